//! `--over`: an event at each of several values of what it holds.

use std::str::FromStr;

use hardpoint::model::{Model, Side, Units};
use hardpoint::programme::Ranges;
use hardpoint::rig::{Event, SweepPlan};

use crate::failure::Failure;
use crate::loads::FARTHEST;

/// What is held at each of several values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// The displacement of the rack.
    Rack,
    /// The travel of the wheels.
    Travel,
    /// The travel of the right wheel of an axle, while the left one moves.
    Right,
}

/// A variable and its values in the units of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Over {
    variable: Variable,
    from: f64,
    to: f64,
    step: f64,
}

impl FromStr for Over {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong =
            || "write rack, travel or right with first, last and step: rack=-40:40:20".to_owned();
        let (name, range) = text.split_once('=').ok_or_else(wrong)?;
        let variable = match name.trim() {
            "rack" => Variable::Rack,
            "travel" => Variable::Travel,
            "right" => Variable::Right,
            _ => return Err(wrong()),
        };
        let numbers: Result<Vec<f64>, _> =
            range.split(':').map(|word| word.trim().parse()).collect();
        let [from, to, step] = numbers.map_err(|_| wrong())?.try_into().map_err(|_| wrong())?;
        if ![from, to, step].iter().all(|number: &f64| number.is_finite()) || step == 0.0 {
            return Err(wrong());
        }
        Ok(Self { variable, from, to, step })
    }
}

impl Over {
    /// The rack from side to side, for an envelope without a word about its second variable.
    pub fn rack(model: &Model) -> Self {
        let to = model.units.length.from_metres(Ranges::of(model).rack);
        let step = 0.5 * to;
        Self { variable: Variable::Rack, from: -to, to, step }
    }

    /// Refuses what the event moves itself or the model does not have.
    pub fn check(
        &self,
        event: Event,
        axle: bool,
        steers: bool,
        force: bool,
    ) -> Result<(), Failure> {
        let moves_wheels = matches!(event, Event::Travel | Event::Opposite | Event::Single(_));
        let wrong = match self.variable {
            Variable::Rack if !steers => "this suspension has no rack for --over rack",
            Variable::Rack if event == Event::Steer => {
                "a steer event moves the rack; use --over travel"
            }
            Variable::Travel | Variable::Right if force => {
                "--over goes over travels only where travels hold the wheels; leave out --vertical"
            }
            Variable::Travel if event != Event::Opposite && moves_wheels => {
                "this event moves the travel; use --over rack, or --over right with --event left"
            }
            Variable::Right if !axle => "--over right is for an axle; add --axle",
            Variable::Right if event != Event::Single(Side::Left) => {
                "--over right holds the right wheel while the left one moves; use --event left"
            }
            _ => return Ok(()),
        };
        Err(Failure::Usage(wrong.into()))
    }

    /// Refuses the option that holds at one value what goes through several.
    pub fn check_held(
        &self,
        rack: Option<&'static str>,
        travel: Option<f64>,
    ) -> Result<(), Failure> {
        let held = match self.variable {
            Variable::Rack => rack,
            Variable::Travel => travel.map(|_| "--travel"),
            Variable::Right => None,
        };
        let Some(option) = held else { return Ok(()) };
        let word = self.word();
        Err(Failure::Usage(format!(
            "{option} holds the {word} at one value, and the event goes over several; leave out {option}, or \
             write --over {word}=A:B:S with the values that you want"
        )))
    }

    /// The plan at each of the values, with its name.
    pub fn plans(
        &self,
        plan: &SweepPlan,
        units: Units,
    ) -> Result<Vec<(String, SweepPlan)>, Failure> {
        let metres = |length| units.length.to_metres(length);
        let [from, to, step] = [self.from, self.to, self.step].map(metres);
        if from.abs().max(to.abs()) > FARTHEST {
            return Err(Failure::Usage(
                "--over is more than a kilometre; lengths are in the unit of the model".into(),
            ));
        }
        let outer = SweepPlan { from, to, step, ..*plan };
        super::plan::check_states(&outer)?;
        let (word, symbol) = (self.word(), units.length.symbol());
        let at = |value: f64| {
            let mut plan = *plan;
            match self.variable {
                Variable::Rack => plan.held.rack = value,
                Variable::Travel => plan.held.travel = value,
                Variable::Right => plan.held.right_travel = Some(value),
            }
            // Nine digits hide the change of units.
            let shown = (units.length.from_metres(value) * 1e9).round() / 1e9;
            (format!("{word} {shown} {symbol}"), plan)
        };
        Ok(outer.values().into_iter().map(at).collect())
    }

    fn word(&self) -> &'static str {
        match self.variable {
            Variable::Rack => "rack",
            Variable::Travel => "travel",
            Variable::Right => "right travel",
        }
    }
}
