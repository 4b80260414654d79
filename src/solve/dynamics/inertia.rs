//! Motions that no mass takes part in.
//!
//! Set-up only: dense, and it may allocate.

use faer::{Mat, Side};

use super::Dynamics;
use super::failure::DynamicsFailure;
use crate::assembly::Blend;
use crate::solve::motion::{Precision, describe, localise};
use crate::solve::rank::{null_space, scaled_jacobian};

/// An inertia below this part of the largest one is none.
const NONE: f64 = 1e-13;

/// The mass matrix alone, with the constraints beside it.
pub(super) const MASS: Blend = Blend { stiffness: 0.0, damping: 0.0, mass: 1.0 };

impl Dynamics {
    /// Refuses motions that the joints allow and that move no mass: their acceleration would be
    /// infinite. The matrix has to hold [`MASS`] at the current state.
    pub(super) fn check_inertia(&self) -> Result<(), DynamicsFailure> {
        let (state, scales) = (&self.now.state, self.scales);
        let (jacobian, _) = scaled_jacobian(&self.expansion, &self.terms, state, &self.h, scales);
        let basis = null_space(jacobian.as_ref(), self.numbering.kept());
        if basis.ncols() == 0 {
            return Ok(());
        }
        let unknowns = self.numbering.unknowns();
        let mut mass = Mat::<f64>::zeros(unknowns, unknowns);
        for (row, column, slot) in self.kkt.pattern().entries() {
            if row < unknowns && column < unknowns {
                mass[(row, column)] =
                    self.kkt.values()[slot] * scales.coordinate(row) * scales.coordinate(column);
            }
        }
        let mass = basis.transpose() * &mass * &basis;
        let Ok(eigen) = mass.self_adjoint_eigen(Side::Lower) else {
            return Err(DynamicsFailure::Undetermined { time: self.now.time });
        };
        let values = eigen.S().column_vector();
        let largest = values[values.nrows() - 1];
        let massless = (0..values.nrows()).take_while(|&k| values[k] <= NONE * largest).count();
        if massless == 0 {
            return Ok(());
        }
        let motions = &basis * eigen.U().subcols(0, massless);
        let precision = Precision { tolerance: 1e-3, numbers: true };
        let mut bodies = vec![];
        let mut words = vec![];
        for twists in localise(state, motions.as_ref(), scales) {
            let (motion, moving) =
                describe(&self.mechanism, state, &twists, scales.length, precision);
            words.push(motion);
            for body in moving {
                let name = self.mechanism.bodies()[body.index()].name.clone();
                if !bodies.contains(&name) {
                    bodies.push(name);
                }
            }
        }
        Err(DynamicsFailure::NoInertia { bodies, motion: words.join("; and: ") })
    }
}
