//! Static equilibrium: coordinates and multipliers together (paper, eq. 4–7).

use super::convergence::{Outcome, Tolerances};
use super::linear::{LinearSolver, largest, solver};
use super::linearised::Scratch;
use super::newton::{Equations, newton};
use super::position::{Scales, move_bodies};
use super::rank::undetermined;
use super::system::System;
use crate::assembly::{Elements, Inertias, Kkt, Numbering};
use crate::mechanism::{DriverId, DriverSlots, Expansion, Mechanism, Owner};
use crate::relation::Coordinates;

/// The part of the largest stiffness times the size of the mechanism that forces are at least
/// measured with: what rounding of a position does to the force of a stiff bushing is no residual.
const STIFFNESS_SHARE: f64 = 1e-3;

/// The equations Φ_qᵀλ − Q = 0 and Φ = 0 with their unknowns q and λ. Q is the sum of the force
/// elements of the mechanism and a constant generalized load.
///
/// The multipliers are unique only where no equation is left out as redundant;
/// the multiplier of a left-out equation is zero. A free motion without
/// stiffness makes the matrix singular. [`Self::find`] is the robust way to a solution;
/// [`Self::solve`] is Newton's method alone.
pub struct Equilibrium {
    pub(super) mechanism: Mechanism,
    pub(super) expansion: Expansion,
    pub(super) problem: Problem,
    pub(super) linear: Box<dyn LinearSolver>,
    pub(super) step: Vec<f64>,
    pub(super) released: Vec<DriverId>,
    pub(super) driver_values: Vec<f64>,
    pub(super) scratch: Scratch,
    undetermined: Vec<usize>,
    // The parameters with all drivers at zero.
    base: Vec<f64>,
}

pub(super) struct Problem {
    pub kkt: Kkt,
    pub numbering: Numbering,
    pub scales: Scales,
    pub sizes: Vec<f64>,
    pub h: Vec<f64>,
    pub load: Vec<f64>,
    pub state: Vec<Coordinates<f64>>,
    pub lambda: Vec<f64>,
    pub phi: Vec<f64>,
    // The residual of the state from which loads are stepped, and the part of it that is
    // held back: the equations are F(x) − held F(x₀).
    pub start_force: Vec<f64>,
    pub start_phi: Vec<f64>,
    pub held: f64,
    // State and multipliers at the start of a step.
    start: Vec<Coordinates<f64>>,
    start_lambda: Vec<f64>,
    // What forces are measured with.
    pub force_size: f64,
    // The weight of the damping with which a relaxation moves, and its diagonal.
    pub damping: f64,
    pub diagonal: Vec<f64>,
}

impl Equilibrium {
    /// The equations of a system at its current state, with all drivers held, λ = 0 and no
    /// load besides the force elements.
    pub fn new(system: &System) -> Self {
        Self::released(system, &[])
    }

    /// The equations of a system at its current state, with the given drivers taken away.
    pub fn released(system: &System, released: &[DriverId]) -> Self {
        let position = system.position();
        let expansion = system.expansion();
        let numbering = system.numbering_without(released);
        let elements = Elements::new(expansion);
        let kkt = Kkt::with_forces(system.terms().clone(), elements, Inertias::none(), &numbering);
        let equations = position.sizes().len();
        let unknowns = kkt.unknowns();
        let drivers = system.mechanism().driver_ids();
        let kept = (position.kept(), position.scales);
        let (state, h) = (&position.state, &position.h);
        Self {
            undetermined: undetermined(expansion, system.terms(), state, h, kept),
            linear: solver(kkt.pattern()),
            step: vec![0.0; kkt.pattern().rows()],
            scratch: Scratch::new(position.h.len(), equations, unknowns),
            released: released.to_vec(),
            driver_values: drivers.map(|driver| system.driver_value(driver)).collect(),
            base: system.base().to_vec(),
            mechanism: system.mechanism().clone(),
            expansion: expansion.clone(),
            problem: Problem {
                scales: position.scales,
                sizes: position.sizes().to_vec(),
                h: position.h.clone(),
                load: vec![0.0; unknowns],
                state: position.state.clone(),
                lambda: vec![0.0; equations],
                phi: vec![0.0; equations],
                start_force: vec![0.0; unknowns],
                start_phi: vec![0.0; equations],
                held: 0.0,
                start: position.state.clone(),
                start_lambda: vec![0.0; equations],
                force_size: 1.0,
                damping: 0.0,
                diagonal: (0..unknowns)
                    .map(|unknown| position.scales.coordinate(unknown).powi(-2))
                    .collect(),
                numbering,
                kkt,
            },
        }
    }

