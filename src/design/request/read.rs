//! What the parts of a request are read with.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::attached::Attached;
use crate::model::read::{FromToml, Section, as_section};
use crate::model::{Model, Quantity, Report, suggest};

/// Nothing of a suspension goes farther than this (m).
pub(super) const FARTHEST: f64 = 1.0;

/// The names of the axes.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// The model that a request is about.
pub(super) struct Context<'a> {
    pub(super) model: &'a Model,
    /// Which parts of the suspension have which points.
    pub(super) attached: Attached,
}

impl<'a> Context<'a> {
    pub(super) fn new(model: &'a Model) -> Self {
        Self { model, attached: Attached::of(model) }
    }

    /// A number in SI.
    pub(super) fn si(&self, quantity: Quantity, value: f64) -> f64 {
        quantity.to_si(self.model.units, value)
    }

    /// +1 or −1: how a coordinate of the model's axes counts in ISO 8855 axes.
    pub(super) fn sign(&self, axis: usize) -> f64 {
        self.model.axes.signs()[axis]
    }

    /// An interval along an axis of the model, in SI and ISO 8855 axes.
    pub(super) fn interval(&self, axis: usize, interval: [f64; 2]) -> [f64; 2] {
        let ends = interval.map(|end| self.sign(axis) * self.si(Quantity::Length, end) + 0.0);
        if ends[0] <= ends[1] { ends } else { [ends[1], ends[0]] }
    }

    /// The place among the points of the model of the one of this name.
    pub(super) fn point(&self, name: &Spanned<String>, report: &mut Report) -> Option<usize> {
        let word = name.get_ref();
        let points = self.model.points();
        let found = points.iter().position(|point| point.name == *word);
        if found.is_none() {
            let known: Vec<&str> = points.iter().map(|point| point.name.as_str()).collect();
            report
                .mistake(&name.span(), format!("the model has no point `{word}`"), "unknown point")
                .help(suggest::choices(word, &known));
        }
        found
    }

    /// The points of these names, each once.
    pub(super) fn points(
        &self,
        names: &[Spanned<String>],
        report: &mut Report,
    ) -> Vec<(usize, Range<usize>)> {
        let mut points: Vec<(usize, Range<usize>)> = vec![];
        for name in names {
            let Some(point) = self.point(name, report) else { continue };
            if let Some((_, first)) = points.iter().find(|(other, _)| *other == point) {
                report
                    .mistake(
                        &name.span(),
                        format!("`{}` is named twice", name.get_ref()),
                        "once more",
                    )
                    .also(first, "first here")
                    .help("name each point once");
                continue;
            }
            points.push((point, name.span()));
        }
        points
    }

    /// A length that is above zero.
    pub(super) fn length(
        &self,
        section: &mut Section,
        key: &'static str,
        report: &mut Report,
    ) -> Option<f64> {
        let length = positive(section, key, report)?;
        self.near(&length, &format!("`{key}`"), report)
    }

    /// A length (SI) that is not absurd.
    pub(super) fn near(
        &self,
        length: &Spanned<f64>,
        what: &str,
        report: &mut Report,
    ) -> Option<f64> {
        let value = self.si(Quantity::Length, *length.get_ref());
        if value.abs() <= FARTHEST {
            return Some(value);
        }
        let unit = self.model.units.length.symbol();
        report
            .mistake(&length.span(), format!("{what} is more than a metre"), "too far")
            .help(format!("lengths are in the unit of the model, {unit}"));
        None
    }
}

/// A number above zero that may be absent.
pub(super) fn positive(
    section: &mut Section,
    key: &'static str,
    report: &mut Report,
) -> Option<Spanned<f64>> {
    let number = section.optional::<f64>(key, report)?;
    if *number.get_ref() > 0.0 {
        return Some(number);
    }
    report
        .mistake(&number.span(), format!("`{key}` must be above zero"), "not positive")
        .help(format!("write a positive number, or leave out `{key}`"));
    None
}

/// A whole number between limits that may be absent.
pub(super) fn whole(
    section: &mut Section,
    key: &'static str,
    [least, most]: [u32; 2],
    report: &mut Report,
) -> Option<Spanned<u32>> {
    let number = section.optional::<f64>(key, report)?;
    let value = *number.get_ref();
    if value.fract() == 0.0 && (f64::from(least)..=f64::from(most)).contains(&value) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // It has been checked.
        return Some(Spanned::new(number.span(), value as u32));
    }
    let message = format!("`{key}` must be a whole number from {least} to {most}");
    let help = format!("write a whole number such as `{key} = {}`", most.min(least.max(11)));
    report.mistake(&number.span(), message, "not such a number").help(help);
    None
}

/// A flag that is true where it is written.
pub(super) fn flag(section: &mut Section, key: &'static str, report: &mut Report) -> bool {
    let Some(flag) = section.optional::<bool>(key, report) else { return false };
    if !flag.get_ref() {
        report
            .mistake(&flag.span(), format!("`{key}` is true where it is written"), "false")
            .help(format!("write `{key} = true`, or leave it out"));
    }
    true
}

/// The sections of a list `[[key]]`, in the order of the file.
pub(super) fn sections<'t>(
    root: &mut Section<'t>,
    key: &'static str,
    report: &mut Report,
) -> Vec<Section<'t>> {
    let Some(value) = root.value(key) else { return vec![] };
    let Some(list) = value.get_ref().as_array() else {
        report
            .mistake(
                &value.span(),
                format!("`{key}` must be a list of sections"),
                "a single section",
            )
            .help(format!("write `[[{key}]]` in double brackets, one for each"));
        return vec![];
    };
    let help = format!("write `[[{key}]]` sections with `key = value` lines");
    let read = |value| as_section(value, format!("[[{key}]]"), &help, report);
    list.iter().filter_map(read).collect()
}

/// An interval: two numbers of which the first is less, or one number for that much to both sides.
pub(super) fn interval(
    value: &Spanned<DeValue>,
    what: &str,
    report: &mut Report,
) -> Option<Spanned<[f64; 2]>> {
    let span = value.span();
    let interval = if value.get_ref().is_array() {
        <[f64; 2]>::read(value, what, report)?
    } else {
        let size = f64::read(value, what, report)?;
        [-size, size]
    };
    if interval[0] < interval[1] {
        return Some(Spanned::new(span, interval));
    }
    report
        .mistake(&span, format!("{what} must begin below its end"), "not increasing")
        .help("write the least and the greatest value, such as `[-10.0, 10.0]`");
    None
}
