//! The relations of a mechanism, ready to be evaluated.

use std::ops::Range;

use super::unknown_count;
use crate::mechanism::{Expansion, Instance};
use crate::relation::{BODY_COORDINATES, Coordinates, Place, Relation, Shape};

/// One relation with its kernels.
#[derive(Clone)]
pub(super) struct Term {
    pub(super) kernels: &'static dyn Relation<f64>,
    pub(super) shape: &'static Shape,
    pub(super) i: usize,
    pub(super) j: usize,
    pub(super) parameters: Range<usize>,
    pub(super) equations: Range<usize>,
}

impl Term {
    pub(super) fn new(instance: &Instance) -> Self {
        Self {
            kernels: instance.kind.kernels::<f64>(),
            shape: instance.kind.shape(),
            i: instance.i.index(),
            j: instance.j.index(),
            parameters: instance.parameters.clone(),
            equations: instance.equations.clone(),
        }
    }

    pub(super) fn place<'a>(&self, state: &'a [Coordinates<f64>], h: &'a [f64]) -> Place<'a, f64> {
        Place { q_i: &state[self.i], q_j: &state[self.j], h: &h[self.parameters.clone()] }
    }

    /// The unknown that a local coordinate is; none for the ground.
    pub(super) fn unknown(&self, local: u8) -> Option<usize> {
        let local = usize::from(local);
        let body = if local < BODY_COORDINATES { self.i } else { self.j };
        let body = body.checked_sub(1)?;
        Some(BODY_COORDINATES * body + local % BODY_COORDINATES)
    }
}

/// Which row each equation has in a matrix.
#[derive(Clone, Debug)]
pub struct Numbering {
    rows: Vec<Option<usize>>,
    kept: Vec<usize>,
    unknowns: usize,
}

impl Numbering {
    /// Numbers all equations but those that are left out.
    pub fn new(expansion: &Expansion, left_out: &[usize]) -> Self {
        let kept: Vec<usize> = (0..expansion.equation_count())
            .filter(|equation| !left_out.contains(equation))
            .collect();
        let mut rows = vec![None; expansion.equation_count()];
        for (row, &equation) in kept.iter().enumerate() {
            rows[equation] = Some(row);
        }
        Self { rows, kept, unknowns: unknown_count(expansion.body_count()) }
    }

    /// The equation of each row.
    pub fn kept(&self) -> &[usize] {
        &self.kept
    }

    /// The row of an equation; none where it is left out.
    pub fn row(&self, equation: usize) -> Option<usize> {
        self.rows[equation]
    }

    /// Number of unknown coordinates.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }
}

/// All relations of a mechanism.
#[derive(Clone)]
pub struct Terms {
    pub(super) list: Vec<Term>,
    pub(super) phi_q: Vec<f64>,
    pub(super) work: Vec<f64>,
    pub(super) curvature: Vec<f64>,
    phi: Vec<f64>,
    rate: Vec<f64>,
    rate_h: Vec<f64>,
    phi_h: Vec<f64>,
    force_h: Vec<f64>,
    zero: Vec<f64>,
}

impl Terms {
    /// Looks the kernels up and sets up their scratch space.
    pub fn new(expansion: &Expansion) -> Self {
        let list: Vec<Term> = expansion.instances().iter().map(Term::new).collect();
        let scratch = |length: fn(&Shape) -> usize| {
            vec![0.0; list.iter().map(|term| length(term.shape)).max().unwrap_or(0)]
        };
        Self {
            phi_q: scratch(|shape| shape.jacobian.len()),
            work: scratch(|shape| shape.work.len()),
            curvature: scratch(|shape| shape.curvature.len()),
            phi: scratch(|shape| shape.equations),
            rate: scratch(|shape| shape.rate.len()),
            rate_h: scratch(|shape| shape.rate_design.len()),
            phi_h: scratch(|shape| shape.design.len()),
            force_h: scratch(|shape| shape.force_design.len()),
            zero: scratch(|shape| shape.equations),
            list,
        }
    }

    /// Φ, all equations.
    pub fn residual(&self, state: &[Coordinates<f64>], h: &[f64], phi: &mut [f64]) {
        for term in &self.list {
            let phi = &mut phi[term.equations.clone()];
            term.kernels.residual(term.place(state, h), phi);
        }
    }

