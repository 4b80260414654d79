//! A drawing of the points of a model: three views in one scale, and a list of what is in them.

mod draw;
mod figure;
mod label;
mod legend;
mod view;

use std::fmt::Write as _;

use crate::model::{Model, SuspensionError};
use figure::Figure;
use view::{Bounds, Frame, View};

/// Most pixels of the front and the side view side by side, and of the front and the top view one above the other.
const SIZE: [f64; 2] = [780.0, 840.0];
/// Pixels around everything, between views, above a view for its title, and below it for the axes.
const MARGIN: f64 = 30.0;
const GAP: f64 = 60.0;
const TITLE: f64 = 30.0;
const AXES: f64 = 60.0;

/// The model at its design position as SVG: front, side and top view in one scale, with the axes of the model, the
/// scale, and a list of points, bodies and signs.
///
/// A body is the hull of the points that hold it, a line where there are two. Numbers stand beside the points of the
/// side that the model describes.
///
/// # Errors
/// As for [`Model::suspension`] and [`Model::axle`].
pub fn drawing(model: &Model) -> Result<String, SuspensionError> {
    let figure = Figure::of(model)?;
    let views = [View::Front, View::Side(model.side), View::Top];
    let [front, side, top] = views.map(|view| figure.bounds(view));
    let across = front.width() + side.width();
    let down = front.height().max(side.height()) + top.height();
    let scale = (SIZE[0] / across).min(SIZE[1] / down).min(900.0);
    let right = MARGIN + front.width() * scale + GAP;
    let below = MARGIN + TITLE + front.height().max(side.height()) * scale + AXES + TITLE;
    let places = [[MARGIN, MARGIN + TITLE], [right, MARGIN + TITLE], [MARGIN, below]];
    let mut body = String::new();
    for ((view, bounds), place) in views.into_iter().zip([front, side, top]).zip(places) {
        let frame = Frame { view, bounds, scale, place };
        figure.draw(&frame, &mut body);
        frame.draw_axes(model.axes, &mut body);
    }
    let [wide, high] = figure.draw_legend(model, [right, below - TITLE], scale, &mut body);
    let width = MARGIN + (right + side.width() * scale).max(wide);
    let height = MARGIN + (below + top.height() * scale + AXES).max(high);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"sans-serif\" font-size=\"11\">\n\
         <title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        escaped(&model.name)
    );
    let _ = writeln!(svg, "{body}</svg>");
    Ok(svg)
}

/// Text that stands between tags.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

impl Figure {
    fn bounds(&self, view: View) -> Bounds {
        let bodies = self.bodies.iter().flat_map(|body| body.points.iter().copied());
        let lines = self.links.iter().chain(&self.struts).flatten().copied();
        let wheels = self.wheels.iter().flatten().copied();
        let marks = self.marks.iter().map(|mark| mark.place);
        let places = bodies.chain(lines).chain(wheels).chain(marks);
        Bounds::around(places.map(|place| view.project(place)))
    }
}
