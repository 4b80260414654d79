//! Adams/Solver datasets (`.adm`), made into mechanism files.
//!
//! | file | what |
//! |---|---|
//! | `lines`, `statement` | the text as statements with keys and values |
//! | `parse`, `expression`, `functions` | function expressions |
//! | `spline` | tables of SPLINE statements |
//! | `frame` | places and axes |
//! | `scales` | units |
//! | `dataset`, `names`, `mass` | parts, markers, variables and splines by their numbers |
//! | `pair` | the two markers of a joint or a force |
//! | `joints`, `constraints`, `motions` | JOINT and JPRIM, GCON, MOTION |
//! | `law`, `forces` | what a force is a function of, and the force elements |
//! | `requests` | what is followed |
//! | `output` | the text of the mechanism file |
//! | `notes` | mistakes and what is left out |

mod constraints;
mod dataset;
mod expression;
mod forces;
mod frame;
mod functions;
mod joints;
mod law;
mod lines;
mod mass;
mod motions;
mod names;
mod notes;
mod output;
mod pair;
mod parse;
mod requests;
mod scales;
mod spline;
mod statement;

use std::collections::{BTreeMap, HashSet};

use self::dataset::Dataset;
use self::notes::Notes;
use self::output::{List, Output};
use self::statement::Statement;
use super::{ImportError, Imported};
use crate::model::Document;
use crate::vector::Vector;

/// Statements without which the mechanism is another one, and why hardpoint does not have them.
const MISSING: &[(&str, &str)] = &[
    ("BEAM", "hardpoint has no beams"),
    ("CONTACT", "hardpoint has no contacts"),
    ("COUPLER", "hardpoint has no couplers of joints"),
    ("CVCV", "hardpoint has no joints of curves"),
    ("DIFF", "hardpoint has no differential equations of users"),
    ("FIELD", "hardpoint has no fields; a BUSHING has no coupling between its components"),
    ("FLEX_BODY", "hardpoint has rigid bodies only"),
    ("FRICTION", "hardpoint has no friction in joints"),
    ("GEAR", "hardpoint has no gears"),
    ("GSE", "hardpoint has no state equations of users"),
    ("LSE", "hardpoint has no state equations of users"),
    ("MFORCE", "hardpoint has rigid bodies only"),
    ("NFORCE", "hardpoint has no forces of many components"),
    ("POINT_MASS", "a body has an orientation in hardpoint: make it a PART"),
    ("PTCV", "hardpoint has no joints of curves"),
    ("TFSISO", "hardpoint has no transfer functions"),
    ("TIRE", "hardpoint has vertical tyres only, which have no statement in a dataset"),
    ("UCON", "it calls a subroutine"),
];

/// Statements that are no part of a mechanism.
const OUTSIDE: &[(&str, &str)] = &[
    ("GRAPHICS", "it is a drawing"),
    ("CURVE", "a curve that nothing runs on has no effect"),
    ("SURFACE", "a surface that nothing touches has no effect"),
    ("VARIABLE", "its expression stands where a force uses it, and nowhere else"),
    ("SPLINE", "its rows are in the tables of the forces that use it, and nowhere else"),
    ("SENSOR", "`hardpoint settle` goes on to the end"),
];

/// Makes a mechanism file of a dataset. `name` is the path that messages show.
///
/// With `lenient`, what changes the mechanism and is not known is left out as well and listed, instead of being a
/// mistake.
///
/// # Errors
/// [`ImportError`] with every mistake and everything that is not known, with its line.
pub fn import(name: &str, text: &str, lenient: bool) -> Result<Imported, ImportError> {
    let mut notes = Notes::new(name, text, lenient);
    let (title, mut statements) = lines::statements(text, &mut notes);
    let dataset = Dataset::read(title, &mut statements, &mut notes);
    check_parts(&dataset, &mut notes);
    let mut output = Output::new(&dataset);
    let gravity = translate(&dataset, &mut statements, &mut output, &mut notes);
    if notes.any_mistakes() {
        notes.finish()?;
        return Ok(Imported::default());
    }
    if output.is_empty(List::Joints) && output.is_empty(List::Forces) {
        notes.assume("nothing holds the parts: the dataset has neither joints nor forces");
    }
    let file = std::path::Path::new(name).file_name().map(|file| file.to_string_lossy());
    let text = output.finish(&file.unwrap_or_default(), gravity);
    // The last word on masses and axes is that of whoever reads the file.
    Document::parse(&format!("{name} as a mechanism file"), &text)?;
    let (left_out, assumed) = notes.finish()?;
    Ok(Imported { text, left_out, assumed })
}

/// Notes parts without a ground and masses without a place.
fn check_parts(dataset: &Dataset, notes: &mut Notes) {
    if dataset.ground.is_none() {
        notes.mistake(1, "no PART is the GROUND", "write PART/1, GROUND");
    }
    if dataset.parts.values().all(|part| part.ground) {
        notes.mistake(
            1,
            "the dataset has no moving PART",
            "there is nothing to compute without one",
        );
    }
    for part in dataset.parts.values().filter(|part| !part.ground) {
        let Some(mass) = part.mass else {
            if (part.velocity.0, part.rotation.0) != ([0.0; 3], [0.0; 3]) {
                let what = format!("the initial velocity of the PART {}", part.name);
                notes.left_out(part.line, what, "a part without mass moves as the others let it");
            }
            continue;
        };
        let wrong = dataset.mass_of(part, mass).err();
        let motion = dataset
            .motion_of(part)
            .is_none()
            .then(|| "names a VM or WM that does not exist".to_owned());
        for what in wrong.into_iter().chain(motion) {
            let what = format!("the PART {} {what}", part.name);
            notes.mistake(part.line, what, "correct the number of the marker");
        }
    }
}

