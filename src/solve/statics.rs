//! The robust way to a static equilibrium, and why there is none.
//!
//! First the out-of-balance loads of the start are taken away and put back in steps, as large as
//! Newton's method takes them: usually one. Where that path ends, the mechanism is let go as in a
//! very viscous fluid until it is near its resting place. A solution counts only if it is stable.

use thiserror::Error;

use super::convergence::{Outcome, Status, Tolerances};
use super::equilibrium::Equilibrium;
use super::newton::{Equations, newton};
use super::stability::{Softest, softest};
use crate::mechanism::{DriverId, ForceKind, Owner};
use crate::relation::Coordinates;

/// Newton's method within a load step: it has to contract, so that it stays with its solution.
const WITHIN_STEP: Tolerances =
    Tolerances { step: 1e-9, residual: 1e-12, iterations: 15, contraction: 0.5 };

/// Newton's method at the end of a relaxation, already near.
const NEAR: Tolerances =
    Tolerances { step: 1e-9, residual: 1e-12, iterations: 20, contraction: f64::INFINITY };

/// The largest first correction of a step, relative to the size of the mechanism.
const LONGEST_STEP: f64 = 0.3;

/// The shortest load step, as a part of all loads.
const SHORTEST: f64 = 1e-4;

/// Linear systems that a relaxation may solve.
const RELAXATION: usize = 2000;

/// The largest change of one step of a relaxation, relative.
const LONGEST_RELAXATION: f64 = 0.05;

/// A relaxation that would have to be damped this many times as much as at its start is stuck.
const STIFFEST: f64 = 1e9;

/// Residual at which a relaxation hands over to Newton's method.
const HAND_OVER: f64 = 1e-4;

/// Largest accepted relative residual of an equation that is left out as redundant.
const CONSISTENT: f64 = 1e-9;

/// Relative residual of such an equation that a step of a relaxation may leave.
const ASTRAY: f64 = 1e-2;

/// How an equilibrium was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StaticReport {
    /// Linear systems that were solved.
    pub iterations: usize,
    /// Steps in which the loads were put on; one where Newton's method needs no help.
    pub load_steps: usize,
    /// Steps of viscous relaxation; zero where load steps are enough.
    pub relaxation_steps: usize,
    /// The largest residual at the end, relative: equations by the size of their terms, forces by the
    /// largest force.
    pub relative_residual: f64,
    /// The smallest stiffness of the mechanism against a motion, made a length by the size of the
    /// mechanism (N/m). Positive: the equilibrium is stable. Infinite where nothing can move.
    pub stiffness: f64,
}

/// Why there is no static equilibrium. The state is the last one that was reached.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum StaticFailure {
    /// A motion without any stiffness.
    #[error(
        "nothing holds this motion: {motion}. Add a spring, a bushing, a tyre or a joint that holds it, \
         or hold it with a driver"
    )]
    FreeMotion {
        /// The motion in words.
        motion: String,
    },
    /// An equilibrium from which the mechanism runs away.
    #[error(
        "the equilibrium is unstable: {motion} has a stiffness of {stiffness:.4e} N/m; \
         check the signs of stiffnesses and the side on which loads act"
    )]
    Unstable {
        /// The motion in words.
        motion: String,
        /// Its stiffness (N/m), below zero.
        stiffness: f64,
    },
    /// Neither load steps nor relaxation come to rest.
    #[error(
        "no equilibrium was found: with {:.1} % of the loads on, the largest residual is {relative_residual:.1e} \
         of the largest force; {hint}",
        .reached * 100.0
    )]
    NoConvergence {
        /// The part of the loads that could be put on.
        reached: f64,
        /// The residual at the end, relative.
        relative_residual: f64,
        /// What may be wrong.
        hint: String,
    },
    /// Drivers that cannot go on.
    #[error("no equilibrium was found on the rest of the way; {hint}")]
    Stuck {
        /// What may be wrong.
        hint: String,
    },
    /// A tyre that carries nothing.
    #[error(
        "the tyre `{tyre}` is in the air, {gap_mm:.3} mm above the ground: lower the wheel, raise the ground, \
         or hold the wheel with a driver"
    )]
    Airborne {
        /// The tyre.
        tyre: String,
        /// Height above the ground (mm).
        gap_mm: f64,
    },
    /// A force that has no value at the state, such as a spring of length zero.
    #[error(
        "force {force} has no value here ({value}): its points coincide, or its bushing has turned too far"
    )]
    NotFinite {
        /// The force element.
        force: String,
        /// What came of it.
        value: f64,
    },
    /// An equation that is left out as redundant is not satisfied.
    #[error(
        "{equation}, is redundant at the design position but is violated by {residual:.1e} here"
    )]
    Inconsistent {
        /// The equation in words.
        equation: String,
        /// By how much, in the unit of the equation.
        residual: f64,
    },
}

