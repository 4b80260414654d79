//! Steering files as mechanisms of their own: rack and pinion, Pitman arm with idler, rotary arm.

use super::{NOT_USED, Title};
use crate::import::json::Json;
use crate::import::sheet::{Sheet, Value};
use crate::import::{ImportError, Imported, Mistakes, Source};
use crate::model::Document;
use crate::vector::{add, norm};

pub(super) fn import(source: Source, root: &Json, title: &Title) -> Result<Imported, ImportError> {
    let mut steering =
        Steering { root, mistakes: Mistakes::new(source.name, source.text), points: vec![] };
    let body = match title.template.as_str() {
        "RackPinion" => steering.rack(),
        "PitmanArm" => steering.pitman(),
        "RotaryArm" => steering.rotary(),
        other => {
            let what = format!("the importer does not know Chrono's steering `{other}`");
            return Err(source.fault(what, "it knows RackPinion, PitmanArm and RotaryArm"));
        }
    };
    steering.mistakes.finish()?;
    let Some((range, sheet)) = body else {
        return Err(
            source.fault("the steering is not complete", "compare it with an example of Chrono")
        );
    };
    let mut head = Sheet::default();
    head.comment("Made by `hardpoint import`: the numbers are those of the source, in SI units.");
    head.comment(&range);
    head.section("format = 1");
    head.set("name", &Value::from(title.name.as_str()), "");
    let about = format!("Project Chrono, {}, steering {}", source.file_name(), title.template);
    head.set("source", &Value::from(about.as_str()), "");
    head.set("ground", &Value::from("chassis"), "");
    head.set("gravity", &Value::from(9.81), "m/s², downward; not in the source");
    head.section("[units]");
    for (key, unit) in [("length", "m"), ("angle", "rad"), ("force", "N"), ("mass", "kg")] {
        head.set(key, &Value::from(unit), "");
    }
    head.section("[points]");
    for (name, position, comment) in &steering.points {
        head.set(name, &Value::from(*position), comment);
    }
    let text = format!("{}\n{}", head.into_text(), sheet.into_text());
    Document::parse(&format!("{} (the mechanism made of it)", source.name), &text)?;
    let mut left_out = vec![];
    root.unused("", NOT_USED, &mut left_out);
    for item in left_out.iter_mut().filter(|item| item.what.ends_with("Radius`")) {
        "it is the size of a body for drawing".clone_into(&mut item.why);
    }
    let assumed = vec!["gravity is not in the source: 9.81 m/s² is written".to_owned()];
    Ok(Imported { text, left_out, assumed })
}

struct Steering<'a> {
    root: &'a Json,
    mistakes: Mistakes,
    points: Vec<(&'static str, [f64; 3], &'static str)>,
}

/// What to say of the range, and the sections of bodies, joints and drivers.
type Body = Option<(String, Sheet)>;

impl<'a> Steering<'a> {
    /// A link that slides along y, driven by a pinion.
    fn rack(&mut self) -> Body {
        let link = self.object("Steering Link")?;
        let pinion = self.object("Pinion")?;
        let offset = self.number(link, "COM")?;
        let length = self.number(link, "Length")?;
        let radius = self.number(pinion, "Radius")?;
        let angle = self.number(pinion, "Maximum Angle (deg)")?;
        let center = [0.0, offset, 0.0];
        let half = 0.5 * length;
        self.points.push(("rack_center", center, "origin of the steering"));
        let left = "where the left tie rod may be held; the suspension says where";
        self.points.push(("rack_left", [0.0, offset + half, 0.0], left));
        let mut sheet = Sheet::default();
        self.mass(&mut sheet, "rack", link, center)?;
        joint(
            &mut sheet,
            "rack_slide",
            "translational",
            ["chassis", "rack"],
            "rack_center",
            ("axis", Value::from("y")),
        );
        sheet.section("[[drivers]]");
        sheet.set("name", &Value::from("rack"), "+ to the left");
        sheet.set("kind", &Value::from("displacement"), "");
        sheet.set("between", &Value::from(["chassis", "rack"]), "");
        sheet.set("at", &Value::from("rack_left"), "");
        sheet.set("along", &Value::from("y"), "");
        let most = radius * angle.to_radians();
        let range = format!(
            "The pinion has a radius of {radius:?} m and turns by {angle:?} degrees to each side: the rack moves from \
             {:.9} to {most:.9} m.",
            -most
        );
        Some((range, sheet))
    }

