//! An active-set method for the quadratic subproblem, which ends in an exact solution or not at all.

use faer::Col;

use super::equality::{Planes, Solution, minimise};
use super::model::Model;

/// Working sets that are tried from one guess.
const TRIALS: usize = 50;
/// Trials in which all mistakes are corrected.
const ALL_AT_ONCE: usize = 8;
/// Limits may be exceeded by this, in typical changes.
pub(super) const BEYOND: f64 = 1e-11;
/// Multipliers may have the wrong sign by this, relative to the largest.
const WRONG_SIGN: f64 = 1e-10;

/// Where a component of the step or a constraint is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Between its limits.
    Between,
    /// On its lower limit; for equations on the only one.
    Lower,
    /// On its upper limit.
    Upper,
    /// Below its lower limit, which is penalised.
    Below,
    /// Above its upper limit, which is penalised.
    Above,
}

/// A working set.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Places {
    pub bounds: Vec<Place>,
    pub rows: Vec<Place>,
}

/// The limits of a subproblem, all relative to the point.
#[derive(Clone)]
pub(super) struct Limits {
    /// Of the step: bounds of the variables and the trust region.
    pub lower: Vec<f64>,
    pub upper: Vec<f64>,
    /// Of the change of the constraints.
    pub row_lower: Vec<f64>,
    pub row_upper: Vec<f64>,
}

/// A solution of the subproblem.
#[derive(Clone)]
pub(super) struct Step {
    pub step: Col<f64>,
    /// Multipliers of the constraints: at least 0 at lower limits.
    pub y: Col<f64>,
    /// Multipliers of the limits of the step.
    pub z: Col<f64>,
    pub places: Places,
}

/// Solves the subproblem from a guess of the working set. With a penalty, constraints may be violated.
pub(super) fn solve(
    model: &Model,
    limits: &Limits,
    penalty: Option<f64>,
    guess: &Places,
) -> Option<Step> {
    let mut places = guess.clone();
    tidy(&mut places, limits, penalty);
    let (mut rule, mut seen): (_, Vec<Places>) = (Rule::All, vec![]);
    for trial in 0..TRIALS {
        // A working set that comes back would come back for ever.
        if seen.contains(&places) || (trial == ALL_AT_ONCE && rule == Rule::All) {
            rule = rule.next()?;
            seen.clear();
        }
        seen.push(places.clone());
        let step = on_working_set(model, limits, penalty, &places)?;
        let corrections = corrections(model, limits, penalty, &step);
        if corrections.is_empty() {
            return Some(step.with_clean_signs(limits));
        }
        let chosen = match rule {
            Rule::All => corrections,
            Rule::Worst => {
                corrections.into_iter().max_by(|a, b| a.2.total_cmp(&b.2)).into_iter().collect()
            }
            Rule::First => corrections.into_iter().take(1).collect(),
        };
        for (target, place, _) in chosen {
            *places.at(target) = place;
        }
    }
    None
}

/// Which mistakes of a working set are corrected in one trial. The first rule needs the fewest trials,
/// the last one cycles least (Bland).
#[derive(Clone, Copy, PartialEq, Eq)]
enum Rule {
    All,
    Worst,
    First,
}

impl Rule {
    fn next(self) -> Option<Self> {
        match self {
            Self::All => Some(Self::Worst),
            Self::Worst => Some(Self::First),
            Self::First => None,
        }
    }
}

impl Step {
    /// Multipliers of limits that are not in the working set become zero.
    pub fn without_passive_multipliers(mut self) -> Self {
        for (j, &place) in self.places.bounds.iter().enumerate() {
            if place == Place::Between {
                self.z[j] = 0.0;
            }
        }
        for (i, &place) in self.places.rows.iter().enumerate() {
            if place == Place::Between {
                self.y[i] = 0.0;
            }
        }
        self
    }

    /// Multipliers of the wrong sign that are only rounding become zero.
    fn with_clean_signs(mut self, limits: &Limits) -> Self {
        let clean = |multiplier: &mut f64, place: Place, equation: bool| match place {
            Place::Lower if !equation => *multiplier = multiplier.max(0.0),
            Place::Upper if !equation => *multiplier = multiplier.min(0.0),
            _ => {}
        };
        for (j, &place) in self.places.bounds.iter().enumerate() {
            clean(&mut self.z[j], place, limits.lower[j] == limits.upper[j]);
        }
        for (i, &place) in self.places.rows.iter().enumerate() {
            clean(&mut self.y[i], place, limits.row_lower[i] == limits.row_upper[i]);
        }
        self
    }
}

/// A place of a working set.
#[derive(Clone, Copy)]
enum Target {
    Bound(usize),
    Row(usize),
}

impl Places {
    pub fn between(variables: usize, constraints: usize) -> Self {
        Self { bounds: vec![Place::Between; variables], rows: vec![Place::Between; constraints] }
    }

    fn at(&mut self, target: Target) -> &mut Place {
        match target {
            Target::Bound(index) => &mut self.bounds[index],
            Target::Row(index) => &mut self.rows[index],
        }
    }
}

