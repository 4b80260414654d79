//! Checks names, shapes and units of a file and gives it the form that can be differentiated.

use std::ops::Range;

use crate::definition::{Definition, ParameterDefinition, Statement, Text};
use crate::expression::{self, Expression, Kind};
use crate::quantity::{Checker, FUNCTIONS, Place, Quantity, Shape, given};
use crate::source::{Mistake, Source};
use crate::unit::Unit;

/// The most equations that one relation may have.
pub const MOST_EQUATIONS: usize = 12;
/// The most parameter components that one relation may have.
pub const MOST_PARAMETERS: usize = 48;

/// What every file has.
#[derive(Clone, Debug)]
pub struct Heading {
    /// Name of the file without its ending.
    pub name: String,
    /// Title in words.
    pub title: String,
    /// The equation for readers.
    pub equation: String,
    /// Where the equation comes from.
    pub reference: String,
    /// Named intermediates in the order of the file.
    pub definitions: Vec<(String, Expression)>,
    /// Parameters in the order of the file.
    pub parameters: Vec<Parameter>,
}

impl Heading {
    /// Number of components of h.
    pub fn parameter_count(&self) -> usize {
        self.parameters.iter().map(|parameter| parameter.size).sum()
    }
}

/// A relation whose every name, shape and unit is right.
#[derive(Clone, Debug)]
pub struct Relation {
    /// Names, definitions and parameters.
    pub heading: Heading,
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
}

/// A kinetic energy whose every name, shape and unit is right.
#[derive(Clone, Debug)]
pub struct Energy {
    /// Names, definitions and parameters.
    pub heading: Heading,
    /// T.
    pub energy: Expression,
}

/// A file without mistakes.
#[derive(Clone, Debug)]
pub enum Checked {
    /// It states a relation.
    Relation(Relation),
    /// It states a kinetic energy.
    Energy(Energy),
}

impl Checked {
    /// What every file has.
    pub fn heading(&self) -> &Heading {
        match self {
            Self::Relation(relation) => &relation.heading,
            Self::Energy(energy) => &energy.heading,
        }
    }
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
const TAKEN: [&str; 12] = [
    "coordinates",
    "energy_shape",
    "kernels",
    "kinetic_energy",
    "motion",
    "operations",
    "parameter",
    "place",
    "relation",
    "s",
    "scalar",
    "shape",
];

/// Checks a file.
///
/// # Errors
/// All mistakes in names, shapes and units, together with those found before.
pub fn check(
    source: &Source,
    definition: &Definition,
    mistakes: Vec<Mistake>,
) -> Result<Checked, Vec<Mistake>> {
    let place = match definition.statement {
        Statement::Relation { .. } => Place::Anywhere,
        Statement::Energy(_) => Place::Energy,
    };
    let mut checker = Checker::new(place, mistakes);
    let heading = checker.heading(source, definition);
    let checked = match &definition.statement {
        Statement::Relation { residual, work } => {
            checker.relation(heading, residual, work.as_ref()).map(Checked::Relation)
        }
        Statement::Energy(energy) => checker.energy(heading, energy).map(Checked::Energy),
    };
    checker.mistakes.sort_by_key(|mistake| mistake.span.start);
    checked.filter(|_| checker.mistakes.is_empty()).ok_or(checker.mistakes)
}

impl Checker {
    fn heading(&mut self, source: &Source, definition: &Definition) -> Heading {
        self.file_name(source);
        let parameters = self.parameters(definition);
        let mut definitions = Vec::new();
        for (name, text) in &definition.definitions {
            self.new_name(name);
            let expression = self.parse(text);
            let quantity = expression.as_ref().and_then(|expression| self.quantity(expression));
            self.names.insert(name.text.clone(), quantity);
            self.unused.push((name.text.clone(), name.span.clone()));
            definitions.extend(expression.map(|expression| (name.text.clone(), expression)));
        }
        Heading {
            name: source.name.clone(),
            title: definition.title.text.clone(),
            equation: definition.equation.text.clone(),
            reference: definition.reference.text.clone(),
            definitions,
            parameters,
        }
    }

    fn relation(
        &mut self,
        heading: Heading,
        residual_text: &Text,
        work_text: Option<&Text>,
    ) -> Option<Relation> {
        let residual = self.parse(residual_text);
        let mut phi = residual.as_ref().and_then(|residual| self.quantity(residual));
        self.place = Place::Work;
        let work = work_text.and_then(|text| self.parse(text));
        let motion = work.as_ref().and_then(|work| self.quantity(work));
        // A load that sees nothing has its multiplier all the same, which needs a unit.
        let is_zero = |residual: &Expression| matches!(residual.kind, Kind::Number(0, _));
        if let (Some(phi), Some(motion)) = (&mut phi, motion)
            && residual.as_ref().is_some_and(is_zero)
        {
            phi.unit = motion.unit;
        }
        self.sizes(&residual_text.span, phi, work_text.zip(motion));
        self.whole(&residual_text.span, "relation");
        let phi = phi?;
        Some(Relation {
            heading,
            bodies: if self.body_j { 2 } else { 1 },
            equations: phi.shape.size(),
            unit: phi.unit,
            residual: residual?,
            work,
        })
    }

    fn energy(&mut self, heading: Heading, text: &Text) -> Option<Energy> {
        let energy = self.parse(text);
        match energy.as_ref().and_then(|energy| self.quantity(energy)) {
            Some(Quantity { shape, .. }) if shape != Shape::Scalar => self.report(
                &text.span,
                format!("the energy is {}", shape.words()),
                "an energy is one number",
            ),
            Some(Quantity { unit, .. }) if unit != Unit::JOULE => self.report(
                &text.span,
                format!("the energy has the unit {unit}"),
                format!("an energy is in joule, {}", Unit::JOULE),
            ),
            _ => {}
        }
        self.whole(&text.span, "energy");
        Some(Energy { heading, energy: energy? })
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
                &definition.statement.text().span,
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

    /// Whether residual and work have the number of equations that they may have.
    fn sizes(
        &mut self,
        span: &Range<usize>,
        phi: Option<Quantity>,
        work: Option<(&Text, Quantity)>,
    ) {
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
        if let (Some(phi), Some((text, work))) = (phi, work)
            && phi.shape != work.shape
        {
            let message =
                format!("work is {}, but the residual {}", work.shape.words(), phi.shape.words());
            self.report(&text.span, message, "give work one row for each equation");
        }
    }

    /// What concerns the file as a whole.
    fn whole(&mut self, span: &Range<usize>, what: &str) {
        // After a mistake in an expression a name may only seem to be unused.
        if self.mistakes.is_empty() {
            if !self.body_i {
                let help = if self.body_j {
                    "a relation of one body speaks of body i: use r_i, A_i, p_i"
                } else if self.place == Place::Energy {
                    "use velocity_i and omega_i"
                } else {
                    "use r_i, A_i or p_i, and r_j, A_j, p_j for the second body"
                };
                self.report(span, format!("the {what} does not depend on body i"), help);
            }
            for (name, span) in std::mem::take(&mut self.unused) {
                let message = format!("`{name}` is never used");
                self.report(&span, message, "use it or delete its line");
            }
        }
    }
}
