//! The minimum of a quadratic model on the planes of an active set, by the null-space method.

use faer::linalg::solvers::Solve;
use faer::{Col, Mat, Scale, Side};

use super::model::Model;

/// A row that is relatively nearer than this to the span of others depends on them.
const DEPENDENT: f64 = 1e-10;
/// By how much the reduced Hessian is damped for its factorisation, relative to its diagonal.
const DAMPING: f64 = 1e-10;
/// The curvature of a model without any, relative to the gradient.
const FLAT: f64 = 1e-8;
/// Conjugate gradients end after so many steps, or when the gradient in the norm of the inverse
/// Hessian has fallen by this factor, squared; what is left is rounding.
const DIRECTIONS: usize = 12;
const REFINED: f64 = 1e-16;
/// A dependent row may be missed by this much, in typical changes.
const INCONSISTENT: f64 = 1e-9;

/// Planes a step has to end on.
pub(super) struct Planes<'a> {
    /// The value of each component of the step that is held.
    pub held: &'a [Option<f64>],
    /// Rows of constraints with the value that they are to have.
    pub rows: &'a [(usize, f64)],
    /// The gradient of penalties that are linear there.
    pub push: &'a Col<f64>,
}

/// Where the model is least on the planes.
pub(super) struct Solution {
    pub step: Col<f64>,
    /// One for each row of the planes; zero for dependent ones.
    pub row_multipliers: Vec<f64>,
    /// Gradient of the Lagrangian: zero for free components, the multiplier for those held.
    pub remainder: Col<f64>,
}

/// Why there is no minimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NoMinimum {
    /// The planes have no point in common.
    Inconsistent,
    /// The model falls without end, or nothing is finite.
    Unbounded,
}

/// Finds the minimum.
pub(super) fn minimise(model: &Model, planes: &Planes) -> Result<Solution, NoMinimum> {
    let free: Vec<usize> = (0..planes.held.len()).filter(|&j| planes.held[j].is_none()).collect();
    let mut step = Col::from_fn(planes.held.len(), |j| planes.held[j].unwrap_or(0.0));
    let normals = Normals::new(model, planes, &free);

    let moved = normals.onto_planes(model, planes, &step)?;
    scatter(&mut step, &free, &moved);
    let reduced = Reduced::new(model, &free, &normals)?;
    reduced.descend(model, planes, &free, &mut step);

    let mut remainder = model.gradient_at(&step) + planes.push;
    let row_multipliers = normals.multipliers(&gather(&remainder, &free));
    for (&(row, _), &multiplier) in planes.rows.iter().zip(&row_multipliers) {
        for j in 0..step.nrows() {
            remainder[j] -= multiplier * model.point.rows[(row, j)];
        }
    }
    let finite = step.is_all_finite() && remainder.is_all_finite();
    if finite {
        Ok(Solution { step, row_multipliers, remainder })
    } else {
        Err(NoMinimum::Unbounded)
    }
}

fn gather(full: &Col<f64>, free: &[usize]) -> Col<f64> {
    Col::from_fn(free.len(), |k| full[free[k]])
}

fn scatter(full: &mut Col<f64>, free: &[usize], add: &Col<f64>) {
    for (k, &j) in free.iter().enumerate() {
        full[j] += add[k];
    }
}

/// An orthogonal factorisation N P = Q R of the normals of the planes, as columns of length one.
struct Normals {
    q: Mat<f64>,
    r: Mat<f64>,
    /// The plane that each column of R belongs to; the first `rank` are independent.
    order: Vec<usize>,
    lengths: Vec<f64>,
    rank: usize,
}

impl Normals {
    fn new(model: &Model, planes: &Planes, free: &[usize]) -> Self {
        let rows = &model.point.rows;
        let mut normals =
            Mat::from_fn(free.len(), planes.rows.len(), |k, i| rows[(planes.rows[i].0, free[k])]);
        let lengths: Vec<f64> = (0..normals.ncols())
            .map(|i| {
                let length = normals.col(i).norm_l2();
                // A row that the free components leave alone is zero, whatever rounding leaves of it.
                let whole = rows.row(planes.rows[i].0).norm_l2();
                if length > DEPENDENT * whole { length } else { f64::INFINITY }
            })
            .collect();
        for (i, &length) in lengths.iter().enumerate() {
            for k in 0..free.len() {
                normals[(k, i)] /= length;
            }
        }
        if planes.rows.is_empty() || free.is_empty() {
            let q = Mat::identity(free.len(), free.len());
            let order = (0..planes.rows.len()).collect();
            return Self { q, r: Mat::zeros(0, 0), order, lengths, rank: 0 };
        }
        let factors = normals.col_piv_qr();
        let r = factors.R().to_owned();
        let rank =
            (0..r.nrows().min(r.ncols())).take_while(|&k| r[(k, k)].abs() > DEPENDENT).count();
        let order = factors.P().arrays().0.to_vec();
        Self { q: factors.compute_Q(), r, order, lengths, rank }
    }

