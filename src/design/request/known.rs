//! What boxes, clearances and joint angles have in common: links, points, and where they count.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::attached::End;
use super::clearance::Round;
use super::read::{Context, interval, whole};
use super::state::{held, values_between};
use super::target::Target;
use crate::model::read::{FromToml, Section};
use crate::model::{Quantity, Report};
use crate::rig::{self, Held, Hold};

/// States of a range of travel or of the rack.
const STATES: u32 = 5;

/// What limits are read with.
pub(super) struct Known<'a> {
    pub(super) context: &'a Context<'a>,
    /// Rim and tyre, where the request has them.
    pub(super) rounds: [Option<Round>; 2],
    /// Whether the request has their sections, right or wrong.
    pub(super) has_rounds: [bool; 2],
    /// Where limits count that do not say where.
    pub(super) states: Vec<rig::Target>,
}

impl Known<'_> {
    /// A link by its two points.
    pub(super) fn link(&self, value: &Spanned<DeValue>, report: &mut Report) -> Option<[End; 2]> {
        let names = <[Spanned<String>; 2]>::read(value, "a link", report)?;
        let points = self.context.points(&names, report);
        let [(a, _), (b, _)] = points[..] else { return None };
        let link = self.context.attached.link([a, b]);
        if link.is_none() {
            let [a, b] = [a, b].map(|point| self.context.attached.name(point));
            report
                .mistake(&value.span(), format!("no part has both `{a}` and `{b}`"), "no link")
                .help("name two points of one body, or of a link or spring between them");
        }
        link
    }

    /// A point with its body.
    pub(super) fn end(
        &self,
        point: usize,
        span: &Range<usize>,
        report: &mut Report,
    ) -> Option<End> {
        let end = self.context.attached.end(point);
        if end.is_none() {
            let name = self.context.attached.name(point);
            report
                .mistake(span, format!("no part carries the point `{name}`"), "carried by none")
                .help("name a point that a joint, a force or the wheel has");
        }
        end
    }

    /// Where a limit counts: at states, over a range of travel, of the rack or of both; otherwise at the design
    /// position and at the ends of what the targets have.
    pub(super) fn states(
        &self,
        section: &mut Section,
        report: &mut Report,
    ) -> Option<Vec<rig::Target>> {
        let ranges = ["travel", "rack"].map(|key| section.value(key).map(|value| (key, value)));
        let states = whole(section, "states", [1, 100], report);
        if let Some(value) = section.value("at") {
            if let Some((key, _)) = ranges.iter().flatten().next() {
                section.clash("at", key, "write states, or a range", report);
                return None;
            }
            let one = |value| held(value, self.context, report).map(|(held, _)| held.target());
            return match value.get_ref().as_array() {
                Some(list) if !list.is_empty() => list.iter().map(one).collect(),
                _ => std::iter::once(value).map(one).collect(),
            };
        }
        if ranges.iter().all(Option::is_none) {
            if let Some(states) = states {
                report
                    .mistake(&states.span(), "`states` belongs to a range", "no range")
                    .help("write `travel = [-50.0, 50.0]`, too");
            }
            return Some(self.states.clone());
        }
        let count = states.map_or(STATES, Spanned::into_inner);
        let mut values = [vec![0.0], vec![0.0]];
        for (values, range) in values.iter_mut().zip(ranges) {
            let Some((key, value)) = range else { continue };
            if key == "rack" && !self.context.model.steers() {
                report
                    .mistake(&value.span(), "the model has no rack", "`rack`")
                    .help("leave this out");
                return None;
            }
            let ends = interval(value, &format!("`{key}`"), report)?;
            for end in *ends.get_ref() {
                self.context.near(&Spanned::new(ends.span(), end), key, report)?;
            }
            let ends = ends.get_ref().map(|end| self.context.si(Quantity::Length, end));
            *values = values_between(ends, count);
        }
        let [travels, racks] = &values;
        let of_travel = |travel: &f64| {
            let travel = *travel;
            racks.iter().map(move |rack| Held { travel, rack: *rack, ..Held::default() }.target())
        };
        Some(travels.iter().flat_map(of_travel).collect())
    }
}

/// The design position, and the ends of the ranges of travel and rack that targets have.
pub(super) fn ends(targets: &[Target]) -> Vec<rig::Target> {
    let mut ranges = [[0.0_f64; 2]; 2];
    for state in targets.iter().flat_map(|target| &target.states) {
        let travels = state.rig.wheels.iter().filter_map(|hold| match hold {
            Hold::Value(travel) => Some(*travel),
            Hold::Force(_) => None,
        });
        for (range, value) in travels.map(|travel| (0, travel)).chain([(1, state.rig.rack)]) {
            ranges[range][0] = ranges[range][0].min(value);
            ranges[range][1] = ranges[range][1].max(value);
        }
    }
    let mut states = vec![Held::default().target()];
    for travel in ranges[0].into_iter().filter(|travel| *travel != 0.0) {
        states.push(Held { travel, ..Held::default() }.target());
    }
    for rack in ranges[1].into_iter().filter(|rack| *rack != 0.0) {
        states.push(Held { rack, ..Held::default() }.target());
    }
    states
}

/// The name of a limit, or its number.
pub(super) fn name(section: &mut Section, kind: &str, index: usize, report: &mut Report) -> String {
    let name = section.optional::<String>("name", report);
    name.map_or_else(|| format!("{kind} {}", index + 1), Spanned::into_inner)
}
