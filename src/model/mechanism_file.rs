//! Mechanism files: bodies, joints, drivers and forces without any suspension.

use std::ops::Range;

use toml::Spanned;

use super::axes::Axes;
use super::checks::note;
use super::diagnostics::Report;
use super::mean;
use super::names::Names;
use super::parts::{
    Marker, Parts, PointFile, check_name, gravity_vector, joint_points, read_points,
};
use super::quantity::Quantity;
use super::read::{FromToml, Section, as_section};
use super::units::Units;
use super::units_file::UnitsFile;
use crate::mechanism::{
    BodyId, Driver, Force, InitialVelocity, Joint, MassProperties, Mechanism, MechanismError,
};

/// A mechanism of one's own, in SI units and the axes of its file: right-handed, heights along z.
#[derive(Clone, Debug)]
pub struct MechanismModel {
    /// The name for reports.
    pub name: String,
    /// What the mechanism is.
    pub description: Option<String>,
    /// Where its numbers come from.
    pub source: Option<String>,
    /// The units of the file, for output.
    pub units: Units,
    /// Bodies, joints, drivers, forces, masses and gravity.
    pub mechanism: Mechanism,
    /// What is followed in motion.
    pub markers: Vec<Marker>,
}

/// The bodies of a file, in its order.
struct BodyFile {
    name: Spanned<String>,
    /// Mass and initial velocity, where the file gives them and they are right.
    mass: Option<(MassProperties, InitialVelocity)>,
}

/// All parts of a mechanism with their places in the text.
struct PartsFile {
    points: Vec<(Spanned<String>, [f64; 3])>,
    bodies: Vec<BodyFile>,
    joints: Vec<(Range<usize>, Joint)>,
    drivers: Vec<(Range<usize>, Driver)>,
    forces: Vec<(Range<usize>, Force)>,
    markers: Vec<(Range<usize>, Marker)>,
    gravity: [f64; 3],
}

pub(super) fn read(root: &mut Section, report: &mut Report) -> Option<MechanismModel> {
    let help = "give the mechanism a name for reports: `name = \"…\"`";
    let name = root.required::<String>("name", help, report);
    let description = root.optional::<String>("description", report);
    let source = root.optional::<String>("source", report);
    let help = "name the body that never moves: `ground = \"ground\"`";
    let ground = root.required::<String>("ground", help, report);
    let ground = ground.map_or("ground".to_owned(), Spanned::into_inner);
    let units = UnitsFile::read(root, report);
    let points = points(root, report);
    let body_names = body_names(root, &ground, report);
    let point_names = points.iter().map(|point| point.name.get_ref().clone()).collect();
    let names = Names::new(ground.clone(), body_names, point_names);
    let parts = Parts { names: &names, units: &units, axes: Axes::Iso8855, own_numbers: true };
    let (bodies, mass) = bodies(root, &ground, &parts, report);
    let file = PartsFile {
        bodies,
        joints: placed(parts.joints(root, report)),
        drivers: placed(parts.drivers(root, report)),
        forces: placed(parts.forces(root, true, report)),
        markers: placed(parts.markers(root, report)),
        gravity: gravity_vector(root, mass.as_ref(), report).unwrap_or_default(),
        points: points
            .into_iter()
            .filter_map(|point| {
                let position = parts.vector(&point.position?, Quantity::Length, report);
                Some((point.name, position))
            })
            .collect(),
    };
    if file.points.len() < names.points().count() {
        return None; // The numbers of the points behind the wrong one would not be right.
    }
    let mechanism = file.build(&ground, report);
    Some(MechanismModel {
        name: name?.into_inner(),
        description: description.map(Spanned::into_inner),
        source: source.map(Spanned::into_inner),
        units: units.units()?,
        mechanism,
        markers: file.markers.into_iter().map(|(_, marker)| marker).collect(),
    })
}

fn placed<T>(parts: Vec<(Spanned<String>, Option<T>)>) -> Vec<(Range<usize>, T)> {
    parts.into_iter().filter_map(|(name, part)| Some((name.span(), part?))).collect()
}

fn points(root: &mut Section, report: &mut Report) -> Vec<PointFile> {
    let help = "add a section `[points]` with lines such as `pivot = [0.0, 0.0, 0.0]`";
    let Some(section) = root.section("points", help, report) else {
        return vec![];
    };
    section.not_empty(help, report);
    let points = read_points(&section, report);
    for point in &points {
        check_name(&point.name, report);
    }
    points
}

