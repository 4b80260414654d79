//! Distances that parts keep.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::Place;
use super::attached::End;
use super::known::{Known, name};
use super::read::{Context, sections};
use crate::model::read::{FromToml, Section};
use crate::model::{Report, suggest};
use crate::rig;

/// A round part about the spin axis: the barrel of the rim, or the tyre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// Inner radius of the barrel, outer radius of the tyre (m).
    pub radius: f64,
    /// Width along the spin axis (m).
    pub width: f64,
    /// The middle of the width, from the wheel centre outboard along the spin axis (m).
    pub offset: f64,
}

/// What keeps a distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The straight line between two points of one body, or a spring.
    Link([End; 2]),
    /// A point.
    Point(End),
    /// [`Limits::rim`](super::Limits::rim): other parts stay inside of the barrel.
    Rim,
    /// [`Limits::tyre`](super::Limits::tyre): other parts stay outside of it.
    Tyre,
}

/// Two parts that do not come too near to each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Clearance {
    /// The name for reports.
    pub name: String,
    /// The parts.
    pub between: [Part; 2],
    /// Their radii (m), zero for points and lines; a rim or tyre has its own.
    pub radii: [f64; 2],
    /// The least distance (m) between their surfaces.
    pub distance: f64,
    /// Where it counts.
    pub states: Vec<rig::Target>,
    /// Where the request says so.
    pub place: Place,
}

/// The section of a rim or tyre.
pub(super) fn round(
    root: &mut Section,
    key: &'static str,
    context: &Context,
    report: &mut Report,
) -> Option<Round> {
    let help = format!("write a section `[{key}]` with `radius` and `width`");
    let mut section = root.optional_section(key, &help, report)?;
    let [radius, width] = ["radius", "width"].map(|key| {
        section.required::<f64>(key, &format!("write its {key}: `{key} = 200.0`"), report)?;
        context.length(&mut section, key, report)
    });
    let offset = section.optional::<f64>("offset", report);
    let offset = offset.map_or(Some(0.0), |offset| context.near(&offset, "`offset`", report));
    section.finish(report);
    Some(Round { radius: radius?, width: width?, offset: offset? })
}

impl Known<'_> {
    /// The clearances.
    pub(super) fn clearances(&self, root: &mut Section, report: &mut Report) -> Vec<Clearance> {
        let mut clearances = vec![];
        for (index, mut section) in sections(root, "clearances", report).into_iter().enumerate() {
            let found = self.clearance(&mut section, index, report);
            section.finish(report);
            clearances.extend(found);
        }
        clearances
    }

    fn clearance(
        &self,
        section: &mut Section,
        index: usize,
        report: &mut Report,
    ) -> Option<Clearance> {
        let name = name(section, "clearance", index, report);
        let help = "name two parts: `between = [[\"tierod_inner\", \"tierod_outer\"], \"spring\"]`";
        let distance = match section.required::<f64>("distance", "write the least distance", report)
        {
            Some(number) if *number.get_ref() == 0.0 => Some(0.0),
            Some(_) => self.context.length(section, "distance", report),
            None => None,
        };
        let radii = section.optional::<[f64; 2]>("radii", report);
        let radii = radii.map_or(Some([0.0; 2]), |radii| {
            let span = radii.span();
            if radii.get_ref().iter().any(|radius| *radius < 0.0) {
                report
                    .mistake(&span, "a radius is below zero", "negative")
                    .help("write both radii");
                return None;
            }
            let [a, b] = radii.get_ref().map(|r| Spanned::new(span.clone(), r));
            let near = |radius, report: &mut Report| self.context.near(radius, "a radius", report);
            Some([near(&a, report)?, near(&b, report)?])
        });
        let states = self.states(section, report);
        if !section.has("between") {
            section.required::<[Spanned<String>; 2]>("between", help, report);
            return None;
        }
        let value = section.value("between")?;
        let parts = value.get_ref().as_array();
        let Some(parts) = parts.filter(|parts| parts.len() == 2) else {
            report.mistake(&value.span(), "`between` must name two parts", "here").help(help);
            return None;
        };
        let between = [self.part(&parts[0], report), self.part(&parts[1], report)];
        let between = [between[0]?, between[1]?];
        self.check_pair(between, &value.span(), report)?;
        let (radii, distance, states) = (radii?, distance?, states?);
        Some(Clearance { name, between, radii, distance, states, place: Place(section.span()) })
    }

    /// Notes parts whose distance says nothing.
    fn check_pair(
        &self,
        between: [Part; 2],
        span: &Range<usize>,
        report: &mut Report,
    ) -> Option<()> {
        let ends = between.map(|part| match part {
            Part::Link(ends) => ends.to_vec(),
            Part::Point(end) => vec![end],
            Part::Rim | Part::Tyre => vec![],
        });
        if ends.iter().all(Vec::is_empty) {
            report
                .mistake(span, "rim and tyre turn together", "no link and no point")
                .help("name a link or a point that stays away from one of them");
            return None;
        }
        let common = ends[0].iter().find(|end| ends[1].iter().any(|other| other.0 == end.0));
        if let Some((point, _)) = common {
            let point = self.context.attached.name(point.index());
            report
                .mistake(span, format!("both parts have the point `{point}`"), "joined there")
                .help("name parts that are not joined: the distance of these is always zero");
            return None;
        }
        Some(())
    }

    /// A part by its points or its name.
    fn part(&self, value: &Spanned<DeValue>, report: &mut Report) -> Option<Part> {
        if value.get_ref().is_array() {
            return self.link(value, report).map(Part::Link);
        }
        let word = Spanned::<String>::read(value, "a part", report)?;
        let attached = &self.context.attached;
        for (index, key) in ["rim", "tyre"].into_iter().enumerate() {
            if word.get_ref() != key {
                continue;
            }
            if !self.has_rounds[index] {
                report
                    .mistake(&word.span(), format!("the request has no section [{key}]"), "unknown")
                    .help(format!("add `[{key}]` with `radius` and `width`"));
            }
            return self.rounds[index].map(|_| [Part::Rim, Part::Tyre][index]);
        }
        if let Some(line) = attached.line(word.get_ref()) {
            return Some(Part::Link(line));
        }
        let strut = match word.get_ref().as_str() {
            "spring" => attached.spring,
            "damper" => attached.damper,
            _ => None,
        };
        if let Some(strut) = strut {
            return Some(Part::Link(strut.ends));
        }
        let points = self.context.model.points();
        if let Some(point) = points.iter().position(|point| point.name == *word.get_ref()) {
            return self.end(point, &word.span(), report).map(Part::Point);
        }
        let mut known = attached.names();
        known.extend(["spring", "damper", "rim", "tyre"]);
        report
            .mistake(&word.span(), format!("there is no part `{}`", word.get_ref()), "unknown part")
            .help(format!(
                "{}; a link is a list of two points",
                suggest::choices(word.get_ref(), &known)
            ));
        None
    }
}
