//! One wheel on the rig with all that belongs to it.

use super::adjust::Home;
use super::line::{Line, Wheel};
use super::pose::{Design, Motion, Motions, Pose, TyreState, WheelLoad};
use super::rates::Rates;
use super::stand::Stand;
use super::view::View;
use super::watch::Fastest;
use crate::mechanism::{BodyId, Direction, DriverId, DriverSlots, ForceId, Law, PointId};
use crate::model::{
    self, Axes, AxleSuspension, Chassis, Drive, Model, Setup, Side, SteerAxis, StrutLine,
    Suspension, Vehicle, WheelSupport,
};
use crate::relation::BODY_COORDINATES;
use crate::scalar::{Real, Scalar};
use crate::solve::{FreeMotion, Twist};
use crate::vector::{Vector, add, constant, dot, norm, sub};

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
    home: Option<Home<f64>>,
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
    pub fn on(self, stand: &Stand, home: Option<Home<f64>>) -> Self {
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
        self.ends().any(|(_, body)| motion.bodies.contains(&body))
    }

    /// Where the wheel starts from, where that is a static state.
    pub fn home<S: Scalar>(&self) -> Option<Home<S>> {
        self.home.map(|home| home.lifted())
    }

    /// The bodies that poses depend on.
    pub fn bodies(&self) -> impl Iterator<Item = usize> {
        self.ends().map(|(_, body)| body.index()).chain([self.chassis.index()])
    }

    /// The points that poses depend on.
    pub fn points(&self) -> impl Iterator<Item = usize> {
        let spin = match self.wheel.spin {
            Direction::Between(from, to) => Some([from.index(), to.index()]),
            Direction::Fixed(_) => None,
        };
        self.ends().map(|(point, _)| point.index()).chain(spin.into_iter().flatten())
    }

    /// The parameters that poses depend on.
    pub fn adjusted_parameters(&self) -> impl Iterator<Item = usize> {
        self.adjusted.into_iter().flatten().flat_map(|first| first..first + 3)
    }

    fn ends(&self) -> impl Iterator<Item = (PointId, BodyId)> {
        let axis = self.steer_axis.iter().flat_map(|axis| [axis.lower, axis.upper]);
        let struts = self.spring.iter().chain(&self.damper).flat_map(|strut| strut.ends);
        axis.chain(struts).chain([(self.wheel.center, self.wheel.body)])
    }

    /// Where wheel, steer axis and spring are, and what the wheel carries.
    pub fn pose(&self, stand: &Stand) -> Pose<f64> {
        self.loaded_pose(&stand.view(), self.home.as_ref(), self.force(stand))
    }

    /// The same of a state on any scalar, with the static state and the vertical force on the wheel.
    pub fn loaded_pose<S: Real>(
        &self,
        view: &View<'_, S>,
        home: Option<&Home<S>>,
        force: Option<S>,
    ) -> Pose<S> {
        let load = force.map(|force| WheelLoad { force, rate: None });
        let tyre = force.and_then(|force| self.tyre_under(force));
        Pose { load, tyre, ..self.pose_from(view, home) }
    }

    /// Adds how the parts of a pose move, and how the force on the wheel grows.
    pub fn move_along(&self, pose: &mut Pose<f64>, rates: &mut Rates<'_>) {
        pose.motions = self.motions_by(|driver| self.motion_by(driver, rates));
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
    pub fn pose_at(&self, view: &View<'_, f64>) -> Pose<f64> {
        self.pose_from(view, self.home.as_ref())
    }

    /// The same on any scalar, with the static state.
    fn pose_from<S: Real>(&self, view: &View<'_, S>, home: Option<&Home<S>>) -> Pose<S> {
        let Self { wheel, steer_axis, spring, damper, .. } = self;
        let rotation = view.rotation(wheel.body);
        let design = self.design(view, home);
        let spin = view.direction(wheel.spin);
        let disc = Wheel {
            center: view.point((wheel.center, wheel.body)),
            spin: rotation.map(|row| dot(row, spin)),
            radius: S::from_f64(wheel.radius),
        };
        Pose {
            travel: match self.support {
                _ if self.rolls => self.travel_in_body(view, home, &disc),
                WheelSupport::Held => view.driver(self.travel),
                WheelSupport::Free => self.driven(&disc)[2] - self.driven(&design.wheel)[2],
            },
            rack: self.rack.map_or(S::from_f64(0.0), |rack| view.driver(rack)),
            wheel: disc,
            rotation: home.map_or(rotation, |home| relative(rotation, home.rotation)),
            steer_axis: steer_axis.map(|axis| {
                let ends = [(axis.lower, self.adjusted[0]), (axis.upper, self.adjusted[1])];
                Line::through(ends.map(|(end, adjusted)| joint_place(view, end, adjusted)))
            }),
            spring: spring.map(|spring| Line::through(spring.ends.map(|end| view.point(end)))),
            damper: damper.map(|damper| Line::through(damper.ends.map(|end| view.point(end)))),
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
    fn driven<S: Scalar>(&self, wheel: &Wheel<S>) -> Vector<S> {
        match self.drive {
            Drive::WheelCenter => wheel.center,
            Drive::ContactPatch => wheel.contact_patch(),
        }
    }

    /// How far the wheel has gone up from design in the axes of the chassis, which rolls.
    fn travel_in_body<S: Real>(
        &self,
        view: &View<'_, S>,
        home: Option<&Home<S>>,
        wheel: &Wheel<S>,
    ) -> S {
        let body = self.chassis;
        let design = self.start(view, home);
        let [x, y, z, ..] = view.state[body.index()];
        let up = view.rotation(body).map(|row| row[2]);
        let origin = S::from_f64(view.bodies[body.index()].origin[2]);
        let height = self.driven(&design)[2] - origin;
        dot(up, sub(self.driven(wheel), [x, y, z])) - height
    }

    /// The wheel at the design position or in the static state.
    fn start<S: Real>(&self, view: &View<'_, S>, home: Option<&Home<S>>) -> Wheel<S> {
        let Self { wheel, .. } = self;
        match home {
            Some(home) => home.wheel,
            None => Wheel {
                center: view.points[wheel.center.index()],
                spin: view.direction(wheel.spin),
                radius: S::from_f64(wheel.radius),
            },
        }
    }

    /// The design position or the static state, carried up and down with the chassis of a state, but not rolled: angles and
    /// ways are those from the design position in ground axes, as Lotus prints them in roll.
    fn design<S: Real>(&self, view: &View<'_, S>, home: Option<&Home<S>>) -> Design<S> {
        let Self { spring, damper, chassis, .. } = self;
        let zero = S::from_f64(0.0);
        let origin = S::from_f64(view.bodies[chassis.index()].origin[2]);
        let sunk = view.state[chassis.index()][2] - origin;
        let carried = |place| add(place, [zero, zero, sunk]);
        let at = |point: PointId| view.points[point.index()];
        let line = |strut: &Option<StrutLine>| {
            strut.map(|strut| Line::through(strut.ends.map(|(point, _)| at(point))))
        };
        let (spring, damper) = match home {
            Some(home) => (home.spring, home.damper),
            None => (line(spring), line(damper)),
        };
        let wheel = self.start(view, home);
        let along = |line: Line<S>| Line { from: carried(line.from), to: carried(line.to) };
        Design {
            wheel: Wheel { center: carried(wheel.center), ..wheel },
            spring: spring.map(along),
            damper: damper.map(along),
        }
    }

    /// How the parts move with the value of a driver.
    pub fn motion_by(&self, driver: DriverId, rates: &mut Rates<'_>) -> Option<Motion<f64>> {
        let tangent = rates.tangent(driver)?.coordinates().to_vec();
        let view = rates.view();
        let motion = self.motion(driver, &view, &tangent, rates.slots())?;
        let is_travel = driver == self.travel;
        let fastest = is_travel.then(|| self.fastest(&view, &tangent)).flatten();
        Some(Motion { fastest, ..motion })
    }

    /// How the parts move with the drivers, those of other wheels held, from the motion by each.
    pub fn motions_by<S: Real>(
        &self,
        mut by: impl FnMut(DriverId) -> Option<Motion<S>>,
    ) -> Option<Motions<S>> {
        let travel = by(self.travel)?;
        let rack = self.rack.and_then(&mut by);
        let across = self.other_travel.and_then(&mut by);
        Some(Motions { travel, rack, across: across.map(|motion| motion.wheel) })
    }

    /// How the parts move with the value of a driver, relative to the chassis, from the rates of all
    /// coordinates. A joint whose place is adjusted moves on its body, too.
    pub fn motion<S: Real>(
        &self,
        driver: DriverId,
        view: &View<'_, S>,
        rates: &[S],
        slots: &DriverSlots,
    ) -> Option<Motion<S>> {
        let places = self.adjusted.map(|first| first.map(|first| slots.rate(driver, first)));
        let of = |body| twist_of(view, rates, body);
        let chassis = of(self.chassis);
        let twist = |body| of(body).minus(&chassis);
        let center = view.point((self.wheel.center, self.wheel.body));
        let [own, relative] = [of(self.wheel.body), twist(self.wheel.body)]
            .map(|twist| norm(twist.at(center).map(Real::value)));
        if relative < CARRIED * own {
            return None;
        }
        let velocity = |(point, body): (PointId, BodyId)| twist(body).at(view.point((point, body)));
        Some(Motion {
            wheel: twist(self.wheel.body),
            steer_axis: self.steer_axis.map(|axis| {
                let [first, second] = self.adjusted;
                let ends = [(axis.lower, first, places[0]), (axis.upper, second, places[1])];
                Line::through(ends.map(|(end, adjusted, rate)| {
                    let place = joint_place(view, end, adjusted);
                    let moved = twist(end.1).at(place);
                    rate.map_or(moved, |rate| add(moved, view.turned(end.1, constant(rate))))
                }))
            }),
            spring: self.spring.map(|spring| Line::through(spring.ends.map(velocity))),
            damper: self.damper.map(|damper| Line::through(damper.ends.map(velocity))),
            fastest: None,
        })
    }

    /// The fastest joint of the mechanism.
    fn fastest(&self, view: &View<'_, f64>, rates: &[f64]) -> Option<Fastest> {
        let chassis = twist_of(view, rates, self.chassis);
        let speeds = self.joints.iter().map(|&(body, point)| {
            let twist = twist_of(view, rates, body).minus(&chassis);
            let ratio = norm(twist.at(view.point((point, body))));
            Fastest { body, point, ratio }
        });
        speeds.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }

    /// The tyre under a vertical load.
    fn tyre_under<S: Real>(&self, load: S) -> Option<TyreState<S>> {
        let law = self.tyre_law.as_ref()?;
        let value = law.value_under(-load.value())?;
        let rate = law.elastic.at(value).first;
        // The force of the law is minus the load, so it says how its value changes with that.
        let change = S::from_f64(load.value()) - load;
        let value = S::from_f64(value) + change / S::from_f64(rate);
        let [_, stiffness] = law.lifted(value);
        (rate > 0.0).then_some(TyreState { rate: stiffness, deflection: -value })
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

/// How a body moves, from the rates of all coordinates.
fn twist_of<S: Scalar>(view: &View<'_, S>, rates: &[S], body: BodyId) -> Twist<S> {
    let Some(moving) = body.index().checked_sub(1) else {
        return Twist { velocity: [S::from_f64(0.0); 3], rotation: [S::from_f64(0.0); 3] };
    };
    let first = BODY_COORDINATES * moving;
    Twist::new(&view.state[body.index()], &rates[first..first + BODY_COORDINATES])
}

/// Where a joint is on a body; `adjusted` is the first of the parameters that say where, where adjusters move it.
fn joint_place<S: Scalar>(
    view: &View<'_, S>,
    (point, body): (PointId, BodyId),
    adjusted: Option<usize>,
) -> Vector<S> {
    match adjusted {
        Some(first) => view.place(body, view.three(first)),
        None => view.point((point, body)),
    }
}

/// The rotation from one orientation to another one: A Bᵀ.
fn relative<S: Scalar>(a: [Vector<S>; 3], b: [Vector<S>; 3]) -> [Vector<S>; 3] {
    a.map(|row| b.map(|other| dot(row, other)))
}
