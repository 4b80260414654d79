//! Forces by length and speed, or moments by angle and angular velocity.

use super::dataset::{Dataset, along};
use super::expression::{Context, Expression, Measure};
use super::pair::Pair;
use crate::mechanism::{Curve, Spline};
use crate::vector::{norm, sub};

/// A force F(x, v) = at rest in the design position + elastic part + viscous part, as Adams counts it: on the
/// part of I, positive away from J or right-handed about z of J.
pub(super) struct Law {
    /// F(0, 0).
    pub(super) at_design: f64,
    /// By the change x of the length or the angle since the design position.
    pub(super) elastic: Answer,
    /// By the speed v.
    pub(super) viscous: Answer,
    /// The length, or the angle since the design position, at which the elastic force is zero; where it is linear
    /// and not constant.
    pub(super) free: Option<f64>,
}

/// What part of a force a variable has.
pub(super) enum Answer {
    /// In proportion.
    Linear(f64),
    /// Rows of the variable and the whole force with the other variable at zero.
    Table(Vec<[f64; 2]>),
}

/// What a force is a function of.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Line,
    Torsion,
}

/// How a measure follows from the change x and the speed v.
#[derive(Clone, Copy)]
enum Role {
    /// m = design + factor · x.
    Value { design: f64, factor: f64 },
    /// m = factor · v.
    Rate { factor: f64 },
}

/// Half the number of rows of a table.
const HALF: i32 = 200;

/// Largest error of a table, by the range of its forces.
const EXACT: f64 = 1e-3;

/// Differences below this part of the largest force are rounding.
const ROUNDING: f64 = 1e-11;

impl Law {
    /// A linear one: F = constant + by_value · m + by_rate · ṁ, where m is the length, or the angle since the
    /// design position.
    pub(super) fn linear(constant: f64, by_value: f64, by_rate: f64, design: f64) -> Self {
        Self {
            at_design: constant + by_value * design,
            elastic: Answer::Linear(by_value),
            viscous: Answer::Linear(by_rate),
            free: (by_value != 0.0).then(|| -constant / by_value),
        }
    }

    /// The law that an expression states, with a remark where it became tables.
    pub(super) fn of(
        expression: &Expression,
        kind: Kind,
        pair: &Pair,
    ) -> Result<(Self, Option<String>), String> {
        let dataset = pair.dataset;
        let mut roles = vec![];
        for measure in expression.measures(dataset)? {
            let role = role(&measure, kind, pair)?;
            roles.push((measure, role));
        }
        if let Some(linear) = expression.linear(dataset) {
            let (mut constant, mut by_x, mut by_v) = (linear.constant, 0.0, 0.0);
            for (measure, by) in &linear.terms {
                let found = roles.iter().find(|(other, _)| other == measure);
                match found.ok_or("it changes with time")?.1 {
                    Role::Value { design, factor } => {
                        by_x += by * factor;
                        // A length counts as it is, an angle since the design position.
                        constant += if kind == Kind::Line { 0.0 } else { by * design };
                    }
                    Role::Rate { factor } => by_v += by * factor,
                }
            }
            let design = if kind == Kind::Line { pair.distance() } else { 0.0 };
            return Ok((Self::linear(constant, by_x, by_v, design), None));
        }
        let force = |x: f64, v: f64| {
            let values = roles.iter().map(|(measure, role)| {
                let value = match role {
                    Role::Value { design, factor } => design + factor * x,
                    Role::Rate { factor } => factor * v,
                };
                (measure.clone(), value)
            });
            expression.value(&Probe { dataset, values: values.collect(), time: None })
        };
        dataset.spend(expression)?;
        let [xs, vs] = ranges(kind, pair);
        let (mut law, remark) = sampled(force, &xs, &vs)?;
        if kind == Kind::Line {
            law.free = law.free.map(|change| pair.distance() + change);
        }
        Ok((law, Some(remark)))
    }

    /// Whether there is never any force.
    pub(super) fn is_zero(&self) -> bool {
        let zero = |answer: &Answer| matches!(answer, Answer::Linear(0.0));
        self.at_design == 0.0 && zero(&self.elastic) && zero(&self.viscous)
    }
}

/// The values at which tables are taken: the change of the length or angle, and the speed.
fn ranges(kind: Kind, pair: &Pair) -> [Vec<f64>; 2] {
    let scales = &pair.dataset.scales;
    let parts = |reach: f64, law: fn(f64) -> f64| {
        (-HALF..=HALF).map(|k| reach * law(f64::from(k) / f64::from(HALF))).collect()
    };
    // Dampers have their knees at low speed.
    let fine = |u: f64| (4.0 * u).sinh() / 4.0_f64.sinh();
    match kind {
        Kind::Line => {
            let metre = 1.0 / (scales.length_unit.to_metres(1.0) * scales.length);
            [parts(0.75 * pair.distance(), |u| u), parts(5.0 * metre * scales.time, fine)]
        }
        Kind::Torsion => [parts(std::f64::consts::PI, |u| u), parts(50.0 * scales.time, fine)],
    }
}

