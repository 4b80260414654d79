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
    /// The state: one wheel of a corner, left and right of an axle.
    pub poses: &'a [Pose<f64>],
    /// What the adjusters of the model are set to.
    pub adjustments: &'a [Adjustment],
}

impl FactorSheet<'_> {
    /// The factors that the suspension has, whether or not they are defined at this state.
    fn shown(&self) -> impl Iterator<Item = &'static Factor> {
        let has = |pose: &Pose<f64>, factor: &Factor| {
            factor.applies(pose) && factor.missing(pose).next().is_none()
        };
        FACTORS.iter().filter(move |factor| self.poses.iter().any(|pose| has(pose, factor)))
    }

    /// What the suspension lacks, and the factors that need it.
    fn lacking(&self) -> Vec<(Vec<Need>, Vec<&'static str>)> {
        let mut groups: Vec<(Vec<Need>, Vec<&'static str>)> = vec![];
        for factor in FACTORS {
            let of = |pose: &Pose<f64>| factor.missing(pose).collect::<Vec<Need>>();
            let poses = self.poses.iter().filter(|pose| factor.applies(pose));
            let Some(missing) = poses.map(of).min_by_key(Vec::len) else { continue };
            match groups.iter_mut().find(|(needs, _)| *needs == missing) {
                _ if missing.is_empty() => {}
                Some((_, names)) => names.push(factor.name),
                None => groups.push((missing, vec![factor.name])),
            }
        }
        groups
    }

    /// The wheels for which a factor is shown: one where the axle has it.
    fn wheels(&self, factor: &Factor) -> &[Pose<f64>] {
        if factor.is_of_axle() { &self.poses[..1] } else { self.poses }
    }

    fn value(&self, factor: &Factor, pose: &Pose<f64>) -> Option<f64> {
        factor.show_by(self.convention, self.units, pose).map(rounded)
    }

    /// The side of a value, where there are two.
    fn side(&self, factor: &Factor, pose: &Pose<f64>) -> Option<&'static str> {
        (self.wheels(factor).len() > 1).then(|| pose.side.name())
    }

    /// Which wheels, for a heading.
    fn what(&self) -> String {
        match self.poses {
            [pose] => format!("{} side", pose.side.name()),
            _ => "axle".to_owned(),
        }
    }

    /// Writes the factors grouped by subject, with unit and sign rule; an undefined one is a dash.
    /// An axle has two columns of values, left and right, and one value in the first where
    /// both wheels have it together.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_table(&self, mut writer: impl io::Write) -> io::Result<()> {
        let Self { name, units, .. } = *self;
        let Some(first) = self.poses.first() else { return Ok(()) };
        let (what, axes, convention) = (self.what(), first.axes.name(), self.convention.name());
        writeln!(writer, "{name}, {what}, {axes} axes, definitions of {convention}")?;
        let length = |metres| cell(Some(units.length.from_metres(metres)));
        let travels: Vec<String> = self.poses.iter().map(|pose| length(pose.travel)).collect();
        writeln!(
            writer,
            "travel {} {symbol} of the {}, rack {} {symbol}",
            travels.join(" and "),
            self.drive.words(),
            length(first.rack),
            symbol = units.length.symbol()
        )?;
        adjustments::write_adjustments(&mut writer, units, self.adjustments)?;
        let width = self.shown().map(|factor| factor.name.len()).max().unwrap_or(0);
        let symbol = |factor: &Factor| factor.quantity.symbol(units);
        let unit_width =
            self.shown().map(|factor| symbol(factor).chars().count()).max().unwrap_or(0);
        for subject in Subject::ALL {
            let mut factors = self.shown().filter(|factor| factor.subject == subject).peekable();
            if factors.peek().is_some() {
                writeln!(writer, "\n{}", subject.title())?;
            }
            for factor in factors {
                let value = |pose| format!("{:>13}", cell(self.value(factor, pose)));
                let mut values: Vec<String> = self.wheels(factor).iter().map(value).collect();
                values.resize(self.poses.len(), " ".repeat(13));
                let unit = symbol(factor);
                let (name, title, values) = (factor.name, factor.title, values.join(" "));
                let sign = factor.by(self.convention).sign;
                writeln!(writer, "  {name:<width$} {values} {unit:<unit_width$} {title}; {sign}")?;
            }
        }
        let lacking = self.lacking();
        if !lacking.is_empty() {
            writeln!(writer, "\nNot shown, because something is lacking")?;
        }
        for (needs, names) in lacking {
            writeln!(writer, "  {}: add {}", names.join(", "), words(&needs))?;
        }
        Ok(())
    }

    /// Writes one line for each value, to 15 significant digits; an undefined value is empty. Of an
    /// axle the names begin with the side, as the columns of sweeps.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_csv(&self, writer: impl io::Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        let mut record =
            |fields: [&str; 7]| csv.write_record(fields).map_err(super::csv::of_the_writer);
        record(["name", "value", "unit", "title", "sign", "formula", "source"])?;
        for factor in self.shown() {
            let Definition { sign, formula, source, .. } = factor.by(self.convention);
            let unit = factor.quantity.symbol(self.units);
            for pose in self.wheels(factor) {
                let value = self.value(factor, pose).map_or_else(String::new, |v| v.to_string());
                let name = match self.side(factor, pose) {
                    Some(side) => format!("{side}_{}", factor.name),
                    None => factor.name.to_owned(),
                };
                record([&name, &value, &unit, factor.title, sign, formula, source])?;
            }
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
        let units = self.units;
        let factor = |factor: &'static Factor| {
            let Definition { sign, formula, source, .. } = factor.by(self.convention);
            let value = match self.wheels(factor) {
                [pose] => json!(self.value(factor, pose)),
                wheels => {
                    let of = |pose: &Pose<f64>| {
                        (pose.side.name().to_owned(), json!(self.value(factor, pose)))
                    };
                    Value::Object(wheels.iter().map(of).collect())
                }
            };
            json!({
                "name": factor.name,
                "subject": factor.subject.title(),
                "title": factor.title,
                "symbol": factor.symbol,
                "value": value,
                "unit": factor.quantity.symbol(units),
                "sign": sign,
                "formula": formula,
                "source": source,
            })
        };
        let lacking = |(needs, names): (Vec<Need>, Vec<&str>)| json!({ "factors": names, "need": words(&needs) });
        let travel = |pose: &Pose<f64>| json!(rounded(units.length.from_metres(pose.travel)));
        let first = self.poses.first();
        json!({
            "model": self.name,
            "side": match self.poses {
                [pose] => pose.side.name(),
                _ => "both",
            },
            "axes": first.map(|pose| pose.axes.name()),
            "convention": self.convention.name(),
            "drive": self.drive.name(),
            "travel": match self.poses {
                [pose] => travel(pose),
                poses => poses.iter().map(travel).collect(),
            },
            "rack": first.map(|pose| rounded(units.length.from_metres(pose.rack))),
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
Units are those of a model in mm, deg and N; in every model gradients are per metre, compliances per kN or
per kN·m, roll rates in N·m by angle, and dive and its like per g of 9.80665 m/s².

| symbol | meaning |
|---|---|
| σ | +1 for a left wheel, −1 for a right one |
| W, P | wheel centre; contact patch, the lowest point of the disc of radius R |
| s, k | unit spin axis, outboard; unit steer axis, upward |
| e_h, e_l | unit horizontal directions in and across the plane of the wheel: forward, outboard |
| G, H | the steer axis on the ground, z = P_z, and at the height of the wheel centre |
| v_W, v_P, ω | velocities of the wheel's body at W and at P and its angular velocity, per unit travel of W, the rack held |
| L, h, β, κ | wheelbase, height of the centre of gravity, shares of braking and driving of the axle, from `[vehicle]` |
| m, m_s, m_u | mass of the vehicle; sprung and unsprung mass of one wheel, from `[vehicle]` |
| T | track, the distance of both contact patches |
| C_ij | compliance matrix of `hardpoint compliance`: displacement i by the unit load j, 1 to 6 (x, y, z, about x, about y, about z) at the left wheel centre, 7 to 12 at the right one |
| CP_ij | the same at the contact patches, points of the wheels' bodies at the loaded radius |
| K_t, R_l | rate of the tyre, loaded radius: R − deflection of the tyre under its load; R without a tyre |

Velocities come from the factorised constraints, without differences. Where joints determine the
position, springs play no part in them; else, as with bushings, they follow the states of
equilibrium. The virtual steer axis is the screw axis of the wheel's body when the rack moves: with the
height of the wheel centre held (`vk_`), or with the length of the spring held (`vks_`, as Adams/Car).

Elastic factors come from the compliance matrix of the state, in which the wheels are let go, the rack is
held and what held the wheels stays on as a dead load. They are written here for the left wheel; of a
corner, which is alone, C17, C39 and their like are zero. Angles are exact slopes of toe and camber, where the formulas
of other programs take C6j for toe and C4j for camber; `--convention adams` does so too, in Adams' axes (x rearward, y
right, z up) and with its numbers. Lateral forces count inboard and aligning torques towards toe-in, so
that both wheels of a symmetric axle have the same numbers. For a rigid suspension on springs elastic factors are the
kinematic ones.

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
        "`--convention` follows another program where it defines otherwise: rows marked *adams* or *lotus*."
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
            let rows = [
                (Some(factor.by(Convention::Iso)), ""),
                (factor.adams, ", *adams*"),
                (factor.lotus, ", *lotus*"),
            ];
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
