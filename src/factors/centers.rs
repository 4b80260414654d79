//! Instant centres in front and side view, and the swing arms to them.

use super::compliance::{Pair, per_rise};
use super::definition::{Factor, Subject, formula};
use super::need::Need;
use super::travel::per_travel;
use super::{FARTHEST, quotient};
use crate::model::Quantity;
use crate::rig::Pose;
use crate::scalar::Real;
use crate::vector::{Vector, add};

/// The point of the wheel's body in whose plane a centre is sought, and the motion of the body.
#[derive(Clone, Copy)]
enum Plane {
    /// The wheel centre, in travel.
    Center,
    /// The patch, in travel.
    Patch,
    /// The wheel centre under equal vertical forces on both wheels.
    Ride,
    /// The wheel centre under opposed ones.
    Roll,
}

impl Plane {
    fn point<S: Real>(self, pose: &Pose<S>) -> Vector<S> {
        match self {
            Self::Patch => pose.wheel.contact_patch(),
            Self::Center | Self::Ride | Self::Roll => pose.wheel.center,
        }
    }
}

/// Velocity of the point and angular velocity, per metre that the wheel centre rises.
fn motion<S: Real>(pose: &Pose<S>, plane: Plane) -> Option<(Vector<S>, Vector<S>)> {
    let twist = match plane {
        Plane::Center | Plane::Patch => per_travel(pose)?,
        Plane::Ride => per_rise(pose, Pair::Parallel)?,
        Plane::Roll => per_rise(pose, Pair::Opposed)?,
    };
    Some((twist.at(plane.point(pose)), twist.rotation))
}

/// Signed length of the arm to the centre of a plane motion with the velocity (`across`, `up`) and the
/// angular velocity `turn`; `None` where the centre is at infinity.
fn arm<S: Real>(across: S, up: S, turn: S) -> Option<S> {
    quotient((across * across + up * up).sqrt(), turn, FARTHEST)
}

/// Length of the arm, positive with the centre inboard.
fn front_length<S: Real>(pose: &Pose<S>, plane: Plane) -> Option<S> {
    let (v, omega) = motion(pose, plane)?;
    arm(v[1], v[2], pose.sigma() * omega[0])
}

/// Length of the arm, positive with the centre rearward.
fn side_length<S: Real>(pose: &Pose<S>, plane: Plane) -> Option<S> {
    let (v, omega) = motion(pose, plane)?;
    arm(v[0], v[2], -omega[1])
}

/// Inclination of the arm, positive where it rises inboard.
fn front_angle<S: Real>(pose: &Pose<S>, plane: Plane) -> Option<S> {
    let (v, _) = motion(pose, plane)?;
    Some((pose.sigma() * v[1]).atan2(v[2]))
}

/// Inclination of the arm, positive where it rises rearward.
fn side_angle<S: Real>(pose: &Pose<S>, plane: Plane) -> Option<S> {
    let (v, _) = motion(pose, plane)?;
    Some(v[0].atan2(v[2]))
}

/// The centre in the plane across the vehicle, in the model's axes.
fn front<S: Real>(pose: &Pose<S>, plane: Plane) -> Option<Vector<S>> {
    let (v, omega) = motion(pose, plane)?;
    arm(v[1], v[2], omega[0])?;
    let to = [S::from_f64(0.0), -(v[2] / omega[0]), v[1] / omega[0]];
    Some(pose.axes.from_iso(add(plane.point(pose), to)))
}

/// The centre in the plane along the vehicle, in the model's axes.
fn side<S: Real>(pose: &Pose<S>, plane: Plane) -> Option<Vector<S>> {
    let (v, omega) = motion(pose, plane)?;
    arm(v[0], v[2], omega[1])?;
    let to = [v[2] / omega[1], S::from_f64(0.0), -(v[0] / omega[1])];
    Some(pose.axes.from_iso(add(plane.point(pose), to)))
}

const CENTERS: Factor = Factor {
    subject: Subject::Centers,
    quantity: Quantity::Length,
    needs: &[Need::Motion],
    source: "plane motion; Adams/Car, Altair",
    ..Factor::BLANK
};

const ELASTIC: Factor =
    Factor { needs: &[Need::Compliance], source: "Adams/Car, Altair 140 to 170", ..CENTERS };

