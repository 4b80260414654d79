//! Velocities, accelerations and multipliers that fit the joints.

use super::Dynamics;
use super::failure::DynamicsFailure;
use super::inertia::MASS;
use crate::mechanism::{Body, DriverId, InitialVelocity, Law, Owner};
use crate::relation::{BODY_COORDINATES, Coordinates};
use crate::solve::motion::Twist;
use crate::vector::{add, cross, dot, norm, rotate, scale, sub};

/// Largest accepted relative residual of an equation at the start.
const ASSEMBLED: f64 = 1e-9;

/// A relative change of velocities above this is more than rounding.
const ROUNDING: f64 = 1e-9;

/// What a motion begins with. By default: the state of the system, the velocities that the
/// mechanism states, all drivers held, no load besides the force elements.
#[derive(Clone, Copy, Default)]
pub struct Start<'a> {
    /// Drivers that are taken away.
    pub released: &'a [DriverId],
    /// Coordinates of all bodies, the ground first; joints have to hold there.
    pub state: Option<&'a [Coordinates<f64>]>,
    /// Velocities of all bodies, the ground first.
    pub velocity: Option<&'a [InitialVelocity]>,
    /// A constant generalised load: seven entries for each moving body.
    pub load: Option<&'a [f64]>,
    /// Laws of the force elements, one for each of their values, instead of those of the mechanism.
    pub laws: Option<&'a [Law]>,
}

/// How the velocities that were asked for were changed to fit the joints: as little as possible,
/// measured by the kinetic energy of the change.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StartReport {
    /// The largest speed that was asked for (m/s), rotations times the size of the mechanism.
    pub requested: f64,
    /// The largest change of the velocity of a body (m/s), at its centre of mass.
    pub velocity_change: f64,
    /// The largest change of the angular velocity of a body (rad/s).
    pub rotation_change: f64,
    /// The body whose motion was changed most; empty where nothing was changed.
    pub body: String,
    /// Whether the change is more than rounding: what was asked for contradicts the joints.
    pub contradicts: bool,
}

impl Dynamics {
    /// Sets velocities, accelerations and multipliers at the start.
    pub(super) fn begin(&mut self, start: &Start<'_>) -> Result<(), DynamicsFailure> {
        self.check_numbers()?;
        self.check_assembled()?;
        self.kkt.fill_in_motion(self.now.motion(), &self.h, &self.now.lambda, MASS, &mut self.phi);
        self.check_forces(0.0)?;
        self.check_inertia()?;
        self.fit_velocities(start)?;
        self.kkt.elements_mut().accept();
        let accelerated = self.accelerate();
        self.check_forces(0.0)?;
        accelerated?;
        let first = self.proposal;
        self.shift_acceleration(first)?;
        self.next.copy_from(&self.now);
        self.open_ledger();
        Ok(())
    }

    fn check_numbers(&self) -> Result<(), DynamicsFailure> {
        let refuse = |what, body: usize, value: f64| {
            let body = self.mechanism.bodies()[body].name.clone();
            Err(DynamicsFailure::NotFinite { what, body, value })
        };
        for (body, q) in self.now.state.iter().enumerate() {
            if let Some(value) = q.iter().find(|value| !value.is_finite()) {
                return refuse("position", body, *value);
            }
        }
        match self.load.iter().position(|value| !value.is_finite()) {
            Some(k) => refuse("load", k / BODY_COORDINATES + 1, self.load[k]),
            None => Ok(()),
        }
    }

    fn check_assembled(&mut self) -> Result<(), DynamicsFailure> {
        self.terms.residual(&self.now.state, &self.h, &mut self.phi);
        for (equation, (phi, size)) in self.phi.iter().zip(&self.sizes).enumerate() {
            let relative = (phi / size).abs();
            if !self.is_released(equation) && (relative.is_nan() || relative > ASSEMBLED) {
                let equation = self.expansion.label(equation).to_owned();
                return Err(DynamicsFailure::NotAssembled { equation, residual: *phi });
            }
        }
        Ok(())
    }

    /// Whether an equation belongs to a released driver.
    pub(super) fn is_released(&self, equation: usize) -> bool {
        let owner = self.expansion.owner(equation);
        matches!(owner, Owner::Driver(driver) if self.released.contains(&driver))
    }

