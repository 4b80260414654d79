//! `[subframe]`: a body on bushings between the chassis and joints of the architecture.

use toml::Spanned;

use super::Fittings;
use crate::mechanism::{BodyId, Direction, Force, ForceKind, Joint, JointKind, PointId};
use crate::model::NamedPoint;
use crate::model::architecture::Architecture;
use crate::model::diagnostics::Report;
use crate::model::loads::JointBushing;
use crate::model::parts::Parts;
use crate::model::read::{Section, as_section};
use crate::model::suggest;
use crate::vector::sub;

pub(super) fn fit(
    root: &mut Section,
    parts: &Parts,
    architecture: &mut Architecture,
    fittings: &mut Fittings,
    report: &mut Report,
) {
    let help = "write a section `[subframe]` with `carries` and a section `[subframe.mounts.…]` for each mount";
    let Some(mut section) = root.optional_section("subframe", help, report) else { return };
    let help =
        "name the joints that it carries instead of the chassis: `carries = [\"lca_pivot\"]`";
    let carries = section.required::<Vec<Spanned<String>>>("carries", help, report);
    if let Some(carries) = carries.as_ref().filter(|carries| carries.get_ref().is_empty()) {
        report.mistake(&carries.span(), "the subframe carries nothing", "no joint").help(help);
    }
    let mounts = mounts(&mut section, parts, report);
    let body = ("subframe", "Subframe, on its mounts");
    let body = super::add_body(architecture, &section, body, true, report);
    section.finish(report);
    let Some(subframe) = body else { return };
    for name in carries.iter().flat_map(Spanned::get_ref) {
        carry(name, subframe, architecture, report);
    }
    // The joint comes last: those of the architecture keep their numbers.
    let joint = architecture.joints.len();
    for (name, kind) in mounts {
        if let ForceKind::Bushing(bushing) = &kind
            && architecture.joints.len() == joint
        {
            let kind = JointKind::Fixed { at: bushing.at };
            let name = "subframe_mounts".to_owned();
            architecture.joints.push(Joint { name, i: BodyId::GROUND, j: subframe, kind });
        }
        let span = name.span();
        let force = Force { name: name.into_inner(), i: BodyId::GROUND, j: subframe, kind };
        fittings.bushings.push((span, JointBushing { joint, force, each_side: true }));
    }
}

/// Lets the subframe take the place of the chassis in a joint.
fn carry(
    name: &Spanned<String>,
    subframe: BodyId,
    architecture: &mut Architecture,
    report: &mut Report,
) {
    let (word, ground) = (name.get_ref(), &architecture.ground);
    let Some(joint) = architecture.joints.iter_mut().find(|joint| joint.name == *word) else {
        let known: Vec<&str> = architecture.joints.iter().map(|j| j.name.as_str()).collect();
        report
            .mistake(&name.span(), format!("there is no joint `{word}`"), "unknown joint")
            .help(suggest::choices(word, &known));
        return;
    };
    if [joint.i, joint.j].contains(&subframe) {
        report
            .mistake(&name.span(), format!("the joint `{word}` is named twice"), "once more")
            .help("name each joint once");
    } else if joint.i == BodyId::GROUND {
        joint.i = subframe;
    } else if joint.j == BodyId::GROUND {
        joint.j = subframe;
    } else {
        let message = format!("the joint `{word}` does not hang on `{ground}`");
        report
            .mistake(&name.span(), message, "between two moving bodies")
            .help(format!("name joints between `{ground}` and another body"));
    }
}

fn mounts(
    section: &mut Section,
    parts: &Parts,
    report: &mut Report,
) -> Vec<(Spanned<String>, ForceKind)> {
    let help = "write a section for each mount on the model's side: `[subframe.mounts.front_mount]` with `at` and `stiffness`";
    let mut mounts = vec![];
    let Some(list) = section.section("mounts", help, report) else { return mounts };
    list.not_empty(help, report);
    for (name, value) in list.entries() {
        let title = format!("[subframe.mounts.{}]", name.get_ref());
        let Some(mut section) = as_section(value, title, help, report) else { continue };
        let kind = parts.bushing(&mut section, name.get_ref(), None, report);
        section.finish(report);
        mounts.extend(kind.map(|kind| (name, kind)));
    }
    mounts
}

/// A mount on the other side, whose point is `at`. Axes between points of this side become constants, for
/// their images are no points of the model.
pub(in crate::model) fn opposite(mount: &Force, at: PointId, points: &[NamedPoint]) -> Force {
    let constant = |line: Direction| match line {
        Direction::Between(from, to) => {
            Direction::Fixed(sub(points[to.0].position, points[from.0].position))
        }
        Direction::Fixed(_) => line,
    };
    let mut image = mount.clone();
    image.name = format!("{}_opposite", mount.name);
    if let ForceKind::Bushing(bushing) = &mut image.kind {
        bushing.axes.x = constant(bushing.axes.x);
        bushing.axes.z = constant(bushing.axes.z);
        bushing.at = at;
    }
    image.mirror();
    image
}
