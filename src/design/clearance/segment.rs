//! Distances of straight links.

use super::length;
use crate::scalar::Real;
use crate::vector::{Vector, cross, dot, norm, scale, sub};

/// The two ends of a straight link.
pub type Segment<S> = [Vector<S>; 2];

/// Links whose directions differ by less than this (the sine of the angle) count as parallel: then one of the
/// ends is nearest.
const PARALLEL: f64 = 1e-6;

/// The smallest distance of two segments, in all cases: inside of both, at an end, parallel, of no length.
///
/// Where they cross the distance is zero, and it has a kink.
pub fn between_segments<S: Real>(a: Segment<S>, b: Segment<S>) -> S {
    if let Some(distance) = inside_both(a, b) {
        return distance;
    }
    let ends = [
        segment_to_point(a, b[0]),
        segment_to_point(a, b[1]),
        segment_to_point(b, a[0]),
        segment_to_point(b, a[1]),
    ];
    smallest(ends)
}

fn smallest<S: Real, const N: usize>(distances: [S; N]) -> S {
    let nearer = |a: S, b: S| if b.value() < a.value() { b } else { a };
    distances.into_iter().reduce(nearer).unwrap_or(S::from_f64(f64::INFINITY))
}

/// The distance of the lines, where they are nearest inside of both segments (Ericson, Real-Time Collision
/// Detection, 5.1.9).
fn inside_both<S: Real>(a: Segment<S>, b: Segment<S>) -> Option<S> {
    let (u, v, apart) = (sub(a[1], a[0]), sub(b[1], b[0]), sub(b[0], a[0]));
    let normal = cross(u, v);
    let [uu, uv, vv] = [dot(u, u), dot(u, v), dot(v, v)].map(Real::value);
    let [ua, va] = [dot(u, apart), dot(v, apart)].map(Real::value);
    let square = dot(normal, normal).value();
    if square <= PARALLEL * PARALLEL * uu * vv {
        return None;
    }
    let along_a = (ua * vv - va * uv) / square;
    let along_b = (ua * uv - va * uu) / square;
    if !(0.0..=1.0).contains(&along_a) || !(0.0..=1.0).contains(&along_b) {
        return None;
    }
    // Unlike the length of the shortest line, this has a derivative where they touch, too.
    let distance = dot(apart, normal) / norm(normal);
    Some(if distance.value() < 0.0 { -distance } else { distance })
}

/// The smallest distance of a segment, which may have no length, from a point.
pub fn segment_to_point<S: Real>([from, to]: Segment<S>, point: Vector<S>) -> S {
    let (along, apart) = (sub(to, from), sub(point, from));
    let (part, whole) = (dot(apart, along), dot(along, along));
    if part.value() <= 0.0 || whole.value() == 0.0 {
        return length(apart);
    }
    if part.value() >= whole.value() {
        return length(sub(point, to));
    }
    length(sub(apart, scale(part / whole, along)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALONG_X: Segment<f64> = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]];

    #[test]
    fn segments_are_as_far_apart_as_their_nearest_points() {
        let distance = |other| {
            let there = between_segments(ALONG_X, other);
            assert_eq!(there, between_segments(other, ALONG_X));
            there
        };
        // Crossing above the middle, touching, and beyond the end.
        assert_eq!(distance([[1.0, -1.0, 0.5], [1.0, 1.0, 0.5]]), 0.5);
        assert_eq!(distance([[1.0, -1.0, 0.0], [1.0, 1.0, 0.0]]), 0.0);
        assert_eq!(distance([[5.0, 4.0, 0.0], [5.0, 9.0, 0.0]]), 5.0);
        // An end above the other one's middle.
        assert_eq!(distance([[1.0, 0.0, 2.0], [1.5, 0.0, 4.0]]), 2.0);
        // Parallel: side by side, one behind the other, on one line.
        assert_eq!(distance([[1.0, 0.0, 3.0], [4.0, 0.0, 3.0]]), 3.0);
        assert_eq!(distance([[5.0, 4.0, 0.0], [7.0, 4.0, 0.0]]), 5.0);
        assert_eq!(distance([[5.0, 0.0, 0.0], [7.0, 0.0, 0.0]]), 3.0);
        // Of no length.
        assert_eq!(distance([[1.0, 1.0, 0.0]; 2]), 1.0);
        assert_eq!(between_segments([[0.0; 3]; 2], [[0.0, 3.0, 4.0]; 2]), 5.0);
    }

    #[test]
    fn points_are_nearest_to_the_inside_or_an_end() {
        assert_eq!(segment_to_point(ALONG_X, [1.5, 3.0, 4.0]), 5.0);
        assert_eq!(segment_to_point(ALONG_X, [-3.0, 0.0, 4.0]), 5.0);
        assert_eq!(segment_to_point(ALONG_X, [5.0, 4.0, 0.0]), 5.0);
        assert_eq!(segment_to_point(ALONG_X, [1.0, 0.0, 0.0]), 0.0);
    }
}
