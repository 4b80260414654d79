//! A trajectory of chosen outputs.

use super::Dynamics;
use super::failure::DynamicsFailure;

/// When a mechanism is at rest: both speeds and accelerations are small, so that a point of return
/// is not taken for rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Largest speed (m/s), see [`Dynamics::largest_speed`].
    pub speed: f64,
    /// Largest acceleration (m/s²).
    pub acceleration: f64,
}

/// How long a motion is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SettlePlan {
    /// The time (s) at which it ends at the latest.
    pub until: f64,
    /// The time (s) from one sample to the next.
    pub interval: f64,
    /// Ends the motion earlier, at the first sample at rest.
    pub rest: Option<Rest>,
}

/// Samples of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory<T> {
    /// Time (s) and what was sampled then; the first sample is the start.
    pub samples: Vec<(f64, T)>,
    /// The time (s) at which the mechanism was found at rest.
    pub rest: Option<f64>,
    /// Why the motion ended too early.
    pub stop: Option<DynamicsFailure>,
}

impl Dynamics {
    /// Follows the motion and samples it. The last sample is at the end, also where the interval
    /// does not divide the time. What was reached before a failure is kept.
    ///
    /// # Errors
    /// [`DynamicsFailure::Setting`] for an interval that is not above zero, and
    /// [`DynamicsFailure::Time`] for an end that has passed.
    pub fn settle<T>(
        &mut self,
        plan: &SettlePlan,
        mut sample: impl FnMut(&Self) -> T,
    ) -> Result<Trajectory<T>, DynamicsFailure> {
        if !(plan.interval > 0.0 && plan.interval.is_finite()) {
            let (what, range) = ("sampling interval (s)", "greater than zero");
            return Err(DynamicsFailure::Setting { what, value: plan.interval, range });
        }
        let start = self.time();
        if !(plan.until >= start && plan.until.is_finite()) {
            return Err(DynamicsFailure::Time { to: plan.until, time: start });
        }
        let mut trajectory =
            Trajectory { samples: vec![(start, sample(self))], rest: None, stop: None };
        let mut number = 0.0;
        while self.time() < plan.until {
            number += 1.0;
            let mut next = start + number * plan.interval;
            if next > plan.until - 1e-9 * plan.interval {
                next = plan.until;
            }
            if let Err(stop) = self.advance_to(next) {
                trajectory.stop = Some(stop);
                break;
            }
            trajectory.samples.push((next, sample(self)));
            if plan.rest.is_some_and(|rest| self.is_at_rest(rest)) {
                trajectory.rest = Some(next);
                break;
            }
        }
        Ok(trajectory)
    }

    fn is_at_rest(&self, rest: Rest) -> bool {
        self.largest_speed() <= rest.speed && self.largest_acceleration() <= rest.acceleration
    }
}
