//! Every wrong file says what is wrong, where, and what to do.
#![allow(missing_docs)]

use hardpoint::model::{Architecture, Document, Model, ModelDiagnostics};

/// The folders hold TOML files, each wrong in the way that its name says; the
/// snapshot is the whole message.
#[test]
fn wrong_models() {
    insta::glob!("fixtures/wrong-models/*", |path| {
        // A relative path keeps the folder of the checkout out of the messages.
        let name = path.file_name().unwrap().to_str().unwrap();
        let error = Model::load(format!("tests/fixtures/wrong-models/{name}"));
        let error = error.expect_err(name);
        insta::assert_snapshot!(error.render());
        if name != "not-utf8.toml" {
            check(name, &error);
        }
    });
}

#[test]
fn wrong_mechanisms() {
    insta::glob!("fixtures/wrong-mechanisms/*", |path| {
        let name = path.file_name().unwrap().to_str().unwrap();
        let error = Document::load(format!("tests/fixtures/wrong-mechanisms/{name}"));
        let error = error.expect_err(name);
        insta::assert_snapshot!(error.render());
        check(name, &error);
    });
}

#[test]
fn wrong_architectures() {
    insta::glob!("fixtures/wrong-architectures/*", |path| {
        let name = path.file_name().unwrap().to_str().unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        let error = Architecture::parse(&format!("architectures/{name}"), &text);
        let error = error.expect_err(name);
        insta::assert_snapshot!(error.render());
        check(name, &error);
    });
}

/// Whatever the message, it has a place and says what to do.
fn check(name: &str, error: &ModelDiagnostics) {
    assert!(!error.mistakes().is_empty(), "{name}");
    for mistake in error.mistakes() {
        let message = mistake.message();
        assert!(mistake.line_and_column().is_some(), "{name}: no place: {message}");
        let help = miette::Diagnostic::help(mistake).map(|help| help.to_string());
        assert!(help.is_some_and(|help| help.len() > 5), "{name}: no help: {message}");
    }
}
