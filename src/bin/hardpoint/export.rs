//! `hardpoint export`: models as files of other programs.

use std::fs;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use hardpoint::export::{self, Format};
use hardpoint::import::text_of;

use crate::failure::Failure;
use crate::output::Output;

/// Write a model as a file of another program.
///
/// What the format has no place for is listed on stderr. `hardpoint import` reads all of them again,
/// with
/// the same numbers.
#[derive(Args)]
#[command(after_help = "\
Examples:
  hardpoint export models/double-wishbone.toml --to csv -o points.csv
  hardpoint export models/adams-tr-front.toml --to adams -o front.sub
  hardpoint export models/quarter-car.toml --to json")]
pub struct Export {
    /// The model or mechanism file.
    model: PathBuf,
    /// The format: csv has the points, adams is a subsystem with hard points and static angles, json
    /// has the whole model.
    #[arg(long, value_enum)]
    to: FormatName,
    /// Write to this file instead of the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// A format.
#[derive(Clone, Copy, ValueEnum)]
enum FormatName {
    Csv,
    Adams,
    Json,
}

impl Export {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let output = Output::beside(&self.model, self.output.as_deref())?;
        let format = match self.to {
            FormatName::Csv => Format::Csv,
            FormatName::Adams => Format::Adams,
            FormatName::Json => Format::Json,
        };
        let name = self.model.display().to_string();
        let bytes = fs::read(&self.model)
            .map_err(|error| Failure::Usage(format!("`{name}` cannot be read: {error}")))?;
        let exported = export::export(&name, &text_of(bytes), format)?;
        output.write(|writer| writer.write_all(exported.text.as_bytes()))?;
        if !exported.left_out.is_empty() {
            eprintln!("left out, because the format has no place for it:");
            for item in &exported.left_out {
                eprintln!("  {item}");
            }
        }
        Ok(())
    }
}
