//! The sparse matrices against central differences of what they are derivatives of.

mod common;

use common::{TieRod, double_wishbone};
use hardpoint::assembly::{Jacobian, Kkt, Numbering, Pattern, Terms, design_state};
use hardpoint::mechanism::{BodyId, Direction, DriverKind, Expansion, JointKind, Mechanism};
use hardpoint::relation::Coordinates;

/// A mechanism with every kind of joint and driver; it need not be able to move.
fn one_of_each() -> Mechanism {
    let mut m = Mechanism::new("ground");
    let a = m.add_point("a", [0.1, -0.2, 0.3]).unwrap();
    let b = m.add_point("b", [0.7, 0.4, -0.1]).unwrap();
    let first = m.add_body("first", [0.3, 0.0, 0.1]).unwrap();
    let second = m.add_body("second", [0.5, 0.3, 0.2]).unwrap();
    let third = m.add_body("third", [0.2, 0.1, -0.4]).unwrap();
    let axis = Direction::Between(a, b);
    let fixed = Direction::Fixed([1.0, 2.0, -1.0]);
    let across = Direction::Fixed([1.0, 0.0, 1.0]);
    for (name, kind) in [
        ("spherical", JointKind::Spherical { at: a }),
        ("revolute", JointKind::Revolute { at: b, axis }),
        ("universal", JointKind::Universal { at: a, shaft: fixed }),
        ("translational", JointKind::Translational { at: b, axis: fixed }),
        ("cylindrical", JointKind::Cylindrical { at: a, axis }),
        ("fixed", JointKind::Fixed { at: b }),
        ("link", JointKind::Link { on_i: a, on_j: b }),
        ("in_plane", JointKind::InPlane { at: b, normal: axis }),
        ("in_line", JointKind::InLine { at: a, axis: fixed }),
        ("perpendicular", JointKind::Perpendicular { at: b, axis }),
        ("hooke", JointKind::Hooke { at: b, pin_i: fixed, pin_j: across }),
        ("square", JointKind::PerpendicularAxes { at: b, axis_i: across, axis_j: fixed }),
        ("parallel", JointKind::ParallelAxes { at: a, axis }),
        ("orientation", JointKind::Orientation { at: a }),
        ("rack", JointKind::RackAndPinion { at: a, axis, along: fixed, pitch_radius: -1.3 }),
        ("screw", JointKind::Screw { at: b, axis: fixed, lead: 7.0 }),
    ] {
        m.add_joint(name, first, second, kind).unwrap();
        m.add_joint(&format!("{name} to ground"), BodyId::GROUND, third, kind).unwrap();
    }
    let moving = [
        ("displacement", DriverKind::Displacement { at: a, along: axis }),
        ("rotation", DriverKind::Rotation { axis: fixed }),
        ("length", DriverKind::Length { on_i: a, on_j: b }),
    ];
    for (name, kind) in moving {
        m.add_driver(name, second, third, kind).unwrap();
    }
    let spin = Direction::Fixed([0.1, 1.0, 0.05]);
    let heights = [
        ("height", DriverKind::Height { at: b }),
        ("patch", DriverKind::PatchHeight { center: a, spin, radius: 0.3 }),
    ];
    for (name, kind) in heights {
        m.add_driver(name, BodyId::GROUND, first, kind).unwrap();
    }
    m
}

/// Numbers in −1 … 1 that are the same in every run.
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut generator = fastrand::Rng::with_seed(seed);
    move || 2.0 * generator.f64() - 1.0
}

/// A state near the design position, its Euler parameters not normalised.
fn disturbed(mechanism: &Mechanism, random: &mut impl FnMut() -> f64) -> Vec<Coordinates<f64>> {
    let mut state = design_state(mechanism.bodies());
    for q in state.iter_mut().skip(1) {
        q.iter_mut().for_each(|x| *x += 0.3 * random());
    }
    state
}

fn dense(pattern: &Pattern, values: &[f64]) -> Vec<Vec<f64>> {
    let mut dense = vec![vec![0.0; pattern.columns()]; pattern.rows()];
    for (row, column, slot) in pattern.entries() {
        dense[row][column] = values[slot];
    }
    dense
}

