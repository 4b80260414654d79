//! `hardpoint settle`: let a model come to rest, and compare with its equilibrium.

use std::path::PathBuf;

use clap::Args;
use hardpoint::factors::{Convention, Factor, basic};
use hardpoint::mechanism::DriverId;
use hardpoint::model::{
    Axes, Chassis, Document, Marker, MechanismModel, Model, Quantity, Side, Units, WheelSupport,
};
use hardpoint::relation::Coordinates;
use hardpoint::report::{SettleReport, SettleRow};
use hardpoint::rig::{Axle, Channel, Corner, Pose, RigError, Stand, follow};
use hardpoint::solve::dynamics::{
    Dynamics, DynamicsFailure, Integrator, SettlePlan, Start, StepSize, Trajectory,
};
use hardpoint::solve::{StaticFailure, StaticReport};

use crate::equilibrium::{refuse_fixed_chassis, released};
use crate::failure::Failure;
use crate::loads::RigOptions;
use crate::output::{Output, Sheet, SideName, axes_of_words};
use crate::{is_axle, load};

/// More samples than this are a mistake in the interval.
const MOST_SAMPLES: f64 = 1e6;

/// More steps than this are a mistake in their length.
const MOST_STEPS: f64 = 1e7;

/// Integrate the motion from the design position and compare its end with the equilibrium.
///
/// A quarter car falls from the design position onto its tyre and its spring; a mechanism starts with the
/// velocities of its file. The table has A, the end of the motion, B, the quasi-static equilibrium, and
/// B − A. The motion is integrated by the generalised-α method, with adaptive steps or one of a
/// given length.
#[derive(Args)]
#[command(after_help = "\
Examples:
  hardpoint settle models/quarter-car.toml --seconds 5
  hardpoint settle models/quarter-car.toml --step 0.0005 -o motion.csv
  hardpoint settle models/quarter-car.toml --fixed-chassis --load fz=500
  hardpoint settle models/sedan-axle.toml --axle --load left.fz=500
  hardpoint settle models/squeezer.toml --seconds 0.03 --step 1e-5")]
pub struct Settle {
    /// The model or mechanism file.
    model: PathBuf,
    /// Put both sides on the rig: the model and its other side.
    #[arg(long, conflicts_with = "side")]
    axle: bool,
    /// How long the motion is followed (s).
    #[arg(long, default_value_t = 5.0, allow_negative_numbers = true, value_name = "S")]
    seconds: f64,
    /// Length of all steps (s), at most: a whole number of them makes --interval, or --seconds where
    /// no motion is written [default: as long as --tolerance allows].
    #[arg(long, allow_negative_numbers = true, value_name = "S")]
    step: Option<f64>,
    /// Local error of a step, relative to the size of the mechanism.
    #[arg(long, default_value_t = 1e-8, value_name = "E", conflicts_with = "step")]
    tolerance: f64,
    /// Numerical damping of the method: its spectral radius at infinity, 0 to 1.
    #[arg(long, default_value_t = 0.8, value_name = "R")]
    spectral_radius: f64,
    /// Write the motion to this CSV file.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Time between the lines of the CSV file (s).
    #[arg(long, default_value_t = 0.01, value_name = "S")]
    interval: f64,
    #[command(flatten)]
    rig: RigOptions,
    /// Write what the joints carry, too, to the CSV file.
    #[arg(long, requires = "output")]
    reactions: bool,
    /// Hold the chassis of a quarter car.
    #[arg(long)]
    fixed_chassis: bool,
    /// Let this driver of a mechanism go; may be given several times.
    #[arg(long, value_name = "DRIVER")]
    release: Vec<String>,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
    /// How to write the table.
    #[arg(long, value_enum, default_value = "table")]
    format: Sheet,
}

/// Where the wheels are at a state of the mechanism.
type Poses<'a> = dyn Fn(&[Coordinates<f64>]) -> Vec<Pose<f64>> + 'a;

