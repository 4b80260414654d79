//! Steps one after the other.

use super::Dynamics;
use super::failure::DynamicsFailure;
use super::method::StepSize;
use super::step::StepFailure;
use crate::relation::BODY_COORDINATES;
use crate::vector::{norm, sub};

/// A rest of the way shorter than this part of a step is none.
const ROUNDING: f64 = 1e-6;

/// The factors by which an adaptive step changes at most.
const SHRINK: f64 = 0.3;
/// See [`SHRINK`].
const GROW: f64 = 2.0;

/// A step that could be longer by less than this factor stays: the factorisation can be kept.
const WORTHWHILE: f64 = 1.2;

/// No body of a vehicle gets farther than this from where it began (m, or sizes of the mechanism).
const FARTHEST: f64 = 1e3;

/// The part of the tolerance that steps aim for.
const SAFETY: f64 = 0.8;

impl Dynamics {
    /// Goes on to a time (s) and ends exactly there.
    ///
    /// # Errors
    /// [`DynamicsFailure`] where the motion cannot go on; the state is then the last one that was
    /// reached.
    pub fn advance_to(&mut self, time: f64) -> Result<(), DynamicsFailure> {
        if !(time >= self.now.time && time.is_finite()) {
            return Err(DynamicsFailure::Time { to: time, time: self.now.time });
        }
        while self.now.time < time {
            self.step_towards(time)?;
            self.check_distance()?;
        }
        Ok(())
    }

    /// Refuses bodies that have left for good, whose steps would only become ever shorter.
    fn check_distance(&self) -> Result<(), DynamicsFailure> {
        let bodies = self.mechanism.bodies().iter().zip(&self.now.state);
        for (body, q) in bodies.skip(1) {
            let distance = norm(sub([q[0], q[1], q[2]], body.origin));
            if distance > FARTHEST.max(FARTHEST * self.scales.length) {
                let (body, time) = (body.name.clone(), self.now.time);
                return Err(DynamicsFailure::RanAway { body, distance, time });
            }
        }
        Ok(())
    }

    /// Takes one accepted step that ends at or before a time (s).
    fn step_towards(&mut self, end: f64) -> Result<(), DynamicsFailure> {
        let mut replanned = false;
        loop {
            // Equal steps to the end, so that none is very short.
            let way = end - self.now.time;
            let count = (way / self.proposal - ROUNDING).ceil().max(1.0);
            let few = matches!(self.integrator.step, StepSize::Fixed(_)) || count <= 2.0;
            let dt = if few { way / count } else { self.proposal };
            match self.attempt(dt) {
                Ok(()) => {
                    if self.judge(dt)? {
                        if count == 1.0 {
                            self.next.time = end;
                        }
                        self.accept(dt);
                        return Ok(());
                    }
                }
                Err(failure) => {
                    self.report.rejected += 1;
                    // A mechanism with redundant equations may need others than at the start.
                    if !replanned && self.has_redundant() {
                        replanned = true;
                        if self.replan() {
                            continue;
                        }
                    }
                    self.shorten(dt, failure)?;
                }
            }
        }
    }

    fn has_redundant(&self) -> bool {
        (0..self.phi.len()).any(|equation| !self.is_held(equation) && !self.is_released(equation))
    }

    /// Halves the step after a failure of Newton's method.
    fn shorten(&mut self, dt: f64, failure: StepFailure) -> Result<(), DynamicsFailure> {
        if dt > 2.0 * self.integrator.smallest_step() {
            self.proposal = 0.5 * dt;
            return Ok(());
        }
        let time = self.now.time;
        let reason = match failure {
            StepFailure::LeftOut(equation) => DynamicsFailure::Inconsistent {
                equation: self.expansion.label(equation).to_owned(),
                residual: self.phi[equation],
                time,
            },
            StepFailure::Newton => match self.check_forces(time) {
                Err(reason) => reason,
                Ok(()) => {
                    let (equation, residual) = self.worst();
                    DynamicsFailure::NoConvergence { time, step: dt, equation, residual }
                }
            },
        };
        self.evaluate_now();
        Err(reason)
    }

    /// Whether the local error of a step is small enough; sets the length of the next one.
    fn judge(&mut self, dt: f64) -> Result<bool, DynamicsFailure> {
        let StepSize::Adaptive { tolerance, largest } = self.integrator.step else {
            // Shorter steps after a failure grow again.
            self.proposal = (2.0 * self.proposal).min(self.integrator.largest_step());
            return Ok(true);
        };
        let error = self.local_error(dt);
        // The error of a step goes with its third power.
        let factor = (SAFETY * tolerance / error.max(f64::MIN_POSITIVE)).cbrt();
        if error > tolerance {
            self.report.rejected += 1;
            if dt <= self.integrator.smallest_step() {
                let failure = DynamicsFailure::TooInexact { time: self.now.time, step: dt, error };
                self.evaluate_now();
                return Err(failure);
            }
            self.proposal = dt * factor.clamp(SHRINK, 0.9);
            return Ok(false);
        }
        // A step that was cut short by the end says nothing against longer ones.
        if factor < 1.0 {
            self.proposal = dt * factor.max(SHRINK);
        } else if dt * factor > WORTHWHILE * self.proposal {
            self.proposal = (dt * factor.min(GROW)).max(self.proposal).min(largest);
        }
        Ok(true)
    }

    /// The local error of the position, relative: the coefficient of the method times h² times the
    /// change of q̈ over the step, which is h times its derivative.
    fn local_error(&self, dt: f64) -> f64 {
        let mut largest: f64 = 0.0;
        let accelerations = self.now.acceleration.iter().zip(&self.next.acceleration);
        for (before, after) in accelerations {
            for k in 0..BODY_COORDINATES {
                largest = largest.max((after[k] - before[k]).abs() / self.scales.coordinate(k));
            }
        }
        self.coefficients.error() * dt * dt * largest
    }

    /// Makes `next` the present.
    fn accept(&mut self, dt: f64) {
        let ratio = dt / self.step;
        for body in 1..self.now.state.len() {
            for k in 0..BODY_COORDINATES {
                let before = self.now.acceleration[body][k];
                let before = before + ratio * (self.now.algorithmic[body][k] - before);
                self.slope[body][k] = (self.next.algorithmic[body][k] - before) / dt;
            }
        }
        let lambda = self.next.lambda.iter().zip(&self.now.lambda);
        for (slope, (after, before)) in self.lambda_slope.iter_mut().zip(lambda) {
            *slope = (after - before) / dt;
        }
        self.step = dt;
        std::mem::swap(&mut self.now, &mut self.next);
        self.kkt.elements_mut().accept();
        self.keep_ledger(dt);
    }

    /// Evaluates everything at the present again, after attempts that failed.
    fn evaluate_now(&mut self) {
        self.set_clock(self.now.time);
        let Self { now, h, phi, .. } = self;
        self.kkt.residual_in_motion(now.motion(), h, &now.lambda, phi);
    }
}
