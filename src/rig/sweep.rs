//! Events: a sequence of states of a corner, an axle or a mechanism.

use super::channel::Channel;
use super::load::Load;
use super::pose::Pose;
use crate::mechanism::DriverId;
use crate::model::Side;
use crate::solve::{StepReport, Stop};

/// What changes in an event; all else is held. A corner takes the part of its side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// The wheel goes up and down, the rack is held. The wheels of an axle go in parallel.
    Travel,
    /// The left wheel goes up from the held travel by as much as the right one goes down: roll with a
    /// constant track of the rig.
    Opposite,
    /// One wheel goes up and down, the other is held.
    Single(Side),
    /// The rack moves, the height of the wheel is held.
    Steer,
    /// One component of the load on the wheel grows, by its position in
    /// [`LOAD_COMPONENTS`](super::LOAD_COMPONENTS). Both wheels of an axle carry the same.
    Load(usize),
    /// One component of the load grows on the left wheel, and as much against it on the right one.
    LoadOpposed(usize),
    /// One component of the load on one wheel grows.
    LoadSingle(usize, Side),
    /// A driver of a mechanism moves, all others are held.
    Driver(DriverId),
}

/// What an event does not change.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// Travel of the wheel or wheels (m), where it is held.
    pub travel: f64,
    /// Displacement of the rack (m).
    pub rack: f64,
    /// Load on the wheel (N and N·m).
    pub load: Load,
    /// Load on the right wheel of an axle, where it is another one.
    pub right_load: Option<Load>,
}

/// What the rig does to the wheels at one state of an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Travel (m) of the left and the right wheel.
    pub travel: [f64; 2],
    /// Displacement of the rack (m).
    pub rack: f64,
    /// Load (N and N·m) on the left and the right wheel.
    pub load: [Load; 2],
}

/// The states that a sweep visits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepPlan {
    /// What moves.
    pub event: Event,
    /// First value (m, N or N·m).
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// Distance of values; its sign does not matter. Zero leaves out all between first and last.
    pub step: f64,
    /// What is held.
    pub held: Held,
}

impl SweepPlan {
    /// What the rig does at a value.
    pub fn target(&self, value: f64) -> Target {
        let Held { travel, rack, load, right_load } = self.held;
        let mut target =
            Target { travel: [travel; 2], rack, load: [load, right_load.unwrap_or(load)] };
        let mut load = |component: usize, side: Side, value| {
            target.load[side.index()].components[component] = value;
        };
        match self.event {
            Event::Travel => target.travel = [value; 2],
            Event::Opposite => target.travel = [travel + value, travel - value],
            Event::Single(side) => target.travel[side.index()] = value,
            Event::Steer => target.rack = value,
            Event::Load(component) => {
                load(component, Side::Left, value);
                load(component, Side::Right, value);
            }
            Event::LoadOpposed(component) => {
                load(component, Side::Left, value);
                load(component, Side::Right, -value);
            }
            Event::LoadSingle(component, side) => load(component, side, value),
            // Drivers by name belong to mechanisms without a wheel.
            Event::Driver(_) => {}
        }
        target
    }

    /// The values (m), `from` first. `to` is the last value even where the distance is no
    /// multiple of the step.
    pub fn values(&self) -> Vec<f64> {
        let distance = self.to - self.from;
        let exact = (distance / self.step).abs();
        if exact.is_infinite() {
            return vec![self.from, self.to];
        }
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
}

/// What a sweep moves: a corner, an axle, or a mechanism without a wheel.
pub trait Specimen {
    /// Goes to one value of a plan.
    ///
    /// # Errors
    /// [`Stop`] where it cannot go on.
    fn go_to(&mut self, plan: &SweepPlan, value: f64) -> Result<StepReport, Stop>;

    /// Returns to the design position.
    fn reset(&mut self);

    /// Where wheels and steer axes are: one of a corner, left and right of an axle, none of a
    /// mechanism.
    fn poses(&mut self) -> Vec<Pose<f64>>;

