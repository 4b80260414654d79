//! Force elements: relations that push back instead of holding.

use super::law::Law;
use super::topology::{BodyId, Direction, PointId};

/// Number of a force element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ForceId(pub(crate) usize);

impl ForceId {
    /// Position in [`Mechanism::forces`](super::Mechanism::forces).
    pub fn index(self) -> usize {
        self.0
    }
}

/// What a length is measured from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reference {
    /// This length (m), such as the free length of a spring.
    Length(f64),
    /// The length at the design position plus this (m).
    Design(f64),
}

/// The frame in which a load keeps its direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadFrame {
    /// The ground.
    Space,
    /// The body it acts on.
    Body,
}

/// Where a vertical tyre touches the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// Straight below the wheel centre: the height of the centre alone counts.
    Center(PointId),
    /// At the lowest point of the disc of the free radius.
    Patch {
        /// Wheel centre.
        center: PointId,
        /// Spin axis, normal to the disc.
        spin: Direction,
    },
}

/// How a bushing measures the rotation of body *j* relative to body *i*.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotationMeasure {
    /// Tait–Bryan angles (a, b, c) of R = Rx(a) Ry(b) Rz(c) in the bushing's axes.
    Angles,
    /// The rotation vector in the bushing's axes.
    RotationVector,
}

/// What the rotational laws of a bushing are the moment of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MomentLaw {
    /// The generalized force is −θ_qᵀλ: with linear laws it has the energy ½ θᵀKθ.
    Energy,
    /// The moment on body *j* is −B λ with the axes B fixed in body *i*, as Adams and Chrono do.
    Torque,
}

/// The right-handed axes of a bushing, fixed in both bodies at the design position: x as given,
/// y = z × x, and z made normal to x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triad {
    /// The x axis.
    pub x: Direction,
    /// A direction in the plane of x and z, on the side of z.
    pub z: Direction,
}

/// An elastic bearing between a point of body *i* and the same point of body *j*.
#[derive(Clone, Debug, PartialEq)]
pub struct Bushing {
    /// Its centre, shared by both bodies at the design position.
    pub at: PointId,
    /// Its axes; translations are measured in those of body *i*.
    pub axes: Triad,
    /// Laws of the displacement of body *j* along x, y and z (N, m).
    pub translation: [Law; 3],
    /// Laws of its rotation about x, y and z (N·m, rad).
    pub rotation: [Law; 3],
    /// How the rotation is measured.
    pub measure: RotationMeasure,
    /// What the rotational laws are the moment of.
    pub moment: MomentLaw,
}

/// The kinds of force elements.
#[derive(Clone, Debug, PartialEq)]
pub enum ForceKind {
    /// Along the line from a point of body *i* to a point of body *j*: spring, damper, actuator,
    /// stop. The value is the distance minus the reference; λ > 0 is tension.
    Line {
        /// End on body *i*.
        on_i: PointId,
        /// End on body *j*.
        on_j: PointId,
        /// What the length is measured from.
        reference: Reference,
        /// The law (N, m).
        law: Law,
    },
    /// Along a direction fixed in body *i*, such as that of a slide. The value is the displacement of the
    /// point of body *j* from the design position; the force on body *j* is −λ along the direction.
    Slide {
        /// The point of body *j*.
        at: PointId,
        /// The direction, fixed in body *i*.
        along: Direction,
        /// The law (N, m).
        law: Law,
    },
    /// About an axis that both bodies share. The value is the angle of body *j* relative to
    /// body *i*, right-handed, zero at the design position and counted over full turns.
    Torsion {
        /// The axis; a joint has to keep it fixed in both bodies.
        axis: Direction,
        /// The law (N·m, rad).
        law: Law,
    },
    /// Six components at a point.
    Bushing(Box<Bushing>),
    /// Vertical force of level ground on a tyre of body *j*. The value is the height of the tyre's
    /// lowest point above the ground, negative in contact; −λ is the vertical load.
    Tyre {
        /// Where it touches.
        contact: Contact,
        /// Radius without load (m).
        free_radius: f64,
        /// Height of the ground (m).
        ground: f64,
        /// The law (N, m).
        law: Law,
    },
    /// A force of constant size on a point of body *j*.
    PointForce {
        /// The point.
        at: PointId,
        /// The frame in which the direction is constant.
        frame: LoadFrame,
        /// The direction, of any length but zero.
        direction: [f64; 3],
        /// Size (N).
        size: f64,
    },
    /// A moment of constant size on body *j*.
    Moment {
        /// The frame in which the direction is constant.
        frame: LoadFrame,
        /// The direction, right-handed, of any length but zero.
        direction: [f64; 3],
        /// Size (N·m).
        size: f64,
    },
}

impl ForceKind {
    /// The name of the kind in words.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Line { .. } => "line force",
            Self::Slide { .. } => "slide spring",
            Self::Torsion { .. } => "torsion spring",
            Self::Bushing(_) => "bushing",
            Self::Tyre { .. } => "tyre",
            Self::PointForce { .. } => "force",
            Self::Moment { .. } => "moment",
        }
    }

    /// The points on body *i* and on body *j*, where the kind has points.
    pub fn points(&self) -> Option<[PointId; 2]> {
        match self {
            Self::Line { on_i, on_j, .. } => Some([*on_i, *on_j]),
            Self::Slide { at, .. } => Some([*at; 2]),
            Self::Bushing(bushing) => Some([bushing.at; 2]),
            Self::Tyre {
                contact: Contact::Center(center) | Contact::Patch { center, .. }, ..
            } => Some([*center; 2]),
            Self::PointForce { at, .. } => Some([*at; 2]),
            Self::Torsion { .. } | Self::Moment { .. } => None,
        }
    }

    /// Whether it acts along the line between two points.
    pub fn is_line(&self) -> bool {
        matches!(self, Self::Line { .. })
    }

    /// The directions that the kind refers to.
    pub fn directions(&self) -> Vec<Direction> {
        match self {
            Self::Slide { along, .. } => vec![*along],
            Self::Torsion { axis, .. } => vec![*axis],
            Self::Bushing(bushing) => vec![bushing.axes.x, bushing.axes.z],
            Self::Tyre { contact: Contact::Patch { spin, .. }, .. } => vec![*spin],
            Self::PointForce { direction, .. } | Self::Moment { direction, .. } => {
                vec![Direction::Fixed(*direction)]
            }
            Self::Line { .. } | Self::Tyre { .. } => vec![],
        }
    }
}

/// A force element between two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Force {
    /// The name that messages use, such as `spring`.
    pub name: String,
    /// Body *i*; the ground for tyres and loads.
    pub i: BodyId,
    /// Body *j*.
    pub j: BodyId,
    /// Kind, points and laws.
    pub kind: ForceKind,
}

/// Mass and inertia of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// Mass (kg).
    pub mass: f64,
    /// Centre of mass at the design position (m).
    pub center: [f64; 3],
    /// Inertia tensor about the centre of mass (kg m²): Jxx, Jyy, Jzz, then the elements Jxy, Jxz, Jyz
    /// (which are minus the products of inertia).
    pub inertia: [f64; 6],
}

/// How a body moves at the start of dynamics.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InitialVelocity {
    /// Velocity (m/s) of the centre of mass, or of the body's origin where it has no mass.
    pub velocity: [f64; 3],
    /// Angular velocity (rad/s), in ground axes.
    pub rotation: [f64; 3],
}