/// The four factors of one view in the plane of one point.
macro_rules! of_view {
    (
        $base:ident, $plane:ident, $end:literal, $of:literal, $mark:literal,
        $ic:literal, $arm:literal, $view:literal,
        $center:ident, $length:ident, $angle:ident,
        $axis:literal, $k:literal, $across:literal, $height:literal, $long:literal, $slope:literal,
        $way:literal
    ) => {
        [
            Factor {
                name: concat!($ic, $end, "_", $axis),
                title: concat!($view, " instant centre", $of, ", ", $axis),
                symbol: concat!("I_", $axis, $mark),
                sign: concat!("+ along the model's +", $axis),
                formula: $across,
                value: formula!(|pose| Some($center(pose, Plane::$plane)?[$k])),
                ..$base
            },
            Factor {
                name: concat!($ic, $end, "_z"),
                title: concat!($view, " instant centre", $of, ", z"),
                symbol: concat!("I_z", $mark),
                sign: "+ along the model's +z",
                formula: $height,
                value: formula!(|pose| Some($center(pose, Plane::$plane)?[2])),
                ..$base
            },
            Factor {
                name: concat!($arm, $end, "_length"),
                title: concat!($view, " swing arm length", $of),
                symbol: concat!("l", $mark),
                sign: concat!("+ centre ", $way, " of the wheel"),
                formula: $long,
                value: formula!(|pose| $length(pose, Plane::$plane)),
                ..$base
            },
            Factor {
                name: concat!($arm, $end, "_angle"),
                title: concat!($view, " swing arm angle", $of),
                symbol: concat!("φ", $mark),
                quantity: Quantity::Angle,
                sign: concat!("+ arm rises ", $way),
                formula: $slope,
                value: formula!(|pose| $angle(pose, Plane::$plane)),
                ..$base
            },
        ]
    };
}

const FRONT_CENTER: [Factor; 4] = of_view!(
    CENTERS,
    Center,
    "",
    "",
    "_f",
    "fvic",
    "fvsa",
    "front-view",
    front,
    front_length,
    front_angle,
    "y",
    1,
    "W_y − v_Wz / ω_x in the plane x = W_x",
    "W_z + v_Wy / ω_x in the plane x = W_x",
    "σ √(v_Wy² + v_Wz²) / ω_x, v_Wz = 1",
    "atan(σ v_Wy / v_Wz)",
    "inboard"
);

const FRONT_PATCH: [Factor; 4] = of_view!(
    CENTERS,
    Patch,
    "_patch",
    " in the plane of the patch",
    "_fP",
    "fvic",
    "fvsa",
    "front-view",
    front,
    front_length,
    front_angle,
    "y",
    1,
    "P_y − v_Pz / ω_x in the plane x = P_x",
    "P_z + v_Py / ω_x in the plane x = P_x",
    "σ √(v_Py² + v_Pz²) / ω_x, v_Wz = 1",
    "atan(σ v_Py / v_Pz)",
    "inboard"
);

const SIDE_CENTER: [Factor; 4] = of_view!(
    CENTERS,
    Center,
    "",
    "",
    "_s",
    "svic",
    "svsa",
    "side-view",
    side,
    side_length,
    side_angle,
    "x",
    0,
    "W_x + v_Wz / ω_y in the plane y = W_y",
    "W_z − v_Wx / ω_y in the plane y = W_y",
    "−√(v_Wx² + v_Wz²) / ω_y, v_Wz = 1",
    "atan(v_Wx / v_Wz)",
    "rearward"
);

const SIDE_PATCH: [Factor; 4] = of_view!(
    CENTERS,
    Patch,
    "_patch",
    " in the plane of the patch",
    "_sP",
    "svic",
    "svsa",
    "side-view",
    side,
    side_length,
    side_angle,
    "x",
    0,
    "P_x + v_Pz / ω_y in the plane y = P_y",
    "P_z − v_Px / ω_y in the plane y = P_y",
    "−√(v_Px² + v_Pz²) / ω_y, v_Wz = 1",
    "atan(v_Px / v_Pz)",
    "rearward"
);

const FRONT_ELASTIC: [Factor; 4] = of_view!(
    ELASTIC,
    Roll,
    "_elastic",
    " from the compliance",
    "_fe",
    "fvic",
    "fvsa",
    "front-view",
    front,
    front_length,
    front_angle,
    "y",
    1,
    "W_y − v_Wz / ω_x under opposed vertical forces",
    "W_z + v_Wy / ω_x under opposed vertical forces",
    "σ √(v_Wy² + v_Wz²) / ω_x: √(dy² + dz²)/dθ, dy = C23 − C29, dz = C33 − C39, dθ = C43 − C49",
    "atan(σ v_Wy / v_Wz) under opposed vertical forces",
    "inboard"
);

const SIDE_ELASTIC: [Factor; 4] = of_view!(
    ELASTIC,
    Ride,
    "_elastic",
    " from the compliance",
    "_se",
    "svic",
    "svsa",
    "side-view",
    side,
    side_length,
    side_angle,
    "x",
    0,
    "W_x + v_Wz / ω_y under equal vertical forces",
    "W_z − v_Wx / ω_y under equal vertical forces",
    "−√(v_Wx² + v_Wz²) / ω_y: √(dx² + dz²)/dθ, dx = C13 + C19, dz = C33 + C39, dθ = C53 + C59",
    "atan(v_Wx / v_Wz) under equal vertical forces",
    "rearward"
);

pub(super) const VIEWS: [&[Factor]; 6] =
    [&FRONT_CENTER, &FRONT_PATCH, &SIDE_CENTER, &SIDE_PATCH, &FRONT_ELASTIC, &SIDE_ELASTIC];