impl Equilibrium {
    /// Finds the static equilibrium that the current state leads to.
    ///
    /// # Errors
    /// [`StaticFailure`] where there is none, or none that is stable.
    pub fn find(&mut self) -> Result<StaticReport, StaticFailure> {
        let mut report = StaticReport::default();
        self.check_values()?;
        let start = self.problem.state.clone();
        let reached = self.step_loads(&mut report);
        self.problem.held = 0.0;
        if reached < 1.0 && !self.relax(&start, &mut report) {
            return Err(
                self.no_equilibrium(reached, "the loads may be more than the mechanism can hold")
            );
        }
        self.judge(&mut report)?;
        Ok(report)
    }

    /// Moves drivers (values in m or rad from the design position) and follows the equilibrium
    /// on the way, in steps as large as Newton's method takes them.
    ///
    /// # Errors
    /// [`StaticFailure`]; the state is then the last one that was reached.
    pub fn move_to(&mut self, targets: &[(DriverId, f64)]) -> Result<StaticReport, StaticFailure> {
        let mut report = StaticReport::default();
        let from: Vec<f64> = targets.iter().map(|&(driver, _)| self.driver_value(driver)).collect();
        let mut changes = targets.to_vec();
        let predict = |it: &mut Self, part: f64| {
            for ((change, &(_, to)), from) in changes.iter_mut().zip(targets).zip(&from) {
                change.1 = part * (to - from);
            }
            it.predict(&changes)
        };
        let reached = self.follow(&mut report, predict, |it, t| it.set_drivers(targets, &from, t));
        if reached < 1.0 {
            let hint = "the joints may be at the end of their travel";
            return Err(match self.no_equilibrium(reached, hint) {
                StaticFailure::NoConvergence { hint, .. } => StaticFailure::Stuck { hint },
                failure => failure,
            });
        }
        self.judge(&mut report)?;
        Ok(report)
    }

    fn set_drivers(&mut self, targets: &[(DriverId, f64)], from: &[f64], t: f64) {
        for (&(driver, to), from) in targets.iter().zip(from) {
            let value = if t == 1.0 { to } else { from + t * (to - from) };
            self.set_driver(driver, value);
        }
    }

    /// Puts the loads on in steps; returns the part of them that could be put on.
    fn step_loads(&mut self, report: &mut StaticReport) -> f64 {
        self.problem.measure();
        self.problem.hold_residual();
        // What is held at the start has no tangent that would be worth a factorisation.
        self.follow(report, |_, _| 0.0, |it, t| it.problem.held = 1.0 - t)
    }

