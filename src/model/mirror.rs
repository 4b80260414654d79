//! The same suspension on the other side of the vehicle.

use super::Model;
use super::adjusters::Change;
use crate::mechanism::{Bushing, Direction, Force, ForceKind, MassProperties};

impl Model {
    /// The same suspension on the other side of the vehicle: y changes its sign, toe and camber
    /// keep their values, and so do lengths, angles and loads of force elements. In bushings, displacement
    /// along their y axis and rotation about their x and z axes change their signs.
    pub fn mirrored(&self) -> Self {
        let mut other = self.clone();
        other.side = self.side.other();
        other.other = self.other.as_ref().map(|given| Box::new(given.mirrored()));
        for point in &mut other.points {
            point.position = mirrored(point.position);
        }
        for mass in other.loads.masses.iter_mut().flatten() {
            *mass = mirrored_mass(mass);
        }
        let architecture = &mut other.architecture;
        for joint in architecture.joints.iter_mut().chain(&mut architecture.axle_joints) {
            joint.kind = joint.kind.on_lines(mirrored_line);
        }
        for adjuster in &mut other.adjusters {
            if let Change::Place { along: Direction::Fixed(along), .. } = &mut adjuster.change {
                *along = mirrored(*along);
            }
        }
        let bushings = other.loads.bushings.iter_mut().map(|bushing| &mut bushing.force);
        let forces = other.loads.forces.iter_mut().chain(&mut other.loads.axle_forces);
        for force in forces.chain(bushings) {
            force.mirror();
        }
        other
    }
}

/// A point, or a vector such as a force. Not a plain negation, which would turn 0 into −0.
pub(super) fn mirrored([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, 0.0 - y, z]
}

/// A vector with a sense of rotation, such as a moment.
fn mirrored_axial([x, y, z]: [f64; 3]) -> [f64; 3] {
    [0.0 - x, y, 0.0 - z]
}

/// A line, which has no sign: along a coordinate axis it is its own image. One between points follows them.
fn mirrored_line(line: Direction) -> Direction {
    match line {
        Direction::Fixed(vector @ [x, y, z]) if y != 0.0 && (x, z) != (0.0, 0.0) => {
            Direction::Fixed(mirrored(vector))
        }
        _ => line,
    }
}

fn mirrored_mass(mass: &MassProperties) -> MassProperties {
    let [xx, yy, zz, xy, xz, yz] = mass.inertia;
    MassProperties {
        mass: mass.mass,
        center: mirrored(mass.center),
        inertia: [xx, yy, zz, 0.0 - xy, xz, 0.0 - yz],
    }
}

impl Force {
    /// Turns the force into its mirror image.
    pub(super) fn mirror(&mut self) {
        mirror(&mut self.kind);
    }
}

fn mirror(kind: &mut ForceKind) {
    match kind {
        ForceKind::Line { .. } | ForceKind::Tyre { .. } => {}
        // Along y the direction stays, such as that of the rack, and the law turns round.
        ForceKind::Slide { along, law, .. } => match *along {
            Direction::Fixed([_, y, _]) if mirrored_line(*along) == *along && y != 0.0 => {
                *law = law.reversed();
            }
            line => *along = mirrored_line(line),
        },
        // The axis turns round, so that the angle and its law keep their signs.
        ForceKind::Torsion { axis, .. } => {
            *axis = match *axis {
                Direction::Between(from, to) => Direction::Between(to, from),
                Direction::Fixed(axis) => Direction::Fixed(mirrored_axial(axis)),
            };
        }
        ForceKind::Bushing(bushing) => mirror_bushing(bushing),
        ForceKind::PointForce { direction, .. } => *direction = mirrored(*direction),
        ForceKind::Moment { direction, .. } => *direction = mirrored_axial(*direction),
    }
}

/// The mirror images of right-handed axes x, y, z are left-handed; x, −y, z are right-handed
/// again. In them displacement along y and rotation about x and z change their signs.
fn mirror_bushing(bushing: &mut Bushing) {
    for axis in [&mut bushing.axes.x, &mut bushing.axes.z] {
        // An axis between points follows them.
        if let Direction::Fixed(vector) = axis {
            *axis = Direction::Fixed(mirrored(*vector));
        }
    }
    let [_, along_y, _] = &mut bushing.translation;
    let [about_x, _, about_z] = &mut bushing.rotation;
    for law in [along_y, about_x, about_z] {
        *law = law.reversed();
    }
}
