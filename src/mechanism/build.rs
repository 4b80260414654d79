//! Building a mechanism by name, and asking it for its parts.

use super::adjuster::Adjuster;
use super::course::Course;
use super::error::MechanismError;
use super::force::{Force, InitialVelocity};
use super::topology::{
    Body, BodyId, Direction, Driver, DriverId, DriverKind, Joint, JointKind, Point, PointId,
};
use crate::vector::{norm, sub};

/// Points closer than this (m) count as one point: no part of a vehicle is a micrometre long.
const COINCIDENT: f64 = 1e-6;

/// Largest cosine of two axes that count as normal to each other.
const NORMAL: f64 = 1e-10;

/// A system of bodies, joints and drivers.
#[derive(Clone, Debug)]
pub struct Mechanism {
    pub(super) bodies: Vec<Body>,
    points: Vec<Point>,
    joints: Vec<Joint>,
    pub(super) drivers: Vec<Driver>,
    pub(super) adjusters: Vec<(DriverId, Adjuster)>,
    pub(super) forces: Vec<Force>,
    pub(super) gravity: [f64; 3],
}

impl Mechanism {
    /// An empty system with the ground under the given name, such as `chassis`.
    pub fn new(ground: &str) -> Self {
        Self {
            bodies: vec![body(ground, [0.0; 3])],
            points: vec![],
            joints: vec![],
            drivers: vec![],
            adjusters: vec![],
            forces: vec![],
            gravity: [0.0; 3],
        }
    }

    /// Adds a body whose frame has its origin at `origin` (m).
    ///
    /// # Errors
    /// [`MechanismError`] for a name that is taken or a number that is not finite.
    pub fn add_body(&mut self, name: &str, origin: [f64; 3]) -> Result<BodyId, MechanismError> {
        new_name("body", name, self.bodies.iter().map(|body| &*body.name))?;
        finite("body", name, &origin)?;
        self.bodies.push(body(name, origin));
        Ok(BodyId(self.bodies.len() - 1))
    }

    /// Adds a named point at its design position (m).
    ///
    /// # Errors
    /// [`MechanismError`] for a name that is taken or a number that is not finite.
    pub fn add_point(&mut self, name: &str, position: [f64; 3]) -> Result<PointId, MechanismError> {
        new_name("point", name, self.points.iter().map(|point| &*point.name))?;
        finite("point", name, &position)?;
        self.points.push(Point { name: name.to_owned(), position });
        Ok(PointId(self.points.len() - 1))
    }

    /// Adds a joint.
    ///
    /// # Errors
    /// [`MechanismError`] where the joint has no meaning, such as an axis between coincident points.
    pub fn add_joint(
        &mut self,
        name: &str,
        i: BodyId,
        j: BodyId,
        kind: JointKind,
    ) -> Result<(), MechanismError> {
        new_name("joint", name, self.joints.iter().map(|joint| &*joint.name))?;
        self.check_bodies("joint", name, i, j)?;
        self.check_points("joint", name, kind.points())?;
        for direction in kind.directions() {
            self.check_direction("joint", name, direction)?;
        }
        match kind {
            JointKind::Link { on_i, on_j } => {
                self.check_distance("joint", name, "length", on_i, on_j)?;
            }
            JointKind::Hooke { pin_i, pin_j, .. } => self.check_normal(name, pin_i, pin_j)?,
            JointKind::PerpendicularAxes { axis_i, axis_j, .. } => {
                self.check_normal(name, axis_i, axis_j)?;
            }
            JointKind::RackAndPinion { pitch_radius: way, .. }
            | JointKind::Screw { lead: way, .. } => {
                finite("joint", name, &[way])?;
                if way == 0.0 {
                    return Err(MechanismError::NoWay { name: name.to_owned() });
                }
            }
            _ => {}
        }
        self.joints.push(Joint { name: name.to_owned(), i, j, kind });
        Ok(())
    }

