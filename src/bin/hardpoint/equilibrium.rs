//! `hardpoint equilibrium`: where a model comes to rest, and what every joint carries.

use std::path::PathBuf;

use clap::Args;
use hardpoint::mechanism::DriverId;
use hardpoint::model::{Axes, Chassis, Document, MechanismModel, Model, Setup, Side, WheelSupport};
use hardpoint::report::StaticsReport;
use hardpoint::rig::{Axle, Corner, RigError, Stand};
use hardpoint::solve::{StaticFailure, Stop};

use crate::failure::Failure;
use crate::loads::{RigOptions, length};
use crate::output::{Output, Sheet, SideName, axes_of_words};
use crate::steering::SteeringOptions;
use crate::{is_axle, load};

/// Find the static equilibrium: pose, reactions of all joints, state of all springs and bushings.
///
/// A wheel with a tyre stands on the ground, one without hangs free; with --travel the rig holds it at
/// a height. A quarter car sinks on its slide unless --fixed-chassis holds it.
#[derive(Args)]
#[command(after_help = "\
Signs: forces of joints act on the second body, along the model's axes; springs + in tension;
tyre load + up on the wheel; loads on the wheel along the model's axes.

Examples:
  hardpoint equilibrium models/quarter-car.toml
  hardpoint equilibrium models/quarter-car.toml --fixed-chassis --travel 20
  hardpoint equilibrium models/bushed-double-wishbone.toml --load fx=1000 --load mz=-100
  hardpoint equilibrium models/bushed-double-wishbone.toml --kinematic --format json
  hardpoint equilibrium models/sedan-axle.toml --axle --load left.fx=1000
  hardpoint equilibrium models/anti-roll-bar.toml")]
pub struct Equilibrium {
    /// The model or mechanism file.
    model: PathBuf,
    /// Put both sides on the rig: the model and its other side.
    #[arg(long, conflicts_with = "side")]
    axle: bool,
    /// Hold the wheel at this travel instead of standing it on its tyre.
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    travel: Option<f64>,
    #[command(flatten)]
    steering: SteeringOptions,
    #[command(flatten)]
    rig: RigOptions,
    /// Hold the chassis of a quarter car.
    #[arg(long)]
    fixed_chassis: bool,
    /// Let this driver of a mechanism go; may be given several times.
    #[arg(long, value_name = "DRIVER")]
    release: Vec<String>,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
    /// How to write the result [default: table, or what the ending of the file names].
    #[arg(long, value_enum)]
    format: Option<Sheet>,
    /// Write to a file instead of the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Equilibrium {
    /// Runs the command.
    pub fn run(mut self) -> Result<(), Failure> {
        // Refused before the work is done.
        let output = Output::beside(&self.model, self.output.as_deref())?;
        let document = load(&self.model, self.side)?;
        self.axle |= is_axle(&document);
        match document {
            Document::Suspension(model) => self.suspension(&self.rig.set(model)?, &output),
            Document::Mechanism(model) => self.mechanism(&model, &output),
        }
    }

    fn suspension(&self, model: &Model, output: &Output) -> Result<(), Failure> {
        let usage = |message: &str| Err(Failure::Usage(message.to_owned()));
        let has_forces = if self.axle { model.axle_has_forces() } else { model.has_forces() };
        if !has_forces {
            return usage(
                "the model has no forces, so every position is an equilibrium; add [[forces]] to it, \
                 or use `hardpoint sweep`",
            );
        }
        if !self.release.is_empty() {
            return usage("--release names drivers of a mechanism file; a suspension has none");
        }
        let free = self.travel.is_none();
        let slides = free && model.is_quarter_car() && !self.fixed_chassis && !self.axle;
        let support = if free { WheelSupport::Free } else { WheelSupport::Held };
        let chassis = if slides { Chassis::Slide } else { Chassis::Fixed };
        let travel = length("--travel", self.travel, model.units)?;
        let rack = self.steering.rack(model)?;
        let setup = self.rig.setup(support, chassis);
        let how = match (free, slides, model.has_tyre()) {
            (true, true, _) => "quarter car on its tyre".to_owned(),
            (true, false, true) => "chassis fixed, wheel on its tyre".to_owned(),
            (true, false, false) => "chassis fixed, wheel free".to_owned(),
            (false, ..) => {
                let unit = model.units.length;
                let travel = unit.from_metres(travel);
                format!("wheel held at a travel of {travel} {}", unit.symbol())
            }
        };
        let side = if self.axle { "axle".into() } else { format!("{} side", model.side.name()) };
        let title = format!("{}, {side}, {} axes, {how}", model.name, model.axes.name());
        match self.axle {
            true => self.axle(model, &setup, (travel, rack), &title, output),
            false => self.corner(model, &setup, (travel, rack), &title, output),
        }
    }

