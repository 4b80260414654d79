//! `hardpoint sweep`: an event, state by state.

mod cases;
mod mechanism;
mod over;
mod plan;

use std::path::PathBuf;

use clap::Args;
use hardpoint::factors::{self, Factor, Need};
use hardpoint::model::{Axes, Chassis, Document, Model, Quantity, Setup, Side, WheelSupport};
use hardpoint::programme::{StageError, rolling};
use hardpoint::report::SweepReport;
use hardpoint::rig::{self, Axle, Corner, Hold, Load, LoadPoint, Specimen, Supports, SweepPlan};
use hardpoint::solve::Stop;

use crate::dangers::dangers;
use crate::events::{EventName, VerticalOptions, Wheels};
use crate::failure::Failure;
use crate::loads::RigOptions;
use crate::output::{ConventionName, Format, Output, SideName, axes_of_words, warn_of_free};
use crate::progress::Progress;
use crate::steering::{SteerBy, SteeringOptions};
use crate::{is_axle, load};
use over::Over;
pub use plan::check_plan;

/// Move wheels, the rack, the body, a load or a driver through an event, or go through cases of a file,
/// and list every state.
///
/// Lengths, angles and forces are in the units of the model, measured from the design position. Where
/// the model has forces, every state is one of static equilibrium, and the table has the wheel
/// load, the wheel rate and what springs and bushings carry.
#[derive(Args)]
#[command(after_help = "\
Signs: travel + jounce; rack + along the model's +y; toe + toe-in; camber + top outboard;
caster + top rearward; kingpin inclination + top inboard; wheel rotation right-handed, as
Rx(a) Ry(b) Rz(c) from the design position in the model's axes; wheel load + up on the wheel;
roll + right-handed about the model's +x, which takes the left wheel to droop where x points
forward (iso8855, sae) and the right one where x points rearward (adams).

In roll all places and angles are in the axes of the ground; travel is that of the wheel in the body.

A file of cases has the names of its columns in the first line and one state in each line below: name,
rack, travel, left_travel, right_travel, fx … mz, left_fx … right_mz for loads, and wheel_force,
left_wheel_force, right_wheel_force for wheels that forces hold. Wheels that no column holds are
free, on their tyres.

Examples:
  hardpoint sweep models/double-wishbone.toml
  hardpoint sweep models/lotus-front.toml --drive contact-patch --from -37.5 --to 37.5 --step 7.5
  hardpoint sweep models/adams-tr-front.toml --rack 5 --from -10 --to 10 --side right
  hardpoint sweep models/double-wishbone.toml --event steer --travel 20 -o steer.csv
  hardpoint sweep models/subframe-axle.toml --event steer --steer-by wheel --from -360 --to 360 --step 60
  hardpoint sweep models/double-wishbone.toml --columns travel,bump_steer,rc_height,anti_dive
  hardpoint sweep models/quarter-car.toml --reactions -o forces.csv
  hardpoint sweep models/bushed-double-wishbone.toml --event load --vary fx --from -2000 --to 2000 --step 500
  hardpoint sweep models/sedan-axle.toml --axle --event opposite --from -50 --to 50
  hardpoint sweep models/sedan-axle.toml --axle --event load --vary fy --wheels opposed
  hardpoint sweep models/lotus-front.toml --axle --event roll --drive contact-patch
  hardpoint sweep models/sedan-axle.toml --axle --event roll-load --from -3 --to 3 --step 0.5
  hardpoint sweep models/sedan-axle.toml --axle --vertical force --from 2000 --to 5000 --step 500
  hardpoint sweep models/sedan-axle.toml --axle --event load --vary fy --vertical force
  hardpoint sweep models/sedan-axle.toml --axle --event envelope --over rack=-30:30:10 -o envelope.csv
  hardpoint sweep models/sedan-axle.toml --axle --event left --over right=-40:40:20
  hardpoint sweep models/sedan-axle.toml --axle --cases models/load-cases.csv
  hardpoint sweep models/four-bar.toml --driver crank_angle --from 0 --to 360 --step 10")]
