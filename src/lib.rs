//! Placeholder.
pub mod assembly;
pub mod kernels;
pub mod mechanism;
pub mod model;
pub mod relation;
pub mod scalar;
pub mod solve;
pub mod vector;
