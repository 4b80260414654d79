//! Function expressions of Adams: what they measure and what they are worth.
//!
//! Sums and products are kept as lists, so that the depth of an expression is that of its brackets.

use std::collections::BTreeMap;

use super::functions::function;

/// Variables in variables beyond this are a circle.
const DEEPEST: usize = 40;

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Expression {
    Number(f64),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Expression)>),
    /// Factors, each with whether it divides.
    Product(Vec<(bool, Expression)>),
    Power(Box<Expression>, Box<Expression>),
    /// A function or a constant, in capitals, with its arguments.
    Call(String, Vec<Expression>),
}

/// A function of the state: its name with the markers that it measures between.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Measure {
    /// In capitals, such as `DM`.
    pub(super) name: String,
    /// The markers; those that are absent are those of the ground.
    pub(super) markers: Vec<u32>,
}

/// The functions of positions and velocities of markers that forces and constraints are made of.
pub(super) const MEASURES: &[&str] =
    &["DM", "DX", "DY", "DZ", "AX", "AY", "AZ", "VR", "VM", "VX", "VY", "VZ", "WX", "WY", "WZ"];

/// Expressions of more parts, with their variables, are refused.
const LARGEST: usize = 20_000;

/// The time where it is one of the variables of a linear expression.
pub(super) const TIME: &str = "TIME";

/// A constant plus measures times factors.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Linear {
    pub(super) constant: f64,
    pub(super) terms: BTreeMap<Measure, f64>,
}

impl Linear {
    fn add(&mut self, factor: f64, other: &Self) {
        self.constant += factor * other.constant;
        for (measure, by) in &other.terms {
            *self.terms.entry(measure.clone()).or_insert(0.0) += factor * by;
        }
    }
}

/// Gives values to what an expression does not know by itself.
pub(super) trait Context {
    /// The value of a measure.
    fn measure(&self, measure: &Measure) -> Result<f64, String>;
    /// The time (s), where it has one.
    fn time(&self) -> Result<f64, String>;
    /// The expression of a VARIABLE.
    fn variable(&self, id: u32) -> Result<&Expression, String>;
    /// The value of a SPLINE.
    fn spline(&self, function: &str, id: u32, x: f64) -> Result<f64, String>;
}

impl Expression {
    /// The measures in it, each once; those of variables, too.
    pub(super) fn measures(&self, context: &impl Context) -> Result<Vec<Measure>, String> {
        let mut found = vec![];
        self.collect(context, 0, &mut found)?;
        found.sort();
        found.dedup();
        Ok(found)
    }

    fn collect(
        &self,
        context: &impl Context,
        depth: usize,
        found: &mut Vec<Measure>,
    ) -> Result<(), String> {
        if depth > DEEPEST || found.len() > 1000 {
            return Err("its variables go round in a circle".into());
        }
        match self {
            Self::Number(_) => Ok(()),
            Self::Sum(parts) | Self::Product(parts) => {
                parts.iter().try_for_each(|(_, part)| part.collect(context, depth, found))
            }
            Self::Power(base, exponent) => {
                base.collect(context, depth, found)?;
                exponent.collect(context, depth, found)
            }
            Self::Call(name, arguments) => {
                if let Some(measure) = self.measure()? {
                    found.push(measure);
                    return Ok(());
                }
                if name == "VARVAL" {
                    let id = self.id(arguments.first())?;
                    return context.variable(id)?.collect(context, depth + 1, found);
                }
                let skip = usize::from(is_spline(name)) * 2;
                let inner = &arguments[..arguments.len().saturating_sub(skip)];
                inner.iter().try_for_each(|part| part.collect(context, depth, found))
            }
        }
    }

    /// What it costs to evaluate: the number of its parts, with those of variables and rows of tables. `None` where
    /// that is more than a limit.
    pub(super) fn size(&self, variable: &mut impl FnMut(u32) -> Option<usize>) -> Option<usize> {
        let mut sum = 1_usize;
        match self {
            Self::Number(_) => {}
            Self::Sum(parts) | Self::Product(parts) => {
                for (_, part) in parts {
                    sum = sum.saturating_add(part.size(variable)?);
                }
            }
            Self::Power(base, exponent) => {
                sum = sum
                    .saturating_add(base.size(variable)?)
                    .saturating_add(exponent.size(variable)?);
            }
            Self::Call(name, arguments) => {
                for part in arguments {
                    sum = sum.saturating_add(part.size(variable)?);
                }
                if name == "VARVAL" {
                    sum = sum.saturating_add(variable(self.id(arguments.first()).ok()?)?);
                }
            }
        }
        (sum <= LARGEST).then_some(sum)
    }

