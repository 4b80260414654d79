//! One wheel on the rig with all that belongs to it.

use super::adjust::Home;
use super::line::{Line, Wheel};
use super::pose::{Design, Motion, Motions, Pose, TyreState, WheelLoad};
use super::rates::Rates;
use super::stand::Stand;
use super::watch::Fastest;
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
    /// The static state, where the model asks for one.
    home: Option<Home>,
    /// Where the parameters are that say where the steer axis meets its bodies, where adjusters change them.
    adjusted: [Option<usize>; 2],
    /// What may be fast near a dead centre: the joints of moving bodies, the seats of springs, the wheel centre.
    joints: Vec<(BodyId, PointId)>,
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
            home: None,
            adjusted: [None; 2],
            joints: vec![],
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
            home: None,
            adjusted: [None; 2],
            joints: vec![],
        }
    }

    /// The same on a stand, with changes counted from a static state where there is one.
    pub fn on(self, stand: &Stand, home: Option<Home>) -> Self {
        let expansion = stand.system().expansion();
        let place = |(point, body)| expansion.adjusted_place(body, point);
        let adjusted = self.steer_axis.map(|axis| [axis.lower, axis.upper].map(place));
        let mut joints = stand.mechanism().held_points();
        let struts = self.spring.iter().chain(&self.damper).flat_map(|strut| strut.ends);
        joints.extend(struts.chain([(self.wheel.center, self.wheel.body)]).map(|(p, b)| (b, p)));
        joints.retain(|(body, _)| ![BodyId::GROUND, self.chassis].contains(body));
        Self { home, adjusted: adjusted.unwrap_or_default(), joints, ..self }
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
        let adjusted = self.adjusted_places(stand);
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
            rotation: self.home.map_or(rotation, |home| relative(rotation, home.rotation)),
            steer_axis: steer_axis.map(|axis| {
                let ends = [(axis.lower, adjusted[0]), (axis.upper, adjusted[1])];
                Line::through(ends.map(|(end, adjusted)| place(mechanism, state, end, adjusted)))
            }),
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
        let design = self.start(mechanism);
        let [x, y, z, ..] = state[body.index()];
        let up = rotation(state, body).map(|row| row[2]);
        let height = self.driven(&design)[2] - mechanism.bodies()[body.index()].origin[2];
        dot(up, sub(self.driven(wheel), [x, y, z])) - height
    }

    /// The wheel at the design position or in the static state.
    fn start(&self, mechanism: &Mechanism) -> Wheel<f64> {
        let center = mechanism.points()[self.wheel.center.index()].position;
        let Self { wheel, .. } = self;
        let design = Wheel { center, spin: wheel.spin_axis, radius: wheel.radius };
        self.home.map_or(design, |home| home.wheel)
    }

    /// The design position or the static state, carried up and down with the chassis of a state, but not rolled: angles and
    /// ways are those from the design position in ground axes, as Lotus prints them in roll.
    fn design(&self, mechanism: &Mechanism, state: &[Coordinates<f64>]) -> Design<f64> {
        let Self { spring, damper, chassis, .. } = self;
        let origin = mechanism.bodies()[chassis.index()].origin;
        let sunk = state[chassis.index()][2] - origin[2];
        let carried = |place| add(place, [0.0, 0.0, sunk]);
        let at = |point: PointId| mechanism.points()[point.index()].position;
        let line = |strut: &Option<StrutLine>| {
            strut.map(|strut| Line::through(strut.ends.map(|(point, _)| at(point))))
        };
        let (spring, damper) = match self.home {
            Some(home) => (home.spring, home.damper),
            None => (line(spring), line(damper)),
        };
        let wheel = self.start(mechanism);
        let along = |line: Line<f64>| Line { from: carried(line.from), to: carried(line.to) };
        Design {
            wheel: Wheel { center: carried(wheel.center), ..wheel },
            spring: spring.map(along),
            damper: damper.map(along),
        }
    }

    /// Where the ends of the steer axis are on their bodies, in body axes, where adjusters move them.
    fn adjusted_places(&self, stand: &Stand) -> [Option<[f64; 3]>; 2] {
        let h = stand.equilibrium().parameters();
        self.adjusted.map(|first| first.map(|first| [h[first], h[first + 1], h[first + 2]]))
    }

    /// How the parts move with the drivers, those of other wheels held.
    fn motions(&self, rates: &mut Rates<'_>, mechanism: &Mechanism) -> Option<Motions<f64>> {
        let travel = self.motion(self.travel, rates, mechanism)?;
        let rack = self.rack.and_then(|rack| self.motion(rack, rates, mechanism));
        let across = self.other_travel.and_then(|other| self.motion(other, rates, mechanism));
        Some(Motions { travel, rack, across: across.map(|motion| motion.wheel) })
    }

    /// How the parts move with the value of a driver, relative to the chassis.
    pub fn motion(
        &self,
        driver: DriverId,
        rates: &mut Rates<'_>,
        mechanism: &Mechanism,
    ) -> Option<Motion<f64>> {
        // A joint whose place is adjusted moves on its body, too.
        let now = rates.parameters();
        let adjusted = self.adjusted.map(|first| first.map(|k| [now[k], now[k + 1], now[k + 2]]));
        let changes = self.adjusted.map(|first| Some(rates.change_of_place(driver, first?)));
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
            steer_axis: self.steer_axis.map(|axis| {
                let ends =
                    [(axis.lower, adjusted[0], changes[0]), (axis.upper, adjusted[1], changes[1])];
                Line::through(ends.map(|(end, adjusted, rate)| {
                    let place = place(mechanism, tangent.state(), end, adjusted);
                    let rate = rate.map_or([0.0; 3], |rate| turned(tangent.state(), end.1, rate));
                    add(twist(end.1).at(place), rate)
                }))
            }),
            spring: self.spring.map(|spring| Line::through(spring.ends.map(velocity))),
            damper: self.damper.map(|damper| Line::through(damper.ends.map(velocity))),
            fastest: if driver == self.travel { self.fastest(velocity) } else { None },
        })
    }

    /// The fastest joint of the mechanism, by the velocities of points.
    fn fastest(&self, velocity: impl Fn((PointId, BodyId)) -> [f64; 3]) -> Option<Fastest> {
        let speeds = self.joints.iter().map(|&(body, point)| {
            let ratio = norm(velocity((point, body)));
            Fastest { body, point, ratio }
        });
        speeds.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
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

/// Where a point of a body is; `adjusted` is its place on the body where that is another one.
fn place(
    mechanism: &Mechanism,
    state: &[Coordinates<f64>],
    (point, body): (PointId, BodyId),
    adjusted: Option<[f64; 3]>,
) -> [f64; 3] {
    let Some(local) = adjusted else {
        return point_position(mechanism, state, body, point);
    };
    let [x, y, z, ..] = state[body.index()];
    add([x, y, z], turned(state, body, local))
}

/// A direction of a body in the axes of the ground.
fn turned(state: &[Coordinates<f64>], body: BodyId, direction: [f64; 3]) -> [f64; 3] {
    rotation(state, body).map(|row| dot(row, direction))
}

/// The rotation from one orientation to another one: A Bᵀ.
fn relative(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    a.map(|row| b.map(|other| dot(row, other)))
}
