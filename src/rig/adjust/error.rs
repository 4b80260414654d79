//! Why a static state cannot be reached.

use thiserror::Error;

use crate::solve::Stop;

/// Why the adjusters cannot bring a model to its static state.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum AdjustError {
    /// The ride height or the settings of the adjusters cannot be reached.
    #[error(
        "the static state cannot be reached from the hard points: {0}; check `ride_height` and settings"
    )]
    Start(Box<Stop>),
    /// A factor that the suspension does not have.
    #[error(
        "[static] asks for {factor}, which the suspension does not have here; add {needs}, or leave it out"
    )]
    Undefined {
        /// The factor, with its side on an axle.
        factor: String,
        /// What to add to the model.
        needs: String,
    },
    /// An adjuster that has nothing to do with its factor.
    #[error("`{adjuster}` does not change {factor}; let another adjuster set it")]
    NoEffect {
        /// The factor.
        factor: String,
        /// The adjuster.
        adjuster: String,
    },
    /// Adjusters that do the same.
    #[error(
        "the adjusters {adjusters} change {factors} in the same proportion, so they cannot set all of them; \
         leave out one factor, or let another adjuster set it"
    )]
    Alike {
        /// The adjusters.
        adjusters: String,
        /// The factors.
        factors: String,
    },
    /// A value that is out of reach.
    #[error(transparent)]
    OutOfReach(#[from] Box<OutOfReach>),
}

/// How far adjusters can bring a factor. Values are in the units of the model.
#[derive(Clone, Debug, Error, PartialEq)]
#[error(
    "{factor} cannot be brought to {target} {unit} by `{adjuster}`: it stopped at {reached} {unit} with \
     {settings}; {hint}"
)]
pub struct OutOfReach {
    /// The factor.
    pub factor: String,
    /// The adjuster that sets it.
    pub adjuster: String,
    /// The value that it should have.
    pub target: String,
    /// The value that it got to.
    pub reached: String,
    /// Their unit.
    pub unit: String,
    /// Where the adjusters were.
    pub settings: String,
    /// What to do.
    pub hint: String,
}
