//! Tables for people.

use std::io;

use super::super::table::{cell, cell_to};
use super::words::{event_name, quantity, wanted};
use super::{SynthesisReport, has_one_value, mean};
use crate::design::request::{Target, short};
use crate::design::synthesis::TradeOff;
use crate::model::Quantity;

/// Decimals of coordinates, as in the new file.
const DECIMALS: usize = 6;

/// A limit that costs less costs nothing: all targets are met.
const NO_COST: f64 = 1e-6;

impl SynthesisReport<'_> {
    /// Writes the verdict, targets before and after, what changed and what holds the design.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_table(&self, mut writer: impl io::Write) -> io::Result<()> {
        let writer = &mut writer;
        let (model, axes) = (self.model, self.model.axes.name());
        let what = match self.request.needs_axle(model) {
            true => "axle".to_owned(),
            false => format!("{} side", model.side.name()),
        };
        write!(writer, "{}, {what}, {axes} axes", model.name)?;
        match &self.request.name {
            Some(name) => writeln!(writer, ": {name}")?,
            None => writeln!(writer)?,
        }
        writeln!(writer, "travel is that of the {}", self.drive.words())?;
        write!(writer, "\n{}", self.verdict_words())?;
        self.write_single(writer)?;
        self.write_curves(writer)?;
        self.write_meanings(writer)?;
        self.write_changes(writer)?;
        self.write_holding(writer)?;
        self.write_trade_off(writer)?;
        self.write_spread(writer)?;
        self.write_search(writer)
    }

    /// The targets of one kind with their places.
    fn targets(&self, single: bool) -> Vec<(usize, &Target)> {
        let targets = self.request.targets.iter().enumerate();
        targets.filter(|(_, target)| has_one_value(target) == single).collect()
    }

    /// Whether a target is met, for the end of a line.
    fn mark(&self, index: usize) -> String {
        let hard = if self.request.targets[index].hard { "hard" } else { "" };
        let met = self.is_met(index).map_or("", |met| if met { "met" } else { "missed" });
        let words: Vec<&str> = [met, hard].into_iter().filter(|word| !word.is_empty()).collect();
        words.join(", ")
    }

    /// Targets that have one value.
    fn write_single(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let units = self.model.units;
        let rows = self.targets(true).into_iter().map(|(index, target)| {
            let show = |values: Option<&[Option<f64>]>| {
                cell(values.and_then(mean).map(|value| target.show(units, value)))
            };
            let tolerance = cell(Some(target.show(units, target.tolerance)));
            vec![
                self.title(target),
                target.unit(units),
                show(Some(&self.before[index])),
                wanted(target, units),
                show(self.after(index)),
                tolerance,
                self.mark(index),
            ]
        });
        let heads = ["Targets", "unit", "before", "wanted", "after", "tolerance", ""];
        aligned(writer, heads, &rows.collect::<Vec<_>>())
    }

    /// Targets at several states: how far they are off.
    fn write_curves(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let units = self.model.units;
        let rows = self.targets(false).into_iter().map(|(index, target)| {
            let show = |value: f64| cell(Some(target.show(units, value)));
            let off = |values: Option<&[Option<f64>]>| {
                let spread = values.and_then(|values| self.spread(index, values));
                spread.map_or(["–".to_owned(), "–".to_owned()], |spread| {
                    [show(spread.largest), show(spread.rms)]
                })
            };
            let ([before, rms_before], [after, rms_after]) =
                (off(Some(&self.before[index])), off(self.after(index)));
            vec![
                self.title(target),
                target.unit(units),
                wanted(target, units),
                before,
                after,
                rms_before,
                rms_after,
                show(target.tolerance),
                self.mark(index),
            ]
        });
        let heads = [
            "Differences from what is wanted",
            "unit",
            "wanted",
            "largest before",
            "after",
            "rms before",
            "after",
            "tolerance",
            "",
        ];
        aligned(writer, heads, &rows.collect::<Vec<_>>())
    }

    /// What the factors are and what their signs mean.
    fn write_meanings(&self, writer: &mut impl io::Write) -> io::Result<()> {
        writeln!(writer)?;
        let mut told: Vec<(&str, &str)> = vec![];
        for target in &self.request.targets {
            let (factor, sign) = (target.factor, target.factor.by(target.convention).sign);
            if told.contains(&(factor.name, sign)) {
                continue;
            }
            told.push((factor.name, sign));
            let (name, unit) = (factor.name, target.unit(self.model.units));
            writeln!(writer, "{name} [{unit}] {}; {sign}", factor.title)?;
        }
        Ok(())
    }

    /// What has changed, and how far each point has moved.
    fn write_changes(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let units = self.model.units;
        let mut rows = vec![];
        let mut unchanged = vec![];
        for (index, variable) in self.request.variables.iter().enumerate() {
            let (before, Some(after)) = self.variable(index) else { return Ok(()) };
            if after == before {
                unchanged.push(variable.name.as_str());
                continue;
            }
            let quantity = variable.parameter.quantity(self.model);
            let show = |value: f64| cell_to(Some(quantity.show(units, value)), DECIMALS);
            let change = show(after - before);
            let (name, unit) = (variable.name.clone(), quantity.symbol(units));
            rows.push(vec![name, unit, show(before), show(after), change]);
        }
        aligned(writer, ["What changed", "unit", "before", "after", "change"], &rows)?;
        if !unchanged.is_empty() {
            writeln!(writer, "\nNot changed: {}", unchanged.join(", "))?;
        }
        let moved = self.moved();
        let length = |value: f64| cell_to(Some(Quantity::Length.show(units, value)), DECIMALS);
        let symbol = || units.length.symbol().to_owned();
        let row = |name: &str, value| vec![name.to_owned(), symbol(), length(value)];
        let mut rows: Vec<_> = moved.iter().map(|point| row(point.name, point.distance)).collect();
        if rows.len() > 1 {
            let together = moved.iter().map(|point| point.distance.powi(2)).sum::<f64>().sqrt();
            rows.push(row("all together, root of the sum of squares", together));
        }
        aligned(writer, ["Points moved", "unit", "distance"], &rows)
    }

    /// Bounds and limits on which the design lies.
    fn write_holding(&self, writer: &mut impl io::Write) -> io::Result<()> {
        if self.design.is_none() || self.found.held.is_empty() {
            return Ok(());
        }
        let row = |held: &crate::design::synthesis::Held| {
            let cost = if held.cost < NO_COST { "0".to_owned() } else { short(held.cost) };
            vec![held.name.clone(), cost]
        };
        let rows: Vec<_> = self.found.held.iter().map(row).collect();
        aligned(writer, ["Bounds and limits that hold the design", "cost"], &rows)?;
        writeln!(
            writer,
            "\ncost: by about how much half the sum of squares of weighted differences in tolerances would fall if \
             the limit were wider: a\nbound by a quarter of its range, a distance by 1 mm, a hard target by its \
             tolerance, an angle by 1°, a movement by half"
        )
    }

    /// The designs between two targets.
    fn write_trade_off(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let Some(pareto) = self.request.pareto.filter(|_| !self.found.trade_off.is_empty()) else {
            return Ok(());
        };
        let units = self.model.units;
        let targets = pareto.targets.map(|target| &self.request.targets[target]);
        let mean_of = |design: &TradeOff, k: usize| {
            let value = mean(&design.factors[pareto.targets[k]]);
            cell(value.map(|value| targets[k].show(units, value)))
        };
        let rows = self.found.trade_off.iter().enumerate().map(|(number, design)| {
            let mut row = vec![(number + 1).to_string()];
            for k in 0..2 {
                row.extend([mean_of(design, k), cell(Some(design.off[k]))]);
            }
            row
        });
        let heads = targets.map(|target| format!("{} [{}]", target.name, target.unit(units)));
        let heads = ["Trade-off", &heads[0], "off", &heads[1], "off"];
        aligned(writer, heads, &rows.collect::<Vec<_>>())?;
        writeln!(
            writer,
            "\noff: root of the mean square of differences in tolerances, times the weight; of what is to be small or \
             great its mean in tolerances,\nless being better; values over a range are means; --format json has the \
             coordinates of each design"
        )
    }

    /// How factors spread under tolerances.
    fn write_spread(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let Some(robustness) = self.request.robustness.as_ref() else { return Ok(()) };
        let units = self.model.units;
        let rows = self.found.spread.iter().map(|spread| {
            let target = &self.request.targets[spread.target];
            let show = |value: Option<f64>| cell(value.map(|value| target.show(units, value)));
            let title = match target.event.zip(target.states[spread.state].value) {
                None => self.title(target),
                Some((event, value)) => {
                    let (name, quantity) = (event_name(event), quantity(event));
                    let value = short(quantity.show(units, value));
                    format!("{} at {name} {value} {}", target.name, quantity.symbol(units))
                }
            };
            let values = [Some(spread.before), Some(spread.after), spread.sampled].map(show);
            let mut row = vec![title, target.unit(units)];
            row.extend(values);
            row
        });
        let heads = ["Standard deviation under tolerances", "unit", "before", "after", "sampled"];
        aligned(writer, heads, &rows.collect::<Vec<_>>())?;
        writeln!(
            writer,
            "\nbefore, after: to first order; sampled: of {} random designs around the new one; a tolerance is three \
             standard deviations",
            robustness.samples
        )
    }

    /// How the design was sought, and where it is.
    fn write_search(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let found = self.found;
        let plural = |count: usize, what: &str| match count {
            1 => format!("1 {what}"),
            count => format!("{count} {what}s"),
        };
        writeln!(
            writer,
            "\nsought from {}; {} of the best one, {} evaluated",
            plural(found.starts, "start"),
            plural(found.iterations, "iteration"),
            plural(found.evaluations, "design")
        )?;
        match self.file {
            Some(file) => writeln!(writer, "the new model is in {file}"),
            None => writeln!(writer, "no model is written"),
        }
    }
}

/// Writes rows aligned under their heads, the first column to the left; nothing without rows.
fn aligned<const N: usize>(
    writer: &mut impl io::Write,
    heads: [&str; N],
    rows: &[Vec<String>],
) -> io::Result<()> {
    if rows.is_empty() {
        return Ok(());
    }
    let widths: Vec<usize> = (0..N)
        .map(|k| {
            let cells = rows.iter().map(|row| row[k].chars().count());
            cells.chain([heads[k].chars().count()]).max().unwrap_or(0)
        })
        .collect();
    let heads: Vec<String> = heads.iter().map(|head| (*head).to_owned()).collect();
    writeln!(writer)?;
    for row in std::iter::once(&heads).chain(rows) {
        let mut line = format!("{:<width$}", row[0], width = widths[0]);
        for (k, (field, width)) in row.iter().zip(&widths).enumerate().skip(1) {
            line += "  ";
            // Words that end a line begin together.
            line += &match k + 1 == N && N > 5 {
                true => field.clone(),
                false => format!("{field:>width$}"),
            };
        }
        writeln!(writer, "{}", line.trim_end())?;
    }
    Ok(())
}
