//! The command line of hardpoint.

mod architectures;
mod check;
mod compliance;
mod dangers;
mod draw;
mod equilibrium;
mod events;
mod export;
mod factors;
mod failure;
mod import;
mod loads;
mod output;
mod progress;
mod report;
mod rig;
mod sensitivity;
mod settings;
mod settle;
mod steering;
mod sweep;
mod synthesize;

use std::path::Path;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use hardpoint::model::{Document, Side};

use failure::Failure;
use output::SideName;

/// Suspension kinematics, compliance and design.
///
/// A model file holds the hard points of one corner of a vehicle in its own
/// units and axes; results come in the same.
#[derive(Parser)]
#[command(version, arg_required_else_help = true, after_help = EXIT_CODES)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  wrong input: the message says where and what to do
  2  wrong usage
  3  the mechanism stopped before the end of the event, or has no equilibrium; the states before it are written
  4  no design meets all targets: the message says which are missed, or which limits contradict each other";

#[derive(Subcommand)]
enum Command {
    Architectures(architectures::Architectures),
    Check(check::Check),
    Compliance(compliance::Compliance),
    Draw(draw::Draw),
    Equilibrium(equilibrium::Equilibrium),
    Export(export::Export),
    Factors(factors::Factors),
    Import(import::Import),
    Report(report::Report),
    Rig(rig::Rig),
    Sensitivity(sensitivity::Sensitivity),
    Settle(settle::Settle),
    Sweep(sweep::Sweep),
    Synthesize(synthesize::Synthesize),
}

fn main() -> ExitCode {
    let done = match Arguments::parse().command {
        Command::Architectures(command) => command.run(),
        Command::Check(command) => command.run(),
        Command::Compliance(command) => command.run(),
        Command::Draw(command) => command.run(),
        Command::Equilibrium(command) => command.run(),
        Command::Export(command) => command.run(),
        Command::Factors(command) => command.run(),
        Command::Import(command) => command.run(),
        Command::Report(command) => command.run(),
        Command::Rig(command) => command.run(),
        Command::Sensitivity(command) => command.run(),
        Command::Settle(command) => command.run(),
        Command::Sweep(command) => command.run(),
        Command::Synthesize(command) => command.run(),
    };
    done.map_or_else(Failure::report, |()| ExitCode::SUCCESS)
}

/// Whether a document is a suspension whose sides are one mechanism: commands then show both.
fn is_axle(document: &Document) -> bool {
    matches!(document, Document::Suspension(model) if model.is_axle())
}

/// Loads a file and, where asked for, turns a suspension into the other side.
fn load(path: &Path, side: Option<SideName>) -> Result<Document, Failure> {
    Ok(match (Document::load(path)?, side) {
        (Document::Suspension(model), Some(_)) if model.is_axle() => {
            let title = model.architecture.title();
            return Err(Failure::Usage(format!(
                "--side looks at one corner; the two sides of `{title}` are one mechanism"
            )));
        }
        (Document::Suspension(model), Some(side)) if Side::from(side) != model.side => {
            Document::Suspension(model.other_side())
        }
        (Document::Mechanism(_), Some(_)) => {
            return Err(Failure::Usage(
                "--side belongs to suspensions; this file is a mechanism".into(),
            ));
        }
        (document, _) => document,
    })
}
