//! JSON with all points of curves.

use std::io;

use serde_json::{Value, json};

use super::super::rounded;
use super::words::{event_name, quantity};
use super::{Spread, SynthesisReport};
use crate::design::request::{Goal, Target};
use crate::design::synthesis::{Deviation, TradeOff, Verdict};
use crate::model::Quantity;

impl SynthesisReport<'_> {
    /// Writes one object to 15 significant digits; what has no value is null.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, &self.json())?;
        writeln!(writer)
    }

    fn json(&self) -> Value {
        let (model, request) = (self.model, self.request);
        let length = |value: f64| rounded(Quantity::Length.show(model.units, value));
        let moved = self.moved();
        let points: Vec<Value> = moved
            .iter()
            .map(|point| json!({ "name": point.name, "distance": length(point.distance) }))
            .collect();
        let together = moved.iter().map(|point| point.distance.powi(2)).sum::<f64>().sqrt();
        let held = self.found.held.iter();
        let held: Vec<Value> =
            held.map(|held| json!({ "name": held.name, "cost": held.cost })).collect();
        json!({
            "model": model.name,
            "request": request.name,
            "axes": model.axes.name(),
            "side": if request.needs_axle(model) { "both" } else { model.side.name() },
            "drive": self.drive.name(),
            "length_unit": model.units.length.symbol(),
            "verdict": self.verdict_json(),
            "targets": request.targets.iter().enumerate().map(|(k, t)| self.target(k, t)).collect::<Vec<_>>(),
            "variables": (0..request.variables.len()).map(|k| self.variable_json(k)).collect::<Vec<_>>(),
            "points": points,
            "total_movement": length(together),
            "held_by": held,
            "trade_off": self.found.trade_off.iter().map(|design| self.trade_off(design)).collect::<Vec<_>>(),
            "spread": self.found.spread.iter().map(|spread| self.deviation(spread)).collect::<Vec<_>>(),
            "search": {
                "starts": self.found.starts,
                "iterations": self.found.iterations,
                "evaluations": self.found.evaluations,
            },
            "file": self.file,
        })
    }

    fn verdict_json(&self) -> Value {
        let kind = match self.verdict {
            Verdict::Met => "met",
            Verdict::Compromise { .. } => "compromise",
            Verdict::Conflict { .. } => "conflict",
            Verdict::Unreachable { .. } => "unreachable",
            Verdict::Unfinished { .. } => "unfinished",
        };
        let unmet = match self.verdict {
            Verdict::Compromise { unmet } => &unmet[..],
            _ => &[],
        };
        let unmet = unmet.iter().map(|unmet| {
            let target = &self.request.targets[unmet.target];
            json!({
                "target": target.name,
                "off": rounded(target.show(self.model.units, unmet.off)),
                "tolerances": rounded(unmet.tolerances),
            })
        });
        let between = match self.verdict {
            Verdict::Conflict { between } => &between[..],
            _ => &[],
        };
        let broken = match self.verdict {
            Verdict::Unfinished { broken } => &broken[..],
            _ => &[],
        };
        json!({
            "kind": kind,
            "words": self.verdict_words(),
            "unmet": unmet.collect::<Vec<_>>(),
            "between": between,
            "broken": broken,
        })
    }

    /// A design between two targets.
    fn trade_off(&self, design: &TradeOff) -> Value {
        let units = self.model.units;
        let targets = self.request.targets.iter().zip(&design.factors).zip(0..);
        let targets = targets.map(|((target, values), index)| {
            let pareto = self.request.pareto.iter().flat_map(|pareto| pareto.targets);
            let off = pareto.zip(design.off).find(|(target, _)| *target == index);
            let show = |value: &Option<f64>| value.map(|value| rounded(target.show(units, value)));
            json!({
                "name": target.name,
                "unit": target.unit(units),
                "off": off.map(|(_, off)| rounded(off)),
                "values": values.iter().map(show).collect::<Vec<_>>(),
            })
        });
        let variables = self.request.variables.iter().zip(&design.values);
        let variables = variables.map(|(variable, value)| {
            let quantity = variable.parameter.quantity(self.model);
            let sign = variable.parameter.axis().map_or(1.0, |axis| self.model.axes.signs()[axis]);
            json!({
                "name": variable.name,
                "unit": quantity.symbol(units),
                "value": rounded(quantity.show(units, sign * value)),
            })
        });
        json!({
            "targets": targets.collect::<Vec<_>>(),
            "variables": variables.collect::<Vec<_>>(),
        })
    }

    /// How a factor spreads under tolerances.
    fn deviation(&self, spread: &Deviation) -> Value {
        let (target, units) = (&self.request.targets[spread.target], self.model.units);
        let show = |value: f64| rounded(target.show(units, value));
        let at = target.event.zip(target.states[spread.state].value);
        json!({
            "target": target.name,
            "unit": target.unit(units),
            "at": at.map(|(event, value)| rounded(quantity(event).show(units, value))),
            "before": show(spread.before),
            "after": show(spread.after),
            "sampled": spread.sampled.map(show),
        })
    }

    fn target(&self, index: usize, target: &Target) -> Value {
        let units = self.model.units;
        let show = |value: f64| rounded(target.show(units, value));
        let spread = |values: Option<&[Option<f64>]>| {
            let found = values.and_then(|values| self.spread(index, values));
            found.map(
                |Spread { largest, rms }| json!({ "largest": show(largest), "rms": show(rms) }),
            )
        };
        let (goal, band) = match &target.goal {
            Goal::Values(_) => ("value", [None; 2]),
            Goal::Band { min, max } => ("band", [*min, *max]),
            Goal::Hold => ("hold", [None; 2]),
            Goal::Minimise => ("minimise", [None; 2]),
            Goal::Maximise => ("maximise", [None; 2]),
        };
        let definition = target.factor.by(target.convention);
        json!({
            "name": target.name,
            "factor": target.factor.name,
            "title": target.factor.title,
            "unit": target.unit(units),
            "sign": definition.sign,
            "formula": definition.formula,
            "convention": target.convention.name(),
            "side": target.side.name(),
            "goal": goal,
            "min": band[0].map(show),
            "max": band[1].map(show),
            "hard": target.hard,
            "weight": target.weight,
            "tolerance": show(target.tolerance),
            "met": self.is_met(index),
            "off_before": spread(Some(&self.before[index])),
            "off_after": spread(self.after(index)),
            "event": target.event.map(event_name),
            "event_unit": target.event.map(|event| quantity(event).symbol(units)),
            "states": (0..target.states.len()).map(|k| self.state(index, k)).collect::<Vec<_>>(),
        })
    }

    /// One state of a target.
    fn state(&self, index: usize, state: usize) -> Value {
        let (target, units) = (&self.request.targets[index], self.model.units);
        let show = |value: f64| rounded(target.show(units, value));
        let before = self.before[index][state];
        let wanted = match &target.goal {
            Goal::Values(values) => Some(values[state]),
            Goal::Hold => before,
            _ => None,
        };
        let at = target.event.zip(target.states[state].value);
        json!({
            "at": at.map(|(event, value)| rounded(quantity(event).show(units, value))),
            "before": before.map(show),
            "wanted": wanted.map(show),
            "after": self.after(index).and_then(|after| after[state]).map(show),
        })
    }

    fn variable_json(&self, index: usize) -> Value {
        let (model, variable) = (self.model, &self.request.variables[index]);
        let quantity = variable.parameter.quantity(model);
        let show = |value: f64| rounded(quantity.show(model.units, value));
        let sign = variable.parameter.axis().map_or(1.0, |axis| model.axes.signs()[axis]);
        let mut bounds = variable.bounds.map(|bound| show(sign * bound));
        bounds.sort_by(f64::total_cmp);
        let (before, after) = self.variable(index);
        json!({
            "name": variable.name,
            "unit": quantity.symbol(model.units),
            "before": show(before),
            "after": after.map(show),
            "change": after.map(|after| show(after - before)),
            "bounds": bounds,
        })
    }
}
