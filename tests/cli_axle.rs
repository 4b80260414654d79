//! Axles and compliance matrices as a user meets them.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use std::collections::HashMap;
use std::fs;

use program::{column, hardpoint, json, stdout};

fn csv(arguments: &[&str]) -> String {
    stdout(&hardpoint(&[arguments, &["--format", "csv"]].concat()).success())
}

fn compliance(arguments: &[&str]) -> serde_json::Value {
    json(&[&["compliance"], arguments].concat())
}

fn entry(found: &serde_json::Value, row: usize, column: usize) -> f64 {
    found["matrix"][row][column].as_f64().expect("a number")
}

#[track_caller]
fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{found} {expected}");
}

const AXLE: &str = "models/sedan-axle.toml";
const RANGE: [&str; 6] = ["--from", "-20", "--to", "20", "--step", "20"];

#[test]
fn travel_events_move_their_wheels() {
    for (event, left, right) in [
        ("parallel", [-20.0, 0.0, 20.0], [-20.0, 0.0, 20.0]),
        ("opposite", [-15.0, 5.0, 25.0], [25.0, 5.0, -15.0]),
        ("left", [-20.0, 0.0, 20.0], [5.0; 3]),
        ("right", [5.0; 3], [-20.0, 0.0, 20.0]),
    ] {
        let mut arguments = vec!["sweep", AXLE, "--axle", "--event", event, "--rack", "3"];
        arguments.extend(RANGE);
        if event != "parallel" {
            arguments.extend(["--travel", "5"]);
        }
        let text = csv(&arguments);
        assert_eq!(column(&text, "left_travel_mm"), left, "{event}");
        assert_eq!(column(&text, "right_travel_mm"), right, "{event}");
        assert_eq!(column(&text, "rack_mm"), [3.0; 3]);
        assert!(!text.contains("left_rack"));
    }
}

/// Loads of both wheels in Adams axes: y to the right.
#[test]
fn load_events_load_their_wheels() {
    let sweep = |wheels: &[&str]| {
        let arguments =
            ["sweep", AXLE, "--axle", "--event", "load", "--vary", "fy", "--travel", "0"];
        let text =
            csv(&[&arguments[..], &["--from", "0", "--to", "500", "--step", "500"], wheels]
                .concat());
        let moved = |name: &str| {
            let y = column(&text, name);
            y[1] - y[0]
        };
        (moved("left_wheel_center_y_mm"), moved("right_wheel_center_y_mm"), text)
    };
    let (left, right, text) = sweep(&[]);
    assert!(left > 0.01 && right > 0.01, "{left} {right}");
    assert_eq!(column(&text, "parallel_load_fy_N"), [0.0, 500.0]);
    let (left, right, _) = sweep(&["--wheels", "opposed"]);
    assert!(left > 0.01 && (left + right).abs() < 1e-8, "{left} {right}");
    let (left, right, _) = sweep(&["--wheels", "right"]);
    assert!(left.abs() < 1e-3 && right > 0.01, "{left} {right}");
}

#[test]
fn steering_moves_both_wheels() {
    let mut arguments = vec!["sweep", AXLE, "--axle", "--event", "steer"];
    arguments.extend(RANGE);
    let text = csv(&arguments);
    let (left, right) = (column(&text, "left_toe_deg"), column(&text, "right_toe_deg"));
    assert_eq!(column(&text, "rack_mm"), [-20.0, 0.0, 20.0]);
    // A rack behind the wheel centre that goes left turns both wheels to the right.
    assert!(left[2] - left[1] > 1.0 && right[2] - right[1] < -1.0, "{left:?} {right:?}");
    // The right wheel is the mirror image of the left one under the opposite rack.
    (0..3).for_each(|k| close(left[k], right[2 - k]));
}

#[test]
fn a_table_names_both_wheels() {
    let mut arguments = vec!["sweep", AXLE, "--axle", "--kinematic"];
    arguments.extend(RANGE);
    let text = stdout(&hardpoint(&arguments).success());
    assert!(text.starts_with("Sedan front axle, axle, iso8855 axes"), "{text}");
    assert!(text.contains("right_wheel_rate") && text.contains("anti_roll_bar_torque"), "{text}");
}

#[test]
fn the_matrix_has_the_units_and_axes_of_the_model() {
    let iso = compliance(&[AXLE, "--axle", "--travel", "10"]);
    assert_eq!(iso["rows"][0], "left_x_mm");
    assert_eq!(iso["rows"][11], "right_rz_deg");
    assert_eq!(iso["columns"][2], "left_fz_N");
    assert_eq!(iso["columns"][9], "right_mx_N·mm");
    assert_eq!(iso["at"], "wheel-center");
    assert!(iso["asymmetry"].as_f64().unwrap() < 1e-10);

    // The same model in Adams axes: C_Adams = S C S.
    let text = fs::read_to_string(AXLE).unwrap();
    let turned = text.lines().map(|line| {
        let Some((key, value)) = line.split_once(" = [") else { return line.to_owned() };
        let value = value.split_once(']').unwrap().0;
        let numbers: Result<Vec<f64>, _> = value.split(", ").map(str::parse).collect();
        let Ok(numbers) = numbers else { return line.to_owned() };
        match numbers.as_slice() {
            &[x, y, z] if !key.ends_with("stiffness") && key != "inertia" => {
                format!("{key} = [{:?}, {:?}, {z:?}]", -x, -y)
            }
            // Jxz and Jyz would change their signs, and are zero.
            _ => line.to_owned(),
        }
    });
    let turned: Vec<String> = turned.collect();
    let turned = turned.join("\n").replace("\"iso8855\"", "\"adams\"");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("adams.toml");
    fs::write(&path, turned).unwrap();
    let adams = compliance(&[path.to_str().unwrap(), "--axle", "--travel", "10"]);
    let signs = [-1.0, -1.0, 1.0, -1.0, -1.0, 1.0];
    let largest = entry(&iso, 2, 2);
    for row in 0..12 {
        for column in 0..12 {
            let expected = signs[row % 6] * signs[column % 6] * entry(&iso, row, column);
            let found = entry(&adams, row, column);
            assert!(
                (found - expected).abs() < 1e-9 * largest,
                "{row} {column}: {found} {expected}"
            );
        }
    }
}

