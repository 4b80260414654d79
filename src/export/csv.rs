//! Points as comma-separated values, with what belongs to them in comments that the importer reads.

use std::fmt::Write as _;

use ::csv::Writer;

use super::{Exported, Suspension};

pub(super) fn write(suspension: &Suspension) -> Exported {
    let mut text = String::new();
    let mut head = |key: &str, value: &str| {
        let value = value.split_whitespace().collect::<Vec<_>>().join(" ");
        if !value.is_empty() {
            // Writing into a text cannot fail.
            let _ = writeln!(text, "# {key} = {value}");
        }
    };
    for key in ["name", "architecture", "axes", "side"] {
        head(key, suspension.text(&[key]));
    }
    for key in ["length", "angle"] {
        head(key, suspension.text(&["units", key]));
    }
    for (key, name) in [("radius", "wheel_radius"), ("toe", "toe"), ("camber", "camber")] {
        let number = suspension.number(&["wheel", key]);
        head(name, &number.map(|number| format!("{number:?}")).unwrap_or_default());
    }
    head("spin_axis_point", suspension.text(&["wheel", "spin_axis_point"]));
    let mut writer = Writer::from_writer(vec![]);
    let header = ["name", "x", "y", "z"].map(str::to_owned);
    let rows = suspension.points().into_iter().map(|(name, [x, y, z])| {
        [name.to_owned(), format!("{x:?}"), format!("{y:?}"), format!("{z:?}")]
    });
    for row in std::iter::once(header).chain(rows) {
        // A text in memory takes every row.
        let _ = writer.write_record(row);
    }
    let table = writer.into_inner().unwrap_or_default();
    text.push_str(&String::from_utf8_lossy(&table));
    Exported { text, left_out: suspension.other_sections(&["points", "units", "wheel"]) }
}
