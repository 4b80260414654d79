//! The virtual test rig: a corner or an axle of a vehicle, moved by its wheels and its rack.
//!
//! The chassis is fixed, or the rig rolls that of an axle. [`Corner`] and [`Axle`] drive wheels up and down and the rack
//! from side to side; [`Sweep`] does so along an event and keeps what was reached.
//! [`Compliance`] says how wheels that the rig lets go give way to loads.

mod adjust;
mod axle;
mod channel;
mod compliance;
mod corner;
pub mod follow;
mod hold;
mod line;
mod load;
mod pose;
mod rates;
mod settled;
mod shape;
mod stand;
mod station;
mod sweep;
mod target;
mod variable;
mod varied;
mod view;
mod watch;

pub use crate::model::LOAD_COMPONENTS;
pub use adjust::{AdjustError, Adjustment, OutOfReach};
pub use axle::Axle;
pub use channel::Channel;
pub use compliance::Compliance;
pub use corner::{Corner, RigError};
pub use hold::Hold;
pub use line::{Line, Wheel};
pub use load::{Load, LoadPoint};
pub use pose::{Design, Motion, Motions, OtherWheel, Pose, TyreState, WheelCompliance, WheelLoad};
pub use rates::Rates;
pub use settled::Settled;
pub use shape::Shape;
pub use stand::Stand;
pub use sweep::{Missed, Place, Row, Specimen, Sweep};
pub use target::{Event, Held, Supports, SweepPlan, Target, Vertical};
pub use variable::{Variable, VaryError};
pub use varied::{Cause, Moved, Varied};
pub use watch::{Danger, Fastest, NEARLY_DEAD, Warning, Watch};
