//! How the parameters of relations follow from the positions of named points.
//!
//! A recipe is decided once, at the design position, and is then a smooth
//! function of the point positions. So its derivative on dual numbers is the
//! exact derivative of the parameters with respect to hard points.

use super::build::Mechanism;
use super::force::Triad;
use super::topology::{BodyId, Direction, PointId};
use crate::scalar::Scalar;
use crate::vector::{Vector, constant, cross, norm, sub, unit};

/// One parameter, or one vector of three, of a relation.
#[derive(Clone, Copy, Debug)]
pub(super) enum Recipe {
    /// A point in the frame of a body with this origin.
    Local { point: PointId, body: BodyId, origin: [f64; 3] },
    /// A constant vector.
    Constant([f64; 3]),
    /// A unit vector.
    Axis(Direction),
    /// The first vector of the perpendicular pair of an axis.
    FirstNormal(Normals),
    /// The second vector of the perpendicular pair of an axis.
    SecondNormal(Normals),
    /// A number that does not depend on points.
    Number(f64),
    /// The distance of two points plus a number.
    Distance(PointId, PointId, f64),
    /// An axis of a bushing: 0 is x, 1 is y, 2 is z.
    BushingAxis(Triad, usize),
    /// The height of a point.
    Height(PointId),
    /// The height of the lowest point of a disc.
    PatchHeight { center: PointId, spin: Direction, radius: f64 },
}

/// An axis and the coordinate axis that its perpendicular pair is built with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Normals {
    axis: Direction,
    reference: usize,
}

impl Normals {
    /// Chooses the coordinate axis farthest from the direction, which stays chosen.
    pub(super) fn choose(mechanism: &Mechanism, axis: Direction) -> Self {
        let components = mechanism.vector(axis).map(f64::abs);
        let reference =
            (0..3).min_by(|&a, &b| components[a].total_cmp(&components[b])).unwrap_or(0);
        Self { axis, reference }
    }

    /// Two unit vectors that form a right-handed triad with the axis as third.
    fn pair<S: Scalar>(self, positions: &[Vector<S>]) -> [Vector<S>; 2] {
        let axis = self.axis.at(positions);
        let mut reference = [0.0; 3];
        reference[self.reference] = 1.0;
        let first = unit(cross(constant(reference), axis));
        [first, cross(axis, first)]
    }
}

impl Recipe {
    /// Number of components.
    pub(super) fn size(self) -> usize {
        match self {
            Self::Local { .. }
            | Self::Constant(_)
            | Self::Axis(_)
            | Self::FirstNormal(_)
            | Self::SecondNormal(_)
            | Self::BushingAxis(..) => 3,
            Self::Number(_) | Self::Distance(..) | Self::Height(_) | Self::PatchHeight { .. } => 1,
        }
    }

    /// Appends the components to `out`.
    pub(super) fn evaluate<S: Scalar>(self, positions: &[Vector<S>], out: &mut Vec<S>) {
        match self {
            Self::Local { point, origin, .. } => {
                out.extend(sub(positions[point.0], constant(origin)));
            }
            Self::Constant(vector) => out.extend(constant::<S>(vector)),
            Self::Axis(axis) => out.extend(axis.at(positions)),
            Self::FirstNormal(normals) => out.extend(normals.pair(positions)[0]),
            Self::SecondNormal(normals) => out.extend(normals.pair(positions)[1]),
            Self::Number(number) => out.push(S::from_f64(number)),
            Self::Distance(from, to, more) => {
                out.push(norm(sub(positions[to.0], positions[from.0])) + S::from_f64(more));
            }
            Self::BushingAxis(axes, axis) => out.extend(axes.at(positions)[axis]),
            Self::Height(point) => out.push(positions[point.0][2]),
            Self::PatchHeight { center, spin, radius } => {
                // The normal of the disc has length one, so the disc reaches down
                // by its radius times the cosine of the camber angle.
                let spin = spin.at(positions);
                let drop = (spin[0] * spin[0] + spin[1] * spin[1]).sqrt();
                out.push(positions[center.0][2] - S::from_f64(radius) * drop);
            }
        }
    }
}

impl Triad {
    /// The axes x, y and z for the given positions of the points.
    pub(crate) fn at<S: Scalar>(self, positions: &[Vector<S>]) -> [Vector<S>; 3] {
        let x = self.x.at(positions);
        let y = unit(cross(self.z.at(positions), x));
        [x, y, cross(x, y)]
    }
}

impl Direction {
    /// Its unit vector for the given positions of the points.
    pub fn at<S: Scalar>(self, positions: &[Vector<S>]) -> Vector<S> {
        match self {
            Self::Between(from, to) => unit(sub(positions[to.0], positions[from.0])),
            Self::Fixed(vector) => {
                // Dividing by the largest component first keeps tiny and huge vectors exact.
                let largest = vector.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
                constant(unit(vector.map(|component| component / largest)))
            }
        }
    }
}
