//! `hardpoint factors`: all design factors at one state.

use std::path::{Path, PathBuf};

use clap::Args;
use hardpoint::model::{Axes, Chassis, Document, Model, WheelSupport};
use hardpoint::report::{FactorSheet, write_definitions};
use hardpoint::rig::{Adjustment, Axle, Corner, Pose, RigError};
use hardpoint::solve::{FreeMotion, Stop};

use crate::failure::Failure;
use crate::loads::{RigOptions, length};
use crate::output::{ConventionName, Format, Output, SideName, axes_of_words, warn_of_free};
use crate::steering::SteeringOptions;
use crate::{is_axle, load};

/// List all design factors of a corner or an axle at one state, or the definitions of all factors.
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
  hardpoint factors models/sedan-axle.toml --axle
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
    /// Put both sides on the rig: the model and its mirror image. Some factors, such as Ackermann, are those of both
    /// wheels together.
    #[arg(long, conflicts_with = "side")]
    axle: bool,
    /// Wheel travel from the design position or the static state of the model, + jounce [default: 0]. Both
    /// wheels of an axle.
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    travel: Option<f64>,
    #[command(flatten)]
    steering: SteeringOptions,
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

/// The wheels at the state, and what their adjusters are set to.
type State = (Vec<Pose<f64>>, Vec<Adjustment>);

impl Factors {
    /// Runs the command.
    pub fn run(mut self) -> Result<(), Failure> {
        let Some(path) = self.model.clone() else {
            let output = self.output.clone().map_or(Output::Stdout, Output::File);
            return output.write(|writer| write_definitions(writer));
        };
        let document = load(&path, self.side)?;
        self.axle |= is_axle(&document);
        // Refused before the work is done.
        let output = Output::beside(&path, self.output.as_deref())?;
        match document {
            Document::Suspension(model) => self.suspension(&self.rig.set(model)?, &path, &output),
            Document::Mechanism(_) => Err(Failure::Usage(
                "factors belong to suspensions; this file is a mechanism".into(),
            )),
        }
    }

    fn suspension(&self, model: &Model, path: &Path, output: &Output) -> Result<(), Failure> {
        let travel = length("--travel", self.travel, model.units)?;
        let rack = self.steering.rack(model)?;
        let rig = |error| Failure::Rig(path.display().to_string(), Box::new(error));
        let (poses, adjustments) = if self.axle {
            self.axle(model, travel, rack, rig)?
        } else {
            self.corner(model, travel, rack, rig)?
        };
        let sheet = FactorSheet {
            name: &model.name,
            units: model.units,
            drive: self.rig.drive(),
            convention: self.convention.into(),
            poses: &poses,
            adjustments: &adjustments,
        };
        let named = self.output.as_deref().and_then(Format::of);
        output.write(|writer| match self.format.or(named).unwrap_or(Format::Table) {
            Format::Table => sheet.write_table(writer),
            Format::Csv => sheet.write_csv(writer),
            Format::Json => sheet.write_json(writer),
        })
    }

    fn corner(
        &self,
        model: &Model,
        travel: f64,
        rack: f64,
        rig: impl Fn(RigError) -> Failure,
    ) -> Result<State, Failure> {
        let setup = self.rig.setup(WheelSupport::Held, Chassis::Fixed);
        let load = self.rig.load(model)?;
        let mut corner = Corner::with_loads(model, &setup, self.rig.point()).map_err(rig)?;
        corner.measure_compliance(true);
        corner.set_load(&load);
        corner.move_to(travel, rack).map_err(|stop| not_reached(stop, model.axes))?;
        warn_of_free(corner.free_wheel_motions().map(words), model.axes);
        Ok((vec![corner.pose()], corner.adjustments().to_vec()))
    }

    fn axle(
        &self,
        model: &Model,
        travel: f64,
        rack: f64,
        rig: impl Fn(RigError) -> Failure,
    ) -> Result<State, Failure> {
        let setup = self.rig.setup(WheelSupport::Held, Chassis::Fixed);
        let load = self.rig.axle_loads(model)?;
        let mut axle = Axle::with_loads(model, &setup, self.rig.point()).map_err(rig)?;
        axle.measure_compliance(true);
        axle.set_load(&load);
        axle.move_to([travel; 2], rack).map_err(|stop| not_reached(stop, model.axes))?;
        warn_of_free(axle.free_wheel_motions().map(words), model.axes);
        Ok((axle.poses().to_vec(), axle.adjustments().to_vec()))
    }
}

fn not_reached(stop: Stop, axes: Axes) -> Failure {
    let axes = axes_of_words(axes, &stop.to_string());
    Failure::Stopped(vec![stop], format!("the state was not reached{axes}"))
}

fn words(motion: &FreeMotion) -> &str {
    &motion.description
}
