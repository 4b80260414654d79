//! The stiffness of a mechanism against the motions that its joints allow.
//!
//! Set-up and reporting: dense, and it may allocate.

use faer::{Mat, Side};

use super::equilibrium::Equilibrium;
use super::motion::{Precision, describe, localise, twists};
use super::rank::null_space;

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

/// The softest motion at the state for which the matrix was filled last, with the equations of some of
/// its rows let go; `None` where nothing can move.
pub(super) fn softest(equilibrium: &Equilibrium, let_go: &[usize]) -> Option<Softest> {
    let problem = &equilibrium.problem;
    let (scales, state) = (problem.scales, &problem.state);
    let unknowns = problem.numbering.unknowns();
    let mut stiffness = Mat::<f64>::zeros(unknowns, unknowns);
    let mut jacobian = Mat::<f64>::zeros(problem.numbering.kept().len(), unknowns);
    let entries = problem.kkt.pattern().entries().take_while(|&(_, column, _)| column < unknowns);
    for (row, column, slot) in entries {
        let value = problem.kkt.values()[slot] * scales.coordinate(column);
        match row.checked_sub(unknowns) {
            Some(row) => jacobian[(row, column)] = value,
            None => stiffness[(row, column)] = value * scales.coordinate(row),
        }
    }
    if jacobian.col_iter().any(|column| column.iter().any(|x| !x.is_finite())) {
        return None;
    }
    let held: Vec<usize> = (0..jacobian.nrows()).filter(|row| !let_go.contains(row)).collect();
    let basis = null_space(jacobian.as_ref(), &held);
    if basis.ncols() == 0 {
        return None;
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
