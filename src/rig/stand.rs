//! A mechanism on the rig: moved by its drivers, loaded by its forces.

use super::channel::{
    Channel, body_channels, distinct, driven_channels, driver_channels, element_channels,
    joint_channels,
};
use super::corner::RigError;
use super::pose::Pose;
use super::rates::Rates;
use super::sweep::Specimen;
use super::target::Target;
use super::variable::VaryError;
use super::view::View;
use crate::mechanism::{Body, DriverId, Expansion, Mechanism};
use crate::model::Axes;
use crate::relation::Coordinates;
use crate::solve::equilibrium::Equilibrium;
use crate::solve::sensitivity::{Frame, Sensitivity};
use crate::solve::{
    FreedomReport, StaticFailure, StaticReport, StepReport, Stop, System, Tolerances,
};
use crate::vector::Vector;

/// A mechanism with its state.
///
/// Where joints and drivers determine the position, it follows the drivers, and forces only say what
/// the joints carry. Otherwise, and where drivers are released, every state is one of static equilibrium.
pub struct Stand {
    system: System,
    equilibrium: Equilibrium,
    released: Vec<DriverId>,
    /// Whether there are force elements.
    loaded: bool,
    /// Whether joints and drivers alone determine the position.
    rigid: bool,
    /// Whether the state is one of equilibrium.
    found: bool,
    /// The drivers that forces hold.
    by_force: Vec<DriverId>,
    axes: Axes,
    elements: Vec<Channel>,
    joints: Vec<Channel>,
    /// The design positions of the points (m).
    positions: Vec<Vector<f64>>,
    sensitivity: Option<Box<Sensitivity>>,
}

/// What sensitivities need of a state.
pub(super) struct Parts<'a> {
    pub frame: Frame<'a>,
    pub expansion: &'a Expansion,
    pub bodies: &'a [Body],
    pub positions: &'a [Vector<f64>],
    pub sensitivity: &'a mut Sensitivity,
}

impl Stand {
    /// Puts a mechanism on the rig at its design position, with some of its drivers taken away.
    /// Components are shown in the given axes.
    ///
    /// # Errors
    /// [`RigError`] where nothing can move or a driver cannot.
    pub fn new(mechanism: Mechanism, released: &[DriverId], axes: Axes) -> Result<Self, RigError> {
        let system = System::new(mechanism)?;
        let expansion = system.expansion();
        let bodies = body_channels(system.mechanism());
        let drivers = driver_channels(system.mechanism(), expansion, released);
        let elements = element_channels(system.mechanism(), expansion);
        let mut elements = [bodies, drivers, elements].concat();
        let mut joints = joint_channels(system.mechanism());
        distinct(elements.iter_mut().chain(&mut joints));
        Ok(Self {
            equilibrium: Equilibrium::released(&system, released),
            released: released.to_vec(),
            loaded: !expansion.elements().is_empty(),
            rigid: released.is_empty() && system.freedom().free_motions.is_empty(),
            found: false,
            by_force: vec![],
            axes,
            elements,
            joints,
            positions: system.mechanism().positions(),
            sensitivity: None,
            system,
        })
    }

    /// Degrees of freedom, redundant equations and free motions.
    pub fn freedom(&self) -> &FreedomReport {
        self.system.freedom()
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Mechanism {
        self.system.mechanism()
    }

    /// The mechanism as a system that its drivers move.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The equilibrium.
    pub fn equilibrium(&self) -> &Equilibrium {
        &self.equilibrium
    }

    /// The equilibrium, to change loads; the next state is sought anew.
    pub fn equilibrium_mut(&mut self) -> &mut Equilibrium {
        self.found = false;
        &mut self.equilibrium
    }

    /// Whether the mechanism has force elements.
    pub fn is_loaded(&self) -> bool {
        self.loaded
    }

    /// Whether the state is one of static equilibrium under the forces.
    pub fn is_in_equilibrium(&self) -> bool {
        self.found
    }

    /// Coordinates of all bodies, the ground first.
    pub fn state(&self) -> &[Coordinates<f64>] {
        self.equilibrium.state()
    }

    /// The value (m or rad, from the design position) of a driver.
    pub fn driver_value(&self, driver: DriverId) -> f64 {
        self.equilibrium.driver_value(driver)
    }

    /// How the stand moves and what it takes, near its state.
    pub fn rates(&mut self) -> Rates<'_> {
        let kinematic = self.rigid || !self.loaded;
        let system = kinematic.then_some(&mut self.system);
        let found = self.loaded && self.found;
        let linearised = self.equilibrium.linearised();
        Rates::new(system, linearised, found, &self.released, &self.positions)
    }

