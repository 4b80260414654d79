//! Programs of kinetic energies against a direct reading of the expressions they were
//! made from, on third-order dual numbers.

mod common;

use common::reader::{Arguments, Number, Reader, components};
use common::{State, close, compare, evaluate, files};
use hardpoint_codegen::alphabet::Alphabet;
use hardpoint_codegen::energy::EnergyKernel;
use hardpoint_codegen::session;
use hardpoint_codegen::validate::{Checked, Energy};
use num_dual::Dual64;

/// A component of q, q̇ or q̈.
#[derive(Clone, Copy, PartialEq)]
enum Variable {
    Q(usize),
    V(usize),
    A(usize),
}

fn seed(variable: Variable, other: Variable) -> f64 {
    f64::from(u8::from(variable == other))
}

/// T where the first direction is one variable, the second is time, and the third
/// is one variable again.
fn value(energy: &Energy, state: &State, first: Variable, third: Variable) -> Number {
    let dual = |value: f64, at: Variable| Dual64::new(value, seed(third, at));
    let number = |value: f64, at: Variable, rate: Dual64| {
        let first = Dual64::from(seed(first, at));
        Number::new(dual(value, at), first, rate, Dual64::from(0.0))
    };
    let q = (0..7).map(|k| number(state.q[k], Variable::Q(k), dual(state.v[k], Variable::V(k))));
    let v = (0..7).map(|k| number(state.v[k], Variable::V(k), dual(state.a[k], Variable::A(k))));
    let h = state.h.iter().map(|&h| Number::from(h));
    let arguments =
        Arguments { q: q.collect(), d: vec![Number::from(0.0); 7], v: v.collect(), h: h.collect() };
    components(Reader::new(&energy.heading, &arguments).value(&energy.energy))[0]
}

fn test(kernel: &EnergyKernel, alphabet: &Alphabet, state: &State) {
    let energy = &kernel.energy;
    let name = &energy.heading.name;
    let run = |k: usize| evaluate(&kernel.programs[k], |symbol| state.value(alphabet, symbol));
    let force = |row: usize, third: Variable| {
        let momentum = value(energy, state, Variable::V(row), third);
        momentum.eps1eps2 - value(energy, state, Variable::Q(row), third).eps1
    };
    let none = Variable::A(usize::MAX);
    let expected = value(energy, state, none, none).re.re;
    close(&format!("{name} T"), run(0)[0], expected, expected.abs());
    let all = run(2);
    for (row, (alone, with)) in run(1).iter().zip(&all).enumerate() {
        let expected = force(row, none).re;
        close(&format!("{name} F[{row}]"), *alone, expected, expected.abs());
        close(&format!("{name} F[{row}]"), *with, expected, expected.abs());
    }
    let (force_q, rest) = all[7..].split_at(kernel.force_q.len());
    let (force_v, mass) = rest.split_at(kernel.force_v.len());
    let slope = |row: usize, third: Variable| force(row, third).eps;
    let size = (7, 7);
    compare(&format!("{name} F_q"), &kernel.force_q, force_q, size, |row, column| {
        slope(row, Variable::Q(column))
    });
    compare(&format!("{name} F_v"), &kernel.force_v, force_v, size, |row, column| {
        slope(row, Variable::V(column))
    });
    compare(&format!("{name} mass"), &kernel.mass, mass, size, |row, column| {
        if row >= column { slope(row, Variable::A(column)) } else { 0.0 }
    });
}

#[test]
fn programs_equal_a_direct_reading() {
    session::run(|| {
        let alphabet = Alphabet::register();
        let mut rng = fastrand::Rng::with_seed(5);
        let mut count = 0;
        for file in files() {
            let Checked::Energy(energy) = file else {
                continue;
            };
            let kernel = EnergyKernel::new(&energy, &alphabet).unwrap_or_else(|e| panic!("{e:?}"));
            for _ in 0..3 {
                test(&kernel, &alphabet, &State::random(&mut rng));
            }
            count += 1;
        }
        assert!(count >= 2);
    })
    .expect("there is a session");
}
