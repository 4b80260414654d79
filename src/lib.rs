//! Placeholder.
pub mod kernels;
pub mod mechanism;
pub mod model;
pub mod relation;
pub mod scalar;
