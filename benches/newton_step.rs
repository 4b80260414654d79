//! One Newton step of static equilibrium (paper, eq. 5–7): filling the matrix,
//! factorising and solving; and the linear algebra alone.

mod common;

use std::hint::black_box;

use common::assembly::{Assembly, Method};
use common::assert_same;
use common::measure::{Way, compare, criterion};
use common::methods::{DIFFERENCES, DUALS, Differences, Symbolic, duals, gradient};
use common::scene::Scene;
use criterion::Criterion;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::{Conj, Mat, MatMut, Par};
use hardpoint::assembly::Pattern;
use hardpoint::solve::linear::{LinearSolver, solver, sparse_lu};

/// Everything that a Newton step needs.
struct Step {
    assembly: Assembly,
    linear: Box<dyn LinearSolver>,
    phi: Vec<f64>,
    step: Vec<f64>,
}

impl Step {
    fn new(scene: &Scene, method: Method) -> Self {
        let Scene { expansion, numbering, kkt, .. } = scene;
        Self {
            assembly: Assembly::kkt(expansion, numbering, kkt, method),
            linear: solver(kkt),
            phi: vec![0.0; expansion.equation_count()],
            step: vec![0.0; kkt.rows()],
        }
    }

    fn fill(&mut self, scene: &Scene) {
        self.assembly.fill_kkt(&scene.state, &scene.h, &scene.lambda, &mut self.phi);
    }

    /// [(Φ_qᵀλ)_q, Φ_qᵀ; Φ_q, 0] · [Δq; Δλ] = −[Φ_qᵀλ; Φ]
    fn solve(&mut self) {
        let right_side = self.assembly.force.iter().chain(&self.phi);
        for (to, from) in self.step.iter_mut().zip(right_side) {
            *to = -from;
        }
        let values = self.assembly.values();
        self.linear.factorise(values).expect("the matrix is regular");
        self.linear.solve(&mut self.step).expect("the matrix is regular");
    }
}

fn newton_step(criterion: &mut Criterion, scene: &Scene) {
    let methods: [(&str, Method, f64); 4] = [
        ("symbolic", |kind| Box::new(Symbolic::new(kind)), DUALS),
        ("curvature by differences", |kind| Box::new(Differences::new(kind)), DIFFERENCES),
        ("curvature by duals, one direction", duals::for_curvature, DUALS),
        ("curvature by duals, all at once", gradient::for_curvature, DUALS),
    ];
    let mut expected = Step::new(scene, methods[0].1);
    expected.fill(scene);
    expected.solve();

    let mut ways: Vec<Way<'_>> = vec![];
    for (name, method, tolerance) in methods {
        let mut step = Step::new(scene, method);
        step.fill(scene);
        step.solve();
        // Rounding of the matrix is magnified by its condition.
        assert_same(name, &step.step, &expected.step, 100.0 * tolerance);
        let work = move || {
            step.fill(black_box(scene));
            step.solve();
            black_box(&step.step);
        };
        ways.push((name, Box::new(work)));
    }
    // The part that no way of finding curvature can save.
    let work = move || {
        expected.solve();
        black_box(&expected.step);
    };
    ways.push(("factorise and solve alone", Box::new(work)));
    compare(criterion, "newton_step", ways);
}

/// The dense LU factorisation of faer in memory that is set aside once.
struct DenseLu {
    entries: Vec<(usize, usize, usize)>,
    matrix: Mat<f64>,
    permutation: [Vec<usize>; 2],
    memory: MemBuffer,
}

impl DenseLu {
    fn new(pattern: &Pattern) -> Self {
        let n = pattern.rows();
        let factorise =
            factor::lu_in_place_scratch::<usize, f64>(n, n, Par::Seq, Default::default());
        let substitute = solve::solve_in_place_scratch::<usize, f64>(n, 1, Par::Seq);
        Self {
            entries: pattern.entries().collect(),
            matrix: Mat::zeros(n, n),
            permutation: [vec![0; n], vec![0; n]],
            memory: MemBuffer::new(factorise.or(substitute)),
        }
    }

    fn solve(&mut self, values: &[f64], right_side: &mut [f64]) {
        self.matrix.fill(0.0);
        for &(row, column, slot) in &self.entries {
            self.matrix[(row, column)] = values[slot];
        }
        let [forward, inverse] = &mut self.permutation;
        let stack = MemStack::new(&mut self.memory);
        let matrix = self.matrix.as_mut();
        let (_, rows) =
            factor::lu_in_place(matrix, forward, inverse, Par::Seq, stack, Default::default());
        let n = right_side.len();
        let right_side = MatMut::from_column_major_slice_mut(right_side, n, 1);
        let factors = self.matrix.as_ref();
        let stack = MemStack::new(&mut self.memory);
        solve::solve_in_place_with_conj(
            factors,
            factors,
            rows,
            Conj::No,
            right_side,
            Par::Seq,
            stack,
        );
    }
}

/// Factorising and solving: the plan, faer's sparse LU and its dense LU.
fn linear(criterion: &mut Criterion, name: &str, pattern: &Pattern, values: &[f64]) {
    let right_side: Vec<f64> = (0..pattern.rows()).map(|k| (k as f64).cos()).collect();
    let mut expected = right_side.clone();
    let mut sparse = sparse_lu(pattern);
    sparse.factorise(values).expect("the matrix is regular");
    sparse.solve(&mut expected).expect("the matrix is regular");
    let mut dense = DenseLu::new(pattern);
    let mut found = right_side.clone();
    dense.solve(values, &mut found);
    assert_same(name, &found, &expected, 1e-10);
    let mut plan = solver(pattern);
    found.copy_from_slice(&right_side);
    plan.factorise(values).expect("the matrix is regular");
    plan.solve(&mut found).expect("the matrix is regular");
    assert_same(name, &found, &expected, 1e-10);

    let mut x = right_side.clone();
    let mut y = right_side.clone();
    let b = &right_side;
    let plan_work = move || {
        y.copy_from_slice(b);
        plan.factorise(black_box(values)).expect("the matrix is regular");
        plan.solve(&mut y).expect("the matrix is regular");
        black_box(&y);
    };
    let sparse_work = move || {
        x.copy_from_slice(b);
        sparse.factorise(black_box(values)).expect("the matrix is regular");
        sparse.solve(&mut x).expect("the matrix is regular");
        black_box(&x);
    };
    let dense_work = move || {
        found.copy_from_slice(b);
        dense.solve(black_box(values), &mut found);
        black_box(&found);
    };
    let ways: Vec<Way<'_>> = vec![
        ("elimination plan", Box::new(plan_work)),
        ("sparse LU", Box::new(sparse_work)),
        ("dense LU", Box::new(dense_work)),
    ];
    compare(criterion, &format!("newton_step/{name}"), ways);
}

fn main() {
    let scene = Scene::sedan();
    let method: Method = |kind| Box::new(Symbolic::new(kind));
    let mut step = Step::new(&scene, method);
    step.fill(&scene);
    let Scene { expansion, numbering, phi_q, .. } = &scene;
    let mut jacobian = Assembly::jacobian(expansion, numbering, phi_q, method);
    jacobian.fill_jacobian(&scene.state, &scene.h, &mut step.phi);
    let mut criterion = criterion();
    newton_step(&mut criterion, &scene);
    linear(&mut criterion, "lu of kkt", &scene.kkt, step.assembly.values());
    linear(&mut criterion, "lu of phi_q", phi_q, jacobian.values());
    criterion.final_summary();
}
