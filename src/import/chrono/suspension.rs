//! A suspension file, by the row of its template.

use super::lines::{damper_of, spring_of, stops_of};
use super::template::{Bushing, Line, Template, find};
use super::{NOT_USED, Title, masses};
use crate::import::draft::{Draft, Part, PartKind, Point, SI, Spin};
use crate::import::json::Json;
use crate::import::options::Options;
use crate::import::sheet::Value;
use crate::import::{ImportError, Imported, LeftOut, Mistakes, Source};
use crate::model::{Architecture, Side};
use crate::vector::{norm, sub};

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
    if template.points.is_empty() {
        if Architecture::built_in(template.architecture).is_some() {
            let what = format!("points of a `{name}` are not read yet");
            let architecture = template.architecture;
            let help = format!(
                "there is an architecture `{architecture}`: write a model with its points by hand; \
                 `hardpoint architectures {architecture}` lists them"
            );
            return Err(source.fault(what, help));
        }
        // Without the architecture this says so.
        return draft.finish(source.name, source.text, options);
    }
    let mut mistakes = Mistakes::new(source.name, source.text);
    points(root, template, &mut draft, &mut mistakes);
    draft.spin = spin(root, &mut mistakes);
    draft.bodies =
        masses::bodies(root, template, &mut draft.left_out, &draft.points, &mut mistakes);
    for line in template.lines {
        line_parts(root, line, &mut draft, &mut mistakes);
    }
    for bushing in template.bushings {
        bushing_part(root, bushing, &mut draft, &mut mistakes);
    }
    mistakes.finish()?;
    leave_out_the_rest(root, &mut draft.left_out);
    draft.finish(source.name, source.text, options)
}

/// Why a file of this template gives no model.
fn without_template(name: &str) -> String {
    match name {
        "RigidSuspension" | "RigidPinnedAxle" => {
            format!("the wheels of a `{name}` do not move on the chassis: there is nothing to compute")
        }
        "GenericWheeledSuspension" => {
            "a `GenericWheeledSuspension` states bodies and joints of its own, which the importer does not read"
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
    let part = |name: &str, kind, entries, comments| Part {
        name: name.to_owned(),
        line: object.line,
        called: format!(
            "{}{}",
            line.object,
            if kind == "spring" || kind == "damper" { "" } else { ", stop" }
        ),
        kind: PartKind::Force(kind, bodies.clone()),
        entries: [vec![("on", Value::from([upper, lower]))], entries].concat(),
        points: vec![upper.to_owned(), lower.to_owned()],
        comments,
    };
    let mut comments = vec![];
    let damping = damper_of(object, length, &mut comments, &mut draft.left_out, mistakes);
    let spring = spring_of(object, &mut comments, mistakes);
    match (spring, damping) {
        (Some(mut spring), damping) => {
            // A spring calls its table of damping so that it is not taken for that of the force.
            let key = |key| if key == "table" { "damping_table" } else { key };
            spring.extend(damping.map(|(name, value)| (key(name), value)));
            draft.add_part(part(line.name, "spring", spring, comments));
        }
        (None, Some(damping)) => {
            let name = if line.name == "spring" { "damper" } else { line.name };
            draft.add_part(part(name, "damper", vec![damping], comments));
        }
        (None, None) => {
            let why = "it has neither a stiffness nor a damping that is known";
            draft.leave_out(object.line, format!("`{}`", line.object), why);
            return;
        }
    }
    for (kind, entries) in stops_of(object, length, &mut draft.left_out, mistakes) {
        let comment = "The stop that Chrono gives to springs with such lengths; its table is linear between the rows.";
        let name = kind.replace('-', "_");
        draft.add_part(part(&name, kind, entries, vec![comment.to_owned()]));
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
fn leave_out_the_rest(root: &Json, left_out: &mut Vec<LeftOut>) {
    let mut rest = vec![];
    root.unused("", NOT_USED, &mut rest);
    for item in &mut rest {
        let drawn = ["Radius`", "Width`"].iter().any(|end| item.what.ends_with(end));
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
