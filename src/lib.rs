//! Placeholder.
pub mod mechanism;
pub mod relation;
pub mod scalar;
