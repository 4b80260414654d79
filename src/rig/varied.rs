//! How the poses of a stand change with what its model is made of.

mod moved;
mod seeds;

pub use moved::Moved;

use super::adjust::Home;
use super::pose::{OtherWheel, Pose, WheelCompliance};
use super::settled::{Settled, SettledChange, Settling};
use super::shape::{Origins, Shape};
use super::stand::Stand;
use super::station::Station;
use super::variable::{VaryError, both_sides};
use super::view::View;
use crate::assembly::ElementConstant;
use crate::mechanism::{Body, Direction, DriverId, DriverSlots, Expansion, Owner};
use crate::model::Model;
use crate::relation::BODY_COORDINATES;
use crate::scalar::{Dual, Scalar};
use crate::solve::Twist;
use crate::solve::compliance::WRENCH;
use crate::solve::sensitivity::{Change, Frame, Question, Response, Sensitivity, SensitivityError};
use crate::vector::Vector;

/// A stand at one state, ready to say how its poses change. The stand cannot change meanwhile.
pub struct Varied<'a> {
    frame: Frame<'a>,
    sensitivity: &'a mut Sensitivity,
    stations: &'a [Station],
    origins: &'a Origins,
    expansion: &'a Expansion,
    bodies: &'a [Body],
    drivers: Vec<Dual>,
    question: Question,
    /// The adjusters whose directions move with points.
    directed: Vec<Directed>,
    settling: Option<Box<Settling<'a>>>,
}

/// An adjuster whose direction lies between points.
struct Directed {
    /// How far (m) it is from where all points are as they are given.
    value: f64,
    along: Direction,
    /// The first ones of the three parameters of each place that it moves.
    places: Vec<usize>,
}

impl Directed {
    /// Those of a stand, which counts its drivers from the static state where there is one.
    fn of(stand: &Stand, settling: Option<&Settling<'_>>) -> Vec<Self> {
        let directed = stand.system().expansion().directed_adjusters(stand.mechanism());
        let directed = directed.into_iter().map(|(driver, along, places)| {
            let name = &stand.mechanism().drivers()[driver.index()].name;
            let settled = settling.and_then(|settling| settling.setting(name));
            Self { value: stand.driver_value(driver) + settled.unwrap_or(0.0), along, places }
        });
        directed.collect()
    }
}

/// What changes in a model, per unit of a parameter (SI).
#[derive(Clone, Debug, Default)]
pub struct Cause {
    /// The shapes of all sides, left first, with their derivatives.
    pub shapes: Vec<Shape<Dual>>,
    /// The constants that the state was asked about.
    pub constants: Vec<f64>,
    /// Parameters of relations.
    pub parameters: Vec<(usize, f64)>,
    /// The same in the mechanism of the static state.
    pub settled_parameters: Vec<(usize, f64)>,
    /// What the goals of the static state have to be.
    pub wanted: Vec<f64>,
    /// The travels of all wheels in the static state.
    pub travels: Vec<f64>,
}

impl<'a> Varied<'a> {
    /// The state of a stand that is in equilibrium or has no forces.
    pub(super) fn of(
        stand: &'a mut Stand,
        stations: &'a [Station],
        origins: &'a Origins,
        constants: &[ElementConstant],
        measures_compliance: bool,
        settled: Option<&'a mut Settled>,
    ) -> Result<Self, VaryError> {
        if !stations.iter().all(Station::is_held) {
            return Err(VaryError::Free);
        }
        let settling = settled.map(|settled| settled.vary(stand, constants)).transpose()?;
        let homes = stations.iter().filter_map(Station::home::<f64>);
        let others = homes.map(|mut home| home.numbers_mut().count()).sum();
        let mut drivers: Vec<DriverId> = stations.iter().map(|station| station.travel).collect();
        drivers.extend(stations.first().and_then(|station| station.rack));
        let by_force: Vec<DriverId> = stand.by_force().to_vec();
        let wheels = stations.iter().map(|station| (station.wheel.body, station.wheel.center));
        let equation = |driver: DriverId| stand.equilibrium().equation_of(driver);
        let by_force = by_force.into_iter().map(|driver| (driver, equation(driver))).collect();
        let question = match measures_compliance {
            true => Question {
                others,
                by_force,
                let_go: stations.iter().map(|station| equation(station.travel)).collect(),
                points: wheels.collect(),
                drivers,
                constants: constants.to_vec(),
            },
            false => {
                let constants = constants.to_vec();
                Question { others, by_force, drivers, constants, ..Question::default() }
            }
        };
        let directed = Directed::of(stand, settling.as_ref());
        let values = stand.equilibrium().driver_values().iter();
        let drivers = values.map(|&value| Dual::from_f64(value)).collect();
        let parts = stand.vary()?;
        let (mut frame, sensitivity) = (parts.frame, parts.sensitivity);
        sensitivity.ask(&mut frame, &question, parts.positions)?;
        let (expansion, bodies) = (parts.expansion, parts.bodies);
        let settling = settling.map(Box::new);
        Ok(Self {
            frame,
            sensitivity,
            stations,
            origins,
            expansion,
            bodies,
            drivers,
            question,
            directed,
            settling,
        })
    }

