//! Suspensions that state bodies, joints and springs of their own, as mechanisms: `GenericWheeledSuspension`.
//!
//! What is `Mirrored` is there on both sides, in the mirror image on the right one. The chassis is the ground, and so
//! are subchassis and steering link, which are in files of their own.

use super::Title;
use super::lines::{rotational, tsda};
use super::masses::{Lump, turned};
use super::suspension::leave_out_the_rest;
use crate::import::draft::{POINT_MASS, Part, beyond_any_body};
use crate::import::json::{Json, Kind};
use crate::import::sheet::{Sheet, Value, word};
use crate::import::{ImportError, Imported, LeftOut, Mistakes, Source};
use crate::mechanism::MassProperties;
use crate::model::{Document, Side};
use crate::vector::{norm, sub};

/// No suspension has more parts of one kind.
const MOST: usize = 200;

/// What stands still: the chassis, and what other files move.
const STILL: [&str; 3] = ["Chassis", "Subchassis", "Steering"];

pub(super) fn import(source: Source, root: &Json, title: &Title) -> Result<Imported, ImportError> {
    let mut generic = Generic {
        root,
        mistakes: Mistakes::new(source.name, source.text),
        left_out: vec![],
        names: vec![],
        points: vec![],
        bodies: Sheet::default(),
        parts: Sheet::default(),
    };
    generic.bodies();
    generic.joints();
    generic.links();
    generic.lines();
    generic.rotational();
    generic.wheels();
    let Generic { mistakes, mut left_out, points, bodies, parts, .. } = generic;
    mistakes.finish()?;
    let mut head = Sheet::default();
    head.comment("Made by `hardpoint import`: the numbers are those of the source, in SI units.");
    head.comment("Subchassis and steering link, which are in files of their own, are held.");
    head.section("format = 1");
    head.set("name", &Value::from(title.name.as_str()), "");
    let about = format!("Project Chrono, {}, template {}", source.file_name(), title.template);
    head.set("source", &Value::from(about.as_str()), "");
    head.set("ground", &Value::from("chassis"), "");
    head.set("gravity", &Value::from(9.81), "m/s², downward; not in the source");
    head.section("[units]");
    for (key, unit) in [("length", "m"), ("angle", "rad"), ("force", "N"), ("mass", "kg")] {
        head.set(key, &Value::from(unit), "");
    }
    head.section("[points]");
    for (name, position) in &points {
        head.set(name, &Value::from(*position), "");
    }
    let text = [head, bodies, parts].map(Sheet::into_text).join("\n");
    Document::parse(&format!("{} (the mechanism made of it)", source.name), &text)?;
    leave_out_the_rest(root, &mut left_out);
    left_out.sort();
    left_out.dedup();
    let assumed = vec!["gravity is not in the source: 9.81 m/s² is written".to_owned()];
    Ok(Imported { text, left_out, assumed })
}

struct Generic<'a> {
    root: &'a Json,
    mistakes: Mistakes,
    left_out: Vec<LeftOut>,
    /// Names of bodies in the source, and whether they are there on both sides.
    names: Vec<(&'a str, bool)>,
    points: Vec<(String, [f64; 3])>,
    bodies: Sheet,
    parts: Sheet,
}

/// The side that a part is on; `None` for one that is there once.
type On = Option<Side>;

/// The name on a side.
fn named(name: &str, side: On) -> String {
    side.map_or_else(|| word(name), |side| format!("{}_{}", side.name(), word(name)))
}

/// The place on a side, of one that is given for the left one.
fn placed([x, y, z]: [f64; 3], side: On) -> [f64; 3] {
    [x, if side == Some(Side::Right) { 0.0 - y } else { y }, z]
}

/// The axis of a rotation on a side: in a mirror image that turns the other way.
fn axis_on([x, y, z]: [f64; 3], side: On) -> [f64; 3] {
    if side == Some(Side::Right) { [0.0 - x, y, 0.0 - z] } else { [x, y, z] }
}

