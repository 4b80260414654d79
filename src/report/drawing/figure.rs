//! What is drawn of a model: bodies, links, springs, wheels and points, in ISO 8855 axes.

use std::collections::BTreeMap;

use crate::mechanism::{BodyId, Direction, ForceKind, JointKind, Mechanism, PointId};
use crate::model::{Model, Setup, Side, StrutLine, SuspensionError, Wheel};
use crate::vector::{add, cross, scale, sub, unit};

/// One colour for each body, again from the first where there are more bodies.
const COLOURS: [&str; 10] = [
    "#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b", "#e377c2", "#17becf",
    "#bcbd22", "#7f7f7f",
];

/// The length (m) at which a body is drawn that shows nothing but its slide.
const SLIDE: f64 = 0.1;

/// Lines, bodies and points (m).
pub(super) struct Figure {
    /// Bodies between the points that hold them.
    pub(super) bodies: Vec<Body>,
    /// Rigid links without a body, by their ends.
    pub(super) links: Vec<[[f64; 3]; 2]>,
    /// Springs and dampers, by their ends.
    pub(super) struts: Vec<[[f64; 3]; 2]>,
    /// The circles of the wheels.
    pub(super) wheels: Vec<Vec<[f64; 3]>>,
    /// Height of the ground.
    pub(super) ground: f64,
    /// Points, each once.
    pub(super) marks: Vec<Mark>,
    /// The names of bodies with their colours and what they are.
    pub(super) names: Vec<(String, &'static str, String)>,
}

/// A body as the hull of its points.
pub(super) struct Body {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) colour: &'static str,
}

/// A point and its number in the model, for those of the model's own side.
pub(super) struct Mark {
    pub(super) place: [f64; 3],
    pub(super) number: Option<usize>,
    pub(super) kind: MarkKind,
}

/// What holds a point.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum MarkKind {
    /// The chassis, and perhaps something else.
    Chassis,
    /// Bodies.
    Body,
    /// Nothing: a point of an axis, or one that nothing uses.
    Free,
}

impl Figure {
    pub(super) fn of(model: &Model) -> Result<Self, SuspensionError> {
        let setup = Setup { kinematic: true, ..Setup::default() };
        let (mechanism, wheels, struts) = if model.is_axle() {
            let axle = model.axle(&setup)?;
            let struts = axle.sides.map(|side| [side.spring, side.damper]);
            (axle.mechanism, axle.sides.map(|side| side.wheel).to_vec(), struts.concat())
        } else {
            let corner = model.suspension(&setup)?;
            (corner.mechanism, vec![corner.wheel], vec![corner.spring, corner.damper])
        };
        let places = mechanism.positions();
        let ends = |points: [PointId; 2]| points.map(|point| places[point.0]);
        let mut figure = Self {
            bodies: vec![],
            links: vec![],
            struts: vec![],
            wheels: wheels.iter().map(|wheel| rim(wheel, places[wheel.center.0])).collect(),
            ground: f64::INFINITY,
            marks: vec![],
            names: vec![],
        };
        for wheel in &wheels {
            figure.ground = figure.ground.min(places[wheel.center.0][2] - wheel.radius);
        }
        for joint in mechanism.joints() {
            if let JointKind::Link { on_i, on_j } = joint.kind {
                figure.links.push(ends([on_i, on_j]));
            }
        }
        let struts = struts_of(&mechanism, &struts);
        figure.struts = struts.iter().map(|strut| ends(strut.map(|(_, point)| point))).collect();
        figure.add_bodies(model, &mechanism, &points_of(&mechanism, &wheels, struts));
        Ok(figure)
    }

    fn add_bodies(
        &mut self,
        model: &Model,
        mechanism: &Mechanism,
        held: &BTreeMap<BodyId, Vec<PointId>>,
    ) {
        let places = mechanism.positions();
        for (&body, points) in held {
            let chassis = body == BodyId::GROUND;
            for point in points {
                let kind = if chassis { MarkKind::Chassis } else { MarkKind::Body };
                self.add_mark(model, &mechanism.points()[point.0].name, places[point.0], kind);
            }
            if chassis {
                continue;
            }
            let name = without_side(model, &mechanism.bodies()[body.0].name).0;
            let colour = self.colour(model, name);
            let mut points: Vec<_> = points.iter().map(|point| places[point.0]).collect();
            if let (&[at], Some(along)) = (&points[..], slide(mechanism, body)) {
                // A rack goes on towards the other side.
                let way = if at[1] * along[1] > 0.0 { -SLIDE } else { SLIDE };
                points = vec![at, add(at, scale(way, along))];
            }
            self.bodies.push(Body { points, colour });
        }
        for (number, point) in model.points().iter().enumerate() {
            if self.marks.iter().all(|mark| mark.number != Some(number)) {
                let (place, number) = (point.position, Some(number));
                self.marks.push(Mark { place, number, kind: MarkKind::Free });
            }
        }
        // Small bodies lie above large ones.
        self.bodies.sort_by_key(|body| std::cmp::Reverse(body.points.len()));
    }

