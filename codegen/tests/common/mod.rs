//! What the tests of programs share: a direct reading, random numbers, comparisons.
#![allow(dead_code, reason = "each test binary uses a part of it")]

pub mod reader;

use std::collections::HashMap;
use std::path::Path;

use hardpoint_codegen::algebra::Function;
use hardpoint_codegen::alphabet::Alphabet;
use hardpoint_codegen::check;
use hardpoint_codegen::kernel::Pattern;
use hardpoint_codegen::program::{Node, Program};
use hardpoint_codegen::source::read_folder;
use hardpoint_codegen::validate::Checked;
use symbolica::prelude::Symbol;

/// Numbers for one evaluation.
pub struct State {
    pub q: Vec<f64>,
    pub d: Vec<f64>,
    pub h: Vec<f64>,
    pub v: Vec<f64>,
    pub a: Vec<f64>,
    pub lambda: Vec<f64>,
}

impl State {
    pub fn random(rng: &mut fastrand::Rng) -> Self {
        let mut numbers =
            |count: usize| -> Vec<f64> { (0..count).map(|_| 0.1 + 0.4 * rng.f64()).collect() };
        Self {
            q: numbers(14),
            d: numbers(14),
            h: numbers(48),
            v: numbers(14),
            lambda: numbers(12),
            a: numbers(7),
        }
    }

    pub fn value(&self, alphabet: &Alphabet, symbol: Symbol) -> f64 {
        let lists = [
            (&alphabet.coordinates, &self.q),
            (&alphabet.parameters, &self.h),
            (&alphabet.multipliers, &self.lambda),
            (&alphabet.velocities, &self.v),
            (&alphabet.accelerations, &self.a),
        ];
        lists
            .iter()
            .find_map(|(symbols, values)| {
                symbols.iter().position(|&known| known == symbol).map(|k| values[k])
            })
            .expect("programs read only arguments")
    }
}

pub fn close(what: &str, found: f64, expected: f64, scale: f64) {
    let difference = (found - expected).abs();
    assert!(
        difference <= 1e-12 * scale.max(1.0),
        "{what}: program {found}, direct {expected}, difference {difference:e}"
    );
}

/// Checks that a pattern with its values is the whole matrix `expected`.
pub fn compare(
    what: &str,
    pattern: &Pattern,
    values: &[f64],
    size: (usize, usize),
    expected: impl Fn(usize, usize) -> f64,
) {
    let entry: HashMap<_, _> = pattern.iter().copied().zip(values).collect();
    for row in 0..size.0 {
        for column in 0..size.1 {
            let found = entry.get(&(row, column)).map_or(0.0, |value| **value);
            let expected = expected(row, column);
            close(&format!("{what}[{row}, {column}]"), found, expected, expected.abs());
        }
    }
}

/// The files of the language's own fixtures and of `constraints/`.
pub fn files() -> Vec<Checked> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    ["tests/right", "../constraints"]
        .iter()
        .flat_map(|folder| read_folder(&here.join(folder)).expect("the folder is there"))
        .map(|source| check(&source).unwrap_or_else(|mistakes| panic!("{mistakes:?}")))
        .collect()
}

/// Runs the program in `f64`.
pub fn evaluate(program: &Program, input: impl Fn(Symbol) -> f64) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::with_capacity(program.nodes.len());
    for node in &program.nodes {
        values.push(match *node {
            Node::Input(symbol) => input(symbol),
            Node::Constant(numerator, denominator) => numerator as f64 / denominator as f64,
            Node::Add(a, b) => values[a] + values[b],
            Node::Subtract(a, b) => values[a] - values[b],
            Node::Multiply(a, b) => values[a] * values[b],
            Node::Negate(a) => -values[a],
            Node::Apply(function, a, b) => match function {
                Function::Reciprocal => 1.0 / values[a],
                Function::Root => values[a].sqrt(),
                Function::Sine => values[a].sin(),
                Function::Cosine => values[a].cos(),
                Function::AtanRatio(order) => atan_ratio(values[a], order),
                Function::Angle => values[a].atan2(b.map_or(f64::NAN, |b| values[b])),
            },
        });
    }
    program.outputs.iter().map(|&output| values[output]).collect()
}

/// The derivative of atan(√x)/√x = ∫ dt/(1 + x t²) from 0 to 1, by Simpson's rule.
pub fn atan_ratio(x: f64, order: u8) -> f64 {
    let inner = |t: f64| {
        let n = i32::from(order);
        (1..=n).fold(1.0, |product, k| -product * f64::from(k) * t * t)
            / (1.0 + x * t * t).powi(n + 1)
    };
    let half = 1.0 / 4000.0;
    let panel = |k: i32| {
        let from = 2.0 * half * f64::from(k);
        inner(from) + 4.0 * inner(from + half) + inner(from + 2.0 * half)
    };
    (0..2000).map(panel).sum::<f64>() * half / 3.0
}
