//! A mechanism that can be moved.

use thiserror::Error;

use super::freedom::{self, BlockedDriver, FreedomReport};
use super::linear::Singular;
use super::motion;
use super::position::{Position, Scales};
use super::rank::{scaled_jacobian, select};
use super::sensitivity::Frame;
use super::stop::{Stop, StopReason};
use super::tangent::Tangent;
use super::travel::{Failure, Travel};
use crate::assembly::{Numbering, Terms, design_state};
use crate::mechanism::{BodyId, DriverId, Expansion, Mechanism, Owner, PointId};
use crate::relation::Coordinates;

/// The part of the way that a new choice of equations has to gain.
const PROGRESS: f64 = 1e-6;

/// Why a mechanism cannot be solved at all.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SystemError {
    /// There is nothing to move.
    #[error("the mechanism has no moving body; add one")]
    NoBodies,
    /// A driver prescribes what joints or other drivers hold.
    #[error(
        "driver `{}` cannot move: at the design position its motion is held by {}. \
         Remove one of them, free a joint, or move the points off this dead centre",
        .0.name, .0.held_by.join(", ")
    )]
    BlockedDriver(BlockedDriver),
    /// The points are so far apart that numbers overflow.
    #[error(
        "the design position gives numbers that are not finite; check the coordinates and their unit"
    )]
    NotFinite,
}

/// How a motion went.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Newton iterations, those of rejected steps included.
    pub iterations: usize,
    /// Accepted steps of the continuation.
    pub steps: usize,
    /// The largest residual at the end, each equation divided by the size of its terms.
    pub relative_residual: f64,
}

/// A mechanism with its state, ready to be moved by its drivers.
///
/// The state starts at the design position. Every motion continues from
/// the current state, so it stays on the branch on which the mechanism was
/// assembled.
///
/// ```
/// use hardpoint::mechanism::{BodyId, Direction, DriverKind, JointKind, Mechanism};
/// use hardpoint::solve::System;
///
/// let mut pendulum = Mechanism::new("ground");
/// let rod = pendulum.add_body("rod", [0.0; 3])?;
/// let pin = pendulum.add_point("pin", [0.0; 3])?;
/// let tip = pendulum.add_point("tip", [0.0, 0.0, -1.0])?;
/// let axis = Direction::Fixed([1.0, 0.0, 0.0]);
/// pendulum.add_joint("hinge", BodyId::GROUND, rod, JointKind::Revolute { at: pin, axis })?;
/// let swing = pendulum.add_driver("swing", BodyId::GROUND, rod, DriverKind::Rotation { axis })?;
///
/// let mut system = System::new(pendulum)?;
/// system.move_to(&[(swing, std::f64::consts::FRAC_PI_2)])?;
/// let [x, y, z] = system.point_position(rod, tip);
/// assert!(x.abs() < 1e-12 && (y - 1.0).abs() < 1e-12 && z.abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct System {
    mechanism: Mechanism,
    expansion: Expansion,
    terms: Terms,
    freedom: FreedomReport,
    position: Position,
    travel: Travel,
    // State and parameters with all drivers at zero.
    start: Vec<Coordinates<f64>>,
    base: Vec<f64>,
    targets: Vec<f64>,
}

