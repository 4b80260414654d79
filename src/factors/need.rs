//! What a factor needs of a model besides the geometry of the wheel.

use crate::rig::Pose;

/// Something that a model or a state may lack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Need {
    /// Tangents: how the wheel moves in travel.
    Motion,
    /// A compliance matrix.
    Compliance,
    /// Both wheels of an axle.
    BothWheels,
    /// A tyre.
    Tyre,
    /// A rack.
    Rack,
    /// `rack_per_turn` of `[steering]`.
    SteeringRatio,
    /// A steer axis through two joints.
    SteerAxis,
    /// A spring.
    Spring,
    /// A damper.
    Damper,
    /// Forces.
    Forces,
    /// `axle` of `[vehicle]`.
    Axle,
    /// `wheelbase` of `[vehicle]`.
    Wheelbase,
    /// `cg_height` of `[vehicle]`.
    CgHeight,
    /// `brake_share` of `[vehicle]`.
    BrakeShare,
    /// `drive_share` of `[vehicle]`.
    DriveShare,
    /// `mass` of `[vehicle]`.
    Mass,
    /// `sprung_mass` of `[vehicle]` or of `[quarter_car]`.
    SprungMass,
    /// `unsprung_mass` of `[vehicle]`.
    UnsprungMass,
}

impl Need {
    /// What to add, as the end of "needs …".
    pub const fn words(self) -> &'static str {
        match self {
            Self::Motion => {
                "a state off a dead centre, and one of equilibrium where the wheel is free"
            }
            Self::Compliance => {
                "a compliance matrix: a wheel that the rig holds at a travel, and forces that hold it where \
                 the rig lets it go"
            }
            Self::BothWheels => "both wheels: the option --axle",
            Self::Tyre => "a section [tyre], and forces that give the load on it",
            Self::Rack => "a rack",
            Self::SteeringRatio => "`rack_per_turn` in [steering]",
            Self::SteerAxis => "a steer axis through two joints, [steer_axis] of the architecture",
            Self::Spring => {
                "a spring: one of [[forces]], or the points that [spring] of the architecture names"
            }
            Self::Damper => {
                "a damper: one of [[forces]], or the points that [damper] of the architecture names"
            }
            Self::Forces => "forces: [[forces]], [bushings] or weights",
            Self::Axle => "`axle` in [vehicle]",
            Self::Wheelbase => "`wheelbase` in [vehicle]",
            Self::CgHeight => "`cg_height` in [vehicle]",
            Self::BrakeShare => "`brake_share` in [vehicle]",
            Self::DriveShare => "`drive_share` in [vehicle]",
            Self::Mass => "`mass` in [vehicle]",
            Self::SprungMass => "`sprung_mass` in [vehicle]",
            Self::UnsprungMass => "`unsprung_mass` in [vehicle]",
        }
    }

    /// A few words for a table.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Motion => "motion",
            Self::Compliance => "compliance",
            Self::BothWheels => "both wheels",
            Self::Tyre => "tyre",
            Self::Rack => "rack",
            Self::SteeringRatio => "`rack_per_turn`",
            Self::SteerAxis => "steer axis",
            Self::Spring => "spring",
            Self::Damper => "damper",
            Self::Forces => "forces",
            Self::Axle => "`axle`",
            Self::Wheelbase => "`wheelbase`",
            Self::CgHeight => "`cg_height`",
            Self::BrakeShare => "`brake_share`",
            Self::DriveShare => "`drive_share`",
            Self::Mass => "`mass`",
            Self::SprungMass => "`sprung_mass`",
            Self::UnsprungMass => "`unsprung_mass`",
        }
    }

    /// Whether a state has it.
    pub fn is_met(self, pose: &Pose<f64>) -> bool {
        let vehicle = &pose.vehicle;
        match self {
            Self::Motion => pose.motions.is_some(),
            Self::Compliance => pose.compliance.is_some(),
            Self::BothWheels => pose.other.is_some(),
            Self::Tyre => pose.tyre.is_some(),
            Self::Rack => pose.motions.is_some_and(|motions| motions.rack.is_some()),
            Self::SteeringRatio => vehicle.rack_per_radian.is_some(),
            Self::SteerAxis => pose.steer_axis.is_some(),
            Self::Spring => pose.spring.is_some(),
            Self::Damper => pose.damper.is_some(),
            Self::Forces => pose.load.is_some(),
            Self::Axle => vehicle.axle.is_some(),
            Self::Wheelbase => vehicle.wheelbase.is_some(),
            Self::CgHeight => vehicle.cg_height.is_some(),
            Self::BrakeShare => vehicle.brake_share.is_some(),
            Self::DriveShare => vehicle.drive_share.is_some(),
            Self::Mass => vehicle.mass.is_some(),
            Self::SprungMass => vehicle.sprung_mass.is_some(),
            Self::UnsprungMass => vehicle.unsprung_mass.is_some(),
        }
    }
}
