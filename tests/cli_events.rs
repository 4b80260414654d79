//! Roll, wheel forces, grids and cases as a user meets them.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use std::fs;

use program::{column, hardpoint, json, stderr, stdout};

fn csv(arguments: &[&str]) -> String {
    stdout(&hardpoint(&[&["sweep"], arguments, &["--format", "csv"]].concat()).success())
}

fn usage(arguments: &[&str], words: &str) {
    let told = stderr(&hardpoint(&[&["sweep"], arguments].concat()).code(2));
    assert!(told.contains(words), "{told}");
}

const AXLE: &str = "models/sedan-axle.toml";
const KINEMATIC: &str = "models/double-wishbone.toml";

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} {expected}");
}

#[test]
fn roll_is_about_the_x_axis_of_the_model() {
    // Lotus' report of the left wheel: x points rearward, so that the left wheel goes up.
    let text = csv(&[
        "models/lotus-front.toml",
        "--axle",
        "--event",
        "roll",
        "--drive",
        "contact-patch",
        "--columns",
        "travel,kpi",
    ]);
    let (roll, kpi) = (column(&text, "roll_deg"), column(&text, "left_kpi_deg"));
    assert_eq!((roll.len(), roll[0], roll[6], roll[12]), (13, -3.0, 0.0, 3.0));
    close(kpi[12], 5.9032, 1.1e-4);
    assert!(column(&text, "left_travel_mm")[12] > 35.0);
    // In ISO axes x points forward, so that it droops.
    let arguments = [KINEMATIC, "--axle", "--event", "roll", "--rack", "4"];
    let text = csv(&arguments);
    assert!(column(&text, "left_travel_mm")[12] < -35.0);
    assert_eq!(column(&text, "rack_mm"), [4.0; 13]);
    let table = stdout(&hardpoint(&[&["sweep"], &arguments[..]].concat()).success());
    let sign = "right-handed about the model's +x: the left side of the body rises";
    assert!(table.contains(sign), "{table}");
}

#[test]
fn roll_with_constant_load_keeps_the_load() {
    let found =
        csv(&[AXLE, "--axle", "--event", "roll-load", "--from", "-2", "--to", "2", "--step", "1"]);
    let [left, right] =
        ["left", "right"].map(|side| column(&found, &format!("{side}_wheel_load_N")));
    let loads: Vec<f64> = left.iter().zip(&right).map(|(left, right)| left + right).collect();
    loads.iter().for_each(|load| close(*load, loads[2], 1e-6));
    assert!(left[0] - right[0] > 500.0, "{left:?} {right:?}");
    let heave = column(&found, "heave_mm");
    assert!(heave[0] > 0.01 && (heave[0] - heave[4]).abs() < 1e-8, "{heave:?}");
    usage(&[KINEMATIC, "--axle", "--event", "roll-load"], "has no axle load to keep");
    usage(&[AXLE, "--event", "roll"], "add --axle");
    usage(&[AXLE, "--axle", "--event", "roll", "--to", "1000"], "lies on its side");
}

#[test]
fn forces_hold_wheels() {
    let range = ["--from", "2000", "--to", "5000", "--step", "1500"];
    let found = csv(&[&[AXLE, "--vertical", "force"], &range[..]].concat());
    assert_eq!(column(&found, "force_N"), [2000.0, 3500.0, 5000.0]);
    let load = column(&found, "wheel_load_N");
    (0..3).for_each(|k| close(load[k], [2000.0, 3500.0, 5000.0][k], 1e-6));

    // A lateral load at the static wheel load, and at another one.
    let lateral = [
        AXLE,
        "--axle",
        "--event",
        "load",
        "--vary",
        "fy",
        "--vertical",
        "force",
        "--step",
        "1000",
    ];
    let found = csv(&lateral);
    let load = column(&found, "left_wheel_load_N");
    assert!(load[1] > 1000.0);
    load.iter().for_each(|force| close(*force, load[1], 1e-6));
    let found = csv(&[&lateral[..], &["--wheel-force", "3000"]].concat());
    column(&found, "right_wheel_load_N").iter().for_each(|force| close(*force, 3000.0, 1e-6));

    let found =
        csv(&[AXLE, "--axle", "--event", "opposite", "--vertical", "force", "--step", "1000"]);
    assert_eq!(column(&found, "opposite_force_change_N"), [-1000.0, 0.0, 1000.0]);

    usage(&[AXLE, "--vertical", "force"], "say the range of the wheel force");
    usage(&[KINEMATIC, "--vertical", "force"], "no force holds the wheels");
    usage(&[AXLE, "--wheel-force", "3000"], "belongs to --vertical");
    usage(
        &[AXLE, "--axle", "--event", "roll", "--vertical", "force"],
        "wheels stay at their heights",
    );
    usage(&["models/four-bar.toml", "--vertical", "force"], "--vertical belongs to suspensions");
}

