//! Every wrong file says what is wrong, where, and what to do.
#![allow(missing_docs)]

use hardpoint::model::{Architecture, Model};

/// The folders hold TOML files, each wrong in the way that its name says; the
/// snapshot beside this file is the whole message.
#[test]
fn wrong_models() {
    insta::glob!("fixtures/wrong-models/*", |path| {
        // A relative path keeps the folder of the checkout out of the messages.
        let name = path.file_name().unwrap().to_str().unwrap();
        let error = Model::load(format!("tests/fixtures/wrong-models/{name}"));
        insta::assert_snapshot!(error.expect_err(name).render());
    });
}

#[test]
fn wrong_architectures() {
    insta::glob!("fixtures/wrong-architectures/*", |path| {
        let name = path.file_name().unwrap().to_str().unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        let error = Architecture::parse(&format!("architectures/{name}"), &text);
        insta::assert_snapshot!(error.expect_err(name).render());
    });
}
