//! The stiffness of a mechanism against the motions that its joints allow.
//!
//! Set-up and reporting: dense, and it may allocate.

use faer::{Mat, Side};

use super::equilibrium::Equilibrium;
use super::motion::{Precision, describe, localise, twists};
use super::rank::{null_space, scaled_jacobian};

/// A stiffness below this part of the largest one is none.
const NONE: f64 = 1e-12;

/// The motion with the smallest stiffness.
pub(super) struct Softest {
    /// The stiffness against it (N/m), made a length by the size of the mechanism.
    pub stiffness: f64,
    /// The motion in words.
    pub motion: String,
    /// Whether the stiffness is above zero.
    pub holds: bool,
}

/// The softest motion at the state of the last evaluation; `None` where nothing can move.
pub(super) fn softest(equilibrium: &Equilibrium) -> Option<Softest> {
    let problem = &equilibrium.problem;
    let scales = problem.scales;
    let (expansion, state) = (&equilibrium.expansion, &problem.state);
    let (jacobian, _) = scaled_jacobian(expansion, &equilibrium.terms, state, &problem.h, scales);
    let kept = problem.numbering.kept();
    if jacobian.col_iter().any(|column| column.iter().any(|x| !x.is_finite())) {
        return None;
    }
    let basis = null_space(jacobian.as_ref(), kept)?;
    if basis.ncols() == 0 {
        return None;
    }
    let unknowns = problem.numbering.unknowns();
    let mut stiffness = Mat::<f64>::zeros(unknowns, unknowns);
    for (row, column, slot) in problem.kkt.pattern().entries() {
        if row < unknowns && column < unknowns {
            let value = problem.kkt.values()[slot];
            stiffness[(row, column)] = value * scales.coordinate(row) * scales.coordinate(column);
        }
    }
    let reduced = basis.transpose() * &stiffness * &basis;
    // A circulating part of forces without potential does no work over a symmetric motion.
    let symmetric = Mat::from_fn(reduced.nrows(), reduced.ncols(), |i, j| {
        0.5 * (reduced[(i, j)] + reduced[(j, i)])
    });
    // Where nothing but rounding is left of the stiffness, the forces say how much that is.
    let largest = (0..symmetric.ncols())
        .flat_map(|j| (0..symmetric.nrows()).map(move |i| (i, j)))
        .fold(problem.force_size * scales.length, |largest: f64, (i, j)| {
            largest.max(symmetric[(i, j)].abs())
        });
    let eigen = symmetric.self_adjoint_eigen(Side::Lower).ok()?;
    let smallest = eigen.S().column_vector()[0];
    let direction = &basis * eigen.U().col(0);
    let holds = smallest > NONE * largest.max(f64::MIN_POSITIVE);
    // A free motion is told apart from others that are free, too.
    let precision = Precision { tolerance: 1e-3, numbers: true };
    let free = smallest.abs() <= NONE * largest;
    let describe =
        |twists: &[_]| describe(&equilibrium.mechanism, state, twists, scales.length, precision).0;
    let motion = if free {
        let soft = (0..symmetric.ncols())
            .take_while(|&k| eigen.S().column_vector()[k].abs() <= NONE * largest)
            .count();
        let free = &basis * eigen.U().subcols(0, soft.max(1));
        let words: Vec<String> =
            localise(state, free.as_ref(), scales).iter().map(|twists| describe(twists)).collect();
        words.join("; and: ")
    } else {
        let rates: Vec<f64> = (0..unknowns).map(|k| direction[k]).collect();
        describe(&twists(state, &rates, scales))
    };
    let stiffness = if free { 0.0 } else { smallest / scales.length.powi(2) };
    Some(Softest { stiffness, motion, holds })
}
