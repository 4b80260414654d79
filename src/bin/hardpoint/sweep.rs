//! `hardpoint sweep`: an event, state by state.

use std::path::PathBuf;

use clap::Args;
use hardpoint::factors::{self, Convention, Factor};
use hardpoint::mechanism::DriverId;
use hardpoint::model::{
    Axes, Chassis, Document, MechanismModel, Model, Quantity, Side, Units, WheelSupport,
};
use hardpoint::report::SweepReport;
use hardpoint::rig::{self, Axle, Corner, Held, Specimen, Stand, SweepPlan};

use crate::events::{Course, EventName, Wheels};
use crate::failure::Failure;
use crate::load;
use crate::loads::{FARTHEST, RigOptions};
use crate::output::{ConventionName, Format, Output, SideName, axes_of_words};
use crate::progress::Progress;

/// More states than this are a mistake in the step.
const MOST_STATES: f64 = 1e6;

/// Move wheels, the rack, a load or a driver through an event and list every state.
///
/// Lengths, angles and forces are in the units of the model, measured from the design position. Where
/// the model has forces, every state is one of static equilibrium, and the table has the wheel
/// load, the wheel rate and what springs and bushings carry.
#[derive(Args)]
#[command(after_help = "\
Signs: travel + jounce; rack + along the model's +y; toe + toe-in; camber + top outboard;
caster + top rearward; kingpin inclination + top inboard; wheel rotation right-handed, as
Rx(a) Ry(b) Rz(c) from the design position in the model's axes; wheel load + up on the wheel.

Examples:
  hardpoint sweep models/double-wishbone.toml
  hardpoint sweep models/lotus-front.toml --drive contact-patch --from -37.5 --to 37.5 --step 7.5
  hardpoint sweep models/adams-tr-front.toml --rack 5 --from -10 --to 10 --side right
  hardpoint sweep models/double-wishbone.toml --event steer --travel 20 -o steer.csv
  hardpoint sweep models/double-wishbone.toml --columns travel,bump_steer,rc_height,anti_dive
  hardpoint sweep models/quarter-car.toml --reactions -o forces.csv
  hardpoint sweep models/bushed-double-wishbone.toml --event load --vary fx --from -2000 --to 2000 --step 500
  hardpoint sweep models/sedan-axle.toml --axle --event opposite --from -50 --to 50
  hardpoint sweep models/sedan-axle.toml --axle --event load --vary fy --wheels opposed
  hardpoint sweep models/four-bar.toml --driver crank --from 0 --to 360 --step 10")]
pub struct Sweep {
    /// The model or mechanism file.
    model: PathBuf,
    /// What changes: the travel of the wheel, the rack, or one component of the load on the wheel;
    /// of an axle the travel in parallel, opposite, left or right [default: travel].
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
    /// First value [default: −130 mm of travel, −40 mm of the rack, −1000 N, −100 N·m].
    #[arg(long, allow_negative_numbers = true, value_name = "A")]
    from: Option<f64>,
    /// Last value [default: 130 mm of travel, 40 mm of the rack, 1000 N, 100 N·m].
    #[arg(long, allow_negative_numbers = true, value_name = "B")]
    to: Option<f64>,
    /// Distance of the states [default: 10 mm of travel, 5 mm of the rack, a tenth of the load].
    #[arg(long, allow_negative_numbers = true, value_name = "S")]
    step: Option<f64>,
    /// Rack displacement that is held [default: 0].
    #[arg(long, allow_negative_numbers = true, value_name = "R")]
    rack: Option<f64>,
    /// Wheel travel that is held [default: 0; a load event leaves the wheel free, on its tyre]. In an
    /// opposite event it is the mean of both wheels.
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
    pub fn run(&self) -> Result<(), Failure> {
        let document = load(&self.model, self.side)?;
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
        let free = event == EventName::Load && self.travel.is_none();
        let support = if free { WheelSupport::Free } else { WheelSupport::Held };
        let setup = self.rig.setup(support, Chassis::Fixed);
        let at = self.rig.point();
        let rig = |error| Failure::Rig(self.model.display().to_string(), Box::new(error));
        let (quantity, mut plan, name) = self.plan(event, model.units, model.steers())?;
        let sweep = if self.axle {
            let [left, right] = self.rig.axle_loads(model)?;
            (plan.held.load, plan.held.right_load) = (left, Some(right));
            let mut axle = Axle::with_loads(model, &setup, at).map_err(rig)?;
            self.states(&mut axle, &plan, model.axes)
        } else {
            plan.held.load = self.rig.load(model)?;
            let mut corner = Corner::with_loads(model, &setup, at).map_err(rig)?;
            self.states(&mut corner, &plan, model.axes)
        };
        let side = [model.side];
        let report = SweepReport {
            name: &model.name,
            sides: if self.axle { &[Side::Left, Side::Right] } else { &side },
            axes: model.axes,
            units: model.units,
            event: &name,
            drive: Some(self.rig.drive()),
            quantity,
            plan: &plan,
            sweep: &sweep,
            reactions: self.reactions,
            factors: columns.as_deref(),
            convention: self.convention.unwrap_or_default().into(),
        };
        self.write(&report, output)
    }

