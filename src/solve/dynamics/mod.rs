//! How a mechanism moves: the equations of motion, integrated in time.
//!
//! With the coordinates q (seven for each body, the normalisation of its Euler parameters is a
//! constraint like any other) and the multipliers λ the equations are
//!
//! F(q, q̇, q̈) + Φ_qᵀλ = Q,  Φ(q) = 0,
//!
//! where F contains inertia, gyroscopic terms and force elements. They are integrated as they
//! stand, with index 3, by the generalised-α method (Chung & Hulbert, J. Appl. Mech. 60, 1993;
//! Arnold & Brüls, Multibody Syst. Dyn. 18, 2007).
//!
//! | file | what |
//! |---|---|
//! | `method` | the coefficients of the method and the choice of steps |
//! | `start` | velocities, accelerations and multipliers that fit the joints |
//! | `inertia` | motions that no mass takes part in |
//! | `step` | one step: Newton's method for accelerations and multipliers |
//! | `course` | drivers that follow a course of time |
//! | `control` | steps one after the other, as long as they have to be |
//! | `energy` | the balance of energy and the drift of constraints |
//! | `observe` | where points are, how fast they move |
//! | `settle` | a trajectory, until the mechanism is at rest |
//! | `failure` | why a motion cannot go on |

mod control;
mod course;
mod energy;
mod failure;
mod inertia;
mod method;
mod observe;
mod settle;
mod start;
mod step;

pub use energy::{DynamicsReport, Energy};
pub use failure::DynamicsFailure;
pub use method::{Integrator, StepSize};
pub use settle::{Rest, SettlePlan, Trajectory};
pub use start::{Start, StartReport};

use self::course::{Driven, driven};
use self::method::Coefficients;
use super::linear::{LinearSolver, solver};
use super::position::Scales;
use super::rank::undetermined;
use super::system::System;
use super::wrench::{Loaded, Reaction};
use crate::assembly::{Elements, Inertias, Kkt, Motion, Numbering, Terms};
use crate::mechanism::{DriverId, Expansion, Mechanism, Owner};
use crate::relation::{BODY_COORDINATES, Coordinates};

/// A mechanism in motion.
///
/// ```
/// use hardpoint::mechanism::{BodyId, Direction, JointKind, MassProperties, Mechanism};
/// use hardpoint::solve::System;
/// use hardpoint::solve::dynamics::{Dynamics, Integrator, Start};
///
/// let mut pendulum = Mechanism::new("ground");
/// let bob = pendulum.add_body("bob", [0.0; 3])?;
/// let pin = pendulum.add_point("pin", [0.0; 3])?;
/// let axis = Direction::Fixed([0.0, 1.0, 0.0]);
/// pendulum.add_joint("hinge", BodyId::GROUND, bob, JointKind::Revolute { at: pin, axis })?;
/// let center = pendulum.add_point("center", [0.01, 0.0, -1.0])?;
/// pendulum.set_mass(bob, MassProperties { mass: 2.0, center: [0.01, 0.0, -1.0], inertia: [0.0; 6] })?;
/// pendulum.set_gravity([0.0, 0.0, -9.81])?;
///
/// let system = System::new(pendulum)?;
/// let mut motion = Dynamics::new(&system, &Start::default(), Integrator::fixed(1e-3))?;
/// // A small swing comes back after 2π √(l/g).
/// motion.advance_to(std::f64::consts::TAU * (1.0_f64 / 9.81).sqrt())?;
/// assert!((motion.point_position(bob, center)[0] - 0.01).abs() < 1e-6);
/// assert!(motion.energy().drift.abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Dynamics {
    mechanism: Mechanism,
    expansion: Expansion,
    terms: Terms,
    numbering: Numbering,
    released: Vec<DriverId>,
    kkt: Kkt,
    linear: Box<dyn LinearSolver>,
    scales: Scales,
    sizes: Vec<f64>,
    h: Vec<f64>,
    load: Vec<f64>,
    driven: Vec<Driven>,
    integrator: Integrator,
    coefficients: Coefficients,
    now: Snapshot,
    next: Snapshot,
    // How the algorithmic acceleration and the multipliers change with time: the predictor.
    slope: Vec<Coordinates<f64>>,
    lambda_slope: Vec<f64>,
    // The step for which the algorithmic acceleration stands; zero before the first one.
    step: f64,
    proposal: f64,
    matrix: MatrixState,
    right_side: Vec<f64>,
    phi: Vec<f64>,
    phi_rate: Vec<f64>,
    energy: Energy,
    // Kinetic and potential energy at the start.
    balance: f64,
    power: f64,
    start: StartReport,
    report: DynamicsReport,
}

/// The factorisation at hand.
#[derive(Clone, Copy, Debug, Default)]
struct MatrixState {
    /// The step that it was made for; zero where there is none.
    step: f64,
}

/// Everything that is known at one time.
#[derive(Clone)]
struct Snapshot {
    time: f64,
    state: Vec<Coordinates<f64>>,
    velocity: Vec<Coordinates<f64>>,
    acceleration: Vec<Coordinates<f64>>,
    /// The acceleration variable of the method, which runs ahead of or behind q̈.
    algorithmic: Vec<Coordinates<f64>>,
    lambda: Vec<f64>,
}

