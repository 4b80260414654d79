//! `hardpoint check`: is this model sound?

mod range;

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use hardpoint::factors::{self, Convention, basic};
use hardpoint::mechanism::{BodyId, Force};
use hardpoint::model::{Axes, Document, MechanismModel, Model, Quantity, Setup, Side, Units};
use hardpoint::report::write_adjustments;
use hardpoint::rig::{Adjustment, Axle, Corner, Pose, RigError, Stand};
use hardpoint::solve::{StaticFailure, StaticReport};

use crate::failure::Failure;
use crate::output::{Output, SideName, axes_of_words};
use crate::settings::Settings;
use crate::{is_axle, load};

/// Check a model: mistakes in the file, degrees of freedom, redundant equations, free motions.
///
/// Prints what the model is, what its adjusters are set to, and its factors at the design position or in its
/// static state.
#[derive(Args)]
#[command(after_help = "\
Examples:
  hardpoint check models/double-wishbone.toml
  hardpoint check models/sedan-axle.toml --axle
  hardpoint check models/adams-tr-front.toml --side right
  hardpoint check models/double-wishbone-pushrod.toml --range 60 --clearance 25")]
pub struct Check {
    /// The model or mechanism file.
    model: PathBuf,
    /// Put both sides together: the model and its other side.
    #[arg(long, conflicts_with = "side")]
    axle: bool,
    /// Look at this side of the vehicle; the other side is the mirror image of the model.
    #[arg(long)]
    side: Option<SideName>,
    /// Move both wheels up and down by this travel at the rack's middle and ends, too, and tell where the range
    /// ends, what comes near to a dead centre, and which links come near to each other or cross
    /// [80 mm without a value].
    #[arg(long, value_name = "T", num_args = 0..=1)]
    range: Option<Option<f64>>,
    /// The distance that middle lines of links, springs and dampers have to keep from each other in --range: of
    /// two tubes the sum of their radii and some air [default: 30 mm].
    #[arg(long, value_name = "D", requires = "range", allow_negative_numbers = true)]
    clearance: Option<f64>,
    #[command(flatten)]
    settings: Settings,
}

impl Check {
    /// Runs the command.
    pub fn run(mut self) -> Result<(), Failure> {
        let document = load(&self.model, self.side)?;
        self.axle |= is_axle(&document);
        let rig = |error| Failure::Rig(self.model.display().to_string(), Box::new(error));
        let document = match document {
            Document::Suspension(model) => Document::Suspension(self.settings.apply(model)?),
            mechanism => mechanism,
        };
        self.facts(&document, rig)?;
        match (document, self.range) {
            (_, None) => Ok(()),
            (Document::Suspension(model), Some(range)) => self.working_range(&model, range),
            (Document::Mechanism(_), Some(_)) => Err(Failure::Usage(
                "--range belongs to suspensions; this file is a mechanism".into(),
            )),
        }
    }

    fn facts(&self, document: &Document, rig: impl Fn(RigError) -> Failure) -> Result<(), Failure> {
        match document {
            Document::Suspension(model) if self.axle => {
                let mut axle = Axle::new(model, &Setup::default()).map_err(rig)?;
                warn_of_ratio(model);
                let poses = [Side::Left, Side::Right].map(|side| axle.pose(side));
                let leaves = leaves_free(axle.stand());
                let held = leaves.then(|| held(axle.rest(), model.units));
                let parts = (axle.stand(), axle.forces(), axle.adjustments());
                Output::Stdout.write(|writer| suspension(writer, model, parts, &poses, held))
            }
            Document::Suspension(model) => {
                warn_of_ratio(model);
                let mut corner = Corner::new(model, &Setup::default()).map_err(rig)?;
                let poses = [corner.pose()];
                let leaves = leaves_free(corner.stand());
                let held = leaves.then(|| held(corner.rest(), model.units));
                let parts = (corner.stand(), corner.forces(), corner.adjustments());
                Output::Stdout.write(|writer| suspension(writer, model, parts, &poses, held))
            }
            Document::Mechanism(_) if self.axle => Err(Failure::Usage(
                "--axle belongs to suspensions; this file is a mechanism".into(),
            )),
            Document::Mechanism(_) if self.settings.given() => {
                Err(Failure::Usage("--set belongs to suspensions; this file is a mechanism".into()))
            }
            Document::Mechanism(model) => {
                let mut stand =
                    Stand::new(model.mechanism.clone(), &[], Axes::Iso8855).map_err(rig)?;
                let held = leaves_free(&stand).then(|| held(stand.rest(), model.units));
                Output::Stdout.write(|writer| mechanism(writer, model, &stand, held))
            }
        }
    }
}

/// A sign of `rack_per_turn` that does not fit the geometry is easily overlooked.
fn warn_of_ratio(model: &Model) {
    let rigid = Setup { kinematic: true, ..Setup::default() };
    let ratio = Corner::new(model, &rigid).ok().and_then(|mut corner| {
        let ratio = factors::find("steering_ratio").ok()?;
        ratio.value(Convention::Iso, &corner.pose())
    });
    if ratio.is_some_and(|ratio| ratio < 0.0) {
        eprintln!(
            "warning: turned to the left, the steering wheel steers to the right; change the sign of \
             `rack_per_turn` in [steering]"
        );
    }
}

