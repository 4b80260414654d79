//! Drivers that follow a course of time.

use super::Dynamics;
use crate::mechanism::{Course, DriverId, Expansion, Jet, Mechanism, Owner};

/// A driver in motion.
pub(super) struct Driven {
    /// The parameter that its value is added to.
    slot: usize,
    /// The parameter at the start.
    start: f64,
    /// Its equation.
    pub(super) equation: usize,
    course: Course,
    /// Value, speed and acceleration at the time at hand.
    pub(super) now: Jet,
}

/// The drivers with a course, but for those that are released.
pub(super) fn driven(
    mechanism: &Mechanism,
    expansion: &Expansion,
    released: &[DriverId],
    h: &[f64],
) -> Vec<Driven> {
    let held = mechanism.driver_ids().filter(|driver| !released.contains(driver));
    held.filter_map(|driver| {
        let course = mechanism.drivers()[driver.index()].course.clone()?;
        let equation = expansion.equations_of(Owner::Driver(driver)).next()?;
        let slot = expansion.driver_slot(driver);
        let now = course.at(0.0);
        Some(Driven { slot, start: h[slot], equation, course, now })
    })
    .collect()
}

impl Dynamics {
    /// Sets the drivers to where they are at a time (s).
    pub(super) fn set_clock(&mut self, time: f64) {
        for driven in &mut self.driven {
            driven.now = driven.course.at(time);
            self.h[driven.slot] = driven.start + driven.now.value;
        }
    }

    /// The power (W) of the drivers: what they are moved by, which is −λ, times their speed.
    pub(super) fn driven_power(&self) -> f64 {
        let power = |driven: &Driven| -self.now.lambda[driven.equation] * driven.now.first;
        self.driven.iter().map(power).sum()
    }
}
