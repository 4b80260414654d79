//! How a suspension is set up: what drives it, what it stands on, what its chassis does.

use thiserror::Error;

use crate::mechanism::MechanismError;

/// Which height the travel driver prescribes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drive {
    /// Height of the wheel centre, as Adams/Car does.
    #[default]
    WheelCenter,
    /// Height of the contact patch, the lowest point of the tyre's disc, as Lotus does.
    ContactPatch,
}

impl Drive {
    /// The name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::WheelCenter => "wheel-center",
            Self::ContactPatch => "contact-patch",
        }
    }

    /// What is driven, in words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::WheelCenter => "wheel centre",
            Self::ContactPatch => "contact patch",
        }
    }
}

/// What carries the wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WheelSupport {
    /// The travel driver holds the wheel at its height; the tyre has no force.
    #[default]
    Held,
    /// The wheel is free: it stands on the tyre of `[tyre]`, or hangs where the model has none.
    Free,
}

/// What the chassis does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Chassis {
    /// It never moves.
    #[default]
    Fixed,
    /// It moves up and down with the mass of `[quarter_car]`.
    Slide,
    /// It rolls above the road about an axis along x in the middle of the vehicle, y = 0, and heaves
    /// with it. The rig drives both motions. Of an axle only.
    Roll {
        /// The height of the axis at the design position (m), in the coordinates of the points.
        axis: f64,
    },
}

/// How a suspension is set up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Setup {
    /// Which height the travel driver prescribes.
    pub drive: Drive,
    /// What carries the wheel.
    pub support: WheelSupport,
    /// What the chassis does.
    pub chassis: Chassis,
    /// Whether all joints are rigid: no bushing stands for a joint. Other forces stay.
    pub kinematic: bool,
}

impl From<Drive> for Setup {
    /// Driven in this way, and otherwise as by default.
    fn from(drive: Drive) -> Self {
        Self { drive, ..Self::default() }
    }
}

/// Why a model cannot be set up.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SuspensionError {
    /// The points make no mechanism.
    #[error(transparent)]
    Mechanism(Box<MechanismError>),
    /// [`Chassis::Slide`] without a sprung mass.
    #[error(
        "the model `{0}` has no sprung mass, so its chassis cannot move; add a section \
         `[quarter_car]` with `sprung_mass`, or fix the chassis"
    )]
    NoQuarterCar(String),
    /// [`Chassis::Slide`] of an axle.
    #[error("the chassis of an axle does not slide; fix it, or look at one side alone")]
    AxleSlides,
    /// A corner of an architecture that has none.
    #[error(
        "the two sides of `{0}` are one mechanism, so there is no corner of it; put both sides on the rig"
    )]
    OnlyAxle(String),
    /// [`Chassis::Roll`] of a corner.
    #[error("the chassis of one side alone does not roll; put both sides on the rig")]
    CornerRolls,
    /// Two models that are not the sides of one axle.
    #[error(
        "`{left}` and `{right}` are not the two sides of one axle: {difference}; give both sides one \
         architecture, or let one be the mirror image of the other"
    )]
    SidesDiffer {
        /// The model of the left side.
        left: String,
        /// The model of the right side.
        right: String,
        /// What differs.
        difference: String,
    },
}

impl From<MechanismError> for SuspensionError {
    fn from(error: MechanismError) -> Self {
        Self::Mechanism(Box::new(error))
    }
}
