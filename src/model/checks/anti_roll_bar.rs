//! An anti-roll bar that cannot turn or has no link.

use super::{Geometry, NEAR};
use crate::model::diagnostics::Report;
use crate::vector::sub;

impl Geometry<'_> {
    /// The link has a length, the arm reaches away from the axis of the bar, and all points lie on
    /// the side of the model: the other half is their mirror image.
    pub(super) fn check_anti_roll_bar(&self, report: &mut Report) {
        let Some(bar) = self.model.anti_roll_bar() else {
            return;
        };
        let [arm_end, link_end] = bar.link;
        if self.coincide(arm_end, link_end) {
            let (a, b) = (self.name(arm_end), self.name(link_end));
            let message =
                format!("`{a}` and `{b}` are the same point, so the drop link has no length");
            report
                .mistake(self.span(link_end), message, "the same point")
                .also(self.span(arm_end), "as this")
                .help("correct one of the two points");
        }
        let arm = sub(self.position(arm_end), self.position(bar.pivot));
        if arm[0].hypot(arm[2]) < NEAR {
            let message = format!(
                "the arm of the anti-roll bar has no length: `{}` lies on its axis",
                self.name(arm_end)
            );
            report
                .mistake(self.span(arm_end), message, "on the axis")
                .also(self.span(bar.pivot), "the axis goes through this point, along y")
                .help("correct one of the two points");
        }
        for point in [bar.pivot, arm_end, link_end] {
            self.check_own_side(point, "the anti-roll bar", report);
        }
    }
}
