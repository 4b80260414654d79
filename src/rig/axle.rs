//! An axle on the rig.

use super::adjust::{self, AdjustError, Adjustment};
use super::channel::{Channel, heave_channel};
use super::compliance::Compliance;
use super::corner::RigError;
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
use crate::mechanism::{DriverId, Force, Mechanism};
use crate::model::{AxleSide, AxleSuspension, Model, Rolling, Setup, Side, Steering, WheelSupport};
use crate::relation::Coordinates;
use crate::solve::compliance::ComplianceError;
use crate::solve::equilibrium::Equilibrium;
use crate::solve::{
    FreeMotion, FreedomReport, StaticFailure, StaticReport, StepReport, Stop, Tangent,
};

/// Both wheels of an axle on the rig, the chassis fixed, or rolled and heaved by the rig.
///
/// The heights of the wheels and the rack are driven, or the wheels stand on their tyres. Where the
/// model has forces, every state is one of static equilibrium. Pairs of values are left, right.
pub struct Axle {
    suspension: AxleSuspension,
    stations: [Station; 2],
    stand: Stand,
    loads: Option<[WheelLoads; 2]>,
    load: [Load; 2],
    own_forces: usize,
    elements: Vec<Channel>,
    measures_compliance: bool,
    steering: Steering,
    adjustments: Vec<Adjustment>,
    origins: Origins,
    settled: Option<Settled>,
}

impl Axle {
    /// Puts a model and its mirror image on the rig, in the static state that the model asks for or at the
    /// design position. Travel and all changes count from there.
    ///
    /// # Errors
    /// [`RigError`] for geometry without meaning, a wheel that cannot move or a static state out of reach.
    pub fn new(model: &Model, setup: &Setup) -> Result<Self, RigError> {
        Self::with_loads(model, setup, LoadPoint::default())
    }