    /// The expression as a linear one in measures and time; `None` where it is not.
    pub(super) fn linear(&self, context: &impl Context) -> Option<Linear> {
        self.linear_at(context, 0)
    }

    fn linear_at(&self, context: &impl Context, depth: usize) -> Option<Linear> {
        if depth > DEEPEST {
            return None;
        }
        let constant = |constant| Linear { constant, ..Linear::default() };
        match self {
            Self::Number(number) => Some(constant(*number)),
            Self::Sum(terms) => {
                let mut sum = Linear::default();
                for (minus, term) in terms {
                    sum.add(if *minus { -1.0 } else { 1.0 }, &term.linear_at(context, depth)?);
                }
                Some(sum)
            }
            Self::Product(factors) => {
                let mut product = constant(1.0);
                for (divides, factor) in factors {
                    let factor = factor.linear_at(context, depth)?;
                    let (linear, number) = match (product.terms.is_empty(), factor.terms.is_empty())
                    {
                        (_, true) if *divides => (product, 1.0 / factor.constant),
                        (_, true) => (product, factor.constant),
                        (true, false) if !*divides => (factor, product.constant),
                        _ => return None,
                    };
                    product = Linear::default();
                    product.add(number, &linear);
                }
                Some(product)
            }
            Self::Call(name, arguments) if name == TIME && arguments.is_empty() => {
                let time = Measure { name: name.clone(), markers: vec![] };
                Some(Linear { constant: 0.0, terms: [(time, 1.0)].into() })
            }
            Self::Call(name, arguments) if name == "VARVAL" => {
                let variable = context.variable(self.id(arguments.first()).ok()?).ok()?;
                variable.linear_at(context, depth + 1)
            }
            Self::Power(..) | Self::Call(..) => match self.measure() {
                Ok(Some(measure)) => Some(Linear { constant: 0.0, terms: [(measure, 1.0)].into() }),
                _ => {
                    // Only what does not change has a value without the measures.
                    let still = self.value_at(&Still(context), depth).ok()?;
                    Some(constant(still))
                }
            },
        }
    }

    /// The measure that this is, if it is one.
    fn measure(&self) -> Result<Option<Measure>, String> {
        let Self::Call(name, arguments) = self else { return Ok(None) };
        if !MEASURES.contains(&name.as_str()) {
            return Ok(None);
        }
        if arguments.is_empty() || arguments.len() > 4 {
            return Err(format!("{name} needs markers, such as {name}(12, 21)"));
        }
        let markers = arguments.iter().map(|argument| self.id(Some(argument)));
        let mut markers: Vec<u32> = markers.collect::<Result<_, _>>()?;
        // Marker 0 is the ground, which is meant where nothing is said.
        while markers.last() == Some(&0) {
            markers.pop();
        }
        Ok(Some(Measure { name: name.clone(), markers }))
    }

    fn id(&self, argument: Option<&Self>) -> Result<u32, String> {
        match argument {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            // It is a whole number.
            Some(Self::Number(n)) if n.fract() == 0.0 && (0.0..=4e9).contains(n) => Ok(*n as u32),
            _ => Err("a number of a marker, spline or variable is expected in its brackets".into()),
        }
    }

    /// The value.
    pub(super) fn value(&self, context: &impl Context) -> Result<f64, String> {
        self.value_at(context, 0)
    }

    fn value_at(&self, context: &impl Context, depth: usize) -> Result<f64, String> {
        if depth > DEEPEST {
            return Err("its variables go round in a circle".into());
        }
        let value = |part: &Self| part.value_at(context, depth);
        match self {
            Self::Number(number) => Ok(*number),
            Self::Sum(terms) => terms.iter().try_fold(0.0, |sum, (minus, term)| {
                let term = value(term)?;
                Ok(if *minus { sum - term } else { sum + term })
            }),
            Self::Product(factors) => factors.iter().try_fold(1.0, |product, (divides, factor)| {
                let factor = value(factor)?;
                Ok(if *divides { product / factor } else { product * factor })
            }),
            Self::Power(base, exponent) => {
                let (base, exponent) = (value(base)?, value(exponent)?);
                let whole = exponent.fract() == 0.0 && exponent.abs() < 1000.0;
                #[allow(clippy::cast_possible_truncation)] // It is a small whole number.
                Ok(if whole { base.powi(exponent as i32) } else { base.powf(exponent) })
            }
            Self::Call(name, arguments) => {
                if let Some(measure) = self.measure()? {
                    return context.measure(&measure);
                }
                match (name.as_str(), arguments.len()) {
                    ("TIME", 0) => return context.time(),
                    ("VARVAL", 1) => {
                        let variable = context.variable(self.id(arguments.first())?)?;
                        return variable.value_at(context, depth + 1);
                    }
                    (name, 3) if is_spline(name) => {
                        let across = value(&arguments[1])?;
                        if across != 0.0 {
                            return Err(format!("{name} of two variables is not known"));
                        }
                        let id = self.id(arguments.get(2))?;
                        return context.spline(name, id, value(&arguments[0])?);
                    }
                    _ => {}
                }
                let arguments: Vec<f64> = arguments.iter().map(value).collect::<Result<_, _>>()?;
                function(name, &arguments)
            }
        }
    }
}

