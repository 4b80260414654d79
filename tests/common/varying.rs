//! Models on the rig with one of their numbers changed, and what that changes.
#![allow(dead_code)] // Every test uses its part.

use hardpoint::design::sensitivity::Sensitivity;
use hardpoint::design::{Parameter, Sensitivities, Way, sensitivities};
use hardpoint::factors::{Convention, FACTORS, Factor};
use hardpoint::model::{Model, Quantity, Setup};
use hardpoint::rig::{Axle, Corner, Hold, Load, LoadPoint, Target, Variable};
use toml::{Table, Value};

/// A model at a state.
pub struct Case {
    pub text: String,
    pub axle: bool,
    pub setup: Setup,
    pub target: Target,
    /// What the names of the parameters begin with.
    pub names: Vec<&'static str>,
}

impl Case {
    /// A model of `models/` at its design position.
    pub fn new(name: &str) -> Self {
        let path = format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).unwrap();
        let axle = false;
        let (setup, target, names) = (Setup::default(), Target::default(), vec![""]);
        Self { text, axle, setup, target, names }
    }

    /// Both sides of it.
    pub fn axle(name: &str) -> Self {
        Self { axle: true, ..Self::new(name) }
    }

    /// With other words in its file.
    pub fn with(mut self, from: &str, to: &str) -> Self {
        assert!(self.text.contains(from), "`{from}` is not in the model");
        self.text = self.text.replacen(from, to, 1);
        self
    }

    /// With more words at the end of its file.
    pub fn and(mut self, more: &str) -> Self {
        self.text = format!("{}\n{more}\n", self.text);
        self
    }

    /// Its wheels at travels and its rack at a displacement (mm).
    pub fn at(mut self, left: f64, right: f64, rack: f64) -> Self {
        self.target.wheels = [left, right].map(|travel| Hold::Value(1e-3 * travel));
        self.target.rack = 1e-3 * rack;
        self
    }

    /// With loads on its wheels (N and N·m).
    pub fn loaded(mut self, left: [f64; 6], right: [f64; 6]) -> Self {
        self.target.load = [left, right].map(|components| Load { components });
        self
    }

    /// By the parameters whose names begin like this.
    pub fn by(mut self, names: &[&'static str]) -> Self {
        self.names = names.to_vec();
        self
    }

    pub fn with_target(mut self, change: impl FnOnce(&mut Target)) -> Self {
        change(&mut self.target);
        self
    }

    pub fn with_setup(mut self, change: impl FnOnce(&mut Setup)) -> Self {
        change(&mut self.setup);
        self
    }

    pub fn model(&self) -> Model {
        parse(&self.text)
    }

    pub fn parameters(&self) -> Vec<Parameter> {
        let all = Parameter::all(&self.model(), self.axle, self.setup.kinematic).into_iter();
        all.filter(|p| self.names.iter().any(|name| p.name.starts_with(name))).collect()
    }

    /// The words of a name, if the file has a number that the name means.
    fn in_file<'n>(&self, name: &'n str) -> Option<Vec<&'n str>> {
        let path: Vec<&str> = name.split('.').collect();
        (!["hub_bearing", "steering_gear"].contains(&path[0])).then_some(path)
    }

    /// The model with a parameter larger by so much (SI), made anew.
    fn moved(&self, parameter: &Parameter, by: f64) -> Model {
        let mut model = self.model();
        let path: Vec<&str> = parameter.name.split('.').collect();
        if parameter.coordinate(&model).is_some() {
            let axis = ["x", "y", "z"].iter().position(|axis| *axis == path[1]).unwrap();
            let mut way = [0.0; 3];
            way[axis] = by;
            let way = model.axes.to_iso(way);
            let place = model.point(path[0]).unwrap();
            assert!(model.set_point(path[0], std::array::from_fn(|k| place[k] + way[k])));
            return model;
        }
        let units = model.units;
        let shown = parameter.quantity.show(units, by);
        let set = |model: &mut Model, name: &str, value: f64| {
            model.set_static(name, value).unwrap();
        };
        match path[..] {
            ["adjusters", name] => {
                let adjuster = model.adjusters().iter().find(|a| a.name == name).unwrap();
                let now = Quantity::Length.show(units, adjuster.setting);
                set(&mut model, name, now + shown);
                return model;
            }
            ["static", name] => {
                let state = model.static_state();
                let now = match state.targets.iter().find(|target| target.factor == name) {
                    Some(target) => target.quantity.show(units, target.value),
                    None => Quantity::Length.show(units, state.ride_height),
                };
                set(&mut model, name, now + shown);
                return model;
            }
            _ => {}
        }
        let mut file: Table = self.text.parse().unwrap();
        match path[..] {
            ["wheel" | "anti_roll_bar", key] => add(&mut file[path[0]], key, shown),
            [section @ ("forces" | "axle_forces"), name, ref rest @ ..] => {
                let forces = file[section].as_array_mut().unwrap();
                let force = forces.iter_mut().find(|force| force["name"].as_str() == Some(name));
                let force = force.unwrap();
                if rest == ["preload"] && force["kind"].as_str() == Some("spring") {
                    // An actuator beside the spring, for a spring has a free length or a preload.
                    let mut more = force.as_table().unwrap().clone();
                    more.retain(|key, _| ["between", "on"].contains(&AsRef::<str>::as_ref(key)));
                    more.insert("name".into(), "more".into());
                    more.insert("kind".into(), "actuator".into());
                    more.insert("force".into(), Value::Float(-shown));
                    forces.push(Value::Table(more));
                } else {
                    change_force(force, rest, by, shown);
                }
            }
            ["bushings", name, ref rest @ ..] => {
                change_force(&mut file["bushings"][name], rest, by, shown);
            }
            ["subframe", "mounts", name, ref rest @ ..] => {
                change_force(&mut file["subframe"]["mounts"][name], rest, by, shown);
            }
            _ => panic!("{}", parameter.name),
        }
        parse(&file.to_string())
    }
}

