//! Checks names, shapes and units of a relation and gives it the form that can be differentiated.

use std::collections::HashMap;
use std::ops::Range;

use crate::definition::{Definition, ParameterDefinition, Text, closest};
use crate::expression::{self, Expression, Kind, Operator};
use crate::source::{Mistake, Source};
use crate::unit::Unit;

/// The most equations that one relation may have.
pub const MOST_EQUATIONS: usize = 12;
/// The most parameter components that one relation may have.
pub const MOST_PARAMETERS: usize = 48;

/// A relation whose every name, shape and unit is right.
#[derive(Clone, Debug)]
pub struct Relation {
    /// Name of the file without its ending.
    pub name: String,
    /// Title in words.
    pub title: String,
    /// The equation for readers.
    pub equation: String,
    /// Where the equation comes from.
    pub reference: String,
    /// 1 or 2.
    pub bodies: usize,
    /// Length of Φ.
    pub equations: usize,
    /// Unit of Φ.
    pub unit: Unit,
    /// Φ.
    pub residual: Expression,
    /// Virtual motion that the force works on.
    pub work: Option<Expression>,
    /// Named intermediates in the order of the file.
    pub definitions: Vec<(String, Expression)>,
    /// Parameters in the order of the file.
    pub parameters: Vec<Parameter>,
}

