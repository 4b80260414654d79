//! Every suspension and steering file of Project Chrono imports, checks and sweeps over its range, or says
//! precisely what is missing.
#![allow(missing_docs)]

use std::fs;
use std::path::Path;

use hardpoint::import;
use hardpoint::model::{Axes, Document, Model, Setup, Side};
use hardpoint::rig::{Axle, Corner, Event, Held, Specimen as _, Stand, Sweep, SweepPlan};

/// The folder of the files; skipped with a message where it is absent.
fn folder() -> Option<std::path::PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/reference/chrono-vehicle");
    if !folder.is_dir() {
        eprintln!("skipped: there is no {}", folder.display());
        return None;
    }
    Some(folder)
}

#[test]
fn all_files_import_and_sweep_or_say_what_is_missing() {
    let Some(folder) = folder() else { return };
    let (mut suspensions, mut steerings, mut refused) = (0, 0, vec![]);
    let mut files: Vec<_> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let files = files.iter().filter(|path| path.extension().is_some_and(|end| end == "json"));
    for path in files {
        let name = path.display().to_string();
        let text = fs::read_to_string(path).unwrap();
        if !text.contains("\"Suspension\"") && !text.contains("\"Steering\"") {
            continue;
        }
        match import::import(&name, &text) {
            Ok(imported) => match Document::parse(&name, &imported.text) {
                Ok(Document::Suspension(model)) => {
                    if model.is_axle() {
                        sweep_axle(&name, &model);
                    } else {
                        sweep_corner(&name, &model);
                    }
                    suspensions += 1;
                }
                Ok(Document::Mechanism(model)) if text.contains("\"Suspension\"") => {
                    sweep_wheels(&name, model.mechanism);
                    suspensions += 1;
                }
                Ok(Document::Mechanism(model)) => {
                    sweep_steering(&name, &imported.text, model.mechanism);
                    steerings += 1;
                }
                Err(error) => panic!("{name}: {}", error.render()),
            },
            Err(error) => {
                let message = error.diagnostics().mistakes()[0].message().to_owned();
                let known = [
                    "nothing to compute",
                    "about its pin",
                    "cannot travel apart",
                    "go up and down",
                ];
                assert!(known.iter().any(|words| message.contains(words)), "{name}: {message}");
                refused.push(format!("{}: {message}", path.file_name().unwrap().to_string_lossy()));
            }
        }
    }
    println!(
        "{suspensions} suspensions and {steerings} steerings imported, {} refused:",
        refused.len()
    );
    refused.iter().for_each(|line| println!("  {line}"));
    assert_eq!(suspensions + steerings + refused.len(), 62);
    assert_eq!(steerings, 14);
    // docs/import.md has the count.
    assert_eq!(suspensions, 44);
}

/// ±70 mm of travel, the displacement limit of Chrono's own test rig, on rigid joints and as the file is.
fn sweep_corner(name: &str, model: &Model) {
    for kinematic in [true, false] {
        let setup = Setup { kinematic, ..Setup::default() };
        let mut corner =
            Corner::new(model, &setup).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(!kinematic || corner.freedom().is_exact(), "{name}: {}", corner.freedom());
        let plan = SweepPlan {
            event: Event::Travel,
            from: -0.07,
            to: 0.07,
            step: 0.01,
            held: Held::default(),
        };
        let sweep = Sweep::run(&mut corner, &plan, |_| {});
        assert!(sweep.stops.is_empty(), "{name}: {}", sweep.stops[0]);
        assert_eq!(sweep.rows.len(), 15, "{name}");
    }
}

/// The same with both wheels up and down, and one up and the other down. Axles on leaf springs of three links
/// have more free motions than travels, which their springs hold.
fn sweep_axle(name: &str, model: &Model) {
    let elastic = model.architecture.title().contains("leaf springs of three links");
    for kinematic in [true, false] {
        let setup = Setup { kinematic, ..Setup::default() };
        let mut axle = Axle::new(model, &setup).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(elastic || axle.freedom().is_exact(), "{name}: {}", axle.freedom());
        for event in [Event::Travel, Event::Opposite] {
            let held = Held::default();
            let plan = SweepPlan { event, from: -0.07, to: 0.07, step: 0.01, held };
            let sweep = Sweep::run(&mut axle, &plan, |_| {});
            assert!(sweep.stops.is_empty(), "{name}, {event:?}: {}", sweep.stops[0]);
            assert_eq!(sweep.rows.len(), 15, "{name}");
        }
    }
}

/// Suspensions with bodies and joints of their own are mechanisms whose drivers are the heights of both wheels.
fn sweep_wheels(name: &str, mechanism: hardpoint::mechanism::Mechanism) {
    let mut stand =
        Stand::new(mechanism, &[], Axes::Iso8855).unwrap_or_else(|e| panic!("{name}: {e}"));
    assert!(stand.freedom().redundant.is_empty(), "{name}: {}", stand.freedom());
    for wheel in ["left_wheel", "right_wheel"] {
        let driver = stand.mechanism().driver_named(wheel).unwrap();
        let (event, held) = (Event::Driver(driver), Held::default());
        let plan = SweepPlan { event, from: -0.07, to: 0.07, step: 0.01, held };
        let sweep = Sweep::run(&mut stand, &plan, |_| {});
        assert!(sweep.stops.is_empty(), "{name}: {}", sweep.stops[0]);
        assert_eq!(sweep.rows.len(), 15, "{name}");
    }
}

