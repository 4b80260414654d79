//! One wheel on the rig with all that belongs to it.

use super::line::{Line, Wheel};
use super::pose::{Design, Motion, Motions, Pose, TyreState, WheelLoad};
use super::rates::Rates;
use super::stand::Stand;
use crate::mechanism::{BodyId, DriverId, ForceId, Law, Mechanism, PointId};
use crate::model::{
    self, Axes, AxleSuspension, Chassis, Drive, Model, Setup, Side, SteerAxis, StrutLine,
    Suspension, Vehicle, WheelSupport,
};
use crate::relation::Coordinates;
use crate::solve::{FreeMotion, point_position, rotation};
use crate::vector::{add, dot, norm, sub};

/// The part of a wheel's velocity that has to be left against the chassis. A chassis that is free on
/// its slide goes up with the wheel, on a spring whose force stays the same: no motion of the suspension.
const CARRIED: f64 = 1e-6;

/// A wheel with its parts, as the mechanism on the rig numbers them.
#[derive(Clone, Debug)]
pub(super) struct Station {
    pub side: Side,
    pub wheel: model::Wheel,
    pub steer_axis: Option<SteerAxis>,
    pub spring: Option<StrutLine>,
    damper: Option<StrutLine>,
    /// The driver of the height, released where the wheel is free.
    pub travel: DriverId,
    /// The driver of the height of the other wheel on the axle.
    other_travel: Option<DriverId>,
    pub rack: Option<DriverId>,
    pub tyre: Option<ForceId>,
    pub chassis: BodyId,
    drive: Drive,
    support: WheelSupport,
    rolls: bool,
    vehicle: Vehicle,
    axes: Axes,
    /// The law of the model's tyre, whether or not the wheel stands on it.
    tyre_law: Option<Law>,
}

impl Station {
    /// The only wheel of a corner.
    pub fn of_corner(suspension: &Suspension, model: &Model, setup: &Setup) -> Self {
        Self {
            side: model.side,
            wheel: suspension.wheel,
            steer_axis: suspension.steer_axis,
            spring: suspension.spring,
            damper: suspension.damper,
            travel: suspension.travel,
            other_travel: None,
            rack: suspension.rack,
            tyre: suspension.tyre,
            chassis: suspension.chassis,
            drive: setup.drive,
            support: setup.support,
            rolls: false,
            vehicle: model.vehicle,
            axes: model.axes,
            tyre_law: model.tyre_law().cloned(),
        }
    }

    /// One wheel of an axle, whose chassis is the ground or rolls above it.
    pub fn of_axle(suspension: &AxleSuspension, side: Side, model: &Model, setup: &Setup) -> Self {
        let part = &suspension.sides[side.index()];
        let other = &suspension.sides[1 - side.index()];
        let chassis = suspension.rolling.map_or(BodyId::GROUND, |rolling| rolling.body);
        Self {
            side: part.side,
            wheel: part.wheel,
            steer_axis: part.steer_axis,
            spring: part.spring,
            damper: part.damper,
            travel: part.travel,
            other_travel: Some(other.travel),
            rack: suspension.rack,
            tyre: part.tyre,
            chassis,
            drive: setup.drive,
            support: setup.support,
            rolls: matches!(setup.chassis, Chassis::Roll { .. }),
            vehicle: model.vehicle,
            axes: model.axes,
            tyre_law: model.tyre_law().cloned(),
        }
    }

    /// Whether a motion moves the wheel, its steer axis or its spring.
    pub fn is_moved(&self, motion: &FreeMotion) -> bool {
        let axis = self.steer_axis.iter().flat_map(|axis| [axis.lower.1, axis.upper.1]);
        let struts = self.spring.iter().chain(&self.damper);
        let struts = struts.flat_map(|strut| strut.ends.map(|(_, body)| body));
        let mut bodies = axis.chain(struts).chain([self.wheel.body]);
        bodies.any(|body| motion.bodies.contains(&body))
    }

    /// Where wheel, steer axis and spring are, and what the wheel carries.
    pub fn pose(&self, stand: &Stand) -> Pose<f64> {
        let force = self.force(stand);
        let load = force.map(|force| WheelLoad { force, rate: None });
        let tyre = force.and_then(|force| self.tyre_under(force));
        Pose { load, tyre, ..self.pose_at(stand, stand.state()) }
    }

    /// Adds how the parts of a pose move, and how the force on the wheel grows.
    pub fn move_along(&self, pose: &mut Pose<f64>, rates: &mut Rates<'_>, mechanism: &Mechanism) {
        pose.motions = self.motions(rates, mechanism);
        if let Some(load) = &mut pose.load
            && self.is_held()
        {
            load.rate = rates.driver_rate(self.travel);
        }
    }

    /// Whether the rig holds the wheel at its height.
    pub fn is_held(&self) -> bool {
        self.support == WheelSupport::Held
    }

