//! The in-memory multibody system, in SI units and any one right-handed frame
//! with z up.
//!
//! A [`Mechanism`] is topology plus the design positions of its named points:
//! joints and drivers refer to points, never to numbers. The parameters of all
//! relations are expanded from the point positions by code that is generic over
//! the scalar, so they have exact derivatives with respect to hard points.

mod topology;

pub use topology::{
    Body, BodyId, Direction, Driver, DriverId, DriverKind, Joint, JointKind, Mechanism,
    MechanismError, Point, PointId,
};