pub struct Sweep {
    /// The model or mechanism file.
    model: PathBuf,
    /// What changes: the travel of the wheel, the rack, or one component of the load on the wheel;
    /// of an axle the travel in parallel, opposite, left or right, or the roll of the body [default:
    /// travel].
    #[arg(long, value_enum)]
    event: Option<EventName>,
    /// Put both sides on the rig: the model and its mirror image.
    #[arg(long, conflicts_with = "side")]
    axle: bool,
    /// The wheels of an axle that a load event loads [default: parallel].
    #[arg(long, value_enum)]
    wheels: Option<Wheels>,
    /// The component that a load event changes: fx, fy, fz, mx, my or mz.
    #[arg(long, value_name = "COMPONENT")]
    vary: Option<String>,
    /// The driver of a mechanism that moves [default: its only one].
    #[arg(long, value_name = "NAME")]
    driver: Option<String>,
    /// Go to the states of this CSV file instead of an event.
    #[arg(
        long,
        value_name = "FILE",
        conflicts_with_all = ["event", "vary", "wheels", "from", "to", "step", "over", "vertical",
            "wheel_force", "driver", "steer_by"]
    )]
    cases: Option<PathBuf>,
    #[command(flatten)]
    vertical: VerticalOptions,
    /// Go through the event at each of several values of what it holds, such as rack=-40:40:20: rack, travel,
    /// or right, the travel of the right wheel while the left one moves [default of an envelope:
    /// rack from −40 mm to 40 mm, or to the nearer limit, in four steps].
    #[arg(long, value_name = "NAME=A:B:S", allow_hyphen_values = true)]
    over: Option<Over>,
    /// First value [default: −130 mm of travel, −40 mm of the rack or its limit, −3°, −1000 N, −100 N·m].
    #[arg(long, allow_negative_numbers = true, value_name = "A")]
    from: Option<f64>,
    /// Last value [default: 130 mm of travel, 40 mm of the rack or its limit, 3°, 1000 N, 100 N·m].
    #[arg(long, allow_negative_numbers = true, value_name = "B")]
    to: Option<f64>,
    /// Distance of the states [default: 10 mm of travel, 5 mm of the rack, 30° of the steering wheel, 0.5°
    /// of roll, a tenth of the load].
    #[arg(long, allow_negative_numbers = true, value_name = "S")]
    step: Option<f64>,
    #[command(flatten)]
    steering: SteeringOptions,
    /// What --from, --to and --step of a steer event are [default: rack].
    #[arg(long, value_enum)]
    steer_by: Option<SteerBy>,
    /// Wheel travel that is held [default: 0; a load event leaves the wheel free, on its tyre]. In an
    /// opposite event it is the mean of both wheels; where forces hold the wheels, they are those at
    /// this travel.
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    travel: Option<f64>,
    #[command(flatten)]
    rig: RigOptions,
    /// The factors to list, by the names of `hardpoint factors --list`: toe,camber,rc_height; otherwise the
    /// place and orientation of the wheel, and what springs and bushings carry.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    columns: Option<Vec<String>>,
    /// Whose definitions of factors to follow where programs differ [default: iso].
    #[arg(long, value_enum)]
    convention: Option<ConventionName>,
    /// List the forces and moments of joints, too.
    #[arg(long)]
    reactions: bool,
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

fn usage<T>(message: impl Into<String>) -> Result<T, Failure> {
    Err(Failure::Usage(message.into()))
}

impl Sweep {
    /// Runs the command.
    pub fn run(mut self) -> Result<(), Failure> {
        let document = load(&self.model, self.side)?;
        self.axle |= is_axle(&document);
        // Refused before the work is done.
        let output = Output::beside(&self.model, self.output.as_deref())?;
        match document {
            Document::Suspension(model) => self.suspension(&self.rig.set(model)?, &output),
            Document::Mechanism(model) => self.mechanism(&model, &output),
        }
    }

