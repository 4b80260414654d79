//! How the wheel moves in travel: gradients, velocities, the screw axis.

use super::definition::{Definition, Factor, Subject, components, formula};
use super::need::Need;
use super::screw::Screw;
use super::wheel::{camber, caster, front_view_camber, toe};
use super::{NEARLY_PARALLEL, quotient};
use crate::model::Quantity;
use crate::rig::{Pose, Wheel};
use crate::scalar::{Dual, Real, Scalar};
use crate::solve::Twist;
use crate::vector::{Vector, norm};

/// The motion of the wheel's body per metre of its centre's travel.
pub(super) fn per_travel<S: Real>(pose: &Pose<S>) -> Option<Twist<S>> {
    by_rise(&pose.motions?.travel.wheel, pose.wheel.center)
}

/// A motion per metre that a point of its body rises; `None` where it hardly rises.
pub(super) fn by_rise<S: Real>(twist: &Twist<S>, point: Vector<S>) -> Option<Twist<S>> {
    let v = twist.at(point);
    quotient(norm(v.map(Real::value)), v[2].value(), NEARLY_PARALLEL)?;
    Some(twist.times(S::from_f64(1.0) / v[2]))
}

/// The wheel in travel.
pub(super) fn moving<S: Real>(pose: &Pose<S>) -> Option<Wheel<Dual<S>>> {
    Some(pose.wheel.moving(&pose.motions?.travel.wheel))
}

/// The rate of the wheel centre's height in travel.
pub(super) fn center_rise<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(moving(pose)?.center[2].derivative)
}

/// The rate of the contact patch's height in travel.
pub(super) fn patch_rise<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(moving(pose)?.contact_patch()[2].derivative)
}

fn toe_rate<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(toe(moving(pose)?.spin, pose.side).derivative)
}

fn camber_rate<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(camber(moving(pose)?.spin).derivative)
}

fn front_view_camber_rate<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(front_view_camber(moving(pose)?.spin, pose.side).derivative)
}

fn caster_rate<S: Real>(pose: &Pose<S>) -> Option<S> {
    let axis = pose.steer_axis?.moving(&pose.motions?.travel.steer_axis?);
    Some(caster(axis.direction()).derivative)
}

/// A rate per metre of something's height.
fn per<S: Real>(rise: Option<S>, rate: Option<S>) -> Option<S> {
    quotient(rate?, rise?, NEARLY_PARALLEL)
}

const TRAVEL: Factor = Factor { subject: Subject::Travel, needs: &[Need::Motion], ..Factor::BLANK };

const GRADIENT: Factor = Factor { quantity: Quantity::Gradient, ..TRAVEL };

pub(super) const GRADIENTS: &[Factor] = &[
    Factor {
        name: "bump_steer",
        title: "bump steer",
        symbol: "dδ_t/dz",
        sign: "+ toe-in in jounce",
        formula: "d toe / dW_z, exact slope",
        source: "Adams/Car, Altair",
        value: formula!(|pose| per(center_rise(pose), toe_rate(pose))),
        lotus: Some(Definition {
            sign: "+ toe-in in jounce",
            formula: "d toe / dP_z, P the lowest point",
            source: "Lotus",
            value: formula!(|pose| per(patch_rise(pose), toe_rate(pose))),
        }),
        ..GRADIENT
    },
    Factor {
        name: "bump_camber",
        title: "bump camber",
        symbol: "dγ/dz",
        sign: "+ top outboard in jounce",
        formula: "d camber / dW_z, exact slope",
        source: "Adams/Car, Altair",
        value: formula!(|pose| per(center_rise(pose), camber_rate(pose))),
        lotus: Some(Definition {
            sign: "+ top outboard in jounce",
            formula: "d camber / dP_z, P the lowest point, camber as seen from the front",
            source: "Lotus",
            value: formula!(|pose| per(patch_rise(pose), front_view_camber_rate(pose))),
        }),
        ..GRADIENT
    },
    Factor {
        name: "bump_caster",
        title: "bump caster",
        symbol: "dτ/dz",
        sign: "+ top rearward in jounce",
        formula: "d caster / dW_z of the axis through the joints, exact slope",
        source: "Adams/Car, Altair",
        value: formula!(|pose| per(center_rise(pose), caster_rate(pose))),
        lotus: Some(Definition {
            sign: "+ top rearward in jounce",
            formula: "d caster / dP_z, P the lowest point",
            source: "Lotus",
            value: formula!(|pose| per(patch_rise(pose), caster_rate(pose))),
        }),
        needs: &[Need::Motion, Need::SteerAxis],
        ..GRADIENT
    },
    Factor {
        name: "recession_angle",
        title: "angle of the wheel-centre path in side view",
        symbol: "ε",
        quantity: Quantity::Angle,
        sign: "+ rearward in jounce",
        formula: "atan(−v_Wx / v_Wz)",
        source: "MathWorks, Morse",
        value: formula!(|pose| {
            let v = per_travel(pose)?.at(pose.wheel.center);
            Some((-v[0]).atan2(v[2]))
        }),
        ..TRAVEL
    },
];

