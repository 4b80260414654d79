//! The sweep of the paper, −130 … 130 mm of travel in 10 mm steps, with the
//! Jacobian found in different ways.
//!
//! The library always uses its own kernels, so all ways run through one
//! continuation here that takes the steps of the library: a tangent predictor
//! and Newton's method to the same tolerances. The library itself runs beside it.

mod common;

use std::hint::black_box;

use common::assembly::{Assembly, Method};
use common::assert_same;
use common::measure::{Way, compare, criterion};
use common::methods::{DUALS, Differences, Symbolic, duals, gradient};
use common::scene::Scene;
use hardpoint::assembly::{Terms, design_state};
use hardpoint::relation::{BODY_COORDINATES, Coordinates};
use hardpoint::solve::linear::{LinearSolver, solver};
use hardpoint::solve::newton::{Equations, newton};
use hardpoint::solve::{System, Tolerances};

/// Travel of the wheel (m).
fn travels() -> impl Iterator<Item = f64> {
    (-13..=13).map(|step| f64::from(step) * 0.01)
}

/// Φ(q; h) = 0 with the Jacobian of one method.
struct Position {
    assembly: Assembly,
    terms: Terms,
    state: Vec<Coordinates<f64>>,
    start: Vec<Coordinates<f64>>,
    h: Vec<f64>,
    phi: Vec<f64>,
    length: f64,
}

impl Equations for Position {
    fn residual(&mut self) -> f64 {
        self.terms.residual(&self.state, &self.h, &mut self.phi);
        self.phi.iter().fold(0.0, |largest: f64, phi| largest.max(phi.abs()))
    }

    fn linearise(&mut self) -> f64 {
        self.assembly.fill_jacobian(&self.state, &self.h, &mut self.phi);
        self.phi.iter().fold(0.0, |largest: f64, phi| largest.max(phi.abs()))
    }

    fn matrix(&self) -> &[f64] {
        self.assembly.values()
    }

    fn right_side(&self, right_side: &mut [f64]) {
        for (to, phi) in right_side.iter_mut().zip(&self.phi) {
            *to = -phi;
        }
    }

    fn begin_step(&mut self) {
        self.start.copy_from_slice(&self.state);
    }

    fn take_step(&mut self, step: &[f64], fraction: f64) {
        let changes = step.chunks_exact(BODY_COORDINATES);
        let bodies = self.state.iter_mut().zip(&self.start).skip(1);
        for ((to, from), change) in bodies.zip(changes) {
            for (k, change) in change.iter().enumerate() {
                to[k] = from[k] + fraction * change;
            }
            let length = to[3..].iter().map(|e| e * e).sum::<f64>().sqrt();
            to[3..].iter_mut().for_each(|e| *e /= length);
        }
    }

    fn step_size(&self, step: &[f64]) -> f64 {
        step.iter().enumerate().fold(0.0, |largest: f64, (unknown, change)| {
            let scale = if unknown % BODY_COORDINATES < 3 { self.length } else { 1.0 };
            largest.max(change.abs() / scale)
        })
    }
}

/// The continuation.
struct Sweep {
    position: Position,
    linear: Box<dyn LinearSolver>,
    design: Vec<Coordinates<f64>>,
    slot: usize,
    height: f64,
    dh: Vec<f64>,
    step: Vec<f64>,
    /// Newton iterations of the last run.
    iterations: usize,
}

/// As in the library's continuation.
const CORRECTOR: Tolerances =
    Tolerances { step: 1e-9, residual: 1e-12, iterations: 8, contraction: 0.1 };

impl Sweep {
    fn new(scene: &Scene, method: Method) -> Self {
        let Scene { expansion, numbering, phi_q, mechanism, .. } = scene;
        let design = design_state(mechanism.bodies());
        let h: Vec<f64> = expansion.parameters(&mechanism.positions());
        let slot = expansion.driver_slot(scene.travel);
        Self {
            linear: solver(phi_q),
            slot,
            height: h[slot],
            dh: vec![0.0; h.len()],
            step: vec![0.0; phi_q.rows()],
            iterations: 0,
            position: Position {
                assembly: Assembly::jacobian(expansion, numbering, phi_q, method),
                terms: scene.terms.clone(),
                state: design.clone(),
                start: design.clone(),
                h,
                phi: vec![0.0; expansion.equation_count()],
                length: 0.5,
            },
            design,
        }
    }

    fn run(&mut self, mut arrived: impl FnMut(&[Coordinates<f64>])) {
        let position = &mut self.position;
        position.state.copy_from_slice(&self.design);
        position.h[self.slot] = self.height;
        self.iterations = 0;
        position.linearise();
        self.linear.factorise(position.matrix()).expect("the design position is regular");
        for travel in travels() {
            // The last factorisation serves the tangent: Φ_q Δq = −Φ_h Δh.
            self.dh[self.slot] = self.height + travel - position.h[self.slot];
            let Position { terms, state, h, phi, .. } = position;
            terms.design_product(state, h, &self.dh, phi);
            position.right_side(&mut self.step);
            self.linear.solve(&mut self.step).expect("the last matrix was regular");
            position.begin_step();
            position.take_step(&self.step, 1.0);
            position.h[self.slot] = self.height + travel;
            let outcome = newton(position, self.linear.as_mut(), &CORRECTOR, &mut self.step);
            assert!(outcome.converged(), "{travel} m: {outcome:?}");
            self.iterations += outcome.iterations;
            arrived(&position.state);
        }
    }
}

/// One run of the library: its iterations, its steps, and the state at each point.
fn shipped(
    system: &mut System,
    scene: &Scene,
    mut arrived: impl FnMut(&[Coordinates<f64>]),
) -> [usize; 2] {
    let mut effort = [0, 0];
    system.reset();
    for travel in travels() {
        let report = system.move_to(&[(scene.travel, travel)]).expect("within the travel");
        effort[0] += report.iterations;
        effort[1] += report.steps;
        arrived(system.state());
    }
    effort
}

fn main() {
    let scene = Scene::sedan();
    let mut system = System::new(scene.mechanism.clone()).expect("the sedan moves");
    let mut expected = vec![];
    let [iterations, steps] =
        shipped(&mut system, &scene, |state| expected.extend_from_slice(state.as_flattened()));
    let methods: [(&str, Method); 4] = [
        ("symbolic", |kind| Box::new(Symbolic::new(kind))),
        ("differences, block by block", |kind| Box::new(Differences::new(kind))),
        ("duals, one direction at a time", duals::for_jacobian),
        ("duals, all directions at once", gradient::for_jacobian),
    ];
    println!("as shipped: {iterations} Newton iterations in {steps} steps");
    let mut ways: Vec<Way<'_>> = vec![];
    for (name, method) in methods {
        let mut sweep = Sweep::new(&scene, method);
        let mut found = vec![];
        sweep.run(|state| found.extend_from_slice(state.as_flattened()));
        // All ways end at the same solution, whatever their Jacobian.
        assert_same(name, &found, &expected, DUALS);
        println!("{name}: {} Newton iterations in 27 steps", sweep.iterations);
        let work = move || {
            sweep.run(|state| {
                black_box(state);
            });
        };
        ways.push((name, Box::new(work)));
    }
    let scene = &scene;
    let work = move || {
        shipped(&mut system, scene, |state| {
            black_box(state);
        });
    };
    ways.push(("as shipped", Box::new(work)));
    let mut criterion = criterion();
    compare(&mut criterion, "sweep", ways);
    criterion.final_summary();
}
