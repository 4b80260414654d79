//! Every command of the guides runs.
#![allow(missing_docs)]

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use tempfile::TempDir;

/// The commands of a guide: the lines of its `sh` blocks, with the exit codes that comments behind them tell.
fn commands(text: &str) -> Vec<(Vec<String>, i32)> {
    let blocks = text.split("```sh\n").skip(1);
    let lines = blocks.flat_map(|block| block.split("```").next().unwrap().lines());
    let command = |line: &str| {
        let (command, comment) = line.split_once('#').unwrap_or((line, ""));
        let code =
            comment.trim().strip_prefix("exit code ").map_or(0, |code| code.parse().unwrap());
        (command.split_whitespace().map(str::to_owned).collect(), code)
    };
    lines.map(command).collect()
}

fn copy(folder: &str, to: &Path) {
    let to = to.join(folder);
    fs::create_dir(&to).unwrap();
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap() {
        let entry = entry.unwrap();
        fs::copy(entry.path(), to.join(entry.file_name())).unwrap();
    }
}

#[test]
fn every_command_of_the_guides_runs() {
    let folder = TempDir::new().unwrap();
    for name in ["models", "requests"] {
        copy(name, folder.path());
    }
    let mut count = 0;
    for entry in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/guides")).unwrap() {
        let path = entry.unwrap().path();
        for (words, code) in commands(&fs::read_to_string(&path).unwrap()) {
            assert_eq!(words[0], "hardpoint", "{}", path.display());
            let mut command = Command::cargo_bin("hardpoint").unwrap();
            command.current_dir(folder.path()).args(&words[1..]).assert().code(code);
            count += 1;
        }
    }
    assert!(count > 10, "{count}");
    // What the guides promise of the files that they write.
    for (name, there) in [("flat.toml", true), ("tight.toml", true), ("none.toml", false)] {
        assert_eq!(folder.path().join(name).exists(), there, "{name}");
    }
}

/// Requests that guides show in part are those of the folder, line by line.
#[test]
fn guides_show_the_requests_as_they_are() {
    let requests = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/requests")).unwrap();
    let requests: Vec<String> =
        requests.map(|entry| fs::read_to_string(entry.unwrap().path()).unwrap()).collect();
    let plain = |line: &str| line.split('#').next().unwrap().trim().to_owned();
    let known: Vec<Vec<String>> =
        requests.iter().map(|text| text.lines().map(plain).collect()).collect();
    for entry in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/guides")).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        for block in text.split("```toml\n").skip(1) {
            let lines: Vec<String> =
                block.split("```").next().unwrap().lines().map(plain).collect();
            let has = |request: &&Vec<String>| lines.iter().all(|line| request.contains(line));
            assert!(known.iter().find(has).is_some(), "{}:\n{}", path.display(), lines.join("\n"));
        }
    }
}
