//! Suspension kinematics, compliance and design on exact symbolic derivatives.
//!
//! The equations of joints are text, in `constraints/`. When the crate is built
//! a computer algebra system differentiates them, up to the Jacobian of the
//! constraint Jacobian, and specialised Rust kernels come of it ([`kernels`]). On
//! them stand a sparse Newton solver ([`solve`]), a virtual test rig ([`rig`])
//! and the static design factors ([`factors`]).
//!
//! Inside, everything is in SI units, radians and ISO 8855 axes (x forward, y left,
//! z up); a model file names its own units and axes, and reports come in those.
//!
//! # From a model file to bump steer
//!
//! ```
//! use hardpoint::factors::wheel;
//! use hardpoint::model::{Model, Setup};
//! use hardpoint::rig::{Corner, Event, Held, Sweep, SweepPlan};
//!
//! let model = Model::load("models/double-wishbone.toml")?;
//! let mut corner = Corner::new(&model, &Setup::default())?;
//! assert!(corner.freedom().is_exact(), "{}", corner.freedom());
//!
//! // 30 mm of rebound to 30 mm of jounce, the rack held in the middle.
//! let plan = SweepPlan { event: Event::Travel, from: -0.03, to: 0.03, step: 0.01, held: Held::default() };
//! let sweep = Sweep::run(&mut corner, &plan, |_| {});
//! assert!(sweep.stops.is_empty());
//! for row in &sweep.rows {
//!     let pose = &row.poses[0];
//!     let toe = wheel::toe(pose.wheel.spin, pose.side).to_degrees();
//!     println!("{:6.1} mm  toe {toe:7.4}° (+ toe-in)", pose.travel * 1000.0);
//! }
//! # let toe = |k: usize| {
//! #     let pose = sweep.rows[k].poses[0];
//! #     wheel::toe(pose.wheel.spin, pose.side).to_degrees()
//! # };
//! # assert!((toe(3) - 0.1).abs() < 1e-12 && toe(6) < toe(0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A mechanism of one's own
//!
//! [`mechanism::Mechanism`] takes bodies, points, joints, drivers, force elements and masses;
//! [`solve::System`] analyses it, says what is redundant or free, and moves it;
//! [`solve::equilibrium::Equilibrium`] finds where it rests and what its joints carry;
//! [`solve::dynamics::Dynamics`] integrates its motion. The example at [`solve::System`] swings a
//! pendulum by a driver, the one at [`solve::dynamics::Dynamics`] lets it swing.
//!
//! # Features
//!
//! `symbolic` (default) derives the kernels afresh at build time and needs symbolica
//! for that. Without it the committed kernels, the same text, are compiled.

pub mod assembly;
pub mod design;
pub mod energy;
pub mod export;
pub mod factors;
pub mod import;
pub mod kernels;
pub mod mechanism;
pub mod model;
pub mod programme;
pub mod relation;
pub mod report;
pub mod rig;
pub mod scalar;
pub mod solve;
pub mod vector;
