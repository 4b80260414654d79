//! The few operations on 3-vectors that have to be generic over [`Scalar`].

use crate::scalar::Scalar;

/// A vector of three components.
pub type Vector<S> = [S; 3];

/// `a + b`.
pub fn add<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    std::array::from_fn(|k| a[k] + b[k])
}

/// `a − b`.
pub fn sub<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    std::array::from_fn(|k| a[k] - b[k])
}

/// `factor · a`.
pub fn scale<S: Scalar>(factor: S, a: Vector<S>) -> Vector<S> {
    a.map(|component| factor * component)
}

/// The scalar product.
pub fn dot<S: Scalar>(a: Vector<S>, b: Vector<S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
pub fn cross<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The Euclidean length.
pub fn norm<S: Scalar>(a: Vector<S>) -> S {
    dot(a, a).sqrt()
}

/// The vector of length one in the direction of `a`; not finite for a zero vector.
pub fn unit<S: Scalar>(a: Vector<S>) -> Vector<S> {
    let length = norm(a);
    a.map(|component| component / length)
}

/// The constant vector `a` without any derivative part.
pub fn constant<S: Scalar>(a: Vector<f64>) -> Vector<S> {
    a.map(S::from_f64)
}

/// `A(p) s`: the vector `s`, turned by the Euler parameters `p` (paper, eq. 8).
pub fn rotate<S: Scalar>(p: [S; 4], s: Vector<S>) -> Vector<S> {
    let e = [p[1], p[2], p[3]];
    let c = add(scale(p[0], s), cross(e, s));
    add(add(scale(p[0], c), scale(dot(e, s), e)), cross(e, c))
}
