//! A specimen that takes other values of parameters, and says what comes of them at its states.

use super::Obstacle;
use crate::assembly::ElementConstant;
use crate::design::parameter::Parameter;
use crate::design::resolve::Resolved;
use crate::mechanism::{BodyId, PointId};
use crate::model::Model;
use crate::rig::{Moved, Pose, Shape, Target, Variable};
use crate::scalar::Dual;
use crate::solve::sensitivity::Change;
use crate::vector::Vector;

/// A corner or an axle whose parameters change.
pub(super) struct Trial<V> {
    specimen: V,
    model: Model,
    parameters: Vec<Parameter>,
    /// What turns a value along an axis of ISO 8855 into one along that of the model.
    signs: Vec<f64>,
    resolved: Vec<Resolved>,
    constants: Vec<ElementConstant>,
    compliance: bool,
    /// Coordinates that are off by tolerances, and what they change.
    tolerances: Vec<Parameter>,
    tolerance_changes: Vec<Change>,
    /// What each parameter changes, for the present values; found when it is first needed.
    changes: Vec<Change>,
}

/// A state with its derivatives by all parameters.
pub(super) struct Reached {
    /// One for each parameter, all with the same values.
    pub by: Vec<Moved>,
}

impl Reached {
    /// A value with its derivatives.
    pub fn of(&self, value: impl Fn(&Moved) -> Option<Dual>) -> Option<(f64, Vec<f64>)> {
        let duals: Option<Vec<Dual>> = self.by.iter().map(value).collect();
        let duals = duals?;
        let value = duals.first()?.value;
        let by: Vec<f64> = duals.iter().map(|dual| dual.derivative).collect();
        (value.is_finite() && by.iter().all(|by| by.is_finite())).then_some((value, by))
    }
}

impl<V: Variable> Trial<V> {
    /// A specimen of a model with what may change of it. `compliance` says whether factors need how wheels give way
    /// to loads.
    pub fn new(specimen: V, model: &Model, parameters: &[Parameter], compliance: bool) -> Self {
        let resolved: Vec<Resolved> =
            parameters.iter().map(|p| p.resolve(&specimen, model)).collect();
        let mut constants = vec![];
        for resolved in &resolved {
            constants.extend(resolved.constants.iter().map(|(constant, _)| *constant));
        }
        Self {
            specimen,
            model: model.clone(),
            parameters: parameters.to_vec(),
            signs: parameters.iter().map(|parameter| parameter.sign_of_iso(model)).collect(),
            resolved,
            constants,
            compliance,
            tolerances: vec![],
            tolerance_changes: vec![],
            changes: vec![],
        }
    }

    /// Tells which coordinates are off by tolerances.
    pub fn tolerate(&mut self, coordinates: Vec<Parameter>) {
        self.tolerances = coordinates;
    }

    /// 1 of a corner, 2 of an axle.
    pub fn sides(&self) -> usize {
        self.specimen.sides()
    }

    /// Takes values (SI, coordinates in ISO 8855 axes) of the parameters and returns to the design position.
    pub fn set(&mut self, x: &[f64]) -> Result<(), Obstacle> {
        self.set_off(x, &[])
    }

    /// As [`Self::set`], with the coordinates that have tolerances off by these ways (m).
    pub fn set_off(&mut self, x: &[f64], offsets: &[f64]) -> Result<(), Obstacle> {
        let mut shape = Shape::of(&self.model);
        let (mut constants, mut lengths) = (vec![], vec![]);
        let parts = self.parameters.iter().zip(&self.resolved).zip(&self.signs);
        for (((parameter, resolved), sign), value) in parts.zip(x) {
            let value = sign * value;
            parameter.place(&self.model, &mut shape, value);
            let own = resolved.constants.iter();
            constants.extend(own.map(|&(constant, factor)| (constant, factor * value)));
            lengths.extend(resolved.parameters.iter().map(|&(slot, _)| (slot, value)));
        }
        for (coordinate, offset) in self.tolerances.iter().zip(offsets) {
            coordinate.shift(&self.model, &mut shape, *offset);
        }
        let shapes = self.specimen.both_sides(&self.model, shape);
        self.changes.clear();
        self.tolerance_changes.clear();
        self.specimen.reshape(&shapes, &constants, &lengths).map_err(Obstacle::State)
    }

    /// Goes to a state.
    pub fn go_to(&mut self, target: &Target) -> Result<(), Obstacle> {
        let moved = self.specimen.go_to(target);
        moved.map(|_| ()).map_err(|stop| Obstacle::Stopped(Box::new(stop)))
    }

    /// The poses at the state.
    pub fn poses(&mut self) -> Vec<Pose<f64>> {
        self.specimen.measure_compliance(self.compliance);
        self.specimen.poses()
    }

    /// What the state has, with derivatives.
    pub fn reached(&mut self) -> Result<Reached, Obstacle> {
        let Self {
            specimen,
            model,
            parameters,
            signs,
            resolved,
            constants,
            compliance,
            changes,
            ..
        } = self;
        let mut varied = specimen.vary(constants, *compliance).map_err(Obstacle::State)?;
        if changes.is_empty() {
            let parts = parameters.iter().zip(&*resolved).zip(&*signs);
            let mut found = vec![];
            for ((parameter, resolved), sign) in parts {
                let change = resolved.change(parameter, model, &mut varied, constants);
                found.push(change.map_err(Obstacle::Derivative)?.times(*sign));
            }
            *changes = found;
        }
        let by = changes.iter().map(|change| varied.moved(change)).collect::<Result<_, _>>();
        Ok(Reached { by: by.map_err(Obstacle::Derivative)? })
    }

    /// The same by the coordinates that have tolerances.
    pub fn tolerances(&mut self) -> Result<Reached, Obstacle> {
        let Self { specimen, model, tolerances, compliance, tolerance_changes: changes, .. } = self;
        let mut varied = specimen.vary(&[], *compliance).map_err(Obstacle::State)?;
        if changes.is_empty() {
            let moves = |p: &Parameter| Resolved::default().change(p, model, &mut varied, &[]);
            let found: Result<Vec<Change>, _> = tolerances.iter().map(moves).collect();
            *changes = found.map_err(Obstacle::Derivative)?;
        }
        let by = changes.iter().map(|change| varied.moved(change)).collect::<Result<_, _>>();
        Ok(Reached { by: by.map_err(Obstacle::Derivative)? })
    }

    /// A point of the model and a body of its architecture, as the specimen numbers them on the side of the model.
    pub fn end(&self, (point, body): (PointId, BodyId)) -> (PointId, BodyId) {
        let mechanism = self.specimen.stand().mechanism();
        let (name, side) = (&self.model.points()[point.index()].name, self.model.side.name());
        let point_named = |name: &str| mechanism.points().iter().position(|p| p.name == *name);
        let body_named = |name: &str| mechanism.bodies().iter().position(|b| b.name == *name);
        let architecture = &self.model.architecture;
        let body_name = match body.index().checked_sub(1) {
            None => architecture.ground(),
            Some(index) => &architecture.bodies()[index].name,
        };
        let found_point = point_named(name).or_else(|| point_named(&format!("{side}_{name}")));
        let found_body =
            body_named(body_name).or_else(|| body_named(&format!("{side}_{body_name}")));
        let point = found_point.map_or(point, PointId);
        (point, found_body.map_or(body, BodyId))
    }
}

impl Moved {
    /// The distance vector of two points.
    pub(super) fn ends(&self, ends: [(PointId, BodyId); 2]) -> [Vector<Dual>; 2] {
        ends.map(|end| self.point(end))
    }
}
