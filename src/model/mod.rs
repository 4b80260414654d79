//! Model files: the text side of suspensions.
//!
#![doc = include_str!("../../docs/models.md")]

mod alignment;
mod architecture;
mod axes;
mod checks;
mod diagnostics;
mod file;
mod load;
mod read;
mod resolve;
mod suggest;
mod suspension;
mod units;

pub use alignment::Alignment;
pub use architecture::{Architecture, BodyRole, PointRole, SteerAxis};
pub use axes::{Axes, Side};
pub use diagnostics::{Mistake, ModelDiagnostics};
pub use suspension::{Drive, Suspension, Wheel};
pub use units::{AngleUnit, LengthUnit, Units};

use crate::vector::{scale, sub, unit};
use diagnostics::Report;

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
    /// Points required by the architecture, in its order, then optional ones.
    points: Vec<NamedPoint>,
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
    /// The hard points: those that the architecture requires, in its order, then optional ones.
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

    /// The same suspension on the other side of the vehicle: y changes its sign,
    /// toe and camber keep their values.
    pub fn mirrored(&self) -> Self {
        let mut other = self.clone();
        other.side = self.side.other();
        for point in &mut other.points {
            // Not a plain negation, which would turn 0 into −0.
            point.position[1] = 0.0 - point.position[1];
        }
        other
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

/// The value, if reading it left no mistakes.
fn finish<T>(value: Option<T>, report: Report) -> Result<T, ModelDiagnostics> {
    let name = report.file().name.clone();
    report.finish()?;
    value.ok_or_else(|| {
        let message = "the file cannot be understood";
        let mistake = Mistake::without_place(message, "please report this file to hardpoint");
        ModelDiagnostics::new(&name, vec![mistake])
    })
}
