//! An assembly whose blocks can be found in any way.
//!
//! It works as the assembly of the library does, entry by entry, on the library's
//! own patterns and numbering. The library looks its kernels up itself, so it
//! cannot be asked to use others.

use std::ops::Range;

use hardpoint::assembly::{Numbering, Pattern};
use hardpoint::kernels::RelationKind;
use hardpoint::mechanism::{Expansion, Instance};
use hardpoint::relation::{BODY_COORDINATES, Coordinates, Place, Shape};

use super::methods::Blocks;
use super::methods::differences::STEP;

/// How a relation's blocks are found.
pub type Method = fn(RelationKind) -> Box<dyn Blocks>;

struct Term {
    blocks: Box<dyn Blocks>,
    shape: &'static Shape,
    i: usize,
    j: usize,
    parameters: Range<usize>,
    equations: Range<usize>,
    phi_q: Vec<f64>,
    curvature: Vec<f64>,
    unknowns: Vec<Option<usize>>,
    // Output and place of each entry that the matrix has.
    phi_q_slots: Vec<[usize; 2]>,
    curvature_slots: Vec<[usize; 2]>,
    // Output, equation and unknown of each entry of the force.
    force: Vec<[usize; 3]>,
}

impl Term {
    fn new(instance: &Instance, method: Method) -> Self {
        let shape = instance.kind.shape();
        let bodies = [instance.i.index(), instance.j.index()];
        let unknown = |local: usize| {
            let body = bodies[local / BODY_COORDINATES].checked_sub(1)?;
            Some(BODY_COORDINATES * body + local % BODY_COORDINATES)
        };
        let force = shape.jacobian.iter().enumerate().filter_map(|(output, &(equation, local))| {
            Some([output, usize::from(equation), unknown(usize::from(local))?])
        });
        Self {
            blocks: method(instance.kind),
            force: force.collect(),
            shape,
            i: bodies[0],
            j: bodies[1],
            parameters: instance.parameters.clone(),
            equations: instance.equations.clone(),
            phi_q: vec![0.0; shape.jacobian.len()],
            curvature: vec![0.0; shape.curvature.len()],
            unknowns: (0..2 * BODY_COORDINATES).map(unknown).collect(),
            phi_q_slots: vec![],
            curvature_slots: vec![],
        }
    }

    fn unknown(&self, local: u8) -> Option<usize> {
        self.unknowns[usize::from(local)]
    }

    fn jacobian(&mut self, state: &[Coordinates<f64>], h: &[f64], phi: &mut [f64]) {
        let place =
            Place { q_i: &state[self.i], q_j: &state[self.j], h: &h[self.parameters.clone()] };
        self.blocks.jacobian(place, &mut phi[self.equations.clone()], &mut self.phi_q);
    }

    fn add_force(&self, lambda: &[f64], force: &mut [f64]) {
        let lambda = &lambda[self.equations.clone()];
        for &[output, equation, unknown] in &self.force {
            force[unknown] += self.phi_q[output] * lambda[equation];
        }
    }
}

/// Φ_q, or [(Φ_qᵀλ)_q, Φ_qᵀ; Φ_q, 0], with the blocks of one method.
pub struct Assembly {
    terms: Vec<Term>,
    pattern: Pattern,
    values: Vec<f64>,
    /// Φ_qᵀλ of the last fill.
    pub force: Vec<f64>,
    // One force on each side of a difference.
    sides: [Vec<f64>; 2],
}

impl Assembly {
    /// The constraint Jacobian.
    pub fn jacobian(
        expansion: &Expansion,
        numbering: &Numbering,
        pattern: &Pattern,
        method: Method,
    ) -> Self {
        Self::new(expansion, numbering, pattern, method, 0)
    }

    /// The matrix of static equilibrium.
    pub fn kkt(
        expansion: &Expansion,
        numbering: &Numbering,
        pattern: &Pattern,
        method: Method,
    ) -> Self {
        Self::new(expansion, numbering, pattern, method, numbering.unknowns())
    }

