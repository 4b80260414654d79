//! Every wrong request says what is wrong, where, and what to do.
#![allow(missing_docs)]

use hardpoint::design::request::Request;
use hardpoint::model::Model;

/// Each file is wrong in the way that its name says; the snapshot is the whole message. A first line such as
/// `# model: models/trailing-arm.toml` names the model.
#[test]
fn wrong_requests() {
    insta::glob!("fixtures/wrong-requests/*.toml", |path| {
        // A relative path keeps the folder of the checkout out of the messages.
        let name = path.file_name().unwrap().to_str().unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        let named = text.lines().next().and_then(|line| line.strip_prefix("# model: "));
        let model = Model::load(named.unwrap_or("models/sedan-axle.toml"));
        let model = model.unwrap_or_else(|error| panic!("{name}: {}", error.render()));
        let error = Request::load(format!("tests/fixtures/wrong-requests/{name}"), &model);
        let error = error.expect_err(name);
        insta::assert_snapshot!(error.render());
        assert!(!error.mistakes().is_empty(), "{name}");
        for mistake in error.mistakes() {
            let message = mistake.message();
            assert!(mistake.line_and_column().is_some(), "{name}: no place: {message}");
            let help = miette::Diagnostic::help(mistake).map(|help| help.to_string());
            assert!(help.is_some_and(|help| help.len() > 5), "{name}: no help: {message}");
        }
    });
}
