//! The text of the mechanism file.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::dataset::{Dataset, Marker};
use super::names::Names;
use super::statement::Statement;
use crate::vector::Vector;

/// Which list of the file a section belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum List {
    Joints,
    Drivers,
    Forces,
    Markers,
}

impl List {
    const ALL: [Self; 4] = [Self::Joints, Self::Drivers, Self::Forces, Self::Markers];

    fn key(self) -> &'static str {
        match self {
            Self::Joints => "joints",
            Self::Drivers => "drivers",
            Self::Forces => "forces",
            Self::Markers => "markers",
        }
    }
}

/// The file as far as it is written.
pub(super) struct Output<'d> {
    pub(super) dataset: &'d Dataset,
    /// The points in use by the number of their marker; 0 is the origin of the ground.
    points: BTreeMap<u32, (String, Vector<f64>)>,
    names: [Names; 4],
    sections: [String; 4],
}

impl<'d> Output<'d> {
    pub(super) fn new(dataset: &'d Dataset) -> Self {
        Self {
            dataset,
            points: BTreeMap::new(),
            names: Default::default(),
            sections: Default::default(),
        }
    }

    /// The point of a marker, in quotes.
    pub(super) fn point(&mut self, marker: &Marker) -> String {
        let place = (marker.name.clone(), marker.frame.origin);
        let (name, _) = self.points.entry(marker.id).or_insert(place);
        quoted(name)
    }

    /// A name of its own for a part of a list.
    pub(super) fn name(&mut self, list: List, statement: &Statement, kind: &str) -> String {
        self.names[list as usize].take(statement, kind)
    }

    /// Whether a list has no section.
    pub(super) fn is_empty(&self, list: List) -> bool {
        self.sections[list as usize].is_empty()
    }

    /// Writes a section of a list: its name, then keys with values as they stand in the file.
    pub(super) fn section(
        &mut self,
        list: List,
        statement: &Statement,
        name: &str,
        lines: &[(&str, String)],
    ) {
        let text = &mut self.sections[list as usize];
        // Writing to a string does not fail.
        let _ = write!(
            text,
            "\n# {}, line {}\n[[{}]]\nname = {}\n",
            statement.title(),
            statement.line,
            list.key(),
            quoted(name)
        );
        for (key, value) in lines {
            let _ = writeln!(text, "{key} = {value}");
        }
    }

    /// The whole file.
    pub(super) fn finish(self, file: &str, gravity: Vector<f64>) -> String {
        let Self { dataset, points, names: _, sections } = self;
        let scales = &dataset.scales;
        let ground = dataset.parts.values().find(|part| part.ground);
        let ground = ground.map_or("ground", |part| part.name.as_str());
        let title = if dataset.title.is_empty() { "Adams dataset" } else { &dataset.title };
        let mut text = String::from("format = 1\n");
        let mut line = |line: String| {
            text.push_str(&line);
            text.push('\n');
        };
        line(format!("name = {}", quoted(title)));
        line(format!("source = {}", quoted(&format!("Adams/Solver dataset {file}"))));
        line(format!("ground = {}", quoted(ground)));
        line(format!("gravity = {}             # m/s²", vector(gravity)));
        if sections[List::Joints as usize].is_empty() {
            line("joints = []".to_owned());
        }
        line("\n[units]".to_owned());
        line(format!("length = {}", quoted(scales.length_unit.symbol())));
        line("angle = \"rad\"".to_owned());
        line(format!("force = {}", quoted(scales.force_unit.symbol())));
        line(format!("mass = {}", quoted(scales.mass_unit.symbol())));
        line(
            "\n[points]                         # where the markers of these names are".to_owned(),
        );
        for (name, place) in points.values() {
            line(format!("{name} = {}", vector(place.map(|c| c * scales.length))));
        }
        for part in dataset.parts.values().filter(|part| !part.ground) {
            line(format!("\n# line {}\n[bodies.{}]", part.line, part.name));
            match part.mass {
                None => line("meaning = \"A body without mass\"".to_owned()),
                Some(mass) => mass_lines(dataset, part, mass, &mut line),
            }
        }
        for list in List::ALL {
            text.push_str(&sections[list as usize]);
        }
        text
    }
}

fn mass_lines(
    dataset: &Dataset,
    part: &super::dataset::Part,
    mass: f64,
    line: &mut impl FnMut(String),
) {
    let scales = &dataset.scales;
    // What is wrong with a part has been noted, and then nothing is written.
    let (center, inertia) = dataset.mass_of(part, mass).unwrap_or_default();
    let [velocity, rotation] = dataset.motion_of(part).unwrap_or_default();
    line(format!("mass = {}", number(mass * scales.mass)));
    line(format!("center_of_mass = {}", vector(center.map(|c| c * scales.length))));
    let inertia: Vec<String> = inertia.map(|j| number(j * scales.inertia())).to_vec();
    let count = if inertia[3..].iter().all(|product| product == "0.0") { 3 } else { 6 };
    line(format!("inertia = [{}]", inertia[..count].join(", ")));
    if velocity != [0.0; 3] {
        line(format!("velocity = {}", vector(velocity.map(|v| v * scales.velocity()))));
    }
    if rotation != [0.0; 3] {
        line(format!("angular_velocity = {}", vector(rotation.map(|w| w / scales.time))));
    }
}

/// A text in quotes.
pub(super) fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

/// A number that reads back as the same, with a point.
pub(super) fn number(number: f64) -> String {
    // Adding zero turns −0 into 0.
    format!("{:?}", number + 0.0)
}

/// Three numbers.
pub(super) fn vector(numbers: Vector<f64>) -> String {
    list(&numbers)
}

/// Any numbers.
pub(super) fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|n| number(*n)).collect();
    format!("[{}]", numbers.join(", "))
}

/// The rows of a table.
pub(super) fn table(rows: &[[f64; 2]]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| format!("    {},\n", list(row))).collect();
    format!("[\n{}]", rows.concat())
}

/// A direction: the name of a coordinate axis, or a vector.
pub(super) fn direction(axis: Vector<f64>) -> String {
    match axis {
        [1.0, 0.0, 0.0] => quoted("x"),
        [0.0, 1.0, 0.0] => quoted("y"),
        [0.0, 0.0, 1.0] => quoted("z"),
        axis => vector(axis),
    }
}
