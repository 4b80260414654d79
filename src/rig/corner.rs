//! A corner on the rig.

use thiserror::Error;

use super::pose::{Axle, Pose, Wheel};
use crate::mechanism::{BodyId, PointId};
use crate::model::{Axes, Model, Setup, Side, Suspension, SuspensionError};
use crate::solve::{FreeMotion, FreedomReport, StepReport, Stop, System, SystemError};
use crate::vector::dot;

/// Why a corner cannot be put on the rig.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RigError {
    /// The model cannot be set up.
    #[error(transparent)]
    Suspension(#[from] SuspensionError),
    /// The mechanism cannot be solved.
    #[error(transparent)]
    System(#[from] SystemError),
}

/// One corner of a vehicle on the rig: the chassis is fixed, the height of the
/// wheel and the rack are driven.
pub struct Corner {
    suspension: Suspension,
    system: System,
    side: Side,
    axes: Axes,
}

impl Corner {
    /// Puts a model on the rig at its design position.
    ///
    /// # Errors
    /// [`RigError`] for geometry without meaning or a wheel that cannot move.
    pub fn new(model: &Model, setup: &Setup) -> Result<Self, RigError> {
        let suspension = model.suspension(setup)?;
        let system = System::new(suspension.mechanism.clone())?;
        Ok(Self { suspension, system, side: model.side, axes: model.axes })
    }

    /// Degrees of freedom, redundant equations and free motions.
    pub fn freedom(&self) -> &FreedomReport {
        self.system.freedom()
    }

    /// The free motions that move the wheel or its steer axis; with one of them their position
    /// is not determined by travel and rack.
    pub fn free_wheel_motions(&self) -> impl Iterator<Item = &FreeMotion> {
        let Suspension { wheel, steer_axis, .. } = &self.suspension;
        let steer_axis = steer_axis.iter().flat_map(|axis| [axis.lower.1, axis.upper.1]);
        let bodies: Vec<BodyId> = steer_axis.chain([wheel.body]).collect();
        let motions = self.freedom().free_motions.iter();
        motions.filter(move |motion| motion.bodies.iter().any(|body| bodies.contains(body)))
    }

    /// The suspension.
    pub fn suspension(&self) -> &Suspension {
        &self.suspension
    }

    /// Whether the suspension has a rack.
    pub fn steers(&self) -> bool {
        self.suspension.rack.is_some()
    }

    /// Moves the wheel to a travel and the rack to a displacement (m, both from the design
    /// position) from where they are. A suspension without a rack ignores `rack`.
    ///
    /// # Errors
    /// [`Stop`] where the mechanism cannot go on. It then stays where it got to.
    pub fn move_to(&mut self, travel: f64, rack: f64) -> Result<StepReport, Stop> {
        if let Some(driver) = self.suspension.rack {
            self.system.set_driver(driver, rack);
        }
        self.system.move_to(&[(self.suspension.travel, travel)])
    }

    /// Returns to the design position.
    pub fn reset(&mut self) {
        self.system.reset();
    }

    /// Where wheel and steer axis are.
    pub fn pose(&self) -> Pose<f64> {
        let wheel = &self.suspension.wheel;
        let rotation = self.system.rotation(wheel.body);
        let spin = wheel.spin_axis;
        let point = |(point, body): (PointId, BodyId)| self.system.point_position(body, point);
        Pose {
            travel: self.system.driver_value(self.suspension.travel),
            rack: self.suspension.rack.map_or(0.0, |rack| self.system.driver_value(rack)),
            wheel: Wheel {
                center: point((wheel.center, wheel.body)),
                spin: rotation.map(|row| dot(row, spin)),
                radius: wheel.radius,
            },
            rotation,
            steer_axis: self
                .suspension
                .steer_axis
                .map(|axis| Axle { lower: point(axis.lower), upper: point(axis.upper) }),
            side: self.side,
            axes: self.axes,
        }
    }
}