    /// Starts anew at the current state of the system it was made of, with the laws of the force elements
    /// as they are. As long as the system holds the same equations, the way to eliminate is kept.
    pub fn restart(&mut self, system: &System) {
        let mut new = Self::released(system, &self.released);
        new.elements_mut().laws_mut().clone_from_slice(self.elements().laws());
        if new.problem.kkt.pattern() == self.problem.kkt.pattern() {
            std::mem::swap(&mut new.linear, &mut self.linear);
        }
        *self = new;
    }

    /// Takes over the points of the system it was made of, its state and its parameters, of which `lengths` have
    /// other values, as [`System::reshape`] left them. Laws stay as they are.
    pub fn reshape(&mut self, system: &System, lengths: &[(usize, f64)]) {
        self.mechanism.set_positions(&system.mechanism().positions());
        self.base.copy_from_slice(system.base());
        for &(slot, value) in lengths {
            self.base[slot] = value;
        }
        self.problem.h.copy_from_slice(&self.base);
        self.problem.state.copy_from_slice(system.state());
        self.problem.lambda.fill(0.0);
        self.problem.held = 0.0;
        self.driver_values.fill(0.0);
        self.elements_mut().forget();
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// The mechanism as relations.
    pub fn expansion(&self) -> &Expansion {
        &self.expansion
    }

    /// The generalized load: seven entries for each moving body, work-conjugate to its coordinates.
    pub fn load_mut(&mut self) -> &mut [f64] {
        &mut self.problem.load
    }

    /// The force elements with their last values.
    pub fn elements(&self) -> &Elements {
        self.problem.kkt.elements()
    }

    /// The force elements, to change their laws along a load schedule.
    pub fn elements_mut(&mut self) -> &mut Elements {
        self.problem.kkt.elements_mut()
    }

    /// Coordinates of all bodies, the ground first.
    pub fn state(&self) -> &[Coordinates<f64>] {
        &self.problem.state
    }

    /// Coordinates to start from.
    pub fn state_mut(&mut self) -> &mut [Coordinates<f64>] {
        &mut self.problem.state
    }

    /// Which parameters the drivers change.
    pub fn driver_slots(&self) -> &DriverSlots {
        self.expansion.driver_slots()
    }

    /// The parameters h of all relations, with the current values of the drivers.
    pub fn parameters(&self) -> &[f64] {
        &self.problem.h
    }

    /// Multipliers of all equations, zero for left-out ones.
    pub fn multipliers(&self) -> &[f64] {
        &self.problem.lambda
    }

    /// Multipliers to start from.
    pub fn multipliers_mut(&mut self) -> &mut [f64] {
        &mut self.problem.lambda
    }

    /// Whether an equation is held; others are redundant or belong to released drivers.
    pub fn is_held(&self, equation: usize) -> bool {
        self.problem.numbering.row(equation).is_some()
    }

    /// Whether the multiplier of an equation is determined: no redundant equation could share it.
    pub fn is_determined(&self, equation: usize) -> bool {
        !self.undetermined.contains(&equation)
    }

    /// The multiplier of a driver: the force (N) or moment (N·m) −λ that it takes to hold it.
    pub fn driver_multiplier(&self, driver: DriverId) -> f64 {
        self.problem.lambda[self.equation_of(driver)]
    }

    /// The value (m or rad, from the design position) that a driver has.
    pub fn driver_value(&self, driver: DriverId) -> f64 {
        self.driver_values[driver.index()]
    }

    /// The values (m or rad, from the design position) of all drivers.
    pub fn driver_values(&self) -> &[f64] {
        &self.driver_values
    }

    /// Sets the value (m or rad, from the design position) of a driver for the next solution.
    pub fn set_driver(&mut self, driver: DriverId, value: f64) {
        self.driver_values[driver.index()] = value;
        let slots = self.expansion.driver_slots();
        slots.set(&self.base, &self.driver_values, &mut self.problem.h);
    }

    /// How many times its matrix was factorised since it was made: the effort.
    pub fn factorisations(&self) -> usize {
        self.linear.factorisations()
    }

    /// Solves for coordinates and multipliers by Newton's method.
    pub fn solve(&mut self, tolerances: &Tolerances) -> Outcome {
        self.problem.measure();
        newton(&mut self.problem, self.linear.as_mut(), tolerances, &mut self.step)
    }

    /// Fills and factorises the matrix at the current state and takes one full step.
    /// Returns whether the matrix was regular.
    pub fn newton_step(&mut self) -> bool {
        let once = Tolerances { iterations: 1, ..Tolerances::default() };
        self.solve(&once).status != super::newton::Status::Singular
    }

    /// The equation of a driver, for [`DriverTangent::multiplier`](super::linearised::DriverTangent::multiplier).
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn equation_of(&self, driver: DriverId) -> usize {
        let mut equations = self.expansion.equations_of(Owner::Driver(driver));
        equations.next().expect("every driver has an equation")
    }
}

impl Problem {
    /// Finds what forces are measured with.
    pub fn measure(&mut self) {
        self.kkt.fill(&self.state, &self.h, &self.lambda, &mut self.phi);
        self.measure_forces();
    }

