//! A subsystem of a suspension: hard points, parameters, springs, dampers, stops and bushings.

use super::forces;
use super::orbit::{Cell, Orbit, Row};
use super::template::{self, Template};
use crate::import::draft::{Draft, Point, Spin};
use crate::import::names::our_name;
use crate::import::options::Options;
use crate::import::{ImportError, Imported, Mistakes, Source};
use crate::model::{Architecture, Axes, Axle, Side};

pub(super) fn import(
    source: Source,
    orbit: &Orbit,
    options: &Options,
) -> Result<Imported, ImportError> {
    let header = orbit.block("SUBSYSTEM_HEADER");
    let named = header.and_then(|header| header.text("TEMPLATE_NAME")).unwrap_or_default();
    let named = named.rsplit(['/', '\\']).next().unwrap_or(named);
    let role = header.and_then(|header| header.text("MAJOR_ROLE")).unwrap_or("suspension");
    if !role.eq_ignore_ascii_case("suspension") && options.architecture.is_none() {
        return Err(source.fault(
            format!("this is a subsystem of the major role `{role}`, no suspension"),
            "import the subsystem of the suspension",
        ));
    }
    let template = template::find(named);
    let architecture =
        options.architecture.as_deref().or(template.map(|template| template.architecture));
    let architecture = architecture.or_else(|| template::own_architecture(named));
    let Some(architecture) = architecture else {
        let what = format!(
            "the topology of the template `{named}` is not known: a subsystem does not hold it"
        );
        let help = format!(
            "templates that are known: {}; or name the architecture with --architecture",
            template::names()
        );
        return Err(source.fault(what, help));
    };
    let units = orbit.units()?;
    let stem = source.file_name().rsplit_once('.').map_or(source.file_name(), |(stem, _)| stem);
    let about = format!("Adams/Car, {}, template {named}", source.file_name());
    let mut draft = Draft::new(stem, about, architecture, units);
    draft.template = format!("the template `{named}`");
    draft.axes = options.axes.unwrap_or(Axes::Adams);
    let side = options.side.unwrap_or(Side::Left);
    draft.side = Some(side);
    let role = header.and_then(|header| header.text("MINOR_ROLE")).unwrap_or_default();
    let axles = [Axle::Front, Axle::Rear];
    draft.axle = axles.into_iter().find(|axle| role.eq_ignore_ascii_case(axle.name()));
    points(source, orbit, template, side, &mut draft)?;
    draft.spin = parameters(orbit, side, &mut draft);
    forces::read(source, orbit, template, options, side, &mut draft)?;
    leave_out_the_rest(orbit, &mut draft);
    draft.finish(source.name, source.text, options)
}

/// Whether a row or an element with this symmetry belongs to a side.
pub(super) fn belongs(symmetry: &str, side: Side) -> bool {
    match symmetry.to_ascii_lowercase().as_str() {
        "left" => side == Side::Left,
        "right" => side == Side::Right,
        // `left/right`, `single`.
        _ => true,
    }
}

/// The hard points of one side. `left/right` has the coordinates of the left one.
fn points(
    source: Source,
    orbit: &Orbit,
    template: Option<&Template>,
    side: Side,
    draft: &mut Draft,
) -> Result<(), ImportError> {
    let Some(block) = orbit.block("HARDPOINT") else {
        return Err(
            source.fault("the subsystem has no block [HARDPOINT]", "save it anew from Adams/Car")
        );
    };
    let mut mistakes = Mistakes::new(source.name, source.text);
    let architecture = Architecture::built_in(&draft.architecture).and_then(Result::ok);
    for row in &block.rows {
        let Some((called, symmetry, mut position)) = hardpoint(row) else {
            let help = "a row is 'name' 'left/right' x y z";
            mistakes.note(row.line, "this row is no hard point", help);
            continue;
        };
        if !belongs(symmetry, side) {
            let why = format!("it is of the other side; a model has one, here the {}", side.name());
            draft.leave_out(row.line, format!("the hard point `{called}` ({symmetry})"), why);
            continue;
        }
        if symmetry.eq_ignore_ascii_case("left/right") && side == Side::Right {
            position[1] = 0.0 - position[1];
        }
        let known = template.and_then(|t| t.points.iter().find(|(theirs, _)| *theirs == called));
        let name = known.map_or_else(
            || our_name(called, architecture.as_ref()),
            |(_, ours)| (*ours).to_owned(),
        );
        draft.points.push(Point { name, called: called.to_owned(), line: row.line, position });
    }
    mistakes.finish()
}

fn hardpoint(row: &Row) -> Option<(&str, &str, [f64; 3])> {
    match &row.cells[..] {
        [name, symmetry, Cell::Number(x), Cell::Number(y), Cell::Number(z), ..] => {
            Some((name.text()?, symmetry.text()?, [*x, *y, *z]))
        }
        _ => None,
    }
}

/// The static angles; the other parameters are switches of the template.
fn parameters(orbit: &Orbit, side: Side, draft: &mut Draft) -> Spin {
    let (mut toe, mut camber) = (None, None);
    for row in
        orbit.blocks.iter().filter(|block| block.name == "PARAMETER").flat_map(|block| &block.rows)
    {
        let [name, symmetry, _, value, ..] = &row.cells[..] else {
            draft.leave_out(
                row.line,
                "a row of [PARAMETER]",
                "it has no name, symmetry, type and value",
            );
            continue;
        };
        let (name, symmetry) =
            (name.text().unwrap_or_default(), symmetry.text().unwrap_or_default());
        match (name, value.number()) {
            ("toe_angle", Some(angle)) if belongs(symmetry, side) => toe = Some(angle),
            ("camber_angle", Some(angle)) if belongs(symmetry, side) => camber = Some(angle),
            ("kinematic_flag", Some(flag)) => {
                let why = if flag == 0.0 {
                    "bushings act unless a command has --kinematic"
                } else {
                    "run commands with --kinematic: the subsystem has its bushings switched off"
                };
                draft.leave_out(row.line, format!("the parameter `{name}` = {flag}"), why);
            }
            _ => draft.leave_out(
                row.line,
                format!("the parameter `{name}`"),
                "a model has no place for it",
            ),
        }
    }
    match (toe, camber) {
        (None, None) => Spin::Unknown,
        (toe, camber) => Spin::Angles { toe: toe.unwrap_or(0.0), camber: camber.unwrap_or(0.0) },
    }
}

/// The blocks that nobody has read.
fn leave_out_the_rest(orbit: &Orbit, draft: &mut Draft) {
    const READ: &[&str] = &["MDI_HEADER", "SUBSYSTEM_HEADER", "UNITS", "HARDPOINT", "PARAMETER"];
    for block in &orbit.blocks {
        if forces::is_force(&block.name) {
            // What kind of element it is says its block already.
            block.get("DEFINITION");
            for (key, line) in block.unread() {
                let usage = block.text("USAGE").unwrap_or_default();
                draft.leave_out(
                    line,
                    format!("`{key}` of `{usage}`"),
                    "a model has no place for it",
                );
            }
        }
        if READ.contains(&block.name.as_str()) || forces::is_force(&block.name) {
            continue;
        }
        let usage = block.text("USAGE").map(|usage| format!(" `{usage}`")).unwrap_or_default();
        let why = match block.name.as_str() {
            "PART_ASSEMBLY" | "PART" => "masses of parts are not imported; write [bodies] sections",
            "PLUGINS" => "it is there for Adams/Car alone",
            _ => "a model has no place for it",
        };
        draft.leave_out(block.line, format!("[{}]{usage}", block.name), why);
    }
}
