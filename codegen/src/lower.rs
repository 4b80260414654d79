//! From checked expressions to symbolic ones over named intermediates.

use std::collections::HashMap;
use std::ops::Range;

use symbolica::prelude::{Atom, Symbol};

use crate::algebra::{Algebra, Function};
use crate::alphabet::Alphabet;
use crate::expression::{Expression, Kind, Operator};
use crate::validate::Heading;

/// What can be wrong with a relation only when it is differentiated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// An equation does not depend on any coordinate.
    ConstantEquation(usize),
    /// A row of `work` is not linear in the virtual motion.
    NonlinearWork(usize),
    /// A row of `work` has no virtual motion in it.
    ConstantWork(usize),
    /// A quotient, at this place of the file, whose divisor is zero for all values of the inputs.
    ZeroDivisor(Range<usize>),
    /// A root, at this place of the file, of zero or a negative number.
    RootOfConstant(Range<usize>),
    /// An `atan_ratio`, at this place of the file, of −1 or a smaller number.
    AtanRatioOfConstant(Range<usize>),
    /// An angle, at this place of the file, of a point that is always the origin.
    AngleOfOrigin(Range<usize>),
    /// An energy does not depend on the velocity.
    NoMass,
    /// An energy is not a polynomial of second degree in the velocity.
    NotQuadratic,
}

/// Expressions of one file as scalars.
pub struct Lowered {
    /// The intermediates that the scalars refer to.
    pub algebra: Algebra,
    /// The components of each expression.
    pub expressions: Vec<Vec<Atom>>,
}

/// Takes vectors and matrices apart and names their parts.
///
/// # Errors
/// Quotients, roots and angles that can have no value.
pub fn lower(
    heading: &Heading,
    expressions: &[&Expression],
    alphabet: &Alphabet,
) -> Result<Lowered, Vec<Flaw>> {
    let mut lowering = Lowering {
        algebra: Algebra::new(alphabet.clone()),
        names: HashMap::new(),
        flaws: Vec::new(),
    };
    lowering.parameters(heading);
    for (name, expression) in &heading.definitions {
        let value = lowering.lower(expression);
        let value = lowering.keep(value);
        lowering.names.insert(name.clone(), value);
    }
    let expressions =
        expressions.iter().map(|expression| lowering.lower(expression).components()).collect();
    if !lowering.flaws.is_empty() {
        return Err(lowering.flaws);
    }
    Ok(Lowered { algebra: lowering.algebra, expressions })
}

/// A value of the language in terms of symbols.
#[derive(Clone)]
enum Value {
    Scalar(Atom),
    Vector(Vec<Atom>),
    Matrix(Vec<Vec<Atom>>),
    /// The rotation matrix of a body, possibly transposed; kept apart, because
    /// its product with a vector has a cheaper form than its nine entries.
    Rotation {
        body: usize,
        transposed: bool,
    },
}

impl Value {
    fn components(self) -> Vec<Atom> {
        match self {
            Self::Vector(components) => components,
            Self::Scalar(scalar) => vec![scalar],
            Self::Matrix(_) | Self::Rotation { .. } => unreachable!("a residual is no matrix"),
        }
    }

    fn scalar(self) -> Atom {
        match self {
            Self::Scalar(scalar) => scalar,
            _ => unreachable!("shapes were checked"),
        }
    }

    fn map(self, mut map: impl FnMut(Atom) -> Atom) -> Self {
        match self {
            Self::Scalar(scalar) => Self::Scalar(map(scalar)),
            Self::Vector(vector) => Self::Vector(vector.into_iter().map(map).collect()),
            Self::Matrix(rows) => Self::Matrix(
                rows.into_iter().map(|row| row.into_iter().map(&mut map).collect()).collect(),
            ),
            Self::Rotation { .. } => unreachable!("rotations are made explicit first"),
        }
    }
}

struct Lowering {
    algebra: Algebra,
    names: HashMap<String, Value>,
    flaws: Vec<Flaw>,
}

impl Lowering {
    fn parameters(&mut self, heading: &Heading) {
        for parameter in &heading.parameters {
            let symbols = &self.algebra.alphabet.parameters[parameter.offset..];
            let value = if parameter.size == 1 {
                Value::Scalar(Atom::var(symbols[0]))
            } else {
                Value::Vector(symbols[..3].iter().map(|&symbol| Atom::var(symbol)).collect())
            };
            self.names.insert(parameter.name.clone(), value);
        }
    }

    /// Gives the parts of a definition names.
    fn keep(&mut self, value: Value) -> Value {
        match value {
            Value::Rotation { .. } => value,
            value => value.map(|atom| self.algebra.name(&atom)),
        }
    }

