//! A suspension as an importer finds it, before it is written as a model file.

use std::path::Path;

use super::options::{Options, read_text};
use super::sheet::{Sheet, Value};
use super::{ImportError, Imported, LeftOut, Mistakes};
use crate::mechanism::{MassProperties, Mechanism};
use crate::model::{
    AngleUnit, Architecture, Axes, Axle, Document, ForceUnit, LengthUnit, MassUnit, Quantity, Side,
    Units,
};

/// The radius (m) that is written where a source has none.
const ASSUMED_RADIUS: f64 = 0.3;

/// No corner of a vehicle has more points.
pub(crate) const MOST_POINTS: usize = 1000;

/// A suspension with the numbers of its source, in the units and axes of the source.
#[derive(Debug)]
pub(crate) struct Draft {
    /// The name for reports.
    pub(crate) name: String,
    /// Where it comes from: the program and what the file is.
    pub(crate) source: String,
    /// A built-in architecture or a path.
    pub(crate) architecture: String,
    /// What the source calls the architecture.
    pub(crate) template: String,
    pub(crate) axes: Axes,
    /// `None` where the wheel centre tells the side.
    pub(crate) side: Option<Side>,
    /// The axle that it belongs to, where that is known.
    pub(crate) axle: Option<Axle>,
    pub(crate) units: Units,
    pub(crate) points: Vec<Point>,
    pub(crate) wheel_radius: Option<f64>,
    pub(crate) spin: Spin,
    /// m/s², downward; masses need it.
    pub(crate) gravity: Option<f64>,
    pub(crate) bodies: Vec<Body>,
    pub(crate) parts: Vec<Part>,
    pub(crate) left_out: Vec<LeftOut>,
    pub(crate) assumed: Vec<String>,
}

/// A hard point under its name in the model.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    pub(crate) name: String,
    /// Its name in the source.
    pub(crate) called: String,
    pub(crate) line: usize,
    pub(crate) position: [f64; 3],
}

/// The static spin axis.
#[derive(Debug)]
pub(crate) enum Spin {
    /// Toe and camber in the unit of angle.
    Angles { toe: f64, camber: f64 },
    /// A second point on the axis.
    Point(String),
    /// The source does not say.
    Unknown,
}

/// The mass of a body.
#[derive(Debug)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) line: usize,
    /// What it is made of, in the words of the source.
    pub(crate) called: String,
    pub(crate) mass: f64,
    pub(crate) center: [f64; 3],
    /// Jxx, Jyy, Jzz, Jxy, Jxz, Jyz.
    pub(crate) inertia: [f64; 6],
}

/// A force element or a bushing.
#[derive(Debug)]
pub(crate) struct Part {
    pub(crate) name: String,
    pub(crate) line: usize,
    /// Its name in the source.
    pub(crate) called: String,
    pub(crate) kind: PartKind,
    pub(crate) entries: Vec<(&'static str, Value)>,
    /// The points that it names.
    pub(crate) points: Vec<String>,
    /// What there is to say of it.
    pub(crate) comments: Vec<String>,
}

/// What a part is.
#[derive(Debug)]
pub(crate) enum PartKind {
    /// A force element of this kind between two bodies.
    Force(&'static str, [String; 2]),
    /// A bushing in the place of this joint.
    Bushing(String),
}

impl Draft {
    /// Nothing but what every draft has.
    pub(crate) fn new(name: &str, source: String, architecture: &str, units: Units) -> Self {
        Self {
            name: name.to_owned(),
            source,
            architecture: architecture.to_owned(),
            template: architecture.to_owned(),
            axes: Axes::Iso8855,
            side: None,
            axle: None,
            units,
            points: vec![],
            wheel_radius: None,
            spin: Spin::Unknown,
            gravity: None,
            bodies: vec![],
            parts: vec![],
            left_out: vec![],
            assumed: vec![],
        }
    }

    /// Notes a part of the source that is not taken over.
    pub(crate) fn leave_out(
        &mut self,
        line: usize,
        what: impl Into<String>,
        why: impl Into<String>,
    ) {
        self.left_out.push(LeftOut { line, what: what.into(), why: why.into() });
    }

    /// Adds a part under a name that no other has.
    pub(crate) fn add_part(&mut self, part: Part) {
        let taken = |name: &str| self.parts.iter().any(|part| part.name == name);
        let number = (2..).find(|number| !taken(&format!("{}_{number}", part.name)));
        let name = match number.filter(|_| taken(&part.name)) {
            Some(number) => format!("{}_{number}", part.name),
            None => part.name.clone(),
        };
        self.parts.push(Part { name, ..part });
    }