const BODIES_HELP: &str = "list the moving bodies: `crank = \"Crank\"` in `[bodies]`, or a section `[bodies.crank]` with its mass";

/// The names are needed before anything else can be read.
fn body_names(root: &mut Section, ground: &str, report: &mut Report) -> Vec<String> {
    let Some(section) = root.section("bodies", BODIES_HELP, report) else {
        return vec![];
    };
    section.not_empty(BODIES_HELP, report);
    let mut names = vec![];
    for (name, _) in section.entries() {
        check_name(&name, report);
        if name.get_ref() == ground {
            report
                .mistake(&name.span(), "the ground is listed as a moving body", "the ground")
                .help("remove this body");
            continue;
        }
        names.push(name.into_inner());
    }
    names
}

/// The bodies, and where the first of them has a mass.
fn bodies(
    root: &mut Section,
    ground: &str,
    parts: &Parts,
    report: &mut Report,
) -> (Vec<BodyFile>, Option<Range<usize>>) {
    let (mut bodies, mut first) = (vec![], None);
    let Some(list) = root.value("bodies").and_then(|value| value.get_ref().as_table()) else {
        return (bodies, first);
    };
    for (key, value) in list {
        let name = Spanned::new(key.span(), key.get_ref().to_string());
        if name.get_ref() == ground {
            continue;
        }
        let mass = if value.get_ref().is_table() {
            first.get_or_insert_with(|| name.span());
            let title = format!("[bodies.{}]", name.get_ref());
            as_section(value, title, BODIES_HELP, report)
                .and_then(|section| body(section, parts, report))
        } else {
            String::read(value, &format!("`{}`", name.get_ref()), report);
            None
        };
        bodies.push(BodyFile { name, mass });
    }
    (bodies, first)
}

fn body(
    mut section: Section,
    parts: &Parts,
    report: &mut Report,
) -> Option<(MassProperties, InitialVelocity)> {
    section.optional::<String>("meaning", report);
    let mass = parts.mass(&mut section, report);
    let velocity = parts.initial_velocity(&mut section, report);
    section.finish(report);
    Some((mass?, velocity))
}

impl PartsFile {
    /// Puts the parts together and notes every one that has no meaning.
    fn build(&self, ground: &str, report: &mut Report) -> Mechanism {
        let mut mechanism = Mechanism::new(ground);
        let mut check = |span: &Range<usize>, result: Result<(), MechanismError>| {
            if let Err(error) = result {
                note(span, &error, report);
            }
        };
        for (name, position) in &self.points {
            check(&name.span(), mechanism.add_point(name.get_ref(), *position).map(|_| ()));
        }
        for (index, body) in self.bodies.iter().enumerate() {
            let origin = self.origin(BodyId(index + 1));
            let added = mechanism.add_body(body.name.get_ref(), origin);
            let moving = added.and_then(|id| match body.mass {
                None => Ok(()),
                Some((mass, velocity)) => mechanism
                    .set_mass(id, mass)
                    .and_then(|()| mechanism.set_initial_velocity(id, velocity)),
            });
            check(&body.name.span(), moving);
        }
        for (span, joint) in &self.joints {
            check(span, mechanism.add_joint(&joint.name, joint.i, joint.j, joint.kind));
        }
        for (span, driver) in &self.drivers {
            let Driver { name, i, j, kind, course } = driver;
            let added = mechanism.add_driver(name, *i, *j, *kind);
            check(
                span,
                added.and_then(|id| match course {
                    None => Ok(()),
                    Some(course) => mechanism.set_course(id, course.clone()),
                }),
            );
        }
        for (span, force) in &self.forces {
            let kind = force.kind.clone();
            check(span, mechanism.add_force(&force.name, force.i, force.j, kind).map(|_| ()));
        }
        for (span, Marker { name, axes, .. }) in &self.markers {
            check(span, mechanism.check_triad("marker", name, *axes));
        }
        check(&(0..0), mechanism.set_gravity(self.gravity));
        mechanism
    }

    /// The mean of the points at which joints hold a body, its centre of mass where they
    /// hold none, or else the origin.
    fn origin(&self, body: BodyId) -> [f64; 3] {
        let joints: Vec<Joint> = self.joints.iter().map(|(_, joint)| joint.clone()).collect();
        let points = joint_points(&joints, body);
        let center = self.bodies[body.0 - 1].mass.map(|(mass, _)| mass.center);
        let mean = mean(points.iter().map(|point| self.points[point.0].1));
        mean.or(center).unwrap_or_default()
    }
}
