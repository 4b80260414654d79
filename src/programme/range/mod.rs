//! The working range of an axle: where it ends, where it comes near to a dead centre, and how near its
//! links come to each other.

use super::stage::StageError;
use crate::mechanism::{BodyId, Direction, ForceKind, JointKind, Mechanism, PointId};
use crate::model::{Model, Setup};
use crate::rig::{Axle, LoadPoint};
use crate::solve::{Stop, point_position};
use crate::vector::{Vector, add, cross, dot, norm, scale, sub};

/// Near a dead centre a point moves more than this many times as fast as the wheel that moves it.
pub const NEARLY_DEAD: f64 = 10.0;

/// States on each side of the middle.
const STEPS: u32 = 16;

/// The part of a link at its ends where it may touch another one that is joined to its neighbour.
const END: f64 = 0.02;

/// A state of the range (m).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// Travel of both wheels.
    pub travel: f64,
    /// Displacement of the rack.
    pub rack: f64,
}

/// The fastest joint of a suspension.
#[derive(Clone, Debug, PartialEq)]
pub struct Fastest {
    /// The body that has it.
    pub body: String,
    /// The point.
    pub point: String,
    /// Its speed by that of the left wheel's height.
    pub ratio: f64,
    /// Where.
    pub at: Place,
}

/// How near the middle lines of two links come.
#[derive(Clone, Debug, PartialEq)]
pub struct Clearance {
    /// The links: bodies, springs, dampers.
    pub links: [String; 2],
    /// The least distance (m); zero where they cross.
    pub distance: f64,
    /// Whether one passes through the other.
    pub crosses: bool,
    /// Where.
    pub at: Place,
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorkingRange {
    /// States reached.
    pub states: usize,
    /// Where it ends, with the state that was sought.
    pub stops: Vec<(Place, Stop)>,
    /// The fastest joint; near a dead centre it is faster than [`NEARLY_DEAD`].
    pub fastest: Option<Fastest>,
    /// The links that come nearest to each other, nearest first.
    pub clearances: Vec<Clearance>,
}

/// A straight part of a body between two of its joints, or a spring.
struct Rod {
    name: String,
    ends: [(PointId, BodyId); 2],
}

/// Two rods that are not joined, and what was seen of them.
struct Pair {
    rods: [usize; 2],
    nearest: Option<(f64, Place)>,
    /// On which side of the other one was at the state before.
    side: Option<f64>,
    crosses: Option<Place>,
}

impl WorkingRange {
    /// Moves both wheels of a model to `travel` (m) up and down, at each of the racks (m).
    ///
    /// # Errors
    /// [`StageError`] where there is no axle to put on the rig.
    pub fn find(
        model: &Model,
        setup: &Setup,
        travel: f64,
        racks: &[f64],
    ) -> Result<Self, StageError> {
        let mut axle = Axle::with_loads(model, setup, LoadPoint::default())?;
        let mechanism = axle.suspension().mechanism.clone();
        let (joints, rods) = (joint_points(&mechanism), rods(&mechanism));
        let mut pairs = pairs(&mechanism, &rods);
        let mut range = Self::default();
        for &rack in racks {
            for direction in [1.0, -1.0] {
                axle.reset();
                pairs.iter_mut().for_each(|pair| pair.side = None);
                for step in 0..=STEPS {
                    let travel = direction * travel * f64::from(step) / f64::from(STEPS);
                    let at = Place { travel, rack };
                    if let Err(stop) = axle.move_to([travel; 2], rack) {
                        range.stops.push((at, stop));
                        break;
                    }
                    range.states += usize::from(step > 0 || direction > 0.0);
                    range.look_at_speeds(&mut axle, &mechanism, &joints, at);
                    for pair in &mut pairs {
                        pair.look(&axle, &rods, at);
                    }
                }
            }
        }
        range.clearances = clearances(&pairs, &rods);
        Ok(range)
    }

