//! How the static state of a model changes with the model: adjusters go where its targets have their values again.

use super::adjust::Home;
use super::pose::Pose;
use super::shape::Origins;
use super::stand::Stand;
use super::station::Station;
use super::variable::VaryError;
use super::varied::Varied;
use crate::assembly::ElementConstant;
use crate::factors::{Convention, Factor};
use crate::mechanism::{DriverId, Owner};
use crate::model::Model;
use crate::scalar::Dual;
use crate::solve::sensitivity::{Change, SensitivityError};

/// A mechanism in its static state.
pub struct Settled {
    stand: Stand,
    stations: Vec<Station>,
    origins: Origins,
    goals: Vec<SettledGoal>,
}

/// A factor that an adjuster sets.
#[derive(Clone)]
pub(super) struct SettledGoal {
    /// The wheel, left first in an axle.
    pub wheel: usize,
    pub factor: &'static Factor,
    /// The adjuster.
    pub driver: DriverId,
}

impl Settled {
    pub(super) fn new(
        stand: Stand,
        stations: Vec<Station>,
        models: &[&Model],
        goals: Vec<SettledGoal>,
    ) -> Self {
        let homes = vec![None; models.len()];
        let origins = Origins::of(stand.mechanism(), models, &homes);
        Self { stand, stations, origins, goals }
    }

    /// The mechanism.
    pub fn stand(&self) -> &Stand {
        &self.stand
    }

    /// The wheel, left first in an axle, and the name of each factor that an adjuster sets.
    pub fn goals(&self) -> impl Iterator<Item = (usize, &'static str)> {
        self.goals.iter().map(|goal| (goal.wheel, goal.factor.name))
    }

    /// The value of a force element of this mechanism that one of another mechanism of the same model is.
    fn value(&self, other: &Stand, value: usize) -> Option<usize> {
        let elements = other.system().expansion().elements();
        let mut instances = elements.iter().map(|element| &element.instance);
        let owner = instances.find(|instance| instance.equations.contains(&value))?.owner;
        let Owner::Force(force) = owner else { return None };
        let name = &other.mechanism().forces()[force.index()].name;
        let here = Owner::Force(self.stand.mechanism().force_named(name)?);
        let values = |stand: &Stand, owner: Owner| -> Vec<usize> {
            let elements = stand.system().expansion().elements().iter();
            let own = elements.filter(|element| element.instance.owner == owner);
            own.flat_map(|element| element.instance.equations.clone()).collect()
        };
        let k = values(other, owner).iter().position(|&other| other == value)?;
        values(&self.stand, here).get(k).copied()
    }

    /// Prepares to say how the state changes, with the constants of force elements of another mechanism of the same
    /// model.
    pub(super) fn vary(
        &mut self,
        other: &Stand,
        constants: &[ElementConstant],
    ) -> Result<Settling<'_>, VaryError> {
        let here = |constant: &ElementConstant| {
            let value =
                self.value(other, constant.value).expect("both have the forces of the model");
            ElementConstant { value, ..*constant }
        };
        let constants: Vec<ElementConstant> = constants.iter().map(here).collect();
        let Self { stand, stations, origins, goals } = self;
        let by_name = |driver: DriverId| {
            let name = &stand.mechanism().drivers()[driver.index()].name;
            let drivers = other.mechanism().drivers();
            drivers.iter().position(|driver| driver.name == *name)
        };
        let number = |driver| by_name(driver).expect("both have the adjusters of the model");
        let numbers: Vec<usize> = goals.iter().map(|goal| number(goal.driver)).collect();
        let drivers = other.mechanism().driver_ids();
        let drivers: Vec<DriverId> = drivers.collect();
        let ways = numbers.into_iter().map(|number| drivers[number]).collect();
        let of_driver = |driver: DriverId| {
            let name = stand.mechanism().drivers()[driver.index()].name.clone();
            (name, stand.driver_value(driver))
        };
        let settings = stand.mechanism().driver_ids().map(of_driver).collect();
        let varied = Varied::of(stand, stations, origins, &constants, false, None)?;
        let mut settling =
            Settling { varied, goals, drivers: ways, settings, inverse: vec![], homes: vec![] };
        settling.find_adjusters()?;
        Ok(settling)
    }
}

/// A static state, ready to say how it changes.
pub(super) struct Settling<'a> {
    pub varied: Varied<'a>,
    goals: &'a [SettledGoal],
    /// The adjusters of the goals in the mechanism on the rig.
    pub drivers: Vec<DriverId>,
    /// The values (m or rad) of all drivers by their names.
    settings: Vec<(String, f64)>,
    /// The inverse of the derivatives of the goals (rows) by their adjusters (columns), row by row.
    inverse: Vec<f64>,
    /// The derivatives of the static places by each adjuster.
    homes: Vec<Vec<f64>>,
}

/// How a static state changes.
pub(super) struct SettledChange {
    /// How far (m) the adjuster of each goal goes.
    pub ways: Vec<f64>,
    /// The changes of the numbers of all [`Home`]s, one after the other.
    pub homes: Vec<f64>,
}

impl Settling<'_> {
    fn find_adjusters(&mut self) -> Result<(), VaryError> {
        let count = self.goals.len();
        let mut slopes = vec![0.0; count * count];
        for column in 0..count {
            let mut change = self.varied.no_change();
            self.varied.drive(self.goals[column].driver, 1.0, &mut change);
            let poses = self.varied.poses(&change).map_err(|_| VaryError::Singular)?;
            for (row, by) in self.derivatives(&poses).into_iter().enumerate() {
                slopes[row * count + column] = by;
            }
            self.homes.push(homes(&poses));
        }
        self.inverse = crate::solve::sensitivity::inverse(&slopes, count)?;
        Ok(())
    }

    /// The value (m or rad) of a driver.
    pub fn setting(&self, name: &str) -> Option<f64> {
        self.settings.iter().find(|(known, _)| known == name).map(|(_, value)| *value)
    }

    /// The derivatives of the goals along a change.
    fn derivatives(&self, poses: &[Pose<Dual>]) -> Vec<f64> {
        let by = |goal: &SettledGoal| {
            let value = (goal.factor.by(Convention::Iso).value.dual)(&poses[goal.wheel]);
            value.map_or(0.0, |value| value.derivative)
        };
        self.goals.iter().map(by).collect()
    }

    /// How the state changes with a change of the mechanism and of the values that the goals have.
    ///
    /// # Errors
    /// [`SensitivityError`].
    pub fn settle(
        &mut self,
        change: &Change,
        wanted: &[f64],
    ) -> Result<SettledChange, SensitivityError> {
        let poses = self.varied.poses(change)?;
        let moved = self.derivatives(&poses);
        let missing: Vec<f64> = (0..moved.len())
            .map(|goal| wanted.get(goal).copied().unwrap_or(0.0) - moved[goal])
            .collect();
        let row = |k: usize| &self.inverse[k * missing.len()..][..missing.len()];
        let way = |k: usize| row(k).iter().zip(&missing).map(|(a, b)| a * b).sum();
        let ways: Vec<f64> = (0..missing.len()).map(way).collect();
        let mut homes = homes(&poses);
        for (way, by) in ways.iter().zip(&self.homes) {
            for (home, by) in homes.iter_mut().zip(by) {
                *home += way * by;
            }
        }
        Ok(SettledChange { ways, homes })
    }
}

/// The changes of the static places of poses.
fn homes(poses: &[Pose<Dual>]) -> Vec<f64> {
    let mut numbers = vec![];
    for pose in poses {
        numbers.extend(Home::of(pose).numbers_mut().map(|number| number.derivative));
    }
    numbers
}
