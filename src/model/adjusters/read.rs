//! Reads `[adjusters]`.

use std::ops::Range;

use toml::Spanned;

use super::{Adjuster, Change, End, STATIC_FACTORS, StaticState};
use crate::mechanism::{
    Acts, BodyId, Curve, Direction, Force, ForceKind, Joint, JointKind, PointId,
};
use crate::model::diagnostics::Report;
use crate::model::parts::{Parts, check_name};
use crate::model::quantity::Quantity;
use crate::model::read::{Section, as_section};
use crate::model::{loads_file, suggest};

/// How far (m) an adjuster goes that names no limits, each way.
const FAR: f64 = 0.1;

/// What a shim, a rod or a seat of a suspension may refer to.
pub(in crate::model) struct AdjustersFile<'a> {
    pub(in crate::model) parts: &'a Parts<'a>,
    /// The joints of the architecture, none where that is not known.
    pub(in crate::model) joints: &'a [Joint],
    /// The joints that bushings stand for.
    pub(in crate::model) bushed: Vec<usize>,
    pub(in crate::model) forces: Vec<&'a Force>,
    /// Whether an axle has a body once.
    pub(in crate::model) is_shared: &'a dyn Fn(BodyId) -> bool,
    /// The name of a body.
    pub(in crate::model) body_name: &'a dyn Fn(BodyId) -> String,
}

