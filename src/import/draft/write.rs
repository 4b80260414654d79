//! Writes a draft as a model file.

use super::{Draft, Part, PartKind, Point, Spin};
use crate::import::sheet::{Sheet, Value};
use crate::model::{Architecture, Side, Units};

impl Draft {
    pub(super) fn write(&self, architecture: &Architecture) -> String {
        let mut sheet = Sheet::default();
        sheet.comment(
            "Made by `hardpoint import`: the numbers are those of the source, in its units.",
        );
        for assumed in &self.assumed {
            sheet.comment(&format!("To check: {assumed}."));
        }
        self.write_head(&mut sheet);
        sheet.section("[points]");
        for point in self.in_order(architecture) {
            let called = if point.called == point.name { "" } else { &point.called };
            sheet.set(&point.name, &Value::from(point.position), called);
        }
        sheet.section("[wheel]");
        sheet.set("radius", &Value::from(self.wheel_radius.unwrap_or_default()), "");
        match &self.spin {
            Spin::Point(name) => sheet.set("spin_axis_point", &Value::from(name.as_str()), ""),
            Spin::Angles { toe, camber } => {
                sheet.set("toe", &Value::from(*toe), "+ toe-in");
                sheet.set("camber", &Value::from(*camber), "+ top outboard");
            }
            Spin::Unknown => {}
        }
        if let Some(axle) = self.axle {
            sheet.section("[vehicle]");
            sheet.set("axle", &Value::from(axle.name()), "");
        }
        for body in &self.bodies {
            sheet.section(&format!("[bodies.{}]", body.name));
            sheet.set("mass", &Value::from(body.mass), &body.called);
            sheet.set("center_of_mass", &Value::from(body.center), "");
            let [xx, yy, zz, products @ ..] = body.inertia;
            let inertia = match products {
                [0.0, 0.0, 0.0] => Value::from([xx, yy, zz]),
                _ => Value::from(body.inertia),
            };
            sheet.set("inertia", &inertia, "");
        }
        self.parts.iter().for_each(|part| part.write(&mut sheet));
        sheet.into_text()
    }

    fn write_head(&self, sheet: &mut Sheet) {
        let Units { length, angle, force, mass } = self.units;
        sheet.section("format = 1");
        sheet.set("name", &Value::from(self.name.as_str()), "");
        sheet.set("source", &Value::from(self.source.as_str()), "");
        sheet.set("architecture", &Value::from(self.architecture.as_str()), "");
        sheet.set("axes", &Value::from(self.axes.name()), "");
        sheet.set("side", &Value::from(self.side.unwrap_or(Side::Left).name()), "");
        if let Some(gravity) = self.gravity.filter(|_| !self.bodies.is_empty()) {
            sheet.set("gravity", &Value::from(gravity), "m/s², downward");
        }
        sheet.section("[units]");
        sheet.set("length", &Value::from(length.symbol()), "");
        sheet.set("angle", &Value::from(angle.symbol()), "");
        if !self.parts.is_empty() {
            sheet.set("force", &Value::from(force.symbol()), "");
        }
        if !self.bodies.is_empty() {
            sheet.set("mass", &Value::from(mass.symbol()), "");
        }
    }

    /// The points in the order of the architecture, then the others.
    fn in_order(&self, architecture: &Architecture) -> Vec<&Point> {
        let roles = architecture.points().iter().chain(architecture.optional_points());
        let roles: Vec<&str> = roles.map(|role| role.name.as_str()).collect();
        let place = |point: &&Point| roles.iter().position(|role| *role == point.name);
        let mut points: Vec<&Point> = self.points.iter().collect();
        points.sort_by_key(|point| place(point).unwrap_or(roles.len()));
        points
    }
}

impl Part {
    fn write(&self, sheet: &mut Sheet) {
        match &self.kind {
            PartKind::Force(..) => sheet.section("[[forces]]"),
            PartKind::AxleForce(..) => sheet.section("[[axle_forces]]"),
            PartKind::Bushing(_) => sheet.section(&format!("[bushings.{}]", self.name)),
        }
        self.write_as(&self.name, sheet);
    }

    /// The keys, under this name.
    pub(crate) fn write_as(&self, name: &str, sheet: &mut Sheet) {
        let called = if self.called == name { "" } else { &self.called };
        self.comment(sheet);
        match &self.kind {
            PartKind::Force(kind, [i, j]) | PartKind::AxleForce(kind, [i, j]) => {
                sheet.set("name", &Value::from(name), called);
                sheet.set("kind", &Value::from(*kind), "");
                sheet.set("between", &Value::from([i.as_str(), j.as_str()]), "");
            }
            PartKind::Bushing(joint) => {
                sheet.set("replaces", &Value::from(joint.as_str()), called);
            }
        }
        for (key, value) in &self.entries {
            sheet.set(key, value, "");
        }
    }

    fn comment(&self, sheet: &mut Sheet) {
        self.comments.iter().for_each(|comment| sheet.comment(comment));
    }
}
