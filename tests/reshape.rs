//! A specimen that takes other hard points is the one that is built from them.

use hardpoint::factors::{Convention, FACTORS};
use hardpoint::model::{Model, Setup};
use hardpoint::rig::{Axle, Corner, Pose, Shape, Target, Variable};

fn model(name: &str) -> Model {
    Model::load(format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR")))
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

/// The model with all points moved at random.
fn moved(model: &Model, random: &mut fastrand::Rng) -> Model {
    let mut moved = model.clone();
    for point in model.points() {
        let to = point.position.map(|x| x + 0.004 * (2.0 * random.f64() - 1.0));
        assert!(moved.set_point(&point.name, to));
    }
    moved
}

fn poses(specimen: &mut impl Variable, travel: f64, rack: f64) -> Vec<Pose<f64>> {
    let held = hardpoint::rig::Held { travel, rack, ..Default::default() };
    let target: Target = held.target();
    specimen.go_to(&target).unwrap_or_else(|stop| panic!("{stop}"));
    specimen.measure_compliance(true);
    specimen.poses()
}

/// All factors agree to 1e-7 of their size; that of numbers near zero is that of the model.
fn same(name: &str, found: &[Pose<f64>], expected: &[Pose<f64>]) -> usize {
    let mut compared = 0;
    for (found, expected) in found.iter().zip(expected) {
        for factor in FACTORS {
            let [found, expected] =
                [found, expected].map(|pose| factor.value(Convention::Iso, pose));
            let (Some(found), Some(expected)) = (found, expected) else {
                assert_eq!(found, expected, "{name} {}", factor.name);
                continue;
            };
            let size = expected.abs().max(1e-3);
            assert!(
                (found - expected).abs() < 1e-7 * size,
                "{name} {}: {found} for {expected}",
                factor.name
            );
            compared += 1;
        }
    }
    compared
}

fn check<V: Variable>(name: &str, steps: usize, build: impl Fn(&Model) -> V) {
    let original = model(name);
    let mut random = fastrand::Rng::with_seed(3);
    let mut specimen = build(&original);
    let rack = if original.steers() { 0.003 } else { 0.0 };
    for step in 0..steps {
        let other = moved(&original, &mut random);
        let shapes = specimen.both_sides(&other, Shape::of(&other));
        specimen.reshape(&shapes, &[], &[]).unwrap();
        let travel = [0.02, -0.03][step % 2];
        let found = poses(&mut specimen, travel, rack);
        let expected = poses(&mut build(&other), travel, rack);
        assert!(same(name, &found, &expected) > 60, "{name}");
    }
}

#[test]
fn corners_take_other_points() {
    for name in [
        "double-wishbone",
        "lotus-front",
        "macpherson",
        "five-link",
        "double-wishbone-pushrod",
        "compliant-corner",
        "bushed-double-wishbone",
    ] {
        check(name, 4, |model| Corner::new(model, &Setup::default()).unwrap());
    }
}

#[test]
fn axles_take_other_points() {
    for name in ["sedan-axle", "double-wishbone"] {
        check(name, 2, |model| Axle::new(model, &Setup::default()).unwrap());
    }
}
