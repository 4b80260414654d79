//! `hardpoint rig` and `hardpoint report` as a user meets them.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use program::{hardpoint, stderr, stdout};

fn rows(path: &Path) -> Vec<HashMap<String, String>> {
    let text = fs::read_to_string(path).expect("the file was written");
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.deserialize().map(|row| row.expect("the table is well-formed")).collect()
}

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    row.get(column).unwrap_or_else(|| panic!("no column {column}")).parse().expect(column)
}

/// All events of an axle with forces, each with all factors; a stage shows what the sweep of the same
/// event shows.
#[test]
fn programme_fills_a_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sedan");
    let arguments = ["rig", "models/sedan-axle.toml", "--travel", "40", "--force", "800"];
    let output = ["-o", path.to_str().expect("a name")];
    let done = hardpoint(&[&arguments[..], &output].concat()).success();
    assert!(stderr(&done).contains("376 states of 20 events"), "{}", stderr(&done));
    for (file, states) in [
        ("parallel", 17),
        ("opposite", 17),
        ("left", 17),
        ("right", 17),
        ("roll", 21),
        ("roll-load", 21),
        ("steer", 17),
        ("envelope", 45),
        ("braking-parallel", 17),
        ("braking-left", 17),
        ("braking-opposed", 17),
        ("traction-parallel", 17),
        ("traction-opposed", 17),
        ("lateral-parallel", 17),
        ("lateral-left", 17),
        ("lateral-opposed", 17),
        ("aligning-parallel", 17),
        ("aligning-left", 17),
        ("aligning-opposed", 17),
        ("overturning-opposed", 17),
    ] {
        let rows = rows(&path.join(format!("{file}.csv")));
        assert_eq!(rows.len(), states, "{file}");
        let columns = ["left_toe_deg", "right_camber_deg", "left_ride_steer_deg/m", "track_mm"];
        for column in columns {
            number(&rows[0], column);
        }
    }
    for file in ["factors.csv", "compliance.csv"] {
        assert!(!rows(&path.join(file)).is_empty(), "{file}");
    }
    let summary = fs::read_to_string(path.join("summary.txt")).expect("a summary");
    assert!(summary.contains("376 states in all") && summary.contains("+ toe-in"), "{summary}");

    // The wheels carry the same at all lateral forces, and stand where a sweep puts them.
    let lateral = rows(&path.join("lateral-opposed.csv"));
    let event = ["--event", "load", "--vary", "fy", "--wheels", "opposed", "--vertical", "force"];
    let range = ["--from", "-800", "--to", "800", "--step", "100", "--format", "csv"];
    let sweep = ["sweep", "models/sedan-axle.toml", "--axle", "--columns", "toe,wheel_load"];
    let sweep = stdout(&hardpoint(&[&sweep[..], &event, &range].concat()).success());
    let mut reader = csv::Reader::from_reader(sweep.as_bytes());
    for (row, expected) in lateral.iter().zip(reader.deserialize()) {
        let expected: HashMap<String, String> = expected.expect("the table is well-formed");
        for column in ["left_toe_deg", "right_toe_deg", "left_wheel_load_N", "right_wheel_load_N"] {
            let (found, expected) = (number(row, column), number(&expected, column));
            assert!((found - expected).abs() <= 1e-7 * expected.abs().max(1.0), "{column}");
        }
    }
}

/// Without forces there are the kinematic events only; what is out of reach is told, and the rest is written.
#[test]
fn programme_tells_what_was_not_reached() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("lotus");
    let output = ["-o", path.to_str().expect("a name")];
    let arguments = ["rig", "models/lotus-front.toml", "--travel", "400"];
    let failed = hardpoint(&[&arguments[..], &output].concat()).code(3);
    let text = stderr(&failed);
    assert!(text.contains("parallel: ") && text.contains("states were reached"), "{text}");
    let parallel = rows(&path.join("parallel.csv"));
    assert!(!parallel.is_empty() && parallel.len() < 17);
    assert_eq!(rows(&path.join("roll.csv")).len(), 21);
    assert!(!path.join("lateral-left.csv").exists());
    let summary = fs::read_to_string(path.join("summary.txt")).expect("a summary");
    assert!(summary.contains("of 17   states"), "{summary}");
}

