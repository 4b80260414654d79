//! Mechanisms that several tests use.
#![allow(dead_code)]

pub mod pendulum;
pub mod sedan;

use hardpoint::mechanism::{
    BodyId, Direction, DriverId, DriverKind, JointKind, Mechanism, MechanismError, PointId,
};

/// A left front double wishbone: hard points of Project Chrono's
/// `Sedan_DoubleWishbone.json`, ISO 8855 axes, metres.
pub const SEDAN: [(&str, [f64; 3]); 9] = [
    ("lca_front", [0.2, 0.42, -0.27]),
    ("lca_rear", [-0.2, 0.47, -0.265]),
    ("lca_outer", [0.0, 0.77, -0.32]),
    ("uca_front", [-0.1, 0.47, 0.105]),
    ("uca_rear", [-0.25, 0.51, 0.11]),
    ("uca_outer", [-0.04, 0.695, 0.105]),
    ("tierod_inner", [-0.2, 0.42, -0.12]),
    ("tierod_outer", [-0.15, 0.77, -0.12]),
    ("wheel_center", [0.0, 0.7979, -0.1199]),
];

/// A double wishbone with its drivers and the parts that tests ask for.
pub struct DoubleWishbone {
    pub mechanism: Mechanism,
    pub upright: BodyId,
    pub wheel_center: PointId,
    pub travel: DriverId,
    pub steer: DriverId,
}

/// How the tie rod is held on the rack.
#[derive(Clone, Copy, PartialEq)]
pub enum TieRod {
    /// By a universal joint: no motion is free.
    Universal,
    /// By a spherical joint: the tie rod can spin.
    Spherical,
}

/// The sedan's suspension with its points moved by `place` (a rigid motion) and
/// vectors turned by `turn`.
pub fn double_wishbone(
    tie_rod: TieRod,
    place: impl Fn([f64; 3]) -> [f64; 3],
    turn: impl Fn([f64; 3]) -> [f64; 3],
) -> Result<DoubleWishbone, MechanismError> {
    let m = Mechanism::new("chassis");
    suspend(m, BodyId::GROUND, tie_rod, place, turn)
}

/// As [`double_wishbone`] on any body that carries it.
pub fn suspend(
    mut m: Mechanism,
    chassis: BodyId,
    tie_rod: TieRod,
    place: impl Fn([f64; 3]) -> [f64; 3],
    turn: impl Fn([f64; 3]) -> [f64; 3],
) -> Result<DoubleWishbone, MechanismError> {
    let mut points = Vec::new();
    for (name, position) in SEDAN {
        points.push(m.add_point(name, place(position))?);
    }
    let [lca_f, lca_r, lca_o, uca_f, uca_r, uca_o, tie_i, tie_o, wheel] = points[..] else {
        unreachable!()
    };
    let origin = |k: usize| place(SEDAN[k].1);
    let lca = m.add_body("lca", origin(2))?;
    let uca = m.add_body("uca", origin(5))?;
    let upright = m.add_body("upright", origin(8))?;
    let tierod = m.add_body("tierod", origin(7))?;
    let rack = m.add_body("rack", origin(6))?;
    let between = Direction::Between;
    let lateral = Direction::Fixed(turn([0.0, 1.0, 0.0]));
    let revolute = |at, axis| JointKind::Revolute { at, axis };
    m.add_joint("lca_pivot", chassis, lca, revolute(lca_f, between(lca_f, lca_r)))?;
    m.add_joint("uca_pivot", chassis, uca, revolute(uca_f, between(uca_f, uca_r)))?;
    m.add_joint("lca_outer", lca, upright, JointKind::Spherical { at: lca_o })?;
    m.add_joint("uca_outer", uca, upright, JointKind::Spherical { at: uca_o })?;
    m.add_joint("tierod_outer", tierod, upright, JointKind::Spherical { at: tie_o })?;
    let inner = match tie_rod {
        TieRod::Universal => JointKind::Universal { at: tie_i, shaft: between(tie_i, tie_o) },
        TieRod::Spherical => JointKind::Spherical { at: tie_i },
    };
    m.add_joint("tierod_inner", rack, tierod, inner)?;
    let slide = JointKind::Translational { at: tie_i, axis: lateral };
    m.add_joint("rack_housing", chassis, rack, slide)?;
    let height = DriverKind::Height { at: wheel };
    let travel = m.add_driver("travel", BodyId::GROUND, upright, height)?;
    let displacement = DriverKind::Displacement { at: tie_i, along: lateral };
    let steer = m.add_driver("rack_travel", chassis, rack, displacement)?;
    Ok(DoubleWishbone { mechanism: m, upright, wheel_center: wheel, travel, steer })
}

/// The largest difference of two vectors.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
