//! From a model to the mechanism that the solver knows.

use super::adjusters::InMechanism;
use super::architecture::{Seats, WheelRole};
use super::mirror::mirrored;
use super::setup::{Chassis, Drive, Setup, SuspensionError, WheelSupport};
use super::{JointBushing, Model, NEAR, SpinAxis, SteerAxis, TyreContact, fittings, mean};
use crate::mechanism::{
    Acts, BodyId, Contact, Curve, Direction, DriverId, DriverKind, Force, ForceId, ForceKind,
    JointKind, Law, MassProperties, Mechanism, MechanismError, PointId,
};
use crate::vector::{scale, sub};

/// The beginning of the name of a point that is the image of a bushing's.
const OPPOSITE: &str = "opposite of ";

/// The name of the point that stands for toe and camber. Names of files are one word, so no point of a model
/// has it.
pub(crate) const AXLE_POINT: &str = "spin axis";

/// How far (m) the point that stands for toe and camber is inboard of the wheel centre.
pub(crate) const AXLE_LENGTH: f64 = 0.1;

/// A mechanism together with what makes it a suspension, in SI units and ISO 8855 axes.
#[derive(Clone, Debug)]
pub struct Suspension {
    /// Bodies, joints and drivers.
    pub mechanism: Mechanism,
    /// The wheel.
    pub wheel: Wheel,
    /// The steer axis through two joints, where the architecture has one.
    pub steer_axis: Option<SteerAxis>,
    /// The spring, where the model has one.
    pub spring: Option<StrutLine>,
    /// The damper, where the model has one.
    pub damper: Option<StrutLine>,
    /// Displacement of the rack (m), positive along the y axis of the model's own axes;
    /// `None` for a suspension that does not steer.
    pub rack: Option<DriverId>,
    /// Change of the height of the wheel above the ground (m), positive in jounce in every axis
    /// system; the ground is the chassis where that is fixed, and the road where it slides.
    pub travel: DriverId,
    /// The adjusters, in the order of the model.
    pub adjusters: Vec<DriverId>,
    /// Which height [`Suspension::travel`] prescribes.
    pub drive: Drive,
    /// The tyre, where the wheel stands on it. The travel driver is there all the same: whoever
    /// looks for an equilibrium on the tyre releases it.
    pub tyre: Option<ForceId>,
    /// The chassis: the ground, or the body on the slide.
    pub chassis: BodyId,
}

/// The wheel of a suspension. Its spin is locked to the body that carries it.
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    /// The body that carries the wheel.
    pub body: BodyId,
    /// The wheel centre.
    pub center: PointId,
    /// The spin axis pointing outboard, fixed in the body.
    pub spin: Direction,
    /// The unit vector of `spin` at the design position.
    pub spin_axis: [f64; 3],
    /// Rolling radius of the tyre (m).
    pub radius: f64,
}

impl Drive {
    /// The driver that prescribes the height of a wheel.
    pub(super) fn of(self, wheel: &Wheel) -> DriverKind {
        let Wheel { center, spin, radius, .. } = *wheel;
        match self {
            Self::WheelCenter => DriverKind::Height { at: center },
            Self::ContactPatch => DriverKind::PatchHeight { center, spin, radius },
        }
    }
}

/// The line of a spring or a damper: its ends and the bodies that they belong to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrutLine {
    /// The ends.
    pub ends: [(PointId, BodyId); 2],
}

/// Whether a force acts from the ground, whatever that is: loads and tyres do.
pub(super) fn is_from_ground(force: &Force) -> bool {
    matches!(
        force.kind,
        ForceKind::Tyre { .. } | ForceKind::PointForce { .. } | ForceKind::Moment { .. }
    )
}

/// The numbers of bodies in the mechanism: with the chassis on a slide, the road is the ground
/// and every body of the architecture stands one further on.
#[derive(Clone, Copy)]
struct Numbering(usize);

impl Numbering {
    fn body(self, body: BodyId) -> BodyId {
        BodyId(body.0 + self.0)
    }

    fn bodies(self, force: &Force) -> (BodyId, BodyId) {
        let i = if is_from_ground(force) { BodyId::GROUND } else { self.body(force.i) };
        (i, self.body(force.j))
    }

    fn steer_axis(self, axis: SteerAxis) -> SteerAxis {
        let end = |(point, body)| (point, self.body(body));
        SteerAxis { lower: end(axis.lower), upper: end(axis.upper) }
    }
}