/// The range that the importer found, which stands in a comment of the mechanism.
fn sweep_steering(name: &str, text: &str, mechanism: hardpoint::mechanism::Mechanism) {
    let words: Vec<&str> = text.split_whitespace().filter(|word| *word != "#").collect();
    let from = words.iter().position(|word| *word == "from").expect("the range is stated");
    let ends = [words[from + 1], words[from + 3]].map(|word| word.parse::<f64>().unwrap());
    let mut stand =
        Stand::new(mechanism, &[], Axes::Iso8855).unwrap_or_else(|e| panic!("{name}: {e}"));
    assert!(stand.freedom().is_exact(), "{name}: {}", stand.freedom());
    let drivers = stand.mechanism().drivers();
    assert_eq!(drivers.len(), 1, "{name}");
    let driver = stand.mechanism().driver_named(&drivers[0].name.clone()).unwrap();
    let held = Held::default();
    let plan = SweepPlan {
        event: Event::Driver(driver),
        from: ends[0],
        to: ends[1],
        step: (ends[1] - ends[0]) / 10.0,
        held,
    };
    let sweep = Sweep::run(&mut stand, &plan, |_| {});
    assert!(sweep.stops.is_empty(), "{name}: {}", sweep.stops[0]);
    assert!(sweep.rows.len() >= 11, "{name}");
}

/// Project Chrono ships two suspensions twice: by their template, and by bodies and joints of their own, with numbers
/// that are rounded in the one on leaf springs. Both move alike.
#[test]
fn templates_and_their_replicas_move_alike() {
    let Some(folder) = folder() else { return };
    let read = |file: &str| {
        let path = folder.join(file);
        let text = fs::read_to_string(&path).unwrap();
        import::import(&path.display().to_string(), &text).unwrap().text
    };
    let stand = |file: &str| match Document::parse(file, &read(file)).unwrap() {
        Document::Mechanism(model) => Stand::new(model.mechanism, &[], Axes::Iso8855).unwrap(),
        Document::Suspension(_) => panic!("{file} is a mechanism"),
    };
    let apart = |a: [f64; 3], b: [f64; 3]| {
        a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
    };
    let wishbones = read("hmmwv__suspension__HMMWV_DoubleWishboneFront.json");
    let wishbones = Model::parse("wishbones.toml", &wishbones).unwrap();
    let mut corner = Corner::new(&wishbones, &Setup::default()).unwrap();
    let mut replica = stand("hmmwv__suspension__HMMWV_DoubleWishboneFront_replica.json");
    for travel in [-0.06, -0.03, 0.03, 0.06] {
        corner.move_to(travel, 0.0).unwrap();
        let place = wheel(&mut replica, [travel, 0.0], "left");
        let off = apart(corner.pose().wheel.center, place);

        assert!(off < 1e-7, "{travel}: {off} m");
    }
    // The replica has next to no preload: without it the template is the same.
    let leaves = read("uaz__suspension__UAZBUS_FrontSAELeafspringAxle.json");
    let leaves: Vec<&str> = leaves.lines().filter(|line| !line.starts_with("preload")).collect();
    let leaves = Model::parse("leaves.toml", &leaves.join("\n")).unwrap();
    let mut axle = Axle::new(&leaves, &Setup::default()).unwrap();
    let mut replica = stand("uaz__suspension__UAZBUS_FrontSAELeafspringAxle_replica.json");
    for travel in [[0.05, 0.05], [-0.05, -0.05], [0.04, -0.04], [0.0, 0.06]] {
        axle.move_to(travel, 0.0).unwrap();
        for (side, name) in [(Side::Left, "left"), (Side::Right, "right")] {
            let place = wheel(&mut replica, travel, name);
            let off = apart(axle.pose(side).wheel.center, place);
            assert!(off < 5e-5, "{travel:?}, {name}: {off} m");
        }
    }
}

/// Where the wheel centre of a side is, with the wheels at these heights.
fn wheel(stand: &mut Stand, travel: [f64; 2], side: &str) -> [f64; 3] {
    let drivers =
        ["left_wheel", "right_wheel"].map(|name| stand.mechanism().driver_named(name).unwrap());
    let targets = [(drivers[0], travel[0]), (drivers[1], travel[1])];
    stand.move_to(&targets).unwrap();
    // The origin of a spindle is its centre of mass, which is the wheel centre.
    let values = stand.channel_values();
    ["x", "y", "z"].map(|axis| {
        let name = format!("{side}_spindle_{axis}");
        let channel = stand.element_channels().iter().position(|channel| channel.name == name);
        values[channel.unwrap_or_else(|| panic!("no channel {name}"))]
    })
}