    /// Pitman arm, link and idler arm. The universal joint has its two axes in a cross without mass,
    /// and
    /// the joint of the idler is an arm without mass.
    fn pitman(&mut self) -> Body {
        let (link, arm) = (self.object("Steering Link")?, self.object("Pitman Arm")?);
        let revolute = self.object("Revolute Joint")?;
        let universal = self.object("Universal Joint")?;
        let idler = self.object("Revolute-Spherical Joint")?;
        let angle = self.number(revolute, "Maximum Angle (deg)")?;
        self.axis(("pitman_pivot", "pitman_axis"), revolute, "Location", "Direction")?;
        let end = self.axis(
            ("pitman_end", "universal_arm_axis"),
            universal,
            "Location",
            "Direction Arm",
        )?;
        let link_axis = self.direction(universal, "Direction Link")?;
        self.points.push(("universal_link_axis", add(end, link_axis), ""));
        self.axis(("idler_pivot", "idler_axis"), idler, "Location Chassis", "Direction")?;
        let idler_end = self.vector(idler, "Location Link")?;
        self.points.push(("idler_end", idler_end, ""));
        if let Some(ends) = self.root.get("Tierod Locations") {
            for (key, name) in
                [("Pitman Side", "tierod_pitman_side"), ("Idler Side", "tierod_idler_side")]
            {
                let place = ends.vector(key, &mut self.mistakes);
                self.points.extend(place.map(|place| (name, place, "the tie rod of this side")));
            }
        }
        let (arm_center, link_center) = (self.vector(arm, "COM")?, self.vector(link, "COM")?);
        let mut sheet = Sheet::default();
        sheet.section("[bodies]");
        sheet.set(
            "universal_cross",
            &Value::from("Cross of the universal joint, without mass"),
            "",
        );
        sheet.set("idler_arm", &Value::from("Idler arm, without mass"), "");
        self.mass(&mut sheet, "pitman_arm", arm, arm_center)?;
        self.mass(&mut sheet, "link", link, link_center)?;
        let between = |a, b| ("axis", Value::from([a, b]));
        let axis = between("pitman_pivot", "pitman_axis");
        joint(
            &mut sheet,
            "pitman_hinge",
            "revolute",
            ["chassis", "pitman_arm"],
            "pitman_pivot",
            axis,
        );
        let axis = between("pitman_end", "universal_arm_axis");
        joint(
            &mut sheet,
            "universal_on_arm",
            "revolute",
            ["pitman_arm", "universal_cross"],
            "pitman_end",
            axis,
        );
        let axis = between("pitman_end", "universal_link_axis");
        joint(
            &mut sheet,
            "universal_on_link",
            "revolute",
            ["universal_cross", "link"],
            "pitman_end",
            axis,
        );
        let axis = between("idler_pivot", "idler_axis");
        joint(&mut sheet, "idler_hinge", "revolute", ["chassis", "idler_arm"], "idler_pivot", axis);
        sheet.section("[[joints]]");
        sheet.set("name", &Value::from("idler_ball_joint"), "");
        sheet.set("kind", &Value::from("spherical"), "");
        sheet.set("between", &Value::from(["idler_arm", "link"]), "");
        sheet.set("at", &Value::from("idler_end"), "");
        driver(&mut sheet, ["chassis", "pitman_arm"], ["pitman_pivot", "pitman_axis"]);
        Some((turns(angle), sheet))
    }

    /// An arm on the chassis that moves the end of the drag link.
    fn rotary(&mut self) -> Body {
        let arm = self.object("Pitman Arm")?;
        let angle = self.number(arm, "Maximum Angle (deg)")?;
        let pivot = self.axis(
            ("pitman_pivot", "pitman_axis"),
            arm,
            "Point of Rotation",
            "Axis of Rotation",
        )?;
        let end = self.vector(arm, "Point to Draglink")?;
        self.points.push(("draglink_arm", end, "the drag link on the arm"));
        let center = std::array::from_fn(|axis| 0.5 * (pivot[axis] + end[axis]));
        let mut sheet = Sheet::default();
        self.mass(&mut sheet, "pitman_arm", arm, center)?;
        let axis = ("axis", Value::from(["pitman_pivot", "pitman_axis"]));
        joint(
            &mut sheet,
            "pitman_hinge",
            "revolute",
            ["chassis", "pitman_arm"],
            "pitman_pivot",
            axis,
        );
        driver(&mut sheet, ["chassis", "pitman_arm"], ["pitman_pivot", "pitman_axis"]);
        Some((turns(angle), sheet))
    }