    fn corner(
        &self,
        model: &Model,
        setup: &Setup,
        (travel, rack): (f64, f64),
        title: &str,
        output: &Output,
    ) -> Result<(), Failure> {
        let load = self.rig.load(model)?;
        let mut corner = Corner::with_loads(model, setup, self.rig.point())
            .map_err(|error| self.cannot_stand(error))?;
        corner.set_load(&load);
        if travel != 0.0 || rack != 0.0 {
            corner.move_to(travel, rack).map_err(|stop| self.stopped(stop, model.axes))?;
        }
        let found = corner.rest().map_err(|failure| self.fails(failure, model.axes))?;
        let report = StaticsReport {
            title,
            axes: model.axes,
            units: model.units,
            found: &found,
            poses: &[corner.pose()],
            equilibrium: corner.equilibrium(),
            elements: corner.element_channels(),
        };
        self.write(&report, output)
    }

    fn axle(
        &self,
        model: &Model,
        setup: &Setup,
        (travel, rack): (f64, f64),
        title: &str,
        output: &Output,
    ) -> Result<(), Failure> {
        let loads = self.rig.axle_loads(model)?;
        let mut axle = Axle::with_loads(model, setup, self.rig.point())
            .map_err(|error| self.cannot_stand(error))?;
        axle.set_load(&loads);
        if travel != 0.0 || rack != 0.0 {
            axle.move_to([travel; 2], rack).map_err(|stop| self.stopped(stop, model.axes))?;
        }
        let found = axle.rest().map_err(|failure| self.fails(failure, model.axes))?;
        let report = StaticsReport {
            title,
            axes: model.axes,
            units: model.units,
            found: &found,
            poses: &[axle.pose(Side::Left), axle.pose(Side::Right)],
            equilibrium: axle.equilibrium(),
            elements: axle.element_channels(),
        };
        self.write(&report, output)
    }

    fn mechanism(&self, model: &MechanismModel, output: &Output) -> Result<(), Failure> {
        let travel = self.travel.map(|_| "--travel");
        let axle = self.axle.then_some("--axle");
        if let Some(option) = travel.or(self.steering.given()).or(axle) {
            return Err(Failure::Usage(format!(
                "{option} belongs to suspensions; this file is a mechanism"
            )));
        }
        self.rig.refuse()?;
        refuse_fixed_chassis(self.fixed_chassis)?;
        let released = released(&self.release, model)?;
        let mut stand = Stand::new(model.mechanism.clone(), &released, Axes::Iso8855)
            .map_err(|error| self.cannot_stand(error))?;
        let found = stand.rest().map_err(|failure| self.fails(failure, Axes::Iso8855))?;
        let report = StaticsReport {
            title: &model.name,
            axes: Axes::Iso8855,
            units: model.units,
            equilibrium: stand.equilibrium(),
            found: &found,
            poses: &[],
            elements: stand.force_channels(),
        };
        self.write(&report, output)
    }

    fn write(&self, report: &StaticsReport, output: &Output) -> Result<(), Failure> {
        let named = match (self.format, self.output.as_deref()) {
            (None, Some(path)) => Sheet::of(path)?,
            _ => None,
        };
        output.write(|writer| match self.format.or(named).unwrap_or(Sheet::Table) {
            Sheet::Table => report.write_text(writer),
            Sheet::Json => report.write_json(writer),
        })
    }

    fn cannot_stand(&self, error: RigError) -> Failure {
        Failure::Rig(self.model.display().to_string(), Box::new(error))
    }

    fn stopped(&self, stop: Stop, axes: Axes) -> Failure {
        let axes = axes_of_words(axes, &stop.to_string());
        Failure::Stopped(vec![stop], format!("no equilibrium was found{axes}"))
    }

    fn fails(&self, failure: StaticFailure, axes: Axes) -> Failure {
        Failure::Static(self.model.display().to_string(), failure, axes)
    }
}

/// A mechanism has no chassis to hold.
pub fn refuse_fixed_chassis(fixed: bool) -> Result<(), Failure> {
    match fixed {
        true => Err(Failure::Usage(
            "--fixed-chassis belongs to suspensions; this file is a mechanism".into(),
        )),
        false => Ok(()),
    }
}

/// The drivers of these names.
pub fn released(names: &[String], model: &MechanismModel) -> Result<Vec<DriverId>, Failure> {
    let driver = |name: &String| {
        model.mechanism.driver_named(name).ok_or_else(|| {
            let drivers: Vec<&str> =
                model.mechanism.drivers().iter().map(|driver| driver.name.as_str()).collect();
            let known = if drivers.is_empty() {
                "the mechanism has none".to_owned()
            } else {
                format!("the drivers are {}", drivers.join(", "))
            };
            Failure::Usage(format!("there is no driver `{name}`; {known}"))
        })
    };
    names.iter().map(driver).collect()
}
