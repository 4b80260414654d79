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

/// A help text that suggests the closest candidate and lists all.
pub(crate) fn choices(word: &str, candidates: &[&str]) -> String {
    let list = listed(candidates);
    match closest(word, candidates.iter().copied()) {
        Some(candidate) => format!("did you mean `{candidate}`? The choices are {list}"),
        None => format!("the choices are {list}"),
    }
}

/// Names in backquotes, separated by commas.
pub(crate) fn listed<'a>(names: impl IntoIterator<Item = &'a &'a str>) -> String {
    let quoted: Vec<String> = names.into_iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

fn plain(word: &str) -> String {
    word.trim().to_lowercase().replace(['_', '-', ' ', '.'], "")
}
