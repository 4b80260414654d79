//! The programs of a kinetic energy: T, the force of inertia and its tangents.

use symbolica::prelude::Atom;

use crate::algebra::{Algebra, Variable};
use crate::alphabet::Alphabet;
use crate::differentiate::{Entries, inputs, rows_by_columns};
use crate::kernel::{KernelError, Pattern, pattern, values};
use crate::lower::{Flaw, Lowered, lower};
use crate::program::Program;
use crate::translate::shortest_program;
use crate::validate::Energy;

/// The names of the programs, in the order in which their operations are listed.
pub const PROGRAMS: [&str; 3] = ["energy", "force", "tangent"];

/// Everything that is emitted for one kinetic energy.
#[derive(Clone, Debug)]
pub struct EnergyKernel {
    /// The energy.
    pub energy: Energy,
    /// Pattern of F_q.
    pub force_q: Pattern,
    /// Pattern of F_q̇.
    pub force_v: Pattern,
    /// Pattern of F_q̈, only row ≥ column.
    pub mass: Pattern,
    /// The programs in the order of [`PROGRAMS`]. Their outputs are, one after
    /// the other: T; F; F, F_q, F_q̇, F_q̈.
    pub programs: [Program; 3],
}

impl EnergyKernel {
    /// Differentiates an energy and finds its programs. Must run inside [`crate::session::run`].
    ///
    /// # Errors
    /// [`KernelError`].
    pub fn new(energy: &Energy, alphabet: &Alphabet) -> Result<Self, KernelError> {
        let Derived { algebra, energy: value, force, force_q, force_v, mass } =
            differentiate(energy, alphabet).map_err(KernelError::Flaws)?;
        let tangents = values(&force_q).chain(values(&force_v)).chain(values(&mass));
        let with_tangents: Vec<Atom> = force.iter().chain(tangents).cloned().collect();
        let programs = [
            shortest_program(&algebra, &[value])?,
            shortest_program(&algebra, &force)?,
            shortest_program(&algebra, &with_tangents)?,
        ];
        Ok(Self {
            energy: energy.clone(),
            force_q: pattern(&force_q),
            force_v: pattern(&force_v),
            mass: pattern(&mass),
            programs,
        })
    }
}

struct Derived {
    algebra: Algebra,
    energy: Atom,
    force: Vec<Atom>,
    force_q: Entries,
    force_v: Entries,
    mass: Entries,
}

/// Lagrange's F = d/dt T_q̇ − T_q for the motion q(t) with q̇ = v and q̈ = a.
fn differentiate(energy: &Energy, alphabet: &Alphabet) -> Result<Derived, Vec<Flaw>> {
    let Lowered { mut algebra, expressions } = lower(&energy.heading, &[&energy.energy], alphabet)?;
    let energy = Atom::add_many(expressions.concat());
    let [q, v, a] = [&alphabet.coordinates, &alphabet.velocities, &alphabet.accelerations]
        .map(|symbols| inputs(&symbols[..7]));
    let along_q = algebra.gradient(&energy, &q);
    let momentum = algebra.gradient(&energy, &v);
    let force: Vec<Atom> = momentum
        .iter()
        .zip(&along_q)
        .map(|(momentum, along_q)| algebra.derivative(momentum, Variable::Motion) - along_q)
        .collect();
    let mut mass = rows_by_columns(&mut algebra, &force, &a);
    if mass.is_empty() {
        return Err(vec![Flaw::NoMass]);
    }
    for (_, _, value) in &mass {
        for &velocity in &v {
            let derivative = algebra.derivative(value, velocity);
            if !algebra.vanishes(&derivative) {
                return Err(vec![Flaw::NotQuadratic]);
            }
        }
    }
    mass.retain(|(row, column, _)| row >= column);
    let force_q = rows_by_columns(&mut algebra, &force, &q);
    let force_v = rows_by_columns(&mut algebra, &force, &v);
    Ok(Derived { algebra, energy, force, force_q, force_v, mass })
}