    fn mechanism(&self, model: &MechanismModel, output: &Output) -> Result<(), Failure> {
        let suspension = [
            (self.event.is_some(), "--event"),
            (self.vary.is_some(), "--vary"),
            (self.rack.is_some(), "--rack"),
            (self.travel.is_some(), "--travel"),
            (self.axle, "--axle"),
            (self.wheels.is_some(), "--wheels"),
            (self.columns.is_some(), "--columns"),
            (self.convention.is_some(), "--convention"),
        ];
        if let Some((_, option)) = suspension.iter().find(|(given, _)| *given) {
            return usage(format!("{option} belongs to suspensions; this file is a mechanism"));
        }
        self.rig.refuse()?;
        let driver = self.driver_of(model)?;
        let part = &model.mechanism.drivers()[driver.index()];
        let quantity = if part.kind.unit() == "rad" { Quantity::Angle } else { Quantity::Length };
        let name = part.name.clone();
        let mut stand = Stand::new(model.mechanism.clone(), &[], Axes::Iso8855)
            .map_err(|error| Failure::Rig(self.model.display().to_string(), Box::new(error)))?;
        let (Some(from), Some(to)) = (self.from, self.to) else {
            return usage(format!(
                "say the range of driver {name} in {} with --from and --to",
                quantity.symbol(model.units)
            ));
        };
        let step = self.step.unwrap_or((to - from) / 10.0);
        let value = |value| quantity.to_si(model.units, value);
        self.check_values(|length| model.units.length.to_metres(length))?;
        let plan = SweepPlan {
            event: rig::Event::Driver(driver),
            from: value(from),
            to: value(to),
            step: value(step),
            held: Held::default(),
        };
        check_states(&plan)?;
        let sweep = self.states(&mut stand, &plan, Axes::Iso8855);
        let report = SweepReport {
            name: &model.name,
            sides: &[],
            axes: Axes::Iso8855,
            units: model.units,
            event: &name,
            drive: None,
            quantity,
            plan: &plan,
            sweep: &sweep,
            reactions: self.reactions,
            factors: None,
            convention: Convention::Iso,
        };
        self.write(&report, output)
    }