/// One over the wheel rate of the sweep is the vertical compliance of a corner.
#[test]
fn the_matrix_agrees_with_the_wheel_rate() {
    let corner = ["models/bushed-double-wishbone.toml"];
    let text = csv(&["sweep", corner[0], "--from", "20", "--to", "20"]);
    let rate = column(&text, "wheel_rate_N/mm")[0];
    let found = compliance(&[corner[0], "--travel", "20"]);
    assert_eq!((&found["rows"][5], &found["columns"][5]), (&"rz_deg".into(), &"mz_N·mm".into()));
    close(entry(&found, 2, 2) * rate, 1.0);
}

#[test]
fn a_matrix_at_the_patches_sees_lateral_loads_lower() {
    let [center, patch] =
        ["wheel-center", "contact-patch"].map(|at| compliance(&[AXLE, "--axle", "--at", at]));
    // A force at the patch cambers the wheel, and the patch moves with it.
    assert!(entry(&patch, 1, 1) > 2.0 * entry(&center, 1, 1));
    assert_eq!(patch["at"], "contact-patch");
}

#[test]
fn the_table_of_a_corner() {
    let arguments = ["compliance", AXLE, "--kinematic", "--travel", "10", "--rack", "-5"];
    let text = stdout(&hardpoint(&arguments).success());
    // The last digit of the asymmetry is rounding.
    let (asymmetry, rest): (Vec<_>, Vec<_>) =
        text.lines().partition(|line| line.starts_with("asymmetry"));
    assert_eq!(asymmetry.len(), 1);
    insta::assert_snapshot!(rest.join("\n"));
}

#[test]
fn wrong_usage_is_told() {
    let sedan = "models/double-wishbone.toml";
    for (arguments, code, message) in [
        (&["sweep", AXLE, "--event", "opposite"][..], 2, "add --axle"),
        (
            &["sweep", AXLE, "--axle", "--wheels", "left"],
            2,
            "--wheels belongs to --axle with --event load",
        ),
        (&["sweep", AXLE, "--axle", "--side", "left"], 2, "cannot be used with"),
        (&["sweep", AXLE, "--axle", "--event", "parallel", "--travel", "3"], 2, "--from and --to"),
        (&["sweep", AXLE, "--load", "left.fx=3"], 2, "names a wheel of an axle"),
        (&["sweep", AXLE, "--axle", "--load", "front.fx=3"], 2, "is not understood"),
        (&["sweep", "models/four-bar.toml", "--axle"], 2, "--axle belongs to suspensions"),
        (&["compliance", "models/four-bar.toml"], 2, "this file is a mechanism"),
        (&["compliance", sedan], 3, "there is no compliance: with the wheel let go, nothing holds"),
        (&["compliance", sedan, "--axle"], 3, "there is no compliance"),
        (&["compliance", AXLE, "--travel", "nan"], 2, "--travel is not a finite number"),
        (
            &["compliance", AXLE, "--axle", "--kinematic", "--travel", "400"],
            3,
            "no compliance was found",
        ),
        (&["compliance", AXLE, "-o", AXLE], 2, "would overwrite the model"),
    ] {
        let assert = hardpoint(arguments).code(code);
        let found = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(found.contains(message), "{arguments:?}: {found}");
    }
}

/// The states of Adams/Car, both wheels, by its definitions, as a user gets them: 1e-6 mm and 1e-6°.
#[test]
fn adams_states_come_by_its_convention() {
    let text = include_str!("reference/adams-tr-front.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let reference: Vec<HashMap<String, f64>> =
        reader.deserialize().map(|row| row.expect("the table is well-formed")).collect();
    let mut compared = 0;
    for rack in ["-5", "0", "5"] {
        let arguments = ["sweep", "models/adams-tr-front.toml", "--axle", "--convention", "adams"];
        let columns = "travel,rack,camber,toe,wheel_center_x,wheel_center_y,wheel_center_z";
        let event = ["--from", "-10", "--to", "10", "--step", "10", "--rack", rack];
        let more = ["--columns", columns, "--format", "csv"];
        let table = stdout(&hardpoint(&[&arguments[..], &event, &more].concat()).success());
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        for row in reader.deserialize::<HashMap<String, f64>>() {
            let row = row.expect("every cell is a number");
            let expected = reference.iter().find(|expected| {
                expected["wheel_travel_mm"] == row["left_travel_mm"]
                    && expected["rack_displacement_mm"] == row["rack_mm"]
            });
            let expected = expected.expect("Adams has the state");
            for side in ["left", "right"] {
                for (ours, theirs) in [
                    ("camber_deg", "camber_deg"),
                    ("toe_deg", "toe_deg"),
                    ("wheel_center_x_mm", "wc_x_mm"),
                    ("wheel_center_y_mm", "wc_y_mm"),
                    ("wheel_center_z_mm", "wc_z_mm"),
                ] {
                    let found = row[&format!("{side}_{ours}")];
                    let expected = expected[&format!("{side}_{theirs}")];
                    assert!((found - expected).abs() <= 1e-6, "{side}_{ours}: {found}, {expected}");
                    compared += 1;
                }
            }
        }
    }
    assert_eq!(compared, 9 * 2 * 5);
}