impl<'a> Generic<'a> {
    /// The items of a list, with the sides that each is on.
    fn items(&mut self, list: &str) -> Vec<(&'a Json, &'a str, Vec<On>)> {
        let Some(list) = self.root.get(list) else { return vec![] };
        let Kind::List(items) = &list.kind else {
            self.mistakes.note(list.line, "this is no list", "write `[ { … }, { … } ]`");
            return vec![];
        };
        if items.is_empty() {
            list.take();
        }
        if items.len() > MOST {
            self.mistakes.note(
                list.line,
                format!("a list has {} parts, more than {MOST}", items.len()),
                "check that it is the right file",
            );
            return vec![];
        }
        let mut found = vec![];
        for item in items {
            let Some(name) = item.text("Name") else {
                self.mistakes.note(item.line, "`Name` is missing or no text", "add it");
                continue;
            };
            let mirrored = item.get("Mirrored").map(|flag| &flag.take().kind);
            let Some(Kind::Bool(mirrored)) = mirrored else {
                self.mistakes.note(
                    item.line,
                    format!("`{name}` has no `Mirrored`"),
                    "write true for a part of each side, or false",
                );
                continue;
            };
            let sides = match mirrored {
                true => vec![Some(Side::Left), Some(Side::Right)],
                false => vec![None],
            };
            found.push((item, name, sides));
        }
        found
    }

    fn vector(&mut self, object: &Json, key: &str) -> Option<[f64; 3]> {
        if !object.has(key) {
            self.mistakes.note(object.line, format!("`{key}` is missing"), "add it");
        }
        object.vector(key, &mut self.mistakes)
    }

