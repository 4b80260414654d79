//! The in-memory multibody system, in SI units and any one right-handed frame
//! with z up.
//!
//! A [`Mechanism`] is topology plus the design positions of its named points:
//! joints and drivers refer to points, never to numbers. The parameters of all
//! relations are expanded from the point positions by code that is generic over
//! the scalar, so they have exact derivatives with respect to hard points.
//!
//! [`Expansion`] is the mechanism as the solver sees it: joints and drivers
//! turned into instances of relations.

mod build;
mod composition;
mod error;
mod expansion;
mod labels;
mod recipe;
mod topology;

pub use build::Mechanism;
pub use error::MechanismError;
pub use expansion::{Expansion, Instance, Owner};
pub(crate) use labels::joint as joint_in_words;
pub use topology::{
    Body, BodyId, Direction, Driver, DriverId, DriverKind, Joint, JointKind, Point, PointId,
};
