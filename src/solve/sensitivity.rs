//! How a state and its tangents change with parameters: the implicit function theorem, once for the state
//! and once more for each tangent, all on one factorisation.
//!
//! With M the factorised matrix, x = (q, λ) and H = G_h, a change dh of parameters moves the state by
//! x_d = −M⁻¹ H dh. A tangent x_k solves M x_k = b_k, so it changes by
//! −M⁻¹ (M_d x_k − b_d), where M_d x_k is found on dual numbers along x_k: see
//! [`Variation`]. Direct solutions go from one parameter to all results,
//! adjoint ones from one result to all parameters.

mod conditions;
mod loads;

pub(crate) use conditions::inverse;

use self::conditions::{ByForce, LeftOut, along_driver};
use self::loads::moved_load;
use super::border::Border;
use super::compliance::{WRENCH, coordinates_of, unit_load};
use super::linear::{LinearSolver, Singular};
use crate::assembly::{
    Along, Derivatives, ElementConstant, Elements, GROUND, Numbering, Rows, Variation,
};
use crate::mechanism::{BodyId, DriverId, DriverSlots, Expansion, PointId};
use crate::relation::{BODY_COORDINATES, Coordinates};
use crate::scalar::{Dual, Scalar as _};
use crate::vector::{Vector, add, rotate};

/// A state with its factorised matrix.
pub struct Frame<'a> {
    pub(super) linear: &'a mut dyn LinearSolver,
    /// The size of the matrix.
    pub(super) size: usize,
    pub(super) numbering: &'a Numbering,
    /// The row of the first kept equation.
    pub(super) first: usize,
    /// Coordinates of all bodies, the ground first.
    pub(super) state: &'a [Coordinates<f64>],
    /// Parameters with the values of drivers.
    pub(super) h: &'a [f64],
    /// Multipliers of all equations and force elements, where forces are in balance.
    pub(super) balance: Option<(&'a [f64], &'a Elements)>,
    pub(super) slots: &'a DriverSlots,
    pub(super) equations: usize,
}

/// What is wanted of a state.
#[derive(Clone, Debug, Default)]
pub struct Question {
    /// The drivers whose tangents are wanted.
    pub drivers: Vec<DriverId>,
    /// The points whose compliance is wanted, each on its body.
    pub points: Vec<(BodyId, PointId)>,
    /// The equations of drivers that let go in the compliance.
    pub let_go: Vec<usize>,
    /// The drivers, among those above, that are held by forces instead of at values, with their equations.
    pub by_force: Vec<(DriverId, usize)>,
    /// The constants of laws that are varied.
    pub constants: Vec<ElementConstant>,
    /// How many numbers there are that the solver does not know, but results depend on.
    pub others: usize,
}

/// A change of what a state depends on.
#[derive(Clone, Debug, Default)]
pub struct Change {
    /// Of the parameters h.
    pub h: Vec<f64>,
    /// Of the constants in the question.
    pub constants: Vec<f64>,
    /// Of the design positions of points (m).
    pub points: Vec<Vector<f64>>,
    /// Of numbers that the solver does not know, but results depend on.
    pub others: Vec<f64>,
}

impl Change {
    /// The same, so many times as much.
    #[must_use]
    pub fn times(mut self, factor: f64) -> Self {
        let numbers = self.h.iter_mut().chain(&mut self.constants).chain(&mut self.others);
        numbers.chain(self.points.as_flattened_mut()).for_each(|number| *number *= factor);
        self
    }

    /// Adds another one, `factor` times.
    fn add(&mut self, factor: f64, other: &Self) {
        let add = |to: &mut [f64], from: &[f64]| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to += factor * from);
        };
        add(&mut self.h, &other.h);
        add(&mut self.constants, &other.constants);
        add(self.points.as_flattened_mut(), other.points.as_flattened());
        add(&mut self.others, &other.others);
    }

    /// The sum of the products of all entries.
    pub fn dot(&self, other: &Self) -> f64 {
        let sum = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let points = sum(self.points.as_flattened(), other.points.as_flattened());
        let others = sum(&self.others, &other.others);
        sum(&self.h, &other.h) + sum(&self.constants, &other.constants) + points + others
    }
}

/// A state with tangents and compliance, each with its derivative along a change.
#[derive(Clone, Debug)]
pub struct Response {
    /// Coordinates of all bodies, the ground first.
    pub state: Vec<Coordinates<Dual>>,
    /// Multipliers of all equations; empty where forces are not in balance.
    pub lambda: Vec<Dual>,
    /// Parameters.
    pub h: Vec<Dual>,
    /// Design positions of all points (m).
    pub points: Vec<Vector<Dual>>,
    /// How far (m or rad) the drivers that forces hold go; the values are zero.
    pub ways: Vec<Dual>,
    /// The numbers that the solver does not know; the values are zero.
    pub others: Vec<Dual>,
    /// The tangents by the drivers of the question, then those by unit loads: coordinates, then multipliers of
    /// kept equations.
    pub tangents: Vec<Vec<Dual>>,
}

