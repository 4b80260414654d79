//! The chassis of an axle: the ground, or a body that rolls and heaves above the road.

use super::Model;
use super::setup::Chassis;
use crate::mechanism::{
    BodyId, Direction, DriverId, DriverKind, JointKind, Mechanism, MechanismError,
};

/// A chassis that the rig rolls and heaves.
#[derive(Clone, Copy, Debug)]
pub struct Rolling {
    /// The chassis. The origin of its frame lies on the roll axis, so it heaves as the axis does.
    pub body: BodyId,
    /// Change of the height of the roll axis above the road (m), positive up.
    pub heave: DriverId,
    /// Roll angle (rad), positive right-handed about the x axis of the model's own axes.
    pub roll: DriverId,
}

impl Model {
    /// A mechanism without a suspension: the chassis as its ground, or the road and the chassis above it.
    pub(super) fn axle_ground(
        &self,
        chassis: Chassis,
    ) -> Result<(Mechanism, Option<Rolling>), MechanismError> {
        let name = &self.architecture.ground;
        let Chassis::Roll { axis } = chassis else {
            return Ok((Mechanism::new(name), None));
        };
        let mut mechanism = Mechanism::new("road");
        let origin = [0.0, 0.0, axis];
        // Names of files are one word, so no part of a model has these names.
        let at = mechanism.add_point("roll centre", origin)?;
        let carriage = mechanism.add_body("rig carriage", origin)?;
        let body = mechanism.add_body(name, origin)?;
        let up = Direction::Fixed([0.0, 0.0, 1.0]);
        let kind = JointKind::Translational { at, axis: up };
        mechanism.add_joint("rig slide", BodyId::GROUND, carriage, kind)?;
        let forward = Direction::Fixed(self.axes.to_iso([1.0, 0.0, 0.0]));
        let kind = JointKind::Revolute { at, axis: forward };
        mechanism.add_joint("rig bearing", carriage, body, kind)?;
        let kind = DriverKind::Displacement { at, along: up };
        let heave = mechanism.add_driver("heave", BodyId::GROUND, carriage, kind)?;
        let kind = DriverKind::Rotation { axis: forward };
        let roll = mechanism.add_driver("roll", carriage, body, kind)?;
        Ok((mechanism, Some(Rolling { body, heave, roll })))
    }
}
