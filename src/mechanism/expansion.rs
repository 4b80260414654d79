//! Joints and drivers as instances of relations.

use std::ops::Range;

use super::build::Mechanism;
use super::labels;
use super::recipe::{Normals, Recipe};
use super::topology::{BodyId, Driver, DriverId, DriverKind, Joint, JointKind};
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
            expansion
                .labels
                .push(format!("{} (Euler parameters), normalisation", body.name));
        }
        for (index, joint) in mechanism.joints().iter().enumerate() {
            Composition::of_joint(mechanism, index, joint, &mut expansion).joint(joint.kind);
            let name = labels::joint(mechanism, joint);
            let components = labels::components(joint.kind);
            expansion.labels.extend(
                components
                    .iter()
                    .map(|component| format!("{name}, {component}")),
            );
        }
        for (index, driver) in mechanism.drivers().iter().enumerate() {
            let id = DriverId(index);
            Composition::of_driver(mechanism, id, driver, &mut expansion).driver(driver.kind);
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

    fn relation(
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

/// One joint or driver on its way into relations.
struct Composition<'a> {
    mechanism: &'a Mechanism,
    owner: Owner,
    i: BodyId,
    j: BodyId,
    into: &'a mut Expansion,
}

impl<'a> Composition<'a> {
    fn of_joint(
        mechanism: &'a Mechanism,
        index: usize,
        joint: &Joint,
        into: &'a mut Expansion,
    ) -> Self {
        Self {
            mechanism,
            owner: Owner::Joint(index),
            i: joint.i,
            j: joint.j,
            into,
        }
    }

    fn of_driver(
        mechanism: &'a Mechanism,
        id: DriverId,
        driver: &Driver,
        into: &'a mut Expansion,
    ) -> Self {
        Self {
            mechanism,
            owner: Owner::Driver(id),
            i: driver.i,
            j: driver.j,
            into,
        }
    }

    fn joint(&mut self, kind: JointKind) {
        match kind {
            JointKind::Spherical { at } => self.spherical(at),
            JointKind::Revolute { at, axis } => {
                self.spherical(at);
                self.align(axis);
            }
            JointKind::Universal { at, shaft } => {
                self.spherical(at);
                let [first, second] = self.normals(shaft);
                self.orthogonal_1(first, second);
            }
            JointKind::Translational { at, axis } => {
                self.align(axis);
                let [first, second] = self.normals(axis);
                self.orthogonal_1(first, second);
                self.orthogonal_2(first, at);
                self.orthogonal_2(second, at);
            }
            JointKind::Cylindrical { at, axis } => {
                self.align(axis);
                self.in_line(at, axis);
            }
            JointKind::Fixed { at } => {
                self.spherical(at);
                let [x, y, z] =
                    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Recipe::Constant);
                self.orthogonal_1(x, y);
                self.orthogonal_1(y, z);
                self.orthogonal_1(z, x);
            }
            JointKind::Link { on_i, on_j } => {
                let ends = [self.local(self.i, on_i), self.local(self.j, on_j)];
                self.relation(
                    RelationKind::SquaredDistance,
                    &[ends[0], ends[1], Recipe::Distance(on_i, on_j)],
                );
            }
            JointKind::InPlane { at, normal } => self.orthogonal_2(Recipe::Axis(normal), at),
            JointKind::InLine { at, axis } => self.in_line(at, axis),
        }
    }

    fn driver(&mut self, kind: DriverKind) {
        match kind {
            DriverKind::Displacement { at, along } => {
                let ends = [self.local(self.i, at), self.local(self.j, at)];
                self.relation(
                    RelationKind::Displacement,
                    &[Recipe::Axis(along), ends[0], ends[1], Recipe::Number(0.0)],
                );
            }
            DriverKind::Rotation { axis } => {
                let [first, second] = self.normals(axis);
                self.relation(
                    RelationKind::Rotation,
                    &[first, second, first, Recipe::Number(0.0)],
                );
            }
            DriverKind::Length { on_i, on_j } => {
                let ends = [self.local(self.i, on_i), self.local(self.j, on_j)];
                self.relation(
                    RelationKind::Distance,
                    &[ends[0], ends[1], Recipe::Distance(on_i, on_j)],
                );
            }
            DriverKind::Height { at } => {
                self.i = self.j;
                let point = self.local(self.j, at);
                self.relation(RelationKind::PointHeight, &[point, Recipe::Height(at)]);
            }
            DriverKind::PatchHeight {
                center,
                spin,
                radius,
            } => {
                self.i = self.j;
                let point = self.local(self.j, center);
                let height = Recipe::PatchHeight {
                    center,
                    spin,
                    radius,
                };
                self.relation(
                    RelationKind::PatchHeight,
                    &[point, Recipe::Axis(spin), Recipe::Number(radius), height],
                );
            }
        }
    }

    /// The axis of body *j* stays parallel to that of body *i*.
    fn align(&mut self, axis: super::Direction) {
        let [first, second] = self.normals(axis);
        self.orthogonal_1(first, Recipe::Axis(axis));
        self.orthogonal_1(second, Recipe::Axis(axis));
    }

    /// The point of body *j* stays on the line through it, fixed in body *i*.
    fn in_line(&mut self, at: super::PointId, axis: super::Direction) {
        let [first, second] = self.normals(axis);
        self.orthogonal_2(first, at);
        self.orthogonal_2(second, at);
    }

    fn spherical(&mut self, at: super::PointId) {
        let ends = [self.local(self.i, at), self.local(self.j, at)];
        self.relation(RelationKind::Spherical, &ends);
    }

    fn orthogonal_1(&mut self, u_i: Recipe, v_j: Recipe) {
        self.relation(RelationKind::Orthogonal1, &[u_i, v_j]);
    }

    fn orthogonal_2(&mut self, a_i: Recipe, at: super::PointId) {
        let ends = [self.local(self.i, at), self.local(self.j, at)];
        self.relation(RelationKind::Orthogonal2, &[a_i, ends[0], ends[1]]);
    }

    fn normals(&self, axis: super::Direction) -> [Recipe; 2] {
        let normals = Normals::choose(self.mechanism, axis);
        [Recipe::FirstNormal(normals), Recipe::SecondNormal(normals)]
    }

    fn local(&self, body: BodyId, point: super::PointId) -> Recipe {
        Recipe::Local {
            point,
            origin: self.mechanism.bodies()[body.0].origin,
        }
    }

    fn relation(&mut self, kind: RelationKind, recipes: &[Recipe]) {
        let Self { owner, i, j, .. } = *self;
        self.into.relation(owner, kind, i, j, recipes);
    }
}
