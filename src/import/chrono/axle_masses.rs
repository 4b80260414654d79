//! The masses of axles, as most of their templates have them.

use super::template::{Center, Frame, Mass, mass};

/// Bodies of axles have the axes of the vehicle.
pub(super) const VEHICLE: Frame = Frame::Vehicle;

pub(super) const AXLE: Mass = mass(&["Axle Tube"], "axle", Center::Own, VEHICLE);
/// Wheels that are one body with the axle.
pub(super) const SPINDLES: Mass = mass(&["Spindle"], "axle", Center::Both, VEHICLE);
pub(super) const KNUCKLE: Mass = mass(&["Knuckle"], "knuckle", Center::Own, VEHICLE);
pub(super) const SPINDLE: Mass = mass(&["Spindle"], "knuckle", Center::Own, VEHICLE);
pub(super) const TIEROD: Mass =
    mass(&["Tierod"], "tierod", Center::Across(&["tierod_outer"]), VEHICLE);
pub(super) const DRAGLINK: Mass = mass(
    &["Draglink"],
    "draglink",
    Center::Mean(&["draglink_outer", "draglink_chassis"]),
    Frame::Plane("draglink_outer", "draglink_chassis", None),
);
pub(super) const WATT_CRANK: Mass = Mass {
    prefix: "Center Link ",
    ..mass(
        &["Watt Mechanism"],
        "watt_crank",
        Center::Mean(&["watt_left_crank", "watt_right_crank"]),
        VEHICLE,
    )
};
pub(super) const WATT_LEFT: Mass = Mass {
    prefix: "Side Link ",
    ..mass(
        &["Watt Mechanism"],
        "watt_left_link",
        Center::Mean(&["watt_left_chassis", "watt_left_crank"]),
        VEHICLE,
    )
};
pub(super) const WATT_RIGHT: Mass = Mass {
    prefix: "Side Link ",
    ..mass(
        &["Watt Mechanism"],
        "watt_right_link",
        Center::Mean(&["watt_right_chassis", "watt_right_crank"]),
        VEHICLE,
    )
};
pub(super) const PANHARD: Mass = mass(
    &["Panhard Rod"],
    "panhard_rod",
    Center::Mean(&["panhard_chassis", "panhard_axle"]),
    VEHICLE,
);
pub(super) const ARB_ARM: Mass =
    mass(&["Anti Roll Bar"], "arb_arm", Center::Half("arb_pivot"), VEHICLE);
pub(super) const LONGITUDINAL: Mass = mass(
    &["Longitudinal Link"],
    "lower_link",
    Center::Mean(&["lower_link_front", "lower_link_rear"]),
    VEHICLE,
);
pub(super) const TRIANGLE: Mass = mass(
    &["Triangular Link"],
    "triangle",
    Center::Across(&["triangle_side", "triangle_axle"]),
    VEHICLE,
);
pub(super) const CLAMP_FRONT: Mass = mass(
    &["Leafspring", "Half Clamp"],
    "clamp_front_half",
    Center::Mean(&["clamp_front", "clamp_front", "clamp_front", "clamp_rear"]),
    VEHICLE,
);
pub(super) const CLAMP_REAR: Mass = mass(
    &["Leafspring", "Half Clamp"],
    "clamp_rear_half",
    Center::Mean(&["clamp_rear", "clamp_rear", "clamp_rear", "clamp_front"]),
    VEHICLE,
);
pub(super) const FRONT_LEAF: Mass = mass(
    &["Leafspring", "Frontleaf"],
    "front_leaf",
    Center::Mean(&["front_hanger", "clamp_front"]),
    VEHICLE,
);
pub(super) const REAR_LEAF: Mass = mass(
    &["Leafspring", "Rearleaf"],
    "rear_leaf",
    Center::Mean(&["shackle_end", "clamp_rear"]),
    VEHICLE,
);
pub(super) const SHACKLE: Mass = mass(
    &["Leafspring", "Shackle"],
    "shackle",
    Center::Mean(&["rear_hanger", "shackle_end"]),
    VEHICLE,
);
