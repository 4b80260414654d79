//! Springs, dampers, stops and bushings with the curves of their property files.

use super::files;
use super::orbit::{Block, Orbit};
use super::subsystem::belongs;
use super::template::Template;
use crate::import::draft::{Draft, Part, PartKind};
use crate::import::options::Options;
use crate::import::sheet::{Value, word};
use crate::import::{ImportError, Source};
use crate::model::{Quantity, Side, Units};

/// Whether [`read`] takes care of the blocks of this name.
pub(super) fn is_force(name: &str) -> bool {
    KINDS.contains(&name)
}

const KINDS: &[&str] = &[
    "NSPRING_ASSEMBLY",
    "SPRING_ASSEMBLY",
    "DAMPER_ASSEMBLY",
    "BUSHING_ASSEMBLY",
    "BUMPSTOP_ASSEMBLY",
    "REBOUNDSTOP_ASSEMBLY",
];

const BUSHING_AXES: &str = "The subsystem does not hold the axes of its bushings. Here z of Adams/Car, which is x below, is \
                            taken along the axis of the joint from rear to front, and y of Adams/Car, which is z below, upward.";

/// No suspension has more of them; each may have a file of its own.
const MOST_ELEMENTS: usize = 200;

/// An element of a subsystem and where it goes.
struct Element<'a> {
    block: &'a Block,
    usage: String,
    template: Option<&'a Template>,
    units: Units,
}

/// A property file, read.
struct Property {
    blocks: Vec<Block>,
    units: Units,
}

pub(super) fn read(
    source: Source,
    orbit: &Orbit,
    template: Option<&Template>,
    options: &Options,
    side: Side,
    draft: &mut Draft,
) -> Result<(), ImportError> {
    let blocks: Vec<&Block> = orbit.blocks.iter().filter(|block| is_force(&block.name)).collect();
    if let Some(first) = blocks.get(MOST_ELEMENTS) {
        let what = format!("the subsystem has more than {MOST_ELEMENTS} force elements");
        return Err(source.mistake(first.line, what, "check that it is the right file"));
    }
    for block in blocks {
        let usage = block.text("USAGE").unwrap_or("unnamed").to_owned();
        if !belongs(block.text("SYMMETRY").unwrap_or_default(), side) {
            let why = format!("it is of the other side; a model has one, here the {}", side.name());
            draft.leave_out(block.line, format!("[{}] `{usage}`", block.name), why);
            continue;
        }
        let element = Element { block, usage, template, units: draft.units };
        let part =
            element.property(source, options).and_then(|property| element.part(&property, draft));
        match part {
            Ok(part) => {
                let bushing = matches!(part.kind, PartKind::Bushing(_));
                let told =
                    "the axes of bushings are not in a subsystem: see the comment of each bushing";
                if bushing && !draft.assumed.iter().any(|assumed| assumed == told) {
                    draft.assumed.push(told.to_owned());
                }
                draft.add_part(part);
            }
            Err(why) => {
                let what = format!("[{}] `{}`", block.name, element.usage);
                draft.leave_out(block.line, what, why);
            }
        }
    }
    Ok(())
}

