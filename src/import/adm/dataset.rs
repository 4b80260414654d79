//! Parts, markers, variables and splines of a dataset, each by its number.

use std::cell::Cell;
use std::collections::BTreeMap;

use super::expression::{Context, Expression, Measure};
use super::frame::{Angle, Frame};
use super::names::Names;
use super::notes::Notes;
use super::parse::parse;
use super::scales::{self, Scales};
use super::spline::Table;
use super::statement::{self, Statement};
use crate::vector::{Vector, add, cross, dot, norm, scale, sub, unit};

/// A body.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) line: usize,
    pub(super) name: String,
    pub(super) ground: bool,
    pub(super) frame: Frame,
    pub(super) mass: Option<f64>,
    pub(super) center: Option<u32>,
    pub(super) inertia_marker: Option<u32>,
    /// Moments, then products +∫ x y dm.
    pub(super) inertia: [f64; 6],
    /// Components along the axes of a marker, or of the default.
    pub(super) velocity: (Vector<f64>, Option<u32>),
    pub(super) rotation: (Vector<f64>, Option<u32>),
}

/// A point with axes on a part.
#[derive(Clone, Debug)]
pub(super) struct Marker {
    pub(super) id: u32,
    pub(super) name: String,
    pub(super) part: u32,
    /// In the frame of the ground.
    pub(super) frame: Frame,
    /// A marker that goes wherever another one is.
    pub(super) floating: bool,
}

/// What the statements of a dataset refer to.
pub(super) struct Dataset {
    pub(super) title: String,
    pub(super) scales: Scales,
    /// The number of the ground.
    pub(super) ground: Option<u32>,
    pub(super) parts: BTreeMap<u32, Part>,
    pub(super) markers: BTreeMap<u32, Marker>,
    pub(super) variables: BTreeMap<u32, Expression>,
    pub(super) splines: BTreeMap<u32, Table>,
    /// A length (of the dataset) to measure distances with: how far its markers are apart.
    pub(super) size: f64,
    /// How large the variables are, with those in them.
    sizes: BTreeMap<u32, usize>,
    /// How much more the laws of forces may cost, so that the import of any file ends.
    budget: Cell<usize>,
}

/// Variables in variables in variables beyond this are refused.
const NESTED: usize = 20;

/// What sampled laws may cost together: a thousand of a hundred parts.
const BUDGET: usize = 100_000;

pub(super) const PART: &[&str] = &[
    "CM", "EXACT", "GROUND", "IM", "IP", "MASS", "MATERIAL", "QG", "REULER", "VM", "VX", "VY",
    "VZ", "WM", "WX", "WY", "WZ", "XG", "ZG",
];
pub(super) const MARKER: &[&str] =
    &["FLOATING", "PART", "POINT_MASS", "QP", "REULER", "USEXP", "XP", "ZP", "FLEX_BODY"];

/// Two places nearer than this part of the size of the dataset are one.
pub(super) const NEAR: f64 = 1e-5;

impl Dataset {
    pub(super) fn read(title: String, statements: &mut [Statement], notes: &mut Notes) -> Self {
        let mut dataset = Self {
            title,
            scales: scales::read(statements, notes),
            ground: None,
            parts: BTreeMap::new(),
            markers: BTreeMap::new(),
            variables: BTreeMap::new(),
            splines: BTreeMap::new(),
            size: 1.0,
            sizes: BTreeMap::new(),
            budget: Cell::new(BUDGET),
        };
        let mut names = Names::default();
        for statement in of_kind(statements, "PART", PART) {
            dataset.add_part(statement, &mut names, notes);
        }
        let mut names = Names::default();
        // The point of measures without a second marker.
        names.own("origin".to_owned());
        for statement in of_kind(statements, "MARKER", MARKER) {
            dataset.add_marker(statement, &mut names, notes);
        }
        for statement in of_kind(statements, "VARIABLE", &["FUNCTION", "IC", "ROUTINE"]) {
            dataset.add_variable(statement, notes);
        }
        dataset.drop_endless_variables();
        for statement in of_kind(statements, "SPLINE", &["X", "Y", "Z", "LINEAR_EXTRAPOLATE"]) {
            dataset.add_spline(statement, notes);
        }
        let places = dataset.markers.values().filter(|marker| !marker.floating);
        let places: Vec<Vector<f64>> = places.map(|marker| marker.frame.origin).collect();
        let extent = |k: usize| {
            let all = places.iter().map(|place| place[k]);
            all.clone().fold(f64::MIN, f64::max) - all.fold(f64::MAX, f64::min)
        };
        let size = norm([0, 1, 2].map(extent));
        if size.is_finite() && size > 0.0 && !places.is_empty() {
            dataset.size = size;
        }
        dataset
    }

