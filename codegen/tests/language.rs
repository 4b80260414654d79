//! Programs against a direct reading of the expressions they were made from,
//! on numbers and on second-order dual numbers.

use std::collections::HashMap;
use std::path::Path;

use hardpoint_codegen::alphabet::Alphabet;
use hardpoint_codegen::expression::{Expression, Kind, Operator};
use hardpoint_codegen::kernel::{Kernel, Pattern};
use hardpoint_codegen::source::read_folder;
use hardpoint_codegen::validate::Relation;
use hardpoint_codegen::{check, session};
use num_dual::{DualNum as _, HyperDual64};

#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "a handful of short-lived values")]
enum Value {
    Scalar(HyperDual64),
    Vector(Vec<HyperDual64>),
    Matrix([[HyperDual64; 3]; 3]),
}

/// Arguments of a relation.
#[derive(Clone)]
struct Arguments {
    q: Vec<HyperDual64>,
    d: Vec<HyperDual64>,
    h: Vec<HyperDual64>,
}

struct Reader<'a> {
    relation: &'a Relation,
    arguments: &'a Arguments,
    names: HashMap<&'a str, Value>,
}

impl<'a> Reader<'a> {
    fn new(relation: &'a Relation, arguments: &'a Arguments) -> Self {
        let mut reader = Self { relation, arguments, names: HashMap::new() };
        for parameter in &relation.parameters {
            let value = if parameter.size == 1 {
                Value::Scalar(arguments.h[parameter.offset])
            } else {
                Value::Vector(arguments.h[parameter.offset..][..3].to_vec())
            };
            reader.names.insert(&parameter.name, value);
        }
        for (name, expression) in &relation.definitions {
            let value = reader.value(expression);
            reader.names.insert(name, value);
        }
        reader
    }

    fn residual(&self) -> Vec<HyperDual64> {
        components(self.value(&self.relation.residual))
    }

    fn given(&self, name: &str) -> Option<Value> {
        let (stem, body) = name.rsplit_once('_')?;
        let at = if body == "j" { 7 } else { 0 };
        let (q, d) = (&self.arguments.q[at..at + 7], &self.arguments.d[at..at + 7]);
        match stem {
            "r" => Some(Value::Vector(q[..3].to_vec())),
            "p" => Some(Value::Vector(q[3..].to_vec())),
            "A" => Some(Value::Matrix(rotation(&q[3..]))),
            "delta_r" => Some(Value::Vector(d[..3].to_vec())),
            "delta_theta" => {
                let turned = cross(&q[4..], &d[4..]);
                let component = |k: usize| {
                    ((q[3] * d[4 + k] - d[3] * q[4 + k]) + turned[k]) * HyperDual64::from(2.0)
                };
                Some(Value::Vector((0..3).map(component).collect()))
            }
            _ => None,
        }
    }

    fn value(&self, expression: &Expression) -> Value {
        match &expression.kind {
            Kind::Number(a, b) => Value::Scalar(HyperDual64::from(*a as f64 / *b as f64)),
            Kind::Name(name) => {
                self.given(name).unwrap_or_else(|| self.names[name.as_str()].clone())
            }
            Kind::Negate(inner) => scale(self.value(inner), HyperDual64::from(-1.0)),
            Kind::Binary(operator, left, right) => {
                binary(*operator, self.value(left), self.value(right))
            }
            Kind::Component(inner, k) => Value::Scalar(components(self.value(inner))[*k]),
            Kind::List(parts) => {
                Value::Vector(parts.iter().flat_map(|part| components(self.value(part))).collect())
            }
            Kind::Call(name, arguments) => {
                let values: Vec<_> =
                    arguments.iter().map(|argument| self.value(argument)).collect();
                match (name.as_str(), values.as_slice()) {
                    ("dot", [Value::Vector(a), Value::Vector(b)]) => Value::Scalar(dot(a, b)),
                    ("cross", [Value::Vector(a), Value::Vector(b)]) => Value::Vector(cross(a, b)),
                    ("norm", [Value::Vector(a)]) => Value::Scalar(dot(a, a).sqrt()),
                    ("transpose", [Value::Matrix(a)]) => {
                        Value::Matrix(std::array::from_fn(|r| std::array::from_fn(|c| a[c][r])))
                    }
                    ("sqrt", [Value::Scalar(a)]) => Value::Scalar(a.sqrt()),
                    ("sin", [Value::Scalar(a)]) => Value::Scalar(a.sin()),
                    ("cos", [Value::Scalar(a)]) => Value::Scalar(a.cos()),
                    ("atan2", [Value::Scalar(y), Value::Scalar(x)]) => Value::Scalar(y.atan2(*x)),
                    other => panic!("{other:?} was accepted"),
                }
            }
        }
    }
}