    /// The colour of a body, which both sides share; its name is listed.
    fn colour(&mut self, model: &Model, name: &str) -> &'static str {
        if let Some((_, colour, _)) = self.names.iter().find(|(known, ..)| known == name) {
            return colour;
        }
        let colour = COLOURS[self.names.len() % COLOURS.len()];
        let role = model.architecture.bodies().iter().find(|body| body.name == name);
        let meaning = role.map_or(String::new(), |role| role.meaning.clone());
        self.names.push((name.to_owned(), colour, meaning));
        colour
    }

    fn add_mark(&mut self, model: &Model, name: &str, place: [f64; 3], kind: MarkKind) {
        let (name, own) = without_side(model, name);
        let number = model.points().iter().position(|point| point.name == name);
        let number = number.filter(|_| own);
        let known = |mark: &Mark| mark.place == place && mark.number == number;
        // The chassis comes first, so what it holds stays its own.
        if !self.marks.iter().any(known) {
            self.marks.push(Mark { place, number, kind });
        }
    }
}

/// The points of each body: where it is held, where springs and dampers stand, and the wheel centre.
fn points_of(
    mechanism: &Mechanism,
    wheels: &[Wheel],
    struts: Vec<[(BodyId, PointId); 2]>,
) -> BTreeMap<BodyId, Vec<PointId>> {
    let centers = wheels.iter().map(|wheel| (wheel.body, wheel.center));
    let mut points: BTreeMap<BodyId, Vec<PointId>> = BTreeMap::new();
    for (body, point) in
        mechanism.held_points().into_iter().chain(centers).chain(struts.into_iter().flatten())
    {
        let of = points.entry(body).or_default();
        if !of.contains(&point) {
            of.push(point);
        }
    }
    points
}

/// Springs and dampers: those that act, and those whose seats are known.
fn struts_of(mechanism: &Mechanism, lines: &[Option<StrutLine>]) -> Vec<[(BodyId, PointId); 2]> {
    let forces = mechanism.forces().iter().filter_map(|force| match force.kind {
        ForceKind::Line { on_i, on_j, .. } => Some([(force.i, on_i), (force.j, on_j)]),
        _ => None,
    });
    let seats = lines.iter().flatten().map(|line| line.ends.map(|(point, body)| (body, point)));
    let mut struts: Vec<_> = forces.chain(seats).collect();
    for strut in &mut struts {
        strut.sort_unstable();
    }
    struts.sort_unstable();
    struts.dedup();
    struts
}

/// The unit vector along which a body slides.
fn slide(mechanism: &Mechanism, body: BodyId) -> Option<[f64; 3]> {
    let places = mechanism.positions();
    mechanism.joints().iter().find_map(|joint| match joint.kind {
        JointKind::Translational { axis, .. } if joint.j == body => Some(unit(match axis {
            Direction::Between(from, to) => sub(places[to.0], places[from.0]),
            Direction::Fixed(along) => along,
        })),
        _ => None,
    })
}

/// The circle of a wheel.
fn rim(wheel: &Wheel, center: [f64; 3]) -> Vec<[f64; 3]> {
    let first = unit(cross(wheel.spin_axis, [0.0, 0.0, 1.0]));
    let second = cross(wheel.spin_axis, first);
    let places = (0..=120).map(|step| {
        let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 120.0).sin_cos();
        add(center, scale(wheel.radius, add(scale(cos, first), scale(sin, second))))
    });
    places.collect()
}

/// The name of a part in the model, and whether it is one of the side that the model describes.
fn without_side<'n>(model: &Model, name: &'n str) -> (&'n str, bool) {
    if !model.is_axle() {
        return (name, true);
    }
    for side in [Side::Left, Side::Right] {
        let rest = name.strip_prefix(side.name()).and_then(|rest| rest.strip_prefix('_'));
        if let Some(rest) = rest {
            return (rest, side == model.side);
        }
    }
    (name, true)
}