    fn add_part(&mut self, statement: &Statement, names: &mut Names, notes: &mut Notes) {
        let Some(id) = identifier(statement, |id| self.parts.contains_key(&id), notes) else {
            return;
        };
        let ground = statement.has("GROUND");
        if ground && self.ground.replace(id).is_some() {
            notes.mistake(statement.line, "there are two parts GROUND", "keep one of them");
        }
        let origin = statement.numbers("QG", notes).unwrap_or_default();
        let frame = frame(statement, origin, ["ZG", "XG"], notes);
        let given = statement.list("IP", notes).unwrap_or_default();
        let mut inertia = [0.0; 6];
        if ![0, 3, 6].contains(&given.len()) {
            let what = format!("IP of {} has {} numbers", statement.title(), given.len());
            notes.mistake(
                statement.line,
                what,
                "write three moments, or three moments and three products",
            );
        }
        inertia.iter_mut().zip(&given).for_each(|(to, from)| *to = *from);
        let mut vector = |keys: [&str; 3], marker: &str| {
            let components = keys.map(|key| statement.number(key, notes).unwrap_or_default());
            (components, statement.reference(marker, notes))
        };
        let velocity = vector(["VX", "VY", "VZ"], "VM");
        let rotation = vector(["WX", "WY", "WZ"], "WM");
        let name = names.take(statement, if ground { "ground" } else { "part" });
        // What may not be changed to assemble the parts, and what they look like.
        statement.has("EXACT");
        statement.has("MATERIAL");
        let part = Part {
            line: statement.line,
            name,
            ground,
            frame,
            // A part may have inertia without a mass.
            mass: statement.number("MASS", notes).or((inertia != [0.0; 6]).then_some(0.0)),
            center: statement.reference("CM", notes),
            inertia_marker: statement.reference("IM", notes),
            inertia,
            velocity,
            rotation,
        };
        if ground && frame != Frame::GROUND {
            let help = "write its markers in the frame of the ground itself";
            notes.mistake(statement.line, "the ground has a place or an orientation", help);
        }
        self.parts.insert(id, part);
    }

    fn add_marker(&mut self, statement: &Statement, names: &mut Names, notes: &mut Notes) {
        let Some(id) = identifier(statement, |id| self.markers.contains_key(&id), notes) else {
            return;
        };
        let Some(part) = statement.reference("PART", notes) else {
            let help = "write the number of its part: PART = …";
            notes.mistake(statement.line, format!("{} names no PART", statement.title()), help);
            return;
        };
        let Some(body) = self.parts.get(&part) else {
            let what = format!("{} is on PART/{part}, which does not exist", statement.title());
            notes.mistake(statement.line, what, "correct the number of the part");
            return;
        };
        let origin = statement.numbers("QP", notes).unwrap_or_default();
        statement.has("USEXP");
        let local = frame(statement, origin, ["ZP", "XP"], notes);
        let frame = body.frame.outward(&local);
        let name = names.take(statement, "marker");
        let floating = statement.has("FLOATING");
        self.markers.insert(id, Marker { id, name, part, frame, floating });
    }

