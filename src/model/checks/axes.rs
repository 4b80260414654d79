//! The steer axis and the spin axis of the wheel.

use super::{Geometry, NEAR};
use crate::mechanism::PointId;
use crate::model::SpinAxis;
use crate::model::diagnostics::Report;
use crate::vector::{norm, sub};

impl Geometry<'_> {
    pub(super) fn check_steer_axis(&self, report: &mut Report) {
        let Some(axis) = self.model.architecture.steer_axis else {
            return;
        };
        let (lower, upper) = (axis.lower.0, axis.upper.0);
        if self.position(upper)[2] - self.position(lower)[2] > NEAR {
            return;
        }
        let message = format!(
            "the steer axis does not point up: `{}` is not above `{}`",
            self.name(upper),
            self.name(lower)
        );
        report
            .mistake(self.span(upper), message, "the upper point")
            .also(self.span(lower), "the lower point")
            .help("exchange the two points if they are mixed up, or check z and `axes`");
    }

    pub(super) fn check_spin_axis(&self, report: &mut Report) {
        let SpinAxis::Point(name) = &self.model.spin else {
            return;
        };
        let center = self.model.architecture.wheel.center;
        let Some(index) = self.model.points.iter().position(|point| point.name == *name) else {
            return;
        };
        let architecture = &self.model.architecture;
        let wheel_points = architecture.joint_points(architecture.wheel.body);
        let point = PointId(index);
        let elsewhere = index < architecture.points.len() && !wheel_points.contains(&point);
        if elsewhere && point != center {
            let message = format!(
                "the spin axis point `{name}` is not on the body `{}` that carries the wheel",
                architecture.body_name(architecture.wheel.body)
            );
            report
                .mistake(&self.spin, message, "on another body")
                .help("name a second point on the spin axis of the wheel");
            return;
        }
        let axis = sub(self.model.points[index].position, self.position(center));
        if norm(axis) < NEAR {
            let message = format!("the spin axis point `{name}` is the wheel centre");
            report
                .mistake(&self.points[index], message, "the same point")
                .also(self.span(center), "as the wheel centre")
                .help("the spin axis needs two different points");
        } else if axis[1].abs() < norm(axis) * std::f64::consts::FRAC_1_SQRT_2 {
            let message = "the spin axis is more than 45° away from the y axis";
            report
                .mistake(&self.spin, message, "this point")
                .also(&self.points[index], "is here")
                .also(self.span(center), "the wheel centre")
                .help("the spin axis of a wheel is nearly parallel to y; check both points");
        }
    }
}
