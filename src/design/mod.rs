//! Design: how factors change with hard points and other parameters, and which of these give wanted factors.

pub mod clearance;
pub mod edit;
pub mod parameter;
pub mod request;
pub mod sensitivity;
pub mod sqp;
pub mod synthesis;

pub use parameter::{Parameter, UnknownParameter};
pub use sensitivity::{Sensitivities, SensitivityFailure, Way, sensitivities};
