//! Three views, and where they stand on the sheet.

use std::fmt::Write as _;

use crate::model::{Axes, Side};

/// From where one looks.
#[derive(Clone, Copy)]
pub(super) enum View {
    Front,
    Side(Side),
    Top,
}

impl View {
    /// To the right and upward on the sheet (m).
    pub(super) fn project(self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        match self {
            Self::Front => [y, z],
            Self::Side(side) => [-side.sign() * x, z],
            Self::Top => [y, -x],
        }
    }

    pub(super) fn title(self) -> &'static str {
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
pub(super) struct Bounds {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl Bounds {
    pub(super) fn around(places: impl Iterator<Item = [f64; 2]>) -> Self {
        let mut bounds = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        for place in places {
            for axis in 0..2 {
                bounds.low[axis] = bounds.low[axis].min(place[axis]);
                bounds.high[axis] = bounds.high[axis].max(place[axis]);
            }
        }
        bounds
    }

    pub(super) fn width(self) -> f64 {
        self.high[0] - self.low[0]
    }

    pub(super) fn height(self) -> f64 {
        self.high[1] - self.low[1]
    }
}

/// Where a view stands on the sheet: its upper left corner in pixels, and pixels per metre.
pub(super) struct Frame {
    pub(super) view: View,
    pub(super) bounds: Bounds,
    pub(super) scale: f64,
    pub(super) place: [f64; 2],
}

impl Frame {
    pub(super) fn on_sheet(&self, place: [f64; 3]) -> [f64; 2] {
        let [u, v] = self.view.project(place);
        let [left, top] = [u - self.bounds.low[0], self.bounds.high[1] - v];
        [self.place[0] + left * self.scale, self.place[1] + top * self.scale]
    }

    /// The upper left and the lower right corner on the sheet.
    pub(super) fn corners(&self) -> [[f64; 2]; 2] {
        let [x, y] = self.place;
        [[x, y], [x + self.bounds.width() * self.scale, y + self.bounds.height() * self.scale]]
    }

    /// Arrows along the model's own axes, below the view.
    pub(super) fn draw_axes(&self, axes: Axes, svg: &mut String) {
        const LENGTH: f64 = 20.0;
        let [[left, _], [_, bottom]] = self.corners();
        let arrows = ["x", "y", "z"].into_iter().enumerate().filter_map(|(axis, name)| {
            let mut along = [0.0; 3];
            along[axis] = 1.0;
            let [u, v] = self.view.project(axes.to_iso(along));
            (u != 0.0 || v != 0.0).then_some((name, [u * LENGTH, -v * LENGTH]))
        });
        let arrows: Vec<_> = arrows.collect();
        // The cross stands in a square of its own whichever way its arrows go.
        let least = |k: usize| arrows.iter().fold(0.0_f64, |least, (_, way)| least.min(way[k]));
        let origin = [left + 6.0 - least(0), bottom + 22.0 - least(1)];
        for (name, way) in arrows {
            let [x, y] = [origin[0] + way[0], origin[1] + way[1]];
            let [ahead, aside] = [way.map(|w| w / LENGTH), [-way[1] / LENGTH, way[0] / LENGTH]];
            let barb = |side: f64| {
                [x - 5.0 * ahead[0] + side * aside[0], y - 5.0 * ahead[1] + side * aside[1]]
            };
            let [[ax, ay], [bx, by]] = [barb(2.5), barb(-2.5)];
            let _ = writeln!(
                svg,
                "<path d=\"M{:.1} {:.1}L{x:.1} {y:.1}M{ax:.1} {ay:.1}L{x:.1} {y:.1}L{bx:.1} {by:.1}\" \
                 fill=\"none\" stroke=\"#555555\"/>\n\
                 <text x=\"{:.1}\" y=\"{:.1}\" fill=\"#555555\" text-anchor=\"middle\">{name}</text>",
                origin[0],
                origin[1],
                x + 7.0 * ahead[0],
                y + 7.0 * ahead[1] + 3.5,
            );
        }
    }
}
