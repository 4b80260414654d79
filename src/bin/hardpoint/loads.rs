//! Options that say how a corner or an axle stands on the rig.

use clap::{Args, ValueEnum};
use hardpoint::model::{Chassis, Drive, Model, Quantity, Setup, Side, Units, WheelSupport};
use hardpoint::rig::{LOAD_COMPONENTS, Load, LoadPoint};

use crate::failure::Failure;
use crate::output::DriveName;
use crate::settings::Settings;

/// How a corner or an axle stands on the rig and what loads its wheels.
#[derive(Args)]
pub struct RigOptions {
    /// Which height a travel means [default: wheel-center].
    #[arg(long, value_enum)]
    drive: Option<DriveName>,
    /// Swap bushings back for the rigid joints that they replace.
    #[arg(long)]
    kinematic: bool,
    /// Load on the wheel, such as fx=1000 or mz=-50: fx, fy, fz, mx, my, mz along and about the axes of
    /// the model, in its units; may be given several times. Both wheels of an axle carry it, but for
    /// left.fx=1000 and the like.
    #[arg(long = "load", value_name = "COMPONENT=VALUE", allow_hyphen_values = true)]
    loads: Vec<String>,
    /// Where loads act on the wheel's body, and where a compliance is taken [default: contact-patch, of
    /// a compliance wheel-center].
    #[arg(long, value_enum)]
    at: Option<LoadPointName>,
    #[command(flatten)]
    settings: Settings,
}

/// Where a load acts.
#[derive(Clone, Copy, ValueEnum)]
enum LoadPointName {
    /// The point of the wheel's body that is the contact patch at design, or in the static state.
    ContactPatch,
    /// The wheel centre.
    WheelCenter,
}

impl RigOptions {
    /// The drive.
    pub fn drive(&self) -> Drive {
        self.drive.map_or(Drive::WheelCenter, Drive::from)
    }

    /// Whether all joints are rigid.
    pub fn is_kinematic(&self) -> bool {
        self.kinematic
    }

    /// Refuses the options for a mechanism, which has no wheel.
    pub fn refuse(&self) -> Result<(), Failure> {
        let given = [
            (self.drive.is_some(), "--drive"),
            (self.kinematic, "--kinematic"),
            (!self.loads.is_empty(), "--load"),
            (self.at.is_some(), "--at"),
            (self.settings.given(), "--set"),
        ];
        match given.into_iter().find(|(given, _)| *given) {
            Some((_, option)) => Err(Failure::Usage(format!(
                "{option} belongs to suspensions; this file is a mechanism, whose loads are [[forces]]"
            ))),
            None => Ok(()),
        }
    }

    /// The model with what `--set` says.
    pub fn set(&self, model: Model) -> Result<Model, Failure> {
        self.settings.apply(model)
    }

    /// Where loads act.
    pub fn point(&self) -> LoadPoint {
        self.point_or(LoadPoint::ContactPatch)
    }

    /// Where loads act, if the user does not say so.
    pub fn point_or(&self, default: LoadPoint) -> LoadPoint {
        match self.at {
            Some(LoadPointName::ContactPatch) => LoadPoint::ContactPatch,
            Some(LoadPointName::WheelCenter) => LoadPoint::WheelCenter,
            None => default,
        }
    }

    /// The setup for a wheel that is held or stands on its tyre.
    pub fn setup(&self, support: WheelSupport, chassis: Chassis) -> Setup {
        Setup { drive: self.drive(), support, chassis, kinematic: self.kinematic }
    }

    /// The load on the wheel of a corner (SI).
    pub fn load(&self, model: &Model) -> Result<Load, Failure> {
        if let Some(text) = self.loads.iter().find(|text| side(text).is_some()) {
            return Err(Failure::Usage(format!(
                "--load {text} names a wheel of an axle; add --axle, or leave out the side"
            )));
        }
        Ok(self.loads(model, model.has_forces())?[0])
    }

    /// The loads on the wheels of an axle (SI).
    pub fn axle_loads(&self, model: &Model) -> Result<[Load; 2], Failure> {
        self.loads(model, model.axle_has_forces())
    }

    fn loads(&self, model: &Model, has_forces: bool) -> Result<[Load; 2], Failure> {
        let mut loads = [Load::default(); 2];
        for text in &self.loads {
            let wrong = || {
                Failure::Usage(format!(
                    "--load {text} is not understood; write a component ({}) and a number, such as fx=1000",
                    LOAD_COMPONENTS.join(", ")
                ))
            };
            let (wheels, text) = match side(text) {
                Some((side, text)) => (&mut loads[side.index()..=side.index()], text),
                None => (&mut loads[..], text.as_str()),
            };
            let (name, value) = text.split_once('=').ok_or_else(wrong)?;
            let component = component(name).ok_or_else(wrong)?;
            let value: f64 = value.trim().parse().map_err(|_| wrong())?;
            if !value.is_finite() {
                return Err(wrong());
            }
            for load in wheels {
                load.components[component] += quantity(component).to_si(model.units, value);
            }
        }
        if !self.loads.is_empty() && !has_forces {
            return Err(Failure::Usage(
                "a load moves nothing in a model without forces; add springs or a tyre to the model, \
                 or leave out --load"
                    .into(),
            ));
        }
        Ok(loads)
    }
}

/// The wheel that a load names, and the rest of the text.
fn side(text: &str) -> Option<(Side, &str)> {
    let (name, rest) = text.split_once('.')?;
    let sides = [Side::Left, Side::Right];
    let side = sides.into_iter().find(|side| side.name() == name.trim())?;
    Some((side, rest))
}

/// No suspension travels farther (m).
pub const FARTHEST: f64 = 1e3;

/// A length of an option in metres, zero where it is not given.
pub fn length(option: &str, value: Option<f64>, units: Units) -> Result<f64, Failure> {
    let metres = value.map_or(0.0, |value| units.length.to_metres(value));
    if !metres.is_finite() {
        return Err(Failure::Usage(format!("{option} is not a finite number")));
    }
    if metres.abs() > FARTHEST {
        return Err(Failure::Usage(format!(
            "{option} is more than a kilometre; lengths are in the unit of the model"
        )));
    }
    Ok(metres)
}

/// The component of a name.
pub fn component(name: &str) -> Option<usize> {
    let name = name.trim().to_ascii_lowercase();
    LOAD_COMPONENTS.iter().position(|component| *component == name)
}

/// What a component is measured in.
pub fn quantity(component: usize) -> Quantity {
    if component < 3 { Quantity::Force } else { Quantity::Torque }
}
