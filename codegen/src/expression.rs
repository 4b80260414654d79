//! Expressions of a relation file: Rust expression syntax, read with `syn`.

use std::ops::Range;

use proc_macro2::Span;
use syn::spanned::Spanned as _;

use crate::definition::Text;
use crate::source::Mistake;

/// An expression and its place in the file.
#[derive(Clone, Debug)]
pub struct Expression {
    /// What it is.
    pub kind: Kind,
    /// Its place in the file, in bytes.
    pub span: Range<usize>,
}

/// The kinds of expressions.
#[derive(Clone, Debug)]
pub enum Kind {
    /// A rational number: numerator and denominator.
    Number(i64, i64),
    /// A given name, a parameter or a definition.
    Name(String),
    /// `-a`.
    Negate(Box<Expression>),
    /// `a + b`, `a - b`, `a * b`, `a / b`.
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// `f(a, b)`.
    Call(String, Vec<Expression>),
    /// `a[0]`.
    Component(Box<Expression>, usize),
    /// `[a, b]`: the components of all, one after the other.
    List(Vec<Expression>),
}

impl Expression {
    /// The entry of a list that gives equation `row`, or the whole where that is not plain.
    pub fn row(&self, row: usize) -> &Self {
        match &self.kind {
            Kind::List(parts) => parts.get(row).unwrap_or(self),
            _ => self,
        }
    }
}

/// Binary operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
}

/// Reads an expression.
///
/// # Errors
/// All parts that are not of the language.
pub fn parse(text: &Text) -> Result<Expression, Vec<Mistake>> {
    let place = |span: Span| {
        let range = span.byte_range();
        // The span of an error at the end of the text is empty and may be unset.
        let start = (text.span.start + range.start).min(text.span.end);
        start..(text.span.start + range.end).min(text.span.end)
    };
    let foreign = text.text.char_indices().find(|(_, character)| !character.is_ascii());
    if let Some((at, character)) = foreign {
        let start = text.span.start + at;
        let help = match character {
            '−' | '–' => "write the minus sign as `-`",
            '·' | '×' => "write a product as `*`, `dot(a, b)` or `cross(a, b)`",
            _ => "expressions are written in ASCII; `equation` is the place for other signs",
        };
        let span = start..start + character.len_utf8();
        let message = format!("`{character}` is not part of an expression");
        return Err(vec![Mistake::new(span, message, help)]);
    }
    if let Some(at) = too_deep(&text.text) {
        let start = text.span.start + at;
        let message = format!("brackets are nested more than {DEEPEST} deep");
        let help = "give parts of the expression names under [definitions]";
        return Err(vec![Mistake::new(start..start + 1, message, help)]);
    }
    let tree: syn::Expr = syn::parse_str(&text.text).map_err(|error| {
        let span = place(error.span());
        let help = "write it like `r_j + A_j * s_j - r_i - A_i * s_i`";
        vec![Mistake::new(span, format!("this is not an expression: {error}"), help)]
    })?;
    let mut mistakes = Vec::new();
    let expression = convert(&tree, &place, &mut mistakes);
    expression.filter(|_| mistakes.is_empty()).ok_or(mistakes)
}

/// Deeper brackets would overflow the stack of the parser.
const DEEPEST: usize = 64;

