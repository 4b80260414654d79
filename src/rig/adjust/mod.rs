//! The static state that a model asks for: ride height and adjusters, from which the rig starts.
//!
//! The wheels are held at the ride height without any load of the rig, and the adjusters are set until the
//! factors of the model's `[static]` have their values: with all forces, or with joints alone where the
//! setup is kinematic.

mod error;
mod newton;

pub use error::{AdjustError, OutOfReach};

use super::corner::RigError;
use super::line::{Line, Wheel};
use super::pose::Pose;
use super::settled::Settled;
use super::stand::Stand;
use super::station::Station;
use crate::mechanism::DriverId;
use crate::model::{AxleSuspension, Chassis, Model, Setup, Side, WheelSupport};
use crate::scalar::Scalar;
use crate::vector::{Vector, add, constant, dot, sub};
use newton::{Adjustable, Search};

/// Where the parts of a corner are in its static state: what changes are counted from instead of the
/// design position.
#[derive(Clone, Copy, Debug)]
pub(super) struct Home<S> {
    pub wheel: Wheel<S>,
    /// The rotation of the wheel's body from the design position.
    pub rotation: [[S; 3]; 3],
    pub spring: Option<Line<S>>,
    pub damper: Option<Line<S>>,
}

impl Home<f64> {
    /// The same on another scalar, at rest.
    pub fn lifted<S: Scalar>(&self) -> Home<S> {
        Home {
            wheel: self.wheel.lifted(),
            rotation: self.rotation.map(constant),
            spring: self.spring.map(|line| line.lifted()),
            damper: self.damper.map(|line| line.lifted()),
        }
    }
}

impl<S: Scalar> Home<S> {
    pub fn of(pose: &Pose<S>) -> Self {
        let Pose { wheel, rotation, spring, damper, .. } = *pose;
        Self { wheel, rotation, spring, damper }
    }

    /// The point of the wheel's body that is the contact patch here, at the design position of the body,
    /// where the wheel centre is at `center`.
    pub fn patch(&self, center: Vector<S>) -> Vector<S> {
        let arm = sub(self.wheel.contact_patch(), self.wheel.center);
        let column = |k: usize| dot(self.rotation.map(|row| row[k]), arm);
        add(center, [column(0), column(1), column(2)])
    }

    /// All numbers that can vary, in an order of their own.
    pub fn numbers_mut(&mut self) -> impl Iterator<Item = &mut S> {
        let Self { wheel: Wheel { center, spin, .. }, rotation, spring, damper } = self;
        let lines = spring.iter_mut().chain(damper);
        let ends = lines.flat_map(|Line { from, to }| from.iter_mut().chain(to));
        center.iter_mut().chain(spin).chain(rotation.as_flattened_mut()).chain(ends)
    }
}

/// What one adjuster is set to, or the ride height.
#[derive(Clone, Debug, PartialEq)]
pub struct Adjustment {
    /// The name of the adjuster, `ride_height` of the ride height; of an axle with the side before it.
    pub name: String,
    /// The side of the vehicle.
    pub side: Side,
    /// What it changes, in words.
    pub title: String,
    /// What a positive value means.
    pub sign: String,
    /// The value (m).
    pub value: f64,
    /// The factor that it sets, where it does.
    pub sets: Option<&'static str>,
}

/// One side of a vehicle in its static state.
pub(super) struct Set {
    pub home: Home<f64>,
    pub adjustments: Vec<Adjustment>,
    values: Vec<f64>,
    travel: f64,
}

impl Set {
    /// The values of the adjusters and the travel, by their drivers.
    pub fn drivers(&self, adjusters: &[DriverId], travel: DriverId) -> Vec<(DriverId, f64)> {
        let values = self.values.iter().copied();
        adjusters.iter().copied().zip(values).chain([(travel, self.travel)]).collect()
    }

    fn new(model: &Model, values: &[f64], pose: &Pose<f64>) -> Self {
        let state = model.static_state();
        let adjustment = |(index, value): (usize, &f64)| {
            let adjuster = &model.adjusters()[index];
            let target = state.targets.iter().find(|target| target.by == index);
            Adjustment {
                name: adjuster.name.clone(),
                side: model.side,
                title: adjuster.title.clone(),
                sign: adjuster.sign.clone(),
                value: *value,
                sets: target.map(|target| target.factor),
            }
        };
        let ride_height = (state.ride_height != 0.0).then(|| Adjustment {
            name: "ride_height".to_owned(),
            side: model.side,
            title: "height of the chassis above the wheel".to_owned(),
            sign: "+ chassis higher".to_owned(),
            value: state.ride_height,
            sets: None,
        });
        let adjustments = values.iter().enumerate().map(adjustment).chain(ride_height).collect();
        let travel = -state.ride_height;
        Self { home: Home::of(pose), adjustments, values: values.to_vec(), travel }
    }
}

/// A wheel that the rig holds, the chassis fixed, as the static state is.
fn held(setup: &Setup) -> Setup {
    Setup { support: WheelSupport::Held, chassis: Chassis::Fixed, ..*setup }
}

/// The static state of a corner; `None` where the model asks for none.
pub(super) fn corner(model: &Model, setup: &Setup) -> Result<Option<(Set, Settled)>, RigError> {
    if !model.is_adjusted() {
        return Ok(None);
    }
    let setup = held(setup);
    let suspension = model.suspension(&setup)?;
    let stand = Stand::new(suspension.mechanism.clone(), &[], model.axes)?;
    let station = Station::of_corner(&suspension, model, &setup).on(&stand, None);
    let wheel = Adjustable { model, station, adjusters: suspension.adjusters, prefix: "" };
    let mut search = Search::new(stand, vec![wheel]);
    search.run()?;
    let (values, pose) = search.wheel(0);
    Ok(Some((Set::new(model, values, &pose), search.settled(&[model]))))
}

/// The static states of both sides of an axle; `None` where no model asks for one.
pub(super) fn axle(
    models: [&Model; 2],
    setup: &Setup,
    suspension: impl FnOnce(&Setup) -> Result<AxleSuspension, RigError>,
) -> Result<Option<([Set; 2], Settled)>, RigError> {
    if !models.iter().any(|model| model.is_adjusted()) {
        return Ok(None);
    }
    let setup = held(setup);
    let suspension = suspension(&setup)?;
    let [left, right] = models;
    let stand = Stand::new(suspension.mechanism.clone(), &[], left.axes)?;
    let station =
        |model: &Model| Station::of_axle(&suspension, model.side, model, &setup).on(&stand, None);
    let [first, second] = models.map(station);
    let [on_left, on_right] = suspension.adjusters;
    let wheels = vec![
        Adjustable { model: left, station: first, adjusters: on_left, prefix: "left " },
        Adjustable { model: right, station: second, adjusters: on_right, prefix: "right " },
    ];
    let mut search = Search::new(stand, wheels);
    search.run()?;
    let set = |k: usize| {
        let (values, pose) = search.wheel(k);
        let mut set = Set::new(models[k], values, &pose);
        for adjustment in &mut set.adjustments {
            adjustment.name = format!("{}_{}", models[k].side.name(), adjustment.name);
        }
        set
    };
    Ok(Some(([set(0), set(1)], search.settled(&models))))
}
