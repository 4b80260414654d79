//! From matrices to positions: where the mechanism goes.
//!
//! [`System`] is the entry: it analyses a mechanism, moves its drivers and
//! answers where points and bodies are.
//!
//! | file | what |
//! |---|---|
//! | `linear` | factorise the values of a fixed pattern, then solve, and check the solution |
//! | `elimination` | a fixed list of operations, for the usual sizes |
//! | `sparse_lu` | faer's factorisation, for large systems |
//! | `newton`, `convergence` | the iteration of the paper's eq. (5)–(7) and Fig. 1 |
//! | `equilibrium` | both residuals of eq. (4): coordinates and multipliers |
//! | `statics` | the robust way to an equilibrium, and why there is none |
//! | `linearised` | all derivatives at a state from one factorisation: tangents by drivers |
//! | `border` | a factorised matrix with conditions added: drivers let go and held |
//! | `stability` | the stiffness against the motions that joints allow |
//! | `compliance` | how points give way to loads |
//! | `sensitivity` | how a state and its tangents change with parameters |
//! | `dynamics` | motion in time |
//! | `wrench` | reactions of joints and forces of elements |
//! | `motion`, `tangent` | how bodies move; per unit of a driver |
//! | `position` | Φ = 0 alone |
//! | `travel` | continuation along driver values |
//! | `freedom` | redundant equations and free motions, in words |
//! | `stop` | why a mechanism cannot go on |

mod border;
pub mod compliance;
mod convergence;
pub mod dynamics;
mod elimination;
pub mod equilibrium;
pub mod freedom;
pub mod linear;
pub mod linearised;
mod motion;
pub mod newton;
mod position;
mod rank;
pub mod sensitivity;
mod sparse_lu;
mod stability;
mod statics;
mod stop;
mod system;
mod tangent;
mod travel;
mod wrench;

pub use convergence::Tolerances;
pub use freedom::{FreeMotion, FreedomReport, RedundantEquation};
pub use motion::{Twist, point_position, rotation};
pub use statics::{StaticFailure, StaticReport};
pub use stop::{Stop, StopReason};
pub use system::{StepReport, System, SystemError};
pub use tangent::Tangent;
pub use wrench::{Loaded, Reaction, Wrench};