    /// The row of Φ_q of one equation, in the places of the unknowns.
    ///
    /// # Panics
    /// If there is no such equation.
    pub fn gradient(
        &mut self,
        equation: usize,
        state: &[Coordinates<f64>],
        h: &[f64],
        gradient: &mut [f64],
    ) {
        let owner = self.list.iter().find(|term| term.equations.contains(&equation));
        let term = owner.expect("every equation belongs to a relation");
        let shape = term.shape;
        let phi_q = &mut self.phi_q[..shape.jacobian.len()];
        let work = &mut self.work[..shape.work.len()];
        let phi = &mut self.phi[..shape.equations];
        term.kernels.jacobian(term.place(state, h), phi, phi_q, work);
        gradient.fill(0.0);
        for (&(row, local), value) in shape.jacobian.iter().zip(phi_q) {
            if term.equations.start + usize::from(row) == equation
                && let Some(unknown) = term.unknown(local)
            {
                gradient[unknown] = *value;
            }
        }
    }

    /// Φ_q v, all equations: how fast Φ changes with the velocities v.
    pub fn velocity_product(
        &mut self,
        state: &[Coordinates<f64>],
        velocity: &[Coordinates<f64>],
        h: &[f64],
        product: &mut [f64],
    ) {
        for term in &self.list {
            let shape = term.shape;
            let phi_q = &mut self.phi_q[..shape.jacobian.len()];
            let work = &mut self.work[..shape.work.len()];
            let phi = &mut self.phi[..shape.equations];
            term.kernels.jacobian(term.place(state, h), phi, phi_q, work);
            multiply(term, shape.jacobian, phi_q, velocity, &mut product[term.equations.clone()]);
        }
    }

    /// (Φ_q v)_q v, all equations: the part of Φ̈ = Φ_q v̇ + (Φ_q v)_q v that does not depend on v̇.
    pub fn convective_acceleration(
        &mut self,
        state: &[Coordinates<f64>],
        velocity: &[Coordinates<f64>],
        h: &[f64],
        product: &mut [f64],
    ) {
        for term in &self.list {
            let shape = term.shape;
            let rate = &mut self.rate[..shape.rate.len()];
            let rate_h = &mut self.rate_h[..shape.rate_design.len()];
            let (v_i, v_j) = (&velocity[term.i], &velocity[term.j]);
            term.kernels.rate(term.place(state, h), v_i, v_j, rate, rate_h);
            multiply(term, shape.rate, rate, velocity, &mut product[term.equations.clone()]);
        }
    }

    /// Φ_h·dh, all equations: how Φ changes when the parameters change by dh.
    pub fn design_product(
        &mut self,
        state: &[Coordinates<f64>],
        h: &[f64],
        dh: &[f64],
        product: &mut [f64],
    ) {
        self.design_products(state, h, dh, None, product, &mut []);
    }

    /// Φ_h·dh, all equations, and (Wᵀλ)_h·dh, all unknowns: how Φ and the forces of the
    /// constraints change when the parameters change by dh. Without multipliers the
    /// forces are not computed.
    pub fn design_products(
        &mut self,
        state: &[Coordinates<f64>],
        h: &[f64],
        dh: &[f64],
        lambda: Option<&[f64]>,
        product: &mut [f64],
        force: &mut [f64],
    ) {
        product.fill(0.0);
        force.fill(0.0);
        for term in &self.list {
            let dh = &dh[term.parameters.clone()];
            if dh.iter().all(|&change| change == 0.0) {
                continue;
            }
            let shape = term.shape;
            let phi_h = &mut self.phi_h[..shape.design.len()];
            let force_h = &mut self.force_h[..shape.force_design.len()];
            let zero = &self.zero[..shape.equations];
            let multipliers = lambda.map_or(zero, |lambda| &lambda[term.equations.clone()]);
            term.kernels.design(term.place(state, h), multipliers, phi_h, force_h);
            let product = &mut product[term.equations.clone()];
            for (&(equation, parameter), value) in shape.design.iter().zip(phi_h) {
                product[usize::from(equation)] += *value * dh[usize::from(parameter)];
            }
            if lambda.is_none() {
                continue;
            }
            for (&(local, parameter), value) in shape.force_design.iter().zip(force_h) {
                if let Some(unknown) = term.unknown(local) {
                    force[unknown] += *value * dh[usize::from(parameter)];
                }
            }
        }
    }
}

/// The product of a matrix of (equation, coordinate) entries with the velocities of two bodies.
pub(super) fn multiply(
    term: &Term,
    pattern: &[(u8, u8)],
    matrix: &[f64],
    velocity: &[Coordinates<f64>],
    product: &mut [f64],
) {
    product.fill(0.0);
    for (&(equation, local), value) in pattern.iter().zip(matrix) {
        let local = usize::from(local);
        let body = if local < BODY_COORDINATES { term.i } else { term.j };
        product[usize::from(equation)] += value * velocity[body][local % BODY_COORDINATES];
    }
}
