//! Options that say where the rack is.

use clap::{Args, ValueEnum};
use hardpoint::model::{Model, Steering};

use crate::failure::Failure;
use crate::loads::length;

/// Where the rack is held.
#[derive(Args)]
pub struct SteeringOptions {
    /// Rack displacement that is held, + along the model's +y [default: 0].
    #[arg(long, allow_negative_numbers = true, value_name = "R")]
    rack: Option<f64>,
    /// Steering-wheel angle that is held instead, + to the left; needs `rack_per_turn` in [steering].
    #[arg(long, allow_negative_numbers = true, value_name = "ANGLE", conflicts_with = "rack")]
    steering_wheel: Option<f64>,
}

/// What the values of a steer event are.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SteerBy {
    /// Displacements of the rack.
    Rack,
    /// Angles of the steering wheel.
    Wheel,
}

impl SteeringOptions {
    /// The option that is given.
    pub fn given(&self) -> Option<&'static str> {
        let options = [(self.rack, "--rack"), (self.steering_wheel, "--steering-wheel")];
        options.into_iter().find(|(value, _)| value.is_some()).map(|(_, option)| option)
    }

    /// The displacement of the rack (m).
    pub fn rack(&self, model: &Model) -> Result<f64, Failure> {
        if let Some(option) = self.given().filter(|_| !model.steers()) {
            return Err(Failure::Usage(format!("this suspension has no rack; leave out {option}")));
        }
        let Some(angle) = self.steering_wheel else {
            return length("--rack", self.rack, model.units);
        };
        let rack = model.units.angle.to_radians(angle) * rack_per_radian(model)?;
        length("--steering-wheel", Some(model.units.length.from_metres(rack)), model.units)
    }
}

/// Displacement of the rack (m) per radian of the steering wheel.
pub fn rack_per_radian(model: &Model) -> Result<f64, Failure> {
    let Steering { rack_per_radian, .. } = model.steering.unwrap_or_default();
    rack_per_radian.ok_or_else(|| {
        Failure::Usage(
            "the model does not say how far the steering wheel moves the rack; add `rack_per_turn` to \
             [steering], or steer by the rack"
                .into(),
        )
    })
}
