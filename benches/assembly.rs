//! Filling Φ_q and the matrix of static equilibrium of the sedan's double
//! wishbone with blocks that are found in different ways.

mod common;

use std::hint::black_box;

use common::assembly::{Assembly, Method};
use common::assert_same;
use common::measure::{Way, compare, criterion};
use common::methods::{DIFFERENCES, DUALS, Differences, Symbolic, duals, gradient};
use common::scene::Scene;
use criterion::Criterion;
use hardpoint::assembly::{Jacobian, Kkt};

const METHODS: [(&str, Method, Method, f64); 4] = [
    ("symbolic", |kind| Box::new(Symbolic::new(kind)), |kind| Box::new(Symbolic::new(kind)), DUALS),
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

    let mut ways: Vec<Way<'_>> = vec![];
    for (name, method, _, tolerance) in METHODS {
        let mut assembly = Assembly::jacobian(expansion, numbering, phi_q, method);
        assembly.fill_jacobian(state, h, &mut phi);
        assert_same(name, assembly.values(), &expected, tolerance);
        let mut phi = phi.clone();
        let work = move || assembly.fill_jacobian(black_box(state), h, &mut phi);
        ways.push((name, Box::new(work)));
    }
    ways.push(("as shipped", Box::new(move || shipped.fill(black_box(state), h, &mut phi))));
    compare(criterion, "assembly/jacobian", ways);
}

/// Φ, Φ_qᵀλ and the matrix of static equilibrium.
fn kkt(criterion: &mut Criterion, scene: &Scene) {
    let Scene { expansion, numbering, kkt, state, h, lambda, .. } = scene;
    let mut phi = vec![0.0; expansion.equation_count()];
    let mut shipped = Kkt::new(scene.terms.clone(), numbering);
    shipped.fill(state, h, lambda, &mut phi);
    let expected = shipped.values().to_vec();

    let mut ways: Vec<Way<'_>> = vec![];
    for (name, _, method, tolerance) in METHODS {
        let mut assembly = Assembly::kkt(expansion, numbering, kkt, method);
        assembly.fill_kkt(state, h, lambda, &mut phi);
        assert_same(name, assembly.values(), &expected, tolerance);
        assert_same(name, &assembly.force, shipped.force(), DUALS);
        let mut phi = phi.clone();
        let work = move || assembly.fill_kkt(black_box(state), h, lambda, &mut phi);
        ways.push((name, Box::new(work)));
    }

    let name = "differences of the assembled matrix";
    let mut assembly = Assembly::kkt(expansion, numbering, kkt, METHODS[0].2);
    let mut moved = state.clone();
    let mut moved_phi = phi.clone();
    assembly.fill_kkt_by_assembled_differences(&mut moved, h, lambda, &mut moved_phi);
    assert_same(name, assembly.values(), &expected, DIFFERENCES);
    let work = move || {
        let state = black_box(&mut moved);
        assembly.fill_kkt_by_assembled_differences(state, h, lambda, &mut moved_phi);
    };
    ways.push((name, Box::new(work)));
    let work = move || shipped.fill(black_box(state), h, lambda, &mut phi);
    ways.push(("as shipped", Box::new(work)));
    compare(criterion, "assembly/kkt", ways);
}

fn main() {
    let scene = Scene::sedan();
    let mut criterion = criterion();
    jacobian(&mut criterion, &scene);
    kkt(&mut criterion, &scene);
    criterion.final_summary();
}
