//! The matrix of static equilibrium (paper, eq. 5–7) and of the equations of motion.

use super::block::{Block, Places as BlockPlaces};
use super::elements::{Blend, Elements, Motion};
use super::inertias::Inertias;
use super::pattern::Pattern;
use super::terms::{Numbering, Term, Terms};
use crate::relation::{BODY_COORDINATES, Coordinates};

/// The matrix [K, Wᵀ; Φ_q, 0] with a fixed, unsymmetric pattern.
///
/// The unknowns are the coordinates, then the multipliers of the equations that
/// are not left out. W = Φ_q for relations that state no `work`. K is the derivative of the
/// forces: (Wᵀλ)_q of the constraints, and for force elements and inertias the derivatives by
/// q, q̇ and q̈ in a [`Blend`]. The pattern contains the whole diagonal of K.
#[derive(Clone)]
pub struct Kkt {
    terms: Terms,
    elements: Elements,
    inertias: Inertias,
    element_places: Vec<BlockPlaces>,
    inertia_places: Vec<BlockPlaces>,
    block: Block,
    rest: Vec<Coordinates<f64>>,
    pattern: Pattern,
    unknowns: usize,
    places: Vec<Places>,
    diagonal: Vec<usize>,
    values: Vec<f64>,
    force: Vec<f64>,
    magnitude: Vec<f64>,
}

/// Where the outputs of one term belong. What concerns the ground or an equation
/// that is left out has no place and is not listed.
#[derive(Clone)]
struct Places {
    /// Φ_q.
    phi_q: Vec<Slot>,
    /// Φ_qᵀ, the mirror image of Φ_q.
    phi_q_transposed: Vec<Slot>,
    /// Wᵀ, where the relation states `work`.
    work: Vec<Slot>,
    /// (Wᵀλ)_q, a symmetric one with both of its triangles.
    curvature: Vec<Slot>,
    /// Wᵀλ: output, equation, unknown.
    force: Vec<[usize; 3]>,
}

/// An entry of a kernel output and its place among the values of the matrix.
#[derive(Clone, Copy)]
struct Slot {
    output: usize,
    value: usize,
}

/// An entry of a kernel output and its row and column.
type Entry = (usize, usize, usize);

fn mirrored(entries: &[Entry]) -> Vec<Entry> {
    entries.iter().map(|&(output, row, column)| (output, column, row)).collect()
}

/// The entries of Φ_q or, with the pattern of `work`, of W.
fn constraint(term: &Term, numbering: &Numbering, pattern: &[(u8, u8)]) -> Vec<Entry> {
    let entries = pattern.iter().enumerate();
    entries
        .filter_map(|(output, &(equation, local))| {
            let row = numbering.row(term.equations.start + usize::from(equation))?;
            Some((output, numbering.unknowns() + row, term.unknown(local)?))
        })
        .collect()
}

fn curvature(term: &Term) -> Vec<Entry> {
    let mut entries = vec![];
    for (output, &(row, column)) in term.shape.curvature.iter().enumerate() {
        if let (Some(i), Some(j)) = (term.unknown(row), term.unknown(column)) {
            entries.push((output, i, j));
            if !term.shape.has_work() && row != column {
                entries.push((output, j, i));
            }
        }
    }
    entries
}

fn force(term: &Term) -> Vec<[usize; 3]> {
    let shape = term.shape;
    let rows = if shape.has_work() { shape.work } else { shape.jacobian };
    let entries = rows.iter().enumerate();
    entries
        .filter_map(|(output, &(equation, local))| {
            Some([output, usize::from(equation), term.unknown(local)?])
        })
        .collect()
}

impl Kkt {
    /// The matrix of the constraints alone.
    pub fn new(terms: Terms, numbering: &Numbering) -> Self {
        Self::with_forces(terms, Elements::none(), Inertias::none(), numbering)
    }

