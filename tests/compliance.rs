//! Compliant corners from their model files against other programs.

use std::collections::HashMap;

use hardpoint::factors::FACTORS;
use hardpoint::mechanism::PointId;
use hardpoint::model::{Model, Setup, WheelSupport};
use hardpoint::rig::{Corner, LOAD_COMPONENTS, Load, LoadPoint, Pose, Specimen as _, Stand};

type Row = HashMap<String, String>;

fn rows(text: &str) -> Vec<Row> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader.deserialize().map(|row| row.expect("the table is well-formed")).collect()
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {}", row[column]))
}

fn vector(row: &Row, name: &str) -> [f64; 3] {
    ["x", "y", "z"].map(|axis| number(row, &format!("{name}_{axis}")))
}

/// The text of a shipped model with some of its words exchanged.
fn model(name: &str, changes: &[(&str, &str)]) -> Model {
    let path = format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut text = std::fs::read_to_string(&path).expect("the model is shipped");
    for (from, to) in changes {
        assert!(text.contains(from), "`{from}` is not in {name}");
        text = text.replace(from, to);
    }
    Model::parse(&path, &text).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

fn load(component: &str, value: f64) -> Load {
    let mut load = Load::default();
    let index = LOAD_COMPONENTS.iter().position(|name| *name == component).unwrap();
    load.components[index] = value;
    load
}

fn factor(model: &Model, pose: &Pose<f64>, name: &str) -> f64 {
    let factor = FACTORS.iter().find(|factor| factor.name == name).expect("the factor exists");
    factor.show(model.units, pose).expect("the suspension has the factor")
}

/// Where a point of the upright is (m, ISO 8855 axes).
fn on_upright(corner: &Corner, name: &str) -> [f64; 3] {
    let mechanism = corner.stand().mechanism();
    let point: PointId = mechanism.point_named(name).expect("the mechanism has the point");
    corner.equilibrium().loaded().point(corner.suspension().wheel.body, point)
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let difference = (found - expected).abs();
    assert!(difference <= tolerance, "{what}: {found} for {expected}, off by {difference:e}");
}

#[track_caller]
fn all_close(what: &str, found: [f64; 3], expected: [f64; 3], tolerance: f64) {
    for axis in 0..3 {
        close(&format!("{what}[{axis}]"), found[axis], expected[axis], tolerance);
    }
}

/// Sedan with its lower arm on two bushings: both variants, both measures of rotation, six load
/// cases and none, to 1e-11 m and 1e-9°.
#[test]
fn the_sedan_on_bushings() {
    const UNLOADED: [(&str, &str); 2] =
        [("gravity = 9.81", "gravity = 0.0"), ("stiffness = 70.0", "stiffness = 0.0")];
    let rows = rows(include_str!("reference/sedan-bushings.csv"));
    assert_eq!(rows.len(), 28);
    for row in &rows {
        let angles = format!("law = \"torque\"\nangles = \"{}\"", row["angles"]);
        let mut changes = vec![("law = \"torque\"", angles.as_str())];
        let held = row["case"] == "B1";
        if held {
            changes.extend(UNLOADED);
        }
        let model = model("bushed-double-wishbone", &changes);
        let support = if held { WheelSupport::Held } else { WheelSupport::Free };
        let setup = Setup { support, ..Setup::default() };
        let mut corner = Corner::with_loads(&model, &setup, LoadPoint::ContactPatch).unwrap();
        corner.set_load(&match row["load"].as_str() {
            "base" => Load::default(),
            case => {
                let size = if case.starts_with('F') { 1000.0 } else { 100.0 };
                let sign = if case.ends_with('+') { 1.0 } else { -1.0 };
                load(&case[..2].to_lowercase(), sign * size)
            }
        });
        let what = format!("{} {} {}", row["case"], row["angles"], row["load"]);
        let found = corner.rest().unwrap_or_else(|failure| panic!("{what}: {failure}"));
        assert!(found.relative_residual <= 1e-12, "{what}: {found:?}");
        let pose = corner.pose();
        all_close(&format!("{what} wheel"), pose.wheel.center, vector(row, "wc"), 1e-11);
        let contact = on_upright(&corner, "contact patch at design");
        all_close(&format!("{what} contact"), contact, vector(row, "cp"), 1e-11);
        for (name, column) in [("toe", "toe_deg"), ("camber", "camber_deg")] {
            let found = factor(&model, &pose, name);
            close(&format!("{what} {name}"), found, number(row, column), 1e-9);
        }
        // The reference has the forces of the upright on the arms.
        let mechanism = corner.stand().mechanism();
        let reactions = corner.equilibrium().reactions();
        for (joint, column) in [("lower_ball_joint", "lbj"), ("upper_ball_joint", "ubj")] {
            let index = mechanism.joints().iter().position(|j| j.name == joint).unwrap();
            let force = reactions[index].on_j.force.map(|x| -x);
            all_close(&format!("{what} {joint}"), force, vector(row, column), 2e-5);
        }
    }
}

/// The compliant corner: eight load cases to 1e-6 mm and 1e-7°; camber there is −asin(s_z), toe
/// −atan(s_x/|s_y|) with x rearward.
#[test]
fn the_compliant_corner() {
    let model = model("compliant-corner", &[]);
    for row in rows(include_str!("reference/bushing-compliance.csv")) {
        let case = row["case"].as_str();
        let (point, load, kinematic) = match case {
            "base" => (LoadPoint::ContactPatch, Load::default(), false),
            "rigid" => (LoadPoint::ContactPatch, Load::default(), true),
            "Fx_plus_wc" => (LoadPoint::WheelCenter, load("fx", 1000.0), false),
            "Fx_minus_wc" => (LoadPoint::WheelCenter, load("fx", -1000.0), false),
            "Fx_rear_cp_1kN_braking" => (LoadPoint::ContactPatch, load("fx", 1000.0), false),
            "Fy_plus_cp_outboard" => (LoadPoint::ContactPatch, load("fy", 1000.0), false),
            "Fy_minus_cp_inboard" => (LoadPoint::ContactPatch, load("fy", -1000.0), false),
            "Fz_2500" => (LoadPoint::ContactPatch, load("fz", -500.0), false),
            "Fz_3500" => (LoadPoint::ContactPatch, load("fz", 500.0), false),
            other => panic!("unknown case {other}"),
        };
        let setup = Setup { support: WheelSupport::Free, kinematic, ..Setup::default() };
        let mut corner = Corner::with_loads(&model, &setup, point).unwrap();
        corner.set_load(&load);
        let found = corner.rest().unwrap_or_else(|failure| panic!("{case}: {failure}"));
        assert!(found.relative_residual <= 1e-12, "{case}: {found:?}");
        let pose = corner.pose();
        let mm = |position: [f64; 3]| model.axes.from_iso(position.map(|x| x * 1000.0));
        let places = [
            ("wheel_centre", "wheel_center"),
            ("contact", "contact_patch"),
            ("lbj", "lca_outer"),
            ("ubj", "uca_outer"),
            ("tie_outer", "tierod_outer"),
        ];
        for (column, point) in places {
            let found = mm(on_upright(&corner, point));
            all_close(&format!("{case} {column}"), found, vector(&row, column), 1e-6);
        }
        for (name, column) in [("toe", "toe_deg"), ("camber", "camber_deg")] {
            close(
                &format!("{case} {name}"),
                factor(&model, &pose, name),
                number(&row, column),
                1e-7,
            );
        }
        let spring = corner.element_channels().iter().position(|c| c.name == "spring_length");
        let length = corner.channel_values()[spring.unwrap()] * 1000.0;
        close(&format!("{case} spring"), length, number(&row, "damper_length"), 1e-6);
        if kinematic {
            continue;
        }
        // The reference has the forces of the arms on the chassis.
        let mechanism = corner.stand().mechanism();
        let loaded = corner.equilibrium().loaded();
        for (force, column) in [
            ("lca_front_bushing", "b_lf"),
            ("lca_rear_bushing", "b_lr"),
            ("uca_front_bushing", "b_uf"),
            ("uca_rear_bushing", "b_ur"),
        ] {
            let force = loaded.force(mechanism.force_named(force).unwrap()).force;
            let found = model.axes.from_iso(force.map(|x| -x));
            let expected = vector(&row, column);
            all_close(&format!("{case} {column}"), found, expected, 1e-3);
        }
    }
}

/// A bushing that resists rotation with the energy ½ θᵀKθ balances a moment that turns it far. What
/// is told of it is the moment, not its part along the angles.
#[test]
fn the_moment_of_a_bushing_is_the_one_that_it_balances() {
    use hardpoint::model::{Axes, Document};
    for angles in ["xyz", "rotation-vector"] {
        for law in ["energy", "torque"] {
            let text = format!(
                r#"
format = 1
name = "Bushing"
ground = "ground"
[units]
length = "m"
angle = "deg"
force = "N"
[points]
center = [0.0, 0.0, 0.0]
[bodies]
body = "On a ball joint"
[[joints]]
name = "ball"
kind = "spherical"
between = ["ground", "body"]
at = "center"
[[forces]]
name = "bushing"
kind = "bushing"
between = ["ground", "body"]
at = "center"
x_axis = "y"
stiffness = [0.0, 0.0, 0.0]
rotational_stiffness = [1.0, 1.5, 2.0]
angles = "{angles}"
law = "{law}"
[[forces]]
name = "moment"
kind = "moment"
body = "body"
moment = [30.0, 20.0, 60.0]
"#
            );
            let Ok(Document::Mechanism(model)) = Document::parse("bushing.toml", &text) else {
                panic!("the file is a mechanism");
            };
            let mut stand = Stand::new(model.mechanism, &[], Axes::Iso8855).unwrap();
            stand.rest().unwrap();
            let channel = |name: &str| {
                let channel = stand.force_channels().iter().find(|channel| channel.name == name);
                channel.unwrap().value(&stand.equilibrium().loaded(), &[], Axes::Iso8855)
            };
            // The axes of the bushing are y, −x and z.
            let expected = [("bushing_mx", -20.0), ("bushing_my", 30.0), ("bushing_mz", -60.0)];
            for (name, moment) in expected {
                assert!((channel(name) - moment).abs() < 1e-9, "{angles} {law} {name}");
            }
        }
    }
}
