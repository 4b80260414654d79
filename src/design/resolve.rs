//! What the parameters of a model are in a mechanism.

use super::parameter::{Kind, Parameter};
use crate::assembly::ElementConstant;
use crate::mechanism::{DriverId, Mechanism, Owner};
use crate::model::Model;
use crate::rig::{Cause, Settled, Shape, Stand, Variable, Varied};
use crate::scalar::Dual;
use crate::solve::sensitivity::{Change, SensitivityError};

/// What a parameter is in a mechanism, and in that of its static state, where there is one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Resolved {
    /// Constants of laws that it is added to, times a factor each.
    pub constants: Vec<(ElementConstant, f64)>,
    /// Parameters of relations that it is added to, times a factor each.
    pub parameters: Vec<(usize, f64)>,
    settled_parameters: Vec<(usize, f64)>,
    /// What the goals of the static state change by.
    wanted: Vec<f64>,
    /// What the travels of the wheels in the static state change by.
    travels: Vec<f64>,
}

impl Parameter {
    /// What the parameter is in the mechanism of a specimen.
    pub(super) fn resolve(&self, specimen: &impl Variable, model: &Model) -> Resolved {
        let stand = specimen.stand();
        let settled = specimen.settled();
        let mut resolved = Resolved::default();
        let is_own = |wheel: usize| {
            let alone = specimen.sides() == 1;
            alone || !model.has_other_side() || wheel == model.side.index()
        };
        match &self.kind {
            Kind::Coordinate { .. } | Kind::Toe | Kind::Camber => {}
            Kind::Law(number) => {
                let expansion = stand.system().expansion();
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
                let owners = owners(stand.mechanism(), model, &number.force).into_iter();
                resolved.constants = owners.filter_map(value).collect();
            }
            Kind::Length { force, factor } => {
                let slots = |stand: &Stand| -> Vec<(usize, f64)> {
                    let owners = owners(stand.mechanism(), model, force).into_iter();
                    let expansion = stand.system().expansion();
                    let slots = owners.filter_map(|(owner, _)| expansion.length(owner));
                    slots.map(|slot| (slot, *factor)).collect()
                };
                resolved.parameters = slots(stand);
                resolved.settled_parameters =
                    settled.map_or_else(Vec::new, |settled| slots(settled.stand()));
            }
            Kind::Adjuster { adjuster } => {
                let drivers = specimen.adjusters(*adjuster).into_iter().enumerate();
                let drivers = drivers.filter(|(wheel, _)| is_own(*wheel));
                let drivers: Vec<DriverId> = drivers.map(|(_, driver)| driver).collect();
                let name = |driver: &DriverId| &*stand.mechanism().drivers()[driver.index()].name;
                let names: Vec<&str> = drivers.iter().map(name).collect();
                let slots = |stand: &Stand| -> Vec<(usize, f64)> {
                    let mechanism = stand.mechanism();
                    let is_named = |driver: &DriverId| {
                        names.contains(&&*mechanism.drivers()[driver.index()].name)
                    };
                    let slots = stand.system().expansion().driver_slots();
                    let drivers = mechanism.driver_ids().filter(is_named);
                    drivers.flat_map(|driver| slots.of(driver).to_vec()).collect()
                };
                resolved.parameters = slots(stand);
                resolved.settled_parameters =
                    settled.map_or_else(Vec::new, |settled| slots(settled.stand()));
            }
            Kind::Target { factor } => {
                let wanted = |(wheel, name): (usize, &str)| {
                    if name == *factor && is_own(wheel) { 1.0 } else { 0.0 }
                };
                let goals = settled.into_iter().flat_map(Settled::goals);
                resolved.wanted = goals.map(wanted).collect();
            }
            Kind::RideHeight => {
                // The wheels go up by as much as the chassis comes down.
                let travel = |wheel: usize| if is_own(wheel) { -1.0 } else { 0.0 };
                resolved.travels = (0..specimen.sides()).map(travel).collect();
            }
        }
        resolved
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
    ///
    /// # Errors
    /// [`SensitivityError`] where the static state does not go with it.
    pub fn change(
        &self,
        parameter: &Parameter,
        model: &Model,
        varied: &mut Varied<'_>,
        constants: &[ElementConstant],
    ) -> Result<Change, SensitivityError> {
        let amount = |constant: &ElementConstant| {
            let own = self.constants.iter().find(|(own, _)| own == constant);
            own.map_or(0.0, |(_, factor)| *factor)
        };
        varied.change_by(&Cause {
            shapes: varied.both_sides(model, parameter.moving(model)),
            constants: constants.iter().map(amount).collect(),
            parameters: self.parameters.clone(),
            settled_parameters: self.settled_parameters.clone(),
            wanted: self.wanted.clone(),
            travels: self.travels.clone(),
        })
    }
}
