//! The balance of energy and the drift of constraints.

use super::Dynamics;
use crate::relation::BODY_COORDINATES;

/// Energies (J) at the present time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Potential energy of weights, preloads and elastic forces, zero where their values are zero.
    pub potential: f64,
    /// Work since the start of all other forces: negative for what dampers have dissipated. It is
    /// summed up along the way by the trapezoidal rule.
    pub work: f64,
    /// Kinetic and potential energy, minus the work, minus what there was at the start: zero but for the
    /// error of the integration.
    pub drift: f64,
}

/// What an integration has done.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DynamicsReport {
    /// Accepted steps.
    pub steps: usize,
    /// Steps that were tried in vain.
    pub rejected: usize,
    /// Newton iterations, those of rejected steps included.
    pub iterations: usize,
    /// Matrices that were factorised.
    pub factorisations: usize,
    /// The shortest accepted step (s).
    pub smallest_step: f64,
    /// The longest accepted step (s).
    pub largest_step: f64,
    /// The largest |Φ| of all steps, each equation divided by the size of its terms; redundant
    /// equations included.
    pub position_drift: f64,
    /// The largest |Φ_q q̇| of all steps (1/s), each equation divided by the size of its terms.
    pub velocity_drift: f64,
    /// The largest |drift| of the energy of all steps (J).
    pub energy_drift: f64,
    /// The largest kinetic energy of all steps (J), to measure the drift with.
    pub largest_kinetic: f64,
}

impl Dynamics {
    /// The energies at the present time.
    pub fn energy(&self) -> Energy {
        self.energy
    }

    /// Measures the energies of the start. The elements have to be evaluated there.
    pub(super) fn open_ledger(&mut self) {
        let [kinetic, potential] = self.energies();
        self.energy = Energy { kinetic, potential, work: 0.0, drift: 0.0 };
        self.report.largest_kinetic = kinetic;
        self.balance = kinetic + potential;
        self.power = self.power_now();
        self.measure_drift();
    }

    /// Goes on with the balance after an accepted step.
    pub(super) fn keep_ledger(&mut self, dt: f64) {
        let [kinetic, potential] = self.energies();
        let power = self.power_now();
        let work = self.energy.work + 0.5 * dt * (self.power + power);
        let drift = kinetic + potential - work - self.balance;
        self.power = power;
        self.energy = Energy { kinetic, potential, work, drift };
        self.measure_drift();
        let report = &mut self.report;
        report.smallest_step = if report.steps == 0 { dt } else { report.smallest_step.min(dt) };
        report.largest_step = report.largest_step.max(dt);
        report.steps += 1;
        report.energy_drift = report.energy_drift.max(drift.abs());
        report.largest_kinetic = report.largest_kinetic.max(kinetic);
    }

    fn energies(&self) -> [f64; 2] {
        let kinetic = self.kkt.inertias().energy(self.now.motion(), &self.h);
        [kinetic, self.kkt.elements().potential()]
    }

    /// The power (W) of forces without potential and of the load.
    fn power_now(&self) -> f64 {
        let velocities = self.now.velocity.iter().skip(1);
        let loads = self.load.chunks_exact(BODY_COORDINATES).zip(velocities);
        let load: f64 =
            loads.flat_map(|(load, v)| load.iter().zip(v)).map(|(load, v)| load * v).sum();
        load + self.kkt.elements().power() + self.driven_power()
    }

    fn measure_drift(&mut self) {
        let Self { now, h, phi_rate, .. } = self;
        self.terms.velocity_product(&now.state, &now.velocity, h, phi_rate);
        for driven in &self.driven {
            phi_rate[driven.equation] -= driven.now.first;
        }
        for equation in 0..self.phi.len() {
            if self.is_released(equation) {
                continue;
            }
            let size = self.sizes[equation];
            let report = &mut self.report;
            report.position_drift = report.position_drift.max((self.phi[equation] / size).abs());
            report.velocity_drift =
                report.velocity_drift.max((self.phi_rate[equation] / size).abs());
        }
    }
}