impl Model {
    /// The mechanism of this model at its design position.
    ///
    /// # Errors
    /// [`SuspensionError`] where the model lacks what the setup needs, or where the geometry has
    /// no meaning. A model straight from a file has been checked; one whose points were moved may fail.
    pub fn suspension(&self, setup: &Setup) -> Result<Suspension, SuspensionError> {
        let architecture = &self.architecture;
        if architecture.is_axle {
            return Err(SuspensionError::OnlyAxle(architecture.title.clone()));
        }
        if let Chassis::Roll { .. } = setup.chassis {
            return Err(SuspensionError::CornerRolls);
        }
        let (mut mechanism, numbers) = self.ground(setup.chassis)?;
        for (index, body) in architecture.bodies.iter().enumerate() {
            let id = BodyId(index + 1);
            let body = mechanism.add_body(&body.name, self.body_origin(id))?;
            if let Some(mass) = self.loads.mass(id) {
                mechanism.set_mass(body, mass)?;
            }
        }
        self.add_joints(&mut mechanism, numbers, setup.kinematic)?;
        let rack = self.add_rack_driver(&mut mechanism, numbers)?;
        let wheel = Wheel {
            body: numbers.body(architecture.wheel.body),
            center: architecture.wheel.center,
            spin: self.spin_direction(),
            spin_axis: self.spin_axis(),
            radius: self.wheel_radius,
        };
        let kind = setup.drive.of(&wheel);
        let travel = mechanism.add_driver("travel", BodyId::GROUND, wheel.body, kind)?;
        let tyre = match (setup.support, self.tyre_force(setup.chassis)) {
            (WheelSupport::Held, _) => None,
            (WheelSupport::Free, Some(tyre)) => Some(add_force(&mut mechanism, numbers, &tyre)?),
            (WheelSupport::Free, None) => None,
        };
        let known = InMechanism {
            name: &str::to_owned,
            body: &|body| numbers.body(body),
            point: &|point| point,
            kinematic: setup.kinematic,
        };
        let adjusters = self.add_adjusters(&mut mechanism, &known)?;
        Ok(Suspension {
            mechanism,
            wheel,
            steer_axis: architecture.steer_axis.map(|axis| numbers.steer_axis(axis)),
            spring: self.spring_line(|body| numbers.body(body)),
            damper: self.damper_line(|body| numbers.body(body)),
            rack,
            travel,
            adjusters,
            drive: setup.drive,
            tyre,
            chassis: numbers.body(BodyId::GROUND),
        })
    }

    /// The points, and the chassis as ground or on its slide.
    fn ground(&self, chassis: Chassis) -> Result<(Mechanism, Numbering), SuspensionError> {
        let name = &self.architecture.ground;
        let mut mechanism = Mechanism::new(if chassis == Chassis::Slide { "road" } else { name });
        mechanism.set_gravity([0.0, 0.0, 0.0 - self.loads.gravity])?;
        for (name, position) in self.mechanism_points() {
            mechanism.add_point(name, position)?;
        }
        if chassis == Chassis::Fixed {
            return Ok((mechanism, Numbering(0)));
        }
        let Some(mass) = self.loads.sprung_mass else {
            return Err(SuspensionError::NoQuarterCar(self.name.clone()));
        };
        let center = self.body_origin(BodyId::GROUND);
        let body = mechanism.add_body(name, center)?;
        // It cannot turn, so its inertia does not count.
        mechanism.set_mass(body, MassProperties { mass, center, inertia: [0.0; 6] })?;
        let points = self.architecture.joint_points(BodyId::GROUND);
        let at = points.first().copied().unwrap_or(self.architecture.wheel.center);
        let axis = Direction::Fixed([0.0, 0.0, 1.0]);
        let kind = JointKind::Translational { at, axis };
        mechanism.add_joint("chassis_slide", BodyId::GROUND, body, kind)?;
        Ok((mechanism, Numbering(body.0)))
    }

