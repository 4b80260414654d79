//! Sweeps as text: a table for people, CSV and JSON for programs.

mod adjustments;
mod compliance;
mod csv;
mod factors;
mod json;
mod settle;
mod statics;
mod table;

pub use adjustments::write_adjustments;
pub use compliance::ComplianceReport;
pub use factors::{FactorSheet, write_definitions};
pub use settle::{SettleReport, SettleRow};
pub use statics::StaticsReport;

use crate::factors::{Convention, Definition, Factor, basic};
use crate::model::{Axes, Drive, Quantity, Side, Units};
use crate::rig::{Event, Pose, Row, Sweep, SweepPlan};

/// A sweep and all that is needed to show it.
#[derive(Clone, Copy)]
pub struct SweepReport<'a> {
    /// Name of the model.
    pub name: &'a str,
    /// The sides of the vehicle: one of a corner, left and right of an axle, none without a wheel.
    pub sides: &'a [Side],
    /// Axes of the report.
    pub axes: Axes,
    /// Units of the report.
    pub units: Units,
    /// What changes, such as `travel`, `left load fx` or the name of a driver.
    pub event: &'a str,
    /// What the travel driver holds, where there is a wheel.
    pub drive: Option<Drive>,
    /// The quantity of the value that changes.
    pub quantity: Quantity,
    /// What was asked for.
    pub plan: &'a SweepPlan,
    /// What came of it.
    pub sweep: &'a Sweep,
    /// Whether forces and moments of joints are shown.
    pub reactions: bool,
    /// The factors that are shown; otherwise those of [`BASIC`](crate::factors::BASIC) that there are, and what force
    /// elements carry.
    pub factors: Option<&'a [&'static Factor]>,
    /// By whose definitions.
    pub convention: Convention,
}

/// One column of a report.
struct Column {
    /// Name without unit.
    name: String,
    title: String,
    quantity: Quantity,
    sign: String,
    formula: String,
    source: String,
    from: From,
}

/// Which pose of a row.
#[derive(Clone, Copy)]
enum Wheel {
    First,
    Right,
}

impl Wheel {
    fn pose(self, row: &Row) -> Option<&Pose<f64>> {
        match self {
            Self::First => row.pose.as_ref(),
            Self::Right => row.right_pose.as_ref(),
        }
    }
}

/// Where the values of a column come from.
#[derive(Clone, Copy)]
enum From {
    /// A factor on the left or the only side, or one on the right of an axle.
    Factor(&'static Factor, Wheel),
    /// The value of the plan.
    Plan,
    Channel(usize),
}

impl Column {
    /// Name and unit.
    fn header(&self, units: Units) -> String {
        self.quantity.column(&self.name, units)
    }
}

impl SweepReport<'_> {
    /// The columns: the load that changes, the factors that the suspension has, then what force
    /// elements and, where they are asked for, joints carry.
    fn columns(&self) -> Vec<Column> {
        let mut columns = vec![];
        let event = self.plan.event;
        // Travel and rack are factors.
        if !matches!(event, Event::Travel | Event::Opposite | Event::Single(_) | Event::Steer) {
            columns.push(Column {
                name: self.event.replace(' ', "_"),
                title: self.event.into(),
                quantity: self.quantity,
                sign: match event {
                    Event::Driver(_) => "+ as the driver is defined".into(),
                    _ => "+ along the model's axis".into(),
                },
                formula: "what the event changes".into(),
                source: "input".into(),
                from: From::Plan,
            });
        }
        if let [left, right] = self.sides {
            // The rack is the same on both sides.
            columns.extend(self.factors("", Wheel::First, |factor| factor.name == "rack"));
            for (side, wheel) in [(left, Wheel::First), (right, Wheel::Right)] {
                columns.extend(self.factors(side.name(), wheel, |factor| factor.name != "rack"));
            }
        } else {
            columns.extend(self.factors("", Wheel::First, |_| true));
        }
        let joints = match (self.reactions, self.factors) {
            (true, _) => usize::MAX,
            (false, None) => self.sweep.element_channels,
            (false, Some(_)) => 0,
        };
        let channels = self.sweep.channels.iter().enumerate().take(joints);
        columns.extend(channels.map(|(index, channel)| Column {
            name: channel.name.clone(),
            title: channel.title.clone(),
            quantity: channel.quantity,
            sign: channel.sign.into(),
            formula: channel.title.clone(),
            source: "static equilibrium".into(),
            from: From::Channel(index),
        }));
        columns
    }

    /// The factors of a wheel; a side stands before their names.
    fn factors(
        &self,
        side: &str,
        wheel: Wheel,
        chosen: impl Fn(&Factor) -> bool,
    ) -> impl Iterator<Item = Column> {
        let has = |factor: &&Factor| {
            let mut poses = self.sweep.rows.iter().filter_map(|row| wheel.pose(row));
            let shown = self.sweep.rows.is_empty() && !self.sides.is_empty();
            shown || poses.any(|pose| factor.value(self.convention, pose).is_some())
        };
        let shown: Vec<&'static Factor> = match self.factors {
            Some(factors) => factors.to_vec(),
            None => basic().filter(has).collect(),
        };
        let (before, behind) = match side {
            "" => (String::new(), String::new()),
            side => (format!("{side}_"), format!(", {side} wheel")),
        };
        let convention = self.convention;
        shown.into_iter().filter(move |factor| chosen(factor)).map(move |factor| {
            let Definition { sign, formula, source, .. } = factor.by(convention);
            Column {
                name: format!("{before}{}", factor.name),
                title: format!("{}{behind}", factor.title),
                quantity: factor.quantity,
                sign: sign.into(),
                formula: formula.into(),
                source: source.into(),
                from: From::Factor(factor, wheel),
            }
        })
    }

    /// Why columns that were asked for are empty, in words.
    pub fn empty_columns(&self) -> Vec<String> {
        let Some(pose) = self.sweep.rows.iter().find_map(|row| row.pose.as_ref()) else {
            return vec![];
        };
        let why = |factor: &&Factor| {
            let name = factor.name;
            if let Some(axle) = factor.axle.filter(|_| !factor.applies(pose)) {
                return Some(format!("`{name}` belongs to a {} axle", axle.name()));
            }
            let missing: Vec<_> = factor.missing(pose).collect();
            (!missing.is_empty()).then(|| format!("`{name}` needs {}", factors::words(&missing)))
        };
        self.factors.into_iter().flatten().filter_map(why).collect()
    }

    /// The values of a row in the units of the model, to 15 significant digits: what lies
    /// behind them is only the change of units, such as 179.99999999999994 mm for 0.18 m.
    fn values(&self, columns: &[Column], row: &Row) -> Vec<Option<f64>> {
        let units = self.units;
        let value = |column: &Column| match column.from {
            From::Factor(factor, wheel) => factor.show_by(self.convention, units, wheel.pose(row)?),
            From::Plan => Some(column.quantity.show(units, row.value)),
            From::Channel(channel) => Some(column.quantity.show(units, row.channels[channel])),
        };
        columns.iter().map(|column| value(column).map(rounded)).collect()
    }
}

fn rounded(value: f64) -> f64 {
    // Adding zero turns −0 into 0.
    format!("{value:.14e}").parse().unwrap_or(value) + 0.0
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn fifteen_digits_hide_the_change_of_units() {
        assert_eq!(rounded(0.18 * 1000.0), 180.0);
        assert_eq!(rounded(-109.90000000000002), -109.9);
        assert_eq!(rounded(1.0 / 3.0), 0.333333333333333);
        assert!(rounded(-0.0).is_sign_positive());
    }
}
