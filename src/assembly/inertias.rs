//! The inertias of bodies, ready to be evaluated.

use std::ops::Range;

use super::block::{Block, Places};
use super::elements::{Blend, Motion};
use crate::energy::{self, EnergyShape, KineticEnergy};
use crate::mechanism::Expansion;
use crate::relation::BODY_COORDINATES;

/// The inertias of all bodies that have mass.
#[derive(Clone)]
pub struct Inertias {
    list: Vec<Inertia>,
    force_q: Vec<f64>,
    force_v: Vec<f64>,
    mass: Vec<f64>,
}

#[derive(Clone)]
struct Inertia {
    kernels: &'static dyn KineticEnergy<f64>,
    shape: &'static EnergyShape,
    body: usize,
    parameters: Range<usize>,
}

impl Inertias {
    /// No inertia: statics.
    pub fn none() -> Self {
        Self { list: vec![], force_q: vec![], force_v: vec![], mass: vec![] }
    }

    /// The inertias of a mechanism.
    pub fn new(expansion: &Expansion) -> Self {
        let list: Vec<Inertia> = expansion
            .inertias()
            .iter()
            .map(|inertia| Inertia {
                kernels: inertia.kind.kernels::<f64>(),
                shape: inertia.kind.shape(),
                body: inertia.body.index(),
                parameters: inertia.parameters.clone(),
            })
            .collect();
        let scratch = |length: fn(&EnergyShape) -> usize| {
            vec![0.0; list.iter().map(|inertia| length(inertia.shape)).max().unwrap_or(0)]
        };
        Self {
            force_q: scratch(|shape| shape.force_q.len()),
            force_v: scratch(|shape| shape.force_v.len()),
            mass: scratch(|shape| shape.mass.len()),
            list,
        }
    }

    /// Kinetic energy of all bodies (J).
    pub fn energy(&self, motion: Motion<'_>, h: &[f64]) -> f64 {
        let energy = |inertia: &Inertia| inertia.kernels.energy(inertia.motion(motion, h));
        self.list.iter().map(energy).sum()
    }

    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// The unknowns of the body of an inertia.
    pub(super) fn places(&self, inertia: usize) -> Places {
        let first = BODY_COORDINATES * (self.list[inertia].body - 1);
        Places::new((first..first + BODY_COORDINATES).map(Some))
    }

    /// Evaluates one inertia: M q̈ and the gyroscopic terms to the force of `block`, and their
    /// derivatives where a blend is given.
    pub(super) fn evaluate(
        &mut self,
        inertia: usize,
        motion: Motion<'_>,
        h: &[f64],
        blend: Option<Blend>,
        block: &mut Block,
    ) {
        block.clear();
        let inertia = &self.list[inertia];
        let shape = inertia.shape;
        let mut force = [0.0; BODY_COORDINATES];
        let place = inertia.motion(motion, h);
        let Some(blend) = blend else {
            inertia.kernels.force(place, &mut force);
            (0..).zip(force).for_each(|(local, value)| block.add_force(local, value, value));
            return;
        };
        let force_q = &mut self.force_q[..shape.force_q.len()];
        let force_v = &mut self.force_v[..shape.force_v.len()];
        let mass = &mut self.mass[..shape.mass.len()];
        inertia.kernels.tangent(place, &mut force, force_q, force_v, mass);
        (0..).zip(force).for_each(|(local, value)| block.add_force(local, value, value));
        for (&(row, column), value) in shape.force_q.iter().zip(force_q) {
            block.add(row, column, blend.stiffness * *value);
        }
        for (&(row, column), value) in shape.force_v.iter().zip(force_v) {
            block.add(row, column, blend.damping * *value);
        }
        for (&(row, column), value) in shape.mass.iter().zip(mass) {
            block.add(row, column, blend.mass * *value);
            if row != column {
                block.add(column, row, blend.mass * *value);
            }
        }
    }
}

impl Inertia {
    fn motion<'a>(&self, motion: Motion<'a>, h: &'a [f64]) -> energy::Motion<'a, f64> {
        energy::Motion {
            q: &motion.state[self.body],
            v: &motion.velocity[self.body],
            a: &motion.acceleration[self.body],
            h: &h[self.parameters.clone()],
        }
    }
}
