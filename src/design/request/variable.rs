//! Variables: what may change, and how far.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::Place;
use super::parameter::{Parameter, named};
use super::read::{AXES, Context, FARTHEST, flag, interval, sections};
use crate::design::edit::{EditError, ModelText};
use crate::model::read::{FromToml, Section, as_section};
use crate::model::{Model, Report};

/// A number of the model that may change.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The name for reports: `tierod_inner.z`, `forces.spring.stiffness`.
    pub name: String,
    /// What it is.
    pub parameter: Parameter,
    /// The value (SI, coordinates in ISO 8855 axes) that the model has. It may lie outside of the bounds.
    pub start: f64,
    /// The least and the greatest value that it may have, which differ.
    pub bounds: [f64; 2],
    /// Where the request says so.
    pub place: Place,
}

impl Variable {
    /// Writes a value (SI) into the text of the model's file.
    ///
    /// # Errors
    /// [`EditError`] where the file has no such number.
    pub fn write(&self, model: &Model, value: f64, text: &mut ModelText) -> Result<(), EditError> {
        let shown = match self.parameter {
            Parameter::Coordinate { axis, .. } => model.axes.signs()[axis] * value + 0.0,
            _ => value,
        };
        let path = self.parameter.path(model);
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        text.set(&path, self.parameter.quantity(model), shown)
    }
}

/// The points that `locked` names.
pub(super) fn locked(
    root: &mut Section,
    context: &Context,
    report: &mut Report,
) -> Vec<(usize, Range<usize>)> {
    let names = root.optional::<Vec<Spanned<String>>>("locked", report);
    names.map(|names| context.points(names.get_ref(), report)).unwrap_or_default()
}

/// What a section says may change, and how far.
struct Entry {
    found: Vec<(String, Parameter)>,
    /// Least and greatest value (SI) of each; `None` where the section says nothing of it.
    bounds: Vec<Option<[f64; 2]>>,
    span: Range<usize>,
    /// Whether it names its points.
    explicit: bool,
}

/// The variables in the order of the file, without those that have mistakes.
pub(super) fn read(
    root: &mut Section,
    context: &Context,
    locked: &[(usize, Range<usize>)],
    movement: Option<f64>,
    report: &mut Report,
) -> Vec<Variable> {
    let before = report.mistakes.len();
    let mut entries = vec![];
    for mut section in sections(root, "variables", report) {
        entries.extend(entry(&mut section, context, locked, report));
        section.finish(report);
    }
    let mut variables: Vec<Variable> = vec![];
    for entry in entries.iter().filter(|entry| entry.explicit) {
        add(entry, context, movement, &mut variables, report);
    }
    for entry in entries.iter().filter(|entry| !entry.explicit) {
        add(entry, context, movement, &mut variables, report);
    }
    if variables.is_empty() && report.mistakes.len() == before {
        report.mistake(&root.span(), "nothing may change", "in this file").help(
            "write a `[[variables]]` section: `point = \"tierod_inner\"` with `range = 10.0`",
        );
    }
    variables
}

/// Adds the variables of a section. Points that are named go before those of `all_points`.
fn add(
    entry: &Entry,
    context: &Context,
    movement: Option<f64>,
    variables: &mut Vec<Variable>,
    report: &mut Report,
) {
    for ((name, parameter), bounds) in entry.found.iter().zip(&entry.bounds) {
        if let Some(first) = variables.iter().find(|other| other.parameter == *parameter) {
            if entry.explicit {
                report
                    .mistake(&entry.span, format!("`{name}` is a variable twice"), "once more")
                    .also(&first.place.0, "first here")
                    .help("name each coordinate once");
                return;
            }
            continue;
        }
        let Some(start) = parameter.value(context.model) else { continue };
        let coordinate = matches!(parameter, Parameter::Coordinate { .. });
        let free = movement.filter(|_| coordinate).map(|way| [start - way, start + way]);
        let Some(bounds) = bounds.or(free) else {
            report
                .mistake(
                    &entry.span,
                    format!("it is not said how far `{name}` may change"),
                    "this variable",
                )
                .help(match coordinate {
                    true => "write `range = [-10.0, 10.0]` from where it is, `bounds`, or `movement` in [limits]",
                    false => "write `percent = 20.0`, `range` or `bounds`",
                });
            return;
        };
        let stiffness = matches!(parameter, Parameter::Stiffness(_) | Parameter::FreeLength { .. });
        if stiffness && bounds[0] < 0.0 {
            report
                .mistake(&entry.span, format!("`{name}` could fall below zero"), "this variable")
                .help("let it change less, or write `bounds` that do not begin below zero");
            return;
        }
        variables.push(Variable {
            name: name.clone(),
            parameter: *parameter,
            start,
            bounds,
            place: Place(entry.span.clone()),
        });
    }
}

