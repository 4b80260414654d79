//! The same parts on other points, for mechanisms that are put together from several models.

use super::force::{Bushing, Contact, ForceKind, Triad};
use super::topology::{Direction, JointKind, PointId};

impl Direction {
    /// The same direction with its points exchanged.
    #[must_use]
    pub(crate) fn on_points(self, other: impl Fn(PointId) -> PointId) -> Self {
        match self {
            Self::Between(from, to) => Self::Between(other(from), other(to)),
            Self::Fixed(_) => self,
        }
    }
}

impl JointKind {
    /// The same kind with its points exchanged.
    #[must_use]
    pub(crate) fn on_points(self, other: impl Fn(PointId) -> PointId) -> Self {
        self.on(&other, |direction| direction.on_points(&other))
    }

    /// The same kind with its directions exchanged.
    #[must_use]
    pub(crate) fn on_lines(self, other: impl Fn(Direction) -> Direction) -> Self {
        self.on(|point| point, other)
    }

    fn on(self, other: impl Fn(PointId) -> PointId, line: impl Fn(Direction) -> Direction) -> Self {
        match self {
            Self::Spherical { at } => Self::Spherical { at: other(at) },
            Self::Revolute { at, axis } => Self::Revolute { at: other(at), axis: line(axis) },
            Self::Universal { at, shaft } => Self::Universal { at: other(at), shaft: line(shaft) },
            Self::Translational { at, axis } => {
                Self::Translational { at: other(at), axis: line(axis) }
            }
            Self::Cylindrical { at, axis } => Self::Cylindrical { at: other(at), axis: line(axis) },
            Self::Fixed { at } => Self::Fixed { at: other(at) },
            Self::Link { on_i, on_j } => Self::Link { on_i: other(on_i), on_j: other(on_j) },
            Self::InPlane { at, normal } => Self::InPlane { at: other(at), normal: line(normal) },
            Self::InLine { at, axis } => Self::InLine { at: other(at), axis: line(axis) },
            Self::Perpendicular { at, axis } => {
                Self::Perpendicular { at: other(at), axis: line(axis) }
            }
            Self::Hooke { at, pin_i, pin_j } => {
                Self::Hooke { at: other(at), pin_i: line(pin_i), pin_j: line(pin_j) }
            }
            Self::PerpendicularAxes { at, axis_i, axis_j } => Self::PerpendicularAxes {
                at: other(at),
                axis_i: line(axis_i),
                axis_j: line(axis_j),
            },
            Self::ParallelAxes { at, axis } => {
                Self::ParallelAxes { at: other(at), axis: line(axis) }
            }
            Self::Orientation { at } => Self::Orientation { at: other(at) },
            Self::RackAndPinion { at, axis, along, pitch_radius } => Self::RackAndPinion {
                at: other(at),
                axis: line(axis),
                along: line(along),
                pitch_radius,
            },
            Self::Screw { at, axis, lead } => Self::Screw { at: other(at), axis: line(axis), lead },
        }
    }
}

impl ForceKind {
    /// The same kind with its points exchanged.
    #[must_use]
    pub(crate) fn on_points(self, other: impl Fn(PointId) -> PointId) -> Self {
        let line = |direction: Direction| direction.on_points(&other);
        match self {
            Self::Line { on_i, on_j, reference, law } => {
                Self::Line { on_i: other(on_i), on_j: other(on_j), reference, law }
            }
            Self::Slide { at, along, law } => {
                Self::Slide { at: other(at), along: line(along), law }
            }
            Self::Torsion { axis, law } => Self::Torsion { axis: line(axis), law },
            Self::Bushing(bushing) => {
                let axes = Triad { x: line(bushing.axes.x), z: line(bushing.axes.z) };
                Self::Bushing(Box::new(Bushing { at: other(bushing.at), axes, ..*bushing }))
            }
            Self::Tyre { contact, free_radius, ground, law } => {
                let contact = match contact {
                    Contact::Center(center) => Contact::Center(other(center)),
                    Contact::Patch { center, spin } => {
                        Contact::Patch { center: other(center), spin: line(spin) }
                    }
                };
                Self::Tyre { contact, free_radius, ground, law }
            }
            Self::PointForce { at, frame, direction, size } => {
                Self::PointForce { at: other(at), frame, direction, size }
            }
            Self::Moment { .. } => self,
        }
    }
}