fn parse(text: &str) -> Model {
    Model::parse("models/model.toml", text).unwrap_or_else(|e| panic!("{}", e.render()))
}

fn number(value: &Value) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    value.as_float().or(value.as_integer().map(|n| n as f64)).unwrap()
}

fn add(table: &mut Value, key: &str, shown: f64) {
    let table = table.as_table_mut().unwrap();
    let now = table.get(key).map_or(0.0, number);
    table.insert(key.into(), Value::Float(now + shown));
}

/// Changes a number of a force or bushing.
fn change_force(force: &mut Value, path: &[&str], by: f64, shown: f64) {
    let row = |rows: &mut Value, row: &str| {
        let force = &mut rows[row.parse::<usize>().unwrap() - 1][1];
        *force = Value::Float(number(force) + shown);
    };
    let scale = |rows: &mut Value| {
        for row in rows.as_array_mut().unwrap() {
            row[1] = Value::Float(number(&row[1]) * (1.0 + by));
        }
    };
    match *path {
        ["scale"] => scale(&mut force["table"]),
        [key @ ("scale" | "rotational_scale"), axis] => {
            let turns = if key == "scale" { "" } else { "r" };
            scale(&mut force["tables"][&*format!("{turns}{axis}")]);
        }
        ["table", k] => row(&mut force["table"], k),
        ["table", component, k] => row(&mut force["tables"][component], k),
        [key, axis] => {
            let axis = ["x", "y", "z"].iter().position(|name| *name == axis).unwrap();
            let force = force.as_table_mut().unwrap();
            let list = force.entry(key).or_insert_with(|| vec![0.0; 3].into());
            list[axis] = Value::Float(number(&list[axis]) + shown);
        }
        [key] => add(force, key, shown),
        _ => panic!("{path:?}"),
    }
}

/// The step (SI) by which a parameter is changed, which makes derivatives comparable, too.
pub fn step(parameter: &Parameter) -> f64 {
    match parameter.quantity {
        Quantity::Length => 1e-3,
        Quantity::Angle => 1e-3,
        Quantity::Force => 30.0,
        Quantity::Torque => 1.0,
        Quantity::Stiffness => 2e3,
        Quantity::RotationalStiffness => 10.0,
        _ => 0.02,
    }
}

/// Asserts that the adjoint derivatives at a state are the direct ones, and that both are those of models made
/// anew with `samples` of the parameters changed.
pub fn check(case: &Case, samples: usize) {
    if case.axle {
        let stand = |model: &Model| {
            Axle::with_loads(model, &case.setup, LoadPoint::default())
                .unwrap_or_else(|e| panic!("{e}"))
        };
        check_on(case, stand, samples);
    } else {
        let stand = |model: &Model| {
            Corner::with_loads(model, &case.setup, LoadPoint::default())
                .unwrap_or_else(|e| panic!("{e}"))
        };
        check_on(case, stand, samples);
    }
}

fn there<V: Variable>(case: &Case, mut specimen: V) -> V {
    specimen.measure_compliance(true);
    specimen.go_to(&case.target).unwrap_or_else(|stop| panic!("{stop}"));
    specimen
}

