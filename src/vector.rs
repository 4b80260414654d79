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

/// Tait–Bryan angles (a, b, c) (rad) of a rotation matrix R = Rx(a) Ry(b) Rz(c).
///
/// At b = ±90° only a ± c is determined and the angles have no derivative.
pub fn rotation_angles<S: Scalar>(r: [[S; 3]; 3]) -> [S; 3] {
    let across = (r[0][0] * r[0][0] + r[0][1] * r[0][1]).sqrt();
    [(-r[1][2]).atan2(r[2][2]), r[0][2].atan2(across), (-r[0][1]).atan2(r[0][0])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotation_angles_are_those_that_made_the_matrix() {
        let (a, b, c) = (0.3_f64, -0.4_f64, 2.5_f64);
        let (sa, ca) = a.sin_cos();
        let (sb, cb) = b.sin_cos();
        let (sc, cc) = c.sin_cos();
        let r = [
            [cb * cc, -cb * sc, sb],
            [ca * sc + sa * sb * cc, ca * cc - sa * sb * sc, -sa * cb],
            [sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb],
        ];
        for (found, expected) in rotation_angles(r).iter().zip([a, b, c]) {
            assert!((found - expected).abs() < 1e-15);
        }
    }
}
