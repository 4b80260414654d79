//! From the text of an architecture file to [`Architecture`].

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::{Architecture, BodyRole, PointRole, Seats, SteerAxis, WheelRole, check};
use crate::mechanism::{BodyId, Joint, JointKind, PointId};
use crate::model::axes::Axes;
use crate::model::diagnostics::Report;
use crate::model::names::{Names, Unavailable};
use crate::model::parts::{Parts, Y, check_name, joint_points};
use crate::model::read::{FromToml, Section, as_section};
use crate::model::suggest;
use crate::model::units_file::UnitsFile;

/// The points and bodies of the file, with their places in the text.
struct Roles {
    ground: String,
    points: Vec<PointRole>,
    point_spans: Vec<Range<usize>>,
    optional_points: Vec<PointRole>,
    bodies: Vec<BodyRole>,
    body_spans: Vec<Range<usize>>,
}

pub(super) fn read(root: &mut Section, report: &mut Report) -> Option<Architecture> {
    let title = root.required::<String>("title", "write `title = \"Double wishbone\"`", report);
    let description = root.optional::<String>("description", report);
    let ground = root.required::<String>(
        "ground",
        "name the body that never moves: `ground = \"chassis\"`",
        report,
    );
    let ground = ground.map_or("chassis".to_owned(), Spanned::into_inner);
    let roles = roles(root, ground, report);
    let names = roles.names();
    let units = UnitsFile::absent();
    let parts = Parts { names: &names, units: &units, axes: Axes::Iso8855, own_numbers: false };
    let read_joints = parts.joints(root, report);
    let is_axle = root.optional::<bool>("axle", report);
    let axle_joints = axle_joints(root, &names, report);
    let bushed = bushed(root, &read_joints, report);
    let rack = rack(root, &names, &read_joints, &axle_joints, report);
    let wheel = wheel(root, &names, report);
    let steer_axis = steer_axis(root, &names, report);
    let spring = seats(root, "spring", &roles, &names, report);
    let damper = seats(root, "damper", &roles, &names, report);
    let axis_span = steer_axis.as_ref().map(Spanned::span);
    if !report.mistakes.is_empty() {
        return None;
    }
    let axle_spans: Vec<_> = axle_joints.iter().map(|(name, _)| name.span()).collect();
    let architecture = Architecture {
        title: title?.into_inner(),
        description: description.map(Spanned::into_inner),
        ground: roles.ground,
        points: roles.points,
        optional_points: roles.optional_points,
        bodies: roles.bodies,
        joints: read_joints.into_iter().filter_map(|(_, j)| j).collect(),
        is_axle: is_axle.is_some_and(Spanned::into_inner),
        axle_joints: axle_joints.into_iter().filter_map(|(_, joint)| joint).collect(),
        bushed,
        rack: rack.map(|(joint, _)| joint),
        pitman_point: rack.and_then(|(_, point)| point),
        wheel: wheel?,
        steer_axis: steer_axis.map(Spanned::into_inner),
        spring,
        damper,
    };
    let places = check::Places {
        points: &roles.point_spans,
        bodies: &roles.body_spans,
        axle_joints: &axle_spans,
        steer_axis: axis_span.unwrap_or(0..0),
    };
    check::check(&architecture, &places, report);
    Some(architecture)
}

fn roles(root: &mut Section, ground: String, report: &mut Report) -> Roles {
    let mut roles = Roles {
        ground,
        points: vec![],
        point_spans: vec![],
        optional_points: vec![],
        bodies: vec![],
        body_spans: vec![],
    };
    let help = "list the hard points: `lca_front = \"Lower control arm, front pivot\"`";
    if let Some(section) = root.section("points", help, report) {
        for (name, point) in points(&section, report) {
            roles.point_spans.push(name.span());
            roles.points.push(point);
        }
        section.not_empty(help, report);
    }
    if let Some(section) = root.optional_section("optional_points", help, report) {
        for (name, point) in points(&section, report) {
            if roles.points.iter().any(|known| known.name == point.name) {
                let message = format!("`{}` is both required and optional", point.name);
                report
                    .mistake(&name.span(), message, "also in [points]")
                    .help("keep it in one of the two sections");
            }
            roles.optional_points.push(point);
        }
    }
    let help = "list the moving bodies: `upright = \"Upright with hub and wheel\"`";
    if let Some(section) = root.section("bodies", help, report) {
        for (name, value) in section.entries() {
            check_name(&name, report);
            let Some((meaning, shared)) = meaning(&name, value, BODY_HELP, "shared", report) else {
                continue;
            };
            if *name.get_ref() == roles.ground {
                report
                    .mistake(&name.span(), "the ground is listed as a moving body", "the ground")
                    .help("remove this line");
            }
            roles.body_spans.push(name.span());
            roles.bodies.push(BodyRole { name: name.into_inner(), meaning, shared });
        }
        section.not_empty(help, report);
    }
    roles
}

