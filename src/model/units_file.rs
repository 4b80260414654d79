//! The `[units]` section, and numbers that are written in its units.

use std::cell::Cell;
use std::ops::Range;

use toml::Spanned;

use super::diagnostics::Report;
use super::quantity::Quantity;
use super::read::Section;
use super::suggest;
use super::units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, Units};

/// The `[units]` section as written. A unit of force or mass may be absent until a number needs it.
pub(crate) struct UnitsFile {
    span: Range<usize>,
    pub(crate) length: Option<Spanned<LengthUnit>>,
    angle: Option<AngleUnit>,
    force: Unit<ForceUnit>,
    mass: Unit<MassUnit>,
}

/// A unit that only some files need.
struct Unit<T> {
    value: Option<T>,
    /// Whether it is known to be missing or wrong, which is noted once.
    noted: Cell<bool>,
}

impl UnitsFile {
    pub(crate) fn read(root: &mut Section, report: &mut Report) -> Self {
        let help = "add a section `[units]` with `length = \"mm\"` and `angle = \"deg\"`";
        let Some(mut section) = root.section("units", help, report) else {
            return Self::absent();
        };
        let length = section.choice("length", "unit of length", LengthUnit::CHOICES, "", report);
        let angle = section.choice("angle", "unit of angle", AngleUnit::CHOICES, "", report);
        let force = unit(&mut section, "force", ForceUnit::CHOICES, report);
        let mass = unit(&mut section, "mass", MassUnit::CHOICES, report);
        let span = section.span();
        section.finish(report);
        Self { span, length, angle: angle.map(Spanned::into_inner), force, mass }
    }

    /// No units: for files without numbers, and for those whose section has been found missing.
    pub(crate) fn absent() -> Self {
        Self {
            span: 0..0,
            length: None,
            angle: None,
            force: Unit { value: None, noted: Cell::new(true) },
            mass: Unit { value: None, noted: Cell::new(true) },
        }
    }

    /// The units, where those are given that every file needs.
    pub(crate) fn units(&self) -> Option<Units> {
        self.length.as_ref().and(self.angle).map(|_| self.or_si())
    }

    /// The unit of angle.
    pub(crate) fn angle(&self) -> Option<AngleUnit> {
        self.angle
    }

    /// A number in SI. Notes a unit that it needs and the file does not name.
    pub(crate) fn to_si(
        &self,
        quantity: Quantity,
        value: f64,
        place: &Range<usize>,
        report: &mut Report,
    ) -> f64 {
        if quantity.has_force() && self.force.is_missing() {
            self.note_missing("force", ForceUnit::CHOICES, "N", place, report);
        }
        if quantity.has_mass() && self.mass.is_missing() {
            self.note_missing("mass", MassUnit::CHOICES, "kg", place, report);
        }
        quantity.to_si(self.or_si(), value)
    }

    /// SI units stand in for missing ones, so that reading can go on after a mistake.
    fn or_si(&self) -> Units {
        Units {
            length: self.length.as_ref().map_or(LengthUnit::Metre, |unit| *unit.get_ref()),
            angle: self.angle.unwrap_or(AngleUnit::Radian),
            force: self.force.value.unwrap_or(ForceUnit::Newton),
            mass: self.mass.value.unwrap_or(MassUnit::Kilogram),
        }
    }

    fn note_missing<T>(
        &self,
        key: &str,
        choices: &[(&str, T)],
        example: &str,
        place: &Range<usize>,
        report: &mut Report,
    ) {
        let symbols: Vec<&str> = choices.iter().map(|(symbol, _)| *symbol).collect();
        report
            .mistake(place, format!("[units] lacks `{key}`, a unit of {key}"), "needs it")
            .also(&self.span, "in this section")
            .help(format!(
                "add `{key} = \"{example}\"` to [units]; the choices are {}",
                suggest::listed(&symbols)
            ));
    }
}

impl<T: Copy> Unit<T> {
    /// Whether the unit is missing and that has not been noted; it counts as noted then.
    fn is_missing(&self) -> bool {
        self.value.is_none() && !self.noted.replace(true)
    }
}

fn unit<T: Copy>(
    section: &mut Section,
    key: &'static str,
    choices: &[(&str, T)],
    report: &mut Report,
) -> Unit<T> {
    let given = section.has(key);
    let choices: Vec<(&str, Option<T>)> =
        choices.iter().map(|(s, unit)| (*s, Some(*unit))).collect();
    let value = section.choice_or(key, &format!("unit of {key}"), &choices, None, report);
    Unit { value: value.flatten(), noted: Cell::new(given) }
}
