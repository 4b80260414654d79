//! "Did you mean …?"

/// How alike two words must be (Jaro–Winkler, 0 to 1) to be offered as a correction.
const ALIKE: f64 = 0.84;

/// The candidate most like `word`, if any is alike enough. Case and the kind of
/// separator do not count, so `LCA-Front` suggests `lca_front`.
pub(crate) fn closest<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    let word = plain(word);
    let mut best = None;
    for candidate in candidates {
        let likeness = strsim::jaro_winkler(&word, &plain(candidate));
        if likeness >= ALIKE && best.is_none_or(|(most, _)| likeness > most) {
            best = Some((likeness, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// What other programs and people call the words of the file formats.
const OTHER_NAMES: &[(&str, &str)] = &[
    ("millimeter", "mm"),
    ("millimetre", "mm"),
    ("centimeter", "cm"),
    ("centimetre", "cm"),
    ("meter", "m"),
    ("metre", "m"),
    ("inch", "in"),
    ("degree", "deg"),
    ("radian", "rad"),
    ("iso", "iso8855"),
    ("lotus", "adams"),
    ("adamscar", "adams"),
    ("j670", "sae"),
    ("ball", "spherical"),
    ("hinge", "revolute"),
    ("hooke", "universal"),
    ("cardan", "universal"),
    ("prismatic", "translational"),
    ("slider", "translational"),
    ("weld", "fixed"),
    ("rod", "link"),
    ("distance", "link"),
    ("newton", "N"),
    ("kilonewton", "kN"),
    ("pound", "lb"),
    ("poundforce", "lbf"),
    ("kilogram", "kg"),
    ("gram", "g"),
    ("tonne", "t"),
    ("shock", "damper"),
    ("shockabsorber", "damper"),
    ("coil", "spring"),
    ("droopstop", "rebound-stop"),
    ("bush", "bushing"),
    ("torque", "moment"),
    ("tire", "tyre"),
    ("angle", "rotation"),
    ("adams", "torque"),
    ("chrono", "torque"),
];

/// The candidate that goes by another name elsewhere, or the closest one.
fn meant<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let plain = plain(word);
    let singular = plain.strip_suffix('s').unwrap_or(&plain);
    let ours = |(other, _): &&(&str, &str)| *other == plain || *other == singular;
    let found = OTHER_NAMES.iter().find(ours).and_then(|(_, ours)| {
        let known = |candidate: &&&str| *candidate == ours;
        candidates.iter().find(known).copied()
    });
    found.or_else(|| closest(word, candidates.iter().copied()))
}

/// A help text that suggests the closest candidate and lists all.
pub(crate) fn choices(word: &str, candidates: &[&str]) -> String {
    let list = listed(candidates);
    match meant(word, candidates) {
        Some(candidate) => format!("did you mean `{candidate}`? The choices are {list}"),
        None => format!("the choices are {list}"),
    }
}

/// Names in backquotes, separated by commas.
pub(crate) fn listed<'a>(names: impl IntoIterator<Item = &'a &'a str>) -> String {
    let quoted: Vec<String> = names.into_iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

/// The word without case and separators.
pub(crate) fn plain(word: &str) -> String {
    word.trim().to_lowercase().replace(['_', '-', ' ', '.'], "")
}
