//! Sweeps: a sequence of states of a corner, an axle or a mechanism.

use std::fmt;

use super::channel::Channel;
use super::pose::Pose;
use super::target::{Held, Supports, SweepPlan, Target};
use super::watch::{Warning, Watch};
use crate::mechanism::Mechanism;
use crate::solve::{StepReport, Stop};

/// What a sweep moves: a corner, an axle, or a mechanism without a wheel.
pub trait Specimen {
    /// Goes to a state.
    ///
    /// # Errors
    /// [`Stop`] where it cannot go on.
    fn go_to(&mut self, target: &Target) -> Result<StepReport, Stop>;

    /// Returns to the design position.
    fn reset(&mut self);

    /// The mechanism on the rig.
    fn mechanism(&self) -> &Mechanism;

    /// Where wheels and steer axes are: one of a corner, left and right of an axle, none of a
    /// mechanism.
    fn poses(&mut self) -> Vec<Pose<f64>>;

    /// The forces with which wheels and chassis are held; zero where there are none.
    fn supports(&self) -> Supports {
        Supports::default()
    }

    /// The channels of force elements, or of bodies, drivers and force elements.
    fn element_channels(&self) -> &[Channel];

    /// The channels of joints.
    fn joint_channels(&self) -> &[Channel];

    /// The values (SI) of all channels, those of joints last.
    fn channel_values(&self) -> Vec<f64>;

    /// Motions that make the state arbitrary, in words.
    fn free_motions(&self) -> Vec<String>;
}

impl Supports {
    /// The forces that hold a specimen where no event has begun, the wheels at their travels. It stays there.
    ///
    /// # Errors
    /// [`Stop`] where it does not get there.
    pub fn find(specimen: &mut impl Specimen, held: &Held) -> Result<Self, Stop> {
        specimen.reset();
        specimen.go_to(&held.target())?;
        Ok(specimen.supports())
    }
}

/// One state of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The value of the plan (m, rad, N or N·m), or the number of the case from 1.
    pub value: f64,
    /// The index of the case, where the sweep goes through cases.
    pub case: Option<usize>,
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

/// Where in a sweep something was seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The plan of several, or the case, in words.
    pub plan: Option<String>,
    /// The value (SI) of the plan, or the number of the case.
    pub value: f64,
}

/// A state that was not reached, and with it those beyond it.
#[derive(Clone, Debug, PartialEq)]
pub struct Missed {
    /// The plan of several, or the case, in words.
    pub at: Option<String>,
    /// Where the mechanism stopped, and why.
    pub stop: Stop,
}

impl fmt::Display for Missed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(at) = &self.at {
            write!(f, "{at}: ")?;
        }
        write!(f, "{}", self.stop)
    }
}

/// The states that were reached, and where the mechanism stopped if it did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sweep {
    /// The states in the order of the plan.
    pub rows: Vec<Row>,
    /// What force elements and, behind them, joints carry at each state.
    pub channels: Vec<Channel>,
    /// How many of the channels belong to force elements.
    pub element_channels: usize,
    /// The number of states that were asked for.
    pub planned: usize,
    /// Where the mechanism could not go on: at most one stop for each direction of a plan, or one for
    /// each case.
    pub stops: Vec<Missed>,
    /// Dead centres that wheels came near to or passed.
    pub warnings: Vec<Warning<Place>>,
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
        let mut run = Run::new(specimen, progress);
        run.plan(plan, None);
        run.end()
    }

    /// Runs plans with their names one after the other, each from the design position. A stop in one leaves
    /// the others.
    pub fn grid(
        specimen: &mut impl Specimen,
        plans: &[(String, SweepPlan)],
        progress: impl FnMut(usize),
    ) -> Self {
        let mut run = Run::new(specimen, progress);
        for (name, plan) in plans {
            run.specimen.reset();
            run.plan(plan, Some(name));
        }
        run.end()
    }

    /// Goes to each of the cases with their names from the design position. One that is not reached
    /// leaves the others.
    pub fn cases(
        specimen: &mut impl Specimen,
        cases: &[(String, Target)],
        progress: impl FnMut(usize),
    ) -> Self {
        let mut run = Run::new(specimen, progress);
        for (index, (name, target)) in cases.iter().enumerate() {
            run.specimen.reset();
            run.watch.restart();
            #[allow(clippy::cast_precision_loss)]
            let row = run.row((index + 1) as f64, target, Some(name));
            run.sweep.rows.extend(row.map(|row| Row { case: Some(index), ..row }));
            run.told();
        }
        run.sweep.planned = cases.len();
        run.end()
    }
}

struct Run<'a, C, P> {
    specimen: &'a mut C,
    progress: P,
    sweep: Sweep,
    watch: Watch<Place>,
    done: usize,
}

impl<'a, C: Specimen, P: FnMut(usize)> Run<'a, C, P> {
    fn new(specimen: &'a mut C, progress: P) -> Self {
        let (sweep, watch) = (Sweep::default(), Watch::default());
        Self { specimen, progress, sweep, watch, done: 0 }
    }

    /// Adds the states of a plan.
    fn plan(&mut self, plan: &SweepPlan, name: Option<&String>) {
        let values = plan.values();
        self.sweep.planned += values.len();
        let middle = (0..values.len())
            .min_by(|&a, &b| values[a].abs().total_cmp(&values[b].abs()))
            .unwrap_or_default();
        let (before, after) = values.split_at(middle);

        self.watch.restart();
        let outwards = self.follow(plan, after.iter(), name);
        // Where not even the first state is reached, nothing beyond it is.
        if let ([_, ..], Some(&first)) = (outwards.as_slice(), after.first())
            && !before.is_empty()
        {
            self.specimen.reset();
            self.watch.restart();
            if self.row(first, &plan.target(first), name).is_some() {
                let mut rows = self.follow(plan, before.iter().rev(), name);
                rows.reverse();
                self.sweep.rows.extend(rows);
            }
        }
        self.sweep.rows.extend(outwards);
    }

    fn follow<'v>(
        &mut self,
        plan: &SweepPlan,
        values: impl Iterator<Item = &'v f64>,
        name: Option<&String>,
    ) -> Vec<Row> {
        let mut rows = Vec::new();
        for &value in values {
            let Some(row) = self.row(value, &plan.target(value), name) else { break };
            rows.push(row);
            self.told();
        }
        rows
    }

    fn told(&mut self) {
        self.done += 1;
        (self.progress)(self.done);
    }

    fn row(&mut self, value: f64, target: &Target, name: Option<&String>) -> Option<Row> {
        match self.specimen.go_to(target) {
            Ok(report) => {
                let poses = self.specimen.poses();
                let place = Place { plan: name.cloned(), value };
                self.watch.look(&poses, self.specimen.mechanism(), &place);
                Some(Row {
                    value,
                    case: None,
                    poses,
                    channels: self.specimen.channel_values(),
                    iterations: report.iterations,
                    relative_residual: report.relative_residual,
                })
            }
            Err(stop) => {
                self.sweep.stops.push(Missed { at: name.cloned(), stop });
                None
            }
        }
    }

    fn end(mut self) -> Sweep {
        self.sweep.warnings = self.watch.warnings();
        self.sweep.free_motions = self.specimen.free_motions();
        let elements = self.specimen.element_channels();
        self.sweep.channels = [elements, self.specimen.joint_channels()].concat();
        self.sweep.element_channels = elements.len();
        self.sweep
    }
}
