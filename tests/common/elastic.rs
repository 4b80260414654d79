//! Values of factors of an axle, and a vehicle around it.
#![allow(dead_code)] // Every test uses its part.

use hardpoint::factors::{Convention, find};
use hardpoint::model::{Axle as AxleOf, Model, Setup};
use hardpoint::rig::{Axle, Pose};

pub fn value_by(convention: Convention, name: &str, pose: &Pose<f64>) -> f64 {
    let value = find(name).unwrap().value(convention, pose);
    value.unwrap_or_else(|| panic!("{name} is undefined"))
}

pub fn value(name: &str, pose: &Pose<f64>) -> f64 {
    value_by(Convention::Iso, name, pose)
}

/// A vehicle around an axle.
pub fn with_vehicle(mut model: Model, axle: AxleOf) -> Model {
    let vehicle = &mut model.vehicle;
    vehicle.axle = Some(axle);
    vehicle.wheelbase = Some(2.776);
    vehicle.cg_height = Some(0.55);
    (vehicle.brake_share, vehicle.drive_share) = (Some(0.65), Some(0.7));
    (vehicle.mass, vehicle.sprung_mass) = (Some(1600.0), Some(380.0));
    vehicle.unsprung_mass = Some(45.0);
    model
}

/// Both wheels of a model, with what is measured of them.
pub fn poses(model: &Model, setup: &Setup, travel: [f64; 2], rack: f64) -> [Pose<f64>; 2] {
    let mut axle = Axle::new(model, setup).unwrap();
    axle.measure_compliance(true);
    axle.move_to(travel, rack).unwrap();
    axle.rest().unwrap();
    axle.poses()
}
