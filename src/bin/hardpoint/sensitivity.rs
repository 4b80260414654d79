//! `hardpoint sensitivity`: how factors change with hard points and other numbers of a model.

mod plan;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use hardpoint::design::event::{Asked, here};
use hardpoint::design::{EventSensitivities, Parameter, Way, along};
use hardpoint::factors::{self, Factor};
use hardpoint::model::{Document, Model, Quantity, Side, WheelSupport};
use hardpoint::report::{SensitivityReport, write_parameters};
use hardpoint::rig::{Axle, Corner, Event, Held, Hold, RigError, Supports, SweepPlan, Variable};
use hardpoint::solve::Stop;

use crate::events::{EventName, VerticalOptions, Wheels};
use crate::failure::Failure;
use crate::loads::{RigOptions, length};
use crate::output::{ConventionName, Format, Output, SideName, axes_of_words};
use crate::progress::Progress;
use crate::steering::SteeringOptions;
use crate::{is_axle, load};

/// The factors that are shown where none are named, as far as the suspension has them.
const USUAL: [&str; 24] = [
    "toe",
    "camber",
    "caster",
    "kpi",
    "scrub_radius",
    "mechanical_trail",
    "vk_caster",
    "vk_kpi",
    "bump_steer",
    "bump_camber",
    "recession_angle",
    "rc_height",
    "anti_dive",
    "anti_lift",
    "anti_lift_drive",
    "anti_squat",
    "motion_ratio",
    "wheel_load",
    "wheel_rate",
    "ride_rate",
    "roll_rate",
    "roll_steer",
    "roll_camber",
    "ackermann",
];

/// List how design factors change with hard points, stiffnesses, lengths and static angles: exact
/// derivatives, ranked.
///
/// Each number of the model changes alone, the others stay. The rig holds the wheels at their travels, or by
/// forces that stay what they are. Where the model has forces, every state is one of static equilibrium. Both sides
/// of an axle change alike.
#[derive(Args)]
#[command(after_help = "\
A derivative is in the unit of the factor by that of the parameter, such as deg per mm. The ranking goes
by the change that 1 mm, 0.1°, 10 N, 1 N·m or a hundredth of a stiffness makes. A parameter without
effect is not in the ranking: no hard point changes toe at design, which is static toe.

Examples:
  hardpoint sensitivity models/double-wishbone.toml
  hardpoint sensitivity models/double-wishbone.toml --factor bump_steer,rc_height --travel 20 --top 5
  hardpoint sensitivity models/double-wishbone.toml --parameter tierod_inner,tierod_outer.z
  hardpoint sensitivity models/double-wishbone.toml --parameters
  hardpoint sensitivity models/double-wishbone.toml --factor toe --event travel --from -60 --to 60 --step 20
  hardpoint sensitivity models/sedan-axle.toml --axle --factor wheel_rate,roll_rate
  hardpoint sensitivity models/sedan-axle.toml --axle --event roll --factor camber --step 1 -o camber.csv
  hardpoint sensitivity models/sedan-axle.toml --axle --vertical force --wheel-force 4500 --factor toe
  hardpoint sensitivity models/compliant-corner.toml --load fy=1000 --format json")]
