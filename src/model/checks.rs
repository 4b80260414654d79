//! Checks that the geometry of a model has a meaning.

use std::ops::Range;

use super::diagnostics::Report;
use super::units::LengthUnit;
use super::{Model, NamedPoint, SpinAxis, suggest};
use crate::mechanism::{BodyId, Direction, JointKind, PointId};

/// Two points nearer than this (m) are one point, and three points whose distance from a
/// line is less are on it: a tenth of a millimetre is below any manufacturing tolerance.
const NEAR: f64 = 1e-4;

/// Coordinates beyond this (m) belong to no vehicle.
const FARTHEST: f64 = 100.0;

/// Smallest and largest extent (m) of the points of one corner, from small models to mining trucks.
const EXTENT: (f64, f64) = (0.02, 20.0);

/// Smallest and largest radius (m) of a tyre.
const RADIUS: (f64, f64) = (0.01, 3.0);

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
}

impl Geometry<'_> {
    fn position(&self, point: PointId) -> [f64; 3] {
        self.model.points[point.0].position
    }

    fn name(&self, point: PointId) -> &str {
        &self.model.points[point.0].name
    }

    fn span(&self, point: PointId) -> &Range<usize> {
        &self.points[point.0]
    }

    fn coincide(&self, a: PointId, b: PointId) -> bool {
        norm(minus(self.position(a), self.position(b))) < NEAR
    }

    fn check_radius(&self, report: &mut Report) {
        let radius = self.model.wheel_radius;
        if radius <= 0.0 {
            report
                .mistake(
                    &self.radius,
                    "the wheel radius must be positive",
                    "not positive",
                )
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
    fn check_scale(&self, report: &mut Report) {
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
        norm(minus(high, low))
    }

    /// Points that lie across the centre line: all of them, or single ones.
    fn check_sides(&self, report: &mut Report) {
        let (side, axes) = (self.model.side, self.model.axes);
        let roles = &self.model.architecture.points;
        let across = |index: &usize| {
            let y = self.model.points[*index].position[1] * side.sign();
            y < -NEAR && !roles[*index].may_cross
        };
        let across: Vec<usize> = (0..roles.len()).filter(across).collect();
        let center = self.model.architecture.wheel.center.0;
        if across.contains(&center) && 2 * across.len() > roles.len() {
            let message = format!(
                "the points lie on the {} side of the vehicle",
                side.other().name()
            );
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
                .mistake(
                    &self.points[index],
                    message,
                    format!("on the {}", side.other().name()),
                )
                .also(&self.side, "the model's side")
                .help(format!("check the sign of y: {}", side.y_rule(axes)));
        }
    }

    /// Axes between two points need two different points.
    fn check_directions(&self, report: &mut Report) {
        for joint in &self.model.architecture.joints {
            let (direction, what) = match joint.kind {
                JointKind::Revolute { axis, .. }
                | JointKind::Translational { axis, .. }
                | JointKind::Cylindrical { axis, .. }
                | JointKind::InLine { axis, .. } => (axis, "has no axis"),
                JointKind::InPlane { normal, .. } => (normal, "has no plane"),
                JointKind::Universal { shaft, .. } => (shaft, "has a shaft of zero length"),
                JointKind::Link { on_i, on_j } => {
                    (Direction::Between(on_i, on_j), "has zero length")
                }
                JointKind::Spherical { .. } | JointKind::Fixed { .. } => continue,
            };
            let Direction::Between(a, b) = direction else {
                continue;
            };
            if self.coincide(a, b) {
                let message = format!(
                    "`{}` and `{}` are the same point, so the joint `{}` {what}",
                    self.name(a),
                    self.name(b),
                    joint.name
                );
                report
                    .mistake(self.span(b), message, "the same point")
                    .also(self.span(a), "as this")
                    .help("correct one of the two points");
            }
        }
    }

    /// A body held only along one line turns freely about it.
    fn check_bodies(&self, report: &mut Report) {
        let architecture = &self.model.architecture;
        for index in 1..=architecture.bodies.len() {
            let body = BodyId(index);
            let joints = || {
                architecture
                    .joints
                    .iter()
                    .filter(|j| j.i == body || j.j == body)
            };
            let points = architecture.joint_points(body);
            let hinge = joints().find_map(|joint| match joint.kind {
                JointKind::Revolute {
                    axis: Direction::Between(a, b),
                    ..
                } => Some((a, b)),
                _ => None,
            });
            let balls = joints().all(|joint| {
                matches!(
                    joint.kind,
                    JointKind::Spherical { .. } | JointKind::Link { .. }
                )
            });
            // A body with a hinge needs a point off its axis, one held by ball joints three points off a line.
            let line = match hinge {
                Some(line) => line,
                None if balls && points.len() > 2 => self.farthest_pair(&points),
                None => continue,
            };
            let off_line = |point: &PointId| self.distance_from_line(*point, line) > NEAR;
            if self.coincide(line.0, line.1) || points.iter().any(off_line) {
                continue;
            }
            let names: Vec<&str> = points.iter().map(|point| self.name(*point)).collect();
            let message = format!(
                "all joints of the body `{}` lie on one line: {}",
                architecture.body_name(body),
                suggest::listed(&names)
            );
            let last = points.len() - 1;
            let mistake = report.mistake(self.span(points[last]), message, "on the line");
            for point in &points[..last] {
                mistake.also(self.span(*point), "on the line");
            }
            mistake.help("the body would turn freely about that line; correct the point that should lie beside it");
        }
    }

    fn farthest_pair(&self, points: &[PointId]) -> (PointId, PointId) {
        let distance =
            |point: &PointId| norm(minus(self.position(*point), self.position(points[0])));
        let far = points
            .iter()
            .copied()
            .max_by(|a, b| distance(a).total_cmp(&distance(b)));
        (points[0], far.unwrap_or(points[0]))
    }

    fn distance_from_line(&self, point: PointId, line: (PointId, PointId)) -> f64 {
        let along = minus(self.position(line.1), self.position(line.0));
        let to = minus(self.position(point), self.position(line.0));
        norm(cross(along, to)) / norm(along)
    }

    fn check_steer_axis(&self, report: &mut Report) {
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

    fn check_spin_axis(&self, report: &mut Report) {
        let SpinAxis::Point(name) = &self.model.spin else {
            return;
        };
        let center = self.model.architecture.wheel.center;
        let Some(index) = self
            .model
            .points
            .iter()
            .position(|point| point.name == *name)
        else {
            return;
        };
        let axis = minus(self.model.points[index].position, self.position(center));
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

/// A length for messages.
fn metres(length: f64) -> String {
    if length < 1.0 {
        format!("{:.3} mm", length * 1000.0)
    } else {
        format!("{length:.3} m")
    }
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

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

fn norm(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
