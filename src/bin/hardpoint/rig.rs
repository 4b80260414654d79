//! `hardpoint rig`: the standard programme, into a folder.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use clap::Args;
use hardpoint::factors::{FACTORS, Factor};
use hardpoint::model::{Chassis, Document, Model, Quantity, Setup, Side, WheelSupport};
use hardpoint::programme::{Ranges, Run, Stage, standard};
use hardpoint::report::{
    ComplianceReport, FactorSheet, ProgrammeSummary, StageResult, SweepReport,
};
use hardpoint::rig::{Adjustment, Axle, Compliance, LoadPoint, Pose};

use crate::dangers::dangers;
use crate::failure::Failure;
use crate::load;
use crate::output::{ConventionName, DriveName, Output, axes_of_words};
use crate::progress::Progress;
use crate::settings::Settings;

/// Run the standard programme of a K&C rig on an axle into a folder of CSV files with a summary.
///
/// Parallel, opposite and single wheel travel, roll about the static roll centre and at constant axle load,
/// steering, the envelope of travel and steering, braking, traction, lateral force, aligning and
/// overturning moment, parallel, opposed and on one side; each with all factors that the axle has, the
/// compliance matrix among them. Where the model has forces, every state is one of static
/// equilibrium, and loads act while the wheels carry what they carry at rest.
#[derive(Args)]
#[command(after_help = "\
The folder has one CSV file for each event, factors.csv with all factors of the static position,
compliance.csv with the compliance matrix at the wheel centres, and summary.txt. Names and signs of
columns are those of `hardpoint factors --list`.

Examples:
  hardpoint rig models/sedan-axle.toml
  hardpoint rig models/lotus-front.toml --drive contact-patch --convention lotus -o lotus
  hardpoint rig models/sedan-axle.toml --travel 60 --rack 50 --force 4000 -o sedan
  hardpoint rig models/sedan-setup.toml --set ride_height=-15 -o low")]
pub struct Rig {
    /// The model file.
    model: PathBuf,
    /// The folder; it is made where it does not exist [default: the name of the model with -rig].
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,
    /// Which height a travel means [default: wheel-center].
    #[arg(long, value_enum)]
    drive: Option<DriveName>,
    /// Swap bushings back for the rigid joints that they replace.
    #[arg(long)]
    kinematic: bool,
    #[command(flatten)]
    settings: Settings,
    /// Whose definitions of factors to follow where programs differ.
    #[arg(long, value_enum, default_value = "iso")]
    convention: ConventionName,
    /// Travel to both sides, of which opposite and single travel go through half [default: 80 mm].
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    travel: Option<f64>,
    /// Roll to both sides [default: 3°].
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    roll: Option<f64>,
    /// Displacement of the rack to both sides [default: 40 mm, or the nearer limit of the model].
    #[arg(long, value_name = "R", allow_negative_numbers = true)]
    rack: Option<f64>,
    /// Forces to both sides [default: 2000 N].
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    force: Option<f64>,
    /// Moments to both sides [default: 100 N·m].
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    moment: Option<f64>,
}

/// The static position.
struct AtRest {
    /// The left and the right wheel.
    poses: [Pose<f64>; 2],
    /// What the adjusters are set to.
    adjustments: Vec<Adjustment>,
    /// How the wheels give way, where forces hold them.
    compliance: Option<Compliance>,
}