    /// As [`Self::new`], with the point at which [`Self::set_load`] loads the wheels.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn with_loads(model: &Model, setup: &Setup, at: LoadPoint) -> Result<Self, RigError> {
        Self::with_sides(model, &model.other_side(), setup, at)
    }

    /// As [`Self::with_loads`], with another model for the other side.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn with_sides(
        model: &Model,
        other: &Model,
        setup: &Setup,
        at: LoadPoint,
    ) -> Result<Self, RigError> {
        let suspension = |setup: &Setup| Ok(model.axle_with(other, setup)?);
        let models = match model.side {
            Side::Left => [model, other],
            Side::Right => [other, model],
        };
        let (set, settled) = adjust::axle(models, setup, suspension)?.unzip();
        let mut suspension = suspension(setup)?;
        let homes = [0, 1].map(|k| set.as_ref().map(|set| set[k].home));
        let axes = model.axes;
        let own_forces = suspension.mechanism.forces().len();
        let loads = match model.axle_has_forces() {
            true => {
                let AxleSuspension { mechanism, sides, .. } = &mut suspension;
                let mut add = |part: &AxleSide| {
                    let prefix = format!("{} ", part.side.name());
                    let home = homes[part.side.index()].as_ref();
                    WheelLoads::add(mechanism, &part.wheel, &prefix, at, home, axes)
                };
                Some([add(&sides[0])?, add(&sides[1])?])
            }
            false => None,
        };
        let released = match setup.support {
            WheelSupport::Held => vec![],
            WheelSupport::Free => suspension.sides.map(|part| part.travel).to_vec(),
        };
        let mut stand = Stand::new(suspension.mechanism.clone(), &released, axes)?;
        if let Some(set) = &set {
            let sides = set.iter().zip(&suspension.sides).zip(&suspension.adjusters);
            let drivers = sides.flat_map(|((set, part), by)| set.drivers(by, part.travel));
            let drivers: Vec<_> = drivers.collect();
            stand.start_from(&drivers).map_err(|stop| AdjustError::Start(Box::new(stop)))?;
        }
        let mut elements = vec![];
        if loads.is_some() {
            let heave = suspension.rolling.map(|rolling| rolling.body);
            elements.extend(heave.map(|chassis| heave_channel(stand.mechanism(), chassis)));
            let travels = suspension.sides.map(|part| part.travel);
            elements.extend(stand.model_channels(own_forces, &travels));
        }
        let station = |side: Side| {
            let station = Station::of_axle(&suspension, side, model, setup);
            station.on(&stand, homes[side.index()])
        };
        Ok(Self {
            origins: Origins::of(stand.mechanism(), &models, &homes),
            stations: [station(Side::Left), station(Side::Right)],
            adjustments: set.into_iter().flatten().flat_map(|set| set.adjustments).collect(),
            load: [Load::default(); 2],
            settled,
            elements,
            suspension,
            stand,
            loads,
            own_forces,
            measures_compliance: false,
            steering: model.steering.unwrap_or_default(),
        })
    }

    /// Degrees of freedom, redundant equations and free motions.
    pub fn freedom(&self) -> &FreedomReport {
        self.stand.freedom()
    }

    /// The free motions that move a wheel, a steer axis or a spring of a model without forces; with one of
    /// them their position is not determined by travels and rack.
    pub fn free_wheel_motions(&self) -> impl Iterator<Item = &FreeMotion> {
        let kinematic = self.loads.is_none();
        let motions = self.freedom().free_motions.iter();
        motions.filter(move |motion| {
            kinematic && self.stations.iter().any(|station| station.is_moved(motion))
        })
    }

    /// What the adjusters are set to; none where the model asks for no static state.
    pub fn adjustments(&self) -> &[Adjustment] {
        &self.adjustments
    }

    /// The suspension.
    pub fn suspension(&self) -> &AxleSuspension {
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

    /// The force elements of the model, without the loads that the rig puts on the wheels.
    pub fn forces(&self) -> &[Force] {
        &self.stand.mechanism().forces()[..self.own_forces]
    }

    /// Whether the axle has a rack.
    pub fn steers(&self) -> bool {
        self.suspension.rack.is_some()
    }

    /// Sets the loads on the wheels for the next state. A model without forces ignores them: its
    /// position does not depend on loads.
    pub fn set_load(&mut self, load: &[Load; 2]) {
        if let Some(loads) = &self.loads
            && self.load != *load
        {
            self.load = *load;
            for (loads, load) in loads.iter().zip(load) {
                loads.set(self.stand.equilibrium_mut(), load);
            }
        }
    }

    /// Moves the wheels to travels and the rack to a displacement (m, all from the static
    /// state or the design position) from where they are. An axle without a rack ignores `rack`, wheels that stand
    /// on their tyres ignore `travel`.
    ///
    /// # Errors
    /// [`Stop`] where the mechanism cannot go on or has no equilibrium, and beyond the limits of the rack. It
    /// then stays where it got to.
    pub fn move_to(&mut self, travel: [f64; 2], rack: f64) -> Result<StepReport, Stop> {
        self.hold(&Target { wheels: travel.map(Hold::Value), rack, ..Target::default() })
    }

    /// As [`Self::move_to`], with wheels that are held by vertical forces (N, positive up on the wheel)
    /// where the target says so, and with the chassis rolled and heaved where it can be. The loads of
    /// the target play no part.
    ///
    /// # Errors
    /// As for [`Self::move_to`], and where no travel or heave has the forces.
    pub fn hold(&mut self, target: &Target) -> Result<StepReport, Stop> {
        let AxleSuspension { sides, rack, rolling, .. } = &self.suspension;
        let wheels = sides.iter().zip(target.wheels);
        let mut targets: Vec<_> = wheels.map(|(part, hold)| (part.travel, hold)).collect();
        if let Some(driver) = *rack {
            if let Some(limit) = self.steering.exceeded(target.rack) {
                let from = self.stand.driver_value(driver);
                return Err(Stop::limit("rack", from, target.rack, limit));
            }
            targets.push((driver, Hold::Value(target.rack)));
        }
        if let Some(Rolling { roll, heave, .. }) = *rolling {
            targets.extend([(roll, Hold::Value(target.roll)), (heave, target.heave)]);
        }
        self.stand.hold(&targets)
    }

    /// Lets the axle find its equilibrium at the current travels and rack.
    ///
    /// # Errors
    /// [`StaticFailure`] where there is none.
    pub fn rest(&mut self) -> Result<StaticReport, StaticFailure> {
        self.stand.rest()
    }

    /// Returns to the static state or the design position. The loads on the wheels stay.
    pub fn reset(&mut self) {
        self.stand.reset();
    }

    /// The channels of the rack and of force elements; none where the model has no forces.
    pub fn element_channels(&self) -> &[Channel] {
        &self.elements
    }

    /// Sets whether [`Self::poses`] measure how the wheels give way to loads.
    pub fn measure_compliance(&mut self, measures: bool) {
        self.measures_compliance = measures;
    }

    /// Where wheel, steer axis and spring of one side are, how they move, and what the wheel carries. Motion
    /// and rate are those with the other wheel held.
    pub fn pose(&mut self, side: Side) -> Pose<f64> {
        let [left, right] = self.poses();
        match side {
            Side::Left => left,
            Side::Right => right,
        }
    }

    /// Where wheel, steer axis and spring of one side are at a state of the mechanism, as
    /// [`Corner::pose_at`](super::Corner::pose_at).
    ///
    /// # Panics
    /// If the state belongs to another mechanism.
    pub fn pose_at(&self, side: Side, state: &[Coordinates<f64>]) -> Pose<f64> {
        self.stations[side.index()].pose_at(&View { state, ..self.stand.view() })
    }

    /// The compliance of both wheels at the current travels, rack and loads; the equilibrium is found
    /// first where it is not known yet.
    ///
    /// # Errors
    /// [`ComplianceError`] where there is no equilibrium, or a wheel has no stiffness without
    /// the rig.
    pub fn compliance(&mut self) -> Result<Compliance, ComplianceError> {
        if self.stand.is_loaded() && !self.stand.is_in_equilibrium() {
            self.rest()?;
        }
        let Self { stations, stand, .. } = self;
        let poses = stations.each_ref().map(|station| station.pose_at(&stand.view()));
        Compliance::of(stand.rates().equilibrium(), stations, &poses)
    }

    /// How all bodies move per metre of a driver, as [`Rates::tangent`](super::Rates::tangent).
    pub fn tangent(&mut self, driver: DriverId) -> Option<Tangent<'_>> {
        self.stand.rates().into_tangent(driver)
    }

    /// The left and the right wheel, each knowing of the other, and how they give way where that
    /// is measured.
    pub fn poses(&mut self) -> [Pose<f64>; 2] {
        let Self { stations, stand, measures_compliance, .. } = self;
        let mut poses = stations.each_ref().map(|station| station.pose(stand));
        let mut rates = stand.rates();
        for (station, pose) in stations.iter().zip(&mut poses) {
            station.move_along(pose, &mut rates);
        }
        let held = stations.iter().all(Station::is_held);
        if *measures_compliance && held && poses[0].motions.is_some() {
            let matrix = Compliance::of(rates.equilibrium(), stations, &poses).ok();
            for (wheel, pose) in poses.iter_mut().enumerate() {
                pose.compliance = matrix.as_ref().map(|matrix| matrix.of_wheel(wheel));
            }
        }
        let [left, right] = poses.map(|pose| pose.as_other());
        (poses[0].other, poses[1].other) = (Some(right), Some(left));
        poses
    }
}

