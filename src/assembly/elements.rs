//! Force elements, ready to be evaluated.

use super::block::{Block, Places};
use super::terms::{Term, multiply};
use crate::mechanism::{Expansion, Law, Owner, Response};
use crate::relation::{BODY_COORDINATES, Coordinates, Shape};

/// How all bodies move, the ground first.
#[derive(Clone, Copy)]
pub struct Motion<'a> {
    /// Coordinates q.
    pub state: &'a [Coordinates<f64>],
    /// Their rates q̇.
    pub velocity: &'a [Coordinates<f64>],
    /// Their second derivatives q̈.
    pub acceleration: &'a [Coordinates<f64>],
}

/// The weights with which the derivatives of forces by q, q̇ and q̈ make one matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blend {
    /// Of the derivative by q.
    pub stiffness: f64,
    /// Of the derivative by q̇.
    pub damping: f64,
    /// Of the derivative by q̈.
    pub mass: f64,
}

impl Blend {
    /// Statics: the derivative by q alone.
    pub const STATIC: Self = Self { stiffness: 1.0, damping: 0.0, mass: 0.0 };
}

/// All force elements of a mechanism with their last values.
#[derive(Clone)]
pub struct Elements {
    list: Vec<Element>,
    laws: Vec<Law>,
    values: Vec<f64>,
    rates: Vec<f64>,
    // W q̇, the rates that forces work on; the same as Φ̇ for relations that state no `work`.
    work_rates: Vec<f64>,
    responses: Vec<Response>,
    // The value of each periodic element at the last accepted state.
    memory: Vec<f64>,
    scratch: Scratch,
}

#[derive(Clone)]
struct Element {
    term: Term,
    owner: Owner,
    periodic: bool,
}

#[derive(Clone)]
struct Scratch {
    lambda: Vec<f64>,
    phi_q: Vec<f64>,
    work: Vec<f64>,
    curvature: Vec<f64>,
    rate: Vec<f64>,
    rate_h: Vec<f64>,
    phi_h: Vec<f64>,
    force_h: Vec<f64>,
}

impl Elements {
    /// No elements.
    pub fn none() -> Self {
        Self::from_parts(vec![], vec![])
    }

    /// The elements of a mechanism.
    pub fn new(expansion: &Expansion) -> Self {
        let list = expansion.elements().iter().map(|element| Element {
            term: Term::new(&element.instance),
            owner: element.instance.owner,
            // An angle between two directions, counted over full turns outside the kernel.
            periodic: element.instance.kind == crate::kernels::RelationKind::Torsion,
        });
        let laws = expansion.elements().iter().flat_map(|element| element.laws.clone());
        Self::from_parts(list.collect(), laws.collect())
    }

    fn from_parts(list: Vec<Element>, laws: Vec<Law>) -> Self {
        let scratch = |length: fn(&Shape) -> usize| {
            vec![0.0; list.iter().map(|element| length(element.term.shape)).max().unwrap_or(0)]
        };
        let numbers = vec![0.0; laws.len()];
        Self {
            scratch: Scratch {
                lambda: scratch(|shape| shape.equations),
                phi_q: scratch(|shape| shape.jacobian.len()),
                work: scratch(|shape| shape.work.len()),
                curvature: scratch(|shape| shape.curvature.len()),
                rate: scratch(|shape| shape.rate.len()),
                rate_h: scratch(|shape| shape.rate_design.len()),
                phi_h: scratch(|shape| shape.design.len()),
                force_h: scratch(|shape| shape.force_design.len()),
            },
            values: numbers.clone(),
            rates: numbers.clone(),
            work_rates: numbers.clone(),
            memory: numbers,
            responses: vec![Response::default(); laws.len()],
            list,
            laws,
        }
    }

