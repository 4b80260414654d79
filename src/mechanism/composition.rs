//! Joints and drivers as compositions of the basic relations.

use super::build::Mechanism;
use super::expansion::{Expansion, Owner};
use super::recipe::{Normals, Recipe};
use super::topology::{BodyId, Direction, Driver, DriverId, DriverKind, Joint, JointKind, PointId};
use crate::kernels::RelationKind;

/// One joint or driver on its way into relations.
pub(super) struct Composition<'a> {
    mechanism: &'a Mechanism,
    owner: Owner,
    i: BodyId,
    j: BodyId,
    into: &'a mut Expansion,
}

impl<'a> Composition<'a> {
    pub(super) fn of_joint(
        mechanism: &'a Mechanism,
        index: usize,
        joint: &Joint,
        into: &'a mut Expansion,
    ) -> Self {
        Self { mechanism, owner: Owner::Joint(index), i: joint.i, j: joint.j, into }
    }

    pub(super) fn of_driver(
        mechanism: &'a Mechanism,
        id: DriverId,
        driver: &Driver,
        into: &'a mut Expansion,
    ) -> Self {
        Self { mechanism, owner: Owner::Driver(id), i: driver.i, j: driver.j, into }
    }

    pub(super) fn joint(&mut self, kind: JointKind) {
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

    pub(super) fn driver(&mut self, kind: DriverKind) {
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
                self.relation(RelationKind::Rotation, &[first, second, first, Recipe::Number(0.0)]);
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
            DriverKind::PatchHeight { center, spin, radius } => {
                self.i = self.j;
                let point = self.local(self.j, center);
                let height = Recipe::PatchHeight { center, spin, radius };
                self.relation(
                    RelationKind::PatchHeight,
                    &[point, Recipe::Axis(spin), Recipe::Number(radius), height],
                );
            }
        }
    }

    /// The axis of body *j* stays parallel to that of body *i*.
    fn align(&mut self, axis: Direction) {
        let [first, second] = self.normals(axis);
        self.orthogonal_1(first, Recipe::Axis(axis));
        self.orthogonal_1(second, Recipe::Axis(axis));
    }

    /// The point of body *j* stays on the line through it, fixed in body *i*.
    fn in_line(&mut self, at: PointId, axis: Direction) {
        let [first, second] = self.normals(axis);
        self.orthogonal_2(first, at);
        self.orthogonal_2(second, at);
    }

    fn spherical(&mut self, at: PointId) {
        let ends = [self.local(self.i, at), self.local(self.j, at)];
        self.relation(RelationKind::Spherical, &ends);
    }

    fn orthogonal_1(&mut self, u_i: Recipe, v_j: Recipe) {
        self.relation(RelationKind::Orthogonal1, &[u_i, v_j]);
    }

    fn orthogonal_2(&mut self, a_i: Recipe, at: PointId) {
        let ends = [self.local(self.i, at), self.local(self.j, at)];
        self.relation(RelationKind::Orthogonal2, &[a_i, ends[0], ends[1]]);
    }

    fn normals(&self, axis: Direction) -> [Recipe; 2] {
        let normals = Normals::choose(self.mechanism, axis);
        [Recipe::FirstNormal(normals), Recipe::SecondNormal(normals)]
    }

    fn local(&self, body: BodyId, point: PointId) -> Recipe {
        Recipe::Local { point, origin: self.mechanism.bodies()[body.0].origin }
    }

    fn relation(&mut self, kind: RelationKind, recipes: &[Recipe]) {
        let Self { owner, i, j, .. } = *self;
        self.into.relation(owner, kind, i, j, recipes);
    }
}
