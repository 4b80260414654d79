//! A small motion of bodies, and its description in words.

use faer::MatRef;

use super::position::Scales;
use crate::mechanism::{BodyId, Direction, Mechanism, PointId};
use crate::relation::{BODY_COORDINATES, Coordinates};
use crate::scalar::Scalar;
use crate::vector::{Vector, add, cross, dot, norm, rotate, scale, sub, unit};

/// How a body moves: the velocity of its point that is at the origin (m/s), and its angular
/// velocity (rad/s). Per unit of a driver, seconds stand for that unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist<S = f64> {
    /// Velocity of the point of the body that is at the origin.
    pub velocity: Vector<S>,
    /// Angular velocity.
    pub rotation: Vector<S>,
}

impl<S: Scalar> Twist<S> {
    /// The twist of one body from the rates of its coordinates, ω = 2 E ṗ (Haug, 9.3).
    pub fn new(q: &Coordinates<S>, rate: &[S]) -> Self {
        let (e0, e) = (q[3], [q[4], q[5], q[6]]);
        let (e0_rate, e_rate) = (rate[3], [rate[4], rate[5], rate[6]]);
        let half = add(sub(scale(e0, e_rate), scale(e0_rate, e)), cross(e, e_rate));
        let rotation = scale(S::from_f64(2.0), half);
        let velocity = sub([rate[0], rate[1], rate[2]], cross(rotation, [q[0], q[1], q[2]]));
        Self { velocity, rotation }
    }

    /// Velocity of the point of the body that is at `position`.
    pub fn at(&self, position: Vector<S>) -> Vector<S> {
        add(self.velocity, cross(self.rotation, position))
    }

    /// The motion relative to another one.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Self {
            velocity: sub(self.velocity, other.velocity),
            rotation: sub(self.rotation, other.rotation),
        }
    }

    /// The same motion, so many times as fast.
    #[must_use]
    pub fn times(&self, factor: S) -> Self {
        Self { velocity: scale(factor, self.velocity), rotation: scale(factor, self.rotation) }
    }
}

impl Twist {
    /// The largest component, velocities divided by `length`.
    pub(super) fn size(&self, length: f64) -> f64 {
        let velocity = self.velocity.iter().map(|v| v.abs() / length);
        velocity.chain(self.rotation.iter().map(|w| w.abs())).fold(0.0, f64::max)
    }
}

/// The twists of all bodies, the ground first, from scaled rates of the unknowns.
pub(super) fn twists(state: &[Coordinates<f64>], rates: &[f64], scales: Scales) -> Vec<Twist> {
    let mut twists = vec![Twist::default()];
    for (body, q) in state.iter().enumerate().skip(1) {
        let first = BODY_COORDINATES * (body - 1);
        let rate: [f64; BODY_COORDINATES] =
            std::array::from_fn(|k| rates[first + k] * scales.coordinate(first + k));
        twists.push(Twist::new(q, &rate));
    }
    twists
}

/// Replaces the basis (columns) by one that tells independent motions apart: each
/// motion leaves still what is typical for the others (row-reduced form with
/// full pivoting on the bodies' velocities).
pub(super) fn localise(
    state: &[Coordinates<f64>],
    basis: MatRef<'_, f64>,
    scales: Scales,
) -> Vec<Vec<Twist>> {
    let mut motions: Vec<Vec<f64>> = (0..basis.ncols())
        .map(|column| {
            let rates: Vec<f64> = (0..basis.nrows()).map(|row| basis[(row, column)]).collect();
            let twists = twists(state, &rates, scales);
            let scaled = |twist: &Twist| {
                let v = scale(1.0 / scales.length, twist.velocity);
                [v[0], v[1], v[2], twist.rotation[0], twist.rotation[1], twist.rotation[2]]
            };
            twists.iter().flat_map(scaled).collect()
        })
        .collect();
    for pivot_row in 0..motions.len() {
        let candidates = (pivot_row..motions.len())
            .flat_map(|row| (0..motions[row].len()).map(move |column| (row, column)));
        let Some((row, column)) =
            candidates.max_by(|a, b| motions[a.0][a.1].abs().total_cmp(&motions[b.0][b.1].abs()))
        else {
            break;
        };
        motions.swap(pivot_row, row);
        let pivot = motions[pivot_row][column];
        motions[pivot_row].iter_mut().for_each(|x| *x /= pivot);
        let pivot_motion = motions[pivot_row].clone();
        for (other, motion) in motions.iter_mut().enumerate() {
            if other != pivot_row {
                let factor = motion[column];
                motion.iter_mut().zip(&pivot_motion).for_each(|(x, p)| *x -= factor * p);
            }
        }
    }
    let twist = |six: &[f64]| Twist {
        velocity: scale(scales.length, [six[0], six[1], six[2]]),
        rotation: [six[3], six[4], six[5]],
    };
    motions.iter().map(|motion| motion.chunks_exact(6).map(twist).collect()).collect()
}

