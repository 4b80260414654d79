//! `hardpoint sensitivity`, as a user meets it.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use program::{hardpoint, json, stderr, stdout};

const SEDAN: &str = "models/double-wishbone.toml";
const AXLE: &str = "models/sedan-axle.toml";

#[test]
fn the_table_ranks_parameters_with_unit_and_sign() {
    let options = ["--factor", "bump_steer,rc_height,toe", "--travel", "20", "--top", "5"];
    let done = hardpoint(&[&["sensitivity", SEDAN][..], &options].concat()).success();
    assert_eq!(stderr(&done), "");
    insta::assert_snapshot!(stdout(&done));
}

#[test]
fn the_table_of_an_axle_has_stiffnesses_and_both_wheels() {
    let options = ["--axle", "--factor", "wheel_rate,roll_rate", "--top", "4", "--way", "adjoint"];
    let done = hardpoint(&[&["sensitivity", AXLE][..], &options].concat()).success();
    insta::assert_snapshot!(stdout(&done));
}

#[test]
fn the_table_of_an_event_has_its_ends_and_the_largest() {
    let event = ["--event", "travel", "--from", "-60", "--to", "60", "--step", "20"];
    let options = ["--factor", "toe", "--parameter", "tierod_inner,tierod_outer"];
    let done = hardpoint(&[&["sensitivity", SEDAN][..], &event, &options].concat()).success();
    insta::assert_snapshot!(stdout(&done));
}

#[test]
fn usual_factors_are_those_that_the_suspension_has() {
    let text = stdout(&hardpoint(&["sensitivity", SEDAN]).success());
    for factor in ["toe", "rc_height", "anti_dive", "motion_ratio"] {
        assert!(text.contains(&format!("\n{factor} ")), "{factor}");
    }
    for factor in ["anti_squat", "wheel_rate", "roll_rate"] {
        assert!(!text.contains(&format!("\n{factor} ")), "{factor}");
    }
}

#[test]
fn parameters_are_listed_with_unit_and_sign() {
    let done = hardpoint(&["sensitivity", AXLE, "--axle", "--parameters"]).success();
    let text = stdout(&done);
    let line = |name: &str| {
        let line = text.lines().find(|line| line.split_whitespace().next() == Some(name));
        line.unwrap_or_else(|| panic!("{name} is not in\n{text}")).split_whitespace().nth(1)
    };
    assert_eq!(line("lca_front.x"), Some("mm"));
    assert_eq!(line("wheel.toe"), Some("deg"));
    assert_eq!(line("forces.spring.stiffness"), Some("N/mm"));
    assert_eq!(line("bushings.lca_rear_bushing.rotational_stiffness.z"), Some("N·mm/deg"));
    assert_eq!(line("anti_roll_bar.stiffness"), Some("N·mm/deg"));
    let rigid = ["sensitivity", AXLE, "--axle", "--parameters", "--kinematic"];
    assert!(!stdout(&hardpoint(&rigid).success()).contains("bushings."));
}

/// The matrix of one state and the lines of an event have the same numbers, in the same units as the JSON.
#[test]
fn csv_and_json_have_the_same_derivatives() {
    let base = ["sensitivity", SEDAN, "--factor", "bump_steer,toe"];
    fn with<'a>(base: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
        [base, more].concat()
    }
    let at = ["--travel", "20", "--format", "csv"];
    let matrix = stdout(&hardpoint(&with(&base, &at)).success());
    let event = ["--event", "travel", "--from", "-20", "--to", "20", "--step", "20"];
    let lines = stdout(&hardpoint(&with(&with(&base, &event), &["--format", "csv"])).success());
    let json = json(&with(&base, &event));
    let mut matrix = csv::Reader::from_reader(matrix.as_bytes());
    let headers: Vec<String> = matrix.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(headers, ["parameter", "per", "bump_steer_deg/m", "toe_deg"]);
    let rows: Vec<csv::StringRecord> = matrix.records().map(Result::unwrap).collect();
    let outer = rows.iter().position(|row| &row[0] == "tierod_outer.z").unwrap();
    assert_eq!(&rows[outer][1], "mm");
    let by: f64 = rows[outer][2].parse().unwrap();
    assert!((by + 0.980_92).abs() < 1e-4, "{by}");

    let mut lines = csv::Reader::from_reader(lines.as_bytes());
    let lines: Vec<csv::StringRecord> = lines.records().map(Result::unwrap).collect();
    assert_eq!(lines.len(), 3 * 2 * rows.len());
    let line = lines
        .iter()
        .find(|line| line[0] == *"20" && line[1] == *"bump_steer" && line[4] == *"tierod_outer.z");
    let line = line.unwrap();
    assert_eq!((&line[3], &line[6]), ("deg/m", "deg/m per mm"));
    let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} for {b}");
    near(line[5].parse().unwrap(), by);

    assert_eq!(json["event"], "travel");
    assert_eq!(json["states"][2]["event_value"], 20.0);
    assert_eq!(json["parameters"][outer]["name"], "tierod_outer.z");
    assert_eq!(json["factors"][0]["derivative_units"][outer], "deg/m per mm");
    near(json["states"][2]["derivatives"][0][outer].as_f64().unwrap(), by);
}

#[test]
fn both_ways_give_the_same_text() {
    let options = ["--factor", "toe,wheel_rate,ride_rate", "--load", "fy=900", "--travel", "8"];
    let text = |way: &str| {
        let arguments = [&["sensitivity", AXLE, "--way", way][..], &options].concat();
        stdout(&hardpoint(&arguments).success())
    };
    assert_eq!(text("direct"), text("adjoint"));
}

/// With its load constant the wheel goes down where the spring gets weaker, so its toe changes.
#[test]
fn wheels_that_forces_hold_follow_the_spring() {
    let of_spring = |vertical: &[&str]| {
        let base = ["sensitivity", AXLE, "--kinematic", "--factor", "toe"];
        let options = ["--parameter", "forces.spring.stiffness"];
        json(&[&base[..], &options, vertical].concat())["states"][0]["derivatives"][0][0].as_f64()
    };
    assert!(of_spring(&[]).unwrap().abs() < 1e-12);
    assert!(of_spring(&["--vertical", "force", "--wheel-force", "4500"]).unwrap().abs() > 1e-3);
}

#[test]
fn what_is_not_understood_is_said() {
    let told = |arguments: &[&str], code: i32| {
        stderr(&hardpoint(&[&["sensitivity"], arguments].concat()).failure().code(code))
    };
    let unknown = told(&[SEDAN, "--parameter", "lca_frnt.x"], 2);
    assert!(unknown.contains("did you mean `lca_front.x`?"), "{unknown}");
    assert!(told(&[SEDAN, "--factor", "cambr"], 2).contains("did you mean `camber`?"));
    assert!(told(&["models/four-bar.toml"], 2).contains("this file is a mechanism"));
    assert!(told(&[SEDAN, "--event", "envelope"], 2).contains("not over a field"));
    assert!(told(&[SEDAN, "--event", "travel", "--step", "0"], 2).contains("--step is zero"));
    let far = ["--event", "travel", "--from", "0", "--to", "400", "--step", "100"];
    let stopped = told(&[&[SEDAN, "--factor", "toe"], &far[..]].concat(), 3);
    assert!(stopped.contains("states have derivatives"), "{stopped}");
    let done = hardpoint(&["sensitivity", SEDAN, "--factor", "wheel_rate"]).success();
    assert!(stderr(&done).contains("warning: `wheel_rate` needs forces"), "{}", stderr(&done));
}
