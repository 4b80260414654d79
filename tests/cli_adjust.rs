//! Adjusters and the static state as a user meets them.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use program::{column, hardpoint, json, stderr, stdout};

const SETUP: &str = "models/sedan-setup.toml";

#[test]
fn check_lists_what_the_adjusters_are_set_to() {
    let done = hardpoint(&["check", SETUP]).success();
    assert_eq!(stderr(&done), "");
    insta::assert_snapshot!(stdout(&done));
}

/// The value of an entry with this name in one of the lists of a factor sheet.
fn entry(sheet: &serde_json::Value, list: &str, name: &str) -> f64 {
    let entries = sheet[list].as_array().expect("a list");
    let found = entries.iter().find(|entry| entry["name"] == name);
    found.unwrap_or_else(|| panic!("no {name}"))["value"].as_f64().expect("a number")
}

#[test]
fn sheet_has_adjusters_and_takes_other_targets() {
    let sheet = json(&["factors", SETUP]);
    let other = json(&["factors", SETUP, "--set", "toe=-0.3", "--set", "wheel_load=4200"]);
    for (sheet, toe, load) in [(&sheet, 0.15, 4000.0), (&other, -0.3, 4200.0)] {
        assert!((entry(sheet, "factors", "toe") - toe).abs() < 1e-9);
        assert!((entry(sheet, "factors", "wheel_load") - load).abs() < 1e-5);
    }
    let seat = |sheet| entry(sheet, "adjustments", "spring_seat");
    assert!(seat(&other) > seat(&sheet) + 1.0, "more preload carries more");
    assert_eq!(sheet["adjustments"][0]["unit"], "mm");
    let csv = stdout(&hardpoint(&["factors", SETUP, "--format", "csv"]).success());
    assert!(csv.lines().any(|line| line.starts_with("tie_rod_length,-1.")), "{csv}");
}

/// All commands start from the static state.
#[test]
fn commands_start_from_the_static_state() {
    let range = ["--from", "-20", "--to", "20", "--step", "20", "--format", "csv"];
    let sweep =
        |more: &[&str]| stdout(&hardpoint(&[&["sweep", SETUP], more, &range].concat()).success());
    let text = sweep(&["--columns", "toe,camber,half_track_change"]);
    assert!((column(&text, "toe_deg")[1] - 0.15).abs() < 1e-9);
    assert!(column(&text, "half_track_change_mm")[1].abs() < 1e-9);
    let text = sweep(&["--axle", "--event", "opposite", "--columns", "toe,travel"]);
    for side in ["left", "right"] {
        assert!((column(&text, &format!("{side}_toe_deg"))[1] - 0.15).abs() < 1e-9);
    }
    for command in [
        &["compliance", SETUP, "--axle"][..],
        &["equilibrium", SETUP],
        &["equilibrium", SETUP, "--travel", "0"],
    ] {
        hardpoint(command).success();
    }
}

#[test]
fn wrong_values_are_told() {
    let told = |arguments: &[&str], code: i32| {
        let done = hardpoint(&[&["factors", SETUP], arguments].concat()).failure().code(code);
        stderr(&done)
    };
    assert!(told(&["--set", "toe"], 2).contains("write a name and a number, such as toe=0.2"));
    assert!(told(&["--set", "toe=much"], 2).contains("--set toe=much: the value is not a number"));
    assert!(told(&["--set", "camer=1"], 2).contains("did you mean `camber`"));
    let far = told(&["--set", "toe=5"], 1);
    assert!(far.contains("toe cannot be brought to 5.0000 deg by `tie_rod_length`"), "{far}");
    assert!(far.contains("its limit"), "{far}");
    let mechanism = hardpoint(&["equilibrium", "models/anti-roll-bar.toml", "--set", "toe=1"]);
    assert!(stderr(&mechanism.failure().code(2)).contains("--set belongs to suspensions"));
}