/// A parameter of a relation.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The name that expressions use.
    pub name: String,
    /// Number of components: 1 or 3.
    pub size: usize,
    /// Position of the first component in h.
    pub offset: usize,
    /// Unit as written.
    pub unit: String,
    /// `body i`, `body j`, `ground`, or empty for a number.
    pub frame: String,
    /// What it is, in words.
    pub meaning: String,
}

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
    fn words(self) -> String {
        match self {
            Self::Scalar => "a number".to_owned(),
            Self::Vector(size) => format!("a vector of {size}"),
            Self::Matrix => "a 3×3 matrix".to_owned(),
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Quantity {
    shape: Shape,
    unit: Unit,
}

/// The names that every relation may use: shape and unit for one body.
const GIVEN: [(&str, Shape, Unit); 5] = [
    ("r", Shape::Vector(3), Unit::METRE),
    ("A", Shape::Matrix, Unit::ONE),
    ("p", Shape::Vector(4), Unit::ONE),
    ("delta_r", Shape::Vector(3), Unit::METRE),
    ("delta_theta", Shape::Vector(3), Unit::ONE),
];

/// Names that generated code uses for something else.
const TAKEN: [&str; 9] = [
    "coordinates",
    "kernels",
    "operations",
    "parameter",
    "place",
    "relation",
    "s",
    "scalar",
    "shape",
];

const FUNCTIONS: [&str; 7] = ["dot", "cross", "norm", "transpose", "sqrt", "sin", "cos"];

/// Checks a relation.
///
/// # Errors
/// All mistakes in names, shapes and units, together with those found before.
pub fn check(
    source: &Source,
    definition: &Definition,
    mistakes: Vec<Mistake>,
) -> Result<Relation, Vec<Mistake>> {
    let mut checker = Checker { mistakes, ..Checker::default() };
    checker.file_name(source);
    let parameters = checker.parameters(definition);
    let mut definitions = Vec::new();
    for (name, text) in &definition.definitions {
        checker.new_name(name);
        let expression = checker.parse(text);
        let quantity = expression.as_ref().and_then(|expression| checker.quantity(expression));
        checker.names.insert(name.text.clone(), quantity);
        checker.unused.push((name.text.clone(), name.span.clone()));
        definitions.extend(expression.map(|expression| (name.text.clone(), expression)));
    }
    let residual = checker.parse(&definition.residual);
    let phi = residual.as_ref().and_then(|residual| checker.quantity(residual));
    checker.virtual_motion = true;
    let work = definition.work.as_ref().and_then(|text| checker.parse(text));
    let motion = work.as_ref().and_then(|work| checker.quantity(work));
    checker.whole(definition, phi, motion);
    if !checker.mistakes.is_empty() {
        checker.mistakes.sort_by_key(|mistake| mistake.span.start);
        return Err(checker.mistakes);
    }
    let phi = phi.ok_or_else(Vec::new)?;
    Ok(Relation {
        name: source.name.clone(),
        title: definition.title.text.clone(),
        equation: definition.equation.text.clone(),
        reference: definition.reference.text.clone(),
        bodies: if checker.body_j { 2 } else { 1 },
        equations: equations(phi.shape),
        unit: phi.unit,
        residual: residual.ok_or_else(Vec::new)?,
        work,
        definitions,
        parameters,
    })
}

fn equations(shape: Shape) -> usize {
    if let Shape::Vector(size) = shape { size } else { 1 }
}

#[derive(Default)]
struct Checker {
    /// Parameters and definitions; `None` where a mistake was already told.
    names: HashMap<String, Option<Quantity>>,
    unused: Vec<(String, Range<usize>)>,
    body_i: bool,
    body_j: bool,
    virtual_motion: bool,
    mistakes: Vec<Mistake>,
}

impl Checker {
    fn report(&mut self, span: &Range<usize>, message: impl Into<String>, help: impl Into<String>) {
        self.mistakes.push(Mistake::new(span.clone(), message, help));
    }

    fn file_name(&mut self, source: &Source) {
        let name = &source.name;
        let plain = name.starts_with(|c: char| c.is_ascii_lowercase())
            && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
        if !plain {
            self.report(
                &(0..0),
                format!("the file name `{name}` cannot name a Rust module"),
                "name the file in lower case letters, digits and underscores, as `in_plane.toml`",
            );
        } else if TAKEN.contains(&name.as_str()) || syn::parse_str::<syn::Ident>(name).is_err() {
            self.report(
                &(0..0),
                format!("the file name `{name}` has another meaning in Rust or in the kernels"),
                "give the file another name, such as two words: `in_plane.toml`",
            );
        }
    }

    fn parameters(&mut self, definition: &Definition) -> Vec<Parameter> {
        let mut offset = 0;
        let mut parameters = Vec::new();
        for parameter in &definition.parameters {
            self.new_name(&parameter.name);
            let unit = parameter.unit.as_ref().and_then(|unit| self.unit(unit));
            let frame = self.frame(parameter);
            let shape = match parameter.size {
                Some(1) => Some(Shape::Scalar),
                size => size.map(Shape::Vector),
            };
            let quantity = shape.zip(unit).map(|(shape, unit)| Quantity { shape, unit });
            self.names.insert(parameter.name.text.clone(), quantity);
            self.unused.push((parameter.name.text.clone(), parameter.name.span.clone()));
            let text =
                |text: &Option<Text>| text.as_ref().map_or_else(String::new, |t| t.text.clone());
            let size = parameter.size.unwrap_or(0);
            parameters.push(Parameter {
                name: parameter.name.text.clone(),
                size,
                offset,
                unit: text(&parameter.unit),
                frame,
                meaning: text(&parameter.meaning),
            });
            offset += size;
        }
        if offset > MOST_PARAMETERS {
            self.report(
                &definition.residual.span,
                format!("the parameters have {offset} components together"),
                format!("a relation may have {MOST_PARAMETERS}; make two relations of it"),
            );
        }
        parameters
    }

    fn unit(&mut self, unit: &Text) -> Option<Unit> {
        Unit::parse(&unit.text)
            .map_err(|part| {
                self.report(
                    &unit.span,
                    format!("the unit `{part}` is not known"),
                    "units are products and powers of m, kg, s, rad, N and J, as `N*m/rad`; \
                     `1` has no dimension",
                );
            })
            .ok()
    }

    fn frame(&mut self, parameter: &ParameterDefinition) -> String {
        let known = ["body i", "body j", "ground"];
        match (&parameter.frame, parameter.size) {
            (None, Some(3)) => self.report(
                &parameter.name.span,
                format!("vector `{}` has no frame", parameter.name.text),
                "say what its components refer to: `frame = \"body i\"`, `\"body j\"` or `\"ground\"`",
            ),
            (Some(frame), Some(1)) => self.report(
                &frame.span,
                format!("number `{}` has a frame", parameter.name.text),
                "leave out `frame`; only vectors have one",
            ),
            (Some(frame), _) if !known.contains(&frame.text.as_str()) => self.report(
                &frame.span,
                format!("the frame `{}` is not known", frame.text),
                "write `body i`, `body j` or `ground`",
            ),
            _ => {}
        }
        parameter.frame.as_ref().map_or_else(String::new, |frame| frame.text.clone())
    }

    fn new_name(&mut self, name: &Text) {
        let text = &name.text;
        if given(text).is_some() || FUNCTIONS.contains(&text.as_str()) {
            self.report(
                &name.span,
                format!("`{text}` has a meaning already"),
                "choose a name that is not given; constraints/README.md lists those",
            );
        } else if self.names.contains_key(text) {
            self.report(
                &name.span,
                format!("`{text}` names two things"),
                "give a parameter and a definition different names",
            );
        } else if syn::parse_str::<syn::Ident>(text).is_err() {
            self.report(
                &name.span,
                format!("`{text}` cannot be used as a name"),
                "use letters, digits and underscores, and no word of the Rust language",
            );
        }
    }

    fn parse(&mut self, text: &Text) -> Option<Expression> {
        expression::parse(text).map_err(|mistakes| self.mistakes.extend(mistakes)).ok()
    }

    /// What concerns the relation as a whole.
    fn whole(&mut self, definition: &Definition, phi: Option<Quantity>, work: Option<Quantity>) {
        let span = &definition.residual.span;
        match phi.map(|phi| phi.shape) {
            Some(Shape::Matrix) => {
                self.report(span, "the residual is a matrix", "list the entries that must vanish");
            }
            Some(shape) if equations(shape) > MOST_EQUATIONS => {
                let count = equations(shape);
                self.report(
                    span,
                    format!("the residual has {count} equations"),
                    format!("a relation may have {MOST_EQUATIONS}; make two relations of it"),
                );
            }
            _ => {}
        }
        if let (Some(phi), Some(work), Some(text)) = (phi, work, &definition.work)
            && phi.shape != work.shape
        {
            let message =
                format!("work is {}, but the residual {}", work.shape.words(), phi.shape.words());
            self.report(&text.span, message, "give work one row for each equation");
        }
        // After a mistake in an expression a name may only seem to be unused.
        if self.mistakes.is_empty() {
            if !self.body_i {
                let help = if self.body_j {
                    "a relation of one body speaks of body i: use r_i, A_i, p_i"
                } else {
                    "use r_i, A_i or p_i, and r_j, A_j, p_j for the second body"
                };
                self.report(span, "the relation does not depend on body i", help);
            }
            for (name, span) in std::mem::take(&mut self.unused) {
                let message = format!("`{name}` is never used");
                self.report(&span, message, "use it or delete its line");
            }
        }
    }

    fn quantity(&mut self, expression: &Expression) -> Option<Quantity> {
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
            size += equations(quantity.shape);
        }
        if size == 0 {
            self.report(span, "the list is empty", "list at least one number or vector");
        }
        unit.map(|unit| Quantity { shape: Shape::Vector(size), unit })
    }

    fn name(&mut self, name: &str, span: &Range<usize>) -> Option<Quantity> {
        if let Some((quantity, body, is_virtual)) = given(name) {
            if is_virtual && !self.virtual_motion {
                self.report(
                    span,
                    format!("`{name}` is a virtual motion"),
                    "virtual motions stand only in `work`",
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
            ("sin" | "cos", [Scalar]) if arguments[0].unit == Unit::ONE => {
                return quantity(Scalar, Unit::ONE);
            }
            ("dot", _) => "two vectors of one size",
            ("cross", _) => "two vectors of 3",
            ("norm", _) => "a vector",
            ("transpose", _) => "a 3×3 matrix",
            ("sqrt", _) => "a number",
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

fn given(name: &str) -> Option<(Quantity, char, bool)> {
    let (stem, body) = name.rsplit_once('_')?;
    let body = match body {
        "i" => 'i',
        "j" => 'j',
        _ => return None,
    };
    let (_, shape, unit) = *GIVEN.iter().find(|(given, ..)| *given == stem)?;
    Some((Quantity { shape, unit }, body, stem.starts_with("delta")))
}
