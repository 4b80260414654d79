//! Springs, dampers and stops: the force elements that Chrono calls TSDA, `f = P − F(l − l0) −
//! D(l̇)`, + pushing.

use crate::import::draft::{Part, PartKind};
use crate::import::json::Json;
use crate::import::sheet::Value;
use crate::import::{LeftOut, Mistakes};

type Entry = (&'static str, Value);

/// The stop of springs with `Minimum Length` and `Maximum Length` (m, N): that of Chrono.
const STOP: [[f64; 2]; 11] = [
    [0.0, 0.0],
    [0.002, 200.0],
    [0.004, 400.0],
    [0.006, 600.0],
    [0.008, 800.0],
    [0.01, 1000.0],
    [0.02, 2500.0],
    [0.03, 4500.0],
    [0.04, 7500.0],
    [0.05, 12500.0],
    [0.06, 125_000.0],
];

/// Speeds (m/s) at which a degressive damper is tabulated, on both sides of zero.
const SPEEDS: [f64; 13] = [0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0, 1.5, 2.0];

const SPLINE: &str =
    "Chrono goes straight from row to row; here a spline goes through the same rows.";

/// The spring or damper of an object between two points, with its damper and its stops. Its ends are as far apart
/// as `length` (m) at the design position.
pub(super) fn tsda(
    object: &Json,
    called: &str,
    bodies: &[String; 2],
    on: [&str; 2],
    length: f64,
    left_out: &mut Vec<LeftOut>,
    mistakes: &mut Mistakes,
) -> Vec<Part> {
    let part = |name: &str, kind, entries, comments| Part {
        name: name.to_owned(),
        line: object.line,
        called: match kind {
            "spring" | "damper" => called.to_owned(),
            _ => format!("{called}, stop"),
        },
        kind: PartKind::Force(kind, bodies.clone()),
        entries: [vec![("on", Value::from(on))], entries].concat(),
        points: on.map(str::to_owned).to_vec(),
        comments,
    };
    let mut comments = vec![];
    let damping = damper_of(object, length, &mut comments, left_out, mistakes);
    let spring = spring_of(object, &mut comments, mistakes);
    let mut parts = match (spring, damping) {
        (Some(mut spring), damping) => {
            // A spring calls its table of damping so that it is not taken for that of the force.
            let key = |key| if key == "table" { "damping_table" } else { key };
            spring.extend(damping.map(|(name, value)| (key(name), value)));
            vec![part("spring", "spring", spring, comments)]
        }
        (None, Some(damping)) => vec![part("damper", "damper", vec![damping], comments)],
        (None, None) => {
            let why = "it has neither a stiffness nor a damping that is known".to_owned();
            left_out.push(LeftOut { line: object.line, what: format!("`{called}`"), why });
            return vec![];
        }
    };
    for (kind, entries) in stops_of(object, length, left_out, mistakes) {
        let comment = "The stop that Chrono gives to springs with such lengths; its table is linear between the rows.";
        parts.push(part(&kind.replace('-', "_"), kind, entries, vec![comment.to_owned()]));
    }
    parts
}

/// A spring about an axis, `M = P − k (θ − θ0) − c θ̇` on the second body, as that of the mechanism; `None` after a
/// mistake.
pub(super) fn rotational(object: &Json, mistakes: &mut Mistakes) -> Option<Vec<Entry>> {
    let mut number = |key: &str| object.number(key, mistakes).unwrap_or(0.0);
    let [preload, free] = ["Preload", "Free Angle"].map(&mut number);
    let [stiffness, damping] =
        ["Spring Coefficient", "Damping Coefficient"].map(|key| object.number(key, mistakes));
    let Some(stiffness) = stiffness else {
        let what = "the importer knows springs about axes by their `Spring Coefficient` only";
        mistakes.note(object.line, what, "add it");
        return None;
    };
    let mut entries = vec![("stiffness", Value::from(stiffness))];
    let moment = preload + stiffness * free;
    entries.extend((moment != 0.0).then(|| ("preload", Value::from(moment))));
    entries.extend(damping.map(|damping| ("damping", Value::from(damping))));
    Some(entries)
}

/// Stiffness and free length of a spring, `None` where the object is none.
fn spring_of(
    object: &Json,
    comments: &mut Vec<String>,
    mistakes: &mut Mistakes,
) -> Option<Vec<Entry>> {
    let linear = object.number("Spring Coefficient", mistakes);
    let curve = object.table("Spring Curve Data", 2, mistakes);
    if linear.is_none() && curve.is_none() {
        return None;
    }
    let preload = object.number("Preload", mistakes).unwrap_or(0.0);
    let Some(free) = object.number("Free Length", mistakes) else {
        mistakes.note(object.line, "the spring has no `Free Length`", "add it");
        return None;
    };
    if let Some(rows) = curve {
        comments.push(SPLINE.to_owned());
        // Compression is minus the deformation, and the force pushes.
        let rows = rows.iter().rev().map(|row| [0.0 - row[0], preload - row[1]]).collect();
        return Some(vec![("table", Value::Rows(rows)), ("free_length", Value::from(free))]);
    }
    let stiffness = linear?;
    if preload != 0.0 {
        comments.push(format!(
            "The free length is {free:?} m with a preload of {preload:?} N in the source."
        ));
    }
    let free = if preload == 0.0 { free } else { free + preload / stiffness };
    Some(vec![("stiffness", Value::from(stiffness)), ("free_length", Value::from(free))])
}

/// The damping of a damper, as a number or a table over the speed, + in extension.
fn damper_of(
    object: &Json,
    length: f64,
    comments: &mut Vec<String>,
    left_out: &mut Vec<LeftOut>,
    mistakes: &mut Mistakes,
) -> Option<Entry> {
    if object.has("Map Data") {
        return map_of(object, length, comments, left_out, mistakes);
    }
    if let Some(rows) = object.table("Damping Curve Data", 2, mistakes) {
        comments.push(SPLINE.to_owned());
        return Some(("table", Value::Rows(rows.iter().map(|row| [row[0], row[1]]).collect())));
    }
    let damping = object.number("Damping Coefficient", mistakes)?;
    let degression = ["Degressivity Compression", "Degressivity Expansion"];
    let [compression, expansion] = degression.map(|key| object.number(key, mistakes));
    let (Some(compression), Some(expansion)) = (compression, expansion) else {
        return Some(("damping", Value::from(damping)));
    };
    comments.push(format!(
        "Degressive: {damping:?} v / (1 + d |v|) with d = {compression:?} s/m in compression and {expansion:?} s/m in extension, \
         tabulated."
    ));
    let force = |speed: f64, degression: f64| damping * speed / (1.0 + degression * speed.abs());
    let below = SPEEDS.iter().rev().map(|speed| [-speed, force(-speed, compression)]);
    let above = SPEEDS.iter().map(|speed| [*speed, force(*speed, expansion)]);
    let rows = below.chain([[0.0, 0.0]]).chain(above);
    Some(("table", Value::Rows(rows.collect())))
}

/// A damper whose force depends on length and speed: its forces at the length of the design position.
fn map_of(
    object: &Json,
    length: f64,
    comments: &mut Vec<String>,
    left_out: &mut Vec<LeftOut>,
    mistakes: &mut Mistakes,
) -> Option<Entry> {
    let lengths = object.get("Deformation").and_then(|lengths| lengths.take().numbers());
    let place = object.get("Map Data")?.line;
    let Some(lengths) = lengths.filter(|lengths| lengths.len() >= 2) else {
        mistakes.note(place, "`Map Data` has no list `Deformation` with its columns", "add it");
        return None;
    };
    if !lengths.windows(2).all(|pair| pair[0] < pair[1]) {
        mistakes.note(
            place,
            "`Deformation` does not increase",
            "sort it, with the columns of the map",
        );
        return None;
    }
    let map = object.table("Map Data", lengths.len() + 1, mistakes)?;
    let upper = lengths.partition_point(|column| *column < length).clamp(1, lengths.len() - 1);
    let share = (length - lengths[upper - 1]) / (lengths[upper] - lengths[upper - 1]);
    let at_length = |row: &Vec<f64>| [row[0], row[upper] + share * (row[upper + 1] - row[upper])];
    let rows: Vec<[f64; 2]> = map.iter().map(at_length).collect();
    comments.push(format!(
        "The forces of the map at {length:.6} m, the length at the design position. {SPLINE}"
    ));
    left_out.push(LeftOut {
        line: place,
        what: "how the force of `Map Data` depends on the length".to_owned(),
        why: format!("a damper depends on its speed alone; its table is that of {length:.6} m"),
    });
    Some(("table", Value::Rows(rows)))
}

/// The stops at the minimum and maximum length.
fn stops_of(
    object: &Json,
    length: f64,
    left_out: &mut Vec<LeftOut>,
    mistakes: &mut Mistakes,
) -> Vec<(&'static str, Vec<Entry>)> {
    let least = object.number("Minimum Length", mistakes);
    let most = object.number("Maximum Length", mistakes);
    let (Some(least), Some(most)) = (least, most) else { return vec![] };
    if least >= most {
        left_out.push(LeftOut {
            line: object.line,
            what: "`Minimum Length` and `Maximum Length`".to_owned(),
            why: "the minimum is not below the maximum; correct the source, if stops are wanted"
                .to_owned(),
        });
        return vec![];
    }
    let stop = |clearance: f64| {
        vec![("clearance", Value::from(clearance)), ("table", Value::Rows(STOP.to_vec()))]
    };
    vec![("bump-stop", stop(length - least)), ("rebound-stop", stop(most - length))]
}