    /// The axes of `Rotation`, a quaternion with its real part first.
    fn rotation(&mut self, object: &Json) -> Option<[[f64; 3]; 3]> {
        let numbers = object.get("Rotation").and_then(|value| value.take().numbers());
        let quaternion: Option<[f64; 4]> = numbers.and_then(|numbers| numbers.try_into().ok());
        let size = quaternion.map(|q| q.iter().map(|x| x * x).sum::<f64>().sqrt());
        let (Some(q), Some(size)) = (quaternion, size.filter(|size| (0.5..2.0).contains(size)))
        else {
            let help = "write four numbers, the real part first: `[1, 0, 0, 0]`";
            self.mistakes.note(object.line, "`Rotation` is missing or no rotation", help);
            return None;
        };
        let [w, x, y, z] = q.map(|component| component / size);
        Some([
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
            [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)],
            [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)],
        ])
    }

    /// The body that a part of a side names: that of its side, or a text and the side in a list.
    fn body(&mut self, object: &Json, key: &str, side: On) -> Option<String> {
        let value = object.get(key).map(Json::take);
        let (name, side) = match value.map(|value| &value.kind) {
            Some(Kind::Text(name)) => (name.as_str(), side),
            Some(Kind::List(items)) => {
                match items.iter().map(|item| &item.kind).collect::<Vec<_>>()[..] {
                    [Kind::Text(name), Kind::Text(side)] if side == "Left" => {
                        (name.as_str(), Some(Side::Left))
                    }
                    [Kind::Text(name), Kind::Text(side)] if side == "Right" => {
                        (name.as_str(), Some(Side::Right))
                    }
                    _ => ("", None),
                }
            }
            _ => ("", None),
        };
        if STILL.contains(&name) {
            return Some("chassis".to_owned());
        }
        match self.names.iter().find(|(known, _)| *known == name) {
            Some((_, false)) => Some(named(name, None)),
            Some((_, true)) if side.is_some() => Some(named(name, side)),
            _ => {
                let help = "name one of `Bodies`, with its side where the part is on none: [\"Knuckle\", \"Left\"]";
                let line = value.map_or(object.line, |value| value.line);
                self.mistakes.note(line, format!("`{key}` names no body"), help);
                None
            }
        }
    }

    fn point(&mut self, name: &str, place: [f64; 3], side: On) -> String {
        let name = named(name, side);
        self.points.push((name.clone(), placed(place, side)));
        name
    }

    /// Mass and inertia of an object at a place, in these axes.
    fn mass(
        &mut self,
        sheet: &str,
        object: &Json,
        center: [f64; 3],
        axes: [[f64; 3]; 3],
        side: On,
    ) -> Option<()> {
        let Some(mass) = object.number("Mass", &mut self.mistakes) else {
            self.mistakes.note(object.line, "`Mass` is missing", "add it");
            return None;
        };
        let key = if object.has("Inertia") { "Inertia" } else { "Moments of Inertia" };
        let [xx, yy, zz] = self.vector(object, key)?;
        let products = object.vector("Products of Inertia", &mut self.mistakes);
        let [xy, xz, yz] = products.unwrap_or_default();
        let tensor = turned([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], axes);
        let lump = Lump { mass, center, tensor };
        let lump = if side == Some(Side::Right) { lump.mirrored() } else { lump };
        let (center, mut inertia) = lump.center_and_inertia();
        if beyond_any_body(MassProperties { mass, center, inertia }) {
            inertia = [0.0; 6];
            let what = format!("the inertia of `{sheet}`");
            self.left_out.push(LeftOut { line: object.line, what, why: POINT_MASS.to_owned() });
        }
        self.bodies.section(&format!("[bodies.{sheet}]"));
        self.bodies.set("mass", &Value::from(mass), "");
        self.bodies.set("center_of_mass", &Value::from(center), "");
        let comment = "Jxx, Jyy, Jzz, Jxy, Jxz, Jyz";
        self.bodies.set("inertia", &Value::from(inertia), comment);
        Some(())
    }

    fn bodies(&mut self) {
        for (object, name, sides) in self.items("Bodies") {
            self.names.push((name, sides.len() == 2));
            let (center, axes) = (self.vector(object, "Position"), self.rotation(object));
            let (Some(center), Some(axes)) = (center, axes) else { continue };
            for side in sides {
                let _ = self.mass(&named(name, side), object, center, axes, side);
            }
        }
    }

    /// A section with a name, a kind and two bodies.
    fn part(&mut self, section: &str, name: &str, kind: &str, between: [&str; 2]) {
        self.parts.section(section);
        self.parts.set("name", &Value::from(name), "");
        self.parts.set("kind", &Value::from(kind), "");
        self.parts.set("between", &Value::from(between), "");
    }

    fn joints(&mut self) {
        for (object, name, sides) in self.items("Joints") {
            let kind = object.text("Type").unwrap_or_default();
            // z of Chrono's frames is the axis of a hinge and a slide, and the normal of a plane; x and y are
            // the pins of a cross. Points of lines and planes are those of the first body.
            let (kind, turned): (&str, &[(&str, usize)]) = match kind {
                "Lock" => ("fixed", &[]),
                "Spherical" => ("spherical", &[]),
                "Revolute" => ("revolute", &[("axis", 2)]),
                "Prismatic" => ("translational", &[("axis", 2)]),
                "Universal" => ("universal", &[("pin_i", 0), ("pin_j", 1)]),
                "Point Plane" => ("in-plane", &[("normal", 2)]),
                "Point Line" => ("in-line", &[("axis", 0)]),
                other => {
                    let help = "it knows Lock, Spherical, Revolute, Prismatic, Universal, Point Line and Point Plane";
                    let what = format!("the importer does not know the joint `{other}`");
                    self.mistakes.note(object.line, what, help);
                    continue;
                }
            };
            let (place, axes) = (self.vector(object, "Position"), self.rotation(object));
            let (Some(place), Some(axes)) = (place, axes) else { continue };
            if let Some(data) = object.get("Bushing Data").map(Json::take) {
                self.left_out.push(LeftOut {
                    line: data.line,
                    what: format!("the bushing of `{name}`"),
                    why: "the joint is written as a rigid one".to_owned(),
                });
            }
            for side in sides {
                let ends = ["Body1", "Body2"].map(|key| self.body(object, key, side));
                let [Some(first), Some(second)] = ends else { continue };
                let at = self.point(name, place, side);
                let between = match kind {
                    "in-plane" | "in-line" => [second.as_str(), &first],
                    _ => [first.as_str(), &second],
                };
                self.part("[[joints]]", &named(name, side), kind, between);
                self.parts.set("at", &Value::from(at.as_str()), "");
                for (key, axis) in turned {
                    self.parts.set(key, &Value::from(placed(axes[*axis], side)), "");
                }
            }
        }
    }

    /// Both ends of a line, and the names of their points.
    fn ends(
        &mut self,
        object: &Json,
        name: &str,
        side: On,
    ) -> Option<([String; 2], [String; 2], f64)> {
        let bodies = ["Body1", "Body2"].map(|key| self.body(object, key, side));
        let places = ["Point1", "Point2"].map(|key| self.vector(object, key));
        let ([Some(i), Some(j)], [Some(from), Some(to)]) = (bodies, places) else { return None };
        let on = [(from, "1"), (to, "2")]
            .map(|(place, end)| self.point(&format!("{name} {end}"), place, side));
        Some(([i, j], on, norm(sub(to, from))))
    }

    fn links(&mut self) {
        for (object, name, sides) in self.items("Distance Constraints") {
            for side in sides {
                let Some(([i, j], [from, to], _)) = self.ends(object, name, side) else { continue };
                self.part("[[joints]]", &named(name, side), "link", [&i, &j]);
                self.parts.set("on", &Value::from([from.as_str(), &to]), "");
            }
        }
    }

    fn lines(&mut self) {
        for (object, name, sides) in self.items("TSDAs") {
            for side in sides {
                let Some((bodies, on, length)) = self.ends(object, name, side) else { continue };
                let on = on.each_ref().map(String::as_str);
                let Self { mistakes, left_out, .. } = self;
                for part in tsda(object, name, &bodies, on, length, left_out, mistakes) {
                    self.force(&part, name, side);
                }
            }
        }
    }

    fn rotational(&mut self) {
        for (object, name, sides) in self.items("RSDAs") {
            let axis = self.vector(object, "Axis");
            let entries = rotational(object, &mut self.mistakes);
            let (Some(axis), Some(entries)) = (axis, entries) else { continue };
            object.get("Position").map(Json::take);
            for side in sides {
                let ends = ["Body1", "Body2"].map(|key| self.body(object, key, side));
                let [Some(i), Some(j)] = ends else { continue };
                self.part("[[forces]]", &named(name, side), "torsion-spring", [&i, &j]);
                self.parts.set("axis", &Value::from(axis_on(axis, side)), "");
                for (key, value) in &entries {
                    self.parts.set(key, value, "");
                }
            }
        }
    }

    /// A spring, a damper or a stop; a stop has the name of its line, too.
    fn force(&mut self, part: &Part, name: &str, side: On) {
        let stop =
            if part.name.ends_with("_stop") { format!(" {}", part.name) } else { String::new() };
        self.parts.section("[[forces]]");
        part.write_as(&named(&format!("{name}{stop}"), side), &mut self.parts);
    }

    /// Spindles, which do not spin, and the drivers of their heights.
    fn wheels(&mut self) {
        let Some(spindle) = self.root.get("Spindle") else {
            self.mistakes.note(self.root.line, "`Spindle` is missing", "add it");
            return;
        };
        let Some(center) = self.vector(spindle, "COM") else { return };
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for side in [Side::Left, Side::Right].map(Some) {
            let body = named("spindle", side);
            let _ = self.mass(&body, spindle, center, axes, side);
            let Some(carrier) = self.body(spindle, "Attachment Body", side) else { return };
            let at = self.point("wheel center", center, side);
            self.part("[[joints]]", &format!("{body}_lock"), "fixed", [&carrier, &body]);
            self.parts.set("at", &Value::from(at.as_str()), "the wheel does not spin");
            self.part("[[drivers]]", &named("wheel", side), "height", ["chassis", &body]);
            self.parts.set("at", &Value::from(at.as_str()), "+ up");
        }
    }
}
