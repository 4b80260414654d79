//! A suspension file, by the row of its template.

use super::lines::tsda;
use super::template::{Bushing, Derived, Line, Template, find};
use super::{NOT_USED, Title, masses};
use crate::import::draft::{Draft, Part, PartKind, Point, SI, Spin};
use crate::import::json::Json;
use crate::import::options::Options;
use crate::import::sheet::Value;
use crate::import::{ImportError, Imported, LeftOut, Mistakes, Source};
use crate::model::{Architecture, Side};
use crate::vector::{add, cross, norm, sub, unit};

pub(super) fn import(
    source: Source,
    root: &Json,
    title: &Title,
    options: &Options,
) -> Result<Imported, ImportError> {
    let name = title.template.as_str();
    let Some(template) = find(name) else {
        return Err(source.fault(without_template(name), "see docs/import.md for what is imported"));
    };
    let about = format!("Project Chrono, {}, template {name}", source.file_name());
    let mut draft = Draft::new(&title.name, about, template.architecture, SI);
    draft.template = format!("Chrono's template {name}");
    draft.side = Some(Side::Left);
    let mut mistakes = Mistakes::new(source.name, source.text);
    if let Some((part, why)) = template.cannot
        && let Some(object) = root.get(part)
    {
        let help = format!(
            "bushings that would let it move are not in such files; without `{part}` it can be imported"
        );
        mistakes.note(object.line, why, help);
    }
    points(root, template, &mut draft, &mut mistakes);
    let built_in = Architecture::built_in(template.architecture).transpose()?;
    if let Some(architecture) = &built_in {
        on_the_side_of_the_draglink(architecture, &mut draft);
    }
    draft.spin = spin(root, &mut mistakes);
    draft.bodies = masses::bodies(root, template, built_in.as_ref(), &mut draft, &mut mistakes);
    for line in template.lines {
        line_parts(root, line, &mut draft, &mut mistakes);
    }
    for bushing in template.bushings {
        bushing_part(root, bushing, &mut draft, &mut mistakes);
    }
    if let Some(torsion) = template.torsion {
        torsion(root, &mut draft, &mut mistakes);
    }
    mistakes.finish()?;
    leave_out_the_rest(root, &mut draft.left_out);
    draft.finish(source.name, source.text, options)
}

/// Why a file of this template gives no model.
fn without_template(name: &str) -> String {
    match name {
        "RigidSuspension" => {
            "the wheels of a `RigidSuspension` do not move on the chassis: there is nothing to compute".to_owned()
        }
        "RigidPinnedAxle" => {
            "a `RigidPinnedAxle` turns about its pin only: it has one motion, and the rig moves both wheels"
                .to_owned()
        }
        "HendricksonPRIMAXX" => {
            "beams and torque rods on hinges across the vehicle let the axle of a `HendricksonPRIMAXX` go up and down \
             only: to roll it needs bushings, which such files do not have"
                .to_owned()
        }
        _ => format!("the importer does not know Chrono's template `{name}`"),
    }
}

fn points(root: &Json, template: &Template, draft: &mut Draft, mistakes: &mut Mistakes) {
    let ends = template
        .lines
        .iter()
        .flat_map(|line| line.ends.map(|(key, point)| (line.object, key, point)));
    let needed = template.points.len();
    for (index, (object, key, point)) in template.points.iter().copied().chain(ends).enumerate() {
        let place = root.get(object);
        match place.and_then(|object| Some((object.get(key)?.line, object.vector(key, mistakes)?)))
        {
            Some((line, position)) => {
                let called = format!("{object}, {key}");
                draft.points.push(Point { name: point.to_owned(), called, line, position });
            }
            None if index < needed => {
                let line = place.map_or(root.line, |object| object.line);
                let what = format!("`{object}` with `{key}` is missing or wrong");
                mistakes.note(line, what, format!("add it: it is the point `{point}`"));
            }
            None => {}
        }
    }
    for (name, derived) in template.derived {
        let Some((called, position)) = derive(derived, draft) else { continue };
        draft.points.push(Point { name: (*name).to_owned(), called, line: root.line, position });
    }
    if draft.position("draglink_chassis").is_some() {
        draft.assumed.push(
            "the drag link ends on a steering arm, which is in a file of its own: this end is held where it is"
                .to_owned(),
        );
    }
}

/// A point that others give, and how; `None` where one of these is missing.
fn derive(derived: &Derived, draft: &Draft) -> Option<(String, [f64; 3])> {
    let at = |name: &str| draft.position(name);
    match *derived {
        Derived::Middle(a, b) => {
            let (from, to) = (at(a)?, at(b)?);
            let middle = std::array::from_fn(|axis| 0.5 * (from[axis] + to[axis]));
            Some((format!("in the middle between {a} and {b}"), middle))
        }
        Derived::Normal(origin, a, b) => {
            let (from, first, second) = (at(origin)?, at(a)?, at(b)?);
            let normal = unit(cross(sub(first, from), sub(second, from)));
            // Points on one line have no normal: the model will be told that the axis has no direction.
            let normal = if normal.iter().all(|x| x.is_finite()) { normal } else { [0.0; 3] };
            Some((format!("normal to the plane through {origin}, {a} and {b}"), add(from, normal)))
        }
    }
}

