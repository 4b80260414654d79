//! The rows of axles, whose sides are one mechanism. Files of Chrono have the points of the left side, and those of
//! the axle itself where they are.

use super::axle_masses::{
    ARB_ARM, AXLE, CLAMP_FRONT, CLAMP_REAR, DRAGLINK, FRONT_LEAF, KNUCKLE, LONGITUDINAL, PANHARD,
    REAR_LEAF, SHACKLE, SPINDLE, SPINDLES, TIEROD, TRIANGLE, VEHICLE, WATT_CRANK, WATT_LEFT,
    WATT_RIGHT,
};
use super::template::{
    Center, DAMPER, Derived, Frame, Line, Mass, NONE, Place, SPRING, Template, line, mass,
};
use super::torsion::{anti_roll_bar, leaf_springs};

const WHEEL: Place = ("Spindle", "COM", "wheel_center");
const AXLE_CENTER: Place = ("Axle Tube", "COM", "axle_center");
const KINGPIN_LOWER: Place = ("Knuckle", "Location Lower", "kingpin_lower");
const KINGPIN_UPPER: Place = ("Knuckle", "Location Upper", "kingpin_upper");
const TIEROD_OUTER: Place = ("Tierod", "Location Knuckle", "tierod_outer");
const DRAGLINK_OUTER: Place = ("Knuckle", "Location Draglink", "draglink_outer");
const DRAGLINK_CHASSIS: Place = ("Draglink", "Location Chassis", "draglink_chassis");
const PIPE: Place = ("Axle Tube", "Location Connector Chassis", "pipe_front");
const TUBE: Place = ("Axle Tube", "Location Connector Chassis", "tube_front");

// Left in the files is the link that lies on the right.
const WATT_LEFT_CHASSIS: Place =
    ("Watt Mechanism", "Location Right Link to Chassis", "watt_left_chassis");
const WATT_LEFT_CRANK: Place =
    ("Watt Mechanism", "Location Right Link to Center", "watt_left_crank");
const WATT_RIGHT_CHASSIS: Place =
    ("Watt Mechanism", "Location Left Link to Chassis", "watt_right_chassis");
const WATT_RIGHT_CRANK: Place =
    ("Watt Mechanism", "Location Left Link to Center", "watt_right_crank");
const WATT_PIVOT: (&str, Derived) =
    ("watt_pivot", Derived::Middle("watt_left_crank", "watt_right_crank"));

const SPRING_LINE: Line = line("Spring", "spring", "axle", "Location Axle", SPRING);
const SHOCK_LINE: Line = line("Shock", "damper", "axle", "Location Axle", DAMPER);
const SPRING_AND_SHOCK: &[Line] = &[SPRING_LINE, SHOCK_LINE];
const AUXILIARY: &[Line] = &[
    line("Auxiliary Spring", "auxiliary_spring", "axle", "Location Axle", SPRING),
    line("Shock", "damper", "axle", "Location Axle", DAMPER),
];

/// A row on springs and dampers of the axle.
const fn axle(
    name: &'static str,
    architecture: &'static str,
    points: &'static [Place],
    masses: &'static [Mass],
) -> Template {
    Template { name, architecture, points, masses, lines: SPRING_AND_SHOCK, ..NONE }
}

