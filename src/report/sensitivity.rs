//! Derivatives of factors by parameters: a ranking for people, CSV and JSON for programs.

use std::io;

use serde_json::{Value, json};

use super::csv::of_the_writer;
use super::rounded;
use super::table::{cell, five_digits, write_aligned};
use crate::design::{EventSensitivities, Parameter, Sensitivity};
use crate::factors::Convention;
use crate::model::{Axes, Drive, Quantity, Side, Units};

/// Derivatives at one state or along an event, and all that is needed to show them.
#[derive(Clone, Copy)]
pub struct SensitivityReport<'a> {
    /// Name of the model.
    pub name: &'a str,
    /// The sides of the vehicle: one of a corner, left and right of an axle.
    pub sides: &'a [Side],
    /// Axes of the report.
    pub axes: Axes,
    /// Units of the report.
    pub units: Units,
    /// Which height a travel means.
    pub drive: Drive,
    /// By whose definitions.
    pub convention: Convention,
    /// The parameters.
    pub parameters: &'a [Parameter],
    /// The name of the event and what its values are; `None` for one state.
    pub event: Option<(&'a str, Quantity)>,
    /// The states.
    pub result: &'a EventSensitivities,
    /// How many parameters a table shows of each factor.
    pub top: usize,
}

/// A change of a factor below this part of its largest one is rounding, or the factor does not depend on the parameter.
const NOTHING: f64 = 1e-12;