    fn new(
        expansion: &Expansion,
        numbering: &Numbering,
        pattern: &Pattern,
        method: Method,
        first_row: usize,
    ) -> Self {
        let slot = |row: Option<usize>, column: Option<usize>| {
            row.zip(column).and_then(|(row, column)| pattern.slot(row, column))
        };
        let terms = expansion.instances().iter().map(|instance| {
            let mut term = Term::new(instance, method);
            for (output, &(equation, local)) in term.shape.jacobian.iter().enumerate() {
                let row = numbering.row(term.equations.start + usize::from(equation));
                let row = row.map(|row| first_row + row);
                let column = term.unknown(local);
                let mirrored = if first_row > 0 { slot(column, row) } else { None };
                let slots = [slot(row, column), mirrored].into_iter().flatten();
                term.phi_q_slots.extend(slots.map(|slot| [output, slot]));
            }
            for (output, &(row, column)) in term.shape.curvature.iter().enumerate() {
                let entry = (term.unknown(row), term.unknown(column));
                let mirrored = if row == column { None } else { slot(entry.1, entry.0) };
                let slots = [slot(entry.0, entry.1), mirrored].into_iter().flatten();
                term.curvature_slots.extend(slots.map(|slot| [output, slot]));
            }
            term
        });
        let unknowns = numbering.unknowns();
        Self {
            terms: terms.collect(),
            values: vec![0.0; pattern.nonzeros()],
            force: vec![0.0; unknowns],
            sides: [vec![0.0; unknowns], vec![0.0; unknowns]],
            pattern: pattern.clone(),
        }
    }

    /// The values in the order of the pattern.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Evaluates Φ and Φ_q.
    pub fn fill_jacobian(&mut self, state: &[Coordinates<f64>], h: &[f64], phi: &mut [f64]) {
        for term in &mut self.terms {
            term.jacobian(state, h, phi);
            for &[output, slot] in &term.phi_q_slots {
                self.values[slot] = term.phi_q[output];
            }
        }
    }

    /// Evaluates Φ, Φ_qᵀλ and the matrix of static equilibrium.
    pub fn fill_kkt(
        &mut self,
        state: &[Coordinates<f64>],
        h: &[f64],
        lambda: &[f64],
        phi: &mut [f64],
    ) {
        self.values.fill(0.0);
        self.force.fill(0.0);
        for term in &mut self.terms {
            let place =
                Place { q_i: &state[term.i], q_j: &state[term.j], h: &h[term.parameters.clone()] };
            term.blocks.curvature(
                place,
                &lambda[term.equations.clone()],
                &mut phi[term.equations.clone()],
                &mut term.phi_q,
                &mut term.curvature,
            );
            for &[output, slot] in &term.phi_q_slots {
                self.values[slot] = term.phi_q[output];
            }
            for &[output, slot] in &term.curvature_slots {
                self.values[slot] += term.curvature[output];
            }
            term.add_force(lambda, &mut self.force);
        }
    }

    /// As [`Self::fill_kkt`], with the curvature by central differences of the
    /// assembled force Φ_qᵀλ: two Jacobians of the whole mechanism for each unknown.
    pub fn fill_kkt_by_assembled_differences(
        &mut self,
        state: &mut [Coordinates<f64>],
        h: &[f64],
        lambda: &[f64],
        phi: &mut [f64],
    ) {
        let unknowns = self.force.len();
        self.values.fill(0.0);
        for column in 0..unknowns {
            let (body, coordinate) = (1 + column / BODY_COORDINATES, column % BODY_COORDINATES);
            let value = state[body][coordinate];
            for (side, force) in [-STEP, STEP].into_iter().zip(&mut self.sides) {
                state[body][coordinate] = value + side;
                force.fill(0.0);
                for term in &mut self.terms {
                    term.jacobian(state, h, phi);
                    term.add_force(lambda, force);
                }
            }
            state[body][coordinate] = value;
            let [before, after] = &self.sides;
            let starts = self.pattern.column_starts();
            for slot in starts[column]..starts[column + 1] {
                let row = self.pattern.row_indices()[slot];
                if row < unknowns {
                    self.values[slot] = (after[row] - before[row]) / (2.0 * STEP);
                }
            }
        }
        self.force.fill(0.0);
        for term in &mut self.terms {
            term.jacobian(state, h, phi);
            for &[output, slot] in &term.phi_q_slots {
                self.values[slot] = term.phi_q[output];
            }
            term.add_force(lambda, &mut self.force);
        }
    }
}
