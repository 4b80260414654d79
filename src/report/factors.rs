//! The factors of one state, and the definitions of all.

use std::io;

use serde_json::{Value, json};

use super::table::cell;
use super::{adjustments, rounded};
use crate::factors::{
    Convention, Definition, FACTORS, FARTHEST, Factor, NEARLY_PARALLEL, Need, Subject,
};
use crate::model::{AngleUnit, Drive, ForceUnit, LengthUnit, MassUnit, Units};
use crate::rig::{Adjustment, Pose};

/// The factors of one state and all that is needed to show them.
#[derive(Clone, Copy)]
pub struct FactorSheet<'a> {
    /// Name of the model.
    pub name: &'a str,
    /// Units of the report.
    pub units: Units,
    /// Which height the travel means.
    pub drive: Drive,
    /// By whose definitions.
    pub convention: Convention,
    /// The state.
    pub pose: &'a Pose<f64>,
    /// What the adjusters of the model are set to.
    pub adjustments: &'a [Adjustment],
}

impl FactorSheet<'_> {
    /// The factors that the corner has, whether or not they are defined at this state.
    fn shown(&self) -> impl Iterator<Item = &'static Factor> {
        let has = |factor: &&Factor| {
            factor.applies(self.pose) && factor.missing(self.pose).next().is_none()
        };
        FACTORS.iter().filter(has)
    }

    /// What the corner lacks, and the factors that need it.
    fn lacking(&self) -> Vec<(Vec<Need>, Vec<&'static str>)> {
        let mut groups: Vec<(Vec<Need>, Vec<&'static str>)> = vec![];
        for factor in FACTORS.iter().filter(|factor| factor.applies(self.pose)) {
            let missing: Vec<Need> = factor.missing(self.pose).collect();
            match groups.iter_mut().find(|(needs, _)| *needs == missing) {
                _ if missing.is_empty() => {}
                Some((_, names)) => names.push(factor.name),
                None => groups.push((missing, vec![factor.name])),
            }
        }
        groups
    }

    fn value(&self, factor: &Factor) -> Option<f64> {
        factor.show_by(self.convention, self.units, self.pose).map(rounded)
    }

    /// Writes the factors grouped by subject, with unit and sign rule; an undefined one is a dash.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_table(&self, mut writer: impl io::Write) -> io::Result<()> {
        let Self { name, units, pose, .. } = *self;
        let (side, axes) = (pose.side.name(), pose.axes.name());
        let convention = self.convention.name();
        writeln!(writer, "{name}, {side} side, {axes} axes, definitions of {convention}")?;
        let length = |metres| cell(Some(units.length.from_metres(metres)));
        writeln!(
            writer,
            "travel {} {symbol} of the {}, rack {} {symbol}",
            length(pose.travel),
            self.drive.words(),
            length(pose.rack),
            symbol = units.length.symbol()
        )?;
        adjustments::write_adjustments(&mut writer, units, self.adjustments)?;
        let width = self.shown().map(|factor| factor.name.len()).max().unwrap_or(0);
        for subject in Subject::ALL {
            let mut factors = self.shown().filter(|factor| factor.subject == subject).peekable();
            if factors.peek().is_some() {
                writeln!(writer, "\n{}", subject.title())?;
            }
            for factor in factors {
                let value = cell(self.value(factor));
                let unit = factor.quantity.symbol(units);
                let (name, title) = (factor.name, factor.title);
                let sign = factor.by(self.convention).sign;
                writeln!(writer, "  {name:<width$} {value:>13} {unit:<6} {title}; {sign}")?;
            }
        }
        let lacking = self.lacking();
        if !lacking.is_empty() {
            writeln!(writer, "\nNot shown, because the model lacks something")?;
        }
        for (needs, names) in lacking {
            writeln!(writer, "  {}: add {}", names.join(", "), words(&needs))?;
        }
        Ok(())
    }

    /// Writes one line for each factor, to 15 significant digits; an undefined value is empty.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_csv(&self, writer: impl io::Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        let mut record =
            |fields: [&str; 7]| csv.write_record(fields).map_err(super::csv::of_the_writer);
        record(["name", "value", "unit", "title", "sign", "formula", "source"])?;
        for factor in self.shown() {
            let value = self.value(factor).map_or_else(String::new, |value| value.to_string());
            let Definition { sign, formula, source, .. } = factor.by(self.convention);
            let unit = factor.quantity.symbol(self.units);
            record([factor.name, &value, &unit, factor.title, sign, formula, source])?;
        }
        for adjustment in self.adjustments {
            let value = adjustments::shown(self.units, adjustment).to_string();
            let formula = match adjustment.sets {
                Some(factor) => format!("set for {factor}"),
                None => "as the model has it".to_owned(),
            };
            let (unit, Adjustment { name, title, sign, .. }) =
                (self.units.length.symbol(), adjustment);
            record([name, &value, unit, title, sign, &formula, "[adjusters]"])?;
        }
        csv.flush()
    }

    /// Writes one object to 15 significant digits; an undefined value is null.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, &self.json())?;
        writeln!(writer)
    }

    fn json(&self) -> Value {
        let Self { units, pose, .. } = *self;
        let factor = |factor: &'static Factor| {
            let Definition { sign, formula, source, .. } = factor.by(self.convention);
            json!({
                "name": factor.name,
                "subject": factor.subject.title(),
                "title": factor.title,
                "symbol": factor.symbol,
                "value": self.value(factor),
                "unit": factor.quantity.symbol(units),
                "sign": sign,
                "formula": formula,
                "source": source,
            })
        };
        let lacking = |(needs, names): (Vec<Need>, Vec<&str>)| json!({ "factors": names, "need": words(&needs) });
        json!({
            "model": self.name,
            "side": pose.side.name(),
            "axes": pose.axes.name(),
            "convention": self.convention.name(),
            "drive": self.drive.name(),
            "travel": rounded(units.length.from_metres(pose.travel)),
            "rack": rounded(units.length.from_metres(pose.rack)),
            "length_unit": units.length.symbol(),
            "adjustments": adjustments::json(units, self.adjustments),
            "factors": self.shown().map(factor).collect::<Vec<_>>(),
            "not_shown": self.lacking().into_iter().map(lacking).collect::<Vec<_>>(),
        })
    }
}

