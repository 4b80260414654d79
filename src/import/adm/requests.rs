//! REQUEST: which markers are followed.

use std::collections::BTreeSet;

use super::dataset::Dataset;
use super::frame::Frame;
use super::notes::Notes;
use super::output::{List, Output, direction, quoted};
use super::statement::Statement;

pub(super) const KEYS: &[&str] = &[
    "ACCELERATION",
    "COMMENT",
    "DISPLACEMENT",
    "F1",
    "F2",
    "F3",
    "F4",
    "F5",
    "F6",
    "F7",
    "F8",
    "F",
    "FORCE",
    "FUNCTION",
    "I",
    "J",
    "RM",
    "TITLE",
    "VELOCITY",
];

/// Follows the markers whose displacement, velocity or acceleration is asked for.
pub(super) fn follow(
    dataset: &Dataset,
    requests: &[&Statement],
    output: &mut Output,
    notes: &mut Notes,
) {
    let (mut followed, mut others) = (BTreeSet::new(), vec![]);
    for request in requests {
        for key in ["COMMENT", "TITLE", "J", "RM"] {
            request.has(key);
        }
        let motion = request.word(&["DISPLACEMENT", "VELOCITY", "ACCELERATION"]).is_some();
        let marker = request.reference("I", notes).and_then(|id| dataset.markers.get(&id));
        let Some(marker) = marker.filter(|_| motion) else {
            for key in KEYS {
                request.has(key);
            }
            others.push(request.line);
            continue;
        };
        if dataset.body(marker).ground {
            notes.left_out(request.line, request.title(), "its marker is on the ground");
            continue;
        }
        let seen_from = |key: &str, notes: &mut Notes| {
            let id = request.reference(key, notes)?;
            let frame = dataset.markers.get(&id)?;
            let still = dataset.body(frame).ground && frame.frame == Frame::GROUND;
            (!still).then_some(id)
        };
        let from = seen_from("J", notes).or_else(|| seen_from("RM", notes));
        if let Some(from) = from {
            let what = format!("{} relative to MARKER/{from}", request.title());
            let why = "the columns of its marker are in the axes of the ground";
            notes.left_out(request.line, what, why);
        }
        if !followed.insert(marker.id) {
            continue;
        }
        let [x, _, z] = marker.frame.axes;
        let lines = [
            ("body", quoted(&dataset.body(marker).name)),
            ("at", output.point(marker)),
            ("x_axis", direction(x)),
            ("z_axis", direction(z)),
        ];
        output.section(List::Markers, request, &marker.name, &lines);
    }
    let why = "a mechanism file follows markers, and `hardpoint settle --reactions` writes what joints carry";
    notes.left_out_together("REQUEST", &others, why);
}
