//! Equilibrium, settling and sweeps with forces as a user meets them.

#[path = "common/program.rs"]
mod program;

use program::{column, hardpoint, json, stderr, stdout};
use std::fs;

const QUARTER: &str = "models/quarter-car.toml";
const BUSHED: &str = "models/bushed-double-wishbone.toml";

#[test]
fn equilibrium_shows_pose_joints_and_forces() {
    let text = stdout(&hardpoint(&["equilibrium", BUSHED]).success());
    // The second line has the residual, which is rounding.
    let (how, rest): (Vec<_>, Vec<_>) =
        text.lines().partition(|line| line.starts_with("static equilibrium after"));
    assert!(how[0].contains("stable"), "{how:?}");
    insta::assert_snapshot!(rest.join("\n"));
}

/// Quarter car: the tyre carries all of the mass; independent solution of the same model.
#[test]
fn a_quarter_car_stands_on_its_tyre() {
    let found = json(&["equilibrium", QUARTER]);
    let wheel = &found["wheel"];
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    // 1e-10 m and 1e-8°, forces to rounding.
    let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-8, "{found}");
    close(number(&wheel["wheel_center_x_mm"]), -0.21524651829120614);
    close(number(&wheel["wheel_center_y_mm"]), 799.0158122970397);
    close(number(&wheel["wheel_center_z_mm"]), -120.35559545454545);
    close(number(&wheel["toe_deg"]), -0.5190665021496355);
    close(number(&wheel["camber_deg"]), -0.887863946237508);
    close(number(&wheel["wheel_load_N"]), (380.0 + 4.2 + 2.1 + 38.0 + 0.8) * 9.81);
    close(number(&found["bodies"]["chassis"]["displacement"][2]), -19.377184092890735);
    assert!(number(&found["relative_residual"]) < 1e-12);
    assert!(number(&found["iterations"]) <= 8.0);
}

#[test]
fn settling_ends_in_the_equilibrium() {
    let found = json(&["settle", QUARTER, "--fixed-chassis", "--step", "0.0005"]);
    for row in found["rows"].as_array().expect("there is a table") {
        let difference = row["difference"].as_f64().expect("there is an equilibrium");
        assert!(difference.abs() < 1e-6, "{row}");
    }
    assert_eq!(found["rows"][0]["quantity"], "wheel centre, x");
    assert_eq!(found["steps"], 10000);
    // The quarter car itself: 1e-6 m after five seconds, as the paper has it.
    let found = json(&["settle", QUARTER, "--seconds", "5"]);
    for row in &found["rows"].as_array().expect("there is a table")[..3] {
        assert!(row["difference"].as_f64().expect("a number").abs() < 1e-3, "{row} in mm");
    }
    let text = stdout(&hardpoint(&["settle", QUARTER]).success());
    for words in ["A dynamic", "B quasi-static", "B − A", "drift of the energy"] {
        assert!(text.contains(words), "{text}");
    }
}

#[test]
fn settling_writes_its_motion() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("motion.csv");
    let path = file.to_str().unwrap();
    hardpoint(&["settle", QUARTER, "--seconds", "0.1", "-o", path]).success();
    let text = fs::read_to_string(&file).unwrap();
    let times = column(&text, "time_s");
    assert_eq!((times.len(), times[10]), (11, 0.1));
    // It falls, and the energy stays.
    assert!(column(&text, "tyre_load_N")[10] > 4000.0);
    assert!(column(&text, "energy_drift_J").iter().all(|drift| drift.abs() < 1e-2));
}

#[test]
fn a_travel_sweep_has_wheel_load_and_rate() {
    let text = stdout(&hardpoint(&["sweep", QUARTER, "--format", "csv", "--reactions"]).success());
    let (load, rate) = (column(&text, "wheel_load_N"), column(&text, "wheel_rate_N/mm"));
    // Sedan, −130 … 130 mm: independent statics.
    assert!((load[0] - 1367.7305630740889).abs() < 1e-6, "{}", load[0]);
    assert!((rate[0] - 19.03872484288638).abs() < 1e-9, "{}", rate[0]);
    let ball = column(&text, "lower_ball_joint_fz_N");
    assert!((ball[0] + 910.3114955394778).abs() < 1e-6, "{}", ball[0]);
    // The rate is the derivative of the load.
    for k in 1..load.len() - 1 {
        let difference = (load[k + 1] - load[k - 1]) / 20.0;
        assert!((difference - rate[k]).abs() < 0.02, "{difference} {}", rate[k]);
    }
}

