//! Sweeps as text: a table for people, CSV and JSON for programs.

mod adjustments;
mod catalogue;
mod compliance;
mod csv;
mod drawing;
mod factors;
mod json;
mod lotus;
mod programme;
mod sensitivity;
mod settle;
mod statics;
mod synthesis;
mod table;

pub use adjustments::write_adjustments;
pub use catalogue::{write_architecture, write_architectures, write_catalogue};
pub use compliance::ComplianceReport;
pub use drawing::drawing;
pub use factors::{FactorSheet, write_definitions};
pub use lotus::LotusReport;
pub use programme::{ProgrammeSummary, StageResult};
pub use sensitivity::{SensitivityReport, write_parameters};
pub use settle::{SettleReport, SettleRow};
pub use statics::StaticsReport;
pub use synthesis::SynthesisReport;

use crate::factors::{Convention, Definition, Factor, basic};
use crate::model::{Axes, Drive, LoadCases, Quantity, Side, Units};
use crate::rig::{Event, Row, Sweep, SweepPlan, Vertical};

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
    /// What was asked for, where that is an event.
    pub plan: Option<&'a SweepPlan>,
    /// What was asked for, where that are cases.
    pub cases: Option<&'a LoadCases>,
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

/// Where the values of a column come from.
#[derive(Clone, Copy)]
enum From {
    /// A factor of one wheel, by its place in the poses of a row.
    Factor(&'static Factor, usize),
    /// The value of the plan.
    Plan,
    /// A column of the cases.
    Case(usize),
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
        let mut columns: Vec<Column> =
            self.plan.and_then(|plan| self.input(plan)).into_iter().collect();
        if let [left, right] = self.sides {
            columns.extend(self.factors("", 0, Factor::is_of_axle));
            for (wheel, side) in [left, right].into_iter().enumerate() {
                columns.extend(self.factors(side.name(), wheel, |factor| !factor.is_of_axle()));
            }
        } else {
            columns.extend(self.factors("", 0, |_| true));
        }
        if let Some(cases) = self.cases {
            let is_shown = |column: &Column| columns.iter().any(|shown| shown.name == column.name);
            let inputs = case_columns(cases).filter(|column| !is_shown(column));
            columns = inputs.collect::<Vec<_>>().into_iter().chain(columns).collect();
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

    /// The column of what an event changes; travel and rack are factors, so they need none.
    fn input(&self, plan: &SweepPlan) -> Option<Column> {
        let sign = match plan.event {
            Event::Travel | Event::Opposite | Event::Single(_) => match plan.held.vertical {
                Vertical::Travel => return None,
                _ => "+ up on the wheel".into(),
            },
            Event::Steer => return None,
            Event::Driver(_) => "+ as the driver is defined".into(),
            Event::Roll => {
                let forward = self.axes.to_iso([1.0, 0.0, 0.0])[0] > 0.0;
                let rises = if forward { Side::Left } else { Side::Right }.name();
                format!("+ right-handed about the model's +x: the {rises} side of the body rises")
            }
            _ => "+ along the model's axis".into(),
        };
        Some(Column {
            name: self.event.replace(' ', "_"),
            title: self.event.into(),
            quantity: self.quantity,
            sign,
            formula: "what the event changes".into(),
            source: "input".into(),
            from: From::Plan,
        })
    }

    /// The name of the case of a row.
    fn case(&self, row: &Row) -> Option<&str> {
        Some(&self.cases?.cases.get(row.case?)?.name)
    }

    /// The factors of a wheel; a side stands before their names.
    fn factors(
        &self,
        side: &str,
        wheel: usize,
        chosen: impl Fn(&Factor) -> bool,
    ) -> impl Iterator<Item = Column> {
        let has = |factor: &&Factor| {
            let mut poses = self.sweep.rows.iter().filter_map(|row| row.poses.get(wheel));
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
        let Some(pose) = self.sweep.rows.iter().find_map(|row| row.poses.first()) else {
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
            From::Factor(factor, wheel) => {
                factor.show_by(self.convention, units, row.poses.get(wheel)?)
            }
            From::Plan => Some(column.quantity.show(units, row.value)),
            From::Case(index) => {
                let value = self.cases?.cases.get(row.case?)?.values[index]?;
                Some(column.quantity.show(units, value))
            }
            From::Channel(channel) => Some(column.quantity.show(units, row.channels[channel])),
        };
        columns.iter().map(|column| value(column).map(rounded)).collect()
    }
}

/// The columns of a file of cases, as its user wrote them.
fn case_columns(cases: &LoadCases) -> impl Iterator<Item = Column> {
    cases.columns.iter().enumerate().map(|(index, column)| Column {
        name: column.name.clone(),
        title: column.name.replace('_', " "),
        quantity: column.input.quantity(),
        sign: column.input.sign().into(),
        formula: "what the case asks for".into(),
        source: "input".into(),
        from: From::Case(index),
    })
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
