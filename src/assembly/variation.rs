//! The derivatives of the equations by everything that they depend on, and how these change along a motion.
//!
//! The equations are G = [Wᵀλ; Φ] with the force elements among Wᵀλ, or Φ alone. A tangent (v, μ, s) of
//! coordinates, multipliers and parameters satisfies G_q v + G_λ μ + G_h s = 0. Its own derivative by
//! whatever moves the state needs the derivatives of that, which are, all second derivatives
//! being symmetric, G_q, G_λ and G_h on dual numbers along the tangent.

use super::elements::Elements;
use super::terms::{Numbering, Term};
use crate::mechanism::{Expansion, LawConstant};
use crate::relation::{Coordinates, Place, Relation};
use crate::scalar::{Dual, Scalar as _};

/// A sparse matrix as a list of its entries.
#[derive(Clone, Debug, Default)]
pub struct Entries {
    list: Vec<(usize, usize, f64)>,
}

impl Entries {
    /// Adds `factor` times a row to a vector.
    pub fn add_row(&self, factor: f64, row: usize, out: &mut [f64]) {
        for &(_, column, value) in self.list.iter().filter(|entry| entry.0 == row) {
            out[column] += factor * value;
        }
    }

    /// The rows that have entries, each once, from the first on.
    pub fn rows(&self) -> Vec<usize> {
        let mut rows: Vec<usize> = self.list.iter().map(|&(row, ..)| row).collect();
        rows.sort_unstable();
        rows.dedup();
        rows
    }

    fn push(&mut self, row: usize, column: usize, value: f64) {
        if value != 0.0 {
            self.list.push((row, column, value));
        }
    }

    /// Adds `factor` times the product with a vector.
    pub fn add_product(&self, factor: f64, x: &[f64], out: &mut [f64]) {
        for &(row, column, value) in &self.list {
            out[row] += factor * value * x[column];
        }
    }

    /// Adds `factor` times the product of the transposed matrix with a vector.
    pub fn add_transposed_product(&self, factor: f64, y: &[f64], out: &mut [f64]) {
        for &(row, column, value) in &self.list {
            out[column] += factor * value * y[row];
        }
    }
}

/// The derivatives of equations: rows are those of the system, each equation of Φ that has none apart.
#[derive(Clone, Debug, Default)]
pub struct Derivatives {
    /// By coordinates, then by the multipliers of kept equations.
    pub by_unknown: Entries,
    /// By the parameters h.
    pub by_parameter: Entries,
    /// By constants of laws.
    pub by_constant: Entries,
    /// Of the equations that are left out, numbered as equations: by coordinates.
    pub left_out_by_unknown: Entries,
    /// The same by the parameters.
    pub left_out_by_parameter: Entries,
}

impl Derivatives {
    fn clear(&mut self) {
        let Self { by_unknown, by_parameter, by_constant, left_out_by_unknown, .. } = self;
        for entries in [by_unknown, by_parameter, by_constant, left_out_by_unknown] {
            entries.list.clear();
        }
        self.left_out_by_parameter.list.clear();
    }
}

/// Which equations there are, and where they stand.
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a> {
    /// The row of each equation of Φ, counted from `first`.
    pub numbering: &'a Numbering,
    /// The row of the first kept equation.
    pub first: usize,
    /// Whether the forces are among the equations; their rows are those of the coordinates.
    pub forces: bool,
}

/// A state with the motion along which derivatives are taken.
#[derive(Clone, Copy, Debug)]
pub struct Along<'a> {
    /// Coordinates of all bodies, the ground first.
    pub state: &'a [Coordinates<Dual>],
    /// Multipliers of all equations.
    pub lambda: &'a [Dual],
    /// Parameters.
    pub h: &'a [Dual],
}

/// A constant of the law of a value of force elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ElementConstant {
    /// The number of the value among those of all elements.
    pub value: usize,
    /// Which constant.
    pub constant: LawConstant,
}

/// All relations of a mechanism on dual numbers.
#[derive(Clone)]
pub struct Variation {
    constraints: Vec<DualTerm>,
    elements: Vec<DualTerm>,
    scratch: Scratch,
}

#[derive(Clone)]
struct DualTerm {
    term: Term,
    kernels: &'static dyn Relation<Dual>,
}

#[derive(Clone, Default)]
struct Scratch {
    phi: Vec<Dual>,
    phi_q: Vec<Dual>,
    work: Vec<Dual>,
    curvature: Vec<Dual>,
    phi_h: Vec<Dual>,
    force_h: Vec<Dual>,
    lambda: Vec<Dual>,
    stiffness: Vec<Dual>,
}