    /// Finds the pattern.
    pub fn with_forces(
        terms: Terms,
        elements: Elements,
        inertias: Inertias,
        numbering: &Numbering,
    ) -> Self {
        let entries: Vec<[Vec<Entry>; 4]> = terms
            .list
            .iter()
            .map(|term| {
                let phi_q = constraint(term, numbering, term.shape.jacobian);
                let work = mirrored(&constraint(term, numbering, term.shape.work));
                let transposed = mirrored(&phi_q);
                [phi_q, transposed, work, curvature(term)]
            })
            .collect();
        let mut element_places: Vec<BlockPlaces> =
            (0..elements.len()).map(|element| elements.places(element)).collect();
        let mut inertia_places: Vec<BlockPlaces> =
            (0..inertias.len()).map(|inertia| inertias.places(inertia)).collect();
        let blocks = element_places.iter().chain(&inertia_places).flat_map(BlockPlaces::entries);
        let unknowns = numbering.unknowns();
        let size = unknowns + numbering.kept().len();
        let diagonal = (0..unknowns).map(|k| (k, k));
        let nonzeros = entries.iter().flatten().flatten().map(|&(_, row, column)| (row, column));
        let nonzeros = nonzeros.chain(diagonal.clone()).chain(blocks).collect();
        let pattern = Pattern::new(size, size, nonzeros);
        let slot = |row, column| {
            pattern.slot(row, column).expect("the pattern was made from these entries")
        };
        let slots = |entries: &Vec<Entry>| -> Vec<Slot> {
            let slot = |&(output, row, column)| Slot { output, value: slot(row, column) };
            entries.iter().map(slot).collect()
        };
        element_places.iter_mut().chain(&mut inertia_places).for_each(|places| places.find(slot));
        let places = terms.list.iter().zip(&entries).map(|(term, entries)| {
            let [phi_q, phi_q_transposed, work, curvature] = entries.each_ref().map(slots);
            Places { phi_q, phi_q_transposed, work, curvature, force: force(term) }
        });
        Self {
            places: places.collect(),
            diagonal: diagonal.map(|(row, column)| slot(row, column)).collect(),
            values: vec![0.0; pattern.nonzeros()],
            force: vec![0.0; unknowns],
            magnitude: vec![0.0; unknowns],
            rest: vec![[0.0; BODY_COORDINATES]; unknowns / BODY_COORDINATES + 1],
            block: Block::new(),
            element_places,
            inertia_places,
            unknowns,
            terms,
            elements,
            inertias,
            pattern,
        }
    }

    /// The pattern of the matrix.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// The values in the order of the pattern.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The relations.
    pub fn terms(&mut self) -> &mut Terms {
        &mut self.terms
    }

    /// The force elements.
    pub fn elements(&self) -> &Elements {
        &self.elements
    }

    /// The force elements, to change their laws or to accept a state.
    pub fn elements_mut(&mut self) -> &mut Elements {
        &mut self.elements
    }

    /// The inertias.
    pub fn inertias(&self) -> &Inertias {
        &self.inertias
    }

    /// The generalized forces of the last evaluation: Wᵀλ of constraints and force elements, and
    /// inertia.
    pub fn force(&self) -> &[f64] {
        &self.force
    }

    /// The sums of the absolute values of the terms of [`Self::force`].
    pub fn magnitude(&self) -> &[f64] {
        &self.magnitude
    }

    /// Evaluates Φ, the forces and the matrix at rest. `lambda` and `phi` have an entry for
    /// every equation; the multiplier of a left-out equation is a dead load, zero for redundant ones.
    pub fn fill(&mut self, state: &[Coordinates<f64>], h: &[f64], lambda: &[f64], phi: &mut [f64]) {
        let rest = std::mem::take(&mut self.rest);
        let motion = Motion { state, velocity: &rest, acceleration: &rest };
        self.fill_in_motion(motion, h, lambda, Blend::STATIC, phi);
        self.rest = rest;
    }

    /// Evaluates Φ and the forces at rest.
    pub fn residual(
        &mut self,
        state: &[Coordinates<f64>],
        h: &[f64],
        lambda: &[f64],
        phi: &mut [f64],
    ) {
        let rest = std::mem::take(&mut self.rest);
        let motion = Motion { state, velocity: &rest, acceleration: &rest };
        self.residual_in_motion(motion, h, lambda, phi);
        self.rest = rest;
    }

    /// Evaluates Φ, the forces and the matrix of bodies in motion.
    pub fn fill_in_motion(
        &mut self,
        motion: Motion<'_>,
        h: &[f64],
        lambda: &[f64],
        blend: Blend,
        phi: &mut [f64],
    ) {
        self.values.fill(0.0);
        self.force.fill(0.0);
        self.magnitude.fill(0.0);
        let Terms { list, phi_q, work, curvature, .. } = &mut self.terms;
        for (term, places) in list.iter().zip(&self.places) {
            let lambda = &lambda[term.equations.clone()];
            let phi_q = &mut phi_q[..term.shape.jacobian.len()];
            let work = &mut work[..term.shape.work.len()];
            let curvature = &mut curvature[..term.shape.curvature.len()];
            term.kernels.curvature(
                term.place(motion.state, h),
                lambda,
                &mut phi[term.equations.clone()],
                phi_q,
                work,
                curvature,
            );
            set(&mut self.values, &places.phi_q, phi_q);
            if term.shape.has_work() {
                set(&mut self.values, &places.work, work);
            } else {
                set(&mut self.values, &places.phi_q_transposed, phi_q);
            }
            for slot in &places.curvature {
                self.values[slot.value] += blend.stiffness * curvature[slot.output];
            }
            let force = (&mut self.force[..], &mut self.magnitude[..]);
            add_force(term, places, phi_q, work, lambda, force);
        }
        self.add_elements(motion, h, Some(blend));
    }