    fn object(&mut self, name: &str) -> Option<&'a Json> {
        let object = self.root.get(name);
        if object.is_none() {
            self.mistakes.note(self.root.line, format!("`{name}` is missing"), "add it");
        }
        object
    }

    fn number(&mut self, object: &Json, key: &str) -> Option<f64> {
        let number = object.number(key, &mut self.mistakes);
        self.found(object, key, number)
    }

    fn vector(&mut self, object: &Json, key: &str) -> Option<[f64; 3]> {
        let vector = object.vector(key, &mut self.mistakes);
        self.found(object, key, vector)
    }

    fn found<T>(&mut self, object: &Json, key: &str, value: Option<T>) -> Option<T> {
        if !object.has(key) {
            self.mistakes.note(object.line, format!("`{key}` is missing"), "add it");
        }
        value
    }

    /// A direction that is not zero.
    fn direction(&mut self, object: &Json, key: &str) -> Option<[f64; 3]> {
        let direction = self.vector(object, key)?;
        let size = norm(direction);
        if size < 1e-9 || !size.is_finite() {
            self.mistakes.note(
                object.line,
                format!("`{key}` has no direction"),
                "write a unit vector",
            );
            return None;
        }
        Some(direction.map(|component| component / size))
    }

    /// A point and a second one a metre along an axis through it.
    fn axis(
        &mut self,
        (point, second): (&'static str, &'static str),
        object: &Json,
        location: &str,
        direction: &str,
    ) -> Option<[f64; 3]> {
        let at = self.vector(object, location)?;
        let direction = self.direction(object, direction)?;
        self.points.push((point, at, ""));
        self.points.push((second, add(at, direction), "a second point on the axis"));
        Some(at)
    }

    fn mass(
        &mut self,
        sheet: &mut Sheet,
        body: &str,
        object: &Json,
        center: [f64; 3],
    ) -> Option<()> {
        let mass = self.number(object, "Mass")?;
        let key = if object.has("Inertia") { "Inertia" } else { "Moments of Inertia" };
        let moments = self.vector(object, key)?;
        let key =
            if object.has("Inertia Products") { "Inertia Products" } else { "Products of Inertia" };
        let [xy, xz, yz] = object.vector(key, &mut self.mistakes).unwrap_or_default();
        let [xx, yy, zz] = moments;
        sheet.section(&format!("[bodies.{body}]"));
        sheet.set("mass", &Value::from(mass), "");
        sheet.set("center_of_mass", &Value::from(center), "");
        sheet.set(
            "inertia",
            &Value::from([xx, yy, zz, xy, xz, yz]),
            "Jxx, Jyy, Jzz, Jxy, Jxz, Jyz",
        );
        Some(())
    }
}

fn turns(angle: f64) -> String {
    let most = angle.to_radians();
    format!("The arm turns by {angle:?} degrees to each side: from {:.9} to {most:.9} rad.", -most)
}

fn joint(
    sheet: &mut Sheet,
    name: &str,
    kind: &str,
    between: [&str; 2],
    at: &str,
    (key, axis): (&str, Value),
) {
    sheet.section("[[joints]]");
    sheet.set("name", &Value::from(name), "");
    sheet.set("kind", &Value::from(kind), "");
    sheet.set("between", &Value::from(between), "");
    sheet.set("at", &Value::from(at), "");
    sheet.set(key, &axis, "");
}

fn driver(sheet: &mut Sheet, between: [&str; 2], axis: [&str; 2]) {
    sheet.section("[[drivers]]");
    sheet.set("name", &Value::from("pitman"), "the angle of the arm, right-handed about its axis");
    sheet.set("kind", &Value::from("rotation"), "");
    sheet.set("between", &Value::from(between), "");
    sheet.set("axis", &Value::from(axis), "");
}
