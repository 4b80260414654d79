//! Static toe and camber, and the spin axis that they stand for.

use super::axes::Side;
use crate::scalar::Scalar;

/// Static alignment of a wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alignment<S = f64> {
    /// Toe (rad), positive toe-in: atan2(s_x, |s_y|) with s the outboard spin axis, ISO 8855 axes.
    pub toe: S,
    /// Camber (rad), positive with the top outboard: −asin(s_z).
    pub camber: S,
}

impl<S: Scalar> Alignment<S> {
    /// The unit spin axis pointing outboard, in ISO 8855 axes:
    /// s = (cos c sin t, σ cos c cos t, −sin c), σ = +1 left, −1 right.
    pub fn spin_axis(self, side: Side) -> [S; 3] {
        let (sin_toe, cos_toe) = (self.toe.sin(), self.toe.cos());
        let (sin_camber, cos_camber) = (self.camber.sin(), self.camber.cos());
        let sigma = S::from_f64(side.sign());
        [cos_camber * sin_toe, sigma * cos_camber * cos_toe, -sin_camber]
    }
}

impl Alignment {
    /// The alignment of a unit spin axis pointing outboard, in ISO 8855 axes.
    pub fn of_spin_axis(spin: [f64; 3]) -> Self {
        Self { toe: spin[0].atan2(spin[1].abs()), camber: -spin[2].clamp(-1.0, 1.0).asin() }
    }
}
