//! Axis systems and sides. Everything inside is in ISO 8855 axes.

use crate::scalar::Scalar;
use crate::vector::Vector;

/// An axis system of a vehicle. All three are right-handed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// ISO 8855: x forward, y left, z up.
    Iso8855,
    /// Adams/Car and Lotus: x rearward, y right, z up.
    Adams,
    /// SAE J670: x forward, y right, z down.
    Sae,
}

impl Axes {
    /// The names of model files.
    pub(crate) const CHOICES: &[(&str, Self)] =
        &[("iso8855", Self::Iso8855), ("adams", Self::Adams), ("sae", Self::Sae)];

    /// The name, as in model files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Iso8855 => "iso8855",
            Self::Adams => "adams",
            Self::Sae => "sae",
        }
    }

    /// The diagonal of the rotation D between these axes and ISO 8855: a turn
    /// by 180° about z (Adams) or x (SAE), so D is its own inverse.
    pub const fn signs(self) -> [f64; 3] {
        match self {
            Self::Iso8855 => [1.0, 1.0, 1.0],
            Self::Adams => [-1.0, -1.0, 1.0],
            Self::Sae => [1.0, -1.0, -1.0],
        }
    }

    /// A vector given in these axes, in ISO 8855 axes.
    pub fn to_iso<S: Scalar>(self, vector: Vector<S>) -> Vector<S> {
        let signs = self.signs().map(S::from_f64);
        // Adding zero turns −0 into 0, which would print as "-0.000".
        std::array::from_fn(|i| signs[i] * vector[i] + S::from_f64(0.0))
    }

    /// A vector given in ISO 8855 axes, in these axes.
    pub fn from_iso<S: Scalar>(self, vector: Vector<S>) -> Vector<S> {
        self.to_iso(vector)
    }

    /// A rotation matrix (rows first) given in these axes, in ISO 8855 axes: D R D.
    pub fn rotation_to_iso<S: Scalar>(self, matrix: [[S; 3]; 3]) -> [[S; 3]; 3] {
        let (signs, zero) = (self.signs().map(S::from_f64), S::from_f64(0.0));
        std::array::from_fn(|i| std::array::from_fn(|j| signs[i] * matrix[i][j] * signs[j] + zero))
    }

    /// A rotation matrix (rows first) given in ISO 8855 axes, in these axes: D R D.
    pub fn rotation_from_iso<S: Scalar>(self, matrix: [[S; 3]; 3]) -> [[S; 3]; 3] {
        self.rotation_to_iso(matrix)
    }
}

/// The side of the vehicle that the points describe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left, seen by the driver: y > 0 in ISO 8855 axes.
    Left,
    /// Right: y < 0 in ISO 8855 axes.
    Right,
}

impl Side {
    /// The names of model files.
    pub(crate) const CHOICES: &[(&str, Self)] = &[("left", Self::Left), ("right", Self::Right)];

    /// The name, as in model files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }

    /// σ: +1 for the left wheel, −1 for the right, the sign of y outboard in ISO 8855 axes.
    pub const fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// Its place where values stand as left, right.
    pub const fn index(self) -> usize {
        match self {
            Self::Left => 0,
            Self::Right => 1,
        }
    }

    /// The other side.
    pub const fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}