    /// What each element belongs to, with the numbers of its values.
    pub fn owners(&self) -> impl Iterator<Item = (Owner, std::ops::Range<usize>)> + '_ {
        self.list.iter().map(|element| (element.owner, element.term.equations.clone()))
    }

    /// Φ of all elements at the last evaluation, angles counted over full turns.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Φ̇ of all elements at the last evaluation.
    pub fn rates(&self) -> &[f64] {
        &self.rates
    }

    /// λ of all elements at the last evaluation, with its derivatives.
    pub fn responses(&self) -> &[Response] {
        &self.responses
    }

    /// What full turns (rad) are in a difference between the counted value of an element and that of its kernel;
    /// zero where the value is no angle.
    pub(super) fn turns(&self, value: usize, difference: f64) -> f64 {
        let owner = self.list.iter().find(|element| element.term.equations.contains(&value));
        let turn = std::f64::consts::TAU;
        match owner {
            Some(Element { periodic: true, .. }) => turn * (difference / turn).round(),
            _ => 0.0,
        }
    }

    /// The laws, one for each value.
    pub fn laws(&self) -> &[Law] {
        &self.laws
    }

    /// The laws, to be changed along a load schedule.
    pub fn laws_mut(&mut self) -> &mut [Law] {
        &mut self.laws
    }

    /// The potential energy (J) of elastic forces, preloads and weights at the last evaluation.
    /// Forces that work on something else than the change of their value have none.
    pub fn potential(&self) -> f64 {
        let elements = self.list.iter().filter(|element| !element.term.shape.has_work());
        let values = elements.flat_map(|element| element.term.equations.clone());
        values.map(|k| self.laws[k].potential(self.values[k])).sum()
    }

    /// The power (W) of all forces that [`Self::potential`] does not contain at the last
    /// evaluation: negative where dampers dissipate.
    pub fn power(&self) -> f64 {
        let power = |element: &Element| -> f64 {
            let values = element.term.equations.clone();
            let force = |k: usize| match element.term.shape.has_work() {
                true => self.responses[k].force,
                false => self.responses[k].force - self.laws[k].conservative(self.values[k]),
            };
            values.map(|k| -force(k) * self.work_rates[k]).sum()
        };
        self.list.iter().map(power).sum()
    }

    /// Remembers the last evaluation as an accepted state, from which angles are counted on.
    pub fn accept(&mut self) {
        self.memory.copy_from_slice(&self.values);
    }

    /// Forgets the accepted state: angles count from the design position again.
    pub fn forget(&mut self) {
        self.memory.fill(0.0);
    }

    /// The number of elements.
    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// The unknowns of an element in the order of its block.
    pub(super) fn places(&self, element: usize) -> Places {
        let term = &self.list[element].term;
        let touched = |local: u8| {
            let column = |pattern: &[(u8, u8)]| pattern.iter().any(|&(_, c)| c == local);
            column(term.shape.jacobian) || column(term.shape.work)
        };
        Places::new(
            (0..2 * BODY_COORDINATES as u8)
                .map(|local| if touched(local) { term.unknown(local) } else { None }),
        )
    }

    /// Adds how the forces of all elements change when the parameters change by dh, at the last
    /// evaluation: (Wᵀλ)_h dh + Wᵀ λ_Φ Φ_h dh, all unknowns.
    pub(crate) fn add_design_force(
        &mut self,
        state: &[Coordinates<f64>],
        h: &[f64],
        dh: &[f64],
        force: &mut [f64],
    ) {
        let Scratch { lambda, phi_q, work, phi_h, force_h, .. } = &mut self.scratch;
        for Element { term, .. } in &self.list {
            let dh = &dh[term.parameters.clone()];
            if dh.iter().all(|&change| change == 0.0) {
                continue;
            }
            let shape = term.shape;
            let place = term.place(state, h);
            let responses = &self.responses[term.equations.clone()];
            let lambda = &mut lambda[..shape.equations];
            for (lambda, response) in lambda.iter_mut().zip(responses) {
                *lambda = response.force;
            }
            let phi_h = &mut phi_h[..shape.design.len()];
            let force_h = &mut force_h[..shape.force_design.len()];
            term.kernels.design(place, lambda, phi_h, force_h);
            for (&(local, parameter), value) in shape.force_design.iter().zip(&*force_h) {
                if let Some(unknown) = term.unknown(local) {
                    force[unknown] += value * dh[usize::from(parameter)];
                }
            }
            let phi_q = &mut phi_q[..shape.jacobian.len()];
            let work = &mut work[..shape.work.len()];
            // The kernel writes Φ, too, which is not needed.
            term.kernels.jacobian(place, lambda, phi_q, work);
            lambda.fill(0.0);
            for (&(equation, parameter), value) in shape.design.iter().zip(&*phi_h) {
                let equation = usize::from(equation);
                let response = &responses[equation];
                lambda[equation] += response.by_value * value * dh[usize::from(parameter)];
            }
            let rows =
                if shape.has_work() { (shape.work, &*work) } else { (shape.jacobian, &*phi_q) };
            for (&(equation, local), value) in rows.0.iter().zip(rows.1) {
                if let Some(unknown) = term.unknown(local) {
                    force[unknown] += value * lambda[usize::from(equation)];
                }
            }
        }
    }

    /// Evaluates one element and writes Wᵀλ to `block`, and the derivatives of it where a blend
    /// is given.
    pub(super) fn evaluate(
        &mut self,
        element: usize,
        motion: Motion<'_>,
        h: &[f64],
        blend: Option<Blend>,
        block: &mut Block,
    ) {
        block.clear();
        let Element { term, periodic, .. } = &self.list[element];
        let shape = term.shape;
        let place = term.place(motion.state, h);
        let equations = term.equations.clone();
        let Scratch { lambda, phi_q, work, curvature, rate, rate_h, .. } = &mut self.scratch;
        let phi_q = &mut phi_q[..shape.jacobian.len()];
        let work = &mut work[..shape.work.len()];
        let lambda = &mut lambda[..shape.equations];
        let phi = &mut self.values[equations.clone()];
        term.kernels.jacobian(place, phi, phi_q, work);
        if *periodic {
            let turn = std::f64::consts::TAU;
            phi[0] += turn * ((self.memory[equations.start] - phi[0]) / turn).round();
        }
        let (v_i, v_j) = (&motion.velocity[term.i], &motion.velocity[term.j]);
        let rates = &mut self.rates[equations.clone()];
        multiply(term, shape.jacobian, phi_q, motion.velocity, rates);
        let work_rates = &mut self.work_rates[equations.clone()];
        if shape.has_work() {
            multiply(term, shape.work, work, motion.velocity, work_rates);
        } else {
            work_rates.copy_from_slice(rates);
        }
        let responses = &mut self.responses[equations.clone()];
        for (k, law) in self.laws[equations.clone()].iter().enumerate() {
            responses[k] = law.at(phi[k], rates[k]);
            lambda[k] = responses[k].force;
        }
        let rows = if shape.has_work() { (shape.work, &*work) } else { (shape.jacobian, &*phi_q) };
        for (&(equation, local), value) in rows.0.iter().zip(rows.1) {
            let response = &responses[usize::from(equation)];
            block.add_force(local, value * response.force, value * response.size);
        }
        let Some(blend) = blend else { return };

        // The program of the curvature writes Φ once more, without the turns.
        let unwrapped = phi[0];
        let curvature = &mut curvature[..shape.curvature.len()];
        term.kernels.curvature(place, lambda, phi, phi_q, work, curvature);
        phi[0] = unwrapped;
        for (&(row, column), value) in shape.curvature.iter().zip(&*curvature) {
            block.add(row, column, blend.stiffness * value);
            if !shape.has_work() && row != column {
                block.add(column, row, blend.stiffness * value);
            }
        }
        let rows = if shape.has_work() { (shape.work, &*work) } else { (shape.jacobian, &*phi_q) };
        for (&(equation, row), w) in rows.0.iter().zip(rows.1) {
            let response = &responses[usize::from(equation)];
            let factor = blend.stiffness * response.by_value + blend.damping * response.by_rate;
            if factor == 0.0 {
                continue;
            }
            for (&(other, column), g) in shape.jacobian.iter().zip(&*phi_q) {
                if other == equation {
                    block.add(row, column, w * factor * g);
                }
            }
        }
        if responses.iter().all(|response| response.by_rate == 0.0) {
            return;
        }
        let rate = &mut rate[..shape.rate.len()];
        term.kernels.rate(place, v_i, v_j, rate, &mut rate_h[..shape.rate_design.len()]);
        for (&(equation, row), w) in rows.0.iter().zip(rows.1) {
            let factor = blend.stiffness * responses[usize::from(equation)].by_rate;
            for (&(other, column), g) in shape.rate.iter().zip(&*rate) {
                if other == equation {
                    block.add(row, column, w * factor * g);
                }
            }
        }
    }
}
