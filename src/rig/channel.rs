//! What force elements and joints carry, number by number.

use std::collections::HashSet;

use crate::kernels::RelationKind;
use crate::mechanism::{
    BodyId, Driver, DriverId, DriverKind, Element, Expansion, ForceId, ForceKind, Mechanism, Owner,
};
use crate::model::{Axes, Quantity};
use crate::solve::{Loaded, Reaction, rotation};
use crate::vector::{dot, rotation_angles};

/// One number that a force element or a joint has at every state.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// The name of its column, without the unit.
    pub name: String,
    /// What it is, in words.
    pub title: String,
    /// Its kind.
    pub quantity: Quantity,
    /// What a positive value means.
    pub sign: &'static str,
    source: Source,
    force: Option<ForceId>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Source {
    /// Φ of a force element times a factor, plus a parameter where it is a length.
    Value { value: usize, factor: f64, reference: Option<usize> },
    /// A coordinate of a body's origin, from the origin of the axes.
    BodyPosition { body: BodyId, axis: usize },
    /// An angle of a body's rotation from design.
    BodyRotation { body: BodyId, axis: usize },
    /// How far a body's origin has risen from a height.
    BodyRise { body: BodyId, from: f64 },
    /// λ of a constraint times a factor.
    Driver { equation: usize },
    /// λ of a force element times a factor.
    Force { value: usize, factor: f64 },
    /// A component of the moment of a bushing on its body *j*, along an axis fixed in body *i* that
    /// stands among the parameters.
    BushingMoment { force: ForceId, body: BodyId, slot: usize },
    /// A component of the force of a joint on its body *j*.
    JointForce { joint: usize, axis: usize },
    /// A component of the moment of a joint on its body *j*.
    JointMoment { joint: usize, axis: usize },
}

const XYZ: [&str; 3] = ["x", "y", "z"];

impl Channel {
    /// The force element that it belongs to.
    pub fn force(&self) -> Option<ForceId> {
        self.force
    }

    /// The value (SI). Components of joints are in the given axes, those of bushings in their own.
    pub fn value(&self, loaded: &Loaded<'_>, reactions: &[Reaction], axes: Axes) -> f64 {
        let elements = loaded.elements;
        match self.source {
            Source::Value { value, factor, reference } => {
                factor * elements.values()[value] + reference.map_or(0.0, |slot| loaded.h[slot])
            }
            Source::Force { value, factor } => factor * elements.responses()[value].force,
            Source::BushingMoment { force, body, slot } => {
                let axis = [loaded.h[slot], loaded.h[slot + 1], loaded.h[slot + 2]];
                let axis = rotation(loaded.state, body).map(|row| dot(row, axis));
                dot(axis, loaded.force(force).moment)
            }
            Source::BodyPosition { body, axis } => {
                let q = &loaded.state[body.index()];
                axes.from_iso([q[0], q[1], q[2]])[axis]
            }
            Source::BodyRotation { body, axis } => {
                let turned = axes.rotation_from_iso(rotation(loaded.state, body));
                rotation_angles(turned)[axis]
            }
            Source::BodyRise { body, from } => loaded.state[body.index()][2] - from,
            Source::Driver { equation } => -loaded.lambda[equation],
            Source::JointForce { joint, axis } => axes.from_iso(reactions[joint].on_j.force)[axis],
            Source::JointMoment { joint, axis } => {
                axes.from_iso(reactions[joint].on_j.moment)[axis]
            }
        }
    }
}