    fn look_at_speeds(
        &mut self,
        axle: &mut Axle,
        mechanism: &Mechanism,
        joints: &[(BodyId, PointId)],
        at: Place,
    ) {
        let wheel = axle.suspension().sides[0].travel;
        let Some(tangent) = axle.tangent(wheel) else { return };
        for &(body, point) in joints {
            let place = point_position(mechanism, tangent.state(), body, point);
            let ratio = norm(tangent.twist(body).at(place));
            if self.fastest.as_ref().is_none_or(|fastest| ratio > fastest.ratio) {
                let body = mechanism.bodies()[body.index()].name.clone();
                let point = mechanism.points()[point.index()].name.clone();
                self.fastest = Some(Fastest { body, point, ratio, at });
            }
        }
    }
}

/// Every body with the points of its joints.
fn joint_points(mechanism: &Mechanism) -> Vec<(BodyId, PointId)> {
    let mut points = vec![];
    for joint in mechanism.joints() {
        let [on_i, on_j] = joint.kind.points();
        let mut ends = vec![(joint.i, on_i), (joint.j, on_j)];
        // An arm on an axis through two points is held at both.
        for direction in joint.kind.directions() {
            if let Direction::Between(from, to) = direction {
                ends.extend([(joint.j, from), (joint.j, to)]);
            }
        }
        points.extend(ends);
    }
    for force in mechanism.forces() {
        if let (ForceKind::Bushing(_), Some([on_i, on_j])) = (&force.kind, force.kind.points()) {
            points.extend([(force.i, on_i), (force.j, on_j)]);
        }
    }
    points.retain(|(body, _)| *body != BodyId::GROUND);
    points.sort_unstable_by_key(|(body, point)| (body.index(), point.index()));
    points.dedup();
    points
}

/// The straight parts of bodies from one neighbour to another, and springs.
fn rods(mechanism: &Mechanism) -> Vec<Rod> {
    let mut rods = vec![];
    let points = joint_points(mechanism);
    for body in mechanism.body_ids().filter(|body| *body != BodyId::GROUND) {
        let own: Vec<PointId> =
            points.iter().filter(|(of, _)| *of == body).map(|(_, point)| *point).collect();
        // What has many joints is no rod: an upright, a subframe.
        if !(2..=3).contains(&own.len()) {
            continue;
        }
        for (k, &from) in own.iter().enumerate() {
            for &to in &own[k + 1..] {
                let ways = [from, to].map(|point| neighbours(mechanism, body, point));
                if ways[0] != ways[1] {
                    let name = mechanism.bodies()[body.index()].name.clone();
                    rods.push(Rod { name, ends: [(from, body), (to, body)] });
                }
            }
        }
    }
    for force in mechanism.forces() {
        if let (ForceKind::Line { on_i, on_j, .. }, true) = (&force.kind, force.kind.is_line()) {
            let ends = [(*on_i, force.i), (*on_j, force.j)];
            rods.push(Rod { name: force.name.clone(), ends });
        }
    }
    rods
}

/// The bodies that a body is joined to at a point, or on an axis through it.
fn neighbours(mechanism: &Mechanism, body: BodyId, point: PointId) -> Vec<BodyId> {
    let mut found = vec![];
    let mut note = |i: BodyId, j: BodyId| found.push(if i == body { j } else { i });
    for joint in mechanism.joints().iter().filter(|joint| [joint.i, joint.j].contains(&body)) {
        let on_axis = match joint.kind {
            JointKind::Revolute { axis: Direction::Between(from, to), .. } => {
                [from, to].contains(&point)
            }
            _ => false,
        };
        if joint.kind.points().contains(&point) || on_axis {
            note(joint.i, joint.j);
        }
    }
    for force in mechanism.forces().iter().filter(|force| [force.i, force.j].contains(&body)) {
        if matches!(force.kind, ForceKind::Bushing(_))
            && force.kind.points().is_some_and(|points| points.contains(&point))
        {
            note(force.i, force.j);
        }
    }
    found.sort_unstable_by_key(|body| body.index());
    found.dedup();
    found
}

/// Rods of different bodies that do not meet.
fn pairs(mechanism: &Mechanism, rods: &[Rod]) -> Vec<Pair> {
    let places = mechanism.positions();
    let mut pairs = vec![];
    for (a, first) in rods.iter().enumerate() {
        for (b, second) in rods.iter().enumerate().skip(a + 1) {
            let meet = first.ends.iter().any(|one| {
                second.ends.iter().any(|other| {
                    let apart = sub(places[one.0.index()], places[other.0.index()]);
                    norm(apart) < 1e-6 || (one.1 == other.1 && one.1 != BodyId::GROUND)
                })
            });
            if !meet {
                pairs.push(Pair { rods: [a, b], nearest: None, side: None, crosses: None });
            }
        }
    }
    pairs
}

impl Pair {
    fn look(&mut self, axle: &Axle, rods: &[Rod], at: Place) {
        let mechanism = axle.stand().mechanism();
        let state = axle.stand().state();
        let line = |rod: usize| {
            rods[rod].ends.map(|(point, body)| point_position(mechanism, state, body, point))
        };
        let [first, second] = self.rods.map(line);
        let (distance, parts) = between(first, second);
        if self.nearest.is_none_or(|(nearest, _)| distance < nearest) {
            self.nearest = Some((distance, at));
        }
        let inside = parts.iter().all(|part| (END..=1.0 - END).contains(part));
        let [u, v] = [first, second].map(|[from, to]| sub(to, from));
        let side = dot(cross(u, v), sub(second[0], first[0]));
        // Where the lines pass each other outside of the rods, nothing is crossed.
        if inside && self.side.is_some_and(|before| before * side < 0.0) {
            self.crosses.get_or_insert(at);
        }
        self.side = inside.then_some(side);
    }
}

/// The distance of two straight lines between their ends, and where along them (0 to 1) it is least
/// (Ericson, Real-Time Collision Detection, 5.1.9).
fn between([p, p_end]: [Vector<f64>; 2], [q, q_end]: [Vector<f64>; 2]) -> (f64, [f64; 2]) {
    let (u, v, w) = (sub(p_end, p), sub(q_end, q), sub(p, q));
    let (a, b, e, c, f) = (dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w));
    let determinant = a * e - b * b;
    let mut s = 0.0;
    if determinant > 1e-12 * a * e {
        s = ((b * f - c * e) / determinant).clamp(0.0, 1.0);
    }
    let mut t = (b * s + f) / e;
    if !(0.0..=1.0).contains(&t) {
        t = t.clamp(0.0, 1.0);
        s = ((b * t - c) / a).clamp(0.0, 1.0);
    }
    let apart = sub(add(p, scale(s, u)), add(q, scale(t, v)));
    (norm(apart), [s, t])
}

