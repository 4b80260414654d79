//! Both sides of a vehicle in one mechanism.

mod across;

use super::adjusters::InMechanism;
use super::chassis::Rolling;
use super::setup::{Chassis, Drive, Setup, SuspensionError, WheelSupport};
use super::suspension::{StrutLine, Wheel, is_from_ground};
use super::{AntiRollBar, Model, Side, SteerAxis, mean};
use crate::mechanism::{
    BodyId, Direction, DriverId, DriverKind, Force, ForceId, ForceKind, Joint, JointKind, Law,
    Mechanism, MechanismError, PointId,
};

/// Two corners on one chassis, in SI units and ISO 8855 axes.
///
/// Points, bodies, joints and forces are named `left_…` and `right_…`; those that both sides have
/// together keep their names.
#[derive(Clone, Debug)]
pub struct AxleSuspension {
    /// Bodies, joints, drivers and force elements.
    pub mechanism: Mechanism,
    /// The left and the right side.
    pub sides: [AxleSide; 2],
    /// Displacement of the rack (m), positive along the y axis of the model's own axes;
    /// `None` for an axle that does not steer.
    pub rack: Option<DriverId>,
    /// The chassis that rolls above the road; `None` where it is the ground.
    pub rolling: Option<Rolling>,
    /// The adjusters of the left and the right side, in the order of the models.
    pub adjusters: [Vec<DriverId>; 2],
    /// Which height the travels prescribe.
    pub drive: Drive,
}

/// One side of an axle.
#[derive(Clone, Copy, Debug)]
pub struct AxleSide {
    /// Left or right.
    pub side: Side,
    /// The wheel.
    pub wheel: Wheel,
    /// The steer axis through two joints, where the architecture has one.
    pub steer_axis: Option<SteerAxis>,
    /// The spring, where the model has one.
    pub spring: Option<StrutLine>,
    /// The damper, where the model has one.
    pub damper: Option<StrutLine>,
    /// Change of the height of the wheel (m), positive in jounce. It is there also where the wheel
    /// is free; whoever looks for an equilibrium on tyres releases it.
    pub travel: DriverId,
    /// The tyre, where the wheel stands on it.
    pub tyre: Option<ForceId>,
}

impl Model {
    /// The axle of this model and [its other side](Model::other_side) at the design position.
    ///
    /// What lies between the ground and bodies that the architecture calls shared is there once, as
    /// this model has it; all else is on both sides. The anti-roll bar joins them.
    ///
    /// # Errors
    /// [`SuspensionError`] as for [`Model::suspension`], and for a chassis on a slide.
    pub fn axle(&self, setup: &Setup) -> Result<AxleSuspension, SuspensionError> {
        self.axle_with(&self.other_side(), setup)
    }

    /// The axle of this model and another one for the other side. What both sides have together is as this
    /// model has it.
    ///
    /// # Errors
    /// As for [`Model::axle`], and [`SuspensionError::SidesDiffer`] for models that have different
    /// architectures or lie on one side.
    pub fn axle_with(
        &self,
        other: &Self,
        setup: &Setup,
    ) -> Result<AxleSuspension, SuspensionError> {
        let models = match self.side {
            Side::Left => [self, other],
            Side::Right => [other, self],
        };
        if setup.chassis == Chassis::Slide {
            return Err(SuspensionError::AxleSlides);
        }
        if let Some(difference) = difference(models) {
            let [left, right] = models.map(|model| model.name.clone());
            return Err(SuspensionError::SidesDiffer { left, right, difference });
        }
        let (mut mechanism, rolling) = self.axle_ground(setup.chassis)?;
        mechanism.set_gravity([0.0, 0.0, 0.0 - self.loads.gravity])?;
        let chassis = rolling.map_or(BodyId::GROUND, |rolling| rolling.body);
        let shared = self.add_shared_bodies(&mut mechanism, chassis)?;
        let left = Half::add(models[0], &shared, &mut mechanism)?;
        let right = Half::add(models[1], &shared, &mut mechanism)?;
        let [own, opposite] = match self.side {
            Side::Left => [&left, &right],
            Side::Right => [&right, &left],
        };
        own.add_parts(&mut mechanism, setup.kinematic, true)?;
        let rack = own.add_rack_driver(&mut mechanism)?;
        let sides = [left.add_side(&mut mechanism, setup)?, right.add_side(&mut mechanism, setup)?];
        if let [Some(on_left), Some(on_right)] =
            [left.add_arm(&mut mechanism)?, right.add_arm(&mut mechanism)?]
        {
            self.couple_arms(&mut mechanism, on_left, on_right)?;
        }
        own.add_parts_across(opposite, &mut mechanism)?;
        let kinematic = setup.kinematic;
        let adjusters = [
            left.add_adjusters(&mut mechanism, kinematic)?,
            right.add_adjusters(&mut mechanism, kinematic)?,
        ];
        Ok(AxleSuspension { mechanism, sides, rack, rolling, adjusters, drive: setup.drive })
    }