/// The channels of all force elements, in their order.
pub fn element_channels(mechanism: &Mechanism, expansion: &Expansion) -> Vec<Channel> {
    let mut channels = vec![];
    for element in expansion.elements() {
        let Owner::Force(id) = element.instance.owner else { continue };
        let force = &mechanism.forces()[id.index()];
        let first = element.instance.equations.start;
        let reference = element.instance.parameters.end - 1;
        let mut add = |end: &str, title: &str, quantity, sign, source| {
            channels.push(Channel {
                name: format!("{}_{end}", force.name),
                title: format!("{}, {title}", force.name),
                quantity,
                sign,
                source,
                force: Some(id),
            });
        };
        let value = |value, factor, reference| Source::Value { value, factor, reference };
        let law = |value, factor| Source::Force { value, factor };
        match &force.kind {
            ForceKind::Line { .. } => {
                let length = value(first, 1.0, Some(reference));
                add("length", "length", Quantity::Length, "distance of its ends", length);
                add("force", "force", Quantity::Force, "+ tension", law(first, 1.0));
            }
            ForceKind::Slide { .. } => {
                let sign = "+ body j along the direction, from body i";
                add(
                    "displacement",
                    "displacement",
                    Quantity::Length,
                    sign,
                    value(first, 1.0, None),
                );
                let sign = "+ on body j along the direction";
                add("force", "force", Quantity::Force, sign, law(first, -1.0));
            }
            ForceKind::Torsion { .. } => {
                let sign = "+ body j turned right-handed from design";
                add("angle", "angle", Quantity::Angle, sign, value(first, 1.0, None));
                let sign = "+ turns body j back, against the angle";
                add("torque", "torque", Quantity::Torque, sign, law(first, 1.0));
            }
            ForceKind::Tyre { .. } => {
                let deflection = value(first, -1.0, None);
                add("deflection", "deflection", Quantity::Length, "+ compressed", deflection);
                add(
                    "load",
                    "vertical load",
                    Quantity::Force,
                    "+ up on the wheel",
                    law(first, -1.0),
                );
            }
            ForceKind::Bushing(_) => {
                let turns = element.instance.kind != RelationKind::BushingTranslation;
                for (axis, letter) in XYZ.into_iter().enumerate() {
                    let (before, length, quantity) = if turns {
                        ("r", Quantity::Angle, Quantity::Torque)
                    } else {
                        ("", Quantity::Length, Quantity::Force)
                    };
                    let what = if turns { "rotation about" } else { "displacement along" };
                    add(
                        &format!("{before}{letter}"),
                        &format!("{what} {letter} of its axes"),
                        length,
                        "+ of body j from body i",
                        value(first + axis, 1.0, None),
                    );
                    // λ of rotations works on the angles, so it is not the moment about the axes
                    // where those are large. The axes are the first parameters.
                    let slot = element.instance.parameters.start + 3 * axis;
                    let (before, what, source) = if turns {
                        (
                            "m",
                            "moment about",
                            Source::BushingMoment { force: id, body: force.i, slot },
                        )
                    } else {
                        ("f", "force along", law(first + axis, -1.0))
                    };
                    add(
                        &format!("{before}{letter}"),
                        &format!("{what} {letter} of its axes"),
                        quantity,
                        "+ on body j",
                        source,
                    );
                }
            }
            ForceKind::PointForce { .. } => {
                let sign = "+ along its direction";
                add("force", "size", Quantity::Force, sign, law(first, -1.0));
            }
            ForceKind::Moment { .. } => {
                let sign = "+ right-handed about its direction";
                add("moment", "size", Quantity::Torque, sign, law(first, -1.0));
            }
        }
    }
    channels
}

/// The channels of all moving bodies: position of the origin and rotation from design.
pub fn body_channels(mechanism: &Mechanism) -> Vec<Channel> {
    let mut channels = vec![];
    for body in mechanism.body_ids().skip(1) {
        let name = &mechanism.bodies()[body.index()].name;
        for (axis, letter) in XYZ.into_iter().enumerate() {
            channels.push(Channel {
                name: format!("{name}_{letter}"),
                title: format!("{name}, origin along {letter}"),
                quantity: Quantity::Length,
                sign: "+ along the axis",
                source: Source::BodyPosition { body, axis },
                force: None,
            });
        }
        for (axis, letter) in XYZ.into_iter().enumerate() {
            channels.push(Channel {
                name: format!("{name}_rot_{letter}"),
                title: format!("{name}, rotation about {letter}, Rx(a) Ry(b) Rz(c) from design"),
                quantity: Quantity::Angle,
                sign: "+ right-handed",
                source: Source::BodyRotation { body, axis },
                force: None,
            });
        }
    }
    channels
}

