//! The rows of independent suspensions.

use super::template::{
    Bushing, Center, DAMPER, Frame, Mass, NONE, SPINDLE, SPRING, Template, UPRIGHT, line, mass,
};

const TIEROD: Mass = mass(
    &["Tierod"],
    "tierod",
    Center::Mean(&["tierod_inner", "tierod_outer"]),
    Frame::Rod("tierod_inner", "tierod_outer"),
);

pub(super) const CORNERS: &[Template] = &[
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
            mass(
                &["Lower Control Arm"],
                "lca",
                Center::Own,
                Frame::Arm("lca_rear", "lca_front", "lca_outer"),
            ),
            mass(
                &["Upper Control Arm"],
                "uca",
                Center::Own,
                Frame::Arm("uca_rear", "uca_front", "uca_outer"),
            ),
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
        ..NONE
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
        ..NONE
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
            mass(
                &["Control Arm"],
                "lca",
                Center::Own,
                Frame::Arm("lca_rear", "lca_front", "lca_outer"),
            ),
            mass(
                &["Strut"],
                "strut",
                Center::Mean(&["strut_lower", "strut_upper"]),
                Frame::Vehicle,
            ),
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
        ..NONE
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
            mass(
                &["Trailing Link"],
                "tension_link",
                Center::Own,
                Frame::Rod("tension_link_inner", "tension_link_outer"),
            ),
            mass(
                &["Lateral"],
                "lateral_link",
                Center::Own,
                Frame::Rod("lateral_link_inner", "lateral_link_outer"),
            ),
            mass(
                &["Upper Arm"],
                "uca",
                Center::Own,
                Frame::Arm("uca_rear", "uca_front", "uca_outer"),
            ),
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
        ..NONE
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
            mass(&["Trailing Arm"], "trailing_arm", Center::Own, Frame::Vehicle),
            Mass { body: "trailing_arm", ..SPINDLE },
            mass(
                &["Upper Link"],
                "upper_link",
                Center::Own,
                Frame::Rod("upper_link_inner", "upper_link_outer"),
            ),
            mass(
                &["Lower Link"],
                "lower_link",
                Center::Own,
                Frame::Rod("lower_link_inner", "lower_link_outer"),
            ),
        ],
        lines: &[
            line("Spring", "spring", "trailing_arm", "Location Arm", SPRING),
            line("Shock", "damper", "trailing_arm", "Location Arm", DAMPER),
        ],
        ..NONE
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
            mass(&["Trailing Arm"], "arm", Center::Own, Frame::Vehicle),
            Mass { body: "arm", ..SPINDLE },
        ],
        lines: &[
            line("Spring", "spring", "arm", "Location Arm", SPRING),
            line("Shock", "damper", "arm", "Location Arm", DAMPER),
        ],
        ..NONE
    },
];