    fn suspension(&self, model: &Model, output: &Output) -> Result<(), Failure> {
        if self.driver.is_some() {
            return usage("--driver belongs to mechanism files; a suspension has --event");
        }
        let columns = self.columns()?;
        if let Some(file) = &self.cases {
            return self.cases(file, model, columns.as_deref(), output);
        }
        let event = self.event.unwrap_or(EventName::Travel);
        if self.vary.is_some() && event != EventName::Load {
            return usage("--vary belongs to --event load");
        }
        if self.wheels.is_some() && !(self.axle && event == EventName::Load) {
            return usage("--wheels belongs to --axle with --event load");
        }
        let has_forces = if self.axle { model.axle_has_forces() } else { model.has_forces() };
        if event == EventName::Load && !has_forces {
            return usage(
                "a load moves nothing in a model without forces; add [[forces]] to the model",
            );
        }
        self.vertical.check(event, has_forces)?;
        if event == EventName::RollLoad && !has_forces {
            return usage(
                "a model without forces has no axle load to keep; add [[forces]] to the model, or use \
                 --event roll",
            );
        }
        let free = event == EventName::Load && self.travel.is_none() && !self.vertical.is_force();
        let support = if free { WheelSupport::Free } else { WheelSupport::Held };
        let mut setup = self.rig.setup(support, Chassis::Fixed);
        let at = self.rig.point();
        let (quantity, mut plan, name) = self.plan(event, model)?;
        let plans = self.plans(event, &plan, model)?;
        let sweep = if self.axle {
            let loads = self.rig.axle_loads(model)?;
            if matches!(event, EventName::Roll | EventName::RollLoad) {
                setup.chassis = self.rolling(model, &setup, at)?;
            }
            let mut axle = self.axle(model, &setup, at)?;
            axle.measure_compliance(needs_compliance(columns.as_deref()));
            self.states(&mut axle, plans, loads, model)?
        } else {
            let mut corner = self.corner(model, &setup, at)?;
            corner.measure_compliance(needs_compliance(columns.as_deref()));
            self.states(&mut corner, plans, [self.rig.load(model)?; 2], model)?
        };
        // The report needs to know what holds the wheels, not with which force.
        plan.held.vertical = self.vertical.vertical(&Supports::default(), model.units);
        let report = SweepReport {
            event: &name,
            quantity,
            plan: Some(&plan),
            factors: columns.as_deref(),
            ..self.report(model, &sweep)
        };
        self.write(&report, output)
    }

    /// A report of a suspension without what it shows.
    fn report<'a>(&self, model: &'a Model, sweep: &'a rig::Sweep) -> SweepReport<'a> {
        SweepReport {
            name: &model.name,
            sides: match (self.axle, model.side) {
                (true, _) => &[Side::Left, Side::Right],
                (false, Side::Left) => &[Side::Left],
                (false, Side::Right) => &[Side::Right],
            },
            axes: model.axes,
            units: model.units,
            event: "",
            drive: Some(self.rig.drive()),
            quantity: Quantity::Length,
            plan: None,
            cases: None,
            sweep,
            reactions: self.reactions,
            factors: None,
            convention: self.convention.unwrap_or_default().into(),
        }
    }

    fn axle(&self, model: &Model, setup: &Setup, at: LoadPoint) -> Result<Axle, Failure> {
        Axle::with_loads(model, setup, at).map_err(|error| self.cannot_stand(error))
    }

    fn corner(&self, model: &Model, setup: &Setup, at: LoadPoint) -> Result<Corner, Failure> {
        Corner::with_loads(model, setup, at).map_err(|error| self.cannot_stand(error))
    }

    fn cannot_stand(&self, error: rig::RigError) -> Failure {
        Failure::Rig(self.model.display().to_string(), Box::new(error))
    }

    /// A chassis that rolls about the static roll centre.
    fn rolling(&self, model: &Model, setup: &Setup, at: LoadPoint) -> Result<Chassis, Failure> {
        rolling(model, setup, at).map_err(|error| match error {
            StageError::Rig(error) => self.cannot_stand(error),
            StageError::NotBegun(stop) => not_begun(*stop, model.axes),
            StageError::NoRollCenter => Failure::Usage(error.to_string()),
        })
    }

