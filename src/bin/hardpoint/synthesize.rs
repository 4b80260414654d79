//! `hardpoint synthesize`: hard points that give wanted factors.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use hardpoint::design::edit::ModelText;
use hardpoint::design::request::Request;
use hardpoint::design::synthesis::{Obstacle, Synthesis, Verdict, judge, measure, synthesize};
use hardpoint::model::{Drive, Model, Setup};
use hardpoint::report::SynthesisReport;

use crate::failure::Failure;
use crate::output::{DriveName, Output, Sheet, axes_of_words};
use crate::progress::Waiting;
use crate::settings::Settings;

/// Seek hard points and other parameters that give wanted factors, and write the new model file.
///
/// A file of targets says what is wanted, what may change and what must not happen. Targets are met as well as possible
/// by least squares, limits and hard targets in any case; where they contradict each other, it is said
/// which do. The new file is the old one with other numbers, rounded to six decimals; the factors that are
/// shown are those of the new file.
#[derive(Args)]
#[command(after_help = "\
The file of targets is described in docs/synthesis.md, with examples in requests/ and docs/guides/.

Without -o no model is written. Where targets are not met within their tolerances, a model is written only with
--force, and the exit code is 4; where limits contradict each other, none is written at all.

Examples:
  hardpoint synthesize models/double-wishbone.toml requests/bump-steer-zero.toml -o new.toml
  hardpoint synthesize models/macpherson.toml requests/bump-steer-and-camber.toml --format json
  hardpoint synthesize models/macpherson.toml requests/roll-centre.toml -o new.toml --report changes.txt")]
pub struct Synthesize {
    /// The model file.
    model: PathBuf,
    /// The file of targets, variables and limits, in the units and axes of the model.
    targets: PathBuf,
    /// Write the new model to this file.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write what was met and what changed to a file instead of the terminal.
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// How to write it [default: table, or what the ending of its file names].
    #[arg(long, value_enum)]
    format: Option<Sheet>,
    /// From how many designs to seek [default: as the file of targets says, or 16].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    starts: Option<u32>,
    /// Write the model even where targets are missed.
    #[arg(long)]
    force: bool,
    /// Which height a travel means [default: wheel-center].
    #[arg(long, value_enum)]
    drive: Option<DriveName>,
    /// Swap bushings back for the rigid joints that they replace.
    #[arg(long)]
    kinematic: bool,
    #[command(flatten)]
    settings: Settings,
}

/// A design as the new file has it.
struct Written {
    text: ModelText,
    model: Model,
    after: Vec<Vec<Option<f64>>>,
    verdict: Verdict,
}

