//! How the poses of a stand change with what its model is made of.

use super::pose::{OtherWheel, Pose, WheelCompliance};
use super::shape::{Origins, Shape};
use super::stand::Stand;
use super::station::Station;
use super::sweep::Specimen;
use super::view::View;
use crate::assembly::ElementConstant;
use crate::mechanism::{Body, BodyId, DriverId, DriverSlots, Expansion, Owner, PointId};
use crate::model::{Model, Side};
use crate::relation::{BODY_COORDINATES, Coordinates};
use crate::scalar::{Dual, Scalar};
use crate::solve::Twist;
use crate::solve::compliance::WRENCH;
use crate::solve::linear::Singular;
use crate::solve::sensitivity::{
    Change, Frame, Gradient, Question, Response, Sensitivity, SensitivityError,
};
use crate::vector::{Vector, add, constant, rotate, sub};

/// Why a state cannot say how it changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VaryError {
    /// The wheel is not held at a travel.
    #[error(
        "sensitivities are those of wheels that the rig holds at a travel; these stand on their tyres"
    )]
    Free,
    /// The model asks for a static state.
    #[error(
        "sensitivities are those of the design position, but [static] or the settings of adjusters put the \
         model elsewhere; leave them out"
    )]
    Adjusted,
    /// There is no equilibrium to start from.
    #[error("the forces are not in balance in this state, so it does not say how it changes")]
    NoEquilibrium,
    /// A dead centre.
    #[error("the state is a dead centre: neighbouring states are not determined")]
    Singular,
}

impl From<Singular> for VaryError {
    fn from(_: Singular) -> Self {
        Self::Singular
    }
}

/// What can be asked how it changes.
pub trait Variable: Specimen {
    /// The mechanism on the rig.
    fn stand(&self) -> &Stand;

    /// Sets whether poses measure how wheels give way to loads.
    fn measure_compliance(&mut self, measures: bool);

    /// The adjusters, one of each side, that one of the model is.
    fn adjusters(&self, adjuster: usize) -> Vec<DriverId>;

    /// The shapes of all sides, left first, that go with one of a model: the other side is the mirror image, or
    /// stays where a file of its own describes it.
    fn both_sides<S: Scalar>(&self, model: &Model, shape: Shape<S>) -> Vec<Shape<S>> {
        both_sides(self.sides(), model, shape)
    }

    /// 1 of a corner, 2 of an axle.
    fn sides(&self) -> usize;

    /// Takes the shapes of other models of the same build for all sides, left first, and returns to the design
    /// position. `constants` are new values of laws, `lengths` those of parameters of force elements. Loads and what
    /// is measured stay.
    ///
    /// # Errors
    /// [`VaryError::Adjusted`] for a model with a static state.
    fn reshape(
        &mut self,
        shapes: &[Shape<f64>],
        constants: &[(ElementConstant, f64)],
        lengths: &[(usize, f64)],
    ) -> Result<(), VaryError>;

    /// The current state, to ask how its poses change with the model and with some constants of force elements.
    ///
    /// # Errors
    /// [`VaryError`].
    fn vary(
        &mut self,
        constants: &[ElementConstant],
        compliance: bool,
    ) -> Result<Varied<'_>, VaryError>;
}

fn both_sides<S: Scalar>(sides: usize, model: &Model, shape: Shape<S>) -> Vec<Shape<S>> {
    if sides < 2 {
        return vec![shape];
    }
    let other = match model.has_other_side() {
        true => Shape::of(&model.other_side()).lifted(),
        false => shape.mirrored(),
    };
    match model.side {
        Side::Left => vec![shape, other],
        Side::Right => vec![other, shape],
    }
}

/// A state with its derivatives along a change.
#[derive(Clone, Debug)]
pub struct Moved {
    /// One of a corner, left and right of an axle.
    pub poses: Vec<Pose<Dual>>,
    state: Vec<Coordinates<Dual>>,
    points: Vec<Vector<Dual>>,
    origins: Vec<[f64; 3]>,
}

impl Moved {
    /// Where a point of a body is (m).
    ///
    /// # Panics
    /// If body or point belong to another mechanism.
    pub fn point(&self, (point, body): (PointId, BodyId)) -> Vector<Dual> {
        let q = &self.state[body.index()];
        let local = sub(self.points[point.index()], constant(self.origins[body.index()]));
        add([q[0], q[1], q[2]], self.turned(body, local))
    }