fn check_on<V: Variable>(case: &Case, stand: impl Fn(&Model) -> V, samples: usize) {
    let model = case.model();
    let parameters = case.parameters();
    let factors: Vec<&'static Factor> = FACTORS.iter().collect();
    let mut specimen = there(case, stand(&model));
    let mut find = |way: Way| {
        sensitivities(&mut specimen, &model, &factors, Convention::Iso, &parameters, way)
            .unwrap_or_else(|e| panic!("{e}"))
    };
    let (direct, adjoint) = (find(Way::Direct), find(Way::Adjoint));
    assert!(direct.rows.iter().filter(|row| row.value.is_some()).count() > 50);
    let name = &model.name;
    compare_ways(name, &parameters, &direct, &adjoint);
    let mut random = fastrand::Rng::with_seed(7);
    let mut chosen: Vec<usize> = (0..parameters.len()).collect();
    random.shuffle(&mut chosen);
    let mut wrong = vec![];
    for &k in &chosen[..samples.min(parameters.len())] {
        let values = |by: f64| {
            let model = case.moved(&parameters[k], by);
            let poses = there(case, stand(&model)).poses();
            let value = |row: &Sensitivity| {
                let pose = poses.iter().find(|pose| pose.side == row.side).unwrap();
                row.factor.value(Convention::Iso, pose).unwrap_or(f64::NAN)
            };
            direct.rows.iter().map(value).collect::<Vec<f64>>()
        };
        if case.in_file(&parameters[k].name).is_none() {
            continue;
        }
        let size = |row: &Sensitivity| {
            // A factor that is constant has derivatives that are rounding.
            let least = 1e-4 * row.value.unwrap_or(0.0).abs().max(1.0);
            1e-3 * largest(row, &parameters).max(least) / step(&parameters[k])
        };
        let sizes: Vec<f64> = direct.rows.iter().map(size).collect();
        let expected = differences(values, step(&parameters[k]), &sizes);
        for ((row, expected), size) in direct.rows.iter().zip(expected).zip(sizes) {
            // Some are not defined next to a state where they just are.
            if row.value.is_none() || expected.is_nan() {
                continue;
            }
            let by = row.by[k].unwrap_or(f64::NAN);
            let by_force = case.target.wheels.iter().any(|hold| matches!(hold, Hold::Force(_)));
            if by_force && ["wheel_load", "loaded_radius"].contains(&row.factor.name) {
                // Models made anew have the force as exactly as the rig seeks it.
                assert!((by * step(&parameters[k])).abs() < 1e-12 * row.value.unwrap().abs());
                continue;
            }
            let allowed = 1e-6 * expected.abs().max(size);
            let off = (by - expected).abs();
            if off.is_nan() || off > allowed {
                wrong.push(format!(
                    "{}: d{} ({} side)/d{}: {by:e} for {expected:e}, off by {:.1e} allowed",
                    name,
                    row.factor.name,
                    row.side.name(),
                    parameters[k].name,
                    off / allowed,
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}

/// The largest change of a factor by a step of any parameter.
fn largest(row: &Sensitivity, parameters: &[Parameter]) -> f64 {
    let changes = row.by.iter().zip(parameters).filter_map(|(by, p)| Some(by.as_ref()? * step(p)));
    changes.fold(0.0, |largest: f64, change| largest.max(change.abs()))
}

fn compare_ways(
    name: &str,
    parameters: &[Parameter],
    direct: &Sensitivities,
    adjoint: &Sensitivities,
) {
    assert_eq!(direct.refused, adjoint.refused, "{name}");
    let mut wrong = vec![];
    for (row, other) in direct.rows.iter().zip(&adjoint.rows) {
        assert_eq!((row.factor.name, row.side), (other.factor.name, other.side));
        // A factor that is constant has derivatives that are rounding.
        let least = 1e-4 * row.value.unwrap_or(0.0).abs().max(1.0);
        let largest = largest(row, parameters).max(least);
        for ((by, other), parameter) in row.by.iter().zip(&other.by).zip(parameters) {
            let size = step(parameter);
            let (Some(by), Some(other)) = (by, other) else {
                assert_eq!(by.is_some(), other.is_some());
                continue;
            };
            let allowed = 1e-11 * (by.abs() * size).max(largest);
            let off = (by - other).abs() * size;
            if off.is_nan() || off > allowed {
                wrong.push(format!(
                    "{name}: d{} ({} side)/d{}: {by:e} direct, {other:e} adjoint, off by {:.1e} allowed",
                    row.factor.name,
                    row.side.name(),
                    parameter.name,
                    off / allowed
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong.join("\n"));
}

/// Derivatives from differences, each with the step that has the smallest error by its own estimate.
///
/// Steps get shorter until that is small beside the value, or beside the size that counts.
fn differences(values: impl Fn(f64) -> Vec<f64>, step: f64, sizes: &[f64]) -> Vec<f64> {
    let mut best = richardson(&values, step);
    for part in [1.0 / 6.0, 1.0 / 36.0] {
        let exact = |((value, error), size): (&(f64, f64), &f64)| {
            value.is_nan() || *error <= 1e-7 * value.abs().max(*size)
        };
        if best.iter().zip(sizes).all(exact) {
            break;
        }
        for (best, next) in best.iter_mut().zip(richardson(&values, part * step)) {
            if next.1 < best.1 {
                *best = next;
            }
        }
    }
    best.into_iter().map(|(value, _)| value).collect()
}

/// Derivatives of sixth order from central differences with a step, its half and its quarter, and their errors.
fn richardson(values: &impl Fn(f64) -> Vec<f64>, step: f64) -> Vec<(f64, f64)> {
    let difference = |step: f64| -> Vec<f64> {
        let (more, less) = (values(step), values(-step));
        more.iter().zip(&less).map(|(more, less)| (more - less) / (2.0 * step)).collect()
    };
    let [whole, half, quarter] = [1.0, 0.5, 0.25].map(|part| difference(part * step));
    let extrapolated = |k: usize| {
        let first = (4.0 * half[k] - whole[k]) / 3.0;
        let second = (4.0 * quarter[k] - half[k]) / 3.0;
        ((16.0 * second - first) / 15.0, (second - first).abs())
    };
    (0..whole.len()).map(extrapolated).collect()
}
