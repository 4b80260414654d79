//! A drawing of the points of a model: three views, bodies as lines between their joints.

use std::fmt::Write as _;

use crate::mechanism::{BodyId, ForceKind, JointKind, Mechanism, PointId};
use crate::model::{Model, Setup, Side, StrutLine, SuspensionError, Wheel, joint_points};
use crate::vector::{add, cross, scale, unit};

/// Width of the front and the side view together, in pixels.
const WIDTH: f64 = 760.0;
const MARGIN: f64 = 30.0;
const LINE: f64 = 15.0;
/// Points nearer than this on the sheet (pixels) share a label.
const TOGETHER: f64 = 6.0;
/// One colour for each body, again from the first where there are more bodies.
const COLOURS: [&str; 10] = [
    "#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b", "#e377c2", "#17becf",
    "#bcbd22", "#7f7f7f",
];

/// The model at its design position as SVG: front, side and top view in one scale, with a list of its points.
///
/// A body is a line, a triangle or a star between its joints, a link without a body a dark line, a wheel a circle, a spring or damper a
/// broken line; a square is a joint on the chassis.
///
/// # Errors
/// As for [`Model::suspension`] and [`Model::axle`].
pub fn drawing(model: &Model) -> Result<String, SuspensionError> {
    let figure = Figure::of(model)?;
    let views = [View::Front, View::Side(model.side), View::Top];
    let [front, side, top] = views.map(|view| figure.bounds(view));
    let scale = (WIDTH / (front.width() + side.width())).min(0.9e3);
    let [front_width, side_width] = [front, side].map(|view| view.width() * scale);
    let upper = front.height().max(side.height()) * scale;
    let below = 2.0 * MARGIN + upper + 2.0 * LINE;
    let legend = figure.legend(model);
    #[allow(clippy::cast_precision_loss)] // A model has a handful of points.
    let listed = legend.len() as f64 * LINE;
    let width = 3.0 * MARGIN + front_width + side_width.max(330.0);
    let height = below + (top.height() * scale).max(listed) + MARGIN;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"sans-serif\" font-size=\"11\">\n\
         <title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        escaped(&model.name)
    );
    let right = 2.0 * MARGIN + front_width;
    let places = [(MARGIN, MARGIN + LINE), (right, MARGIN + LINE), (MARGIN, below)];
    for ((view, bounds), place) in views.into_iter().zip([front, side, top]).zip(places) {
        let frame = Frame { view, bounds, scale, place };
        figure.draw(&frame, &mut svg);
    }
    for (row, line) in legend.iter().enumerate() {
        #[allow(clippy::cast_precision_loss)]
        let y = below + row as f64 * LINE;
        let (colour, text) = line;
        let _ = writeln!(
            svg,
            "<text x=\"{right:.1}\" y=\"{y:.1}\" fill=\"{colour}\">{}</text>",
            escaped(text)
        );
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// Lines and points in ISO 8855 axes.
struct Figure {
    lines: Vec<Line>,
    /// The number of the point in the model, for those of its own side, and whether it is on the chassis.
    points: Vec<([f64; 3], Option<usize>, bool)>,
    bodies: Vec<(String, &'static str)>,
}

struct Line {
    points: Vec<[f64; 3]>,
    style: String,
}

impl Figure {
    fn of(model: &Model) -> Result<Self, SuspensionError> {
        let setup = Setup { kinematic: true, ..Setup::default() };
        let mut figure = Self { lines: vec![], points: vec![], bodies: vec![] };
        if model.is_axle() {
            let axle = model.axle(&setup)?;
            let wheels = axle.sides.map(|side| side.wheel);
            figure.add_bodies(model, &axle.mechanism, &wheels);
            let struts = axle.sides.map(|side| [side.spring, side.damper]);
            figure.add_struts(&axle.mechanism, struts.as_flattened());
        } else {
            let corner = model.suspension(&setup)?;
            figure.add_bodies(model, &corner.mechanism, &[corner.wheel]);
            figure.add_struts(&corner.mechanism, &[corner.spring, corner.damper]);
        }
        Ok(figure)
    }

    fn add_bodies(&mut self, model: &Model, mechanism: &Mechanism, wheels: &[Wheel]) {
        let place = |point: PointId| mechanism.points()[point.0].position;
        let names: Vec<&str> =
            model.architecture.bodies().iter().map(|b| b.name.as_str()).collect();
        for (index, body) in mechanism.bodies().iter().enumerate() {
            let id = BodyId(index);
            let mut held = joint_points(mechanism.joints(), id);
            if index > 0 {
                held.extend(
                    wheels.iter().filter(|wheel| wheel.body == id).map(|wheel| wheel.center),
                );
            }
            for point in &held {
                let point_name = &mechanism.points()[point.0].name;
                self.add_point(model, point_name, place(*point), index == 0);
            }
            let Some(role) =
                names.iter().position(|name| *name == without_side(model, &body.name).0)
            else {
                continue; // The chassis is not drawn.
            };
            let colour = COLOURS[role % COLOURS.len()];
            if self.bodies.iter().all(|(name, _)| name != names[role]) {
                self.bodies.push((names[role].to_owned(), colour));
            }
            let style = format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"2.5\"");
            self.add_body(held.into_iter().map(place).collect(), &style);
        }
        for joint in mechanism.joints() {
            if let JointKind::Link { on_i, on_j } = joint.kind {
                let style = "fill=\"none\" stroke=\"#333333\" stroke-width=\"2.5\"".to_owned();
                self.lines.push(Line { points: vec![place(on_i), place(on_j)], style });
            }
        }
        for wheel in wheels {
            let (center, spin) = (place(wheel.center), wheel.spin_axis);
            let first = unit(cross(spin, [0.0, 0.0, 1.0]));
            let second = cross(spin, first);
            let rim = (0..=48).map(|step| {
                let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 48.0).sin_cos();
                let way = add(scale(cos, first), scale(sin, second));
                add(center, scale(wheel.radius, way))
            });
            let style = "fill=\"none\" stroke=\"#bbbbbb\"".to_owned();
            self.lines.push(Line { points: rim.collect(), style });
        }
    }

    /// A line between two joints, a triangle between three, and otherwise a star.
    fn add_body(&mut self, mut points: Vec<[f64; 3]>, style: &str) {
        let mut add_line = |points| self.lines.push(Line { points, style: style.to_owned() });
        match points.len() {
            0 | 1 => {}
            2 => add_line(points),
            3 => {
                points.push(points[0]);
                add_line(points);
            }
            number => {
                #[allow(clippy::cast_precision_loss)] // A body has a handful of points.
                let share = 1.0 / number as f64;
                let middle = scale(share, points.iter().copied().fold([0.0; 3], add));
                points.into_iter().for_each(|point| add_line(vec![middle, point]));
            }
        }
    }

    /// Springs and dampers: those that act, and those whose seats are known.
    fn add_struts(&mut self, mechanism: &Mechanism, struts: &[Option<StrutLine>]) {
        let lines = mechanism.forces().iter().filter_map(|force| match force.kind {
            ForceKind::Line { on_i, on_j, .. } => Some([on_i, on_j]),
            _ => None,
        });
        let seats = struts.iter().flatten().map(|line| line.ends.map(|(point, _)| point));
        let mut drawn: Vec<_> = lines.chain(seats).collect();
        drawn.sort_unstable();
        drawn.dedup();
        for ends in drawn {
            let points = ends.map(|point| mechanism.points()[point.0].position).to_vec();
            let style =
                "fill=\"none\" stroke=\"#555555\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"";
            self.lines.push(Line { points, style: style.to_owned() });
        }
    }

    fn add_point(&mut self, model: &Model, name: &str, place: [f64; 3], chassis: bool) {
        let (name, own) = without_side(model, name);
        let number = model.points().iter().position(|point| point.name == name);
        let number = number.filter(|_| own);
        let known = self.points.iter().any(|(known, its, _)| *known == place && *its == number);
        if !known {
            self.points.push((place, number, chassis));
        }
    }

    fn legend(&self, model: &Model) -> Vec<(&'static str, String)> {
        let architecture = &model.architecture;
        let roles = || architecture.points().iter().chain(architecture.optional_points());
        let mut lines: Vec<(&str, String)> = vec![];
        for (number, point) in model.points().iter().enumerate() {
            if self.points.iter().any(|(_, its, _)| *its == Some(number)) {
                let role = roles().find(|role| role.name == point.name);
                let meaning = role.map_or(String::new(), |role| format!(": {}", role.meaning));
                lines.push(("black", format!("{}  {}{meaning}", number + 1, point.name)));
            }
        }
        lines.extend(self.bodies.iter().map(|(name, colour)| (*colour, format!("— {name}"))));
        lines
    }

    fn bounds(&self, view: View) -> Bounds {
        let lines = self.lines.iter().flat_map(|line| line.points.iter().copied());
        let places = lines.chain(self.points.iter().map(|(place, ..)| *place));
        let mut bounds = Bounds { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        for place in places.map(|place| view.project(place)) {
            for axis in 0..2 {
                bounds.low[axis] = bounds.low[axis].min(place[axis]);
                bounds.high[axis] = bounds.high[axis].max(place[axis]);
            }
        }
        bounds
    }

    fn draw(&self, frame: &Frame, svg: &mut String) {
        let (x, y) = frame.place;
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{:.1}\" font-weight=\"bold\">{}</text>",
            y - 12.0,
            frame.view.title()
        );
        for Line { points, style } in &self.lines {
            let points: Vec<String> = points
                .iter()
                .map(|point| {
                    let [x, y] = frame.on_sheet(*point);
                    format!("{x:.1},{y:.1}")
                })
                .collect();
            let _ = writeln!(svg, "<polyline points=\"{}\" {style}/>", points.join(" "));
        }
        let mut labels: Vec<([f64; 2], String)> = vec![];
        for (place, number, chassis) in &self.points {
            let [x, y] = frame.on_sheet(*place);
            let _ = if *chassis {
                let (x, y) = (x - 3.5, y - 3.5);
                writeln!(svg, "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"7\" height=\"7\"/>")
            } else {
                writeln!(
                    svg,
                    "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"white\" stroke=\"black\"/>"
                )
            };
            if let Some(number) = number {
                let near = |(place, _): &&mut ([f64; 2], String)| {
                    (place[0] - x).hypot(place[1] - y) < TOGETHER
                };
                match labels.iter_mut().find(near) {
                    Some((_, label)) => *label = format!("{label}, {}", number + 1),
                    None => labels.push(([x, y], (number + 1).to_string())),
                }
            }
        }
        for ([x, y], label) in labels {
            let (x, y) = (x + 5.0, y - 4.0);
            let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\">{label}</text>");
        }
    }
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

