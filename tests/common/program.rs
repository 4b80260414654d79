//! The program as a user runs it.
#![allow(dead_code, reason = "each test binary uses a part of it")]

use assert_cmd::Command;
use assert_cmd::assert::Assert;

/// Runs the program in the folder of the project.
pub fn hardpoint(arguments: &[&str]) -> Assert {
    Command::cargo_bin("hardpoint")
        .expect("the program is built")
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(arguments)
        .assert()
}

/// What it wrote.
pub fn stdout(assert: &Assert) -> String {
    String::from_utf8(assert.get_output().stdout.clone()).expect("the output is text")
}

/// What it told.
pub fn stderr(assert: &Assert) -> String {
    String::from_utf8(assert.get_output().stderr.clone()).expect("the messages are text")
}

/// What it wrote with `--format json`.
pub fn json(arguments: &[&str]) -> serde_json::Value {
    let arguments = [arguments, &["--format", "json"]].concat();
    serde_json::from_str(&stdout(&hardpoint(&arguments).success())).expect("the output is JSON")
}

/// The numbers of one column of a CSV text.
pub fn column(text: &str, name: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let headers = reader.headers().expect("there is a header").clone();
    let index = headers.iter().position(|header| header == name);
    let index = index.unwrap_or_else(|| panic!("no column {name} in {headers:?}"));
    reader.records().map(|row| row.unwrap()[index].parse().unwrap()).collect()
}
