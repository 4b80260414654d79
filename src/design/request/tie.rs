//! Ties: coordinates that change together.

use toml::Spanned;

use super::Place;
use super::parameter::Parameter;
use super::read::{AXES, Context, sections};
use super::variable::{Variable, axes};
use crate::model::read::Section;
use crate::model::{Quantity, Report};

/// How two coordinates belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// They are equal.
    Equal,
    /// Their difference stays.
    Offset,
    /// Their sum stays, or they lie equally far to both sides of a plane.
    Mirror,
}

/// A linear equation: the sum of factors times [variables](super::Request::variables) is a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Tie {
    /// The coordinates, for reports: `lca_front.z and lca_rear.z`.
    pub name: String,
    /// How they belong together.
    pub relation: Relation,
    /// Variables by their places, with their factors; one or two.
    pub terms: Vec<(usize, f64)>,
    /// The value (SI, ISO 8855 axes).
    pub value: f64,
    /// Where the request says so.
    pub place: Place,
}

/// The ties, without those that have mistakes.
pub(super) fn read(
    root: &mut Section,
    context: &Context,
    variables: (&[Variable], bool),
    report: &mut Report,
) -> Vec<Tie> {
    let mut ties = vec![];
    for mut section in sections(root, "ties", report) {
        ties.extend(tie(&mut section, context, variables, report).unwrap_or_default());
        section.finish(report);
    }
    ties
}

fn tie(
    section: &mut Section,
    context: &Context,
    (variables, known): (&[Variable], bool),
    report: &mut Report,
) -> Option<Vec<Tie>> {
    let help = "name the points that change together: `points = [\"lca_front\", \"lca_rear\"]`";
    let names = section.required::<Vec<Spanned<String>>>("points", help, report);
    let key = section.one_of(
        &["coordinate", "coordinates"],
        "write `coordinate = \"z\"`, or `coordinates` for several",
        report,
    );
    let axes = match key {
        Some("coordinate") => {
            let axis = AXES.map(|axis| (axis, axis));
            let word = section.choice("coordinate", "coordinate", &axis, "", report);
            word.and_then(|word| AXES.iter().position(|axis| axis == word.get_ref()))
                .into_iter()
                .collect()
        }
        Some(_) => axes(section, report),
        None => vec![],
    };
    let relations =
        [("equal", Relation::Equal), ("offset", Relation::Offset), ("mirror", Relation::Mirror)];
    let hint = ": equal coordinates, a constant difference, or opposite motion";
    let relation = section.choice("relation", "relation", &relations, hint, report);
    let about = section.optional::<f64>("about", report);
    let names = names?;
    let points = context.points(names.get_ref(), report);
    let (relation, span) = (relation?, names.span());
    let relation = *relation.get_ref();
    if names.get_ref().len() < 2 || (relation == Relation::Mirror && names.get_ref().len() > 2) {
        let (message, help) = match relation {
            Relation::Mirror => ("a mirror image needs two points", "name two points"),
            _ => ("one point alone is not tied", "name two points or more"),
        };
        report.mistake(&span, message, "these points").help(help);
        return None;
    }
    if let (Some(about), false) = (&about, relation == Relation::Mirror) {
        report
            .mistake(&about.span(), "`about` belongs to `relation = \"mirror\"`", "no mirror")
            .help("leave it out");
        return None;
    }
    let (first, others) = points.split_first()?;
    let mut ties = vec![];
    for &axis in &axes {
        let plane = about
            .as_ref()
            .map(|about| context.sign(axis) * context.si(Quantity::Length, *about.get_ref()));
        for other in others {
            let of = |point: usize| Parameter::Coordinate { point, axis };
            let pair = [first.0, other.0].map(of);
            let place = Place(section.span());
            let name = [first.0, other.0]
                .map(|point| format!("{}.{}", context.attached.name(point), AXES[axis]))
                .join(" and ");
            let tie = equation(pair, relation, plane, variables, context);
            let tied = tie.terms.len() == 2 || (tie.terms.len() == 1 && tie.moves);
            if !tied && !known {
                return None;
            }
            if !tied {
                let message = match tie.terms.len() {
                    0 => format!("neither of {name} is a variable"),
                    _ => format!("only one of {name} is a variable, and so it could not move"),
                };
                report
                    .mistake(&span, message, "these points")
                    .help("make both of them `[[variables]]`, or leave the tie out");
                return None;
            }
            let (terms, value) = (tie.terms, tie.value);
            ties.push(Tie { name, relation, terms, value, place });
        }
    }
    Some(ties)
}

struct Equation {
    terms: Vec<(usize, f64)>,
    value: f64,
    /// Whether it moves a coordinate whose partner does not move.
    moves: bool,
}

/// The equation of a pair of coordinates. One that is no variable counts with its value.
fn equation(
    pair: [Parameter; 2],
    relation: Relation,
    plane: Option<f64>,
    variables: &[Variable],
    context: &Context,
) -> Equation {
    let start = pair.map(|of| of.value(context.model).unwrap_or_default());
    let (factor, value) = match relation {
        Relation::Equal => (-1.0, 0.0),
        Relation::Offset => (-1.0, start[0] - start[1]),
        Relation::Mirror => (1.0, plane.map_or(start[0] + start[1], |plane| 2.0 * plane)),
    };
    let mut equation = Equation { terms: vec![], value, moves: false };
    for ((of, factor), start) in pair.into_iter().zip([1.0, factor]).zip(start) {
        match variables.iter().position(|variable| variable.parameter == of) {
            Some(variable) => equation.terms.push((variable, factor)),
            None => equation.value -= factor * start,
        }
    }
    equation.moves = relation == Relation::Equal || plane.is_some();
    equation
}
