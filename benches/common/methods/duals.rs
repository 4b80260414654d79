//! Scalar dual numbers of `num-dual`: one direction, or one pair of directions, at a time.

use hardpoint::kernels::RelationKind;
use hardpoint::relation::{Place, Relation};
use hardpoint::scalar::Scalar;

use super::programs::{self, Program};
use super::{Arguments, Blocks, Contraction, columns};
use crate::common::dual::{First, Second};

/// Φ_q from Φ on `Dual64`.
pub fn for_jacobian(kind: RelationKind) -> Box<dyn Blocks> {
    Box::new(Duals::new(kind, programs::residual(kind)))
}

/// (Φ_qᵀλ)_q from the symbolic Φ_q on `Dual64`.
pub fn for_curvature(kind: RelationKind) -> Box<dyn Blocks> {
    Box::new(Duals::new(kind, programs::jacobian(kind)))
}

struct Duals {
    // The program whose derivative is wanted.
    program: Program<First>,
    pattern: &'static [(u8, u8)],
    arguments: Arguments<First>,
    columns: Vec<usize>,
    contraction: Contraction,
    phi: Vec<First>,
    phi_q: Vec<First>,
}

impl Duals {
    fn new(kind: RelationKind, program: Program<First>) -> Self {
        let shape = kind.shape();
        Self {
            program,
            pattern: shape.jacobian,
            arguments: Arguments::new(shape),
            columns: columns(shape.jacobian),
            contraction: Contraction::new(shape),
            phi: vec![First::from_f64(0.0); shape.equations],
            phi_q: vec![First::from_f64(0.0); shape.jacobian.len()],
        }
    }
}

impl Blocks for Duals {
    fn jacobian(&mut self, place: Place<'_, f64>, phi: &mut [f64], phi_q: &mut [f64]) {
        self.arguments.set(place);
        for &column in &self.columns {
            self.arguments.coordinate(column).0.eps = 1.0;
            (self.program)(self.arguments.place(), &mut self.phi, &mut self.phi_q);
            self.arguments.coordinate(column).0.eps = 0.0;
            for (entry, &(row, of)) in phi_q.iter_mut().zip(self.pattern) {
                if usize::from(of) == column {
                    *entry = self.phi[usize::from(row)].0.eps;
                }
            }
        }
        for (to, from) in phi.iter_mut().zip(&self.phi) {
            *to = from.0.re;
        }
    }

    fn curvature(
        &mut self,
        place: Place<'_, f64>,
        lambda: &[f64],
        phi: &mut [f64],
        phi_q: &mut [f64],
        curvature: &mut [f64],
    ) {
        self.arguments.set(place);
        curvature.fill(0.0);
        let Contraction { directions, products } = &self.contraction;
        for (&direction, products) in directions.iter().zip(products) {
            self.arguments.coordinate(direction).0.eps = 1.0;
            (self.program)(self.arguments.place(), &mut self.phi, &mut self.phi_q);
            self.arguments.coordinate(direction).0.eps = 0.0;
            for product in products {
                curvature[product.entry] +=
                    lambda[product.equation] * self.phi_q[product.output].0.eps;
            }
        }
        // Every direction gives the values again; the last ones are taken.
        for (to, from) in phi.iter_mut().zip(&self.phi).chain(phi_q.iter_mut().zip(&self.phi_q)) {
            *to = from.0.re;
        }
    }
}

/// (Φ_qᵀλ)_q from Φ alone on `HyperDual64`, one evaluation for each stored
/// entry; Φ and Φ_q from the symbolic kernel.
pub struct HyperDuals {
    symbolic: &'static dyn Relation<f64>,
    residual: Program<Second>,
    arguments: Arguments<Second>,
    phi: Vec<Second>,
}

impl HyperDuals {
    /// The blocks of a relation.
    pub fn new(kind: RelationKind) -> Self {
        let shape = kind.shape();
        Self {
            symbolic: kind.kernels(),
            residual: programs::residual(kind),
            arguments: Arguments::new(shape),
            phi: vec![Second::from_f64(0.0); shape.equations],
        }
    }
}

impl Blocks for HyperDuals {
    fn jacobian(&mut self, place: Place<'_, f64>, phi: &mut [f64], phi_q: &mut [f64]) {
        self.symbolic.jacobian(place, phi, phi_q, &mut []);
    }

    fn curvature(
        &mut self,
        place: Place<'_, f64>,
        lambda: &[f64],
        phi: &mut [f64],
        phi_q: &mut [f64],
        curvature: &mut [f64],
    ) {
        self.symbolic.jacobian(place, phi, phi_q, &mut []);
        self.arguments.set(place);
        for (entry, &(row, column)) in curvature.iter_mut().zip(self.symbolic.shape().curvature) {
            let (row, column) = (usize::from(row), usize::from(column));
            self.arguments.coordinate(row).0.eps1 = 1.0;
            self.arguments.coordinate(column).0.eps2 = 1.0;
            (self.residual)(self.arguments.place(), &mut self.phi, &mut []);
            self.arguments.coordinate(row).0.eps1 = 0.0;
            self.arguments.coordinate(column).0.eps2 = 0.0;
            let products = self.phi.iter().zip(lambda);
            *entry = products.map(|(phi, lambda)| lambda * phi.0.eps1eps2).sum();
        }
    }
}
