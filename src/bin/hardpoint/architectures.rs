//! `hardpoint architectures`: which suspensions there are, and what they are made of.

use std::path::{Path, PathBuf};

use clap::Args;
use hardpoint::model::Architecture;
use hardpoint::report::{write_architecture, write_architectures, write_catalogue};

use crate::failure::Failure;
use crate::output::Output;

/// List the architectures, or show the points, bodies, joints and free motions of one.
///
/// An architecture is a file; docs/architectures.md shows how to write one's own.
#[derive(Args)]
#[command(after_help = "\
Examples:
  hardpoint architectures
  hardpoint architectures macpherson
  hardpoint architectures my-suspension.toml")]
pub struct Architectures {
    /// A built-in architecture, or a file that ends in .toml.
    #[arg(conflicts_with = "list")]
    name: Option<String>,
    /// Write all built-in architectures as Markdown.
    #[arg(long)]
    list: bool,
    /// Write to this file.
    #[arg(short, long)]
    output: Option<PathBuf>,
}

impl Architectures {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let Some(name) = &self.name else {
            let output = self.output.clone().map_or(Output::Stdout, Output::File);
            let list = self.list;
            return output.write(|writer| match list {
                true => write_catalogue(writer),
                false => write_architectures(writer),
            });
        };
        let output = Output::beside(Path::new(name), self.output.as_deref())?;
        let architecture = match Architecture::built_in(name) {
            Some(architecture) => architecture?,
            None if name.ends_with(".toml") => Architecture::load(name)?,
            None => {
                return Err(Failure::Usage(format!(
                    "there is no built-in architecture `{name}`; they are {}, and a file of your own ends in .toml",
                    Architecture::built_in_names().join(", ")
                )));
            }
        };
        output.write(|writer| write_architecture(writer, name, &architecture))
    }
}
