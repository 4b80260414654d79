//! Which equations are independent, by dense factorisations at one state.
//!
//! This is set-up and error reporting, so it may be dense and may allocate.

use faer::{Mat, MatRef};

use super::position::Scales;
use crate::assembly::{Jacobian, Numbering, Terms};
use crate::mechanism::{Expansion, Owner};
use crate::relation::Coordinates;

/// A scaled pivot below this is zero: rounding leaves about 1e-15.
const ZERO: f64 = 1e-9;

/// The independent equations and the rest.
pub(super) struct Selection {
    /// Dependent equations of joints, to be left out.
    pub left_out: Vec<usize>,
    /// Equations of drivers that depend on joints and other drivers.
    pub blocked: Vec<usize>,
    /// The independent equations.
    pub kept: Vec<usize>,
    /// Rank of normalisations and joints together.
    pub joint_rank: usize,
}

/// Φ_q (all equations) without dimension: columns by [`Scales::coordinate`],
/// rows to length one. Also returns the length of each row before.
pub(super) fn scaled_jacobian(
    expansion: &Expansion,
    terms: &Terms,
    state: &[Coordinates<f64>],
    h: &[f64],
    scales: Scales,
) -> (Mat<f64>, Vec<f64>) {
    let numbering = Numbering::new(expansion, &[]);
    let mut jacobian = Jacobian::new(terms.clone(), &numbering);
    let mut phi = vec![0.0; expansion.equation_count()];
    jacobian.fill(state, h, &mut phi);
    let mut dense = Mat::zeros(phi.len(), numbering.unknowns());
    for (row, column, slot) in jacobian.pattern().entries() {
        dense[(row, column)] = jacobian.values()[slot] * scales.coordinate(column);
    }
    let lengths: Vec<f64> = (0..phi.len()).map(|row| dense.row(row).norm_l2()).collect();
    for (row, &length) in lengths.iter().enumerate() {
        if length > 0.0 {
            for column in 0..dense.ncols() {
                dense[(row, column)] /= length;
            }
        }
    }
    (dense, lengths)
}

/// Chooses independent equations: first the normalisations, then as many joint
/// equations as possible, then drivers. So only joint equations are ever left
/// out, and a driver that depends on the joints is found out.
pub(super) fn select(expansion: &Expansion, jacobian: MatRef<'_, f64>) -> Selection {
    let of = |wanted: fn(Owner) -> bool| -> Vec<usize> {
        (0..expansion.equation_count())
            .filter(|&equation| wanted(expansion.owner(equation)))
            .collect()
    };
    let mut basis = Mat::zeros(jacobian.ncols(), 0);
    let mut kept = vec![];
    let mut stage = |equations: &[usize]| extend(&mut basis, &mut kept, jacobian, equations);
    stage(&of(|owner| matches!(owner, Owner::Body(_))));
    let left_out = stage(&of(|owner| matches!(owner, Owner::Joint(_))));
    let drivers = of(|owner| matches!(owner, Owner::Driver(_)));
    let blocked = stage(&drivers);
    let joint_rank = kept.len() - (drivers.len() - blocked.len());
    Selection { left_out, blocked, kept, joint_rank }
}

/// Adds the independent ones of `equations` to `kept` and to the orthonormal
/// basis of their span; returns the others.
fn extend(
    basis: &mut Mat<f64>,
    kept: &mut Vec<usize>,
    jacobian: MatRef<'_, f64>,
    equations: &[usize],
) -> Vec<usize> {
    if equations.is_empty() {
        return vec![];
    }
    let mut rest = Mat::from_fn(jacobian.ncols(), equations.len(), |unknown, k| {
        jacobian[(equations[k], unknown)]
    });
    // Twice is enough to be orthogonal to rounding.
    for _ in 0..2 {
        rest = &rest - &*basis * (basis.transpose() * &rest);
    }
    let factors = rest.col_piv_qr();
    let upper = factors.thin_R();
    let rank = (0..upper.nrows()).take_while(|&k| upper[(k, k)].abs() > ZERO).count();
    let thin = factors.compute_thin_Q();
    *basis = Mat::from_fn(basis.nrows(), basis.ncols() + rank, |row, column| {
        match column.checked_sub(basis.ncols()) {
            Some(new) => thin[(row, new)],
            None => basis[(row, column)],
        }
    });
    let order = factors.P().arrays().0;
    kept.extend(order[..rank].iter().map(|&k| equations[k]));
    let mut dependent: Vec<usize> = order[rank..].iter().map(|&k| equations[k]).collect();
    dependent.sort_unstable();
    dependent
}

/// The kept equations that a dependent one is a combination of.
pub(super) fn holders(jacobian: MatRef<'_, f64>, kept: &[usize], dependent: usize) -> Vec<usize> {
    use faer::linalg::solvers::SolveLstsq;
    let columns =
        Mat::from_fn(jacobian.ncols(), kept.len(), |unknown, k| jacobian[(kept[k], unknown)]);
    let right_side = Mat::from_fn(jacobian.ncols(), 1, |unknown, _| jacobian[(dependent, unknown)]);
    let weights = columns.qr().solve_lstsq(&right_side);
    (0..kept.len()).filter(|&k| weights[(k, 0)].abs() > 1e-6).map(|k| kept[k]).collect()
}

/// The equations whose multipliers are not determined at a state: those that are left out as
/// redundant, and those that hold the same with them.
pub(super) fn undetermined(
    expansion: &Expansion,
    terms: &Terms,
    state: &[Coordinates<f64>],
    h: &[f64],
    (kept, scales): (&[usize], Scales),
) -> Vec<usize> {
    let left_out = |equation: &usize| !kept.contains(equation);
    let mut found: Vec<usize> = (0..expansion.equation_count()).filter(left_out).collect();
    if !found.is_empty() {
        let (jacobian, _) = scaled_jacobian(expansion, terms, state, h, scales);
        let holders = |&equation: &usize| holders(jacobian.as_ref(), kept, equation);
        found = found
            .iter()
            .flat_map(|equation| [vec![*equation], holders(equation)].concat())
            .collect();
    }
    found
}

/// An orthonormal basis of the motions (columns, scaled) that the kept equations allow: what the full
/// orthogonal factor of their transpose has behind their span.
pub(super) fn null_space(jacobian: MatRef<'_, f64>, kept: &[usize]) -> Mat<f64> {
    let unknowns = jacobian.ncols();
    let columns = Mat::from_fn(unknowns, kept.len(), |unknown, k| jacobian[(kept[k], unknown)]);
    let orthogonal = columns.qr().compute_Q();
    orthogonal.subcols(kept.len(), unknowns - kept.len()).to_owned()
}

/// The smallest singular value that is not zero by redundancy, with its left
/// vector (by equation) and its right vector (by unknown).
pub(super) fn weakest(jacobian: MatRef<'_, f64>, rank: usize) -> Option<(f64, Vec<f64>, Vec<f64>)> {
    let factors = jacobian.thin_svd().ok()?;
    let last = rank.min(jacobian.ncols()).checked_sub(1)?;
    let column = |matrix: MatRef<'_, f64>| (0..matrix.nrows()).map(|k| matrix[(k, last)]).collect();
    Some((factors.S().column_vector()[last], column(factors.U()), column(factors.V())))
}
