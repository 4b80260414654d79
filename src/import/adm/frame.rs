//! Places and axes of parts and markers.

use crate::vector::{Vector, add, cross, dot, norm, scale, sub, unit};

/// An origin with three unit axes x, y and z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) origin: Vector<f64>,
    pub(super) axes: [Vector<f64>; 3],
}

/// An angle as it is written: quarter turns in degrees have exact sines.
#[derive(Clone, Copy, Debug)]
pub(super) enum Angle {
    Degrees(f64),
    Radians(f64),
}

impl Angle {
    fn sin_cos(self) -> (f64, f64) {
        match self {
            Self::Radians(angle) => angle.sin_cos(),
            Self::Degrees(angle) => match angle.rem_euclid(360.0) {
                0.0 => (0.0, 1.0),
                90.0 => (1.0, 0.0),
                180.0 => (0.0, -1.0),
                270.0 => (-1.0, 0.0),
                _ => angle.to_radians().sin_cos(),
            },
        }
    }
}

impl Frame {
    pub(super) const GROUND: Self =
        Self { origin: [0.0; 3], axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };

    /// The vector with these components along the axes.
    pub(super) fn vector(&self, [x, y, z]: Vector<f64>) -> Vector<f64> {
        let [along_x, along_y, along_z] = self.axes;
        add(add(scale(x, along_x), scale(y, along_y)), scale(z, along_z))
    }

    /// The point with these coordinates.
    pub(super) fn point(&self, coordinates: Vector<f64>) -> Vector<f64> {
        add(self.origin, self.vector(coordinates))
    }

    /// A frame inside this one, in the frame of the ground.
    pub(super) fn outward(&self, inner: &Self) -> Self {
        Self { origin: self.point(inner.origin), axes: inner.axes.map(|axis| self.vector(axis)) }
    }

    /// Axes turned by body-fixed angles about z, the new x and the new z (Adams' REULER).
    pub(super) fn turned(origin: Vector<f64>, angles: [Angle; 3]) -> Self {
        let [(s1, c1), (s2, c2), (s3, c3)] = angles.map(Angle::sin_cos);
        let x = [c1 * c3 - s1 * c2 * s3, s1 * c3 + c1 * c2 * s3, s2 * s3];
        let y = [-c1 * s3 - s1 * c2 * c3, -s1 * s3 + c1 * c2 * c3, s2 * c3];
        let z = [s1 * s2, -c1 * s2, c2];
        Self { origin, axes: [x, y, z] }
    }

    /// Axes with z through one point and x towards another one; `None` where they give no frame.
    pub(super) fn through(
        origin: Vector<f64>,
        on_z: Option<Vector<f64>>,
        near_x: Option<Vector<f64>>,
    ) -> Option<Self> {
        let towards = |point| {
            let way = sub(point, origin);
            (norm(way) > 0.0).then(|| unit(way))
        };
        let z = match on_z {
            Some(point) => towards(point)?,
            None => [0.0, 0.0, 1.0],
        };
        let x = match near_x {
            Some(point) => towards(point)?,
            // Any will do: the coordinate axis farthest from z.
            None => {
                let farthest = if z[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
                unit(sub(farthest, scale(dot(farthest, z), z)))
            }
        };
        let y = cross(z, x);
        if norm(y) < 1e-9 {
            return None;
        }
        let y = unit(y);
        Some(Self { origin, axes: [cross(y, z), y, z] })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact_and_axes_right_handed() {
        use Angle::{Degrees, Radians};
        let frame = Frame::turned([0.0; 3], [180.0, 90.0, 180.0].map(Degrees));
        assert_eq!(frame.axes, [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]);
        let frame = Frame::turned([0.0; 3], [0.3, -1.2, 2.0].map(Radians));
        let [x, y, z] = frame.axes;
        assert!(norm(sub(cross(x, y), z)) < 1e-15 && dot(x, y).abs() < 1e-15);
    }

    #[test]
    fn points_give_the_axes() {
        let frame = Frame::through([1.0, 0.0, 0.0], Some([1.0, 2.0, 0.0]), Some([1.0, 5.0, 3.0]));
        assert_eq!(frame.unwrap().axes, [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!(Frame::through([0.0; 3], Some([0.0; 3]), None), None);
        assert_eq!(Frame::through([0.0; 3], Some([0.0, 0.0, 1.0]), Some([0.0, 0.0, 3.0])), None);
    }
}