#[test]
fn equilibrium_matrix_is_the_derivative_of_its_residual() {
    for mechanism in
        [one_of_each(), double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap().mechanism]
    {
        let expansion = Expansion::new(&mechanism);
        let left_out = [4, 7];
        let numbering = Numbering::new(&expansion, &left_out);
        let mut kkt = Kkt::new(Terms::new(&expansion), &numbering);
        let mut random = random(7);
        let state = disturbed(&mechanism, &mut random);
        let mut h: Vec<f64> = expansion.parameters(&mechanism.positions());
        h.iter_mut().for_each(|h| *h += 0.05 * random());
        let mut lambda: Vec<f64> = (0..expansion.equation_count()).map(|_| random()).collect();
        left_out.iter().for_each(|&equation| lambda[equation] = 0.0);

        let mut phi = vec![0.0; expansion.equation_count()];
        kkt.fill(&state, &h, &lambda, &mut phi);
        let matrix = dense(kkt.pattern(), kkt.values());
        let force = kkt.force().to_vec();
        let n = numbering.unknowns();
        let mut residual = |x: &[f64]| {
            let mut state = state.clone();
            let mut lambda = lambda.clone();
            state.iter_mut().skip(1).flatten().zip(x).for_each(|(q, dx)| *q += dx);
            for (&equation, dx) in numbering.kept().iter().zip(&x[n..]) {
                lambda[equation] += dx;
            }
            let mut phi = vec![0.0; phi.len()];
            kkt.residual(&state, &h, &lambda, &mut phi);
            let kept = numbering.kept().iter().map(|&equation| phi[equation]);
            kkt.force().iter().copied().chain(kept).collect::<Vec<f64>>()
        };
        let here = residual(&vec![0.0; matrix.len()]);
        assert!(common::difference(&here[..n], &force) < 1e-13);
        for (column, _) in matrix.iter().enumerate() {
            let step = 1e-5;
            let mut x = vec![0.0; matrix.len()];
            x[column] = step;
            let plus = residual(&x);
            x[column] = -step;
            let minus = residual(&x);
            for (row, entries) in matrix.iter().enumerate() {
                let difference = (plus[row] - minus[row]) / (2.0 * step);
                assert!(
                    (entries[column] - difference).abs() < 1e-8,
                    "({row}, {column}): {} and {difference}",
                    entries[column]
                );
            }
        }
    }
}

#[test]
fn constraint_matrix_is_the_lower_left_block() {
    let mechanism = one_of_each();
    let expansion = Expansion::new(&mechanism);
    let numbering = Numbering::new(&expansion, &[10]);
    let terms = Terms::new(&expansion);
    let state = disturbed(&mechanism, &mut random(3));
    let h: Vec<f64> = expansion.parameters(&mechanism.positions());
    let mut phi = vec![0.0; expansion.equation_count()];
    let mut jacobian = Jacobian::new(terms.clone(), &numbering);
    jacobian.fill(&state, &h, &mut phi);
    let mut kkt = Kkt::new(terms, &numbering);
    let lambda = vec![0.0; phi.len()];
    kkt.fill(&state, &h, &lambda, &mut phi);
    let n = numbering.unknowns();
    let whole = dense(kkt.pattern(), kkt.values());
    for (row, entries) in dense(jacobian.pattern(), jacobian.values()).iter().enumerate() {
        for (column, value) in entries.iter().enumerate() {
            // Two programs compute it, so it is the same up to rounding.
            assert!((whole[n + row][column] - value).abs() < 1e-14);
            assert_eq!(whole[column][n + row], whole[n + row][column]);
        }
    }
    let diagonal = vec![2.5; n];
    kkt.fill_least_change(&state, &h, &diagonal, &mut phi);
    let least = dense(kkt.pattern(), kkt.values());
    for row in 0..n {
        for column in 0..n {
            assert_eq!(least[row][column], if row == column { 2.5 } else { 0.0 });
        }
    }
    for (least, whole) in least[n..].iter().zip(&whole[n..]) {
        assert!(common::difference(least, whole) < 1e-14);
    }
}

#[test]
fn the_design_position_satisfies_all_equations() {
    let mechanism = one_of_each();
    let expansion = Expansion::new(&mechanism);
    let h: Vec<f64> = expansion.parameters(&mechanism.positions());
    let mut phi = vec![1.0; expansion.equation_count()];
    let state = design_state(mechanism.bodies());
    Terms::new(&expansion).residual(&state, &h, &mut phi);
    for (equation, phi) in phi.iter().enumerate() {
        assert!(phi.abs() < 1e-15, "{}: {phi:e}", expansion.label(equation));
    }
}

#[test]
fn the_design_product_is_the_derivative_along_parameters() {
    let mechanism = one_of_each();
    let expansion = Expansion::new(&mechanism);
    let mut random = random(11);
    let state = disturbed(&mechanism, &mut random);
    let h: Vec<f64> = expansion.parameters(&mechanism.positions());
    let dh: Vec<f64> = h.iter().map(|_| random()).collect();
    let mut terms = Terms::new(&expansion);
    let mut product = vec![0.0; expansion.equation_count()];
    terms.design_product(&state, &h, &dh, &mut product);
    let at = |step: f64| {
        let h: Vec<f64> = h.iter().zip(&dh).map(|(h, dh)| h + step * dh).collect();
        let mut phi = vec![0.0; product.len()];
        terms.residual(&state, &h, &mut phi);
        phi
    };
    for (exact, (plus, minus)) in product.iter().zip(at(1e-5).iter().zip(at(-1e-5))) {
        let difference = (plus - minus) / 2e-5;
        assert!((exact - difference).abs() < 1e-8, "{exact} and {difference}");
    }
}
