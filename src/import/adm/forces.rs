//! SFORCE, SPRINGDAMPER, BUSHING, and constant VFORCE, VTORQUE and GFORCE.

use super::dataset::Dataset;
use super::expression::Measure;
use super::law::{Answer, Kind, Law};
use super::notes::Notes;
use super::output::{List, Output, direction, number, quoted, table, vector};
use super::pair::{Pair, marker};
use super::parse::parse;
use super::statement::Statement;
use crate::vector::{Vector, dot, scale};

pub(super) const SFORCE: &[&str] =
    &["ACTIONONLY", "FUNCTION", "I", "J", "REACTION", "ROTATIONAL", "TRANSLATIONAL"];

pub(super) const SPRINGDAMPER: &[&str] = &[
    "ANGLE",
    "C",
    "CT",
    "FORCE",
    "I",
    "J",
    "K",
    "KT",
    "LENGTH",
    "ROTATION",
    "TORQUE",
    "TRANSLATION",
];

pub(super) const BUSHING: &[&str] = &["C", "CT", "FORCE", "I", "J", "K", "KT", "TORQUE"];

pub(super) const COMPONENTS: &[&str] =
    &["FUNCTION", "FX", "FY", "FZ", "I", "JFLOAT", "RM", "TX", "TY", "TZ"];

/// Axes of a bushing that are turned by more than this (rad) at the design position have no small angles.
const SMALL: f64 = 0.1;

/// Translates one SFORCE.
pub(super) fn single(
    dataset: &Dataset,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    let turns = statement.has("ROTATIONAL");
    if !statement.has("TRANSLATIONAL") && !turns {
        let what = format!("{} is neither TRANSLATIONAL nor ROTATIONAL", statement.title());
        return notes.mistake(statement.line, what, "write one of the two");
    }
    statement.has("REACTION");
    let action_only = statement.has("ACTIONONLY");
    let [i, j] = ["I", "J"].map(|key| marker(dataset, statement, key, notes));
    let (Some(i), Some(j)) = (i, j) else { return };
    // A force of one side may have its direction from its own part.
    let pair = if action_only {
        Some(Pair { dataset, i, j })
    } else {
        Pair::new(dataset, i, j, statement, notes)
    };
    let Some(pair) = pair else { return };
    let Some((line, text)) = statement.text("FUNCTION") else {
        let what = format!("{} has no FUNCTION", statement.title());
        return notes.mistake(statement.line, what, "write FUNCTION = …");
    };
    let what = format!("{}: {}", statement.title(), super::statement::shortened(text));
    let parsed = match parse(text) {
        Ok(parsed) => parsed,
        Err(why) => return notes.missing(line, what, why),
    };
    if action_only {
        let size = parsed.linear(dataset).filter(|linear| linear.terms.is_empty());
        let Some(size) = size else {
            return notes.missing(line, what, "forces of one side are constant in hardpoint");
        };
        let load = scale(size.constant, pair.z_j());
        let (force, moment) = if turns { ([0.0; 3], load) } else { (load, [0.0; 3]) };
        return loads(
            &pair,
            Frame::of(&pair, pair.j.part),
            [force, moment],
            statement,
            output,
            notes,
        );
    }
    let kind = if turns { Kind::Torsion } else { Kind::Line };
    if turns && pair.aligned(statement, notes).is_none() {
        return;
    }
    match Law::of(&parsed, kind, &pair) {
        Err(why) => notes.missing(line, what, why),
        Ok((law, remark)) => {
            if let Some(remark) = remark {
                notes.assume(format!("{what}: {remark}"));
            }
            write(&law, kind, &pair, statement, output, notes);
        }
    }
}

/// Translates one SPRINGDAMPER: F = FORCE − K (DM − LENGTH) − C VR, or the same with angles.
pub(super) fn spring_damper(
    dataset: &Dataset,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    let turns = statement.has("ROTATION");
    if !statement.has("TRANSLATION") && !turns {
        let what = format!("{} is neither TRANSLATION nor ROTATION", statement.title());
        return notes.mistake(statement.line, what, "write one of the two");
    }
    let Some(pair) = Pair::of(dataset, statement, notes) else { return };
    let keys = if turns { ["KT", "CT", "ANGLE", "TORQUE"] } else { ["K", "C", "LENGTH", "FORCE"] };
    let [k, c, free, force] = keys.map(|key| statement.number(key, notes).unwrap_or_default());
    if !turns {
        let law = Law::linear(force + k * free, -k, -c, pair.distance());
        return write(&law, Kind::Line, &pair, statement, output, notes);
    }
    if pair.aligned(statement, notes).is_none() {
        return;
    }
    let measure = Measure { name: "AZ".into(), markers: vec![pair.i.id, pair.j.id] };
    let angle = dataset.design(&measure).unwrap_or_default();
    let law = Law::linear(force + k * (free - angle), -k, -c, 0.0);
    write(&law, Kind::Torsion, &pair, statement, output, notes);
}