/// Where a point of a body is (m), which moves with the body whichever joint it belongs to.
///
/// # Panics
/// If body or point belong to another mechanism.
pub fn point_position(
    mechanism: &Mechanism,
    state: &[Coordinates<f64>],
    body: BodyId,
    point: PointId,
) -> Vector<f64> {
    let q = &state[body.index()];
    let origin = mechanism.bodies()[body.index()].origin;
    let local = sub(mechanism.points()[point.index()].position, origin);
    add([q[0], q[1], q[2]], rotate([q[3], q[4], q[5], q[6]], local))
}

/// The rotation matrix of a body, row by row: it turns directions from the design position to
/// the current one.
///
/// # Panics
/// If the body belongs to another mechanism.
pub fn rotation(state: &[Coordinates<f64>], body: BodyId) -> [[f64; 3]; 3] {
    let q = &state[body.index()];
    let p = [q[3], q[4], q[5], q[6]];
    let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| rotate(p, axis));
    std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row]))
}

/// How exactly a motion is known and wanted.
#[derive(Clone, Copy)]
pub(super) struct Precision {
    /// Differences below this part of the motion are none.
    pub tolerance: f64,
    /// Whether axes without named points are given in numbers.
    pub numbers: bool,
}

impl Precision {
    /// For motions that are exact up to rounding.
    pub const EXACT: Self = Self { tolerance: 1e-6, numbers: true };
    /// For motions near a dead centre, of which the reached state is only close to.
    pub const NEAR: Self = Self { tolerance: 1e-3, numbers: false };
}

/// Describes the motion of all bodies, such as `tierod turns about the line
/// tierod_inner–tierod_outer`, with the bodies that move.
pub(super) fn describe(
    mechanism: &Mechanism,
    state: &[Coordinates<f64>],
    twists: &[Twist],
    length: f64,
    precision: Precision,
) -> (String, Vec<BodyId>) {
    let largest = twists.iter().map(|twist| twist.size(length)).fold(0.0, f64::max);
    let negligible = precision.tolerance * largest;
    let mut groups: Vec<Vec<BodyId>> = vec![];
    for (body, twist) in twists.iter().enumerate() {
        if twist.size(length) <= negligible {
            continue;
        }
        let same = groups
            .iter_mut()
            .find(|group| twists[group[0].index()].minus(twist).size(length) <= negligible);
        match same {
            Some(group) => group.push(BodyId(body)),
            None => groups.push(vec![BodyId(body)]),
        }
    }
    let words: Vec<String> = groups
        .iter()
        .map(|group| {
            let names: Vec<&str> =
                group.iter().map(|id| &*mechanism.bodies()[id.index()].name).collect();
            let twist = &twists[group[0].index()];
            let how = how(mechanism, state, group, twist, length, precision);
            if names.len() == 1 {
                format!("{} {how}", names[0])
            } else {
                format!("{} together: {how}", names.join(", "))
            }
        })
        .collect();
    (words.join("; "), groups.concat())
}

