//! The programs of one relation: one for each set of outputs that is asked for together.

use symbolica::prelude::Atom;

use crate::alphabet::Alphabet;
use crate::differentiate::{Derived, Entries, differentiate};
use crate::lower::Flaw;
use crate::program::{Program, ProgramError};
use crate::translate::shortest_program;
use crate::validate::Relation;

/// A sparsity pattern: (row, column) of each stored entry.
pub type Pattern = Vec<(usize, usize)>;

/// The names of the programs, in the order in which their operations are listed.
pub const PROGRAMS: [&str; 5] = ["residual", "jacobian", "curvature", "design", "rate"];

/// Everything that is emitted for one relation.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// The relation.
    pub relation: Relation,
    /// Pattern of Φ_q.
    pub jacobian: Pattern,
    /// Pattern of W, empty without `work`.
    pub work: Pattern,
    /// Pattern of (Wᵀλ)_q.
    pub curvature: Pattern,
    /// Pattern of Φ_h.
    pub design: Pattern,
    /// Pattern of (Wᵀλ)_h.
    pub force_design: Pattern,
    /// Pattern of (Φ_q v)_q.
    pub rate: Pattern,
    /// Pattern of (Φ_q v)_h.
    pub rate_design: Pattern,
    /// The programs in the order of [`PROGRAMS`]. Their outputs are, one after
    /// the other: Φ; Φ, Φ_q, W; Φ, Φ_q, W, (Wᵀλ)_q; Φ_h, (Wᵀλ)_h; (Φ_q v)_q, (Φ_q v)_h.
    pub programs: [Program; 5],
}

/// Why a checked relation has no kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum KernelError {
    /// Its equations cannot be used.
    Flaws(Vec<Flaw>),
    /// Its expressions have no program.
    Program(ProgramError),
}

impl From<ProgramError> for KernelError {
    fn from(error: ProgramError) -> Self {
        Self::Program(error)
    }
}

impl Kernel {
    /// Differentiates a relation and finds its programs. Must run inside [`crate::session::run`].
    ///
    /// # Errors
    /// [`KernelError`].
    pub fn new(relation: &Relation, alphabet: &Alphabet) -> Result<Self, KernelError> {
        let derived = differentiate(relation, alphabet).map_err(KernelError::Flaws)?;
        let Derived {
            algebra,
            residual,
            jacobian,
            work,
            curvature,
            design,
            force_design,
            rate,
            rate_design,
        } = derived;
        let with_jacobian: Vec<Atom> =
            residual.iter().chain(values(&jacobian)).chain(values(&work)).cloned().collect();
        let with_curvature: Vec<Atom> =
            with_jacobian.iter().chain(values(&curvature)).cloned().collect();
        let with_design: Vec<Atom> =
            values(&design).chain(values(&force_design)).cloned().collect();
        let with_rate: Vec<Atom> = values(&rate).chain(values(&rate_design)).cloned().collect();
        let programs = [
            shortest_program(&algebra, &residual)?,
            shortest_program(&algebra, &with_jacobian)?,
            shortest_program(&algebra, &with_curvature)?,
            shortest_program(&algebra, &with_design)?,
            shortest_program(&algebra, &with_rate)?,
        ];
        Ok(Self {
            relation: relation.clone(),
            jacobian: pattern(&jacobian),
            work: pattern(&work),
            curvature: pattern(&curvature),
            design: pattern(&design),
            force_design: pattern(&force_design),
            rate: pattern(&rate),
            rate_design: pattern(&rate_design),
            programs,
        })
    }
}

pub(crate) fn values(entries: &Entries) -> impl Iterator<Item = &Atom> {
    entries.iter().map(|(_, _, value)| value)
}

pub(crate) fn pattern(entries: &Entries) -> Pattern {
    entries.iter().map(|&(row, column, _)| (row, column)).collect()
}
