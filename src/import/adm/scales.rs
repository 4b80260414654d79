//! Units of a dataset, and what its numbers are multiplied by to be in those of the written file.

use super::notes::Notes;
use super::statement::{Statement, in_full};
use crate::model::{ForceUnit, LengthUnit, MassUnit};

/// The units of the written file. Those of the dataset are kept where a file can have them; others
/// become SI units, by a factor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales {
    pub(super) length_unit: LengthUnit,
    pub(super) force_unit: ForceUnit,
    pub(super) mass_unit: MassUnit,
    pub(super) length: f64,
    pub(super) force: f64,
    pub(super) mass: f64,
    /// Seconds.
    pub(super) time: f64,
}

impl Scales {
    const SI: Self = Self {
        length_unit: LengthUnit::Metre,
        force_unit: ForceUnit::Newton,
        mass_unit: MassUnit::Kilogram,
        length: 1.0,
        force: 1.0,
        mass: 1.0,
        time: 1.0,
    };

    /// Force by length.
    pub(super) fn stiffness(&self) -> f64 {
        self.force / self.length
    }

    /// Force by speed.
    pub(super) fn damping(&self) -> f64 {
        self.stiffness() * self.time
    }

    /// Force times length; by angle it is the same, because angles are in radians.
    pub(super) fn torque(&self) -> f64 {
        self.force * self.length
    }

    /// Moment by angular speed.
    pub(super) fn rotational_damping(&self) -> f64 {
        self.torque() * self.time
    }

    /// Mass times length squared.
    pub(super) fn inertia(&self) -> f64 {
        self.mass * self.length * self.length
    }

    /// Length by time.
    pub(super) fn velocity(&self) -> f64 {
        self.length / self.time
    }
}

