//! The examples of all help texts run as they are printed.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use std::path::Path;

use assert_cmd::Command;
use program::{hardpoint, stdout};

const COMMANDS: [&str; 11] = [
    "check",
    "compliance",
    "equilibrium",
    "export",
    "factors",
    "import",
    "report",
    "rig",
    "sensitivity",
    "settle",
    "sweep",
];

/// The arguments of the examples in the help of a command.
fn examples(command: &str) -> Vec<Vec<String>> {
    let help = stdout(&hardpoint(&[command, "--help"]).success());
    let (_, examples) = help.split_once("Examples:\n").expect(command);
    // A long example goes on in a line of its own.
    let examples = examples.split("  hardpoint ").skip(1);
    examples.map(|example| example.split_whitespace().map(str::to_owned).collect()).collect()
}

/// Those that end soon, with files that are here.
fn runs(example: &[String]) -> bool {
    let slow = example[0] == "settle" || example[0] == "rig" && example[1].contains("sedan");
    let file = example.iter().find(|word| !word.starts_with('-') && word.contains('.'));
    let there = file.is_none_or(|file| Path::new(env!("CARGO_MANIFEST_DIR")).join(file).exists());
    there && !slow
}

#[test]
fn examples_of_the_help_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = |word: &String| match word.strip_prefix("models/") {
        Some(file) => format!("{}/models/{file}", env!("CARGO_MANIFEST_DIR")),
        None => word.clone(),
    };
    let mut count = 0;
    for example in COMMANDS.into_iter().flat_map(examples).filter(|example| runs(example)) {
        let mut program = Command::cargo_bin("hardpoint").expect("the program is built");
        program.current_dir(folder.path()).args(example.iter().map(here)).assert().success();
        count += 1;
    }
    assert!(count >= 30, "only {count} examples");
}