    /// Where wheel, steer axis and spring are at a state of the mechanism.
    pub fn pose_at(&self, stand: &Stand, state: &[Coordinates<f64>]) -> Pose<f64> {
        let Self { wheel, steer_axis, spring, damper, .. } = self;
        let mechanism = stand.mechanism();
        let rotation = rotation(state, wheel.body);
        let point = |(point, body)| point_position(mechanism, state, body, point);
        let driven = |driver| stand.driver_value(driver);
        let design = self.design(mechanism, state);
        let disc = Wheel {
            center: point((wheel.center, wheel.body)),
            spin: rotation.map(|row| dot(row, wheel.spin_axis)),
            radius: wheel.radius,
        };
        Pose {
            travel: match self.support {
                _ if self.rolls => self.travel_in_body(mechanism, state, &disc),
                WheelSupport::Held => driven(self.travel),
                WheelSupport::Free => self.driven(&disc)[2] - self.driven(&design.wheel)[2],
            },
            rack: self.rack.map_or(0.0, driven),
            wheel: disc,
            rotation,
            steer_axis: steer_axis.map(|axis| Line::through([axis.lower, axis.upper].map(point))),
            spring: spring.map(|spring| Line::through(spring.ends.map(point))),
            damper: damper.map(|damper| Line::through(damper.ends.map(point))),
            design,
            motions: None,
            load: None,
            tyre: None,
            compliance: None,
            other: None,
            vehicle: self.vehicle,
            side: self.side,
            axes: self.axes,
        }
    }

    /// The point of a wheel whose height the driver prescribes.
    fn driven(&self, wheel: &Wheel<f64>) -> [f64; 3] {
        match self.drive {
            Drive::WheelCenter => wheel.center,
            Drive::ContactPatch => wheel.contact_patch(),
        }
    }

    /// How far the wheel has gone up from design in the axes of the chassis, which rolls.
    fn travel_in_body(
        &self,
        mechanism: &Mechanism,
        state: &[Coordinates<f64>],
        wheel: &Wheel<f64>,
    ) -> f64 {
        let body = self.chassis;
        let design = Wheel {
            center: mechanism.points()[self.wheel.center.index()].position,
            spin: self.wheel.spin_axis,
            radius: self.wheel.radius,
        };
        let [x, y, z, ..] = state[body.index()];
        let up = rotation(state, body).map(|row| row[2]);
        let height = self.driven(&design)[2] - mechanism.bodies()[body.index()].origin[2];
        dot(up, sub(self.driven(wheel), [x, y, z])) - height
    }

    /// The design position, carried up and down with the chassis of a state, but not rolled: angles and
    /// ways are those from the design position in ground axes, as Lotus prints them in roll.
    fn design(&self, mechanism: &Mechanism, state: &[Coordinates<f64>]) -> Design<f64> {
        let Self { wheel, spring, damper, chassis, .. } = self;
        let origin = mechanism.bodies()[chassis.index()].origin;
        let sunk = state[chassis.index()][2] - origin[2];
        let at = |point: PointId| add(mechanism.points()[point.index()].position, [0.0, 0.0, sunk]);
        let line = |strut: &Option<StrutLine>| {
            strut.map(|strut| Line::through(strut.ends.map(|(point, _)| at(point))))
        };
        Design {
            wheel: Wheel { center: at(wheel.center), spin: wheel.spin_axis, radius: wheel.radius },
            spring: line(spring),
            damper: line(damper),
        }
    }

    /// How the parts move with the drivers, those of other wheels held.
    fn motions(&self, rates: &mut Rates<'_>, mechanism: &Mechanism) -> Option<Motions<f64>> {
        let travel = self.motion(self.travel, rates, mechanism)?;
        let rack = self.rack.and_then(|rack| self.motion(rack, rates, mechanism));
        let across = self.other_travel.and_then(|other| self.motion(other, rates, mechanism));
        Some(Motions { travel, rack, across: across.map(|motion| motion.wheel) })
    }

    fn motion(
        &self,
        driver: DriverId,
        rates: &mut Rates<'_>,
        mechanism: &Mechanism,
    ) -> Option<Motion<f64>> {
        let tangent = rates.tangent(driver)?;
        let twist = |body| tangent.twist(body).minus(&tangent.twist(self.chassis));
        let center = point_position(mechanism, tangent.state(), self.wheel.body, self.wheel.center);
        let [own, relative] = [tangent.twist(self.wheel.body), twist(self.wheel.body)]
            .map(|twist| norm(twist.at(center)));
        if relative < CARRIED * own {
            return None;
        }
        let velocity = |(point, body): (PointId, BodyId)| {
            twist(body).at(point_position(mechanism, tangent.state(), body, point))
        };
        Some(Motion {
            wheel: twist(self.wheel.body),
            steer_axis: self
                .steer_axis
                .map(|axis| Line::through([axis.lower, axis.upper].map(velocity))),
            spring: self.spring.map(|spring| Line::through(spring.ends.map(velocity))),
            damper: self.damper.map(|damper| Line::through(damper.ends.map(velocity))),
        })
    }

    /// The tyre under a vertical load.
    fn tyre_under(&self, load: f64) -> Option<TyreState<f64>> {
        let law = self.tyre_law.as_ref()?;
        let value = law.value_under(-load)?;
        let rate = law.elastic.at(value).first;
        (rate > 0.0).then_some(TyreState { rate, deflection: -value })
    }

    /// The vertical force on the wheel.
    fn force(&self, stand: &Stand) -> Option<f64> {
        if !stand.is_loaded() || !stand.is_in_equilibrium() {
            return None;
        }
        match self.support {
            WheelSupport::Held => Some(-stand.equilibrium().driver_multiplier(self.travel)),
            WheelSupport::Free => Some(stand.equilibrium().loaded().force(self.tyre?).force[2]),
        }
    }
}
