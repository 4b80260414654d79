//! The parts of a mechanism: bodies, points, joints and drivers.

use super::course::Course;
use super::force::{InitialVelocity, MassProperties};

/// Number of a body; [`BodyId::GROUND`] never moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(pub(crate) usize);

impl BodyId {
    /// The body that everything is measured from.
    pub const GROUND: Self = Self(0);
}

/// Number of a named point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PointId(pub(crate) usize);

/// Number of a driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DriverId(pub(crate) usize);

impl BodyId {
    /// Position in [`Mechanism::bodies`](super::Mechanism::bodies).
    pub fn index(self) -> usize {
        self.0
    }
}

impl PointId {
    /// Position in [`Mechanism::points`](super::Mechanism::points).
    pub fn index(self) -> usize {
        self.0
    }
}

impl DriverId {
    /// Position in [`Mechanism::drivers`](super::Mechanism::drivers).
    pub fn index(self) -> usize {
        self.0
    }
}

/// A rigid body. Its frame has identity rotation at the design position.
#[derive(Clone, Debug)]
pub struct Body {
    /// The name that messages use.
    pub name: String,
    /// Origin of the body frame at the design position (m). It is a frozen
    /// constant: the local coordinates of a point are its position minus this.
    pub origin: [f64; 3],
    /// Mass and inertia, where they are known.
    pub mass: Option<MassProperties>,
    /// How it moves at the start of dynamics.
    pub initial_velocity: InitialVelocity,
}

/// A named point and its design position (m).
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The name that messages use, such as `lca_outer`.
    pub name: String,
    /// Design position (m).
    pub position: [f64; 3],
}

/// A direction at the design position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// From the first point to the second.
    Between(PointId, PointId),
    /// A constant vector of any length but zero.
    Fixed([f64; 3]),
}

/// The kinds of joints. Points and directions are given at the design position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointKind {
    /// Both bodies share the point. 3 equations.
    Spherical {
        /// The shared point.
        at: PointId,
    },
    /// Both bodies share the point and the axis. 5 equations.
    Revolute {
        /// The shared point.
        at: PointId,
        /// The axis of rotation.
        axis: Direction,
    },
    /// Both bodies share the point; the cross axis of body *i* stays normal to that of body *j*.
    /// Both cross axes are chosen normal to `shaft`. 4 equations.
    Universal {
        /// The shared point.
        at: PointId,
        /// The direction that cannot turn about itself.
        shaft: Direction,
    },
    /// Body *j* slides along the axis without turning. 5 equations.
    Translational {
        /// A point on the axis.
        at: PointId,
        /// The direction of sliding.
        axis: Direction,
    },
    /// Body *j* slides along and turns about the axis. 4 equations.
    Cylindrical {
        /// A point on the axis.
        at: PointId,
        /// The direction of sliding and axis of rotation.
        axis: Direction,
    },
    /// No relative motion. 6 equations.
    Fixed {
        /// Where the bodies are joined.
        at: PointId,
    },
    /// The distance between a point of body *i* and a point of body *j* is constant. 1 equation.
    Link {
        /// End on body *i*.
        on_i: PointId,
        /// End on body *j*.
        on_j: PointId,
    },
    /// The point of body *j* stays in a plane fixed in body *i*. 1 equation.
    InPlane {
        /// The point of body *j*.
        at: PointId,
        /// Normal of the plane, fixed in body *i*.
        normal: Direction,
    },
    /// The point of body *j* stays on a line fixed in body *i*. 2 equations.
    InLine {
        /// The point of body *j*.
        at: PointId,
        /// Direction of the line, fixed in body *i*.
        axis: Direction,
    },
    /// A normal of the axis in body *i* stays perpendicular to another one in body *j*, so body *j* does not
    /// turn about the axis. 1 equation.
    Perpendicular {
        /// Where its moment is told.
        at: PointId,
        /// The axis about which nothing turns.
        axis: Direction,
    },
    /// A universal joint with given pins of its cross: both bodies share the point, and the pins stay
    /// normal to each other. 4 equations.
    Hooke {
        /// The shared point.
        at: PointId,
        /// The pin in body *i*.
        pin_i: Direction,
        /// The pin in body *j*, normal to the other.
        pin_j: Direction,
    },
    /// An axis of body *i* stays normal to one of body *j*. 1 equation.
    PerpendicularAxes {
        /// Where its moment is told.
        at: PointId,
        /// The axis in body *i*.
        axis_i: Direction,
        /// The axis in body *j*, normal to the other.
        axis_j: Direction,
    },
    /// An axis of body *j* stays parallel to one of body *i*. 2 equations.
    ParallelAxes {
        /// Where its moment is told.
        at: PointId,
        /// The axis of both bodies.
        axis: Direction,
    },
    /// Body *j* does not turn relative to body *i*. 3 equations.
    Orientation {
        /// Where its moment is told.
        at: PointId,
    },
    /// Body *j*, the pinion, turns about the axis as the rack, body *i*, moves along. 1 equation: other
    /// joints guide the two.
    RackAndPinion {
        /// A point on the axis of the pinion.
        at: PointId,
        /// The axis of the pinion.
        axis: Direction,
        /// The direction of the rack's way.
        along: Direction,
        /// The way (m) of the rack along its direction for each radian that the pinion turns
        /// right-handed about its axis.
        pitch_radius: f64,
    },
    /// Body *j* turns about the axis as it goes along it from body *i*. 1 equation: a cylindrical joint guides
    /// the two.
    Screw {
        /// A point on the axis.
        at: PointId,
        /// The axis.
        axis: Direction,
        /// The way (m) of body *j* along the axis for each right-handed turn about it.
        lead: f64,
    },
}