#[test]
fn programme_refuses_what_it_cannot_do() {
    for (arguments, words) in [
        (&["models/four-bar.toml"][..], "this file is a mechanism"),
        (&["models/lotus-front.toml", "--travel", "-3"], "--travel is not a positive number"),
        (&["models/lotus-front.toml", "-o", "Cargo.toml"], "no folder"),
    ] {
        let failed = hardpoint(&[&["rig"], arguments].concat()).code(2);
        assert!(stderr(&failed).contains(words), "{}", stderr(&failed));
    }
}

/// The printed report of Lotus, state by state, beside which it can be laid.
#[test]
fn report_has_the_tables_of_lotus() {
    let steps = ["--bump", "37.5", "--bump-step", "7.5", "--rack", "45", "--rack-step", "4.5"];
    let done = hardpoint(&[&["report", "models/lotus-front.toml"][..], &steps].concat()).success();
    assert_eq!(stderr(&done), "");
    insta::assert_snapshot!(stdout(&done));
}

/// What cannot be reached is told in the units of the model, and nothing of an earlier run stays as if it
/// were of this one.
#[test]
fn programme_tells_what_is_beyond_the_limits_of_the_rack() {
    let model = fs::read_to_string("models/double-wishbone.toml").expect("the model");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("limited.toml");
    fs::write(&path, format!("{model}\n[steering]\nlimits = [-20.0, 20.0]\n")).expect("a file");
    let out = folder.path().join("out");
    fs::create_dir(&out).expect("a folder");
    fs::write(out.join("compliance.csv"), "of an earlier run").expect("a file");
    let words = [&path, &out].map(|path| path.to_str().expect("a name"));
    let told = hardpoint(&["rig", words[0], "--rack", "40", "-o", words[1]]).code(3);
    let told = stderr(&told);
    assert!(told.contains("envelope: rack -40 mm: stopped at"), "{told}");
    assert!(out.join("summary.txt").exists() && !out.join("compliance.csv").exists());
}

/// The programme and the check belong to the same car as the sweeps.
#[test]
fn commands_set_the_car_otherwise() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a name");
    let model = "models/sedan-setup.toml";
    let short = ["--kinematic", "--travel", "10", "--roll", "0.5", "--rack", "5", "--force", "50"];
    let set = ["--set", "toe=0.4"];
    hardpoint(&[&["rig", model, "-o", out], &short[..], &set].concat()).success();
    let steer = rows(&folder.path().join("steer.csv"));
    let toe = number(&steer[steer.len() / 2], "left_toe_deg");
    assert!((toe - 0.4).abs() < 1e-6, "{toe}");
    for command in ["check", "report"] {
        let shown = stdout(&hardpoint(&[&[command, model], &set[..]].concat()).success());
        assert!(shown.contains("0.4000"), "{shown}");
        let told = stderr(&hardpoint(&[command, model, "--set", "toes=1"]).code(2));
        assert!(told.contains("`toes`"), "{told}");
    }
    let mechanism = hardpoint(&["check", "models/four-bar.toml", "--set", "toe=1"]).code(2);
    assert!(stderr(&mechanism).contains("--set belongs to suspensions"));
}

/// A report of an axle whose sides differ shows both.
#[test]
fn report_has_the_points_of_both_files() {
    let shown = stdout(&hardpoint(&["report", "tests/fixtures/left-sedan.toml"]).success());
    for title in ["HARD POINTS, left side", "HARD POINTS, right side"] {
        assert!(shown.contains(title), "{shown}");
    }
    assert!(shown.contains("-690.000     108.000 mm"), "{shown}");
    let mirrored = stdout(&hardpoint(&["report", "models/lotus-front.toml"]).success());
    assert_eq!(mirrored.matches("HARD POINTS").count(), 1);
}