pub(super) const AXLES: &[Template] = &[
    axle(
        "SolidThreeLinkAxle",
        "solid-axle-three-link",
        &[
            ("Longitudinal Link", "Location Chassis", "lower_link_front"),
            ("Longitudinal Link", "Location Axle", "lower_link_rear"),
            ("Triangular Link", "Location Chassis", "triangle_side"),
            ("Triangular Link", "Location Axle", "triangle_axle"),
            WHEEL,
        ],
        &[AXLE, SPINDLES, LONGITUDINAL, TRIANGLE],
    ),
    axle(
        "SolidBellcrankThreeLinkAxle",
        "solid-axle-three-link-bellcrank",
        &[
            ("Longitudinal Link", "Location Chassis", "lower_link_front"),
            ("Longitudinal Link", "Location Axle", "lower_link_rear"),
            ("Triangular Link", "Location Chassis", "triangle_side"),
            ("Triangular Link", "Location Axle", "triangle_axle"),
            KINGPIN_LOWER,
            KINGPIN_UPPER,
            ("Knuckle", "Location Tierod", "tierod_outer"),
            ("Bellcrank", "Location Tierod", "tierod_inner"),
            ("Bellcrank", "Location Axle", "bellcrank_pivot"),
            ("Draglink", "Location Bellcrank", "draglink_bellcrank"),
            ("Draglink", "Location Steering", "draglink_chassis"),
            WHEEL,
        ],
        &[
            AXLE,
            KNUCKLE,
            SPINDLE,
            LONGITUDINAL,
            TRIANGLE,
            mass(&["Bellcrank"], "bellcrank", Center::Mean(&["bellcrank_pivot"]), VEHICLE),
            mass(&["Tierod"], "tierod", Center::Mean(&["tierod_inner", "tierod_outer"]), VEHICLE),
            mass(
                &["Draglink"],
                "draglink",
                Center::Mean(&["draglink_bellcrank", "draglink_chassis"]),
                VEHICLE,
            ),
        ],
    ),
    Template {
        name: "SolidAxle",
        architecture: "solid-axle-bellcrank",
        points: &[
            ("Lower Link", "Location Chassis", "lower_link_front"),
            ("Lower Link", "Location Axle", "lower_link_rear"),
            ("Upper Link", "Location Chassis", "upper_link_front"),
            ("Upper Link", "Location Axle", "upper_link_rear"),
            KINGPIN_LOWER,
            KINGPIN_UPPER,
            TIEROD_OUTER,
            ("Bell Crank", "Location Axle", "bellcrank_pivot"),
            ("Bell Crank", "Location Tierod", "bellcrank_tierod"),
            ("Draglink", "Location Bell Crank", "draglink_bellcrank"),
            DRAGLINK_CHASSIS,
            WHEEL,
        ],
        derived: &[(
            "bellcrank_axis",
            Derived::Normal("bellcrank_pivot", "draglink_bellcrank", "bellcrank_tierod"),
        )],
        masses: &[
            AXLE,
            KNUCKLE,
            SPINDLE,
            mass(
                &["Upper Link"],
                "upper_link",
                Center::Own,
                Frame::Plane("upper_link_rear", "upper_link_front", Some("lower_link_rear")),
            ),
            mass(
                &["Lower Link"],
                "lower_link",
                Center::Own,
                Frame::Plane("lower_link_front", "lower_link_rear", Some("upper_link_rear")),
            ),
            TIEROD,
            mass(
                &["Bell Crank"],
                "bellcrank",
                Center::Mean(&["draglink_bellcrank", "bellcrank_pivot", "bellcrank_tierod"]),
                Frame::Plane("draglink_bellcrank", "draglink_chassis", Some("lower_link_rear")),
            ),
            mass(
                &["Draglink"],
                "draglink",
                Center::Mean(&["draglink_bellcrank", "draglink_chassis"]),
                Frame::Plane("draglink_bellcrank", "draglink_chassis", Some("lower_link_rear")),
            ),
        ],
        lines: SPRING_AND_SHOCK,
        cannot: Some((
            "Trackbar",
            "four links and a track bar leave a rigid axle one motion, so that its wheels cannot travel apart",
        )),
        ..NONE
    },
    Template {
        derived: &[WATT_PIVOT],
        ..axle(
            "DeDionAxle",
            "de-dion",
            &[
                TUBE,
                WATT_LEFT_CHASSIS,
                WATT_LEFT_CRANK,
                WATT_RIGHT_CHASSIS,
                WATT_RIGHT_CRANK,
                WHEEL,
            ],
            &[AXLE, SPINDLES, WATT_CRANK, WATT_LEFT, WATT_RIGHT],
        )
    },
    Template {
        derived: &[WATT_PIVOT],
        ..axle(
            "ToeBarDeDionAxle",
            "de-dion-toe-bar",
            &[
                TUBE,
                WATT_LEFT_CHASSIS,
                WATT_LEFT_CRANK,
                WATT_RIGHT_CHASSIS,
                WATT_RIGHT_CRANK,
                KINGPIN_LOWER,
                KINGPIN_UPPER,
                TIEROD_OUTER,
                DRAGLINK_OUTER,
                DRAGLINK_CHASSIS,
                WHEEL,
            ],
            &[AXLE, KNUCKLE, SPINDLE, TIEROD, DRAGLINK, WATT_CRANK, WATT_LEFT, WATT_RIGHT],
        )
    },
    axle(
        "PushPipeAxle",
        "push-pipe",
        &[
            PIPE,
            ("Panhard Rod", "Location Connector Chassis", "panhard_chassis"),
            ("Panhard Rod", "Location Connector Axle", "panhard_axle"),
            WHEEL,
        ],
        &[AXLE, SPINDLES, PANHARD],
    ),
    axle(
        "ToeBarPushPipeAxle",
        "push-pipe-toe-bar",
        &[
            PIPE,
            ("Panhard Rod", "Location Connector Chassis", "panhard_chassis"),
            ("Panhard Rod", "Location Connector Axle", "panhard_axle"),
            KINGPIN_LOWER,
            KINGPIN_UPPER,
            TIEROD_OUTER,
            DRAGLINK_OUTER,
            DRAGLINK_CHASSIS,
            WHEEL,
        ],
        &[AXLE, KNUCKLE, SPINDLE, TIEROD, DRAGLINK, PANHARD],
    ),
    Template {
        torsion: Some(anti_roll_bar),
        ..axle(
            "RigidPanhardAxle",
            "rigid-panhard-axle",
            &[
                AXLE_CENTER,
                ("Panhard Rod", "Location Chassis", "panhard_chassis"),
                ("Panhard Rod", "Location Axle", "panhard_axle"),
                ("Anti Roll Bar", "Location Chassis", "arb_pivot"),
                ("Anti Roll Bar", "Location Axle", "arb_end"),
                WHEEL,
            ],
            &[AXLE, SPINDLES, PANHARD, ARB_ARM],
        )
    },
    Template {
        torsion: Some(anti_roll_bar),
        ..axle(
            "ToeBarRigidPanhardAxle",
            "rigid-panhard-axle-toe-bar",
            &[
                AXLE_CENTER,
                ("Panhard Rod", "Location Chassis", "panhard_chassis"),
                ("Panhard Rod", "Location Axle", "panhard_axle"),
                ("Anti Roll Bar", "Location Chassis", "arb_pivot"),
                ("Anti Roll Bar", "Location Axle", "arb_end"),
                KINGPIN_LOWER,
                KINGPIN_UPPER,
                TIEROD_OUTER,
                DRAGLINK_OUTER,
                DRAGLINK_CHASSIS,
                WHEEL,
            ],
            &[AXLE, KNUCKLE, SPINDLE, TIEROD, DRAGLINK, PANHARD, ARB_ARM],
        )
    },
    axle("LeafspringAxle", "leaf-spring-axle", &[AXLE_CENTER, WHEEL], &[AXLE, SPINDLES]),
    axle(
        "ToeBarLeafspringAxle",
        "leaf-spring-axle-toe-bar",
        &[
            AXLE_CENTER,
            KINGPIN_LOWER,
            KINGPIN_UPPER,
            TIEROD_OUTER,
            DRAGLINK_OUTER,
            DRAGLINK_CHASSIS,
            WHEEL,
        ],
        &[AXLE, KNUCKLE, SPINDLE, TIEROD, DRAGLINK],
    ),
    Template {
        lines: AUXILIARY,
        torsion: Some(leaf_springs),
        ..axle(
            "SAELeafspringAxle",
            "sae-leaf-spring-axle",
            &[
                ("Leafspring", "Location Front Hanger", "front_hanger"),
                ("Leafspring", "Location Clamp A", "clamp_front"),
                ("Leafspring", "Location Clamp B", "clamp_rear"),
                ("Leafspring", "Location Shackle", "shackle_end"),
                ("Leafspring", "Location Rear Hanger", "rear_hanger"),
                WHEEL,
            ],
            &[AXLE, SPINDLES, CLAMP_FRONT, CLAMP_REAR, FRONT_LEAF, REAR_LEAF, SHACKLE],
        )
    },
    Template {
        lines: AUXILIARY,
        torsion: Some(leaf_springs),
        ..axle(
            "SAEToeBarLeafspringAxle",
            "sae-leaf-spring-axle-toe-bar",
            &[
                ("Leafspring", "Location Front Hanger", "front_hanger"),
                ("Leafspring", "Location Clamp A", "clamp_front"),
                ("Leafspring", "Location Clamp B", "clamp_rear"),
                ("Leafspring", "Location Shackle", "shackle_end"),
                ("Leafspring", "Location Rear Hanger", "rear_hanger"),
                KINGPIN_LOWER,
                KINGPIN_UPPER,
                TIEROD_OUTER,
                DRAGLINK_OUTER,
                DRAGLINK_CHASSIS,
                WHEEL,
            ],
            &[
                AXLE,
                KNUCKLE,
                SPINDLE,
                TIEROD,
                DRAGLINK,
                CLAMP_FRONT,
                CLAMP_REAR,
                FRONT_LEAF,
                REAR_LEAF,
                SHACKLE,
            ],
        )
    },
];