impl AdjustersFile<'_> {
    /// The adjusters and the static state, without those that have mistakes.
    pub(in crate::model) fn read(
        &self,
        root: &mut Section,
        report: &mut Report,
    ) -> (Vec<Adjuster>, StaticState) {
        let adjusters = self.adjusters(root, report);
        let state = self.static_state(root, &adjusters, report);
        (adjusters.into_iter().filter_map(|(_, adjuster)| adjuster).collect(), state)
    }

    /// The adjusters in the order of the file; `None` for one with a mistake.
    fn adjusters(
        &self,
        root: &mut Section,
        report: &mut Report,
    ) -> Vec<(Spanned<String>, Option<Adjuster>)> {
        let mut adjusters = vec![];
        let help = "write a section for an adjuster: `[adjusters.tie_rod_length]` with `kind`";
        let Some(list) = root.optional_section("adjusters", help, report) else {
            return adjusters;
        };
        for (name, value) in list.entries() {
            let title = format!("[adjusters.{}]", name.get_ref());
            let Some(section) = as_section(value, title, help, report) else {
                continue;
            };
            check_name(&name, report);
            check_free(&name, report);
            let adjuster = self.adjuster(section, &name, report);
            adjusters.push((name, adjuster));
        }
        adjusters
    }

    fn adjuster(
        &self,
        mut section: Section,
        name: &Spanned<String>,
        report: &mut Report,
    ) -> Option<Adjuster> {
        let kinds = ["length", "shim", "seat"];
        let Some(kind) = section.word("kind", "kind of adjuster", &kinds, report) else {
            // Which other keys the adjuster has depends on its kind.
            section.finish_open(report);
            return None;
        };
        let found = match kind {
            "length" => self.length(&mut section, report),
            "shim" => self.shim(&mut section, report),
            _ => self.seat(&mut section, report),
        };
        let setting = self.parts.optional_number(&mut section, "setting", Quantity::Length, report);
        let limits = self.limits(&mut section, report);
        section.finish(report);
        let (change, title, sign) = found?;
        let limits = limits?;
        let value = setting.as_ref().map_or(0.0, |setting| *setting.get_ref());
        if !(limits[0]..=limits[1]).contains(&value) {
            let span = setting.map_or(name.span(), |setting| setting.span());
            let message = format!("the setting of `{}` is beyond its limits", name.get_ref());
            report
                .mistake(&span, message, "beyond the limits")
                .help("write a setting between the `limits`; they are 100 mm each way where none are given");
            return None;
        }
        Some(Adjuster { name: name.get_ref().clone(), title, sign, setting: value, limits, change })
    }

    fn limits(&self, section: &mut Section, report: &mut Report) -> Option<[f64; 2]> {
        let Some(limits) = section.optional::<[f64; 2]>("limits", report) else {
            return (!section.has("limits")).then_some([-FAR, FAR]);
        };
        let span = limits.span();
        let limits = limits
            .get_ref()
            .map(|limit| self.parts.units.to_si(Quantity::Length, limit, &span, report));
        if limits[0] < limits[1] {
            return Some(limits);
        }
        report
            .mistake(&span, "the first of the `limits` has to be the lower one", "not increasing")
            .help("write the least and the largest value: `limits = [-5.0, 5.0]`");
        None
    }

    /// The length of a rod between two of its points, or of a link.
    fn length(
        &self,
        section: &mut Section,
        report: &mut Report,
    ) -> Option<(Change, String, String)> {
        let help = "name the rod, `body = \"tierod\"`, or a joint that is a link, `joint = \"…\"`";
        let sign = "+ longer".to_owned();
        if section.one_of(&["body", "joint"], help, report)? == "joint" {
            section.value("ends");
            let (joint, _) = self.joint(section, report)?;
            let name = &self.joints[joint].name;
            return Some((Change::Link { joint }, format!("length of {name}"), sign))
                .filter(|_| self.is_link(section, joint, report));
        }
        let name = section.required::<String>("body", help, report);
        let help = "name the ends of the rod: `ends = [\"tierod_inner\", \"tierod_outer\"]`; the second one moves";
        let ends = self.parts.two_points(section, "ends", help, report);
        let place = section.value("ends").map_or(section.span(), Spanned::span);
        let name = name?;
        let body = self.parts.names.moving_body(&name, "name the body of a rod", report)?;
        let [from, to] = ends?;
        let joints = self.held_at(body, to);
        if self.joints.is_empty() {
            return None; // That the architecture is not known has been noted.
        }
        if joints.is_empty() {
            let message = format!("no joint holds `{}` at the second point", name.get_ref());
            report
                .mistake(&place, message, "the end that moves")
                .help("name the two ends at which joints hold the rod");
            return None;
        }
        let attached = |force: &&&Force| {
            let points = force.kind.points();
            let [on_i, on_j] = points.unwrap_or([from, from]);
            (force.i == body && on_i == to) || (force.j == body && on_j == to)
        };
        if let Some(force) = self.forces.iter().find(attached) {
            let message = format!("the force `{}` acts at the end that moves", force.name);
            report
                .mistake(&place, message, "the end that moves")
                .help("name the ends the other way round, so that the other one moves");
            return None;
        }
        let along = Direction::Between(from, to);
        let change = Change::Place { joints, along };
        self.own(&change, &place, report)?;
        Some((change, format!("length of {}", name.get_ref()), sign))
    }

    /// The joints that hold a body at a point.
    fn held_at(&self, body: BodyId, point: PointId) -> Vec<(usize, End)> {
        let mut held = vec![];
        for (index, joint) in self.joints.iter().enumerate() {
            let [on_i, on_j] = joint.kind.points();
            if joint.i == body && on_i == point {
                held.push((index, End::I));
            }
            if joint.j == body && on_j == point {
                held.push((index, End::J));
            }
        }
        held
    }

    fn is_link(&self, section: &mut Section, joint: usize, report: &mut Report) -> bool {
        let place = section.value("joint").map_or(section.span(), Spanned::span);
        let Joint { name, kind, .. } = &self.joints[joint];
        let (message, help) = if self.bushed.contains(&joint) {
            (format!("bushings stand for the joint `{name}`"), "a bushing has no length")
        } else if matches!(kind, JointKind::Link { .. }) {
            return self.own(&Change::Link { joint }, &place, report).is_some();
        } else {
            let message = format!("the joint `{name}` is {}, which has no length", kind.name());
            (message, "name the rod: `body = \"…\"` with `ends`, or use `kind = \"shim\"`")
        };
        report.mistake(&place, message, "no length").help(help);
        false
    }

    /// A shim at a joint.
    fn shim(&self, section: &mut Section, report: &mut Report) -> Option<(Change, String, String)> {
        let joint = self.joint(section, report);
        let help = "name the body on which the joint moves: `on = \"upright\"`";
        let on = section.required::<String>("on", help, report);
        let along = self.parts.direction(section, "direction", report);
        let sign = match section.value("direction").and_then(|value| value.get_ref().as_str()) {
            Some(axis) => format!("+ along the model's +{axis}"),
            None => "+ from the first point of its direction to the second".to_owned(),
        };
        let (joint, place) = joint?;
        let (name, on) = (&self.joints[joint].name, on?);
        let body = self.parts.names.body(&on, report)?;
        let (i, j) = (self.joints[joint].i, self.joints[joint].j);
        let end = match body {
            _ if body == i => End::I,
            _ if body == j => End::J,
            _ => {
                let message = format!("the joint `{name}` does not hold `{}`", on.get_ref());
                let names = [i, j].map(|body| (self.body_name)(body));
                report
                    .mistake(&on.span(), message, "no body of the joint")
                    .help(format!("its bodies are `{}` and `{}`", names[0], names[1]));
                return None;
            }
        };
        let title = format!("shim at {name} on {}", on.get_ref());
        let change = Change::Place { joints: vec![(joint, end)], along: along? };
        self.own(&change, &place, report)?;
        Some((change, title, sign))
    }

    /// The seat of a spring.
    fn seat(&self, section: &mut Section, report: &mut Report) -> Option<(Change, String, String)> {
        let help = "name the spring: `force = \"spring\"`";
        let name = section.required::<String>("force", help, report)?;
        let word = name.get_ref().as_str();
        let is_spring = |force: &Force| {
            matches!(&force.kind, ForceKind::Line { law, .. }
                if law.acts == Acts::Always && law.elastic != Curve::Zero)
        };
        let springs: Vec<&str> = self
            .forces
            .iter()
            .filter(|force| is_spring(force))
            .map(|force| force.name.as_str())
            .collect();
        let found = self.forces.iter().position(|force| force.name == word && is_spring(force));
        let Some(force) = found else {
            let help = match springs[..] {
                [] => "add a spring to [[forces]]".to_owned(),
                _ => suggest::choices(word, &springs),
            };
            let message = format!("there is no spring `{word}` in [[forces]]");
            report.mistake(&name.span(), message, "unknown spring").help(help);
            return None;
        };
        let (i, j) = (self.forces[force].i, self.forces[force].j);
        self.one_side(i, j, &name.span(), report)?;
        let sign = "+ more preload".to_owned();
        Some((Change::FreeLength { force }, format!("seat of {word}"), sign))
    }

    /// The joint of `joint`, and where it stands.
    fn joint(&self, section: &mut Section, report: &mut Report) -> Option<(usize, Range<usize>)> {
        let help = "name the joint: `joint = \"upper_ball_joint\"`";
        let name = section.required::<String>("joint", help, report)?;
        let index = loads_file::joint(&name, self.joints, report)?;
        Some((index, name.span()))
    }

    /// Notes a change of what both sides of an axle have together.
    fn own(&self, change: &Change, place: &Range<usize>, report: &mut Report) -> Option<()> {
        let joints = match change {
            Change::Place { joints, .. } => joints.iter().map(|(joint, _)| *joint).collect(),
            Change::Link { joint } => vec![*joint],
            Change::FreeLength { .. } => vec![],
        };
        for joint in joints.into_iter().map(|joint| &self.joints[joint]) {
            self.one_side(joint.i, joint.j, place, report)?;
        }
        Some(())
    }

    fn one_side(
        &self,
        i: BodyId,
        j: BodyId,
        place: &Range<usize>,
        report: &mut Report,
    ) -> Option<()> {
        if !((self.is_shared)(i) && (self.is_shared)(j)) {
            return Some(());
        }
        report
            .mistake(place, "both sides of an axle have this together", "shared")
            .help("an adjuster belongs to one side; name something that every side has for itself");
        None
    }
}

/// Notes a name that means something else where things are set.
fn check_free(name: &Spanned<String>, report: &mut Report) {
    let mut taken = STATIC_FACTORS.iter().map(|(factor, _)| *factor);
    let word = name.get_ref().as_str();
    if taken.any(|factor| factor == word) || ["ride_height", "travel", "rack"].contains(&word) {
        report
            .mistake(&name.span(), format!("`{word}` is not free for an adjuster"), "taken")
            .help("give the adjuster a name of its own, such as `tie_rod_length`");
    }
}