/// The rotation matrix, homogeneous of second degree in p as the language defines it.
fn rotation(p: &[HyperDual64]) -> [[HyperDual64; 3]; 3] {
    let (e0, e) = (p[0], &p[1..]);
    let diagonal = e0 * e0 - dot(e, e);
    let two = HyperDual64::from(2.0);
    let tilde = [
        [HyperDual64::from(0.0), -e[2], e[1]],
        [e[2], HyperDual64::from(0.0), -e[0]],
        [-e[1], e[0], HyperDual64::from(0.0)],
    ];
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let entry = (e[row] * e[column] + e0 * tilde[row][column]) * two;
            if row == column { entry + diagonal } else { entry }
        })
    })
}

fn components(value: Value) -> Vec<HyperDual64> {
    match value {
        Value::Scalar(scalar) => vec![scalar],
        Value::Vector(vector) => vector,
        Value::Matrix(_) => panic!("a matrix has no list of components"),
    }
}

fn dot(a: &[HyperDual64], b: &[HyperDual64]) -> HyperDual64 {
    a.iter().zip(b).fold(HyperDual64::from(0.0), |sum, (&a, &b)| sum + a * b)
}

fn cross(a: &[HyperDual64], b: &[HyperDual64]) -> Vec<HyperDual64> {
    (0..3)
        .map(|k| {
            let (l, m) = ((k + 1) % 3, (k + 2) % 3);
            a[l] * b[m] - a[m] * b[l]
        })
        .collect()
}

fn scale(value: Value, factor: HyperDual64) -> Value {
    match value {
        Value::Scalar(scalar) => Value::Scalar(scalar * factor),
        Value::Vector(vector) => Value::Vector(vector.into_iter().map(|x| x * factor).collect()),
        Value::Matrix(rows) => Value::Matrix(rows.map(|row| row.map(|x| x * factor))),
    }
}

fn binary(operator: Operator, a: Value, b: Value) -> Value {
    match (operator, a, b) {
        (Operator::Subtract, a, b) => binary(Operator::Add, a, scale(b, HyperDual64::from(-1.0))),
        (Operator::Add, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a + b),
        (Operator::Add, Value::Vector(a), Value::Vector(b)) => {
            Value::Vector(a.into_iter().zip(b).map(|(a, b)| a + b).collect())
        }
        (Operator::Add, Value::Matrix(a), Value::Matrix(b)) => {
            Value::Matrix(std::array::from_fn(|r| std::array::from_fn(|c| a[r][c] + b[r][c])))
        }
        (Operator::Multiply, Value::Scalar(a), b) => scale(b, a),
        (Operator::Multiply, a, Value::Scalar(b)) => scale(a, b),
        (Operator::Multiply, Value::Matrix(a), Value::Vector(b)) => {
            Value::Vector(a.iter().map(|row| dot(row, &b)).collect())
        }
        (Operator::Multiply, Value::Matrix(a), Value::Matrix(b)) => {
            let column = |c: usize| [b[0][c], b[1][c], b[2][c]];
            Value::Matrix(std::array::from_fn(|r| std::array::from_fn(|c| dot(&a[r], &column(c)))))
        }
        (Operator::Divide, a, Value::Scalar(b)) => scale(a, b.recip()),
        other => panic!("{other:?} was accepted"),
    }
}

/// Numbers for one evaluation.
struct State {
    q: Vec<f64>,
    d: Vec<f64>,
    h: Vec<f64>,
    v: Vec<f64>,
    lambda: Vec<f64>,
}

impl State {
    fn random(rng: &mut fastrand::Rng) -> Self {
        let mut numbers =
            |count: usize| -> Vec<f64> { (0..count).map(|_| 0.1 + 0.4 * rng.f64()).collect() };
        Self { q: numbers(14), d: numbers(14), h: numbers(48), v: numbers(14), lambda: numbers(12) }
    }

    fn value(&self, alphabet: &Alphabet, symbol: symbolica::prelude::Symbol) -> f64 {
        let lists = [
            (&alphabet.coordinates, &self.q),
            (&alphabet.parameters, &self.h),
            (&alphabet.multipliers, &self.lambda),
            (&alphabet.velocities, &self.v),
        ];
        lists
            .iter()
            .find_map(|(symbols, values)| {
                symbols.iter().position(|&known| known == symbol).map(|k| values[k])
            })
            .expect("programs read only arguments")
    }

