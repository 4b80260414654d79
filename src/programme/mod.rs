//! The standard programme of the rig: what a K&C machine measures of an axle, event by event.
//!
//! A [`Stage`] is an event with its range and with what the rig holds; [`standard`] has all that an axle
//! can go through.

mod range;
mod stage;
mod standard;

pub use range::{Clearance, Fastest, Place, WorkingRange};
pub use stage::{Body, Run, Stage, StageError, rolling};
pub use standard::{Ranges, standard};