/// Makes a guess agree with the limits that there are.
fn tidy(places: &mut Places, limits: &Limits, penalty: Option<f64>) {
    let bounds = limits.lower.iter().zip(&limits.upper);
    for (place, (lower, upper)) in places.bounds.iter_mut().zip(bounds) {
        if lower == upper {
            *place = Place::Lower;
        }
    }
    let rows = limits.row_lower.iter().zip(&limits.row_upper);
    for (place, (lower, upper)) in places.rows.iter_mut().zip(rows) {
        *place = match *place {
            Place::Below if penalty.is_none() => Place::Lower,
            Place::Above if penalty.is_none() => Place::Upper,
            other => other,
        };
        if lower == upper && matches!(place, Place::Between | Place::Upper) {
            *place = Place::Lower;
        }
        let missing = match place {
            Place::Lower | Place::Below => lower.is_infinite(),
            Place::Upper | Place::Above => upper.is_infinite(),
            Place::Between => false,
        };
        if missing {
            *place = Place::Between;
        }
    }
}

fn on_working_set(
    model: &Model,
    limits: &Limits,
    penalty: Option<f64>,
    places: &Places,
) -> Option<Step> {
    let held: Vec<Option<f64>> = (places.bounds.iter().enumerate())
        .map(|(j, place)| match place {
            Place::Lower => Some(limits.lower[j]),
            Place::Upper => Some(limits.upper[j]),
            _ => None,
        })
        .collect();
    let rows: Vec<(usize, f64)> = (places.rows.iter().enumerate())
        .filter_map(|(i, place)| match place {
            Place::Lower => Some((i, limits.row_lower[i])),
            Place::Upper => Some((i, limits.row_upper[i])),
            _ => None,
        })
        .collect();
    let mut y = Col::zeros(places.rows.len());
    for (i, place) in places.rows.iter().enumerate() {
        match place {
            Place::Below => y[i] = penalty.unwrap_or(0.0),
            Place::Above => y[i] = -penalty.unwrap_or(0.0),
            _ => {}
        }
    }
    let push = -(model.point.rows.transpose() * &y);
    let planes = Planes { held: &held, rows: &rows, push: &push };
    let Solution { step, row_multipliers, remainder } = minimise(model, &planes).ok()?;
    for (&(row, _), multiplier) in rows.iter().zip(row_multipliers) {
        y[row] = multiplier;
    }
    let z = Col::from_fn(held.len(), |j| if held[j].is_some() { remainder[j] } else { 0.0 });
    Some(Step { step, y, z, places: places.clone() })
}

/// What is wrong with a step, where it belongs and how wrong it is.
fn corrections(
    model: &Model,
    limits: &Limits,
    penalty: Option<f64>,
    solution: &Step,
) -> Vec<(Target, Place, f64)> {
    let Step { step, y, z, places } = solution;
    let mut found = vec![];
    let scale = 1.0 + model.gradient_at(step).norm_max().max(y.norm_max());
    let wrong = WRONG_SIGN * scale;
    for (j, &place) in places.bounds.iter().enumerate() {
        let (lower, upper, value) = (limits.lower[j], limits.upper[j], step[j]);
        match place {
            _ if lower == upper => {}
            Place::Lower if z[j] < -wrong => {
                found.push((Target::Bound(j), Place::Between, -z[j] / scale));
            }
            Place::Upper if z[j] > wrong => {
                found.push((Target::Bound(j), Place::Between, z[j] / scale));
            }
            Place::Between => outside(&mut found, Target::Bound(j), value, lower, upper),
            _ => {}
        }
    }
    let changes = &model.point.rows * step;
    let most = penalty.unwrap_or(f64::INFINITY);
    for (i, &place) in places.rows.iter().enumerate() {
        let (lower, upper, value) = (limits.row_lower[i], limits.row_upper[i], changes[i]);
        let row = Target::Row(i);
        match place {
            Place::Between => outside(&mut found, row, value, lower, upper),
            Place::Lower | Place::Upper if y[i] > most + wrong && lower.is_finite() => {
                found.push((row, Place::Below, (y[i] - most) / scale));
            }
            Place::Lower | Place::Upper if y[i] < -most - wrong && upper.is_finite() => {
                found.push((row, Place::Above, (-y[i] - most) / scale));
            }
            Place::Lower if lower != upper && y[i] < -wrong => {
                found.push((row, Place::Between, -y[i] / scale));
            }
            Place::Upper if lower != upper && y[i] > wrong => {
                found.push((row, Place::Between, y[i] / scale));
            }
            Place::Below if value > lower + BEYOND => {
                found.push((row, Place::Lower, value - lower));
            }
            Place::Above if value < upper - BEYOND => {
                found.push((row, Place::Upper, upper - value));
            }
            _ => {}
        }
    }
    found
}

fn outside(
    found: &mut Vec<(Target, Place, f64)>,
    target: Target,
    value: f64,
    lower: f64,
    upper: f64,
) {
    let slack = BEYOND * (1.0 + value.abs());
    if value < lower - slack {
        found.push((target, Place::Lower, lower - value));
    } else if value > upper + slack {
        found.push((target, Place::Upper, value - upper));
    }
}
