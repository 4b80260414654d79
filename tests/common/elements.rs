//! The generalized forces of all force elements, element by element.

use hardpoint::mechanism::{Expansion, Mechanism};
use hardpoint::relation::{Coordinates, Place};

/// What every element of a mechanism does at a state.
pub struct Answer {
    /// Φ of all elements.
    pub values: Vec<f64>,
    /// The generalized force −Wᵀλ on every body.
    pub force: Vec<[f64; 7]>,
}

/// Evaluates all elements at a state and its rate, the ground first.
pub fn answer(
    mechanism: &Mechanism,
    state: &[Coordinates<f64>],
    velocity: &[Coordinates<f64>],
) -> Answer {
    let expansion = Expansion::new(mechanism);
    let h = expansion.parameters(&mechanism.positions());
    let mut answer = Answer { values: vec![], force: vec![[0.0; 7]; state.len()] };
    for element in expansion.elements() {
        let instance = &element.instance;
        let (i, j) = (instance.i.index(), instance.j.index());
        let shape = instance.kind.shape();
        let place = Place { q_i: &state[i], q_j: &state[j], h: &h[instance.parameters.clone()] };
        let mut phi = vec![0.0; shape.equations];
        let mut phi_q = vec![0.0; shape.jacobian.len()];
        let mut work = vec![0.0; shape.work.len()];
        instance.kind.kernels::<f64>().jacobian(place, &mut phi, &mut phi_q, &mut work);
        let body = |column: u8| if column < 7 { i } else { j };
        let mut rate = vec![0.0; shape.equations];
        for (&(row, column), entry) in shape.jacobian.iter().zip(&phi_q) {
            rate[row as usize] += entry * velocity[body(column)][column as usize % 7];
        }
        let laws = element.laws.iter().zip(phi.iter().zip(&rate));
        let lambda: Vec<f64> = laws.map(|(law, (&phi, &rate))| law.at(phi, rate).force).collect();
        let (pattern, rows) =
            if shape.has_work() { (shape.work, &work) } else { (shape.jacobian, &phi_q) };
        for (&(row, column), entry) in pattern.iter().zip(rows) {
            answer.force[body(column)][column as usize % 7] -= entry * lambda[row as usize];
        }
        answer.values.extend(phi);
    }
    answer
}
