//! Mounts of the subframe that would be there twice.

use super::{Geometry, NEAR};
use crate::mechanism::PointId;
use crate::model::diagnostics::Report;

impl Geometry<'_> {
    /// All mounts lie on the side of the model: those of the other side are their mirror images.
    pub(super) fn check_subframe(&self, report: &mut Report) {
        for bushing in self.model.bushings().iter().filter(|bushing| bushing.each_side) {
            if let Some([at, _]) = bushing.force.kind.points() {
                self.check_own_side(at, "the subframe", report);
            }
        }
    }

    /// A point of something whose other half is its mirror image.
    pub(super) fn check_own_side(&self, point: PointId, of: &str, report: &mut Report) {
        let side = self.model.side;
        if self.position(point)[1] * side.sign() >= -NEAR {
            return;
        }
        let name = self.name(point);
        let message = format!("the point `{name}` of {of} lies across the centre line");
        report
            .mistake(self.span(point), message, format!("on the {}", side.other().name()))
            .also(&self.side, "the model's side")
            .help(format!(
                "give the points of one side, the other has their mirror images; check the sign of y: {}",
                side.y_rule(self.model.axes)
            ));
    }
}
