//! The blocks Φ, Φ_q and (Φ_qᵀλ)_q of one relation, found in different ways.
//!
//! Every way writes the same entries in the same order, so that an assembly does
//! not notice which one it works with. All know the sparsity pattern and evaluate
//! only the directions in which something changes; none allocates.

pub mod differences;
pub mod duals;
pub mod gradient;
mod programs;

pub use differences::Differences;

use hardpoint::kernels::RelationKind;
use hardpoint::relation::{Coordinates, Place, Relation, Shape};
use hardpoint::scalar::Scalar;

/// Differences are compared with symbolic numbers to this tolerance.
pub const DIFFERENCES: f64 = 1e-6;
/// Dual numbers are exact up to rounding.
pub const DUALS: f64 = 1e-12;

/// The derivatives of a relation. Outputs are as in [`Relation`].
pub trait Blocks {
    /// Φ and Φ_q.
    fn jacobian(&mut self, place: Place<'_, f64>, phi: &mut [f64], phi_q: &mut [f64]);

    /// Φ, Φ_q and (Φ_qᵀλ)_q.
    fn curvature(
        &mut self,
        place: Place<'_, f64>,
        lambda: &[f64],
        phi: &mut [f64],
        phi_q: &mut [f64],
        curvature: &mut [f64],
    );
}

/// The kernels as they are shipped.
pub struct Symbolic(pub &'static dyn Relation<f64>);

impl Symbolic {
    /// The kernels of a relation.
    pub fn new(kind: RelationKind) -> Self {
        Self(kind.kernels())
    }
}

impl Blocks for Symbolic {
    fn jacobian(&mut self, place: Place<'_, f64>, phi: &mut [f64], phi_q: &mut [f64]) {
        self.0.jacobian(place, phi, phi_q, &mut []);
    }

    fn curvature(
        &mut self,
        place: Place<'_, f64>,
        lambda: &[f64],
        phi: &mut [f64],
        phi_q: &mut [f64],
        curvature: &mut [f64],
    ) {
        self.0.curvature(place, lambda, phi, phi_q, &mut [], curvature);
    }
}

/// One product of the contraction with λ: `curvature[entry] += λ[equation] · dΦ_q[output]`.
#[derive(Clone, Copy)]
pub struct Product {
    pub entry: usize,
    pub equation: usize,
    pub output: usize,
}

/// How the stored entries of (Φ_qᵀλ)_q follow from the derivative of Φ_q along each direction.
pub struct Contraction {
    /// The coordinates to go along.
    pub directions: Vec<usize>,
    /// The products of each direction.
    pub products: Vec<Vec<Product>>,
}

impl Contraction {
    /// The directions in which Φ_q changes.
    pub fn new(shape: &Shape) -> Self {
        Self::along(shape, columns(shape.curvature))
    }

    /// The given directions.
    pub fn along(shape: &Shape, directions: Vec<usize>) -> Self {
        assert!(!shape.has_work(), "{} has rows of work", shape.name);
        let products = directions
            .iter()
            .map(|&direction| {
                let entries = shape.curvature.iter().enumerate();
                entries
                    .filter(|(_, (_, column))| usize::from(*column) == direction)
                    .flat_map(|(entry, &(row, _))| {
                        let outputs = shape.jacobian.iter().enumerate();
                        outputs.filter(move |(_, (_, column))| *column == row).map(
                            move |(output, &(equation, _))| Product {
                                entry,
                                equation: usize::from(equation),
                                output,
                            },
                        )
                    })
                    .collect()
            })
            .collect();
        Self { directions, products }
    }
}

/// The columns of a pattern, each once.
pub fn columns(pattern: &[(u8, u8)]) -> Vec<usize> {
    let mut columns: Vec<usize> = pattern.iter().map(|&(_, column)| usize::from(column)).collect();
    columns.sort_unstable();
    columns.dedup();
    columns
}

/// Copies of the arguments of a kernel in another type of number.
pub struct Arguments<S> {
    q: [Coordinates<S>; 2],
    h: Vec<S>,
}

impl<S: Scalar> Arguments<S> {
    /// Room for the arguments of a relation.
    pub fn new(shape: &Shape) -> Self {
        let zero = S::from_f64(0.0);
        Self { q: [[zero; 7]; 2], h: vec![zero; shape.parameter_count()] }
    }

    /// Copies numbers without derivative.
    pub fn set(&mut self, place: Place<'_, f64>) {
        self.q = [place.q_i.map(S::from_f64), place.q_j.map(S::from_f64)];
        for (to, from) in self.h.iter_mut().zip(place.h) {
            *to = S::from_f64(*from);
        }
    }

    /// A coordinate: 0..7 of body i, 7..14 of body j.
    pub fn coordinate(&mut self, local: usize) -> &mut S {
        &mut self.q[local / 7][local % 7]
    }

    /// Where to evaluate.
    pub fn place(&self) -> Place<'_, S> {
        Place { q_i: &self.q[0], q_j: &self.q[1], h: &self.h }
    }
}