    /// A direction of a body in the axes of the ground.
    ///
    /// # Panics
    /// If the body belongs to another mechanism.
    pub fn turned(&self, body: BodyId, direction: Vector<Dual>) -> Vector<Dual> {
        let q = &self.state[body.index()];
        rotate([q[3], q[4], q[5], q[6]], direction)
    }

    /// The design position (m) of a point.
    ///
    /// # Panics
    /// If the point belongs to another mechanism.
    pub fn design(&self, point: PointId) -> Vector<Dual> {
        self.points[point.index()]
    }
}

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
}

impl<'a> Varied<'a> {
    /// The state of a stand that is in equilibrium or has no forces.
    pub(super) fn of(
        stand: &'a mut Stand,
        stations: &'a [Station],
        origins: &'a Origins,
        constants: &[ElementConstant],
        measures_compliance: bool,
    ) -> Result<Self, VaryError> {
        if !stations.iter().all(Station::is_held) {
            return Err(VaryError::Free);
        }
        if stations.iter().any(Station::is_adjusted) {
            return Err(VaryError::Adjusted);
        }
        let mut drivers: Vec<DriverId> = stations.iter().map(|station| station.travel).collect();
        drivers.extend(stations.first().and_then(|station| station.rack));
        let by_force: Vec<DriverId> = stand.by_force().to_vec();
        let wheels = stations.iter().map(|station| (station.wheel.body, station.wheel.center));
        let equation = |driver: DriverId| stand.equilibrium().equation_of(driver);
        let by_force = by_force.into_iter().map(|driver| (driver, equation(driver))).collect();
        let question = match measures_compliance {
            true => Question {
                by_force,
                let_go: stations.iter().map(|station| equation(station.travel)).collect(),
                points: wheels.collect(),
                drivers,
                constants: constants.to_vec(),
            },
            false => {
                let constants = constants.to_vec();
                Question { by_force, drivers, constants, ..Question::default() }
            }
        };
        let values = stand.equilibrium().driver_values().iter();
        let drivers = values.map(|&value| Dual::from_f64(value)).collect();
        let parts = stand.vary()?;
        let (mut frame, sensitivity) = (parts.frame, parts.sensitivity);
        sensitivity.ask(&mut frame, &question, parts.positions)?;
        let (expansion, bodies) = (parts.expansion, parts.bodies);
        Ok(Self { frame, sensitivity, stations, origins, expansion, bodies, drivers, question })
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
        if stations.iter().any(Station::is_adjusted) {
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

    /// What changes when the shapes of the sides do, each being that of its model with derivatives. Sides are
    /// in the order of the vehicle, left first.
    pub fn change(&self, shapes: &[Shape<Dual>]) -> Change {
        let points = self.origins.positions(shapes);
        let h: Vec<Dual> = self.expansion.parameters(&points);
        Change {
            h: h.into_iter().map(|h| h.derivative).collect(),
            constants: vec![0.0; self.question.constants.len()],
            points: points.iter().map(|point| point.map(|x| x.derivative)).collect(),
        }
    }

    /// No change.
    pub fn no_change(&self) -> Change {
        Change {
            h: vec![0.0; self.expansion.parameter_count()],
            constants: vec![0.0; self.question.constants.len()],
            points: vec![[0.0; 3]; self.origins.len()],
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
        let Response { state, points, .. } = response;
        let origins = self.bodies.iter().map(|body| body.origin).collect();
        Ok(Moved { poses, state, points, origins })
    }

    /// Whether the equations that are left out as redundant go with a change.
    ///
    /// # Errors
    /// [`SensitivityError::Redundant`] where one does not.
    pub fn check(&self, change: &Change) -> Result<(), SensitivityError> {
        self.sensitivity.check(&self.frame, change)
    }

    /// The derivatives of results of the poses by everything that a change has. `results` gives values and
    /// derivatives for poses; `count` is the number of them.
    ///
    /// # Errors
    /// [`SensitivityError`].
    pub fn gradients(
        &mut self,
        count: usize,
        results: impl Fn(&[Pose<Dual>]) -> Vec<f64>,
    ) -> Result<Vec<Change>, SensitivityError> {
        let mut seeded = self.sensitivity.still(&self.frame);
        let mut gradients = vec![Gradient::default(); count];
        let tangents = seeded.tangents.len();
        for gradient in &mut gradients {
            gradient.unknowns = vec![0.0; self.frame.size()];
            gradient.tangents = vec![vec![0.0; self.frame.size()]; tangents];
            gradient.ways = vec![0.0; self.question.by_force.len()];
            gradient.direct = self.no_change();
        }
        for seed in self.seeds(&seeded) {
            seed.entry(&mut seeded).derivative = 1.0;
            let poses = self.poses_of(&seeded);
            seed.entry(&mut seeded).derivative = 0.0;
            for (gradient, by) in gradients.iter_mut().zip(results(&poses)) {
                *seed.place(gradient, &self.frame) = by;
            }
        }
        let Self { sensitivity, frame, .. } = self;
        let adjoint = |gradient: &Gradient| Ok(sensitivity.adjoint(frame, gradient)?);
        gradients.iter().map(adjoint).collect()
    }

    /// The entries of a response that poses depend on.
    fn seeds(&self, response: &Response) -> Vec<Seed> {
        let mut bodies: Vec<usize> = self.stations.iter().flat_map(Station::bodies).collect();
        bodies.sort_unstable();
        bodies.dedup();
        bodies.retain(|&body| body != 0);
        let mut points: Vec<usize> = self.stations.iter().flat_map(Station::points).collect();
        points.sort_unstable();
        points.dedup();
        let travels = self.stations.iter().map(|station| self.equation(station.travel));
        let rows = travels.filter_map(|e| Some((e, self.frame.multiplier(e)?)));
        let rows: Vec<(usize, usize)> = rows.collect();
        let mut seeds = vec![];
        for &body in &bodies {
            for k in 0..BODY_COORDINATES {
                seeds.push(Seed::Coordinate { body, k });
                let entry = BODY_COORDINATES * (body - 1) + k;
                let tangents = 0..response.tangents.len();
                seeds.extend(tangents.map(|tangent| Seed::Tangent { tangent, entry }));
            }
        }
        for (equation, entry) in rows {
            seeds.push(Seed::Multiplier { equation, entry });
            let tangents = 0..self.question.drivers.len();
            seeds.extend(tangents.map(|tangent| Seed::Tangent { tangent, entry }));
        }
        for point in points {
            seeds.extend((0..3).map(|axis| Seed::Point { point, axis }));
        }
        seeds.extend((0..response.ways.len()).map(|driver| Seed::Way { driver }));
        let places = self.stations.iter().flat_map(Station::adjusted_parameters);
        seeds.extend(places.map(|parameter| Seed::Parameter { parameter }));
        seeds
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
        let compliance = self.compliance(response, &view);
        let pose = |(wheel, station): (usize, &Station)| {
            let equation = self.equation(station.travel);
            let multiplier = self.frame.multiplier(equation);
            let force = multiplier.map(|_| -response.lambda[equation]);
            let mut pose = station.loaded_pose(&view, force);
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

/// An entry of a response that is given a derivative.
#[derive(Clone, Copy)]
enum Seed {
    Coordinate { body: usize, k: usize },
    Tangent { tangent: usize, entry: usize },
    Multiplier { equation: usize, entry: usize },
    Point { point: usize, axis: usize },
    Parameter { parameter: usize },
    Way { driver: usize },
}

impl Seed {
    fn entry(self, response: &mut Response) -> &mut Dual {
        match self {
            Self::Coordinate { body, k } => &mut response.state[body][k],
            Self::Tangent { tangent, entry } => &mut response.tangents[tangent][entry],
            Self::Multiplier { equation, .. } => &mut response.lambda[equation],
            Self::Point { point, axis } => &mut response.points[point][axis],
            Self::Parameter { parameter } => &mut response.h[parameter],
            Self::Way { driver } => &mut response.ways[driver],
        }
    }

    fn place<'g>(self, gradient: &'g mut Gradient, frame: &Frame<'_>) -> &'g mut f64 {
        match self {
            Self::Coordinate { body, k } => {
                &mut gradient.unknowns[BODY_COORDINATES * (body - 1) + k]
            }
            Self::Tangent { tangent, entry } => &mut gradient.tangents[tangent][entry],
            Self::Multiplier { entry, .. } => {
                debug_assert!(entry >= frame.unknowns());
                &mut gradient.unknowns[entry]
            }
            Self::Point { point, axis } => &mut gradient.direct.points[point][axis],
            Self::Parameter { parameter } => &mut gradient.direct.h[parameter],
            Self::Way { driver } => &mut gradient.ways[driver],
        }
    }
}
