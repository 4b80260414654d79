//! Programs of relations against a direct reading of the expressions they were made
//! from, on numbers and on second-order dual numbers.

mod common;

use common::reader::{Arguments, Number, Reader, components};
use common::{State, close, compare, evaluate, files};
use hardpoint_codegen::alphabet::Alphabet;
use hardpoint_codegen::kernel::Kernel;
use hardpoint_codegen::session;
use hardpoint_codegen::validate::{Checked, Relation};
use num_dual::Dual64;

fn number(value: f64, first: f64, second: f64) -> Number {
    let [value, first, second, both] = [value, first, second, 0.0].map(Dual64::from);
    Number::new(value, first, second, both)
}

/// Second-order dual arguments: first direction over all of q, second over q or h.
fn dual(state: &State, first: &[f64], second: (usize, bool)) -> Arguments {
    let seed = |k: usize, in_h: bool| f64::from(u8::from(second == (k, in_h)));
    let constants = |values: &[f64]| values.iter().map(|&value| Number::from(value)).collect();
    Arguments {
        q: (0..14).map(|k| number(state.q[k], first[k], seed(k, false))).collect(),
        d: constants(&state.d),
        v: constants(&state.v),
        h: (0..48).map(|k| number(state.h[k], 0.0, seed(k, true))).collect(),
    }
}

fn unit(k: usize) -> [f64; 14] {
    std::array::from_fn(|other| f64::from(u8::from(other == k)))
}

fn test(kernel: &Kernel, alphabet: &Alphabet, state: &State) {
    let relation = &kernel.relation;
    let run = |k: usize| evaluate(&kernel.programs[k], |symbol| state.value(alphabet, symbol));
    let name = &relation.heading.name;
    let (rows, columns) = (relation.equations, 7 * relation.bodies);
    let parameters = relation.heading.parameter_count();
    let phi = |first: &[f64], second: (usize, bool)| {
        let arguments = dual(state, first, second);
        components(Reader::new(&relation.heading, &arguments).value(&relation.residual))
    };

    let found = run(0);
    for (found, expected) in found.iter().zip(phi(&unit(0), (0, false))) {
        close(name, *found, expected.re.re, 1.0);
    }
    let all = run(2);
    let (found, rest) = all[rows..].split_at(kernel.jacobian.len());
    compare(&format!("{name} Φ_q"), &kernel.jacobian, found, (rows, columns), |row, column| {
        phi(&unit(column), (0, false))[row].eps1.re
    });
    let (work, curvature) = rest.split_at(kernel.work.len());
    if relation.work.is_none() {
        compare(
            &format!("{name} (Φ_qᵀλ)_q"),
            &kernel.curvature,
            curvature,
            (columns, columns),
            |row, column| {
                let second = phi(&unit(row), (column, false));
                let sum =
                    second.iter().zip(&state.lambda).map(|(phi, l)| phi.eps1eps2.re * l).sum();
                if row >= column { sum } else { 0.0 }
            },
        );
    } else {
        test_work(relation, kernel, state, work, curvature);
    }
    let design = run(3);
    let found = &design[..kernel.design.len()];
    compare(&format!("{name} Φ_h"), &kernel.design, found, (rows, parameters), |row, column| {
        phi(&unit(0), (column, true))[row].eps2.re
    });
    let rate = run(4);
    let (found, found_h) = rate.split_at(kernel.rate.len());
    compare(&format!("{name} (Φ_q v)_q"), &kernel.rate, found, (rows, columns), |row, column| {
        phi(&state.v, (column, false))[row].eps1eps2.re
    });
    compare(
        &format!("{name} (Φ_q v)_h"),
        &kernel.rate_design,
        found_h,
        (rows, parameters),
        |row, column| phi(&state.v, (column, true))[row].eps1eps2.re,
    );
}

/// W is the derivative of the work rows by the virtual motion; (Wᵀλ)_q follows by one more.
fn test_work(relation: &Relation, kernel: &Kernel, state: &State, work: &[f64], curvature: &[f64]) {
    let (rows, columns) = (relation.equations, 7 * relation.bodies);
    let expression = relation.work.as_ref().expect("the relation states work");
    let entry = |row: usize, motion: usize, coordinate: usize| {
        let mut arguments = dual(state, &[0.0; 14], (coordinate, false));
        arguments.d = (0..14).map(|k| number(state.d[k], unit(motion)[k], 0.0)).collect();
        components(Reader::new(&relation.heading, &arguments).value(expression))[row]
    };
    let name = &relation.heading.name;
    compare(&format!("{name} W"), &kernel.work, work, (rows, columns), |row, column| {
        entry(row, column, 0).eps1.re
    });
    let size = (columns, columns);
    compare(&format!("{name} (Wᵀλ)_q"), &kernel.curvature, curvature, size, |row, column| {
        (0..rows).map(|k| entry(k, row, column).eps1eps2.re * state.lambda[k]).sum()
    });
}

#[test]
fn programs_equal_a_direct_reading() {
    session::run(|| {
        let alphabet = Alphabet::register();
        let mut rng = fastrand::Rng::with_seed(4);
        for file in files() {
            let Checked::Relation(relation) = file else {
                continue;
            };
            let kernel = Kernel::new(&relation, &alphabet).unwrap_or_else(|e| panic!("{e:?}"));
            for _ in 0..3 {
                test(&kernel, &alphabet, &State::random(&mut rng));
            }
        }
    })
    .expect("there is a session");
}
