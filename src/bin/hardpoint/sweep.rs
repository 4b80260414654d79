//! `hardpoint sweep`: an event, state by state.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::{Args, ValueEnum};
use hardpoint::model::{Drive, Setup};
use hardpoint::report::SweepReport;
use hardpoint::rig::{self, Corner, SweepPlan};
use indicatif::{ProgressBar, ProgressDrawTarget};

use crate::failure::Failure;
use crate::load;
use crate::output::{DriveName, Format, Output, SideName, axes_of_words};

/// More states than this are a mistake in the step.
const MOST_STATES: f64 = 1e6;

/// No suspension travels farther (m).
const FARTHEST: f64 = 1e3;

/// Move the wheel through an event and list wheel and steer axis at every state.
///
/// All lengths are in the unit of the model, measured from the design position.
#[derive(Args)]
#[command(after_help = "\
Signs: travel + jounce; rack + along the model's +y; toe + toe-in; camber + top outboard;
caster + top rearward; kingpin inclination + top inboard; wheel rotation right-handed, as
Rx(a) Ry(b) Rz(c) from the design position in the model's axes.

Examples:
  hardpoint sweep models/double-wishbone.toml
  hardpoint sweep models/lotus-front.toml --drive contact-patch --from -37.5 --to 37.5 --step 7.5
  hardpoint sweep models/adams-tr-front.toml --rack 5 --from -10 --to 10 --side right
  hardpoint sweep models/double-wishbone.toml --event steer --travel 20 -o steer.csv")]
pub struct Sweep {
    /// The model file.
    model: PathBuf,
    /// What moves: the wheel up and down, or the rack from side to side.
    #[arg(long, value_enum, default_value = "travel")]
    event: EventName,
    /// First value [default: −130 mm of travel, −40 mm of the rack].
    #[arg(long, allow_negative_numbers = true, value_name = "A")]
    from: Option<f64>,
    /// Last value [default: 130 mm of travel, 40 mm of the rack].
    #[arg(long, allow_negative_numbers = true, value_name = "B")]
    to: Option<f64>,
    /// Distance of the states [default: 10 mm of travel, 5 mm of the rack].
    #[arg(long, allow_negative_numbers = true, value_name = "S")]
    step: Option<f64>,
    /// Rack displacement that a travel event holds [default: 0].
    #[arg(long, allow_negative_numbers = true, value_name = "R")]
    rack: Option<f64>,
    /// Wheel travel that a steer event holds [default: 0].
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    travel: Option<f64>,
    /// Which height is driven.
    #[arg(long, value_enum, default_value = "wheel-center")]
    drive: DriveName,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
    /// How to write the states [default: table, or what the ending of the file names].
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Write to a file instead of the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum EventName {
    /// The wheel goes up and down.
    Travel,
    /// The rack moves from side to side.
    Steer,
}

impl Sweep {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let model = load(&self.model, self.side)?;
        let place = self.output.as_ref().and_then(|path| path.canonicalize().ok());
        if place.is_some() && place == self.model.canonicalize().ok() {
            return Err(Failure::Usage("-o would overwrite the model; name another file".into()));
        }
        let drive = Drive::from(self.drive);
        let mut corner = Corner::new(&model, &Setup::from(drive))
            .map_err(|error| Failure::Rig(self.model.display().to_string(), error))?;
        let plan = self.plan(|length| model.units.length.to_metres(length), corner.steers())?;
        let progress = Progress::new(plan.values().len());
        let sweep = rig::Sweep::run(&mut corner, &plan, |done| progress.show(done));
        progress.clear();
        for motion in &sweep.free_motions {
            let axes = axes_of_words(model.axes, motion);
            eprintln!(
                "warning: no joint holds this motion of the wheel: {motion}{axes}; values that \
                 depend on it are not determined by the model. Add a joint to the architecture"
            );
        }

        let report = SweepReport { model: &model, drive, plan: &plan, sweep: &sweep };
        let named = self.output.as_deref().and_then(Format::of);
        let output = self.output.clone().map_or(Output::Stdout, Output::File);
        output.write(|writer| match self.format.or(named).unwrap_or(Format::Table) {
            Format::Table => report.write_table(writer),
            Format::Csv => report.write_csv(writer),
            Format::Json => report.write_json(writer),
        })?;
        if sweep.stops.is_empty() {
            return Ok(());
        }
        let words: String = sweep.stops.iter().map(ToString::to_string).collect();
        let axes = axes_of_words(model.axes, &words);
        let rows = format!("{} of {} states were reached{axes}", sweep.rows.len(), sweep.planned);
        Err(Failure::Stopped(sweep.stops, rows))
    }

    /// The states to visit, from lengths in the unit of the model.
    fn plan(&self, metres: impl Fn(f64) -> f64, steers: bool) -> Result<SweepPlan, Failure> {
        let usage = |message: &str| Err(Failure::Usage(message.to_owned()));
        let options = [
            ("--from", self.from),
            ("--to", self.to),
            ("--step", self.step),
            ("--rack", self.rack),
            ("--travel", self.travel),
        ];
        for (name, value) in options {
            let Some(value) = value else { continue };
            if !value.is_finite() {
                return usage(&format!("{name} is not a finite number"));
            }
            if name != "--step" && metres(value).abs() > FARTHEST {
                return usage(&format!(
                    "{name} is more than a kilometre; lengths are in the unit of the model"
                ));
            }
        }
        let (event, range, step, held) = match self.event {
            EventName::Travel => {
                if self.travel.is_some() {
                    return usage(
                        "a travel event moves the travel; hold the rack with --rack, \
                                  and say the range of travel with --from and --to",
                    );
                }
                if self.rack.is_some_and(|rack| rack != 0.0) && !steers {
                    return usage("this suspension has no rack; leave out --rack");
                }
                (rig::Event::Travel, 0.13, 0.01, self.rack)
            }
            EventName::Steer => {
                if self.rack.is_some() {
                    return usage(
                        "a steer event moves the rack; hold the travel with --travel, \
                                  and say the range of the rack with --from and --to",
                    );
                }
                if !steers {
                    return usage("this suspension has no rack, so there is no steer event");
                }
                (rig::Event::Steer, 0.04, 0.005, self.travel)
            }
        };
        let length = |value: Option<f64>, default: f64| value.map_or(default, &metres);
        let plan = SweepPlan {
            event,
            from: length(self.from, -range),
            to: length(self.to, range),
            step: length(self.step, step),
            held: length(held, 0.0),
        };
        let states = ((plan.to - plan.from) / plan.step).abs();
        if plan.step == 0.0 {
            return usage("--step is zero");
        }
        if states > MOST_STATES {
            return usage("--step is too small for the range: at most 1,000,000 states");
        }
        Ok(plan)
    }
}

/// A bar on the terminal for sweeps that take long; nothing where stderr is no terminal.
struct Progress {
    bar: ProgressBar,
    start: Instant,
}

impl Progress {
    fn new(states: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(states as u64), ProgressDrawTarget::hidden());
        Self { bar, start: Instant::now() }
    }

    fn show(&self, done: usize) {
        if self.bar.is_hidden() && self.start.elapsed() > Duration::from_millis(500) {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_position(done as u64);
    }

    fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
