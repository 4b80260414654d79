//! A suspension as an importer finds it, before it is written as a model file.

mod fit;
mod write;

pub(crate) use fit::{POINT_MASS, beyond_any_body};

use std::path::Path;

use super::options::{Options, read_text};
use super::sheet::Value;
use super::{ImportError, Imported, LeftOut};
use crate::model::{
    AngleUnit, Architecture, Axes, Axle, Document, ForceUnit, LengthUnit, MassUnit, Side, Units,
};

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
    /// A force element between the two sides of an axle.
    AxleForce(&'static str, [String; 2]),
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