#[test]
fn a_load_sweep_gives_compliance() {
    let range = ["--from", "-1000", "--to", "1000", "--step", "1000", "--format", "csv"];
    let mut arguments = vec!["sweep", BUSHED, "--event", "load", "--vary", "fx"];
    arguments.extend(range);
    let text = stdout(&hardpoint(&arguments).success());
    assert_eq!(column(&text, "load_fx_N"), [-1000.0, 0.0, 1000.0]);
    let x = column(&text, "wheel_center_x_mm");
    assert!(x[0] < x[1] && x[1] < x[2], "{x:?}");
    // The joints alone do not give way to a force along x that much.
    arguments.push("--kinematic");
    let text = stdout(&hardpoint(&arguments).success());
    let rigid = column(&text, "wheel_center_x_mm");
    assert!((rigid[2] - rigid[0]).abs() < 0.1 * (x[2] - x[0]), "{rigid:?} {x:?}");
}

#[test]
fn mechanisms_run_with_every_command() {
    let text = stdout(&hardpoint(&["check", "models/squeezer.toml"]).success());
    assert!(text.contains("7 moving bodies, 1 degree of freedom"), "{text}");
    assert_eq!(text.matches("redundant: ").count(), 9, "{text}");
    let sweep = ["--from", "0", "--to", "360", "--step", "90", "--format", "csv"];
    let mut arguments = vec!["sweep", "models/four-bar.toml"];
    arguments.extend(sweep);
    let text = stdout(&hardpoint(&arguments).success());
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 5);
    for (first, last) in rows[0].iter().zip(rows[4].iter()).skip(1) {
        let (first, last): (f64, f64) = (first.parse().unwrap(), last.parse().unwrap());
        assert!((first - last).abs() < 1e-9, "a full turn leads back: {first} {last}");
    }
    let found = json(&["equilibrium", "models/anti-roll-bar.toml"]);
    assert!(found["force_elements"]["anti_roll_bar_torque_N·mm"].as_f64().unwrap().abs() > 1.0);
    let found = json(&["settle", "models/pendulum.toml", "--seconds", "1"]);
    assert!(found["energy_drift_J"].as_f64().unwrap().abs() < 1e-4, "{found}");
}

#[test]
fn what_goes_wrong_is_told() {
    for (arguments, code, words) in [
        (&["equilibrium", "models/double-wishbone.toml"][..], 2, "has no forces"),
        (&["equilibrium", QUARTER, "--load", "fq=3"], 2, "fx, fy, fz, mx, my, mz"),
        (&["equilibrium", QUARTER, "--load", "fx=much"], 2, "such as fx=1000"),
        (&["equilibrium", QUARTER, "--format", "csv"], 2, "possible values: table, json"),
        (&["equilibrium", QUARTER, "-o", "rest.csv"], 2, ".json or .txt"),
        (&["settle", QUARTER, "--step", "1e-9"], 2, "at most 10,000,000 steps"),
        (&["settle", QUARTER, "--seconds", "0"], 2, "above zero"),
        (&["equilibrium", "models/four-bar.toml", "--travel", "3"], 2, "this file is a mechanism"),
        (&["equilibrium", "models/four-bar.toml", "--release", "x"], 2, "there is no driver `x`"),
        (&["equilibrium", "models/double-four-bar.toml"], 3, "the equilibrium is unstable"),
        (&["sweep", "models/four-bar.toml"], 2, "--from and --to"),
        (&["sweep", "models/pendulum.toml", "--from", "0", "--to", "1"], 2, "has no driver"),
        (&["sweep", QUARTER, "--event", "load"], 2, "--vary fx"),
        (&["sweep", "models/double-wishbone.toml", "--event", "load", "--vary", "fx"], 2, "forces"),
        (&["settle", QUARTER, "--step", "-1"], 2, "step"),
        (&["settle", QUARTER, "--seconds", "-1"], 2, "above zero"),
        (&["settle", "models/double-wishbone.toml"], 3, "mass"),
    ] {
        let done = hardpoint(arguments);
        let (error, output) = (stderr(&done), stdout(&done));
        let status = done.get_output().status.code();
        assert_eq!(status, Some(code), "{arguments:?}: {error}{output}");
        assert!(error.contains(words), "{arguments:?}: {error}");
    }
}