    /// The factors of `--columns`.
    fn columns(&self) -> Result<Option<Vec<&'static Factor>>, Failure> {
        let Some(names) = &self.columns else { return Ok(None) };
        let find = |name: &String| {
            factors::find(name.trim()).map_err(|unknown| Failure::Usage(unknown.to_string()))
        };
        names.iter().map(find).collect::<Result<_, _>>().map(Some)
    }

    fn driver_of(&self, model: &MechanismModel) -> Result<DriverId, Failure> {
        if let Some(name) = &self.driver {
            let found = crate::equilibrium::released(std::slice::from_ref(name), model)?;
            return Ok(found[0]);
        }
        let mut drivers = model.mechanism.driver_ids();
        match (drivers.next(), drivers.next()) {
            (Some(only), None) => Ok(only),
            (None, _) => {
                usage("the mechanism has no driver; add a [[drivers]] section to the file")
            }
            _ => usage("the mechanism has several drivers; name one with --driver"),
        }
    }

    fn states(&self, specimen: &mut impl Specimen, plan: &SweepPlan, axes: Axes) -> rig::Sweep {
        let progress = Progress::new(plan.values().len());
        let sweep = rig::Sweep::run(specimen, plan, |done| progress.show(done));
        progress.clear();
        for motion in &sweep.free_motions {
            let axes = axes_of_words(axes, motion);
            eprintln!(
                "warning: no joint holds this motion: {motion}{axes}; values that depend on it are not \
                 determined by the model. Add a joint"
            );
        }
        sweep
    }

    fn write(&self, report: &SweepReport, output: &Output) -> Result<(), Failure> {
        for why in report.empty_columns() {
            eprintln!("warning: {why}; its column is empty");
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
        Err(Failure::Stopped(sweep.stops.clone(), rows))
    }

    fn check_values(&self, metres: impl Fn(f64) -> f64) -> Result<(), Failure> {
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
                return usage(format!("{name} is not a finite number"));
            }
            let is_length = match name {
                "--step" => false,
                "--from" | "--to" => self.event != Some(EventName::Load) && self.driver.is_none(),
                _ => true,
            };
            if is_length && metres(value).abs() > FARTHEST {
                return usage(format!(
                    "{name} is more than a kilometre; lengths are in the unit of the model"
                ));
            }
        }
        Ok(())
    }

    /// The states of a corner to visit, what their values are, and the name of the event.
    fn plan(
        &self,
        event: EventName,
        units: Units,
        steers: bool,
    ) -> Result<(Quantity, SweepPlan, String), Failure> {
        let metres = |length: f64| units.length.to_metres(length);
        self.check_values(metres)?;
        if self.rack.is_some_and(|rack| rack != 0.0) && !steers {
            return usage("this suspension has no rack; leave out --rack");
        }
        match event {
            EventName::Travel | EventName::Parallel if self.travel.is_some() => {
                return usage(
                    "a travel event moves the travel; hold the rack with --rack, \
                     and say the range of travel with --from and --to",
                );
            }
            EventName::Steer if self.rack.is_some() => {
                return usage(
                    "a steer event moves the rack; hold the travel with --travel, \
                     and say the range of the rack with --from and --to",
                );
            }
            EventName::Steer if !steers => {
                return usage("this suspension has no rack, so there is no steer event");
            }
            _ => {}
        }
        let Course { event, quantity, range, step, name } = if self.axle {
            Course::of_axle(event, self.vary.as_deref(), self.wheels)?
        } else {
            Course::of_corner(event, self.vary.as_deref())?
        };
        let value = |value: Option<f64>, default: f64| {
            value.map_or(default, |value| quantity.to_si(units, value))
        };
        let length = |value: Option<f64>| value.map_or(0.0, metres);
        let plan = SweepPlan {
            event,
            from: value(self.from, -range),
            to: value(self.to, range),
            step: value(self.step, step),
            held: Held { travel: length(self.travel), rack: length(self.rack), ..Held::default() },
        };
        check_states(&plan)?;
        Ok((quantity, plan, name))
    }
}

fn check_states(plan: &SweepPlan) -> Result<(), Failure> {
    let states = ((plan.to - plan.from) / plan.step).abs();
    if plan.step == 0.0 && plan.from != plan.to {
        return usage("--step is zero");
    }
    if states > MOST_STATES {
        return usage("--step is too small for the range: at most 1,000,000 states");
    }
    Ok(())
}