    /// Where a point is.
    pub(crate) fn position(&self, name: &str) -> Option<[f64; 3]> {
        self.points.iter().find(|point| point.name == name).map(|point| point.position)
    }

    /// The model file. `name` and `text` are those of the source.
    pub(crate) fn finish(
        mut self,
        name: &str,
        text: &str,
        options: &Options,
    ) -> Result<Imported, ImportError> {
        if let Some(architecture) = &options.architecture {
            self.architecture.clone_from(architecture);
        }
        if self.points.len() > MOST_POINTS {
            let what = format!("the file has more than {MOST_POINTS} points");
            return Err(ImportError::whole(name, what, "check that it is the right one"));
        }
        let architecture = self.load_architecture(name)?;
        self.drop_impossible_inertias();
        self.drop_what_has_no_place(&architecture);
        self.check_points(name, text, &architecture)?;
        self.assume(options, &architecture);
        let model = self.write(&architecture);
        // What comes out has to be a model: its mistakes are shown at their places in what was made.
        Document::parse(&format!("{name} (the model made of it)"), &model)?;
        self.left_out.sort();
        self.left_out.dedup();
        Ok(Imported { text: model, left_out: self.left_out, assumed: self.assumed })
    }

    fn load_architecture(&self, name: &str) -> Result<Architecture, ImportError> {
        let word = self.architecture.as_str();
        if word.ends_with(".toml") {
            let path = Path::new(name).parent().unwrap_or(Path::new("")).join(word);
            let text = read_text(&path).map_err(|why| {
                ImportError::whole(name, why, "name an architecture file that exists")
            })?;
            return Ok(Architecture::parse(&path.display().to_string(), &text)?);
        }
        if let Some(architecture) = Architecture::built_in(word) {
            return Ok(architecture?);
        }
        let what = format!("this build has no architecture for {} (`{word}`)", self.template);
        let known = Architecture::built_in_names().join(", ");
        let help = format!(
            "name one with --architecture: one of {known}, or a file of your own with the points of the source"
        );
        Err(ImportError::whole(name, what, help))
    }

    /// Files of examples have inertias that no body can have, which a model must not: what remains is a point mass.
    fn drop_impossible_inertias(&mut self) {
        let units = self.units;
        for body in &mut self.bodies {
            let mass = MassProperties {
                mass: Quantity::Mass.to_si(units, body.mass),
                center: body.center.map(|x| Quantity::Length.to_si(units, x)),
                inertia: body.inertia.map(|entry| Quantity::Inertia.to_si(units, entry)),
            };
            let mut trial = Mechanism::new("ground");
            let id = trial.add_body("body", [0.0; 3]);
            let possible = |mass| id.clone().and_then(|id| trial.set_mass(id, mass)).is_ok();
            let (mut possible, point) = (possible, MassProperties { inertia: [0.0; 6], ..mass });
            if !possible(mass) && possible(point) {
                let why = "no body has such moments: the largest is more than the sum of the others, or one is below \
                           zero; a point mass is written";
                let what = format!("the inertia of {}", body.called);
                self.left_out.push(LeftOut { line: body.line, what, why: why.to_owned() });
                body.inertia = [0.0; 6];
            }
        }
    }

    /// Lists bodies, forces and bushings that the architecture has no place for.
    fn drop_what_has_no_place(&mut self, architecture: &Architecture) {
        let title = architecture.title();
        let moving = |name: &str| architecture.bodies().iter().any(|body| body.name == name);
        let mut left_out = vec![];
        let mut leave = |line, what: &str, why| {
            left_out.push(LeftOut { line, what: what.to_owned(), why });
        };
        self.bodies.retain(|body| {
            let kept = moving(&body.name);
            if !kept {
                let why = format!("`{title}` has no body `{}`", body.name);
                leave(body.line, &format!("the mass of {}", body.called), why);
            }
            kept
        });
        let points = &self.points;
        self.parts.retain(|part| {
            let missing = match &part.kind {
                PartKind::Force(_, bodies) => {
                    let known = |name: &&String| moving(name) || *name == architecture.ground();
                    bodies.iter().find(|name| !known(name)).map(|name| format!("body `{name}`"))
                }
                PartKind::Bushing(joint) => {
                    let known = architecture.joints.iter().any(|known| known.name == *joint);
                    (!known).then(|| format!("joint `{joint}`"))
                }
            };
            let lost = part.points.iter().find(|name| points.iter().all(|p| p.name != **name));
            if let Some(missing) = &missing {
                leave(part.line, &part.called, format!("`{title}` has no {missing}"));
            } else if let Some(point) = lost {
                leave(
                    part.line,
                    &part.called,
                    format!("the source has no point for its `{point}`"),
                );
            }
            missing.is_none() && lost.is_none()
        });
        let spin = match &self.spin {
            Spin::Point(name) => Some(name.clone()),
            _ => None,
        };
        let parts = &self.parts;
        self.points.retain(|point| {
            let mut roles = architecture.points().iter().chain(architecture.optional_points());
            let kept = roles.any(|role| role.name == point.name)
                || parts.iter().any(|part| part.points.contains(&point.name))
                || spin.as_ref() == Some(&point.name);
            if !kept {
                let why = format!("`{title}` has no point `{}`, and no force names it", point.name);
                leave(point.line, &format!("the point `{}`", point.called), why);
            }
            kept
        });
        self.left_out.append(&mut left_out);
    }

