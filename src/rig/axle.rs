//! An axle on the rig.

use super::channel::{Channel, element_channels};
use super::corner::RigError;
use super::load::{Load, LoadPoint, WheelLoads};
use super::pose::{self, Pose, Wheel, WheelLoad};
use super::stand::Stand;
use super::sweep::{Specimen, SweepPlan};
use crate::mechanism::{BodyId, Force, PointId};
use crate::model::{Axes, AxleSide, AxleSuspension, Model, Setup, Side, WheelSupport};
use crate::solve::equilibrium::Equilibrium;
use crate::solve::{
    FreeMotion, FreedomReport, StaticFailure, StaticReport, StepReport, Stop, point_position,
    rotation,
};
use crate::vector::dot;

/// Both wheels of an axle on the rig, the chassis fixed.
///
/// The heights of the wheels and the rack are driven, or the wheels stand on their tyres. Where the
/// model has forces, every state is one of static equilibrium. Pairs of values are left, right.
pub struct Axle {
    suspension: AxleSuspension,
    setup: Setup,
    stand: Stand,
    loads: Option<[WheelLoads; 2]>,
    load: [Load; 2],
    own_forces: usize,
    elements: Vec<Channel>,
    axes: Axes,
}

impl Axle {
    /// Puts a model and its mirror image on the rig at their design position.
    ///
    /// # Errors
    /// [`RigError`] for geometry without meaning or a wheel that cannot move.
    pub fn new(model: &Model, setup: &Setup) -> Result<Self, RigError> {
        Self::with_loads(model, setup, LoadPoint::default())
    }

