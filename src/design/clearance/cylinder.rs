//! Distances from what turns with the wheel: the rim and the tyre.

use super::length;
use super::segment::Segment;
use crate::scalar::{Dual, Real, Scalar};
use crate::vector::{Vector, add, constant, dot, scale, sub};

/// Where the nearest place of a segment is looked for first: farther apart than this part of its length,
/// two places may be nearest.
const PARTS: u32 = 32;

/// Halvings of the part in which the nearest place lies; it is exact then.
const HALVINGS: u32 = 60;

/// A round part about the spin axis of the wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder<S> {
    /// The middle, on the axis.
    pub center: Vector<S>,
    /// The unit vector of the axis.
    pub axis: Vector<S>,
    /// Radius.
    pub radius: f64,
    /// Width along the axis.
    pub width: f64,
    /// What it keeps out.
    pub keeps: Keeps,
}

/// On which side of a [`Cylinder`] other parts have to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeps {
    /// Inside: the barrel of a rim, around brake, ball joints and the end of the tie rod. Parts may leave it
    /// through its open ends.
    Inside,
    /// Outside: the tyre.
    Outside,
}

impl<S: Real> Cylinder<S> {
    /// The distance of a point from where it must not be: from the cylinder that keeps it outside, or from the
    /// space around the one that keeps it inside, between the planes of its ends. Where the point is not allowed to be
    /// the value is negative, minus the least way out.
    pub fn to_point(&self, point: Vector<S>) -> S {
        let from_center = sub(point, self.center);
        let along = dot(from_center, self.axis);
        let radial = length(sub(from_center, scale(along, self.axis)));
        let sideways = if along.value() < 0.0 { -along } else { along };
        let beyond = sideways - S::from_f64(0.5 * self.width);
        let radius = S::from_f64(self.radius);
        let off = match self.keeps {
            Keeps::Inside => radius - radial,
            Keeps::Outside => radial - radius,
        };
        if beyond.value() > 0.0 && off.value() > 0.0 {
            return (beyond * beyond + off * off).sqrt();
        }
        if beyond.value() > off.value() { beyond } else { off }
    }

    /// The least value of [`Self::to_point`] along a segment.
    ///
    /// While it is positive it has a derivative: where the nearest place is an inner one, the value does not
    /// change to first order when that place moves along, so the derivative is that with the place held. Derivatives of
    /// higher order (of nested dual numbers) lack the motion of that place.
    pub fn to_segment(&self, segment: Segment<S>) -> S {
        let part = self.nearest(segment);
        self.to_point(place(segment, S::from_f64(part)))
    }

    /// How far along a segment (0 to 1) the value is least.
    fn nearest(&self, segment: Segment<S>) -> f64 {
        let cylinder = Cylinder {
            center: constant::<Dual>(self.center.map(Real::value)),
            axis: constant::<Dual>(self.axis.map(Real::value)),
            radius: self.radius,
            width: self.width,
            keeps: self.keeps,
        };
        let segment = segment.map(|end| constant::<Dual>(end.map(Real::value)));
        let at = |part: f64| cylinder.to_point(place(segment, Dual::new(part, 1.0)));
        let parts = (0..=PARTS).map(|part| f64::from(part) / f64::from(PARTS));
        let values = parts.map(|part| (part, at(part).value));
        let least = values.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0.0, |(part, _)| part);
        let step = 1.0 / f64::from(PARTS);
        let (mut before, mut behind) = (f64::max(least - step, 0.0), f64::min(least + step, 1.0));
        // At an end of the segment, or in a kink, the value does not turn within the part.
        if at(before).derivative >= 0.0 || at(behind).derivative <= 0.0 {
            return least;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (before + behind);
            if at(middle).derivative < 0.0 {
                before = middle;
            } else {
                behind = middle;
            }
        }
        0.5 * (before + behind)
    }
}

/// The place at a part of the way from one end to the other.
fn place<S: Scalar>([from, to]: Segment<S>, part: S) -> Vector<S> {
    add(from, scale(part, sub(to, from)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const RIM: Cylinder<f64> = Cylinder {
        center: [0.0; 3],
        axis: [0.0, 1.0, 0.0],
        radius: 5.0,
        width: 4.0,
        keeps: Keeps::Inside,
    };
    const TYRE: Cylinder<f64> = Cylinder { keeps: Keeps::Outside, ..RIM };

    #[test]
    fn points_inside_of_a_rim_are_as_far_as_its_barrel() {
        assert_eq!(RIM.to_point([3.0, 1.0, 0.0]), 2.0);
        assert_eq!(RIM.to_point([0.0, 0.0, 0.0]), 5.0);
        // Before the open end: the edge is nearest; beside it: as far as its plane.
        assert_eq!(RIM.to_point([2.0, -6.0, 0.0]), 5.0);
        assert_eq!(RIM.to_point([7.0, -6.0, 0.0]), 4.0);
        assert_eq!(RIM.to_point([0.0, 0.0, 5.5]), -0.5);
    }

    #[test]
    fn points_outside_of_a_tyre_are_as_far_as_its_side_or_its_tread() {
        assert_eq!(TYRE.to_point([0.0, 1.0, 8.0]), 3.0);
        assert_eq!(TYRE.to_point([1.0, -3.0, 0.0]), 1.0);
        assert_eq!(TYRE.to_point([8.0, 6.0, 0.0]), 5.0);
        assert_eq!(TYRE.to_point([0.0, 1.5, 4.0]), -0.5);
    }

    #[test]
    fn a_rod_that_leaves_the_rim_is_nearest_to_its_edge() {
        // From the axis outwards over the edge at (5, −2): the line x = −y + 0.5 passes it at 2.5/√2.
        let rod = [[0.5, 0.0, 0.0], [8.5, -8.0, 0.0]];
        assert!((RIM.to_segment(rod) - 2.5 / 2.0_f64.sqrt()).abs() < 1e-14);
        // Along the axis, and through the barrel.
        assert_eq!(RIM.to_segment([[1.0, 0.0, 0.0], [1.0, -9.0, 0.0]]), 4.0);
        assert!(RIM.to_segment([[0.0, 0.0, 0.0], [9.0, 0.0, 0.0]]) < 0.0);
        // Past a tyre: the edge at (5, −2) is nearest to the line y = −3 − (9 − x)/18.
        let distance = TYRE.to_segment([[9.0, -3.0, 0.0], [-9.0, -4.0, 0.0]]);
        assert!((distance - 22.0 / 325.0_f64.sqrt()).abs() < 1e-14, "{distance}");
    }
}
