//! Residual, Jacobian and curvature of one relation: one symbolic kernel beside
//! the other ways to the same numbers.

mod common;

use std::hint::black_box;

use common::assert_same;
use common::measure::{BASE, run};
use common::methods::{Blocks, DIFFERENCES, DUALS, Differences, Symbolic, duals, gradient};
use common::support::State;
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

    let mut group = criterion.benchmark_group(format!("kernels/{}", kind.name()));
    let ways: [(&str, Box<dyn Blocks>, f64); 6] = [
        (BASE, Box::new(Symbolic::new(kind)), DUALS),
        ("differences, 14 directions", Box::new(Differences::blind(kind)), DIFFERENCES),
        ("differences, known pattern", Box::new(Differences::new(kind)), DIFFERENCES),
        ("duals, one direction at a time", duals::for_curvature(kind), DUALS),
        ("duals, all directions at once", gradient::for_curvature(kind), DUALS),
        ("hyper-duals, one entry at a time", Box::new(duals::HyperDuals::new(kind)), DUALS),
    ];
    for (name, mut blocks, tolerance) in ways {
        let mut found = empty.clone();
        evaluate(&mut *blocks, &state, &mut found);
        for (found, expected) in found.iter().zip(&expected) {
            assert_same(name, found, expected, tolerance);
        }
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                evaluate(&mut *blocks, black_box(&state), &mut found);
                black_box(&found);
            });
        });
    }
    group.finish();
}

fn main() {
    run(|criterion| {
        for kind in RELATIONS {
            relation(criterion, kind);
        }
    });
}