impl Specimen for Axle {
    fn go_to(&mut self, target: &Target) -> Result<StepReport, Stop> {
        self.set_load(&target.load);
        self.hold(target)
    }

    fn supports(&self) -> Supports {
        let AxleSuspension { sides, rolling, .. } = &self.suspension;
        Supports {
            wheels: sides.map(|part| self.stand.driver_force(part.travel)),
            chassis: rolling.map_or(0.0, |rolling| self.stand.driver_force(rolling.heave)),
        }
    }

    fn reset(&mut self) {
        Self::reset(self);
    }

    fn mechanism(&self) -> &Mechanism {
        self.stand.mechanism()
    }

    fn poses(&mut self) -> Vec<Pose<f64>> {
        Self::poses(self).to_vec()
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

impl Variable for Axle {
    fn stand(&self) -> &Stand {
        Self::stand(self)
    }

    fn measure_compliance(&mut self, measures: bool) {
        Self::measure_compliance(self, measures);
    }

    fn adjusters(&self, adjuster: usize) -> Vec<DriverId> {
        self.suspension.adjusters.each_ref().map(|side| side[adjuster]).to_vec()
    }

    fn sides(&self) -> usize {
        2
    }

    fn reshape(
        &mut self,
        shapes: &[Shape<f64>],
        constants: &[(ElementConstant, f64)],
        lengths: &[(usize, f64)],
    ) -> Result<(), VaryError> {
        let Self { stations, stand, origins, .. } = self;
        Varied::reshape(stand, stations, origins, shapes, constants, lengths)
    }

    fn settled(&self) -> Option<&Settled> {
        self.settled.as_ref()
    }

    fn vary(
        &mut self,
        constants: &[ElementConstant],
        compliance: bool,
    ) -> Result<Varied<'_>, VaryError> {
        let Self { stations, stand, origins, settled, .. } = self;
        Varied::of(stand, stations, origins, constants, compliance, settled.as_mut())
    }
}