    fn given(&mut self, name: &str) -> Option<Value> {
        let (stem, body) = name.rsplit_once('_')?;
        let body = usize::from(body == "j");
        let alphabet = &self.algebra.alphabet;
        let slice = |symbols: &[Symbol], from: usize, to: usize| -> Vec<Atom> {
            symbols[7 * body + from..7 * body + to].iter().map(|&s| Atom::var(s)).collect()
        };
        Some(match stem {
            "r" => Value::Vector(slice(&alphabet.coordinates, 0, 3)),
            "p" => Value::Vector(slice(&alphabet.coordinates, 3, 7)),
            "A" => Value::Rotation { body, transposed: false },
            "delta_r" => Value::Vector(slice(&alphabet.virtual_motions, 0, 3)),
            "delta_theta" => {
                let p = slice(&alphabet.coordinates, 3, 7);
                let d = slice(&alphabet.virtual_motions, 3, 7);
                Value::Vector(self.turned(&p, &d, 1))
            }
            "velocity" => Value::Vector(slice(&alphabet.velocities, 0, 3)),
            "omega" => {
                let p = slice(&alphabet.coordinates, 3, 7);
                let v = slice(&alphabet.velocities, 3, 7);
                Value::Vector(self.turned(&p, &v, -1))
            }
            _ => return None,
        })
    }

    /// δθ = 2 (e0 δe − δe0 e ± e × δe) for a change δp: with + in the axes of the ground,
    /// with − in those of the body.
    fn turned(&mut self, p: &[Atom], d: &[Atom], sign: i64) -> Vec<Atom> {
        let turned = cross(&p[1..], &d[1..]);
        (0..3)
            .map(|k| {
                let turned = &turned[k] * Atom::num(sign);
                let half = &p[0] * &d[1 + k] - &d[0] * &p[1 + k] + turned;
                self.algebra.name(&(half * Atom::num(2)))
            })
            .collect()
    }

    /// A s = e0 c + d e + e × c with c = e0 s + e × s and d = e·s; the inverse rotation has −e.
    fn rotate(&mut self, body: usize, transposed: bool, s: &[Atom]) -> Vec<Atom> {
        let p: Vec<Atom> = self.algebra.alphabet.coordinates[7 * body + 3..7 * body + 7]
            .iter()
            .map(|&symbol| Atom::var(symbol))
            .collect();
        let e: Vec<Atom> = p[1..].iter().map(|e| if transposed { -e } else { e.clone() }).collect();
        let d = self.algebra.name(&dot(&e, s));
        let turned = cross(&e, s);
        let c: Vec<Atom> =
            (0..3).map(|k| self.algebra.name(&(&p[0] * &s[k] + &turned[k]))).collect();
        let turned = cross(&e, &c);
        (0..3).map(|k| self.algebra.name(&(&p[0] * &c[k] + &d * &e[k] + &turned[k]))).collect()
    }

    fn times(&mut self, matrix: &Value, vector: &[Atom]) -> Vec<Atom> {
        match matrix {
            Value::Rotation { body, transposed } => self.rotate(*body, *transposed, vector),
            Value::Matrix(rows) => rows.iter().map(|row| dot(row, vector)).collect(),
            _ => unreachable!("shapes were checked"),
        }
    }

    fn explicit(&mut self, value: Value) -> Value {
        let Value::Rotation { .. } = value else {
            return value;
        };
        let columns: Vec<Vec<Atom>> = (0..3)
            .map(|axis| {
                let unit: Vec<Atom> = (0..3).map(|k| Atom::num(i64::from(k == axis))).collect();
                self.times(&value, &unit)
            })
            .collect();
        Value::Matrix(transpose(&columns))
    }

    fn lower(&mut self, expression: &Expression) -> Value {
        match &expression.kind {
            Kind::Number(numerator, denominator) => {
                Value::Scalar(Atom::num(*numerator) / Atom::num(*denominator))
            }
            Kind::Name(name) => self
                .given(name)
                .or_else(|| self.names.get(name).cloned())
                .unwrap_or_else(|| unreachable!("names were checked")),
            Kind::Negate(inner) => {
                let inner = self.lower(inner);
                self.explicit(inner).map(|atom| -atom)
            }
            Kind::Binary(operator, left, right) => {
                let left = self.lower(left);
                let right = self.lower(right);
                self.binary(*operator, left, right, &expression.span)
            }
            Kind::Call(name, arguments) => {
                let arguments = arguments.iter().map(|argument| self.lower(argument)).collect();
                self.call(name, arguments, &expression.span)
            }
            Kind::Component(inner, component) => {
                Value::Scalar(self.lower(inner).components()[*component].clone())
            }
            Kind::List(parts) => {
                Value::Vector(parts.iter().flat_map(|part| self.lower(part).components()).collect())
            }
        }
    }