impl SensitivityReport<'_> {
    /// The rows of the factors, which all states have alike.
    fn rows(&self) -> &[Sensitivity] {
        self.result.states.first().map_or(&[], |state| &state.found.rows)
    }

    /// The name of a row, with the side before it where both wheels have one.
    fn name(&self, row: &Sensitivity) -> String {
        match (self.sides.len() > 1, row.factor.is_of_axle()) {
            (true, false) => format!("{}_{}", row.side.name(), row.factor.name),
            _ => row.factor.name.to_owned(),
        }
    }

    fn symbol(&self, row: &Sensitivity) -> String {
        row.factor.quantity.symbol(self.units)
    }

    fn derivative(&self, row: &Sensitivity, parameter: usize) -> Option<f64> {
        let shown = |by| {
            let parameter = &self.parameters[parameter];
            rounded(parameter.show(self.units, row.factor.quantity, by))
        };
        row.by.get(parameter).copied().flatten().map(shown)
    }

    fn value(&self, row: &Sensitivity) -> Option<f64> {
        row.value.map(|value| rounded(row.factor.quantity.show(self.units, value)))
    }

    /// The value of the event at a state.
    fn at(&self, value: f64) -> Option<f64> {
        self.event.map(|(_, quantity)| rounded(quantity.show(self.units, value)))
    }

    /// The unit of the values of the event.
    fn event_unit(&self) -> String {
        self.event.map_or_else(String::new, |(_, quantity)| quantity.symbol(self.units))
    }

    /// The parameters that change a row, those that change it most first, each with the state that has its largest
    /// derivative.
    fn ranking(&self, row: usize) -> Vec<(usize, usize)> {
        let states = &self.result.states;
        let effect = |parameter: usize, state: usize| {
            let by = states[state].found.rows[row].by.get(parameter).copied().flatten();
            by.map_or(0.0, |by| (by * self.parameters[parameter].step).abs())
        };
        let mut ranking: Vec<(f64, usize, usize)> = (0..self.parameters.len())
            .filter_map(|parameter| {
                let of = |state| (effect(parameter, state), parameter, state);
                (0..states.len()).map(of).max_by(|a, b| a.0.total_cmp(&b.0))
            })
            .collect();
        ranking.sort_by(|a, b| b.0.total_cmp(&a.0));
        let value = states.iter().filter_map(|state| state.found.rows[row].value);
        let size = value.fold(1e-3, |size: f64, value| size.max(value.abs()));
        let largest = ranking.first().map_or(0.0, |first| first.0).max(1e-3 * size);
        let changes = ranking.into_iter().take_while(|(effect, ..)| *effect > NOTHING * largest);
        changes.map(|(_, parameter, state)| (parameter, state)).collect()
    }

    /// Writes a ranking for each factor: the parameters that change it most, with unit and sign rule.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_table(&self, mut writer: impl io::Write) -> io::Result<()> {
        let what = match self.sides {
            [side] => format!("{} side", side.name()),
            _ => "axle, both sides changed alike".to_owned(),
        };
        let (axes, convention) = (self.axes.name(), self.convention.name());
        writeln!(writer, "{}, {what}, {axes} axes, definitions of {convention}", self.name)?;
        self.write_state(&mut writer)?;
        for (k, row) in self.rows().iter().enumerate() {
            self.write_ranking(&mut writer, k, row)?;
        }
        let refused = self.refused();
        if !refused.is_empty() {
            writeln!(writer, "\nNo derivatives by these parameters")?;
        }
        for (name, why) in refused {
            writeln!(writer, "  {name}: {why}")?;
        }
        writeln!(
            writer,
            "\nEach parameter changes alone. What stays: all other points, static toe and camber, masses, laws."
        )
    }

    fn write_state(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let Some(first) = self.result.states.first() else {
            return writeln!(writer, "no state was reached");
        };
        let symbol = self.units.length.symbol();
        let length = |metres| cell(Some(self.units.length.from_metres(metres)));
        if let Some((event, _)) = self.event {
            let last = self.result.states.last().unwrap_or(first);
            let [from, to] = [first, last].map(|state| cell(self.at(state.value)));
            let (states, unit) = (self.result.states.len(), self.event_unit());
            return writeln!(writer, "{event} from {from} to {to} {unit}, {states} states");
        }
        let travels: Vec<String> = first.travels.iter().map(|&travel| length(travel)).collect();
        let (travels, rack) = (travels.join(" and "), length(first.rack));
        let drive = self.drive.words();
        writeln!(writer, "travel {travels} {symbol} of the {drive}, rack {rack} {symbol}")
    }

    fn write_ranking(
        &self,
        writer: &mut impl io::Write,
        row: usize,
        first: &Sensitivity,
    ) -> io::Result<()> {
        let unit = self.symbol(first);
        let sign = first.factor.by(self.convention).sign;
        write!(writer, "\n{}", self.name(first))?;
        if self.event.is_none() {
            write!(writer, " {}", cell(self.value(first)))?;
        }
        writeln!(writer, " {unit}: {}; {sign}", first.factor.title)?;
        let ranking = self.ranking(row);
        if ranking.is_empty() {
            let why = match self.result.states.iter().all(|s| s.found.rows[row].value.is_none()) {
                true => "it is not defined here",
                false => "no parameter changes it here",
            };
            return writeln!(writer, "  {why}");
        }
        let mut lines = vec![];
        for (rank, &(parameter, worst)) in ranking.iter().take(self.top).enumerate() {
            let its = &self.parameters[parameter];
            let at = |state: usize| {
                let row = &self.result.states[state].found.rows[row];
                self.derivative(row, parameter).map_or_else(|| "–".to_owned(), five_digits)
            };
            let mut line = vec![(rank + 1).to_string(), its.name.clone()];
            match self.event {
                None => {
                    let row = &self.result.states[worst].found.rows[row];
                    let by = row.by[parameter].unwrap_or(f64::NAN);
                    let effect = row.factor.quantity.show(self.units, by * its.step);
                    let step = rounded(its.quantity.show(self.units, its.step));
                    let of = its.quantity.symbol(self.units);
                    let of = if of == "1" { String::new() } else { format!(" {of}") };
                    line.push(at(worst));
                    line.push(its.unit(self.units, row.factor.quantity));
                    line.push(format!("{} {unit} for {step}{of}", five_digits(effect)));
                }
                Some(_) => {
                    let value = self.result.states[worst].value;
                    let last = self.result.states.len() - 1;
                    line.extend([at(0), at(last), at(worst)]);
                    line.push(cell(self.at(value)));
                    line.push(its.unit(self.units, first.factor.quantity));
                }
            }
            line.push(its.sign.to_owned());
            lines.push(line);
        }
        let head = match self.event {
            None => vec!["", "parameter", "derivative", "unit", "change", "sign"],
            Some(_) => vec!["", "parameter", "first", "last", "largest", "at", "unit", "sign"],
        };
        lines.insert(0, head.into_iter().map(str::to_owned).collect());
        write_aligned(writer, &lines, if self.event.is_none() { 2..3 } else { 2..6 })?;
        match ranking.len().checked_sub(self.top) {
            Some(more @ 1..) => writeln!(writer, "      and {more} more; --top shows them"),
            _ => Ok(()),
        }
    }

    /// Writes the matrix of one state, a row for each parameter and a column for each factor, or in an event one line for
    /// each state, factor and parameter; to 15 significant digits, without a number where there is none.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_csv(&self, writer: impl io::Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        let mut record = |fields: Vec<String>| csv.write_record(fields).map_err(of_the_writer);
        let number = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
        if let Some((event, quantity)) = self.event {
            let head = quantity.column(&event.replace(' ', "_"), self.units);
            let rest = ["factor", "value", "unit", "parameter", "derivative", "derivative_unit"];
            record([vec![head], rest.map(str::to_owned).to_vec()].concat())?;
            for state in &self.result.states {
                for row in &state.found.rows {
                    for (k, parameter) in self.parameters.iter().enumerate() {
                        record(vec![
                            number(self.at(state.value)),
                            self.name(row),
                            number(self.value(row)),
                            self.symbol(row),
                            parameter.name.clone(),
                            number(self.derivative(row, k)),
                            parameter.unit(self.units, row.factor.quantity),
                        ])?;
                    }
                }
            }
        } else {
            let rows = self.rows();
            let names =
                rows.iter().map(|row| row.factor.quantity.column(&self.name(row), self.units));
            record(["parameter".into(), "per".into()].into_iter().chain(names).collect())?;
            for (k, parameter) in self.parameters.iter().enumerate() {
                let by = rows.iter().map(|row| number(self.derivative(row, k)));
                let per = parameter.quantity.symbol(self.units);
                record([parameter.name.clone(), per].into_iter().chain(by).collect())?;
            }
        }
        csv.flush()
    }

    /// Writes one object to 15 significant digits; what is not defined is null.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, &self.json())?;
        writeln!(writer)
    }

    fn json(&self) -> Value {
        let units = self.units;
        let length = |metres: f64| rounded(units.length.from_metres(metres));
        let parameter = |parameter: &Parameter| {
            json!({
                "name": parameter.name,
                "unit": parameter.quantity.symbol(units),
                "sign": parameter.sign,
                "compared_by": rounded(parameter.quantity.show(units, parameter.step)),
            })
        };
        let factor = |row: &Sensitivity| {
            let definition = row.factor.by(self.convention);
            json!({
                "name": self.name(row),
                "factor": row.factor.name,
                "side": (!row.factor.is_of_axle()).then(|| row.side.name()),
                "title": row.factor.title,
                "unit": self.symbol(row),
                "sign": definition.sign,
                "formula": definition.formula,
                "source": definition.source,
                "derivative_units": self
                    .parameters
                    .iter()
                    .map(|parameter| parameter.unit(units, row.factor.quantity))
                    .collect::<Vec<_>>(),
            })
        };
        let derivatives = |row: &Sensitivity| -> Vec<Option<f64>> {
            (0..self.parameters.len()).map(|k| self.derivative(row, k)).collect()
        };
        let states = self.result.states.iter().map(|state| {
            let rows = &state.found.rows;
            json!({
                "event_value": self.at(state.value),
                "travel": state.travels.iter().map(|&travel| length(travel)).collect::<Vec<_>>(),
                "rack": length(state.rack),
                "values": rows.iter().map(|row| self.value(row)).collect::<Vec<_>>(),
                "derivatives": rows.iter().map(derivatives).collect::<Vec<_>>(),
            })
        });
        let refused = self.refused().into_iter();
        let without =
            self.result.without.iter().map(
                |(value, why)| json!({ "event_value": self.at(*value), "why": why.to_string() }),
            );
        json!({
            "model": self.name,
            "side": match self.sides {
                [side] => side.name(),
                _ => "both",
            },
            "axes": self.axes.name(),
            "convention": self.convention.name(),
            "drive": self.drive.name(),
            "length_unit": units.length.symbol(),
            "event": self.event.map(|(name, _)| name),
            "event_unit": self.event.map(|_| self.event_unit()),
            "states_planned": self.result.planned,
            "stops": self.result.stops.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "parameters": self.parameters.iter().map(parameter).collect::<Vec<_>>(),
            "factors": self.rows().iter().map(factor).collect::<Vec<_>>(),
            "refused": refused
                .map(|(name, why)| json!({ "parameter": name, "why": why }))
                .collect::<Vec<_>>(),
            "without_derivatives": without.collect::<Vec<_>>(),
            "states": states.collect::<Vec<_>>(),
        })
    }

    /// The parameters by which some state has no derivative, each with the first reason.
    fn refused(&self) -> Vec<(&str, &str)> {
        let mut list: Vec<(&str, &str)> = vec![];
        for (name, why) in self.result.states.iter().flat_map(|state| &state.found.refused) {
            if list.iter().all(|(known, _)| known != name) {
                list.push((name, why));
            }
        }
        list
    }
}

/// Writes the parameters of a model with unit and sign rule.
///
/// # Errors
/// What the writer says.
pub fn write_parameters(
    mut writer: impl io::Write,
    units: Units,
    parameters: &[Parameter],
) -> io::Result<()> {
    let line = |parameter: &Parameter| {
        let unit = parameter.quantity.symbol(units);
        vec![parameter.name.clone(), unit, parameter.sign.to_owned()]
    };
    let head = ["parameter", "unit", "sign"].map(str::to_owned).to_vec();
    let lines: Vec<Vec<String>> = [head].into_iter().chain(parameters.iter().map(line)).collect();
    write_aligned(&mut writer, &lines, 0..0)
}
