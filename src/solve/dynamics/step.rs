//! One step of the generalised-α method.

use super::method::Coefficients;
use super::{Dynamics, Snapshot};
use crate::assembly::{Blend, Kkt, Numbering};
use crate::relation::BODY_COORDINATES;
use crate::solve::linear::solver;
use crate::solve::position::Scales;
use crate::solve::rank::{scaled_jacobian, select};

/// Newton iterations of one step.
const ITERATIONS: usize = 12;

/// Largest error of the accelerations that is left, relative to the largest of them.
const TOLERANCE: f64 = 1e-10;

/// Largest error of the position that is left, relative.
const CLOSED: f64 = 1e-12;

/// What rounding of relative positions leaves in a change of them.
const ROUNDING: f64 = 2e-15;

/// An iteration that stands still below this relative change of the position has reached what
/// rounding allows.
const STANDSTILL: f64 = 1e-12;

/// A matrix is made anew when a correction is larger than this part of the one before.
const SLOW: f64 = 0.1;

/// A matrix is made anew when the step has changed by more than this part.
const OTHER_STEP: f64 = 1e-6;

/// Largest accepted relative residual of an equation that is left out as redundant.
const CONSISTENT: f64 = 1e-9;

/// Why a step failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StepFailure {
    /// Newton's method does not converge.
    Newton,
    /// A left-out equation is violated.
    LeftOut(usize),
}

impl Dynamics {
    /// Tries a step from `now` to `next`.
    pub(super) fn attempt(&mut self, dt: f64) -> Result<(), StepFailure> {
        self.set_clock(self.now.time + dt);
        self.predict(dt);
        self.correct(dt)?;
        let Self { next, h, phi, .. } = self;
        self.kkt.residual_in_motion(next.motion(), h, &next.lambda, phi);
        for equation in 0..self.phi.len() {
            if self.numbering.row(equation).is_none() && !self.is_released(equation) {
                let relative = (self.phi[equation] / self.sizes[equation]).abs();
                if relative.is_nan() || relative > CONSISTENT {
                    return Err(StepFailure::LeftOut(equation));
                }
            }
        }
        Ok(())
    }

    /// Begins `next` with accelerations and multipliers that go on as they changed before.
    fn predict(&mut self, dt: f64) {
        let Coefficients { beta, gamma, .. } = self.coefficients;
        let [new, carried, before] = self.coefficients.weights();
        let ratio = dt / self.step;
        let Self { now, next, slope, lambda_slope, .. } = self;
        next.time = now.time + dt;
        for body in 1..now.state.len() {
            for k in 0..BODY_COORDINATES {
                let true_acceleration = now.acceleration[body][k];
                // The algorithmic acceleration stands for a time that moves with the step.
                let lead = now.algorithmic[body][k] - true_acceleration;
                let a0 = true_acceleration + ratio * lead;
                let a1 = a0 + dt * slope[body][k];
                let v = now.velocity[body][k];
                next.algorithmic[body][k] = a1;
                next.acceleration[body][k] = new * a1 + carried * a0 - before * true_acceleration;
                next.velocity[body][k] = v + dt * ((1.0 - gamma) * a0 + gamma * a1);
                next.state[body][k] =
                    now.state[body][k] + dt * (v + dt * ((0.5 - beta) * a0 + beta * a1));
            }
        }
        for ((to, from), slope) in next.lambda.iter_mut().zip(&now.lambda).zip(&*lambda_slope) {
            *to = from + dt * slope;
        }
    }

    /// Newton's method for a₁ and λ₁. With the second block row divided by βh², the matrix
    /// [M̂ + γh C + βh² K, Φ_qᵀ; Φ_q, 0] keeps its condition however short the step is. The matrix is
    /// kept as long as the corrections fall fast.
    fn correct(&mut self, dt: f64) -> Result<(), StepFailure> {
        let Coefficients { beta, gamma, .. } = self.coefficients;
        let (to_q, to_v) = (beta * dt * dt, gamma * dt);
        let [mass, ..] = self.coefficients.weights();
        let blend = Blend { stiffness: to_q, damping: to_v, mass };
        let mut stale = (self.matrix.step - dt).abs() > OTHER_STEP * dt;
        let mut before = f64::INFINITY;
        for _ in 0..ITERATIONS {
            self.report.iterations += 1;
            let made = stale;
            {
                let Self { kkt, next, h, phi, .. } = self;
                if stale {
                    kkt.fill_in_motion(next.motion(), h, &next.lambda, blend, phi);
                } else {
                    kkt.residual_in_motion(next.motion(), h, &next.lambda, phi);
                }
            }
            if stale {
                self.report.factorisations += 1;
                self.matrix.step = 0.0;
                self.linear.factorise(self.kkt.values()).map_err(|_| StepFailure::Newton)?;
                self.matrix.step = dt;
                stale = false;
            }
            self.write_right_side(to_q);
            self.linear.solve(&mut self.right_side).map_err(|_| StepFailure::Newton)?;
            let change = self.apply(to_q, to_v, mass);
            if !change.is_finite() {
                return Err(StepFailure::Newton);
            }
            let (size, position) = sizes(&self.next, self.scales);
            let target = (TOLERANCE * size).min(CLOSED * position / to_q);
            let target = target.max(ROUNDING * position / to_q);
            // Before the second correction nothing is known about how fast they fall.
            let rate = if before.is_finite() { change / before } else { SLOW };
            if change <= target || (rate < SLOW && rate * change <= target) {
                return Ok(());
            }
            if rate > SLOW {
                if change * to_q <= STANDSTILL * position && rate > 0.5 {
                    return Ok(());
                }
                if made && rate > 2.0 {
                    return Err(StepFailure::Newton);
                }
                stale = true;
            }
            before = change;
        }
        Err(StepFailure::Newton)
    }

