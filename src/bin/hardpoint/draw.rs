//! `hardpoint draw`: the points of a model in three views.

use std::path::PathBuf;

use clap::Args;
use hardpoint::model::{Document, SuspensionError};
use hardpoint::report::drawing;
use hardpoint::rig::RigError;

use crate::failure::Failure;
use crate::load;
use crate::output::{Output, SideName};

/// Draw a model at its design position: front, side and top view as SVG.
///
/// Bodies are lines between their joints; squares are joints on the chassis.
#[derive(Args)]
#[command(after_help = "\
Examples:
  hardpoint draw models/macpherson.toml -o macpherson.svg")]
pub struct Draw {
    /// The model file.
    model: PathBuf,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
    /// Write to this file.
    #[arg(short, long)]
    output: Option<PathBuf>,
}

impl Draw {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let output = Output::beside(&self.model, self.output.as_deref())?;
        let Document::Suspension(model) = load(&self.model, self.side)? else {
            return Err(Failure::Usage(
                "drawings are of suspensions; this file is a mechanism".into(),
            ));
        };
        let svg = drawing(&model).map_err(|error: SuspensionError| {
            Failure::Rig(self.model.display().to_string(), Box::new(RigError::from(error)))
        })?;
        output.write(|writer| writer.write_all(svg.as_bytes()))
    }
}