    /// The joints, or bushings that stand for them, and the other forces.
    fn add_joints(
        &self,
        mechanism: &mut Mechanism,
        numbers: Numbering,
        kinematic: bool,
    ) -> Result<(), MechanismError> {
        let bushings = if kinematic { &[][..] } else { &self.loads.bushings };
        for (index, joint) in self.architecture.joints.iter().enumerate() {
            if bushings.iter().all(|bushing| bushing.joint != index) {
                let (i, j) = (numbers.body(joint.i), numbers.body(joint.j));
                mechanism.add_joint(&joint.name, i, j, joint.kind)?;
            }
        }
        let (mounts, bushings) = (bushings, bushings.iter().map(|bushing| &bushing.force));
        for force in self.loads.forces.iter().chain(bushings) {
            add_force(mechanism, numbers, force)?;
        }
        for (bushing, place) in mounts.iter().filter_map(|b| Some((b, self.opposite_place(b)?))) {
            let point = format!("{OPPOSITE}{}", bushing.force.name);
            let at = mechanism.add_point(&point, place)?;
            let image = fittings::opposite(&bushing.force, at, &self.points);
            add_force(mechanism, numbers, &image)?;
        }
        Ok(())
    }

    /// The hard point, by its place in the order of the model, whose image a point of the mechanism is.
    pub(crate) fn opposite_point(&self, name: &str) -> Option<usize> {
        let bushing = name.strip_prefix(OPPOSITE)?;
        let mut bushings = self.loads.bushings.iter();
        let [at, _] = bushings.find(|other| other.force.name == bushing)?.force.kind.points()?;
        Some(at.0)
    }

    /// The hard point that gives the spin axis with the wheel centre, by its place in the order of the model, and 1
    /// where it lies outboard of that, −1 inboard.
    pub(crate) fn spindle(&self) -> Option<(usize, f64)> {
        let SpinAxis::Point(name) = &self.spin else { return None };
        let index = self.points.iter().position(|point| point.name == *name)?;
        let center = self.points[self.architecture.wheel.center.0].position;
        let outboard = self.points[index].position[1] - center[1];
        Some((index, if outboard * self.side.sign() < 0.0 { -1.0 } else { 1.0 }))
    }

    /// The place (m) of the image of a bushing that a shared body has on each side; `None` for others, and
    /// for one on the centre line, which is its own image.
    pub(super) fn opposite_place(&self, bushing: &JointBushing) -> Option<[f64; 3]> {
        let [at, _] = bushing.force.kind.points().filter(|_| bushing.each_side)?;
        let place = self.points[at.0].position;
        (place[1].abs() > NEAR).then(|| mirrored(place))
    }

    /// The line of the first spring of the model, or else the one that the architecture knows. `number`
    /// gives the bodies of the architecture their numbers in the mechanism.
    pub(crate) fn spring_line(&self, number: impl Fn(BodyId) -> BodyId) -> Option<StrutLine> {
        // Dampers, actuators and stops lie on lines, too.
        let springs = |law: &Law| law.acts == Acts::Always && law.elastic != Curve::Zero;
        self.strut_line(springs, self.architecture.spring.as_ref(), number)
    }

    /// The line of the first damper of the model, which may be one with its spring, or else the one that
    /// the architecture knows.
    pub(crate) fn damper_line(&self, number: impl Fn(BodyId) -> BodyId) -> Option<StrutLine> {
        let damps = |law: &Law| law.acts == Acts::Always && law.viscous != Curve::Zero;
        self.strut_line(damps, self.architecture.damper.as_ref(), number)
    }

    fn strut_line(
        &self,
        belongs: impl Fn(&Law) -> bool,
        seats: Option<&Seats>,
        number: impl Fn(BodyId) -> BodyId,
    ) -> Option<StrutLine> {
        for force in &self.loads.forces {
            let ForceKind::Line { on_i, on_j, law, .. } = &force.kind else { continue };
            if belongs(law) {
                return Some(StrutLine {
                    ends: [(*on_i, number(force.i)), (*on_j, number(force.j))],
                });
            }
        }
        let end = |(name, body): &(String, BodyId)| {
            let point = self.points.iter().position(|point| point.name == *name)?;
            Some((PointId(point), number(*body)))
        };
        Some(StrutLine { ends: [end(&seats?.lower)?, end(&seats?.upper)?] })
    }

    /// The law of the tyre: its value is minus the deflection (m).
    pub fn tyre_law(&self) -> Option<&Law> {
        self.loads.tyre.as_ref().map(|tyre| &tyre.law)
    }