/// What the columns of a motion are.
struct Recorder<'a> {
    units: Units,
    axes: Axes,
    /// The sides of the wheels, none of a mechanism.
    sides: &'a [Side],
    poses: &'a Poses<'a>,
    channels: &'a [Channel],
    markers: &'a [Marker],
    /// The channels of joints; none where nobody asks for them.
    joints: &'a [Channel],
}

/// A suspension on the rig with its equilibrium.
struct Specimen<'a> {
    stand: &'a Stand,
    /// The drivers of the heights of the wheels.
    released: &'a [DriverId],
    equilibrium: Result<StaticReport, StaticFailure>,
    title: String,
}

impl Settle {
    /// Runs the command.
    pub fn run(mut self) -> Result<(), Failure> {
        let samples = self.seconds / self.interval;
        if !(samples.is_finite() && samples > 0.0 && self.interval > 0.0) {
            return Err(Failure::Usage("--seconds and --interval have to be above zero".into()));
        }
        if samples > MOST_SAMPLES {
            return Err(Failure::Usage("--interval is too short: at most 1,000,000 lines".into()));
        }
        if self.step.is_some_and(|step| self.seconds / step > MOST_STEPS) {
            return Err(Failure::Usage("--step is too short: at most 10,000,000 steps".into()));
        }
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
        if !self.release.is_empty() {
            return Err(Failure::Usage(
                "--release names drivers of a mechanism file; a suspension has none".into(),
            ));
        }
        let slides = model.is_quarter_car() && !self.fixed_chassis && !self.axle;
        let chassis = if slides { Chassis::Slide } else { Chassis::Fixed };
        let setup = self.rig.setup(WheelSupport::Free, chassis);
        let axes = model.axes.name();
        if self.axle {
            let loads = self.rig.axle_loads(model)?;
            let mut axle = Axle::with_loads(model, &setup, self.rig.point())
                .map_err(|error| self.cannot_stand(error))?;
            axle.set_load(&loads);
            let specimen = Specimen {
                equilibrium: axle.rest(),
                stand: axle.stand(),
                released: &axle.suspension().sides.map(|part| part.travel),
                title: format!("{}, axle, {axes} axes", model.name),
            };
            let sides = [Side::Left, Side::Right];
            let recorder = Recorder {
                units: model.units,
                axes: model.axes,
                sides: &sides,
                poses: &|state| sides.map(|side| axle.pose_at(side, state)).to_vec(),
                channels: axle.element_channels(),
                markers: &[],
                joints: self.joints(axle.stand()),
            };
            return self.follow(&specimen, &recorder, output);
        }
        let load = self.rig.load(model)?;
        let mut corner = Corner::with_loads(model, &setup, self.rig.point())
            .map_err(|error| self.cannot_stand(error))?;
        corner.set_load(&load);
        let specimen = Specimen {
            equilibrium: corner.rest(),
            stand: corner.stand(),
            released: &[corner.suspension().travel],
            title: format!("{}, {} side, {axes} axes", model.name, model.side.name()),
        };
        let recorder = Recorder {
            units: model.units,
            axes: model.axes,
            sides: &[model.side],
            poses: &|state| vec![corner.pose_at(state)],
            channels: corner.element_channels(),
            markers: &[],
            joints: self.joints(corner.stand()),
        };
        self.follow(&specimen, &recorder, output)
    }

