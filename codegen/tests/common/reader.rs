//! A direct reading of expressions, on dual numbers.

use std::collections::HashMap;

use super::atan_ratio;
use hardpoint_codegen::expression::{Expression, Kind, Operator};
use hardpoint_codegen::validate::Heading;
use num_dual::{Dual64, DualNum as _, DualStruct as _, HyperDual};

/// Third-order dual numbers: the force of an energy has second derivatives already.
pub type Number = HyperDual<Dual64>;

#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "a handful of short-lived values")]
pub enum Value {
    Scalar(Number),
    Vector(Vec<Number>),
    Matrix([[Number; 3]; 3]),
}

/// Arguments of a relation.
#[derive(Clone)]
pub struct Arguments {
    pub q: Vec<Number>,
    pub d: Vec<Number>,
    pub v: Vec<Number>,
    pub h: Vec<Number>,
}

/// Reads expressions as they stand.
pub struct Reader<'a> {
    arguments: &'a Arguments,
    names: HashMap<&'a str, Value>,
}

impl<'a> Reader<'a> {
    pub fn new(heading: &'a Heading, arguments: &'a Arguments) -> Self {
        let mut reader = Self { arguments, names: HashMap::new() };
        for parameter in &heading.parameters {
            let value = if parameter.size == 1 {
                Value::Scalar(arguments.h[parameter.offset])
            } else {
                Value::Vector(arguments.h[parameter.offset..][..3].to_vec())
            };
            reader.names.insert(&parameter.name, value);
        }
        for (name, expression) in &heading.definitions {
            let value = reader.value(expression);
            reader.names.insert(name, value);
        }
        reader
    }

    fn given(&self, name: &str) -> Option<Value> {
        let (stem, body) = name.rsplit_once('_')?;
        let at = if body == "j" { 7 } else { 0 };
        let [q, d, v] = [&self.arguments.q, &self.arguments.d, &self.arguments.v]
            .map(|numbers| &numbers[at..at + 7]);
        match stem {
            "r" => Some(Value::Vector(q[..3].to_vec())),
            "p" => Some(Value::Vector(q[3..].to_vec())),
            "A" => Some(Value::Matrix(rotation(&q[3..]))),
            "delta_r" => Some(Value::Vector(d[..3].to_vec())),
            "delta_theta" => {
                let turned = cross(&q[4..], &d[4..]);
                let component = |k: usize| {
                    ((q[3] * d[4 + k] - d[3] * q[4 + k]) + turned[k]) * Number::from(2.0)
                };
                Some(Value::Vector((0..3).map(component).collect()))
            }
            "velocity" => Some(Value::Vector(v[..3].to_vec())),
            "omega" => {
                // G = [−e, e0 1 − ẽ] (Haug, section 9.3).
                let rows = [
                    [-q[4], q[3], q[6], -q[5]],
                    [-q[5], -q[6], q[3], q[4]],
                    [-q[6], q[5], -q[4], q[3]],
                ];
                let two = Number::from(2.0);
                Some(Value::Vector(rows.iter().map(|row| dot(row, &v[3..]) * two).collect()))
            }
            _ => None,
        }
    }

    pub fn value(&self, expression: &Expression) -> Value {
        match &expression.kind {
            Kind::Number(a, b) => Value::Scalar(Number::from(*a as f64 / *b as f64)),
            Kind::Name(name) => {
                self.given(name).unwrap_or_else(|| self.names[name.as_str()].clone())
            }
            Kind::Negate(inner) => scale(self.value(inner), Number::from(-1.0)),
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
                    ("atan_ratio", [Value::Scalar(a)]) => {
                        // Taylor's series ends where a product of infinitesimals vanishes.
                        let (at, step) = (a.re(), *a - a.re());
                        let series = (0..4).rev().fold(Number::from(0.0), |sum, n: u8| {
                            (sum * step) / f64::from(n + 1) + atan_ratio(at, n)
                        });
                        Value::Scalar(series)
                    }
                    ("atan2", [Value::Scalar(y), Value::Scalar(x)]) => Value::Scalar(y.atan2(*x)),
                    other => panic!("{other:?} was accepted"),
                }
            }
        }
    }
}

/// The rotation matrix, homogeneous of second degree in p as the language defines it.
fn rotation(p: &[Number]) -> [[Number; 3]; 3] {
    let (e0, e) = (p[0], &p[1..]);
    let diagonal = e0 * e0 - dot(e, e);
    let two = Number::from(2.0);
    let tilde = [
        [Number::from(0.0), -e[2], e[1]],
        [e[2], Number::from(0.0), -e[0]],
        [-e[1], e[0], Number::from(0.0)],
    ];
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let entry = (e[row] * e[column] + e0 * tilde[row][column]) * two;
            if row == column { entry + diagonal } else { entry }
        })
    })
}

pub fn components(value: Value) -> Vec<Number> {
    match value {
        Value::Scalar(scalar) => vec![scalar],
        Value::Vector(vector) => vector,
        Value::Matrix(_) => panic!("a matrix has no list of components"),
    }
}

fn dot(a: &[Number], b: &[Number]) -> Number {
    a.iter().zip(b).fold(Number::from(0.0), |sum, (&a, &b)| sum + a * b)
}

fn cross(a: &[Number], b: &[Number]) -> Vec<Number> {
    (0..3)
        .map(|k| {
            let (l, m) = ((k + 1) % 3, (k + 2) % 3);
            a[l] * b[m] - a[m] * b[l]
        })
        .collect()
}

fn scale(value: Value, factor: Number) -> Value {
    match value {
        Value::Scalar(scalar) => Value::Scalar(scalar * factor),
        Value::Vector(vector) => Value::Vector(vector.into_iter().map(|x| x * factor).collect()),
        Value::Matrix(rows) => Value::Matrix(rows.map(|row| row.map(|x| x * factor))),
    }
}

fn binary(operator: Operator, a: Value, b: Value) -> Value {
    match (operator, a, b) {
        (Operator::Subtract, a, b) => binary(Operator::Add, a, scale(b, Number::from(-1.0))),
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
