//! Targets: what is wanted of which factor, and where.

use std::ops::Range;

use toml::Spanned;

use super::Place;
use super::curve::{self, Column};
use super::goal::{self, Goal};
use super::read::{Context, flag, positive, sections};
use super::state::Course;
use crate::factors::{Convention, Factor, find};
use crate::model::read::Section;
use crate::model::{Quantity, Report, Side, Units};
use crate::rig::{self, Event};

/// A state of the rig at which something is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// The value (SI) of the event that leads there; `None` without an event.
    pub value: Option<f64>,
    /// What the rig does there.
    pub rig: rig::Target,
}

/// What is wanted of a factor.
#[derive(Clone, Debug)]
pub struct Target {
    /// The name for messages, for the trade-off and for robustness; every target has its own.
    pub name: String,
    /// The factor.
    pub factor: &'static Factor,
    /// By whose definition.
    pub convention: Convention,
    /// Of which wheel.
    pub side: Side,
    /// What is wanted.
    pub goal: Goal,
    /// What changes from state to state; `None` where there is one state only.
    pub event: Option<Event>,
    /// Where it is wanted, at least one, in increasing order of the values of the event.
    pub states: Vec<State>,
    /// How much it counts against other targets.
    pub weight: f64,
    /// The difference (SI) that counts as one.
    pub tolerance: f64,
    /// Whether it is a constraint; otherwise its differences, divided by the tolerance and times the weight, are
    /// residuals of least squares.
    pub hard: bool,
    /// Where the request says so.
    pub place: Place,
}

impl Target {
    /// The symbol of the unit of its values.
    pub fn unit(&self, units: Units) -> String {
        self.factor.quantity.symbol(units)
    }

    /// How far (SI) a value at one of the states is off what is wanted, by its place; of a band what lies outside. What
    /// is held is wanted as it was before. `None` without a value.
    pub fn off(&self, state: usize, value: Option<f64>, before: Option<f64>) -> Option<f64> {
        let value = value?;
        Some(match &self.goal {
            Goal::Values(values) => value - values[state],
            Goal::Hold => value - before?,
            Goal::Band { min, max } => {
                let below = min.map_or(0.0, |min| (value - min).min(0.0));
                let above = max.map_or(0.0, |max| (value - max).max(0.0));
                below + above
            }
            Goal::Minimise | Goal::Maximise => 0.0,
        })
    }

    /// A value (SI) in the units of a model.
    pub fn show(&self, units: Units, value: f64) -> f64 {
        self.factor.quantity.show(units, value)
    }
}

/// The keys of which a target has one; a band has two of them.
const GOALS: [&str; 6] = ["value", "curve", "min", "hold", "minimise", "maximise"];

const GOALS_HELP: &str = "say what is wanted: `value = …`, `curve = [[x, y], …]`, `min = …` and `max = …`, \
     `hold = true`, `minimise = true` or `maximise = true`";

/// The targets, without those that have mistakes.
pub(super) fn read(root: &mut Section, context: &Context, report: &mut Report) -> Vec<Target> {
    let before = report.mistakes.len();
    let list = sections(root, "targets", report);
    if list.is_empty() && report.mistakes.len() == before {
        report.mistake(&root.span(), "the request has no targets", "in this file").help(
            "write a `[[targets]]` section for each factor: `factor = \"toe\"` with `value = 0.0`",
        );
    }
    let mut targets: Vec<Target> = vec![];
    let mut names: Vec<Spanned<String>> = vec![];
    for mut section in list {
        let name = section.optional::<String>("name", report);
        if let Some(name) = &name {
            if let Some(first) = names.iter().find(|first| first.get_ref() == name.get_ref()) {
                let message = format!("there are two targets named `{}`", name.get_ref());
                report
                    .mistake(&name.span(), message, "taken")
                    .also(&first.span(), "by this target")
                    .help("give one of them another name");
            }
            names.push(name.clone());
        }
        let target = target(&mut section, context, report);
        section.finish(report);
        if let Some(mut target) = target {
            target.name = name.map(Spanned::into_inner).unwrap_or_default();
            targets.push(target);
        }
    }
    // Names that are given come first, so that they stay whatever else is in the file.
    for index in 0..targets.len() {
        if targets[index].name.is_empty() {
            let title = targets[index].factor.name.to_owned();
            let free = |name: &String| targets.iter().all(|other| other.name != *name);
            let numbered = (2..).map(|number| format!("{title}_{number}"));
            let name = std::iter::once(title.clone()).chain(numbered).find(free);
            targets[index].name = name.unwrap_or_default();
        }
    }
    targets
}

fn target(section: &mut Section, context: &Context, report: &mut Report) -> Option<Target> {
    let place = Place(section.span());
    let factor = factor(section, report);
    let conventions =
        [Convention::Iso, Convention::Adams, Convention::Lotus].map(|by| (by.name(), by));
    let convention =
        section.choice_or("convention", "convention", &conventions, Convention::Iso, report);
    let side = section.choice_or("side", "side", Side::CHOICES, context.model.side, report);
    let kind = goal_key(section, report);
    if kind == Some("curve") {
        section.value("x");
        section.value("y");
    }
    let course = Course::read(section, context, kind == Some("curve"), report);
    let quantity = factor.map_or(Quantity::Ratio, |factor| factor.quantity);
    let (goal, states) = goal(section, kind, factor, course.as_ref(), context, report);
    let weight = positive(section, "weight", report);
    let tolerance = positive(section, "tolerance", report);
    let tolerance = match tolerance {
        Some(tolerance) => context.si(quantity, tolerance.into_inner()),
        None => goal::tolerance(quantity),
    };
    let hard = hard(section, kind, report);
    let (goal, states) = (goal?, states?);
    contradiction(&goal, &states, hard, &place.0, report)?;
    Some(Target {
        name: String::new(),
        factor: factor?,
        convention: convention?,
        side: side?,
        goal,
        event: course?.event,
        states,
        weight: weight.map_or(1.0, Spanned::into_inner),
        tolerance,
        hard,
        place,
    })
}