    /// The channels of joints, where they are asked for.
    fn joints<'a>(&self, stand: &'a Stand) -> &'a [Channel] {
        if self.reactions { stand.reaction_channels() } else { &[] }
    }

    /// Follows the motion of wheels and compares its end with the equilibrium.
    fn follow(
        &self,
        specimen: &Specimen,
        recorder: &Recorder,
        output: &Output,
    ) -> Result<(), Failure> {
        let Specimen { stand, released, equilibrium, title } = specimen;
        let (units, axes) = (recorder.units, recorder.axes);
        let mut dynamics = self.dynamics(stand, released, axes)?;
        let trajectory = self.integrate(&mut dynamics, recorder, output)?;
        let ends = (recorder.poses)(dynamics.state());
        let rests = (recorder.poses)(stand.state());
        // Travel and rack are what the rig holds in a sweep, no part of the paper's table.
        let held = ["travel", "rack", "steering_wheel_angle"];
        let shown: Vec<_> = kinematic().filter(|factor| !held.contains(&factor.name)).collect();
        let mut rows = vec![];
        for (end, rest) in ends.iter().zip(&rests) {
            let side = if ends.len() > 1 { format!("{} ", end.side.name()) } else { String::new() };
            rows.extend(shown.iter().filter_map(|factor| {
                let rest = equilibrium.as_ref().ok().map(|_| rest);
                Some(SettleRow {
                    title: format!("{side}{}", factor.title),
                    quantity: factor.quantity,
                    dynamic: factor.value(Convention::Iso, end)?,
                    quasi_static: rest.and_then(|rest| factor.value(Convention::Iso, rest)),
                })
            }));
        }
        self.tell(title, (units, axes), &dynamics, &rows, equilibrium)?;
        self.end(trajectory, axes)
    }

    fn mechanism(&self, model: &MechanismModel, output: &Output) -> Result<(), Failure> {
        self.rig.refuse()?;
        refuse_fixed_chassis(self.fixed_chassis)?;
        if self.axle {
            return Err(Failure::Usage(
                "--axle belongs to suspensions; this file is a mechanism".into(),
            ));
        }
        let released = released(&self.release, model)?;
        let mut stand = Stand::new(model.mechanism.clone(), &released, Axes::Iso8855)
            .map_err(|error| self.cannot_stand(error))?;
        let equilibrium = stand.rest();
        let (units, axes) = (model.units, Axes::Iso8855);
        let mut dynamics = self.dynamics(&stand, &released, axes)?;
        let channels: Vec<Channel> = [stand.body_channels(), stand.force_channels()].concat();
        let recorder = Recorder {
            units,
            axes,
            sides: &[],
            poses: &|_| vec![],
            channels: &channels,
            markers: &model.markers,
            joints: self.joints(&stand),
        };
        let trajectory = self.integrate(&mut dynamics, &recorder, output)?;
        let (end, rest) = (dynamics.loaded(), stand.equilibrium().loaded());
        let row = |channel: &Channel| SettleRow {
            title: channel.title.clone(),
            quantity: channel.quantity,
            dynamic: channel.value(&end, &[], axes),
            quasi_static: equilibrium.is_ok().then(|| channel.value(&rest, &[], axes)),
        };
        let rows: Vec<SettleRow> = stand.body_channels().iter().map(row).collect();
        self.tell(&model.name, (units, axes), &dynamics, &rows, &equilibrium)?;
        self.end(trajectory, axes)
    }

    fn dynamics(
        &self,
        stand: &Stand,
        released: &[DriverId],
        axes: Axes,
    ) -> Result<Dynamics, Failure> {
        let step = match self.step {
            Some(step) => StepSize::Fixed(step),
            None => StepSize::Adaptive { tolerance: self.tolerance, largest: 0.02 },
        };
        let integrator = Integrator { spectral_radius: self.spectral_radius, step };
        // Loads on the wheel are part of the laws.
        let laws = Some(stand.equilibrium().elements().laws());
        let start = Start { released, laws, ..Start::default() };
        Dynamics::new(stand.system(), &start, integrator)
            .map_err(|failure| self.fails(failure, axes))
    }

    /// Follows the motion; returns the lines of the CSV file.
    fn integrate(
        &self,
        dynamics: &mut Dynamics,
        recorder: &Recorder,
        output: &Output,
    ) -> Result<Trajectory<Vec<f64>>, Failure> {
        let interval = if self.output.is_some() { self.interval } else { self.seconds };
        let plan = SettlePlan { until: self.seconds, interval, rest: None };
        let trajectory = dynamics.settle(&plan, |dynamics| recorder.sample(dynamics));
        let trajectory = trajectory.map_err(|failure| self.fails(failure, recorder.axes))?;
        if let Output::File(_) = output {
            output.write(|writer| {
                let mut csv = csv::Writer::from_writer(writer);
                csv.write_record(recorder.header())?;
                for (time, values) in &trajectory.samples {
                    let numbers = std::iter::once(time).chain(values);
                    csv.write_record(numbers.map(f64::to_string))?;
                }
                csv.flush()
            })?;
        }
        Ok(trajectory)
    }

    fn tell(
        &self,
        title: &str,
        (units, axes): (Units, Axes),
        dynamics: &Dynamics,
        rows: &[SettleRow],
        equilibrium: &Result<StaticReport, StaticFailure>,
    ) -> Result<(), Failure> {
        let failure = equilibrium.as_ref().err().map(|failure| {
            let words = failure.to_string();
            format!("{words}{}", axes_of_words(axes, &words))
        });
        let report = SettleReport {
            title,
            units,
            seconds: dynamics.time(),
            rows,
            motion: dynamics.report(),
            energy: dynamics.energy(),
            speed: dynamics.largest_speed(),
            start: dynamics.start(),
            equilibrium: match (equilibrium, &failure) {
                (Ok(found), _) => Ok(found),
                (Err(_), failure) => Err(failure.as_deref().unwrap_or_default()),
            },
        };
        Output::Stdout.write(|writer| match self.format {
            Sheet::Json => report.write_json(writer),
            Sheet::Table => report.write_text(writer),
        })
    }

    /// A motion that stopped early is a failure, told behind what it got to.
    fn end(&self, trajectory: Trajectory<Vec<f64>>, axes: Axes) -> Result<(), Failure> {
        match trajectory.stop {
            Some(stop) => Err(self.fails(stop, axes)),
            None => Ok(()),
        }
    }

    fn cannot_stand(&self, error: RigError) -> Failure {
        Failure::Rig(self.model.display().to_string(), Box::new(error))
    }

    fn fails(&self, failure: DynamicsFailure, axes: Axes) -> Failure {
        if let DynamicsFailure::Setting { .. } = failure {
            return Failure::Usage(failure.to_string());
        }
        Failure::Motion(self.model.display().to_string(), failure, axes)
    }
}

