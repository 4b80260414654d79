//! From a model to the mechanism that the solver knows.

use super::{Model, SpinAxis, SteerAxis};
use crate::mechanism::{
    BodyId, Direction, DriverId, DriverKind, JointKind, Mechanism, MechanismError, PointId,
};

/// Which height the travel driver prescribes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drive {
    /// Height of the wheel centre, as Adams/Car does.
    #[default]
    WheelCenter,
    /// Height of the contact patch, the lowest point of the tyre's disc, as Lotus does.
    ContactPatch,
}

impl Drive {
    /// The name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::WheelCenter => "wheel-center",
            Self::ContactPatch => "contact-patch",
        }
    }
}

/// A mechanism together with what makes it a suspension, in SI units and ISO 8855 axes.
#[derive(Clone, Debug)]
pub struct Suspension {
    /// Bodies, joints and drivers.
    pub mechanism: Mechanism,
    /// The wheel.
    pub wheel: Wheel,
    /// The steer axis through two joints, where the architecture has one.
    pub steer_axis: Option<SteerAxis>,
    /// Displacement of the rack (m), positive along the y axis of the model's own axes;
    /// `None` for a suspension that does not steer.
    pub rack: Option<DriverId>,
    /// Change of the height of the wheel (m), positive in jounce in every axis system.
    pub travel: DriverId,
    /// Which height [`Suspension::travel`] prescribes.
    pub drive: Drive,
}

/// The wheel of a suspension. Its spin is locked to the body that carries it.
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    /// The body that carries the wheel.
    pub body: BodyId,
    /// The wheel centre.
    pub center: PointId,
    /// The spin axis pointing outboard, fixed in the body.
    pub spin: Direction,
    /// The unit vector of `spin` at the design position.
    pub spin_axis: [f64; 3],
    /// Rolling radius of the tyre (m).
    pub radius: f64,
}

impl Model {
    /// The mechanism of this model at its design position.
    ///
    /// # Errors
    /// [`MechanismError`] where the geometry has no meaning. A model straight
    /// from a file has been checked; one whose points were moved may fail.
    pub fn suspension(&self, drive: Drive) -> Result<Suspension, MechanismError> {
        let architecture = &self.architecture;
        let mut mechanism = Mechanism::new(&architecture.ground);
        // The joints of the architecture number points and bodies in this order.
        for point in &self.points {
            mechanism.add_point(&point.name, point.position)?;
        }
        for (index, body) in architecture.bodies.iter().enumerate() {
            mechanism.add_body(&body.name, self.body_origin(BodyId(index + 1)))?;
        }
        for joint in &architecture.joints {
            mechanism.add_joint(&joint.name, joint.i, joint.j, joint.kind)?;
        }
        let rack = self.add_rack_driver(&mut mechanism)?;
        let wheel = Wheel {
            body: architecture.wheel.body,
            center: architecture.wheel.center,
            spin: self.spin_direction(),
            spin_axis: self.spin_axis(),
            radius: self.wheel_radius,
        };
        let kind = match drive {
            Drive::WheelCenter => DriverKind::Height { at: wheel.center },
            Drive::ContactPatch => DriverKind::PatchHeight {
                center: wheel.center,
                spin: wheel.spin,
                radius: wheel.radius,
            },
        };
        let travel = mechanism.add_driver("travel", BodyId::GROUND, wheel.body, kind)?;
        Ok(Suspension {
            mechanism,
            wheel,
            steer_axis: architecture.steer_axis,
            rack,
            travel,
            drive,
        })
    }

    /// The mean of the points at which a body is held. It is a constant of the
    /// mechanism: it does not follow when a point moves.
    fn body_origin(&self, body: BodyId) -> [f64; 3] {
        let mut points = self.architecture.joint_points(body);
        if body == self.architecture.wheel.body {
            points.push(self.architecture.wheel.center);
            points.sort_unstable();
            points.dedup();
        }
        let sum = points.iter().fold([0.0; 3], |sum, point| {
            let position = self.points[point.0].position;
            std::array::from_fn(|i| sum[i] + position[i])
        });
        #[allow(clippy::cast_precision_loss)] // A body has a handful of points.
        let number = points.len() as f64;
        sum.map(|sum| sum / number)
    }

    fn add_rack_driver(
        &self,
        mechanism: &mut Mechanism,
    ) -> Result<Option<DriverId>, MechanismError> {
        let Some(index) = self.architecture.rack else {
            return Ok(None);
        };
        let joint = &self.architecture.joints[index];
        let JointKind::Translational { at, .. } = joint.kind else {
            return Ok(None);
        };
        let along = Direction::Fixed(self.axes.to_iso([0.0, 1.0, 0.0]));
        let kind = DriverKind::Displacement { at, along };
        mechanism.add_driver("rack", joint.i, joint.j, kind).map(Some)
    }

    /// The spin axis as the mechanism knows it: it follows the points that define it.
    fn spin_direction(&self) -> Direction {
        let SpinAxis::Point(name) = &self.spin else {
            return Direction::Fixed(self.spin_axis());
        };
        let center = self.architecture.wheel.center;
        let Some(index) = self.points.iter().position(|point| point.name == *name) else {
            return Direction::Fixed(self.spin_axis());
        };
        let outboard = self.points[index].position[1] - self.points[center.0].position[1];
        if outboard * self.side.sign() < 0.0 {
            Direction::Between(PointId(index), center)
        } else {
            Direction::Between(center, PointId(index))
        }
    }
}