impl System {
    /// Analyses the mechanism at its design position and sets everything up that the motion needs.
    ///
    /// # Errors
    /// [`SystemError`] if nothing can move or a driver cannot. Redundant equations and free
    /// motions are no errors: see [`Self::freedom`]. Free motions stay as still as they can.
    pub fn new(mechanism: Mechanism) -> Result<Self, SystemError> {
        if mechanism.bodies().len() < 2 {
            return Err(SystemError::NoBodies);
        }
        let expansion = Expansion::new(&mechanism);
        let terms = Terms::new(&expansion);
        let state = design_state(mechanism.bodies());
        let h: Vec<f64> = expansion.parameters(&mechanism.positions());
        let scales = Scales::of(&mechanism);
        let (jacobian, mut sizes) = scaled_jacobian(&expansion, &terms, &state, &h, scales);
        if !h.iter().chain(&sizes).all(|number| number.is_finite()) {
            return Err(SystemError::NotFinite);
        }
        sizes.iter_mut().filter(|size| **size == 0.0).for_each(|size| *size = 1.0);

        let freedom = freedom::report(&mechanism, &expansion, jacobian.as_ref(), &state, scales);
        if let Some(blocked) = freedom.blocked_drivers.first() {
            return Err(SystemError::BlockedDriver(blocked.clone()));
        }
        let left_out: Vec<usize> = freedom.redundant.iter().map(|r| r.equation).collect();
        let numbering = Numbering::new(&expansion, &left_out);
        let (start, base) = (state.clone(), h.clone());
        let position = Position::new(terms.clone(), numbering, scales, sizes, state, h);
        let (slots, drivers) = (expansion.driver_slots().clone(), mechanism.drivers().len());
        Ok(Self {
            travel: Travel::new(&position, slots, drivers, !left_out.is_empty()),
            targets: vec![0.0; mechanism.drivers().len()],
            mechanism,
            expansion,
            terms,
            freedom,
            position,
            start,
            base,
        })
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// The mechanism as relations.
    pub fn expansion(&self) -> &Expansion {
        &self.expansion
    }

    /// Redundant equations and free motions at the design position.
    pub fn freedom(&self) -> &FreedomReport {
        &self.freedom
    }

    /// Coordinates of all bodies, the ground first.
    pub fn state(&self) -> &[Coordinates<f64>] {
        &self.position.state
    }

    /// The parameters h of all relations, with the current values of the drivers.
    pub fn parameters(&self) -> &[f64] {
        &self.position.h
    }

    /// The value that a driver has reached (m or rad), measured from the design position.
    pub fn driver_value(&self, driver: DriverId) -> f64 {
        self.travel.values()[driver.index()]
    }

    /// Sets the value (m or rad) that the next [`Self::move_to`] takes a driver to.
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn set_driver(&mut self, driver: DriverId, value: f64) {
        self.targets[driver.index()] = value;
    }

    /// Moves from the current state until the given drivers have the given values (m or
    /// rad, measured from the design position); the others keep theirs or go where
    /// [`Self::set_driver`] sends them. All drivers move in proportion.
    ///
    /// # Errors
    /// [`Stop`] says where the mechanism cannot go on and why. The state is then the last one
    /// that was reached.
    ///
    /// # Panics
    /// If a driver belongs to another mechanism.
    pub fn move_to(&mut self, targets: &[(DriverId, f64)]) -> Result<StepReport, Stop> {
        for &(driver, value) in targets {
            self.set_driver(driver, value);
        }
        let moved = match self.targets.iter().position(|value| !value.is_finite()) {
            Some(driver) => {
                Err(StopReason::NotFinite { driver: self.mechanism.drivers()[driver].name.clone() })
            }
            None => self.travel().map_err(|failure| self.explain(failure)),
        };
        moved.map_err(|reason| {
            let stop = Stop::new(&self.mechanism, reason, self.travel.values(), &self.targets);
            self.targets.copy_from_slice(self.travel.values());
            stop
        })
    }

    /// How all bodies move per unit (m or rad) of a driver at the current state, the other drivers
    /// held: −Φ_q⁻¹ Φ_h. Forces play no part; free motions stay as still as they can.
    ///
    /// # Errors
    /// [`Singular`] where the mechanism is in a dead centre.
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn tangent(&mut self, driver: DriverId) -> Result<Tangent<'_>, Singular> {
        let rates = self.travel.driver_tangent(&mut self.position, driver)?;
        Ok(Tangent::new(&self.position.state, rates))
    }