impl Recorder<'_> {
    fn header(&self) -> Vec<String> {
        let mut header = vec!["time_s".to_owned()];
        for side in self.sides {
            let before =
                if self.sides.len() > 1 { format!("{}_", side.name()) } else { String::new() };
            let column = |factor: &Factor| format!("{before}{}", factor.column(self.units));
            header.extend(kinematic().map(column));
        }
        let channel =
            |channel: &Channel| format!("{}_{}", channel.name, channel.quantity.symbol(self.units));
        header.extend(self.channels.iter().map(channel));
        header.extend(self.markers.iter().flat_map(|marker| follow::columns(marker, self.units)));
        header.extend(self.joints.iter().map(channel));
        header.extend(
            ["kinetic_energy_J", "potential_energy_J", "work_J", "energy_drift_J"]
                .map(String::from),
        );
        header
    }

    fn sample(&self, dynamics: &Dynamics) -> Vec<f64> {
        let mut values = vec![];
        for pose in (self.poses)(dynamics.state()) {
            let value =
                |factor: &'static Factor| factor.show(self.units, &pose).unwrap_or(f64::NAN);
            values.extend(kinematic().map(value));
        }
        let loaded = dynamics.loaded();
        let reactions = if self.joints.is_empty() { vec![] } else { dynamics.reactions() };
        let value = |channel: &Channel| {
            channel.quantity.show(self.units, channel.value(&loaded, &reactions, self.axes))
        };
        values.extend(self.channels.iter().map(value));
        let marker = |marker| follow::values(marker, dynamics, self.units);
        values.extend(self.markers.iter().flat_map(marker));
        values.extend(self.joints.iter().map(value));
        let energy = dynamics.energy();
        values.extend([energy.kinetic, energy.potential, energy.work, energy.drift]);
        values
    }
}

/// The factors that a moving wheel has.
fn kinematic() -> impl Iterator<Item = &'static Factor> {
    basic().filter(|f| matches!(f.quantity, Quantity::Length | Quantity::Angle))
}