/// Derivatives of one result by all that [`Response`] has, its derivatives being one at a time.
#[derive(Clone, Debug, Default)]
pub struct Gradient {
    /// By coordinates, then by multipliers of kept equations.
    pub unknowns: Vec<f64>,
    /// By the entries of each tangent.
    pub tangents: Vec<Vec<f64>>,
    /// By the values of drivers that forces hold, directly.
    pub ways: Vec<f64>,
    /// By parameters and points directly.
    pub direct: Change,
}

/// The tangents at a state, and all that their derivatives need.
pub struct Sensitivity {
    variation: Variation,
    question: Question,
    origins: Vec<[f64; 3]>,
    positions: Vec<Vector<f64>>,
    values: Derivatives,
    unused: Derivatives,
    tangents: Vec<Solved>,
    let_go: Border,
    let_go_transposed: Border,
    excess: Vec<f64>,
    at: Dualised,
    by_force: ByForce,
    left_out: Vec<LeftOut>,
}

#[derive(Default)]
struct Solved {
    x: Vec<f64>,
    cause: Cause,
    changes: Derivatives,
}

#[derive(Clone, Copy, Default)]
enum Cause {
    #[default]
    Driver,
    /// A unit force or moment at a point of the question.
    Load { point: usize, component: usize },
}

/// A state on dual numbers.
#[derive(Default)]
struct Dualised {
    state: Vec<Coordinates<Dual>>,
    lambda: Vec<Dual>,
    h: Vec<Dual>,
}

impl Frame<'_> {
    /// The size of the matrix.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The number of coordinates, which are the first unknowns.
    pub fn unknowns(&self) -> usize {
        self.numbering.unknowns()
    }

    /// The place of the multiplier of an equation among the unknowns, where it is one of them.
    pub fn multiplier(&self, equation: usize) -> Option<usize> {
        self.balance?;
        self.numbering.row(equation).map(|row| self.numbering.unknowns() + row)
    }

    fn rows(&self) -> Rows<'_> {
        Rows { numbering: self.numbering, first: self.first, forces: self.balance.is_some() }
    }

    /// The state with rates of coordinates and multipliers, and of parameters.
    fn along(&self, x: &[f64], dh: &[f64], at: &mut Dualised) {
        let unknowns = self.numbering.unknowns();
        at.state.clear();
        at.state.push(GROUND.map(Dual::from_f64));
        let bodies = self.state.iter().skip(1).zip(x[..unknowns].chunks_exact(BODY_COORDINATES));
        at.state.extend(bodies.map(|(q, rate)| std::array::from_fn(|k| Dual::new(q[k], rate[k]))));
        at.lambda.clear();
        if let Some((lambda, _)) = self.balance {
            at.lambda.extend(lambda.iter().map(|&lambda| Dual::from_f64(lambda)));
            for (&equation, &rate) in self.numbering.kept().iter().zip(&x[unknowns..]) {
                at.lambda[equation].derivative = rate;
            }
        }
        at.h.clear();
        at.h.extend(self.h.iter().zip(dh).map(|(&h, &dh)| Dual::new(h, dh)));
    }
}

impl Sensitivity {
    /// Prepares for the states of a mechanism. `origins` are those of the frames of its bodies.
    pub fn new(expansion: &Expansion, origins: Vec<[f64; 3]>) -> Self {
        Self {
            variation: Variation::new(expansion),
            question: Question::default(),
            origins,
            positions: vec![],
            values: Derivatives::default(),
            unused: Derivatives::default(),
            tangents: vec![],
            let_go: Border::default(),
            let_go_transposed: Border::default(),
            excess: vec![],
            at: Dualised::default(),
            by_force: ByForce::default(),
            left_out: vec![],
        }
    }

    /// What is known of the state.
    pub fn question(&self) -> &Question {
        &self.question
    }