    /// As [`Variable::reshape`].
    pub(super) fn reshape(
        stand: &mut Stand,
        stations: &[Station],
        origins: &Origins,
        shapes: &[Shape<f64>],
        constants: &[(ElementConstant, f64)],
        lengths: &[(usize, f64)],
    ) -> Result<(), VaryError> {
        if stations.iter().any(|station| station.home::<f64>().is_some()) {
            return Err(VaryError::Adjusted);
        }
        let laws = stand.equilibrium_mut().elements_mut().laws_mut();
        for (constant, value) in constants {
            laws[constant.value].set_constant(constant.constant, *value);
        }
        stand.reshape(&origins.positions(shapes), lengths);
        Ok(())
    }

    /// As [`Variable::both_sides`].
    pub fn both_sides<S: Scalar>(&self, model: &Model, shape: Shape<S>) -> Vec<Shape<S>> {
        both_sides(self.stations.len(), model, shape)
    }

    /// What changes in the state when something does in the model. Adjusters and the static state follow.
    ///
    /// # Errors
    /// [`SensitivityError`] where the static state does not go with it.
    pub fn change_by(&mut self, cause: &Cause) -> Result<Change, SensitivityError> {
        let Some(mut settling) = self.settling.take() else {
            return Ok(self.change_from(cause, &self.homes(&[])));
        };
        let mut at_rest = settling.varied.change(&cause.shapes);
        at_rest.constants.copy_from_slice(&cause.constants);
        for &(slot, factor) in &cause.settled_parameters {
            at_rest.h[slot] += factor;
        }
        for (station, &travel) in settling.varied.stations.iter().zip(&cause.travels) {
            settling.varied.drive(station.travel, travel, &mut at_rest);
        }
        let settled = settling.settle(&at_rest, &cause.wanted);
        let drivers = settling.drivers.clone();
        self.settling = Some(settling);
        let SettledChange { ways, homes } = settled?;
        let mut change = self.change_from(cause, &self.homes(&homes));
        for (driver, way) in drivers.into_iter().zip(ways) {
            self.drive(driver, way, &mut change);
        }
        for (station, &travel) in self.stations.iter().zip(&cause.travels) {
            self.drive(station.travel, travel, &mut change);
        }
        change.others = homes;
        Ok(change)
    }

    /// What changes without the adjusters that a static state moves.
    fn change_from(&self, cause: &Cause, homes: &[Option<Home<Dual>>]) -> Change {
        let mut change = self.change_of(&self.origins.positions_from(&cause.shapes, homes));
        change.constants.copy_from_slice(&cause.constants);
        for &(slot, factor) in &cause.parameters {
            change.h[slot] += factor;
        }
        change
    }

    /// Adds what changes when a driver goes so far.
    pub(super) fn drive(&self, driver: DriverId, way: f64, change: &mut Change) {
        self.slots().add([(driver, way)], &mut change.h);
    }

    /// The static states of the sides, with the changes of their numbers, or none.
    fn homes(&self, changes: &[f64]) -> Vec<Option<Home<Dual>>> {
        let mut changes = changes.iter();
        let moving = |station: &Station| {
            let mut home: Home<Dual> = station.home()?;
            for number in home.numbers_mut() {
                number.derivative = changes.next().copied().unwrap_or(0.0);
            }
            Some(home)
        };
        self.stations.iter().map(moving).collect()
    }

    /// What changes when the shapes of the sides do, each being that of its model with derivatives. Sides are
    /// in the order of the vehicle, left first. A static state stays.
    pub fn change(&self, shapes: &[Shape<Dual>]) -> Change {
        self.change_of(&self.origins.positions(shapes))
    }

    /// What changes with the design positions of points.
    fn change_of(&self, points: &[Vector<Dual>]) -> Change {
        let mut h: Vec<Dual> = self.expansion.parameters(points);
        for Directed { value, along, places } in &self.directed {
            let along = along.at(points);
            for place in places {
                for (h, along) in h[*place..].iter_mut().zip(along) {
                    h.derivative += value * along.derivative;
                }
            }
        }
        Change {
            h: h.into_iter().map(|h| h.derivative).collect(),
            constants: vec![0.0; self.question.constants.len()],
            points: points.iter().map(|point| point.map(|x| x.derivative)).collect(),
            others: vec![0.0; self.question.others],
        }
    }

