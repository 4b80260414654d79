//! How a mechanism moves with the value of a driver.

use super::motion::Twist;
use crate::mechanism::BodyId;
use crate::relation::{BODY_COORDINATES, Coordinates};

/// The derivative of a state by the value of a driver (per m or rad), the other drivers held.
#[derive(Clone, Copy, Debug)]
pub struct Tangent<'a> {
    state: &'a [Coordinates<f64>],
    rates: &'a [f64],
}

impl<'a> Tangent<'a> {
    /// `rates` has seven entries for each body of `state` but the ground.
    pub(super) fn new(state: &'a [Coordinates<f64>], rates: &'a [f64]) -> Self {
        Self { state, rates }
    }

    /// The state at which it is: coordinates of all bodies, the ground first.
    pub fn state(&self) -> &'a [Coordinates<f64>] {
        self.state
    }

    /// The derivatives of the coordinates, seven for each moving body.
    pub fn coordinates(&self) -> &'a [f64] {
        self.rates
    }

    /// How a body moves per unit of the driver; the ground does not.
    ///
    /// # Panics
    /// If the body belongs to another mechanism.
    pub fn twist(&self, body: BodyId) -> Twist {
        let Some(first) = body.index().checked_sub(1).map(|moving| BODY_COORDINATES * moving)
        else {
            return Twist::default();
        };
        Twist::new(&self.state[body.index()], &self.rates[first..first + BODY_COORDINATES])
    }
}