/// Translates all statements that are neither parts nor markers; returns gravity (m/s²).
fn translate(
    dataset: &Dataset,
    statements: &mut [Statement],
    output: &mut Output,
    notes: &mut Notes,
) -> Vector<f64> {
    for statement in &mut *statements {
        let keys = keys(&statement.keyword);
        statement.know(keys);
    }
    let statements = &*statements;
    check_numbers(statements, notes);
    let joints = statements.iter().filter(|statement| statement.keyword == "JOINT");
    let joints = joints.filter_map(|joint| Some((joint.id?, joint))).collect();
    let mut gravity = [0.0; 3];
    // Statements without an effect are told once for each kind.
    let mut outside: BTreeMap<&str, (Vec<usize>, &str)> = BTreeMap::new();
    for statement in statements {
        match statement.keyword.as_str() {
            "PART" | "MARKER" | "UNITS" | "END" | "REQUEST" => {}
            "ACCGRAV" => gravity = read_gravity(dataset, statement, notes),
            "JOINT" => joints::joint(dataset, statement, output, notes),
            "JPRIM" => joints::primitive(dataset, statement, output, notes),
            "GCON" => constraints::general(dataset, statement, output, notes),
            "MOTION" => motions::motion(dataset, statement, &joints, output, notes),
            "SFORCE" => forces::single(dataset, statement, output, notes),
            "SPRINGDAMPER" => forces::spring_damper(dataset, statement, output, notes),
            "BUSHING" => forces::bushing(dataset, statement, output, notes),
            "VFORCE" | "VTORQUE" | "GFORCE" => {
                forces::components(dataset, statement, output, notes);
            }
            keyword => {
                if let Some((_, why)) = MISSING.iter().find(|(missing, _)| *missing == keyword) {
                    notes.missing(statement.line, statement.title(), *why);
                } else if statement::KEYWORDS.contains(&keyword) {
                    let why = OUTSIDE.iter().find(|(outside, _)| *outside == keyword);
                    let why = why.map_or("it is a setting of Adams", |(_, why)| why);
                    outside.entry(keyword).or_insert((vec![], why)).0.push(statement.line);
                } else {
                    let why = "hardpoint knows no such statement, or its keyword is cut too short";
                    notes.missing(statement.line, statement::shortened(&statement.title()), why);
                }
                continue;
            }
        }
    }
    let requests: Vec<&Statement> =
        statements.iter().filter(|statement| statement.keyword == "REQUEST").collect();
    requests::follow(dataset, &requests, output, notes);
    for (keyword, (lines, why)) in outside {
        notes.left_out_together(keyword, &lines, why);
    }
    list_unused(statements, notes);
    gravity
}

/// Notes numbers that two statements of one kind have. Those of parts and the like have been noted.
fn check_numbers(statements: &[Statement], notes: &mut Notes) {
    let mut taken = HashSet::new();
    let referred = ["PART", "MARKER", "VARIABLE", "SPLINE"];
    for statement in statements {
        let Statement { keyword, id, line, .. } = statement;
        let counts = !keys(keyword).is_empty() && !referred.contains(&keyword.as_str());
        if counts && id.is_some() && !taken.insert((keyword, id)) {
            let what = format!("there are two {}", statement.title());
            notes.mistake(*line, what, "give one of them another number");
        }
    }
}

/// Lists the keys that no translation has asked for.
fn list_unused(statements: &[Statement], notes: &mut Notes) {
    for statement in statements {
        if keys(&statement.keyword).is_empty() {
            continue; // The whole statement is listed.
        }
        for (line, argument) in statement.unused() {
            let what = format!("{argument} of {}", statement.title());
            notes.left_out(line, what, "hardpoint does not know it or does not need it");
        }
    }
}

/// The keys of the kinds of statements that are translated here.
fn keys(keyword: &str) -> &'static [&'static str] {
    match keyword {
        "PART" => dataset::PART,
        "MARKER" => dataset::MARKER,
        "UNITS" => scales::KEYS,
        "ACCGRAV" => &["IGRAV", "JGRAV", "KGRAV"],
        "JOINT" => joints::JOINT_KEYS,
        "JPRIM" => joints::PRIMITIVE_KEYS,
        "GCON" => constraints::KEYS,
        "MOTION" => motions::KEYS,
        "SFORCE" => forces::SFORCE,
        "SPRINGDAMPER" => forces::SPRINGDAMPER,
        "BUSHING" => forces::BUSHING,
        "VFORCE" | "VTORQUE" | "GFORCE" => forces::COMPONENTS,
        "REQUEST" => requests::KEYS,
        _ => &[],
    }
}

/// The acceleration of gravity (m/s²).
fn read_gravity(dataset: &Dataset, statement: &Statement, notes: &mut Notes) -> Vector<f64> {
    let scales = &dataset.scales;
    let metre = scales.length_unit.to_metres(scales.length);
    let components = ["IGRAV", "JGRAV", "KGRAV"];
    components.map(|key| {
        statement.number(key, notes).unwrap_or_default() * metre / (scales.time * scales.time)
    })
}
