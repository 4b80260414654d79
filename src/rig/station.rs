//! One wheel on the rig with all that belongs to it.

use super::adjust::Home;
use super::line::{Line, Wheel};
use super::pose::{Design, Motion, Motions, Pose, WheelLoad};
use super::stand::Stand;
use crate::mechanism::{BodyId, DriverId, ForceId, Mechanism, PointId};
use crate::model::{
    self, Axes, AxleSide, Drive, Model, Setup, Side, SpringLine, SteerAxis, Suspension, Vehicle,
    WheelSupport,
};
use crate::relation::Coordinates;
use crate::solve::{FreeMotion, point_position, rotation};
use crate::vector::{add, dot};

/// A wheel with its parts, as the mechanism on the rig numbers them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station {
    pub side: Side,
    pub wheel: model::Wheel,
    pub steer_axis: Option<SteerAxis>,
    pub spring: Option<SpringLine>,
    /// The driver of the height, released where the wheel is free.
    pub travel: DriverId,
    pub rack: Option<DriverId>,
    pub tyre: Option<ForceId>,
    pub chassis: BodyId,
    drive: Drive,
    support: WheelSupport,
    vehicle: Vehicle,
    axes: Axes,
    /// The static state, where the model asks for one.
    home: Option<Home>,
    /// Where the parameters are that say where the steer axis meets its bodies, where adjusters change them.
    adjusted: [Option<usize>; 2],
}

impl Station {
    /// The only wheel of a corner.
    pub fn of_corner(suspension: &Suspension, model: &Model, setup: &Setup) -> Self {
        Self {
            side: model.side,
            wheel: suspension.wheel,
            steer_axis: suspension.steer_axis,
            spring: suspension.spring,
            travel: suspension.travel,
            rack: suspension.rack,
            tyre: suspension.tyre,
            chassis: suspension.chassis,
            drive: setup.drive,
            support: setup.support,
            vehicle: model.vehicle,
            axes: model.axes,
            home: None,
            adjusted: [None; 2],
        }
    }

    /// One wheel of an axle, whose chassis is the ground.
    pub fn of_axle(part: &AxleSide, rack: Option<DriverId>, model: &Model, setup: &Setup) -> Self {
        Self {
            side: part.side,
            wheel: part.wheel,
            steer_axis: part.steer_axis,
            spring: part.spring,
            travel: part.travel,
            rack,
            tyre: part.tyre,
            chassis: BodyId::GROUND,
            drive: setup.drive,
            support: setup.support,
            vehicle: model.vehicle,
            axes: model.axes,
            home: None,
            adjusted: [None; 2],
        }
    }

    /// The same on a stand, with changes counted from a static state where there is one.
    pub fn on(self, stand: &Stand, home: Option<Home>) -> Self {
        let expansion = stand.system().expansion();
        let place = |(point, body)| expansion.adjusted_place(body, point);
        let adjusted = self.steer_axis.map(|axis| [axis.lower, axis.upper].map(place));
        Self { home, adjusted: adjusted.unwrap_or_default(), ..self }
    }

    /// Whether a motion moves the wheel, its steer axis or its spring.
    pub fn is_moved(&self, motion: &FreeMotion) -> bool {
        let axis = self.steer_axis.iter().flat_map(|axis| [axis.lower.1, axis.upper.1]);
        let spring = self.spring.iter().flat_map(|spring| spring.ends.map(|(_, body)| body));
        let mut bodies = axis.chain(spring).chain([self.wheel.body]);
        bodies.any(|body| motion.bodies.contains(&body))
    }

    /// Where wheel, steer axis and spring are, how they move, and what the wheel carries.
    pub fn pose(&self, stand: &mut Stand, mechanism: &Mechanism) -> Pose<f64> {
        let (load, motions) = (self.load(stand), self.motions(stand, mechanism));
        Pose { load, motions, ..self.pose_at(stand, stand.state()) }
    }

