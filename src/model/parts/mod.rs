//! The parts that suspensions and mechanisms are made of: joints, drivers, force elements, masses.
//!
//! They are read into SI units and the axes inside; the names of bodies and points become numbers.

mod bushing;
mod drivers;
mod forces;
mod joints;
mod law;
mod line;
mod markers;
mod masses;
mod places;
mod torsion;
mod tyre;

use toml::Spanned;

use super::axes::Axes;
use super::diagnostics::Report;
use super::names::Names;
use super::quantity::Quantity;
use super::read::{FromToml, Section, as_section};
use super::units_file::UnitsFile;
pub(crate) use joints::{Y, joint_points};
pub use markers::Marker;
pub(crate) use masses::{gravity, gravity_vector};
pub use tyre::TyreContact;
pub(crate) use tyre::TyreFile;

/// What parts of a file refer to.
pub(crate) struct Parts<'a> {
    pub(crate) names: &'a Names,
    pub(crate) units: &'a UnitsFile,
    pub(crate) axes: Axes,
    /// Whether directions may be vectors and joints may have lengths. Those of an architecture, which has
    /// neither units nor axes, follow from its points.
    pub(crate) own_numbers: bool,
}

impl Parts<'_> {
    /// A number in SI that must be there; `help` says what to write.
    pub(crate) fn number(
        &self,
        section: &mut Section,
        key: &'static str,
        quantity: Quantity,
        help: &str,
        report: &mut Report,
    ) -> Option<Spanned<f64>> {
        let number = section.required(key, help, report)?;
        Some(self.in_si(&number, quantity, report))
    }

    /// A number in SI that may be absent.
    pub(crate) fn optional_number(
        &self,
        section: &mut Section,
        key: &'static str,
        quantity: Quantity,
        report: &mut Report,
    ) -> Option<Spanned<f64>> {
        let number = section.optional(key, report)?;
        Some(self.in_si(&number, quantity, report))
    }

    fn in_si(
        &self,
        number: &Spanned<f64>,
        quantity: Quantity,
        report: &mut Report,
    ) -> Spanned<f64> {
        let span = number.span();
        let value = self.units.to_si(quantity, *number.get_ref(), &span, report);
        Spanned::new(span, value)
    }

    /// Numbers of one kind in SI.
    pub(crate) fn all_in_si<const N: usize>(
        &self,
        numbers: &Spanned<[f64; N]>,
        quantity: Quantity,
        report: &mut Report,
    ) -> [f64; N] {
        let span = numbers.span();
        numbers.get_ref().map(|number| self.units.to_si(quantity, number, &span, report))
    }

    /// A vector in SI and the axes inside.
    pub(crate) fn vector(
        &self,
        numbers: &Spanned<[f64; 3]>,
        quantity: Quantity,
        report: &mut Report,
    ) -> [f64; 3] {
        self.axes.to_iso(self.all_in_si(numbers, quantity, report))
    }
}

/// Notes a number below zero and returns it otherwise.
fn not_negative(number: &Spanned<f64>, what: &str, help: &str, report: &mut Report) -> Option<f64> {
    if *number.get_ref() >= 0.0 {
        return Some(*number.get_ref());
    }
    report.mistake(&number.span(), format!("{what} is below zero"), "negative").help(help);
    None
}

/// Reads a list of sections `[[key]]` that have names, in the order of the file; `None` stands for
/// one with a mistake. `example` is a name.
pub(crate) fn named_sections<'t, T>(
    root: &mut Section<'t>,
    key: &'static str,
    example: &str,
    report: &mut Report,
    mut read: impl FnMut(Section<'t>, &str, &mut Report) -> Option<T>,
) -> Vec<(Spanned<String>, Option<T>)> {
    let mut parts: Vec<(Spanned<String>, Option<T>)> = vec![];
    let one = key.trim_end_matches('s');
    let Some(value) = root.value(key) else {
        return parts;
    };
    let Some(list) = value.get_ref().as_array() else {
        report
            .mistake(
                &value.span(),
                format!("`{key}` must be a list of sections"),
                "a single section",
            )
            .help(format!("write `[[{key}]]` in double brackets, one for each {one}"));
        return parts;
    };
    for value in list.iter() {
        let help = format!("write one `[[{key}]]` section for each {one}");
        let Some(mut section) = as_section(value, format!("[[{key}]]"), &help, report) else {
            continue;
        };
        let help = format!("give the {one} a name for messages: `name = \"{example}\"`");
        let Some(name) = section.required::<String>("name", &help, report) else {
            section.finish_open(report);
            continue;
        };
        let mut taken = false;
        if let Some((first, _)) = parts.iter().find(|(n, _)| n.get_ref() == name.get_ref()) {
            let message = format!("there are two {key} named `{}`", name.get_ref());
            report
                .mistake(&name.span(), message, "taken")
                .also(&first.span(), format!("by this {one}"))
                .help("give one of them another name");
            taken = true;
        }
        let part = read(section, name.get_ref(), report);
        parts.push((name, part.filter(|_| !taken)));
    }
    parts
}

/// A point in the units and axes of the file.
pub(crate) struct PointFile {
    pub(crate) name: Spanned<String>,
    /// `None` for coordinates with a mistake.
    pub(crate) position: Option<Spanned<[f64; 3]>>,
}

/// The points of a section `[points]`.
pub(crate) fn read_points(section: &Section, report: &mut Report) -> Vec<PointFile> {
    let mut points = vec![];
    for (name, value) in section.entries() {
        let what = format!("the point `{}`", name.get_ref());
        let position = <[f64; 3]>::read(value, &what, report);
        let position = position.map(|position| Spanned::new(value.span(), position));
        points.push(PointFile { name, position });
    }
    points
}

/// Names stand in messages and in the headers of tables, so they must be visible words.
pub(crate) fn check_name(name: &Spanned<String>, report: &mut Report) {
    let word = name.get_ref();
    if word.is_empty() || word.contains(|c: char| c.is_whitespace() || c.is_control()) {
        report
            .mistake(&name.span(), "a name must be one word", "not one word")
            .help("join the words with `_`, as in `lca_front`");
    }
}