    /// Evaluates Φ and the forces of bodies in motion.
    pub fn residual_in_motion(
        &mut self,
        motion: Motion<'_>,
        h: &[f64],
        lambda: &[f64],
        phi: &mut [f64],
    ) {
        self.force.fill(0.0);
        self.magnitude.fill(0.0);
        let Terms { list, phi_q, work, .. } = &mut self.terms;
        for (term, places) in list.iter().zip(&self.places) {
            let phi_q = &mut phi_q[..term.shape.jacobian.len()];
            let work = &mut work[..term.shape.work.len()];
            let phi = &mut phi[term.equations.clone()];
            term.kernels.jacobian(term.place(motion.state, h), phi, phi_q, work);
            let lambda = &lambda[term.equations.clone()];
            let force = (&mut self.force[..], &mut self.magnitude[..]);
            add_force(term, places, phi_q, work, lambda, force);
        }
        self.add_elements(motion, h, None);
    }

    /// Adds force elements and inertias.
    fn add_elements(&mut self, motion: Motion<'_>, h: &[f64], blend: Option<Blend>) {
        let Self { block, force, magnitude, values, .. } = self;
        for (element, places) in self.element_places.iter().enumerate() {
            self.elements.evaluate(element, motion, h, blend, block);
            places.scatter_force(block, force, magnitude);
            if blend.is_some() {
                places.scatter(block, values);
            }
        }
        for (inertia, places) in self.inertia_places.iter().enumerate() {
            self.inertias.evaluate(inertia, motion, h, blend, block);
            places.scatter_force(block, force, magnitude);
            if blend.is_some() {
                places.scatter(block, values);
            }
        }
    }

    /// Evaluates Φ and the matrix [D, Φ_qᵀ; Φ_q, 0] with the given diagonal D,
    /// whose solution is the smallest change of coordinates in the norm of D.
    pub fn fill_least_change(
        &mut self,
        state: &[Coordinates<f64>],
        h: &[f64],
        diagonal: &[f64],
        phi: &mut [f64],
    ) {
        self.values.fill(0.0);
        for (&slot, &value) in self.diagonal.iter().zip(diagonal) {
            self.values[slot] = value;
        }
        let Terms { list, phi_q, work, .. } = &mut self.terms;
        for (term, places) in list.iter().zip(&self.places) {
            let phi_q = &mut phi_q[..term.shape.jacobian.len()];
            let work = &mut work[..term.shape.work.len()];
            let phi = &mut phi[term.equations.clone()];
            term.kernels.jacobian(term.place(state, h), phi, phi_q, work);
            set(&mut self.values, &places.phi_q, phi_q);
            set(&mut self.values, &places.phi_q_transposed, phi_q);
        }
    }

    /// Adds `factor` times a diagonal matrix to K.
    pub fn add_diagonal(&mut self, diagonal: &[f64], factor: f64) {
        for (&slot, &value) in self.diagonal.iter().zip(diagonal) {
            self.values[slot] += factor * value;
        }
    }

    /// The largest absolute entry of K, each divided by the scales of its row and column.
    pub fn largest_stiffness(&self, scale: impl Fn(usize) -> f64) -> f64 {
        let entries = self.pattern.entries();
        entries.take_while(|&(_, column, _)| column < self.unknowns).fold(
            0.0,
            |largest: f64, (row, column, slot)| {
                if row >= self.unknowns {
                    return largest;
                }
                largest.max((self.values[slot] * scale(row) * scale(column)).abs())
            },
        )
    }

    /// Number of coordinates; the multipliers follow them.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }
}

/// Writes the entries of a kernel output to their places.
fn set(values: &mut [f64], slots: &[Slot], output: &[f64]) {
    for slot in slots {
        values[slot.value] = output[slot.output];
    }
}

/// Adds Wᵀλ of one term.
fn add_force(
    term: &Term,
    places: &Places,
    phi_q: &[f64],
    work: &[f64],
    lambda: &[f64],
    (force, magnitude): (&mut [f64], &mut [f64]),
) {
    let rows = if term.shape.has_work() { work } else { phi_q };
    for &[output, equation, unknown] in &places.force {
        let value = rows[output] * lambda[equation];
        force[unknown] += value;
        magnitude[unknown] += value.abs();
    }
}
