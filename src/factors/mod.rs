//! The static design factors: what each is called, how it is found and what its sign means.
//!
//! [`FACTORS`] is the one table of definitions; the command line, reports and `docs/factors.md`
//! are made from it. Every formula is generic over the scalar, so that its derivative is exact.
//!
//! ```
//! use hardpoint::factors::{Convention, find};
//! use hardpoint::model::{Model, Setup};
//! use hardpoint::rig::Corner;
//!
//! let model = Model::load("models/double-wishbone.toml")?;
//! let mut corner = Corner::new(&model, &Setup::default())?;
//! let roll_center = find("rc_height")?;
//! let height = roll_center.value(Convention::Iso, &corner.pose());
//! assert!((height.expect("it is defined at design") - 0.16204).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A factor that is not defined at a state, such as the place of an instant centre when the lines that
//! meet there are parallel, has no value there: see [`NEARLY_PARALLEL`] and [`FARTHEST`].

mod anti;
mod centers;
mod convention;
mod definition;
mod need;
mod place;
mod ratios;
mod screw;
mod steer_axis;
mod steering;
mod table;
mod travel;
pub mod wheel;

pub use convention::Convention;
pub use definition::{Definition, Factor, Formula, Subject};
pub use need::Need;
pub use table::{BASIC, FACTORS, UnknownFactor, basic, find};

use crate::scalar::Real;

/// An instant centre or a screw axis that is farther from the wheel than this (m) is taken to be
/// at infinity: across a kilometre the lines that meet there are parallel to a thousandth.
pub const FARTHEST: f64 = 1e3;

/// A ratio above this is taken to have no denominator: a steer axis within a milliradian of the
/// horizontal does not meet the ground, a spring a thousand times slower than the wheel does not move.
pub const NEARLY_PARALLEL: f64 = 1e3;

/// `numerator / denominator`; `None` where that is above `most`, or 0/0.
fn quotient<S: Real>(numerator: S, denominator: S, most: f64) -> Option<S> {
    let defined = numerator.value().abs() < most * denominator.value().abs();
    defined.then(|| numerator / denominator)
}

#[cfg(test)]
mod tests {
    use super::quotient;

    #[test]
    fn quotients_end_where_they_mean_nothing() {
        assert_eq!(quotient(1.0, 2.0, 1e3), Some(0.5));
        assert_eq!(quotient(-999.0, 1.0, 1e3), Some(-999.0));
        assert_eq!(quotient(1.0, 1e-3, 1e3), None);
        assert_eq!(quotient(0.0, 0.0, 1e3), None);
        assert_eq!(quotient(f64::NAN, 1.0, 1e3), None);
        assert_eq!(quotient(1.0, f64::NAN, 1e3), None);
    }
}
