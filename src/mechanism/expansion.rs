//! Joints, drivers and force elements as instances of relations.

use std::ops::Range;

use super::build::Mechanism;
use super::composition::Composition;
use super::force::ForceId;
use super::labels;
use super::law::Law;
use super::recipe::Recipe;
use super::slots::DriverSlots;
use super::topology::{BodyId, DriverId, DriverKind};
use crate::kernels::{EnergyKind, RelationKind};
use crate::scalar::Scalar;
use crate::vector::sub;

/// What an equation belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// The joint with this position in [`Mechanism::joints`].
    Joint(usize),
    /// A driver.
    Driver(DriverId),
    /// The Euler parameters of a body.
    Body(BodyId),
    /// A force element.
    Force(ForceId),
    /// The weight of a body.
    Weight(BodyId),
}

/// One relation between bodies of the mechanism.
#[derive(Clone, Debug)]
pub struct Instance {
    /// Which relation.
    pub kind: RelationKind,
    /// Body *i*; the only body of a relation of one body.
    pub i: BodyId,
    /// Body *j*; the same as *i* for a relation of one body.
    pub j: BodyId,
    /// Where its parameters are in h.
    pub parameters: Range<usize>,
    /// Where its equations are in Φ.
    pub equations: Range<usize>,
    /// The joint, driver or body that it comes from.
    pub owner: Owner,
}

/// A relation that pushes back.
#[derive(Clone, Debug)]
pub struct Element {
    /// The relation; its equations are numbered apart from those of the constraints.
    pub instance: Instance,
    /// One law for each equation.
    pub laws: Vec<Law>,
}

/// The inertia of a body.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// The body.
    pub body: BodyId,
    /// The kinetic energy.
    pub kind: EnergyKind,
    /// Where its parameters are in h.
    pub parameters: Range<usize>,
}

/// A mechanism as relations: first the Euler parameters of every moving body,
/// then the joints, then the drivers. Force elements and inertias stand apart: they hold nothing.
#[derive(Clone, Debug)]
pub struct Expansion {
    instances: Vec<Instance>,
    elements: Vec<Element>,
    inertias: Vec<Inertia>,
    value_count: usize,
    pub(super) recipes: Vec<Recipe>,
    driver_slots: DriverSlots,
    labels: Vec<String>,
    owners: Vec<Owner>,
    parameter_count: usize,
    body_count: usize,
}

impl Expansion {
    /// Expands all joints and drivers.
    pub fn new(mechanism: &Mechanism) -> Self {
        let mut expansion = Self {
            instances: vec![],
            elements: vec![],
            inertias: vec![],
            value_count: 0,
            recipes: vec![],
            driver_slots: DriverSlots::default(),
            labels: vec![],
            owners: vec![],
            parameter_count: 0,
            body_count: mechanism.bodies().len(),
        };
        for (index, body) in mechanism.bodies().iter().enumerate().skip(1) {
            let id = BodyId(index);
            let kind = RelationKind::EulerParameters;
            expansion.relation(Owner::Body(id), kind, id, id, &[]);
            expansion.labels.push(format!("{} (Euler parameters), normalisation", body.name));
        }
        for (index, joint) in mechanism.joints().iter().enumerate() {
            Composition::of_joint(mechanism, index, joint, &mut expansion).joint(joint.kind);
            let name = labels::joint(mechanism, joint);
            let components = labels::components(joint.kind);
            expansion
                .labels
                .extend(components.iter().map(|component| format!("{name}, {component}")));
        }
        for (index, driver) in mechanism.drivers().iter().enumerate() {
            let id = DriverId(index);
            if driver.kind == DriverKind::Adjuster {
                expansion.driver_slots.push(vec![]);
                continue;
            }
            Composition::of_driver(mechanism, id, driver, &mut expansion).driver(driver.kind);
            // The prescribed value is the last parameter of every relation that drives.
            expansion.driver_slots.push(vec![(expansion.parameter_count - 1, 1.0)]);
            expansion.labels.push(labels::driver(mechanism, driver));
        }
        debug_assert_eq!(expansion.labels.len(), expansion.owners.len());
        expansion.forces_and_masses(mechanism);
        for (driver, adjuster) in &mechanism.adjusters {
            let slots = expansion.adjusted(mechanism, adjuster);
            expansion.driver_slots.replace(*driver, slots);
        }
        expansion
    }