type Choice<U> = (&'static str, U, f64);

const LENGTHS: &[Choice<LengthUnit>] = &[
    ("METER", LengthUnit::Metre, 1.0),
    ("MILLIMETER", LengthUnit::Millimetre, 1.0),
    ("CENTIMETER", LengthUnit::Centimetre, 1.0),
    ("INCH", LengthUnit::Inch, 1.0),
    ("KILOMETER", LengthUnit::Metre, 1e3),
    ("MICROMETER", LengthUnit::Metre, 1e-6),
    ("FOOT", LengthUnit::Metre, 0.3048),
    ("YARD", LengthUnit::Metre, 0.9144),
    ("MILE", LengthUnit::Metre, 1609.344),
];

const FORCES: &[Choice<ForceUnit>] = &[
    ("NEWTON", ForceUnit::Newton, 1.0),
    ("KNEWTON", ForceUnit::Kilonewton, 1.0),
    ("POUND_FORCE", ForceUnit::PoundForce, 1.0),
    ("KPOUND_FORCE", ForceUnit::PoundForce, 1e3),
    ("OUNCE_FORCE", ForceUnit::PoundForce, 0.0625),
    ("KILOGRAM_FORCE", ForceUnit::Newton, 9.80665),
    ("DYNE", ForceUnit::Newton, 1e-5),
    ("MEGANEWTON", ForceUnit::Kilonewton, 1e3),
    ("CENTINEWTON", ForceUnit::Newton, 1e-2),
    ("MILLINEWTON", ForceUnit::Newton, 1e-3),
    ("POUNDAL", ForceUnit::Newton, 0.138_254_954_376),
];

const MASSES: &[Choice<MassUnit>] = &[
    ("KILOGRAM", MassUnit::Kilogram, 1.0),
    ("GRAM", MassUnit::Gram, 1.0),
    ("TONNE", MassUnit::Tonne, 1.0),
    ("MEGAGRAM", MassUnit::Tonne, 1.0),
    ("POUND_MASS", MassUnit::Pound, 1.0),
    ("KPOUND_MASS", MassUnit::Pound, 1e3),
    ("OUNCE_MASS", MassUnit::Pound, 0.0625),
    ("US_TON", MassUnit::Pound, 2e3),
    // One pound-force times s² by foot and by inch.
    ("SLUG", MassUnit::Pound, 9.80665 / 0.3048),
    ("SLINCH", MassUnit::Pound, 9.80665 / 0.0254),
    ("MILLIGRAM", MassUnit::Gram, 1e-3),
];

const TIMES: &[Choice<()>] = &[
    ("SECOND", (), 1.0),
    ("MILLISECOND", (), 1e-3),
    ("MILLISECONDS", (), 1e-3),
    ("MICROSECOND", (), 1e-6),
    ("MINUTE", (), 60.0),
    ("HOUR", (), 3600.0),
    ("DAY", (), 86400.0),
];

pub(super) const KEYS: &[&str] = &["FORCE", "LENGTH", "MASS", "TIME", "SYSTEM", "UCF"];

/// Units of length, force, mass and time that have a name together.
const SYSTEMS: &[(&str, [&str; 4])] = &[
    ("MKS", ["METER", "NEWTON", "KILOGRAM", "SECOND"]),
    ("CGS", ["CENTIMETER", "DYNE", "GRAM", "SECOND"]),
    ("FPS", ["FOOT", "POUND_FORCE", "POUND_MASS", "SECOND"]),
    ("IPS", ["INCH", "POUND_FORCE", "POUND_MASS", "SECOND"]),
];

/// Reads the UNITS statement.
pub(super) fn read(statements: &mut [Statement], notes: &mut Notes) -> Scales {
    let mut all = statements.iter_mut().filter(|statement| statement.keyword == "UNITS");
    let Some(statement) = all.next() else {
        let help = "write the units that its numbers are in, such as UNITS/FORCE=NEWTON, MASS=KILOGRAM, LENGTH=MILLIMETER, TIME=SECOND";
        notes.mistake(1, "the dataset names no UNITS", help);
        return Scales::SI;
    };
    statement.know(KEYS);
    if let Some(second) = all.next() {
        notes.mistake(second.line, "there is a second UNITS statement", "keep one of them");
    }
    let statement = &*statement;
    if let Some((line, _)) = statement.text("UCF") {
        let help = "write FORCE, MASS, LENGTH and TIME instead of the factor";
        notes.mistake(line, "units by a consistency factor (UCF) have no name", help);
    }
    let words: Vec<&str> = SYSTEMS.iter().map(|(word, _)| *word).collect();
    let system = statement.text("SYSTEM").and_then(|(line, text)| {
        let word = in_full(&text.to_ascii_uppercase(), &words);
        if word.is_none() {
            let what = format!("there is no system of units {text}");
            notes.mistake(line, what, format!("the choices are {}", words.join(", ")));
        }
        SYSTEMS.iter().find(|(name, _)| Some(*name) == word).map(|(_, units)| *units)
    });
    let system = system.unwrap_or([""; 4]);
    let (length_unit, length) =
        unit(statement, "LENGTH", system[0], LENGTHS, notes).unwrap_or((LengthUnit::Metre, 1.0));
    let (force_unit, force) =
        unit(statement, "FORCE", system[1], FORCES, notes).unwrap_or((ForceUnit::Newton, 1.0));
    let (mass_unit, mass) =
        unit(statement, "MASS", system[2], MASSES, notes).unwrap_or((MassUnit::Kilogram, 1.0));
    let ((), time) = unit(statement, "TIME", system[3], TIMES, notes).unwrap_or(((), 1.0));
    Scales { length_unit, force_unit, mass_unit, length, force, mass, time }
}

fn unit<U: Copy>(
    statement: &Statement,
    key: &str,
    default: &str,
    choices: &[Choice<U>],
    notes: &mut Notes,
) -> Option<(U, f64)> {
    let (line, text) = statement.text(key).unwrap_or((statement.line, default));
    let words: Vec<&str> = choices.iter().map(|(word, ..)| *word).collect();
    let found = in_full(&text.trim().to_ascii_uppercase(), &words);
    let choice = choices.iter().find(|(word, ..)| Some(*word) == found);
    if choice.is_none() {
        let what = match text {
            "" => format!("UNITS lacks {key}"),
            text => format!("hardpoint does not know the unit {key} = {text}"),
        };
        notes.mistake(line, what, format!("the choices are {}", words.join(", ")));
    }
    choice.map(|(_, unit, factor)| (*unit, *factor))
}