/// Writes the elements of a law.
fn write(
    law: &Law,
    kind: Kind,
    pair: &Pair,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    if law.is_zero() {
        return notes.left_out(statement.line, statement.title(), "its force is always zero");
    }
    let name = output.name(List::Forces, statement, &statement.keyword.to_ascii_lowercase());
    match kind {
        Kind::Line => line(law, pair, &name, statement, output),
        Kind::Torsion => torsion(law, pair, &name, statement, output, notes),
    }
}

/// A force along the line of two points. F > 0 pushes them apart, λ > 0 pulls them together.
fn line(law: &Law, pair: &Pair, name: &str, statement: &Statement, output: &mut Output) {
    let scales = pair.dataset.scales;
    let rows = |rows: &[[f64; 2]], by: f64, sign: [f64; 2]| {
        let mut rows: Vec<[f64; 2]> =
            rows.iter().map(|[x, f]| [sign[0] * x * by, sign[1] * f * scales.force]).collect();
        rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
        table(&rows)
    };
    let start = |kind: &str, output: &mut Output| {
        vec![("kind", quoted(kind)), pair.i_to_j(), pair.on(output)]
    };
    let mut damping = vec![];
    match &law.viscous {
        Answer::Linear(0.0) => {}
        Answer::Linear(by_rate) => damping.push(("damping", number(-by_rate * scales.damping()))),
        Answer::Table(force) => {
            // The whole force is in its rows; what is there at rest belongs to the spring.
            let force: Vec<[f64; 2]> = force.iter().map(|[v, f]| [*v, f - law.at_design]).collect();
            damping.push(("damping_table", rows(&force, scales.velocity(), [1.0, -1.0])));
        }
    }
    let mut lines = start("spring", output);
    match &law.elastic {
        Answer::Linear(0.0) => {
            if law.at_design != 0.0 {
                let mut lines = start("actuator", output);
                lines.push(("force", number(-law.at_design * scales.force)));
                output.section(List::Forces, statement, name, &lines);
            }
            let Some((_, damping)) = damping.pop() else { return };
            let key = if matches!(law.viscous, Answer::Linear(_)) { "damping" } else { "table" };
            let mut lines = start("damper", output);
            lines.push((key, damping));
            let name =
                if law.at_design == 0.0 { name.to_owned() } else { format!("{name}_damper") };
            return output.section(List::Forces, statement, &name, &lines);
        }
        Answer::Linear(slope) => {
            lines.push(("stiffness", number(-slope * scales.stiffness())));
            lines.push(match law.free.filter(|free| *free >= 0.0) {
                Some(free) => ("free_length", number(free * scales.length)),
                None => ("preload", number(law.at_design * scales.force)),
            });
        }
        Answer::Table(force) => {
            // By the compression from the design position.
            lines.push(("table", rows(force, scales.length, [-1.0, 1.0])));
            lines.push(("free_length", number(pair.distance() * scales.length)));
        }
    }
    lines.append(&mut damping);
    output.section(List::Forces, statement, name, &lines);
}

/// A moment about z of J. F > 0 turns the part of I right-handed.
fn torsion(
    law: &Law,
    pair: &Pair,
    name: &str,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    let scales = pair.dataset.scales;
    let Answer::Linear(by_rate) = law.viscous else {
        let why = "the damping of torsion springs is linear in hardpoint";
        return notes.missing(statement.line, statement.title(), why);
    };
    let kind = ("kind", quoted("torsion-spring"));
    let mut lines = vec![kind, pair.j_to_i(), ("axis", direction(pair.z_j()))];
    match &law.elastic {
        Answer::Linear(slope) => {
            lines.push(("stiffness", number(-slope * scales.torque())));
            match law.free {
                Some(free) => lines.push(("free_angle", number(free))),
                None => lines.push(("preload", number(law.at_design * scales.torque()))),
            }
        }
        Answer::Table(force) => {
            let rows: Vec<[f64; 2]> =
                force.iter().map(|[x, f]| [*x, -f * scales.torque()]).collect();
            lines.push(("table", table(&rows)));
        }
    }
    if by_rate != 0.0 {
        lines.push(("damping", number(-by_rate * scales.rotational_damping())));
    }
    output.section(List::Forces, statement, name, &lines);
}

