//! `hardpoint compliance`: how wheels give way to loads.

use std::path::PathBuf;

use clap::Args;
use hardpoint::model::{Axes, Chassis, Document, Model, WheelSupport};
use hardpoint::report::ComplianceReport;
use hardpoint::rig::{self, Axle, Corner, LoadPoint, RigError};
use hardpoint::solve::Stop;
use hardpoint::solve::compliance::ComplianceError;

use crate::failure::Failure;
use crate::loads::{RigOptions, length};
use crate::output::{Format, Output, SideName, axes_of_words};
use crate::steering::SteeringOptions;
use crate::{is_axle, load};

/// The compliance matrix: displacements and rotations of wheels per unit force and moment, 6×6 of a
/// corner, 12×12 of an axle.
///
/// The rig holds the wheels at a travel, the rack at its displacement and the loads that are given; there the
/// wheels are let go, and what held them stays on as a dead load. Tyres do not count.
#[derive(Args)]
#[command(after_help = "\
Signs: forces and displacements + along the model's axes, moments and rotations right-handed about
them. The matrix is symmetric where all forces have an energy and no moment is applied; the
asymmetry |C − Cᵀ|/|C| is printed.

Examples:
  hardpoint compliance models/bushed-double-wishbone.toml
  hardpoint compliance models/sedan-axle.toml --axle
  hardpoint compliance models/sedan-axle.toml --axle --travel 20 --load fx=-1000 -o c.csv
  hardpoint compliance models/sedan-axle.toml --axle --at contact-patch --format json")]
pub struct Compliance {
    /// The model file.
    model: PathBuf,
    /// Put both sides on the rig: the model and its mirror image.
    #[arg(long, conflicts_with = "side")]
    axle: bool,
    /// Wheel travel, of both wheels of an axle [default: 0].
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    travel: Option<f64>,
    #[command(flatten)]
    steering: SteeringOptions,
    #[command(flatten)]
    rig: RigOptions,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
    /// How to write the matrix [default: table, or what the ending of the file names].
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Write to a file instead of the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Compliance {
    /// Runs the command.
    pub fn run(mut self) -> Result<(), Failure> {
        // Refused before the work is done.
        let output = Output::beside(&self.model, self.output.as_deref())?;
        let usage = |message: &str| Err(Failure::Usage(message.to_owned()));
        let document = load(&self.model, self.side)?;
        self.axle |= is_axle(&document);
        let Document::Suspension(model) = document else {
            return usage("a compliance belongs to wheels; this file is a mechanism");
        };
        let model = self.rig.set(model)?;
        let travel = length("--travel", self.travel, model.units)?;
        let rack = self.steering.rack(&model)?;
        let steers = model.steers();
        let at = self.rig.point_or(LoadPoint::WheelCenter);
        let compliance = if self.axle {
            self.of_axle(&model, travel, rack, at)?
        } else {
            self.of_corner(&model, travel, rack, at)?
        };
        let compliance = match at {
            LoadPoint::WheelCenter => compliance,
            LoadPoint::ContactPatch => compliance.at_contact_patch(),
        };
        let what = if self.axle { "axle".into() } else { format!("{} side", model.side.name()) };
        let unit = model.units.length;
        let (travel, rack) = (unit.from_metres(travel), unit.from_metres(rack));
        let symbol = unit.symbol();
        let steered = if steers { format!(", rack {rack} {symbol}") } else { String::new() };
        let title = format!(
            "{}, {what}, {} axes, travel {travel} {symbol}{steered}",
            model.name,
            model.axes.name()
        );
        let report = ComplianceReport {
            title: &title,
            axes: model.axes,
            units: model.units,
            compliance: &compliance,
        };
        let named = self.output.as_deref().and_then(Format::of);
        output.write(|writer| match self.format.or(named).unwrap_or(Format::Table) {
            Format::Table => report.write_table(writer),
            Format::Csv => report.write_csv(writer),
            Format::Json => report.write_json(writer),
        })
    }

    fn of_corner(
        &self,
        model: &Model,
        travel: f64,
        rack: f64,
        at: LoadPoint,
    ) -> Result<rig::Compliance, Failure> {
        let load = self.rig.load(model)?;
        let setup = self.rig.setup(WheelSupport::Held, Chassis::Fixed);
        let mut corner =
            Corner::with_loads(model, &setup, at).map_err(|error| self.cannot_stand(error))?;
        corner.set_load(&load);
        corner.move_to(travel, rack).map_err(|stop| stopped(stop, model.axes))?;
        corner.compliance().map_err(|error| self.fails(error, model.axes))
    }

    fn of_axle(
        &self,
        model: &Model,
        travel: f64,
        rack: f64,
        at: LoadPoint,
    ) -> Result<rig::Compliance, Failure> {
        let loads = self.rig.axle_loads(model)?;
        let setup = self.rig.setup(WheelSupport::Held, Chassis::Fixed);
        let mut axle =
            Axle::with_loads(model, &setup, at).map_err(|error| self.cannot_stand(error))?;
        axle.set_load(&loads);
        axle.move_to([travel; 2], rack).map_err(|stop| stopped(stop, model.axes))?;
        axle.compliance().map_err(|error| self.fails(error, model.axes))
    }

    fn cannot_stand(&self, error: RigError) -> Failure {
        Failure::Rig(self.model.display().to_string(), Box::new(error))
    }

    fn fails(&self, error: ComplianceError, axes: Axes) -> Failure {
        Failure::Compliance(self.model.display().to_string(), error, axes)
    }
}

fn stopped(stop: Stop, axes: Axes) -> Failure {
    let axes = axes_of_words(axes, &stop.to_string());
    Failure::Stopped(vec![stop], format!("no compliance was found{axes}"))
}
