//! Links as straight lines, and how near they come to each other.

use super::{Clearance, Place};
use crate::mechanism::{BodyId, Direction, ForceKind, JointKind, Mechanism, PointId};
use crate::model::AxleSuspension;
use crate::relation::Coordinates;
use crate::solve::point_position;
use crate::vector::{Vector, add, cross, dot, norm, scale, sub};

/// The part of a link at its ends where it may touch another one that is joined to its neighbour.
const END: f64 = 0.02;

/// Points nearer than this (m) are one.
const TOUCH: f64 = 1e-6;

/// A straight part of a body between two of its joints, a rigid link or a spring.
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

/// All rods of an axle.
pub(super) struct Rods {
    mechanism: Mechanism,
    rods: Vec<Rod>,
    pairs: Vec<Pair>,
}

impl Rods {
    pub(super) fn of(suspension: &AxleSuspension) -> Self {
        let mechanism = suspension.mechanism.clone();
        let mut rods = body_rods(&mechanism);
        for joint in mechanism.joints() {
            if let JointKind::Link { on_i, on_j } = joint.kind {
                rods.push(Rod {
                    name: joint.name.clone(),
                    ends: [(on_i, joint.i), (on_j, joint.j)],
                });
            }
        }
        rods.extend(struts(suspension));
        Self { pairs: pairs(&mechanism, &rods), mechanism, rods }
    }

    /// The next state is no neighbour of the last one.
    pub(super) fn restart(&mut self) {
        self.pairs.iter_mut().for_each(|pair| pair.side = None);
    }

    /// Looks at the distances of a state.
    pub(super) fn look(&mut self, state: &[Coordinates<f64>], at: Place) {
        let Self { mechanism, rods, pairs } = self;
        let line = |rod: usize| {
            rods[rod].ends.map(|(point, body)| point_position(mechanism, state, body, point))
        };
        for pair in pairs {
            pair.look(pair.rods.map(line), at);
        }
    }

