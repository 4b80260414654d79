//! Central differences, as programs without second derivatives use them.

use hardpoint::kernels::RelationKind;
use hardpoint::relation::{BODY_COORDINATES, Place, Relation};

use super::{Arguments, Blocks, Contraction, columns};

/// Step of the central differences; coordinates are of the order of one.
pub const STEP: f64 = 1e-5;

/// Φ_q by differences of Φ, and (Φ_qᵀλ)_q by differences of the symbolic Φ_q.
pub struct Differences {
    kernels: &'static dyn Relation<f64>,
    arguments: Arguments<f64>,
    columns: Vec<usize>,
    contraction: Contraction,
    // One residual or Jacobian on each side.
    before: Vec<f64>,
    after: Vec<f64>,
    unused: Vec<f64>,
}

impl Differences {
    /// Only the directions in which something changes.
    pub fn new(kind: RelationKind) -> Self {
        let shape = kind.shape();
        Self {
            kernels: kind.kernels(),
            arguments: Arguments::new(shape),
            columns: columns(shape.jacobian),
            contraction: Contraction::new(shape),
            before: vec![0.0; shape.jacobian.len()],
            after: vec![0.0; shape.jacobian.len()],
            unused: vec![0.0; shape.equations],
        }
    }

    /// All fourteen directions, for a program that does not know the pattern of its curvature.
    pub fn blind(kind: RelationKind) -> Self {
        let shape = kind.shape();
        let all = (0..BODY_COORDINATES * shape.bodies).collect();
        Self { contraction: Contraction::along(shape, all), ..Self::new(kind) }
    }
}

impl Blocks for Differences {
    fn jacobian(&mut self, place: Place<'_, f64>, phi: &mut [f64], phi_q: &mut [f64]) {
        self.kernels.residual(place, phi);
        self.arguments.set(place);
        let (before, after) = (&mut self.before[..phi.len()], &mut self.after[..phi.len()]);
        let pattern = self.kernels.shape().jacobian;
        for &column in &self.columns {
            let value = *self.arguments.coordinate(column);
            *self.arguments.coordinate(column) = value - STEP;
            self.kernels.residual(self.arguments.place(), before);
            *self.arguments.coordinate(column) = value + STEP;
            self.kernels.residual(self.arguments.place(), after);
            *self.arguments.coordinate(column) = value;
            for (entry, &(row, of)) in phi_q.iter_mut().zip(pattern) {
                if usize::from(of) == column {
                    let row = usize::from(row);
                    *entry = (after[row] - before[row]) / (2.0 * STEP);
                }
            }
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
        self.kernels.jacobian(place, phi, phi_q, &mut []);
        self.arguments.set(place);
        curvature.fill(0.0);
        let Contraction { directions, products } = &self.contraction;
        for (&direction, products) in directions.iter().zip(products) {
            let value = *self.arguments.coordinate(direction);
            for (side, outputs) in [(-STEP, &mut self.before), (STEP, &mut self.after)] {
                *self.arguments.coordinate(direction) = value + side;
                let place = self.arguments.place();
                self.kernels.jacobian(place, &mut self.unused, outputs, &mut []);
            }
            *self.arguments.coordinate(direction) = value;
            for product in products {
                let change = self.after[product.output] - self.before[product.output];
                curvature[product.entry] += lambda[product.equation] * change / (2.0 * STEP);
            }
        }
    }
}
