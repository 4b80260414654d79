//! Design: how factors change with hard points and other parameters, and which of these give wanted factors.

pub mod clearance;
pub mod edit;
pub mod event;
mod laws;
pub mod parameter;
pub mod request;
mod resolve;
pub mod sensitivity;
pub mod sqp;
pub mod synthesis;

pub use event::{EventSensitivities, StateSensitivities, along};
pub use parameter::{Parameter, UnknownParameter};
pub use sensitivity::{Sensitivities, Sensitivity, SensitivityFailure, Way, sensitivities};
