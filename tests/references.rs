//! Whole suspensions from their model files against the results of other programs.

use std::collections::HashMap;

use hardpoint::factors::FACTORS;
use hardpoint::model::{Drive, Model, Setup};
use hardpoint::rig::{Corner, Event, Held, Pose, Row, Sweep, SweepPlan};

/// The rows of a reference table by the names of its columns.
fn table(text: &str) -> Vec<HashMap<String, f64>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader.deserialize().map(|row| row.expect("the table is well-formed")).collect()
}

fn model(name: &str) -> Model {
    let path = format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    Model::load(path).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

/// A factor by name in the units of the model.
fn factor(model: &Model, pose: &Pose<f64>, name: &str) -> f64 {
    let factor = FACTORS.iter().find(|factor| factor.name == name).expect("the factor exists");
    factor.show(model.units, pose).expect("the suspension has the factor")
}

fn pose(row: &Row) -> Pose<f64> {
    row.poses[0]
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let difference = (found - expected).abs();
    assert!(
        difference <= tolerance,
        "{what}: {found} instead of {expected}, difference {difference:e}"
    );
}

fn sweep(model: &Model, drive: Drive, plan: &SweepPlan) -> Sweep {
    let mut corner =
        Corner::new(model, &Setup { drive, ..Setup::default() }).expect("the model moves");
    let sweep = Sweep::run(&mut corner, plan, |_| {});
    assert!(sweep.stops.is_empty(), "{:?}", sweep.stops);
    sweep
}

/// Columns of the sedan's reference. It is promised to 1e-9 m and 1e-9°; what is reached is
/// rounding.
fn compare_with_sedan(text: &str, plan: &SweepPlan) -> Sweep {
    let model = model("double-wishbone");
    let sweep = sweep(&model, Drive::WheelCenter, plan);
    let reference = table(text);
    assert_eq!(sweep.rows.len(), reference.len());
    for (row, expected) in sweep.rows.iter().zip(&reference) {
        let at = format!("travel {} rack {}", expected["travel_mm"], expected["rack_mm"]);
        let (pose, tolerance) = (&pose(row), 1e-12);
        let factor = |name: &str| factor(&model, pose, name);
        let patch = pose.wheel.contact_patch();
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let center = expected[&format!("wc_{axis}")];
            close(&format!("{at} W_{axis}"), pose.wheel.center[k], center, tolerance);
            let shown = factor(&format!("wheel_center_{axis}")) / 1000.0;
            close(&format!("{at} shown W_{axis}"), shown, center, tolerance);
            let expected = expected[&format!("cp_{axis}")];
            close(&format!("{at} P_{axis}"), patch[k], expected, tolerance);
        }
        let entry = |i: usize, j: usize| expected[&format!("R{i}{j}")];
        for i in 0..3 {
            for j in 0..3 {
                close(&format!("{at} R{i}{j}"), pose.rotation[i][j], entry(i, j), tolerance);
            }
        }
        let angles = [
            ("wheel_rot_x", (-entry(1, 2)).atan2(entry(2, 2))),
            ("wheel_rot_y", entry(0, 2).asin()),
            ("wheel_rot_z", (-entry(0, 1)).atan2(entry(0, 0))),
        ];
        for (name, expected) in angles {
            close(&format!("{at} {name}"), factor(name), expected.to_degrees(), 1e-10);
        }
        for name in ["toe", "camber", "caster", "kpi"] {
            let expected = expected[&format!("{name}_deg")];
            close(&format!("{at} {name}"), factor(name), expected, 1e-10);
        }
        close(&format!("{at} travel"), factor("travel"), expected["travel_mm"], tolerance);
        close(&format!("{at} rack"), factor("rack"), expected["rack_mm"], tolerance);
    }
    sweep
}

/// The paper's sweep: −130 … 130 mm in 10 mm steps.
#[test]
fn sedan_travel() {
    let plan = SweepPlan {
        event: Event::Travel,
        from: -0.13,
        to: 0.13,
        step: 0.01,
        held: Held::default(),
    };
    let sweep = compare_with_sedan(include_str!("reference/sedan-travel.csv"), &plan);
    for row in &sweep.rows {
        assert!(row.iterations <= 3, "{} iterations at {}", row.iterations, row.value);
        assert!(row.relative_residual <= 1e-12, "{:e}", row.relative_residual);
    }
}

#[test]
fn sedan_steering() {
    let plan =
        SweepPlan { event: Event::Steer, from: -0.06, to: 0.06, step: 0.01, held: Held::default() };
    compare_with_sedan(include_str!("reference/sedan-steer.csv"), &plan);
}

/// Adams/Car: 9 states of both sides to 1e-6 mm and 1e-6°.
#[test]
fn adams_both_sides() {
    let left = model("adams-tr-front");
    for model in [left.mirrored(), left] {
        let side = model.side.name();
        let mut corner = Corner::new(&model, &Setup::default()).expect("the model moves");
        let reference = table(include_str!("reference/adams-tr-front.csv"));
        assert_eq!(reference.len(), 9);
        for expected in reference {
            let (travel, rack) = (expected["wheel_travel_mm"], expected["rack_displacement_mm"]);
            corner.move_to(travel / 1000.0, rack / 1000.0).expect("the state is reached");
            let pose = corner.pose();
            let pairs = [
                ("camber", "camber_deg"),
                ("toe", "toe_deg"),
                ("wheel_center_x", "wc_x_mm"),
                ("wheel_center_y", "wc_y_mm"),
                ("wheel_center_z", "wc_z_mm"),
            ];
            for (name, column) in pairs {
                let expected = expected[&format!("{side}_{column}")];
                let what = format!("{side} travel {travel} rack {rack} {name}");
                close(&what, factor(&model, &pose, name), expected, 1e-6);
            }
        }
    }
}

/// Lotus: all bump points, driven by the contact patch, to the last printed digit of angles
/// (6e-5°) and to 0.006 mm.
#[test]
fn lotus_bump() {
    let model = model("lotus-front");
    let plan = SweepPlan {
        event: Event::Travel,
        from: -0.0375,
        to: 0.0375,
        step: 0.0075,
        held: Held::default(),
    };
    let sweep = sweep(&model, Drive::ContactPatch, &plan);
    let reference = table(include_str!("reference/lotus-bump.csv"));
    assert_eq!(sweep.rows.len(), 11);
    assert_eq!(reference.len(), 11);
    let static_patch = pose(&sweep.rows[5]).wheel.contact_patch();
    for (row, expected) in sweep.rows.iter().zip(&reference) {
        let at = format!("bump {}", expected["bump_mm"]);
        let pairs = [
            ("camber", "camber_deg"),
            ("toe", "toe_deg"),
            ("caster", "castor_deg"),
            ("kpi", "kingpin_deg"),
        ];
        for (name, column) in pairs {
            let found = factor(&model, &pose(row), name);
            close(&format!("{at} {name}"), found, expected[column], 6e-5);
        }
        let patch = pose(row).wheel.contact_patch();
        let outboard = model.side.sign() * (patch[1] - static_patch[1]) * 1000.0;
        close(&format!("{at} half track"), outboard, expected["half_track_change_mm"], 0.006);
        let forward = (patch[0] - static_patch[0]) * 1000.0;
        close(&format!("{at} wheelbase"), forward, expected["wheelbase_change_mm"], 0.006);
        let bump = (patch[2] - static_patch[2]) * 1000.0;
        close(&format!("{at} height of the patch"), bump, expected["bump_mm"], 1e-9);
    }
}
