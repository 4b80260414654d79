//! The virtual test rig: one corner of a vehicle, moved by its wheel and its rack.
//!
//! The chassis is fixed. [`Corner`] drives the wheel up and down and the rack
//! from side to side; [`Sweep`] does so along an event and keeps what was reached.

mod corner;
mod pose;
mod sweep;

pub use corner::{Corner, RigError};
pub use pose::{Axle, Pose, Wheel};
pub use sweep::{Event, Row, Sweep, SweepPlan};
