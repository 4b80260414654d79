//! What joints and force elements put on a body.

use super::equilibrium::Equilibrium;
use super::motion::point_position;
use crate::assembly::Elements;
use crate::kernels::RelationKind;
use crate::mechanism::{BodyId, Expansion, ForceId, Instance, Mechanism, Owner};
use crate::relation::{BODY_COORDINATES, Coordinates, Place};
use crate::vector::{Vector, add, cross, scale, sub};

/// A force and a moment at a point, in ground axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Force (N).
    pub force: [f64; 3],
    /// Moment about the point (N·m).
    pub moment: [f64; 3],
    /// The point (m).
    pub at: [f64; 3],
}

/// What a joint puts on its body *j*; body *i* feels the opposite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// Force and moment on body *j* at the joint's point of that body.
    pub on_j: Wrench,
    /// Whether it is determined. Where an equation of the joint is redundant, or holds what a redundant
    /// one of another joint holds, too, one of them carries the part of both.
    pub unique: bool,
}

/// A state of a mechanism with all its multipliers.
#[derive(Clone, Copy)]
pub struct Loaded<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// The mechanism as relations.
    pub expansion: &'a Expansion,
    /// Coordinates of all bodies.
    pub state: &'a [Coordinates<f64>],
    /// Parameters of all relations.
    pub h: &'a [f64],
    /// Multipliers of all constraints.
    pub lambda: &'a [f64],
    /// Values and forces of all force elements.
    pub elements: &'a Elements,
}

impl Equilibrium {
    /// The state with its multipliers, for reactions.
    pub fn loaded(&self) -> Loaded<'_> {
        Loaded {
            mechanism: &self.mechanism,
            expansion: &self.expansion,
            state: self.state(),
            h: self.parameters(),
            lambda: self.multipliers(),
            elements: self.elements(),
        }
    }

    /// The reactions of all joints, in their order.
    pub fn reactions(&self) -> Vec<Reaction> {
        self.loaded().reactions(|equation| self.is_determined(equation))
    }
}

impl Loaded<'_> {
    /// The reactions of all joints, in their order. `determined` says whether the
    /// multiplier of an equation is.
    pub fn reactions(&self, determined: impl Fn(usize) -> bool) -> Vec<Reaction> {
        let joints = self.mechanism.joints().iter().enumerate();
        joints
            .map(|(index, joint)| {
                let at = self.point(joint.j, joint.kind.points()[1]);
                let mut reaction =
                    Reaction { on_j: Wrench { at, ..Wrench::default() }, unique: true };
                for instance in self.expansion.instances() {
                    if instance.owner != Owner::Joint(index) {
                        continue;
                    }
                    let lambda = &self.lambda[instance.equations.clone()];
                    reaction.on_j.add(&self.wrench(instance, lambda, at));
                    reaction.unique &= instance.equations.clone().all(&determined);
                }
                reaction
            })
            .collect()
    }

    /// What a force element puts on its body *j*, at its point of that body or, where it has no point,
    /// at the origin of the body's frame.
    ///
    /// # Panics
    /// If the force belongs to another mechanism.
    pub fn force(&self, force: ForceId) -> Wrench {
        let element = &self.mechanism.forces()[force.index()];
        let at = match element.kind.points() {
            Some([_, on_j]) => self.point(element.j, on_j),
            None => {
                let q = &self.state[element.j.index()];
                [q[0], q[1], q[2]]
            }
        };
        let mut sum = Wrench { at, ..Wrench::default() };
        for element in self.expansion.elements() {
            if element.instance.owner != Owner::Force(force) {
                continue;
            }
            let responses = &self.elements.responses()[element.instance.equations.clone()];
            let lambda: Vec<f64> = responses.iter().map(|response| response.force).collect();
            sum.add(&self.wrench(&element.instance, &lambda, at));
        }
        sum
    }

    /// Where a point of a body is (m).
    pub fn point(&self, body: BodyId, point: crate::mechanism::PointId) -> [f64; 3] {
        point_position(self.mechanism, self.state, body, point)
    }

    /// −Wᵀλ of one relation on its body *j*, or on its only body, about a point.
    fn wrench(&self, instance: &Instance, lambda: &[f64], at: Vector<f64>) -> Wrench {
        let shape = instance.kind.shape();
        let body = instance.j.index();
        let place = Place {
            q_i: &self.state[instance.i.index()],
            q_j: &self.state[body],
            h: &self.h[instance.parameters.clone()],
        };
        let mut phi = vec![0.0; shape.equations];
        let mut phi_q = vec![0.0; shape.jacobian.len()];
        let mut work = vec![0.0; shape.work.len()];
        let kind: RelationKind = instance.kind;
        kind.kernels::<f64>().jacobian(place, &mut phi, &mut phi_q, &mut work);
        let rows = if shape.has_work() { (shape.work, &work) } else { (shape.jacobian, &phi_q) };
        let first = if shape.bodies == 1 { 0 } else { BODY_COORDINATES };
        let mut generalized = [0.0; BODY_COORDINATES];
        for (&(equation, local), value) in rows.0.iter().zip(rows.1) {
            if let Some(local) = usize::from(local).checked_sub(first)
                && local < BODY_COORDINATES
            {
                generalized[local] -= value * lambda[usize::from(equation)];
            }
        }
        Wrench::of_generalized(&self.state[body], &generalized).about(at)
    }
}

impl Wrench {
    /// The force and moment about the origin of a body's frame that have the given generalized
    /// force: moment = ½ E Q_p with E = [−e, e0·1 + ẽ], because ω = 2 E ṗ.
    fn of_generalized(q: &Coordinates<f64>, force: &Coordinates<f64>) -> Self {
        let (e0, e) = (q[3], [q[4], q[5], q[6]]);
        let (f0, f) = (force[3], [force[4], force[5], force[6]]);
        let moment = add(sub(scale(e0, f), scale(f0, e)), cross(e, f));
        Self {
            force: [force[0], force[1], force[2]],
            moment: scale(0.5, moment),
            at: [q[0], q[1], q[2]],
        }
    }

    /// The same about another point.
    #[must_use]
    pub fn about(&self, at: [f64; 3]) -> Self {
        let moment = add(self.moment, cross(sub(self.at, at), self.force));
        Self { force: self.force, moment, at }
    }

    fn add(&mut self, other: &Self) {
        self.force = add(self.force, other.force);
        self.moment = add(self.moment, other.moment);
    }
}