    /// Where wheel, steer axis and spring are at a state of the mechanism.
    pub fn pose_at(&self, stand: &Stand, state: &[Coordinates<f64>]) -> Pose<f64> {
        let Self { wheel, steer_axis, spring, .. } = self;
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
        let height = |wheel: &Wheel<f64>| match self.drive {
            Drive::WheelCenter => wheel.center[2],
            Drive::ContactPatch => wheel.contact_patch()[2],
        };
        Pose {
            travel: match self.support {
                WheelSupport::Held => driven(self.travel),
                WheelSupport::Free => height(&disc) - height(&design.wheel),
            },
            rack: self.rack.map_or(0.0, driven),
            wheel: disc,
            rotation: self.home.map_or(rotation, |home| relative(rotation, home.rotation)),
            steer_axis: steer_axis.map(|axis| {
                let ends = [(axis.lower, adjusted[0]), (axis.upper, adjusted[1])];
                Line::through(ends.map(|(end, adjusted)| place(mechanism, state, end, adjusted)))
            }),
            spring: spring.map(|spring| Line::through(spring.ends.map(point))),
            design,
            motions: None,
            load: None,
            vehicle: self.vehicle,
            side: self.side,
            axes: self.axes,
        }
    }

    /// The design position or the static state, carried along with the chassis of a state.
    fn design(&self, mechanism: &Mechanism, state: &[Coordinates<f64>]) -> Design<f64> {
        let Self { wheel, spring, chassis, .. } = self;
        let origin = mechanism.bodies()[chassis.index()].origin;
        let sunk = state[chassis.index()][2] - origin[2];
        let carried = |place| add(place, [0.0, 0.0, sunk]);
        let (wheel, spring) = match self.home {
            Some(home) => (home.wheel, home.spring),
            None => {
                let at = |point: PointId| mechanism.points()[point.index()].position;
                let center = at(wheel.center);
                let ends = spring.map(|spring| spring.ends.map(|(point, _)| at(point)));
                let wheel = Wheel { center, spin: wheel.spin_axis, radius: wheel.radius };
                (wheel, ends.map(Line::through))
            }
        };
        let along = |line: Line<f64>| Line { from: carried(line.from), to: carried(line.to) };
        Design {
            wheel: Wheel { center: carried(wheel.center), ..wheel },
            spring: spring.map(along),
        }
    }

    /// Where the ends of the steer axis are on their bodies, in body axes, where adjusters move them.
    fn adjusted_places(&self, stand: &Stand) -> [Option<[f64; 3]>; 2] {
        let h = stand.equilibrium().parameters();
        self.adjusted.map(|first| first.map(|first| [h[first], h[first + 1], h[first + 2]]))
    }

    /// How the parts move with the drivers, those of other wheels held.
    fn motions(&self, stand: &mut Stand, mechanism: &Mechanism) -> Option<Motions<f64>> {
        let travel = self.motion(self.travel, stand, mechanism)?;
        let rack = self.rack.and_then(|rack| self.motion(rack, stand, mechanism));
        Some(Motions { travel, rack })
    }

    /// How the parts move with the value of a driver, relative to the chassis.
    pub fn motion(
        &self,
        driver: DriverId,
        stand: &mut Stand,
        mechanism: &Mechanism,
    ) -> Option<Motion<f64>> {
        // A joint whose place is adjusted moves on its body, too.
        let slots = stand.system().expansion().driver_slots();
        let rates = self.adjusted.map(|first| first.map(|first| slots.rate(driver, first)));
        let adjusted = self.adjusted_places(stand);
        let tangent = stand.tangent(driver)?;
        let twist = |body| tangent.twist(body).minus(&tangent.twist(self.chassis));
        let velocity = |(point, body): (PointId, BodyId)| {
            twist(body).at(point_position(mechanism, tangent.state(), body, point))
        };
        Some(Motion {
            wheel: twist(self.wheel.body),
            steer_axis: self.steer_axis.map(|axis| {
                let ends =
                    [(axis.lower, adjusted[0], rates[0]), (axis.upper, adjusted[1], rates[1])];
                Line::through(ends.map(|(end, adjusted, rate)| {
                    let place = place(mechanism, tangent.state(), end, adjusted);
                    let rate = rate.map_or([0.0; 3], |rate| turned(tangent.state(), end.1, rate));
                    add(twist(end.1).at(place), rate)
                }))
            }),
            spring: self.spring.map(|spring| Line::through(spring.ends.map(velocity))),
        })
    }

    /// The vertical force on the wheel and how it grows with its travel.
    pub fn load(&self, stand: &mut Stand) -> Option<WheelLoad<f64>> {
        if !stand.is_loaded() || !stand.is_in_equilibrium() {
            return None;
        }
        match self.support {
            WheelSupport::Held => {
                let force = -stand.equilibrium().driver_multiplier(self.travel);
                Some(WheelLoad { force, rate: stand.driver_rate(self.travel) })
            }
            WheelSupport::Free => {
                let force = stand.equilibrium().loaded().force(self.tyre?);
                Some(WheelLoad { force: force.force[2], rate: None })
            }
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
