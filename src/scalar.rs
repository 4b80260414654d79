//! The numbers that kernels compute with.
//!
//! Kernels, the expansion of hard points into relation parameters and the
//! formulas of the factors are generic over [`Scalar`], so the code that
//! computes a value also computes its exact derivative when it runs on [`Dual`].

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number that kernels can compute with.
///
/// The trait has no comparisons and no `powf` on purpose: a kernel is one
/// straight line of smooth operations, the same for every number type.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The number `value` without any derivative part.
    fn from_f64(value: f64) -> Self;
    /// The non-negative square root.
    fn sqrt(self) -> Self;
    /// The sine of an angle in radians.
    fn sin(self) -> Self;
    /// The cosine of an angle in radians.
    fn cos(self) -> Self;
    /// The angle (rad) of the point (`x`, `self`) from the x axis, in (−π, π].
    fn atan2(self, x: Self) -> Self;
}

impl Scalar for f64 {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn sin(self) -> Self {
        f64::sin(self)
    }
    #[inline(always)]
    fn cos(self) -> Self {
        f64::cos(self)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        f64::atan2(self, x)
    }
}

/// A forward dual number `value + ε derivative`, ε² = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// The directional derivative.
    pub derivative: f64,
}

impl Dual {
    /// The dual number `value + ε derivative`.
    pub const fn new(value: f64, derivative: f64) -> Self {
        Self { value, derivative }
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.derivative + other.derivative)
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.derivative - other.derivative)
    }
}

impl Mul for Dual {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.value * other.value,
            self.derivative * other.value + self.value * other.derivative,
        )
    }
}

impl Div for Dual {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::new(value, (self.derivative - value * other.derivative) / other.value)
    }
}

impl Neg for Dual {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.value, -self.derivative)
    }
}

impl Scalar for Dual {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::new(value, 0.0)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.derivative / (2.0 * root))
    }
    #[inline(always)]
    fn sin(self) -> Self {
        let (sin, cos) = self.value.sin_cos();
        Self::new(sin, self.derivative * cos)
    }
    #[inline(always)]
    fn cos(self) -> Self {
        let (sin, cos) = self.value.sin_cos();
        Self::new(cos, -self.derivative * sin)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let square = x.value * x.value + self.value * self.value;
        let derivative = (self.derivative * x.value - x.derivative * self.value) / square;
        Self::new(self.value.atan2(x.value), derivative)
    }
}
