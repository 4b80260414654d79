//! From relations to sparse matrices.
//!
//! The sparsity pattern is found once per mechanism. Every output of a kernel
//! then knows its place in the value array, so filling a matrix neither
//! allocates nor searches.
//!
//! The unknowns are the seven coordinates of each moving body, in the order of
//! the bodies. The ground is body 0 with the constant coordinates
//! [`GROUND`]; its columns are dropped. Equations that are left out as redundant
//! have no row.

mod block;
mod elements;
mod inertias;
mod jacobian;
mod kkt;
mod pattern;
mod terms;
mod variation;

pub use elements::{Blend, Elements, Motion};
pub use inertias::Inertias;
pub use jacobian::Jacobian;
pub use kkt::Kkt;
pub use pattern::Pattern;
pub use terms::{Numbering, Terms};
pub use variation::{Along, Derivatives, ElementConstant, Entries, Rows, Variation};

use crate::mechanism::Body;
use crate::relation::{BODY_COORDINATES, Coordinates};

/// The coordinates of the ground: origin and identity rotation.
pub const GROUND: Coordinates<f64> = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

/// The design state: every body at its origin with identity rotation.
pub fn design_state(bodies: &[Body]) -> Vec<Coordinates<f64>> {
    bodies
        .iter()
        .map(|body| {
            let mut coordinates = GROUND;
            coordinates[..3].copy_from_slice(&body.origin);
            coordinates
        })
        .collect()
}

/// Number of unknown coordinates of a system with `body_count` bodies, ground included.
fn unknown_count(body_count: usize) -> usize {
    BODY_COORDINATES * (body_count - 1)
}
