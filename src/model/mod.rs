//! Model files: the text side of suspensions and mechanisms.
//!
#![doc = include_str!("../../docs/models.md")]

mod adjusters;
mod alignment;
mod architecture;
mod axes;
mod axle;
mod case_input;
mod cases;
mod chassis;
mod checks;
mod diagnostics;
mod file;
mod fittings;
mod load;
mod loads;
mod loads_file;
mod mechanism_file;
mod mirror;
mod names;
mod parts;
mod quantity;
pub(crate) mod read;
mod resolve;
mod setup;
pub(crate) mod suggest;
mod suspension;
mod units;
mod units_file;
mod vehicle;

pub use adjusters::{Adjuster, STATIC_FACTORS, StaticState, StaticTarget};
pub use alignment::Alignment;
pub use architecture::{Architecture, BodyRole, PointRole, SteerAxis};
pub use axes::{Axes, Side};
pub use axle::{AxleSide, AxleSuspension};
pub use case_input::{CaseInput, LOAD_COMPONENTS};
pub use cases::{CaseColumn, LoadCase, LoadCases};
pub use chassis::Rolling;
pub use diagnostics::{Mistake, ModelDiagnostics};
pub(crate) use diagnostics::{Report, SourceFile};
pub use fittings::Steering;
pub use load::Document;
pub(crate) use load::{read_file, read_text};
pub use loads::{AntiRollBar, JointBushing, Tyre, TyreContact};
pub use mechanism_file::MechanismModel;
pub use parts::Marker;
pub use quantity::Quantity;
pub use setup::{Chassis, Drive, Setup, SuspensionError, WheelSupport};
pub(crate) use suspension::{AXLE_LENGTH, AXLE_POINT};
pub use suspension::{StrutLine, Suspension, Wheel};
pub use units::{AngleUnit, ForceUnit, LengthUnit, MassUnit, Units};
pub use vehicle::{Axle, Brakes, Vehicle};

use crate::mechanism::{Force, MassProperties};
use crate::vector::{add, scale, sub, unit};
use loads::Loads;

/// Two points nearer than this (m) are one point, and three points whose distance from a
/// line is less are on it: a tenth of a millimetre is below any manufacturing tolerance.
const NEAR: f64 = 1e-4;

/// One corner of a vehicle, in SI units and ISO 8855 axes (x forward, y left, z up).
#[derive(Clone, Debug)]
pub struct Model {
    /// The name for reports.
    pub name: String,
    /// What the model is.
    pub description: Option<String>,
    /// Where its numbers come from.
    pub source: Option<String>,
    /// Bodies, joints and the meaning of the points.
    pub architecture: Architecture,
    /// The axes of the file, for output.
    pub axes: Axes,
    /// The units of the file, for output.
    pub units: Units,
    /// The side that the points describe.
    pub side: Side,
    /// Rolling radius of the tyre (m).
    pub wheel_radius: f64,
    /// How the static spin axis is given.
    pub spin: SpinAxis,
    /// The vehicle.
    pub vehicle: Vehicle,
    /// The steering gear, where the model tells of it. Both sides of a vehicle have the same.
    pub steering: Option<Steering>,
    /// The other side of the vehicle, where a file of its own describes it.
    other: Option<Box<Self>>,
    /// Points required by the architecture, in its order, then optional ones, then the model's own.
    points: Vec<NamedPoint>,
    loads: Loads,
    adjusters: Vec<Adjuster>,
    static_state: StaticState,
}

/// A hard point.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedPoint {
    /// The name, as in the architecture.
    pub name: String,
    /// Design position (m, ISO 8855 axes).
    pub position: [f64; 3],
}

/// How the static spin axis of the wheel is given.
#[derive(Clone, Debug, PartialEq)]
pub enum SpinAxis {
    /// By toe and camber.
    Alignment(Alignment),
    /// By the name of a second point on the axis, inboard or outboard of the wheel centre.
    Point(String),
}

impl Model {
    /// The hard points: those that the architecture requires, in its order, then optional ones,
    /// then those that only forces of the model name.
    pub fn points(&self) -> &[NamedPoint] {
        &self.points
    }

    /// The design position (m, ISO 8855 axes) of a point, `None` where the model has no such point.
    pub fn point(&self, name: &str) -> Option<[f64; 3]> {
        let point = self.points.iter().find(|point| point.name == name)?;
        Some(point.position)
    }

    /// Moves a point to a position (m, ISO 8855 axes); `false` where the model has no such point.
    /// [`Model::suspension`] tells whether the new geometry has a meaning.
    pub fn set_point(&mut self, name: &str, position: [f64; 3]) -> bool {
        let point = self.points.iter_mut().find(|point| point.name == name);
        let found = point.is_some();
        if let Some(point) = point {
            point.position = position;
        }
        found
    }

    /// Acceleration of gravity (m/s²), downward.
    pub fn gravity(&self) -> f64 {
        self.loads.gravity
    }

