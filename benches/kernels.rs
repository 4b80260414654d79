//! Residual, Jacobian and curvature of one relation: one symbolic kernel beside
//! the other ways to the same numbers.

mod common;

use std::hint::black_box;

use common::assert_same;
use common::dual::State;
use common::measure::{Way, compare, criterion};
use common::methods::{Blocks, DIFFERENCES, DUALS, Differences, Symbolic, duals, gradient};
use criterion::Criterion;
use hardpoint::kernels::RelationKind;
use hardpoint::relation::Place;

const RELATIONS: [RelationKind; 4] = [
    RelationKind::Spherical,
    RelationKind::Orthogonal1,
    RelationKind::Orthogonal2,
    RelationKind::SquaredDistance,
];

/// Φ, Φ_q and (Φ_qᵀλ)_q.
type Outputs = [Vec<f64>; 3];

fn evaluate(blocks: &mut dyn Blocks, state: &State, outputs: &mut Outputs) {
    let [q_i, q_j] = [&state.q[..7], &state.q[7..]].map(|q| q.try_into().expect("seven"));
    let place = Place { q_i, q_j, h: &state.h };
    let [phi, phi_q, curvature] = outputs;
    blocks.curvature(place, &state.lambda, phi, phi_q, curvature);
}

fn relation(criterion: &mut Criterion, kind: RelationKind) {
    let shape = kind.shape();
    let state = State::random(shape, &mut fastrand::Rng::with_seed(1));
    let empty = [shape.equations, shape.jacobian.len(), shape.curvature.len()]
        .map(|length| vec![f64::NAN; length]);
    let mut expected = empty.clone();
    evaluate(&mut Symbolic::new(kind), &state, &mut expected);

    let ways: [(&str, Box<dyn Blocks>, f64); 6] = [
        ("symbolic", Box::new(Symbolic::new(kind)), DUALS),
        ("differences, 14 directions", Box::new(Differences::blind(kind)), DIFFERENCES),
        ("differences, known pattern", Box::new(Differences::new(kind)), DIFFERENCES),
        ("duals, one direction at a time", duals::for_curvature(kind), DUALS),
        ("duals, all directions at once", gradient::for_curvature(kind), DUALS),
        ("hyper-duals, one entry at a time", Box::new(duals::HyperDuals::new(kind)), DUALS),
    ];
    let ways = ways.into_iter().map(|(name, mut blocks, tolerance)| -> Way<'_> {
        let mut found = empty.clone();
        evaluate(&mut *blocks, &state, &mut found);
        for (found, expected) in found.iter().zip(&expected) {
            assert_same(name, found, expected, tolerance);
        }
        let state = &state;
        let work = move || {
            evaluate(&mut *blocks, black_box(state), &mut found);
            black_box(&found);
        };
        (name, Box::new(work))
    });
    compare(criterion, &format!("kernels/{}", kind.name()), ways.collect());
}

fn main() {
    let mut criterion = criterion();
    for kind in RELATIONS {
        relation(&mut criterion, kind);
    }
    criterion.final_summary();
}