    fn add_variable(&mut self, statement: &Statement, notes: &mut Notes) {
        let Some(id) = identifier(statement, |id| self.variables.contains_key(&id), notes) else {
            return;
        };
        // One that no force uses may be anything.
        if let Some((_, text)) = statement.text("FUNCTION")
            && let Ok(expression) = parse(text)
        {
            self.variables.insert(id, expression);
        }
    }

    /// Forgets variables that are made of themselves or of too many others, so that expressions end.
    fn drop_endless_variables(&mut self) {
        let mut sizes = BTreeMap::new();
        for id in self.variables.keys() {
            self.size_of_variable(*id, 0, &mut sizes);
        }
        self.sizes = sizes.into_iter().filter_map(|(id, size)| Some((id, size?))).collect();
        self.variables.retain(|id, _| self.sizes.contains_key(id));
    }

    fn size_of_variable(
        &self,
        id: u32,
        depth: usize,
        sizes: &mut BTreeMap<u32, Option<usize>>,
    ) -> Option<usize> {
        if let Some(size) = sizes.get(&id) {
            return *size;
        }
        if depth > NESTED {
            return None;
        }
        // Until it is known, a variable that meets itself has no size.
        sizes.insert(id, None);
        let expression = self.variables.get(&id)?;
        let size = expression.size(&mut |other| self.size_of_variable(other, depth + 1, sizes));
        sizes.insert(id, size);
        size
    }

    /// Takes what a law costs that has to be sampled from what one dataset may cost.
    pub(super) fn spend(&self, expression: &Expression) -> Result<(), String> {
        let sizes = |id: u32| self.sizes.get(&id).copied();
        let size = expression.size(&mut { sizes }).ok_or("it is too long")?;
        let left = self.budget.get().checked_sub(size.max(100));
        self.budget.set(left.ok_or("the dataset has too many expressions that are not linear")?);
        Ok(())
    }

    fn add_spline(&mut self, statement: &Statement, notes: &mut Notes) {
        let Some(id) = identifier(statement, |id| self.splines.contains_key(&id), notes) else {
            return;
        };
        let (x, y) = (statement.list("X", notes), statement.list("Y", notes));
        let (Some(x), Some(y), false) = (x, y, statement.has("Z")) else { return };
        if x.len() == y.len()
            && let Some(table) = Table::new(x.into_iter().zip(y).map(|(x, y)| [x, y]).collect())
        {
            self.splines.insert(id, table);
        }
    }

    /// The name of a marker's body.
    pub(super) fn body(&self, marker: &Marker) -> &Part {
        // A marker is only kept where its part exists.
        &self.parts[&marker.part]
    }

    /// The frame of a marker of a measure; the ground where it is absent.
    pub(super) fn frame_of(&self, measure: &Measure, place: usize) -> Result<Frame, String> {
        match measure.markers.get(place) {
            None | Some(0) => Ok(Frame::GROUND),
            Some(id) => match self.markers.get(id) {
                Some(marker) => Ok(marker.frame),
                None => Err(format!("{} names MARKER/{id}, which does not exist", measure.name)),
            },
        }
    }

    /// The number of the part that a marker of a measure is on.
    pub(super) fn part_of(&self, measure: &Measure, place: usize) -> Option<u32> {
        match measure.markers.get(place) {
            None | Some(0) => self.ground,
            Some(id) => self.markers.get(id).map(|marker| marker.part),
        }
    }

    /// A measure of positions in the design position, lengths in those of the dataset.
    pub(super) fn design(&self, measure: &Measure) -> Result<f64, String> {
        let (i, j) = (self.frame_of(measure, 0)?, self.frame_of(measure, 1)?);
        let way = sub(i.origin, j.origin);
        let along = |axis: usize| Ok(dot(way, self.frame_of(measure, 2)?.axes[axis]));
        let [x_i, _, z_i] = i.axes;
        let [x_j, y_j, z_j] = j.axes;
        match measure.name.as_str() {
            "DM" => Ok(norm(way)),
            "DX" => along(0),
            "DY" => along(1),
            "DZ" => along(2),
            "AX" => Ok((-dot(z_i, y_j)).atan2(dot(z_i, z_j))),
            "AY" => Ok(dot(z_i, x_j).atan2(dot(z_i, z_j))),
            "AZ" => Ok(dot(x_i, y_j).atan2(dot(x_i, x_j))),
            name => Err(format!("{name} is a velocity")),
        }
    }
}

