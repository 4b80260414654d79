//! Design: which hard points give the factors that a designer wants.

pub mod clearance;
pub mod edit;
pub mod request;
