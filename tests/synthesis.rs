//! Hard points that give wanted factors.

use std::fmt::Write as _;

use hardpoint::design::request::Request;
use hardpoint::design::synthesis::{Synthesis, Verdict, synthesize};
use hardpoint::factors::{Convention, find};
use hardpoint::model::{Model, Setup};
use hardpoint::rig::Corner;

fn model(name: &str) -> Model {
    Model::load(format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn seek(model: &Model, request: &str) -> Synthesis {
    let request = Request::parse("targets.toml", request, model)
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render()));
    synthesize(&request, model, &Setup::default()).unwrap()
}

const CURVES: [&str; 5] = ["toe", "camber", "caster", "wheel_center_x", "wheel_center_y"];

/// The curves of a model over its travel, as targets.
fn curves(model: &Model) -> String {
    let mut corner = Corner::new(model, &Setup::default()).unwrap();
    let mut text = "format = 1\n".to_owned();
    for name in CURVES {
        let factor = find(name).unwrap();
        let mut rows = vec![];
        for k in -5..=5 {
            let travel = 0.01 * f64::from(k);
            corner.move_to(travel, 0.0).unwrap();
            let value = factor.show_by(Convention::Iso, model.units, &corner.pose()).unwrap();
            rows.push(format!("[{}, {value:e}]", 10.0 * f64::from(k)));
        }
        let rows = rows.join(", ");
        writeln!(text, "[[targets]]\nfactor = \"{name}\"\nover = \"travel\"\ncurve = [{rows}]")
            .unwrap();
    }
    text
}

/// From a hundred random perturbations by up to 10 mm of five points the factors of the original are found again
/// to 1e-6.
#[test]
fn perturbed_suspensions_are_recovered() {
    let original = model("double-wishbone");
    let points = ["lca_front", "lca_rear", "uca_front", "uca_rear", "tierod_inner"];
    let targets = curves(&original);
    let mut random = fastrand::Rng::with_seed(6);
    let mut recovered = 0;
    let mut evaluations = 0;
    let began = std::time::Instant::now();
    for _ in 0..100 {
        let mut perturbed = original.clone();
        let mut request = targets.clone();
        for name in points {
            let from = original.point(name).unwrap();
            let to = from.map(|x| x + 0.01 * (2.0 * random.f64() - 1.0));
            assert!(perturbed.set_point(name, to));
            let bounds = from.map(|x| format!("[{}, {}]", 1e3 * x - 15.0, 1e3 * x + 15.0));
            let [x, y, z] = bounds;
            writeln!(request, "[[variables]]\npoint = \"{name}\"").unwrap();
            writeln!(request, "bounds = {{ x = {x}, y = {y}, z = {z} }}").unwrap();
        }
        let found = seek(&perturbed, &request);
        evaluations += found.evaluations;
        let wanted = seek_values(&original, &request);
        let worst = worst(&found, &wanted);
        println!(
            "{worst:.1e} {:?} starts {} iterations {} evaluations {}",
            found.verdict, found.starts, found.iterations, found.evaluations
        );
        recovered += usize::from(worst < 1e-6);
    }
    println!("{recovered} of 100, {evaluations} evaluations, {:?}", began.elapsed());
    assert!(recovered >= 95, "{recovered} of 100");
}

/// The wanted values (SI) of a request.
fn seek_values(model: &Model, request: &str) -> Vec<Vec<f64>> {
    use hardpoint::design::request::Goal;
    let request = Request::parse("targets.toml", request, model).unwrap();
    let values = |goal: &Goal| match goal {
        Goal::Values(values) => values.clone(),
        _ => vec![],
    };
    request.targets.iter().map(|target| values(&target.goal)).collect()
}

/// The largest difference, relative to the largest value of its curve.
fn worst(found: &Synthesis, wanted: &[Vec<f64>]) -> f64 {
    let mut worst: f64 = 0.0;
    for (after, wanted) in found.after.iter().zip(wanted) {
        let size = wanted.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        for (after, wanted) in after.iter().zip(wanted) {
            worst = worst.max((after.unwrap() - wanted).abs() / size);
        }
    }
    worst
}

#[test]
fn a_verdict_is_met_where_targets_are() {
    let request = "format = 1\n[[targets]]\nfactor = \"bump_steer\"\nvalue = 0.0\n\
        [[variables]]\npoints = [\"tierod_inner\", \"tierod_outer\"]\n\
        coordinates = [\"z\"]\nrange = 40.0\n";
    let found = seek(&model("double-wishbone"), request);
    assert_eq!(found.verdict, Verdict::Met, "{:?} {:?}", found.before, found.after);
    assert!(found.after[0][0].unwrap().abs() < 1e-9);
}