impl Rig {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let Document::Suspension(model) = load(&self.model, None)? else {
            return Err(Failure::Usage(
                "the programme belongs to suspensions; this file is a mechanism".into(),
            ));
        };
        let model = self.settings.apply(model)?;
        let stages = standard(&model, &self.ranges(&model)?);
        let setup = Setup {
            drive: self.drive.map(Into::into).unwrap_or_default(),
            support: WheelSupport::Held,
            chassis: Chassis::Fixed,
            kinematic: self.kinematic,
        };
        let folder = self.folder()?;
        let at_rest = self.at_rest(&model, &setup)?;
        fs::create_dir_all(&folder)
            .map_err(|error| Failure::Output(folder.display().to_string(), error))?;
        // A summary is there only beside the files that it speaks of.
        remove(&folder.join("summary.txt"))?;
        let progress = Progress::new(stages.iter().map(Stage::states).sum());
        let mut before = 0;
        let mut results = vec![];
        for stage in stages {
            let done = stage.run(&model, &setup, true, |done| progress.show(before + done));
            before += stage.states();
            results.push(match done {
                Ok(run) => self.write_stage(stage, &run, &model, &setup, &folder)?,
                Err(error) => {
                    remove(&folder.join(file_of(&stage)))?;
                    let notes = vec![error.to_string()];
                    let warnings = vec![];
                    StageResult { stage, file: None, reached: 0, iterations: 0, notes, warnings }
                }
            });
        }
        progress.clear();
        self.write_rest(&model, &setup, &folder, &at_rest)?;
        let summary = ProgrammeSummary {
            model: &model,
            drive: setup.drive,
            convention: self.convention.into(),
            poses: &at_rest.poses,
            adjustments: &at_rest.adjustments,
            stages: &results,
        };
        Output::File(folder.join("summary.txt")).write(|writer| summary.write(writer))?;
        tell(&results, &folder, &model)
    }

    fn folder(&self) -> Result<PathBuf, Failure> {
        if let Some(folder) = &self.output {
            if folder.exists() && !folder.is_dir() {
                return Err(Failure::Usage(format!(
                    "{} is no folder; name another one with -o",
                    folder.display()
                )));
            }
            return Ok(folder.clone());
        }
        let stem = self.model.file_stem().unwrap_or_default().to_string_lossy();
        Ok(PathBuf::from(format!("{stem}-rig")))
    }

    fn ranges(&self, model: &Model) -> Result<Ranges, Failure> {
        let default = Ranges::of(model);
        let range = |name: &str, value: Option<f64>, quantity: Quantity, default: f64| {
            let Some(value) = value else { return Ok(default) };
            if value.is_finite() && value > 0.0 {
                return Ok(quantity.to_si(model.units, value));
            }
            Err(Failure::Usage(format!("{name} is not a positive number")))
        };
        Ok(Ranges {
            travel: range("--travel", self.travel, Quantity::Length, default.travel)?,
            roll: range("--roll", self.roll, Quantity::Angle, default.roll)?,
            rack: range("--rack", self.rack, Quantity::Length, default.rack)?,
            force: range("--force", self.force, Quantity::Force, default.force)?,
            moment: range("--moment", self.moment, Quantity::Torque, default.moment)?,
        })
    }

    /// Both wheels at the static position, and how they give way there.
    fn at_rest(&self, model: &Model, setup: &Setup) -> Result<AtRest, Failure> {
        let rig = |error| Failure::Rig(self.model.display().to_string(), Box::new(error));
        let mut axle = Axle::new(model, setup).map_err(rig)?;
        axle.measure_compliance(true);
        axle.move_to([0.0; 2], 0.0).map_err(|stop| {
            let axes = axes_of_words(model.axes, &stop.to_string());
            Failure::Stopped(vec![stop], format!("the static position was not reached{axes}"))
        })?;
        Ok(AtRest {
            poses: axle.poses(),
            adjustments: axle.adjustments().to_vec(),
            compliance: axle.compliance().ok(),
        })
    }

    fn write_stage(
        &self,
        stage: Stage,
        run: &Run,
        model: &Model,
        setup: &Setup,
        folder: &Path,
    ) -> Result<StageResult, Failure> {
        let Run { plan, sweep } = run;
        let convention = self.convention.into();
        let has = |factor: &Factor| {
            let mut poses = sweep.rows.iter().flat_map(|row| &row.poses);
            poses.any(|pose| factor.value(convention, pose).is_some())
        };
        let factors: Vec<&'static Factor> = FACTORS.iter().filter(|factor| has(factor)).collect();
        let report = SweepReport {
            name: &model.name,
            sides: &[Side::Left, Side::Right],
            axes: model.axes,
            units: model.units,
            event: &stage.name.replace('-', " "),
            drive: Some(setup.drive),
            quantity: stage.quantity,
            plan: Some(plan),
            cases: None,
            sweep,
            reactions: true,
            factors: Some(&factors),
            convention,
        };
        let file = file_of(&stage);
        Output::File(folder.join(&file)).write(|writer| report.write_csv(writer))?;
        Ok(StageResult {
            file: Some(file),
            reached: sweep.rows.len(),
            iterations: sweep.rows.iter().map(|row| row.iterations).sum(),
            notes: sweep.stops.iter().map(ToString::to_string).collect(),
            warnings: dangers(sweep, Some(stage.quantity), model.units),
            stage,
        })
    }

    fn write_rest(
        &self,
        model: &Model,
        setup: &Setup,
        folder: &Path,
        AtRest { poses, adjustments, compliance }: &AtRest,
    ) -> Result<(), Failure> {
        let sheet = FactorSheet {
            name: &model.name,
            units: model.units,
            drive: setup.drive,
            convention: self.convention.into(),
            poses,
            adjustments,
        };
        Output::File(folder.join("factors.csv")).write(|writer| sheet.write_csv(writer))?;
        let Some(compliance) = compliance else { return remove(&folder.join("compliance.csv")) };
        debug_assert_eq!(compliance.at(), LoadPoint::WheelCenter);
        let report = ComplianceReport {
            title: &model.name,
            axes: model.axes,
            units: model.units,
            compliance,
        };
        Output::File(folder.join("compliance.csv")).write(|writer| report.write_csv(writer))
    }
}

fn file_of(stage: &Stage) -> String {
    format!("{}.csv", stage.name)
}

/// Removes what an earlier run left under a name that this one has nothing for.
fn remove(path: &Path) -> Result<(), Failure> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => {
            Err(Failure::Output(path.display().to_string(), error))
        }
        _ => Ok(()),
    }
}

/// Says on stderr what was written and what was not reached.
fn tell(results: &[StageResult], folder: &Path, model: &Model) -> Result<(), Failure> {
    let reached: usize = results.iter().map(|result| result.reached).sum();
    let folder = folder.display();
    eprintln!(
        "{reached} states of {} events are in {folder}; see summary.txt there",
        results.len()
    );
    for StageResult { stage, warnings, .. } in results {
        for warning in warnings {
            eprintln!("warning: {}: {warning}", stage.name);
        }
    }
    let notes: Vec<String> = results
        .iter()
        .flat_map(|StageResult { stage, notes, .. }| {
            notes.iter().map(move |note| format!("{}: {note}", stage.name))
        })
        .collect();
    if notes.is_empty() {
        return Ok(());
    }
    let planned: usize = results.iter().map(|result| result.stage.states()).sum();
    let axes = axes_of_words(model.axes, &notes.join(" "));
    Err(Failure::Incomplete(notes, format!("{reached} of {planned} states were reached{axes}")))
}
