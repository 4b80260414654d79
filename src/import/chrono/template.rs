//! Which architecture a template of Chrono is, and where its points, masses and forces stand in the
//! file.
//!
//! A template is one row here; a row without points waits for its architecture.

/// A template of Chrono.
pub(super) struct Template {
    /// Its name in files.
    pub(super) name: &'static str,
    /// The architecture that has its bodies and joints.
    pub(super) architecture: &'static str,
    pub(super) points: &'static [Place],
    pub(super) masses: &'static [Mass],
    pub(super) lines: &'static [Line],
    pub(super) bushings: &'static [Bushing],
}

/// Object, key, and the point of the model.
pub(super) type Place = (&'static str, &'static str, &'static str);

/// A body of Chrono and the body of the model that has its mass.
pub(super) struct Mass {
    pub(super) object: &'static str,
    pub(super) body: &'static str,
    pub(super) center: Center,
    pub(super) frame: Frame,
}

/// Where the centre of mass is.
pub(super) enum Center {
    /// The member `COM`.
    Own,
    /// The middle of two points of the model.
    Between(&'static str, &'static str),
}

/// The axes of the inertia, where the file does not say that they are those of the vehicle.
pub(super) enum Frame {
    Vehicle,
    /// x along the axis from rear to front, z normal to the plane of the arm: rear, front, outer point.
    Arm(&'static str, &'static str, &'static str),
    /// z along the rod, x as near to that of the vehicle as can be.
    Rod(&'static str, &'static str),
}

/// A spring or a damper from the chassis.
pub(super) struct Line {
    pub(super) object: &'static str,
    pub(super) name: &'static str,
    pub(super) body: &'static str,
    /// The key and the point on the chassis, then those on the body.
    pub(super) ends: [(&'static str, &'static str); 2],
}

/// The bushing of a revolute joint, in the middle of its axis.
pub(super) struct Bushing {
    pub(super) object: &'static str,
    pub(super) joint: &'static str,
    pub(super) axis: [&'static str; 2],
}

/// The template of this name.
pub(super) fn find(name: &str) -> Option<&'static Template> {
    TEMPLATES.iter().find(|template| template.name == name)
}

const fn later(name: &'static str, architecture: &'static str) -> Template {
    Template { name, architecture, points: &[], masses: &[], lines: &[], bushings: &[] }
}

const UPRIGHT: Mass =
    Mass { object: "Upright", body: "upright", center: Center::Own, frame: Frame::Vehicle };
const SPINDLE: Mass =
    Mass { object: "Spindle", body: "upright", center: Center::Own, frame: Frame::Vehicle };
const TIEROD: Mass = Mass {
    object: "Tierod",
    body: "tierod",
    center: Center::Between("tierod_inner", "tierod_outer"),
    frame: Frame::Rod("tierod_inner", "tierod_outer"),
};

const fn line(
    object: &'static str,
    name: &'static str,
    body: &'static str,
    key: &'static str,
    points: [&'static str; 2],
) -> Line {
    Line { object, name, body, ends: [("Location Chassis", points[0]), (key, points[1])] }
}

const SPRING: [&str; 2] = ["spring_upper", "spring_lower"];
const DAMPER: [&str; 2] = ["damper_upper", "damper_lower"];

const TEMPLATES: &[Template] = &[
    Template {
        name: "DoubleWishbone",
        architecture: "double-wishbone",
        points: &[
            ("Lower Control Arm", "Location Chassis Front", "lca_front"),
            ("Lower Control Arm", "Location Chassis Back", "lca_rear"),
            ("Lower Control Arm", "Location Upright", "lca_outer"),
            ("Upper Control Arm", "Location Chassis Front", "uca_front"),
            ("Upper Control Arm", "Location Chassis Back", "uca_rear"),
            ("Upper Control Arm", "Location Upright", "uca_outer"),
            ("Tierod", "Location Chassis", "tierod_inner"),
            ("Tierod", "Location Upright", "tierod_outer"),
            ("Spindle", "COM", "wheel_center"),
        ],
        masses: &[
            Mass {
                object: "Lower Control Arm",
                body: "lca",
                center: Center::Own,
                frame: Frame::Arm("lca_rear", "lca_front", "lca_outer"),
            },
            Mass {
                object: "Upper Control Arm",
                body: "uca",
                center: Center::Own,
                frame: Frame::Arm("uca_rear", "uca_front", "uca_outer"),
            },
            UPRIGHT,
            SPINDLE,
            TIEROD,
        ],
        lines: &[
            line("Spring", "spring", "lca", "Location Arm", SPRING),
            line("Shock", "damper", "lca", "Location Arm", DAMPER),
        ],
        bushings: &[
            Bushing {
                object: "Lower Control Arm",
                joint: "lca_pivot",
                axis: ["lca_rear", "lca_front"],
            },
            Bushing {
                object: "Upper Control Arm",
                joint: "uca_pivot",
                axis: ["uca_rear", "uca_front"],
            },
        ],
    },
    Template {
        name: "DoubleWishboneReduced",
        architecture: "double-wishbone-reduced",
        points: &[
            ("Lower Control Arm", "Location Chassis Front", "lca_front"),
            ("Lower Control Arm", "Location Chassis Back", "lca_rear"),
            ("Lower Control Arm", "Location Upright", "lca_outer"),
            ("Upper Control Arm", "Location Chassis Front", "uca_front"),
            ("Upper Control Arm", "Location Chassis Back", "uca_rear"),
            ("Upper Control Arm", "Location Upright", "uca_outer"),
            ("Tierod", "Location Chassis", "tierod_inner"),
            ("Tierod", "Location Upright", "tierod_outer"),
            ("Spindle", "COM", "wheel_center"),
        ],
        masses: &[UPRIGHT, SPINDLE],
        lines: &[line("Shock", "spring", "upright", "Location Upright", SPRING)],
        bushings: &[],
    },
    Template {
        name: "MacPhersonStrut",
        architecture: "macpherson",
        points: &[
            ("Control Arm", "Location Chassis Front", "lca_front"),
            ("Control Arm", "Location Chassis Back", "lca_rear"),
            ("Control Arm", "Location Upright", "lca_outer"),
            ("Spring", "Location Upright", "strut_lower"),
            ("Spring", "Location Chassis", "strut_upper"),
            ("Tierod", "Location Chassis", "tierod_inner"),
            ("Tierod", "Location Upright", "tierod_outer"),
            ("Spindle", "COM", "wheel_center"),
        ],
        masses: &[
            Mass {
                object: "Control Arm",
                body: "lca",
                center: Center::Own,
                frame: Frame::Arm("lca_rear", "lca_front", "lca_outer"),
            },
            Mass {
                object: "Strut",
                body: "strut",
                center: Center::Between("strut_lower", "strut_upper"),
                frame: Frame::Vehicle,
            },
            UPRIGHT,
            SPINDLE,
            TIEROD,
        ],
        lines: &[
            line("Spring", "spring", "upright", "Location Upright", SPRING),
            line("Shock", "damper", "upright", "Location Upright", DAMPER),
        ],
        bushings: &[Bushing {
            object: "Control Arm",
            joint: "lca_pivot",
            axis: ["lca_rear", "lca_front"],
        }],
    },
    Template {
        name: "MultiLink",
        architecture: "split-lower-arm",
        points: &[
            ("Trailing Link", "Location Chassis", "tension_link_inner"),
            ("Trailing Link", "Location Upright", "tension_link_outer"),
            ("Lateral", "Location Chassis", "lateral_link_inner"),
            ("Lateral", "Location Upright", "lateral_link_outer"),
            ("Upper Arm", "Location Chassis Front", "uca_front"),
            ("Upper Arm", "Location Chassis Back", "uca_rear"),
            ("Upper Arm", "Location Upright", "uca_outer"),
            ("Tierod", "Location Chassis", "tierod_inner"),
            ("Tierod", "Location Upright", "tierod_outer"),
            ("Spindle", "COM", "wheel_center"),
        ],
        masses: &[
            Mass {
                object: "Trailing Link",
                body: "tension_link",
                center: Center::Own,
                frame: Frame::Rod("tension_link_inner", "tension_link_outer"),
            },
            Mass {
                object: "Lateral",
                body: "lateral_link",
                center: Center::Own,
                frame: Frame::Rod("lateral_link_inner", "lateral_link_outer"),
            },
            Mass {
                object: "Upper Arm",
                body: "uca",
                center: Center::Own,
                frame: Frame::Arm("uca_rear", "uca_front", "uca_outer"),
            },
            UPRIGHT,
            SPINDLE,
            TIEROD,
        ],
        // Chrono has both on the trailing link.
        lines: &[
            line("Spring", "spring", "tension_link", "Location Link", SPRING),
            line("Shock", "damper", "tension_link", "Location Link", DAMPER),
        ],
        bushings: &[Bushing {
            object: "Upper Arm",
            joint: "uca_pivot",
            axis: ["uca_rear", "uca_front"],
        }],
    },
    Template {
        name: "ThreeLinkIRS",
        architecture: "three-link-irs",
        points: &[
            ("Trailing Arm", "Location Chassis", "trailing_arm_front"),
            ("Upper Link", "Location Chassis", "upper_link_inner"),
            ("Upper Link", "Location Arm", "upper_link_outer"),
            ("Lower Link", "Location Chassis", "lower_link_inner"),
            ("Lower Link", "Location Arm", "lower_link_outer"),
            ("Spindle", "COM", "wheel_center"),
        ],
        masses: &[
            Mass {
                object: "Trailing Arm",
                body: "trailing_arm",
                center: Center::Own,
                frame: Frame::Vehicle,
            },
            Mass { body: "trailing_arm", ..SPINDLE },
            Mass {
                object: "Upper Link",
                body: "upper_link",
                center: Center::Own,
                frame: Frame::Rod("upper_link_inner", "upper_link_outer"),
            },
            Mass {
                object: "Lower Link",
                body: "lower_link",
                center: Center::Own,
                frame: Frame::Rod("lower_link_inner", "lower_link_outer"),
            },
        ],
        lines: &[
            line("Spring", "spring", "trailing_arm", "Location Arm", SPRING),
            line("Shock", "damper", "trailing_arm", "Location Arm", DAMPER),
        ],
        bushings: &[],
    },
    Template {
        name: "SemiTrailingArm",
        architecture: "semi-trailing-arm",
        points: &[
            ("Trailing Arm", "Location Chassis Inner", "arm_inner"),
            ("Trailing Arm", "Location Chassis Outer", "arm_outer"),
            ("Spindle", "COM", "wheel_center"),
        ],
        masses: &[
            Mass {
                object: "Trailing Arm",
                body: "arm",
                center: Center::Own,
                frame: Frame::Vehicle,
            },
            Mass { body: "arm", ..SPINDLE },
        ],
        lines: &[
            line("Spring", "spring", "arm", "Location Arm", SPRING),
            line("Shock", "damper", "arm", "Location Arm", DAMPER),
        ],
        bushings: &[],
    },
    later("SolidAxle", "solid-axle-bellcrank-steered"),
    later("SolidThreeLinkAxle", "solid-axle-three-link"),
    later("SolidBellcrankThreeLinkAxle", "solid-axle-bellcrank"),
    later("DeDionAxle", "de-dion"),
    later("ToeBarDeDionAxle", "de-dion-toe-bar"),
    later("RigidPanhardAxle", "rigid-panhard-axle"),
    later("ToeBarRigidPanhardAxle", "rigid-panhard-axle-toe-bar"),
    later("PushPipeAxle", "push-pipe"),
    later("ToeBarPushPipeAxle", "push-pipe-axle-toe-bar"),
    later("LeafspringAxle", "leaf-spring-axle"),
    later("ToeBarLeafspringAxle", "leaf-spring-axle-toe-bar"),
    later("SAELeafspringAxle", "sae-leaf-spring-axle"),
    later("SAEToeBarLeafspringAxle", "sae-leaf-spring-axle-toe-bar"),
    later("HendricksonPRIMAXX", "hendrickson-primaxx"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Architecture;

    /// Architectures that this build has must have the points, bodies and joints that the table names.
    #[test]
    fn rows_fit_the_architectures() {
        for template in TEMPLATES {
            let Some(architecture) = Architecture::built_in(template.architecture) else {
                continue;
            };
            let architecture = architecture.unwrap();
            let (name, title) = (template.name, architecture.title());
            // Axles are drawn up from both of their sides, which no row does yet.
            if template.points.is_empty() {
                continue;
            }
            for role in architecture.points() {
                let known = template.points.iter().any(|(_, _, point)| *point == role.name);
                assert!(known, "{name} gives {title} no {}", role.name);
            }
            let bodies: Vec<&str> =
                architecture.bodies().iter().map(|body| body.name.as_str()).collect();
            for body in template.masses.iter().map(|mass| mass.body) {
                assert!(bodies.contains(&body), "{title} has no body {body} for {name}");
            }
            for body in template.lines.iter().map(|line| line.body) {
                assert!(bodies.contains(&body), "{title} has no body {body} for {name}");
            }
            for joint in template.bushings.iter().map(|bushing| bushing.joint) {
                let known = architecture.joints.iter().any(|known| known.name == joint);
                assert!(known, "{title} has no joint {joint} for {name}");
            }
        }
    }
}