    /// The channels of force elements, or of bodies, drivers and force elements.
    fn element_channels(&self) -> &[Channel];

    /// The channels of joints.
    fn joint_channels(&self) -> &[Channel];

    /// The values (SI) of all channels, those of joints last.
    fn channel_values(&self) -> Vec<f64>;

    /// Motions that make the state arbitrary, in words.
    fn free_motions(&self) -> Vec<String>;
}

/// One state of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The value of the plan (m, N or N·m).
    pub value: f64,
    /// Where wheels and steer axes are: one of a corner, left and right of an axle, none of a
    /// mechanism.
    pub poses: Vec<Pose<f64>>,
    /// The values (SI) of [`Sweep::channels`].
    pub channels: Vec<f64>,
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
    /// What force elements and, behind them, joints carry at each state.
    pub channels: Vec<Channel>,
    /// How many of the channels belong to force elements.
    pub element_channels: usize,
    /// The number of states that the plan has.
    pub planned: usize,
    /// Where the mechanism could not go on: at most one stop for each direction.
    pub stops: Vec<Stop>,
    /// Motions of wheel and steer axis that the joints leave free, in words. What depends on
    /// them is not determined by the model.
    pub free_motions: Vec<String>,
}

impl Sweep {
    /// Runs a plan. `progress` is told after each state how many are done.
    ///
    /// The sweep starts at the value nearest to the design position and goes
    /// outwards from there, so that every state is reached from a neighbour that
    /// lies nearer to the design position, and a stop on one side leaves the other.
    pub fn run(
        specimen: &mut impl Specimen,
        plan: &SweepPlan,
        progress: impl FnMut(usize),
    ) -> Self {
        let values = plan.values();
        let middle = (0..values.len())
            .min_by(|&a, &b| values[a].abs().total_cmp(&values[b].abs()))
            .unwrap_or_default();
        let (before, after) = values.split_at(middle);
        let mut run = Run { specimen, plan, progress, done: 0, stops: Vec::new() };

        let outwards = run.follow(after.iter());
        let mut rows = Vec::new();
        // Where not even the first state is reached, nothing beyond it is.
        if let ([_, ..], Some(&first)) = (outwards.as_slice(), after.first())
            && !before.is_empty()
        {
            run.specimen.reset();
            if run.row(first).is_some() {
                rows = run.follow(before.iter().rev());
                rows.reverse();
            }
        }
        rows.extend(outwards);
        let stops = run.stops;
        let free_motions = specimen.free_motions();
        let elements = specimen.element_channels();
        let channels = [elements, specimen.joint_channels()].concat();
        let element_channels = elements.len();
        Self { rows, channels, element_channels, planned: values.len(), stops, free_motions }
    }
}

struct Run<'a, C, P> {
    specimen: &'a mut C,
    plan: &'a SweepPlan,
    progress: P,
    done: usize,
    stops: Vec<Stop>,
}

impl<C: Specimen, P: FnMut(usize)> Run<'_, C, P> {
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
        match self.specimen.go_to(self.plan, value) {
            Ok(report) => Some(Row {
                value,
                poses: self.specimen.poses(),
                channels: self.specimen.channel_values(),
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
        SweepPlan { event: Event::Travel, from, to, step, held: Held::default() }.values()
    }

    #[test]
    fn values_end_exactly_where_they_are_asked_to() {
        assert_eq!(values(-0.13, 0.13, 0.01).len(), 27);
        assert_eq!(values(-0.13, 0.13, 0.01).last(), Some(&0.13));
        assert_eq!(values(0.0, 1.0, 0.4), [0.0, 0.4, 0.8, 1.0]);
        assert_eq!(values(1.0, 0.0, 0.5), [1.0, 0.5, 0.0]);
        assert_eq!(values(2.0, 2.0, 0.5), [2.0]);
        assert_eq!(values(0.0, 1.0, 0.0), [0.0, 1.0]);
    }
}
