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
    /// The derivative of this order of g(x) = atan(√x)/√x, g(0) = 1, for x > −1.
    ///
    /// Twice the vector part of Euler parameters over the scalar part, times g of the
    /// square of that quotient, is a rotation vector, at zero rotation as anywhere.
    fn atan_ratio(self, order: u8) -> Self;
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
    fn atan_ratio(self, order: u8) -> Self {
        if (-0.25..=1.0).contains(&self) {
            atan_ratio_near_zero(self, order)
        } else {
            atan_ratio_far_from_zero(self, order)
        }
    }
}

/// (−1)ⁿ n!/(2n + 1) F(n + 1, n + ½; n + 3/2; −x) in powers of x/(1 + x), whose terms
/// are all positive for x > 0 (Abramowitz and Stegun, 15.3.4).
fn atan_ratio_near_zero(x: f64, order: u8) -> f64 {
    let n = f64::from(order);
    let mut power = 1.0;
    for factor in 1..=order {
        power *= -f64::from(factor) / (1.0 + x);
    }
    let ratio = x / (1.0 + x);
    let (mut sum, mut term, mut k) = (0.0, 1.0, 0.0);
    while f64::abs(term) > f64::EPSILON / 8.0 {
        sum += term;
        term *= ratio * (n + 1.0 + k) / (n + 1.5 + k);
        k += 1.0;
    }
    power / (1.0 + x) * sum / (2.0 * n + 1.0)
}

/// From order to order by 2x g⁽ⁿ⁺¹⁾ + (2n + 1) g⁽ⁿ⁾ = (−1)ⁿ n!/(1 + x)ⁿ⁺¹, which loses
/// digits only near zero. Not a number for x ≤ −1.
fn atan_ratio_far_from_zero(x: f64, order: u8) -> f64 {
    let root = x.abs().sqrt();
    let mut value = if x > 0.0 { root.atan() / root } else { root.atanh() / root };
    let mut power = 1.0 / (1.0 + x);
    for n in 0..order {
        let n = f64::from(n);
        value = (power - (2.0 * n + 1.0) * value) / (2.0 * x);
        power *= -(n + 1.0) / (1.0 + x);
    }
    value
}

/// A scalar that is one number, whose size decides between cases.
///
/// Formulas of factors ask with it whether something is defined, such as the
/// intersection of lines; a kernel never does.
pub trait Real: Scalar {
    /// The number itself, without derivative parts.
    fn value(self) -> f64;
}

impl Real for f64 {
    fn value(self) -> f64 {
        self
    }
}

/// A forward dual number `value + ε derivative`, ε² = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual<S = f64> {
    /// The value.
    pub value: S,
    /// The directional derivative.
    pub derivative: S,
}

impl<S: Copy> Dual<S> {
    /// The dual number `value + ε derivative`.
    pub const fn new(value: S, derivative: S) -> Self {
        Self { value, derivative }
    }
}

impl<S: Real> Real for Dual<S> {
    fn value(self) -> f64 {
        self.value.value()
    }
}

impl<S: Scalar> Add for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.derivative + other.derivative)
    }
}

impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.derivative - other.derivative)
    }
}

impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.value * other.value,
            self.derivative * other.value + self.value * other.derivative,
        )
    }
}

impl<S: Scalar> Div for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::new(value, (self.derivative - value * other.derivative) / other.value)
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.value, -self.derivative)
    }
}

impl<S: Scalar> Scalar for Dual<S> {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::new(S::from_f64(value), S::from_f64(0.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.derivative / (S::from_f64(2.0) * root))
    }
    #[inline(always)]
    fn sin(self) -> Self {
        Self::new(self.value.sin(), self.derivative * self.value.cos())
    }
    #[inline(always)]
    fn cos(self) -> Self {
        Self::new(self.value.cos(), -(self.derivative * self.value.sin()))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let square = x.value * x.value + self.value * self.value;
        let derivative = (self.derivative * x.value - x.derivative * self.value) / square;
        Self::new(self.value.atan2(x.value), derivative)
    }
    fn atan_ratio(self, order: u8) -> Self {
        let slope = self.value.atan_ratio(order + 1);
        Self::new(self.value.atan_ratio(order), self.derivative * slope)
    }
}
