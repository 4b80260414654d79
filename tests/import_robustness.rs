//! No bytes make an importer or the parsers of models and requests panic, hang or eat the memory.
//!
//! `HARDPOINT_FUZZ=1000000 cargo test --release --test import_robustness` runs a million.
#![allow(missing_docs)]

use std::time::{Duration, Instant};

use fastrand::Rng;
use hardpoint::design::request::Request;
use hardpoint::import::{self, text_of};
use hardpoint::model::{Document, Model};

/// Files that are right, from which wrong ones are made.
const SEEDS: &[(&str, &[u8])] = &[
    ("front.sub", include_bytes!("fixtures/import/car.cdb/subsystems.tbl/front.sub")),
    ("car.asy", include_bytes!("fixtures/import/car.cdb/assemblies.tbl/car.asy")),
    ("arm.bus", include_bytes!("fixtures/import/car.cdb/bushings.tbl/arm.bus")),
    ("coil.spr", include_bytes!("fixtures/import/car.cdb/springs.tbl/coil.spr")),
    ("lotus.shk", include_bytes!("fixtures/import/lotus.shk")),
    ("lotus.txt", include_bytes!("fixtures/import/lotus-table.txt")),
    ("points.csv", include_bytes!("fixtures/import/points.csv")),
    ("team.csv", include_bytes!("fixtures/import/team.csv")),
    ("strut.json", include_bytes!("fixtures/import/strut.json")),
    ("wishbone.json", include_bytes!("fixtures/import/wishbone.json")),
    ("pitman.json", include_bytes!("fixtures/import/pitman.json")),
    ("toe-bar-axle.json", include_bytes!("fixtures/import/toe-bar-axle.json")),
    ("leaf-axle.json", include_bytes!("fixtures/import/leaf-axle.json")),
    ("generic.json", include_bytes!("fixtures/import/generic.json")),
    ("revolute.adm", include_bytes!("fixtures/adams/revolute.adm")),
    ("torsion.adm", include_bytes!("fixtures/adams/torsion-expression.adm")),
    ("model.toml", include_bytes!("../models/sedan-axle.toml")),
    ("mechanism.toml", include_bytes!("../models/squeezer.toml")),
    ("request.toml", include_bytes!("fixtures/requests/complete.toml")),
];

thread_local! {
    /// The model that requests are for.
    static SEDAN: Model = Model::load("models/sedan-axle.toml").expect("it is shipped");
}

/// Pieces that break parsers.
const PIECES: &[&str] = &[
    "",
    "\0",
    "'",
    "\"",
    "[",
    "]",
    "{",
    "}",
    "(",
    ")",
    ",",
    "=",
    "/*",
    "//",
    "$",
    "#",
    "\n",
    "\r\n",
    "\t",
    "1e999",
    "-1e308",
    "NaN",
    "inf",
    "-0",
    "1e-320",
    "99999999999999999999",
    "\u{feff}",
    "\u{2028}",
    "é",
    "[[",
    "]]",
    "[HARDPOINT]",
    "[UNITS]",
    "TEMP_SETTINGS",
    "FRONT SUSPENSION",
    "lca_front",
    "null",
    "true",
    "[points]",
    "0x10",
    "..",
    "../..",
    "mdids://",
    "<a>/",
];

/// The slowest that one file may be, on a machine that does other work as well.
const LONGEST: Duration = Duration::from_secs(20);

#[test]
fn no_bytes_break_an_importer() {
    let number = std::env::var("HARDPOINT_FUZZ")
        .ok()
        .and_then(|number| number.parse().ok())
        .unwrap_or(1500_u64);
    let start = Instant::now();
    let mut imported = 0_u64;
    for run in 0..number {
        // Every run can be repeated by its number.
        let mut rng = Rng::with_seed(run);
        let (name, seed) = SEEDS[rng.usize(..SEEDS.len())];
        let bytes = match rng.u8(..8) {
            0 => (0..rng.usize(..400)).map(|_| rng.u8(..)).collect(),
            1 => seed[..rng.usize(..=seed.len())].to_vec(),
            _ => mutated(seed, &mut rng),
        };
        let before = Instant::now();
        imported += u64::from(accepted(name, bytes));
        assert!(before.elapsed() < LONGEST, "run {run} took {:?}", before.elapsed());
    }
    println!("{number} files in {:?}, of which {imported} make a model", start.elapsed());
    assert!(
        imported > number / 100,
        "only {imported} of {number} make a model: the mutations are too coarse"
    );
}

