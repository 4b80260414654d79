//! Static toe and camber, and the spin axis that they stand for.

use super::axes::Side;

/// Static alignment of a wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alignment {
    /// Toe (rad), positive toe-in: atan2(s_x, |s_y|) with s the outboard spin axis, ISO 8855 axes.
    pub toe: f64,
    /// Camber (rad), positive with the top outboard: −asin(s_z).
    pub camber: f64,
}

impl Alignment {
    /// The unit spin axis pointing outboard, in ISO 8855 axes:
    /// s = (cos c sin t, σ cos c cos t, −sin c), σ = +1 left, −1 right.
    pub fn spin_axis(self, side: Side) -> [f64; 3] {
        let (sin_toe, cos_toe) = self.toe.sin_cos();
        let (sin_camber, cos_camber) = self.camber.sin_cos();
        [cos_camber * sin_toe, side.sign() * cos_camber * cos_toe, -sin_camber]
    }

    /// The alignment of a unit spin axis pointing outboard, in ISO 8855 axes.
    pub fn of_spin_axis(spin: [f64; 3]) -> Self {
        Self { toe: spin[0].atan2(spin[1].abs()), camber: -spin[2].clamp(-1.0, 1.0).asin() }
    }
}