pub struct Sensitivity {
    /// The model file.
    model: PathBuf,
    /// The factors, by the names of `hardpoint factors --list`: toe,bump_steer [default: the usual ones that
    /// the suspension has].
    #[arg(long = "factor", value_name = "NAMES", value_delimiter = ',')]
    factors: Vec<String>,
    /// The parameters, by the names of --parameters, or all of a point, force or bushing by its name:
    /// lca_front,forces.spring [default: all].
    #[arg(long = "parameter", value_name = "NAMES", value_delimiter = ',')]
    parameter: Vec<String>,
    /// List the parameters of the model instead.
    #[arg(long, conflicts_with_all = ["factors", "event", "way", "top"])]
    parameters: bool,
    /// Put both sides on the rig: the model and its mirror image.
    #[arg(long, conflicts_with = "side")]
    axle: bool,
    /// Go through an event, and find the derivatives at each of its states.
    #[arg(long, value_enum)]
    event: Option<EventName>,
    /// The wheels of an axle that a load event loads [default: parallel].
    #[arg(long, value_enum, requires = "event")]
    wheels: Option<Wheels>,
    /// The component that a load event changes: fx, fy, fz, mx, my or mz.
    #[arg(long, value_name = "COMPONENT", requires = "event")]
    vary: Option<String>,
    /// First value of the event [default: as of `hardpoint sweep`].
    #[arg(long, allow_negative_numbers = true, value_name = "A", requires = "event")]
    from: Option<f64>,
    /// Last value of the event.
    #[arg(long, allow_negative_numbers = true, value_name = "B", requires = "event")]
    to: Option<f64>,
    /// Distance of the states of the event.
    #[arg(long, allow_negative_numbers = true, value_name = "S", requires = "event")]
    step: Option<f64>,
    /// Wheel travel from the design position, + jounce [default: 0]. Both wheels of an axle.
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    travel: Option<f64>,
    #[command(flatten)]
    vertical: VerticalOptions,
    #[command(flatten)]
    steering: SteeringOptions,
    #[command(flatten)]
    rig: RigOptions,
    /// How many parameters the table shows of each factor.
    #[arg(long, value_name = "N", default_value_t = 10)]
    top: usize,
    /// From each parameter to all factors, or from each factor to all parameters; both give the same [default: the
    /// cheaper one].
    #[arg(long, value_enum)]
    way: Option<WayName>,
    /// Whose definitions of factors to follow where programs differ.
    #[arg(long, value_enum, default_value = "iso")]
    convention: ConventionName,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
    /// How to write the derivatives [default: table, or what the ending of the file names].
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Write to a file instead of the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Which way derivatives are found.
#[derive(Clone, Copy, ValueEnum)]
enum WayName {
    /// From each parameter to all factors.
    Direct,
    /// From each factor to all parameters.
    Adjoint,
}

/// What is asked for, with the name and the quantity of the event.
struct Question {
    factors: Vec<&'static Factor>,
    parameters: Vec<Parameter>,
    event: Option<(String, Quantity)>,
    plan: SweepPlan,
}

fn usage<T>(message: impl Into<String>) -> Result<T, Failure> {
    Err(Failure::Usage(message.into()))
}

impl Sensitivity {
    /// Runs the command.
    pub fn run(mut self) -> Result<(), Failure> {
        let document = load(&self.model, self.side)?;
        self.axle |= is_axle(&document);
        // Refused before the work is done.
        let output = Output::beside(&self.model, self.output.as_deref())?;
        let Document::Suspension(model) = document else {
            return usage("factors belong to suspensions; this file is a mechanism");
        };
        let model = self.rig.set(model)?;
        let parameters = self.chosen(&model)?;
        if self.parameters {
            return output.write(|writer| write_parameters(writer, model.units, &parameters));
        }
        let has_forces = if self.axle { model.axle_has_forces() } else { model.has_forces() };
        self.vertical.check(self.event.unwrap_or(EventName::Travel), has_forces)?;
        let question = self.question(&model, parameters)?;
        let path = self.model.clone();
        let rig = |error: RigError| Failure::Rig(path.display().to_string(), Box::new(error));
        let setup = self.rig.setup(WheelSupport::Held, self.chassis(&question, &model, &rig)?);
        let mut plan = question.plan;
        let result = if self.axle {
            let [left, right] = self.rig.axle_loads(&model)?;
            (plan.held.load, plan.held.right_load) = (left, Some(right));
            let axle = Axle::with_loads(&model, &setup, self.rig.point()).map_err(rig)?;
            self.find(axle, &model, &question, &plan)?
        } else {
            plan.held.load = self.rig.load(&model)?;
            let corner = Corner::with_loads(&model, &setup, self.rig.point()).map_err(rig)?;
            self.find(corner, &model, &question, &plan)?
        };
        self.write(&model, &question, result, &output)
    }

    /// The parameters that are named, or all.
    fn chosen(&self, model: &Model) -> Result<Vec<Parameter>, Failure> {
        let all = Parameter::all(model, self.axle, self.rig.is_kinematic());
        if self.parameter.is_empty() {
            return Ok(all);
        }
        let mut chosen: Vec<Parameter> = vec![];
        for word in &self.parameter {
            let found = Parameter::named(&all, word.trim());
            for parameter in found.map_err(|unknown| Failure::Usage(unknown.to_string()))? {
                if !chosen.contains(&parameter) {
                    chosen.push(parameter);
                }
            }
        }
        Ok(chosen)
    }

    fn question(&self, model: &Model, parameters: Vec<Parameter>) -> Result<Question, Failure> {
        let names: Vec<&str> = match self.factors.is_empty() {
            true => USUAL.to_vec(),
            false => self.factors.iter().map(|name| name.trim()).collect(),
        };
        let find = |name: &&str| {
            factors::find(name).map_err(|unknown| Failure::Usage(unknown.to_string()))
        };
        let factors = names.iter().map(find).collect::<Result<_, _>>()?;
        let travel = length("--travel", self.travel, model.units)?;
        let held = Held { travel, rack: self.steering.rack(model)?, ..Held::default() };
        let still = SweepPlan { event: Event::Travel, from: travel, to: travel, step: 0.0, held };
        let Some(event) = self.event else {
            return Ok(Question { factors, parameters, event: None, plan: still });
        };
        let (course, plan) = self.plan(event, model, held)?;
        let event = Some((course.name, course.quantity));
        Ok(Question { factors, parameters, event, plan })
    }

