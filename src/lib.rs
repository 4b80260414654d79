//! Placeholder.
pub mod kernels;
pub mod mechanism;
pub mod relation;
pub mod scalar;
