//! Adding force elements, masses and gravity to a mechanism.

use super::build::{Mechanism, finite, new_name};
use super::error::MechanismError;
use super::force::{
    Contact, Force, ForceId, ForceKind, InitialVelocity, MassProperties, Reference, Triad,
};
use super::law::{Curve, Law};
use super::topology::{BodyId, Direction};
use crate::vector::{cross, norm, unit};

impl Mechanism {
    /// Adds a force element.
    ///
    /// # Errors
    /// [`MechanismError`] where the element has no meaning, such as a spring between coincident
    /// points whose length is measured from the design position.
    pub fn add_force(
        &mut self,
        name: &str,
        i: BodyId,
        j: BodyId,
        kind: ForceKind,
    ) -> Result<ForceId, MechanismError> {
        new_name("force", name, self.forces.iter().map(|force| &*force.name))?;
        self.check_bodies("force", name, i, j)?;
        if let Some(points) = kind.points() {
            self.check_points("force", name, points)?;
        }
        for direction in kind.directions() {
            self.check_direction("force", name, direction)?;
        }
        self.check_force(name, i, j, &kind)?;
        self.forces.push(Force { name: name.to_owned(), i, j, kind });
        Ok(ForceId(self.forces.len() - 1))
    }

    /// All force elements.
    pub fn forces(&self) -> &[Force] {
        &self.forces
    }

    /// The numbers of all force elements.
    pub fn force_ids(&self) -> impl Iterator<Item = ForceId> + use<> {
        (0..self.forces.len()).map(ForceId)
    }

    /// The force element of a name.
    pub fn force_named(&self, name: &str) -> Option<ForceId> {
        self.forces.iter().position(|force| force.name == name).map(ForceId)
    }

    /// Gives a body mass and inertia.
    ///
    /// # Errors
    /// [`MechanismError`] for a mass below zero or an inertia tensor that no body has.
    ///
    /// # Panics
    /// If the body belongs to another mechanism.
    pub fn set_mass(&mut self, body: BodyId, mass: MassProperties) -> Result<(), MechanismError> {
        let name = &self.bodies[body.0].name;
        finite("body", name, &[mass.mass])?;
        finite("body", name, &mass.center)?;
        finite("body", name, &mass.inertia)?;
        if let Some(problem) = implausible(&mass) {
            return Err(MechanismError::Mass { name: name.clone(), problem });
        }
        self.bodies[body.0].mass = Some(mass);
        Ok(())
    }

    /// Says how a body moves at the start of dynamics.
    ///
    /// # Errors
    /// [`MechanismError::NotFinite`].
    ///
    /// # Panics
    /// If the body belongs to another mechanism.
    pub fn set_initial_velocity(
        &mut self,
        body: BodyId,
        motion: InitialVelocity,
    ) -> Result<(), MechanismError> {
        let name = &self.bodies[body.0].name;
        finite("body", name, &motion.velocity)?;
        finite("body", name, &motion.rotation)?;
        self.bodies[body.0].initial_velocity = motion;
        Ok(())
    }

    /// Sets the acceleration of gravity (m/s²), zero at first.
    ///
    /// # Errors
    /// [`MechanismError::NotFinite`].
    pub fn set_gravity(&mut self, gravity: [f64; 3]) -> Result<(), MechanismError> {
        finite("gravity", "gravity", &gravity)?;
        self.gravity = gravity;
        Ok(())
    }

    /// The acceleration of gravity (m/s²).
    pub fn gravity(&self) -> [f64; 3] {
        self.gravity
    }