/// How far a chassis that rolls has heaved.
pub fn heave_channel(mechanism: &Mechanism, chassis: BodyId) -> Channel {
    let from = mechanism.bodies()[chassis.index()].origin[2];
    Channel {
        name: "heave".into(),
        title: "heave, rise of the roll axis".into(),
        quantity: Quantity::Length,
        sign: "+ up",
        source: Source::BodyRise { body: chassis, from },
        force: None,
    }
}

/// The whole displacement of bodies that hang on a driven one by a spring along its way, such as that of a
/// rack behind the driven end of its steering column.
pub fn driven_channels(mechanism: &Mechanism, expansion: &Expansion) -> Vec<Channel> {
    let driven = |element: &Element| {
        let Owner::Force(id) = element.instance.owner else { return None };
        let force = &mechanism.forces()[id.index()];
        let ForceKind::Slide { along, .. } = force.kind else { return None };
        let drives = |driver: &DriverId| {
            let Driver { j, kind, .. } = &mechanism.drivers()[driver.index()];
            *j == force.i
                && matches!(kind, DriverKind::Displacement { along: way, .. } if *way == along)
        };
        let driver = mechanism.driver_ids().find(drives)?;
        let body = &mechanism.bodies()[force.j.index()].name;
        Some(Channel {
            name: format!("{body}_displacement"),
            title: format!("{body}, displacement"),
            quantity: Quantity::Length,
            sign: "+ in the sense of what drives it",
            source: Source::Value {
                value: element.instance.equations.start,
                factor: 1.0,
                reference: Some(expansion.driver_slot(driver)),
            },
            force: None,
        })
    };
    expansion.elements().iter().filter_map(driven).collect()
}

/// The force or moment that holds each driver that is not released.
pub fn driver_channels(
    mechanism: &Mechanism,
    expansion: &Expansion,
    released: &[DriverId],
) -> Vec<Channel> {
    let drivers = mechanism.driver_ids().filter(|driver| !released.contains(driver));
    let channel = |driver: DriverId| {
        let part = &mechanism.drivers()[driver.index()];
        let turns = part.kind.unit() == "rad";
        let (end, quantity) =
            if turns { ("torque", Quantity::Torque) } else { ("force", Quantity::Force) };
        let equation = expansion.equations_of(Owner::Driver(driver)).next()?;
        Some(Channel {
            name: format!("{}_{end}", part.name),
            title: format!("{}, {end} that holds it", part.name),
            quantity,
            sign: "+ in the sense of its value",
            source: Source::Driver { equation },
            force: None,
        })
    };
    drivers.filter_map(channel).collect()
}

/// The channels of all joints, in their order: force, then moment on body *j*.
pub fn joint_channels(mechanism: &Mechanism) -> Vec<Channel> {
    let mut channels = vec![];
    for (joint, part) in mechanism.joints().iter().enumerate() {
        let body = &mechanism.bodies()[part.j.index()].name;
        for (axis, letter) in XYZ.into_iter().enumerate() {
            channels.push(Channel {
                name: format!("{}_f{letter}", part.name),
                title: format!("{}, force on {body} along {letter}", part.name),
                quantity: Quantity::Force,
                sign: "+ along the model's axis",
                source: Source::JointForce { joint, axis },
                force: None,
            });
        }
        for (axis, letter) in XYZ.into_iter().enumerate() {
            channels.push(Channel {
                name: format!("{}_m{letter}", part.name),
                title: format!("{}, moment on {body} about {letter}", part.name),
                quantity: Quantity::Torque,
                sign: "+ right-handed about the model's axis",
                source: Source::JointMoment { joint, axis },
                force: None,
            });
        }
    }
    channels
}

/// Gives channels that would have the name of another one a number, so that columns have one meaning.
pub fn distinct<'a>(channels: impl Iterator<Item = &'a mut Channel>) {
    let mut taken = HashSet::new();
    for channel in channels {
        let name = channel.name.clone();
        let mut number = 1;
        while !taken.insert(channel.name.clone()) {
            number += 1;
            channel.name = format!("{name}_{number}");
        }
    }
}
