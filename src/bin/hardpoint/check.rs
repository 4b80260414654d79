//! `hardpoint check`: is this model sound?

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use hardpoint::factors::FACTORS;
use hardpoint::mechanism::{BodyId, Force};
use hardpoint::model::{Axes, Document, MechanismModel, Model, Setup};
use hardpoint::rig::{Corner, Pose, Stand};

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
    /// The model or mechanism file.
    model: PathBuf,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
}

impl Check {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let rig = |error| Failure::Rig(self.model.display().to_string(), error);
        match load(&self.model, self.side)? {
            Document::Suspension(model) => {
                let mut corner = Corner::new(&model, &Setup::default()).map_err(rig)?;
                let pose = corner.pose();
                Output::Stdout.write(|writer| suspension(writer, &model, &corner, &pose))
            }
            Document::Mechanism(model) => {
                let stand = Stand::new(model.mechanism.clone(), &[], Axes::Iso8855)
                    .map_err(|error| rig(error.into()))?;
                Output::Stdout.write(|writer| mechanism(writer, &model, &stand))
            }
        }
    }
}

fn suspension(
    writer: &mut dyn Write,
    model: &Model,
    corner: &Corner,
    pose: &Pose<f64>,
) -> io::Result<()> {
    let units = model.units;
    let length = units.length.symbol();
    header(writer, &model.name, model.description.as_deref())?;
    writeln!(writer, "architecture   {}", model.architecture.title())?;
    writeln!(writer, "side           {}", model.side.name())?;
    writeln!(writer, "axes           {}", model.axes.name())?;
    writeln!(writer, "units          {length}, {}", units.angle.symbol())?;
    let radius = units.length.from_metres(model.wheel_radius);
    writeln!(writer, "wheel radius   {radius} {length}")?;
    writeln!(writer)?;
    parts(writer, corner.stand(), corner.own_forces(), model.axes)?;
    writeln!(writer)?;
    writeln!(writer, "at the design position:")?;
    for factor in FACTORS {
        if let Some(value) = factor.show(units, pose) {
            let unit = factor.quantity.symbol(units);
            // Rounding noise of a value that is zero at design would only distract.
            let value = if value.abs() < 5e-10 { 0.0 } else { value };
            writeln!(writer, "{:<24} {value:>12.4} {unit:<4} {}", factor.title, factor.sign)?;
        }
    }
    Ok(())
}

fn mechanism(writer: &mut dyn Write, model: &MechanismModel, stand: &Stand) -> io::Result<()> {
    header(writer, &model.name, model.description.as_deref())?;
    let units = model.units;
    writeln!(writer, "units          {}, {}", units.length.symbol(), units.angle.symbol())?;
    writeln!(writer)?;
    parts(writer, stand, stand.mechanism().forces(), Axes::Iso8855)
}

fn header(writer: &mut dyn Write, name: &str, description: Option<&str>) -> io::Result<()> {
    writeln!(writer, "{name}")?;
    if let Some(description) = description {
        writeln!(writer, "{description}")?;
    }
    writeln!(writer)
}

/// Joints and force elements, then what they leave free.
fn parts(writer: &mut dyn Write, stand: &Stand, forces: &[Force], axes: Axes) -> io::Result<()> {
    let mechanism = stand.mechanism();
    let names = mechanism.joints().iter().map(|joint| &joint.name);
    let names = names.chain(mechanism.drivers().iter().map(|driver| &driver.name));
    let width =
        names.chain(forces.iter().map(|force| &force.name)).map(|name| name.chars().count());
    let width = width.max().unwrap_or(0);
    let body = |id: BodyId| mechanism.bodies()[id.index()].name.as_str();
    for joint in mechanism.joints() {
        let (kind, i, j) = (joint.kind.name(), body(joint.i), body(joint.j));
        writeln!(writer, "{:<width$}  {kind:<13}  {i}–{j}", joint.name)?;
    }
    for force in forces {
        let (kind, i, j) = (force.kind.name(), body(force.i), body(force.j));
        writeln!(writer, "{:<width$}  {kind:<13}  {i}–{j}", force.name)?;
    }
    writeln!(writer)?;
    let freedom = stand.freedom().to_string();
    writeln!(writer, "{freedom}{}", axes_of_words(axes, &freedom))?;
    if stand.freedom().is_exact() {
        writeln!(writer, "no redundant equations, no free motions")?;
    } else if !forces.is_empty() && !stand.freedom().free_motions.is_empty() {
        writeln!(writer, "what joints leave free, forces may hold: see `hardpoint equilibrium`")?;
    }
    Ok(())
}
