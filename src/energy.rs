//! What every generated module of a kinetic energy implements.
//!
//! An energy is one file of `constraints/`: T(q, q̇; h) of one body with the seven
//! coordinates of [`crate::relation`]. The force of inertia is Lagrange's
//! F = d/dt T_q̇ − T_q along a motion with velocities v = q̇ and accelerations
//! a = q̈; the equations of motion are F + Φ_qᵀλ = Q (Haug, *Computer Aided
//! Kinematics and Dynamics of Mechanical Systems*, chapter 11).
//!
//! T does not see a velocity along p: the mass matrix has rank 6, and the
//! normalisation pᵀp = 1 makes the equations of motion regular.

use crate::relation::{Coordinates, Operations, Parameter};
use crate::scalar::Scalar;

/// Where the kernels of an energy are evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Motion<'a, S> {
    /// Coordinates of the body.
    pub q: &'a Coordinates<S>,
    /// Their velocities (m/s, 1/s).
    pub v: &'a Coordinates<S>,
    /// Their accelerations (m/s², 1/s²); not read by the energy itself.
    pub a: &'a Coordinates<S>,
    /// The parameters, in the order of [`EnergyShape::parameters`].
    pub h: &'a [S],
}

/// What is known about an energy when its kernels are generated.
///
/// Patterns list (row, column) pairs of coordinates, in the order in which kernels write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EnergyShape {
    /// Name of the file without its ending, such as `rigid_body`.
    pub name: &'static str,
    /// Title in words.
    pub title: &'static str,
    /// The equation for readers.
    pub equation: &'static str,
    /// Where the equation comes from.
    pub reference: &'static str,
    /// The parameters h in order.
    pub parameters: &'static [Parameter],
    /// Pattern of F_q.
    pub force_q: &'static [(u8, u8)],
    /// Pattern of F_q̇.
    pub force_v: &'static [(u8, u8)],
    /// Pattern of the mass matrix F_q̈ = T_q̇q̇: symmetric, only entries with row ≥ column.
    pub mass: &'static [(u8, u8)],
    /// Operations of the programs `energy`, `force`, `tangent`.
    pub operations: [Operations; 3],
}

impl EnergyShape {
    /// Number of components of h.
    pub fn parameter_count(&self) -> usize {
        self.parameters.iter().map(|parameter| parameter.size).sum()
    }
}

/// The kernels of one kinetic energy.
///
/// Every method is one straight-line program. F has seven entries (N for r, N m
/// for p); the other slices have the length of the pattern that [`EnergyShape`] names.
///
/// # Panics
/// A slice of another length than stated is a programming error and panics.
pub trait KineticEnergy<S: Scalar>: Sync {
    /// Patterns, parameters and operation counts.
    fn shape(&self) -> &'static EnergyShape;

    /// T (J).
    fn energy(&self, motion: Motion<'_, S>) -> S;

    /// F = d/dt T_q̇ − T_q.
    fn force(&self, motion: Motion<'_, S>, force: &mut [S]);

    /// F, F_q, F_q̇ and F_q̈.
    fn tangent(
        &self,
        motion: Motion<'_, S>,
        force: &mut [S],
        force_q: &mut [S],
        force_v: &mut [S],
        mass: &mut [S],
    );
}
