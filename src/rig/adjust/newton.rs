//! Newton's method for the values of all adjusters together.
//!
//! The Jacobian is exact: the formulas of the factors on dual numbers along the tangents of the adjusters.

use faer::Mat;
use faer::linalg::solvers::Solve;

use super::super::pose::Pose;
use super::super::settled::{Settled, SettledGoal};
use super::super::stand::Stand;
use super::super::station::Station;
use super::error::{AdjustError, OutOfReach};
use crate::factors::{self, Convention, Factor, Need};
use crate::mechanism::DriverId;
use crate::model::{Adjuster, Model, Quantity, StaticTarget};
use crate::solve::Stop;

/// Newton steps; a dozen are many.
const STEPS: usize = 60;

/// The longest step of an adjuster (m).
const LONGEST: f64 = 0.02;

/// The shortest step (m) worth to be tried.
const SHORTEST: f64 = 1e-9;

/// What is left to adjust (m) where that is nothing but rounding.
const ROUNDING: f64 = 1e-15;

/// What may be left to adjust (m) where rounding keeps it from getting less.
const NOISE: f64 = 1e-10;

/// One wheel with its adjusters.
pub(super) struct Adjustable<'a> {
    pub model: &'a Model,
    pub station: Station,
    pub adjusters: Vec<DriverId>,
    /// What stands before the names of its factors.
    pub prefix: &'static str,
}

/// One factor that has to have its value.
#[derive(Clone)]
struct Goal {
    wheel: usize,
    target: StaticTarget,
    factor: &'static Factor,
}

/// Adjusters on the way to the static state.
pub(super) struct Search<'a> {
    stand: Stand,
    wheels: Vec<Adjustable<'a>>,
    goals: Vec<Goal>,
    /// The values (m) of all adjusters of each wheel.
    values: Vec<Vec<f64>>,
}

impl<'a> Search<'a> {
    pub fn new(stand: Stand, wheels: Vec<Adjustable<'a>>) -> Self {
        let goal = |(wheel, target): (usize, &StaticTarget)| {
            let factor = factors::find(target.factor).ok()?;
            Some(Goal { wheel, target: target.clone(), factor })
        };
        let targets = wheels.iter().enumerate().flat_map(|(wheel, part)| {
            part.model.static_state().targets.iter().map(move |target| (wheel, target))
        });
        let goals = targets.filter_map(goal).collect();
        let setting = |adjuster: &Adjuster| adjuster.setting;
        let values = wheels
            .iter()
            .map(|part| part.model.adjusters().iter().map(setting).collect())
            .collect();
        Self { stand, wheels, goals, values }
    }

    /// The static state that was found.
    pub fn settled(self, models: &[&Model]) -> Settled {
        let Self { stand, wheels, goals, .. } = self;
        let goal = |Goal { wheel, target, factor }: Goal| SettledGoal {
            wheel,
            factor,
            driver: wheels[wheel].adjusters[target.by],
        };
        let goals: Vec<SettledGoal> = goals.into_iter().map(goal).collect();
        let stations = wheels.into_iter().map(|part| part.station).collect();
        Settled::new(stand, stations, models, goals)
    }

    /// The values (m) of the adjusters of a wheel, and where it is.
    pub fn wheel(&self, wheel: usize) -> (&[f64], Pose<f64>) {
        let station = &self.wheels[wheel].station;
        (&self.values[wheel], station.pose_at(&self.stand.view()))
    }

    /// Brings all factors to their targets.
    pub fn run(&mut self) -> Result<(), AdjustError> {
        let start = self.values.clone();
        self.go_to(&start).map_err(|stop| AdjustError::Start(Box::new(stop)))?;
        let mut before = f64::INFINITY;
        for _ in 0..STEPS {
            if self.goals.is_empty() {
                return Ok(());
            }
            let missing = self.missing()?;
            let jacobian = self.jacobian()?;
            let sizes = row_sizes(&jacobian);
            let left = worst(&missing, &sizes);
            if left <= ROUNDING || (left <= NOISE && left > 0.5 * before) {
                return Ok(());
            }
            let step = self.newton_step(&jacobian, &missing, &sizes)?;
            if !self.take(&step, left, &sizes)? {
                // Rounding keeps a solution from getting better.
                return if left <= NOISE {
                    Ok(())
                } else {
                    Err(self.out_of_reach(&missing, &sizes))
                };
            }
            before = left;
        }
        let missing = self.missing()?;
        let sizes = row_sizes(&self.jacobian()?);
        Err(self.out_of_reach(&missing, &sizes))
    }