/// Tables of a force that is a sum of a function of x and one of v.
fn sampled(
    force: impl Fn(f64, f64) -> Result<f64, String>,
    xs: &[f64],
    vs: &[f64],
) -> Result<(Law, String), String> {
    let finite = |x: f64, v: f64| {
        let value = force(x, v)?;
        if value.is_finite() { Ok(value) } else { Err(format!("it has no value ({value})")) }
    };
    let at_design = finite(0.0, 0.0)?;
    let by_x: Vec<[f64; 2]> =
        xs.iter().map(|x| Ok([*x, finite(*x, 0.0)?])).collect::<Result<_, String>>()?;
    let by_v: Vec<[f64; 2]> =
        vs.iter().map(|v| Ok([*v, finite(0.0, *v)?])).collect::<Result<_, String>>()?;
    let largest = by_x.iter().chain(&by_v).fold(0.0, |m: f64, row| m.max(row[1].abs()));
    let step = xs.len().div_ceil(7).max(1);
    for x in xs.iter().step_by(step) {
        for (v, [_, alone]) in vs.iter().zip(&by_v).step_by(step) {
            let apart = finite(*x, 0.0)? + alone - at_design;
            if (finite(*x, *v)? - apart).abs() > 1e-9 * largest {
                return Err(
                    "it is no sum of a function of the position and one of the speed".into()
                );
            }
        }
    }
    let (elastic, x_error) = answer(by_x, at_design, largest, |x| finite(x, 0.0))?;
    let (viscous, v_error) = answer(by_v, at_design, largest, |v| finite(0.0, v))?;
    let free = match elastic {
        Answer::Linear(slope) if slope != 0.0 => Some(-at_design / slope),
        _ => None,
    };
    let error = x_error.max(v_error);
    let remark = format!(
        "its expression is not linear and became a table of {} rows; the largest difference between them is \
         {error:.1e}",
        xs.len()
    );
    Ok((Law { at_design, elastic, viscous, free }, remark))
}

/// A line or a table through rows, with the largest error between the rows of the table.
fn answer(
    rows: Vec<[f64; 2]>,
    at_zero: f64,
    largest: f64,
    force: impl Fn(f64) -> Result<f64, String>,
) -> Result<(Answer, f64), String> {
    let [x, f] = rows[rows.len() - 1];
    let slope = if x == 0.0 { 0.0 } else { (f - at_zero) / x };
    let straight = |row: &[f64; 2]| (row[1] - at_zero - slope * row[0]).abs() <= ROUNDING * largest;
    if rows.iter().all(straight) {
        return Ok((Answer::Linear(slope), 0.0));
    }
    let spline = Spline::new("force", rows.clone()).map_err(|_| "its values make no table")?;
    let spline = Curve::Table(spline);
    let mut error: f64 = 0.0;
    for pair in rows.windows(2) {
        for part in [0.25, 0.5, 0.75] {
            let x = pair[0][0] + part * (pair[1][0] - pair[0][0]);
            error = error.max((spline.at(x).value - force(x)?).abs());
        }
    }
    let (least, most) = rows
        .iter()
        .fold((f64::MAX, f64::MIN), |(least, most), row| (least.min(row[1]), most.max(row[1])));
    if error > EXACT * (most - least) {
        return Err("it jumps or bends too sharply for a table".into());
    }
    Ok((Answer::Table(rows), error))
}

/// How a measure follows from the state of the two markers of a force.
fn role(measure: &Measure, kind: Kind, pair: &Pair) -> Result<Role, String> {
    let words = || {
        let markers: Vec<String> = measure.markers.iter().map(u32::to_string).collect();
        format!("{}({})", measure.name, markers.join(", "))
    };
    let other = || format!("{} is not measured between the markers of the force", words());
    let Some(sense) = pair.sense(measure) else { return Err(other()) };
    let dataset = pair.dataset;
    match (kind, measure.name.as_str()) {
        (Kind::Line, "DM" | "VR") => {
            let ends = [pair.i, pair.j].map(|marker| marker.frame.origin);
            let ends = if sense > 0.0 { ends } else { [ends[1], ends[0]] };
            for (place, end) in ends.into_iter().enumerate() {
                let here = dataset.frame_of(measure, place)?.origin;
                if norm(sub(here, end)) > 1e-9 * dataset.size {
                    return Err(other());
                }
            }
            if measure.name == "VR" {
                return Ok(Role::Rate { factor: 1.0 });
            }
            Ok(Role::Value { design: pair.distance(), factor: 1.0 })
        }
        (Kind::Torsion, name @ ("AX" | "AY" | "AZ" | "WX" | "WY" | "WZ")) => {
            let axis = match &name[1..] {
                "X" => 0,
                "Y" => 1,
                _ => 2,
            };
            // Angles are about an axis of the second marker, velocities about one of the third.
            let about = dataset.frame_of(measure, if name.starts_with('A') { 1 } else { 2 })?;
            let Some(same) = along(about.axes[axis], pair.z_j()) else {
                return Err(format!("{} is not about the z axis of the marker J", words()));
            };
            let factor = sense * same;
            if name.starts_with('W') {
                return Ok(Role::Rate { factor });
            }
            Ok(Role::Value { design: dataset.design(measure)?, factor })
        }
        _ => Err(format!("{} is not known in such a force", words())),
    }
}

/// Values for some measures and the time.
pub(super) struct Probe<'d> {
    pub(super) dataset: &'d Dataset,
    pub(super) values: Vec<(Measure, f64)>,
    pub(super) time: Option<f64>,
}

impl Context for Probe<'_> {
    fn measure(&self, measure: &Measure) -> Result<f64, String> {
        match self.values.iter().find(|(other, _)| other == measure) {
            Some((_, value)) => Ok(*value),
            None => self.dataset.measure(measure),
        }
    }

    fn time(&self) -> Result<f64, String> {
        self.time.ok_or_else(|| "it changes with time".into())
    }

    fn variable(&self, id: u32) -> Result<&Expression, String> {
        self.dataset.variable(id)
    }

    fn spline(&self, function: &str, id: u32, x: f64) -> Result<f64, String> {
        self.dataset.spline(function, id, x)
    }
}