impl Roles {
    /// What joints may name: a model may lack an optional point.
    fn names(&self) -> Names {
        let unavailable = self.optional_points.iter().map(|point| Unavailable {
            name: point.name.clone(),
            why: format!("`{}` is optional, so a model may lack it", point.name),
            help: "move it to [points], or name a required point".to_owned(),
        });
        let bodies = self.bodies.iter().map(|body| body.name.clone()).collect();
        let points = self.points.iter().map(|point| point.name.clone()).collect();
        Names::new(self.ground.clone(), bodies, points).with_unavailable(unavailable.collect())
    }
}

/// The joints of `[[axle_joints]]`, between the two sides.
fn axle_joints(
    root: &mut Section,
    names: &Names,
    report: &mut Report,
) -> Vec<(Spanned<String>, Option<Joint>)> {
    let names = names.across();
    let units = UnitsFile::absent();
    let parts = Parts { names: &names, units: &units, axes: Axes::Iso8855, own_numbers: false };
    parts.joints_of(root, "axle_joints", report)
}

/// The joints of `bushed`, by their places.
fn bushed(
    root: &mut Section,
    joints: &[(Spanned<String>, Option<Joint>)],
    report: &mut Report,
) -> Vec<usize> {
    let listed = root.optional::<Vec<Spanned<String>>>("bushed", report);
    let listed = listed.map(Spanned::into_inner).unwrap_or_default();
    listed.iter().filter_map(|name| joint_place(name, joints, report)).collect()
}

/// The place of the joint of this name.
fn joint_place(
    name: &Spanned<String>,
    joints: &[(Spanned<String>, Option<Joint>)],
    report: &mut Report,
) -> Option<usize> {
    if joints.is_empty() {
        return None; // That the joints are missing has been noted.
    }
    let found = joints.iter().position(|(joint, _)| joint.get_ref() == name.get_ref());
    if found.is_none() {
        let known: Vec<&str> = joints.iter().map(|(j, _)| j.get_ref().as_str()).collect();
        let message = format!("there is no joint `{}`", name.get_ref());
        report
            .mistake(&name.span(), message, "unknown joint")
            .help(suggest::choices(name.get_ref(), &known));
    }
    found
}

const POINT_HELP: &str = "say what the point is: `meaning = \"…\"`";
const BODY_HELP: &str = "say what the body is: `meaning = \"…\"`";

fn points(section: &Section, report: &mut Report) -> Vec<(Spanned<String>, PointRole)> {
    let mut points = vec![];
    for (name, value) in section.entries() {
        check_name(&name, report);
        if let Some((meaning, may_cross)) = meaning(&name, value, POINT_HELP, "may_cross", report) {
            points.push((name.clone(), PointRole { name: name.into_inner(), meaning, may_cross }));
        }
    }
    points
}

/// What a point or a body is: its meaning, or a table such as `{ meaning = "…", may_cross = true }`
/// with the word that it may have.
fn meaning(
    name: &Spanned<String>,
    value: &Spanned<DeValue>,
    help: &str,
    word: &'static str,
    report: &mut Report,
) -> Option<(String, bool)> {
    let what = format!("`{}`", name.get_ref());
    if !value.get_ref().is_table() {
        return Some((String::read(value, &what, report).unwrap_or_default(), false));
    }
    let mut table = as_section(value, what, help, report)?;
    let meaning = table.required::<String>("meaning", help, report);
    let word = table.optional::<bool>(word, report);
    table.finish(report);
    let meaning = meaning.map(Spanned::into_inner).unwrap_or_default();
    Some((meaning, word.is_some_and(Spanned::into_inner)))
}

fn wheel(root: &mut Section, names: &Names, report: &mut Report) -> Option<WheelRole> {
    let help = "say which body carries the wheel: `body = …` and `center = …`";
    let mut section = root.section("wheel", help, report)?;
    let body = section.required("body", "name the body that carries the wheel", report);
    let center = section.required("center", "name the point in the wheel centre", report);
    section.finish(report);
    let body = body.and_then(|body| names.body(&body, report).map(|id| (id, body)));
    let center = center.and_then(|center| names.point(&center, report));
    let (body, name) = body?;
    if body == BodyId::GROUND {
        report
            .mistake(&name.span(), "the wheel is on the ground body", "never moves")
            .help("name the body that carries the wheel, such as the upright");
    }
    Some(WheelRole { body, center: center? })
}