impl Scratch {
    /// Makes room for the outputs of a relation.
    fn fit(&mut self, term: &Term) {
        let shape = term.shape;
        let zero = Dual::from_f64(0.0);
        for (vector, length) in [
            (&mut self.phi, shape.equations),
            (&mut self.phi_q, shape.jacobian.len()),
            (&mut self.work, shape.work.len()),
            (&mut self.curvature, shape.curvature.len()),
            (&mut self.phi_h, shape.design.len()),
            (&mut self.force_h, shape.force_design.len()),
            (&mut self.lambda, shape.equations),
            (&mut self.stiffness, shape.equations),
        ] {
            vector.clear();
            vector.resize(length, zero);
        }
    }
}

/// Where values and their changes along the motion go.
struct Sink<'a> {
    values: &'a mut Derivatives,
    changes: &'a mut Derivatives,
}

impl Sink<'_> {
    fn push(
        &mut self,
        part: fn(&mut Derivatives) -> &mut Entries,
        row: usize,
        column: usize,
        entry: Dual,
    ) {
        part(self.values).push(row, column, entry.value);
        part(self.changes).push(row, column, entry.derivative);
    }
}

impl Variation {
    /// The relations of a mechanism.
    pub fn new(expansion: &Expansion) -> Self {
        let constraints = expansion.instances().iter().map(DualTerm::new).collect();
        let elements = expansion.elements().iter();
        let elements = elements.map(|element| DualTerm::new(&element.instance)).collect();
        Self { constraints, elements, scratch: Scratch::default() }
    }

    /// Finds the derivatives at a state and how they change along its motion. `constants` are those
    /// by which `by_constant` has columns, in their order.
    pub fn evaluate(
        &mut self,
        along: Along<'_>,
        rows: Rows<'_>,
        elements: &Elements,
        constants: &[ElementConstant],
        values: &mut Derivatives,
        changes: &mut Derivatives,
    ) {
        values.clear();
        changes.clear();
        let mut sink = Sink { values, changes };
        for constraint in &self.constraints {
            constraint.hold(along, rows, &mut self.scratch, &mut sink);
        }
        if !rows.forces {
            return;
        }
        for element in &self.elements {
            element.push_back(along, elements, constants, &mut self.scratch, &mut sink);
        }
    }
}

impl DualTerm {
    fn new(instance: &crate::mechanism::Instance) -> Self {
        Self { term: Term::new(instance), kernels: instance.kind.kernels::<Dual>() }
    }