/// From where one looks.
#[derive(Clone, Copy)]
enum View {
    Front,
    Side(Side),
    Top,
}

impl View {
    /// To the right and upward on the sheet (m).
    fn project(self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        match self {
            Self::Front => [y, z],
            Self::Side(side) => [-side.sign() * x, z],
            Self::Top => [y, -x],
        }
    }

    fn title(self) -> &'static str {
        match self {
            Self::Front => "Front view, from ahead",
            Self::Side(Side::Left) => "Side view from the left, forward to the left",
            Self::Side(Side::Right) => "Side view from the right, forward to the right",
            Self::Top => "Top view, forward is down",
        }
    }
}

/// The box around a view (m).
#[derive(Clone, Copy)]
struct Bounds {
    low: [f64; 2],
    high: [f64; 2],
}

impl Bounds {
    fn width(self) -> f64 {
        self.high[0] - self.low[0]
    }

    fn height(self) -> f64 {
        self.high[1] - self.low[1]
    }
}

/// Where a view stands on the sheet: its upper left corner in pixels, and pixels per metre.
struct Frame {
    view: View,
    bounds: Bounds,
    scale: f64,
    place: (f64, f64),
}

impl Frame {
    fn on_sheet(&self, place: [f64; 3]) -> [f64; 2] {
        let [u, v] = self.view.project(place);
        let [left, top] = [u - self.bounds.low[0], self.bounds.high[1] - v];
        [self.place.0 + left * self.scale, self.place.1 + top * self.scale]
    }
}

/// Text that stands between tags.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
