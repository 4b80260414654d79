//! What ends a command early, and how it is told.

use std::io::{self, IsTerminal as _};
use std::process::ExitCode;

use hardpoint::model::{Axes, ModelDiagnostics};
use hardpoint::rig::{Missed, RigError};
use hardpoint::solve::compliance::ComplianceError;
use hardpoint::solve::dynamics::DynamicsFailure;
use hardpoint::solve::{StaticFailure, Stop};
use miette::GraphicalReportHandler;

use crate::output::axes_of_words;

/// Why a command did not end well.
pub enum Failure {
    /// The model file has mistakes.
    Model(ModelDiagnostics),
    /// The model makes no mechanism that moves.
    Rig(String, Box<RigError>),
    /// What is asked of a model does not go with it.
    Input(String, String),
    /// There is no static equilibrium; the axes are those of the model.
    Static(String, StaticFailure, Axes),
    /// A wheel has no compliance.
    Compliance(String, ComplianceError, Axes),
    /// The motion cannot go on.
    Motion(String, DynamicsFailure, Axes),
    /// The mechanism stopped during an event.
    Stopped(Vec<Stop>, String),
    /// States of an event or cases that were not reached.
    Missed(Vec<Missed>, String),
    /// What several events did not reach, in words.
    Incomplete(Vec<String>, String),
    /// No design meets all targets; says which are missed, or what contradicts each other.
    Unmet(String),
    /// A file or pipe that cannot be written; says which.
    Output(String, io::Error),
    /// Options that do not fit together.
    Usage(String),
}

impl From<ModelDiagnostics> for Failure {
    fn from(diagnostics: ModelDiagnostics) -> Self {
        Self::Model(diagnostics)
    }
}

impl Failure {
    /// Tells the failure on stderr and gives its exit code.
    pub fn report(self) -> ExitCode {
        match self {
            Self::Model(diagnostics) => {
                if io::stderr().is_terminal() {
                    eprint!("{}", diagnostics.render_with(&GraphicalReportHandler::new()));
                } else {
                    eprint!("{}", diagnostics.render());
                }
                ExitCode::from(1)
            }
            Self::Rig(model, error) => {
                eprintln!("error: {model}: {error}");
                ExitCode::from(1)
            }
            Self::Input(model, message) => {
                eprintln!("error: {model}: {message}");
                ExitCode::from(1)
            }
            Self::Static(model, failure, axes) => no_motion(&model, &failure, axes),
            Self::Compliance(model, error, axes) => no_motion(&model, &error, axes),
            Self::Motion(model, failure, axes) => no_motion(&model, &failure, axes),
            Self::Stopped(stops, rows) => {
                for stop in stops {
                    eprintln!("{stop}");
                }
                eprintln!("{rows}");
                ExitCode::from(3)
            }
            Self::Missed(missed, rows) => {
                for missed in missed {
                    eprintln!("{missed}");
                }
                eprintln!("{rows}");
                ExitCode::from(3)
            }
            Self::Incomplete(notes, rows) => {
                for note in notes {
                    eprintln!("{}", note.trim_end());
                }
                eprintln!("{rows}");
                ExitCode::from(3)
            }
            Self::Unmet(words) => {
                eprintln!("{}", words.trim_end());
                ExitCode::from(4)
            }
            // A reader that has seen enough, such as `head`, is no failure.
            Self::Output(_, error) if error.kind() == io::ErrorKind::BrokenPipe => {
                ExitCode::SUCCESS
            }
            Self::Output(what, error) => {
                eprintln!("error: {what} cannot be written: {error}; name another place with -o");
                ExitCode::from(1)
            }
            Self::Usage(message) => {
                eprintln!("error: {message}\n\nFor more information, try '--help'.");
                ExitCode::from(2)
            }
        }
    }
}

/// Tells why a model neither rests nor moves.
fn no_motion(model: &str, failure: &impl ToString, axes: Axes) -> ExitCode {
    let failure = failure.to_string();
    eprintln!("error: {model}: {failure}{}", axes_of_words(axes, &failure));
    ExitCode::from(3)
}