    /// All points that the architecture needs are there, each once.
    fn check_points(
        &self,
        name: &str,
        text: &str,
        architecture: &Architecture,
    ) -> Result<(), ImportError> {
        let mut mistakes = Mistakes::new(name, text);
        for (index, point) in self.points.iter().enumerate() {
            if let Some(first) = self.points[..index].iter().find(|first| first.name == point.name)
            {
                let what = format!(
                    "`{}` and `{}` are both the point `{}`",
                    first.called, point.called, point.name
                );
                mistakes.note(
                    point.line,
                    what,
                    format!("keep one of them; the other is in line {}", first.line),
                );
            }
        }
        let missing =
            architecture.points().iter().filter(|role| self.position(&role.name).is_none());
        let missing: Vec<String> =
            missing.map(|role| format!("{}: {}", role.name, role.meaning)).collect();
        mistakes.finish()?;
        if missing.is_empty() {
            return Ok(());
        }
        let what = format!("`{}` needs points that the source does not have", architecture.title());
        Err(ImportError::whole(
            name,
            what,
            format!("add them to the source:\n{}", missing.join("\n")),
        ))
    }

    /// What the source does not say and a model needs.
    fn assume(&mut self, options: &Options, architecture: &Architecture) {
        let unit = self.units.length;
        self.wheel_radius = self.wheel_radius.or(options.wheel_radius);
        self.axle = self.axle.or(options.axle);
        if self.wheel_radius.is_none() {
            let radius = unit.from_metres(ASSUMED_RADIUS);
            self.wheel_radius = Some(radius);
            self.assumed.push(format!(
                "the source has no wheel radius: {radius} {} is a placeholder; write that of the tyre \
                 into [wheel], or import with --wheel-radius",
                unit.symbol()
            ));
        }
        if matches!(self.spin, Spin::Unknown) {
            self.spin = Spin::Angles { toe: 0.0, camber: 0.0 };
            self.assumed.push(
                "the source has neither static toe nor camber: both are written as zero".to_owned(),
            );
        }
        if self.side.is_none() {
            let center = &architecture.point_name(architecture.wheel.center);
            let y = self.position(center).map_or(0.0, |position| self.axes.to_iso(position)[1]);
            self.side = Some(if y < 0.0 { Side::Right } else { Side::Left });
        }
        if !self.bodies.is_empty() && self.gravity.is_none() {
            self.gravity = Some(9.81);
            self.assumed
                .push("the source has masses and no gravity: 9.81 m/s² is written".to_owned());
        }
    }

    fn write(&self, architecture: &Architecture) -> String {
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
        let called = if self.called == self.name { "" } else { &self.called };
        match &self.kind {
            PartKind::Force(kind, [i, j]) => {
                sheet.section("[[forces]]");
                self.comment(sheet);
                sheet.set("name", &Value::from(self.name.as_str()), called);
                sheet.set("kind", &Value::from(*kind), "");
                sheet.set("between", &Value::from([i.as_str(), j.as_str()]), "");
            }
            PartKind::Bushing(joint) => {
                sheet.section(&format!("[bushings.{}]", self.name));
                self.comment(sheet);
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

/// Metres, radians, newtons and kilograms.
pub(crate) const SI: Units = Units {
    length: LengthUnit::Metre,
    angle: AngleUnit::Radian,
    force: ForceUnit::Newton,
    mass: MassUnit::Kilogram,
};

/// Millimetres, degrees, newtons and kilograms.
pub(crate) const MMKS: Units = Units {
    length: LengthUnit::Millimetre,
    angle: AngleUnit::Degree,
    force: ForceUnit::Newton,
    mass: MassUnit::Kilogram,
};