fn steer_axis(
    root: &mut Section,
    names: &Names,
    report: &mut Report,
) -> Option<Spanned<SteerAxis>> {
    let help = "name a point and a body for `lower` and `upper`, or remove the section";
    let mut section = root.optional_section("steer_axis", help, report)?;
    let [lower, upper] =
        ["lower", "upper"].map(|end| steer_axis_end(&mut section, end, names, report));
    let span = section.span();
    section.finish(report);
    let (lower, upper) = (lower?, upper?);
    if lower.0 == upper.0 {
        report
            .mistake(&span, "the steer axis has one point twice", "no direction")
            .help("name the lower and the upper point of the axis");
    }
    Some(Spanned::new(span, SteerAxis { lower, upper }))
}

fn steer_axis_end(
    axis: &mut Section,
    end: &'static str,
    names: &Names,
    report: &mut Report,
) -> Option<(PointId, BodyId)> {
    let help = format!("write `{end} = {{ point = \"…\", body = \"…\" }}`");
    let mut section = axis.section(end, &help, report)?;
    let point = section.required("point", &help, report);
    let body = section.required("body", &help, report);
    section.finish(report);
    let point = point.and_then(|point| names.point(&point, report));
    let body = body.and_then(|body| names.body(&body, report));
    Some((point?, body?))
}

/// The seats of a spring or a damper may be optional points, so they are known by name.
fn seats(
    root: &mut Section,
    name: &'static str,
    roles: &Roles,
    names: &Names,
    report: &mut Report,
) -> Option<Seats> {
    let help = "name a point and a body for `lower` and `upper`, or remove the section";
    let mut section = root.optional_section(name, help, report)?;
    let [lower, upper] =
        ["lower", "upper"].map(|end| seat(&mut section, end, roles, names, report));
    section.finish(report);
    Some(Seats { lower: lower?, upper: upper? })
}

fn seat(
    seats: &mut Section,
    end: &'static str,
    roles: &Roles,
    names: &Names,
    report: &mut Report,
) -> Option<(String, BodyId)> {
    let help = format!("write `{end} = {{ point = \"…\", body = \"…\" }}`");
    let mut section = seats.section(end, &help, report)?;
    let point = section.required::<String>("point", &help, report);
    let body = section.required("body", &help, report);
    section.finish(report);
    let body = body.and_then(|body| names.body(&body, report));
    let point = point?;
    let known: Vec<&str> =
        roles.points.iter().chain(&roles.optional_points).map(|role| role.name.as_str()).collect();
    if !known.contains(&point.get_ref().as_str()) {
        let message = format!("there is no point `{}`", point.get_ref());
        report
            .mistake(&point.span(), message, "unknown point")
            .help(suggest::choices(point.get_ref(), &known));
        return None;
    }
    Some((point.into_inner(), body?))
}

/// The joint of the rack, whose second body slides along y of the ground, or that of a pitman arm with the
/// point that it moves.
fn rack(
    root: &mut Section,
    names: &Names,
    joints: &[(Spanned<String>, Option<Joint>)],
    axle_joints: &[(Spanned<String>, Option<Joint>)],
    report: &mut Report,
) -> Option<(usize, Option<PointId>)> {
    let help = "name the translational joint between the ground and the rack: `joint = \"…\"`";
    let mut section = root.optional_section("rack", help, report)?;
    let name = section.required::<String>("joint", help, report);
    let point = section.optional::<String>("point", report);
    section.finish(report);
    let name = name?;
    let index = joint_place(&name, joints, report)?;
    let joint = joints[index].1.as_ref()?;
    let moved = point.as_ref().and_then(|point| names.point(point, report));
    let driven = match joint.kind {
        JointKind::Translational { axis, .. } => axis == Y && point.is_none(),
        JointKind::Revolute { .. } => point.is_some(),
        _ => false,
    };
    if !driven || joint.i != BodyId::GROUND {
        let message = format!("the joint `{}` cannot be driven as a rack", name.get_ref());
        report
            .mistake(&name.span(), message, "the rack joint")
            .also(&joints[index].0.span(), "defined here")
            .help(
                "a rack joint is translational, between the ground and the rack in this order, with `axis = \"y\"`; \
                 that of a pitman arm is revolute, and `point` names the joint at the other end of the arm",
            );
    }
    if let (Some(point), Some(moved)) = (&point, moved) {
        let all: Vec<Joint> =
            joints.iter().chain(axle_joints).filter_map(|(_, joint)| joint.clone()).collect();
        if !joint_points(&all, joint.j).contains(&moved) {
            let message = format!("no joint holds the pitman arm at `{}`", point.get_ref());
            report
                .mistake(&point.span(), message, "not on the arm")
                .help("name the joint between the pitman arm and the relay rod or drag link");
        }
    }
    Some((index, moved))
}
