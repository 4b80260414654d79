//! What of a model a designer can change, and what that changes in the mechanism.

use thiserror::Error;

use super::request::{self, Stiffness};
use crate::assembly::ElementConstant;
use crate::mechanism::{
    Acts, Curve, Force, ForceKind, Law, LawConstant, Mechanism, Owner, Reference,
};
use crate::model::suggest;
use crate::model::{Model, Quantity, SpinAxis, Units};
use crate::rig::{Shape, Variable, Varied};
use crate::scalar::Dual;
use crate::solve::sensitivity::Change;

/// One number of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The name, such as `lca_front.z` or `forces.spring.stiffness`.
    pub name: String,
    /// Its kind.
    pub quantity: Quantity,
    /// What a positive change means.
    pub sign: &'static str,
    kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    /// A coordinate of a hard point, by its place in the model, along an axis of the model.
    Coordinate { point: usize, axis: usize },
    /// Static toe.
    Toe,
    /// Static camber.
    Camber,
    /// A constant of a law of a force element; `part` is the number of the law among those of the element.
    Law { force: String, part: usize, constant: LawConstant },
    /// The length from which a force element measures.
    Length { force: String },
    /// The setting of an adjuster, by its place in the model.
    Adjuster { adjuster: usize },
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

const AXES: [&str; 3] = ["x", "y", "z"];
const ALONG: [&str; 3] =
    ["+ along the model's +x", "+ along the model's +y", "+ along the model's +z"];

impl Parameter {
    /// All parameters of a model that act on the rig: `axle` adds what is between two sides, `kinematic` leaves
    /// out what rigid joints make without effect.
    pub fn all(model: &Model, axle: bool, kinematic: bool) -> Vec<Self> {
        let mut all = Self::coordinates(model);
        if let SpinAxis::Alignment(_) = model.spin {
            let angle = |name: &str, sign, kind| Self {
                name: format!("wheel.{name}"),
                quantity: Quantity::Angle,
                sign,
                kind,
            };
            all.push(angle("toe", "+ toe-in", Kind::Toe));
            all.push(angle("camber", "+ top outboard", Kind::Camber));
        }
        for force in model.forces() {
            all.extend(Self::of_force(force));
        }
        if !kinematic {
            for bushing in model.bushings() {
                all.extend(Self::of_bushing("bushings", &bushing.force));
            }
        }
        if axle && model.anti_roll_bar().is_some_and(|bar| bar.stiffness > 0.0) {
            all.push(Self {
                name: "anti_roll_bar.stiffness".to_owned(),
                quantity: Quantity::RotationalStiffness,
                sign: "+ stiffer",
                kind: Kind::Law {
                    force: "anti_roll_bar".to_owned(),
                    part: 0,
                    constant: LawConstant::Stiffness,
                },
            });
        }
        for (index, adjuster) in model.adjusters().iter().enumerate() {
            all.push(Self {
                name: format!("adjusters.{}", adjuster.name),
                quantity: Quantity::Length,
                sign: "+ as the adjuster says",
                kind: Kind::Adjuster { adjuster: index },
            });
        }
        all
    }

    /// The coordinates of all hard points.
    pub fn coordinates(model: &Model) -> Vec<Self> {
        let coordinates = |point: usize| (0..3).map(move |axis| (point, axis));
        let parameter = |(point, axis): (usize, usize)| Self {
            name: format!("{}.{}", model.points()[point].name, AXES[axis]),
            quantity: Quantity::Length,
            sign: ALONG[axis],
            kind: Kind::Coordinate { point, axis },
        };
        (0..model.points().len()).flat_map(coordinates).map(parameter).collect()
    }

