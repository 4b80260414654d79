//! `hardpoint import`: a file of another program becomes a model or a mechanism file.

use std::fs;
use std::path::PathBuf;

use clap::Args;
use hardpoint::import::{Imported, adm, import};

use crate::failure::Failure;
use crate::output::Output;

/// Make a model or mechanism file of a file of another program.
///
/// What is not taken over is listed with its line.
#[derive(Args)]
#[command(after_help = "\
Examples:
  hardpoint import pendulum.adm -o pendulum.toml
  hardpoint import suspension.adm --lenient")]
pub struct Import {
    /// The file; its ending says what it is: .adm is an Adams/Solver dataset.
    file: PathBuf,
    /// Write the model to this file.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Leave out what hardpoint does not have, too, although the mechanism is then another one.
    #[arg(long)]
    lenient: bool,
}

impl Import {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let output = Output::beside(&self.file, self.output.as_deref())?;
        let name = self.file.display().to_string();
        let bytes = fs::read(&self.file).map_err(|error| {
            Failure::Usage(format!("{name} cannot be read: {error}; name a file that exists"))
        })?;
        // Names in comments may be in any encoding; keywords and numbers are plain.
        let text = String::from_utf8_lossy(&bytes);
        let dataset =
            self.file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("adm"));
        let imported =
            if dataset { adm::import(&name, &text, self.lenient) } else { import(&name, &text) };
        let Imported { text, left_out, assumed } =
            imported.map_err(|error| Failure::Model(error.diagnostics().clone()))?;
        output.write(|writer| writer.write_all(text.as_bytes()))?;
        for part in left_out {
            eprintln!("{name}:{}: {} is left out: {}", part.line, part.what, part.why);
        }
        for what in assumed {
            eprintln!("{name}: {what}");
        }
        Ok(())
    }
}
