//! Numbers that belong to no vehicle: wrong units, wrong side.

use super::{Geometry, NEAR};
use crate::model::NamedPoint;
use crate::model::diagnostics::Report;
use crate::model::units::LengthUnit;
use crate::vector::{norm, sub};

/// Coordinates beyond this (m) belong to no vehicle.
const FARTHEST: f64 = 100.0;

/// Smallest and largest extent (m) of the points of one corner, from small models to mining trucks.
const EXTENT: (f64, f64) = (0.02, 20.0);

/// Smallest and largest radius (m) of a tyre.
const RADIUS: (f64, f64) = (0.01, 3.0);

impl Geometry<'_> {
    pub(super) fn check_radius(&self, report: &mut Report) {
        let radius = self.model.wheel_radius;
        if radius <= 0.0 {
            report
                .mistake(&self.radius, "the wheel radius must be positive", "not positive")
                .help("write the rolling radius of the tyre");
        } else if !(RADIUS.0..=RADIUS.1).contains(&radius) {
            let message = format!("a wheel radius of {} is not plausible", metres(radius));
            report
                .mistake(&self.radius, message, "too small or too large")
                .also(&self.length, "in this unit")
                .help("write the rolling radius of the tyre in the unit of [units]");
        }
    }

    /// Finds numbers in another unit than the file says, such as metres called millimetres.
    pub(super) fn check_scale(&self, report: &mut Report) {
        let points = self.model.points.iter().zip(&self.points);
        let far = |point: &(&NamedPoint, _)| norm(point.0.position) > FARTHEST;
        let far: Vec<_> = points.filter(far).collect();
        if !far.is_empty() && 2 * far.len() < self.points.len() {
            for (point, span) in far {
                let distance = metres(norm(point.position));
                let message = format!("the point `{}` is {distance} from the origin", point.name);
                report
                    .mistake(span, message, "too far away")
                    .also(&self.length, "in this unit")
                    .help("check the number and the unit of length");
            }
            return;
        }
        let extent = self.extent();
        if far.is_empty() && (EXTENT.0..=EXTENT.1).contains(&extent) {
            return;
        }
        let written = self.model.units.length.from_metres(extent);
        let fits = |unit: &LengthUnit| {
            *unit != self.model.units.length && (0.1..=5.0).contains(&unit.to_metres(written))
        };
        let units = LengthUnit::CHOICES.iter().map(|(_, unit)| *unit);
        // Metres and millimetres are by far the most common, so try them first.
        let common = [LengthUnit::Metre, LengthUnit::Millimetre];
        let likely = common.into_iter().chain(units).find(fits);
        let (message, help) = match likely {
            Some(unit) => (
                format!("the lengths look like {}", unit.plural()),
                format!("if they are, write `length = \"{}\"`", unit.symbol()),
            ),
            None => (
                "the size of the suspension or its distance from the origin is not plausible"
                    .to_owned(),
                "check the unit of length and the points".to_owned(),
            ),
        };
        let label = format!("makes the suspension {} large", metres(extent));
        report.mistake(&self.length, message, label).help(help);
    }

    /// The diagonal of the box around all points.
    fn extent(&self) -> f64 {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for point in &self.model.points {
            for axis in 0..3 {
                low[axis] = low[axis].min(point.position[axis]);
                high[axis] = high[axis].max(point.position[axis]);
            }
        }
        norm(sub(high, low))
    }

    /// Points that lie across the centre line: all of them, or single ones.
    pub(super) fn check_sides(&self, report: &mut Report) {
        let (side, axes) = (self.model.side, self.model.axes);
        let roles = &self.model.architecture.points;
        let across = |index: &usize| {
            let y = self.model.points[*index].position[1] * side.sign();
            y < -NEAR && !roles[*index].may_cross
        };
        let across: Vec<usize> = (0..roles.len()).filter(across).collect();
        let center = self.model.architecture.wheel.center.0;
        if across.contains(&center) && 2 * across.len() > roles.len() {
            let message =
                format!("the points lie on the {} side of the vehicle", side.other().name());
            report
                .mistake(&self.side, message, format!("not on the {}", side.name()))
                .also(&self.points[center], "the wheel centre, for one")
                .help(format!(
                    "write `side = \"{}\"`, or check `axes`: {}",
                    side.other().name(),
                    side.y_rule(axes)
                ));
            return;
        }
        for index in across {
            let name = &self.model.points[index].name;
            let message = format!("the point `{name}` lies across the centre line of the vehicle");
            report
                .mistake(&self.points[index], message, format!("on the {}", side.other().name()))
                .also(&self.side, "the model's side")
                .help(format!("check the sign of y: {}", side.y_rule(axes)));
        }
    }
}

/// A length for messages.
fn metres(length: f64) -> String {
    if length < 1.0 { format!("{:.3} mm", length * 1000.0) } else { format!("{length:.3} m") }
}

impl LengthUnit {
    fn plural(self) -> &'static str {
        match self {
            Self::Millimetre => "millimetres",
            Self::Centimetre => "centimetres",
            Self::Metre => "metres",
            Self::Inch => "inches",
        }
    }
}