#[test]
fn envelopes_go_over_travel_and_rack() {
    let small = ["--from", "-40", "--to", "40", "--step", "40"];
    let found = csv(&[
        &[KINEMATIC, "--event", "envelope", "--over", "rack=-20:20:20", "--columns", "toe"],
        &small[..],
    ]
    .concat());
    assert_eq!(column(&found, "travel_mm"), [-40.0, 0.0, 40.0].repeat(3));
    let racks = [[-20.0; 3], [0.0; 3], [20.0; 3]].concat();
    assert_eq!(column(&found, "rack_mm"), racks);
    let held = csv(&[&[KINEMATIC, "--rack", "-20", "--columns", "toe"], &small[..]].concat());
    assert_eq!(column(&found, "toe_deg")[..3], column(&held, "toe_deg"));

    let found = csv(&[
        &[AXLE, "--axle", "--event", "left", "--over", "right=-30:30:60", "--columns", "travel"],
        &small[..],
    ]
    .concat());
    assert_eq!(column(&found, "left_travel_mm"), [-40.0, 0.0, 40.0].repeat(2));
    assert_eq!(column(&found, "right_travel_mm"), [[-30.0; 3], [30.0; 3]].concat());

    usage(&[KINEMATIC, "--over", "rack=1:2"], "write rack, travel or right");
    usage(&[KINEMATIC, "--event", "steer", "--over", "rack=-1:1:1"], "moves the rack");
    usage(&[KINEMATIC, "--over", "travel=-1:1:1"], "moves the travel");
    usage(&[KINEMATIC, "--over", "right=-1:1:1"], "add --axle");
}

/// What cannot be reached is told with its place in the grid; the rest is written.
#[test]
fn a_grid_tells_where_it_stopped() {
    let arguments =
        ["sweep", KINEMATIC, "--event", "envelope", "--over", "rack=0:10:10", "--to", "900"];
    let run = hardpoint(&[&arguments[..], &["--step", "100", "--format", "csv"]].concat()).code(3);
    let told = stderr(&run);
    assert!(
        told.contains("rack 0 mm: stopped at travel") && told.contains("rack 10 mm: "),
        "{told}"
    );
    assert!(told.contains("of 24 states were reached"), "{told}");
    let racks = column(&stdout(&run), "rack_mm");
    assert!(racks.contains(&0.0) && racks.contains(&10.0), "{racks:?}");
}

#[test]
fn cases_come_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let cases = file("cases.csv", "name,left_fx,rack_mm,travel\nbraking,-3000,,20\nsteered,,5,\n");
    let found = csv(&[AXLE, "--axle", "--cases", &cases]);
    assert!(found.starts_with("case,left_fx_N,travel_mm,rack_mm,"), "{found}");
    assert!(found.contains("\nbraking,-3000,") && found.contains("\nsteered,,"), "{found}");
    assert_eq!(column(&found, "right_travel_mm"), [20.0, 0.0]);
    let found = json(&["sweep", AXLE, "--axle", "--cases", &cases]);
    assert_eq!(found["rows"][0]["case"], "braking");
    assert_eq!(found["event"], "cases");
    // A wheel that no column holds stands on its tyre.
    let free = file("free.csv", "fz\n0\n-500\n");
    let found = csv(&[AXLE, "--cases", &free, "--columns", "wheel_load"]);
    let loads = column(&found, "wheel_load_N");
    // The spring takes the rest.
    assert!((400.0..499.0).contains(&(loads[1] - loads[0])), "{loads:?}");

    let wrong = file("wrong.csv", "name,left_fxx,rack\na,1,two\n");
    let told = stderr(&hardpoint(&["sweep", AXLE, "--axle", "--cases", &wrong]).code(1));
    for words in
        ["did you mean `left_fx`?", "wrong.csv:1:6", "`rack` must be a number", "wrong.csv:2:5"]
    {
        assert!(told.contains(words), "{words}: {told}");
    }
    let told = stderr(&hardpoint(&["sweep", KINEMATIC, "--cases", &free]).code(1));
    assert!(told.contains("the model has no forces"), "{told}");
    hardpoint(&["sweep", AXLE, "--cases", &cases, "--event", "travel"]).code(2);
    hardpoint(&["sweep", AXLE, "--axle", "--cases", "nowhere.csv"]).code(1);
}

#[test]
fn what_is_gone_through_is_not_held_as_well() {
    let envelope = [KINEMATIC, "--event", "envelope", "--rack", "10"];
    usage(&envelope, "--rack holds the rack at one value");
    usage(&[KINEMATIC, "--rack", "10", "--over", "rack=0:10:10"], "leave out --rack");
    let steer = [KINEMATIC, "--event", "steer", "--travel", "5", "--over", "travel=0:10:10"];
    usage(&steer, "--travel holds the travel at one value");
}

#[test]
fn an_envelope_goes_to_the_limits_of_the_rack() {
    let model = fs::read_to_string(KINEMATIC).expect("the model");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("limited.toml");
    fs::write(&path, format!("{model}\n[steering]\nlimits = [-25.0, 20.0]\n")).expect("a file");
    let path = path.to_str().expect("a name");
    let range = ["--from", "0", "--to", "0", "--columns", "rack"];
    let text = csv(&[&[path, "--event", "envelope"], &range[..]].concat());
    assert_eq!(column(&text, "rack_mm"), [-20.0, -10.0, 0.0, 10.0, 20.0]);
}
