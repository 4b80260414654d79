//! The factors that both wheels of an axle have together.
#![allow(missing_docs)]

use std::collections::HashMap;

use hardpoint::factors::{Convention, find};
use hardpoint::model::{Drive, Model, Setup};
use hardpoint::rig::{Axle, Event, Held, Pose, Sweep, SweepPlan};

fn table(text: &str) -> Vec<HashMap<String, f64>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader.deserialize().map(|row| row.expect("the table is well-formed")).collect()
}

fn model(name: &str) -> Model {
    let path = format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    Model::load(path).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

fn axle(model: &Model, drive: Drive) -> Axle {
    Axle::new(model, &Setup::from(drive)).unwrap()
}

/// A factor by Lotus' definitions in the units of the model.
fn lotus(name: &str, model: &Model, pose: &Pose<f64>) -> Option<f64> {
    find(name).unwrap().show_by(Convention::Lotus, model.units, pose)
}

fn iso(name: &str, pose: &Pose<f64>) -> f64 {
    find(name).unwrap().value(Convention::Iso, pose).unwrap_or_else(|| panic!("{name}"))
}

/// Every printed column of Lotus' steering table, both sides: angles to 0.0055°, Ackermann to 0.011 %,
/// the turning radius to 1e-6 and half a digit.
#[test]
fn lotus_has_all_columns_of_its_steering_table() {
    let model = model("lotus-front");
    let reference = table(include_str!("reference/lotus-steering.csv"));
    let mut axle = axle(&model, Drive::ContactPatch);
    let (event, held) = (Event::Steer, Held::default());
    let plan = SweepPlan { event, from: -0.045, to: 0.045, step: 0.0045, held };
    let sweep = Sweep::run(&mut axle, &plan, |_| {});
    assert_eq!((sweep.rows.len(), reference.len()), (21, 21));
    let mut worst: f64 = 0.0;
    for (row, expected) in sweep.rows.iter().zip(&reference) {
        let [left, right] = &row.poses[..] else { panic!("an axle has two wheels") };
        let mut near = |column: &str, name: &str, pose: &Pose<f64>, tolerance: f64| {
            let found = lotus(name, &model, pose).expect(name);
            let difference = (found - expected[column]).abs();
            worst = worst.max(difference / tolerance);
            assert!(difference <= tolerance, "{column}: {found}, not {}", expected[column]);
        };
        near("rack_mm", "rack", left, 1e-9);
        for (pose, side) in [(left, "lhs"), (right, "rhs")] {
            near(&format!("toe_{side}_deg"), "toe", pose, 0.0055);
            near(&format!("camber_{side}_deg"), "camber", pose, 0.0055);
        }
        for pose in [left, right] {
            if expected["rack_mm"] == 0.0 {
                // Parallel wheels have neither.
                assert_eq!(lotus("ackermann", &model, pose), None);
                assert_eq!(lotus("turning_radius", &model, pose), None);
            } else {
                near("ackermann_pct", "ackermann", pose, 0.011);
                let radius = expected["turning_radius_mm"];
                near("turning_radius_mm", "turning_radius", pose, 1e-6 * radius + 0.005);
            }
        }
    }
    assert!(worst > 0.1, "the reference is rounded");
    // The printed Ackermann at the middle is the limit of small angles.
    axle.move_to([0.0; 2], 5e-4).unwrap();
    let limit = lotus("ackermann", &model, &axle.poses()[0]).unwrap();
    assert!((limit - 17.29).abs() < 0.011, "{limit}");
}

/// Wheels on an ideal linkage have 100 % by both definitions where they agree, and the centre of the turn on the
/// line of the rear axle.
#[test]
fn ackermann_against_its_closed_form() {
    let mut model = model("lotus-front");
    model.vehicle.wheelbase = Some(2.5);
    let mut axle = axle(&model, Drive::ContactPatch);
    axle.move_to([0.0; 2], 0.02).unwrap();
    let [left, right] = axle.poses();
    let (l, r) = (iso("steer_angle", &left), iso("steer_angle", &right));
    assert!(l * r > 0.0);
    // Positive racks go to the right in the axes of this model, ahead of the axle: a left turn.
    let (inner, outer) = if l > 0.0 { (l, r) } else { (-r, -l) };
    let track = iso("track", &left);
    let ideal = (2.5 / (2.5 / outer.tan() - track)).atan();
    let close = |name: &str, expected: f64| {
        for pose in [&left, &right] {
            let found = iso(name, pose);
            assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{name}: {found}");
        }
    };
    close("ideal_steer", ideal);
    close("ackermann_angle", inner - outer);
    close("ackermann_error", inner - ideal);
    close("ackermann", (inner - outer) / (ideal - outer));
    close("outside_turn_diameter", 5.0 / outer.sin());
    close("turning_radius", 1.25 * (1.0 / inner.tan() + 1.0 / outer.tan()));
    close("mean_steer", 0.5 * (l + r));
    // The exact slope by the rack is the slope of the mean.
    let mut mean = |rack: f64| {
        axle.move_to([0.0; 2], rack).unwrap();
        iso("mean_steer", &axle.poses()[0])
    };
    let h = 1e-4;
    let slope = (8.0 * (mean(0.02 + h) - mean(0.02 - h)) - mean(0.02 + 2.0 * h)
        + mean(0.02 - 2.0 * h))
        / (12.0 * h);
    close_to(iso("mean_steer_by_rack", &left), slope, 1e-9);
}

#[track_caller]
fn close_to(found: f64, expected: f64, tolerance: f64) {
    let size = expected.abs().max(1.0);
    assert!((found - expected).abs() <= tolerance * size, "{found} instead of {expected}");
}

/// In parallel travel the roll centre of the axle is that of the corner; a mirrored axle has the mirrored one.
#[test]
fn roll_centre_of_both_wheels() {
    let model = model("lotus-front");
    let mut axle = axle(&model, Drive::ContactPatch);
    for travel in [-0.03, 0.0, 0.02] {
        axle.move_to([travel; 2], 0.0).unwrap();
        for pose in axle.poses() {
            assert!(iso("roll_center_y", &pose).abs() < 1e-12);
            close_to(iso("roll_center_z", &pose), iso("rc_height", &pose), 1e-12);
        }
    }
    axle.move_to([0.02, -0.01], 0.0).unwrap();
    let one = axle.poses()[0];
    axle.move_to([-0.01, 0.02], 0.0).unwrap();
    let other = axle.poses()[0];
    assert!(iso("roll_center_y", &one).abs() > 1e-4);
    close_to(iso("roll_center_y", &one), -iso("roll_center_y", &other), 1e-12);
    close_to(iso("roll_center_z", &one), iso("roll_center_z", &other), 1e-12);
}

/// Both wheels, and the roll of the body against the line through their patches (rad).
type State = ([Pose<f64>; 2], f64);

/// Roll steer and roll camber are the slopes of toe and camber in opposite travel, by the
/// angle of the line through both patches.
#[test]
fn roll_slopes_are_those_of_opposite_travel() {
    for name in ["lotus-front", "sedan-axle"] {
        let model = model(name);
        let mut axle = axle(&model, Drive::WheelCenter);
        let mut at = |u: f64| -> State {
            axle.move_to([0.01 + u, 0.01 - u], 0.004).unwrap();
            let poses = axle.poses();
            let [left, right] = poses.each_ref().map(|pose| pose.wheel.contact_patch());
            let roll = -((left[2] - right[2]) / (left[1] - right[1])).atan();
            (poses, roll)
        };
        let h = 5e-4;
        let states = [-2.0, -1.0, 1.0, 2.0].map(|k| at(k * h));
        let slope = |value: &dyn Fn(&State) -> f64| {
            let [a, b, c, d] = states.each_ref().map(value);
            (8.0 * (c - b) - (d - a)) / (12.0 * h)
        };
        let roll = slope(&|state| state.1);
        let (poses, _) = at(0.0);
        for (side, pose) in poses.iter().enumerate() {
            let steer = slope(&|state| iso("steer_angle", &state.0[side])) / roll;
            let camber = slope(&|state| iso("camber", &state.0[side])) / roll;
            close_to(iso("roll_steer", pose), steer, 1e-8);
            close_to(iso("roll_camber", pose), camber, 1e-8);
            close_to(iso("roll_camber_ground", pose), camber - pose.side.sign(), 1e-8);
        }
    }
}
