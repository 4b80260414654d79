//! The equations of equilibrium about one state: all that is asked of them there comes from one
//! factorisation.

use super::border::Border;
use super::equilibrium::Equilibrium;
use super::linear::Singular;
use super::newton::Equations as _;
use super::sensitivity::Frame;
use super::tangent::Tangent;
use crate::assembly::Numbering;
use crate::mechanism::{DriverId, Owner};

/// An equilibrium, linearised at the state that was found last.
///
/// The matrix is filled and factorised when the first answer needs it. While this borrows the
/// equilibrium its state cannot change, so all answers are those of one state.
pub struct Linearised<'a> {
    pub(super) equilibrium: &'a mut Equilibrium,
    factorised: Option<Result<(), Singular>>,
    holding: Option<Result<(), Singular>>,
    /// The driver whose tangent was found last and is still there.
    pub(super) solved: Option<DriverId>,
}

/// What answers are worked out in, set aside once.
pub(super) struct Scratch {
    dh: Vec<f64>,
    phi_change: Vec<f64>,
    force_change: Vec<f64>,
    hold: Hold,
    /// The conditions that let drivers go.
    pub let_go: Border,
}

/// Released drivers that are held all the same.
#[derive(Default)]
struct Hold {
    drivers: Vec<DriverId>,
    equations: Vec<usize>,
    /// −Φ_h of each, by its own value.
    rates: Vec<f64>,
    border: Border,
    /// The rates of their multipliers in the last solution.
    multipliers: Vec<f64>,
}

impl Scratch {
    pub fn new(parameters: usize, equations: usize, unknowns: usize) -> Self {
        Self {
            dh: vec![0.0; parameters],
            phi_change: vec![0.0; equations],
            force_change: vec![0.0; unknowns],
            hold: Hold::default(),
            let_go: Border::default(),
        }
    }
}

impl Equilibrium {
    /// The equations at the solution that was found last, to ask for its derivatives.
    pub fn linearised(&mut self) -> Linearised<'_> {
        let hold = &mut self.scratch.hold;
        hold.drivers.clear();
        hold.equations.clear();
        hold.rates.clear();
        Linearised { equilibrium: self, factorised: None, holding: None, solved: None }
    }

    /// The tangent by one driver. Whoever wants more than one takes [`Self::linearised`].
    ///
    /// # Errors
    /// As for [`Linearised::tangent`].
    pub fn driver_tangent(&mut self, driver: DriverId) -> Result<DriverTangent<'_>, Singular> {
        self.linearised().into_tangent(driver)
    }
}

impl<'a> Linearised<'a> {
    /// The equilibrium.
    pub fn at(&self) -> &Equilibrium {
        self.equilibrium
    }

    /// The same, with drivers that are released held where they are. Their tangents are motions along
    /// states of equilibrium in which the driven value changes, and with it the force that this takes.
    #[must_use]
    pub fn holding(self, drivers: &[DriverId]) -> Self {
        let Equilibrium { problem, expansion, scratch, .. } = &mut *self.equilibrium;
        let released = |driver: &DriverId| {
            let mut equations = expansion.equations_of(Owner::Driver(*driver));
            equations.any(|equation| problem.numbering.row(equation).is_none())
        };
        scratch.hold.drivers.clear();
        scratch.hold.drivers.extend(drivers.iter().copied().filter(released));
        Self { holding: None, solved: None, ..self }
    }

