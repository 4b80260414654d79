//! `[vehicle]`: what some factors need to know of the vehicle that a corner belongs to.

use std::ops::RangeInclusive;

use toml::Spanned;

use super::diagnostics::Report;
use super::parts::Parts;
use super::quantity::Quantity;
use super::read::Section;

/// An axle of a vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axle {
    /// The front axle.
    Front,
    /// The rear axle.
    Rear,
}

impl Axle {
    /// The name, as in model files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Front => "front",
            Self::Rear => "rear",
        }
    }
}

/// Which body takes up the brake torque.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Brakes {
    /// The body that carries the wheel.
    #[default]
    Outboard,
    /// The chassis, through a shaft.
    Inboard,
}

/// The vehicle of a corner, as far as the model tells.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vehicle {
    /// The axle that the corner belongs to.
    pub axle: Option<Axle>,
    /// Distance of the axles (m).
    pub wheelbase: Option<f64>,
    /// Height of the centre of gravity above the ground at the design position (m).
    pub cg_height: Option<f64>,
    /// The part of the brake force that this axle has, 0 to 1.
    pub brake_share: Option<f64>,
    /// The part of the drive force that this axle has, 0 to 1.
    pub drive_share: Option<f64>,
    /// Where the brakes are.
    pub brakes: Brakes,
    /// Mass of the whole vehicle (kg).
    pub mass: Option<f64>,
    /// Sprung mass that one wheel of this axle carries (kg).
    pub sprung_mass: Option<f64>,
    /// Unsprung mass of one wheel of this axle (kg).
    pub unsprung_mass: Option<f64>,
    /// Displacement of the rack (m) per radian of the steering wheel to the left, from `[steering]`.
    pub rack_per_radian: Option<f64>,
}

/// Wheelbases (m) from small models to mining trucks.
const WHEELBASE: RangeInclusive<f64> = 0.05..=30.0;

/// Heights (m) of centres of gravity, from small models to mining trucks.
const CG_HEIGHT: RangeInclusive<f64> = 0.005..=10.0;

pub(super) fn read(root: &mut Section, parts: &Parts, report: &mut Report) -> Option<Vehicle> {
    let help = "write a section `[vehicle]` with lines such as `axle = \"front\"`";
    let Some(mut section) = root.optional_section("vehicle", help, report) else {
        return Some(Vehicle::default());
    };
    let axles = [("front", Some(Axle::Front)), ("rear", Some(Axle::Rear))];
    let axle = section.choice_or("axle", "axle", &axles, None, report);
    let places = [("outboard", Brakes::Outboard), ("inboard", Brakes::Inboard)];
    let brakes = section.choice_or("brakes", "kind of brakes", &places, Brakes::default(), report);
    let wheelbase = length(&mut section, "wheelbase", WHEELBASE, parts, report);
    let cg_height = length(&mut section, "cg_height", CG_HEIGHT, parts, report);
    let brake_share = share(&mut section, "brake_share", report);
    let drive_share = share(&mut section, "drive_share", report);
    let keys = ["mass", "sprung_mass", "unsprung_mass"];
    let [total, sprung_mass, unsprung_mass] =
        keys.map(|key| mass(&mut section, key, parts, report));
    section.finish(report);
    Some(Vehicle {
        axle: axle?,
        wheelbase,
        cg_height,
        brake_share,
        drive_share,
        brakes: brakes?,
        mass: total,
        sprung_mass,
        unsprung_mass,
        rack_per_radian: None,
    })
}

/// A mass (kg) that may be absent.
fn mass(
    section: &mut Section,
    key: &'static str,
    parts: &Parts,
    report: &mut Report,
) -> Option<f64> {
    let mass = parts.optional_number(section, key, Quantity::Mass, report)?;
    let (span, value) = (mass.span(), mass.into_inner());
    if value > 0.0 {
        return Some(value);
    }
    let help = format!("write the mass as a positive number: `{key} = …`");
    report.mistake(&span, format!("`{key}` must be positive"), "not positive").help(help);
    None
}

/// A length (m) that may be absent.
fn length(
    section: &mut Section,
    key: &'static str,
    plausible: RangeInclusive<f64>,
    parts: &Parts,
    report: &mut Report,
) -> Option<f64> {
    let metres = parts.optional_number(section, key, Quantity::Length, report)?;
    let (span, value) = (metres.span(), metres.into_inner());
    if value <= 0.0 {
        let help = format!("write the distance as a positive number: `{key} = …`");
        report.mistake(&span, format!("`{key}` must be positive"), "not positive").help(help);
        return None;
    }
    // Where the unit is missing, which is noted, nothing can be said of the size.
    if let Some(unit) = &parts.units.length
        && !plausible.contains(&value)
    {
        let message = format!("a {} of {value} m is not plausible", key.replace('_', " "));
        report
            .mistake(&span, message, "too small or too large")
            .also(&unit.span(), "in this unit")
            .help("write it in the unit of [units]");
        return None;
    }
    Some(value)
}

/// A part of a whole that may be absent.
fn share(section: &mut Section, key: &'static str, report: &mut Report) -> Option<f64> {
    let share: Spanned<f64> = section.optional(key, report)?;
    let (span, value) = (share.span(), share.into_inner());
    if (0.0..=1.0).contains(&value) {
        return Some(value);
    }
    let help = if (1.0..=100.0).contains(&value) {
        format!("it is a part of 1: for {value} % write `{key} = {}`", value / 100.0)
    } else {
        format!("write the part of the whole force that this axle has, such as `{key} = 0.6`")
    };
    report.mistake(&span, format!("`{key}` must lie between 0 and 1"), "not a part").help(help);
    None
}
