//! MOTION: drivers that follow a function of time.

use std::collections::BTreeMap;

use super::dataset::{Dataset, NEAR};
use super::expression::{Expression, Measure, TIME};
use super::law::Probe;
use super::notes::Notes;
use super::output::{List, Output, direction, list};
use super::pair::{Pair, not_assembled};
use super::parse::parse;
use super::statement::Statement;

pub(super) const KEYS: &[&str] = &[
    "ACCELERATION",
    "B1",
    "B2",
    "B3",
    "DISPLACEMENT",
    "FUNCTION",
    "I",
    "ICDISP",
    "ICVEL",
    "J",
    "JOINT",
    "ROTATION",
    "TRANSLATION",
    "VELOCITY",
    "X",
    "Y",
    "Z",
];

/// Translates one MOTION.
pub(super) fn motion(
    dataset: &Dataset,
    statement: &Statement,
    joints: &BTreeMap<u32, &Statement>,
    output: &mut Output,
    notes: &mut Notes,
) {
    let (pair, axis, turns) = match place(dataset, statement, joints, notes) {
        Some(place) => place,
        None => return,
    };
    let Some((line, text)) = statement.text("FUNCTION") else {
        let what = format!("{} has no FUNCTION", statement.title());
        return notes.mistake(statement.line, what, "write FUNCTION = …");
    };
    let what = format!("{}: {}", statement.title(), super::statement::shortened(text));
    if statement.has("ACCELERATION") {
        return notes.missing(line, what, "drivers follow positions or speeds in hardpoint");
    }
    let by_speed = statement.has("VELOCITY");
    statement.has("DISPLACEMENT");
    let mut course = Course::default();
    let read = parse(text).and_then(|expression| {
        course.add(&expression, 1.0, dataset, 0)?;
        let at = |time| expression.value(&Probe { dataset, values: vec![], time: Some(time) });
        at(0.0)
    });
    let start = match read {
        Ok(start) => start,
        Err(why) => return notes.missing(line, what, why),
    };
    if by_speed {
        if !course.waves.is_empty() || !course.steps.is_empty() {
            let why = "hardpoint integrates only speeds that are polynomials of the time";
            return notes.missing(line, what, why);
        }
        let speed = std::iter::once(start).chain(course.polynomial.iter().copied());
        course.polynomial = speed.zip(1_u16..).map(|(by, power)| by / f64::from(power)).collect();
    } else {
        let markers = vec![pair.i.id, pair.j.id, pair.j.id];
        let name = if turns { "AZ" } else { ["DX", "DY", "DZ"][axis] };
        let design = dataset.design(&Measure { name: name.into(), markers }).unwrap_or_default();
        let unit = if turns { 1.0 } else { dataset.size };
        if (start - design).abs() > NEAR * unit {
            let what = format!(
                "{} begins at {start:.6e}, but the markers are at {design:.6e}",
                statement.title()
            );
            return not_assembled(line, what, notes);
        }
    }
    let name = output.name(List::Drivers, statement, "motion");
    let along = direction(pair.j.frame.axes[axis]);
    let mut lines = if turns {
        vec![("kind", "\"rotation\"".to_owned()), pair.j_to_i(), ("axis", along)]
    } else {
        let at = ("at", output.point(pair.i));
        vec![("kind", "\"displacement\"".to_owned()), pair.j_to_i(), at, ("along", along)]
    };
    let scale = if turns { 1.0 } else { dataset.scales.length };
    if let Some(motion) = course.text(scale, dataset.scales.time) {
        lines.push(("motion", motion));
    }
    output.section(List::Drivers, statement, &name, &lines);
}

/// The markers, the axis of J, and whether it is a rotation.
fn place<'d>(
    dataset: &'d Dataset,
    statement: &Statement,
    joints: &BTreeMap<u32, &Statement>,
    notes: &mut Notes,
) -> Option<(Pair<'d>, usize, bool)> {
    if !statement.has("JOINT") {
        let pair = Pair::of(dataset, statement, notes)?;
        let word = statement.word(&["X", "Y", "Z"]);
        let Some(word) = word else {
            let why = "rotations are driven at a JOINT, displacements along X, Y or Z";
            notes.missing(statement.line, statement.title(), why);
            return None;
        };
        return Some((pair, usize::from(word.as_bytes()[0] - b'X'), false));
    }
    let id = statement.reference("JOINT", notes)?;
    let Some(joint) = joints.get(&id) else {
        let what = format!("{} drives JOINT/{id}, which does not exist", statement.title());
        notes.mistake(statement.line, what, "correct the number of the joint");
        return None;
    };
    let turns = statement.has("ROTATION");
    if !turns && !statement.has("TRANSLATION") {
        let what = format!("{} is neither ROTATION nor TRANSLATION", statement.title());
        notes.mistake(statement.line, what, "write one of the two");
        return None;
    }
    let kinds: &[&str] =
        if turns { &["REVOLUTE", "CYLINDRICAL"] } else { &["TRANSLATIONAL", "CYLINDRICAL"] };
    if joint.word(kinds).is_none() {
        let what = format!("{} drives what JOINT/{id} does not let move", statement.title());
        notes.mistake(statement.line, what, "write ROTATION or TRANSLATION as the joint has it");
        return None;
    }
    Some((Pair::of(dataset, joint, notes)?, 2, turns))
}