    /// Follows the equilibrium while `set` goes from 0 to 1, in steps as large as Newton's method
    /// takes them; returns where it got to. State and setting are then those that were reached. `predict`
    /// begins a step of a length with what it can foresee, and says how far it goes.
    fn follow(
        &mut self,
        report: &mut StaticReport,
        mut predict: impl FnMut(&mut Self, f64) -> f64,
        set: impl Fn(&mut Self, f64),
    ) -> f64 {
        let mut saved = (self.problem.state.clone(), self.problem.lambda.clone());
        let (mut t, mut dt): (f64, f64) = (0.0, 1.0);
        while t < 1.0 {
            let next = if t + dt >= 1.0 - SHORTEST { 1.0 } else { t + dt };
            let foreseen = predict(self, next - t);
            set(self, next);
            if foreseen <= LONGEST_STEP && self.newton_within_step(report).converged() {
                saved.0.copy_from_slice(&self.problem.state);
                saved.1.copy_from_slice(&self.problem.lambda);
                self.elements_mut().accept();
                report.load_steps += 1;
                (t, dt) = (next, 2.0 * dt);
                continue;
            }
            self.restore(&saved);
            set(self, t);
            dt = 0.5 * (next - t);
            if dt < SHORTEST {
                break;
            }
        }
        t
    }

    fn newton_within_step(&mut self, report: &mut StaticReport) -> Outcome {
        self.problem.measure();
        let (problem, step) = (&mut self.problem, &mut self.step);
        let mut outcome = newton(problem, self.linear.as_mut(), &WITHIN_STEP, step);
        report.iterations += outcome.iterations;
        report.relative_residual = outcome.relative_residual;
        if outcome.converged() && outcome.first_step > LONGEST_STEP {
            outcome.status = Status::NotContracting;
        }
        outcome
    }

    fn restore(&mut self, saved: &(Vec<Coordinates<f64>>, Vec<f64>)) {
        self.problem.state.copy_from_slice(&saved.0);
        self.problem.lambda.copy_from_slice(&saved.1);
    }

    /// Lets the mechanism sink to rest in a very viscous fluid: implicit steps of D q̇ = −F with
    /// Φ = 0, whose step grows as the residual falls.
    fn relax(&mut self, start: &[Coordinates<f64>], report: &mut StaticReport) -> bool {
        self.problem.state.copy_from_slice(start);
        self.problem.lambda.fill(0.0);
        self.problem.measure();
        let first = self.problem.force_size * self.problem.scales.length;
        let mut damping = first;
        let mut next_attempt = HAND_OVER;
        while report.relaxation_steps < RELAXATION && damping < STIFFEST * first {
            self.problem.measure();
            self.problem.damping = damping;
            self.problem.linearise();
            self.problem.right_side(&mut self.step);
            report.relaxation_steps += 1;
            report.iterations += 1;
            let solved = self.linear.factorise(self.problem.matrix());
            let solved = solved.and_then(|()| self.linear.solve(&mut self.step));
            let size = self.problem.step_size(&self.step);
            if solved.is_err() || size.is_nan() || size > LONGEST_RELAXATION {
                damping *= 4.0;
                continue;
            }
            self.problem.begin_step();
            self.problem.take_step(&self.step, 1.0);
            let residual = self.problem.residual();
            if self.worst_left_out() > ASTRAY {
                // The step left the positions in which redundant equations agree.
                self.problem.take_step(&self.step, 0.0);
                damping *= 4.0;
                continue;
            }
            self.elements_mut().accept();
            damping *= if size < 0.2 * LONGEST_RELAXATION { 0.25 } else { 0.7 };
            if residual > next_attempt || size > 10.0 * HAND_OVER {
                continue;
            }
            self.problem.damping = 0.0;
            let saved = (self.problem.state.clone(), self.problem.lambda.clone());
            let outcome = newton(&mut self.problem, self.linear.as_mut(), &NEAR, &mut self.step);
            report.iterations += outcome.iterations;
            report.relative_residual = outcome.relative_residual;
            if outcome.converged() {
                return true;
            }
            self.restore(&saved);
            next_attempt *= 0.1;
        }
        self.problem.damping = 0.0;
        false
    }