    /// What sensitivities need of the state: of the equilibrium, or of the position where there are no
    /// forces.
    pub(super) fn vary(&mut self) -> Result<Parts<'_>, VaryError> {
        if self.loaded && !self.found {
            return Err(VaryError::NoEquilibrium);
        }
        let Self { system, equilibrium, positions, sensitivity, .. } = self;
        let sensitivity = sensitivity.get_or_insert_with(|| {
            let bodies = system.mechanism().bodies();
            let origins = bodies.iter().map(|body| body.origin).collect();
            Box::new(Sensitivity::new(system.expansion(), origins))
        });
        // The half that is not asked lends what both have.
        Ok(if self.loaded {
            let (expansion, bodies) = (system.expansion(), system.mechanism().bodies());
            let frame = equilibrium.linearised().into_frame()?;
            Parts { frame, expansion, bodies, positions, sensitivity }
        } else {
            let (expansion, bodies) = (equilibrium.expansion(), equilibrium.mechanism().bodies());
            Parts { frame: system.frame()?, expansion, bodies, positions, sensitivity }
        })
    }

    /// The state.
    pub(super) fn view(&self) -> View<'_, f64> {
        View::of(&self.equilibrium, &self.positions)
    }

    /// The channels of bodies alone: positions and rotations.
    pub fn body_channels(&self) -> &[Channel] {
        &self.elements[..6 * (self.mechanism().bodies().len() - 1)]
    }

    /// The channels of all joints, which carry inertia also where no force element acts.
    pub fn reaction_channels(&self) -> &[Channel] {
        &self.joints
    }

    /// The channels of drivers and force elements: all but those of bodies.
    pub fn force_channels(&self) -> &[Channel] {
        &self.elements[self.body_channels().len()..]
    }

    /// The channels of a stand with wheels: of its drivers and of its first forces, those of the model.
    /// Forces of the travel drivers are wheel loads, which are factors; what the rig puts on the
    /// wheels is an input, not a result.
    pub(super) fn model_channels(&self, own_forces: usize, travels: &[DriverId]) -> Vec<Channel> {
        let (mechanism, expansion) = (self.mechanism(), self.system.expansion());
        let own = |channel: &Channel| channel.force().is_some_and(|f| f.index() < own_forces);
        let mut channels = driver_channels(mechanism, expansion, travels);
        channels.extend(driven_channels(mechanism, expansion));
        channels.extend(element_channels(mechanism, expansion).into_iter().filter(own));
        distinct(channels.iter_mut());
        channels
    }

    /// The values (SI) of channels and, behind them, of those of joints.
    pub(super) fn values(&self, channels: &[Channel]) -> Vec<f64> {
        let (loaded, reactions) = (self.equilibrium.loaded(), self.equilibrium.reactions());
        let channels = channels.iter().chain(self.joint_channels());
        channels.map(|channel| channel.value(&loaded, &reactions, self.axes)).collect()
    }

    /// Moves drivers to values (m or rad, from the design position).
    ///
    /// # Errors
    /// [`Stop`] where the mechanism cannot go on or has no equilibrium. It then stays where it got to.
    pub fn move_to(&mut self, targets: &[(DriverId, f64)]) -> Result<StepReport, Stop> {
        self.by_force.clear();
        if self.rigid || !self.loaded { self.move_rigidly(targets) } else { self.follow(targets) }
    }

    /// The drivers that forces hold, not values.
    pub(super) fn by_force(&self) -> &[DriverId] {
        &self.by_force
    }

    /// Says which drivers forces hold.
    pub(super) fn hold_by_force(&mut self, drivers: impl IntoIterator<Item = DriverId>) {
        self.by_force.clear();
        self.by_force.extend(drivers);
    }

    /// Lets the mechanism find its equilibrium with the drivers where they are.
    ///
    /// # Errors
    /// [`StaticFailure`] where there is none.
    pub fn rest(&mut self) -> Result<StaticReport, StaticFailure> {
        self.found = false;
        let report = self.equilibrium.find()?;
        self.found = true;
        Ok(report)
    }

    /// Moves drivers to values (m or rad, from the design position) and takes the state that is reached there
    /// for the one from which drivers count and to which [`Self::reset`] returns.
    ///
    /// # Errors
    /// As for [`Self::move_to`].
    pub(super) fn start_from(&mut self, targets: &[(DriverId, f64)]) -> Result<(), Stop> {
        let mut values = vec![0.0; self.mechanism().drivers().len()];
        for &(driver, value) in targets {
            values[driver.index()] = value;
        }
        let state = if self.released.is_empty() {
            self.move_to(targets)?;
            self.equilibrium.state().to_vec()
        } else {
            // Where wheels that are let go come to rest is sought from the state in which the rig holds them.
            self.system.move_to(targets)?;
            self.system.state().to_vec()
        };
        self.system.start_from(&state, &values);
        self.reset();
        Ok(())
    }

    /// Returns to the start. Laws that were changed stay as they are.
    pub fn reset(&mut self) {
        self.system.reset();
        self.equilibrium.restart(&self.system);
        self.found = false;
        self.by_force.clear();
    }

    /// Takes other design positions (m) of all points, and other values of the lengths from which force elements
    /// measure, by their parameters. It returns to the design position.
    pub(super) fn reshape(&mut self, positions: &[Vector<f64>], lengths: &[(usize, f64)]) {
        self.positions.copy_from_slice(positions);
        self.system.reshape(positions);
        self.equilibrium.reshape(&self.system, lengths);
        self.found = false;
    }

    /// Moves joints, which alone determine the position, then finds what they carry.
    fn move_rigidly(&mut self, targets: &[(DriverId, f64)]) -> Result<StepReport, Stop> {
        let mut report = self.system.move_to(targets)?;
        self.equilibrium.state_mut().copy_from_slice(self.system.state());
        for driver in self.system.mechanism().driver_ids() {
            self.equilibrium.set_driver(driver, self.system.driver_value(driver));
        }
        if !self.loaded {
            return Ok(report);
        }
        let outcome = self.equilibrium.solve(&Tolerances::default());
        report.iterations += outcome.iterations;
        report.relative_residual = report.relative_residual.max(outcome.relative_residual);
        self.found = outcome.converged();
        if self.found {
            self.equilibrium.elements_mut().accept();
            return Ok(report);
        }
        match self.rest() {
            Ok(_) => Ok(report),
            Err(failure) => Err(Stop::no_equilibrium(self.system.mechanism(), failure, &[])),
        }
    }

    /// Follows the equilibrium of a compliant mechanism.
    fn follow(&mut self, targets: &[(DriverId, f64)]) -> Result<StepReport, Stop> {
        match self.try_follow(targets) {
            Ok(report) => Ok(report),
            Err(failure) => {
                let way = |&(driver, target)| (driver, self.driver_value(driver), target);
                let ways: Vec<_> = targets.iter().map(way).collect();
                Err(Stop::no_equilibrium(self.system.mechanism(), failure, &ways))
            }
        }
    }

    fn try_follow(&mut self, targets: &[(DriverId, f64)]) -> Result<StepReport, StaticFailure> {
        let mut sum = StepReport::default();
        let mut add = |report: StaticReport| {
            sum.iterations += report.iterations;
            sum.steps += report.load_steps;
            sum.relative_residual = report.relative_residual;
        };
        if !self.found {
            add(self.rest()?);
        }
        let held = |&&(driver, value): &&(DriverId, f64)| {
            !self.released.contains(&driver) && self.driver_value(driver) != value
        };
        let targets: Vec<(DriverId, f64)> = targets.iter().filter(held).copied().collect();
        if !targets.is_empty() {
            add(self.equilibrium.move_to(&targets)?);
        }
        Ok(sum)
    }
}

impl Specimen for Stand {
    fn go_to(&mut self, target: &Target) -> Result<StepReport, Stop> {
        // Wheels, rack and chassis belong to corners and axles.
        target.driver.map_or_else(|| Ok(StepReport::default()), |target| self.move_to(&[target]))
    }

    fn reset(&mut self) {
        Self::reset(self);
    }

    fn mechanism(&self) -> &Mechanism {
        self.system.mechanism()
    }

    fn poses(&mut self) -> Vec<Pose<f64>> {
        vec![]
    }

    fn element_channels(&self) -> &[Channel] {
        &self.elements
    }

    fn joint_channels(&self) -> &[Channel] {
        if self.loaded { &self.joints } else { &[] }
    }

    fn channel_values(&self) -> Vec<f64> {
        self.values(&self.elements)
    }

    fn free_motions(&self) -> Vec<String> {
        if self.loaded {
            return vec![];
        }
        self.freedom().free_motions.iter().map(|motion| motion.description.clone()).collect()
    }
}
