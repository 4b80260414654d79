//! The committed kernels are those that the default build derives.
#![cfg(feature = "symbolic")]

use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, str};

const ADVICE: &str = "rewrite the committed kernels with `cargo run -p hardpoint-codegen -- write`";

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}; {ADVICE}", folder.display()))
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .map(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            (name, fs::read(&path).expect("the file can be read"))
        })
        .collect()
}

#[test]
fn committed_kernels_equal_those_of_the_default_build() {
    let derived = files(Path::new(env!("OUT_DIR")));
    let committed = files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("kernels"));
    assert!(!derived.is_empty());
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&derived), names(&committed), "{ADVICE}");
    for (name, text) in &derived {
        if text != &committed[name] {
            let lines = |bytes: &[u8]| -> Vec<String> {
                str::from_utf8(bytes).unwrap_or("").lines().map(str::to_owned).collect()
            };
            let (derived, committed) = (lines(text), lines(&committed[name]));
            let line = derived.iter().zip(&committed).position(|(a, b)| a != b);
            let line = line.unwrap_or(derived.len().min(committed.len())) + 1;
            panic!("kernels/{name} differs from what is derived, first in line {line}; {ADVICE}");
        }
    }
}
