//! GCON: constraints that an expression states.

use super::dataset::{Dataset, Marker, NEAR};
use super::expression::Measure;
use super::frame::Frame;
use super::law::Probe;
use super::notes::Notes;
use super::output::{List, Output, direction};
use super::pair::{Pair, not_assembled};
use super::parse::parse;
use super::statement::Statement;
use crate::vector::{Vector, add, scale};

pub(super) const KEYS: &[&str] = &["FUNCTION", "I"];

/// Translates one GCON. An expression of one measure that is zero holds the measure where it is, which
/// is one of the joints of hardpoint.
pub(super) fn general(
    dataset: &Dataset,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    // The marker at which Adams tells the reaction.
    statement.has("I");
    let Some((line, text)) = statement.text("FUNCTION") else {
        let what = format!("{} has no FUNCTION", statement.title());
        notes.mistake(statement.line, what, "write FUNCTION = …");
        return;
    };
    let held = parse(text).and_then(|expression| {
        let measures = expression.measures(dataset)?;
        let [measure] = &measures[..] else {
            return Err(match measures.len() {
                0 => "it measures nothing".to_owned(),
                _ => "hardpoint has constraints of one measure only".to_owned(),
            });
        };
        let design = dataset.design(measure)?;
        let length = measure.name.starts_with('D');
        let unit = if length { dataset.size } else { 1.0 };
        let value = |at: f64| {
            let values = vec![(measure.clone(), at)];
            expression.value(&Probe { dataset, values, time: None })
        };
        let step = 1e-6 * unit;
        let slope = (value(design + step)? - value(design - step)?) / (2.0 * step);
        if slope == 0.0 {
            return Err("it does not change with what it measures".into());
        }
        Ok((measure.clone(), (value(design)? / slope).abs() / unit))
    });
    let (measure, offset) = match held {
        Ok(held) => held,
        Err(why) => return notes.missing(line, format!("{}: {text}", statement.title()), why),
    };
    if offset.is_nan() || offset > NEAR {
        let what = format!("the FUNCTION of {} is not zero where the parts are", statement.title());
        return not_assembled(line, what, notes);
    }
    let [i, j] = [0, 1].map(|place| place_of(dataset, &measure, place));
    let (Some(i), Some(j)) = (i, j) else {
        let what = format!("{} names a marker that does not exist", statement.title());
        return notes.mistake(line, what, "correct the number of the marker");
    };
    let Some(pair) = Pair::new(dataset, &i, &j, statement, notes) else { return };
    let name = output.name(List::Joints, statement, "gcon");
    match joint(&pair, &measure, output) {
        Ok(lines) => output.section(List::Joints, statement, &name, &lines),
        Err(why) => notes.missing(line, format!("{}: {text}", statement.title()), why),
    }
}

/// The marker of a measure; the origin of the ground where it has none.
fn place_of(dataset: &Dataset, measure: &Measure, place: usize) -> Option<Marker> {
    match measure.markers.get(place) {
        Some(id) if *id != 0 => dataset.markers.get(id).cloned(),
        _ => Some(Marker {
            id: 0,
            name: "origin".into(),
            part: dataset.ground?,
            frame: Frame::GROUND,
            floating: false,
        }),
    }
}

type Lines = Vec<(&'static str, String)>;

/// The joint that holds a measure of two markers at its value in the design position.
fn joint(pair: &Pair, measure: &Measure, output: &mut Output) -> Result<Lines, String> {
    let dataset = pair.dataset;
    let axis = match measure.name.as_bytes().last() {
        Some(b'X') => 0,
        Some(b'Y') => 1,
        _ => 2,
    };
    let kind = |kind: &str| ("kind", format!("\"{kind}\""));
    match measure.name.as_str() {
        "DM" if pair.distance() <= NEAR * dataset.size => {
            Err("its length is zero: write a JPRIM ATPOINT".into())
        }
        "DM" => Ok(vec![kind("link"), pair.i_to_j(), pair.on(output)]),
        "DX" | "DY" | "DZ" => {
            let normal = ("normal", direction(dataset.frame_of(measure, 2)?.axes[axis]));
            // The plane belongs to the body whose axes it has.
            let plane_in = dataset.part_of(measure, 2);
            if plane_in == Some(pair.j.part) {
                let at = ("at", output.point(pair.i));
                Ok(vec![kind("in-plane"), pair.j_to_i(), at, normal])
            } else if plane_in == Some(pair.i.part) {
                let at = ("at", output.point(pair.j));
                Ok(vec![kind("in-plane"), pair.i_to_j(), at, normal])
            } else {
                Err("the axes of the displacement belong to neither of its two parts".into())
            }
        }
        "AX" | "AY" | "AZ" => {
            let angle = dataset.design(measure)?;
            let [x_i, _, z_i] = pair.i.frame.axes;
            let [x_j, y_j, z_j] = pair.j.frame.axes;
            let (sine, cosine) = angle.sin_cos();
            let turned = |u: Vector<f64>, v: Vector<f64>, sine: f64| {
                direction(add(scale(cosine, u), scale(sine, v)))
            };
            // The angle is that at which these two are normal to each other.
            let (axis_i, axis_j) = match axis {
                0 => (z_i, turned(y_j, z_j, sine)),
                1 => (z_i, turned(x_j, z_j, -sine)),
                _ => (x_i, turned(y_j, x_j, -sine)),
            };
            let at = ("at", output.point(pair.i));
            let axes = [("axis_i", axis_j), ("axis_j", direction(axis_i))];
            Ok([&[kind("perpendicular-axes"), pair.j_to_i(), at][..], &axes].concat())
        }
        name => Err(format!("{name} is a velocity, which no joint of hardpoint holds")),
    }
}
