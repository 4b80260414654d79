//! Shapes and units of expressions.

use std::collections::HashMap;
use std::ops::Range;

use crate::definition::closest;
use crate::expression::{Expression, Kind, Operator};
use crate::source::Mistake;
use crate::unit::Unit;

/// Number of components of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// A vector of so many components.
    Vector(usize),
    /// A 3×3 matrix.
    Matrix,
}

impl Shape {
    /// Number of components of a number or vector.
    pub(crate) fn size(self) -> usize {
        if let Self::Vector(size) = self { size } else { 1 }
    }

    pub(crate) fn words(self) -> String {
        match self {
            Self::Scalar => "a number".to_owned(),
            Self::Vector(size) => format!("a vector of {size}"),
            Self::Matrix => "a 3×3 matrix".to_owned(),
        }
    }
}

/// Shape and unit of an expression.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quantity {
    pub shape: Shape,
    pub unit: Unit,
}

/// Where a given name may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// In every expression.
    Anywhere,
    /// In `work`.
    Work,
    /// In `energy` and its definitions.
    Energy,
}

/// The given names: shape and unit for one body, and where they may stand.
const GIVEN: [(&str, Shape, Unit, Place); 7] = [
    ("r", Shape::Vector(3), Unit::METRE, Place::Anywhere),
    ("A", Shape::Matrix, Unit::ONE, Place::Anywhere),
    ("p", Shape::Vector(4), Unit::ONE, Place::Anywhere),
    ("delta_r", Shape::Vector(3), Unit::METRE, Place::Work),
    ("delta_theta", Shape::Vector(3), Unit::ONE, Place::Work),
    ("velocity", Shape::Vector(3), Unit::METRE_PER_SECOND, Place::Energy),
    ("omega", Shape::Vector(3), Unit::PER_SECOND, Place::Energy),
];

/// The functions of the language.
pub(crate) const FUNCTIONS: [&str; 9] =
    ["dot", "cross", "norm", "transpose", "sqrt", "sin", "cos", "atan2", "atan_ratio"];

/// What is known while a file is checked, and the mistakes found so far.
pub(crate) struct Checker {
    /// Parameters and definitions; `None` where a mistake was already told.
    pub names: HashMap<String, Option<Quantity>>,
    pub unused: Vec<(String, Range<usize>)>,
    pub body_i: bool,
    pub body_j: bool,
    /// Where the expression stands that is checked.
    pub place: Place,
    pub mistakes: Vec<Mistake>,
}

impl Checker {
    pub fn new(place: Place, mistakes: Vec<Mistake>) -> Self {
        Self {
            names: HashMap::new(),
            unused: Vec::new(),
            body_i: false,
            body_j: false,
            place,
            mistakes,
        }
    }

    pub fn report(
        &mut self,
        span: &Range<usize>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.mistakes.push(Mistake::new(span.clone(), message, help));
    }

    /// Shape and unit of an expression; `None` after a mistake, which then was told.
    pub fn quantity(&mut self, expression: &Expression) -> Option<Quantity> {
        let span = &expression.span;
        match &expression.kind {
            Kind::Number(..) => Some(Quantity { shape: Shape::Scalar, unit: Unit::ONE }),
            Kind::Name(name) => self.name(name, span),
            Kind::Negate(inner) => self.quantity(inner),
            Kind::Binary(operator, left, right) => {
                let left = self.quantity(left);
                let right = self.quantity(right);
                self.binary(*operator, left?, right?, span)
            }
            Kind::Call(name, arguments) => {
                let quantities: Vec<_> =
                    arguments.iter().map(|argument| self.quantity(argument)).collect();
                self.call(name, &quantities.into_iter().collect::<Option<Vec<_>>>()?, span)
            }
            Kind::Component(inner, component) => {
                let inner = self.quantity(inner)?;
                match inner.shape {
                    Shape::Vector(size) if *component < size => {
                        Some(Quantity { shape: Shape::Scalar, unit: inner.unit })
                    }
                    shape => {
                        self.report(
                            span,
                            format!("{} has no component {component}", shape.words()),
                            "the components of a vector are counted from 0",
                        );
                        None
                    }
                }
            }
            Kind::List(parts) => self.list(parts, span),
        }
    }

    fn list(&mut self, parts: &[Expression], span: &Range<usize>) -> Option<Quantity> {
        let quantities: Vec<_> =
            parts.iter().map(|part| (self.quantity(part), &part.span)).collect();
        let mut size = 0;
        let mut unit = None;
        for (quantity, span) in quantities {
            let quantity = quantity?;
            if quantity.shape == Shape::Matrix {
                self.report(span, "a list cannot hold a matrix", "list numbers and vectors");
                return None;
            }
            let first = *unit.get_or_insert(quantity.unit);
            if first != quantity.unit {
                self.report(
                    span,
                    format!("the list has the unit {first}, but this entry {}", quantity.unit),
                    "all entries of a list need one unit; multiply by a length where it must be",
                );
                return None;
            }
            size += quantity.shape.size();
        }
        if size == 0 {
            self.report(span, "the list is empty", "list at least one number or vector");
        }
        unit.map(|unit| Quantity { shape: Shape::Vector(size), unit })
    }

