//! A corner on the rig.

use thiserror::Error;

use super::adjust::{self, AdjustError, Adjustment};
use super::channel::Channel;
use super::compliance::Compliance;
use super::hold::Hold;
use super::load::{Load, LoadPoint, WheelLoads};
use super::pose::Pose;
use super::settled::Settled;
use super::shape::{Origins, Shape};
use super::stand::Stand;
use super::station::Station;
use super::sweep::Specimen;
use super::target::{Supports, Target};
use super::variable::{Variable, VaryError};
use super::varied::Varied;
use super::view::View;
use crate::assembly::ElementConstant;
use crate::mechanism::{DriverId, Force, Mechanism, MechanismError};
use crate::model::{Model, Setup, Steering, Suspension, SuspensionError, WheelSupport};
use crate::relation::Coordinates;
use crate::solve::compliance::ComplianceError;
use crate::solve::equilibrium::Equilibrium;
use crate::solve::{
    FreeMotion, FreedomReport, StaticFailure, StaticReport, StepReport, Stop, SystemError,
};

/// Why a corner cannot be put on the rig.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RigError {
    /// The points make no mechanism.
    #[error(transparent)]
    Mechanism(#[from] MechanismError),
    /// The model cannot be set up like this.
    #[error(transparent)]
    Suspension(#[from] SuspensionError),
    /// The mechanism cannot be solved.
    #[error(transparent)]
    System(#[from] SystemError),
    /// The static state that the model asks for is out of reach.
    #[error(transparent)]
    Adjust(Box<AdjustError>),
}

impl From<AdjustError> for RigError {
    fn from(error: AdjustError) -> Self {
        Self::Adjust(Box::new(error))
    }
}

/// One corner of a vehicle on the rig.
///
/// The height of the wheel and the rack are driven, or the wheel stands on its tyre. Where the
/// model has forces, every state is one of static equilibrium.
pub struct Corner {
    suspension: Suspension,
    station: Station,
    stand: Stand,
    loads: Option<WheelLoads>,
    load: Load,
    own_forces: usize,
    elements: Vec<Channel>,
    measures_compliance: bool,
    steering: Steering,
    adjustments: Vec<Adjustment>,
    origins: Origins,
    settled: Option<Settled>,
}

impl Corner {
    /// Puts a model on the rig in its static state: with adjusters and ride height as `[static]` of the model
    /// asks for, else at the design position. Travel and all changes count from there.
    ///
    /// # Errors
    /// [`RigError`] for geometry without meaning, a wheel that cannot move or a static state out of reach.
    pub fn new(model: &Model, setup: &Setup) -> Result<Self, RigError> {
        Self::with_loads(model, setup, LoadPoint::default())
    }

    /// As [`Self::new`], with the point at which [`Self::set_load`] loads the wheel.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn with_loads(model: &Model, setup: &Setup, at: LoadPoint) -> Result<Self, RigError> {
        let (set, settled) = adjust::corner(model, setup)?.unzip();
        let home = set.as_ref().map(|set| set.home);
        let mut suspension = model.suspension(setup)?;
        let own_forces = suspension.mechanism.forces().len();
        let loads = match model.has_forces() {
            true => {
                let Suspension { mechanism, wheel, .. } = &mut suspension;
                Some(WheelLoads::add(mechanism, wheel, "", at, home.as_ref(), model.axes)?)
            }
            false => None,
        };
        let released = match setup.support {
            WheelSupport::Held => vec![],
            WheelSupport::Free => vec![suspension.travel],
        };
        let mut stand = Stand::new(suspension.mechanism.clone(), &released, model.axes)?;
        if let Some(set) = &set {
            let drivers = set.drivers(&suspension.adjusters, suspension.travel);
            stand.start_from(&drivers).map_err(|stop| AdjustError::Start(Box::new(stop)))?;
        }
        let elements = match loads {
            Some(_) => stand.model_channels(own_forces, &[suspension.travel]),
            None => vec![],
        };
        Ok(Self {
            origins: Origins::of(stand.mechanism(), &[model], &[home]),
            station: Station::of_corner(&suspension, model, setup).on(&stand, home),
            load: Load::default(),
            settled,
            suspension,
            stand,
            loads,
            elements,
            own_forces,
            measures_compliance: false,
            steering: model.steering.unwrap_or_default(),
            adjustments: set.map_or_else(Vec::new, |set| set.adjustments),
        })
    }

    /// Degrees of freedom, redundant equations and free motions.
    pub fn freedom(&self) -> &FreedomReport {
        self.stand.freedom()
    }

    /// The free motions that move the wheel, its steer axis or its spring; with one of them their position
    /// is not determined by travel and rack. Where the model has forces they hold what joints
    /// leave free, or there is no equilibrium.
    pub fn free_wheel_motions(&self) -> impl Iterator<Item = &FreeMotion> {
        let kinematic = self.loads.is_none();
        let motions = self.freedom().free_motions.iter();
        motions.filter(move |motion| kinematic && self.station.is_moved(motion))
    }

    /// What the adjusters are set to; none where the model asks for no static state.
    pub fn adjustments(&self) -> &[Adjustment] {
        &self.adjustments
    }

    /// The suspension.
    pub fn suspension(&self) -> &Suspension {
        &self.suspension
    }

    /// The equilibrium.
    pub fn equilibrium(&self) -> &Equilibrium {
        self.stand.equilibrium()
    }

    /// The mechanism on the rig.
    pub fn stand(&self) -> &Stand {
        &self.stand
    }

    /// The force elements of the model, without the loads that the rig puts on the wheel.
    pub fn forces(&self) -> &[Force] {
        &self.stand.mechanism().forces()[..self.own_forces]
    }

    /// Whether the suspension has a rack.
    pub fn steers(&self) -> bool {
        self.suspension.rack.is_some()
    }

    /// Sets the load on the wheel for the next state. A model without forces ignores it: its
    /// position does not depend on loads.
    pub fn set_load(&mut self, load: &Load) {
        if let Some(loads) = &self.loads
            && self.load != *load
        {
            self.load = *load;
            loads.set(self.stand.equilibrium_mut(), load);
        }
    }

    /// Moves the wheel to a travel and the rack to a displacement (m, both from the static
    /// state or the design position) from where they are. A suspension without a rack ignores `rack`, a wheel that stands
    /// on its tyre ignores `travel`.
    ///
    /// # Errors
    /// [`Stop`] where the mechanism cannot go on or has no equilibrium, and beyond the limits of the rack. It
    /// then stays where it got to.
    pub fn move_to(&mut self, travel: f64, rack: f64) -> Result<StepReport, Stop> {
        self.hold(Hold::Value(travel), rack)
    }

    /// As [`Self::move_to`], with the wheel held at a travel or by a vertical force (N, positive up on
    /// the wheel).
    ///
    /// # Errors
    /// As for [`Self::move_to`], and where no travel has the force.
    pub fn hold(&mut self, wheel: Hold, rack: f64) -> Result<StepReport, Stop> {
        let mut targets = vec![(self.suspension.travel, wheel)];
        if let Some(driver) = self.suspension.rack {
            if let Some(limit) = self.steering.exceeded(rack) {
                let from = self.stand.driver_value(driver);
                return Err(Stop::limit("rack", from, rack, limit));
            }
            targets.push((driver, Hold::Value(rack)));
        }
        self.stand.hold(&targets)
    }

    /// Lets the corner find its equilibrium at the current travel and rack.
    ///
    /// # Errors
    /// [`StaticFailure`] where there is none.
    pub fn rest(&mut self) -> Result<StaticReport, StaticFailure> {
        self.stand.rest()
    }

    /// Returns to the static state or the design position. The load on the wheel stays.
    pub fn reset(&mut self) {
        self.stand.reset();
    }

    /// The channels of the rack and of force elements; none where the model has no forces.
    pub fn element_channels(&self) -> &[Channel] {
        &self.elements
    }

    /// Sets whether [`Self::pose`] measures how the wheel gives way to loads.
    pub fn measure_compliance(&mut self, measures: bool) {
        self.measures_compliance = measures;
    }

    /// Where wheel, steer axis and spring are, how they move, what the wheel carries, and how it gives way
    /// where that is measured.
    pub fn pose(&mut self) -> Pose<f64> {
        let Self { station, stand, measures_compliance, .. } = self;
        let mut pose = station.pose(stand);
        let mut rates = stand.rates();
        station.move_along(&mut pose, &mut rates);
        if *measures_compliance && station.is_held() && pose.motions.is_some() {
            let station = std::slice::from_ref(station);
            let matrix = Compliance::of(rates.equilibrium(), station, &[pose]).ok();
            pose.compliance = matrix.map(|matrix| matrix.of_wheel(0));
        }
        pose
    }

    /// The compliance of the wheel at the current travel, rack and load; the equilibrium is found first
    /// where it is not known yet.
    ///
    /// # Errors
    /// [`ComplianceError`] where there is no equilibrium, or the wheel has no stiffness without
    /// the rig.
    pub fn compliance(&mut self) -> Result<Compliance, ComplianceError> {
        if self.stand.is_loaded() && !self.stand.is_in_equilibrium() {
            self.rest()?;
        }
        let Self { station, stand, .. } = self;
        let pose = station.pose_at(&stand.view());
        let station = std::slice::from_ref(station);
        Compliance::of(stand.rates().equilibrium(), station, &[pose])
    }

    /// Where wheel, steer axis and spring are at a state of the mechanism, with drivers that are held
    /// where they are. How they move and what the wheel carries is not known there.
    ///
    /// # Panics
    /// If the state belongs to another mechanism.
    pub fn pose_at(&self, state: &[Coordinates<f64>]) -> Pose<f64> {
        self.station.pose_at(&View { state, ..self.stand.view() })
    }
}

impl Specimen for Corner {
    fn go_to(&mut self, target: &Target) -> Result<StepReport, Stop> {
        let side = self.station.side.index();
        self.set_load(&target.load[side]);
        self.hold(target.wheels[side], target.rack)
    }

    fn supports(&self) -> Supports {
        // The wheel of the other side is not there; it takes part in no event.
        let force = self.stand.driver_force(self.suspension.travel);
        Supports { wheels: [force; 2], chassis: 0.0 }
    }

    fn reset(&mut self) {
        Self::reset(self);
    }

    fn mechanism(&self) -> &Mechanism {
        self.stand.mechanism()
    }

    fn poses(&mut self) -> Vec<Pose<f64>> {
        vec![Self::pose(self)]
    }

    fn element_channels(&self) -> &[Channel] {
        &self.elements
    }

    fn joint_channels(&self) -> &[Channel] {
        self.stand.joint_channels()
    }

    fn channel_values(&self) -> Vec<f64> {
        self.stand.values(&self.elements)
    }

    fn free_motions(&self) -> Vec<String> {
        self.free_wheel_motions().map(|motion| motion.description.clone()).collect()
    }
}

impl Variable for Corner {
    fn stand(&self) -> &Stand {
        Self::stand(self)
    }

    fn measure_compliance(&mut self, measures: bool) {
        Self::measure_compliance(self, measures);
    }

    fn adjusters(&self, adjuster: usize) -> Vec<DriverId> {
        vec![self.suspension.adjusters[adjuster]]
    }

    fn sides(&self) -> usize {
        1
    }

    fn reshape(
        &mut self,
        shapes: &[Shape<f64>],
        constants: &[(ElementConstant, f64)],
        lengths: &[(usize, f64)],
    ) -> Result<(), VaryError> {
        let Self { station, stand, origins, .. } = self;
        Varied::reshape(stand, std::slice::from_ref(station), origins, shapes, constants, lengths)
    }

    fn settled(&self) -> Option<&Settled> {
        self.settled.as_ref()
    }

    fn vary(
        &mut self,
        constants: &[ElementConstant],
        compliance: bool,
    ) -> Result<Varied<'_>, VaryError> {
        let Self { station, stand, origins, settled, .. } = self;
        let stations = std::slice::from_ref(station);
        Varied::of(stand, stations, origins, constants, compliance, settled.as_mut())
    }
}