    /// What a request calls a parameter.
    pub(super) fn wanted(parameter: request::Parameter, name: &str, model: &Model) -> Self {
        let law = |force: &Force, part: usize| Kind::Law {
            force: force.name.clone(),
            part,
            constant: LawConstant::Stiffness,
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
                Kind::Length { force: model.forces()[force].name.clone() }
            }
            request::Parameter::Stiffness(stiffness) => match stiffness {
                Stiffness::Force { force } => law(&model.forces()[force], 0),
                Stiffness::BushingForce { force, component: part } => {
                    component(&model.forces()[force], part)
                }
                Stiffness::Bushing { bushing, component: part } => {
                    component(&model.bushings()[bushing].force, part)
                }
                Stiffness::AntiRollBar => Kind::Law {
                    force: "anti_roll_bar".to_owned(),
                    part: 0,
                    constant: LawConstant::Stiffness,
                },
            },
        };
        let quantity = parameter.quantity(model);
        Self { name: name.to_owned(), quantity, sign: "", kind }
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

    fn of_force(force: &Force) -> Vec<Self> {
        let prefix = format!("forces.{}", force.name);
        match &force.kind {
            ForceKind::Line { reference, law, .. } => {
                let mut list = Self::of_law(&prefix, force, 0, law, false);
                let measured = law.elastic != Curve::Zero;
                if measured {
                    let (name, sign) = match reference {
                        Reference::Length(_) => ("free_length", "+ longer"),
                        Reference::Design(_) => ("offset", "+ longer where it measures from"),
                    };
                    list.push(Self {
                        name: format!("{prefix}.{name}"),
                        quantity: Quantity::Length,
                        sign,
                        kind: Kind::Length { force: force.name.clone() },
                    });
                }
                list
            }
            ForceKind::Slide { law, .. } => Self::of_law(&prefix, force, 0, law, false),
            ForceKind::Torsion { law, .. } => Self::of_law(&prefix, force, 0, law, true),
            ForceKind::Bushing(_) => Self::of_bushing("forces", force),
            _ => vec![],
        }
    }

    /// The six laws of a bushing; those of a kind that is all zero are not there.
    fn of_bushing(section: &str, force: &Force) -> Vec<Self> {
        let ForceKind::Bushing(bushing) = &force.kind else { return vec![] };
        let mut list = vec![];
        let mut first = 0;
        for (laws, name, turns) in [
            (&bushing.translation, "stiffness", false),
            (&bushing.rotation, "rotational_stiffness", true),
        ] {
            if laws.iter().all(Law::is_zero) {
                continue;
            }
            for (axis, law) in laws.iter().enumerate() {
                let prefix = format!("{section}.{}", force.name);
                for mut parameter in Self::of_law(&prefix, force, first + axis, law, turns) {
                    let rest = parameter.name[prefix.len() + 1..].to_owned();
                    let rest = if rest == "stiffness" { name } else { &rest };
                    parameter.name = format!("{prefix}.{rest}.{}", AXES[axis]);
                    list.push(parameter);
                }
            }
            first += laws.len();
        }
        list
    }

