//! Placeholder.
pub mod assembly;
pub mod factors;
pub mod kernels;
pub mod mechanism;
pub mod model;
pub mod relation;
pub mod report;
pub mod rig;
pub mod scalar;
pub mod solve;
pub mod vector;