/// Whether joints and drivers leave something free that forces may hold.
fn leaves_free(stand: &Stand) -> bool {
    stand.is_loaded() && !stand.freedom().free_motions.is_empty()
}

/// Whether forces hold what joints leave free.
fn held(found: Result<StaticReport, StaticFailure>, units: Units) -> String {
    match found {
        Ok(report) => {
            let stiffness = Quantity::Stiffness.show(units, report.stiffness);
            let unit = Quantity::Stiffness.symbol(units);
            format!(
                "forces hold what joints leave free; the smallest stiffness is {stiffness:.4e} {unit}"
            )
        }
        Err(failure) => format!("forces do not hold it: {failure}"),
    }
}

fn suspension(
    writer: &mut dyn Write,
    model: &Model,
    (stand, forces, adjustments): (&Stand, &[Force], &[Adjustment]),
    poses: &[Pose<f64>],
    held: Option<String>,
) -> io::Result<()> {
    let units = model.units;
    let length = units.length.symbol();
    header(writer, &model.name, model.description.as_deref())?;
    writeln!(writer, "architecture   {}", model.architecture.title())?;
    let side = match poses {
        [_] => model.side.name().to_owned(),
        _ => match model.has_other_side() {
            true => format!("both, {} from this file", model.side.name()),
            false => format!("both, {} the mirror image", model.side.other().name()),
        },
    };
    writeln!(writer, "side           {side}")?;
    writeln!(writer, "axes           {}", model.axes.name())?;
    writeln!(writer, "units          {length}, {}", units.angle.symbol())?;
    let radius = units.length.from_metres(model.wheel_radius);
    writeln!(writer, "wheel radius   {radius} {length}")?;
    writeln!(writer)?;
    parts(writer, stand, forces, model.axes, held)?;
    write_adjustments(&mut *writer, units, adjustments)?;
    writeln!(writer)?;
    let set = model.is_adjusted();
    writeln!(writer, "{}:", if set { "in the static state" } else { "at the design position" })?;
    if let [left, right] = poses {
        let [left, right] = [left, right].map(|pose| pose.side.name());
        writeln!(writer, "{:<24} {left:>12} {right:>12}", "")?;
    }
    for factor in basic() {
        let values: Option<Vec<f64>> = poses.iter().map(|pose| factor.show(units, pose)).collect();
        if let Some(values) = values {
            let unit = factor.quantity.symbol(units);
            // Rounding noise of a value that is zero at design would only distract.
            let exact = |value: &f64| if value.abs() < 5e-10 { 0.0 } else { *value };
            let values: Vec<String> =
                values.iter().map(|value| format!("{:>12.4}", exact(value))).collect();
            let values = values.join(" ");
            writeln!(writer, "{:<24} {values} {unit:<4} {}", factor.title, factor.sign)?;
        }
    }
    Ok(())
}

fn mechanism(
    writer: &mut dyn Write,
    model: &MechanismModel,
    stand: &Stand,
    held: Option<String>,
) -> io::Result<()> {
    header(writer, &model.name, model.description.as_deref())?;
    let units = model.units;
    writeln!(writer, "units          {}, {}", units.length.symbol(), units.angle.symbol())?;
    writeln!(writer)?;
    parts(writer, stand, stand.mechanism().forces(), Axes::Iso8855, held)
}

fn header(writer: &mut dyn Write, name: &str, description: Option<&str>) -> io::Result<()> {
    writeln!(writer, "{name}")?;
    if let Some(description) = description {
        writeln!(writer, "{description}")?;
    }
    writeln!(writer)
}

/// Joints and force elements, then what they leave free.
fn parts(
    writer: &mut dyn Write,
    stand: &Stand,
    forces: &[Force],
    axes: Axes,
    held: Option<String>,
) -> io::Result<()> {
    let mechanism = stand.mechanism();
    let names = mechanism.joints().iter().map(|joint| &joint.name);
    let names = names.chain(mechanism.drivers().iter().map(|driver| &driver.name));
    let width =
        names.chain(forces.iter().map(|force| &force.name)).map(|name| name.chars().count());
    let width = width.max().unwrap_or(0);
    let body = |id: BodyId| mechanism.bodies()[id.index()].name.as_str();
    for joint in mechanism.joints() {
        let (kind, i, j) = (joint.kind.name(), body(joint.i), body(joint.j));
        writeln!(writer, "{:<width$}  {kind:<13}  {i}–{j}", joint.name)?;
    }
    for force in forces {
        let (kind, i, j) = (force.kind.name(), body(force.i), body(force.j));
        writeln!(writer, "{:<width$}  {kind:<13}  {i}–{j}", force.name)?;
    }
    writeln!(writer)?;
    let freedom = stand.freedom().to_string();
    writeln!(writer, "{freedom}{}", axes_of_words(axes, &freedom))?;
    if stand.freedom().is_exact() {
        writeln!(writer, "no redundant equations, no free motions")?;
    }
    match held {
        Some(held) => writeln!(writer, "{held}{}", axes_of_words(axes, &held)),
        None => Ok(()),
    }
}