/// The statements of one kind, with their keys in full.
pub(super) fn of_kind<'s>(
    statements: &'s mut [Statement],
    keyword: &str,
    keys: &[&'static str],
) -> impl Iterator<Item = &'s Statement> {
    let of_kind = statements.iter_mut().filter(move |statement| statement.keyword == keyword);
    of_kind.map(move |statement| {
        statement.know(keys);
        &*statement
    })
}

/// The number of a statement, which has to be its own.
fn identifier(
    statement: &Statement,
    taken: impl Fn(u32) -> bool,
    notes: &mut Notes,
) -> Option<u32> {
    let Some(id) = statement.id else {
        let what = format!("a {} has no number", statement.keyword);
        notes.mistake(
            statement.line,
            what,
            format!("write it behind a slash: {}/1", statement.keyword),
        );
        return None;
    };
    if taken(id) {
        notes.mistake(
            statement.line,
            format!("there are two {}", statement.title()),
            "give one of them another number",
        );
        return None;
    }
    Some(id)
}

/// Axes by angles, or by points on z and near x.
fn frame(
    statement: &Statement,
    origin: Vector<f64>,
    [z, x]: [&str; 2],
    notes: &mut Notes,
) -> Frame {
    let points = [z, x].map(|key| statement.numbers::<3>(key, notes));
    if points != [None, None] {
        return Frame::through(origin, points[0], points[1]).unwrap_or_else(|| {
            let what = format!("{z} and {x} of {} give no axes", statement.title());
            notes.mistake(statement.line, what, "write a point on the z axis and one beside it");
            Frame { origin, ..Frame::GROUND }
        });
    }
    if statement.numbers::<3>("REULER", notes).is_none() {
        return Frame { origin, ..Frame::GROUND };
    }
    let text = statement.text("REULER").map_or("", |(_, text)| text);
    let angle = |text: &str| {
        let text = text.trim();
        match text.strip_suffix(['D', 'd']).and_then(statement::number) {
            Some(degrees) => Angle::Degrees(degrees),
            None => Angle::Radians(statement::number(text).unwrap_or_default()),
        }
    };
    let mut angles = text.split(',').map(angle);
    let zero = Angle::Degrees(0.0);
    Frame::turned(origin, std::array::from_fn(|_| angles.next().unwrap_or(zero)))
}

impl Context for Dataset {
    fn measure(&self, measure: &Measure) -> Result<f64, String> {
        self.design(measure)
    }

    fn time(&self) -> Result<f64, String> {
        Err("it changes with time".into())
    }

    fn variable(&self, id: u32) -> Result<&Expression, String> {
        self.variables.get(&id).ok_or(format!(
            "VARIABLE/{id} does not exist, has no expression or is made of too many others"
        ))
    }

    fn spline(&self, function: &str, id: u32, x: f64) -> Result<f64, String> {
        let table = self.splines.get(&id).ok_or(format!(
            "SPLINE/{id} does not exist or is no table of four rising values or more"
        ))?;
        Ok(table.value(function, x))
    }
}

/// Whether two directions are along one line, and whether they point the same way.
pub(super) fn along(a: Vector<f64>, b: Vector<f64>) -> Option<f64> {
    (norm(cross(a, b)) <= NEAR).then(|| dot(a, b).signum())
}

/// The part of a direction that is normal to another one, of length one.
pub(super) fn normal_to(direction: Vector<f64>, to: Vector<f64>) -> Vector<f64> {
    unit(add(direction, scale(-dot(direction, to), to)))
}
