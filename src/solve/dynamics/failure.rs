//! Why a motion cannot be integrated.

use thiserror::Error;

/// Why a motion does not begin or does not go on. The state is the last one that was reached.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum DynamicsFailure {
    /// A setting of the integrator that makes no sense.
    #[error("the {what} of the integrator is {value}; it has to be {range}")]
    Setting {
        /// Which setting.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        range: &'static str,
    },
    /// A time that has passed.
    #[error("the motion cannot go on to {to} s: it is at {time} s already; ask for a later time")]
    Time {
        /// The time that was asked for (s).
        to: f64,
        /// The time that was reached (s).
        time: f64,
    },
    /// A start that does not satisfy the joints.
    #[error(
        "the motion cannot begin: {equation}, is violated by {residual:.1e}; start from a position \
         in which all joints and drivers hold"
    )]
    NotAssembled {
        /// The equation in words.
        equation: String,
        /// By how much, in the unit of the equation.
        residual: f64,
    },
    /// A coordinate, velocity or load that is infinite or not a number.
    #[error("the {what} of {body} is not finite ({value}); give a finite number")]
    NotFinite {
        /// `position`, `velocity` or `load`.
        what: &'static str,
        /// The body.
        body: String,
        /// The number.
        value: f64,
    },
    /// A force that has no value, such as that of a spring of length zero.
    #[error(
        "force {force} has no value at {time} s ({value}): its points coincide, or its bushing has turned too far"
    )]
    NoForce {
        /// The force element.
        force: String,
        /// Time (s).
        time: f64,
        /// What came of it.
        value: f64,
    },
    /// A motion without inertia.
    #[error(
        "body {} has no mass or moment of inertia against this motion: {motion}. Give it mass and \
         moments of inertia, or hold the motion with a joint or a driver",
        .bodies.join(", ")
    )]
    NoInertia {
        /// The bodies that move.
        bodies: Vec<String>,
        /// The motion in words.
        motion: String,
    },
    /// The equations of motion have no unique solution at the start.
    #[error(
        "accelerations and reactions are not determined at {time} s: the joints are at a dead centre. \
         Start from another position, or free a joint"
    )]
    Undetermined {
        /// Time (s).
        time: f64,
    },
    /// Newton's method fails even in the smallest step.
    #[error(
        "the motion stops at {time:.9} s: even a step of {step:.1e} s does not converge; the largest residual \
         is {residual:.1e} (relative) in {equation}. Look for a dead centre, a stop that is too stiff or \
         a force that jumps there, or take shorter steps"
    )]
    NoConvergence {
        /// Time (s) that was reached.
        time: f64,
        /// The last step (s) that was tried.
        step: f64,
        /// The equation or body with the largest residual, in words.
        equation: String,
        /// The residual, relative.
        residual: f64,
    },
    /// The local error stays too large even in the smallest step.
    #[error(
        "the motion stops at {time:.9} s: even a step of {step:.1e} s has a local error of {error:.1e}, more than \
         the tolerance; a force may jump there. Smooth it, or raise the tolerance"
    )]
    TooInexact {
        /// Time (s) that was reached.
        time: f64,
        /// The last step (s) that was tried.
        step: f64,
        /// Its local error, relative.
        error: f64,
    },
    /// A body leaves for good.
    #[error(
        "the motion runs away: at {time:.6} s {body} is {distance:.0} m from where it began. Check the signs of \
         stiffness and damping, hold it with a joint or a spring, or ask for a shorter time"
    )]
    RanAway {
        /// The body.
        body: String,
        /// How far it is (m).
        distance: f64,
        /// Time (s).
        time: f64,
    },
    /// An equation that is left out as redundant is not satisfied.
    #[error(
        "{equation}, is redundant at the start but is violated by {residual:.1e} at {time:.9} s: \
         the mechanism has left the position in which its joints agree"
    )]
    Inconsistent {
        /// The equation in words.
        equation: String,
        /// By how much, in the unit of the equation.
        residual: f64,
        /// Time (s).
        time: f64,
    },
}