    /// The force elements of `[[forces]]`, with the numbers of bodies of a fixed chassis.
    pub fn forces(&self) -> &[Force] {
        &self.loads.forces
    }

    /// The force elements of `[[axle_forces]]`, between the two sides of an axle.
    pub fn axle_forces(&self) -> &[Force] {
        &self.loads.axle_forces
    }

    /// The bushings of `[bushings]`, which stand for joints, and the elastic elements of fittings, which do so,
    /// too.
    pub fn bushings(&self) -> &[JointBushing] {
        &self.loads.bushings
    }

    /// The names of the joints that bushings stand for, each once.
    pub fn bushed_joints(&self) -> Vec<&str> {
        let joints = self.architecture.joints.iter().enumerate();
        let bushed = |index| self.loads.bushings.iter().any(|bushing| bushing.joint == index);
        joints.filter(|(index, _)| bushed(*index)).map(|(_, joint)| joint.name.as_str()).collect()
    }

    /// Mass properties by the name of the body, `None` where the model gives none.
    pub fn mass(&self, body: &str) -> Option<MassProperties> {
        let index = self.architecture.bodies.iter().position(|role| role.name == body)?;
        self.loads.masses.get(index).copied().flatten()
    }

    /// The tyre.
    pub fn tyre(&self) -> Option<&Tyre> {
        self.loads.tyre.as_ref()
    }

    /// The anti-roll bar, which acts where both sides make an axle.
    pub fn anti_roll_bar(&self) -> Option<&AntiRollBar> {
        self.loads.anti_roll_bar.as_ref()
    }

    /// Mass (kg) of the chassis on its slide.
    pub fn sprung_mass(&self) -> Option<f64> {
        self.loads.sprung_mass
    }

    /// Whether anything but the tyre acts on the bodies: force elements, bushings or weights.
    pub fn has_forces(&self) -> bool {
        let weights = self.loads.gravity != 0.0 && self.loads.masses.iter().any(Option::is_some);
        weights || !self.loads.forces.is_empty() || !self.loads.bushings.is_empty()
    }

    /// Whether a file of its own describes the other side of the vehicle.
    pub fn has_other_side(&self) -> bool {
        self.other.is_some()
    }

    /// The other side of the vehicle: that of `other_side`, or the mirror image.
    #[must_use]
    pub fn other_side(&self) -> Self {
        let Some(other) = &self.other else { return self.mirrored() };
        let this = Self { other: None, ..self.clone() };
        Self { other: Some(Box::new(this)), ..(**other).clone() }
    }

    /// Whether both sides are one mechanism, such as a beam axle: [`Model::suspension`] has no corner of it.
    pub fn is_axle(&self) -> bool {
        self.architecture.is_axle
    }

    /// Whether the suspension has a rack.
    pub fn steers(&self) -> bool {
        self.architecture.rack.is_some()
    }

    /// Whether the wheel can stand on a tyre.
    pub fn has_tyre(&self) -> bool {
        self.loads.tyre.is_some()
    }

    /// Whether the chassis can move on a vertical slide.
    pub fn is_quarter_car(&self) -> bool {
        self.loads.sprung_mass.is_some()
    }

    /// The unit spin axis at the design position, pointing outboard, in ISO 8855 axes.
    pub fn spin_axis(&self) -> [f64; 3] {
        match &self.spin {
            SpinAxis::Alignment(alignment) => alignment.spin_axis(self.side),
            SpinAxis::Point(name) => {
                let center = self.points[self.architecture.wheel.center.0].position;
                let other = self.point(name).unwrap_or(center);
                let axis = unit(sub(other, center));
                let outboard = if axis[1] * self.side.sign() < 0.0 { -1.0 } else { 1.0 };
                scale(outboard, axis)
            }
        }
    }

    /// Static toe and camber, also where a point gives the spin axis.
    pub fn alignment(&self) -> Alignment {
        match &self.spin {
            SpinAxis::Alignment(alignment) => *alignment,
            SpinAxis::Point(_) => Alignment::of_spin_axis(self.spin_axis()),
        }
    }
}

/// The mean of some points.
fn mean(points: impl ExactSizeIterator<Item = [f64; 3]>) -> Option<[f64; 3]> {
    #[allow(clippy::cast_precision_loss)] // A body has a handful of points.
    let number = points.len() as f64;
    let sum = points.reduce(add)?;
    Some(sum.map(|sum| sum / number))
}

/// The value, if reading it left no mistakes.
pub(crate) fn finish<T>(value: Option<T>, report: Report) -> Result<T, ModelDiagnostics> {
    let name = report.file().name.clone();
    report.finish()?;
    value.ok_or_else(|| {
        let message = "the file cannot be understood";
        let mistake = Mistake::without_place(message, "please report this file to hardpoint");
        ModelDiagnostics::new(&name, vec![mistake])
    })
}
