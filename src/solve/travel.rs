//! Continuation along driver values.
//!
//! A motion from one set of driver values to another is a path q(t), 0 ≤ t ≤ 1.
//! Each step predicts along the tangent, corrects with Newton's method and asks
//! whether it stayed on the branch; if not, the step is halved.

use super::convergence::{Outcome, Status, Tolerances};
use super::linear::{LinearSolver, Singular};
use super::newton::{Equations, newton};
use super::position::{Position, move_bodies};
use super::system::StepReport;
use crate::mechanism::{DriverId, DriverSlots};
use crate::relation::Coordinates;

/// The corrector: few iterations, each step much shorter than the one before.
const CORRECTOR: Tolerances =
    Tolerances { step: 1e-9, residual: 1e-12, iterations: 8, contraction: 0.1 };

/// The shortest step, as a part of the motion.
const SHORTEST: f64 = 1e-10;

/// Largest first correction as a part of the predicted step.
const CORRECTION: f64 = 0.2;

/// Smallest accepted cosine of the angle between the tangents before and after a step. Two parts of
/// a path with a short gap between them differ in it, although both are on the same branch.
const STRAIGHT: f64 = 0.95;

/// Scaled changes below this are small: neither the size of a correction nor the
/// angle between tangents says anything about branches then.
const SMALL: f64 = 1e-3;

/// Largest accepted relative residual of a left-out equation.
const CONSISTENT: f64 = 1e-9;

/// Why a step was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Failure {
    /// The corrector did not converge.
    Corrector {
        /// The equation with the largest residual.
        equation: usize,
        relative_residual: f64,
    },
    /// The matrix became singular.
    Singular,
    /// The step left the branch: the determinant changed its sign or the path bent too far.
    LeftBranch,
    /// A left-out equation is no longer satisfied.
    Inconsistent { equation: usize, value: f64 },
}

/// Where the factorisation that the linear solver holds belongs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Factorised {
    /// Nowhere near the current state.
    Elsewhere,
    /// At the last iterate before the current state, a tiny step away.
    Near,
    /// At the current state.
    Here,
}

/// The state of a continuation and its scratch space.
pub(super) struct Travel {
    linear: Box<dyn LinearSolver>,
    slots: DriverSlots,
    values: Vec<f64>,
    start_values: Vec<f64>,
    dh: Vec<f64>,
    start: Vec<Coordinates<f64>>,
    tangent: Vec<f64>,
    next_tangent: Vec<f64>,
    step: Vec<f64>,
    factorised: Factorised,
    check_left_out: bool,
}

impl Travel {
    pub fn new(
        position: &Position,
        slots: DriverSlots,
        drivers: usize,
        check_left_out: bool,
    ) -> Self {
        let size = position.size();
        Self {
            linear: position.linear_solver(),
            values: vec![0.0; drivers],
            start_values: vec![0.0; drivers],
            dh: vec![0.0; position.h.len()],
            start: position.state.clone(),
            tangent: vec![0.0; size],
            next_tangent: vec![0.0; size],
            step: vec![0.0; size],
            factorised: Factorised::Elsewhere,
            check_left_out,
            slots,
        }
    }

    /// The values that the drivers have reached.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Says that state and parameters are those with all drivers at zero again.
    pub fn reset(&mut self) {
        self.values.fill(0.0);
        self.factorised = Factorised::Elsewhere;
    }

    /// Says that `position` has another choice of independent equations.
    pub fn replan(&mut self, position: &Position) {
        self.linear = position.linear_solver();
        self.factorised = Factorised::Elsewhere;
    }

    /// How far the drivers still have to go, in their own units.
    pub fn remaining(&self, targets: &[f64]) -> f64 {
        let ways = self.values.iter().zip(targets);
        ways.fold(0.0, |remaining, (value, target)| remaining.max((target - value).abs()))
    }

    /// Moves the drivers from their values to `targets`. On failure state,
    /// parameters and values are the last that were reached.
    pub fn move_to(
        &mut self,
        position: &mut Position,
        design: &[f64],
        targets: &[f64],
        report: &mut StepReport,
    ) -> Result<(), Failure> {
        if self.values == targets {
            report.relative_residual = position.residual();
            return Ok(());
        }
        self.start_values.copy_from_slice(&self.values);
        self.dh.fill(0.0);
        let ways = self.values.iter().zip(targets).map(|(from, to)| to - from).enumerate();
        self.slots.add(ways.map(|(driver, way)| (DriverId(driver), way)), &mut self.dh);
        let sign = self.first_tangent(position).map_err(|Singular| Failure::Singular)?;
        self.factorised = Factorised::Near;

        let (mut t, mut dt): (f64, f64) = (0.0, 1.0);
        while t < 1.0 {
            let next = if t + dt >= 1.0 - SHORTEST { 1.0 } else { t + dt };
            self.start.copy_from_slice(&position.state);
            let outcome = self.step(position, design, targets, [t, next], sign, report);
            match outcome {
                Ok(outcome) => {
                    std::mem::swap(&mut self.tangent, &mut self.next_tangent);
                    report.steps += 1;
                    report.relative_residual = outcome.relative_residual;
                    (t, dt) = (next, 2.0 * dt);
                }
                Err(failure) => {
                    position.state.copy_from_slice(&self.start);
                    self.set_drivers(position, design, targets, t);
                    dt = 0.5 * (next - t);
                    if dt < SHORTEST {
                        self.factorised = Factorised::Elsewhere;
                        return Err(failure);
                    }
                }
            }
        }
        Ok(())
    }

