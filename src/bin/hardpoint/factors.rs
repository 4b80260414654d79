//! `hardpoint factors`: all design factors at one state.

use std::path::{Path, PathBuf};

use clap::Args;
use hardpoint::model::{Chassis, Document, Model, WheelSupport};
use hardpoint::report::{FactorSheet, write_definitions};
use hardpoint::rig::Corner;

use crate::failure::Failure;
use crate::load;
use crate::loads::{RigOptions, length};
use crate::output::{ConventionName, Format, Output, SideName, axes_of_words};

/// List all design factors of a corner at one state, or the definitions of all factors.
///
/// Steer axis, instant centres, roll centre, anti-dive, motion ratio and all others, with unit and
/// sign. Gradients are exact slopes. Where the model has forces, the state is one of static equilibrium.
#[derive(Args)]
#[command(after_help = "\
Anti-dive and its like need the section [vehicle] of the model; what is missing is listed below the
factors. A value that is not defined at the state, such as an instant centre at infinity, is –.

Examples:
  hardpoint factors models/double-wishbone.toml
  hardpoint factors models/double-wishbone.toml --travel 30 --rack -5 --side right
  hardpoint factors models/lotus-front.toml --convention lotus --drive contact-patch --travel 15
  hardpoint factors models/double-wishbone.toml --format csv -o factors.csv
  hardpoint factors --list")]
pub struct Factors {
    /// The model file.
    #[arg(required_unless_present = "list")]
    model: Option<PathBuf>,
    /// Print the definitions of all factors: name, symbol, unit, sign, formula, source.
    #[arg(long, conflicts_with = "model")]
    list: bool,
    /// Wheel travel from the design position or the static state of the model, + jounce [default: 0].
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    travel: Option<f64>,
    /// Rack displacement, + along the model's +y [default: 0].
    #[arg(long, allow_negative_numbers = true, value_name = "R")]
    rack: Option<f64>,
    #[command(flatten)]
    rig: RigOptions,
    /// Whose definitions to follow where programs differ.
    #[arg(long, value_enum, default_value = "iso")]
    convention: ConventionName,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
    /// How to write the factors [default: table, or what the ending of the file names].
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Write to a file instead of the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Factors {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let Some(path) = &self.model else {
            let output = self.output.clone().map_or(Output::Stdout, Output::File);
            return output.write(|writer| write_definitions(writer));
        };
        let document = load(path, self.side)?;
        // Refused before the work is done.
        let output = Output::beside(path, self.output.as_deref())?;
        match document {
            Document::Suspension(model) => self.corner(&self.rig.set(model)?, path, &output),
            Document::Mechanism(_) => Err(Failure::Usage(
                "factors belong to suspensions; this file is a mechanism".into(),
            )),
        }
    }

    fn corner(&self, model: &Model, path: &Path, output: &Output) -> Result<(), Failure> {
        let travel = length("--travel", self.travel, model.units)?;
        let rack = length("--rack", self.rack, model.units)?;
        let setup = self.rig.setup(WheelSupport::Held, Chassis::Fixed);
        let load = self.rig.load(model)?;
        let mut corner = Corner::with_loads(model, &setup, self.rig.point())
            .map_err(|error| Failure::Rig(path.display().to_string(), Box::new(error)))?;
        if rack != 0.0 && !corner.steers() {
            let message = "this suspension has no rack; leave out --rack";
            return Err(Failure::Usage(message.into()));
        }
        corner.set_load(&load);
        corner.move_to(travel, rack).map_err(|stop| {
            let axes = axes_of_words(model.axes, &stop.to_string());
            Failure::Stopped(vec![stop], format!("the state was not reached{axes}"))
        })?;
        for motion in corner.free_wheel_motions() {
            let motion = &motion.description;
            let axes = axes_of_words(model.axes, motion);
            eprintln!(
                "warning: no joint holds this motion: {motion}{axes}; values that depend on it are not \
                 determined by the model. Add a joint"
            );
        }
        let sheet = FactorSheet {
            name: &model.name,
            units: model.units,
            drive: self.rig.drive(),
            convention: self.convention.into(),
            pose: &corner.pose(),
            adjustments: corner.adjustments(),
        };
        let named = self.output.as_deref().and_then(Format::of);
        output.write(|writer| match self.format.or(named).unwrap_or(Format::Table) {
            Format::Table => sheet.write_table(writer),
            Format::Csv => sheet.write_csv(writer),
            Format::Json => sheet.write_json(writer),
        })
    }
}
