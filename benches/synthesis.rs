//! Hard points from factors: five points, 15 coordinates, curves of five factors over 11 travels.
//!
//! The same program is solved with derivatives by central differences of corners that are built anew, as whoever
//! has no derivatives does it.

mod common;

use std::fmt::Write as _;
use std::hint::black_box;

use common::measure::{Way, compare, criterion};
use hardpoint::design::request::{self, Goal, Request};
use hardpoint::design::sqp::{self, Evaluation, Failure, Settings, Statement, Status, solve};
use hardpoint::design::synthesis::{Verdict, synthesize};
use hardpoint::factors::{Convention, find};
use hardpoint::model::{Model, Setup};
use hardpoint::rig::Corner;

const POINTS: [&str; 5] = ["lca_front", "lca_rear", "uca_front", "uca_rear", "tierod_inner"];
const CURVES: [&str; 5] = ["toe", "camber", "caster", "wheel_center_x", "wheel_center_y"];

/// A perturbed model, and the request to find the original again.
fn problem() -> (Model, Request) {
    let path = format!("{}/models/double-wishbone.toml", env!("CARGO_MANIFEST_DIR"));
    let original = Model::load(path).expect("the model is shipped");
    let mut corner = Corner::new(&original, &Setup::default()).expect("it can be built");
    let mut text = "format = 1\n".to_owned();
    for name in CURVES {
        let factor = find(name).expect("the factor is known");
        let mut rows = vec![];
        for k in -5..=5 {
            corner.move_to(0.01 * f64::from(k), 0.0).expect("the travel is reached");
            let value = factor.show_by(Convention::Iso, original.units, &corner.pose());
            rows.push(format!("[{}, {:e}]", 10 * k, value.expect("it is defined")));
        }
        let rows = rows.join(", ");
        let _ =
            writeln!(text, "[[targets]]\nfactor = \"{name}\"\nover = \"travel\"\ncurve = [{rows}]");
    }
    let mut perturbed = original;
    let mut random = fastrand::Rng::with_seed(6);
    for name in POINTS {
        let from = perturbed.point(name).expect("the point is there");
        perturbed.set_point(name, from.map(|x| x + 0.01 * (2.0 * random.f64() - 1.0)));
        let _ = writeln!(text, "[[variables]]\npoint = \"{name}\"\nrange = 25.0");
    }
    let request = Request::parse("targets.toml", &text, &perturbed).expect("it is well-formed");
    (perturbed, request)
}

/// The same with central differences.
struct Differences<'a> {
    model: &'a Model,
    request: &'a Request,
}

impl Differences<'_> {
    fn residuals(&self, x: &[f64]) -> Result<Vec<f64>, Failure> {
        let mut model = self.model.clone();
        for (name, position) in POINTS.iter().zip(x.as_chunks::<3>().0) {
            model.set_point(name, *position);
        }
        let fail = |words: String| Failure(words);
        let mut corner =
            Corner::new(&model, &Setup::default()).map_err(|error| fail(error.to_string()))?;
        let mut values = vec![vec![0.0; 11]; CURVES.len()];
        for k in 0..11_u8 {
            let travel = 0.01 * (f64::from(k) - 5.0);
            corner.move_to(travel, 0.0).map_err(|stop| fail(stop.to_string()))?;
            let pose = corner.pose();
            for (values, target) in values.iter_mut().zip(&self.request.targets) {
                let value = target.factor.value(Convention::Iso, &pose);
                values[usize::from(k)] = value.ok_or_else(|| fail("undefined".to_owned()))?;
            }
        }
        let targets = self.request.targets.iter().zip(values);
        let off = targets.flat_map(|(target, values)| {
            let Goal::Values(wanted) = &target.goal else { return vec![] };
            values.iter().zip(wanted).map(|(value, wanted)| value - wanted).collect()
        });
        Ok(off.collect())
    }
}

impl sqp::Problem for Differences<'_> {
    fn evaluate(&mut self, x: &[f64], out: &mut Evaluation) -> Result<(), Failure> {
        let step = 1e-6;
        let residuals = self.residuals(x)?;
        for k in 0..x.len() {
            let at = |by: f64| {
                let mut x = x.to_vec();
                x[k] += by;
                self.residuals(&x)
            };
            let (more, less) = (at(step)?, at(-step)?);
            for (row, (more, less)) in more.iter().zip(less).enumerate() {
                out.residual_jacobian[row * x.len() + k] = (more - less) / (2.0 * step);
            }
        }
        out.residuals.copy_from_slice(&residuals);
        Ok(())
    }
}

/// Both ways to the same design.
fn ways<'a>(model: &'a Model, request: &'a Request) -> Vec<Way<'a>> {
    let setup = Setup::default();
    let found = synthesize(request, model, &setup).expect("the model is fine");
    assert_eq!((found.verdict, found.starts), (Verdict::Met, 1));
    println!("exact derivatives: {} evaluations", found.evaluations);
    let weight = |target: &request::Target| 1.0 / target.tolerance;
    let variable = |variable: &request::Variable| {
        let [lower, upper] = variable.bounds;
        sqp::Variable { lower, upper, typical: 0.25 * (upper - lower) }
    };
    let statement = Statement {
        variables: request.variables.iter().map(variable).collect(),
        weights: request.targets.iter().flat_map(|target| vec![weight(target); 11]).collect(),
        constraints: vec![],
    };
    let start: Vec<f64> = request.variables.iter().map(|variable| variable.start).collect();
    let mut differences = Differences { model, request };
    let settings = Settings::default();
    let outcome = solve(&mut differences, &statement, &start, &settings).expect("it makes sense");
    assert!(matches!(outcome.status, Status::Converged(_)));
    println!("differences: {} evaluations", outcome.evaluations);
    vec![
        (
            "exact derivatives",
            Box::new(move || {
                black_box(synthesize(request, model, &setup).is_ok());
            }),
        ),
        (
            "differences of corners that are built anew",
            Box::new(move || {
                black_box(solve(&mut differences, &statement, &start, &settings).is_ok());
            }),
        ),
    ]
}

fn main() {
    let mut criterion = criterion();
    let (model, request) = problem();
    compare(&mut criterion, "five points from five curves", ways(&model, &request));
    criterion.final_summary();
}
