//! The list beside the views: points, bodies, signs and the scale.

use std::fmt::Write as _;

use super::draw::{LINK, REFERENCE, STRUT, draw_mark};
use super::escaped;
use super::figure::{Figure, MarkKind};
use super::label::CHARACTER;
use crate::model::{Model, Units};

/// Height of a line, and width of the column of numbers and signs (pixels).
const LINE: f64 = 15.0;
const COLUMN: f64 = 26.0;

/// Rows of the list on their way to the sheet.
struct Rows<'s> {
    at: [f64; 2],
    /// The right end of the longest.
    wide: f64,
    svg: &'s mut String,
}

impl Rows<'_> {
    /// A row of a sign and words; the sign is told where its middle is.
    fn add(&mut self, words: &str, sign: impl FnOnce([f64; 2], &mut String)) {
        let [x, y] = self.at;
        sign([x + COLUMN / 2.0 - 4.0, y - 4.0], self.svg);
        let text = escaped(words);
        let _ = writeln!(self.svg, "<text x=\"{:.1}\" y=\"{y:.1}\">{text}</text>", x + COLUMN);
        #[allow(clippy::cast_precision_loss)] // A row is some words.
        let end = x + COLUMN + words.chars().count() as f64 * CHARACTER;
        self.wide = self.wide.max(end);
        self.at[1] += LINE;
    }

    /// A row with a straight piece of a line as its sign.
    fn add_line(&mut self, words: &str, style: &str) {
        self.add(words, |[x, y], svg| {
            let [from, to] = [x - 9.0, x + 9.0];
            let _ = writeln!(
                svg,
                "<path d=\"M{from:.1} {y:.1}L{to:.1} {y:.1}\" fill=\"none\" {style}/>"
            );
        });
    }
}

impl Figure {
    /// Draws the list from its upper left corner on; gives the right and the lower end.
    pub(super) fn draw_legend(
        &self,
        model: &Model,
        [x, y]: [f64; 2],
        scale: f64,
        svg: &mut String,
    ) -> [f64; 2] {
        let mut rows = Rows { at: [x, y], wide: x, svg };
        let architecture = &model.architecture;
        let roles = || architecture.points().iter().chain(architecture.optional_points());
        for (number, point) in model.points().iter().enumerate() {
            let role = roles().find(|role| role.name == point.name);
            let meaning = role.map_or(String::new(), |role| format!(": {}", role.meaning));
            rows.add(&format!("{}{meaning}", point.name), |[x, y], svg| {
                let (x, number) = (x + 6.0, number + 1);
                let y = y + 4.0;
                let _ = writeln!(
                    svg,
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"end\">{number}</text>"
                );
            });
        }
        rows.at[1] += LINE / 2.0;
        for (name, colour, meaning) in &self.names {
            let meaning = if meaning.is_empty() { String::new() } else { format!(": {meaning}") };
            rows.add_line(
                &format!("{name}{meaning}"),
                &format!("stroke=\"{colour}\" stroke-width=\"3\""),
            );
        }
        rows.at[1] += LINE / 2.0;
        self.add_signs(&mut rows);
        add_scale(&mut rows, model.units, scale);
        [rows.wide, rows.at[1]]
    }

    fn add_signs(&self, rows: &mut Rows) {
        for (kind, words) in [
            (MarkKind::Chassis, "on the chassis"),
            (MarkKind::Body, "on bodies"),
            (MarkKind::Free, "on no joint"),
        ] {
            if self.marks.iter().any(|mark| mark.kind == kind) {
                rows.add(words, |middle, svg| draw_mark(middle, kind, svg));
            }
        }
        if !self.links.is_empty() {
            rows.add_line("rigid link", LINK);
        }
        if !self.struts.is_empty() {
            rows.add_line("spring or damper", STRUT);
        }
        rows.add_line("ground, middle of the vehicle", REFERENCE);
    }
}

/// A bar of 1, 2 or 5 times a power of ten in the model's unit, some 60 to 150 pixels long.
fn add_scale(rows: &mut Rows, units: Units, scale: f64) {
    let pixels = |length: f64| units.length.to_metres(length) * scale;
    let mut length = 1e-6;
    'found: loop {
        for step in [1.0, 2.0, 5.0] {
            if pixels(step * length) >= 60.0 {
                length *= step;
                break 'found;
            }
        }
        length *= 10.0;
    }
    // Powers of ten by multiplication are off in the last digits.
    let length = (length * 1e6).round() / 1e6;
    let [x, y] = [rows.at[0], rows.at[1] + LINE];
    let end = x + pixels(length);
    let _ = writeln!(
        rows.svg,
        "<path d=\"M{x:.1} {:.1}v8M{x:.1} {y:.1}H{end:.1}M{end:.1} {:.1}v8\" fill=\"none\" \
         stroke=\"black\"/>\n<text x=\"{:.1}\" y=\"{:.1}\">{length} {}</text>",
        y - 4.0,
        y - 4.0,
        end + 6.0,
        y + 4.0,
        units.length.symbol()
    );
    rows.at[1] += 2.0 * LINE;
}