    fn of_law(prefix: &str, force: &Force, part: usize, law: &Law, turns: bool) -> Vec<Self> {
        let (size, stiffness) = match turns {
            false => (Quantity::Force, Quantity::Stiffness),
            true => (Quantity::Torque, Quantity::RotationalStiffness),
        };
        let make = |name: String, quantity, sign, constant| Self {
            name: format!("{prefix}.{name}"),
            quantity,
            sign,
            kind: Kind::Law { force: force.name.clone(), part, constant },
        };
        let mut list = vec![];
        match &law.elastic {
            Curve::Zero => {}
            Curve::Linear(_) => {
                list.push(make(
                    "stiffness".to_owned(),
                    stiffness,
                    "+ stiffer",
                    LawConstant::Stiffness,
                ));
            }
            Curve::Table(spline) => {
                list.push(make(
                    "scale".to_owned(),
                    Quantity::Ratio,
                    "+ stiffer: a factor of all forces of the table",
                    LawConstant::Stiffness,
                ));
                let rows = spline.points().len();
                list.extend((0..rows).map(|row| {
                    let name = format!("table.{}", row + 1);
                    make(name, size, "+ as the force of the law, + tension", LawConstant::Row(row))
                }));
            }
        }
        if law.acts == Acts::Always && law.elastic != Curve::Zero {
            let sign = if turns { "+ right-handed" } else { "+ tension" };
            list.push(make("preload".to_owned(), size, sign, LawConstant::Preload));
        }
        list
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

    /// What the parameter is in the mechanism of a specimen.
    pub(super) fn resolve(&self, specimen: &impl Variable) -> Resolved {
        let mechanism = specimen.stand().mechanism();
        let expansion = specimen.stand().system().expansion();
        match &self.kind {
            Kind::Coordinate { .. } | Kind::Toe | Kind::Camber => Resolved::Shape,
            Kind::Law { force, part, constant } => {
                let values = owners(mechanism, force).flat_map(|owner| {
                    let own = expansion.elements().iter().map(|element| &element.instance);
                    let own = own.filter(move |instance| instance.owner == owner);
                    own.flat_map(|instance| instance.equations.clone()).nth(*part)
                });
                let constant = *constant;
                Resolved::Constants(
                    values.map(|value| ElementConstant { value, constant }).collect(),
                )
            }
            Kind::Length { force } => {
                let slots = owners(mechanism, force).filter_map(|owner| expansion.length(owner));
                Resolved::Parameters(slots.map(|slot| (slot, 1.0)).collect())
            }
            Kind::Adjuster { adjuster } => {
                let drivers = specimen.adjusters(*adjuster);
                let slots = drivers.iter().flat_map(|&d| expansion.driver_slots().of(d));
                Resolved::Parameters(slots.copied().collect())
            }
        }
    }

    /// The shape of a model that moves with this parameter.
    fn moving(&self, model: &Model) -> Shape<Dual> {
        let mut shape = Shape::of(model).lifted::<Dual>();
        match self.kind {
            Kind::Coordinate { point, axis } => {
                let mut along = [0.0; 3];
                along[axis] = 1.0;
                for (x, along) in shape.points[point].iter_mut().zip(model.axes.to_iso(along)) {
                    x.derivative = along;
                }
            }
            Kind::Toe => shape.alignment.toe.derivative = 1.0,
            Kind::Camber => shape.alignment.camber.derivative = 1.0,
            _ => {}
        }
        shape
    }
}

/// The force elements of a name: one, or one on each side.
fn owners(mechanism: &Mechanism, force: &str) -> impl Iterator<Item = Owner> {
    let names = [force.to_owned(), format!("left_{force}"), format!("right_{force}")];
    let ids: Vec<_> = names.iter().filter_map(|name| mechanism.force_named(name)).collect();
    ids.into_iter().map(Owner::Force)
}

/// What a parameter is in a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Resolved {
    /// It moves points.
    Shape,
    /// It is a constant of laws.
    Constants(Vec<ElementConstant>),
    /// It is added to parameters of relations, times a factor each.
    Parameters(Vec<(usize, f64)>),
}

impl Resolved {
    /// What changes in a state when the parameter does, per unit (SI). `constants` are those that the state was
    /// asked about.
    pub fn change(
        &self,
        parameter: &Parameter,
        model: &Model,
        varied: &Varied<'_>,
        constants: &[ElementConstant],
    ) -> Change {
        match self {
            Self::Shape => {
                let shape = parameter.moving(model);
                varied.change(&varied.both_sides(model, shape))
            }
            Self::Constants(own) => {
                let mut change = varied.no_change();
                for (amount, constant) in change.constants.iter_mut().zip(constants) {
                    *amount = if own.contains(constant) { 1.0 } else { 0.0 };
                }
                change
            }
            Self::Parameters(slots) => {
                let mut change = varied.no_change();
                for &(slot, factor) in slots {
                    change.h[slot] += factor;
                }
                change
            }
        }
    }
}
