//! The static design factors: what each is called, how it is found and what its sign means.
//!
//! [`FACTORS`] is the one table of definitions; reports, help and documents are made from it.

pub mod wheel;

use crate::model::{Quantity, Units};
use crate::rig::Pose;

/// One factor.
#[derive(Clone, Copy)]
pub struct Factor {
    /// The name of its column, without the unit.
    pub name: &'static str,
    /// What it is, in words.
    pub title: &'static str,
    /// Its kind.
    pub quantity: Quantity,
    /// What a positive value means.
    pub sign: &'static str,
    /// How it is found, in ISO 8855 axes unless it says otherwise.
    pub formula: &'static str,
    /// Where the definition comes from.
    pub source: &'static str,
    /// The value (m or rad) at a state; `None` where the suspension has no such factor.
    pub value: fn(&Pose<f64>) -> Option<f64>,
}

impl Factor {
    /// The name of its column: name and unit.
    pub fn column(&self, units: Units) -> String {
        format!("{}_{}", self.name, self.quantity.symbol(units))
    }

    /// The value in the units of a model.
    pub fn show(&self, units: Units, pose: &Pose<f64>) -> Option<f64> {
        (self.value)(pose).map(|value| self.quantity.show(units, value))
    }
}

/// Wheel centre in the axes of the model.
fn center(pose: &Pose<f64>) -> [f64; 3] {
    pose.axes.from_iso(pose.wheel.center)
}

/// Angles of the wheel's rotation in the axes of the model.
fn angles(pose: &Pose<f64>) -> [f64; 3] {
    crate::vector::rotation_angles(pose.axes.rotation_from_iso(pose.rotation))
}

const ROTATION: &str = "R = Rx(a) Ry(b) Rz(c), from design, in the model's axes";

/// All factors, in the order in which reports show them.
pub const FACTORS: &[Factor] = &[
    Factor {
        name: "travel",
        title: "wheel travel",
        quantity: Quantity::Length,
        sign: "+ jounce",
        formula: "change of the height that is driven: wheel centre or contact patch",
        source: "Adams/Car, Lotus",
        value: |pose| Some(pose.travel),
    },
    Factor {
        name: "rack",
        title: "rack displacement",
        quantity: Quantity::Length,
        sign: "+ along the model's +y",
        formula: "displacement of the rack from design",
        source: "Adams/Car",
        value: |pose| Some(pose.rack),
    },
    Factor {
        name: "wheel_center_x",
        title: "wheel centre, x",
        quantity: Quantity::Length,
        sign: "+ along the model's +x",
        formula: "W_x in the model's axes",
        source: "method paper, Fig. 6",
        value: |pose| Some(center(pose)[0]),
    },
    Factor {
        name: "wheel_center_y",
        title: "wheel centre, y",
        quantity: Quantity::Length,
        sign: "+ along the model's +y",
        formula: "W_y in the model's axes",
        source: "method paper, Fig. 8",
        value: |pose| Some(center(pose)[1]),
    },
    Factor {
        name: "wheel_center_z",
        title: "wheel centre, z",
        quantity: Quantity::Length,
        sign: "+ along the model's +z",
        formula: "W_z in the model's axes",
        source: "method paper, Fig. 7",
        value: |pose| Some(center(pose)[2]),
    },
    Factor {
        name: "toe",
        title: "toe",
        quantity: Quantity::Angle,
        sign: "+ toe-in",
        formula: "atan2(s_x, σ s_y), s the outboard spin axis, σ = +1 left, −1 right",
        source: "Adams/Car, Lotus",
        value: |pose| Some(wheel::toe(pose.wheel.spin, pose.side)),
    },
    Factor {
        name: "camber",
        title: "camber",
        quantity: Quantity::Angle,
        sign: "+ top outboard",
        formula: "−asin(s_z)",
        source: "Adams/Car, ISO 8855",
        value: |pose| Some(wheel::camber(pose.wheel.spin)),
    },
    Factor {
        name: "wheel_rot_x",
        title: "wheel rotation about x",
        quantity: Quantity::Angle,
        sign: "+ right-handed about the model's +x",
        formula: ROTATION,
        source: "method paper, Fig. 9",
        value: |pose| Some(angles(pose)[0]),
    },
    Factor {
        name: "wheel_rot_y",
        title: "wheel rotation about y",
        quantity: Quantity::Angle,
        sign: "+ right-handed about the model's +y",
        formula: ROTATION,
        source: "method paper, Fig. 10",
        value: |pose| Some(angles(pose)[1]),
    },
    Factor {
        name: "wheel_rot_z",
        title: "wheel rotation about z",
        quantity: Quantity::Angle,
        sign: "+ right-handed about the model's +z",
        formula: ROTATION,
        source: "method paper, Fig. 11",
        value: |pose| Some(angles(pose)[2]),
    },
    Factor {
        name: "caster",
        title: "caster",
        quantity: Quantity::Angle,
        sign: "+ top rearward",
        formula: "atan2(−k_x, k_z), k the steer axis pointing up",
        source: "Altair, Lotus",
        value: |pose| pose.steer_axis.map(|axis| wheel::caster(axis.direction())),
    },
    Factor {
        name: "kpi",
        title: "kingpin inclination",
        quantity: Quantity::Angle,
        sign: "+ top inboard",
        formula: "atan2(−σ k_y, k_z)",
        source: "Altair, Lotus",
        value: |pose| pose.steer_axis.map(|axis| wheel::kingpin(axis.direction(), pose.side)),
    },
    Factor {
        name: "wheel_load",
        title: "vertical wheel load",
        quantity: Quantity::Force,
        sign: "+ up on the wheel",
        formula: "vertical force of the rig or the ground in static equilibrium",
        source: "Adams/Car",
        value: |pose| pose.load.map(|load| load.force),
    },
    Factor {
        name: "wheel_rate",
        title: "wheel rate",
        quantity: Quantity::Stiffness,
        sign: "+ stiffer in jounce",
        formula: "dF/dz of the vertical force that holds the wheel, by its travel",
        source: "Adams/Car, Lotus",
        value: |pose| pose.load.and_then(|load| load.rate),
    },
];