    fn name(&mut self, name: &str, span: &Range<usize>) -> Option<Quantity> {
        if let Some((quantity, body, place)) = given(name) {
            if place != Place::Anywhere && place != self.place {
                let (what, help) = if place == Place::Work {
                    ("a virtual motion", "virtual motions stand only in `work`")
                } else {
                    ("a velocity", "velocities stand only in files that state an `energy`")
                };
                self.report(span, format!("`{name}` is {what}"), help);
                return None;
            }
            if self.place == Place::Energy && body == 'j' {
                self.report(
                    span,
                    format!("`{name}` is of a second body"),
                    "a kinetic energy is that of one body, body i",
                );
                return None;
            }
            *(if body == 'i' { &mut self.body_i } else { &mut self.body_j }) = true;
            return Some(quantity);
        }
        self.unused.retain(|(unused, _)| unused != name);
        if let Some(quantity) = self.names.get(name) {
            return *quantity;
        }
        let known = self.names.keys().map(String::as_str).chain(FUNCTIONS);
        let help = match closest(name, known) {
            Some(close) => format!("did you mean `{close}`?"),
            None => "given are r_i, A_i, p_i, r_j, A_j, p_j; declare others under [parameters] \
                     or, above their use, under [definitions]"
                .to_owned(),
        };
        self.report(span, format!("`{name}` is not known"), help);
        None
    }

    fn binary(
        &mut self,
        operator: Operator,
        left: Quantity,
        right: Quantity,
        span: &Range<usize>,
    ) -> Option<Quantity> {
        use Shape::{Matrix, Scalar, Vector};
        let words = (left.shape.words(), right.shape.words());
        match operator {
            Operator::Add | Operator::Subtract => {
                let verb = if operator == Operator::Add { "added" } else { "subtracted" };
                if left.shape != right.shape {
                    let message = format!("{} and {} cannot be {verb}", words.0, words.1);
                    self.report(span, message, "both sides need one shape");
                    None
                } else if left.unit != right.unit {
                    let message =
                        format!("units {} and {} cannot be {verb}", left.unit, right.unit);
                    self.report(span, message, "both sides need one unit");
                    None
                } else {
                    Some(left)
                }
            }
            Operator::Multiply => {
                let shape = match (left.shape, right.shape) {
                    (Scalar, shape) | (shape, Scalar) => shape,
                    (Matrix, Vector(3)) => Vector(3),
                    (Matrix, Matrix) => Matrix,
                    _ => {
                        self.report(
                            span,
                            format!("{} and {} cannot be multiplied", words.0, words.1),
                            "write dot(a, b) or cross(a, b) for vectors, and the matrix on the left",
                        );
                        return None;
                    }
                };
                Some(Quantity { shape, unit: left.unit.times(right.unit) })
            }
            Operator::Divide if right.shape == Scalar => {
                Some(Quantity { shape: left.shape, unit: left.unit.over(right.unit) })
            }
            Operator::Divide => {
                let message = format!("division by {} has no meaning", words.1);
                self.report(span, message, "divide by a number");
                None
            }
        }
    }

    fn call(
        &mut self,
        name: &str,
        arguments: &[Quantity],
        span: &Range<usize>,
    ) -> Option<Quantity> {
        use Shape::{Matrix, Scalar, Vector};
        if matches!(name, "abs" | "min" | "max" | "sign" | "floor" | "powf" | "pow") {
            self.report(
                span,
                format!("`{name}` is not smooth or not exact"),
                "kernels have derivatives everywhere: choices, stops and tables belong into force \
                 laws, powers are products",
            );
            return None;
        }
        let shapes: Vec<_> = arguments.iter().map(|argument| argument.shape).collect();
        let quantity = |shape, unit| Some(Quantity { shape, unit });
        let expected = match (name, shapes.as_slice()) {
            ("dot", [Vector(a), Vector(b)]) if a == b => {
                return quantity(Scalar, arguments[0].unit.times(arguments[1].unit));
            }
            ("cross", [Vector(3), Vector(3)]) => {
                return quantity(Vector(3), arguments[0].unit.times(arguments[1].unit));
            }
            ("norm", [Vector(_)]) => return quantity(Scalar, arguments[0].unit),
            ("transpose", [Matrix]) => return quantity(Matrix, arguments[0].unit),
            ("sqrt", [Scalar]) => match arguments[0].unit.root() {
                Some(unit) => return quantity(Scalar, unit),
                None => "a number whose unit has a root",
            },
            ("sin" | "cos" | "atan_ratio", [Scalar]) if arguments[0].unit == Unit::ONE => {
                return quantity(Scalar, Unit::ONE);
            }
            ("atan2", [Scalar, Scalar]) if arguments[0].unit == arguments[1].unit => {
                return quantity(Scalar, Unit::ONE);
            }
            ("dot", _) => "two vectors of one size",
            ("cross", _) => "two vectors of 3",
            ("norm", _) => "a vector",
            ("transpose", _) => "a 3×3 matrix",
            ("sqrt", _) => "a number",
            ("atan2", _) => "two numbers of one unit, the sine of the angle first",
            ("atan_ratio", _) => "a number without dimension, larger than -1",
            ("sin" | "cos", _) => "a number without dimension, an angle in radians",
            _ => {
                let help = match closest(name, FUNCTIONS.into_iter()) {
                    Some(close) => format!("did you mean `{close}`?"),
                    None => format!("the functions are {}", FUNCTIONS.join(", ")),
                };
                self.report(span, format!("there is no function `{name}`"), help);
                return None;
            }
        };
        self.report(
            span,
            format!("`{name}` does not fit what it is given"),
            format!("give it {expected}"),
        );
        None
    }
}

/// Shape and unit of a given name, its body, and where it may stand.
pub(crate) fn given(name: &str) -> Option<(Quantity, char, Place)> {
    let (stem, body) = name.rsplit_once('_')?;
    let body = match body {
        "i" => 'i',
        "j" => 'j',
        _ => return None,
    };
    let (_, shape, unit, place) = *GIVEN.iter().find(|(given, ..)| *given == stem)?;
    Some((Quantity { shape, unit }, body, place))
}