/// Reads a file as a user would, with all messages.
fn accepted(name: &str, bytes: Vec<u8>) -> bool {
    let text = text_of(bytes);
    if name.starts_with("request") {
        let model = SEDAN.with(Clone::clone);
        return match Request::parse("tests/fixtures/requests/complete.toml", &text, &model) {
            Ok(_) => true,
            Err(error) => {
                assert!(!error.render().is_empty());
                false
            }
        };
    }
    if name.ends_with(".toml") {
        return match Document::parse(name, &text) {
            Ok(_) => true,
            Err(error) => {
                assert!(!error.render().is_empty());
                false
            }
        };
    }
    match import::import(&format!("tests/fixtures/import/car.cdb/subsystems.tbl/{name}"), &text) {
        Ok(imported) => {
            if let Err(error) = Document::parse(name, &imported.text) {
                panic!("what was imported is no model:\n{}\n{}", imported.text, error.render());
            }
            true
        }
        Err(error) => {
            assert!(!error.diagnostics().render().is_empty());
            false
        }
    }
}

/// Some small changes: bytes, pieces, lines that are gone, doubled or exchanged.
fn mutated(seed: &[u8], rng: &mut Rng) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..rng.usize(1..6) {
        if bytes.is_empty() {
            break;
        }
        let place = rng.usize(..bytes.len());
        match rng.u8(..7) {
            0 => bytes[place] = rng.u8(..),
            1 => {
                bytes.remove(place);
            }
            2 | 3 => {
                let piece = PIECES[rng.usize(..PIECES.len())].as_bytes();
                bytes.splice(place..place, piece.iter().copied());
            }
            // A digit becomes another, so that numbers change.
            4 => {
                let digits: Vec<usize> =
                    (0..bytes.len()).filter(|k| bytes[*k].is_ascii_digit()).collect();
                if let Some(digit) = rng.choice(digits) {
                    bytes[digit] = b'0' + rng.u8(..10);
                }
            }
            kind => {
                let mut lines: Vec<Vec<u8>> =
                    bytes.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
                let (a, b) = (rng.usize(..lines.len()), rng.usize(..lines.len()));
                if kind == 5 {
                    lines.swap(a, b);
                } else if rng.bool() {
                    lines.insert(b, lines[a].clone());
                } else {
                    lines.truncate(b.max(1));
                }
                bytes = lines.join(&b'\n');
            }
        }
    }
    bytes
}

/// Files that are wrong in size or depth rather than in letters.
#[test]
fn large_and_deep_files_end_soon() {
    let deep_json = "[".repeat(100_000);
    let deep_object = "{\"a\":".repeat(50_000);
    let deep_toml = format!("a = {}", "[".repeat(100_000));
    let many_points = format!("# length = mm\n# axes = iso8855\n{}", "p,1,2,3\n".repeat(300_000));
    let wrong_rows = "p,1,2,x\n".repeat(300_000);
    let triples: String = (0..200_000).map(|k| format!("p{k}_x;1\n")).collect();
    let blocks = format!(
        "[MDI_HEADER]\nFILE_TYPE='asy'\n{}",
        "[SUBSYSTEM]\nUSAGE='front.sub'\n".repeat(50_000)
    );
    let bushings = format!(
        "{}\n{}",
        include_str!("fixtures/import/car.cdb/subsystems.tbl/front.sub"),
        "[BUSHING_ASSEMBLY]\nUSAGE='lca_front'\nPROPERTY_FILE='mdids://car/bushings.tbl/arm.bus'\n"
            .repeat(20_000)
    );
    let numbers = format!("{{\"a\": [{}1]}}", "1,".repeat(500_000));
    let twice = format!("{{{}\"z\": 1}}", "\"a\": 1,".repeat(100_000));
    let huge = " ".repeat(17 << 20);
    for (name, text) in [
        ("a.json", &deep_json),
        ("a.json", &deep_object),
        ("a.json", &numbers),
        ("a.json", &twice),
        ("a.toml", &deep_toml),
        ("a.csv", &many_points),
        ("a.csv", &wrong_rows),
        ("a.csv", &triples),
        ("a.asy", &blocks),
        ("front.sub", &bushings),
        ("a.txt", &huge),
    ] {
        let start = Instant::now();
        assert!(!accepted(name, text.clone().into_bytes()), "{name}");
        let took = start.elapsed();
        assert!(took < LONGEST, "{name} of {} bytes took {took:?}", text.len());
    }
}
