//! Φ(q; h) = 0 for the coordinates q.
//!
//! A mechanism without free motion is solved by Φ_q alone: Φ_q Δq = −Φ.
//! Otherwise Δq is the smallest change that satisfies the same equations, so
//! that free motions stay as still as they can:
//! [D, Φ_qᵀ; Φ_q, 0] [Δq; μ] = [0; −Φ].

use super::linear::{LinearSolver, largest, solver};
use super::newton::Equations;
use crate::assembly::{Jacobian, Kkt, Numbering, Terms};
use crate::mechanism::Mechanism;
use crate::relation::{BODY_COORDINATES, Coordinates};
use crate::vector::norm;

enum Matrix {
    Determinate(Box<Jacobian>),
    LeastChange { kkt: Box<Kkt>, diagonal: Vec<f64> },
}

/// What makes metres and Euler parameters comparable.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales {
    /// The size of the mechanism (m): half the diagonal of the box around its points.
    pub length: f64,
}

impl Scales {
    pub fn of(mechanism: &Mechanism) -> Self {
        let mut diagonal = [0.0; 3];
        for (axis, extent) in diagonal.iter_mut().enumerate() {
            let coordinates = mechanism.points().iter().map(|point| point.position[axis]);
            let low = coordinates.clone().fold(f64::INFINITY, f64::min);
            *extent = (coordinates.fold(low, f64::max) - low).max(0.0);
        }
        let length = 0.5 * norm(diagonal);
        // All points in one place: a mechanism of rotations only.
        Self { length: if length > 1e-6 { length } else { 1.0 } }
    }

    /// A coordinate's own size: metres by the size of the mechanism, Euler parameters as they are.
    pub fn coordinate(&self, unknown: usize) -> f64 {
        if unknown % BODY_COORDINATES < 3 { self.length } else { 1.0 }
    }

    /// The largest scaled component of a change of coordinates.
    pub fn change(&self, change: &[f64]) -> f64 {
        change.iter().enumerate().fold(0.0, |largest: f64, (unknown, dq)| {
            largest.max(dq.abs() / self.coordinate(unknown))
        })
    }
}

/// The equations Φ = 0 with their coordinates and parameters.
pub(super) struct Position {
    matrix: Matrix,
    numbering: Numbering,
    pub scales: Scales,
    pub state: Vec<Coordinates<f64>>,
    pub h: Vec<f64>,
    // The size of each equation's terms, in the unit of the equation.
    sizes: Vec<f64>,
    phi: Vec<f64>,
    start: Vec<Coordinates<f64>>,
}

impl Position {
    pub fn new(
        terms: Terms,
        numbering: Numbering,
        scales: Scales,
        sizes: Vec<f64>,
        state: Vec<Coordinates<f64>>,
        h: Vec<f64>,
    ) -> Self {
        let unknowns = numbering.unknowns();
        let matrix = if numbering.kept().len() == unknowns {
            Matrix::Determinate(Box::new(Jacobian::new(terms, &numbering)))
        } else {
            Matrix::LeastChange {
                kkt: Box::new(Kkt::new(terms, &numbering)),
                diagonal: (0..unknowns)
                    .map(|unknown| scales.coordinate(unknown).powi(-2))
                    .collect(),
            }
        };
        Self {
            matrix,
            phi: vec![0.0; sizes.len()],
            sizes,
            start: state.clone(),
            numbering,
            scales,
            state,
            h,
        }
    }

    /// The same state with another choice of independent equations.
    pub fn with_equations(&self, terms: Terms, numbering: Numbering) -> Self {
        let (sizes, state, h) = (self.sizes.clone(), self.state.clone(), self.h.clone());
        Self::new(terms, numbering, self.scales, sizes, state, h)
    }

    /// A solver for the matrix.
    pub fn linear_solver(&self) -> Box<dyn LinearSolver> {
        solver(match &self.matrix {
            Matrix::Determinate(jacobian) => jacobian.pattern(),
            Matrix::LeastChange { kkt, .. } => kkt.pattern(),
        })
    }

    /// Length of right-hand sides and steps.
    pub fn size(&self) -> usize {
        match &self.matrix {
            Matrix::Determinate(_) => self.numbering.unknowns(),
            Matrix::LeastChange { kkt, .. } => kkt.pattern().rows(),
        }
    }

    /// Number of unknown coordinates, the first entries of a step.
    pub fn unknowns(&self) -> usize {
        self.numbering.unknowns()
    }

    /// The equations that are not left out.
    pub fn kept(&self) -> &[usize] {
        self.numbering.kept()
    }