    /// The nearest places of all pairs, one for each two links, nearest first.
    pub(super) fn clearances(&self) -> Vec<Clearance> {
        let mut found: Vec<Clearance> = vec![];
        for pair in &self.pairs {
            let Some((distance, at)) = pair.nearest else { continue };
            let links = pair.rods.map(|rod| self.rods[rod].name.clone());
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
}

/// The straight parts of bodies from one neighbour to another.
fn body_rods(mechanism: &Mechanism) -> Vec<Rod> {
    let mut rods = vec![];
    let held = mechanism.held_points();
    for body in mechanism.body_ids().filter(|body| *body != BodyId::GROUND) {
        let own: Vec<(PointId, Vec<BodyId>)> = held
            .iter()
            .filter(|(of, _)| *of == body)
            .map(|&(_, point)| (point, neighbours(mechanism, body, point)))
            .collect();
        let name = &mechanism.bodies()[body.index()].name;
        let mut add = |from: PointId, to: PointId| {
            rods.push(Rod { name: name.clone(), ends: [(from, body), (to, body)] });
        };
        if own.len() <= 3 {
            for (k, (from, at_from)) in own.iter().enumerate() {
                for (to, _) in own[k + 1..].iter().filter(|(_, at_to)| at_from != at_to) {
                    add(*from, *to);
                }
            }
            continue;
        }
        // What has many joints is no rod, such as an upright; but an arm that also carries a pushrod goes from its
        // pivots, two joints with one neighbour, to its far end.
        let is_pivot = |at: &[BodyId]| own.iter().filter(|(_, other)| other == at).count() > 1;
        for (pivot, at_pivot) in own.iter().filter(|(_, at)| is_pivot(at)) {
            let far = own.iter().filter(|(_, at)| at != at_pivot).max_by(|a, b| {
                let distance = |end: PointId| apart(mechanism, *pivot, end);
                distance(a.0).total_cmp(&distance(b.0))
            });
            if let Some((far, _)) = far {
                add(*pivot, *far);
            }
        }
    }
    rods
}

/// Springs and dampers: those that act, and those whose seats are known.
fn struts(suspension: &AxleSuspension) -> Vec<Rod> {
    let mut rods: Vec<Rod> = vec![];
    for force in suspension.mechanism.forces() {
        if let ForceKind::Line { on_i, on_j, .. } = force.kind {
            let ends = [(on_i, force.i), (on_j, force.j)];
            rods.push(Rod { name: force.name.clone(), ends });
        }
    }
    for side in &suspension.sides {
        for (strut, name) in [(side.spring, "spring"), (side.damper, "damper")] {
            let Some(strut) = strut else { continue };
            let is_known = |rod: &Rod| strut.ends.iter().all(|end| rod.ends.contains(end));
            if !rods.iter().any(is_known) {
                rods.push(Rod { name: format!("{}_{name}", side.side.name()), ends: strut.ends });
            }
        }
    }
    rods
}

fn apart(mechanism: &Mechanism, a: PointId, b: PointId) -> f64 {
    let place = |point: PointId| mechanism.points()[point.index()].position;
    norm(sub(place(a), place(b)))
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
    let mut pairs = vec![];
    for (a, first) in rods.iter().enumerate() {
        for (b, second) in rods.iter().enumerate().skip(a + 1) {
            let meet = first.ends.iter().any(|one| {
                second.ends.iter().any(|other| {
                    apart(mechanism, one.0, other.0) < TOUCH
                        || (one.1 == other.1 && one.1 != BodyId::GROUND)
                })
            });
            if !meet && !joined_on_the_way(mechanism, first, second) {
                pairs.push(Pair { rods: [a, b], nearest: None, side: None, crosses: None });
            }
        }
    }
    pairs
}

/// Whether a joint between the bodies of two rods lies on both of them, such as the pivot of a bell crank.
fn joined_on_the_way(mechanism: &Mechanism, first: &Rod, second: &Rod) -> bool {
    let places = mechanism.positions();
    let on = |rod: &Rod, point: PointId| {
        let place = places[point.index()];
        between(rod.ends.map(|(end, _)| places[end.index()]), [place; 2]).0 < TOUCH
    };
    let bodies = |rod: &Rod| rod.ends.map(|(_, body)| body);
    let (one, other) = (bodies(first), bodies(second));
    mechanism.joints().iter().any(|joint| {
        let joins = one.contains(&joint.i) && other.contains(&joint.j)
            || one.contains(&joint.j) && other.contains(&joint.i);
        joins && joint.kind.points().iter().any(|point| on(first, *point) && on(second, *point))
    })
}

impl Pair {
    fn look(&mut self, [first, second]: [[Vector<f64>; 2]; 2], at: Place) {
        let (distance, parts) = between(first, second);
        // Of states that differ by rounding the first counts.
        if self.nearest.is_none_or(|(nearest, _)| distance < nearest - TOUCH / 1e3) {
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
/// (Ericson, Real-Time Collision Detection, 5.1.9). The second one may be a point.
fn between([p, p_end]: [Vector<f64>; 2], [q, q_end]: [Vector<f64>; 2]) -> (f64, [f64; 2]) {
    let (u, v, w) = (sub(p_end, p), sub(q_end, q), sub(p, q));
    let (a, b, e, c, f) = (dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w));
    let determinant = a * e - b * b;
    let mut s = 0.0;
    if determinant > 1e-12 * a * e {
        s = ((b * f - c * e) / determinant).clamp(0.0, 1.0);
    }
    let mut t = if e > 0.0 { (b * s + f) / e } else { -1.0 };
    if !(0.0..=1.0).contains(&t) {
        t = t.clamp(0.0, 1.0);
        s = ((b * t - c) / a).clamp(0.0, 1.0);
    }
    let apart = sub(add(p, scale(s, u)), add(q, scale(t, v)));
    (norm(apart), [s, t])
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
        // A point.
        assert_eq!(between(along_x, [[1.5, 2.0, 0.0]; 2]), (2.0, [0.75, 0.0]));
    }
}