    fn write_right_side(&mut self, to_q: f64) {
        let (force, constraints) = self.right_side.split_at_mut(self.numbering.unknowns());
        for (out, (load, force)) in force.iter_mut().zip(self.load.iter().zip(self.kkt.force())) {
            *out = load - force;
        }
        for (out, &equation) in constraints.iter_mut().zip(self.numbering.kept()) {
            *out = -self.phi[equation] / to_q;
        }
    }

    /// Adds the correction that the right-hand side holds; returns its largest acceleration, scaled.
    fn apply(&mut self, to_q: f64, to_v: f64, mass: f64) -> f64 {
        let Self { next, right_side, numbering, scales, .. } = self;
        let (accelerations, multipliers) = right_side.split_at(numbering.unknowns());
        let mut largest: f64 = 0.0;
        for (body, change) in (1..).zip(accelerations.chunks_exact(BODY_COORDINATES)) {
            for (k, &da) in change.iter().enumerate() {
                next.algorithmic[body][k] += da;
                next.acceleration[body][k] += mass * da;
                next.velocity[body][k] += to_v * da;
                next.state[body][k] += to_q * da;
                let size = da.abs() / scales.coordinate(k);
                largest = if size.is_nan() { f64::INFINITY } else { largest.max(size) };
            }
        }
        for (change, &equation) in multipliers.iter().zip(numbering.kept()) {
            next.lambda[equation] += change;
        }
        largest
    }

    /// Chooses independent equations at the current state; returns whether that changed anything.
    /// Equations that are independent at the start may depend on each other elsewhere while left-out
    /// ones do not.
    pub(super) fn replan(&mut self) -> bool {
        self.set_clock(self.now.time);
        let state = &self.now.state;
        let (jacobian, _) =
            scaled_jacobian(&self.expansion, &self.terms, state, &self.h, self.scales);
        let selection = select(&self.expansion, jacobian.as_ref());
        let mut left_out = selection.left_out;
        if left_out.iter().all(|&equation| !self.is_held(equation)) {
            return false;
        }
        left_out.extend((0..self.phi.len()).filter(|&equation| self.is_released(equation)));
        let numbering = Numbering::new(&self.expansion, &left_out);
        if numbering.kept().len() != self.numbering.kept().len() {
            return false;
        }
        let (elements, inertias) = (self.kkt.elements().clone(), self.kkt.inertias().clone());
        self.kkt = Kkt::with_forces(self.terms.clone(), elements, inertias, &numbering);
        self.linear = solver(self.kkt.pattern());
        self.numbering = numbering;
        self.lambda_slope.fill(0.0);
        // The accelerations stay as they are; only the multipliers are shared out anew.
        let acceleration = self.now.acceleration.clone();
        let determined = self.accelerate().is_ok();
        self.now.acceleration = acceleration;
        determined
    }

    /// The equation with the largest relative residual of the last attempt, or the body with the
    /// largest residual of forces where all equations hold.
    pub(super) fn worst(&self) -> (String, f64) {
        let worse = |worst: (usize, f64), (index, value): (usize, f64)| {
            if value.is_nan() || value > worst.1 { (index, value) } else { worst }
        };
        let relative = self.phi.iter().zip(&self.sizes).map(|(phi, size)| (phi / size).abs());
        let held = relative.enumerate().filter(|&(equation, _)| !self.is_released(equation));
        let (equation, residual) = held.fold((0, 0.0), worse);
        if residual > CONSISTENT {
            return (self.expansion.label(equation).to_owned(), residual);
        }
        let forces = self.load.iter().zip(self.kkt.force()).zip(self.kkt.magnitude());
        let forces = forces.map(|((load, force), size)| {
            (load - force).abs() / size.max(load.abs()).max(f64::MIN_POSITIVE)
        });
        let (unknown, force) = forces.enumerate().fold((0, 0.0), worse);
        let body = &self.mechanism.bodies()[unknown / BODY_COORDINATES + 1];
        (format!("the balance of forces on {}", body.name), force)
    }
}

/// The largest acceleration and the largest position, scaled; a position is at least one.
fn sizes(snapshot: &Snapshot, scales: Scales) -> (f64, f64) {
    let (mut acceleration, mut position): (f64, f64) = (0.0, 1.0);
    for (a, q) in snapshot.algorithmic.iter().zip(&snapshot.state).skip(1) {
        for k in 0..BODY_COORDINATES {
            acceleration = acceleration.max(a[k].abs() / scales.coordinate(k));
            position = position.max(q[k].abs() / scales.coordinate(k));
        }
    }
    (acceleration, position)
}