    /// Sets adjusters, the wheels at the ride height.
    fn go_to(&mut self, values: &[Vec<f64>]) -> Result<(), Stop> {
        let mut targets: Vec<(DriverId, f64)> = vec![];
        for (part, values) in self.wheels.iter().zip(values) {
            targets.extend(part.adjusters.iter().copied().zip(values.iter().copied()));
            targets.push((part.station.travel, -part.model.static_state().ride_height));
        }
        self.stand.move_to(&targets)?;
        self.values.clone_from_slice(values);
        Ok(())
    }

    /// Takes a step, or a part of it that brings the worst factor nearer; `false` where none does.
    fn take(&mut self, step: &[f64], left: f64, sizes: &[f64]) -> Result<bool, AdjustError> {
        let start = self.values.clone();
        let longest = step.iter().fold(0.0, |longest: f64, step| longest.max(step.abs()));
        let mut fraction = (LONGEST / longest).min(1.0);
        while fraction * longest > SHORTEST || fraction == 1.0 {
            let mut values = start.clone();
            for (goal, step) in self.goals.iter().zip(step) {
                let [least, most] = self.adjuster(goal).limits;
                let value = &mut values[goal.wheel][goal.target.by];
                *value = (*value + fraction * step).clamp(least, most);
            }
            if values == start {
                return Ok(false);
            }
            if self.go_to(&values).is_ok() && worst(&self.missing()?, sizes) < left {
                return Ok(true);
            }
            fraction *= 0.5;
        }
        // The state that was reached before has been reached, so it can be reached again.
        self.go_to(&start).map_err(|stop| AdjustError::Start(Box::new(stop)))?;
        Ok(false)
    }

