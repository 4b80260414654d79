//! `hardpoint factors` and factors as columns, as a user meets them.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use program::{hardpoint, stderr, stdout};
use std::fs;

const SEDAN: &str = "models/double-wishbone.toml";
const LOTUS: &str = "models/lotus-front.toml";

#[test]
fn sheet_has_all_factors_with_unit_and_sign() {
    let arguments = ["--convention", "lotus", "--drive", "contact-patch", "--travel", "15"];
    let done = hardpoint(&[&["factors", LOTUS][..], &arguments].concat()).success();
    assert_eq!(stderr(&done), "");
    insta::assert_snapshot!(stdout(&done));
}

/// The document is what the program prints.
#[test]
fn document_of_factors_is_up_to_date() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/factors.md");
    let document = fs::read_to_string(path).expect("the document is there");
    let printed = stdout(&hardpoint(&["factors", "--list"]).success());
    assert!(
        document.replace("\r\n", "\n") == printed,
        "docs/factors.md is old; write it anew: hardpoint factors --list -o docs/factors.md"
    );
}

#[test]
fn sheet_is_csv_and_json_too() {
    let text = stdout(&hardpoint(&["factors", SEDAN, "--format", "csv"]).success());
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.unwrap()).collect();
    let toe = rows.iter().find(|row| &row[0] == "toe").expect("a row for toe");
    assert_eq!((&toe[1], &toe[2], &toe[4]), ("0.1", "deg", "+ toe-in"));
    assert!(rows.iter().all(|row| row[1].parse::<f64>().is_ok()), "all are defined here");

    let text = stdout(&hardpoint(&["factors", SEDAN, "--format", "json", "--travel", "20"]));
    let value: serde_json::Value = serde_json::from_str(&text).expect("the output is JSON");
    assert_eq!((&value["travel"], &value["convention"]), (&20.0.into(), &"iso".into()));
    let factors = value["factors"].as_array().expect("a list");
    assert_eq!(factors.len(), rows.len());
    for factor in factors {
        for key in ["name", "title", "symbol", "unit", "sign", "formula", "source"] {
            assert!(factor[key].as_str().is_some_and(|text| !text.is_empty()), "{factor}");
        }
    }
    assert_eq!(value["not_shown"][1]["factors"][0], "wheel_load");
}

/// What the model lacks is said with the key; what is undefined is a dash, an empty field, null.
#[test]
fn missing_and_undefined_are_told_apart() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("level.toml");
    let model = fs::read_to_string(SEDAN).expect("the model is there");
    let points = "lca_front = [200.0, 420.0, -300.0]\nlca_rear = [-200.0, 420.0, -300.0]\n\
                  lca_outer = [0.0, 770.0, -300.0]\nuca_front = [200.0, 420.0, 100.0]\n\
                  uca_rear = [-200.0, 420.0, 100.0]\nuca_outer = [0.0, 770.0, 100.0]\n\
                  tierod_inner = [-150.0, 420.0, -120.0]\ntierod_outer = [-150.0, 770.0, -120.0]\n\
                  wheel_center = [0.0, 797.9, -119.9]\n\n[wheel]";
    let (from, to) = (model.find("lca_front").unwrap(), model.find("[wheel]").unwrap());
    let vehicle = model.find("cg_height").unwrap();
    let mut level = model.clone();
    level.replace_range(vehicle.., "brake_share = 0.6\n");
    level.replace_range(from..to + "[wheel]".len(), points);
    fs::write(&path, level).expect("a file");
    let name = path.to_str().expect("a plain name");
    let text = stdout(&hardpoint(&["factors", name]).success());
    let line = |start: &str| {
        let found = text.lines().find(|line| line.trim_start().starts_with(start));
        found.unwrap_or_else(|| panic!("no line {start}: {text}")).to_owned()
    };
    assert!(line("fvsa_length").contains(" – mm"), "{}", line("fvsa_length"));
    assert!(line("fvsa_angle").contains("0.0000 deg"), "{}", line("fvsa_angle"));
    assert_eq!(line("anti_dive:"), "  anti_dive: add `cg_height` in [vehicle]");
    let both = "  anti_lift_drive: add `cg_height` in [vehicle] and `drive_share` in [vehicle]";
    assert_eq!(line("anti_lift_drive:"), both);
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");

    let columns = ["--columns", "toe,fvic_y,anti_dive,anti_squat", "--format", "csv"];
    let range = ["--from", "0", "--to", "0"];
    let done = hardpoint(&[&["sweep", name][..], &columns, &range].concat()).success();
    assert_eq!(stdout(&done), "toe_deg,fvic_y_mm,anti_dive_pct,anti_squat_pct\n0.1,,,\n");
    let told = stderr(&done);
    assert!(told.contains("`anti_dive` needs `cg_height` in [vehicle]"), "{told}");
    assert!(told.contains("`anti_squat` belongs to a rear axle"), "{told}");
    assert_eq!(told.lines().count(), 2, "{told}");
}

#[test]
fn columns_are_chosen_by_name() {
    let columns = ["--columns", "travel, bump_steer,motion_ratio,anti_dive", "--format", "csv"];
    let text = stdout(&hardpoint(&[&["sweep", SEDAN][..], &columns].concat()).success());
    let mut lines = text.lines();
    let header = "travel_mm,bump_steer_deg/m,motion_ratio,anti_dive_pct";
    assert_eq!(lines.next(), Some(header));
    assert_eq!(lines.clone().count(), 27);
    let middle: Vec<f64> = lines.nth(13).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let expected = [0.0, -35.98931632374049, 0.5193636028747222, 9.124784598601574];
    for (found, expected) in middle.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-10, "{middle:?}");
    }
    // A load event keeps the column of what changes; the table has definitions by the convention.
    let load = ["--event", "load", "--vary", "fx", "--travel", "0", "--columns", "camber"];
    let model = "models/bushed-double-wishbone.toml";
    let lotus = ["--convention", "lotus", "--step", "1000"];
    let text = stdout(&hardpoint(&[&["sweep", model][..], &load, &lotus].concat()).success());
    assert!(text.contains("as seen from the front") && text.contains("load_fx"), "{text}");
    assert!(!text.contains("spring"), "{text}");
}

#[test]
fn mistakes_say_what_to_do() {
    let unknown = hardpoint(&["sweep", SEDAN, "--columns", "toe,roll-center"]).failure().code(2);
    let told = stderr(&unknown);
    assert!(told.contains("no factor `roll-center`; did you mean `rc_height`?"), "{told}");
    let far = hardpoint(&["factors", SEDAN, "--travel", "1e9"]).failure().code(2);
    assert!(stderr(&far).contains("--travel is more than a kilometre"), "{}", stderr(&far));
    let stopped = hardpoint(&["factors", SEDAN, "--travel", "900"]).failure().code(3);
    assert!(stdout(&stopped).is_empty(), "no numbers of a state that was not reached");
    let four_bar = "models/four-bar.toml";
    let mechanism = hardpoint(&["factors", four_bar]).failure().code(2);
    assert!(stderr(&mechanism).contains("is a mechanism"), "{}", stderr(&mechanism));
    let columns = ["sweep", four_bar, "--from", "0", "--to", "9", "--columns", "toe"];
    let columns = hardpoint(&columns).failure().code(2);
    assert!(stderr(&columns).contains("--columns belongs to suspensions"), "{}", stderr(&columns));
    hardpoint(&["factors"]).failure().code(2);
    let over = hardpoint(&["factors", SEDAN, "-o", SEDAN]).failure().code(2);
    assert!(stderr(&over).contains("overwrite the model"), "{}", stderr(&over));
}
