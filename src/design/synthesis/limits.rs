//! What must not happen, as constraints.

use super::goals::Goals;
use super::trial::{Reached, Trial};
use crate::design::clearance::{Cylinder, Keeps, between_segments, cosine, segment_to_point};
use crate::design::request::{AngleLimit, Clearance, Part, Reference, Request, Round};
use crate::design::request::{short, state_words};
use crate::design::sqp::Evaluation;
use crate::mechanism::{BodyId, PointId};
use crate::model::{Model, Quantity};
use crate::rig::{self, Moved, Variable};
use crate::scalar::{Dual, Scalar as _};
use crate::vector::{Vector, add, constant, dot, norm, scale, sub};

/// A typical change of distances and boxes (m).
const TYPICAL: f64 = 1e-3;

type End = (PointId, BodyId);

/// A constraint of geometry.
#[derive(Clone, Debug)]
pub(super) struct Limit {
    pub row: usize,
    /// What its lower and its upper side say, for reports.
    pub words: [String; 2],
    /// The state, by its place in [`Goals::states`]; `None` for one of the parameters alone.
    pub state: Option<usize>,
    pub kind: Kind,
}

#[derive(Clone, Debug)]
pub(super) enum Kind {
    /// The sum of squares of changes of these variables (m²), and the most that its root may be (m).
    Movement { variables: Vec<usize>, most: f64 },
    /// A sum of variables with factors.
    Tie(Vec<(usize, f64)>),
    /// A coordinate of a point, along an axis of ISO 8855.
    Box { end: End, axis: usize },
    /// A distance of two parts, without their radii.
    Clearance(Box<Clearance>),
    /// The cosine of an angle.
    Angle { limit: Box<AngleLimit> },
}

/// All of them.
#[derive(Clone, Debug, Default)]
pub(super) struct Limits {
    pub list: Vec<Limit>,
    rounds: [Option<Round>; 2],
    start: Vec<f64>,
}

impl Limits {
    /// Adds the constraints of a request to those of its goals.
    pub fn of<V: Variable>(
        request: &Request,
        model: &Model,
        trial: &Trial<V>,
        goals: &mut Goals,
    ) -> Self {
        let start = request.variables.iter().map(|variable| variable.start).collect();
        let rounds = [request.limits.rim, request.limits.tyre];
        let mut limits = Self { list: vec![], rounds, start };
        limits.distances(request, model, goals);
        for tie in &request.ties {
            let row = goals.constrain([tie.value; 2], TYPICAL);
            let (name, kind) = (format!("tie of {}", tie.name), Kind::Tie(tie.terms.clone()));
            limits.list.push(Limit { row, words: [name.clone(), name], state: None, kind });
        }
        for part in &request.limits.boxes {
            for target in &part.states {
                let state = Some(goals.state(*target));
                for &end in &part.points {
                    let point = &model.points()[end.0.index()].name;
                    let end = trial.end(end);
                    for (axis, ends) in part.limits.iter().enumerate() {
                        if ends.iter().all(|end| end.is_infinite()) {
                            continue;
                        }
                        let row = goals.constrain(*ends, TYPICAL);
                        let name = format!("{}: {point}.{}", part.name, ["x", "y", "z"][axis]);
                        let words = sides(&name, model, axis, *ends, target);
                        let kind = Kind::Box { end, axis };
                        limits.list.push(Limit { row, words, state, kind });
                    }
                }
            }
        }
        for clearance in &request.limits.clearances {
            let least = clearance.distance + clearance.radii[0] + clearance.radii[1];
            let between = clearance.between.map(|part| match part {
                Part::Link(ends) => Part::Link(ends.map(|end| trial.end(end))),
                Part::Point(end) => Part::Point(trial.end(end)),
                round => round,
            });
            for target in &clearance.states {
                let state = Some(goals.state(*target));
                let row = goals.constrain([least, f64::INFINITY], TYPICAL);
                let kind = Kind::Clearance(Box::new(Clearance { between, ..clearance.clone() }));
                let least = shown(model, Quantity::Length, clearance.distance);
                let words = format!("{}: at least {least}{}", clearance.name, at(target, model));
                limits.list.push(Limit { row, words: [words.clone(), words], state, kind });
            }
        }
        for angle in &request.limits.angles {
            let (_, on) = trial.end((angle.link[0].0, angle.on));
            let link = angle.link.map(|end| trial.end(end));
            let from = match angle.from {
                Reference::Between(points) => Reference::Between(
                    points.map(|point| trial.end((PointId(point), BodyId::GROUND)).0.index()),
                ),
                other => other,
            };
            for target in &angle.states {
                let state = Some(goals.state(*target));
                let row = goals.constrain([angle.max.cos(), f64::INFINITY], 0.02 * angle.max.sin());
                let limit = AngleLimit { link, on, from, ..angle.clone() };
                let kind = Kind::Angle { limit: Box::new(limit) };
                let most = shown(model, Quantity::Angle, angle.max);
                let words = format!("{}: at most {most}{}", angle.name, at(target, model));
                limits.list.push(Limit { row, words: [words.clone(), words], state, kind });
            }
        }
        limits
    }