    fn check_force(
        &self,
        name: &str,
        i: BodyId,
        j: BodyId,
        kind: &ForceKind,
    ) -> Result<(), MechanismError> {
        match kind {
            ForceKind::Line { on_i, on_j, reference, law } => {
                check_law(name, law)?;
                match reference {
                    Reference::Length(length) => finite("force", name, &[*length]),
                    Reference::Design(offset) => {
                        finite("force", name, &[*offset])?;
                        self.check_distance("force", name, "length", *on_i, *on_j)
                    }
                }
            }
            ForceKind::Slide { law, .. } | ForceKind::Torsion { law, .. } => check_law(name, law),
            ForceKind::Bushing(bushing) => {
                for law in bushing.translation.iter().chain(&bushing.rotation) {
                    check_law(name, law)?;
                }
                self.check_triad("force", name, bushing.axes)
            }
            ForceKind::Tyre { contact, free_radius, ground, law } => {
                check_law(name, law)?;
                finite("force", name, &[*ground])?;
                self.check_height("force", name, i, j)?;
                let (center, spin) = match *contact {
                    Contact::Patch { center, spin } => (center, spin),
                    // Any axis that lies level will do, for the radius alone counts.
                    Contact::Center(center) => (center, Direction::Fixed([0.0, 1.0, 0.0])),
                };
                self.check_disc("force", name, center, spin, *free_radius)
            }
            ForceKind::PointForce { size, .. } | ForceKind::Moment { size, .. } => {
                finite("force", name, &[*size])?;
                if i == BodyId::GROUND {
                    return Ok(());
                }
                let body = |id: BodyId| self.bodies[id.0].name.clone();
                Err(MechanismError::NotFromGround { name: name.to_owned(), i: body(i), j: body(j) })
            }
        }
    }
}

impl Mechanism {
    /// Whether axes span a frame; their directions have been checked.
    pub(crate) fn check_triad(
        &self,
        what: &'static str,
        name: &str,
        axes: Triad,
    ) -> Result<(), MechanismError> {
        for direction in [axes.x, axes.z] {
            self.check_direction(what, name, direction)?;
        }
        let [x, z] = [axes.x, axes.z].map(|direction| unit(self.vector(direction)));
        if norm(cross(z, x)) < 1e-6 {
            return Err(MechanismError::ParallelAxes { what, name: name.to_owned() });
        }
        Ok(())
    }
}

fn check_law(name: &str, law: &Law) -> Result<(), MechanismError> {
    finite("force", name, &[law.preload])?;
    for curve in [&law.elastic, &law.viscous] {
        if let Curve::Linear(factor) = curve {
            finite("force", name, &[*factor])?;
        }
    }
    Ok(())
}

/// What is wrong with a mass or an inertia tensor. The tensor of a real body has eigenvalues that
/// satisfy the triangle inequality; a rod or a point has zeros among them.
fn implausible(mass: &MassProperties) -> Option<&'static str> {
    let [xx, yy, zz, xy, xz, yz] = mass.inertia;
    let trace = xx + yy + zz;
    let tolerance = 1e-6 * trace.abs();
    if mass.mass < 0.0 {
        return Some("it is below zero; give a positive mass");
    }
    if [xx, yy, zz].iter().any(|j| *j < 0.0) {
        return Some("a moment of inertia is below zero; give positive moments");
    }
    if [xx, yy, zz].iter().any(|j| 2.0 * j > trace + tolerance) {
        return Some(
            "one moment of inertia is larger than the sum of the other two, which no body has; \
             check the numbers and their unit",
        );
    }
    // Twice the second moments of mass, ½ tr(J) 1 − J, must be positive semidefinite.
    let s = [trace - 2.0 * xx, trace - 2.0 * yy, trace - 2.0 * zz].map(|d| 0.5 * d + tolerance);
    let minors = [
        s[0] * s[1] - xy * xy,
        s[0] * s[2] - xz * xz,
        s[1] * s[2] - yz * yz,
        s[0] * s[1] * s[2] - 2.0 * xy * xz * yz - s[0] * yz * yz - s[1] * xz * xz - s[2] * xy * xy,
    ];
    (minors.iter().any(|minor| *minor < 0.0)).then_some(
        "the inertia tensor belongs to no body; check the elements Jxy, Jxz, Jyz and their signs",
    )
}
