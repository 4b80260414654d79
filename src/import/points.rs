//! From a list of named points to a suspension: what tables of points have in common.

use super::draft::{Draft, MOST_POINTS, Point, Spin};
use super::names::{axle_prefix, meant, our_name};
use super::options::Options;
use super::{ImportError, Imported, Source};
use crate::model::{AngleUnit, Architecture, Axes, Axle, LengthUnit, Side, Units};

/// A point as a table has it.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) line: usize,
    pub(super) called: String,
    pub(super) position: [f64; 3],
}

/// What a table says beside its points.
#[derive(Debug, Default)]
pub(super) struct Head {
    pub(super) name: Option<String>,
    pub(super) architecture: Option<String>,
    pub(super) length: Option<LengthUnit>,
    /// That of toe and camber, degrees where nothing is said.
    pub(super) angle: Option<AngleUnit>,
    pub(super) axes: Option<Axes>,
    pub(super) side: Option<Side>,
    pub(super) radius: Option<f64>,
    pub(super) toe: Option<f64>,
    pub(super) camber: Option<f64>,
    pub(super) spin_axis_point: Option<String>,
    /// What the file is, for `source`.
    pub(super) format: &'static str,
}

/// Makes a suspension of named points.
pub(super) fn suspension(
    source: Source,
    head: &Head,
    rows: Vec<Row>,
    options: &Options,
) -> Result<Imported, ImportError> {
    if rows.len() > MOST_POINTS {
        let what = format!("the file has {} points, more than any suspension", rows.len());
        return Err(source.fault(what, "check that it is the right one"));
    }
    let word = options.architecture.as_ref().or(head.architecture.as_ref());
    let missing = |what: &str, how: &str| {
        source.fault(format!("the file does not say {what}"), format!("add {how}"))
    };
    let Some(word) = word.cloned() else {
        let known = Architecture::built_in_names().join(", ");
        return Err(missing(
            "which architecture its points belong to",
            &format!(
                "--architecture, such as --architecture double-wishbone; built in are {known}"
            ),
        ));
    };
    let length = options
        .length
        .or(head.length)
        .ok_or_else(|| missing("its unit of length", "--length mm, or a line `# length = mm`"))?;
    let axes = options.axes.or(head.axes).ok_or_else(|| {
        missing(
            "its axes",
            "--axes: iso8855 is x forward, y left, z up; adams is x rearward, y right, z up; sae is x \
             forward, y right, z down",
        )
    })?;
    let angle = head.angle.unwrap_or(AngleUnit::Degree);
    let units = Units { length, angle, ..super::draft::MMKS };
    let title = head.name.clone().unwrap_or_else(|| stem(source.file_name()));
    let about = format!("{}, {}", source.file_name(), head.format);
    let mut draft = Draft::new(&title, about, &word, units);
    draft.axes = axes;
    draft.side = options.side.or(head.side);
    draft.wheel_radius = head.radius;
    let built_in = Architecture::built_in(&word).and_then(Result::ok);
    let rows = one_axle(source, rows, options, &mut draft)?;
    take(source, rows, built_in.as_ref(), &mut draft);
    draft.spin = spin(head, &draft);
    draft.finish(source.name, source.text, options)
}

fn stem(file: &str) -> String {
    file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned()
}

/// The rows of one axle, where names start with `F_` and `R_`.
fn one_axle(
    source: Source,
    rows: Vec<Row>,
    options: &Options,
    draft: &mut Draft,
) -> Result<Vec<Row>, ImportError> {
    let has = |wanted| {
        let prefixed =
            rows.iter().filter(|row| axle_prefix(&row.called).is_some_and(|(p, _)| p == wanted));
        prefixed.count()
    };
    let (front, rear) = (has('f'), has('r'));
    // A lone `R_…` may be the right-hand side of something.
    if front == 0 && rear < 3 {
        return Ok(rows);
    }
    let wanted = match options.axle {
        Some(Axle::Front) => 'f',
        Some(Axle::Rear) => 'r',
        None if rear == 0 => 'f',
        None if front == 0 => 'r',
        None => {
            return Err(source.fault(
                "the file has points of two axles, `F_…` and `R_…`",
                "choose one: --axle front or --axle rear",
            ));
        }
    };
    let mut kept = vec![];
    for mut row in rows {
        match axle_prefix(&row.called) {
            Some((prefix, rest)) if prefix == wanted => {
                row.called = rest.to_owned();
                kept.push(row);
            }
            Some(_) => draft.leave_out(
                row.line,
                format!("the point `{}`", row.called),
                "it belongs to the other axle; import that one with --axle",
            ),
            None => kept.push(row),
        }
    }
    Ok(kept)
}

/// Gives the points our names; the mirror images that some tables have are left out.
fn take(source: Source, rows: Vec<Row>, architecture: Option<&Architecture>, draft: &mut Draft) {
    let names: Vec<String> = rows.iter().map(|row| our_name(&row.called, architecture)).collect();
    for (row, name) in rows.into_iter().zip(&names) {
        let base = row.called.strip_suffix("_M").or_else(|| row.called.strip_suffix("_R"));
        let twin = base.map(|base| our_name(base, architecture));
        if let Some(twin) = twin.filter(|twin| names.contains(twin)) {
            let why = format!("the mirror image of `{twin}`; a model has one side");
            draft.leave_out(row.line, format!("the point `{}`", row.called), why);
            continue;
        }
        let known = architecture.is_none_or(|architecture| {
            let mut roles = architecture.points().iter().chain(architecture.optional_points());
            roles.any(|role| role.name == *name)
        });
        let likely = architecture.filter(|_| !known).and_then(|a| meant(name, a, &names));
        if let Some(likely) = likely {
            let why = format!(
                "no such point; did you mean `{likely}`? Then change its name in {}",
                source.file_name()
            );
            draft.leave_out(row.line, format!("the point `{}`", row.called), why);
            continue;
        }
        draft.points.push(Point {
            name: name.clone(),
            called: row.called,
            line: row.line,
            position: row.position,
        });
    }
}

/// The spin axis: by the angles or the point that the head names, or else by a second point on it.
fn spin(head: &Head, draft: &Draft) -> Spin {
    let named = head.spin_axis_point.clone().filter(|name| draft.position(name).is_some());
    if let Some(name) = named {
        return Spin::Point(name);
    }
    if let (Some(toe), Some(camber)) = (head.toe, head.camber) {
        return Spin::Angles { toe, camber };
    }
    match draft.position("wheel_spindle") {
        Some(_) => Spin::Point("wheel_spindle".to_owned()),
        None => Spin::Unknown,
    }
}
