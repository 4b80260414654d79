//! Whether joints hold, from positions of points and rotations of bodies: no residual of the solver plays a part.

use hardpoint::mechanism::{BodyId, Direction, JointKind, PointId};
use hardpoint::solve::System;

type Vector = [f64; 3];

pub fn distance(a: Vector, b: Vector) -> f64 {
    sub(a, b).iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn sub(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

fn turn(rotation: [Vector; 3], vector: Vector) -> Vector {
    rotation.map(|row| (0..3).map(|k| row[k] * vector[k]).sum())
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn design(system: &System, point: PointId) -> Vector {
    system.mechanism().points()[point.index()].position
}

fn direction(system: &System, direction: Direction) -> Vector {
    let vector = match direction {
        Direction::Between(from, to) => sub(design(system, to), design(system, from)),
        Direction::Fixed(vector) => vector,
    };
    vector.map(|x| x / distance(vector, [0.0; 3]))
}

/// The joint that is furthest from holding, and by how much (m, or rad).
pub fn largest_error(system: &System) -> (f64, String) {
    largest_error_of(system, 0.0)
}

/// The same with the first body of every joint moved by `aside` (m).
pub fn largest_error_of(system: &System, aside: f64) -> (f64, String) {
    let mut worst = (0.0, String::new());
    for joint in system.mechanism().joints() {
        let on_i = |point| {
            let [x, y, z] = system.point_position(joint.i, point);
            [x + aside, y, z]
        };
        let on_j = |point| system.point_position(joint.j, point);
        let turned = |axis: Direction| {
            let axis = direction(system, axis);
            [joint.i, joint.j].map(|body: BodyId| turn(system.rotation(body), axis))
        };
        let apart = |point| distance(on_i(point), on_j(point));
        let aligned = |axis| {
            let [a, b] = turned(axis);
            distance(a, b)
        };
        let beside = |at, axis| {
            let [along, _] = turned(axis);
            distance(cross(along, sub(on_j(at), on_i(at))), [0.0; 3])
        };
        let error = match joint.kind {
            JointKind::Spherical { at } => apart(at),
            // The cross: turning about the shaft is left to the mobility of the whole.
            JointKind::Universal { at, .. } => apart(at),
            JointKind::Revolute { at, axis } => apart(at).max(aligned(axis)),
            JointKind::Cylindrical { at, axis } => beside(at, axis).max(aligned(axis)),
            JointKind::Translational { at, axis } => {
                let [a, b] = [joint.i, joint.j].map(|body| system.rotation(body));
                let turned = (0..3).map(|row| distance(a[row], b[row])).fold(0.0, f64::max);
                beside(at, axis).max(turned)
            }
            JointKind::Link { on_i: first, on_j: second } => {
                let length = distance(design(system, first), design(system, second));
                (distance(on_i(first), on_j(second)) - length).abs()
            }
            JointKind::InPlane { at, normal } => {
                let [normal, _] = turned(normal);
                let off = sub(on_j(at), on_i(at));
                (0..3).map(|k| normal[k] * off[k]).sum::<f64>().abs()
            }
            JointKind::ParallelAxes { axis, .. } => aligned(axis),
            kind => panic!("no architecture has had a joint that is {}", kind.name()),
        };
        if error.is_nan() || error > worst.0 {
            worst = (error, joint.name.clone());
        }
    }
    worst
}

/// Where a point of a body is, by name.
pub fn place(system: &System, body: &str, point: &str) -> Vector {
    let mechanism = system.mechanism();
    let body = mechanism.body_named(body).unwrap_or_else(|| panic!("no body {body}"));
    let point = mechanism.point_named(point).unwrap_or_else(|| panic!("no point {point}"));
    system.point_position(body, point)
}

/// All points of joints with the bodies that they belong to.
pub fn places(system: &System) -> Vec<(String, String, Vector)> {
    let mechanism = system.mechanism();
    let mut places = vec![];
    for joint in mechanism.joints() {
        for (body, point) in [joint.i, joint.j].into_iter().zip(joint.kind.points()) {
            let names =
                (&mechanism.bodies()[body.index()].name, &mechanism.points()[point.index()].name);
            places.push((names.0.clone(), names.1.clone(), system.point_position(body, point)));
        }
    }
    places
}