fn entry(
    section: &mut Section,
    context: &Context,
    locked: &[(usize, Range<usize>)],
    report: &mut Report,
) -> Option<Entry> {
    let keys = ["point", "points", "all_points", "parameter"];
    let help = "say what may change: `point = \"tierod_inner\"`, `points = [\"…\", \"…\"]`, `all_points = true` \
                or `parameter = \"forces.spring.stiffness\"`";
    let key = section.one_of(&keys, help, report);
    if key == Some("parameter") {
        return parameter(section, context, report);
    }
    let points = match key {
        Some("point") => {
            let name = section.optional::<Spanned<String>>("point", report)?;
            context.points(&[name.into_inner()], report)
        }
        Some("points") => {
            let names = section.optional::<Vec<Spanned<String>>>("points", report)?;
            context.points(names.get_ref(), report)
        }
        Some(_) => {
            flag(section, "all_points", report);
            let free = |point: &usize| locked.iter().all(|(other, _)| other != point);
            let all = (0..context.model.points().len()).filter(free);
            all.map(|point| (point, section.span())).collect()
        }
        None => vec![],
    };
    for (point, span) in &points {
        if let Some((_, lock)) = locked.iter().find(|(other, _)| other == point) {
            let message = format!("the point `{}` is locked", context.attached.name(*point));
            report
                .mistake(span, message, "a variable")
                .also(lock, "locked here")
                .help("take it out of `locked`, or leave this variable out");
        }
    }
    let axes = axes(section, report);
    let before = report.mistakes.len();
    let ranges = by_axis(section, "range", &axes, report);
    let absolute = by_axis(section, "bounds", &axes, report);
    if ranges.is_some() && absolute.is_some() {
        section.clash("range", "bounds", "write how far, or between which values", report);
    }
    let mut entry = Entry {
        found: vec![],
        bounds: vec![],
        span: section.span(),
        explicit: key != Some("all_points"),
    };
    for (point, _) in points {
        for &axis in &axes {
            let start = context.model.points()[point].position[axis];
            let of = |list: &Option<[Option<Spanned<[f64; 2]>>; 3]>| list.as_ref()?[axis].clone();
            let bounds = match (of(&ranges), of(&absolute)) {
                (Some(range), _) => {
                    let ends = context.interval(axis, *range.get_ref());
                    Some((ends.map(|end| start + end), range.span()))
                }
                (None, Some(bounds)) => {
                    Some((context.interval(axis, *bounds.get_ref()), bounds.span()))
                }
                (None, None) => None,
            };
            let far = |bounds: &&([f64; 2], Range<usize>)| {
                bounds.0.iter().any(|end| (end - start).abs() > FARTHEST)
            };
            if let Some((_, span)) = bounds.as_ref().filter(far)
                && report.mistakes.len() == before
            {
                let name = context.attached.name(point);
                let unit = context.model.units.length.symbol();
                report
                    .mistake(span, format!("that is more than a metre from `{name}`"), "too far")
                    .help(format!("lengths are in the unit of the model, {unit}"));
            }
            let name = format!("{}.{}", context.attached.name(point), AXES[axis]);
            entry.found.push((name, Parameter::Coordinate { point, axis }));
            entry.bounds.push(bounds.map(|(bounds, _)| bounds));
        }
    }
    // Where a range is wrong, how far the point may go is not known.
    (report.mistakes.len() == before).then_some(entry)
}