    /// No change.
    pub fn no_change(&self) -> Change {
        Change {
            h: vec![0.0; self.expansion.parameter_count()],
            constants: vec![0.0; self.question.constants.len()],
            points: vec![[0.0; 3]; self.origins.len()],
            others: vec![0.0; self.question.others],
        }
    }

    /// The poses with their derivatives along a change.
    ///
    /// # Errors
    /// [`SensitivityError`].
    pub fn poses(&mut self, change: &Change) -> Result<Vec<Pose<Dual>>, SensitivityError> {
        let response = self.sensitivity.response(&mut self.frame, change)?;
        Ok(self.poses_of(&response))
    }

    /// The poses and all bodies with their derivatives along a change.
    ///
    /// # Errors
    /// [`SensitivityError`].
    pub fn moved(&mut self, change: &Change) -> Result<Moved, SensitivityError> {
        let response = self.sensitivity.response(&mut self.frame, change)?;
        let poses = self.poses_of(&response);
        Ok(Moved::new(poses, response, self.bodies))
    }

    /// Whether the equations that are left out as redundant go with a change.
    ///
    /// # Errors
    /// [`SensitivityError::Redundant`] where one does not.
    pub fn check(&self, change: &Change) -> Result<(), SensitivityError> {
        self.sensitivity.check(&self.frame, change)
    }

    /// An equation of the joints in words.
    pub fn label(&self, equation: usize) -> &str {
        self.expansion.label(equation)
    }

    fn equation(&self, driver: DriverId) -> usize {
        let owner = Owner::Driver(driver);
        self.expansion.equations_of(owner).next().expect("a travel has an equation")
    }

    fn slots(&self) -> &DriverSlots {
        self.expansion.driver_slots()
    }

    /// The poses of a response.
    fn poses_of(&self, response: &Response) -> Vec<Pose<Dual>> {
        let mut drivers = self.drivers.clone();
        for ((driver, _), way) in self.question.by_force.iter().zip(&response.ways) {
            drivers[driver.index()].derivative = way.derivative;
        }
        let view = View {
            bodies: self.bodies,
            points: &response.points,
            state: &response.state,
            h: &response.h,
            drivers: &drivers,
        };
        let tangent = |driver: DriverId| {
            let k = self.question.drivers.iter().position(|&asked| asked == driver)?;
            Some(&response.tangents[k])
        };
        let changes: Vec<f64> = response.others.iter().map(|other| other.derivative).collect();
        let homes = self.homes(&changes);
        let compliance = self.compliance(response, &view);
        let pose = |(wheel, station): (usize, &Station)| {
            let equation = self.equation(station.travel);
            let multiplier = self.frame.multiplier(equation);
            let force = multiplier.map(|_| -response.lambda[equation]);
            let mut pose = station.loaded_pose(&view, homes[wheel].as_ref(), force);
            pose.motions = station
                .motions_by(|driver| station.motion(driver, &view, tangent(driver)?, self.slots()));
            if let (Some(load), Some(row)) = (&mut pose.load, multiplier) {
                load.rate = tangent(station.travel).map(|tangent| -tangent[row]);
            }
            pose.compliance = compliance.as_ref().map(|matrix| {
                let zero = Dual::from_f64(0.0);
                WheelCompliance::of_wheel(wheel, self.stations.len(), matrix, zero)
            });
            pose
        };
        let mut poses: Vec<Pose<Dual>> = self.stations.iter().enumerate().map(pose).collect();
        if let [left, right] = &mut poses[..] {
            let [on_left, on_right]: [OtherWheel<Dual>; 2] = [left.as_other(), right.as_other()];
            (left.other, right.other) = (Some(on_right), Some(on_left));
        }
        poses
    }

    /// The compliance matrix, row by row, where it was asked for.
    fn compliance(&self, response: &Response, view: &View<'_, Dual>) -> Option<Vec<Dual>> {
        let Question { drivers, points, .. } = &self.question;
        if points.is_empty() {
            return None;
        }
        let order = WRENCH * points.len();
        let mut matrix = vec![Dual::from_f64(0.0); order * order];
        for (column, tangent) in response.tangents[drivers.len()..].iter().enumerate() {
            for (wheel, &(body, point)) in points.iter().enumerate() {
                let first = BODY_COORDINATES * (body.index() - 1);
                let rates = &tangent[first..first + BODY_COORDINATES];
                let twist = Twist::new(&view.state[body.index()], rates);
                let moved = twist.at(view.point((point, body)));
                for (i, moved) in moved.into_iter().chain(twist.rotation).enumerate() {
                    matrix[(WRENCH * wheel + i) * order + column] = moved;
                }
            }
        }
        Some(matrix)
    }
}