    /// How far points may be from where they were.
    fn distances(&mut self, request: &Request, model: &Model, goals: &mut Goals) {
        let coordinates = |of: Option<usize>| -> Vec<usize> {
            let variables = request.variables.iter().enumerate();
            let is = |variable: &crate::design::request::Variable| {
                let point = variable.parameter.point();
                point.is_some() && (of.is_none() || point == of)
            };
            variables.filter(|(_, variable)| is(variable)).map(|(index, _)| index).collect()
        };
        let mut add = |name: String, of: Option<usize>, most: f64| {
            let variables = coordinates(of);
            if variables.is_empty() {
                return;
            }
            let row = goals.constrain([f64::NEG_INFINITY, most * most], most * most);
            let words = format!("{name}: at most {}", shown(model, Quantity::Length, most));
            let (words, kind) = ([words.clone(), words], Kind::Movement { variables, most });
            self.list.push(Limit { row, words, state: None, kind });
        };
        if let Some(most) = request.limits.movement {
            for (index, point) in model.points().iter().enumerate() {
                add(format!("movement of {}", point.name), Some(index), most);
            }
        }
        if let Some(most) = request.limits.total_movement {
            add("total movement".to_owned(), None, most);
        }
    }

    /// Pulls a design towards the model until no point has moved too far.
    pub fn pull(&self, x: &mut [f64]) {
        for limit in &self.list {
            let Kind::Movement { variables, most } = &limit.kind else { continue };
            let way = variables.iter().map(|&k| (x[k] - self.start[k]).powi(2)).sum::<f64>().sqrt();
            let part = (most / way).min(1.0);
            variables.iter().for_each(|&k| x[k] = self.start[k] + part * (x[k] - self.start[k]));
        }
    }

    /// Writes the constraints that parameters alone decide.
    pub fn evaluate_parameters(&self, x: &[f64], out: &mut Evaluation) {
        let n = x.len();
        for limit in &self.list {
            let jacobian = &mut out.constraint_jacobian[limit.row * n..][..n];
            match &limit.kind {
                Kind::Movement { variables, .. } => {
                    let way = |&k: &usize| x[k] - self.start[k];
                    out.constraints[limit.row] = variables.iter().map(|k| way(k).powi(2)).sum();
                    variables.iter().for_each(|k| jacobian[*k] = 2.0 * way(k));
                }
                Kind::Tie(terms) => {
                    out.constraints[limit.row] = terms.iter().map(|&(k, f)| f * x[k]).sum();
                    terms.iter().for_each(|&(k, factor)| jacobian[k] += factor);
                }
                _ => {}
            }
        }
    }

