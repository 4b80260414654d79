//! Joints, drivers and force elements as compositions of the basic relations.

use std::slice;

use super::build::Mechanism;
use super::expansion::{Expansion, Owner};
use super::force::{
    Bushing, Contact, Force, ForceId, ForceKind, LoadFrame, MassProperties, MomentLaw, Reference,
    RotationMeasure,
};
use super::law::Law;
use super::recipe::{Normals, Recipe};
use super::topology::{BodyId, Direction, Driver, DriverId, DriverKind, Joint, JointKind, PointId};
use crate::kernels::RelationKind;
use crate::vector::{norm, sub};

/// One joint, driver or force element on its way into relations.
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

    pub(super) fn of_force(
        mechanism: &'a Mechanism,
        id: ForceId,
        force: &Force,
        into: &'a mut Expansion,
    ) -> Self {
        Self { mechanism, owner: Owner::Force(id), i: force.i, j: force.j, into }
    }

    pub(super) fn of_weight(
        mechanism: &'a Mechanism,
        body: BodyId,
        into: &'a mut Expansion,
    ) -> Self {
        Self { mechanism, owner: Owner::Weight(body), i: body, j: body, into }
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
                self.keep_orientation();
            }
            JointKind::Link { on_i, on_j } => {
                let ends = [self.local(self.i, on_i), self.local(self.j, on_j)];
                self.relation(
                    RelationKind::SquaredDistance,
                    &[ends[0], ends[1], Recipe::Distance(on_i, on_j, 0.0)],
                );
            }
            JointKind::InPlane { at, normal } => self.orthogonal_2(Recipe::Axis(normal), at),
            JointKind::InLine { at, axis } => self.in_line(at, axis),
            JointKind::Perpendicular { axis, .. } => {
                let [first, second] = self.normals(axis);
                self.orthogonal_1(first, second);
            }
            JointKind::Hooke { at, pin_i, pin_j } => {
                self.spherical(at);
                self.orthogonal_1(Recipe::Axis(pin_i), Recipe::Axis(pin_j));
            }
            JointKind::PerpendicularAxes { axis_i, axis_j, .. } => {
                self.orthogonal_1(Recipe::Axis(axis_i), Recipe::Axis(axis_j));
            }
            JointKind::ParallelAxes { axis, .. } => self.align(axis),
            JointKind::Orientation { .. } => self.keep_orientation(),
            JointKind::RackAndPinion { at, axis, along, pitch_radius } => {
                // The pinion goes back along the rack by what the rack goes along.
                self.roll(at, axis, along, -1.0 / pitch_radius);
            }
            JointKind::Screw { at, axis, lead } => {
                self.roll(at, axis, axis, std::f64::consts::TAU / lead);
            }
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
                    &[ends[0], ends[1], Recipe::Distance(on_i, on_j, 0.0)],
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
            // It changes the parameters of others.
            DriverKind::Adjuster => {}
        }
    }

    pub(super) fn force(&mut self, kind: &ForceKind) {
        match kind {
            ForceKind::Line { on_i, on_j, reference, law } => {
                let reference = match *reference {
                    Reference::Length(length) => Recipe::Number(length),
                    Reference::Design(offset) => Recipe::Distance(*on_i, *on_j, offset),
                };
                let ends = [self.local(self.i, *on_i), self.local(self.j, *on_j)];
                let recipes = [ends[0], ends[1], reference];
                self.element(RelationKind::Distance, &recipes, slice::from_ref(law));
            }
            ForceKind::Slide { at, along, law } => {
                let ends = [self.local(self.i, *at), self.local(self.j, *at)];
                let recipes = [Recipe::Axis(*along), ends[0], ends[1], Recipe::Number(0.0)];
                self.element(RelationKind::Displacement, &recipes, slice::from_ref(law));
            }
            ForceKind::Torsion { axis, law } => {
                let [first, second] = self.normals(*axis);
                let recipes = [first, second, first, Recipe::Number(0.0)];
                self.element(RelationKind::Torsion, &recipes, slice::from_ref(law));
            }
            ForceKind::Bushing(bushing) => self.bushing(bushing),
            ForceKind::Tyre { contact, free_radius, ground, law } => {
                self.i = self.j;
                let law = slice::from_ref(law);
                match *contact {
                    Contact::Center(center) => {
                        let height = Recipe::Number(ground + free_radius);
                        let recipes = [self.local(self.j, center), height];
                        self.element(RelationKind::PointHeight, &recipes, law);
                    }
                    Contact::Patch { center, spin } => {
                        let point = self.local(self.j, center);
                        let (spin, radius) = (Recipe::Axis(spin), Recipe::Number(*free_radius));
                        let recipes = [point, spin, radius, Recipe::Number(*ground)];
                        self.element(RelationKind::PatchHeight, &recipes, law);
                    }
                }
            }
            ForceKind::PointForce { at, frame, direction, size } => {
                self.i = self.j;
                let axis = Recipe::Axis(Direction::Fixed(*direction));
                let point = self.local(self.j, *at);
                self.load(*frame, axis, Some(point), *size);
            }
            ForceKind::Moment { frame, direction, size } => {
                self.i = self.j;
                self.load(*frame, Recipe::Axis(Direction::Fixed(*direction)), None, *size);
            }
        }
    }

    /// The weight m·g at the centre of mass.
    pub(super) fn weight(&mut self, mass: &MassProperties, gravity: [f64; 3]) {
        let origin = self.mechanism.bodies()[self.j.0].origin;
        let center = Recipe::Constant(sub(mass.center, origin));
        let axis = Recipe::Axis(Direction::Fixed(gravity));
        self.load(LoadFrame::Space, axis, Some(center), mass.mass * norm(gravity));
    }

    /// A force at a point, or a moment where there is no point, along an axis.
    fn load(&mut self, frame: LoadFrame, axis: Recipe, point: Option<Recipe>, size: f64) {
        // The force on the body is −Wᵀλ.
        let law = [Law::constant(-size)];
        match (frame, point) {
            (LoadFrame::Space, Some(point)) => {
                let recipes = [axis, point, Recipe::Number(0.0)];
                self.element(RelationKind::PositionAlong, &recipes, &law);
            }
            (LoadFrame::Body, Some(point)) => {
                self.element(RelationKind::ForceInBody, &[axis, point], &law);
            }
            (LoadFrame::Space, None) => self.element(RelationKind::MomentInSpace, &[axis], &law),
            (LoadFrame::Body, None) => self.element(RelationKind::MomentInBody, &[axis], &law),
        }
    }

    fn bushing(&mut self, bushing: &Bushing) {
        let axes = [0, 1, 2].map(|axis| Recipe::BushingAxis(bushing.axes, axis));
        let [x, y, z] = axes;
        if !bushing.translation.iter().all(Law::is_zero) {
            let (on_i, on_j) = (self.local(self.i, bushing.at), self.local(self.j, bushing.at));
            let recipes = [x, y, z, on_i, on_j];
            self.element(RelationKind::BushingTranslation, &recipes, &bushing.translation);
        }
        if bushing.rotation.iter().all(Law::is_zero) {
            return;
        }
        let (kind, recipes) = match (bushing.measure, bushing.moment) {
            (RotationMeasure::Angles, MomentLaw::Energy) => {
                (RelationKind::BushingAngles, &[x, y, z, x, y, z][..])
            }
            (RotationMeasure::Angles, MomentLaw::Torque) => {
                (RelationKind::BushingAnglesTorque, &[x, y, z, x, y, z][..])
            }
            (RotationMeasure::RotationVector, MomentLaw::Energy) => {
                (RelationKind::BushingRotationVector, &axes[..])
            }
            (RotationMeasure::RotationVector, MomentLaw::Torque) => {
                (RelationKind::BushingRotationVectorTorque, &axes[..])
            }
        };
        self.element(kind, recipes, &bushing.rotation);
    }

    /// Body *j* keeps its orientation in body *i*.
    fn keep_orientation(&mut self) {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Recipe::Constant);
        self.orthogonal_1(x, y);
        self.orthogonal_1(y, z);
        self.orthogonal_1(z, x);
    }

    /// Body *j* turns about the axis by the ratio (rad/m) times the way of its point along a direction.
    fn roll(&mut self, at: PointId, axis: Direction, along: Direction, ratio: f64) {
        let [first, second] = self.normals(axis);
        let ends = [self.local(self.i, at), self.local(self.j, at)];
        let along = Recipe::Axis(along);
        let recipes = [first, second, first, along, ends[0], ends[1], Recipe::Number(ratio)];
        self.relation(RelationKind::RackAndPinion, &recipes);
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
        Recipe::Local { point, body, origin: self.mechanism.bodies()[body.0].origin }
    }

    fn relation(&mut self, kind: RelationKind, recipes: &[Recipe]) {
        let Self { owner, i, j, .. } = *self;
        self.into.relation(owner, kind, i, j, recipes);
    }

    fn element(&mut self, kind: RelationKind, recipes: &[Recipe], laws: &[Law]) {
        let Self { owner, i, j, .. } = *self;
        self.into.element(owner, kind, i, j, recipes, laws);
    }
}
