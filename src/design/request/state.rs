//! At which states of the rig something is wanted.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::read::{Context, interval, whole};
use super::target::State;
use crate::model::read::{FromToml, Section, as_section};
use crate::model::{CaseInput, LOAD_COMPONENTS, Quantity, Report, Side, suggest};
use crate::rig::{self, Event, Held, SweepPlan, Vertical};

/// How wheels and rack are held.
const HOLDS: [(&str, CaseInput); 7] = [
    ("travel", CaseInput::Travel(None)),
    ("left_travel", CaseInput::Travel(Some(Side::Left))),
    ("right_travel", CaseInput::Travel(Some(Side::Right))),
    ("wheel_force", CaseInput::WheelForce(None)),
    ("left_wheel_force", CaseInput::WheelForce(Some(Side::Left))),
    ("right_wheel_force", CaseInput::WheelForce(Some(Side::Right))),
    ("rack", CaseInput::Rack),
];

/// The components of loads: of both wheels, of the left and of the right one.
const LOADS: [&str; 18] = [
    "fx", "fy", "fz", "mx", "my", "mz", "left_fx", "left_fy", "left_fz", "left_mx", "left_my",
    "left_mz", "right_fx", "right_fy", "right_fz", "right_mx", "right_my", "right_mz",
];

/// The events, by their names on the command line; `bump` is what many call travel.
const EVENTS: [&str; 9] =
    ["travel", "bump", "parallel", "opposite", "left", "right", "steer", "roll", "load"];

/// States of a range where nothing says how many.
const POINTS: u32 = 11;

/// What a target is wanted at.
pub(super) struct Course {
    pub(super) event: Option<Event>,
    /// What the values of the event are.
    pub(super) quantity: Quantity,
    held: Held,
    /// The values (SI) of a range.
    range: Option<Vec<f64>>,
}

impl Course {
    /// The states: of the range, of the values (SI) of a curve, or the one that is held.
    pub(super) fn states(&self, curve: Option<&[f64]>) -> Vec<State> {
        let Some(event) = self.event else {
            return vec![State { value: None, rig: self.held.target() }];
        };
        let plan = SweepPlan { event, from: 0.0, to: 0.0, step: 0.0, held: self.held };
        let values = curve.or(self.range.as_deref()).unwrap_or_default();
        values.iter().map(|v| State { value: Some(*v), rig: plan.target(*v) }).collect()
    }

    /// Reads the keys of a target that say where: one state, or a range of an event. A curve has its own values.
    pub(super) fn read(
        section: &mut Section,
        context: &Context,
        curve: bool,
        report: &mut Report,
    ) -> Option<Self> {
        let held = section.value("at").map(|value| held(value, context, report));
        let (held, given) = held.unwrap_or(Some((Held::default(), vec![])))?;
        let points = whole(section, "points", [1, 1000], report);
        let (event, quantity, values) = event(section, context, report)?;
        let Some((event, place)) = event else {
            for key in ["range", "points"] {
                if let Some(value) = section.value(key) {
                    report
                        .mistake(&value.span(), format!("`{key}` belongs to an event"), "no event")
                        .help(
                            "write a range such as `travel = [-50.0, 50.0]`, or name the `event`",
                        );
                    return None;
                }
            }
            let quantity = Quantity::Length;
            return Some(Self { event: None, quantity, held, range: None });
        };
        if let Some((key, span)) = given
            .iter()
            .find(|(_, input, _)| changes(event, *input))
            .map(|(key, _, span)| (key, span))
        {
            report
                .mistake(span, format!("`{key}` is what the event changes"), "held here")
                .also(&place, "changed here")
                .help("leave one of them out");
            return None;
        }
        let range = match (values, curve) {
            (Some((_, span)), true) => {
                report
                    .mistake(&span, "a curve has its own range", "a range")
                    .help("say what changes with `over = \"travel\"`, and leave the range out");
                return None;
            }
            (None, true) => {
                if let Some(points) = points {
                    report
                        .mistake(&points.span(), "a curve has its own points", "a number of points")
                        .help("leave `points` out");
                    return None;
                }
                None
            }
            (Some((ends, _)), false) => {
                Some(values_between(ends, points.map_or(POINTS, Spanned::into_inner)))
            }
            (None, false) => {
                report
                    .mistake(&place, "the range of the event is missing", "from where to where?")
                    .help("write the first and the last value: `range = [-50.0, 50.0]`");
                return None;
            }
        };
        Some(Self { event: Some(event), quantity, held, range })
    }
}

/// Evenly spaced values from one end to the other.
pub(super) fn values_between([from, to]: [f64; 2], count: u32) -> Vec<f64> {
    if count < 2 {
        return vec![0.5 * (from + to)];
    }
    let part = |k: u32| f64::from(k) / f64::from(count - 1);
    (0..count).map(|k| from * (1.0 - part(k)) + to * part(k)).collect()
}

