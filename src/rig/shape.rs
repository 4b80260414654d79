//! What of a model's geometry can be varied, and where it puts the points of a mechanism.

use super::adjust::Home;
use super::line::Wheel;
use crate::mechanism::Mechanism;
use crate::model::{Alignment, Model, Side};
use crate::scalar::Scalar;
use crate::vector::{Vector, constant, scale, sub, unit};

/// The geometry of one side of a vehicle, in ISO 8855 axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape<S> {
    /// Design positions (m) of the hard points, in the order of the model.
    pub points: Vec<Vector<S>>,
    /// Static toe and camber (rad); without effect where a point gives the spin axis.
    pub alignment: Alignment<S>,
}

impl Shape<f64> {
    /// That of a model.
    pub fn of(model: &Model) -> Self {
        let points = model.points().iter().map(|point| point.position).collect();
        Self { points, alignment: model.alignment() }
    }

    /// The same on another scalar, at rest.
    pub fn lifted<S: Scalar>(&self) -> Shape<S> {
        let Alignment { toe, camber } = self.alignment;
        Shape {
            points: self.points.iter().map(|&point| constant(point)).collect(),
            alignment: Alignment { toe: S::from_f64(toe), camber: S::from_f64(camber) },
        }
    }
}

impl<S: Scalar> Shape<S> {
    /// The mirror image.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let image = |&[x, y, z]: &Vector<S>| [x, -y, z];
        Self { points: self.points.iter().map(image).collect(), alignment: self.alignment }
    }
}

/// Where the points of a mechanism come from.
#[derive(Clone, Debug)]
pub(super) struct Origins {
    list: Vec<Origin>,
    wheels: Vec<WheelOrigin>,
}

#[derive(Clone, Copy, Debug)]
enum Origin {
    /// A hard point of one side.
    Hard { side: usize, point: usize },
    /// The mirror image of one.
    Image { side: usize, point: usize },
    /// The point that stands for toe and camber.
    Axle { side: usize },
    /// The contact patch that the rig loads.
    Patch { side: usize },
    /// The point stays.
    Fixed([f64; 3]),
}

#[derive(Clone, Debug)]
struct WheelOrigin {
    side: Side,
    center: usize,
    radius: f64,
    /// The second point of the spin axis, where there is one, and 1 where it lies outboard, −1 inboard.
    spindle: Option<(usize, f64)>,
    home: Option<Home<f64>>,
}

impl Origins {
    /// Finds them by their names, which have the side before them in an axle.
    pub fn of(mechanism: &Mechanism, models: &[&Model], homes: &[Option<Home<f64>>]) -> Self {
        let prefix = |model: &Model| match models.len() {
            1 => [String::new(), String::new()],
            _ => ["_", " "].map(|gap| format!("{}{gap}", model.side.name())),
        };
        let origin = |name: &str, position: [f64; 3]| {
            for (side, model) in models.iter().enumerate() {
                let [prefix, spaced] = prefix(model);
                let hard = |name: &str| model.points().iter().position(|p| p.name == name);
                if name.strip_prefix(&spaced) == Some(super::load::PATCH) {
                    return Origin::Patch { side };
                }
                let Some(rest) = name.strip_prefix(&prefix) else { continue };
                if rest == crate::model::AXLE_POINT && model.axle_point().is_some() {
                    return Origin::Axle { side };
                }
                if let Some(point) = hard(rest) {
                    return Origin::Hard { side, point };
                }
                if let Some(point) = model.opposite_point(rest) {
                    return Origin::Image { side, point };
                }
            }
            Origin::Fixed(position)
        };
        let wheel = |(model, home): (&&Model, &Option<Home<f64>>)| WheelOrigin {
            side: model.side,
            center: model.architecture.wheel_center().index(),
            radius: model.wheel_radius,
            spindle: model.spindle(),
            home: *home,
        };
        Self {
            list: mechanism.points().iter().map(|p| origin(&p.name, p.position)).collect(),
            wheels: models.iter().zip(homes).map(wheel).collect(),
        }
    }

    /// The number of points of the mechanism.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// The design positions (m) of the points of the mechanism for shapes of the sides.
    pub fn positions<S: Scalar>(&self, shapes: &[Shape<S>]) -> Vec<Vector<S>> {
        let homes: Vec<Option<Home<S>>> =
            self.wheels.iter().map(|wheel| wheel.home.map(|home| home.lifted())).collect();
        self.positions_from(shapes, &homes)
    }

    /// The same where the static states of the sides vary, too.
    pub fn positions_from<S: Scalar>(
        &self,
        shapes: &[Shape<S>],
        homes: &[Option<Home<S>>],
    ) -> Vec<Vector<S>> {
        let spin = |side: usize| {
            let WheelOrigin { side: name, center, spindle, .. } = &self.wheels[side];
            let Shape { points, alignment } = &shapes[side];
            let Some((spindle, outboard)) = *spindle else { return alignment.spin_axis(*name) };
            scale(S::from_f64(outboard), unit(sub(points[spindle], points[*center])))
        };
        let place = |origin: &Origin| match *origin {
            Origin::Hard { side, point } => shapes[side].points[point],
            Origin::Image { side, point } => {
                let [x, y, z] = shapes[side].points[point];
                [x, -y, z]
            }
            Origin::Axle { side } => {
                let center = shapes[side].points[self.wheels[side].center];
                sub(center, scale(S::from_f64(crate::model::AXLE_LENGTH), spin(side)))
            }
            Origin::Patch { side } => {
                let WheelOrigin { center, radius, .. } = &self.wheels[side];
                let center = shapes[side].points[*center];
                match &homes[side] {
                    Some(home) => home.patch(center),
                    None => {
                        let radius = S::from_f64(*radius);
                        Wheel { center, spin: spin(side), radius }.contact_patch()
                    }
                }
            }
            Origin::Fixed(position) => constant(position),
        };
        self.list.iter().map(place).collect()
    }
}