    /// The current state with its factorised matrix, for sensitivities of the position alone.
    ///
    /// # Errors
    /// [`Singular`] where the mechanism is in a dead centre.
    pub fn frame(&mut self) -> Result<Frame<'_>, Singular> {
        let Self { travel, position, expansion, .. } = self;
        let linear = travel.factorised_here(position)?;
        let position = &*position;
        Ok(Frame {
            linear,
            size: position.size(),
            first: position.size() - position.kept().len(),
            numbering: position.numbering(),
            state: &position.state,
            h: &position.h,
            balance: None,
            slots: expansion.driver_slots(),
            equations: expansion.equation_count(),
        })
    }

    /// Returns to where all drivers are at zero: the design position, or the state that
    /// [`Self::start_from`] was given.
    pub fn reset(&mut self) {
        self.position.state.copy_from_slice(&self.start);
        self.position.h.copy_from_slice(&self.base);
        self.targets.fill(0.0);
        self.travel.reset();
    }

    /// Moves the design positions (m) of points, and goes there with all drivers at zero. Frames of bodies stay
    /// where they are, and so do the choices that were made at the first design position: which equations are
    /// independent, and with which coordinate axes normals are built.
    ///
    /// # Panics
    /// If there are not as many positions as points.
    pub fn reshape(&mut self, positions: &[[f64; 3]]) {
        self.mechanism.set_positions(positions);
        self.base = self.expansion.parameters(positions);
        self.start = design_state(self.mechanism.bodies());
        self.reset();
    }

    /// Takes a state with these values of drivers (m or rad) for the one that all drivers count from, and goes
    /// there. The joints have to hold in it.
    ///
    /// # Panics
    /// If state or values belong to another mechanism.
    pub fn start_from(&mut self, state: &[Coordinates<f64>], values: &[f64]) {
        let base = self.base.clone();
        self.expansion.driver_slots().set(&base, values, &mut self.base);
        self.start.copy_from_slice(state);
        self.reset();
    }

    /// Where a point of a body is (m). The point moves with the body, whichever joint it belongs to.
    ///
    /// # Panics
    /// If body or point belong to another mechanism.
    pub fn point_position(&self, body: BodyId, point: PointId) -> [f64; 3] {
        motion::point_position(&self.mechanism, self.state(), body, point)
    }

    /// The rotation matrix of a body, row by row: it turns directions from the design position to
    /// the current one.
    ///
    /// # Panics
    /// If the body belongs to another mechanism.
    pub fn rotation(&self, body: BodyId) -> [[f64; 3]; 3] {
        motion::rotation(self.state(), body)
    }

    /// The parameters with all drivers at zero.
    pub(super) fn base(&self) -> &[f64] {
        &self.base
    }

    pub(super) fn position(&self) -> &Position {
        &self.position
    }

    pub(super) fn terms(&self) -> &Terms {
        &self.terms
    }

    /// The independent equations without those of drivers that are let go.
    pub(super) fn numbering_without(&self, released: &[DriverId]) -> Numbering {
        let left_out: Vec<usize> = (0..self.expansion.equation_count())
            .filter(|&equation| {
                let owner = self.expansion.owner(equation);
                let free = matches!(owner, Owner::Driver(driver) if released.contains(&driver));
                free || self.position.numbering().row(equation).is_none()
            })
            .collect();
        Numbering::new(&self.expansion, &left_out)
    }

    /// Moves the drivers to their targets.
    ///
    /// Equations that are independent at the design position may depend on each
    /// other elsewhere while left-out ones do not. So before a mechanism with
    /// redundant equations is stopped, they are chosen anew where it is.
    fn travel(&mut self) -> Result<StepReport, Failure> {
        let mut report = StepReport::default();
        let mut way = f64::INFINITY;
        loop {
            let Self { travel, position, base, targets, .. } = self;
            let Err(failure) = travel.move_to(position, base, targets, &mut report) else {
                return Ok(report);
            };
            let remaining = travel.remaining(targets);
            if remaining > (1.0 - PROGRESS) * way || !self.replan() {
                return Err(failure);
            }
            way = remaining;
        }
    }

    /// Chooses independent equations at the current state; returns whether that changed anything.
    fn replan(&mut self) -> bool {
        let Self { expansion, terms, position, .. } = self;
        if position.kept().len() == expansion.equation_count() {
            return false;
        }
        let (state, h, scales) = (&position.state, &position.h, position.scales);
        let (jacobian, _) = scaled_jacobian(expansion, terms, state, h, scales);
        let selection = select(expansion, jacobian.as_ref());
        let as_many = selection.kept.len() == position.kept().len();
        let row = |&equation: &usize| position.numbering().row(equation);
        if !as_many || selection.left_out.iter().all(|equation| row(equation).is_none()) {
            return false;
        }
        let numbering = Numbering::new(expansion, &selection.left_out);
        self.position = position.with_equations(terms.clone(), numbering);
        self.travel.replan(&self.position);
        true
    }

    /// Says why the travel failed. Only called on failure, so it may take its time.
    fn explain(&self, failure: Failure) -> StopReason {
        super::stop::explain(
            &self.mechanism,
            &self.expansion,
            &self.terms,
            &self.position,
            (&self.start, &self.base),
            failure,
        )
    }
}
