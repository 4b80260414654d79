//! Histories of ADAMS and how exactly they are reproduced.
#![allow(dead_code, reason = "each test binary uses a part of it")]

use std::path::{Path, PathBuf};

/// Position 3, Euler parameters 4, velocity 3, angular velocity 3, acceleration 3, angular acceleration 3,
/// force and moment on the ground 6.
pub type Row = [f64; 25];

/// The parts of a row with their names.
pub const PARTS: [(&str, std::ops::Range<usize>); 8] = [
    ("position", 0..3),
    ("Euler parameters", 3..7),
    ("velocity", 7..10),
    ("angular velocity", 10..13),
    ("acceleration", 13..16),
    ("angular acceleration", 16..19),
    ("force", 19..22),
    ("moment", 22..25),
];

/// The largest differences of two rows, part by part.
fn differences(actual: &Row, expected: &Row) -> [f64; 8] {
    std::array::from_fn(|part| {
        let range = PARTS[part].1.clone();
        let largest = |sign: f64| {
            range.clone().map(|k| (actual[k] - sign * expected[k]).abs()).fold(0.0, f64::max)
        };
        // Both signs of Euler parameters are the same rotation.
        if part == 1 { largest(1.0).min(largest(-1.0)) } else { largest(1.0) }
    })
}

/// What ADAMS itself is accurate to in these histories, part by part.
fn allowed(name: &str) -> [f64; 8] {
    let mut allowed = [1e-5, 1e-5, 1e-5, 1e-5, 6e-3, 6e-3, 6e-3, 6e-3];
    match name {
        // Spherical_Case01 and Spherical_Case02 are one pendulum in two places. ADAMS differs by this
        // much between them, and the second is within 1e-5 of ours.
        "Spherical_Case01" | "Universal_Case01" | "Universal_Case02" | "Universal_Case03" => {
            allowed[..4].copy_from_slice(&[1.3e-5, 1e-5, 1.8e-4, 1e-4]);
        }
        "RotSpring_Case01" => allowed[2] = 1.1e-5,
        // Angular accelerations of 1000 rad/s² for a moment; shorter steps change nothing more.
        "Distance_Case02" => (allowed[3], allowed[5]) = (2e-5, 5e-2),
        _ => {}
    }
    allowed
}

/// The rows of one history that are carried along.
pub fn carried(name: &str) -> Vec<(f64, Row)> {
    let text = include_str!("../reference/adams-joints.csv");
    let rows: Vec<(f64, Row)> = text
        .lines()
        .filter(|line| line.split(',').next() == Some(name))
        .map(|line| {
            let mut numbers = line.split(',').skip(1).map(|number| number.parse().unwrap());
            (numbers.next().unwrap(), std::array::from_fn(|_| numbers.next().unwrap()))
        })
        .collect();
    assert_eq!(rows.len(), 3, "{name}");
    rows
}

/// The folder of the full histories, where it is beside the repository.
pub fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/reference/adams-joints");
    if !folder.exists() {
        eprintln!("skipped: {} is not there", folder.display());
        return None;
    }
    Some(folder)
}

/// Holds the largest differences of all rows against what is allowed.
pub fn hold(name: &str, rows: impl Iterator<Item = (Row, Row)>) {
    let mut worst = [0.0_f64; 8];
    for (actual, expected) in rows {
        let differences = differences(&actual, &expected);
        worst = std::array::from_fn(|part| worst[part].max(differences[part]));
    }
    for ((part, worst), allowed) in PARTS.iter().zip(worst).zip(allowed(name)) {
        assert!(worst < allowed, "{name}, {}: {worst:.1e}", part.0);
    }
}

/// All rows up to 1 s of a history.
pub fn history(folder: &Path, name: &str) -> Vec<(f64, Row)> {
    let parts = ["Pos", "Quat", "Vel", "Avel", "Acc", "Aacc", "Rforce", "Rtorque"];
    let mut rows: Vec<(f64, Vec<f64>)> = vec![];
    let file = |part: &str| {
        let name = format!("{name}_ADAMS_{part}.txt");
        let mut folders = std::fs::read_dir(folder).unwrap();
        let path = folders.find_map(|entry| {
            let path = entry.unwrap().path().join(&name);
            path.exists().then_some(path)
        });
        std::fs::read_to_string(path.unwrap_or_else(|| panic!("no {name}"))).unwrap()
    };
    for (part, name) in parts.into_iter().enumerate() {
        let text = file(name);
        let numbers = text.lines().filter_map(|line| {
            line.split_whitespace().map(|number| number.parse().ok()).collect::<Option<Vec<f64>>>()
        });
        let numbers = numbers.filter(|row| row.len() > 1 && row[0] < 1.0 + 1e-9);
        for (k, row) in numbers.enumerate() {
            if part == 0 {
                rows.push((row[0], vec![]));
            }
            rows[k].1.extend_from_slice(&row[1..]);
        }
    }
    assert_eq!(rows.len(), 101, "{name}");
    rows.into_iter().map(|(time, row)| (time, row.try_into().unwrap())).collect()
}