    /// As [`Self::new`], with the point at which [`Self::set_load`] loads the wheels.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn with_loads(model: &Model, setup: &Setup, at: LoadPoint) -> Result<Self, RigError> {
        Self::of(model.axle(setup)?, model, setup, at)
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
        Self::of(model.axle_with(other, setup)?, model, setup, at)
    }

    fn of(
        mut suspension: AxleSuspension,
        model: &Model,
        setup: &Setup,
        at: LoadPoint,
    ) -> Result<Self, RigError> {
        let axes = model.axes;
        let own_forces = suspension.mechanism.forces().len();
        let loads = match model.axle_has_forces() {
            true => {
                let AxleSuspension { mechanism, sides, .. } = &mut suspension;
                let mut add = |part: &AxleSide| {
                    let prefix = format!("{}_", part.side.name());
                    WheelLoads::add(mechanism, &part.wheel, &prefix, at, axes)
                };
                Some([add(&sides[0])?, add(&sides[1])?])
            }
            false => None,
        };
        let released = match setup.support {
            WheelSupport::Held => vec![],
            WheelSupport::Free => suspension.sides.map(|part| part.travel).to_vec(),
        };
        let stand = Stand::new(suspension.mechanism.clone(), &released, axes)?;
        // What the rig puts on the wheels is an input, not a result.
        let elements = element_channels(stand.mechanism(), stand.system().expansion())
            .into_iter()
            .filter(|channel| channel.force().is_some_and(|force| force.index() < own_forces));
        Ok(Self {
            elements: elements.collect(),
            load: [Load::default(); 2],
            setup: *setup,
            suspension,
            stand,
            loads,
            own_forces,
            axes,
        })
    }

    /// Degrees of freedom, redundant equations and free motions.
    pub fn freedom(&self) -> &FreedomReport {
        self.stand.freedom()
    }

    /// The free motions that move a wheel or a steer axis of a model without forces; with one of
    /// them their position is not determined by travels and rack.
    pub fn free_wheel_motions(&self) -> impl Iterator<Item = &FreeMotion> {
        let bodies: Vec<BodyId> = self
            .suspension
            .sides
            .iter()
            .flat_map(|part| {
                let axis = part.steer_axis.iter().flat_map(|axis| [axis.lower.1, axis.upper.1]);
                axis.chain([part.wheel.body])
            })
            .collect();
        let kinematic = self.loads.is_none();
        let motions = self.freedom().free_motions.iter();
        motions.filter(move |motion| {
            kinematic && motion.bodies.iter().any(|body| bodies.contains(body))
        })
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

    /// Moves the wheels to travels and the rack to a displacement (m, all from the design
    /// position) from where they are. An axle without a rack ignores `rack`, wheels that stand
    /// on their tyres ignore `travel`.
    ///
    /// # Errors
    /// [`Stop`] where the mechanism cannot go on or has no equilibrium. It then stays where it got to.
    pub fn move_to(&mut self, travel: [f64; 2], rack: f64) -> Result<StepReport, Stop> {
        let sides = self.suspension.sides.iter().zip(travel);
        let mut targets: Vec<_> = sides.map(|(part, travel)| (part.travel, travel)).collect();
        targets.extend(self.suspension.rack.map(|driver| (driver, rack)));
        self.stand.move_to(&targets)
    }

    /// Lets the axle find its equilibrium at the current travels and rack.
    ///
    /// # Errors
    /// [`StaticFailure`] where there is none.
    pub fn rest(&mut self) -> Result<StaticReport, StaticFailure> {
        self.stand.rest()
    }

    /// Returns to the design position. The loads on the wheels stay.
    pub fn reset(&mut self) {
        self.stand.reset();
    }

    /// The channels of force elements; none where the model has no forces.
    pub fn element_channels(&self) -> &[Channel] {
        &self.elements
    }

    /// Where wheel and steer axis of one side are, and what the wheel carries. The rate is that with
    /// the other wheel held.
    pub fn pose(&mut self, side: Side) -> Pose<f64> {
        let part = self.suspension.sides[side.index()];
        let load = self.wheel_load(&part);
        let state = self.stand.state();
        let mechanism = self.stand.mechanism();
        let turned = rotation(state, part.wheel.body);
        let point =
            |(point, body): (PointId, BodyId)| point_position(mechanism, state, body, point);
        let center = point((part.wheel.center, part.wheel.body));
        let driven = |driver| self.stand.driver_value(driver);
        let travel = match self.setup.support {
            WheelSupport::Held => driven(part.travel),
            WheelSupport::Free => {
                center[2] - mechanism.points()[part.wheel.center.index()].position[2]
            }
        };
        Pose {
            travel,
            rack: self.suspension.rack.map_or(0.0, driven),
            wheel: Wheel {
                center,
                spin: turned.map(|row| dot(row, part.wheel.spin_axis)),
                radius: part.wheel.radius,
            },
            rotation: turned,
            steer_axis: part
                .steer_axis
                .map(|axis| pose::Axle { lower: point(axis.lower), upper: point(axis.upper) }),
            load,
            side,
            axes: self.axes,
        }
    }

    /// The vertical force on a wheel and how it grows with its travel.
    fn wheel_load(&mut self, part: &AxleSide) -> Option<WheelLoad<f64>> {
        if !self.stand.is_loaded() || !self.stand.is_in_equilibrium() {
            return None;
        }
        match self.setup.support {
            WheelSupport::Held => {
                let force = -self.stand.equilibrium().driver_multiplier(part.travel);
                Some(WheelLoad { force, rate: self.stand.driver_rate(part.travel) })
            }
            WheelSupport::Free => {
                let force = self.stand.equilibrium().loaded().force(part.tyre?);
                Some(WheelLoad { force: force.force[2], rate: None })
            }
        }
    }
}

impl Specimen for Axle {
    fn go_to(&mut self, plan: &SweepPlan, value: f64) -> Result<StepReport, Stop> {
        let target = plan.target(value);
        self.set_load(&target.load);
        self.move_to(target.travel, target.rack)
    }

    fn reset(&mut self) {
        Self::reset(self);
    }

    fn pose(&mut self) -> Option<Pose<f64>> {
        Some(Self::pose(self, Side::Left))
    }

    fn right_pose(&mut self) -> Option<Pose<f64>> {
        Some(Self::pose(self, Side::Right))
    }

    fn element_channels(&self) -> &[Channel] {
        &self.elements
    }

    fn joint_channels(&self) -> &[Channel] {
        self.stand.joint_channels()
    }

    fn channel_values(&self) -> Vec<f64> {
        let equilibrium = self.stand.equilibrium();
        let (loaded, reactions) = (equilibrium.loaded(), equilibrium.reactions());
        let channels = self.elements.iter().chain(self.joint_channels());
        channels.map(|channel| channel.value(&loaded, &reactions, self.axes)).collect()
    }

    fn free_motions(&self) -> Vec<String> {
        self.free_wheel_motions().map(|motion| motion.description.clone()).collect()
    }
}