/// The axes of `coordinates`, all without it.
pub(super) fn axes(section: &mut Section, report: &mut Report) -> Vec<usize> {
    let Some(words) = section.optional::<Vec<Spanned<String>>>("coordinates", report) else {
        return vec![0, 1, 2];
    };
    let mut axes = vec![];
    for word in words.get_ref() {
        let Some(axis) = AXES.iter().position(|axis| axis == word.get_ref()) else {
            let message = format!("there is no coordinate `{}`", word.get_ref());
            report
                .mistake(&word.span(), message, "unknown")
                .help("the coordinates are `x`, `y` and `z`");
            continue;
        };
        if axes.contains(&axis) {
            let message = format!("`{}` is named twice", word.get_ref());
            report.mistake(&word.span(), message, "once more").help("name each coordinate once");
        } else {
            axes.push(axis);
        }
    }
    if words.get_ref().is_empty() {
        report
            .mistake(&words.span(), "no coordinate is named", "empty")
            .help("write `coordinates = [\"y\", \"z\"]`, or leave it out for all three");
    }
    axes
}

/// Intervals of the three axes, in the units and axes of the file: one for all, or a table.
fn by_axis(
    section: &mut Section,
    key: &'static str,
    axes: &[usize],
    report: &mut Report,
) -> Option<[Option<Spanned<[f64; 2]>>; 3]> {
    let value = section.value(key)?;
    let what = format!("`{key}`");
    if !value.get_ref().is_table() {
        let found = one(key, value, &what, report);
        return Some([0, 1, 2].map(|_| found.clone()));
    }
    let help = format!("write `{key} = {{ y = [-10.0, 10.0] }}`");
    let mut table = as_section(value, what, &help, report)?;
    let found = AXES.map(|axis| {
        let value = table.value(axis)?;
        one(key, value, &format!("`{key}` of {axis}"), report)
            .map(|read| Spanned::new(value.span(), read.into_inner()))
    });
    for (axis, interval) in found.iter().enumerate() {
        if let (Some(interval), false) = (interval, axes.contains(&axis)) {
            let message = format!("`{}` is none of the `coordinates`", AXES[axis]);
            report
                .mistake(&interval.span(), message, "not a variable")
                .help("add it to `coordinates`, or leave it out here");
        }
    }
    table.not_empty(&help, report);
    table.finish(report);
    Some(found)
}

/// An interval; absolute bounds are two numbers.
fn one(
    key: &str,
    value: &Spanned<DeValue>,
    what: &str,
    report: &mut Report,
) -> Option<Spanned<[f64; 2]>> {
    if key == "bounds" && !value.get_ref().is_array() {
        <[f64; 2]>::read(value, what, report)?;
        return None;
    }
    interval(value, what, report)
}

/// A parameter other than a coordinate.
fn parameter(section: &mut Section, context: &Context, report: &mut Report) -> Option<Entry> {
    let name = section.optional::<String>("parameter", report);
    let help =
        "write `percent = 20.0`, `range = [-5.0, 5.0]` in its unit, or `bounds = [40.0, 80.0]`";
    let key = section.one_of(&["percent", "range", "bounds"], help, report);
    let key = key.and_then(|key| Some((key, section.value(key)?)));
    let ends = key.and_then(|(key, value)| one(key, value, &format!("`{key}`"), report));
    let name = name?;
    let found = named(name.get_ref(), &name.span(), context, report)?;
    let ((key, _), ends) = (key?, ends?.into_inner());
    let bounds = |(_, parameter): &(String, Parameter)| {
        let start = parameter.value(context.model)?;
        let si = |value| context.si(parameter.quantity(context.model), value);
        let bounds = match key {
            "percent" => ends.map(|percent| start + 0.01 * percent * start.abs()),
            "range" => ends.map(|change| start + si(change)),
            _ => ends.map(si),
        };
        (bounds[0] < bounds[1]).then_some(bounds)
    };
    let bounds: Vec<Option<[f64; 2]>> = found.iter().map(bounds).collect();
    if let Some(zero) = bounds.iter().position(Option::is_none) {
        report
            .mistake(&name.span(), format!("`{}` is zero", found[zero].0), "no part of zero")
            .help("write a `range` or `bounds` instead of `percent`");
        return None;
    }
    Some(Entry { found, bounds, span: section.span(), explicit: true })
}