impl Element<'_> {
    fn property(&self, source: Source, options: &Options) -> Result<Property, String> {
        let Some(name) = self.block.text("PROPERTY_FILE") else {
            return Err("it names no property file".to_owned());
        };
        let (path, text) = files::named(name, source.name, options).map_err(|why| {
            format!("its property file {why}; name its database with --database NAME=FOLDER")
        })?;
        let wrong = |error: ImportError| {
            let mistakes = error.diagnostics().mistakes();
            let first = mistakes.first().map_or("", |mistake| mistake.message());
            format!("its property file `{path}` cannot be read: {first}")
        };
        let orbit = Orbit::parse(Source { name: &path, text: &text }).map_err(wrong)?;
        let units = orbit.units().map_err(wrong)?;
        Ok(Property { blocks: orbit.blocks, units })
    }

    fn part(&self, property: &Property, draft: &mut Draft) -> Result<Part, String> {
        match self.block.name.as_str() {
            "NSPRING_ASSEMBLY" | "SPRING_ASSEMBLY" => self.spring(property, draft),
            "DAMPER_ASSEMBLY" => self.damper(property),
            "BUSHING_ASSEMBLY" => self.bushing(property),
            "BUMPSTOP_ASSEMBLY" => self.stop(property, "bump-stop"),
            _ => self.stop(property, "rebound-stop"),
        }
    }

    /// Deflection and force of a spring are positive in compression.
    fn spring(&self, property: &Property, draft: &mut Draft) -> Result<Part, String> {
        let curve = self.curve(property, "CURVE", [Quantity::Length, Quantity::Force], 1.0)?;
        let odd = curve.iter().all(|[x, y]| curve.iter().any(|[a, b]| *a == -x && *b == -y));
        if !odd {
            draft.assumed.push(format!(
                "the curve of the spring `{}` is taken as deflection and force in compression; turn the signs of both \
                 columns, and their order, if it is that in extension",
                self.usage
            ));
        }
        let value = self.block.number("USER_VALUE");
        let mut entries = vec![("table", Value::Rows(curve))];
        match (self.block.text("VALUE_TYPE").map(str::to_ascii_lowercase).as_deref(), value) {
            (Some("preload"), Some(preload)) => entries.push(("preload", Value::from(preload))),
            (Some("installed_length"), Some(installed)) => {
                let data = property.blocks.iter().find(|block| block.name == "SPRING_DATA");
                let free = data.and_then(|data| data.number("FREE_LENGTH"));
                let free = free.ok_or("its property file has no FREE_LENGTH")?;
                entries
                    .push(("free_length", Value::from(self.own(property, Quantity::Length, free))));
                entries.push(("installed_length", Value::from(installed)));
            }
            _ => {
                return Err(
                    "it has no VALUE_TYPE 'preload' or 'installed_length' with a USER_VALUE"
                        .to_owned(),
                );
            }
        }
        let ends = self.template.map(|template| template.strut.spring);
        self.line("spring", ends, entries)
    }

    /// Speed and force of a damper are positive in extension.
    fn damper(&self, property: &Property) -> Result<Part, String> {
        let curve = self.curve(property, "CURVE", [Quantity::Velocity, Quantity::Force], 1.0)?;
        let ends = self.template.map(|template| template.strut.damper);
        self.line("damper", ends, vec![("table", Value::Rows(curve))])
    }

    fn stop(&self, property: &Property, kind: &'static str) -> Result<Part, String> {
        let kind_of_distance = self.block.text("DISTANCE_TYPE").unwrap_or("clearance");
        let clearance =
            self.block.number("USER_DISTANCE").or_else(|| self.block.number("USER_VALUE"));
        let clearance = clearance.filter(|_| kind_of_distance.eq_ignore_ascii_case("clearance"));
        let clearance = clearance.ok_or("it has no USER_DISTANCE of DISTANCE_TYPE 'clearance'")?;
        let curve = self.curve(property, "CURVE", [Quantity::Length, Quantity::Force], 1.0)?;
        let ends = self.template.map(|template| template.strut.damper);
        self.line(
            kind,
            ends,
            vec![("clearance", Value::from(clearance)), ("table", Value::Rows(curve))],
        )
    }

    fn line(
        &self,
        kind: &'static str,
        ends: Option<[&'static str; 2]>,
        entries: Vec<(&'static str, Value)>,
    ) -> Result<Part, String> {
        let (Some(template), Some(ends)) = (self.template, ends) else {
            return Err("its template is not known, so neither are its ends".to_owned());
        };
        let bodies = ["chassis".to_owned(), template.strut.body.to_owned()];
        Ok(Part {
            name: word(&self.usage),
            line: self.block.line,
            called: self.usage.clone(),
            kind: PartKind::Force(kind, bodies),
            entries: [vec![("on", Value::from(ends))], entries].concat(),
            points: ends.map(str::to_owned).to_vec(),
            comments: vec![],
        })
    }

    /// Curves, dampings, preloads and scale factors of the six components.
    fn bushing(&self, property: &Property) -> Result<Part, String> {
        let template = self.template.ok_or("its template is not known, so neither is its joint")?;
        let place = template.bushings.iter().find(|(usage, ..)| *usage == self.usage);
        let (_, joint, at) =
            place.ok_or("the architecture has no joint that it could stand for")?;
        let axis = template.axes.iter().find(|(known, _)| known == joint).map(|(_, axis)| *axis);
        let axis = axis.ok_or("the axis of its joint is not known")?;
        let number = |key: String| self.block.number(&key);
        let mut tables = vec![];
        let mut damping = [0.0; 6];
        let data = property.blocks.iter().find(|block| block.name == "DAMPING");
        for (k, component) in COMPONENTS.into_iter().enumerate() {
            let (force, table) = (component.name, component.table);
            let scale = number(format!("{force}_SCALING_FACTOR")).unwrap_or(1.0);
            let curve =
                self.curve(property, &format!("{force}_CURVE"), component.columns, scale)?;
            tables.push((table, curve));
            let scale = number(format!("{force}_DAMPING_FORCE_SCALE")).unwrap_or(1.0);
            let given =
                data.and_then(|data| data.number(&format!("{force}_DAMPING"))).unwrap_or(0.0);
            damping[k] = scale * self.own(property, component.damping, given);
        }
        let preload = |group: &str| {
            ["Z", "X", "Y"].map(|axis| number(format!("{group}_PRELOAD_{axis}")).unwrap_or(0.0))
        };
        let offset = |group: &str| {
            ["X", "Y", "Z"].map(|axis| number(format!("{group}_OFFSET_{axis}")).unwrap_or(0.0))
        };
        if [offset("T"), offset("R")].concat().iter().any(|offset| *offset != 0.0) {
            return Err("it has offsets, which bushings do not have here".to_owned());
        }
        let [x, y, z, rx, ry, rz] = damping;
        Ok(Part {
            name: format!("{}_bushing", word(&self.usage)),
            line: self.block.line,
            called: self.usage.clone(),
            kind: PartKind::Bushing((*joint).to_owned()),
            entries: vec![
                ("at", Value::from(*at)),
                ("x_axis", Value::from(axis)),
                ("tables", Value::Tables(tables)),
                ("damping", Value::from([x, y, z])),
                ("rotational_damping", Value::from([rx, ry, rz])),
                ("preload", Value::from(preload("T"))),
                ("rotational_preload", Value::from(preload("R"))),
                ("law", Value::from("torque")),
            ],
            points: vec![(*at).to_owned(), axis[0].to_owned(), axis[1].to_owned()],
            comments: vec![BUSHING_AXES.to_owned()],
        })
    }

    /// A curve of a property file in the units of the subsystem, with its forces scaled.
    fn curve(
        &self,
        property: &Property,
        name: &str,
        columns: [Quantity; 2],
        scale: f64,
    ) -> Result<Vec<[f64; 2]>, String> {
        let block = property.blocks.iter().find(|block| block.name == name);
        let rows = block.map(Block::curve).unwrap_or_default();
        let rows: Vec<[f64; 2]> = rows
            .into_iter()
            .map(|[x, y]| {
                [self.own(property, columns[0], x), scale * self.own(property, columns[1], y)]
            })
            .collect();
        if rows.len() < 2 {
            return Err(format!("its property file has no [{name}] with at least two rows"));
        }
        if !rows.windows(2).all(|pair| pair[0][0] < pair[1][0]) {
            return Err(format!(
                "the first column of [{name}] in its property file does not increase"
            ));
        }
        Ok(rows)
    }

    /// A number of a property file in the units of the subsystem; the same number where they agree.
    fn own(&self, property: &Property, quantity: Quantity, number: f64) -> f64 {
        if property.units == self.units {
            return number;
        }
        quantity.show(self.units, quantity.to_si(property.units, number))
    }
}

/// A component of a bushing.
struct Component {
    name: &'static str,
    table: &'static str,
    columns: [Quantity; 2],
    damping: Quantity,
}

const fn translation(name: &'static str, table: &'static str) -> Component {
    Component {
        name,
        table,
        columns: [Quantity::Length, Quantity::Force],
        damping: Quantity::Damping,
    }
}

const fn rotation(name: &'static str, table: &'static str) -> Component {
    Component {
        name,
        table,
        columns: [Quantity::Angle, Quantity::Torque],
        damping: Quantity::RotationalDamping,
    }
}

/// Bushings of arms have z along the axis of the joint; here that is x, and the others follow in turn.
const COMPONENTS: [Component; 6] = [
    translation("FZ", "x"),
    translation("FX", "y"),
    translation("FY", "z"),
    rotation("TZ", "rx"),
    rotation("TX", "ry"),
    rotation("TY", "rz"),
];
