//! Gaussian elimination as a fixed list of operations.
//!
//! Suspension systems are small and are solved thousands of times with one
//! pattern. The order of the pivots is chosen once, by Markowitz's count among
//! entries that are large enough, and from it the list of all multiply-subtracts
//! follows. When a pivot decays, the plan is made anew from the values at hand.

use std::ops::Range;

use super::linear::{Factors, Singular, permutation_sign};
use crate::assembly::Pattern;

/// A planned pivot is at least this part of the largest entry of its column.
const PLANNED: f64 = 0.1;

/// A pivot that falls below this part of the largest entry of its column asks for a new plan.
const DECAYED: f64 = 1e-4;

/// No entry in this place.
const NONE: u32 = u32::MAX;

/// One pivot: where it is, and its parts of the lists of [`Plan`].
struct Pivot {
    row: usize,
    column: usize,
    value: usize,
    lower: Range<usize>,
    upper: Range<usize>,
    updates: Range<usize>,
}

/// An entry of a factor: its row (below a pivot) or column (right of it), and its value.
#[derive(Clone, Copy)]
struct Entry {
    index: u32,
    value: u32,
}

/// target −= factor · entry
#[derive(Clone, Copy)]
struct Update {
    target: u32,
    factor: u32,
    entry: u32,
}

#[derive(Default)]
struct Plan {
    pivots: Vec<Pivot>,
    lower: Vec<Entry>,
    upper: Vec<Entry>,
    updates: Vec<Update>,
    /// Values with those that fill in.
    size: usize,
    /// Sign of the permutations of rows and columns.
    sign: f64,
}

/// Factors by an elimination plan.
pub(super) struct Elimination {
    pattern: Pattern,
    plan: Plan,
    /// The factors: multipliers below the pivots, pivots, and rows right of them.
    values: Vec<f64>,
    reciprocals: Vec<f64>,
    scratch: Vec<f64>,
}

impl Elimination {
    /// No plan yet: it is made from the first values.
    pub fn new(pattern: &Pattern) -> Self {
        let n = pattern.rows();
        Self {
            pattern: pattern.clone(),
            plan: Plan::default(),
            values: vec![],
            reciprocals: vec![0.0; n],
            scratch: vec![0.0; n],
        }
    }

    /// Runs the plan; false where a pivot has decayed.
    fn run(&mut self, values: &[f64]) -> bool {
        let (given, filled) = self.values.split_at_mut(values.len());
        given.copy_from_slice(values);
        filled.fill(0.0);
        let values = &mut self.values[..];
        for (pivot, reciprocal) in self.plan.pivots.iter().zip(&mut self.reciprocals) {
            let value = values[pivot.value];
            let below = &self.plan.lower[pivot.lower.clone()];
            let largest = below.iter().fold(value.abs(), |largest, entry| {
                largest.max(values[entry.value as usize].abs())
            });
            // Not the other way round: a comparison with NaN is false.
            if !(value.abs() > 0.0 && value.abs() >= DECAYED * largest) {
                return false;
            }
            *reciprocal = 1.0 / value;
            for entry in below {
                values[entry.value as usize] *= *reciprocal;
            }
            for update in &self.plan.updates[pivot.updates.clone()] {
                values[update.target as usize] -=
                    values[update.factor as usize] * values[update.entry as usize];
            }
        }
        true
    }
}

impl Factors for Elimination {
    fn factorise(&mut self, values: &[f64]) -> Result<(), Singular> {
        if self.plan.pivots.len() == self.pattern.rows() && self.run(values) {
            return Ok(());
        }
        self.plan = Plan::new(&self.pattern, values)?;
        self.values.resize(self.plan.size, 0.0);
        if self.run(values) { Ok(()) } else { Err(Singular) }
    }

    fn substitute(&mut self, right_side: &mut [f64], transposed: bool) {
        let Plan { pivots, lower, upper, .. } = &self.plan;
        let (values, y) = (&self.values, &mut self.scratch);
        y.copy_from_slice(right_side);
        if transposed {
            for (k, pivot) in pivots.iter().enumerate() {
                let x = y[pivot.column] * self.reciprocals[k];
                for entry in &upper[pivot.upper.clone()] {
                    y[entry.index as usize] -= values[entry.value as usize] * x;
                }
                right_side[pivot.row] = x;
            }
            for pivot in pivots.iter().rev() {
                let mut x = right_side[pivot.row];
                for entry in &lower[pivot.lower.clone()] {
                    x -= values[entry.value as usize] * right_side[entry.index as usize];
                }
                right_side[pivot.row] = x;
            }
        } else {
            for pivot in pivots {
                let x = y[pivot.row];
                for entry in &lower[pivot.lower.clone()] {
                    y[entry.index as usize] -= values[entry.value as usize] * x;
                }
            }
            for (k, pivot) in pivots.iter().enumerate().rev() {
                let mut x = y[pivot.row];
                for entry in &upper[pivot.upper.clone()] {
                    x -= values[entry.value as usize] * right_side[entry.index as usize];
                }
                right_side[pivot.column] = x * self.reciprocals[k];
            }
        }
    }

