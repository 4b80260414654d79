//! Φ_q as a sparse matrix.

use super::pattern::Pattern;
use super::terms::{Numbering, Terms};
use crate::relation::Coordinates;

/// Φ_q with a fixed pattern.
///
/// It has a row for each equation that is not left out and a column for each
/// unknown; it is square when the mechanism has no free motion.
#[derive(Clone)]
pub struct Jacobian {
    terms: Terms,
    pattern: Pattern,
    // One place for each kernel output, term after term. Entries of the ground
    // and of left-out equations all go to one spare place behind the values.
    slots: Vec<usize>,
    values: Vec<f64>,
}

impl Jacobian {
    /// Finds the pattern.
    pub fn new(terms: Terms, numbering: &Numbering) -> Self {
        let places: Vec<_> = terms
            .list
            .iter()
            .flat_map(|term| {
                term.shape.jacobian.iter().map(|&(equation, local)| {
                    let row = numbering.row(term.equations.start + usize::from(equation));
                    row.zip(term.unknown(local))
                })
            })
            .collect();
        let pattern = Pattern::new(
            numbering.kept().len(),
            numbering.unknowns(),
            places.iter().copied().flatten().collect(),
        );
        let spare = pattern.nonzeros();
        let slots = places
            .into_iter()
            .map(|place| place.and_then(|(row, column)| pattern.slot(row, column)))
            .map(|slot| slot.unwrap_or(spare))
            .collect();
        Self { values: vec![0.0; spare + 1], terms, pattern, slots }
    }

    /// The pattern of the matrix.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// The values in the order of the pattern.
    pub fn values(&self) -> &[f64] {
        &self.values[..self.pattern.nonzeros()]
    }

    /// The relations.
    pub fn terms(&mut self) -> &mut Terms {
        &mut self.terms
    }

    /// Evaluates Φ (all equations) and the matrix.
    pub fn fill(&mut self, state: &[Coordinates<f64>], h: &[f64], phi: &mut [f64]) {
        let Terms { list, phi_q, work, .. } = &mut self.terms;
        let mut slots = self.slots.iter();
        for term in list {
            let phi_q = &mut phi_q[..term.shape.jacobian.len()];
            term.kernels.jacobian(
                term.place(state, h),
                &mut phi[term.equations.clone()],
                phi_q,
                &mut work[..term.shape.work.len()],
            );
            for (value, &slot) in phi_q.iter().zip(&mut slots) {
                self.values[slot] = *value;
            }
        }
    }
}