/// What to add, one after the other.
pub(super) fn words(needs: &[Need]) -> String {
    needs.iter().map(|need| need.words()).collect::<Vec<_>>().join(" and ")
}

const PREAMBLE: &str = "\
# Static design factors

Made by `hardpoint factors --list` from the one table in `src/factors/`. `hardpoint factors MODEL` shows
all that a corner has at one state, `hardpoint sweep MODEL --columns toe,rc_height` any of
them along an event.

Formulas are in ISO 8855 axes: x forward, y left, z up. Components are shown in the model's axes.
Units are those of a model in mm, deg and N; gradients are per metre in every model.

| symbol | meaning |
|---|---|
| σ | +1 for a left wheel, −1 for a right one |
| W, P | wheel centre; contact patch, the lowest point of the disc of radius R |
| s, k | unit spin axis, outboard; unit steer axis, upward |
| e_h, e_l | unit horizontal directions in and across the plane of the wheel: forward, outboard |
| G, H | the steer axis on the ground, z = P_z, and at the height of the wheel centre |
| v_W, v_P, ω | velocities of the wheel's body at W and at P and its angular velocity, per unit travel of W, the rack held |
| L, h, β, κ | wheelbase, height of the centre of gravity, shares of braking and driving of the axle, from `[vehicle]` |

Velocities come from the factorised constraints, without differences. Where joints determine the
position, springs play no part in them; else, as with bushings, they follow the states of
equilibrium. The virtual steer axis is the screw axis of the wheel's body when the rack moves: with the
height of the wheel centre held (`vk_`), or with the length of the spring held (`vks_`, as Adams/Car).

A factor has no value, shown as –, where it is not defined:";

/// Writes the definitions of all factors as Markdown; `docs/factors.md` is this text.
///
/// # Errors
/// What the writer says.
pub fn write_definitions(mut writer: impl io::Write) -> io::Result<()> {
    let units = Units {
        length: LengthUnit::Millimetre,
        angle: AngleUnit::Degree,
        force: ForceUnit::Newton,
        mass: MassUnit::Kilogram,
    };
    writeln!(writer, "{PREAMBLE}")?;
    writeln!(
        writer,
        "an instant centre or a screw axis more than {FARTHEST} m from the wheel is at infinity, and so\n\
         is a roll centre as high; a ratio, a slope or a gradient above {NEARLY_PARALLEL} has no denominator: a\n\
         steer axis within a milliradian of the horizontal does not meet the ground.\n"
    )?;
    writeln!(
        writer,
        "`--convention` follows another program where it defines otherwise: rows marked *lotus*. Adams/Car\n\
         defines all of these factors as ISO 8855 does."
    )?;
    for subject in Subject::ALL {
        writeln!(writer, "\n## {}\n", subject.title())?;
        writeln!(writer, "| name | factor | symbol | unit | sign | definition | source | needs |")?;
        writeln!(writer, "|---|---|---|---|---|---|---|---|")?;
        for factor in FACTORS.iter().filter(|factor| factor.subject == subject) {
            let Factor { name, title, symbol, quantity, .. } = *factor;
            let unit = quantity.symbol(units);
            let needs: Vec<&str> = factor.needs.iter().map(|need| need.label()).collect();
            let needs = needs.join(", ");
            let rows = [(Some(factor.by(Convention::Iso)), ""), (factor.lotus, ", *lotus*")];
            for (definition, mark) in rows {
                let Some(Definition { sign, formula, source, .. }) = definition else { continue };
                writeln!(
                    writer,
                    "| `{name}`{mark} | {title} | {symbol} | {unit} | {sign} | {formula} | {source} | {needs} |"
                )?;
            }
        }
    }
    Ok(())
}