    /// Whether anything but the tyres acts on the bodies of the axle.
    pub fn axle_has_forces(&self) -> bool {
        let other = self.other.as_ref().is_some_and(|other| other.has_forces());
        let bar = self.anti_roll_bar().is_some_and(|bar| bar.stiffness > 0.0);
        self.has_forces() || !self.loads.axle_forces.is_empty() || other || bar
    }

    /// The numbers of the bodies that both sides have together, the chassis first; others are `None`.
    fn add_shared_bodies(
        &self,
        mechanism: &mut Mechanism,
        chassis: BodyId,
    ) -> Result<Vec<Option<BodyId>>, MechanismError> {
        let mut numbers = vec![Some(chassis)];
        for (index, body) in self.architecture.bodies.iter().enumerate() {
            let id = BodyId(index + 1);
            numbers.push(None);
            if body.shared {
                let added = mechanism.add_body(&body.name, self.body_origin(id))?;
                if let Some(mass) = self.loads.mass(id) {
                    mechanism.set_mass(added, mass)?;
                }
                numbers[id.0] = Some(added);
            }
        }
        Ok(numbers)
    }

    /// The torsion spring between the arms of the anti-roll bar; none for a bar that is cut.
    fn couple_arms(
        &self,
        mechanism: &mut Mechanism,
        left: BodyId,
        right: BodyId,
    ) -> Result<(), MechanismError> {
        let stiffness = self.anti_roll_bar().map_or(0.0, |bar| bar.stiffness);
        if stiffness > 0.0 {
            let axis = Direction::Fixed(self.axes.to_iso([0.0, 1.0, 0.0]));
            let kind = ForceKind::Torsion { axis, law: Law::spring(stiffness) };
            mechanism.add_force("anti_roll_bar", right, left, kind)?;
        }
        Ok(())
    }
}

/// What keeps two models from being the sides of one axle.
pub(super) fn difference([left, right]: [&Model; 2]) -> Option<String> {
    if left.side == right.side {
        return Some(format!("both lie on the {}", left.side.name()));
    }
    let [a, b] = [&left.architecture, &right.architecture];
    // Fittings are bodies that one of the two may lack.
    for (side, here, there) in [(left.side, a, b), (right.side, b, a)] {
        let lacks = |name: &String| there.bodies.iter().all(|body| body.name != *name);
        if a.title == b.title
            && let Some(body) = here.bodies.iter().find(|body| lacks(&body.name))
        {
            return Some(format!("only the {} one has a body `{}`", side.name(), body.name));
        }
    }
    let points = |model: &Model| -> Vec<String> {
        model.architecture.points.iter().map(|point| point.name.clone()).collect()
    };
    let bodies = |model: &Model| -> Vec<(String, bool)> {
        let bodies = model.architecture.bodies.iter();
        bodies.map(|body| (body.name.clone(), body.shared)).collect()
    };
    let same_joints = a.joints.len() == b.joints.len()
        && a.axle_joints.len() == b.axle_joints.len()
        && a.joints
            .iter()
            .zip(&b.joints)
            .all(|(a, b)| (&a.name, a.i, a.j, shape(a)) == (&b.name, b.i, b.j, shape(b)));
    if a.ground != b.ground
        || points(left) != points(right)
        || bodies(left) != bodies(right)
        || !same_joints
    {
        return Some(format!("their architectures `{}` and `{}` differ", a.title, b.title));
    }
    if let Some(difference) = across::missing_point([left, right]) {
        return Some(difference);
    }
    let bars = [left, right].map(|model| model.anti_roll_bar().is_some());
    (bars[0] != bars[1]).then(|| "only one of them has an anti-roll bar".to_owned())
}

