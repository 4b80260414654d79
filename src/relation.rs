//! What every generated kernel module implements.
//!
//! A relation is one file of `constraints/`: equations Φ(q; h) between the
//! coordinates of a body *i* and, for most relations, a body *j*.
//! Each body has seven coordinates q = (x, y, z, e0, e1, e2, e3): the position
//! r of its frame in metres and its Euler parameters p. The local coordinates
//! of a pair are numbered 0..7 for body *i* and 7..14 for body *j*.

use crate::scalar::Scalar;

/// Coordinates of one body: position (m), then Euler parameters.
pub const BODY_COORDINATES: usize = 7;

/// The coordinates of one body.
pub type Coordinates<S> = [S; BODY_COORDINATES];

/// Where a kernel is evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Place<'a, S> {
    /// Coordinates of body *i*.
    pub q_i: &'a Coordinates<S>,
    /// Coordinates of body *j*; not read by relations of one body.
    pub q_j: &'a Coordinates<S>,
    /// The relation's own parameters, in the order of [`Shape::parameters`].
    pub h: &'a [S],
}

/// A parameter of a relation, as its file declares it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// The name that the expressions use.
    pub name: &'static str,
    /// Number of components: 1 or 3.
    pub size: usize,
    /// Position of the first component in `h`.
    pub offset: usize,
    /// Unit, such as `m`; `1` without dimension.
    pub unit: &'static str,
    /// The frame that the components refer to: `body i`, `body j` or `ground`; empty for scalars.
    pub frame: &'static str,
    /// What it is, in words.
    pub meaning: &'static str,
}

/// Operations of one straight-line program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications and negations.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots, sines, cosines and other functions.
    pub functions: usize,
}

/// What is known about a relation when its kernels are generated.
///
/// Kernels write only the entries of a sparsity pattern, in its order.
/// A pattern lists (row, column) pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Name of the file without its ending, such as `orthogonal_1`.
    pub name: &'static str,
    /// Title in words.
    pub title: &'static str,
    /// The equation for readers.
    pub equation: &'static str,
    /// Where the equation comes from.
    pub reference: &'static str,
    /// 1 or 2.
    pub bodies: usize,
    /// Length m of Φ.
    pub equations: usize,
    /// Unit of Φ.
    pub unit: &'static str,
    /// The parameters h in order.
    pub parameters: &'static [Parameter],
    /// Pattern of Φ_q: (equation, coordinate).
    pub jacobian: &'static [(u8, u8)],
    /// Pattern of W(q) where the relation states `work`; otherwise W = Φ_q and this is empty.
    pub work: &'static [(u8, u8)],
    /// Pattern of (Wᵀλ)_q: (coordinate, coordinate). Without `work` it is
    /// symmetric and only entries with row ≥ column are stored.
    pub curvature: &'static [(u8, u8)],
    /// Pattern of Φ_h: (equation, component of h).
    pub design: &'static [(u8, u8)],
    /// Pattern of (Wᵀλ)_h: (coordinate, component of h).
    pub force_design: &'static [(u8, u8)],
    /// Pattern of (Φ_q v)_q: (equation, coordinate).
    pub rate: &'static [(u8, u8)],
    /// Pattern of (Φ_q v)_h: (equation, component of h).
    pub rate_design: &'static [(u8, u8)],
    /// Operations of the programs `residual`, `jacobian`, `curvature`, `design`, `rate`.
    pub operations: [Operations; 5],
}

impl Shape {
    /// Number of components of h.
    pub fn parameter_count(&self) -> usize {
        self.parameters.iter().map(|parameter| parameter.size).sum()
    }

    /// Whether the force works on rows other than Φ_q, which makes the curvature unsymmetric.
    pub fn has_work(&self) -> bool {
        !self.work.is_empty()
    }
}

/// The kernels of one relation.
///
/// Every method is one straight-line program. Output slices have the length of
/// the pattern that [`Shape`] names; vectors Φ and λ have [`Shape::equations`]
/// entries, a velocity has seven entries for each body.
///
/// # Panics
/// A slice of another length than stated is a programming error and panics.
pub trait Relation<S: Scalar>: Sync {
    /// Patterns, parameters and operation counts.
    fn shape(&self) -> &'static Shape;

    /// Φ.
    fn residual(&self, place: Place<'_, S>, phi: &mut [S]);

    /// Φ, Φ_q and W (empty without `work`).
    fn jacobian(&self, place: Place<'_, S>, phi: &mut [S], phi_q: &mut [S], work: &mut [S]);

    /// Φ, Φ_q, W and (Wᵀλ)_q.
    fn curvature(
        &self,
        place: Place<'_, S>,
        lambda: &[S],
        phi: &mut [S],
        phi_q: &mut [S],
        work: &mut [S],
        curvature: &mut [S],
    );

    /// Φ_h and (Wᵀλ)_h.
    fn design(&self, place: Place<'_, S>, lambda: &[S], phi_h: &mut [S], force_h: &mut [S]);

    /// (Φ_q v)_q and (Φ_q v)_h for the velocities v_i and v_j.
    fn rate(
        &self,
        place: Place<'_, S>,
        v_i: &Coordinates<S>,
        v_j: &Coordinates<S>,
        rate_q: &mut [S],
        rate_h: &mut [S],
    );
}

/// A slice as an array of the length that a kernel works on.
#[inline(always)]
pub(crate) fn exact<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("the slice has the length of the pattern")
}

/// As [`exact`], for writing.
#[inline(always)]
pub(crate) fn exact_mut<S, const N: usize>(slice: &mut [S]) -> &mut [S; N] {
    slice.try_into().expect("the slice has the length of the pattern")
}
