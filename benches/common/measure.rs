//! How long things are measured, and the ratios at the end of a run.

use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};
use std::{env, fs};

use criterion::Criterion;

/// The alternative that all others of a group are divided by.
pub const BASE: &str = "symbolic";

/// Runs groups of benchmarks and prints their ratios.
pub fn run(groups: impl FnOnce(&mut Criterion)) {
    let start = SystemTime::now();
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(1000))
        .sample_size(30)
        .configure_from_args();
    groups(&mut criterion);
    criterion.final_summary();
    // `cargo test --benches` only tries whether everything runs.
    if env::args().any(|argument| argument == "--bench") {
        print_ratios(start);
    }
}

/// Prints the medians that criterion has stored since `start`, divided by the
/// base of their group.
fn print_ratios(start: SystemTime) {
    let mut measured = vec![];
    medians(&results(), start, &mut measured);
    measured.sort_by(|a, b| (&a.0, a.2).partial_cmp(&(&b.0, b.2)).expect("times are numbers"));
    let base = |group: &str| {
        measured.iter().find(|(of, function, _)| of == group && function == BASE).map(|m| m.2)
    };
    println!("time divided by that of `{BASE}`");
    for (group, function, median) in &measured {
        if let Some(base) = base(group) {
            println!("{group:<28} {function:<40} {:8.2}", median / base);
        }
    }
}

/// Where criterion writes, by its own rules.
fn results() -> PathBuf {
    match env::var_os("CRITERION_HOME") {
        Some(home) => home.into(),
        None => Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("criterion"),
    }
}

/// Group, function and median (ns) of every result below a folder.
fn medians(folder: &Path, start: SystemTime, found: &mut Vec<(String, String, f64)>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.ends_with("new") {
            found.extend(median(&path, start));
        } else if path.is_dir() {
            medians(&path, start, found);
        }
    }
}

fn median(folder: &Path, start: SystemTime) -> Option<(String, String, f64)> {
    let estimates = folder.join("estimates.json");
    if fs::metadata(&estimates).ok()?.modified().ok()? < start {
        return None;
    }
    let read = |path: &Path| -> Option<serde_json::Value> {
        serde_json::from_str(&fs::read_to_string(path).ok()?).ok()
    };
    let name = read(&folder.join("benchmark.json"))?;
    let median = read(&estimates)?["median"]["point_estimate"].as_f64()?;
    let part = |key: &str| name[key].as_str().map(str::to_owned);
    Some((part("group_id")?, part("function_id")?, median))
}
