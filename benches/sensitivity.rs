//! Derivatives of factors by all parameters of a model at one state: directly, by adjoints, and by central
//! differences of models made anew, these by the coordinates of one point only.

mod common;

use std::hint::black_box;

use common::assert_same;
use common::measure::{Way, compare, criterion};
use hardpoint::design::{self, Parameter, sensitivities};
use hardpoint::factors::{Convention, FACTORS, Factor, Need, find};
use hardpoint::model::{Model, Setup};
use hardpoint::rig::{Axle, Corner, Hold, Target, Variable};

/// The point whose coordinates differences are found by.
const POINT: &str = "lca_outer";

/// Step (m) of differences.
const STEP: f64 = 1e-5;

/// Besides one factor and all.
const FIFTEEN: [&str; 15] = [
    "toe",
    "camber",
    "wheel_center_x",
    "wheel_center_y",
    "rc_height",
    "anti_dive",
    "motion_ratio",
    "bump_steer",
    "bump_camber",
    "caster",
    "kpi",
    "mechanical_trail",
    "scrub_radius",
    "vk_caster",
    "vk_kpi",
];

fn model(name: &str) -> Model {
    let path = format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    Model::load(path).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

/// A model at a state.
struct Scene<B> {
    model: Model,
    parameters: Vec<Parameter>,
    target: Target,
    build: B,
}

impl<V: Variable, B: Fn(&Model) -> V> Scene<B> {
    fn there(&self, model: &Model, compliance: bool) -> V {
        let mut specimen = (self.build)(model);
        specimen.measure_compliance(compliance);
        specimen.go_to(&self.target).expect("the state is within reach");
        specimen
    }

    fn find(&self, specimen: &mut V, factors: &[&'static Factor], way: design::Way) -> Vec<f64> {
        let (model, parameters) = (&self.model, &self.parameters);
        let found = sensitivities(specimen, model, factors, Convention::Iso, parameters, way);
        let found = found.expect("the state has derivatives");
        found.rows.iter().flat_map(|row| row.by.iter().map(|by| by.unwrap_or(0.0))).collect()
    }

    /// Central differences by the coordinates of one point.
    fn differences(&self, factors: &[&'static Factor], compliance: bool) -> Vec<f64> {
        let values = |axis: usize, by: f64| -> Vec<f64> {
            let mut model = self.model.clone();
            let mut place = model.point(POINT).expect("the point is there");
            place[axis] += by;
            model.set_point(POINT, place);
            let poses = self.there(&model, compliance).poses();
            let of = |factor: &&'static Factor| {
                let value = |pose| factor.value(Convention::Iso, pose).unwrap_or(0.0);
                poses.iter().map(value).collect::<Vec<f64>>()
            };
            factors.iter().flat_map(of).collect()
        };
        let by = |axis: usize| {
            let (more, less) = (values(axis, STEP), values(axis, -STEP));
            more.into_iter().zip(less).map(|(a, b)| (a - b) / (2.0 * STEP)).collect::<Vec<f64>>()
        };
        (0..3).flat_map(by).collect()
    }

    fn compare(&self, name: &str, criterion: &mut criterion::Criterion) {
        let mut specimen = self.there(&self.model, true);
        let poses = specimen.poses();
        let has = |factor: &&Factor| {
            poses.iter().any(|pose| factor.value(Convention::Iso, pose).is_some())
        };
        let all: Vec<&'static Factor> = FACTORS.iter().filter(has).collect();
        let named = |names: &[&str]| -> Vec<&'static Factor> {
            names.iter().map(|name| find(name).expect("the factor exists")).collect()
        };
        let sets = [named(&FIFTEEN[..1]), named(&FIFTEEN), all];
        for factors in &sets {
            let compliance = factors.iter().any(|factor| factor.needs.contains(&Need::Compliance));
            let mut second = self.there(&self.model, compliance);
            let one_way = self.find(&mut specimen, factors, design::Way::Direct);
            let other_way = self.find(&mut second, factors, design::Way::Adjoint);
            assert_same(name, &one_way, &other_way, 1e-9);
            let specimen = &mut specimen;
            let direct = move || {
                black_box(self.find(specimen, factors, design::Way::Direct));
            };
            let adjoint = move || {
                black_box(self.find(&mut second, factors, design::Way::Adjoint));
            };
            let differences = move || {
                black_box(self.differences(factors, compliance));
            };
            let (factors, parameters) = (factors.len(), self.parameters.len());
            let group = format!("{name}, {factors} factors by {parameters} parameters");
            let ways: Vec<Way<'_>> = vec![
                ("direct", Box::new(direct)),
                ("adjoint", Box::new(adjoint)),
                ("differences, three parameters alone", Box::new(differences)),
            ];
            compare(criterion, &group, ways);
        }
    }
}

fn main() {
    let mut criterion = criterion();
    let wheels = [Hold::Value(0.02), Hold::Value(-0.01)];
    let target = Target { wheels, rack: 0.005, ..Target::default() };
    let setup = Setup::default();
    let sedan = model("double-wishbone");
    Scene {
        parameters: Parameter::all(&sedan, false, false),
        model: sedan,
        target,
        build: |model: &Model| Corner::new(model, &setup).expect("it stands"),
    }
    .compare("double wishbone", &mut criterion);
    let axle = model("sedan-axle");
    Scene {
        parameters: Parameter::all(&axle, true, false),
        model: axle,
        target,
        build: |model: &Model| Axle::new(model, &setup).expect("it stands"),
    }
    .compare("sedan axle", &mut criterion);
    criterion.final_summary();
}
