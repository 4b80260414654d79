//! What of a model a designer can change, and what that changes in the mechanism.

use thiserror::Error;

use super::laws::LawNumber;
use super::request::{self, Stiffness};
use crate::factors;
use crate::mechanism::{Force, ForceKind, Law, LawConstant};
use crate::model::suggest;
use crate::model::{Model, Quantity, SpinAxis, StaticState, StaticTarget, Units};
use crate::rig::Shape;

/// One number of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The name, such as `lca_front.z` or `forces.spring.stiffness`.
    pub name: String,
    /// Its kind.
    pub quantity: Quantity,
    /// What a positive change means.
    pub sign: &'static str,
    /// A small change (SI) by which parameters of different kinds are compared: 1 mm, 0.1°, 10 N, 1 N·m, a
    /// hundredth of a stiffness.
    pub step: f64,
    pub(super) kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    /// A coordinate of a hard point, by its place in the model, along an axis of the model.
    Coordinate { point: usize, axis: usize },
    /// Static toe.
    Toe,
    /// Static camber.
    Camber,
    /// A number of a law of a force element.
    Law(LawNumber),
    /// The length from which a force element measures, which grows with the parameter or, for −1, shrinks.
    Length { force: String, factor: f64 },
    /// The setting of an adjuster that sets no factor, by its place in the model.
    Adjuster { adjuster: usize },
    /// What a factor has to be in the static state, by its name.
    Target { factor: &'static str },
    /// The ride height of the static state.
    RideHeight,
}

/// No parameter has this name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("the model has no parameter `{name}`{}", suggestion.as_ref().map_or_else(
    || "; `hardpoint sensitivity MODEL --parameters` lists them".to_owned(),
    |other| format!("; did you mean `{other}`?"),
))]
pub struct UnknownParameter {
    /// What was asked for.
    pub name: String,
    /// A name that is near.
    pub suggestion: Option<String>,
}

pub(super) const AXES: [&str; 3] = ["x", "y", "z"];
const ALONG: [&str; 3] =
    ["+ along the model's +x", "+ along the model's +y", "+ along the model's +z"];

impl Parameter {
    /// All parameters of a model that act on the rig: `axle` adds what is between two sides, `kinematic` leaves
    /// out what rigid joints make without effect.
    pub fn all(model: &Model, axle: bool, kinematic: bool) -> Vec<Self> {
        let mut all = Self::coordinates(model);
        if let SpinAxis::Alignment(_) = model.spin {
            let angle = |name: &str, sign, kind| {
                Self::new(format!("wheel.{name}"), Quantity::Angle, sign, kind)
            };
            all.push(angle("toe", "+ toe-in", Kind::Toe));
            all.push(angle("camber", "+ top outboard", Kind::Camber));
        }
        for force in model.forces() {
            all.extend(Self::of_force("forces", force));
        }
        if axle {
            for force in model.axle_forces() {
                all.extend(Self::of_force("axle_forces", force));
            }
        }
        if !kinematic {
            for bushing in model.bushings() {
                all.extend(Self::of_force(bushing.section(), &bushing.force));
            }
        }
        let bar = model.anti_roll_bar().filter(|bar| axle && bar.stiffness > 0.0);
        if let Some(bar) = bar {
            let (name, quantity) = ("anti_roll_bar.stiffness", Quantity::RotationalStiffness);
            let kind = Kind::Law(LawNumber::plain("anti_roll_bar", LawConstant::Stiffness));
            let stiffness = Self::new(name.to_owned(), quantity, "+ stiffer", kind);
            all.push(stiffness.compared_by(0.01 * bar.stiffness));
        }
        // Without a static state the model is as its hard points say, whatever could be adjusted.
        if model.is_adjusted() {
            all.extend(Self::of_static_state(model));
        }
        all
    }

    /// What the static state asks for, and the settings of adjusters that have no target.
    fn of_static_state(model: &Model) -> Vec<Self> {
        let StaticState { targets, .. } = model.static_state();
        let new = |name: &str, quantity, sign, kind| {
            Self::new(format!("static.{name}"), quantity, sign, kind)
        };
        let higher = "+ chassis higher above the wheels";
        let mut all = vec![new("ride_height", Quantity::Length, higher, Kind::RideHeight)];
        for &StaticTarget { factor, quantity, .. } in targets {
            let sign = factors::find(factor).map_or("", |factor| factor.sign);
            all.push(new(factor, quantity, sign, Kind::Target { factor }));
        }
        for (index, adjuster) in model.adjusters().iter().enumerate() {
            if targets.iter().all(|target| target.by != index) {
                let name = format!("adjusters.{}", adjuster.name);
                let kind = Kind::Adjuster { adjuster: index };
                all.push(Self::new(name, Quantity::Length, "+ as the adjuster says", kind));
            }
        }
        all
    }

    pub(super) fn new(name: String, quantity: Quantity, sign: &'static str, kind: Kind) -> Self {
        let step = match quantity {
            Quantity::Length => 1e-3,
            Quantity::Angle => 0.1_f64.to_radians(),
            Quantity::Force => 10.0,
            Quantity::Torque => 1.0,
            _ => 0.01,
        };
        Self { name, quantity, sign, step, kind }
    }