impl Snapshot {
    fn at_rest(state: Vec<Coordinates<f64>>, equations: usize) -> Self {
        let zero = vec![[0.0; BODY_COORDINATES]; state.len()];
        Self {
            time: 0.0,
            velocity: zero.clone(),
            acceleration: zero.clone(),
            algorithmic: zero,
            lambda: vec![0.0; equations],
            state,
        }
    }

    fn motion(&self) -> Motion<'_> {
        Motion { state: &self.state, velocity: &self.velocity, acceleration: &self.acceleration }
    }

    fn copy_from(&mut self, other: &Self) {
        self.time = other.time;
        self.state.copy_from_slice(&other.state);
        self.velocity.copy_from_slice(&other.velocity);
        self.acceleration.copy_from_slice(&other.acceleration);
        self.algorithmic.copy_from_slice(&other.algorithmic);
        self.lambda.copy_from_slice(&other.lambda);
    }
}

impl Dynamics {
    /// Puts the mechanism into motion at time zero, with consistent velocities, accelerations and
    /// multipliers. Drivers that are not released hold their current values or follow their courses from
    /// there.
    ///
    /// # Errors
    /// [`DynamicsFailure`] for numbers that are not finite, a position in which the joints do
    /// not hold, or a motion that no mass takes part in.
    pub fn new(
        system: &System,
        start: &Start<'_>,
        integrator: Integrator,
    ) -> Result<Self, DynamicsFailure> {
        integrator.check()?;
        let position = system.position();
        let expansion = system.expansion();
        let numbering = system.numbering_without(start.released);
        let mut elements = Elements::new(expansion);
        if let Some(laws) = start.laws {
            elements.laws_mut().clone_from_slice(laws);
        }
        let kkt = Kkt::with_forces(
            system.terms().clone(),
            elements,
            Inertias::new(expansion),
            &numbering,
        );
        let equations = position.sizes().len();
        let state = start.state.unwrap_or(system.state()).to_vec();
        let now = Snapshot::at_rest(state, equations);
        let load = start.load.map_or_else(|| vec![0.0; kkt.unknowns()], <[f64]>::to_vec);
        let mut dynamics = Self {
            mechanism: system.mechanism().clone(),
            expansion: expansion.clone(),
            terms: system.terms().clone(),
            released: start.released.to_vec(),
            linear: solver(kkt.pattern()),
            scales: position.scales,
            sizes: position.sizes().to_vec(),
            driven: driven(system.mechanism(), expansion, start.released, &position.h),
            h: position.h.clone(),
            load,
            coefficients: integrator.coefficients(),
            slope: now.algorithmic.clone(),
            lambda_slope: now.lambda.clone(),
            next: now.clone(),
            now,
            step: 0.0,
            proposal: integrator.first_step(),
            matrix: MatrixState::default(),
            right_side: vec![0.0; kkt.pattern().rows()],
            phi: vec![0.0; equations],
            phi_rate: vec![0.0; equations],
            energy: Energy::default(),
            balance: 0.0,
            power: 0.0,
            start: StartReport::default(),
            report: DynamicsReport::default(),
            integrator,
            numbering,
            kkt,
        };
        dynamics.begin(start)?;
        Ok(dynamics)
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// Time since the start (s).
    pub fn time(&self) -> f64 {
        self.now.time
    }

    /// Coordinates q of all bodies, the ground first (m; Euler parameters).
    pub fn state(&self) -> &[Coordinates<f64>] {
        &self.now.state
    }

    /// Velocities q̇ of all bodies, the ground first (m/s, 1/s).
    pub fn velocity(&self) -> &[Coordinates<f64>] {
        &self.now.velocity
    }

    /// Accelerations q̈ of all bodies, the ground first (m/s², 1/s²).
    pub fn acceleration(&self) -> &[Coordinates<f64>] {
        &self.now.acceleration
    }

    /// Multipliers of all equations, zero for those of released drivers and redundant ones.
    pub fn multipliers(&self) -> &[f64] {
        &self.now.lambda
    }

    /// The force elements with their values and forces.
    pub fn elements(&self) -> &Elements {
        self.kkt.elements()
    }

    /// Whether an equation is held; others are redundant or belong to released drivers.
    pub fn is_held(&self, equation: usize) -> bool {
        self.numbering.row(equation).is_some()
    }

    /// The state with its multipliers, for reactions and forces.
    pub fn loaded(&self) -> Loaded<'_> {
        Loaded {
            mechanism: &self.mechanism,
            expansion: &self.expansion,
            state: &self.now.state,
            h: &self.h,
            lambda: &self.now.lambda,
            elements: self.kkt.elements(),
        }
    }

    /// The reactions of all joints, in their order.
    pub fn reactions(&self) -> Vec<Reaction> {
        let released = self.released.iter();
        let released =
            released.flat_map(|&driver| self.expansion.equations_of(Owner::Driver(driver)));
        // What a released driver held is held by nothing, so it shares no reaction.
        let kept: Vec<usize> = self.numbering.kept().iter().copied().chain(released).collect();
        let (state, kept) = (&self.now.state, (&kept[..], self.scales));
        let shared = undetermined(&self.expansion, &self.terms, state, &self.h, kept);
        self.loaded().reactions(|equation| !shared.contains(&equation))
    }

    /// How the velocities that were asked for fit the joints.
    pub fn start(&self) -> &StartReport {
        &self.start
    }

    /// What the integration has done so far.
    pub fn report(&self) -> &DynamicsReport {
        &self.report
    }
}