    /// The same, from the forces and stiffnesses of the last evaluation.
    pub fn measure_forces(&mut self) {
        let scales = self.scales;
        let arm = |unknown| scales.length / scales.coordinate(unknown);
        let forces = self.kkt.magnitude().iter().zip(&self.load).enumerate();
        let size = forces.fold(0.0, |size: f64, (unknown, (inner, outer))| {
            size.max(inner.max(outer.abs()) / arm(unknown))
        });
        let stiffness = self.kkt.largest_stiffness(|unknown| scales.coordinate(unknown));
        let size = size.max(STIFFNESS_SHARE * stiffness / scales.length);
        self.force_size = if size > 0.0 && size.is_finite() { size } else { 1.0 };
    }

    /// Holds the residual of the current state back, all of it.
    pub fn hold_residual(&mut self) {
        self.kkt.residual(&self.state, &self.h, &self.lambda, &mut self.phi);
        for (held, (inner, outer)) in
            self.start_force.iter_mut().zip(self.kkt.force().iter().zip(&self.load))
        {
            *held = inner - outer;
        }
        self.start_phi.copy_from_slice(&self.phi);
        self.held = 1.0;
    }

    fn force_residual(&self, unknown: usize) -> f64 {
        let force = self.kkt.force()[unknown] - self.load[unknown];
        force - self.held * self.start_force[unknown]
    }

    fn phi_residual(&self, equation: usize) -> f64 {
        self.phi[equation] - self.held * self.start_phi[equation]
    }

    fn size(&self) -> f64 {
        let force = (0..self.kkt.unknowns()).fold(0.0, |worst: f64, unknown| {
            // A force works on metres, a moment on Euler parameters.
            let arm = self.scales.length / self.scales.coordinate(unknown);
            worst_of(worst, self.force_residual(unknown) / (arm * self.force_size))
        });
        self.numbering.kept().iter().fold(force, |worst, &equation| {
            worst_of(worst, self.phi_residual(equation) / self.sizes[equation])
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
        if self.damping > 0.0 {
            self.kkt.add_diagonal(&self.diagonal, self.damping);
        }
        self.size()
    }

    fn matrix(&self) -> &[f64] {
        self.kkt.values()
    }

    fn right_side(&self, right_side: &mut [f64]) {
        let (force, phi) = right_side.split_at_mut(self.kkt.unknowns());
        for (unknown, force) in force.iter_mut().enumerate() {
            *force = -self.force_residual(unknown);
        }
        for (phi, &equation) in phi.iter_mut().zip(self.numbering.kept()) {
            *phi = -self.phi_residual(equation);
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
        let change = &step[..self.kkt.unknowns()];
        if largest(step).is_finite() { self.scales.change(change) } else { f64::INFINITY }
    }
}