    /// Finds the tangents that a question is about at a state. `positions` are the design positions of points.
    ///
    /// # Errors
    /// [`Singular`] in a dead centre, and where nothing holds what drivers let go.
    pub fn ask(
        &mut self,
        frame: &mut Frame<'_>,
        question: &Question,
        positions: &[Vector<f64>],
    ) -> Result<(), Singular> {
        self.question.clone_from(question);
        self.positions.clear();
        self.positions.extend_from_slice(positions);
        let count = question.drivers.len() + WRENCH * question.points.len();
        self.tangents.resize_with(count, Solved::default);
        let mut dh = vec![0.0; frame.h.len()];
        frame.along(&vec![0.0; frame.size], &dh, &mut self.at);
        self.evaluate(frame, None);
        self.open(frame)?;
        for (k, &driver) in question.drivers.iter().enumerate() {
            dh.fill(0.0);
            frame.slots.add([(driver, 1.0)], &mut dh);
            let mut x = vec![0.0; frame.size];
            self.values.by_parameter.add_product(-1.0, &dh, &mut x);
            frame.linear.solve_refined(&mut x)?;
            frame.along(&x, &dh, &mut self.at);
            self.tangents[k].x = x;
            self.tangents[k].cause = Cause::Driver;
            self.evaluate(frame, Some(k));
        }
        dh.fill(0.0);
        for load in 0..WRENCH * question.points.len() {
            let k = question.drivers.len() + load;
            let (point, component) = (load / WRENCH, load % WRENCH);
            let mut x = vec![0.0; frame.size];
            let (body, at) = self.loaded_point(point);
            let q = frame.state[body.index()];
            let place = add([q[0], q[1], q[2]], rotate([q[3], q[4], q[5], q[6]], at));
            let first = coordinates_of(body);
            let force = unit_load(&q, place, component);
            x[first..first + BODY_COORDINATES].copy_from_slice(&force);
            frame.linear.solve_refined(&mut x)?;
            self.let_go.keep(&mut x, &mut self.excess);
            frame.along(&x, &dh, &mut self.at);
            self.tangents[k].x = x;
            self.tangents[k].cause = Cause::Load { point, component };
            self.evaluate(frame, Some(k));
        }
        self.ask_left_out(frame)?;
        self.ask_by_force(frame)
    }

    /// The derivatives of the equations, and their changes along a tangent.
    fn evaluate(&mut self, frame: &Frame<'_>, tangent: Option<usize>) {
        let Self { variation, question, values, unused, tangents, at, .. } = self;
        let along = Along { state: &at.state, lambda: &at.lambda, h: &at.h };
        let none = Elements::none();
        let elements = frame.balance.map_or(&none, |(_, elements)| elements);
        let (values, changes) = match tangent {
            None => (values, unused),
            Some(k) => (unused, &mut tangents[k].changes),
        };
        variation.evaluate(along, frame.rows(), elements, &question.constants, values, changes);
    }

    /// Finds what lets drivers go, in solutions and in transposed ones.
    fn open(&mut self, frame: &mut Frame<'_>) -> Result<(), Singular> {
        let unknowns = frame.numbering.unknowns();
        let let_go = &self.question.let_go;
        let rows: Vec<usize> = let_go.iter().filter_map(|&e| frame.numbering.row(e)).collect();
        self.excess.clear();
        self.excess.resize(rows.len(), 0.0);
        for border in [&mut self.let_go, &mut self.let_go_transposed] {
            border.begin(frame.size, rows.len());
            for (k, row) in rows.iter().enumerate() {
                border.condition_mut(k)[unknowns + row] = 1.0;
            }
        }
        self.let_go.close(frame.linear)?;
        self.let_go_transposed.close_by(|x| frame.linear.solve_transposed(x))
    }

    /// How the state and the tangents change, the direct way.
    ///
    /// # Errors
    /// [`SensitivityError::Redundant`] where redundant equations would not go with the change.
    pub fn response(
        &mut self,
        frame: &mut Frame<'_>,
        change: &Change,
    ) -> Result<Response, SensitivityError> {
        self.check(frame, change)?;
        let ways = self.ways(change);
        let mut change = change.clone();
        let drivers = self.question.by_force.iter().map(|&(driver, _)| driver);
        frame.slots.add(drivers.zip(ways.iter().copied()), &mut change.h);
        let mut x = vec![0.0; frame.size];
        self.values.by_parameter.add_product(-1.0, &change.h, &mut x);
        self.values.by_constant.add_product(-1.0, &change.constants, &mut x);
        frame.linear.solve_refined(&mut x)?;
        frame.along(&x, &change.h, &mut self.at);
        let state = std::mem::take(&mut self.at.state);
        let mut tangents = Vec::with_capacity(self.tangents.len());
        for tangent in &self.tangents {
            let mut rate = vec![0.0; frame.size];
            tangent.changes.by_unknown.add_product(-1.0, &x, &mut rate);
            tangent.changes.by_parameter.add_product(-1.0, &change.h, &mut rate);
            tangent.changes.by_constant.add_product(-1.0, &change.constants, &mut rate);
            if let Cause::Load { point, component } = tangent.cause {
                let (body, at) = self.loaded_point(point);
                let (_, index) = self.question.points[point];
                let moved = change.points.get(index.index()).copied().unwrap_or([0.0; 3]);
                let at = std::array::from_fn(|k| Dual::new(at[k], moved[k]));
                let force = moved_load(&state[body.index()], at, component);
                let first = coordinates_of(body);
                for (rate, force) in rate[first..].iter_mut().zip(force) {
                    *rate += force.derivative;
                }
            }
            frame.linear.solve_refined(&mut rate)?;
            if let Cause::Load { .. } = tangent.cause {
                self.let_go.keep(&mut rate, &mut self.excess);
            }
            tangents.push(tangent.x.iter().zip(rate).map(|(&x, r)| Dual::new(x, r)).collect());
        }
        let points = self.positions.iter().enumerate().map(|(k, position)| {
            let moved = change.points.get(k).copied().unwrap_or([0.0; 3]);
            std::array::from_fn(|axis| Dual::new(position[axis], moved[axis]))
        });
        Ok(Response {
            state,
            lambda: std::mem::take(&mut self.at.lambda),
            h: std::mem::take(&mut self.at.h),
            points: points.collect(),
            ways: ways.into_iter().map(|way| Dual::new(0.0, way)).collect(),
            others: change.others.iter().map(|&other| Dual::new(0.0, other)).collect(),
            tangents,
        })
    }