    fn binary(
        &mut self,
        operator: Operator,
        left: Value,
        right: Value,
        span: &Range<usize>,
    ) -> Value {
        match operator {
            Operator::Add | Operator::Subtract => {
                let sign = if operator == Operator::Add { 1 } else { -1 };
                let add = |a: Atom, b: &Atom| a + b * Atom::num(sign);
                match (self.explicit(left), self.explicit(right)) {
                    (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(add(a, &b)),
                    (Value::Vector(a), Value::Vector(b)) => {
                        Value::Vector(a.into_iter().zip(&b).map(|(a, b)| add(a, b)).collect())
                    }
                    (Value::Matrix(a), Value::Matrix(b)) => Value::Matrix(
                        a.into_iter()
                            .zip(&b)
                            .map(|(a, b)| a.into_iter().zip(b).map(|(a, b)| add(a, b)).collect())
                            .collect(),
                    ),
                    _ => unreachable!("shapes were checked"),
                }
            }
            Operator::Multiply => match (left, right) {
                (Value::Scalar(a), b) => self.explicit(b).map(|b| &a * b),
                (a, Value::Scalar(b)) => self.explicit(a).map(|a| a * &b),
                (matrix, Value::Vector(vector)) => Value::Vector(self.times(&matrix, &vector)),
                (matrix, other) => {
                    let Value::Matrix(rows) = self.explicit(other) else {
                        unreachable!("shapes were checked")
                    };
                    let columns: Vec<_> =
                        transpose(&rows).iter().map(|column| self.times(&matrix, column)).collect();
                    Value::Matrix(transpose(&columns))
                }
            },
            Operator::Divide => {
                let divisor = right.scalar();
                if self.algebra.vanishes(&divisor) {
                    self.flaws.push(Flaw::ZeroDivisor(span.clone()));
                }
                let reciprocal = self.algebra.apply(Function::Reciprocal, &[divisor]);
                self.explicit(left).map(|atom| atom * &reciprocal)
            }
        }
    }

    fn root(&mut self, argument: Atom, span: &Range<usize>) -> Value {
        if self.algebra.is_not_positive(&argument) {
            self.flaws.push(Flaw::RootOfConstant(span.clone()));
        }
        self.apply(Function::Root, &[argument])
    }

    fn angle(&mut self, y: Atom, x: Atom, span: &Range<usize>) -> Value {
        if self.algebra.vanishes(&y) && self.algebra.vanishes(&x) {
            self.flaws.push(Flaw::AngleOfOrigin(span.clone()));
        }
        self.apply(Function::Angle, &[y, x])
    }

    fn atan_ratio(&mut self, argument: Atom, span: &Range<usize>) -> Value {
        if self.algebra.is_not_positive(&(&argument + Atom::one())) {
            self.flaws.push(Flaw::AtanRatioOfConstant(span.clone()));
        }
        self.apply(Function::AtanRatio(0), &[argument])
    }

    fn apply(&mut self, function: Function, arguments: &[Atom]) -> Value {
        Value::Scalar(self.algebra.apply(function, arguments))
    }

    fn call(&mut self, name: &str, arguments: Vec<Value>, span: &Range<usize>) -> Value {
        let mut arguments = arguments.into_iter();
        let mut next = || arguments.next().unwrap_or_else(|| unreachable!("arity was checked"));
        match name {
            "dot" => Value::Scalar(dot(&next().components(), &next().components())),
            "cross" => Value::Vector(cross(&next().components(), &next().components())),
            "norm" => {
                let vector = next().components();
                self.root(dot(&vector, &vector), span)
            }
            "transpose" => match next() {
                Value::Rotation { body, transposed } => {
                    Value::Rotation { body, transposed: !transposed }
                }
                Value::Matrix(rows) => Value::Matrix(transpose(&rows)),
                _ => unreachable!("shapes were checked"),
            },
            "sqrt" => self.root(next().scalar(), span),
            "sin" => self.apply(Function::Sine, &[next().scalar()]),
            "cos" => self.apply(Function::Cosine, &[next().scalar()]),
            "atan_ratio" => self.atan_ratio(next().scalar(), span),
            "atan2" => self.angle(next().scalar(), next().scalar(), span),
            _ => unreachable!("functions were checked"),
        }
    }
}

fn dot(a: &[Atom], b: &[Atom]) -> Atom {
    Atom::add_many(a.iter().zip(b).map(|(a, b)| a * b))
}

fn cross(a: &[Atom], b: &[Atom]) -> Vec<Atom> {
    (0..3)
        .map(|k| {
            let (l, m) = ((k + 1) % 3, (k + 2) % 3);
            &a[l] * &b[m] - &a[m] * &b[l]
        })
        .collect()
}

fn transpose(rows: &[Vec<Atom>]) -> Vec<Vec<Atom>> {
    (0..3).map(|column| rows.iter().map(|row| row[column].clone()).collect()).collect()
}
