//! `hardpoint report`: the tables that Lotus prints.

use std::path::PathBuf;

use clap::Args;
use hardpoint::model::{Document, Drive, Model, Quantity, Setup};
use hardpoint::programme::{Ranges, Run, Stage, StageError, standard};
use hardpoint::report::LotusReport;
use hardpoint::rig::{Axle, RigError};

use crate::failure::Failure;
use crate::load;
use crate::output::{DriveName, Output, axes_of_words};
use crate::settings::Settings;

/// Print bump, roll, steering and static values of an axle in the order and by the definitions of Lotus
/// Suspension Analysis, for direct comparison.
#[derive(Args)]
#[command(after_help = "\
Signs: bump + up; camber + top outboard, as seen from the front; toe + toe-in; castor + top rearward;
kingpin + top inboard; roll + right-handed about the x axis of the model; rack + along its y axis;
wheelbase and half-track change + longer and wider. A value that is not defined is –.

Examples:
  hardpoint report models/lotus-front.toml --bump 37.5 --bump-step 7.5 --rack 45 --rack-step 4.5
  hardpoint report models/double-wishbone.toml -o sedan.txt")]
pub struct Report {
    /// The model file.
    model: PathBuf,
    /// Which height the bump means [default: contact-patch].
    #[arg(long, value_enum)]
    drive: Option<DriveName>,
    #[command(flatten)]
    settings: Settings,
    /// Bump to both sides [default: 80 mm].
    #[arg(long, value_name = "B", allow_negative_numbers = true)]
    bump: Option<f64>,
    /// Distance of the states [default: an eighth].
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    bump_step: Option<f64>,
    /// Roll to both sides [default: 3°].
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    roll: Option<f64>,
    /// Distance of the states [default: a tenth].
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    roll_step: Option<f64>,
    /// Displacement of the rack to both sides [default: 40 mm, or the nearer limit of the model].
    #[arg(long, value_name = "R", allow_negative_numbers = true)]
    rack: Option<f64>,
    /// Distance of the states [default: an eighth].
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    rack_step: Option<f64>,
    /// Write to a file instead of the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Report {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let Document::Suspension(model) = load(&self.model, None)? else {
            return Err(Failure::Usage(
                "the report belongs to suspensions; this file is a mechanism".into(),
            ));
        };
        let model = self.settings.apply(model)?;
        let output = Output::beside(&self.model, self.output.as_deref())?;
        let drive = self.drive.map_or(Drive::ContactPatch, Into::into);
        // The report is one of kinematics, as that of Lotus.
        let setup = Setup { kinematic: true, ..Setup::from(drive) };
        let rig = |error: RigError| Failure::Rig(self.model.display().to_string(), Box::new(error));
        let mut axle = Axle::new(&model, &setup).map_err(rig)?;
        axle.move_to([0.0; 2], 0.0).map_err(|stop| {
            let axes = axes_of_words(model.axes, &stop.to_string());
            Failure::Stopped(vec![stop], format!("the static position was not reached{axes}"))
        })?;
        let poses = axle.poses();
        let run = |stage: &Stage| {
            stage.run(&model, &setup, false, |_| {}).map_err(|error| match error {
                StageError::Rig(error) => rig(error),
                error => Failure::Incomplete(vec![error.to_string()], "nothing was written".into()),
            })
        };
        let stages = self.stages(&model)?;
        let runs: Vec<(&'static str, Run)> = stages
            .iter()
            .map(|stage| Ok((stage.name, run(stage)?)))
            .collect::<Result<_, Failure>>()?;
        let named = |name: &str| runs.iter().find(|(run, _)| *run == name).map(|(_, run)| run);
        let (Some(bump), Some(roll)) = (named("parallel"), named("roll")) else {
            unreachable!("every axle has both events")
        };
        let steering = named("steer");
        let report = LotusReport { model: &model, drive, poses: &poses, bump, roll, steering };
        output.write(|writer| report.write(writer))?;
        let stops = || {
            runs.iter().flat_map(|(name, run)| {
                run.sweep.stops.iter().map(move |stop| format!("{name}: {stop}"))
            })
        };
        if stops().next().is_none() {
            return Ok(());
        }
        Err(Failure::Incomplete(stops().collect(), "the report lacks states".into()))
    }

    fn stages(&self, model: &Model) -> Result<Vec<Stage>, Failure> {
        let mut stages = standard(model, &Ranges::of(model));
        stages.retain(|stage| ["parallel", "roll", "steer"].contains(&stage.name));
        for stage in &mut stages {
            let (range, step, name, quantity) = match stage.name {
                "parallel" => (self.bump, self.bump_step, "--bump", Quantity::Length),
                "roll" => (self.roll, self.roll_step, "--roll", Quantity::Angle),
                _ => (self.rack, self.rack_step, "--rack", Quantity::Length),
            };
            let positive = |value: f64| value.is_finite() && value > 0.0;
            if [range, step].into_iter().flatten().any(|value| !positive(value)) {
                return Err(Failure::Usage(format!("{name} and {name}-step are positive numbers")));
            }
            if let Some(range) = range {
                let range = quantity.to_si(model.units, range);
                stage.step *= range / stage.range;
                stage.range = range;
            }
            if let Some(step) = step {
                stage.step = quantity.to_si(model.units, step);
            }
            if stage.range / stage.step > 1e5 {
                return Err(Failure::Usage(format!("{name}-step is too small for the range")));
            }
        }
        Ok(stages)
    }
}