    /// The factors of `--columns`.
    fn columns(&self) -> Result<Option<Vec<&'static Factor>>, Failure> {
        let Some(names) = &self.columns else { return Ok(None) };
        let find = |name: &String| {
            factors::find(name.trim()).map_err(|unknown| Failure::Usage(unknown.to_string()))
        };
        let mut columns: Vec<&'static Factor> = names.iter().map(find).collect::<Result<_, _>>()?;
        if self.over.is_some() || self.event == Some(EventName::Envelope) {
            // A grid without its places would say nothing.
            for name in ["rack", "travel"] {
                if !columns.iter().any(|factor| factor.name == name) {
                    columns.extend(factors::find(name));
                    columns.rotate_right(1);
                }
            }
        }
        Ok(Some(columns))
    }

    /// The states of plans with their names; the loads are those of the left and the right wheel.
    fn states(
        &self,
        specimen: &mut impl Specimen,
        mut plans: Vec<(String, SweepPlan)>,
        [left, right]: [Load; 2],
        model: &Model,
    ) -> Result<rig::Sweep, Failure> {
        for (_, plan) in &mut plans {
            (plan.held.load, plan.held.right_load) = (left, Some(right));
            if self.vertical.is_force() || self.event == Some(EventName::RollLoad) {
                let supports = Supports::find(specimen, &plan.held)
                    .map_err(|stop| not_begun(stop, model.axes))?;
                plan.held.vertical = self.vertical.vertical(&supports, model.units);
                if self.event == Some(EventName::RollLoad) {
                    plan.held.heave = Hold::Force(supports.chassis);
                }
                specimen.reset();
            }
        }
        let count = plans.iter().map(|(_, plan)| plan.values().len()).sum();
        Ok(self.go(count, model.axes, |progress| match plans.as_slice() {
            [(_, plan)] => rig::Sweep::run(specimen, plan, progress),
            plans => rig::Sweep::grid(specimen, plans, progress),
        }))
    }

    /// Runs a sweep of so many states with a bar, and warns of motions that nothing holds.
    fn go(
        &self,
        states: usize,
        axes: Axes,
        run: impl FnOnce(&mut dyn FnMut(usize)) -> rig::Sweep,
    ) -> rig::Sweep {
        let progress = Progress::new(states);
        let sweep = run(&mut |done| progress.show(done));
        progress.clear();
        warn_of_free(sweep.free_motions.iter().map(String::as_str), axes);
        sweep
    }

    fn write(&self, report: &SweepReport, output: &Output) -> Result<(), Failure> {
        for why in report.empty_columns() {
            eprintln!("warning: {why}; its column is empty");
        }
        let quantity = report.cases.is_none().then_some(report.quantity);
        for danger in dangers(report.sweep, quantity, report.units) {
            eprintln!("warning: {danger}");
        }
        let named = self.output.as_deref().and_then(Format::of);
        output.write(|writer| match self.format.or(named).unwrap_or(Format::Table) {
            Format::Table => report.write_table(writer),
            Format::Csv => report.write_csv(writer),
            Format::Json => report.write_json(writer),
        })?;
        let sweep = report.sweep;
        if sweep.stops.is_empty() {
            return Ok(());
        }
        let words: String = sweep.stops.iter().map(ToString::to_string).collect();
        let axes = axes_of_words(report.axes, &words);
        let rows = format!("{} of {} states were reached{axes}", sweep.rows.len(), sweep.planned);
        Err(Failure::Missed(sweep.stops.clone(), rows))
    }
}

/// Whether a column needs the compliance matrix, which costs as much as the state itself.
fn needs_compliance(columns: Option<&[&'static Factor]>) -> bool {
    columns.into_iter().flatten().any(|factor| factor.needs.contains(&Need::Compliance))
}

/// The rig did not get to where the event begins.
fn not_begun(stop: Stop, axes: Axes) -> Failure {
    let axes = axes_of_words(axes, &stop.to_string());
    Failure::Stopped(vec![stop], format!("the event has not begun{axes}"))
}