    fn determinant_sign(&mut self) -> f64 {
        self.reciprocals.iter().fold(self.plan.sign, |sign, pivot| sign * pivot.signum())
    }
}

/// The matrix while it is planned: dense, with the place of every entry.
struct Planning {
    n: usize,
    places: Vec<u32>,
    values: Vec<f64>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    size: usize,
}

impl Planning {
    fn new(pattern: &Pattern, values: &[f64]) -> Self {
        let n = pattern.rows();
        let mut places = vec![NONE; n * n];
        let mut dense = vec![0.0; n * n];
        for (row, column, slot) in pattern.entries() {
            places[row * n + column] = place(slot);
            dense[row * n + column] = values[slot];
        }
        Self {
            n,
            places,
            values: dense,
            rows: (0..n).collect(),
            columns: (0..n).collect(),
            size: pattern.nonzeros(),
        }
    }

    fn has(&self, row: usize, column: usize) -> bool {
        self.places[row * self.n + column] != NONE
    }

    /// The pivot with the fewest possible fill-ins, the larger one of equals.
    fn choose(&self) -> Option<(usize, usize)> {
        let count = |row: usize| self.columns.iter().filter(|&&j| self.has(row, j)).count();
        let counts: Vec<usize> = self.rows.iter().map(|&row| count(row)).collect();
        let mut best: Option<(usize, f64, usize, usize)> = None;
        for &column in &self.columns {
            let value = |row: usize| self.values[row * self.n + column].abs();
            let in_column = self.rows.iter().filter(|&&row| self.has(row, column)).count();
            let largest = self.rows.iter().map(|&row| value(row)).fold(0.0, f64::max);
            for (&row, &in_row) in self.rows.iter().zip(&counts) {
                let relative = value(row) / largest;
                if !(self.has(row, column) && relative >= PLANNED) {
                    continue;
                }
                let fill = (in_row - 1) * (in_column - 1);
                let better = best.is_none_or(|(least, size, ..)| {
                    fill < least || (fill == least && relative > size)
                });
                if better {
                    best = Some((fill, relative, row, column));
                }
            }
        }
        best.map(|(_, _, row, column)| (row, column))
    }

    /// Eliminates with a pivot and appends what that takes to the plan.
    fn eliminate(&mut self, row: usize, column: usize, plan: &mut Plan) {
        let n = self.n;
        self.rows.retain(|&other| other != row);
        self.columns.retain(|&other| other != column);
        let right: Vec<usize> =
            self.columns.iter().copied().filter(|&j| self.has(row, j)).collect();
        let below: Vec<usize> =
            self.rows.iter().copied().filter(|&i| self.has(i, column)).collect();
        let starts = [plan.lower.len(), plan.upper.len(), plan.updates.len()];
        for &i in &below {
            let factor = self.values[i * n + column] / self.values[row * n + column];
            for &j in &right {
                if !self.has(i, j) {
                    self.places[i * n + j] = place(self.size);
                    self.size += 1;
                }
                self.values[i * n + j] -= factor * self.values[row * n + j];
                plan.updates.push(Update {
                    target: self.places[i * n + j],
                    factor: self.places[i * n + column],
                    entry: self.places[row * n + j],
                });
            }
        }
        let entry = |index: usize, value: u32| Entry { index: place(index), value };
        plan.lower.extend(below.iter().map(|&i| entry(i, self.places[i * n + column])));
        plan.upper.extend(right.iter().map(|&j| entry(j, self.places[row * n + j])));
        plan.pivots.push(Pivot {
            row,
            column,
            value: self.places[row * n + column] as usize,
            lower: starts[0]..plan.lower.len(),
            upper: starts[1]..plan.upper.len(),
            updates: starts[2]..plan.updates.len(),
        });
    }
}

fn place(index: usize) -> u32 {
    u32::try_from(index).expect("a planned matrix is small")
}

impl Plan {
    fn new(pattern: &Pattern, values: &[f64]) -> Result<Self, Singular> {
        let mut planning = Planning::new(pattern, values);
        let mut plan = Self::default();
        for _ in 0..planning.n {
            let (row, column) = planning.choose().ok_or(Singular)?;
            planning.eliminate(row, column, &mut plan);
        }
        plan.size = planning.size;
        let mut visited = vec![false; planning.n];
        let mut order = |index: fn(&Pivot) -> usize| {
            let order: Vec<usize> = plan.pivots.iter().map(index).collect();
            permutation_sign(&order, &mut visited)
        };
        plan.sign = order(|pivot| pivot.row) * order(|pivot| pivot.column);
        Ok(plan)
    }
}