    /// Writes the constraints at a state.
    pub fn evaluate(&self, state: usize, wheel: usize, reached: &Reached, out: &mut Evaluation) {
        let n = reached.by.len();
        for limit in self.list.iter().filter(|limit| limit.state == Some(state)) {
            let Some((value, by)) = reached.of(|moved| self.value(&limit.kind, wheel, moved))
            else {
                out.constraints[limit.row] = f64::NAN;
                continue;
            };
            out.constraints[limit.row] = value;
            out.constraint_jacobian[limit.row * n..][..n].copy_from_slice(&by);
        }
    }

    fn value(&self, kind: &Kind, wheel: usize, moved: &Moved) -> Option<Dual> {
        Some(match kind {
            Kind::Movement { .. } | Kind::Tie(_) => return None,
            Kind::Box { end, axis } => moved.point(*end)[*axis],
            Kind::Clearance(clearance) => match clearance.between {
                [Part::Link(a), Part::Link(b)] => between_segments(moved.ends(a), moved.ends(b)),
                [Part::Link(link), Part::Point(point)] | [Part::Point(point), Part::Link(link)] => {
                    segment_to_point(moved.ends(link), moved.point(point))
                }
                [Part::Point(a), Part::Point(b)] => norm(sub(moved.point(a), moved.point(b))),
                [Part::Link(link), round] | [round, Part::Link(link)] => {
                    self.cylinder(round, wheel, moved)?.to_segment(moved.ends(link))
                }
                [Part::Point(point), round] | [round, Part::Point(point)] => {
                    self.cylinder(round, wheel, moved)?.to_point(moved.point(point))
                }
                [_, _] => return None,
            },
            Kind::Angle { limit } => {
                let [from, to] = moved.ends(limit.link);
                let design = |point: usize| moved.design(PointId(point));
                let reference: Vector<Dual> = match limit.from {
                    Reference::Design => {
                        let [from, to] = limit.link.map(|(point, _)| moved.design(point));
                        sub(to, from)
                    }
                    Reference::Direction(direction) => constant(direction),
                    Reference::Between([a, b]) => sub(design(b), design(a)),
                };
                cosine(sub(to, from), moved.turned(limit.on, reference))
            }
        })
    }

    fn cylinder(&self, part: Part, wheel: usize, moved: &Moved) -> Option<Cylinder<Dual>> {
        let (round, keeps) = match part {
            Part::Rim => (self.rounds[0]?, Keeps::Inside),
            _ => (self.rounds[1]?, Keeps::Outside),
        };
        let disc = &moved.poses[wheel].wheel;
        debug_assert!((dot(disc.spin, disc.spin).value - 1.0).abs() < 1e-9);
        Some(Cylinder {
            center: add(disc.center, scale(Dual::from_f64(round.offset), disc.spin)),
            axis: disc.spin,
            radius: round.radius,
            width: round.width,
            keeps,
        })
    }
}

/// A number with its unit.
fn shown(model: &Model, quantity: Quantity, value: f64) -> String {
    format!("{} {}", short(quantity.show(model.units, value)), quantity.symbol(model.units))
}

/// Where a limit counts.
fn at(state: &rig::Target, model: &Model) -> String {
    let words = state_words(state, model.units);
    if words.is_empty() { words } else { format!(" at {words}") }
}

/// What the two ends (m) of an interval along an axis of ISO 8855 say in the axes of the model.
fn sides(
    name: &str,
    model: &Model,
    axis: usize,
    ends: [f64; 2],
    state: &rig::Target,
) -> [String; 2] {
    let sign = model.axes.signs()[axis];
    let words = |end: f64, upper: bool| {
        let which = if upper == (sign > 0.0) { "at most" } else { "at least" };
        let end = shown(model, Quantity::Length, sign * end);
        format!("{name} {which} {end}{}", at(state, model))
    };
    [words(ends[0], false), words(ends[1], true)]
}
