//! Filling Φ_q and the matrix of static equilibrium of the sedan's double
//! wishbone with blocks that are found in different ways.

mod common;

use std::hint::black_box;

use common::assembly::{Assembly, Method};
use common::assert_same;
use common::measure::{BASE, run};
use common::methods::{DIFFERENCES, DUALS, Differences, Symbolic, duals, gradient};
use common::scene::Scene;
use criterion::Criterion;
use hardpoint::assembly::{Jacobian, Kkt};

const METHODS: [(&str, Method, Method, f64); 4] = [
    (BASE, |kind| Box::new(Symbolic::new(kind)), |kind| Box::new(Symbolic::new(kind)), DUALS),
    (
        "differences, block by block",
        |kind| Box::new(Differences::new(kind)),
        |kind| Box::new(Differences::new(kind)),
        DIFFERENCES,
    ),
    ("duals, one direction at a time", duals::for_jacobian, duals::for_curvature, DUALS),
    ("duals, all directions at once", gradient::for_jacobian, gradient::for_curvature, DUALS),
];

/// Φ and Φ_q.
fn jacobian(criterion: &mut Criterion, scene: &Scene) {
    let Scene { expansion, numbering, phi_q, state, h, .. } = scene;
    let mut phi = vec![0.0; expansion.equation_count()];
    let mut shipped = Jacobian::new(scene.terms.clone(), numbering);
    shipped.fill(state, h, &mut phi);
    let expected = shipped.values().to_vec();

    let mut group = criterion.benchmark_group("assembly/jacobian");
    for (name, method, _, tolerance) in METHODS {
        let mut assembly = Assembly::jacobian(expansion, numbering, phi_q, method);
        assembly.fill_jacobian(state, h, &mut phi);
        assert_same(name, assembly.values(), &expected, tolerance);
        group.bench_function(name, |bencher| {
            bencher.iter(|| assembly.fill_jacobian(black_box(state), h, &mut phi));
        });
    }
    group.bench_function("as shipped", |bencher| {
        bencher.iter(|| shipped.fill(black_box(state), h, &mut phi));
    });
    group.finish();
}

/// Φ, Φ_qᵀλ and the matrix of static equilibrium.
fn kkt(criterion: &mut Criterion, scene: &Scene) {
    let Scene { expansion, numbering, kkt, h, lambda, .. } = scene;
    let mut state = scene.state.clone();
    let mut phi = vec![0.0; expansion.equation_count()];
    let mut shipped = Kkt::new(scene.terms.clone(), numbering);
    shipped.fill(&state, h, lambda, &mut phi);
    let expected = shipped.values().to_vec();

    let mut group = criterion.benchmark_group("assembly/kkt");
    for (name, _, method, tolerance) in METHODS {
        let mut assembly = Assembly::kkt(expansion, numbering, kkt, method);
        assembly.fill_kkt(&state, h, lambda, &mut phi);
        assert_same(name, assembly.values(), &expected, tolerance);
        assert_same(name, &assembly.force, shipped.force(), DUALS);
        group.bench_function(name, |bencher| {
            bencher.iter(|| assembly.fill_kkt(black_box(&state), h, lambda, &mut phi));
        });
    }

    let name = "differences of the assembled matrix";
    let mut assembly = Assembly::kkt(expansion, numbering, kkt, METHODS[0].2);
    assembly.fill_kkt_by_assembled_differences(&mut state, h, lambda, &mut phi);
    assert_same(name, assembly.values(), &expected, DIFFERENCES);
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            let state = black_box(&mut state);
            assembly.fill_kkt_by_assembled_differences(state, h, lambda, &mut phi);
        });
    });
    group.bench_function("as shipped", |bencher| {
        bencher.iter(|| shipped.fill(black_box(&state), h, lambda, &mut phi));
    });
    group.finish();
}

fn main() {
    let scene = Scene::sedan();
    run(|criterion| {
        jacobian(criterion, &scene);
        kkt(criterion, &scene);
    });
}
