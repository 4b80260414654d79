//! Bodies, points, joints and drivers by name.

use thiserror::Error;

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

/// A rigid body. Its frame has identity rotation at the design position.
#[derive(Clone, Debug)]
pub struct Body {
    /// The name that messages use.
    pub name: String,
    /// Origin of the body frame at the design position (m). It is a frozen
    /// constant: the local coordinates of a point are its position minus this.
    pub origin: [f64; 3],
}

/// A named point and its design position (m).
#[derive(Clone, Debug)]
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
    Spherical { at: PointId },
    /// Both bodies share the point and the axis. 5 equations.
    Revolute { at: PointId, axis: Direction },
    /// Both bodies share the point; the cross axis of body *i* stays normal to that of body *j*.
    /// Both cross axes are chosen normal to `shaft`. 4 equations.
    Universal { at: PointId, shaft: Direction },
    /// Body *j* slides along the axis without turning. 5 equations.
    Translational { at: PointId, axis: Direction },
    /// Body *j* slides along and turns about the axis. 4 equations.
    Cylindrical { at: PointId, axis: Direction },
    /// No relative motion. 6 equations.
    Fixed { at: PointId },
    /// The distance between a point of body *i* and a point of body *j* is constant. 1 equation.
    Link { on_i: PointId, on_j: PointId },
    /// The point of body *j* stays in a plane fixed in body *i*. 1 equation.
    InPlane { at: PointId, normal: Direction },
    /// The point of body *j* stays on a line fixed in body *i*. 2 equations.
    InLine { at: PointId, axis: Direction },
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
    Displacement { at: PointId, along: Direction },
    /// Rotation (rad) of body *j* relative to body *i* about an axis, right-handed.
    Rotation { axis: Direction },
    /// Change of the distance (m) between a point of body *i* and a point of body *j*.
    Length { on_i: PointId, on_j: PointId },
    /// Change of the height (m) of a point of body *j* above the ground.
    Height { at: PointId },
    /// Change of the height (m) of the lowest point of a disc on body *j*: the contact patch.
    PatchHeight {
        /// Centre of the disc.
        center: PointId,
        /// Spin axis, normal to the disc.
        spin: Direction,
        /// Radius (m).
        radius: f64,
    },
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
}

/// A system of bodies, joints and drivers.
#[derive(Clone, Debug)]
pub struct Mechanism {
    pub(crate) bodies: Vec<Body>,
    pub(crate) points: Vec<Point>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) drivers: Vec<Driver>,
}

/// Why a mechanism cannot be built.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum MechanismError {
    /// Two things have one name.
    #[error("there are two {what}s named `{name}`; give one of them another name")]
    DuplicateName { what: &'static str, name: String },
    // More kinds: coincident points of a direction, zero length of a link, a joint of a body with
    // itself, a number that is not finite, a fixed direction of zero length, a radius that is not
    // positive. Each names the joint or driver and the points.
}

impl Mechanism {
    /// An empty system with the ground under the given name, such as `chassis`.
    pub fn new(ground: &str) -> Self {
        let ground = Body { name: ground.to_owned(), origin: [0.0; 3] };
        Self { bodies: vec![ground], points: vec![], joints: vec![], drivers: vec![] }
    }

    /// Adds a body whose frame has its origin at `origin` (m).
    ///
    /// # Errors
    /// [`MechanismError`] for a name that is taken or a number that is not finite.
    pub fn add_body(&mut self, name: &str, origin: [f64; 3]) -> Result<BodyId, MechanismError> {
        todo!("{name}{origin:?}")
    }

    /// Adds a named point at its design position (m).
    ///
    /// # Errors
    /// [`MechanismError`] for a name that is taken or a number that is not finite.
    pub fn add_point(&mut self, name: &str, position: [f64; 3]) -> Result<PointId, MechanismError> {
        todo!("{name}{position:?}")
    }

    /// Adds a joint.
    ///
    /// # Errors
    /// [`MechanismError`] where the joint has no meaning, such as an axis between coincident points.
    pub fn add_joint(
        &mut self,
        name: &str,
        i: BodyId,
        j: BodyId,
        kind: JointKind,
    ) -> Result<(), MechanismError> {
        todo!("{name}{i:?}{j:?}{kind:?}")
    }

    /// Adds a driver.
    ///
    /// # Errors
    /// [`MechanismError`] as for joints.
    pub fn add_driver(
        &mut self,
        name: &str,
        i: BodyId,
        j: BodyId,
        kind: DriverKind,
    ) -> Result<DriverId, MechanismError> {
        todo!("{name}{i:?}{j:?}{kind:?}")
    }
}