    fn find(
        &self,
        mut specimen: impl Variable,
        model: &Model,
        question: &Question,
        plan: &SweepPlan,
    ) -> Result<EventSensitivities, Failure> {
        let way = match self.way {
            None => Way::Automatic,
            Some(WayName::Direct) => Way::Direct,
            Some(WayName::Adjoint) => Way::Adjoint,
        };
        let asked = Asked {
            model,
            factors: &question.factors,
            convention: self.convention.into(),
            parameters: &question.parameters,
            way,
        };
        let mut plan = *plan;
        let keeps_load = self.event == Some(EventName::RollLoad);
        if self.vertical.is_force() || keeps_load {
            let supports = Supports::find(&mut specimen, &plan.held)
                .map_err(|stop| not_reached(stop, model))?;
            plan.held.vertical = self.vertical.vertical(&supports, model.units);
            if keeps_load {
                plan.held.heave = Hold::Force(supports.chassis);
            }
            specimen.reset();
        }
        if question.event.is_some() {
            let progress = Progress::new(plan.values().len());
            let result = along(&mut specimen, &plan, &asked, |done| progress.show(done));
            progress.clear();
            return Ok(result);
        }
        specimen.go_to(&plan.held.target()).map_err(|stop| not_reached(stop, model))?;
        let path = self.model.display();
        let state = here(&mut specimen, plan.from, &asked).map_err(|failure| {
            let note = format!("error: {path}: {failure}");
            Failure::Incomplete(vec![note], "no derivatives were found".to_owned())
        })?;
        Ok(EventSensitivities { states: vec![state], planned: 1, ..Default::default() })
    }

    fn write(
        &self,
        model: &Model,
        question: &Question,
        mut result: EventSensitivities,
        output: &Output,
    ) -> Result<(), Failure> {
        self.keep_factors(&mut result);
        let report = SensitivityReport {
            name: &model.name,
            sides: match (self.axle, model.side) {
                (true, _) => &[Side::Left, Side::Right],
                (false, Side::Left) => &[Side::Left],
                (false, Side::Right) => &[Side::Right],
            },
            axes: model.axes,
            units: model.units,
            drive: self.rig.drive(),
            convention: self.convention.into(),
            parameters: &question.parameters,
            event: question.event.as_ref().map(|(name, quantity)| (name.as_str(), *quantity)),
            result: &result,
            top: self.top,
        };
        let first = result.states.first().filter(|_| !self.factors.is_empty());
        for (name, why) in first.into_iter().flat_map(|state| &state.found.lacking) {
            eprintln!("warning: `{name}` needs {why}; it has no derivatives");
        }
        let named = self.output.as_deref().and_then(|path: &Path| Format::of(path));
        output.write(|writer| match self.format.or(named).unwrap_or(Format::Table) {
            Format::Table => report.write_table(writer),
            Format::Csv => report.write_csv(writer),
            Format::Json => report.write_json(writer),
        })?;
        let notes = result.without.iter().map(|(_, failure)| failure.to_string());
        let stops = result.stops.iter().map(ToString::to_string);
        let notes: Vec<String> = stops.chain(notes).collect();
        if notes.is_empty() {
            return Ok(());
        }
        let (states, planned) = (result.states.len(), result.planned);
        let axes = axes_of_words(model.axes, &notes.concat());
        let rows = format!("{states} of {planned} states have derivatives{axes}");
        Err(Failure::Incomplete(notes, rows))
    }

    /// Leaves out usual factors that no state has.
    fn keep_factors(&self, result: &mut EventSensitivities) {
        if !self.factors.is_empty() {
            return;
        }
        let states = &mut result.states;
        let count = states.first().map_or(0, |state| state.found.rows.len());
        let kept: Vec<bool> = (0..count)
            .map(|row| states.iter().any(|state| state.found.rows[row].value.is_some()))
            .collect();
        for state in states {
            let mut kept = kept.iter();
            state.found.rows.retain(|_| *kept.next().unwrap_or(&true));
        }
    }
}

fn not_reached(stop: Stop, model: &Model) -> Failure {
    let axes = axes_of_words(model.axes, &stop.to_string());
    Failure::Stopped(vec![stop], format!("the state was not reached{axes}"))
}