impl JointKind {
    /// The name of the kind in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Spherical { .. } => "spherical",
            Self::Revolute { .. } => "revolute",
            Self::Universal { .. } => "universal",
            Self::Translational { .. } => "translational",
            Self::Cylindrical { .. } => "cylindrical",
            Self::Fixed { .. } => "fixed",
            Self::Link { .. } => "rigid link",
            Self::InPlane { .. } => "in-plane",
            Self::InLine { .. } => "in-line",
            Self::Perpendicular { .. } => "perpendicular",
            Self::Hooke { .. } => "universal",
            Self::PerpendicularAxes { .. } => "perpendicular-axes",
            Self::ParallelAxes { .. } => "parallel-axes",
            Self::Orientation { .. } => "orientation",
            Self::RackAndPinion { .. } => "rack-and-pinion",
            Self::Screw { .. } => "screw",
        }
    }

    /// The number of its equations.
    pub fn equations(self) -> usize {
        match self {
            Self::Fixed { .. } => 6,
            Self::Revolute { .. } | Self::Translational { .. } => 5,
            Self::Universal { .. } | Self::Cylindrical { .. } | Self::Hooke { .. } => 4,
            Self::Spherical { .. } | Self::Orientation { .. } => 3,
            Self::InLine { .. } | Self::ParallelAxes { .. } => 2,
            Self::Link { .. }
            | Self::InPlane { .. }
            | Self::Perpendicular { .. }
            | Self::PerpendicularAxes { .. }
            | Self::RackAndPinion { .. }
            | Self::Screw { .. } => 1,
        }
    }

    /// The points that the joint holds together.
    pub fn points(self) -> [PointId; 2] {
        match self {
            Self::Spherical { at }
            | Self::Revolute { at, .. }
            | Self::Universal { at, .. }
            | Self::Translational { at, .. }
            | Self::Cylindrical { at, .. }
            | Self::Fixed { at }
            | Self::InPlane { at, .. }
            | Self::InLine { at, .. }
            | Self::Perpendicular { at, .. }
            | Self::Hooke { at, .. }
            | Self::PerpendicularAxes { at, .. }
            | Self::ParallelAxes { at, .. }
            | Self::Orientation { at }
            | Self::RackAndPinion { at, .. }
            | Self::Screw { at, .. } => [at, at],
            Self::Link { on_i, on_j } => [on_i, on_j],
        }
    }

    /// The directions of the joint: none, one or two.
    pub fn directions(self) -> impl Iterator<Item = Direction> {
        let directions = match self {
            Self::Spherical { .. }
            | Self::Fixed { .. }
            | Self::Link { .. }
            | Self::Orientation { .. } => [None, None],
            Self::Revolute { axis, .. }
            | Self::Translational { axis, .. }
            | Self::Cylindrical { axis, .. }
            | Self::InLine { axis, .. }
            | Self::Perpendicular { axis, .. }
            | Self::ParallelAxes { axis, .. }
            | Self::Screw { axis, .. } => [Some(axis), None],
            Self::Universal { shaft, .. } => [Some(shaft), None],
            Self::InPlane { normal, .. } => [Some(normal), None],
            Self::Hooke { pin_i, pin_j, .. } => [Some(pin_i), Some(pin_j)],
            Self::PerpendicularAxes { axis_i, axis_j, .. } => [Some(axis_i), Some(axis_j)],
            Self::RackAndPinion { axis, along, .. } => [Some(axis), Some(along)],
        };
        directions.into_iter().flatten()
    }
}

