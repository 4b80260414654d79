//! Vector dual numbers: all directions in one evaluation.
//!
//! The number type is ours and not `DualSVec64` of `num-dual`, whose vector types
//! need nalgebra. It is a plain array, which the compiler turns into SIMD.

use std::ops::{Add, Div, Mul, Neg, Sub};

use hardpoint::kernels::RelationKind;
use hardpoint::relation::Place;
use hardpoint::scalar::Scalar;

use super::programs::{self, Program};
use super::{Arguments, Blocks, Contraction, columns};

/// A value with its derivatives along N coordinates.
#[derive(Clone, Copy)]
struct Gradient<const N: usize> {
    value: f64,
    derivatives: [f64; N],
}

impl<const N: usize> Gradient<N> {
    #[inline(always)]
    fn new(value: f64, derivative: impl Fn(usize) -> f64) -> Self {
        Self { value, derivatives: std::array::from_fn(derivative) }
    }

    /// f(self) from the value and the slope of f.
    #[inline(always)]
    fn chain(self, value: f64, slope: f64) -> Self {
        Self::new(value, |k| slope * self.derivatives[k])
    }

    /// f(a, b) from the value and the slopes of f.
    #[inline(always)]
    fn chain_two(value: f64, [a, b]: [Self; 2], slopes: [f64; 2]) -> Self {
        Self::new(value, |k| slopes[0] * a.derivatives[k] + slopes[1] * b.derivatives[k])
    }
}

impl<const N: usize> Add for Gradient<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, |k| self.derivatives[k] + other.derivatives[k])
    }
}

impl<const N: usize> Sub for Gradient<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, |k| self.derivatives[k] - other.derivatives[k])
    }
}

impl<const N: usize> Mul for Gradient<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::chain_two(self.value * other.value, [self, other], [other.value, self.value])
    }
}

impl<const N: usize> Div for Gradient<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let inverse = 1.0 / other.value;
        Self::new(value, |k| (self.derivatives[k] - value * other.derivatives[k]) * inverse)
    }
}

impl<const N: usize> Neg for Gradient<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl<const N: usize> Scalar for Gradient<N> {
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self { value, derivatives: [0.0; N] }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    #[inline(always)]
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }
    #[inline(always)]
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let slopes = [x.value / square, -self.value / square];
        Self::chain_two(self.value.atan2(x.value), [self, x], slopes)
    }
    fn atan_ratio(self, order: u8) -> Self {
        self.chain(self.value.atan_ratio(order), self.value.atan_ratio(order + 1))
    }
}

/// Φ_q from Φ in one evaluation.
pub fn for_jacobian(kind: RelationKind) -> Box<dyn Blocks> {
    // No more lanes than there are directions: the Euler parameters of a pair
    // are eight, all its coordinates fourteen.
    let directions = columns(kind.shape().jacobian);
    match directions.len() {
        ..=8 => Box::new(Gradients::<8>::new(kind, programs::residual(kind), directions)),
        _ => Box::new(Gradients::<14>::new(kind, programs::residual(kind), directions)),
    }
}

/// (Φ_qᵀλ)_q from the symbolic Φ_q in one evaluation.
pub fn for_curvature(kind: RelationKind) -> Box<dyn Blocks> {
    let directions = columns(kind.shape().curvature);
    match directions.len() {
        ..=8 => Box::new(Gradients::<8>::new(kind, programs::jacobian(kind), directions)),
        _ => Box::new(Gradients::<14>::new(kind, programs::jacobian(kind), directions)),
    }
}

struct Gradients<const N: usize> {
    // The program whose derivative is wanted.
    program: Program<Gradient<N>>,
    pattern: &'static [(u8, u8)],
    arguments: Arguments<Gradient<N>>,
    contraction: Contraction,
    // The lane of each entry of Φ_q, none where it has none.
    lanes: Vec<Option<usize>>,
    phi: Vec<Gradient<N>>,
    phi_q: Vec<Gradient<N>>,
}

impl<const N: usize> Gradients<N> {
    fn new(kind: RelationKind, program: Program<Gradient<N>>, directions: Vec<usize>) -> Self {
        let shape = kind.shape();
        let lane = |column: u8| directions.iter().position(|&d| d == usize::from(column));
        Self {
            program,
            pattern: shape.jacobian,
            arguments: Arguments::new(shape),
            lanes: shape.jacobian.iter().map(|&(_, column)| lane(column)).collect(),
            contraction: Contraction::along(shape, directions),
            phi: vec![Gradient::from_f64(0.0); shape.equations],
            phi_q: vec![Gradient::from_f64(0.0); shape.jacobian.len()],
        }
    }

    fn evaluate(&mut self, place: Place<'_, f64>) {
        self.arguments.set(place);
        for (lane, &direction) in self.contraction.directions.iter().enumerate() {
            self.arguments.coordinate(direction).derivatives[lane] = 1.0;
        }
        (self.program)(self.arguments.place(), &mut self.phi, &mut self.phi_q);
    }
}

impl<const N: usize> Blocks for Gradients<N> {
    fn jacobian(&mut self, place: Place<'_, f64>, phi: &mut [f64], phi_q: &mut [f64]) {
        self.evaluate(place);
        for (to, from) in phi.iter_mut().zip(&self.phi) {
            *to = from.value;
        }
        let pattern = self.pattern.iter().zip(&self.lanes);
        for (entry, (&(row, _), lane)) in phi_q.iter_mut().zip(pattern) {
            let lane = lane.expect("made for the Jacobian");
            *entry = self.phi[usize::from(row)].derivatives[lane];
        }
    }

    fn curvature(
        &mut self,
        place: Place<'_, f64>,
        lambda: &[f64],
        phi: &mut [f64],
        phi_q: &mut [f64],
        curvature: &mut [f64],
    ) {
        self.evaluate(place);
        for (to, from) in phi.iter_mut().zip(&self.phi).chain(phi_q.iter_mut().zip(&self.phi_q)) {
            *to = from.value;
        }
        curvature.fill(0.0);
        for (lane, products) in self.contraction.products.iter().enumerate() {
            for product in products {
                curvature[product.entry] +=
                    lambda[product.equation] * self.phi_q[product.output].derivatives[lane];
            }
        }
    }
}
