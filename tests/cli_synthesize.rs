//! `hardpoint synthesize` as a user meets it.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use std::fs;

use hardpoint::design::edit::ModelText;
use program::{hardpoint, json, stderr, stdout};
use tempfile::TempDir;

const SEDAN: &str = "models/double-wishbone.toml";
const TWO: [&str; 2] = ["models/macpherson.toml", "requests/bump-steer-and-camber.toml"];

/// A folder with a file of targets in it.
fn targets(text: &str) -> (TempDir, String) {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("targets.toml");
    fs::write(&path, text).expect("the folder can be written");
    let path = path.to_str().expect("the path is text").to_owned();
    (folder, path)
}

/// The text without its line on how the design was sought, which says nothing of the design.
fn without_search(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("sought from"));
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn tables_say_what_was_wanted_what_came_and_what_moved() {
    let done = hardpoint(&[&["synthesize"], &TWO[..]].concat()).success();
    assert_eq!(stderr(&done), "");
    insta::assert_snapshot!(without_search(&stdout(&done)));
}

/// Two coordinates, two gradients: both are met exactly, in the file that is written.
#[test]
fn two_coordinates_meet_two_gradients() {
    let folder = TempDir::new().unwrap();
    let new = folder.path().join("new.toml");
    let new = new.to_str().unwrap();
    hardpoint(&[&["synthesize"], &TWO[..], &["-o", new]].concat()).success();
    let sheet = json(&["factors", new]);
    let factors = sheet["factors"].as_array().unwrap();
    let value = |name: &str| {
        factors.iter().find(|factor| factor["name"] == name).unwrap()["value"].as_f64().unwrap()
    };
    // Six decimals of a millimetre leave this much.
    assert!((value("bump_steer") + 36.0).abs() < 1e-5, "{}", value("bump_steer"));
    assert!((value("bump_camber") + 13.0).abs() < 1e-5, "{}", value("bump_camber"));
    // All but two lines are those of the model, and in them all but one number.
    let (old, new) = (fs::read_to_string(TWO[0]).unwrap(), fs::read_to_string(new).unwrap());
    let lines = old.lines().zip(new.lines());
    let changed: Vec<_> = lines.filter(|(old, new)| old != new).collect();
    assert_eq!(old.lines().count(), new.lines().count());
    let [strut, tierod] = &changed[..] else { panic!("{changed:?}") };
    for ((old, new), name, axis) in [(strut, "strut_upper", 1), (tierod, "tierod_inner", 2)] {
        assert!(old.starts_with(name), "{old}");
        let parts = |line: &str| line.split(", ").map(str::to_owned).collect::<Vec<_>>();
        let different =
            parts(old).iter().zip(parts(new)).map(|(old, new)| *old != new).collect::<Vec<_>>();
        assert_eq!(different.iter().filter(|different| **different).count(), 1);
        assert!(different[axis]);
    }
}

/// The values after are those of the file, so a reader of it finds the same digits.
#[test]
fn json_has_all_states_of_what_the_file_gives() {
    let folder = TempDir::new().unwrap();
    let new = folder.path().join("new.toml");
    let new = new.to_str().unwrap();
    let value = json(&["synthesize", SEDAN, "requests/toe-curve-flat.toml", "-o", new]);
    assert_eq!(value["verdict"]["kind"], "met");
    assert_eq!(value["file"], new);
    let curve = &value["targets"][0];
    let states = curve["states"].as_array().unwrap();
    assert_eq!((states.len(), &curve["event_unit"]), (11, &"mm".into()));
    let sweep = ["--from", "-50", "--to", "50", "--step", "10", "--columns", "toe"];
    let sweep = |model: &str| json(&[&["sweep", model], &sweep[..]].concat())["rows"].clone();
    let (before, after) = (sweep(SEDAN), sweep(new));
    for (k, state) in states.iter().enumerate() {
        let close = |state: &serde_json::Value, row: &serde_json::Value| {
            let (a, b) = (state.as_f64().unwrap(), row["toe_deg"].as_f64().unwrap());
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        };
        close(&state["before"], &before[k]);
        close(&state["after"], &after[k]);
        assert_eq!(state["wanted"], 0.1);
    }
    let largest = |key: &str| {
        let values = states.iter().map(|state| (state[key].as_f64().unwrap() - 0.1).abs());
        values.fold(0.0, f64::max)
    };
    let close =
        |a: &serde_json::Value, b: f64| assert!((a.as_f64().unwrap().abs() - b).abs() < 1e-9);
    close(&curve["off_before"]["largest"], largest("before"));
    close(&curve["off_after"]["largest"], largest("after"));
    // What has moved is what the file says, with the bounds kept.
    let model = ModelText::load(new).unwrap().read().unwrap();
    for variable in value["variables"].as_array().unwrap() {
        let name = variable["name"].as_str().unwrap();
        let (point, axis) = name.split_once('.').unwrap();
        let axis = ["x", "y", "z"].iter().position(|letter| *letter == axis).unwrap();
        let after = variable["after"].as_f64().unwrap();
        assert!((model.point(point).unwrap()[axis] * 1e3 - after).abs() < 1e-9);
        let bounds = [0, 1].map(|k| variable["bounds"][k].as_f64().unwrap());
        assert!(bounds[0] <= after && after <= bounds[1], "{variable}");
        let change = after - variable["before"].as_f64().unwrap();
        close(&variable["change"], change.abs());
    }
}

