//! `hardpoint import` and `hardpoint export` as a user runs them.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use std::fs;

use program::{hardpoint, stderr, stdout};

const SUBSYSTEM: &str = "tests/fixtures/import/car.cdb/subsystems.tbl/front.sub";

#[test]
fn an_import_is_a_model_and_tells_what_is_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("front.toml").display().to_string();
    let run = hardpoint(&["import", SUBSYSTEM, "-o", &model, "--wheel-radius", "310"]).success();
    let told = stderr(&run);
    assert!(told.contains("line 24: the point `drive_shaft_inr`"), "{told}");
    assert!(!told.contains("placeholder"), "{told}");
    assert!(stdout(&run).is_empty());
    let checked = stdout(&hardpoint(&["check", &model]).success());
    assert!(
        checked.contains("wheel radius   310 mm") && checked.contains("ride_spring"),
        "{checked}"
    );
    hardpoint(&["sweep", &model, "--kinematic", "--from", "-60", "--to", "60"]).success();

    // To CSV and to JSON and back: the same model to the last digit.
    let value = |model: &str| {
        let text = stdout(&hardpoint(&["export", model, "--to", "json"]).success());
        serde_json::from_str::<serde_json::Value>(&text).unwrap()
    };
    let json = folder.path().join("front.json").display().to_string();
    hardpoint(&["export", &model, "--to", "json", "-o", &json]).success();
    let again = folder.path().join("again.toml").display().to_string();
    hardpoint(&["import", &json, "-o", &again]).success();
    assert_eq!(value(&again), value(&model));
    let csv = hardpoint(&["export", &model, "--to", "csv"]).success();
    assert!(stdout(&csv).contains("\nlca_outer,1.25,-750.0,100.0\n"), "{}", stdout(&csv));
    assert!(
        stderr(&csv).contains("`forces`") && stderr(&csv).contains("`bushings`"),
        "{}",
        stderr(&csv)
    );
}

#[test]
fn without_an_option_the_model_goes_to_the_terminal() {
    let run = hardpoint(&["import", "tests/fixtures/import/points.csv"]).success();
    assert!(stdout(&run).contains("architecture = \"double-wishbone\""));
    assert!(
        stderr(&run).contains("to check, because the file does not say it"),
        "{}",
        stderr(&run)
    );
}

#[test]
fn a_source_is_never_overwritten_and_nothing_is_half_written() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("points.csv");
    fs::write(&source, "lca_front,1,2,3\n").unwrap();
    let name = source.display().to_string();
    let run = hardpoint(&["import", &name, "-o", &name]).failure().code(2);
    assert!(stderr(&run).contains("-o would overwrite"), "{}", stderr(&run));

    let target = folder.path().join("model.toml");
    fs::write(&target, "old").unwrap();
    let run = hardpoint(&["import", &name, "-o", &target.display().to_string()]).failure().code(1);
    assert!(stderr(&run).contains("--architecture"), "{}", stderr(&run));
    assert_eq!(fs::read_to_string(&target).unwrap(), "old");
    assert_eq!(fs::read_to_string(&source).unwrap(), "lca_front,1,2,3\n");
}

#[test]
fn a_mistake_is_shown_at_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("points.csv");
    fs::write(&source, "name,x,y,z\nlca_front,1,2,3\nlca_rear,1,b,3\n").unwrap();
    let run = hardpoint(&["import", &source.display().to_string()]).failure().code(1);
    let told = stderr(&run);
    assert!(
        told.contains("points.csv:3:1")
            && told.contains("`b` in the row of `lca_rear` is no number"),
        "{told}"
    );
}

#[test]
fn wrong_usage_is_told() {
    for (arguments, words) in [
        (&["import", "nothing.sub"][..], "cannot be read"),
        (&["import", SUBSYSTEM, "--database", "x"], "NAME=FOLDER"),
        (&["import", SUBSYSTEM, "--wheel-radius", "-1"], "positive"),
        (&["import", SUBSYSTEM, "--architecture", "no.toml"], "cannot be read"),
        (&["export", "models/four-bar.toml"], "--to"),
    ] {
        let run = hardpoint(arguments).failure().code(2);
        assert!(stderr(&run).contains(words), "{arguments:?}: {}", stderr(&run));
    }
    let run = hardpoint(&["export", "models/four-bar.toml", "--to", "csv"]).failure().code(1);
    assert!(stderr(&run).contains("--to json"), "{}", stderr(&run));
}
