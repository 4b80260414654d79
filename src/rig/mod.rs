//! The virtual test rig: one corner of a vehicle, moved by its wheel and its rack.
//!
//! The chassis is fixed. [`Corner`] drives the wheel up and down and the rack
//! from side to side; [`Sweep`] does so along an event and keeps what was reached.

mod channel;
mod corner;
mod line;
mod load;
mod pose;
mod stand;
mod sweep;

pub use channel::Channel;
pub use corner::{Corner, RigError};
pub use line::{Line, Wheel};
pub use load::{LOAD_COMPONENTS, Load, LoadPoint};
pub use pose::{Design, Motion, Motions, Pose, WheelLoad};
pub use stand::Stand;
pub use sweep::{Event, Held, Row, Specimen, Sweep, SweepPlan};
