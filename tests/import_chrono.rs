//! Every suspension and steering file of Project Chrono imports, checks and sweeps over its range, or says
//! precisely what is missing.
#![allow(missing_docs)]

use std::fs;
use std::path::Path;

use hardpoint::import;
use hardpoint::model::{Axes, Document, Model, Setup};
use hardpoint::rig::{Corner, Event, Held, Stand, Sweep, SweepPlan};

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
                    sweep_corner(&name, &model);
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
                    "has no architecture for",
                    "are not read yet",
                    "nothing to compute",
                    "bodies and joints of its own",
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
    // More architectures make more; docs/import.md has the count.
    assert!(suspensions >= 9, "{suspensions}");
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