/// The kind and the points of a joint; directions such as the spin axis may differ.
fn shape(joint: &Joint) -> JointKind {
    joint.kind.on_lines(|_| Direction::Fixed([0.0; 3]))
}

/// One side on its way into the mechanism: its names and numbers there.
struct Half<'a> {
    model: &'a Model,
    first_point: usize,
    bodies: Vec<BodyId>,
}

impl<'a> Half<'a> {
    /// Adds the points and bodies of a side.
    fn add(
        model: &'a Model,
        shared: &[Option<BodyId>],
        mechanism: &mut Mechanism,
    ) -> Result<Self, MechanismError> {
        let mut half = Self { model, first_point: mechanism.points().len(), bodies: vec![] };
        for (name, position) in model.mechanism_points() {
            mechanism.add_point(&half.name(name), position)?;
        }
        for (index, shared) in shared.iter().enumerate() {
            let id = BodyId(index);
            let number = match shared {
                Some(number) => *number,
                None => {
                    let name = half.name(model.architecture.body_name(id));
                    let added = mechanism.add_body(&name, model.body_origin(id))?;
                    if let Some(mass) = model.loads.mass(id) {
                        mechanism.set_mass(added, mass)?;
                    }
                    added
                }
            };
            half.bodies.push(number);
        }
        Ok(half)
    }

    /// The name of a part of this side.
    fn name(&self, name: &str) -> String {
        format!("{}_{name}", self.model.side.name())
    }

    fn body(&self, body: BodyId) -> BodyId {
        self.bodies[body.0]
    }

    fn point(&self, point: PointId) -> PointId {
        PointId(point.0 + self.first_point)
    }

    /// Adds the joints, the bushings that stand for them and the force elements: those that
    /// both sides have together, or those of this side.
    fn add_parts(
        &self,
        mechanism: &mut Mechanism,
        kinematic: bool,
        shared: bool,
    ) -> Result<(), MechanismError> {
        let (architecture, loads) = (&self.model.architecture, &self.model.loads);
        let together = |i, j| architecture.is_shared(i) && architecture.is_shared(j);
        let name = |name: &str| if shared { name.to_owned() } else { self.name(name) };
        let bushings = if kinematic { &[][..] } else { &loads.bushings };
        for (index, joint) in architecture.joints.iter().enumerate() {
            let replaced = bushings.iter().any(|bushing| bushing.joint == index);
            if together(joint.i, joint.j) == shared && !replaced {
                let kind = joint.kind.on_points(|point| self.point(point));
                let (i, j) = (self.body(joint.i), self.body(joint.j));
                mechanism.add_joint(&name(&joint.name), i, j, kind)?;
            }
        }
        let forces = loads.forces.iter().map(|force| (force, together(force.i, force.j)));
        let bushings = bushings.iter().map(|bushing| {
            let Force { i, j, .. } = bushing.force;
            let once = together(i, j) && self.model.opposite_place(bushing).is_none();
            (&bushing.force, once)
        });
        for (force, once) in forces.chain(bushings) {
            if once == shared {
                self.add_force(mechanism, &name(&force.name), force)?;
            }
        }
        Ok(())
    }

