//! Checks names, shapes and units of a relation and gives it the form that can be differentiated.

use crate::definition::{Definition, ParameterDefinition, Text};
use crate::expression::{self, Expression};
use crate::quantity::{Checker, FUNCTIONS, Quantity, Shape, given};
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
        equations: phi.shape.size(),
        unit: phi.unit,
        residual: residual.ok_or_else(Vec::new)?,
        work,
        definitions,
        parameters,
    })
}

impl Checker {
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
            Some(shape) if shape.size() > MOST_EQUATIONS => {
                let count = shape.size();
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
}