    /// One predictor, one corrector, and the questions whether it stayed on the branch.
    fn step(
        &mut self,
        position: &mut Position,
        design: &[f64],
        targets: &[f64],
        [t, next]: [f64; 2],
        sign: f64,
        report: &mut StepReport,
    ) -> Result<Outcome, Failure> {
        let dt = next - t;
        move_bodies(&self.start, &self.tangent, dt, &mut position.state);
        self.set_drivers(position, design, targets, next);
        let outcome = newton(position, self.linear.as_mut(), &CORRECTOR, &mut self.step);
        report.iterations += outcome.iterations;
        if !outcome.converged() {
            return Err(match outcome.status {
                Status::Singular => Failure::Singular,
                _ => {
                    let (equation, relative_residual) = position.worst_equation();
                    Failure::Corrector { equation, relative_residual }
                }
            });
        }
        let unknowns = position.unknowns();
        let predicted = dt * position.scales.change(&self.tangent[..unknowns]);
        if outcome.first_step > SMALL.max(CORRECTION * predicted) {
            return Err(Failure::LeftBranch);
        }
        if position.determinate() && self.linear.determinant_sign() != sign {
            return Err(Failure::LeftBranch);
        }
        // The factorisation of the last iteration is as good as that of the
        // state itself, because the last step was tiny.
        position
            .tangent(self.linear.as_mut(), &self.dh, &mut self.next_tangent)
            .map_err(|Singular| Failure::Singular)?;
        let change = dt * position.scales.change(&self.next_tangent[..unknowns]);
        if predicted.max(change) > SMALL && self.cosine(position) < STRAIGHT {
            return Err(Failure::LeftBranch);
        }
        if self.check_left_out {
            let (equation, relative) = position.worst_equation();
            if relative.is_nan() || relative > CONSISTENT {
                let value = position.phi(equation);
                return Err(Failure::Inconsistent { equation, value });
            }
        }
        Ok(outcome)
    }

    /// The tangent at the current state; returns the sign of the determinant.
    fn first_tangent(&mut self, position: &mut Position) -> Result<f64, Singular> {
        if self.factorised == Factorised::Elsewhere {
            self.factorise(position)?;
        }
        position.tangent(self.linear.as_mut(), &self.dh, &mut self.tangent)?;
        Ok(self.linear.determinant_sign())
    }

    /// The rates of all unknowns per unit of one driver at the current state. A result and not a
    /// prediction, so the factorisation has to be that of the very state.
    pub fn driver_tangent(
        &mut self,
        position: &mut Position,
        driver: DriverId,
    ) -> Result<&[f64], Singular> {
        self.factorised_here(position)?;
        self.dh.fill(0.0);
        self.slots.add([(driver, 1.0)], &mut self.dh);
        position.tangent(self.linear.as_mut(), &self.dh, &mut self.next_tangent)?;
        Ok(&self.next_tangent[..position.unknowns()])
    }

    /// The solver with the matrix of the current state.
    pub fn factorised_here(
        &mut self,
        position: &mut Position,
    ) -> Result<&mut dyn LinearSolver, Singular> {
        if self.factorised != Factorised::Here {
            self.factorise(position)?;
        }
        Ok(self.linear.as_mut())
    }

    fn factorise(&mut self, position: &mut Position) -> Result<(), Singular> {
        self.factorised = Factorised::Elsewhere;
        position.linearise();
        self.linear.factorise(position.matrix())?;
        self.factorised = Factorised::Here;
        Ok(())
    }

    fn set_drivers(&mut self, position: &mut Position, design: &[f64], targets: &[f64], t: f64) {
        for (value, (from, to)) in self.values.iter_mut().zip(self.start_values.iter().zip(targets))
        {
            *value = if t == 1.0 { *to } else { from + t * (to - from) };
        }
        self.slots.set(design, &self.values, &mut position.h);
    }

    /// The cosine of the angle between the tangents before and after a step.
    fn cosine(&self, position: &Position) -> f64 {
        let (mut product, mut before, mut after) = (0.0, 0.0, 0.0);
        for unknown in 0..position.unknowns() {
            let scale = position.scales.coordinate(unknown);
            let a = self.tangent[unknown] / scale;
            let b = self.next_tangent[unknown] / scale;
            product += a * b;
            before += a * a;
            after += b * b;
        }
        product / (before * after).sqrt()
    }
}
