//! From symbolic expressions to the entries of every kernel output.

use symbolica::prelude::{Atom, Symbol};

use crate::algebra::{Algebra, Variable};
use crate::alphabet::Alphabet;
use crate::lower::{Flaw, Lowered, lower};
use crate::validate::Relation;

/// The structural nonzeros of one output: row, column, value.
pub type Entries = Vec<(usize, usize, Atom)>;

/// Every kernel output of a relation as expressions over named intermediates.
pub struct Derived {
    /// The intermediates that the entries refer to.
    pub algebra: Algebra,
    /// Φ.
    pub residual: Vec<Atom>,
    /// Φ_q.
    pub jacobian: Entries,
    /// W where the relation states `work`, otherwise empty.
    pub work: Entries,
    /// (Wᵀλ)_q; without `work` only row ≥ column.
    pub curvature: Entries,
    /// Φ_h.
    pub design: Entries,
    /// (Wᵀλ)_h.
    pub force_design: Entries,
    /// (Φ_q v)_q.
    pub rate: Entries,
    /// (Φ_q v)_h.
    pub rate_design: Entries,
}

/// Differentiates a relation.
///
/// # Errors
/// What makes its equations unusable.
pub fn differentiate(relation: &Relation, alphabet: &Alphabet) -> Result<Derived, Vec<Flaw>> {
    let expressions: Vec<_> = std::iter::once(&relation.residual).chain(&relation.work).collect();
    let Lowered { algebra, mut expressions } = lower(&relation.heading, &expressions, alphabet)?;
    let work = relation.work.as_ref().and_then(|_| expressions.pop());
    derive(relation, algebra, expressions.concat(), work.as_deref())
}

fn derive(
    relation: &Relation,
    mut algebra: Algebra,
    residual: Vec<Atom>,
    work: Option<&[Atom]>,
) -> Result<Derived, Vec<Flaw>> {
    let alphabet = algebra.alphabet.clone();
    let coordinates = inputs(&alphabet.coordinates[..7 * relation.bodies]);
    let parameters = inputs(&alphabet.parameters[..relation.heading.parameter_count()]);
    let rows = residual.len();

    let jacobian = rows_by_columns(&mut algebra, &residual, &coordinates);
    let work_rows = work.map(|work| {
        let virtual_motions = inputs(&alphabet.virtual_motions[..7 * relation.bodies]);
        rows_by_columns(&mut algebra, work, &virtual_motions)
    });
    check(&algebra, rows, &jacobian, work_rows.as_ref())?;

    // The generalized force Wᵀλ, before any of it is differentiated.
    let force: Vec<Atom> = match &work_rows {
        None => {
            let energy = contract(&residual, &alphabet.multipliers);
            algebra.gradient(&energy, &coordinates)
        }
        Some(entries) => (0..coordinates.len())
            .map(|column| {
                let terms = entries.iter().filter(|entry| entry.1 == column);
                Atom::add_many(
                    terms.map(|(row, _, value)| value * Atom::var(alphabet.multipliers[*row])),
                )
            })
            .collect(),
    };
    let mut curvature = rows_by_columns(&mut algebra, &force, &coordinates);
    if work.is_none() {
        curvature.retain(|(row, column, _)| row >= column);
    }
    let design = rows_by_columns(&mut algebra, &residual, &parameters);
    let force_design = rows_by_columns(&mut algebra, &force, &parameters);
    let velocity: Vec<Atom> =
        residual.iter().map(|phi| algebra.derivative(phi, Variable::Motion)).collect();
    let rate = rows_by_columns(&mut algebra, &velocity, &coordinates);
    let rate_design = rows_by_columns(&mut algebra, &velocity, &parameters);
    Ok(Derived {
        algebra,
        residual,
        jacobian,
        work: work_rows.unwrap_or_default(),
        curvature,
        design,
        force_design,
        rate,
        rate_design,
    })
}

pub(crate) fn inputs(symbols: &[Symbol]) -> Vec<Variable> {
    symbols.iter().map(|&symbol| Variable::Input(symbol)).collect()
}

fn contract(rows: &[Atom], multipliers: &[Symbol]) -> Atom {
    Atom::add_many(rows.iter().zip(multipliers).map(|(row, &lambda)| row * Atom::var(lambda)))
}

pub(crate) fn rows_by_columns(
    algebra: &mut Algebra,
    rows: &[Atom],
    columns: &[Variable],
) -> Entries {
    let mut entries = Vec::new();
    for (row, expression) in rows.iter().enumerate() {
        for (column, &variable) in columns.iter().enumerate() {
            let value = algebra.derivative(expression, variable);
            if !algebra.vanishes(&value) {
                entries.push((row, column, value));
            }
        }
    }
    entries
}

fn check(
    algebra: &Algebra,
    rows: usize,
    jacobian: &Entries,
    work: Option<&Entries>,
) -> Result<(), Vec<Flaw>> {
    let mut flaws = Vec::new();
    for row in 0..rows {
        let Some(work) = work else {
            if jacobian.iter().all(|entry| entry.0 != row) {
                flaws.push(Flaw::ConstantEquation(row));
            }
            continue;
        };
        let mut entries = work.iter().filter(|entry| entry.0 == row).peekable();
        let virtual_motions = &algebra.alphabet.virtual_motions;
        if entries.peek().is_none() {
            flaws.push(Flaw::ConstantWork(row));
        } else if entries.any(|entry| algebra.depends_on(&entry.2, virtual_motions)) {
            flaws.push(Flaw::NonlinearWork(row));
        }
    }
    if flaws.is_empty() { Ok(()) } else { Err(flaws) }
}