/// The nearest places of all pairs, one for each two links.
fn clearances(pairs: &[Pair], rods: &[Rod]) -> Vec<Clearance> {
    let mut found: Vec<Clearance> = vec![];
    for pair in pairs {
        let Some((distance, at)) = pair.nearest else { continue };
        let links = pair.rods.map(|rod| rods[rod].name.clone());
        let clearance = match pair.crosses {
            Some(at) => Clearance { links, distance: 0.0, crosses: true, at },
            None => Clearance { links, distance, crosses: false, at },
        };
        match found.iter_mut().find(|other| other.links == clearance.links) {
            Some(other) if clearance.distance < other.distance => *other = clearance,
            Some(_) => {}
            None => found.push(clearance),
        }
    }
    found.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_as_far_apart_as_their_nearest_points() {
        let along_x = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
        // Crossing above the middle.
        let (distance, parts) = between(along_x, [[1.0, -1.0, 0.5], [1.0, 1.0, 0.5]]);
        assert_eq!((distance, parts), (0.5, [0.5, 0.5]));
        // Beyond the end.
        let (distance, parts) = between(along_x, [[5.0, 4.0, 0.0], [5.0, 9.0, 0.0]]);
        assert_eq!((distance, parts), (5.0, [1.0, 0.0]));
        // Parallel.
        let (distance, _) = between(along_x, [[1.0, 0.0, 3.0], [4.0, 0.0, 3.0]]);
        assert_eq!(distance, 3.0);
    }
}