    /// How coordinates and multipliers change with the value of a driver (m or rad), the others held,
    /// at a solution: the columns −KKT⁻¹ [(Φ_qᵀλ)_h; Φ_h].
    ///
    /// # Errors
    /// [`Singular`] where the solution is not isolated, and for a driver that is released and not
    /// held here.
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn tangent(&mut self, driver: DriverId) -> Result<DriverTangent<'_>, Singular> {
        self.solve(driver)?;
        Ok(DriverTangent::of(self.equilibrium))
    }

    /// As [`Self::tangent`], for the last question.
    ///
    /// # Errors
    /// As for [`Self::tangent`].
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn into_tangent(mut self, driver: DriverId) -> Result<DriverTangent<'a>, Singular> {
        self.solve(driver)?;
        Ok(DriverTangent::of(self.equilibrium))
    }

    /// How the force (N) or moment (N·m) −λ that holds a driver grows with its value, the others held.
    ///
    /// # Errors
    /// As for [`Self::tangent`].
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn driver_rate(&mut self, driver: DriverId) -> Result<f64, Singular> {
        let equation = self.equilibrium.equation_of(driver);
        Ok(-self.tangent(driver)?.multiplier(equation))
    }

    /// The state with its factorised matrix, for sensitivities.
    ///
    /// # Errors
    /// [`Singular`] where the solution is not isolated.
    pub fn into_frame(mut self) -> Result<Frame<'a>, Singular> {
        self.factorise()?;
        let Equilibrium { problem, linear, expansion, .. } = self.equilibrium;
        Ok(Frame {
            linear: linear.as_mut(),
            size: problem.kkt.pattern().rows(),
            first: problem.numbering.unknowns(),
            numbering: &problem.numbering,
            state: &problem.state,
            h: &problem.h,
            balance: Some((&problem.lambda, problem.kkt.elements())),
            slots: expansion.driver_slots(),
            equations: expansion.equation_count(),
        })
    }

    /// Fills the matrix and factorises it, once.
    pub(super) fn factorise(&mut self) -> Result<(), Singular> {
        let Equilibrium { problem, linear, .. } = &mut *self.equilibrium;
        *self.factorised.get_or_insert_with(|| {
            problem.kkt.fill(&problem.state, &problem.h, &problem.lambda, &mut problem.phi);
            linear.factorise(problem.kkt.values())
        })
    }

    /// Finds what the drivers that are held here do, once.
    fn hold(&mut self) -> Result<(), Singular> {
        if let Some(done) = self.holding {
            return done;
        }
        let done = self.factorise().and_then(|()| self.close());
        self.holding = Some(done);
        done
    }

    fn close(&mut self) -> Result<(), Singular> {
        let it = &mut *self.equilibrium;
        let mut hold = std::mem::take(&mut it.scratch.hold);
        hold.border.begin(it.problem.kkt.pattern().rows(), hold.drivers.len());
        hold.equations.clear();
        hold.rates.clear();
        for (k, &driver) in hold.drivers.iter().enumerate() {
            let equation = it.equation_of(driver);
            it.change_parameters([(driver, 1.0)]);
            hold.equations.push(equation);
            hold.rates.push(-it.scratch.phi_change[equation]);
            let (problem, gradient) = (&mut it.problem, hold.border.condition_mut(k));
            problem.kkt.terms().gradient(equation, &problem.state, &problem.h, gradient);
        }
        hold.multipliers.clear();
        hold.multipliers.resize(hold.drivers.len(), 0.0);
        let closed = hold.border.close(it.linear.as_mut());
        it.scratch.hold = hold;
        closed
    }

    fn solve(&mut self, driver: DriverId) -> Result<(), Singular> {
        if self.solved == Some(driver) {
            return Ok(());
        }
        self.hold()?;
        self.solved = None;
        let it = &mut *self.equilibrium;
        let held = it.scratch.hold.drivers.iter().position(|&held| held == driver);
        if let Some(k) = held {
            let Hold { rates, border, multipliers, .. } = &mut it.scratch.hold;
            for (out, response) in it.step.iter_mut().zip(border.response(k)) {
                *out = rates[k] * response;
            }
            for (out, inverse) in multipliers.iter_mut().zip(border.inverse(k)) {
                *out = -rates[k] * inverse;
            }
        } else {
            let left_out = |equation| !it.is_held(equation);
            if it.expansion.equations_of(Owner::Driver(driver)).any(left_out) {
                return Err(Singular);
            }
            it.change_parameters([(driver, 1.0)]);
            it.answer_to_change();
            it.linear.solve_refined(&mut it.step)?;
            let Hold { border, multipliers, .. } = &mut it.scratch.hold;
            border.keep(&mut it.step, multipliers);
        }
        self.solved = Some(driver);
        Ok(())
    }
}

impl Equilibrium {
    /// Finds Φ_h and (Φ_qᵀλ)_h by changes of values of drivers.
    fn change_parameters(&mut self, changes: impl IntoIterator<Item = (DriverId, f64)>) {
        let (problem, scratch) = (&mut self.problem, &mut self.scratch);
        scratch.dh.fill(0.0);
        self.expansion.driver_slots().add(changes, &mut scratch.dh);
        problem.kkt.terms().design_products(
            &problem.state,
            &problem.h,
            &scratch.dh,
            Some(&problem.lambda),
            &mut scratch.phi_change,
            &mut scratch.force_change,
        );
        problem.kkt.elements_mut().add_design_force(
            &problem.state,
            &problem.h,
            &scratch.dh,
            &mut scratch.force_change,
        );
    }
}

impl Equilibrium {
    /// The right side −[(Φ_qᵀλ)_h; Φ_h] of the change that was found last.
    fn answer_to_change(&mut self) {
        let (force, phi) = self.step.split_at_mut(self.problem.kkt.unknowns());
        for (out, change) in force.iter_mut().zip(&self.scratch.force_change) {
            *out = -change;
        }
        for (out, &equation) in phi.iter_mut().zip(self.problem.numbering.kept()) {
            *out = -self.scratch.phi_change[equation];
        }
    }

    /// Goes along the tangent of the current equilibrium by what drivers are about to change (m or rad):
    /// where Newton's method begins. Returns the size of the step, relative to the mechanism; infinite
    /// where there is no tangent, and nothing has moved then.
    pub(super) fn predict(&mut self, changes: &[(DriverId, f64)]) -> f64 {
        let problem = &mut self.problem;
        problem.kkt.fill(&problem.state, &problem.h, &problem.lambda, &mut problem.phi);
        self.change_parameters(changes.iter().copied());
        self.answer_to_change();
        let solved = self.linear.factorise(self.problem.kkt.values());
        if solved.and_then(|()| self.linear.solve(&mut self.step)).is_err() {
            return f64::INFINITY;
        }
        let size = self.problem.step_size(&self.step);
        if size.is_finite() {
            self.problem.begin_step();
            self.problem.take_step(&self.step, 1.0);
        }
        size
    }
}

/// The derivative of an equilibrium by the value of a driver.
pub struct DriverTangent<'a> {
    /// Of the coordinates.
    pub motion: Tangent<'a>,
    multipliers: &'a [f64],
    numbering: &'a Numbering,
    hold: &'a Hold,
}

impl<'a> DriverTangent<'a> {
    fn of(equilibrium: &'a Equilibrium) -> Self {
        let problem = &equilibrium.problem;
        let (coordinates, multipliers) = equilibrium.step.split_at(problem.kkt.unknowns());
        Self {
            motion: Tangent::new(&problem.state, coordinates),
            multipliers,
            numbering: &problem.numbering,
            hold: &equilibrium.scratch.hold,
        }
    }

    /// Of the multiplier of an equation; zero where it is left out.
    pub fn multiplier(&self, equation: usize) -> f64 {
        if let Some(row) = self.numbering.row(equation) {
            return self.multipliers[row];
        }
        let held = self.hold.equations.iter().position(|&held| held == equation);
        held.map_or(0.0, |k| self.hold.multipliers[k])
    }
}
