//! What the parameters of a model are in a mechanism.

use super::parameter::{Kind, Parameter};
use crate::assembly::ElementConstant;
use crate::mechanism::{Mechanism, Owner};
use crate::model::Model;
use crate::rig::{Shape, Variable, Varied};
use crate::scalar::Dual;
use crate::solve::sensitivity::Change;

/// What a parameter is in a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Resolved {
    /// It moves points.
    Shape,
    /// It is added to constants of laws, times a factor each.
    Constants(Vec<(ElementConstant, f64)>),
    /// It is added to parameters of relations, times a factor each.
    Parameters(Vec<(usize, f64)>),
}

impl Parameter {
    /// What the parameter is in the mechanism of a specimen.
    pub(super) fn resolve(&self, specimen: &impl Variable, model: &Model) -> Resolved {
        let mechanism = specimen.stand().mechanism();
        let expansion = specimen.stand().system().expansion();
        match &self.kind {
            Kind::Coordinate { .. } | Kind::Toe | Kind::Camber => Resolved::Shape,
            Kind::Law(number) => {
                let value = |(owner, is_image): (Owner, bool)| {
                    let own = expansion.elements().iter().map(|element| &element.instance);
                    let own = own.filter(|instance| instance.owner == owner);
                    let value = own.flat_map(|own| own.equations.clone()).nth(number.part)?;
                    let (constant, factor) = match is_image {
                        true => number.image(),
                        false => (number.constant, number.factor),
                    };
                    Some((ElementConstant { value, constant }, factor))
                };
                let owners = owners(mechanism, model, &number.force).into_iter();
                Resolved::Constants(owners.filter_map(value).collect())
            }
            Kind::Length { force, factor } => {
                let owners = owners(mechanism, model, force).into_iter();
                let slots = owners.filter_map(|(owner, _)| expansion.length(owner));
                Resolved::Parameters(slots.map(|slot| (slot, *factor)).collect())
            }
            Kind::Adjuster { adjuster } => {
                let mut drivers = specimen.adjusters(*adjuster);
                if drivers.len() > 1 && model.has_other_side() {
                    drivers = vec![drivers[model.side.index()]];
                }
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

/// The force elements that one of the model became, and whether each is its mirror image: one, one on each side,
/// or the mounts of a subframe that a corner has on both. A side with a file of its own has its own elements.
fn owners(mechanism: &Mechanism, model: &Model, force: &str) -> Vec<(Owner, bool)> {
    let on = |side: &str| format!("{side}_{force}");
    let (own, other) = (model.side.name(), model.side.other().name());
    let mut names = vec![(force.to_owned(), false), (on(own), false)];
    names.push((format!("{force}_opposite"), true));
    if !model.has_other_side() {
        names.push((on(other), true));
    }
    let found = |(name, image): (String, bool)| {
        mechanism.force_named(&name).map(|force| (Owner::Force(force), image))
    };
    names.into_iter().filter_map(found).collect()
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
                    let own = own.iter().find(|(own, _)| own == constant);
                    *amount = own.map_or(0.0, |(_, factor)| *factor);
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
