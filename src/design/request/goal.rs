//! What is wanted of a factor, and what difference counts.

use crate::model::Quantity;

/// What is wanted of a factor.
#[derive(Clone, Debug, PartialEq)]
pub enum Goal {
    /// These values (SI), one for each state.
    Values(Vec<f64>),
    /// No value below the first or above the second (SI), at any state.
    Band {
        /// The least value.
        min: Option<f64>,
        /// The greatest value.
        max: Option<f64>,
    },
    /// The values that the model has, at all states.
    Hold,
    /// The mean of all states as small as possible, with its sign.
    Minimise,
    /// The mean of all states as great as possible.
    Maximise,
}

/// The difference (SI) that counts as one where a target does not say: what a designer would notice.
pub(super) fn tolerance(quantity: Quantity) -> f64 {
    let degree = 1.0_f64.to_radians();
    match quantity {
        Quantity::Length | Quantity::LengthByG => 1e-4,
        Quantity::Angle | Quantity::AngleByG => 0.01 * degree,
        Quantity::Gradient => 0.1 * degree,
        Quantity::Pitch => 1e-3,
        Quantity::Ratio | Quantity::Percent | Quantity::Frequency => 0.01,
        Quantity::Force => 10.0,
        Quantity::Torque => 1.0,
        Quantity::Stiffness => 100.0,
        Quantity::RollStiffness | Quantity::RotationalStiffness => 1.0 / degree,
        Quantity::AngleByForce => 0.01 * degree / 1e3,
        Quantity::AngleByTorque => 0.1 * degree / 1e3,
        Quantity::LengthByForce => 1e-4 / 1e3,
        Quantity::Damping | Quantity::RotationalDamping => 10.0,
        Quantity::Mass | Quantity::Inertia | Quantity::Time => 0.1,
        Quantity::Velocity | Quantity::Acceleration => 1e-3,
        Quantity::AngularVelocity | Quantity::AngularAcceleration => 0.1 * degree,
    }
}
