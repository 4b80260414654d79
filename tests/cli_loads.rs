//! The command line on models with forces, as a user meets it.

#[path = "common/program.rs"]
mod program;

use std::fs;
use std::path::Path;

use program::{hardpoint, json, stderr, stdout};

/// Writes a file into a folder and returns its name.
fn write(folder: &Path, text: &str) -> String {
    let path = folder.join("model.toml");
    fs::write(&path, text).expect("the folder takes a file");
    path.to_str().expect("a plain name").to_owned()
}

const QUARTER_CAR: &str = "models/quarter-car.toml";

/// An arm of 1 m along x with a mass of 1 kg at its end, held by a driver about y.
const ARM: &str = r#"
format = 1
name = "Arm"
ground = "ground"
gravity = 9.81
[units]
length = "m"
angle = "deg"
force = "N"
mass = "kg"
[points]
pivot = [0.0, 0.0, 0.0]
end = [1.0, 0.0, 0.0]
[bodies.arm]
mass = 1.0
center_of_mass = [1.0, 0.0, 0.0]
inertia = [0.0, 0.0, 0.0]
[[joints]]
name = "hinge"
kind = "revolute"
between = ["ground", "arm"]
at = "pivot"
axis = "y"
[[drivers]]
name = "angle"
kind = "rotation"
between = ["ground", "arm"]
axis = "y"
"#;

#[test]
fn no_result_takes_the_place_of_its_model() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = fs::read_to_string(QUARTER_CAR).expect("the model is there");
    let model = write(folder.path(), &text);
    for command in ["equilibrium", "settle", "sweep"] {
        let refused = hardpoint(&[command, &model, "-o", &model]).failure().code(2);
        assert!(stderr(&refused).contains("would overwrite the model"), "{command}");
        assert_eq!(fs::read_to_string(&model).expect("the model is there"), text, "{command}");
    }
}

#[test]
fn options_of_suspensions_are_refused_for_mechanisms() {
    let bar = "models/anti-roll-bar.toml";
    let options: [&[&str]; 4] = [
        &["--load", "fz=1000"],
        &["--kinematic"],
        &["--drive", "contact-patch"],
        &["--at", "wheel-center"],
    ];
    for option in options {
        for command in ["equilibrium", "settle"] {
            let refused = hardpoint(&[&[command, bar], option].concat()).failure().code(2);
            assert!(stderr(&refused).contains(option[0]), "{}", stderr(&refused));
        }
        let sweep = ["sweep", "models/four-bar.toml", "--from", "0", "--to", "10"];
        hardpoint(&[&sweep, option].concat()).failure().code(2);
    }
    for command in ["equilibrium", "settle"] {
        hardpoint(&[command, bar, "--fixed-chassis"]).failure().code(2);
    }
}

/// Gravity turns the arm with 9.81 N·m about +y; the driver holds against it. The rack of a
/// suspension balances the tie rod.
#[test]
fn what_drivers_hold_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let arm = json(&["equilibrium", &write(folder.path(), ARM)]);
    let torque = arm["drivers"]["angle_torque_N·m"].as_f64().expect("a number");
    assert!((torque + 9.81).abs() < 1e-12, "{torque}");

    let car = json(&["equilibrium", QUARTER_CAR]);
    let rack = car["drivers"]["rack_force_N"].as_f64().expect("a number");
    let rod = car["joints"]["tierod_inner_joint"]["force"][1].as_f64().expect("a number");
    assert!(rack.abs() > 10.0 && (rack - rod).abs() < 1e-9, "{rack} {rod}");
    let sweep = stdout(&hardpoint(&["sweep", QUARTER_CAR, "--format", "csv"]).success());
    assert!(sweep.lines().next().is_some_and(|header| header.contains(",rack_force_N,")));
}

#[test]
fn columns_of_parts_with_one_name_are_told_apart() {
    let folder = tempfile::tempdir().expect("a folder");
    let bushing = r#"
[[forces]]
name = "arm"
kind = "bushing"
between = ["ground", "arm"]
at = "end"
stiffness = [1.0, 1.0, 1.0]
"#;
    let model = write(folder.path(), &format!("{ARM}{bushing}"));
    let arguments =
        ["sweep", &model, "--from", "0", "--to", "90", "--step", "90", "--format", "csv"];
    let text = stdout(&hardpoint(&arguments).success());
    let mut header: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
    let columns = header.len();
    header.sort_unstable();
    header.dedup();
    assert_eq!(header.len(), columns, "{text}");
    let report = stdout(&hardpoint(&["equilibrium", &model]).success());
    let bushing = report.lines().find(|line| line.ends_with("on arm") && line.contains('–'));
    assert!(bushing.is_some_and(|line| line.matches("0.0000").count() == 3), "{report}");
}

/// Names such as those that the rig once gave to its own forces.
#[test]
fn forces_may_have_any_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = fs::read_to_string(QUARTER_CAR).expect("the model is there");
    let named = text.replace("name = \"spring\"", "name = \"load_fx\"");
    let model = write(folder.path(), &named);
    assert!(stdout(&hardpoint(&["check", &model]).success()).contains("load_fx"));
    hardpoint(&["equilibrium", &model, "--load", "fx=100"]).success();
}

#[test]
fn the_travel_of_a_free_wheel_is_that_of_its_drive() {
    let travel = |drive: &str| {
        let car = json(&["equilibrium", QUARTER_CAR, "--drive", drive]);
        car["wheel"]["travel_mm"].as_f64().expect("a number")
    };
    let (center, patch) = (travel("wheel-center"), travel("contact-patch"));
    // The radius is 326.6 mm, camber goes from −0.5° to −0.887863946°.
    let lower = 326.6 * ((-0.5_f64).to_radians().cos() - (-0.887_863_946_f64).to_radians().cos());
    assert!(lower > 0.02 && (patch - center - lower).abs() < 1e-6, "{center} {patch} {lower}");
}

/// The pose of motions without stiffness or inertia is told in axes that may not be the model's.
#[test]
fn the_axes_of_numbers_in_messages_are_told() {
    let failed = hardpoint(&["settle", "models/compliant-corner.toml"]).failure().code(3);
    assert!(stderr(&failed).contains("(numbers in iso8855 axes)"), "{}", stderr(&failed));
}

#[test]
fn a_load_that_lifts_the_tyre_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = fs::read_to_string(QUARTER_CAR).expect("the model is there");
    let model = write(folder.path(), &text.replace("lift_off = false", "lift_off = true"));
    let failed = hardpoint(&["equilibrium", &model, "--load", "fz=9000"]).failure().code(3);
    assert!(stderr(&failed).contains("the tyre `tyre` has left the ground"), "{}", stderr(&failed));
}

#[test]
fn a_travel_out_of_reach_is_told() {
    let model = "models/bushed-double-wishbone.toml";
    let failed = hardpoint(&["equilibrium", model, "--travel", "1e6"]).failure().code(3);
    assert!(stderr(&failed).contains("at the end of their travel"), "{}", stderr(&failed));
}
