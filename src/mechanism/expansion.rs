//! Joints and drivers as instances of relations.

use std::ops::Range;

use super::build::Mechanism;
use super::composition::Composition;
use super::labels;
use super::recipe::Recipe;
use super::topology::{BodyId, DriverId};
use crate::kernels::RelationKind;
use crate::scalar::Scalar;

/// What an equation belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// The joint with this position in [`Mechanism::joints`].
    Joint(usize),
    /// A driver.
    Driver(DriverId),
    /// The Euler parameters of a body.
    Body(BodyId),
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

/// A mechanism as relations: first the Euler parameters of every moving body,
/// then the joints, then the drivers.
#[derive(Clone, Debug)]
pub struct Expansion {
    instances: Vec<Instance>,
    recipes: Vec<Recipe>,
    driver_slots: Vec<usize>,
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
            recipes: vec![],
            driver_slots: vec![],
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
            Composition::of_driver(mechanism, id, driver, &mut expansion).driver(driver.kind);
            // The prescribed value is the last parameter of every relation that drives.
            expansion.driver_slots.push(expansion.parameter_count - 1);
            expansion.labels.push(labels::driver(mechanism, driver));
        }
        debug_assert_eq!(expansion.labels.len(), expansion.owners.len());
        expansion
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

    /// The parameter that a driver's value is added to.
    pub fn driver_slot(&self, driver: DriverId) -> usize {
        self.driver_slots[driver.0]
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
        let first_parameter = self.parameter_count;
        let first_equation = self.owners.len();
        let equations = kind.shape().equations;
        self.parameter_count += recipes.iter().map(|recipe| recipe.size()).sum::<usize>();
        debug_assert_eq!(
            self.parameter_count - first_parameter,
            kind.shape().parameter_count(),
            "parameters of {}",
            kind.name()
        );
        self.recipes.extend_from_slice(recipes);
        self.owners.extend(std::iter::repeat_n(owner, equations));
        self.instances.push(Instance {
            kind,
            i,
            j,
            parameters: first_parameter..self.parameter_count,
            equations: first_equation..first_equation + equations,
            owner,
        });
    }
}
