//! The bodies and points that joints and forces may name.

use std::cell::Cell;

use toml::Spanned;

use super::diagnostics::Report;
use super::suggest;
use crate::mechanism::{BodyId, PointId};

/// Names in the order of their numbers, and who asked for them.
pub(crate) struct Names {
    ground: String,
    /// Moving bodies; `BodyId(1)` is the first of them.
    bodies: Vec<String>,
    points: Vec<(String, Cell<bool>)>,
    /// Points that exist but cannot be named here.
    unavailable: Vec<Unavailable>,
}

/// A point that exists but cannot be named.
pub(crate) struct Unavailable {
    pub(crate) name: String,
    pub(crate) why: String,
    pub(crate) help: String,
}

impl Names {
    pub(crate) fn new(ground: String, bodies: Vec<String>, points: Vec<String>) -> Self {
        let points = points.into_iter().map(|name| (name, Cell::new(false))).collect();
        Self { ground, bodies, points, unavailable: vec![] }
    }

    pub(crate) fn with_unavailable(mut self, points: Vec<Unavailable>) -> Self {
        self.unavailable = points;
        self
    }

    /// The names of parts between the two sides of an axle: `other.lca` is that of the other side, and
    /// those of the other side come after all of this side.
    pub(crate) fn across(&self) -> Self {
        let both = |names: Vec<&str>| {
            let other = names.iter().map(|name| format!("other.{name}"));
            let this = names.iter().map(|name| (*name).to_owned());
            this.chain(other).collect()
        };
        let bodies = both(self.bodies.iter().map(String::as_str).collect());
        Self::new(self.ground.clone(), bodies, both(self.points().collect()))
    }

    /// Notes the points that have been asked for, on either side, by their names [across](Self::across).
    pub(crate) fn use_points_of(&self, across: &Self) {
        for (index, (_, used)) in across.points.iter().enumerate() {
            if used.get() {
                self.points[index % self.points.len()].1.set(true);
            }
        }
    }

    /// Exchanges the moving bodies.
    pub(crate) fn set_bodies(&mut self, bodies: Vec<String>) {
        self.bodies = bodies;
    }

    /// Whether a point has been asked for.
    pub(crate) fn is_used(&self, name: &str) -> bool {
        self.points.iter().any(|(point, used)| point == name && used.get())
    }

    /// The points in the order of their numbers.
    pub(crate) fn points(&self) -> impl Iterator<Item = &str> {
        self.points.iter().map(|(name, _)| name.as_str())
    }

    /// The moving body or the ground of this name.
    pub(crate) fn body(&self, name: &Spanned<String>, report: &mut Report) -> Option<BodyId> {
        let word = name.get_ref();
        if *word == self.ground {
            return Some(BodyId::GROUND);
        }
        if self.bodies.is_empty() {
            return None; // That the bodies are missing has been noted.
        }
        let found = self.bodies.iter().position(|body| body == word);
        if found.is_none() {
            let mut known = vec![self.ground.as_str()];
            known.extend(self.bodies.iter().map(String::as_str));
            report
                .mistake(&name.span(), format!("there is no body `{word}`"), "unknown body")
                .help(suggest::choices(word, &known));
        }
        found.map(|index| BodyId(index + 1))
    }

    /// The body of this name if it moves; `help` says what the ground cannot have.
    pub(crate) fn moving_body(
        &self,
        name: &Spanned<String>,
        help: &str,
        report: &mut Report,
    ) -> Option<BodyId> {
        let body = self.body(name, report)?;
        if body != BodyId::GROUND {
            return Some(body);
        }
        let message = format!("the body `{}` never moves", self.ground);
        report.mistake(&name.span(), message, "the ground").help(help);
        None
    }

    /// The point of this name.
    pub(crate) fn point(&self, name: &Spanned<String>, report: &mut Report) -> Option<PointId> {
        let word = name.get_ref();
        if self.points.is_empty() {
            return None; // That the points are missing has been noted.
        }
        if let Some(index) = self.points.iter().position(|(point, _)| point == word) {
            self.points[index].1.set(true);
            return Some(PointId(index));
        }
        let unavailable = self.unavailable.iter().find(|point| point.name == *word);
        let (message, help) = match unavailable {
            Some(point) => (point.why.clone(), point.help.clone()),
            None => {
                let known: Vec<&str> = self.points.iter().map(|(name, _)| name.as_str()).collect();
                (format!("there is no point `{word}`"), suggest::choices(word, &known))
            }
        };
        report.mistake(&name.span(), message, "unknown point").help(help);
        None
    }
}
