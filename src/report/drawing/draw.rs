//! One view of a figure.

use std::fmt::Write as _;

use super::figure::{Figure, Mark, MarkKind};
use super::label::Obstacles;
use super::view::{Frame, View};

/// Points nearer than this on the sheet (pixels) share a label.
const TOGETHER: f64 = 5.0;
/// Labels may stand this far (pixels) beside the box of a view.
const BESIDE: f64 = 26.0;

/// How the ground, the middle of the vehicle, links and springs are drawn.
pub(super) const REFERENCE: &str = "stroke=\"#999999\" stroke-dasharray=\"8 3 2 3\"";
pub(super) const LINK: &str = "stroke=\"#333333\" stroke-width=\"2.5\"";
pub(super) const STRUT: &str = "stroke=\"#555555\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"";

impl Figure {
    pub(super) fn draw(&self, frame: &Frame, svg: &mut String) {
        let [x, y] = frame.place;
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{:.1}\" font-weight=\"bold\">{}</text>",
            y - 18.0,
            frame.view.title()
        );
        let mut lines = vec![];
        let mut polyline = |points: Vec<[f64; 2]>, style: &str| {
            let shape = if style.contains("fill-opacity") { "polygon" } else { "polyline" };
            let _ = writeln!(svg, "<{shape} points=\"{}\" {style}/>", listed(&points));
            lines.extend(points.windows(2).map(|ends| [ends[0], ends[1]]));
            // A polygon is closed.
            if let ("polygon", [first, .., last]) = (shape, &points[..]) {
                lines.push([*last, *first]);
            }
        };
        for line in self.references(frame) {
            polyline(line.to_vec(), &format!("fill=\"none\" {REFERENCE}"));
        }
        for wheel in &self.wheels {
            let style = "fill=\"none\" stroke=\"#bbbbbb\" stroke-width=\"1.5\"";
            polyline(on_sheet(frame, wheel), style);
        }
        for body in &self.bodies {
            let colour = body.colour;
            let mut points = on_sheet(frame, &body.points);
            let style = if points.len() > 2 {
                points = hull(points);
                format!(
                    "fill=\"{colour}\" fill-opacity=\"0.12\" stroke=\"{colour}\" stroke-width=\"1.8\" stroke-linejoin=\"round\""
                )
            } else {
                format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"2.5\"")
            };
            polyline(points, &style);
        }
        for (ends, style) in [(&self.links, LINK), (&self.struts, STRUT)] {
            for line in ends {
                polyline(on_sheet(frame, line), &format!("fill=\"none\" {style}"));
            }
        }
        self.draw_marks(frame, lines, svg);
    }

    /// The ground, and the middle of the vehicle where it is in the view.
    fn references(&self, frame: &Frame) -> Vec<[[f64; 2]; 2]> {
        let [[left, top], [right, bottom]] = frame.corners();
        let [x, y] = frame.on_sheet([0.0, 0.0, self.ground]);
        let mut lines = vec![];
        if !matches!(frame.view, View::Top) {
            lines.push([[left - 8.0, y], [right + 8.0, y]]);
        }
        if !matches!(frame.view, View::Side(_)) && (left..=right).contains(&x) {
            lines.push([[x, top - 8.0], [x, bottom + 8.0]]);
        }
        lines
    }

    /// Marks of points with their numbers; those that are one on the sheet share a label.
    fn draw_marks(&self, frame: &Frame, lines: Vec<[[f64; 2]; 2]>, svg: &mut String) {
        let mut labels: Vec<([f64; 2], Vec<usize>)> = vec![];
        for Mark { place, number, kind } in &self.marks {
            let at = frame.on_sheet(*place);
            draw_mark(at, *kind, svg);
            let Some(number) = number else { continue };
            let near = |(place, _): &&mut ([f64; 2], _)| {
                f64::hypot(place[0] - at[0], place[1] - at[1]) < TOGETHER
            };
            match labels.iter_mut().find(near) {
                Some((_, numbers)) => numbers.push(number + 1),
                None => labels.push((at, vec![number + 1])),
            }
        }
        let [low, high] = frame.corners();
        // The title is above.
        let inside = [[low[0] - BESIDE, low[1] - 14.0], high.map(|high| high + BESIDE)];
        let marks = self.marks.iter().map(|mark| frame.on_sheet(mark.place)).collect();
        let mut obstacles = Obstacles::new(marks, lines, inside);
        for (at, mut numbers) in labels {
            numbers.sort_unstable();
            let numbers: Vec<String> = numbers.iter().map(usize::to_string).collect();
            let text = numbers.join(", ");
            let placed = obstacles.place(at, &text);
            if let Some([x, y]) = placed.leader {
                let _ = writeln!(
                    svg,
                    "<path d=\"M{:.1} {:.1}L{x:.1} {y:.1}\" stroke=\"#555555\" stroke-width=\"0.6\"/>",
                    at[0], at[1]
                );
            }
            let [x, y] = placed.at;
            let place = format!("x=\"{x:.1}\" y=\"{y:.1}\"");
            // What is under the number stays readable around it.
            let _ = writeln!(
                svg,
                "<text {place} stroke=\"white\" stroke-width=\"3\" stroke-opacity=\"0.8\">{text}</text>\n\
                 <text {place}>{text}</text>"
            );
        }
    }
}

/// A square on the chassis, a circle on bodies, a cross on nothing.
pub(super) fn draw_mark([x, y]: [f64; 2], kind: MarkKind, svg: &mut String) {
    let _ = match kind {
        MarkKind::Chassis => {
            let (x, y) = (x - 3.5, y - 3.5);
            writeln!(svg, "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"7\" height=\"7\"/>")
        }
        MarkKind::Body => writeln!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"white\" stroke=\"black\"/>"
        ),
        MarkKind::Free => {
            let [left, right, up, down] = [x - 3.0, x + 3.0, y - 3.0, y + 3.0];
            writeln!(
                svg,
                "<path d=\"M{left:.1} {up:.1}L{right:.1} {down:.1}M{left:.1} {down:.1}L{right:.1} {up:.1}\" \
                 stroke=\"black\"/>"
            )
        }
    };
}

fn on_sheet(frame: &Frame, places: &[[f64; 3]]) -> Vec<[f64; 2]> {
    places.iter().map(|place| frame.on_sheet(*place)).collect()
}

fn listed(points: &[[f64; 2]]) -> String {
    let points: Vec<String> = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    points.join(" ")
}

/// The convex hull of points, in order (Andrew's monotone chain).
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let turns = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0
    };
    let half = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = vec![];
        for point in points {
            while let [.., a, b] = chain[..]
                && !turns(a, b, point)
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut chain = half(&mut points.iter().copied());
    chain.extend(half(&mut points.iter().rev().copied()));
    chain
}

#[cfg(test)]
mod tests {
    use super::hull;

    #[test]
    fn the_hull_leaves_out_what_is_inside() {
        let points = vec![
            [1.0, 1.0],
            [0.0, 0.0],
            [2.0, 0.0],
            [1.0, 0.0],
            [2.0, 2.0],
            [0.0, 2.0],
            [0.5, 1.5],
        ];
        assert_eq!(hull(points), [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
        // On one line, there and back.
        assert_eq!(hull(vec![[0.0, 0.0], [2.0, 2.0], [1.0, 1.0]]), [[0.0, 0.0], [2.0, 2.0]]);
    }
}