/// `moves along …` or `turns about …`.
fn how(
    mechanism: &Mechanism,
    state: &[Coordinates<f64>],
    bodies: &[BodyId],
    twist: &Twist,
    length: f64,
    precision: Precision,
) -> String {
    let near_zero = precision.tolerance * length;
    if norm(twist.rotation) <= precision.tolerance * twist.size(length) {
        return format!("moves along {}", direction(twist.velocity));
    }
    let axis = unit(twist.rotation);
    let speed = norm(twist.rotation);
    let foot = scale(1.0 / (speed * speed), cross(twist.rotation, twist.velocity));
    let pitch = dot(axis, twist.velocity) / speed;
    let verb = if pitch.abs() <= near_zero {
        "turns about".to_owned()
    } else {
        let per_turn = pitch * std::f64::consts::TAU * 1e3;
        format!("screws ({per_turn:.3} mm per turn) about")
    };
    let mut near: Vec<(f64, f64, PointId)> = points_on(mechanism, bodies)
        .into_iter()
        .map(|(body, point)| {
            let arm = sub(point_position(mechanism, state, body, point), foot);
            let along = dot(axis, arm);
            (norm(sub(arm, scale(along, axis))), along, point)
        })
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    let name = |point: PointId| &mechanism.points()[point.index()].name;
    let on_axis = near.iter().take_while(|(distance, ..)| *distance <= near_zero);
    let first = on_axis.clone().min_by(|a, b| a.1.total_cmp(&b.1));
    let last = on_axis.max_by(|a, b| a.1.total_cmp(&b.1));
    match (first, last) {
        (Some(first), Some(last)) if last.1 - first.1 > near_zero => {
            let (a, b) = (first.2.min(last.2), first.2.max(last.2));
            format!("{verb} the line {}–{}", name(a), name(b))
        }
        (Some(only), _) if !precision.numbers => format!("{verb} {}", name(only.2)),
        (Some(only), _) => {
            format!("{verb} an axis through {} along {}", name(only.2), direction(axis))
        }
        _ if !precision.numbers => "turns and moves".to_owned(),
        _ => {
            let nearest = near.first().map_or_else(String::new, |(distance, _, point)| {
                format!(", {:.3} mm from {}", distance * 1e3, name(*point))
            });
            let [x, y, z] = foot.map(|c| c * 1e3 + 0.0);
            format!(
                "{verb} an axis along {} through ({x:.3}, {y:.3}, {z:.3}) mm{nearest}",
                direction(axis)
            )
        }
    }
}

/// The named points that joints and drivers put on these bodies.
fn points_on(mechanism: &Mechanism, bodies: &[BodyId]) -> Vec<(BodyId, PointId)> {
    let mut found = vec![];
    let mut note = |i: BodyId, j: BodyId, points: Option<[PointId; 2]>, along: Vec<Direction>| {
        for (side, body) in [i, j].into_iter().enumerate() {
            if bodies.contains(&body) {
                found.extend(points.map(|points| (body, points[side])));
                for direction in &along {
                    if let Direction::Between(from, to) = *direction {
                        found.extend([(body, from), (body, to)]);
                    }
                }
            }
        }
    };
    for joint in mechanism.joints() {
        note(joint.i, joint.j, Some(joint.kind.points()), joint.kind.directions().collect());
    }
    for driver in mechanism.drivers() {
        let along = driver.kind.direction().into_iter().collect();
        note(driver.i, driver.j, driver.kind.points(), along);
    }
    found
}

/// A direction in words: the name of a coordinate axis, or components.
fn direction(vector: Vector<f64>) -> String {
    let unit = unit(vector);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if unit[axis].abs() > 1.0 - 1e-9 {
            return name.to_owned();
        }
    }
    // A line has no sense: the first component that counts is printed positive.
    let sign = unit.iter().find(|c| c.abs() > 1e-6).map_or(1.0, |c| c.signum());
    let [x, y, z] = unit.map(|c| {
        let c = sign * c;
        if c.abs() < 5e-5 { 0.0 } else { c }
    });
    format!("({x:.4}, {y:.4}, {z:.4})")
}
