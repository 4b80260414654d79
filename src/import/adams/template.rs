//! Which architecture a template of Adams/Car is. A subsystem has no topology; that is in its template.

use crate::model::Architecture;

/// A template of the shared database, or one like it.
pub(super) struct Template {
    /// Its name without the leading `_`, or the start of it.
    pub(super) name: &'static str,
    pub(super) architecture: &'static str,
    /// Hard points that have another name in the model.
    pub(super) points: &'static [(&'static str, &'static str)],
    /// The ends of springs and dampers: on the chassis, then on the body.
    pub(super) strut: Strut,
    /// The usage of a bushing, the joint that it stands for and its point; its z axis is that of the
    /// joint.
    pub(super) bushings: &'static [(&'static str, &'static str, &'static str)],
    /// The axes of joints that have bushings.
    pub(super) axes: &'static [(&'static str, [&'static str; 2])],
}

/// Where springs, dampers and stops act.
pub(super) struct Strut {
    pub(super) spring: [&'static str; 2],
    pub(super) damper: [&'static str; 2],
    pub(super) body: &'static str,
}

const ARMS: &[(&str, &str, &str)] = &[
    ("lca_front", "lca_pivot", "lca_front"),
    ("lca_rear", "lca_pivot", "lca_rear"),
    ("uca_front", "uca_pivot", "uca_front"),
    ("uca_rear", "uca_pivot", "uca_rear"),
];

const AXES: &[(&str, [&str; 2])] =
    &[("lca_pivot", ["lca_rear", "lca_front"]), ("uca_pivot", ["uca_rear", "uca_front"])];

const TEMPLATES: &[Template] = &[
    Template {
        name: "double_wishbone",
        architecture: "double-wishbone",
        points: &[("lwr_strut_mount", "damper_lower"), ("top_mount", "damper_upper")],
        strut: Strut {
            spring: ["damper_upper", "damper_lower"],
            damper: ["damper_upper", "damper_lower"],
            body: "lca",
        },
        bushings: ARMS,
        axes: AXES,
    },
    Template {
        name: "macpherson",
        architecture: "macpherson",
        points: &[
            ("strut_lwr_mount", "strut_lower"),
            ("top_mount", "strut_top"),
            ("spring_lwr_seat", "spring_lower"),
        ],
        strut: Strut {
            spring: ["strut_top", "spring_lower"],
            damper: ["strut_top", "strut_lower"],
            body: "upright",
        },
        bushings: ARMS,
        axes: AXES,
    },
];

/// The template of this name: that of the shared database, or one whose name starts like it.
pub(super) fn find(name: &str) -> Option<&'static Template> {
    let name = name.trim_start_matches('_').to_ascii_lowercase();
    let name = name.strip_suffix(".tpl").unwrap_or(&name);
    let name = name.trim_start_matches("acar_").trim_start_matches("fsae_");
    TEMPLATES.iter().find(|template| {
        let rest = name.strip_prefix(template.name);
        // `_macpherson_active` has another topology than a plain strut only where its name says so.
        rest.is_some_and(|rest| {
            rest.is_empty() || rest.starts_with("_front") || rest.starts_with("_rear")
        })
    })
}

/// The names of the templates, for messages.
pub(super) fn names() -> String {
    let names = TEMPLATES.iter().map(|template| format!("_{}", template.name));
    names.collect::<Vec<_>>().join(", ")
}

/// What Adams/Car calls the points of an architecture, where it has another name for them.
pub(crate) fn adams_name(architecture: &str, point: &str) -> String {
    let template = TEMPLATES.iter().find(|template| template.architecture == architecture);
    let renamed = template.and_then(|t| t.points.iter().find(|(_, ours)| *ours == point));
    renamed.map_or(point, |(theirs, _)| *theirs).to_owned()
}

/// The template of an architecture: that of the shared database, or one of one's own with the name of the
/// architecture; and whether it is that of the database.
pub(crate) fn of_architecture(architecture: &str) -> (String, bool) {
    let template = TEMPLATES.iter().find(|template| template.architecture == architecture);
    match template {
        Some(template) => (format!("_{}", template.name), true),
        None => (own_word(architecture), false),
    }
}

/// The built-in architecture that a template has its name from, as [`of_architecture`] gives it.
pub(super) fn own_architecture(name: &str) -> Option<&'static str> {
    let name = name.strip_suffix(".tpl").unwrap_or(name);
    Architecture::built_in_names().into_iter().find(|known| own_word(known) == name)
}

/// `_five_link` of `five-link` and of `somewhere/five-link.toml`.
fn own_word(architecture: &str) -> String {
    let file = architecture.rsplit(['/', '\\']).next().unwrap_or(architecture);
    let stem = file.strip_suffix(".toml").unwrap_or(file);
    let letter = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    format!("_{}", stem.chars().map(letter).collect::<String>())
}