/// A function of time but for its constant part, in the units of the dataset.
#[derive(Default)]
struct Course {
    /// Of t, t², …
    polynomial: Vec<f64>,
    /// Amplitude, angular frequency and phase.
    waves: Vec<[f64; 3]>,
    /// Beginning, end and change; whether it is of fifth degree.
    steps: Vec<([f64; 3], bool)>,
}

/// Powers of the time above this are a mistake.
const HIGHEST: f64 = 20.0;

impl Course {
    /// Adds an expression times a factor.
    fn add(
        &mut self,
        expression: &Expression,
        factor: f64,
        dataset: &Dataset,
        depth: usize,
    ) -> Result<(), String> {
        if depth > 20 {
            return Err("its variables go round in a circle".into());
        }
        if let Some(measure) = expression.measures(dataset)?.first() {
            return Err(format!("it follows {}, not only the time", measure.name));
        }
        if let Some(linear) = expression.linear(dataset) {
            let by_time = linear.terms.values().sum::<f64>();
            self.power(1, factor * by_time);
            return Ok(());
        }
        let constant = |expression: &Expression| {
            let linear = expression.linear(dataset).filter(|linear| linear.terms.is_empty());
            linear.map(|linear| linear.constant)
        };
        let unknown = || "hardpoint knows polynomials, sines and STEPs of the time".to_owned();
        match expression {
            Expression::Sum(terms) => terms.iter().try_for_each(|(minus, term)| {
                self.add(term, if *minus { -factor } else { factor }, dataset, depth + 1)
            }),
            Expression::Product(factors) => {
                let (mut factor, mut varying) = (factor, None);
                for (divides, part) in factors {
                    match constant(part) {
                        Some(constant) if *divides => factor /= constant,
                        Some(constant) => factor *= constant,
                        None if !*divides && varying.is_none() => varying = Some(part),
                        None => return Err(unknown()),
                    }
                }
                self.add(varying.ok_or_else(unknown)?, factor, dataset, depth + 1)
            }
            Expression::Power(base, exponent) => {
                let time = **base == Expression::Call(TIME.to_owned(), vec![]);
                match constant(exponent) {
                    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                    // Small and whole.
                    Some(n) if time && n.fract() == 0.0 && (1.0..=HIGHEST).contains(&n) => {
                        self.power(n as usize, factor);
                        Ok(())
                    }
                    _ => Err(unknown()),
                }
            }
            Expression::Call(name, arguments) => match (name.as_str(), &arguments[..]) {
                ("SIN" | "COS", [inside]) => {
                    let inside = inside.linear(dataset).ok_or_else(unknown)?;
                    let frequency = inside.terms.values().sum::<f64>();
                    let quarter = if name == "COS" { std::f64::consts::FRAC_PI_2 } else { 0.0 };
                    self.waves.push([factor, frequency, inside.constant + quarter]);
                    Ok(())
                }
                ("STEP" | "STEP5", [x, numbers @ ..]) if numbers.len() == 4 => {
                    let time = *x == Expression::Call(TIME.to_owned(), vec![]);
                    let numbers: Option<Vec<f64>> = numbers.iter().map(constant).collect();
                    let numbers = numbers.filter(|n| time && n[0] < n[2]).ok_or_else(unknown)?;
                    let change = factor * (numbers[3] - numbers[1]);
                    self.steps.push(([numbers[0], numbers[2], change], name == "STEP5"));
                    Ok(())
                }
                ("VARVAL", [Expression::Number(id)]) => {
                    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                    let id = *id as u32;
                    let variable = dataset.variables.get(&id).ok_or_else(unknown)?;
                    self.add(variable, factor, dataset, depth + 1)
                }
                _ => Err(unknown()),
            },
            Expression::Number(_) => Ok(()),
        }
    }

    fn power(&mut self, power: usize, factor: f64) {
        if self.polynomial.len() < power {
            self.polynomial.resize(power, 0.0);
        }
        self.polynomial[power - 1] += factor;
    }

    /// The value of `motion`, `None` where nothing moves; `unit` and `second` are the scales of the
    /// value and of the time.
    fn text(&self, unit: f64, second: f64) -> Option<String> {
        let mut parts = vec![];
        let polynomial: Vec<f64> = self
            .polynomial
            .iter()
            .zip(1..)
            .map(|(by, power)| by * unit / second.powi(power))
            .collect();
        if polynomial.iter().any(|by| *by != 0.0) {
            parts.push(format!("polynomial = {}", list(&polynomial)));
        }
        let rows = |key: &str, rows: Vec<[f64; 3]>| {
            let rows: Vec<String> = rows.iter().map(|row| list(row)).collect();
            (!rows.is_empty()).then(|| format!("{key} = [{}]", rows.join(", ")))
        };
        let turn = std::f64::consts::TAU * second;
        let waves =
            self.waves.iter().map(|[size, speed, phase]| [size * unit, speed / turn, *phase]);
        parts.extend(rows("sine", waves.collect()));
        for (key, fifth) in [("step", false), ("step5", true)] {
            let steps = self.steps.iter().filter(|(_, degree)| *degree == fifth);
            let steps = steps.map(|([from, to, by], _)| [from * second, to * second, by * unit]);
            parts.extend(rows(key, steps.collect()));
        }
        (!parts.is_empty()).then(|| format!("{{ {} }}", parts.join(", ")))
    }
}