fn factor(section: &mut Section, report: &mut Report) -> Option<&'static Factor> {
    let help = "name a factor: `factor = \"toe\"`; `hardpoint factors --list` has all names";
    let name = section.required::<String>("factor", help, report)?;
    match find(name.get_ref()) {
        Ok(factor) => Some(factor),
        Err(unknown) => {
            let message = format!("there is no factor `{}`", name.get_ref());
            let help = match unknown.meant {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => "`hardpoint factors --list` has all names".to_owned(),
            };
            report.mistake(&name.span(), message, "unknown factor").help(help);
            None
        }
    }
}

/// Which of [`GOALS`] the target has.
fn goal_key(section: &mut Section, report: &mut Report) -> Option<&'static str> {
    let mut keys = GOALS;
    if section.has("max") && !section.has("min") {
        keys[2] = "max";
    }
    let key = section.one_of(&keys, GOALS_HELP, report);
    section.value("min");
    section.value("max");
    if key.is_some_and(|key| !["min", "max"].contains(&key)) && section.has("max") {
        section.clash(key?, "max", GOALS_HELP, report);
        return None;
    }
    key.map(|key| if key == "max" { "min" } else { key })
}

/// What is wanted, and where.
fn goal(
    section: &mut Section,
    kind: Option<&'static str>,
    factor: Option<&'static Factor>,
    course: Option<&Course>,
    context: &Context,
    report: &mut Report,
) -> (Option<Goal>, Option<Vec<State>>) {
    let quantity = factor.map_or(Quantity::Ratio, |factor| factor.quantity);
    let states = course.map(|course| course.states(None));
    let number = |section: &mut Section, key, report: &mut Report| {
        let number = section.optional::<f64>(key, report)?;
        Some(context.si(quantity, number.into_inner()))
    };
    match kind {
        Some("value") => {
            let value = number(section, "value", report);
            let count = states.as_ref().map_or(0, Vec::len);
            (value.map(|value| Goal::Values(vec![value; count])), states)
        }
        Some("curve") => {
            let Some(course) = course else { return (None, None) };
            let Some(event) = course.event else {
                let span = section.value("curve").map_or(section.span(), Spanned::span);
                report
                    .mistake(&span, "it is not said what the curve goes over", "a curve")
                    .help("write `over = \"travel\"`, `over = \"rack\"` or an `event`");
                return (None, None);
            };
            let names: &[&str] = match event {
                Event::Steer => &["rack"],
                Event::Roll => &["roll", "roll_angle"],
                Event::Load(_) | Event::LoadOpposed(_) | Event::LoadSingle(..) => &["load"],
                _ => &["travel"],
            };
            let own = [factor.map_or("", |factor| factor.name)];
            let columns =
                [Column { names, quantity: course.quantity }, Column { names: &own, quantity }];
            let Some(rows) = curve::read(section, &columns, context, report) else {
                return (None, None);
            };
            let (x, y): (Vec<f64>, Vec<f64>) = rows.into_iter().map(|[x, y]| (x, y)).unzip();
            (Some(Goal::Values(y)), Some(course.states(Some(&x))))
        }
        Some("min") => {
            let ends = ["min", "max"].map(|key| number(section, key, report));
            let [min, max] = ends;
            if let (Some(least), Some(most)) = (min, max)
                && least >= most
            {
                let span = |section: &mut Section, key| {
                    section.value(key).map_or(section.span(), Spanned::span)
                };
                report
                    .mistake(&span(section, "max"), "`max` is not above `min`", "`max`")
                    .also(&span(section, "min"), "`min`")
                    .help("write a `min` that is less than `max`");
                return (None, None);
            }
            (Some(Goal::Band { min, max }), states)
        }
        Some(key) => {
            flag(section, key, report);
            let goal = match key {
                "hold" => Goal::Hold,
                "minimise" => Goal::Minimise,
                _ => Goal::Maximise,
            };
            (Some(goal), states)
        }
        None => (None, None),
    }
}

/// Whether the target is a constraint: a band is, unless the request says otherwise.
fn hard(section: &mut Section, kind: Option<&str>, report: &mut Report) -> bool {
    let hard = section.optional::<bool>("hard", report);
    let open = matches!(kind, Some("minimise" | "maximise"));
    if let Some(hard) = &hard
        && *hard.get_ref()
        && open
    {
        report
            .mistake(
                &hard.span(),
                "what is to be as small or great as possible is no constraint",
                "hard",
            )
            .help("leave `hard` out, or write a `min` or `max`");
    }
    hard.map_or(kind == Some("min"), Spanned::into_inner) && !open
}

/// Notes a constraint that asks for two values at one state.
fn contradiction(
    goal: &Goal,
    states: &[State],
    hard: bool,
    span: &Range<usize>,
    report: &mut Report,
) -> Option<()> {
    let twice =
        states.windows(2).any(|pair| pair[0].value.is_some() && pair[0].value == pair[1].value);
    if let (Goal::Values(_), true, true) = (goal, hard, twice) {
        report
            .mistake(span, "the curve has two values at one place", "this target")
            .help("leave `hard` out, so that the mean of both is sought, or one of the two rows");
        return None;
    }
    Some(())
}
