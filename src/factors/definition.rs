//! What is stated of a factor.

use std::fmt;

use super::convention::Convention;
use super::need::Need;
use crate::model::{Axle, Quantity, Units};
use crate::rig::Pose;
use crate::scalar::Dual;

/// What a factor is about; reports are grouped by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Where the wheel is.
    Place,
    /// How the wheel stands.
    Orientation,
    /// The steer axis through two joints.
    SteerAxis,
    /// The axis about which the wheel steers with its centre held at its height.
    VirtualAxis,
    /// The axis about which the wheel steers with the length of the spring held.
    VirtualAxisSpring,
    /// The motion of the wheel in travel.
    Travel,
    /// Instant centres and swing arms.
    Centers,
    /// Roll centre.
    RollCenter,
    /// Pitch: anti-dive, anti-lift, anti-squat.
    Anti,
    /// Spring, damper and motion ratios.
    Spring,
    /// Wheel load.
    Load,
    /// Steering.
    Steering,
    /// Roll of the axle.
    Roll,
    /// Rates of wheel, ride and roll, and other stiffnesses.
    Rates,
    /// Ride and roll from the compliance.
    Ride,
    /// Compliance to lateral forces and aligning torques.
    Lateral,
    /// Compliance to braking and driving forces.
    Longitudinal,
    /// Jacking forces.
    Jacking,
    /// Pitch from the compliance.
    Pitch,
}

impl Subject {
    /// All of them, in the order of reports.
    pub const ALL: [Self; 19] = [
        Self::Place,
        Self::Orientation,
        Self::SteerAxis,
        Self::VirtualAxis,
        Self::VirtualAxisSpring,
        Self::Travel,
        Self::Centers,
        Self::RollCenter,
        Self::Anti,
        Self::Spring,
        Self::Load,
        Self::Steering,
        Self::Roll,
        Self::Rates,
        Self::Ride,
        Self::Lateral,
        Self::Longitudinal,
        Self::Jacking,
        Self::Pitch,
    ];

    /// A heading.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Place => "Place of the wheel",
            Self::Orientation => "Orientation of the wheel",
            Self::SteerAxis => "Steer axis through the joints",
            Self::VirtualAxis => "Virtual steer axis, height of the wheel centre held",
            Self::VirtualAxisSpring => "Virtual steer axis, length of the spring held",
            Self::Travel => "Motion in travel",
            Self::Centers => "Instant centres and swing arms",
            Self::RollCenter => "Roll centre",
            Self::Anti => "Anti-dive, anti-lift, anti-squat",
            Self::Spring => "Spring, damper and motion ratios",
            Self::Load => "Wheel load",
            Self::Steering => "Steering",
            Self::Roll => "Roll of the axle",
            Self::Rates => "Rates and stiffnesses",
            Self::Ride => "Ride and roll from the compliance",
            Self::Lateral => "Lateral compliance",
            Self::Longitudinal => "Longitudinal compliance",
            Self::Jacking => "Jacking forces",
            Self::Pitch => "Dive, lift and squat from the compliance",
        }
    }
}

/// What a factor is a property of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scope {
    /// Each wheel has its own value.
    #[default]
    Wheel,
    /// The axle has one value; either wheel of it gives the same.
    Axle,
}

/// A formula, for numbers and for dual numbers. The value is in SI units.
#[derive(Clone, Copy)]
pub struct Formula {
    /// The value.
    pub plain: fn(&Pose<f64>) -> Option<f64>,
    /// The value with its derivative.
    pub dual: fn(&Pose<Dual>) -> Option<Dual>,
}

/// A formula that is generic over the scalar.
macro_rules! formula {
    ($formula:expr) => {
        crate::factors::Formula { plain: $formula, dual: $formula }
    };
}
pub(super) use formula;

/// How a factor is defined by one convention.
#[derive(Clone, Copy)]
pub struct Definition {
    /// What a positive value means.
    pub sign: &'static str,
    /// How it is found, in ISO 8855 axes unless it says otherwise.
    pub formula: &'static str,
    /// Where the definition comes from.
    pub source: &'static str,
    /// The value at a state; `None` where it is not defined.
    pub value: Formula,
}