    /// The shortest way of the free components from a step onto the planes.
    fn onto_planes(
        &self,
        model: &Model,
        planes: &Planes,
        step: &Col<f64>,
    ) -> Result<Col<f64>, NoMinimum> {
        let rows = &model.point.rows;
        let missing: Vec<f64> =
            (planes.rows.iter()).map(|&(row, value)| value - rows.row(row) * step).collect();
        let mut weights = vec![0.0; self.rank];
        for k in 0..self.rank {
            let done: f64 = (0..k).map(|l| self.r[(l, k)] * weights[l]).sum();
            let plane = self.order[k];
            weights[k] = (missing[plane] / self.lengths[plane] - done) / self.r[(k, k)];
        }
        for (k, &plane) in self.order.iter().enumerate().skip(self.rank) {
            let length = self.lengths[plane];
            let reached: f64 = (0..self.rank).map(|l| self.r[(l, k)] * weights[l]).sum();
            let left =
                if length.is_finite() { missing[plane] - reached * length } else { missing[plane] };
            if left.abs() > INCONSISTENT {
                return Err(NoMinimum::Inconsistent);
            }
        }
        let free = self.q.nrows();
        Ok(Col::from_fn(free, |j| (0..self.rank).map(|k| self.q[(j, k)] * weights[k]).sum()))
    }

    /// The multipliers that leave least of a gradient of the free components.
    fn multipliers(&self, gradient: &Col<f64>) -> Vec<f64> {
        let mut multipliers = vec![0.0; self.lengths.len()];
        for k in (0..self.rank).rev() {
            let along: f64 = (0..gradient.nrows()).map(|j| self.q[(j, k)] * gradient[j]).sum();
            let known: f64 =
                (k + 1..self.rank).map(|l| self.r[(k, l)] * multipliers[self.order[l]]).sum();
            multipliers[self.order[k]] = (along - known) / self.r[(k, k)];
        }
        for (multiplier, length) in multipliers.iter_mut().zip(&self.lengths) {
            *multiplier /= length;
        }
        multipliers
    }
}

/// The Hessian in the null space of the planes, factorised.
struct Reduced {
    /// Columns of the null space, each divided by the square root of its curvature.
    basis: Mat<f64>,
    factors: Option<faer::linalg::solvers::Llt<f64>>,
}

impl Reduced {
    fn new(model: &Model, free: &[usize], normals: &Normals) -> Result<Self, NoMinimum> {
        let (count, dimension) = (free.len(), free.len() - normals.rank);
        let mut basis = Mat::from_fn(count, dimension, |j, k| normals.q[(j, normals.rank + k)]);
        if dimension == 0 {
            return Ok(Self { basis, factors: None });
        }
        let hessian = Mat::from_fn(count, count, |j, k| model.hessian[(free[j], free[k])]);
        let reduced = basis.transpose() * &hessian * &basis;
        let diagonal = (0..dimension).map(|k| reduced[(k, k)]);
        let (least, largest) = diagonal.fold((0.0f64, 0.0f64), |(least, largest), value| {
            (least.min(value), largest.max(value))
        });
        if largest == 0.0 && least < 0.0 {
            return Err(NoMinimum::Unbounded);
        }
        // Where nothing bends, a slope leads far enough to meet a limit.
        let flat = FLAT * model.point.gradient().norm_max();
        // Scaling by the diagonal is nearly the best there is (van der Sluis, Numer. Math. 14 (1969)).
        let floor = (f64::EPSILON * largest).max(if largest == 0.0 { flat } else { 0.0 });
        let floor = if floor > 0.0 { floor } else { 1.0 };
        let scales: Vec<f64> =
            (0..dimension).map(|k| 1.0 / reduced[(k, k)].max(floor).sqrt()).collect();
        let scaled = Mat::from_fn(dimension, dimension, |k, l| {
            let damping = if largest == 0.0 { 1.0 } else { DAMPING };
            let damping = if k == l { damping } else { 0.0 };
            reduced[(k, l)] * scales[k] * scales[l] + damping
        });
        for k in 0..dimension {
            for j in 0..count {
                basis[(j, k)] *= scales[k];
            }
        }
        let factors = scaled.llt(Side::Lower).map_err(|_| NoMinimum::Unbounded)?;
        Ok(Self { basis, factors: Some(factors) })
    }

    /// Goes to the minimum by conjugate gradients (Nocedal and Wright, algorithm 5.3) with the damped
    /// factorisation as preconditioner. One step is nearly all; the next ones undo what damping and
    /// the squared condition of JᵀJ have spoilt, as far as rounding allows.
    fn descend(&self, model: &Model, planes: &Planes, free: &[usize], step: &mut Col<f64>) {
        let Some(factors) = &self.factors else { return };
        let mut direction = Col::<f64>::zeros(self.basis.ncols());
        let (mut first, mut last) = (0.0, 0.0);
        for count in 0..DIRECTIONS {
            let gradient = model.gradient_at(step) + planes.push;
            let gradient = self.basis.transpose() * gather(&gradient, free);
            let newton = factors.solve(&gradient);
            let size: f64 = gradient.transpose() * &newton;
            if count == 0 {
                first = size;
            } else if size <= REFINED * first {
                return;
            }
            let ratio = if count == 0 { 0.0 } else { size / last };
            last = size;
            direction = Scale(ratio) * direction - newton;
            let mut along = Col::zeros(step.nrows());
            scatter(&mut along, free, &(&self.basis * &direction));
            let bend = model.bend(&along);
            let slope: f64 = gradient.transpose() * &direction;
            if slope >= 0.0 || bend <= 0.0 {
                // A flat direction: the damped step is the one to take.
                if count == 0 {
                    *step += along;
                }
                return;
            }
            *step += Scale(-slope / bend) * along;
        }
    }
}
