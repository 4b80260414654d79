//! What other programs and teams call the hard points.

use crate::model::Architecture;
use crate::model::suggest::{self, plain};

/// Our name, and other names without case and separators: those of Lotus, of Adams/Car where they
/// differ,
/// of OptimumK and the short forms of teams.
const NAMES: &[(&str, &[&str])] = &[
    (
        "lca_front",
        &["lowerwishbonefrontpivot", "lowerarmfrontpivot", "lcaif", "lcaf", "chaslowfor"],
    ),
    ("lca_rear", &["lowerwishbonerearpivot", "lowerarmrearpivot", "lcair", "lcar", "chaslowaft"]),
    (
        "lca_outer",
        &[
            "lowerwishboneouterballjoint",
            "lowerballjoint",
            "loweraouterballjoint",
            "lcao",
            "uprilowpnt",
        ],
    ),
    (
        "uca_front",
        &["upperwishbonefrontpivot", "upperarmfrontpivot", "ucaif", "ucaf", "chasuppfor"],
    ),
    ("uca_rear", &["upperwishbonerearpivot", "upperarmrearpivot", "ucair", "ucar", "chasuppaft"]),
    ("uca_outer", &["upperwishboneouterballjoint", "upperballjoint", "ucao", "upriupppnt"]),
    (
        "tierod_inner",
        &[
            "innertrackrodballjoint",
            "tierodi",
            "tierodinboard",
            "tieri",
            "toelinkinner",
            "toelinki",
            "chastiepnt",
        ],
    ),
    (
        "tierod_outer",
        &[
            "outertrackrodballjoint",
            "tierodo",
            "tierodoutboard",
            "tiero",
            "toelinkouter",
            "toelinko",
            "upritiepnt",
        ],
    ),
    ("wheel_center", &["wheelcentrepoint", "wheelcentre", "wheelcenterpoint", "wc"]),
    ("wheel_spindle", &["wheelspindlepoint", "wheelaxis", "spindle"]),
    (
        "damper_lower",
        &["damperwishboneend", "dampero", "lowerdamper", "shocklower", "damperlowerpoint"],
    ),
    (
        "damper_upper",
        &["damperbodyend", "damperi", "upperdamper", "shockupper", "damperupperpoint"],
    ),
    (
        "spring_lower",
        &["lowerspringpivotpoint", "lowerspringpivot", "springwishboneend", "springo"],
    ),
    ("spring_upper", &["upperspringpivotpoint", "upperspringpivot", "springbodyend", "springi"]),
    ("strut_top", &["strutbodyend", "topmount", "struttopmount", "strutmount"]),
    ("contact_patch", &["contactpatch", "contactpatchpoint", "tyrecontactpatch"]),
];

/// Which axle a name speaks of: `F_…` or `R_…`, as teams write it.
pub(super) fn axle_prefix(name: &str) -> Option<(char, &str)> {
    let (prefix, rest) = name.split_once(['_', '.', '-', ' '])?;
    match prefix {
        "F" | "f" => Some(('f', rest)),
        "R" | "r" => Some(('r', rest)),
        _ => None,
    }
}

/// Our name for what a source calls a point: that of the architecture, or one that is known elsewhere.
/// A name that is not known stays, as a word.
pub(super) fn our_name(called: &str, architecture: Option<&Architecture>) -> String {
    let called = called.trim();
    let short = ["hpl_", "hpr_", "hps_"].iter().find_map(|prefix| called.strip_prefix(prefix));
    let word = plain(short.unwrap_or(called));
    let known = |name: &str| plain(name) == word;
    if let Some(architecture) = architecture {
        let mut roles = architecture.points().iter().chain(architecture.optional_points());
        if let Some(role) = roles.find(|role| known(&role.name)) {
            return role.name.clone();
        }
    }
    let found = NAMES.iter().find(|(ours, others)| known(ours) || others.contains(&word.as_str()));
    found
        .map_or_else(|| super::sheet::word(short.unwrap_or(called)), |(ours, _)| (*ours).to_owned())
}

/// A name of the architecture like one that it does not have, for messages.
pub(super) fn meant(name: &str, architecture: &Architecture, taken: &[String]) -> Option<String> {
    let roles = architecture.points().iter().map(|role| role.name.as_str());
    let free = roles.filter(|role| !taken.iter().any(|taken| taken == role));
    suggest::closest(name, free).map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_others_are_known() {
        let architecture = Architecture::built_in("double-wishbone").unwrap().unwrap();
        for (called, ours) in [
            ("Lower wishbone front pivot", "lca_front"),
            ("LCA_IF", "lca_front"),
            ("hpl_lca_outer", "lca_outer"),
            ("WheelCenter", "wheel_center"),
            ("Inner track rod ball joint", "tierod_inner"),
            ("LCA-Front", "lca_front"),
            ("Rocker Center", "rocker_center"),
        ] {
            assert_eq!(our_name(called, Some(&architecture)), ours);
        }
        assert_eq!(axle_prefix("F_LCA_O"), Some(('f', "LCA_O")));
        assert_eq!(axle_prefix("FLCA"), None);
    }

    #[test]
    fn no_name_stands_for_two_points() {
        let mut all: Vec<&str> =
            NAMES.iter().flat_map(|(_, others)| others.iter().copied()).collect();
        let number = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), number);
    }
}
