//! The symbols that relations are mapped onto.

use symbolica::prelude::Symbol;
use symbolica::symbol;

use crate::validate::{MOST_EQUATIONS, MOST_PARAMETERS};

/// Coordinates of two bodies.
pub const COORDINATES: usize = 14;

/// Intermediates that are registered before any relation is read.
const INTERMEDIATES: usize = 2000;

/// The symbols that relations are mapped onto.
///
/// Symbolica orders terms by the registration of their symbols. One fixed
/// alphabet, registered before anything else, makes the output for a relation
/// independent of the relations before it.
#[derive(Clone)]
pub struct Alphabet {
    /// Coordinates q of both bodies.
    pub coordinates: Vec<Symbol>,
    /// Parameters h.
    pub parameters: Vec<Symbol>,
    /// Multipliers λ.
    pub multipliers: Vec<Symbol>,
    /// Velocities v of both bodies.
    pub velocities: Vec<Symbol>,
    /// Virtual motions δq of both bodies.
    pub virtual_motions: Vec<Symbol>,
    pub(crate) intermediates: Vec<Symbol>,
    /// Accelerations a of the one body of an energy.
    pub accelerations: Vec<Symbol>,
}

impl Alphabet {
    /// Registers the alphabet.
    pub fn register() -> Self {
        let letters = |letter: &str, count: usize| -> Vec<Symbol> {
            (0..count).map(|k| symbol!(format!("hardpoint::{letter}{k}"))).collect()
        };
        Self {
            coordinates: letters("q", COORDINATES),
            parameters: letters("h", MOST_PARAMETERS),
            multipliers: letters("l", MOST_EQUATIONS),
            velocities: letters("v", COORDINATES),
            virtual_motions: letters("d", COORDINATES),
            intermediates: letters("t", INTERMEDIATES),
            accelerations: letters("a", COORDINATES / 2),
        }
    }
}