    fn add_force(
        &self,
        mechanism: &mut Mechanism,
        name: &str,
        force: &Force,
    ) -> Result<ForceId, MechanismError> {
        let kind = force.kind.clone().on_points(|point| self.point(point));
        let i = if is_from_ground(force) { BodyId::GROUND } else { self.body(force.i) };
        mechanism.add_force(name, i, self.body(force.j), kind)
    }

    fn add_rack_driver(
        &self,
        mechanism: &mut Mechanism,
    ) -> Result<Option<DriverId>, MechanismError> {
        let Some((carrier, rack, at)) = self.model.rack() else {
            return Ok(None);
        };
        let along = self.model.rack_direction();
        let kind = DriverKind::Displacement { at: self.point(at), along };
        let (i, j) = (self.body(carrier), self.body(rack));
        mechanism.add_driver("rack", i, j, kind).map(Some)
    }

    /// Adds all that is of this side alone.
    fn add_side(
        &self,
        mechanism: &mut Mechanism,
        setup: &Setup,
    ) -> Result<AxleSide, MechanismError> {
        let (model, architecture) = (self.model, &self.model.architecture);
        self.add_parts(mechanism, setup.kinematic, false)?;
        let wheel = Wheel {
            body: self.body(architecture.wheel.body),
            center: self.point(architecture.wheel.center),
            spin: model.spin_direction().on_points(|point| self.point(point)),
            spin_axis: model.spin_axis(),
            radius: model.wheel_radius,
        };
        let end = |(point, body)| (self.point(point), self.body(body));
        let on_side = |line: StrutLine| StrutLine {
            ends: line.ends.map(|(point, body)| (self.point(point), body)),
        };
        let kind = setup.drive.of(&wheel);
        let travel =
            mechanism.add_driver(&self.name("travel"), BodyId::GROUND, wheel.body, kind)?;
        let tyre = match (setup.support, model.tyre_force(setup.chassis)) {
            (WheelSupport::Free, Some(tyre)) => {
                Some(self.add_force(mechanism, &self.name(&tyre.name), &tyre)?)
            }
            _ => None,
        };
        Ok(AxleSide {
            side: model.side,
            wheel,
            steer_axis: architecture
                .steer_axis
                .map(|axis| SteerAxis { lower: end(axis.lower), upper: end(axis.upper) }),
            spring: model.spring_line(|body| self.body(body)).map(on_side),
            damper: model.damper_line(|body| self.body(body)).map(on_side),
            travel,
            tyre,
        })
    }

    fn add_adjusters(
        &self,
        mechanism: &mut Mechanism,
        kinematic: bool,
    ) -> Result<Vec<DriverId>, MechanismError> {
        let known = InMechanism {
            name: &|name| self.name(name),
            body: &|body| self.body(body),
            point: &|point| self.point(point),
            kinematic,
        };
        self.model.add_adjusters(mechanism, &known)
    }

    /// Adds the arm of the anti-roll bar, which turns on the chassis, and its drop link.
    fn add_arm(&self, mechanism: &mut Mechanism) -> Result<Option<BodyId>, MechanismError> {
        let Some(&AntiRollBar { pivot, link, link_body, .. }) = self.model.anti_roll_bar() else {
            return Ok(None);
        };
        let ends = [pivot, link[0]].map(|point| self.model.points[point.0].position);
        let origin = mean(ends.into_iter()).unwrap_or_default();
        let arm = mechanism.add_body(&self.name("arb_arm"), origin)?;
        let axis = Direction::Fixed([0.0, 1.0, 0.0]);
        let bearing = JointKind::Revolute { at: self.point(pivot), axis };
        let chassis = self.body(BodyId::GROUND);
        mechanism.add_joint(&self.name("arb_bearing"), chassis, arm, bearing)?;
        let link = JointKind::Link { on_i: self.point(link[0]), on_j: self.point(link[1]) };
        mechanism.add_joint(&self.name("arb_link"), arm, self.body(link_body), link)?;
        Ok(Some(arm))
    }
}