    /// The tyre as a force element with the numbers of the architecture. The ground comes nearer to a chassis
    /// that stands lower; one that slides finds its height itself.
    pub(super) fn tyre_force(&self, chassis: Chassis) -> Option<Force> {
        let tyre = self.loads.tyre.as_ref()?;
        let WheelRole { body, center } = self.architecture.wheel;
        let contact = match tyre.contact {
            TyreContact::WheelCenter => Contact::Center(center),
            TyreContact::ContactPatch => Contact::Patch { center, spin: self.spin_direction() },
        };
        let raised = match chassis {
            Chassis::Slide => 0.0,
            _ => self.static_state.ride_height,
        };
        let (free_radius, law) = (tyre.free_radius, tyre.law.clone());
        let ground = tyre.ground - raised;
        let kind = ForceKind::Tyre { contact, free_radius, ground, law };
        Some(Force { name: "tyre".to_owned(), i: BodyId::GROUND, j: body, kind })
    }

    /// The mean of the points at which a body is held. It is a constant of the
    /// mechanism: it does not follow when a point moves.
    pub(super) fn body_origin(&self, body: BodyId) -> [f64; 3] {
        let mut points = self.architecture.joint_points(body);
        points.retain(|point| point.0 < self.points.len());
        if body == self.architecture.wheel.body {
            points.push(self.architecture.wheel.center);
            points.sort_unstable();
            points.dedup();
        }
        mean(points.iter().map(|point| self.points[point.0].position)).unwrap_or_default()
    }

    fn add_rack_driver(
        &self,
        mechanism: &mut Mechanism,
        numbers: Numbering,
    ) -> Result<Option<DriverId>, MechanismError> {
        let Some((carrier, rack, at)) = self.rack() else {
            return Ok(None);
        };
        let along = self.rack_direction();
        let kind = DriverKind::Displacement { at, along };
        let (i, j) = (numbers.body(carrier), numbers.body(rack));
        mechanism.add_driver("rack", i, j, kind).map(Some)
    }

    /// The body that carries the rack, the body that is driven along its slide, and the point of that: the
    /// rack itself, the pitman arm, or the end of a steering gear that gives way.
    pub(super) fn rack(&self) -> Option<(BodyId, BodyId, PointId)> {
        let joint = &self.architecture.joints[self.architecture.rack?];
        match joint.kind {
            JointKind::Translational { at, .. } => Some((joint.i, joint.j, at)),
            _ => Some((joint.i, joint.j, self.architecture.pitman_point?)),
        }
    }

    /// The direction in which the displacement of the rack is positive.
    pub(super) fn rack_direction(&self) -> Direction {
        Direction::Fixed(self.axes.to_iso([0.0, 1.0, 0.0]))
    }

    /// The points of the mechanism with their names: those of the model in its order, then
    /// [the one](Self::axle_point) that stands for toe and camber.
    pub(super) fn mechanism_points(&self) -> impl Iterator<Item = (&str, [f64; 3])> {
        let points = self.points.iter().map(|point| (&*point.name, point.position));
        let center = self.points[self.architecture.wheel.center.0].position;
        let inboard = || sub(center, scale(AXLE_LENGTH, self.spin_axis()));
        let axle = self.axle_point().map(|_| (AXLE_POINT, inboard()));
        points.chain(axle)
    }

    /// The point of the mechanism, inboard of the wheel centre on the spin axis, that toe and camber place;
    /// `None` where a point of the model gives the spin axis.
    pub fn axle_point(&self) -> Option<PointId> {
        matches!(self.spin, SpinAxis::Alignment(_)).then_some(PointId(self.points.len()))
    }

    /// The spin axis as the mechanism knows it: it follows the points that define it.
    pub(super) fn spin_direction(&self) -> Direction {
        let center = self.architecture.wheel.center;
        if let Some(inboard) = self.axle_point() {
            return Direction::Between(inboard, center);
        }
        match self.spindle() {
            None => Direction::Fixed(self.spin_axis()),
            Some((index, outboard)) if outboard < 0.0 => Direction::Between(PointId(index), center),
            Some((index, _)) => Direction::Between(center, PointId(index)),
        }
    }
}

fn add_force(
    mechanism: &mut Mechanism,
    numbers: Numbering,
    force: &Force,
) -> Result<ForceId, MechanismError> {
    let (i, j) = numbers.bodies(force);
    mechanism.add_force(&force.name, i, j, force.kind.clone())
}
