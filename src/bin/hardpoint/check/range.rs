//! `hardpoint check --range`: the working range.

use std::io::{self, Write};

use hardpoint::model::{LengthUnit, Model, Setup};
use hardpoint::programme::{Clearance, Fastest, Place, Ranges, StageError, WorkingRange};
use hardpoint::rig::{Danger, NEARLY_DEAD, Warning};

use super::Check;
use crate::failure::Failure;
use crate::loads::FARTHEST;
use crate::output::Output;

/// Links nearer than this (m) are told.
const NEAR: f64 = 0.03;

/// At least so many pairs of links are listed.
const LISTED: usize = 8;

/// Width of the place of a clearance.
const PLACE: usize = 31;

/// Below this ratio nothing but the wheel moves.
const STILL: f64 = 1e-6;

impl Check {
    /// Goes through the working range of both sides and tells what was found.
    pub(super) fn working_range(&self, model: &Model, range: Option<f64>) -> Result<(), Failure> {
        let ranges = Ranges::of(model);
        let length = |name: &str, value: f64| {
            let metres = model.units.length.to_metres(value);
            match metres > 0.0 && metres < FARTHEST {
                true => Ok(metres),
                false => Err(Failure::Usage(format!("{name} is not a positive length"))),
            }
        };
        let travel = range.map_or(Ok(ranges.travel), |travel| length("--range", travel))?;
        let asked = self.clearance.map_or(Ok(NEAR), |asked| length("--clearance", asked))?;
        let racks = match model.steers() {
            true => vec![0.0, -ranges.rack, ranges.rack],
            false => vec![0.0],
        };
        let found = WorkingRange::find(model, &Setup::default(), travel, &racks);
        let found = found.map_err(|error| match error {
            StageError::Rig(error) => {
                Failure::Rig(self.model.display().to_string(), Box::new(error))
            }
            error => Failure::Usage(error.to_string()),
        })?;
        let page = Page { model, travel, asked };
        Output::Stdout.write(|writer| page.write(writer, &found))
    }
}

/// What was asked for.
struct Page<'a> {
    model: &'a Model,
    travel: f64,
    asked: f64,
}

impl Page<'_> {
    fn write(&self, writer: &mut dyn Write, found: &WorkingRange) -> io::Result<()> {
        let WorkingRange { states, stops, fastest, warnings, clearances } = found;
        let travel = self.length(self.travel);
        writeln!(writer, "\nworking range, both wheels ±{travel}: {states} states reached")?;
        for (at, stop) in stops {
            let stop = stop.to_string();
            writeln!(writer, "  ends before {}: {}", self.place(at), stop.trim_end())?;
        }
        match fastest.as_ref().filter(|fastest| fastest.ratio > STILL) {
            Some(Fastest { body, point, ratio, at }) => {
                let near = match *ratio > NEARLY_DEAD {
                    true => "; this is near to a dead centre: move its points or shorten the range",
                    false => "; far from a dead centre",
                };
                writeln!(
                    writer,
                    "  fastest joint: {point} of {body} goes {ratio:.2} times as far as the wheel at {}{near}",
                    self.place(at)
                )?;
            }
            None => writeln!(writer, "  how the joints move with the wheel is not determined")?,
        }
        let others =
            warnings.iter().filter(|warning| !matches!(warning.danger, Danger::Fast { .. }));
        for Warning { danger, side, from, to } in others {
            let (side, from, to) = (side.name(), self.place(from), self.place(to));
            writeln!(writer, "  {side} wheel, from {from} to {to}: {danger}")?;
        }
        self.write_clearances(writer, clearances)
    }

    /// Those that are nearer than asked, and the nearest of the others.
    fn write_clearances(&self, writer: &mut dyn Write, all: &[Clearance]) -> io::Result<()> {
        let asked = self.length(self.asked);
        let near = all.iter().filter(|clearance| clearance.distance < self.asked).count();
        let what = match near {
            0 => "no two links come".to_owned(),
            1 => "two links come".to_owned(),
            _ => format!("{near} pairs of links come"),
        };
        writeln!(writer, "  {what} nearer than {asked} (middle lines)")?;
        if all.is_empty() {
            return Ok(());
        }
        let listed = &all[..all.len().min(near.max(LISTED))];
        let names = |clearance: &Clearance| clearance.links.join(" – ");
        let width =
            listed.iter().map(|clearance| names(clearance).chars().count()).max().unwrap_or(0);
        writeln!(
            writer,
            "\nsmallest distances of middle lines, {} of {} pairs:",
            listed.len(),
            all.len()
        )?;
        for clearance in listed {
            let place = self.place(&clearance.at);
            let distance = self.length(clearance.distance);
            let (distance, remark) = match clearance {
                Clearance { crosses: true, .. } => {
                    ("–".to_owned(), "  they cross before: one would cut the other")
                }
                _ if clearance.distance < self.asked => (distance, "  nearer than asked"),
                _ => (distance, ""),
            };
            let line =
                format!("  {distance:>10}  {:<width$}  {place:<PLACE$}{remark}", names(clearance));
            writeln!(writer, "{}", line.trim_end())?;
        }
        Ok(())
    }

    fn length(&self, metres: f64) -> String {
        let unit = self.model.units.length;
        // To a tenth of a millimetre.
        let digits = match unit {
            LengthUnit::Millimetre => 1,
            LengthUnit::Centimetre => 2,
            LengthUnit::Inch => 3,
            LengthUnit::Metre => 4,
        };
        format!("{:.digits$} {}", unit.from_metres(metres), unit.symbol())
    }

    fn place(&self, at: &Place) -> String {
        match self.model.steers() {
            true => format!("travel {}, rack {}", self.length(at.travel), self.length(at.rack)),
            false => format!("travel {}", self.length(at.travel)),
        }
    }
}