const VELOCITY: Factor = Factor { quantity: Quantity::Ratio, ..TRAVEL };

fn center_velocity<S: Real>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(per_travel(pose)?.at(pose.wheel.center))
}

pub(super) const CENTER_VELOCITY: [Factor; 3] = components!(
    "center_velocity",
    "velocity of the wheel centre by its travel",
    "v_W",
    center_velocity,
    Factor { formula: "dW / dW_z, in the model's axes", source: "Adams/Car", ..VELOCITY }
);

fn angular_velocity<S: Real>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(per_travel(pose)?.rotation)
}

pub(super) const ANGULAR_VELOCITY: [Factor; 3] = components!(
    "angular_velocity",
    "angular velocity of the wheel's body by its travel",
    "ω",
    angular_velocity,
    Factor {
        formula: "turn of the body by W_z, right-handed, in the model's axes",
        source: "Adams/Car",
        ..GRADIENT
    }
);

fn patch_velocity<S: Real>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(per_travel(pose)?.at(pose.wheel.contact_patch()))
}

pub(super) const PATCH_VELOCITY: [Factor; 3] = components!(
    "patch_velocity",
    "velocity of the body's point in the patch by travel",
    "v_P",
    patch_velocity,
    Factor {
        formula: "v_W + ω × (P − W): the wheel locked to its body, in the model's axes",
        source: "Lotus",
        ..VELOCITY
    }
);

fn patch_path<S: Real>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(pose.wheel.moving(&per_travel(pose)?).contact_patch().map(|c| c.derivative))
}

pub(super) const PATCH_PATH: [Factor; 3] = components!(
    "patch_path",
    "path of the lowest point of the tyre by travel",
    "dP",
    patch_path,
    Factor {
        formula: "dP / dW_z of the lowest point, which wanders round the tyre, in the model's axes",
        source: "Lotus",
        ..VELOCITY
    }
);

fn screw<S: Real>(pose: &Pose<S>) -> Option<Screw<S>> {
    Screw::of(&per_travel(pose)?, pose.wheel.center)
}

fn screw_direction<S: Real>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(screw(pose)?.direction)
}

pub(super) const SCREW_DIRECTION: [Factor; 3] = components!(
    "screw_axis",
    "direction of the screw axis of travel",
    "e",
    screw_direction,
    Factor {
        formula: "ω / abs(ω), in the model's axes",
        source: "Ball, Theory of Screws",
        ..VELOCITY
    }
);

fn screw_point<S: Real>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(screw(pose)?.point)
}

pub(super) const SCREW_POINT: [Factor; 3] = components!(
    "screw_point",
    "point of the screw axis nearest to the wheel centre",
    "S",
    screw_point,
    Factor {
        formula: "W + ω × v_W / ω², in the model's axes",
        source: "Ball, Theory of Screws",
        ..TRAVEL
    }
);

pub(super) const SCREW_PITCH: &[Factor] = &[Factor {
    name: "screw_pitch",
    title: "pitch of the screw axis of travel",
    symbol: "p",
    quantity: Quantity::Pitch,
    sign: "+ right-handed screw",
    formula: "ω·v_W / ω²",
    source: "Ball, Theory of Screws",
    value: formula!(|pose| Some(screw(pose)?.pitch)),
    ..TRAVEL
}];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rate_without_rise_is_no_gradient() {
        assert_eq!(per(Some(2.0), Some(1.0)), Some(0.5));
        assert_eq!(per(Some(0.0), Some(1.0)), None);
        assert_eq!(per::<f64>(None, Some(1.0)), None);
        let zero = Dual::<f64>::from_f64(0.0);
        assert_eq!(per(Some(zero), Some(zero)), None);
    }
}
