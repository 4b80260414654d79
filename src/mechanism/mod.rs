//! The in-memory multibody system, in SI units and any one right-handed frame
//! with z up.
//!
//! A [`Mechanism`] is topology plus the design positions of its named points:
//! joints and drivers refer to points, never to numbers. The parameters of all
//! relations are expanded from the point positions by code that is generic over
//! the scalar, so they have exact derivatives with respect to hard points.
//!
//! Force elements and masses refer to points, too. A force element is a relation that pushes
//! back with a [`Law`] instead of holding.
//!
//! [`Expansion`] is the mechanism as the solver sees it: joints, drivers and force elements
//! turned into instances of relations.

mod adjuster;
mod build;
mod composition;
mod course;
mod elements;
mod error;
mod expansion;
mod force;
mod labels;
mod law;
mod recipe;
mod renumber;
mod skeleton;
mod slots;
mod spline;
mod topology;

pub use adjuster::Adjuster;
pub use build::Mechanism;
pub use course::{Course, Step, Wave};
pub use error::MechanismError;
pub use expansion::{Element, Expansion, Inertia, Instance, Owner};
pub use force::{
    Bushing, Contact, Force, ForceId, ForceKind, InitialVelocity, LoadFrame, MassProperties,
    MomentLaw, Reference, RotationMeasure, Triad,
};
pub(crate) use labels::joint as joint_in_words;
pub use law::{Acts, Curve, Law, LawConstant, Response};
pub use slots::DriverSlots;
pub use spline::{Jet, Spline};
pub use topology::{
    Body, BodyId, Direction, Driver, DriverId, DriverKind, Joint, JointKind, Point, PointId,
};