/// A joint between two bodies.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The name that messages use, such as `lca_pivot`.
    pub name: String,
    /// Body *i*.
    pub i: BodyId,
    /// Body *j*.
    pub j: BodyId,
    /// Kind, points and axes.
    pub kind: JointKind,
}

/// What a driver prescribes. Every value is measured from the design position,
/// so all values zero means the design position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriverKind {
    /// Displacement (m) of a point of body *j* along a direction fixed in body *i*.
    Displacement {
        /// The point of body *j*.
        at: PointId,
        /// Positive direction, fixed in body *i*.
        along: Direction,
    },
    /// Rotation (rad) of body *j* relative to body *i* about an axis, right-handed.
    Rotation {
        /// Axis of rotation, fixed in body *i*. A joint has to keep it fixed in body *j* too.
        axis: Direction,
    },
    /// Change of the distance (m) between a point of body *i* and a point of body *j*.
    Length {
        /// End on body *i*.
        on_i: PointId,
        /// End on body *j*.
        on_j: PointId,
    },
    /// Change of the height (m) of a point of body *j* above the ground.
    Height {
        /// The point of body *j*.
        at: PointId,
    },
    /// Change of the height (m) of the lowest point of a disc on body *j*: the contact patch.
    PatchHeight {
        /// Centre of the disc.
        center: PointId,
        /// Spin axis, normal to the disc.
        spin: Direction,
        /// Radius (m).
        radius: f64,
    },
    /// A dimension (m) of parts: see [`Mechanism::add_adjuster`](super::Mechanism::add_adjuster).
    /// It holds no motion.
    Adjuster,
}

impl DriverKind {
    /// What is prescribed, in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Displacement { .. } => "displacement",
            Self::Rotation { .. } => "rotation",
            Self::Length { .. } => "length",
            Self::Height { .. } => "height",
            Self::PatchHeight { .. } => "contact-patch height",
            Self::Adjuster => "adjuster",
        }
    }

    /// The points on body *i* and on body *j*, where the kind has points.
    pub fn points(self) -> Option<[PointId; 2]> {
        match self {
            Self::Displacement { at, .. } | Self::Height { at } => Some([at, at]),
            Self::Length { on_i, on_j } => Some([on_i, on_j]),
            Self::PatchHeight { center, .. } => Some([center, center]),
            Self::Rotation { .. } | Self::Adjuster => None,
        }
    }

    /// The direction of the driver, where it has one.
    pub fn direction(self) -> Option<Direction> {
        match self {
            Self::Displacement { along, .. } => Some(along),
            Self::Rotation { axis } => Some(axis),
            Self::PatchHeight { spin, .. } => Some(spin),
            Self::Length { .. } | Self::Height { .. } | Self::Adjuster => None,
        }
    }

    /// Unit of the driver's value: `m` or `rad`.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Rotation { .. } => "rad",
            _ => "m",
        }
    }
}

/// A prescribed motion.
#[derive(Clone, Debug)]
pub struct Driver {
    /// The name that messages use, such as `travel`.
    pub name: String,
    /// Body *i*; ground for heights.
    pub i: BodyId,
    /// Body *j*.
    pub j: BodyId,
    /// What is prescribed.
    pub kind: DriverKind,
    /// How its value changes in dynamics, where it does.
    pub course: Option<Course>,
}
