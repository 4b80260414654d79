//! Numbers and states that several test binaries share.
#![allow(dead_code, reason = "each test binary uses a part of it")]

use hardpoint::kernels::RelationKind;
use hardpoint::relation::{Place, Shape};
use hardpoint::scalar::Scalar;
use num_dual::{Dual64, DualNum as _, DualStruct as _, HyperDual, HyperDual64};

/// A number type of `num-dual` as a scalar of ours, which the orphan rule asks for.
#[derive(Clone, Copy, Debug)]
pub struct Foreign<T>(pub T);

macro_rules! foreign {
    ($type:ty) => {
        impl std::ops::Add for Foreign<$type> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }
        impl std::ops::Sub for Foreign<$type> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }
        impl std::ops::Mul for Foreign<$type> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                Self(self.0 * other.0)
            }
        }
        impl std::ops::Div for Foreign<$type> {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                Self(self.0 / other.0)
            }
        }
        impl std::ops::Neg for Foreign<$type> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
        impl Scalar for Foreign<$type> {
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                Self(<$type>::from(value))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }
            #[inline(always)]
            fn sin(self) -> Self {
                Self(self.0.sin())
            }
            #[inline(always)]
            fn cos(self) -> Self {
                Self(self.0.cos())
            }
            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                Self(self.0.atan2(x.0))
            }
            fn atan_ratio(self, order: u8) -> Self {
                // Taylor's series ends where a product of infinitesimals vanishes.
                let (at, step) = (self.0.re(), self.0 - self.0.re());
                let series = (0..4).rev().fold(<$type>::from(0.0), |sum, n: u8| {
                    (sum * step) / f64::from(n + 1) + at.atan_ratio(order + n)
                });
                Self(series)
            }
        }
    };
}

foreign!(Dual64);
foreign!(HyperDual64);
foreign!(HyperDual<Dual64>);

/// First-order dual number.
pub type First = Foreign<Dual64>;
/// Second-order dual number with two directions.
pub type Second = Foreign<HyperDual64>;
/// Third-order dual number: each part of a second-order one has a derivative in a third direction.
pub type Third = Foreign<HyperDual<Dual64>>;

/// A random place to evaluate a relation at.
#[derive(Clone, Debug)]
pub struct State {
    /// Coordinates of both bodies, one after the other.
    pub q: [f64; 14],
    /// Parameters.
    pub h: Vec<f64>,
    /// Multipliers.
    pub lambda: Vec<f64>,
    /// Velocities of both bodies.
    pub v: [f64; 14],
}

impl State {
    /// A random state with unit Euler parameters and sizes as in a suspension.
    ///
    /// A state near a singularity of angles or near the cut of `atan2` is drawn again:
    /// rounding grows there as the derivatives do, and angles jump.
    pub fn random(shape: &Shape, rng: &mut fastrand::Rng) -> Self {
        loop {
            let state = Self::anywhere(shape, rng);
            if shape.unit != "1" || state.is_regular(shape) {
                return state;
            }
        }
    }

    fn is_regular(&self, shape: &Shape) -> bool {
        let kind = RelationKind::from_name(shape.name).expect("every shape has a kind");
        let [q_i, q_j] = [&self.q[..7], &self.q[7..]].map(|q| q.try_into().expect("seven"));
        let mut phi = vec![0.0; shape.equations];
        let mut phi_q = vec![0.0; shape.jacobian.len()];
        let mut work = vec![0.0; shape.work.len()];
        let place = Place { q_i, q_j, h: &self.h };
        kind.kernels::<f64>().jacobian(place, &mut phi, &mut phi_q, &mut work);
        phi.iter().all(|phi| phi.abs() < 2.0) && phi_q.iter().all(|entry| entry.abs() < 12.0)
    }

    fn anywhere(shape: &Shape, rng: &mut fastrand::Rng) -> Self {
        let mut q = std::array::from_fn(|_| symmetric(rng));
        for body in [0, 7] {
            unit(&mut q[body + 3..body + 7]);
        }
        let mut h: Vec<f64> = (0..shape.parameter_count()).map(|_| symmetric(rng)).collect();
        for parameter in shape.parameters {
            let range = parameter.offset..parameter.offset + parameter.size;
            if parameter.size == 3 && parameter.unit == "1" {
                unit(&mut h[range]);
            }
        }
        Self {
            q,
            h,
            lambda: (0..shape.equations).map(|_| symmetric(rng)).collect(),
            v: std::array::from_fn(|_| symmetric(rng)),
        }
    }
}

fn symmetric(rng: &mut fastrand::Rng) -> f64 {
    2.0 * rng.f64() - 1.0
}

fn unit(vector: &mut [f64]) {
    let norm = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    vector.iter_mut().for_each(|x| *x /= norm);
}

/// The rotation matrix of Euler parameters, in the textbook form.
pub fn rotation_matrix(p: &[f64]) -> [[f64; 3]; 3] {
    let (e0, e1, e2, e3) = (p[0], p[1], p[2], p[3]);
    [
        [2.0 * (e0 * e0 + e1 * e1) - 1.0, 2.0 * (e1 * e2 - e0 * e3), 2.0 * (e1 * e3 + e0 * e2)],
        [2.0 * (e1 * e2 + e0 * e3), 2.0 * (e0 * e0 + e2 * e2) - 1.0, 2.0 * (e2 * e3 - e0 * e1)],
        [2.0 * (e1 * e3 - e0 * e2), 2.0 * (e2 * e3 + e0 * e1), 2.0 * (e0 * e0 + e3 * e3) - 1.0],
    ]
}

/// Matrix times vector.
pub fn times(a: &[[f64; 3]; 3], s: &[f64]) -> [f64; 3] {
    std::array::from_fn(|row| (0..3).map(|k| a[row][k] * s[k]).sum())
}

/// Scalar product.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
