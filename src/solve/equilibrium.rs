//! Static equilibrium: coordinates and multipliers together (paper, eq. 4–7).

use super::convergence::{Outcome, Tolerances};
use super::linear::{LinearSolver, largest, solver};
use super::newton::{Equations, newton};
use super::position::{Scales, move_bodies};
use super::system::System;
use crate::assembly::{Kkt, Numbering};
use crate::relation::Coordinates;

/// The equations Φ_qᵀλ − Q = 0 and Φ = 0 with their unknowns q and λ, for a
/// constant generalized load Q.
///
/// The multipliers are unique only where no equation is left out as redundant;
/// the multiplier of a left-out equation is zero. A free motion without
/// stiffness makes the matrix singular.
pub struct Equilibrium {
    problem: Problem,
    linear: Box<dyn LinearSolver>,
    step: Vec<f64>,
}

struct Problem {
    kkt: Kkt,
    numbering: Numbering,
    scales: Scales,
    sizes: Vec<f64>,
    h: Vec<f64>,
    load: Vec<f64>,
    state: Vec<Coordinates<f64>>,
    lambda: Vec<f64>,
    phi: Vec<f64>,
    // State and multipliers at the start of a step.
    start: Vec<Coordinates<f64>>,
    start_lambda: Vec<f64>,
    // The largest force so far: what forces are measured with.
    force_size: f64,
}

impl Equilibrium {
    /// The equations of a system at its current state, with λ = 0 and Q = 0.
    pub fn new(system: &System) -> Self {
        let position = system.position();
        let numbering = position.numbering().clone();
        let kkt = Kkt::new(system.terms().clone(), &numbering);
        let equations = position.sizes().len();
        Self {
            linear: solver(kkt.pattern()),
            step: vec![0.0; kkt.pattern().rows()],
            problem: Problem {
                scales: position.scales,
                sizes: position.sizes().to_vec(),
                h: position.h.clone(),
                load: vec![0.0; kkt.unknowns()],
                state: position.state.clone(),
                lambda: vec![0.0; equations],
                phi: vec![0.0; equations],
                start: position.state.clone(),
                start_lambda: vec![0.0; equations],
                force_size: 1.0,
                numbering,
                kkt,
            },
        }
    }

    /// The generalized load Q: seven entries for each moving body, work-conjugate to its coordinates.
    pub fn load_mut(&mut self) -> &mut [f64] {
        &mut self.problem.load
    }

    /// Coordinates of all bodies, the ground first.
    pub fn state(&self) -> &[Coordinates<f64>] {
        &self.problem.state
    }

    /// Coordinates to start from.
    pub fn state_mut(&mut self) -> &mut [Coordinates<f64>] {
        &mut self.problem.state
    }

    /// Multipliers of all equations, zero for left-out ones.
    pub fn multipliers(&self) -> &[f64] {
        &self.problem.lambda
    }

    /// Multipliers to start from.
    pub fn multipliers_mut(&mut self) -> &mut [f64] {
        &mut self.problem.lambda
    }

    /// Solves for coordinates and multipliers by Newton's method.
    pub fn solve(&mut self, tolerances: &Tolerances) -> Outcome {
        let problem = &mut self.problem;
        let forces = [&problem.load, &problem.lambda];
        let size = forces.iter().map(|force| largest(force)).fold(0.0, f64::max);
        problem.force_size = if size > 0.0 { size } else { 1.0 };
        newton(problem, self.linear.as_mut(), tolerances, &mut self.step)
    }

    /// Fills and factorises the matrix at the current state and takes one full step.
    /// Returns whether the matrix was regular.
    pub fn newton_step(&mut self) -> bool {
        let once = Tolerances { iterations: 1, ..Tolerances::default() };
        self.solve(&once).status != super::newton::Status::Singular
    }
}

impl Problem {
    fn size(&self) -> f64 {
        let force = self.kkt.force().iter().zip(&self.load).enumerate();
        let force = force.fold(0.0, |worst: f64, (unknown, (inner, outer))| {
            // A force works on metres, a moment on Euler parameters.
            let arm = self.scales.length / self.scales.coordinate(unknown);
            worst_of(worst, (inner - outer) / (arm * self.force_size))
        });
        self.numbering.kept().iter().fold(force, |worst, &equation| {
            worst_of(worst, self.phi[equation] / self.sizes[equation])
        })
    }
}

fn worst_of(worst: f64, value: f64) -> f64 {
    if value.is_nan() { f64::INFINITY } else { worst.max(value.abs()) }
}

impl Equations for Problem {
    fn residual(&mut self) -> f64 {
        self.kkt.residual(&self.state, &self.h, &self.lambda, &mut self.phi);
        self.size()
    }

    fn linearise(&mut self) -> f64 {
        self.kkt.fill(&self.state, &self.h, &self.lambda, &mut self.phi);
        self.size()
    }

    fn matrix(&self) -> &[f64] {
        self.kkt.values()
    }

    fn right_side(&self, right_side: &mut [f64]) {
        let (force, phi) = right_side.split_at_mut(self.kkt.unknowns());
        for (f, (inner, outer)) in force.iter_mut().zip(self.kkt.force().iter().zip(&self.load)) {
            *f = outer - inner;
        }
        for (phi, &equation) in phi.iter_mut().zip(self.numbering.kept()) {
            *phi = -self.phi[equation];
        }
    }

    fn begin_step(&mut self) {
        self.start.copy_from_slice(&self.state);
        self.start_lambda.copy_from_slice(&self.lambda);
    }

    fn take_step(&mut self, step: &[f64], fraction: f64) {
        let (change, multipliers) = step.split_at(self.kkt.unknowns());
        move_bodies(&self.start, change, fraction, &mut self.state);
        for (change, &equation) in multipliers.iter().zip(self.numbering.kept()) {
            self.lambda[equation] = self.start_lambda[equation] + fraction * change;
        }
    }

    fn step_size(&self, step: &[f64]) -> f64 {
        let (change, multipliers) = step.split_at(self.kkt.unknowns());
        let size = self.scales.change(change).max(largest(multipliers) / self.force_size);
        if largest(step).is_finite() { size } else { f64::INFINITY }
    }
}