    /// The velocities nearest to those asked for that satisfy Φ_q v = 0:
    /// [M, Φ_qᵀ; Φ_q, 0] [Δv; μ] = [0; −Φ_q v]. The matrix has to hold [`MASS`].
    fn fit_velocities(&mut self, start: &Start<'_>) -> Result<(), DynamicsFailure> {
        let bodies = self.mechanism.bodies();
        for (index, body) in bodies.iter().enumerate().skip(1) {
            let wish = start.velocity.map_or(body.initial_velocity, |all| all[index]);
            let numbers = wish.velocity.iter().chain(&wish.rotation);
            if let Some(&value) = numbers.clone().find(|value| !value.is_finite()) {
                let body = body.name.clone();
                return Err(DynamicsFailure::NotFinite { what: "velocity", body, value });
            }
            self.now.velocity[index] = rates(&self.now.state[index], body, &wish);
        }
        let Self { now, h, phi_rate, .. } = self;
        self.terms.velocity_product(&now.state, &now.velocity, h, phi_rate);
        self.linear
            .factorise(self.kkt.values())
            .map_err(|_| DynamicsFailure::Undetermined { time: 0.0 })?;
        let (change, constraints) = self.right_side.split_at_mut(self.numbering.unknowns());
        change.fill(0.0);
        for (out, &equation) in constraints.iter_mut().zip(self.numbering.kept()) {
            *out = -self.phi_rate[equation];
        }
        for driven in &self.driven {
            if let Some(row) = self.numbering.row(driven.equation) {
                constraints[row] += driven.now.first;
            }
        }
        self.linear
            .solve(&mut self.right_side)
            .map_err(|_| DynamicsFailure::Undetermined { time: 0.0 })?;
        self.start = self.judge_change();
        let changes = self.right_side.chunks_exact(BODY_COORDINATES);
        for (velocity, change) in self.now.velocity.iter_mut().skip(1).zip(changes) {
            velocity.iter_mut().zip(change).for_each(|(v, dv)| *v += dv);
        }
        Ok(())
    }

    /// Measures the change of velocities that the right-hand side holds.
    fn judge_change(&self) -> StartReport {
        let mut report = StartReport::default();
        let length = self.scales.length;
        let mut most = 0.0;
        let bodies = self.mechanism.bodies().iter().enumerate().skip(1);
        for ((index, body), change) in bodies.zip(self.right_side.chunks_exact(BODY_COORDINATES)) {
            let q = &self.now.state[index];
            let center = center(q, body);
            let parts = |rate: &[f64]| {
                let twist = Twist::new(q, rate);
                (norm(twist.at(center)), norm(twist.rotation))
            };
            let (velocity, rotation) = parts(&self.now.velocity[index]);
            report.requested = report.requested.max(velocity).max(rotation * length);
            let (velocity, rotation) = parts(change);
            report.velocity_change = report.velocity_change.max(velocity);
            report.rotation_change = report.rotation_change.max(rotation);
            let change = velocity.max(rotation * length);
            if change > most {
                most = change;
                report.body = body.name.clone();
            }
        }
        // What drivers set in motion was not asked to rest.
        let asked = self.driven.is_empty() || report.requested > 0.0;
        report.contradicts = asked && most > ROUNDING * report.requested;
        report
    }

