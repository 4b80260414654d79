//! Which architecture a template of Chrono is, and where its points, masses and forces stand in the
//! file.
//!
//! A template is one row, in [`corners`](super::corners) or [`axles`](super::axles).

use super::axles::AXLES;
use super::corners::CORNERS;
use crate::import::Mistakes;
use crate::import::draft::Draft;
use crate::import::json::Json;

/// A template of Chrono.
pub(super) struct Template {
    /// Its name in files.
    pub(super) name: &'static str,
    /// The architecture that has its bodies and joints.
    pub(super) architecture: &'static str,
    pub(super) points: &'static [Place],
    /// Points that are not in the file and follow from others.
    pub(super) derived: &'static [(&'static str, Derived)],
    pub(super) masses: &'static [Mass],
    pub(super) lines: &'static [Line],
    pub(super) bushings: &'static [Bushing],
    /// Adds springs about axes.
    pub(super) torsion: Option<fn(&Json, &mut Draft, &mut Mistakes)>,
    /// A part that leaves an axle too few free motions, and why.
    pub(super) cannot: Option<(&'static str, &'static str)>,
}

/// What most rows do not have.
pub(super) const NONE: Template = Template {
    name: "",
    architecture: "",
    points: &[],
    derived: &[],
    masses: &[],
    lines: &[],
    bushings: &[],
    torsion: None,
    cannot: None,
};

/// Object, key, and the point of the model.
pub(super) type Place = (&'static str, &'static str, &'static str);

/// Where a point is that others give.
pub(super) enum Derived {
    /// The middle of two points.
    Middle(&'static str, &'static str),
    /// One metre from the first point, normal to the plane of the three.
    Normal(&'static str, &'static str, &'static str),
}

/// A body of Chrono and the body of the model that has its mass.
pub(super) struct Mass {
    /// The members that lead to the object, from the outside in.
    pub(super) object: &'static [&'static str],
    /// What stands before `Mass` and `Inertia` in the names of its members.
    pub(super) prefix: &'static str,
    pub(super) body: &'static str,
    pub(super) center: Center,
    pub(super) frame: Frame,
}

/// Where the centre of mass is.
pub(super) enum Center {
    /// The member `COM`.
    Own,
    /// The member `COM`, and once more on the other side: two equal parts of one body.
    Both,
    /// The mean of points of the model.
    Mean(&'static [&'static str]),
    /// The mean of points of the model and of their mirror images.
    Across(&'static [&'static str]),
    /// Half way from the centre line to a point of the model.
    Half(&'static str),
}

/// The axes of the inertia, where the file does not say that they are those of the vehicle.
pub(super) enum Frame {
    Vehicle,
    /// x along the axis from rear to front, z normal to the plane of the arm: rear, front, outer point.
    Arm(&'static str, &'static str, &'static str),
    /// z along the rod, x as near to that of the vehicle as can be.
    Rod(&'static str, &'static str),
    /// z along the rod from the first point to the second, y normal to the plane of both and the third, which
    /// is the origin of the suspension where none is named.
    Plane(&'static str, &'static str, Option<&'static str>),
}

/// A spring or a damper from the chassis.
pub(super) struct Line {
    pub(super) object: &'static str,
    pub(super) name: &'static str,
    pub(super) body: &'static str,
    /// The key and the point on the chassis, then those on the body.
    pub(super) ends: [(&'static str, &'static str); 2],
}

/// The bushing of a revolute joint, in the middle of its axis.
pub(super) struct Bushing {
    pub(super) object: &'static str,
    pub(super) joint: &'static str,
    pub(super) axis: [&'static str; 2],
}

/// The template of this name.
pub(super) fn find(name: &str) -> Option<&'static Template> {
    all().find(|template| template.name == name)
}

fn all() -> impl Iterator<Item = &'static Template> {
    CORNERS.iter().chain(AXLES)
}

pub(super) const fn mass(
    object: &'static [&'static str],
    body: &'static str,
    center: Center,
    frame: Frame,
) -> Mass {
    Mass { object, prefix: "", body, center, frame }
}

pub(super) const UPRIGHT: Mass = mass(&["Upright"], "upright", Center::Own, Frame::Vehicle);
pub(super) const SPINDLE: Mass = mass(&["Spindle"], "upright", Center::Own, Frame::Vehicle);

pub(super) const fn line(
    object: &'static str,
    name: &'static str,
    body: &'static str,
    key: &'static str,
    points: [&'static str; 2],
) -> Line {
    Line { object, name, body, ends: [("Location Chassis", points[0]), (key, points[1])] }
}

pub(super) const SPRING: [&str; 2] = ["spring_upper", "spring_lower"];
pub(super) const DAMPER: [&str; 2] = ["damper_upper", "damper_lower"];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Architecture;

    /// Architectures that this build has must have the points, bodies and joints that the table names.
    #[test]
    fn rows_fit_the_architectures() {
        for template in all() {
            let architecture = Architecture::built_in(template.architecture).unwrap().unwrap();
            let (name, title) = (template.name, architecture.title());
            for role in architecture.points() {
                let mut names = template.points.iter().map(|(_, _, point)| *point);
                let mut derived = template.derived.iter().map(|(point, _)| *point);
                let known = names.any(|point| point == role.name)
                    || derived.any(|point| point == role.name);
                assert!(known, "{name} gives {title} no {}", role.name);
            }
            let bodies: Vec<&str> =
                architecture.bodies().iter().map(|body| body.name.as_str()).collect();
            for body in template.masses.iter().map(|mass| mass.body) {
                assert!(bodies.contains(&body), "{title} has no body {body} for {name}");
            }
            for body in template.lines.iter().map(|line| line.body) {
                assert!(bodies.contains(&body), "{title} has no body {body} for {name}");
            }
            for joint in template.bushings.iter().map(|bushing| bushing.joint) {
                let known = architecture.joints.iter().any(|known| known.name == joint);
                assert!(known, "{title} has no joint {joint} for {name}");
            }
        }
    }
}