    /// The same, compared by another change (SI).
    pub(super) fn compared_by(self, step: f64) -> Self {
        Self { step, ..self }
    }

    /// The coordinates of all hard points.
    pub fn coordinates(model: &Model) -> Vec<Self> {
        let coordinates = |point: usize| (0..3).map(move |axis| (point, axis));
        let parameter = |(point, axis): (usize, usize)| {
            let name = format!("{}.{}", model.points()[point].name, AXES[axis]);
            let kind = Kind::Coordinate { point, axis };
            Self::new(name, Quantity::Length, ALONG[axis], kind)
        };
        (0..model.points().len()).flat_map(coordinates).map(parameter).collect()
    }

    /// What a request calls a parameter.
    pub(super) fn wanted(parameter: request::Parameter, name: &str, model: &Model) -> Self {
        let law = |force: &Force, part: usize| {
            Kind::Law(LawNumber { part, ..LawNumber::plain(&force.name, LawConstant::Stiffness) })
        };
        // A bushing has no laws of a kind that are all zero.
        let component = |force: &Force, component: usize| match &force.kind {
            ForceKind::Bushing(bushing) if bushing.translation.iter().all(Law::is_zero) => {
                law(force, component - bushing.translation.len())
            }
            _ => law(force, component),
        };
        let kind = match parameter {
            request::Parameter::Coordinate { point, axis } => Kind::Coordinate { point, axis },
            request::Parameter::Toe => Kind::Toe,
            request::Parameter::Camber => Kind::Camber,
            request::Parameter::FreeLength { force } => {
                Kind::Length { force: model.forces()[force].name.clone(), factor: 1.0 }
            }
            request::Parameter::Stiffness(stiffness) => match stiffness {
                Stiffness::Force { force } => law(&model.forces()[force], 0),
                Stiffness::BushingForce { force, component: part } => {
                    component(&model.forces()[force], part)
                }
                Stiffness::Bushing { bushing, component: part } => {
                    component(&model.bushings()[bushing].force, part)
                }
                Stiffness::AntiRollBar => {
                    Kind::Law(LawNumber::plain("anti_roll_bar", LawConstant::Stiffness))
                }
            },
        };
        Self::new(name.to_owned(), parameter.quantity(model), "", kind)
    }

    /// The parameters that a word stands for: one by its full name, or all whose names begin with it and a dot.
    ///
    /// # Errors
    /// [`UnknownParameter`].
    pub fn named(all: &[Self], word: &str) -> Result<Vec<Self>, UnknownParameter> {
        let belongs = |parameter: &&Self| {
            let rest = parameter.name.strip_prefix(word);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let found: Vec<Self> = all.iter().filter(belongs).cloned().collect();
        if !found.is_empty() {
            return Ok(found);
        }
        let names = all.iter().map(|parameter| parameter.name.as_str());
        let suggestion = suggest::closest(word, names).map(str::to_owned);
        Err(UnknownParameter { name: word.to_owned(), suggestion })
    }

    /// The value of a coordinate (m, along an axis of the model), `None` for other kinds.
    pub fn coordinate(&self, model: &Model) -> Option<f64> {
        let Kind::Coordinate { point, axis } = self.kind else { return None };
        Some(model.axes.from_iso(model.points()[point].position)[axis])
    }

    /// −1 where the axis of a coordinate points against that of ISO 8855, else 1.
    pub(super) fn sign_of_iso(&self, model: &Model) -> f64 {
        match self.kind {
            Kind::Coordinate { axis, .. } => model.axes.signs()[axis],
            _ => 1.0,
        }
    }

    /// Puts a value (SI, a coordinate along the axis of the model) into a shape.
    pub(super) fn place(&self, model: &Model, shape: &mut Shape<f64>, value: f64) {
        match self.kind {
            Kind::Coordinate { point, axis } => {
                let mut position = model.axes.from_iso(shape.points[point]);
                position[axis] = value;
                shape.points[point] = model.axes.to_iso(position);
            }
            Kind::Toe => shape.alignment.toe = value,
            Kind::Camber => shape.alignment.camber = value,
            _ => {}
        }
    }

    /// Moves a coordinate of a shape by a way (m) along the axis of the model.
    pub(super) fn shift(&self, model: &Model, shape: &mut Shape<f64>, way: f64) {
        if let Kind::Coordinate { point, axis } = self.kind {
            shape.points[point][axis] += model.axes.signs()[axis] * way;
        }
    }

    /// What a derivative of a factor by this parameter is multiplied with to be shown, and its unit.
    pub fn show(&self, units: Units, factor: Quantity, derivative: f64) -> f64 {
        factor.show(units, derivative) / self.quantity.show(units, 1.0)
    }

    /// The unit in which [`Self::show`] gives derivatives.
    pub fn unit(&self, units: Units, factor: Quantity) -> String {
        format!("{} per {}", factor.symbol(units), self.quantity.symbol(units))
    }
}