    /// The state and the tangents without any change, to give single entries derivatives.
    pub fn still(&mut self, frame: &Frame<'_>) -> Response {
        frame.along(&vec![0.0; frame.size], &vec![0.0; frame.h.len()], &mut self.at);
        let still = |x: &f64| Dual::from_f64(*x);
        Response {
            state: std::mem::take(&mut self.at.state),
            lambda: std::mem::take(&mut self.at.lambda),
            h: std::mem::take(&mut self.at.h),
            points: self.positions.iter().map(|p| p.map(Dual::from_f64)).collect(),
            ways: vec![Dual::from_f64(0.0); self.question.by_force.len()],
            others: vec![Dual::from_f64(0.0); self.question.others],
            tangents: self.tangents.iter().map(|t| t.x.iter().map(still).collect()).collect(),
        }
    }

    /// The derivatives of a result by parameters, constants and points, the adjoint way, from those by state and
    /// tangents.
    ///
    /// # Errors
    /// [`Singular`].
    pub fn adjoint(
        &mut self,
        frame: &mut Frame<'_>,
        gradient: &Gradient,
    ) -> Result<Change, Singular> {
        let mut total = gradient.direct.clone();
        total.h.resize(frame.h.len(), 0.0);
        total.constants.resize(self.question.constants.len(), 0.0);
        total.points.resize(self.positions.len(), [0.0; 3]);
        total.others.resize(self.question.others, 0.0);
        let mut state = gradient.unknowns.clone();
        state.resize(frame.size, 0.0);
        for (tangent, by) in self.tangents.iter().zip(&gradient.tangents) {
            if by.iter().all(|&by| by == 0.0) {
                continue;
            }
            let mut y = by.clone();
            y.resize(frame.size, 0.0);
            frame.linear.solve_transposed(&mut y)?;
            if let Cause::Load { point, component } = tangent.cause {
                self.let_go_transposed.keep(&mut y, &mut self.excess);
                self.add_load_gradient(frame, &y, (point, component), &mut state, &mut total);
            }
            tangent.changes.by_unknown.add_transposed_product(-1.0, &y, &mut state);
            tangent.changes.by_parameter.add_transposed_product(-1.0, &y, &mut total.h);
            tangent.changes.by_constant.add_transposed_product(-1.0, &y, &mut total.constants);
        }
        frame.linear.solve_transposed(&mut state)?;
        self.values.by_parameter.add_transposed_product(-1.0, &state, &mut total.h);
        self.values.by_constant.add_transposed_product(-1.0, &state, &mut total.constants);
        // What drivers do that go where they have the same forces again.
        let ByForce { inverse, gradients } = &self.by_force;
        let count = gradients.len();
        let direct = gradient.ways.iter().chain(std::iter::repeat(&0.0));
        let drivers = self.question.by_force.iter().zip(direct);
        let by_ways: Vec<f64> =
            drivers.map(|((driver, _), by)| by + along_driver(frame, *driver, &total)).collect();
        for (column, gradient) in gradients.iter().enumerate() {
            let by: f64 = (0..count).map(|k| by_ways[k] * inverse[k * count + column]).sum();
            total.add(-by, gradient);
        }
        Ok(total)
    }
}

/// Why there is no sensitivity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SensitivityError {
    /// The state has no unique neighbours.
    #[error(transparent)]
    Singular(#[from] Singular),
    /// The equation was left out as redundant, and the change breaks it.
    #[error("a redundant equation does not go with the change")]
    Redundant {
        /// The equation.
        equation: usize,
    },
}
