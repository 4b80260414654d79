//! Checks that the geometry of a model has a meaning.

mod anti_roll_bar;
mod axes;
mod degenerate;
mod loads;
mod plausibility;
mod subframe;

use std::ops::Range;

pub(super) use loads::note;

use super::diagnostics::Report;
use super::loads_file::LoadPlaces;
use super::{Model, NEAR};
use crate::mechanism::PointId;
use crate::vector::{norm, sub};

/// A model with the places of its values in the text.
pub(super) struct Geometry<'a> {
    pub(super) model: &'a Model,
    /// Places of the points, in the order of the model.
    pub(super) points: Vec<Range<usize>>,
    pub(super) side: Range<usize>,
    pub(super) length: Range<usize>,
    pub(super) radius: Range<usize>,
    /// Place of the spin axis point.
    pub(super) spin: Range<usize>,
    /// Places of the loads.
    pub(super) loads: LoadPlaces,
}

pub(super) fn check(geometry: &Geometry, report: &mut Report) {
    let before = report.mistakes.len();
    geometry.check_radius(report);
    geometry.check_scale(report);
    if report.mistakes.len() > before {
        // At the wrong scale every other check would fail too.
        return;
    }
    geometry.check_sides(report);
    geometry.check_directions(report);
    geometry.check_bodies(report);
    geometry.check_steer_axis(report);
    geometry.check_spin_axis(report);
    geometry.check_loads(report);
    geometry.check_anti_roll_bar(report);
    geometry.check_subframe(report);
}

impl Geometry<'_> {
    /// Where a point of the mechanism is.
    fn position(&self, point: PointId) -> [f64; 3] {
        self.mechanism_point(point).1
    }

    fn name(&self, point: PointId) -> &str {
        self.mechanism_point(point).0
    }

    /// Where a point stands in the text; the one for toe and camber is placed by the wheel.
    fn span(&self, point: PointId) -> &Range<usize> {
        self.points.get(point.0).unwrap_or(&self.radius)
    }

    fn mechanism_point(&self, point: PointId) -> (&str, [f64; 3]) {
        self.model.mechanism_points().nth(point.0).expect("the mechanism has the point")
    }

    fn coincide(&self, a: PointId, b: PointId) -> bool {
        norm(sub(self.position(a), self.position(b))) < NEAR
    }
}
