//! The matrix of static equilibrium (paper, eq. 5–7).

use super::pattern::Pattern;
use super::terms::{Numbering, Term, Terms};
use crate::relation::Coordinates;

/// The matrix [(Wᵀλ)_q, Wᵀ; Φ_q, 0] with a fixed, unsymmetric pattern.
///
/// The unknowns are the coordinates, then the multipliers of the equations that
/// are not left out. W = Φ_q for relations that state no `work`. The
/// pattern contains the whole diagonal of the first block.
#[derive(Clone)]
pub struct Kkt {
    terms: Terms,
    pattern: Pattern,
    unknowns: usize,
    // Places of the outputs `jacobian`, `work` and `curvature`, term after term.
    // The second place of a pair is the mirror image: that of Φ_qᵀ, or the
    // other triangle of a symmetric curvature.
    phi_q_slots: Vec<[usize; 2]>,
    work_slots: Vec<usize>,
    curvature_slots: Vec<[usize; 2]>,
    diagonal_slots: Vec<usize>,
    values: Vec<f64>,
    force: Vec<f64>,
}

type Entry = Option<(usize, usize)>;

fn mirror(entry: Entry) -> Entry {
    entry.map(|(row, column)| (column, row))
}

/// Where the outputs of one term belong.
struct Places<'a> {
    term: &'a Term,
    numbering: &'a Numbering,
}

impl Places<'_> {
    /// An entry of Φ_q or, mirrored, of Wᵀ.
    fn constraint(&self, equation: u8, local: u8) -> Entry {
        let row = self.numbering.row(self.term.equations.start + usize::from(equation))?;
        Some((self.numbering.unknowns() + row, self.term.unknown(local)?))
    }

    fn phi_q(&self) -> impl Iterator<Item = [Entry; 2]> {
        self.term.shape.jacobian.iter().map(|&(equation, local)| {
            let entry = self.constraint(equation, local);
            [entry, mirror(entry)]
        })
    }

    fn work(&self) -> impl Iterator<Item = Entry> {
        let work = self.term.shape.work.iter();
        work.map(|&(equation, local)| mirror(self.constraint(equation, local)))
    }

    fn curvature(&self) -> impl Iterator<Item = [Entry; 2]> {
        self.term.shape.curvature.iter().map(|&(row, column)| {
            let entry = self.term.unknown(row).zip(self.term.unknown(column));
            let symmetric = !self.term.shape.has_work() && row != column;
            [entry, if symmetric { mirror(entry) } else { None }]
        })
    }
}

impl Kkt {
    /// Finds the pattern.
    pub fn new(terms: Terms, numbering: &Numbering) -> Self {
        let (mut phi_q, mut work, mut curvature) = (vec![], vec![], vec![]);
        for term in &terms.list {
            let places = Places { term, numbering };
            phi_q.extend(places.phi_q());
            work.extend(places.work());
            curvature.extend(places.curvature());
        }
        let unknowns = numbering.unknowns();
        let size = unknowns + numbering.kept().len();
        let entries = phi_q.iter().chain(&curvature).flatten().chain(&work);
        let diagonal = (0..unknowns).map(|k| (k, k));
        let pattern =
            Pattern::new(size, size, entries.copied().flatten().chain(diagonal.clone()).collect());
        let spare = pattern.nonzeros();
        let slot = |entry: Entry| {
            entry.and_then(|(row, column)| pattern.slot(row, column)).unwrap_or(spare)
        };
        Self {
            unknowns,
            phi_q_slots: phi_q.into_iter().map(|pair| pair.map(slot)).collect(),
            work_slots: work.into_iter().map(slot).collect(),
            curvature_slots: curvature.into_iter().map(|pair| pair.map(slot)).collect(),
            diagonal_slots: diagonal.map(|entry| slot(Some(entry))).collect(),
            values: vec![0.0; spare + 1],
            force: vec![0.0; unknowns],
            terms,
            pattern,
        }
    }

    /// The pattern of the matrix.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// The values in the order of the pattern.
    pub fn values(&self) -> &[f64] {
        &self.values[..self.pattern.nonzeros()]
    }