const OUT_OF_REACH: &str = "format = 1\n[[targets]]\nfactor = \"rc_height\"\nvalue = 300.0\n\
    [[variables]]\npoint = \"lca_outer\"\ncoordinates = [\"z\"]\nrange = 10.0\n[search]\nstarts = 2\n";

/// A design that misses targets is shown, and written only where that is asked for.
#[test]
fn missed_targets_need_force() {
    let (folder, path) = targets(OUT_OF_REACH);
    let new = folder.path().join("new.toml");
    let new = new.to_str().unwrap();
    let done = hardpoint(&["synthesize", SEDAN, &path, "-o", new]).failure().code(4);
    insta::assert_snapshot!(without_search(&stdout(&done)));
    let told = stderr(&done);
    assert!(told.contains("the target is missed") && told.contains("--force"), "{told}");
    assert!(!fs::exists(new).unwrap());
    let done = hardpoint(&["synthesize", SEDAN, &path, "-o", new, "--force"]).failure().code(4);
    assert!(!stderr(&done).contains("--force"), "{}", stderr(&done));
    assert!(fs::read_to_string(new).unwrap().contains("lca_outer = [0.0, 770.0, -330.0]"));
}

#[test]
fn conflicts_are_stated_and_nothing_is_written() {
    let (folder, path) = targets(&OUT_OF_REACH.replace("300.0\n", "300.0\nhard = true\n"));
    let [new, report] = ["new.toml", "report.json"].map(|name| folder.path().join(name));
    let [new, report] = [&new, &report].map(|path| path.to_str().unwrap());
    let force = ["-o", new, "--force", "--report", report];
    let done = hardpoint(&[&["synthesize", SEDAN, &path], &force[..]].concat()).failure().code(4);
    insta::assert_snapshot!(stderr(&done));
    assert_eq!(stdout(&done), "");
    assert!(!fs::exists(new).unwrap());
    let report: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(report).unwrap()).unwrap();
    assert_eq!(
        (&report["verdict"]["kind"], &report["file"]),
        (&"conflict".into(), &serde_json::Value::Null)
    );
    assert_eq!(report["verdict"]["between"].as_array().unwrap().len(), 2);
    assert_eq!(report["targets"][0]["states"][0]["after"], serde_json::Value::Null);
}

/// Coordinates are those of the model, whose x points rearward and y to the right here.
#[test]
fn numbers_are_in_the_axes_of_the_model() {
    let text = "format = 1\n[[targets]]\nfactor = \"bump_steer\"\nvalue = 30.0\n[[variables]]\n\
                point = \"tierod_inner\"\ncoordinates = [\"x\", \"y\", \"z\"]\nrange = 20.0\n\
                [[boxes]]\npoints = [\"tierod_inner\"]\ny = [-390.0, -300.0]\nat = { travel = 0.0 }\n";
    let (_folder, path) = targets(text);
    let value = json(&["synthesize", "models/adams-tr-front.toml", &path]);
    let y = &value["variables"][1];
    assert_eq!((&y["name"], &y["before"]), (&"tierod_inner.y".into(), &(-400.0).into()));
    assert_eq!((&y["bounds"][0], &y["bounds"][1]), (&(-420.0).into(), &(-380.0).into()));
    assert!(y["after"].as_f64().unwrap() >= -390.000_001);
    let held = value["held_by"].as_array().unwrap();
    let names: Vec<&str> = held.iter().map(|held| held["name"].as_str().unwrap()).collect();
    assert!(names.contains(&"box 1: tierod_inner.y at least -390 mm"), "{names:?}");
}

/// What a model lacks is told at the target, before any search.
#[test]
fn factors_that_the_model_lacks_are_refused_at_their_targets() {
    let rest = "[[variables]]\npoint = \"tierod_inner\"\nrange = 5.0\n";
    let text = format!(
        "format = 1\n[[targets]]\nfactor = \"wheel_load\"\nvalue = 3000.0\n[[targets]]\n\
         factor = \"anti_lift\"\nhold = true\n{rest}"
    );
    let (_folder, path) = targets(&text);
    let told = stderr(&hardpoint(&["synthesize", SEDAN, &path]).failure().code(1));
    insta::assert_snapshot!(told.replace(&path, "targets.toml"));
}