/// One factor.
#[derive(Clone, Copy)]
pub struct Factor {
    /// The name of its column, without the unit.
    pub name: &'static str,
    /// What it is, in words.
    pub title: &'static str,
    /// How books and formulas write it.
    pub symbol: &'static str,
    /// What it is about.
    pub subject: Subject,
    /// Its kind.
    pub quantity: Quantity,
    /// What a positive value means.
    pub sign: &'static str,
    /// How it is found, in ISO 8855 axes unless it says otherwise.
    pub formula: &'static str,
    /// Where the definition comes from.
    pub source: &'static str,
    /// The value at a state; `None` where it is not defined.
    pub value: Formula,
    /// What Lotus defines otherwise.
    pub lotus: Option<Definition>,
    /// What Adams/Car defines otherwise.
    pub adams: Option<Definition>,
    /// Whether it belongs to a wheel or to an axle.
    pub scope: Scope,
    /// What a model or a state needs to have the factor.
    pub needs: &'static [Need],
    /// The axle that alone has the factor.
    pub axle: Option<Axle>,
}

impl fmt::Debug for Factor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Factor").field(&self.name).finish()
    }
}

impl Factor {
    /// A factor without a name, from which the tables begin.
    pub(super) const BLANK: Self = Self {
        name: "",
        title: "",
        symbol: "",
        subject: Subject::Place,
        quantity: Quantity::Length,
        sign: "",
        formula: "",
        source: "",
        value: formula!(|_| None),
        lotus: None,
        adams: None,
        scope: Scope::Wheel,
        needs: &[],
        axle: None,
    };

    /// The definition by a convention.
    pub fn by(&self, convention: Convention) -> Definition {
        let own = match convention {
            Convention::Iso => None,
            Convention::Adams => self.adams,
            Convention::Lotus => self.lotus,
        };
        own.unwrap_or(Definition {
            sign: self.sign,
            formula: self.formula,
            source: self.source,
            value: self.value,
        })
    }

    /// The name of its column: name and unit.
    pub fn column(&self, units: Units) -> String {
        self.quantity.column(self.name, units)
    }

    /// The value (SI) by a convention.
    pub fn value(&self, convention: Convention, pose: &Pose<f64>) -> Option<f64> {
        let value = (self.by(convention).value.plain)(pose);
        value.filter(|value| value.is_finite() && self.applies(pose))
    }

    /// The value by ISO 8855 in the units of a model.
    pub fn show(&self, units: Units, pose: &Pose<f64>) -> Option<f64> {
        self.show_by(Convention::Iso, units, pose)
    }

    /// The value by a convention in the units of a model.
    pub fn show_by(&self, convention: Convention, units: Units, pose: &Pose<f64>) -> Option<f64> {
        self.value(convention, pose).map(|value| self.quantity.show(units, value))
    }

    /// Whether the axle of the corner has such a factor, as far as the axle is known.
    pub fn applies(&self, pose: &Pose<f64>) -> bool {
        match (self.axle, pose.vehicle.axle) {
            (Some(only), Some(axle)) => only == axle,
            _ => true,
        }
    }

    /// Whether the factor belongs to both wheels together.
    pub fn is_of_axle(&self) -> bool {
        self.scope == Scope::Axle
    }

    /// What the state lacks to have this factor.
    pub fn missing(&self, pose: &Pose<f64>) -> impl Iterator<Item = Need> {
        self.needs.iter().copied().filter(|need| !need.is_met(pose))
    }
}

/// The three components of a vector as factors, in the model's axes. `$base` has what they share.
macro_rules! components {
    ($name:literal, $title:literal, $symbol:literal, $vector:expr, $base:expr) => {
        [
            components!($name, $title, $symbol, $vector, $base, "x", 0),
            components!($name, $title, $symbol, $vector, $base, "y", 1),
            components!($name, $title, $symbol, $vector, $base, "z", 2),
        ]
    };
    ($name:literal, $title:literal, $symbol:literal, $vector:expr, $base:expr, $axis:literal, $k:literal) => {
        crate::factors::Factor {
            name: concat!($name, "_", $axis),
            title: concat!($title, ", ", $axis),
            symbol: concat!($symbol, "_", $axis),
            sign: concat!("+ along the model's +", $axis),
            value: crate::factors::definition::formula!(|pose| {
                Some(pose.axes.from_iso($vector(pose)?)[$k])
            }),
            ..$base
        }
    };
}
pub(super) use components;