    /// The relations.
    pub fn terms(&mut self) -> &mut Terms {
        &mut self.terms
    }

    /// Wᵀλ of the last [`Self::fill`] or [`Self::residual`].
    pub fn force(&self) -> &[f64] {
        &self.force
    }

    /// Evaluates Φ, Wᵀλ and the matrix. `lambda` and `phi` have an entry for
    /// every equation; the multiplier of a left-out equation has to be zero.
    pub fn fill(&mut self, state: &[Coordinates<f64>], h: &[f64], lambda: &[f64], phi: &mut [f64]) {
        self.values.fill(0.0);
        self.force.fill(0.0);
        let Terms { list, phi_q, work, curvature, .. } = &mut self.terms;
        let mut phi_q_slots = self.phi_q_slots.iter();
        let mut work_slots = self.work_slots.iter();
        let mut curvature_slots = self.curvature_slots.iter();
        for term in list {
            let lambda = &lambda[term.equations.clone()];
            let phi_q = &mut phi_q[..term.shape.jacobian.len()];
            let work = &mut work[..term.shape.work.len()];
            let curvature = &mut curvature[..term.shape.curvature.len()];
            term.kernels.curvature(
                term.place(state, h),
                lambda,
                &mut phi[term.equations.clone()],
                phi_q,
                work,
                curvature,
            );
            let has_work = term.shape.has_work();
            for (value, &[slot, transposed]) in phi_q.iter().zip(&mut phi_q_slots) {
                self.values[slot] = *value;
                if !has_work {
                    self.values[transposed] = *value;
                }
            }
            for (value, &slot) in work.iter().zip(&mut work_slots) {
                self.values[slot] = *value;
            }
            for (value, &[slot, mirrored]) in curvature.iter().zip(&mut curvature_slots) {
                self.values[slot] += *value;
                self.values[mirrored] += *value;
            }
            add_force(term, phi_q, work, lambda, &mut self.force);
        }
    }

    /// Evaluates Φ and Wᵀλ only.
    pub fn residual(
        &mut self,
        state: &[Coordinates<f64>],
        h: &[f64],
        lambda: &[f64],
        phi: &mut [f64],
    ) {
        self.force.fill(0.0);
        let Terms { list, phi_q, work, .. } = &mut self.terms;
        for term in list {
            let phi_q = &mut phi_q[..term.shape.jacobian.len()];
            let work = &mut work[..term.shape.work.len()];
            let phi = &mut phi[term.equations.clone()];
            term.kernels.jacobian(term.place(state, h), phi, phi_q, work);
            let lambda = &lambda[term.equations.clone()];
            add_force(term, phi_q, work, lambda, &mut self.force);
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
        for (&slot, &value) in self.diagonal_slots.iter().zip(diagonal) {
            self.values[slot] = value;
        }
        let Terms { list, phi_q, work, .. } = &mut self.terms;
        let mut slots = self.phi_q_slots.iter();
        for term in list {
            let phi_q = &mut phi_q[..term.shape.jacobian.len()];
            let work = &mut work[..term.shape.work.len()];
            let phi = &mut phi[term.equations.clone()];
            term.kernels.jacobian(term.place(state, h), phi, phi_q, work);
            for (value, &[slot, transposed]) in phi_q.iter().zip(&mut slots) {
                self.values[slot] = *value;
                self.values[transposed] = *value;
            }
        }
    }

    /// Number of coordinates; the multipliers follow them.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }
}

/// Adds Wᵀλ of one term.
fn add_force(term: &Term, phi_q: &[f64], work: &[f64], lambda: &[f64], force: &mut [f64]) {
    let (pattern, rows) =
        if term.shape.has_work() { (term.shape.work, work) } else { (term.shape.jacobian, phi_q) };
    for (&(equation, local), value) in pattern.iter().zip(rows) {
        if let Some(unknown) = term.unknown(local) {
            force[unknown] += *value * lambda[usize::from(equation)];
        }
    }
}
