//! Steering wheels, limits and whole axles on the command line.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use program::{column, hardpoint, json, stderr, stdout};

const MODEL: &str = "models/subframe-axle.toml";

fn csv(arguments: &[&str]) -> String {
    stdout(&hardpoint(&[arguments, &["--format", "csv"]].concat()).success())
}

#[track_caller]
fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{found} {expected}");
}

#[test]
fn steering_goes_by_the_steering_wheel() {
    let wheel = ["sweep", MODEL, "--event", "steer", "--steer-by", "wheel"];
    let text = csv(&[&wheel[..], &["--from", "-180", "--to", "180", "--step", "90"]].concat());
    let angles = column(&text, "steering_wheel_angle_deg");
    for (angle, expected) in angles.iter().zip([-180.0, -90.0, 0.0, 90.0, 180.0]) {
        close(*angle, expected);
    }
    let rack = column(&text, "rack_mm");
    close(rack[4], -26.0);
    // To the left is toe-out of the left wheel.
    let toe = column(&text, "toe_deg");
    assert!(toe[0] > 5.0 && toe[4] < -5.0, "{toe:?}");
    // The whole way is from limit to limit, by either.
    let whole = column(&csv(&wheel), "rack_mm");
    close(whole[0], 60.0);
    close(*whole.last().unwrap(), -60.0);
    let whole = column(&csv(&["sweep", MODEL, "--event", "steer"]), "rack_mm");
    close(whole[0], -60.0);
    close(*whole.last().unwrap(), 60.0);
}

#[test]
fn the_steering_wheel_is_held_as_the_rack_is() {
    for command in [&["factors", MODEL][..], &["equilibrium", MODEL, "--axle"]] {
        let by_rack = stdout(&hardpoint(&[command, &["--rack", "-13"]].concat()).success());
        let by_wheel =
            stdout(&hardpoint(&[command, &["--steering-wheel", "90"]].concat()).success());
        assert_eq!(by_rack, by_wheel);
    }
}

#[test]
fn limits_and_missing_ratios_are_told() {
    let beyond = hardpoint(&["sweep", MODEL, "--event", "steer", "--from", "50", "--to", "70"]);
    let told = stderr(&beyond.code(3));
    assert!(told.contains("rack = 60 mm on the way to 65 mm: rack has a limit at 60 mm"), "{told}");
    assert!(told.contains("3 of 5 states"), "{told}");
    let told = stderr(&hardpoint(&["equilibrium", MODEL, "--rack", "61"]).code(3));
    assert!(told.contains("limit at 60 mm"), "{told}");
    let plain = "models/sedan-axle.toml";
    let told = stderr(&hardpoint(&["factors", plain, "--steering-wheel", "90"]).code(2));
    assert!(told.contains("rack_per_turn"), "{told}");
    let steer = ["sweep", plain, "--event", "steer", "--steer-by", "wheel"];
    assert!(stderr(&hardpoint(&steer).code(2)).contains("rack_per_turn"));
    let travel = ["sweep", MODEL, "--steer-by", "wheel"];
    assert!(stderr(&hardpoint(&travel).code(2)).contains("--event steer"));
    let mechanism = ["equilibrium", "models/pendulum.toml", "--steering-wheel", "3"];
    assert!(stderr(&hardpoint(&mechanism).code(2)).contains("--steering-wheel belongs"));
}

#[test]
fn a_ratio_of_the_wrong_sign_is_told() {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/models/subframe-axle.toml"));
    let text = text.unwrap().replace("rack_per_turn = -52.0", "rack_per_turn = 52.0");
    let path = concat!(env!("CARGO_TARGET_TMPDIR"), "/wrong-ratio.toml");
    std::fs::write(path, text).unwrap();
    for side in ["left", "right"] {
        let told = stderr(&hardpoint(&["check", path, "--side", side]).success());
        assert!(told.contains("change the sign of `rack_per_turn`"), "{told}");
        let told = stderr(&hardpoint(&["check", MODEL, "--side", side]).success());
        assert_eq!(told, "");
    }
}

#[test]
fn whole_axles_are_checked_and_rest() {
    let text = stdout(&hardpoint(&["check", "models/sedan-axle.toml", "--axle"]).success());
    for part in [
        "both, right the mirror image",
        "left_lca_front_bushing",
        "anti_roll_bar",
        "11 moving bodies",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let pair = ["check", "tests/fixtures/left-sedan.toml", "--axle"];
    let text = stdout(&hardpoint(&pair).success());
    assert!(text.contains("both, left from this file"), "{text}");
    assert!(text.contains("no redundant equations, no free motions"), "{text}");
    let loaded = ["equilibrium", "models/sedan-axle.toml", "--axle", "--load", "left.fz=300"];
    let found = json(&loaded);
    let load = |side: &str| found[format!("{side}_wheel")]["wheel_load_N"].as_f64().unwrap();
    // The bar lets the right wheel carry a part.
    assert!(load("left") < load("right"), "{found}");
    let alone = json(&["equilibrium", "models/sedan-axle.toml", "--load", "fz=300"]);
    assert!(alone["wheel"]["wheel_load_N"].as_f64().unwrap() > 0.0);
    let told = stderr(&hardpoint(&["check", "models/pendulum.toml", "--axle"]).code(2));
    assert!(told.contains("--axle belongs to suspensions"), "{told}");
}

#[test]
fn an_axle_settles_where_it_rests() {
    let axle = ["settle", "models/sedan-axle.toml", "--axle", "--load", "left.fz=300"];
    let found = json(&[&axle[..], &["--seconds", "4", "--tolerance", "1e-6"]].concat());
    let rows = found["rows"].as_array().unwrap();
    for side in ["left", "right"] {
        let name = format!("{side} wheel centre, z");
        let row = rows.iter().find(|row| row["quantity"] == name).expect(&name);
        assert!(row["quasi_static"].as_f64().unwrap() > -119.0, "{row}");
        assert!(row["difference"].as_f64().unwrap().abs() < 0.01, "{row}");
    }
}

#[test]
fn the_other_side_of_a_pair_is_its_own_file() {
    let factors = |side: &str| csv(&["factors", "tests/fixtures/left-sedan.toml", "--side", side]);
    let own = csv(&["factors", "tests/fixtures/right-sedan.toml"]);
    assert_eq!(factors("right"), own);
    assert_ne!(factors("left"), own);
}
