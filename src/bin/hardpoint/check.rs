//! `hardpoint check`: is this model sound?

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use hardpoint::factors::FACTORS;
use hardpoint::model::{Model, Setup};
use hardpoint::rig::Corner;

use crate::failure::Failure;
use crate::load;
use crate::output::{Output, SideName, axes_of_words};

/// Check a model: mistakes in the file, degrees of freedom, redundant equations, free motions.
///
/// Prints what the model is and its factors at the design position.
#[derive(Args)]
#[command(after_help = "\
Examples:
  hardpoint check models/double-wishbone.toml
  hardpoint check models/adams-tr-front.toml --side right")]
pub struct Check {
    /// The model file.
    model: PathBuf,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
}

impl Check {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let model = load(&self.model, self.side)?;
        let corner = Corner::new(&model, &Setup::default())
            .map_err(|error| Failure::Rig(self.model.display().to_string(), error))?;
        Output::Stdout.write(|writer| write(writer, &model, &corner))
    }
}

fn write(writer: &mut dyn Write, model: &Model, corner: &Corner) -> io::Result<()> {
    let (units, pose) = (model.units, corner.pose());
    let length = units.length.symbol();
    writeln!(writer, "{}", model.name)?;
    if let Some(description) = &model.description {
        writeln!(writer, "{description}")?;
    }
    writeln!(writer)?;
    writeln!(writer, "architecture   {}", model.architecture.title())?;
    writeln!(writer, "side           {}", model.side.name())?;
    writeln!(writer, "axes           {}", model.axes.name())?;
    writeln!(writer, "units          {length}, {}", units.angle.symbol())?;
    let radius = units.length.from_metres(model.wheel_radius);
    writeln!(writer, "wheel radius   {radius} {length}")?;
    writeln!(writer)?;
    let mechanism = &corner.suspension().mechanism;
    let names = mechanism.joints().iter().map(|joint| joint.name.chars().count());
    let width = names.max().unwrap_or(0);
    for joint in mechanism.joints() {
        let [i, j] = [joint.i, joint.j].map(|body| mechanism.bodies()[body.index()].name.as_str());
        writeln!(writer, "{:<width$}  {:<13}  {i}–{j}", joint.name, joint.kind.name())?;
    }
    writeln!(writer)?;
    let freedom = corner.freedom().to_string();
    writeln!(writer, "{freedom}{}", axes_of_words(model.axes, &freedom))?;
    if corner.freedom().is_exact() {
        writeln!(writer, "no redundant equations, no free motions")?;
    }
    writeln!(writer)?;
    writeln!(writer, "at the design position:")?;
    for factor in FACTORS {
        if let Some(value) = factor.show(units, &pose) {
            let unit = factor.quantity.symbol(units);
            // Rounding noise of a value that is zero at design would only distract.
            let value = if value.abs() < 5e-10 { 0.0 } else { value };
            writeln!(writer, "{:<24} {value:>12.4} {unit:<4} {}", factor.title, factor.sign)?;
        }
    }
    Ok(())
}