    fn adjuster(&self, goal: &Goal) -> &'a Adjuster {
        &self.wheels[goal.wheel].model.adjusters()[goal.target.by]
    }

    /// The pose of a wheel with its load, without motions, which no factor of a static state needs.
    fn pose(&self, wheel: usize) -> Pose<f64> {
        self.wheels[wheel].station.pose(&self.stand)
    }

    /// What every factor lacks to its target (SI).
    fn missing(&mut self) -> Result<Vec<f64>, AdjustError> {
        let goals = self.goals.clone();
        let missing = |goal: &Goal| {
            let pose = self.pose(goal.wheel);
            let value = goal.factor.value(Convention::Iso, &pose);
            value.map(|value| goal.target.value - value).ok_or_else(|| AdjustError::Undefined {
                factor: self.name(goal),
                needs: needs(goal.factor, &pose),
            })
        };
        goals.iter().map(missing).collect()
    }

    /// The derivatives of all factors (rows) by the adjusters that set them (columns).
    fn jacobian(&mut self) -> Result<Mat<f64>, AdjustError> {
        let goals = self.goals.clone();
        let order = goals.len();
        let mut jacobian = Mat::zeros(order, order);
        let poses: Vec<Pose<f64>> = (0..self.wheels.len()).map(|wheel| self.pose(wheel)).collect();
        for (column, by) in goals.iter().enumerate() {
            let driver = self.wheels[by.wheel].adjusters[by.target.by];
            for (row, goal) in goals.iter().enumerate() {
                let station = &self.wheels[goal.wheel].station;
                let pose = &poses[goal.wheel];
                let mut rates = self.stand.rates();
                let load_rate = rates.force_rate(station.travel, driver);
                let motion = station.motion_by(driver, &mut rates);
                let moving = motion.map(|motion| pose.moving(&motion, load_rate));
                let value = moving.and_then(|pose| (goal.factor.value.dual)(&pose));
                jacobian[(row, column)] = value.map_or(0.0, |value| value.derivative);
            }
        }
        for (row, goal) in goals.iter().enumerate() {
            if jacobian[(row, row)].abs() < least_effect(goal.target.quantity) {
                let adjuster = self.adjuster_name(goal);
                return Err(AdjustError::NoEffect { factor: self.name(goal), adjuster });
            }
        }
        Ok(jacobian)
    }

    /// The step of all adjusters that set something.
    fn newton_step(
        &self,
        jacobian: &Mat<f64>,
        missing: &[f64],
        sizes: &[f64],
    ) -> Result<Vec<f64>, AdjustError> {
        /// Rows of length one are dependent where the matrix that they make is this near to a singular one.
        const DEPENDENT: f64 = 1e-6;
        let order = missing.len();
        let scaled = Mat::from_fn(order, order, |row, column| jacobian[(row, column)] / sizes[row]);
        let smallest = scaled.singular_values().ok().and_then(|values| values.last().copied());
        if !smallest.is_some_and(|smallest| smallest > DEPENDENT) {
            let list = |names: Vec<String>| names.join(" and ");
            let adjusters = self.goals.iter().map(|goal| format!("`{}`", self.adjuster_name(goal)));
            return Err(AdjustError::Alike {
                adjusters: list(adjusters.collect()),
                factors: list(self.goals.iter().map(|goal| self.name(goal)).collect()),
            });
        }
        let right = Mat::from_fn(order, 1, |row, _| missing[row] / sizes[row]);
        let step = scaled.partial_piv_lu().solve(&right);
        Ok((0..order).map(|row| step[(row, 0)]).collect())
    }

    /// The name of a factor, with its side on an axle.
    fn name(&self, goal: &Goal) -> String {
        format!("{}{}", self.wheels[goal.wheel].prefix, goal.factor.name)
    }

    fn adjuster_name(&self, goal: &Goal) -> String {
        let prefix = self.wheels[goal.wheel].prefix.replace(' ', "_");
        format!("{prefix}{}", self.adjuster(goal).name)
    }

    /// Says where the factor stopped that is farthest from its target.
    fn out_of_reach(&self, missing: &[f64], sizes: &[f64]) -> AdjustError {
        let far = |index: &usize| (missing[*index] / sizes[*index]).abs();
        let worst = (0..missing.len()).max_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or_default();
        let goal = &self.goals[worst];
        let units = self.wheels[goal.wheel].model.units;
        let show = |value: f64| format!("{:.4}", goal.target.quantity.show(units, value));
        let mut ends = vec![];
        let setting = |goal: &Goal| {
            let value = self.values[goal.wheel][goal.target.by];
            let adjuster = self.adjuster(goal);
            let name = self.adjuster_name(goal);
            let end = adjuster.limits.contains(&value);
            if end {
                ends.push(format!("`{name}`"));
            }
            let (value, unit) = (units.length.from_metres(value), units.length.symbol());
            format!("`{name}` at {value:.4} {unit}{}", if end { ", its limit" } else { "" })
        };
        let settings: Vec<String> = self.goals.iter().map(setting).collect();
        let hint = match ends[..] {
            [] => {
                "the suspension goes no nearer; ask for a value in reach, or move the hard points"
                    .into()
            }
            _ => format!(
                "widen the `limits` of {} if there is room, or move the hard points",
                ends.join(" and ")
            ),
        };
        Box::new(OutOfReach {
            factor: self.name(goal),
            adjuster: self.adjuster_name(goal),
            target: show(goal.target.value),
            reached: show(goal.target.value - missing[worst]),
            unit: goal.target.quantity.symbol(units),
            settings: settings.join(", "),
            hint,
        })
        .into()
    }
}

/// What to add to a model to have a factor.
fn needs(factor: &Factor, pose: &Pose<f64>) -> String {
    let needs: Vec<&str> = factor.missing(pose).map(Need::words).collect();
    if needs.is_empty() { "what it is made of".to_owned() } else { needs.join(" and ") }
}

/// The largest entry of every row.
fn row_sizes(jacobian: &Mat<f64>) -> Vec<f64> {
    let size = |row| (0..jacobian.ncols()).fold(0.0, |m: f64, k| m.max(jacobian[(row, k)].abs()));
    (0..jacobian.nrows()).map(size).collect()
}

/// How far (m) the adjuster would have to go that brings the worst factor to its target.
fn worst(missing: &[f64], sizes: &[f64]) -> f64 {
    missing.iter().zip(sizes).fold(0.0, |worst, (missing, size)| {
        let left = (missing / size).abs();
        if left.is_nan() { f64::INFINITY } else { worst.max(left) }
    })
}

/// An adjuster whose effect by metre is less than this (SI) is taken to have none.
fn least_effect(quantity: Quantity) -> f64 {
    match quantity {
        // A thousandth of a newton by millimetre.
        Quantity::Force => 1.0,
        _ => 1e-6,
    }
}