    fn forces_and_masses(&mut self, mechanism: &Mechanism) {
        for (index, force) in mechanism.forces().iter().enumerate() {
            Composition::of_force(mechanism, ForceId(index), force, self).force(&force.kind);
        }
        let gravity = mechanism.gravity();
        for (index, body) in mechanism.bodies().iter().enumerate().skip(1) {
            let Some(mass) = body.mass else { continue };
            let id = BodyId(index);
            if gravity != [0.0; 3] && mass.mass > 0.0 {
                Composition::of_weight(mechanism, id, self).weight(&mass, gravity);
            }
            let [xx, yy, zz, xy, xz, yz] = mass.inertia;
            let recipes = [
                Recipe::Number(mass.mass),
                Recipe::Constant(sub(mass.center, body.origin)),
                Recipe::Constant([xx, yy, zz]),
                Recipe::Constant([xy, xz, yz]),
            ];
            let parameters = self.recipes(&recipes);
            self.inertias.push(Inertia { body: id, kind: EnergyKind::RigidBody, parameters });
        }
    }

    /// The force elements, weights last.
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// Number of equations of all force elements.
    pub fn value_count(&self) -> usize {
        self.value_count
    }

    /// The inertias of the bodies that have mass.
    pub fn inertias(&self) -> &[Inertia] {
        &self.inertias
    }

    /// The relations in the order of their equations.
    pub fn instances(&self) -> &[Instance] {
        &self.instances
    }

    /// Length of Φ.
    pub fn equation_count(&self) -> usize {
        self.owners.len()
    }

    /// Length of h.
    pub fn parameter_count(&self) -> usize {
        self.parameter_count
    }

    /// Number of bodies with the ground.
    pub fn body_count(&self) -> usize {
        self.body_count
    }

    /// An equation in words, such as `lca_outer (spherical joint of lca and upright), y position`.
    pub fn label(&self, equation: usize) -> &str {
        &self.labels[equation]
    }

    /// What an equation belongs to.
    pub fn owner(&self, equation: usize) -> Owner {
        self.owners[equation]
    }

    /// The equations of a joint, driver or body.
    pub fn equations_of(&self, owner: Owner) -> impl Iterator<Item = usize> + '_ {
        (0..self.owners.len()).filter(move |&equation| self.owners[equation] == owner)
    }

    /// The parameter that the value of a driver which prescribes a motion is added to.
    ///
    /// # Panics
    /// If the driver is an adjuster that changes nothing.
    pub fn driver_slot(&self, driver: DriverId) -> usize {
        self.driver_slots.of(driver)[0].0
    }

    /// The parameters that the values of drivers are added to.
    pub fn driver_slots(&self) -> &DriverSlots {
        &self.driver_slots
    }

    /// All parameters h for the given positions of the points (m) and all drivers at zero.
    ///
    /// The choices that the parameters depend on, such as the coordinate axis
    /// that a normal is built with, were made at the design position and stay.
    /// So the derivative on dual numbers is exact.
    ///
    /// # Panics
    /// If `positions` is shorter than the list of points.
    pub fn parameters<S: Scalar>(&self, positions: &[[S; 3]]) -> Vec<S> {
        let mut h = Vec::with_capacity(self.parameter_count);
        for recipe in &self.recipes {
            recipe.evaluate(positions, &mut h);
        }
        h
    }

    /// Adds one relation with the recipes of its parameters, in the order of its file.
    pub(super) fn relation(
        &mut self,
        owner: Owner,
        kind: RelationKind,
        i: BodyId,
        j: BodyId,
        recipes: &[Recipe],
    ) {
        let first = self.owners.len();
        let equations = kind.shape().equations;
        let parameters = self.recipes(recipes);
        debug_assert_eq!(parameters.len(), kind.shape().parameter_count(), "{}", kind.name());
        self.owners.extend(std::iter::repeat_n(owner, equations));
        let equations = first..first + equations;
        self.instances.push(Instance { kind, i, j, parameters, equations, owner });
    }

    /// Adds one relation that pushes back.
    pub(super) fn element(
        &mut self,
        owner: Owner,
        kind: RelationKind,
        i: BodyId,
        j: BodyId,
        recipes: &[Recipe],
        laws: &[Law],
    ) {
        let first = self.value_count;
        debug_assert_eq!(laws.len(), kind.shape().equations, "{}", kind.name());
        self.value_count += laws.len();
        let parameters = self.recipes(recipes);
        debug_assert_eq!(parameters.len(), kind.shape().parameter_count(), "{}", kind.name());
        let equations = first..self.value_count;
        let instance = Instance { kind, i, j, parameters, equations, owner };
        self.elements.push(Element { instance, laws: laws.to_vec() });
    }

    /// Keeps recipes and returns where their numbers are in h.
    fn recipes(&mut self, recipes: &[Recipe]) -> Range<usize> {
        let first = self.parameter_count;
        self.parameter_count += recipes.iter().map(|recipe| recipe.size()).sum::<usize>();
        self.recipes.extend_from_slice(recipes);
        first..self.parameter_count
    }
}