    fn place<'a>(&self, along: Along<'a>) -> Place<'a, Dual> {
        let Term { i, j, parameters, .. } = &self.term;
        let h = &along.h[parameters.clone()];
        Place { q_i: &along.state[*i], q_j: &along.state[*j], h }
    }

    /// The entries of a relation that holds.
    fn hold(&self, along: Along<'_>, rows: Rows<'_>, scratch: &mut Scratch, sink: &mut Sink<'_>) {
        let term = &self.term;
        scratch.fit(term);
        let Scratch { phi, phi_q, work, curvature, phi_h, force_h, lambda, .. } = scratch;
        let place = self.place(along);
        if rows.forces {
            lambda.copy_from_slice(&along.lambda[term.equations.clone()]);
            self.kernels.curvature(place, lambda, phi, phi_q, work, curvature);
        } else {
            self.kernels.jacobian(place, phi, phi_q, work);
        }
        self.kernels.design(place, lambda, phi_h, force_h);
        let row = |equation: u8| {
            let equation = term.equations.start + usize::from(equation);
            rows.numbering.row(equation).map(|row| rows.first + row).ok_or(equation)
        };
        let parameter = |k: u8| term.parameters.start + usize::from(k);
        for (&(equation, local), &value) in term.shape.jacobian.iter().zip(&*phi_q) {
            let Some(unknown) = term.unknown(local) else { continue };
            match row(equation) {
                Ok(row) => sink.push(|d| &mut d.by_unknown, row, unknown, value),
                Err(equation) => {
                    sink.push(|d| &mut d.left_out_by_unknown, equation, unknown, value);
                }
            }
        }
        for (&(equation, k), &value) in term.shape.design.iter().zip(&*phi_h) {
            match row(equation) {
                Ok(row) => sink.push(|d| &mut d.by_parameter, row, parameter(k), value),
                Err(equation) => {
                    sink.push(|d| &mut d.left_out_by_parameter, equation, parameter(k), value);
                }
            }
        }
        if !rows.forces {
            return;
        }
        let unknowns = rows.numbering.unknowns();
        for (&(equation, local), &value) in self.work_pattern().iter().zip(work_of(phi_q, work)) {
            let multiplier = rows.numbering.row(term.equations.start + usize::from(equation));
            if let (Some(unknown), Some(multiplier)) = (term.unknown(local), multiplier) {
                sink.push(|d| &mut d.by_unknown, unknown, unknowns + multiplier, value);
            }
        }
        self.push_forces(curvature, force_h, sink);
    }

    /// The entries of (Wᵀλ)_q and (Wᵀλ)_h.
    fn push_forces(&self, curvature: &[Dual], force_h: &[Dual], sink: &mut Sink<'_>) {
        let term = &self.term;
        for (&(row, column), &value) in term.shape.curvature.iter().zip(curvature) {
            let (Some(i), Some(j)) = (term.unknown(row), term.unknown(column)) else { continue };
            sink.push(|d| &mut d.by_unknown, i, j, value);
            if !term.shape.has_work() && row != column {
                sink.push(|d| &mut d.by_unknown, j, i, value);
            }
        }
        for (&(local, k), &value) in term.shape.force_design.iter().zip(force_h) {
            if let Some(unknown) = term.unknown(local) {
                let parameter = term.parameters.start + usize::from(k);
                sink.push(|d| &mut d.by_parameter, unknown, parameter, value);
            }
        }
    }

    /// The entries of a relation that pushes back.
    fn push_back(
        &self,
        along: Along<'_>,
        elements: &Elements,
        constants: &[ElementConstant],
        scratch: &mut Scratch,
        sink: &mut Sink<'_>,
    ) {
        let term = &self.term;
        let shape = term.shape;
        scratch.fit(term);
        let Scratch { phi, phi_q, work, curvature, phi_h, force_h, lambda, stiffness } = scratch;
        let place = self.place(along);
        self.kernels.jacobian(place, phi, phi_q, work);
        let laws = &elements.laws()[term.equations.clone()];
        for (k, law) in laws.iter().enumerate() {
            // Angles are counted over full turns outside the kernel.
            let counted = elements.values()[term.equations.start + k];
            let turns = elements.turns(term.equations.start + k, counted - phi[k].value);
            phi[k] = phi[k] + Dual::from_f64(turns);
            [lambda[k], stiffness[k]] = law.lifted(phi[k]);
        }
        let value_of = std::mem::take(phi);
        phi.resize(shape.equations, Dual::from_f64(0.0));
        self.kernels.curvature(place, lambda, phi, phi_q, work, curvature);
        self.kernels.design(place, lambda, phi_h, force_h);
        *phi = value_of;
        self.push_forces(curvature, force_h, sink);
        // Wᵀ f_Φ Φ_q, Wᵀ f_Φ Φ_h and Wᵀ f_c.
        for (&(equation, local), &w) in self.work_pattern().iter().zip(work_of(phi_q, work)) {
            let Some(unknown) = term.unknown(local) else { continue };
            let factor = w * stiffness[usize::from(equation)];
            for (&(other, column), &value) in shape.jacobian.iter().zip(&*phi_q) {
                if other == equation
                    && let Some(column) = term.unknown(column)
                {
                    sink.push(|d| &mut d.by_unknown, unknown, column, factor * value);
                }
            }
            for (&(other, k), &value) in shape.design.iter().zip(&*phi_h) {
                if other == equation {
                    let parameter = term.parameters.start + usize::from(k);
                    sink.push(|d| &mut d.by_parameter, unknown, parameter, factor * value);
                }
            }
            let k = usize::from(equation);
            for (column, constant) in constants.iter().enumerate() {
                if constant.value == term.equations.start + k {
                    let force = laws[k].by_constant(constant.constant, phi[k]);
                    sink.push(|d| &mut d.by_constant, unknown, column, w * force);
                }
            }
        }
    }

    /// The pattern of W.
    fn work_pattern(&self) -> &'static [(u8, u8)] {
        let shape = self.term.shape;
        if shape.has_work() { shape.work } else { shape.jacobian }
    }
}

fn work_of<'a>(phi_q: &'a [Dual], work: &'a [Dual]) -> &'a [Dual] {
    if work.is_empty() { phi_q } else { work }
}
