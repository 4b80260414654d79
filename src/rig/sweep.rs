//! Events: a sequence of states of a corner.

use super::corner::Corner;
use super::pose::Pose;
use crate::solve::Stop;

/// What moves in an event; the other driver is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// The wheel goes up and down, the rack is held.
    Travel,
    /// The rack moves, the height of the wheel is held.
    Steer,
}

impl Event {
    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Travel => "travel",
            Self::Steer => "steer",
        }
    }
}

/// The states that a sweep visits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepPlan {
    /// What moves.
    pub event: Event,
    /// First value (m).
    pub from: f64,
    /// Last value (m).
    pub to: f64,
    /// Distance of values (m), not zero; its sign does not matter.
    pub step: f64,
    /// Value of the driver that is held (m).
    pub held: f64,
}

impl SweepPlan {
    /// The values (m), `from` first. `to` is the last value even where the distance is no
    /// multiple of the step.
    pub fn values(&self) -> Vec<f64> {
        let distance = self.to - self.from;
        let exact = (distance / self.step).abs();
        // A distance that is a multiple of the step but for rounding has no short last step.
        let whole = (exact + 1e-9).floor();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let steps = whole as usize;
        let step = self.step.abs().copysign(distance);
        #[allow(clippy::cast_precision_loss)]
        let mut values: Vec<f64> = (0..=steps).map(|k| self.from + k as f64 * step).collect();
        if exact - whole > 1e-9 {
            values.push(self.to);
        } else if let Some(last) = values.last_mut() {
            *last = self.to;
        }
        values
    }

    fn targets(&self, value: f64) -> (f64, f64) {
        match self.event {
            Event::Travel => (value, self.held),
            Event::Steer => (self.held, value),
        }
    }
}

/// One state of a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Where wheel and steer axis are.
    pub pose: Pose<f64>,
    /// Newton iterations from the state before.
    pub iterations: usize,
    /// The largest residual, each equation divided by the size of its terms.
    pub relative_residual: f64,
}

/// The states that were reached, and where the mechanism stopped if it did.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// The states in the order of the plan.
    pub rows: Vec<Row>,
    /// The number of states that the plan has.
    pub planned: usize,
    /// Where the mechanism could not go on: at most one stop for each direction.
    pub stops: Vec<Stop>,
}

impl Sweep {
    /// Runs a plan. `progress` is told after each state how many are done.
    ///
    /// The sweep starts at the value nearest to the design position and goes
    /// outwards from there, so that every state is reached from a neighbour that
    /// lies nearer to the design position, and a stop on one side leaves the other.
    pub fn run(corner: &mut Corner, plan: &SweepPlan, progress: impl FnMut(usize)) -> Self {
        let values = plan.values();
        let middle = (0..values.len())
            .min_by(|&a, &b| values[a].abs().total_cmp(&values[b].abs()))
            .unwrap_or_default();
        let (before, after) = values.split_at(middle);
        let mut run = Run { corner, plan, progress, done: 0, stops: Vec::new() };

        let outwards = run.follow(after.iter());
        let mut rows = Vec::new();
        // Where not even the first state is reached, nothing beyond it is.
        if let ([_, ..], Some(&first)) = (outwards.as_slice(), after.first())
            && !before.is_empty()
        {
            run.corner.reset();
            if run.row(first).is_some() {
                rows = run.follow(before.iter().rev());
                rows.reverse();
            }
        }
        rows.extend(outwards);
        Self { rows, planned: values.len(), stops: run.stops }
    }
}

struct Run<'a, P> {
    corner: &'a mut Corner,
    plan: &'a SweepPlan,
    progress: P,
    done: usize,
    stops: Vec<Stop>,
}

impl<P: FnMut(usize)> Run<'_, P> {
    fn follow<'v>(&mut self, values: impl Iterator<Item = &'v f64>) -> Vec<Row> {
        let mut rows = Vec::new();
        for &value in values {
            let Some(row) = self.row(value) else { break };
            rows.push(row);
            self.done += 1;
            (self.progress)(self.done);
        }
        rows
    }

    fn row(&mut self, value: f64) -> Option<Row> {
        let (travel, rack) = self.plan.targets(value);
        match self.corner.move_to(travel, rack) {
            Ok(report) => Some(Row {
                pose: self.corner.pose(),
                iterations: report.iterations,
                relative_residual: report.relative_residual,
            }),
            Err(stop) => {
                self.stops.push(stop);
                None
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(from: f64, to: f64, step: f64) -> Vec<f64> {
        SweepPlan { event: Event::Travel, from, to, step, held: 0.0 }.values()
    }

    #[test]
    fn values_end_exactly_where_they_are_asked_to() {
        assert_eq!(values(-0.13, 0.13, 0.01).len(), 27);
        assert_eq!(values(-0.13, 0.13, 0.01).last(), Some(&0.13));
        assert_eq!(values(0.0, 1.0, 0.4), [0.0, 0.4, 0.8, 1.0]);
        assert_eq!(values(1.0, 0.0, 0.5), [1.0, 0.5, 0.0]);
        assert_eq!(values(2.0, 2.0, 0.5), [2.0]);
    }
}