    /// Which row each equation has.
    pub fn numbering(&self) -> &Numbering {
        &self.numbering
    }

    /// The size of each equation's terms.
    pub fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    /// Whether the sign of the determinant tells branches apart.
    pub fn determinate(&self) -> bool {
        matches!(self.matrix, Matrix::Determinate(_))
    }

    /// Writes the change of coordinates that goes with the change dh of the
    /// parameters, −Φ_q⁻¹ Φ_h dh, into the first entries of `tangent`. `linear`
    /// holds the factorisation at or near the state.
    pub fn tangent(
        &mut self,
        linear: &mut dyn LinearSolver,
        dh: &[f64],
        tangent: &mut [f64],
    ) -> Result<(), super::linear::Singular> {
        let terms = match &mut self.matrix {
            Matrix::Determinate(jacobian) => jacobian.terms(),
            Matrix::LeastChange { kkt, .. } => kkt.terms(),
        };
        terms.design_product(&self.state, &self.h, dh, &mut self.phi);
        self.right_side(tangent);
        linear.solve(tangent)
    }

    /// The equation with the largest relative residual, left-out ones included, and that residual.
    pub fn worst_equation(&mut self) -> (usize, f64) {
        self.evaluate();
        let relative = self.phi.iter().zip(&self.sizes);
        relative.map(|(phi, scale)| phi.abs() / scale).enumerate().fold(
            (0, 0.0),
            |worst, (equation, value)| {
                if value > worst.1 || value.is_nan() { (equation, value) } else { worst }
            },
        )
    }

    /// Φ of one equation at the last evaluation.
    pub fn phi(&self, equation: usize) -> f64 {
        self.phi[equation]
    }

    fn evaluate(&mut self) {
        let terms = match &mut self.matrix {
            Matrix::Determinate(jacobian) => jacobian.terms(),
            Matrix::LeastChange { kkt, .. } => kkt.terms(),
        };
        terms.residual(&self.state, &self.h, &mut self.phi);
    }

    fn relative_residual(&self) -> f64 {
        self.numbering.kept().iter().fold(0.0, |worst: f64, &equation| {
            let relative = self.phi[equation].abs() / self.sizes[equation];
            if relative.is_nan() { f64::INFINITY } else { worst.max(relative) }
        })
    }
}

impl Equations for Position {
    fn residual(&mut self) -> f64 {
        self.evaluate();
        self.relative_residual()
    }

    fn linearise(&mut self) -> f64 {
        match &mut self.matrix {
            Matrix::Determinate(jacobian) => jacobian.fill(&self.state, &self.h, &mut self.phi),
            Matrix::LeastChange { kkt, diagonal } => {
                kkt.fill_least_change(&self.state, &self.h, diagonal, &mut self.phi);
            }
        }
        self.relative_residual()
    }

    fn matrix(&self) -> &[f64] {
        match &self.matrix {
            Matrix::Determinate(jacobian) => jacobian.values(),
            Matrix::LeastChange { kkt, .. } => kkt.values(),
        }
    }

    fn right_side(&self, right_side: &mut [f64]) {
        right_side.fill(0.0);
        let first = right_side.len() - self.numbering.kept().len();
        for (row, &equation) in self.numbering.kept().iter().enumerate() {
            right_side[first + row] = -self.phi[equation];
        }
    }

    fn begin_step(&mut self) {
        self.start.copy_from_slice(&self.state);
    }

    fn take_step(&mut self, step: &[f64], fraction: f64) {
        move_bodies(&self.start, step, fraction, &mut self.state);
    }

    fn step_size(&self, step: &[f64]) -> f64 {
        let change = &step[..self.unknowns()];
        if largest(change).is_finite() { self.scales.change(change) } else { f64::INFINITY }
    }
}

/// Sets `state` to `start` plus `fraction` of `change` and makes the Euler
/// parameters of every moving body unit vectors again.
pub(super) fn move_bodies(
    start: &[Coordinates<f64>],
    change: &[f64],
    fraction: f64,
    state: &mut [Coordinates<f64>],
) {
    let changes = change.chunks_exact(BODY_COORDINATES);
    for ((to, from), dq) in state.iter_mut().zip(start).skip(1).zip(changes) {
        for ((to, from), dq) in to.iter_mut().zip(from).zip(dq) {
            *to = from + fraction * dq;
        }
        let p = &mut to[3..];
        let length = p.iter().map(|e| e * e).sum::<f64>().sqrt();
        p.iter_mut().for_each(|e| *e /= length);
    }
}