impl Synthesize {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        self.check_files()?;
        let named = self.report.as_deref().map(Sheet::of).transpose()?.flatten();
        let format = self.format.or(named).unwrap_or(Sheet::Table);
        let text = ModelText::load(&self.model)?;
        let model = self.settings.apply(text.read()?)?;
        let mut request = Request::load(&self.targets, &model)?;
        request.search.starts = self.starts.unwrap_or(request.search.starts);
        // What the file cannot take is told before the work is done.
        write_values(&request, &model, &starts(&request), &mut text.clone())?;
        let setup = Setup {
            kinematic: self.kinematic,
            ..Setup::from(self.drive.map_or(Drive::WheelCenter, Drive::from))
        };
        let before = measure(&request, &model, &setup);
        let before = before.map_err(|obstacle| self.failure(obstacle, &model, &request))?;
        if !before.mistakes.is_empty() {
            return Err(request.refuse(before.mistakes).into());
        }
        let waiting = Waiting::for_end_of(format!(
            "seeking a design from up to {} starts",
            request.search.starts
        ));
        let found = synthesize(&request, &model, &setup);
        waiting.clear();
        let found = found.map_err(|obstacle| self.failure(obstacle, &model, &request))?;
        let written = match found.verdict {
            Verdict::Met | Verdict::Compromise { .. } => {
                Some(self.write(&request, &model, &setup, text, &before.values, &found)?)
            }
            _ => None,
        };
        let verdict = written.as_ref().map_or(&found.verdict, |written| &written.verdict);
        let file = self.output.as_deref().filter(|_| *verdict == Verdict::Met || self.force);
        let file = file.filter(|_| written.is_some());
        let report = SynthesisReport {
            model: &model,
            request: &request,
            drive: setup.drive,
            verdict,
            before: &before.values,
            design: written.as_ref().map(|written| (&written.model, &written.after[..])),
            found: &found,
            file: file.and_then(Path::to_str),
        };
        if let (Some(written), Some(file)) = (&written, file) {
            let output = Output::File(file.to_owned());
            output.write(|writer| writer.write_all(written.text.text().as_bytes()))?;
        }
        self.tell(&report, format)
    }

    /// Refuses places that would take that of an input.
    fn check_files(&self) -> Result<(), Failure> {
        let place = |path: &Path| fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let inputs = [&self.model, &self.targets].map(|path| place(path));
        let outputs = [("-o", &self.output), ("--report", &self.report)];
        for (option, file) in outputs {
            if file.as_ref().is_some_and(|file| inputs.contains(&place(file))) {
                return Err(Failure::Usage(format!(
                    "{option} would overwrite the model or the targets; name another file"
                )));
            }
        }
        match (&self.output, &self.report) {
            (Some(model), Some(report)) if place(model) == place(report) => {
                Err(Failure::Usage("-o and --report name the same file".to_owned()))
            }
            _ => Ok(()),
        }
    }

    /// The design as the new file has it.
    fn write(
        &self,
        request: &Request,
        model: &Model,
        setup: &Setup,
        mut text: ModelText,
        before: &[Vec<Option<f64>>],
        found: &Synthesis,
    ) -> Result<Written, Failure> {
        write_values(request, model, &found.values, &mut text)?;
        // Paths in the file are relative to where it will be.
        let new = match &self.output {
            Some(path) => Model::parse(&path.display().to_string(), text.text())?,
            None => text.read()?,
        };
        let new = self.settings.apply(new)?;
        let after = measure(request, &new, setup)
            .map_err(|obstacle| self.failure(obstacle, model, request))?
            .values;
        let verdict = judge(request, before, &after);
        Ok(Written { text, model: new, after, verdict })
    }

    /// Writes the report, and fails where targets are missed.
    fn tell(&self, report: &SynthesisReport, format: Sheet) -> Result<(), Failure> {
        let output = self.report.clone().map_or(Output::Stdout, Output::File);
        output.write(|writer| match format {
            Sheet::Table => report.write_table(writer),
            Sheet::Json => report.write_json(writer),
        })?;
        match report.unmet() {
            Some(mut words) => {
                if self.report.is_none() && format == Sheet::Table {
                    // The table has the rest.
                    words.truncate(words.find('\n').map_or(words.len(), |end| end + 1));
                }
                if report.design.is_some() && report.file.is_none() && self.output.is_some() {
                    words += "no model is written: let more change, want less, or write this one with --force\n";
                }
                Err(Failure::Unmet(words))
            }
            None => Ok(()),
        }
    }

    /// Why the model or a design has no factors.
    fn failure(&self, obstacle: Obstacle, model: &Model, request: &Request) -> Failure {
        let path = self.model.display().to_string();
        match obstacle {
            Obstacle::Rig(error) => Failure::Rig(path, Box::new(error)),
            Obstacle::Stopped(stop) => {
                let axes = axes_of_words(model.axes, &stop.to_string());
                let words = format!("a state of {} was not reached{axes}", self.targets.display());
                Failure::Stopped(vec![*stop], words)
            }
            Obstacle::Undefined(ref name) => {
                match request.targets.iter().find(|target| target.name == *name) {
                    Some(target) => {
                        let help = "name other states, or another factor";
                        let message = obstacle.to_string();
                        let place = &target.place;
                        let mistake = request.mistake(place, &message, "this target", help);
                        request.refuse(vec![mistake]).into()
                    }
                    None => Failure::Input(path, obstacle.to_string()),
                }
            }
            other => Failure::Input(path, other.to_string()),
        }
    }
}

/// The values that the model has.
fn starts(request: &Request) -> Vec<f64> {
    request.variables.iter().map(|variable| variable.start).collect()
}

/// Writes the values of all variables into the text of the model.
fn write_values(
    request: &Request,
    model: &Model,
    values: &[f64],
    text: &mut ModelText,
) -> Result<(), Failure> {
    let mut mistakes = vec![];
    for (variable, value) in request.variables.iter().zip(values) {
        if let Err(error) = variable.write(model, *value, text) {
            let help = "let something else change, or write the number into the model first";
            let label = "this variable";
            mistakes.push(request.mistake(&variable.place, &error.to_string(), label, help));
        }
    }
    if mistakes.is_empty() { Ok(()) } else { Err(request.refuse(mistakes).into()) }
}