/// A drag link to the knuckle of the right side makes the model that of the right side: all points that the file
/// has for the left one are mirrored.
fn on_the_side_of_the_draglink(architecture: &Architecture, draft: &mut Draft) {
    let right = draft.position("draglink_outer").is_some_and(|place| place[1] < 0.0);
    if !right {
        return;
    }
    draft.side = Some(Side::Right);
    let crosses =
        |name: &str| architecture.points().iter().any(|role| role.name == name && role.may_cross);
    for point in draft.points.iter_mut().filter(|point| point.name != "draglink_outer") {
        if !crosses(&point.name) {
            point.position[1] = 0.0 - point.position[1];
        }
    }
}

/// Chrono turns the spindle by the toe angle, + toe-in, and the camber angle, + top outboard, as we do.
fn spin(root: &Json, mistakes: &mut Mistakes) -> Spin {
    let toe = root.number("Toe Angle (deg)", mistakes);
    let camber = root.number("Camber Angle (deg)", mistakes);
    // Files without these angles have zero, as Chrono takes them.
    let [toe, camber] = [toe, camber].map(|angle| angle.unwrap_or(0.0).to_radians());
    Spin::Angles { toe, camber }
}

/// The spring or damper of an object, and the stops of the spring.
fn line_parts(root: &Json, line: &Line, draft: &mut Draft, mistakes: &mut Mistakes) {
    let Some(object) = root.get(line.object) else { return };
    let [upper, lower] = line.ends.map(|(_, point)| point);
    let ends = (draft.position(upper), draft.position(lower));
    let (Some(from), Some(to)) = ends else { return };
    let length = norm(sub(to, from));
    let bodies = ["chassis".to_owned(), line.body.to_owned()];
    let on = [upper, lower];
    for mut part in tsda(object, line.object, &bodies, on, length, &mut draft.left_out, mistakes) {
        match part.kind {
            PartKind::Force("damper", _) if line.name == "spring" => {
                "damper".clone_into(&mut part.name);
            }
            PartKind::Force("spring" | "damper", _) => line.name.clone_into(&mut part.name),
            _ => {}
        }
        draft.add_part(part);
    }
}

/// Chrono's bushing of a revolute joint: alike in all directions, and soft about the axis of the joint.
fn bushing_part(root: &Json, bushing: &Bushing, draft: &mut Draft, mistakes: &mut Mistakes) {
    let data = root.get(bushing.object).and_then(|object| object.get("Bushing Data"));
    let Some(data) = data else { return };
    let mut number = |key: &str| match data.number(key, mistakes) {
        Some(number) => number,
        None => {
            mistakes.note(data.line, format!("`Bushing Data` lacks `{key}`"), "add it");
            0.0
        }
    };
    let [k, d, kr, dr] =
        ["Stiffness Linear", "Damping Linear", "Stiffness Rotational", "Damping Rotational"]
            .map(&mut number);
    let free = data.get("DOF");
    let mut about = |key: &str| free.and_then(|free| free.number(key, mistakes)).unwrap_or(0.0);
    let (ka, da) = (about("Stiffness Rotational"), about("Damping Rotational"));
    let [rear, front] = bushing.axis;
    let (Some(a), Some(b)) = (draft.position(rear), draft.position(front)) else { return };
    let middle = std::array::from_fn(|axis| 0.5 * (a[axis] + b[axis]));
    let at = format!("{}_center", bushing.joint);
    let called = format!("{}, bushing", bushing.object);
    draft.points.push(Point {
        name: at.clone(),
        called: called.clone(),
        line: data.line,
        position: middle,
    });
    draft.add_part(Part {
        name: format!("{}_bushing", bushing.joint),
        line: data.line,
        called,
        kind: PartKind::Bushing(bushing.joint.to_owned()),
        entries: vec![
            ("at", Value::from(at.as_str())),
            ("x_axis", Value::from(bushing.axis)),
            ("stiffness", Value::from([k; 3])),
            ("rotational_stiffness", Value::from([ka, kr, kr])),
            ("damping", Value::from([d; 3])),
            ("rotational_damping", Value::from([da, dr, dr])),
            ("law", Value::from("torque")),
        ],
        points: vec![at, rear.to_owned(), front.to_owned()],
        comments: vec![],
    });
}

/// Lists what nothing has asked for. Radii and widths are there for drawing.
pub(super) fn leave_out_the_rest(root: &Json, left_out: &mut Vec<LeftOut>) {
    let mut rest = vec![];
    root.unused("", NOT_USED, &mut rest);
    for item in &mut rest {
        let drawn =
            ["Radius`", "Width`", "Visualization`"].iter().any(|end| item.what.ends_with(end));
        if drawn {
            "it is the size of a body for drawing".clone_into(&mut item.why);
        } else if item.what == "`Axle`" {
            "the inertia of the axle shaft: wheels do not spin here".clone_into(&mut item.why);
        } else if item.what.ends_with("DOF`") || item.what.contains("DOF /") {
            "the joint of this bushing has no such free direction".clone_into(&mut item.why);
        }
    }
    left_out.append(&mut rest);
}
