//! The command line as a user meets it.

#[path = "common/program.rs"]
mod program;

use std::fs;
use std::io::Read as _;
use std::path::Path;
use std::process::Stdio;

use program::{hardpoint, stderr, stdout};

const SEDAN: &str = "models/double-wishbone.toml";

#[test]
fn check_says_what_the_model_is() {
    insta::assert_snapshot!(stdout(&hardpoint(&["check", SEDAN]).success()));
}

#[test]
fn default_sweep_is_the_table_of_the_paper() {
    let done = hardpoint(&["sweep", SEDAN]).success();
    assert_eq!(stderr(&done), "", "quiet when piped");
    insta::assert_snapshot!(stdout(&done));
}

#[test]
fn csv_has_the_promised_columns() {
    let text = stdout(&hardpoint(&["sweep", SEDAN, "--format", "csv"]).success());
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some(
            "travel_mm,rack_mm,wheel_center_x_mm,wheel_center_y_mm,wheel_center_z_mm,toe_deg,\
             camber_deg,wheel_rot_x_deg,wheel_rot_y_deg,wheel_rot_z_deg,caster_deg,kpi_deg"
        )
    );
    assert_eq!(lines.count(), 27);
}

#[test]
fn json_tells_definitions_iterations_and_residuals() {
    let text = stdout(&hardpoint(&["sweep", SEDAN, "--format", "json", "--event", "steer"]));
    let value: serde_json::Value = serde_json::from_str(&text).expect("the output is JSON");
    assert_eq!(value["event"], "steer");
    assert_eq!(value["rows"].as_array().map(Vec::len), Some(17));
    assert_eq!(value["columns"][5]["name"], "toe_deg");
    assert_eq!(value["columns"][5]["sign"], "+ toe-in");
    for row in value["rows"].as_array().into_iter().flatten() {
        assert!(row["newton_iterations"].as_u64().is_some_and(|iterations| iterations < 10));
        assert!(row["relative_residual"].as_f64().is_some_and(|residual| residual < 1e-12));
    }
}

#[test]
fn other_side_mirrors_the_rack() {
    let range = ["--event", "steer", "--from", "5", "--to", "5", "--format", "csv"];
    let row = |side: &str, rack: &str| {
        let mut arguments = vec!["sweep", SEDAN, "--side", side];
        arguments.extend(range.map(|part| if part == "5" { rack } else { part }));
        let text = stdout(&hardpoint(&arguments).success());
        let last = text.lines().last().unwrap_or_default();
        last.split(',').map(|field| field.parse::<f64>().expect("a number")).collect::<Vec<_>>()
    };
    let (left, right) = (row("left", "5"), row("right", "-5"));
    // Toe, camber, caster and kingpin inclination are the same, y is mirrored.
    for column in [5, 6, 10, 11] {
        assert!((left[column] - right[column]).abs() < 1e-11, "{left:?} {right:?}");
    }
    assert!((left[3] + right[3]).abs() < 1e-10);
}

#[test]
fn file_is_whole_or_not_there() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("steer.csv");
    let name = path.to_str().expect("a plain name");
    hardpoint(&["sweep", SEDAN, "-o", name]).success();
    let text = fs::read_to_string(&path).expect("the file is there");
    assert_eq!(text.lines().count(), 28, "the ending of the file names the format");
    assert_eq!(files(folder.path()), 1);

    let missing = folder.path().join("no/such/folder.csv");
    let failed = hardpoint(&["sweep", SEDAN, "-o", missing.to_str().expect("a plain name")]);
    let failed = failed.failure().code(1);
    assert!(stderr(&failed).contains("folder.csv cannot be written"), "{}", stderr(&failed));
}

#[test]
fn a_reader_that_has_seen_enough_is_no_failure() {
    for format in ["table", "csv", "json"] {
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_hardpoint"))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .args(["sweep", SEDAN, "--step", "0.1", "--format", format])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut start = [0; 10];
        child.stdout.take().expect("a pipe").read_exact(&mut start).expect("some output");
        let output = child.wait_with_output().expect("the program ends");
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && message.is_empty(), "{format}: {message}");
    }
}

