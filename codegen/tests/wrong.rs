//! Every mistake in a relation file is told with its place and what to do.

use std::path::{Path, PathBuf};

use hardpoint_codegen::source::{Source, read_folder};
use hardpoint_codegen::{Error, generate};

fn fixtures() -> Vec<Source> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/wrong");
    let sources = read_folder(&folder).expect("the fixtures can be read");
    // Messages name the file, but must not depend on where the repository lies.
    sources
        .into_iter()
        .map(|source| {
            let name = source.path.file_name().map(PathBuf::from).unwrap_or_default();
            Source::new(name, source.text)
        })
        .collect()
}

#[test]
fn each_wrong_file_has_its_message() {
    let fixtures = fixtures();
    assert!(fixtures.len() >= 25);
    for source in fixtures {
        let name = source.name.clone();
        match generate(vec![source]) {
            Err(error @ Error::Mistakes(_)) => insta::assert_snapshot!(name, error.to_string()),
            other => panic!("{name} was accepted or failed otherwise: {other:?}"),
        }
    }
}

#[test]
fn mistakes_of_all_files_are_told_at_once() {
    let fixtures = fixtures();
    let count = fixtures.len();
    let Err(Error::Mistakes(files)) = generate(fixtures) else {
        panic!("wrong files were accepted")
    };
    assert_eq!(files.len(), count);
}

#[test]
fn two_files_may_not_give_one_type() {
    let text =
        "format = 1\ntitle = \"t\"\nequation = \"e\"\nreference = \"r\"\nresidual = \"r_i[0]\"\n";
    let sources = vec![Source::new("arm_1.toml", text), Source::new("arm1.toml", text)];
    let Err(error @ Error::Mistakes(_)) = generate(sources) else {
        panic!("two relations of one type were accepted")
    };
    let message = error.to_string();
    assert!(message.contains("`arm_1` and `arm1` both give the type `Arm1`"), "{message}");
}