fn is_spline(name: &str) -> bool {
    matches!(name, "AKISPL" | "CUBSPL")
}

/// A context in which nothing moves: only constants have values.
struct Still<'c, C>(&'c C);

impl<C: Context> Context for Still<'_, C> {
    fn measure(&self, measure: &Measure) -> Result<f64, String> {
        Err(format!("{} changes", measure.name))
    }
    fn time(&self) -> Result<f64, String> {
        Err("the time changes".into())
    }
    fn variable(&self, id: u32) -> Result<&Expression, String> {
        self.0.variable(id)
    }
    fn spline(&self, function: &str, id: u32, x: f64) -> Result<f64, String> {
        self.0.spline(function, id, x)
    }
}

#[cfg(test)]
mod tests {
    use super::super::parse::parse;
    use super::*;

    struct Nothing;

    impl Context for Nothing {
        fn measure(&self, measure: &Measure) -> Result<f64, String> {
            Ok(f64::from(measure.markers[0]))
        }
        fn time(&self) -> Result<f64, String> {
            Ok(0.5)
        }
        fn variable(&self, _: u32) -> Result<&Expression, String> {
            Err("none".into())
        }
        fn spline(&self, _: &str, _: u32, x: f64) -> Result<f64, String> {
            Ok(2.0 * x)
        }
    }

    fn value(text: &str) -> f64 {
        parse(text).unwrap_or_else(|e| panic!("{text}: {e}")).value(&Nothing).unwrap()
    }

    #[test]
    fn expressions_follow_the_rules_of_fortran() {
        for (text, expected) in [
            ("1 + 2*3 - 4/2", 5.0),
            ("-2**2", -4.0),
            ("2**-1 * 8", 4.0),
            ("2**3**2", 512.0),
            ("2*-3", -6.0),
            ("1.5E1 + .5e+0", 15.5),
            ("8/2/2", 2.0),
            ("dm(7, 2) - 2", 5.0),
            ("sin( 90D )", 1.0),
            ("RTOD*180D", 180.0),
            ("IF(TIME-1: 3, 4, 5)", 3.0),
            ("IF(0: 3, 4, 5)", 4.0),
            ("STEP(TIME, 0, 0, 1, 10)", 5.0),
            ("STEP5(2, 0, 0, 1, 10)", 10.0),
            ("POLY(3, 1, 1, 2, 3)", 17.0),
            ("akispl(3, 0, 4)", 6.0),
        ] {
            assert!((value(text) - expected).abs() < 1e-13, "{text} is {}", value(text));
        }
    }

    #[test]
    fn linear_expressions_keep_their_numbers() {
        let linear = |text: &str| parse(text).unwrap().linear(&Nothing);
        let spring = linear("-100.0*(DM(1,2)-2.0) - 1.5*VR(1,2)/2 + SIN(90D)").unwrap();
        let measure = |name: &str| Measure { name: name.into(), markers: vec![1, 2] };
        assert_eq!(spring.constant, 201.0);
        let terms = [(measure("DM"), -100.0), (measure("VR"), -0.75)];
        assert_eq!(spring.terms, terms.into());
        for text in ["DM(1,2)*DM(1,2)", "1/DM(1,2)", "SIN(TIME)", "DM(1,2)**2"] {
            assert_eq!(linear(text), None, "{text}");
        }
        assert_eq!(linear("3*TIME").unwrap().terms.len(), 1);
    }

    #[test]
    fn what_is_wrong_is_told() {
        for text in ["", "2*", "(1", "SIN(", "3 4", "@", "DM(", "1..2", "2 +", "1e999"] {
            assert!(parse(text).is_err(), "{text}");
        }
        let error = |text: &str| parse(text).unwrap().value(&Nothing).unwrap_err();
        assert!(error("FOO(1)").contains("FOO with 1 arguments"));
        assert!(error("DM").contains("markers"));
        let deep = format!("{}1{}", "(".repeat(1000), ")".repeat(1000));
        assert!(parse(&deep).unwrap_err().contains("brackets"));
        assert!(parse(&"-".repeat(10_000)).is_err() && parse(&"2**".repeat(10_000)).is_err());
        let long = "1+".repeat(4000) + "1";
        assert_eq!(value(&long), 4001.0);
        assert!(parse(&"1+".repeat(100_000)).unwrap_err().contains("more than"));
    }
}
