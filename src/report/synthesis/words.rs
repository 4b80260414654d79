//! Verdicts, targets and states in words.

use super::super::table::cell;
use super::SynthesisReport;
use crate::design::request::{Goal, State, Target, short, state_words};
use crate::design::synthesis::Verdict;
use crate::model::{CaseInput, LOAD_COMPONENTS, Quantity, Units};
use crate::rig::Event;

impl SynthesisReport<'_> {
    /// What stands against the targets, in lines for the terminal; `None` where all are met.
    pub fn unmet(&self) -> Option<String> {
        (*self.verdict != Verdict::Met).then(|| self.verdict_words())
    }

    /// The verdict in lines.
    pub(super) fn verdict_words(&self) -> String {
        let count = self.request.targets.len();
        match self.verdict {
            Verdict::Met => match count {
                1 => "the target is met within its tolerance, and all limits are kept\n".to_owned(),
                _ => format!(
                    "all {count} targets are met within their tolerances, and all limits are kept\n"
                ),
            },
            Verdict::Compromise { unmet } => {
                let what = match count {
                    1 => "the target is missed".to_owned(),
                    _ => format!("{} of {count} targets are missed", unmet.len()),
                };
                let mut words = format!(
                    "{what}; this is the best design that was found, and it keeps all limits\n"
                );
                for unmet in unmet {
                    let target = &self.request.targets[unmet.target];
                    let units = self.model.units;
                    words += &format!(
                        "  {} is off by {} {}{}: {:.1} times its tolerance\n",
                        self.title(target),
                        cell(Some(target.show(units, unmet.off))),
                        target.unit(units),
                        if target.states.len() == 1 { "" } else { " at most" },
                        unmet.tolerances
                    );
                }
                words
            }
            Verdict::Conflict { between } => {
                let mut words = match between.len() {
                    1 => "this cannot be kept by any change that is allowed, so there is no design:\n"
                        .to_owned(),
                    _ => "these contradict each other, so there is no design that keeps them all:\n"
                        .to_owned(),
                };
                for limit in between {
                    words += &format!("  {limit}\n");
                }
                words += "widen or leave out one of them, or let more change\n";
                words
            }
            Verdict::Unreachable { reason } => {
                format!("designs around the best one could not be evaluated: {reason}\n")
            }
            Verdict::Unfinished { broken } => {
                let mut words =
                    "no design was found that keeps all limits; the nearest breaks these:\n"
                        .to_owned();
                for limit in broken {
                    words += &format!("  {limit}\n");
                }
                words += "widen them or others, let more change, or give it more `iterations` or `starts` in [search]\n";
                words
            }
        }
    }

    /// A target with where it is wanted.
    pub(super) fn title(&self, target: &Target) -> String {
        let wheel = match self.request.needs_axle(self.model) && !target.factor.is_of_axle() {
            true => format!(", {} wheel", target.side.name()),
            false => String::new(),
        };
        format!("{}{wheel}{}", target.name, self.place(target))
    }

    /// Where a target is wanted.
    fn place(&self, target: &Target) -> String {
        let units = self.model.units;
        let Some(event) = target.event else {
            let held = target.states.first().map(|state| state_words(&state.rig, units));
            let held = held.filter(|held| !held.is_empty());
            return held.map_or_else(String::new, |held| format!(" at {held}"));
        };
        let quantity = quantity(event);
        let end = |state: Option<&State>| {
            let value = state.and_then(|state| state.value).unwrap_or_default();
            short(quantity.show(units, value))
        };
        let (first, last) = (end(target.states.first()), end(target.states.last()));
        let (name, symbol) = (event_name(event), quantity.symbol(units));
        match target.states.len() {
            1 => format!(" at {name} {first} {symbol}"),
            count => format!(" over {name} {first} … {last} {symbol}, {count} states"),
        }
    }
}

/// What is wanted at one state, or of all.
pub(super) fn wanted(target: &Target, units: Units) -> String {
    let show = |value: f64| cell(Some(target.show(units, value)));
    match &target.goal {
        Goal::Values(values) if values.iter().all(|value| *value == values[0]) => show(values[0]),
        Goal::Values(_) => "curve".to_owned(),
        Goal::Band { min: Some(min), max: Some(max) } => format!("{} … {}", show(*min), show(*max)),
        Goal::Band { min: Some(min), .. } => format!("≥ {}", show(*min)),
        Goal::Band { max, .. } => format!("≤ {}", cell(max.map(|max| target.show(units, max)))),
        Goal::Hold => "as before".to_owned(),
        Goal::Minimise => "least".to_owned(),
        Goal::Maximise => "greatest".to_owned(),
    }
}

/// What an event is called in requests.
pub(super) fn event_name(event: Event) -> String {
    match event {
        Event::Travel => "travel".to_owned(),
        Event::Opposite => "opposite travel".to_owned(),
        Event::Single(side) => format!("travel of the {} wheel", side.name()),
        Event::Steer => "rack".to_owned(),
        Event::Roll => "roll".to_owned(),
        Event::Load(component) => format!("load {}", LOAD_COMPONENTS[component]),
        Event::LoadOpposed(component) => format!("opposed load {}", LOAD_COMPONENTS[component]),
        Event::LoadSingle(component, side) => {
            format!("{} load {}", side.name(), LOAD_COMPONENTS[component])
        }
        Event::Driver(_) => "driver".to_owned(),
    }
}

/// What the values of an event are.
pub(super) fn quantity(event: Event) -> Quantity {
    match event {
        Event::Roll => Quantity::Angle,
        Event::Load(component)
        | Event::LoadOpposed(component)
        | Event::LoadSingle(component, _) => CaseInput::Load(component, None).quantity(),
        _ => Quantity::Length,
    }
}