    /// The largest relative residual of the equations that are left out as redundant.
    fn worst_left_out(&self) -> f64 {
        let problem = &self.problem;
        let equations = problem.phi.iter().zip(&problem.sizes).enumerate();
        equations
            .filter(|&(equation, _)| !self.is_held(equation) && !self.is_released(equation))
            .map(|(_, (phi, size))| (phi / size).abs())
            .fold(0.0, |worst, value| if value.is_nan() { f64::INFINITY } else { worst.max(value) })
    }

    fn is_released(&self, equation: usize) -> bool {
        matches!(self.expansion.owner(equation), Owner::Driver(driver) if self.released.contains(&driver))
    }

    /// Whether a solution is one that the mechanism stays in.
    fn judge(&mut self, report: &mut StaticReport) -> Result<(), StaticFailure> {
        let problem = &mut self.problem;
        problem.held = 0.0;
        problem.damping = 0.0;
        problem.kkt.fill(&problem.state, &problem.h, &problem.lambda, &mut problem.phi);
        problem.kkt.elements_mut().accept();
        let problem = &self.problem;
        for (equation, (phi, size)) in problem.phi.iter().zip(&problem.sizes).enumerate() {
            let relative = (phi / size).abs();
            if !self.is_released(equation) && (relative.is_nan() || relative > CONSISTENT) {
                let equation = self.expansion.label(equation).to_owned();
                return Err(StaticFailure::Inconsistent { equation, residual: *phi });
            }
        }
        report.stiffness = f64::INFINITY;
        if let Some(Softest { stiffness, motion, holds }) = softest(self, &[]) {
            report.stiffness = stiffness;
            if !holds && stiffness < 0.0 {
                return Err(StaticFailure::Unstable { motion, stiffness });
            }
            if !holds {
                return Err(StaticFailure::FreeMotion { motion });
            }
        }
        self.check_tyres()
    }

    fn check_tyres(&self) -> Result<(), StaticFailure> {
        let elements = self.elements();
        for (owner, values) in elements.owners() {
            let Owner::Force(force) = owner else { continue };
            let force = &self.mechanism.forces()[force.index()];
            let response = elements.responses()[values.start];
            if matches!(force.kind, ForceKind::Tyre { .. })
                && elements.laws()[values.start].acts != crate::mechanism::Acts::Always
                && response.force >= 0.0
            {
                let gap_mm = 1e3 * elements.values()[values.start];
                return Err(StaticFailure::Airborne { tyre: force.name.clone(), gap_mm });
            }
        }
        Ok(())
    }

    /// Refuses force elements without a value or a direction at the current state.
    fn check_values(&mut self) -> Result<(), StaticFailure> {
        self.problem.residual();
        for force in self.mechanism.force_ids() {
            let wrench = self.loaded().force(force);
            let numbers = wrench.force.iter().chain(&wrench.moment);
            if let Some(&value) = numbers.into_iter().find(|number| !number.is_finite()) {
                let force = self.mechanism.forces()[force.index()].name.clone();
                return Err(StaticFailure::NotFinite { force, value });
            }
        }
        Ok(())
    }

    /// Says why there is no equilibrium, from the state where the search ended.
    fn no_equilibrium(&mut self, reached: f64, hint: &str) -> StaticFailure {
        if let Err(failure) = self.check_values() {
            return failure;
        }
        let problem = &mut self.problem;
        problem.held = 0.0;
        problem.damping = 0.0;
        let relative_residual = problem.linearise();
        let mut hint = hint.to_owned();
        if let Err(StaticFailure::Airborne { tyre, .. }) = self.check_tyres() {
            // What else is wrong there follows from it.
            hint = format!("the tyre `{tyre}` has left the ground; check loads and ground");
        } else if let Some(Softest { stiffness, motion, holds: false }) = softest(self, &[]) {
            if stiffness >= 0.0 {
                return StaticFailure::FreeMotion { motion };
            }
            hint = format!(
                "the mechanism runs away: {motion} has a stiffness of {stiffness:.4e} N/m; check the signs of \
                 stiffnesses and the side on which loads act"
            );
        }
        StaticFailure::NoConvergence { reached, relative_residual, hint }
    }
}