#[test]
fn wrong_files_and_options_are_told() {
    let (folder, path) = targets(OUT_OF_REACH);
    let told = |arguments: &[&str], code: i32| {
        let done = hardpoint(&[&["synthesize"], arguments].concat()).failure().code(code);
        assert_eq!(stdout(&done), "");
        stderr(&done)
    };
    let twice = told(&[SEDAN, &path, "-o", SEDAN], 2);
    assert!(twice.contains("-o would overwrite the model"), "{twice}");
    let over = told(&[SEDAN, &path, "--report", &path], 2);
    assert!(over.contains("--report would overwrite"), "{over}");
    let same = folder.path().join("a.txt");
    let same = same.to_str().unwrap();
    let same = told(&[SEDAN, &path, "-o", same, "--report", same], 2);
    assert!(same.contains("the same file"), "{same}");
    let table = told(&[SEDAN, &path, "--report", "a.csv"], 2);
    assert!(table.contains(".json or .txt"), "{table}");
    assert!(told(&[SEDAN, &path, "--starts", "0"], 2).contains("--starts"));
    assert!(told(&[SEDAN, "none.toml"], 1).contains("none.toml"));
    let mechanism = told(&["models/four-bar.toml", &path], 1);
    assert!(mechanism.contains("mechanism"), "{mechanism}");
    let adjusted = told(&["models/sedan-setup.toml", &path], 1);
    assert!(
        adjusted.contains("models/sedan-setup.toml: ") && adjusted.contains("[static]"),
        "{adjusted}"
    );
    let stop =
        targets(&OUT_OF_REACH.replace("value = 300.0", "value = 300.0\nat = { travel = 600.0 }"));
    let stop = told(&[SEDAN, &stop.1], 3);
    assert!(stop.contains("was not reached"), "{stop}");
}

/// A new file elsewhere that would not find what the model refers to is not written.
#[test]
fn paths_in_the_new_file_are_checked() {
    let folder = TempDir::new().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    fs::copy("architectures/double-wishbone.toml", place("own.toml")).unwrap();
    let text = fs::read_to_string(SEDAN).unwrap();
    let text = text.replace("architecture = \"double-wishbone\"", "architecture = \"own.toml\"");
    fs::write(place("model.toml"), text).unwrap();
    fs::create_dir(place("sub")).unwrap();
    let request = "requests/bump-steer-zero.toml";
    let (near, far) = (place("new.toml"), place("sub/new.toml"));
    hardpoint(&["synthesize", &place("model.toml"), request, "-o", &near]).success();
    let done = hardpoint(&["synthesize", &place("model.toml"), request, "-o", &far]);
    let told = stderr(&done.failure().code(1));
    assert!(told.contains("own.toml"), "{told}");
    assert!(!fs::exists(far).unwrap());
}

/// The body rolls about the roll centre of the design, not that of the model.
#[test]
fn roll_is_about_the_axis_of_the_design() {
    let text = "format = 1\n[[targets]]\nfactor = \"toe\"\nevent = \"roll\"\nrange = [-2.0, 2.0]\npoints = 5\n\
                value = 0.1\ntolerance = 0.02\n[[targets]]\nfactor = \"rc_height\"\nvalue = 120.0\n\
                [[variables]]\npoints = [\"tierod_inner\", \"tierod_outer\", \"lca_outer\"]\n\
                coordinates = [\"z\"]\nrange = 40.0\n[search]\nstarts = 4\n";
    let (folder, path) = targets(text);
    let new = folder.path().join("new.toml");
    let new = new.to_str().unwrap();
    let arguments = ["synthesize", SEDAN, &path, "-o", new, "--force", "--format", "json"];
    let found = hardpoint(&arguments);
    let found: serde_json::Value = serde_json::from_str(&stdout(&found)).unwrap();
    assert_eq!(found["side"], "both");
    let sweep = ["--axle", "--event", "roll", "--from", "-2", "--to", "2", "--step", "1"];
    let sweep = json(&[&["sweep", new], &sweep[..], &["--columns", "toe"]].concat());
    let states = found["targets"][0]["states"].as_array().unwrap();
    for (state, row) in states.iter().zip(sweep["rows"].as_array().unwrap()) {
        let (own, swept) =
            (state["after"].as_f64().unwrap(), row["left_toe_deg"].as_f64().unwrap());
        assert!((own - swept).abs() < 1e-9, "{own} {swept}");
        let before = state["before"].as_f64().unwrap();
        let at = state["at"].as_f64().unwrap();
        assert!(
            at == 0.0 || (own - 0.1).abs() < 0.5 * (before - 0.1).abs(),
            "{at}: {before} {own}"
        );
    }
}