    /// Accelerations and multipliers at the current positions and velocities:
    /// [M, Φ_qᵀ; Φ_q, 0] [q̈; λ] = [Q − F(q, q̇, 0); −(Φ_q v)_q v].
    pub(super) fn accelerate(&mut self) -> Result<(), DynamicsFailure> {
        let Self { now, h, .. } = self;
        now.acceleration.fill([0.0; BODY_COORDINATES]);
        now.lambda.fill(0.0);
        self.kkt.fill_in_motion(now.motion(), h, &now.lambda, MASS, &mut self.phi);
        self.terms.convective_acceleration(&now.state, &now.velocity, h, &mut self.phi_rate);
        let (force, constraints) = self.right_side.split_at_mut(self.numbering.unknowns());
        let balance = self.load.iter().zip(self.kkt.force());
        force.iter_mut().zip(balance).for_each(|(out, (load, force))| *out = load - force);
        for (out, &equation) in constraints.iter_mut().zip(self.numbering.kept()) {
            *out = -self.phi_rate[equation];
        }
        for driven in &self.driven {
            if let Some(row) = self.numbering.row(driven.equation) {
                constraints[row] += driven.now.second;
            }
        }
        self.matrix.step = 0.0;
        let solved = self.linear.factorise(self.kkt.values());
        solved
            .and_then(|()| self.linear.solve(&mut self.right_side))
            .map_err(|_| DynamicsFailure::Undetermined { time: self.now.time })?;
        let (accelerations, multipliers) = self.right_side.split_at(self.numbering.unknowns());
        let accelerations = accelerations.chunks_exact(BODY_COORDINATES);
        for (to, from) in self.now.acceleration.iter_mut().skip(1).zip(accelerations) {
            to.copy_from_slice(from);
        }
        for (multiplier, &equation) in multipliers.iter().zip(self.numbering.kept()) {
            self.now.lambda[equation] = *multiplier;
        }
        Ok(())
    }

    /// Sets the algorithmic acceleration for a first step: q̈ at its shifted time, from a predicted
    /// state there. So the method is of second order from the first step on (Arnold & Brüls 2007).
    fn shift_acceleration(&mut self, step: f64) -> Result<(), DynamicsFailure> {
        self.step = step;
        let dt = self.coefficients.shift() * step;
        let here = self.now.clone();
        self.next.copy_from(&here);
        if dt != 0.0 {
            for (body, acceleration) in here.acceleration.iter().enumerate() {
                for k in 0..BODY_COORDINATES {
                    let (v, a) = (here.velocity[body][k], acceleration[k]);
                    self.now.state[body][k] += dt * (v + 0.5 * dt * a);
                    self.now.velocity[body][k] += dt * a;
                }
            }
            self.set_clock(here.time + dt);
            self.accelerate()?;
            self.set_clock(here.time);
        }
        let shifted = self.now.acceleration.clone();
        self.now = here;
        self.now.algorithmic = shifted;
        // The force elements hold the values of the shifted state.
        let Self { now, h, .. } = self;
        self.kkt.residual_in_motion(now.motion(), h, &now.lambda, &mut self.phi);
        Ok(())
    }

    /// Refuses force elements without a value at the last evaluation.
    pub(super) fn check_forces(&self, time: f64) -> Result<(), DynamicsFailure> {
        let elements = self.kkt.elements();
        for (owner, values) in elements.owners() {
            let Owner::Force(force) = owner else { continue };
            for k in values {
                let response = elements.responses()[k];
                // Where a relation has no direction, the rate of its value has no value.
                let numbers = [response.force, response.by_value, elements.rates()[k]];
                if let Some(&value) = numbers.iter().find(|number| !number.is_finite()) {
                    let force = self.mechanism.forces()[force.index()].name.clone();
                    return Err(DynamicsFailure::NoForce { force, time, value });
                }
            }
        }
        Ok(())
    }
}

/// Where the centre of mass of a body is (m), or its origin where it has no mass.
pub(super) fn center(q: &Coordinates<f64>, body: &Body) -> [f64; 3] {
    let origin = [q[0], q[1], q[2]];
    match body.mass {
        None => origin,
        Some(mass) => add(origin, rotate([q[3], q[4], q[5], q[6]], sub(mass.center, body.origin))),
    }
}

/// The rates of the coordinates of a body with a velocity at its centre of mass and an angular
/// velocity: ṗ = ½ Eᵀω.
fn rates(q: &Coordinates<f64>, body: &Body, motion: &InitialVelocity) -> Coordinates<f64> {
    let (e0, e) = (q[3], [q[4], q[5], q[6]]);
    let omega = motion.rotation;
    let arm = sub([q[0], q[1], q[2]], center(q, body));
    let r = add(motion.velocity, cross(omega, arm));
    let e0_rate = -0.5 * dot(e, omega);
    let e_rate = scale(0.5, add(scale(e0, omega), cross(omega, e)));
    [r[0], r[1], r[2], e0_rate, e_rate[0], e_rate[1], e_rate[2]]
}