    /// Adds a driver.
    ///
    /// # Errors
    /// [`MechanismError`] as for joints.
    pub fn add_driver(
        &mut self,
        name: &str,
        i: BodyId,
        j: BodyId,
        kind: DriverKind,
    ) -> Result<DriverId, MechanismError> {
        new_name("driver", name, self.drivers.iter().map(|driver| &*driver.name))?;
        if matches!(kind, DriverKind::Height { .. } | DriverKind::PatchHeight { .. }) {
            self.check_height("driver", name, i, j)?;
        }
        self.check_bodies("driver", name, i, j)?;
        if let Some(points) = kind.points() {
            self.check_points("driver", name, points)?;
        }
        if let Some(direction) = kind.direction() {
            self.check_direction("driver", name, direction)?;
        }
        match kind {
            DriverKind::Length { on_i, on_j } => {
                self.check_distance("driver", name, "length", on_i, on_j)?;
            }
            DriverKind::PatchHeight { center, spin, radius } => {
                self.check_disc("driver", name, center, spin, radius)?;
            }
            _ => {}
        }
        self.drivers.push(Driver { name: name.to_owned(), i, j, kind, course: None });
        Ok(DriverId(self.drivers.len() - 1))
    }

    /// Says how the value of a driver changes with time in dynamics; statics and sweeps do not know it.
    ///
    /// # Errors
    /// [`MechanismError::Course`] for numbers that are not finite or a step that ends before it begins.
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn set_course(&mut self, driver: DriverId, course: Course) -> Result<(), MechanismError> {
        let driver = &mut self.drivers[driver.0];
        if !course.is_sound() {
            return Err(MechanismError::Course { name: driver.name.clone() });
        }
        driver.course = Some(course);
        Ok(())
    }

    /// All bodies; the ground is the first.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// All named points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// All joints.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// All drivers.
    pub fn drivers(&self) -> &[Driver] {
        &self.drivers
    }

    /// What a driver adjusts; `None` for one that prescribes a motion.
    pub fn adjuster(&self, driver: DriverId) -> Option<&Adjuster> {
        self.adjusters.iter().find(|(id, _)| *id == driver).map(|(_, adjuster)| adjuster)
    }

    /// The numbers of all bodies, the ground first.
    pub fn body_ids(&self) -> impl Iterator<Item = BodyId> + use<> {
        (0..self.bodies.len()).map(BodyId)
    }

    /// The numbers of all drivers.
    pub fn driver_ids(&self) -> impl Iterator<Item = DriverId> + use<> {
        (0..self.drivers.len()).map(DriverId)
    }

    /// The body of a name.
    pub fn body_named(&self, name: &str) -> Option<BodyId> {
        self.bodies.iter().position(|body| body.name == name).map(BodyId)
    }

    /// The point of a name.
    pub fn point_named(&self, name: &str) -> Option<PointId> {
        self.points.iter().position(|point| point.name == name).map(PointId)
    }

    /// The driver of a name.
    pub fn driver_named(&self, name: &str) -> Option<DriverId> {
        self.drivers.iter().position(|driver| driver.name == name).map(DriverId)
    }

    /// Design positions of all points (m), the form that [`super::Expansion::parameters`] takes.
    pub fn positions(&self) -> Vec<[f64; 3]> {
        self.points.iter().map(|point| point.position).collect()
    }

    /// Moves all points.
    ///
    /// # Panics
    /// If there are not as many positions as points.
    pub(crate) fn set_positions(&mut self, positions: &[[f64; 3]]) {
        assert_eq!(positions.len(), self.points.len(), "each point has a position");
        for (point, position) in self.points.iter_mut().zip(positions) {
            point.position = *position;
        }
    }

    /// The vector of a direction at the design position, not of length one.
    pub(super) fn vector(&self, direction: Direction) -> [f64; 3] {
        match direction {
            Direction::Between(from, to) => {
                sub(self.points[to.0].position, self.points[from.0].position)
            }
            Direction::Fixed(vector) => vector,
        }
    }

    pub(super) fn check_bodies(
        &self,
        what: &'static str,
        name: &str,
        i: BodyId,
        j: BodyId,
    ) -> Result<(), MechanismError> {
        if let Some(unknown) = [i, j].into_iter().find(|id| id.0 >= self.bodies.len()) {
            return Err(unknown_id(what, name, "body", unknown.0));
        }
        if i == j {
            return Err(MechanismError::SameBody {
                what,
                name: name.to_owned(),
                body: self.bodies[i.0].name.clone(),
            });
        }
        Ok(())
    }

    pub(super) fn check_points(
        &self,
        what: &'static str,
        name: &str,
        points: [PointId; 2],
    ) -> Result<(), MechanismError> {
        match points.into_iter().find(|id| id.0 >= self.points.len()) {
            Some(unknown) => Err(unknown_id(what, name, "point", unknown.0)),
            None => Ok(()),
        }
    }

