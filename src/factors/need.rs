//! What a factor needs of a model besides the geometry of the wheel.

use crate::rig::Pose;

/// Something that a model or a state may lack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Need {
    /// Tangents: a wheel that is held at its height.
    HeldWheel,
    /// A rack.
    Rack,
    /// `rack_per_turn` of `[steering]`.
    SteeringRatio,
    /// A steer axis through two joints.
    SteerAxis,
    /// A spring.
    Spring,
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
}

impl Need {
    /// What to add, as the end of "needs …".
    pub const fn words(self) -> &'static str {
        match self {
            Self::HeldWheel => "a wheel that is held at its height, off a dead centre",
            Self::Rack => "a rack",
            Self::SteeringRatio => "`rack_per_turn` in [steering]",
            Self::SteerAxis => "a steer axis through two joints, [steer_axis] of the architecture",
            Self::Spring => {
                "a spring: one of [[forces]], or the points that [spring] of the architecture names"
            }
            Self::Forces => "forces: [[forces]], [bushings] or weights",
            Self::Axle => "`axle` in [vehicle]",
            Self::Wheelbase => "`wheelbase` in [vehicle]",
            Self::CgHeight => "`cg_height` in [vehicle]",
            Self::BrakeShare => "`brake_share` in [vehicle]",
            Self::DriveShare => "`drive_share` in [vehicle]",
        }
    }

    /// A few words for a table.
    pub const fn label(self) -> &'static str {
        match self {
            Self::HeldWheel => "held wheel",
            Self::Rack => "rack",
            Self::SteeringRatio => "`rack_per_turn`",
            Self::SteerAxis => "steer axis",
            Self::Spring => "spring",
            Self::Forces => "forces",
            Self::Axle => "`axle`",
            Self::Wheelbase => "`wheelbase`",
            Self::CgHeight => "`cg_height`",
            Self::BrakeShare => "`brake_share`",
            Self::DriveShare => "`drive_share`",
        }
    }

    /// Whether a state has it.
    pub fn is_met(self, pose: &Pose<f64>) -> bool {
        let vehicle = &pose.vehicle;
        match self {
            Self::HeldWheel => pose.motions.is_some(),
            Self::Rack => pose.motions.is_some_and(|motions| motions.rack.is_some()),
            Self::SteeringRatio => vehicle.rack_per_radian.is_some(),
            Self::SteerAxis => pose.steer_axis.is_some(),
            Self::Spring => pose.spring.is_some(),
            Self::Forces => pose.load.is_some(),
            Self::Axle => vehicle.axle.is_some(),
            Self::Wheelbase => vehicle.wheelbase.is_some(),
            Self::CgHeight => vehicle.cg_height.is_some(),
            Self::BrakeShare => vehicle.brake_share.is_some(),
            Self::DriveShare => vehicle.drive_share.is_some(),
        }
    }
}