    /// Second-order dual arguments: first direction over all of q, second over q or h.
    fn dual(&self, first: &[f64], second: (usize, bool)) -> Arguments {
        let seed = |k: usize, in_h: bool| f64::from(u8::from(second == (k, in_h)));
        let q = (0..14).map(|k| HyperDual64::new(self.q[k], first[k], seed(k, false), 0.0));
        let h = (0..48).map(|k| HyperDual64::new(self.h[k], 0.0, seed(k, true), 0.0));
        let d = self.d.iter().map(|&d| HyperDual64::from(d));
        Arguments { q: q.collect(), d: d.collect(), h: h.collect() }
    }
}

fn close(what: &str, found: f64, expected: f64, scale: f64) {
    let difference = (found - expected).abs();
    assert!(
        difference <= 1e-12 * scale.max(1.0),
        "{what}: program {found}, direct {expected}, difference {difference:e}"
    );
}

/// Checks that a pattern with its values is the whole matrix `expected`.
fn compare(
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

fn relations() -> Vec<Relation> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    ["tests/right", "../constraints"]
        .iter()
        .flat_map(|folder| read_folder(&here.join(folder)).expect("the folder is there"))
        .map(|source| check(&source).unwrap_or_else(|mistakes| panic!("{mistakes:?}")))
        .collect()
}

fn unit(k: usize) -> [f64; 14] {
    std::array::from_fn(|other| f64::from(u8::from(other == k)))
}

fn test(kernel: &Kernel, alphabet: &Alphabet, state: &State) {
    let relation = &kernel.relation;
    let run = |k: usize| kernel.programs[k].evaluate(|symbol| state.value(alphabet, symbol));
    let name = &relation.name;
    let (rows, columns) = (relation.equations, 7 * relation.bodies);
    let parameters: usize = relation.parameters.iter().map(|parameter| parameter.size).sum();
    let phi = |first: &[f64], second: (usize, bool)| {
        Reader::new(relation, &state.dual(first, second)).residual()
    };

    let found = run(0);
    for (found, expected) in found.iter().zip(phi(&unit(0), (0, false))) {
        close(name, *found, expected.re, 1.0);
    }
    let all = run(2);
    let (found, rest) = all[rows..].split_at(kernel.jacobian.len());
    compare(&format!("{name} Φ_q"), &kernel.jacobian, found, (rows, columns), |row, column| {
        phi(&unit(column), (0, false))[row].eps1
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
                let sum = second.iter().zip(&state.lambda).map(|(phi, l)| phi.eps1eps2 * l).sum();
                if row >= column { sum } else { 0.0 }
            },
        );
    } else {
        test_work(relation, kernel, state, work, curvature);
    }
    let design = run(3);
    let found = &design[..kernel.design.len()];
    compare(&format!("{name} Φ_h"), &kernel.design, found, (rows, parameters), |row, column| {
        phi(&unit(0), (column, true))[row].eps2
    });
    let rate = run(4);
    let (found, found_h) = rate.split_at(kernel.rate.len());
    compare(&format!("{name} (Φ_q v)_q"), &kernel.rate, found, (rows, columns), |row, column| {
        phi(&state.v, (column, false))[row].eps1eps2
    });
    compare(
        &format!("{name} (Φ_q v)_h"),
        &kernel.rate_design,
        found_h,
        (rows, parameters),
        |row, column| phi(&state.v, (column, true))[row].eps1eps2,
    );
}

/// W is the derivative of the work rows by the virtual motion; (Wᵀλ)_q follows by one more.
fn test_work(relation: &Relation, kernel: &Kernel, state: &State, work: &[f64], curvature: &[f64]) {
    let (rows, columns) = (relation.equations, 7 * relation.bodies);
    let expression = relation.work.as_ref().expect("the relation states work");
    let entry = |row: usize, motion: usize, coordinate: usize| {
        let mut arguments = state.dual(&[0.0; 14], (coordinate, false));
        arguments.d =
            (0..14).map(|k| HyperDual64::new(state.d[k], unit(motion)[k], 0.0, 0.0)).collect();
        components(Reader::new(relation, &arguments).value(expression))[row]
    };
    let name = &relation.name;
    compare(&format!("{name} W"), &kernel.work, work, (rows, columns), |row, column| {
        entry(row, column, 0).eps1
    });
    let size = (columns, columns);
    compare(&format!("{name} (Wᵀλ)_q"), &kernel.curvature, curvature, size, |row, column| {
        (0..rows).map(|k| entry(k, row, column).eps1eps2 * state.lambda[k]).sum()
    });
}

#[test]
fn programs_equal_a_direct_reading() {
    session::run(|| {
        let alphabet = Alphabet::register();
        let mut rng = fastrand::Rng::with_seed(4);
        for relation in relations() {
            let kernel = Kernel::new(&relation, &alphabet).unwrap_or_else(|e| panic!("{e:?}"));
            for _ in 0..3 {
                test(&kernel, &alphabet, &State::random(&mut rng));
            }
        }
    })
    .expect("there is a session");
}