#[cfg(unix)]
#[test]
fn links_and_devices_stay_what_they_are() {
    let folder = tempfile::tempdir().expect("a folder");
    let (file, link) = (folder.path().join("steer.CSV"), folder.path().join("link.csv"));
    fs::write(&file, "old").expect("a file");
    std::os::unix::fs::symlink(&file, &link).expect("a link");
    hardpoint(&["sweep", SEDAN, "-o", link.to_str().expect("a plain name")]).success();
    assert!(fs::symlink_metadata(&link).expect("the link is there").is_symlink());
    assert_eq!(fs::read_to_string(&file).expect("the file is there").lines().count(), 28);
    // A link to a device, so that a failure of this test cannot harm the device itself.
    let null = folder.path().join("null.csv");
    std::os::unix::fs::symlink("/dev/stdout", &null).expect("a link");
    let done = hardpoint(&["sweep", SEDAN, "-o", null.to_str().expect("a plain name")]).success();
    assert_eq!(stdout(&done).lines().count(), 28);
    assert_eq!(files(folder.path()), 3, "nothing is left behind");
}

#[test]
fn a_wheel_that_nothing_holds_is_told() {
    let read = |path: &str| fs::read_to_string(path).expect("the file is there");
    let (start, rest) = read("architectures/double-wishbone.toml")
        .split_once("[[joints]]\nname = \"tierod_outer_joint\"")
        .map(|(start, rest)| (start.to_owned(), rest.to_owned()))
        .expect("the joint is there");
    let end = rest.find("[[joints]]").expect("a joint follows");
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("loose.toml"), start + &rest[end..]).expect("a file");
    let model = read("models/adams-tr-front.toml").replace("double-wishbone", "./loose.toml");
    let path = folder.path().join("model.toml");
    fs::write(&path, model).expect("a file");
    let name = path.to_str().expect("a plain name");

    let swept = hardpoint(&["sweep", name, "--from", "0", "--to", "0"]).success();
    let message = stderr(&swept);
    let parts = ["warning: no joint holds", "lca turns about the line lca_front–lca_rear"];
    for part in parts.into_iter().chain(["(numbers in iso8855 axes)"]) {
        assert!(message.contains(part), "{message}");
    }
    assert_eq!(message.matches("warning").count(), 1, "the loose tie rod does not matter");
    let checked = stdout(&hardpoint(&["check", name]).success());
    assert!(checked.contains("free: ") && checked.contains("iso8855 axes"), "{checked}");
}

fn files(folder: &Path) -> usize {
    fs::read_dir(folder).expect("the folder can be read").count()
}

#[test]
fn lock_up_is_told_with_place_and_joint_after_the_states_before_it() {
    let arguments = ["sweep", SEDAN, "--from", "-250", "--to", "0", "--step", "50"];
    let stopped = hardpoint(&arguments).failure().code(3);
    assert!(stdout(&stopped).contains("-200.0000"));
    let message = stderr(&stopped);
    for part in ["stopped at travel = -214.605", "dead centre", "5 of 6 states were reached"] {
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn wrong_input_is_told_with_what_to_do() {
    let cases: &[(&[&str], i32, &str)] = &[
        (&["sweep", "models/nope.toml"], 1, "there is no file"),
        (&["check", "models"], 1, "models"),
        (&["sweep", SEDAN, "--step", "0"], 2, "--step is zero"),
        (&["sweep", SEDAN, "--step", "1e-9"], 2, "too small"),
        (&["sweep", SEDAN, "--from", "nan"], 2, "--from is not a finite number"),
        (&["sweep", SEDAN, "--to", "inf"], 2, "--to is not a finite number"),
        (&["sweep", SEDAN, "--to", "1e308", "--step", "1e308"], 2, "--to is more than a kilometre"),
        (&["sweep", SEDAN, "--to", "far"], 2, "invalid value 'far'"),
        (&["sweep", SEDAN, "--travel", "3"], 2, "--rack"),
        (&["sweep", SEDAN, "--event", "steer", "--rack", "3"], 2, "--travel"),
        (&["sweep", SEDAN, "-o", SEDAN], 2, "-o would overwrite the model"),
        (&["sweep", SEDAN, "--event", "stear"], 2, "steer"),
        (&["swep", SEDAN], 2, "sweep"),
        (&["sweep"], 2, "<MODEL>"),
        (&[], 2, "Usage"),
    ];
    for (arguments, code, part) in cases {
        let failed = hardpoint(arguments).failure().code(*code);
        assert!(stderr(&failed).contains(part), "{arguments:?}: {}", stderr(&failed));
        assert_eq!(stdout(&failed), "", "{arguments:?}");
    }
}

#[test]
fn help_has_examples_and_exit_codes() {
    assert!(stdout(&hardpoint(&["--help"]).success()).contains("Exit codes"));
    let help = stdout(&hardpoint(&["sweep", "--help"]).success());
    assert!(help.contains("Examples") && help.contains("toe + toe-in"), "{help}");
}
