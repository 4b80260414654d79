//! Single programs of the relations that are measured, in any type of number.
//!
//! `RelationKind::kernels` compiles all programs of all relations for a type of
//! number, which takes minutes for numbers with many parts.

use hardpoint::kernels::{self, RelationKind};
use hardpoint::relation::Place;
use hardpoint::scalar::Scalar;

/// A program that writes Φ, and Φ_q if it computes it.
pub type Program<S> = fn(Place<'_, S>, &mut [S], &mut [S]);

fn exact<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("the slice has the length of the pattern")
}

fn exact_mut<S, const N: usize>(slice: &mut [S]) -> &mut [S; N] {
    slice.try_into().expect("the slice has the length of the pattern")
}

macro_rules! programs {
    (pairs [$($pair:ident $pair_kind:ident),*], one_body [$($one:ident $one_kind:ident),*]) => {
        /// The residual program.
        pub fn residual<S: Scalar>(kind: RelationKind) -> Program<S> {
            match kind {
                $(RelationKind::$pair_kind => |place, phi, _| {
                    kernels::$pair::residual(place.q_i, place.q_j, exact(place.h), exact_mut(phi));
                },)*
                $(RelationKind::$one_kind => |place, phi, _| {
                    kernels::$one::residual(place.q_i, exact(place.h), exact_mut(phi));
                },)*
                _ => panic!("add {} to the list of programs", kind.name()),
            }
        }

        /// The program for residual and Jacobian.
        pub fn jacobian<S: Scalar>(kind: RelationKind) -> Program<S> {
            match kind {
                $(RelationKind::$pair_kind => |place, phi, phi_q| {
                    let (phi, phi_q) = (exact_mut(phi), exact_mut(phi_q));
                    let h = exact(place.h);
                    kernels::$pair::jacobian(place.q_i, place.q_j, h, phi, phi_q, &mut []);
                },)*
                $(RelationKind::$one_kind => |place, phi, phi_q| {
                    let (phi, phi_q) = (exact_mut(phi), exact_mut(phi_q));
                    kernels::$one::jacobian(place.q_i, exact(place.h), phi, phi_q, &mut []);
                },)*
                _ => panic!("add {} to the list of programs", kind.name()),
            }
        }
    };
}

programs!(
    pairs [
        displacement Displacement,
        orthogonal_1 Orthogonal1,
        orthogonal_2 Orthogonal2,
        spherical Spherical,
        squared_distance SquaredDistance
    ],
    one_body [euler_parameters EulerParameters, point_height PointHeight]
);
