//! The virtual test rig: a corner or an axle of a vehicle, moved by its wheels and its rack.
//!
//! The chassis is fixed. [`Corner`] and [`Axle`] drive wheels up and down and the rack
//! from side to side; [`Sweep`] does so along an event and keeps what was reached.
//! [`Compliance`] says how wheels that the rig lets go give way to loads.

mod axle;
mod channel;
mod compliance;
mod corner;
pub mod follow;
mod line;
mod load;
mod pose;
mod stand;
mod station;
mod sweep;

pub use axle::Axle;
pub use channel::Channel;
pub use compliance::Compliance;
pub use corner::{Corner, RigError};
pub use line::{Line, Wheel};
pub use load::{LOAD_COMPONENTS, Load, LoadPoint};
pub use pose::{Design, Motion, Motions, OtherWheel, Pose, TyreState, WheelCompliance, WheelLoad};
pub use stand::Stand;
pub use sweep::{Event, Held, Row, Specimen, Sweep, SweepPlan, Target};