/// Whether an event changes what is held.
fn changes(event: Event, input: CaseInput) -> bool {
    match event {
        Event::Travel => matches!(input, CaseInput::Travel(_) | CaseInput::WheelForce(_)),
        Event::Single(side) => matches!(
            input,
            CaseInput::Travel(of) | CaseInput::WheelForce(of) if of == Some(side)
        ),
        Event::Steer => input == CaseInput::Rack,
        Event::Load(component) | Event::LoadOpposed(component) => {
            matches!(input, CaseInput::Load(other, _) if other == component)
        }
        Event::LoadSingle(component, side) => input == CaseInput::Load(component, Some(side)),
        Event::Opposite | Event::Roll | Event::Driver(_) => false,
    }
}

/// A key, what it says and where.
type Given = (&'static str, CaseInput, Range<usize>);

/// What is held at a state, with the keys that say so.
pub(super) fn held(
    value: &Spanned<DeValue>,
    context: &Context,
    report: &mut Report,
) -> Option<(Held, Vec<Given>)> {
    let help = "write what the rig holds: `at = { travel = 30.0, rack = 0.0 }`";
    let mut section = as_section(value, "`at`".to_owned(), help, report)?;
    let mistakes = report.mistakes.len();
    let mut given: Vec<(Given, f64)> = vec![];
    for (key, input) in HOLDS {
        given.extend(number(&mut section, key, input, context, report));
    }
    let help = "write the components of the load: `load = { fx = -1000.0 }`";
    if let Some(mut loads) = section.optional_section("load", help, report) {
        for (index, key) in LOADS.into_iter().enumerate() {
            let side = [None, Some(Side::Left), Some(Side::Right)][index / 6];
            let input = CaseInput::Load(index % 6, side);
            given.extend(number(&mut loads, key, input, context, report));
        }
        loads.not_empty(help, report);
        loads.finish(report);
    }
    section.finish(report);
    let wheel = |input: CaseInput| match input {
        CaseInput::WheelForce(side) => CaseInput::Travel(side),
        other => other,
    };
    for (index, ((key, input, span), _)) in given.iter().enumerate() {
        let earlier = given[..index].iter().map(|(given, _)| given);
        let mut earlier = earlier.filter(|(_, other, _)| wheel(*other).collides(wheel(*input)));
        if let Some((other, _, place)) = earlier.next() {
            report
                .mistake(span, format!("`{other}` and `{key}` hold the same wheel"), "once more")
                .also(place, "first here")
                .help("leave one of them out");
        }
    }
    let held = in_rig(&given, value, report);
    let whole = report.mistakes.len() == mistakes;
    held.filter(|_| whole).map(|held| (held, given.into_iter().map(|(given, _)| given).collect()))
}

/// One number of a state in SI.
fn number(
    section: &mut Section,
    key: &'static str,
    input: CaseInput,
    context: &Context,
    report: &mut Report,
) -> Option<(Given, f64)> {
    let number = section.optional::<f64>(key, report)?;
    let model = context.model;
    let loaded = model.has_forces() || model.axle_has_forces();
    let problem = match input {
        CaseInput::Rack if !model.steers() => Some(("the model has no rack", "leave this out")),
        CaseInput::Load(..) | CaseInput::WheelForce(_) if !loaded => Some((
            "the model has no forces, so a load moves nothing",
            "add springs to the model, or leave this out",
        )),
        _ => None,
    };
    if let Some((message, help)) = problem {
        report.mistake(&number.span(), message, format!("`{key}`")).help(help);
        return None;
    }
    let value = match input.quantity() {
        Quantity::Length => context.near(&number, &format!("`{key}`"), report)?,
        quantity => context.si(quantity, *number.get_ref()),
    };
    Some(((key, input, number.span()), value))
}

/// What the rig holds. Both wheels are held in the same way.
fn in_rig(given: &[(Given, f64)], value: &Spanned<DeValue>, report: &mut Report) -> Option<Held> {
    let mut target = Held::default().target();
    let (mut forces, mut load) = ([None; 2], [[0.0; 6]; 2]);
    let mut travels = [None; 2];
    for ((_, input, _), value) in given {
        let sides = input.side().map_or(0..2, |side| side.index()..side.index() + 1);
        match input {
            CaseInput::Rack => target.rack = *value,
            CaseInput::Travel(_) => travels[sides].fill(Some(*value)),
            CaseInput::WheelForce(_) => forces[sides].fill(Some(*value)),
            CaseInput::Load(component, _) => {
                load[sides].iter_mut().for_each(|load| load[*component] = *value);
            }
        }
    }
    let [load, right_load] = load.map(|components| rig::Load { components });
    let travel = travels.map(Option::unwrap_or_default);
    let vertical = match forces {
        [None, None] => Vertical::Travel,
        [Some(left), Some(right)] => Vertical::Force([left, right]),
        _ => {
            report
                .mistake(&value.span(), "a force holds one wheel only", "one of two wheels")
                .help("hold both wheels by forces, or both by travels");
            return None;
        }
    };
    Some(Held {
        travel: travel[0],
        right_travel: Some(travel[1]),
        vertical,
        rack: target.rack,
        load,
        right_load: Some(right_load),
        ..Held::default()
    })
}

/// An event with its place.
type Named = Option<(Event, Range<usize>)>;

/// A range (SI) with its place.
type Ranged = Option<([f64; 2], Range<usize>)>;

/// What changes, what its values are, and from where to where.
fn event(
    section: &mut Section,
    context: &Context,
    report: &mut Report,
) -> Option<(Named, Quantity, Ranged)> {
    let keys = ["event", "over", "travel", "rack"];
    let given: Vec<&'static str> =
        keys.into_iter().filter(|key| section.value(key).is_some()).collect();
    if let [first, second, ..] = given[..] {
        section.clash(first, second, "say once what changes", report);
        return None;
    }
    let range = section.value("range");
    let Some(key) = given.first() else { return Some((None, Quantity::Length, None)) };
    let place = section.value(key)?.span();
    let (event, quantity, range) = match *key {
        "travel" | "rack" => {
            if let Some(range) = range {
                section.clash(key, "range", "write the range once", report);
                interval(range, "`range`", report);
                return None;
            }
            let event = if *key == "travel" { Event::Travel } else { Event::Steer };
            (event, Quantity::Length, section.value(key))
        }
        "over" => {
            let choices = [("travel", Event::Travel), ("rack", Event::Steer)];
            let over = section.choice("over", "motion", &choices, "", report)?;
            (over.into_inner(), Quantity::Length, range)
        }
        _ => {
            let (event, quantity) = named(section, report)?;
            (event, quantity, range)
        }
    };
    if event == Event::Steer && !context.model.steers() {
        report
            .mistake(&place, "the model has no rack", "steering")
            .help("leave this target out, or choose an event of travel");
        return None;
    }
    if matches!(quantity, Quantity::Force | Quantity::Torque) && !context.model.axle_has_forces() {
        report
            .mistake(&place, "the model has no forces, so a load moves nothing", "a load")
            .help("add springs to the model, or leave this target out");
        return None;
    }
    let Some(range) = range else { return Some((Some((event, place)), quantity, None)) };
    // One state is a range, too.
    let what =
        if ["travel", "rack"].contains(key) { format!("`{key}`") } else { "`range`".to_owned() };
    let what = what.as_str();
    let ends = <[f64; 2]>::read(range, what, report)?;
    if ends[0] > ends[1] {
        report
            .mistake(&range.span(), format!("{what} must begin below its end"), "decreasing")
            .help("write the least value first");
        return None;
    }
    for end in ends {
        if quantity == Quantity::Length {
            context.near(&Spanned::new(range.span(), end), what, report)?;
        }
    }
    let ends = ends.map(|end| context.si(quantity, end));
    Some((Some((event, place)), quantity, Some((ends, range.span()))))
}

/// The event of `event`, with the component and the wheels of a load.
fn named(section: &mut Section, report: &mut Report) -> Option<(Event, Quantity)> {
    let Some(word) = section.word("event", "event", &EVENTS, report) else {
        // Which other keys the event has depends on it.
        section.value("vary");
        section.value("wheels");
        return None;
    };
    let event = match word {
        "opposite" => Event::Opposite,
        "left" => Event::Single(Side::Left),
        "right" => Event::Single(Side::Right),
        "steer" => Event::Steer,
        "roll" => return Some((Event::Roll, Quantity::Angle)),
        "load" => return load(section, report),
        _ => Event::Travel,
    };
    Some((event, Quantity::Length))
}

/// A load that grows.
fn load(section: &mut Section, report: &mut Report) -> Option<(Event, Quantity)> {
    let help = format!(
        "say which component of the load grows, one of {}: `vary = \"fy\"`",
        suggest::listed(&LOAD_COMPONENTS)
    );
    let wheels = ["parallel", "opposed", "left", "right"].map(|word| (word, word));
    let wheels = section.choice_or("wheels", "choice of wheels", &wheels, "parallel", report);
    let vary = section.required::<String>("vary", &help, report)?;
    let Some(component) = LOAD_COMPONENTS.iter().position(|name| name == vary.get_ref()) else {
        let message = format!("there is no component `{}` of a load", vary.get_ref());
        let help = suggest::choices(vary.get_ref(), &LOAD_COMPONENTS);
        report.mistake(&vary.span(), message, "unknown").help(help);
        return None;
    };
    let event = match wheels? {
        "opposed" => Event::LoadOpposed(component),
        "left" => Event::LoadSingle(component, Side::Left),
        "right" => Event::LoadSingle(component, Side::Right),
        _ => Event::Load(component),
    };
    Some((event, CaseInput::Load(component, None).quantity()))
}