    pub(super) fn check_direction(
        &self,
        what: &'static str,
        name: &str,
        direction: Direction,
    ) -> Result<(), MechanismError> {
        match direction {
            Direction::Between(from, to) => {
                self.check_points(what, name, [from, to])?;
                self.check_distance(what, name, "direction", from, to)
            }
            Direction::Fixed(vector) => {
                finite(what, name, &vector)?;
                // Lengths outside this range would over- or underflow when squared.
                let largest = vector.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
                if (1e-100..=1e100).contains(&largest) {
                    return Ok(());
                }
                Err(MechanismError::ZeroDirection {
                    what,
                    name: name.to_owned(),
                    direction: vector,
                })
            }
        }
    }

    /// Whether two directions are normal to each other at the design position.
    fn check_normal(&self, name: &str, i: Direction, j: Direction) -> Result<(), MechanismError> {
        let [i, j] = [i, j].map(|direction| crate::vector::unit(self.vector(direction)));
        let cosine = crate::vector::dot(i, j);
        if cosine.abs() <= NORMAL {
            return Ok(());
        }
        let angle = cosine.clamp(-1.0, 1.0).acos().to_degrees();
        Err(MechanismError::NotNormal { name: name.to_owned(), angle })
    }

    pub(super) fn check_distance(
        &self,
        what: &'static str,
        name: &str,
        part: &'static str,
        from: PointId,
        to: PointId,
    ) -> Result<(), MechanismError> {
        let (from, to) = (&self.points[from.0], &self.points[to.0]);
        let distance = norm(sub(to.position, from.position));
        if distance > COINCIDENT {
            return Ok(());
        }
        Err(MechanismError::CoincidentPoints {
            what,
            name: name.to_owned(),
            part,
            from: Box::new(from.clone()),
            to: Box::new(to.clone()),
            distance,
        })
    }

    pub(super) fn check_height(
        &self,
        what: &'static str,
        name: &str,
        i: BodyId,
        j: BodyId,
    ) -> Result<(), MechanismError> {
        if i == BodyId::GROUND && j != BodyId::GROUND {
            return Ok(());
        }
        let body_name = |id: BodyId| {
            self.bodies
                .get(id.0)
                .map_or_else(|| format!("body number {}", id.0), |body| body.name.clone())
        };
        Err(MechanismError::HeightBodies {
            what,
            name: name.to_owned(),
            i: body_name(i),
            j: body_name(j),
            ground: body_name(BodyId::GROUND),
        })
    }

    pub(super) fn check_disc(
        &self,
        what: &'static str,
        name: &str,
        center: PointId,
        spin: Direction,
        radius: f64,
    ) -> Result<(), MechanismError> {
        finite(what, name, &[radius])?;
        let center = self.points[center.0].name.clone();
        let name = name.to_owned();
        if radius <= 0.0 {
            return Err(MechanismError::Radius { what, name, radius, center });
        }
        let spin = crate::vector::unit(self.vector(spin));
        if spin[0].hypot(spin[1]) < 1e-6 {
            return Err(MechanismError::VerticalSpin { what, name, center });
        }
        Ok(())
    }
}

fn body(name: &str, origin: [f64; 3]) -> Body {
    let initial_velocity = InitialVelocity::default();
    Body { name: name.to_owned(), origin, mass: None, initial_velocity }
}

pub(super) fn new_name<'a>(
    what: &'static str,
    name: &str,
    mut taken: impl Iterator<Item = &'a str>,
) -> Result<(), MechanismError> {
    if name.trim().is_empty() {
        return Err(MechanismError::EmptyName { what });
    }
    if taken.any(|other| other == name) {
        return Err(MechanismError::DuplicateName { what, name: name.to_owned() });
    }
    Ok(())
}

pub(super) fn finite(
    what: &'static str,
    name: &str,
    numbers: &[f64],
) -> Result<(), MechanismError> {
    match numbers.iter().find(|number| !number.is_finite()) {
        Some(&value) => Err(MechanismError::NotFinite { what, name: name.to_owned(), value }),
        None => Ok(()),
    }
}

fn unknown_id(
    what: &'static str,
    name: &str,
    target: &'static str,
    number: usize,
) -> MechanismError {
    MechanismError::UnknownId { what, name: name.to_owned(), target, number }
}