/// Where brackets are nested too deep.
fn too_deep(text: &str) -> Option<usize> {
    let mut depth: usize = 0;
    text.bytes().position(|byte| {
        match byte {
            b'(' | b'[' => depth += 1,
            b')' | b']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth > DEEPEST
    })
}

fn convert(
    tree: &syn::Expr,
    place: &impl Fn(Span) -> Range<usize>,
    mistakes: &mut Vec<Mistake>,
) -> Option<Expression> {
    let span = place(tree.span());
    let refuse = |mistakes: &mut Vec<Mistake>, message: &str, help: &str| {
        mistakes.push(Mistake::new(span.clone(), message, help));
        None
    };
    let kind = match tree {
        syn::Expr::Paren(inner) => return convert(&inner.expr, place, mistakes),
        syn::Expr::Group(inner) => return convert(&inner.expr, place, mistakes),
        syn::Expr::Lit(literal) => match number(&literal.lit) {
            Some((numerator, denominator)) => Kind::Number(numerator, denominator),
            None => {
                return refuse(
                    mistakes,
                    "this number is not understood",
                    "write it with at most 15 digits, as 2 or 0.5, without exponent or suffix",
                );
            }
        },
        syn::Expr::Path(path) => match path.path.get_ident() {
            Some(name) => Kind::Name(name.to_string()),
            None => return refuse(mistakes, "this is not a name", "use a single name"),
        },
        syn::Expr::Unary(unary) if matches!(unary.op, syn::UnOp::Neg(_)) => {
            Kind::Negate(Box::new(convert(&unary.expr, place, mistakes)?))
        }
        syn::Expr::Binary(binary) => {
            let operator = match binary.op {
                syn::BinOp::Add(_) => Operator::Add,
                syn::BinOp::Sub(_) => Operator::Subtract,
                syn::BinOp::Mul(_) => Operator::Multiply,
                syn::BinOp::Div(_) => Operator::Divide,
                syn::BinOp::BitXor(_) => {
                    return refuse(
                        mistakes,
                        "`^` is not a power here",
                        "write a power as a product, `x * x`, and a root as `sqrt(x)`",
                    );
                }
                _ => {
                    return refuse(
                        mistakes,
                        "this operator is not part of the language",
                        "the operators are +, -, * and /; choices belong into force laws",
                    );
                }
            };
            let left = convert(&binary.left, place, mistakes);
            let right = convert(&binary.right, place, mistakes);
            Kind::Binary(operator, Box::new(left?), Box::new(right?))
        }
        syn::Expr::Call(call) => {
            let name = match &*call.func {
                syn::Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
                _ => None,
            };
            let Some(name) = name else {
                return refuse(mistakes, "this cannot be called", "call a function by its name");
            };
            let arguments = all(call.args.iter(), place, mistakes)?;
            Kind::Call(name, arguments)
        }
        syn::Expr::Index(index) => {
            let component = match &*index.index {
                syn::Expr::Lit(literal) => match number(&literal.lit) {
                    Some((component, 1)) => usize::try_from(component).ok(),
                    _ => None,
                },
                _ => None,
            };
            let Some(component) = component else {
                return refuse(
                    mistakes,
                    "the index is not a whole number",
                    "write the component as a number, as in `r_i[2]`; the first is 0",
                );
            };
            Kind::Component(Box::new(convert(&index.expr, place, mistakes)?), component)
        }
        syn::Expr::Array(array) => Kind::List(all(array.elems.iter(), place, mistakes)?),
        _ => {
            return refuse(
                mistakes,
                "this is not part of the language",
                "expressions have numbers, names, + - * /, functions, `v[0]` and `[a, b]`",
            );
        }
    };
    Some(Expression { kind, span })
}

fn all<'a>(
    trees: impl Iterator<Item = &'a syn::Expr>,
    place: &impl Fn(Span) -> Range<usize>,
    mistakes: &mut Vec<Mistake>,
) -> Option<Vec<Expression>> {
    // Every element is read before the first failure is passed on, so that all mistakes are told.
    let converted: Vec<_> = trees.map(|tree| convert(tree, place, mistakes)).collect();
    converted.into_iter().collect()
}

/// An exact rational from a literal such as `2` or `0.25`.
fn number(literal: &syn::Lit) -> Option<(i64, i64)> {
    let digits = match literal {
        syn::Lit::Int(int) if int.suffix().is_empty() => int.base10_digits().to_owned(),
        syn::Lit::Float(float) if float.suffix().is_empty() => float.base10_digits().to_owned(),
        _ => return None,
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((&digits, ""));
    if whole.len() + fraction.len() > 15 {
        return None;
    }
    let numerator: i64 = format!("{whole}{fraction}").parse().ok()?;
    let denominator = 10_i64.pow(u32::try_from(fraction.len()).ok()?);
    Some((numerator, denominator))
}