/// Translates one BUSHING: components along the axes of J, on the part of I.
pub(super) fn bushing(
    dataset: &Dataset,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    let Some(pair) = Pair::of(dataset, statement, notes) else { return };
    let keys = ["K", "C", "FORCE", "KT", "CT", "TORQUE"];
    let [k, c, force, kt, ct, torque] =
        keys.map(|key| statement.numbers::<3>(key, notes).unwrap_or_default());
    let axes = pair.j.frame.axes;
    let offset = axes.map(|axis| dot(axis, pair.way()));
    // R of I in the axes of J, R = Rx(a) Ry(b) Rz(c).
    let r = axes.map(|axis| pair.i.frame.axes.map(|other| dot(axis, other)));
    let angles = crate::vector::rotation_angles(r);
    if angles.iter().any(|angle| angle.abs() > SMALL) && kt != [0.0; 3] {
        let why = "the axes of its markers differ by more than small angles";
        return notes.missing(statement.line, statement.title(), why);
    }
    let scales = dataset.scales;
    // What the bushing pushes at the design position is a preload.
    let at_design = |constant: Vector<f64>, k: Vector<f64>, x: Vector<f64>, by: f64| {
        vector(std::array::from_fn(|n| (constant[n] - k[n] * x[n]) * by))
    };
    let scaled = |numbers: Vector<f64>, by: f64| vector(numbers.map(|number| number * by));
    let name = output.name(List::Forces, statement, "bushing");
    let mut lines = vec![
        ("kind", quoted("bushing")),
        pair.j_to_i(),
        ("at", output.point(pair.i)),
        ("x_axis", direction(axes[0])),
        ("z_axis", direction(axes[2])),
        ("stiffness", scaled(k, scales.stiffness())),
    ];
    lines.push(("damping", scaled(c, scales.damping())));
    lines.push(("preload", at_design(force, k, offset, scales.force)));
    lines.push(("rotational_stiffness", scaled(kt, scales.torque())));
    lines.push(("rotational_damping", scaled(ct, scales.rotational_damping())));
    lines.push(("rotational_preload", at_design(torque, kt, angles, scales.torque())));
    lines.push(("law", quoted("torque")));
    output.section(List::Forces, statement, &name, &lines);
}

/// Translates a VFORCE, VTORQUE or GFORCE with constant components.
pub(super) fn components(
    dataset: &Dataset,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    let Some(i) = marker(dataset, statement, "I", notes) else { return };
    let Some(floating) = marker(dataset, statement, "JFLOAT", notes) else { return };
    let rm =
        if statement.has("RM") { marker(dataset, statement, "RM", notes) } else { Some(floating) };
    let Some(rm) = rm else { return };
    let why = if statement.has("FUNCTION") {
        Some("it calls a subroutine")
    } else if !dataset.body(floating).ground {
        Some("forces with components act from the ground in hardpoint")
    } else if dataset.body(i).ground {
        Some("it acts on the ground")
    } else {
        None
    };
    if let Some(why) = why {
        return notes.missing(statement.line, statement.title(), why);
    }
    let mut component = |key: &str| {
        let Some((line, text)) = statement.text(key) else { return Some(0.0) };
        let parsed = parse(text);
        let constant = parsed.ok().and_then(|parsed| parsed.linear(dataset));
        let constant = constant.filter(|linear| linear.terms.is_empty());
        if constant.is_none() {
            let what = format!("{}: {key} = {text}", statement.title());
            notes.missing(line, what, "forces with components are constant in hardpoint");
        }
        constant.map(|linear| linear.constant)
    };
    let force = ["FX", "FY", "FZ"].map(&mut component);
    let moment = ["TX", "TY", "TZ"].map(&mut component);
    let whole = |parts: [Option<f64>; 3]| Some([parts[0]?, parts[1]?, parts[2]?]);
    let (Some(force), Some(moment)) = (whole(force), whole(moment)) else { return };
    let pair = Pair { dataset, i, j: floating };
    let loads_in_ground = [rm.frame.vector(force), rm.frame.vector(moment)];
    loads(&pair, Frame::of(&pair, rm.part), loads_in_ground, statement, output, notes);
}

/// What a load keeps its direction in.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Frame {
    Space,
    Body,
    /// Another part.
    Other,
}

impl Frame {
    fn of(pair: &Pair, part: u32) -> Self {
        if part == pair.i.part {
            Self::Body
        } else if pair.dataset.ground == Some(part) {
            Self::Space
        } else {
            Self::Other
        }
    }
}

/// Writes a constant force and a constant moment on the part of I.
fn loads(
    pair: &Pair,
    frame: Frame,
    [force, moment]: [Vector<f64>; 2],
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    let frame = match frame {
        Frame::Space => "space",
        Frame::Body => "body",
        Frame::Other => {
            let why = "a load keeps its direction in space or in its own part in hardpoint";
            return notes.missing(statement.line, statement.title(), why);
        }
    };
    if pair.body_i().ground {
        let why = "it acts on the ground";
        return notes.left_out(statement.line, statement.title(), why);
    }
    let scales = pair.dataset.scales;
    let body = ("body", quoted(&pair.body_i().name));
    let frame = ("frame", quoted(frame));
    let keyword = statement.keyword.to_ascii_lowercase();
    if force != [0.0; 3] {
        let name = output.name(List::Forces, statement, &keyword);
        let value = ("force", vector(force.map(|f| f * scales.force)));
        let lines = [
            ("kind", quoted("force")),
            body.clone(),
            ("at", output.point(pair.i)),
            value,
            frame.clone(),
        ];
        output.section(List::Forces, statement, &name, &lines);
    }
    if moment != [0.0; 3] {
        let name = output.name(List::Forces, statement, &keyword);
        let value = ("moment", vector(moment.map(|m| m * scales.torque())));
        let lines = [("kind", quoted("moment")), body, value, frame];
        output.section(List::Forces, statement, &name, &lines);
    }
    if force == [0.0; 3] && moment == [0.0; 3] {
        notes.left_out(statement.line, statement.title(), "its force is always zero");
    }
}
