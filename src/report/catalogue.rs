//! Architectures as text: a list, and each with its points, bodies and joints.

use std::io::{self, Write};

use crate::mechanism::{BodyId, Direction, Joint, JointKind, PointId};
use crate::model::{Architecture, PointRole};

/// How many bodies and equations joints make, one side or, of a whole axle, both.
struct Count {
    bodies: usize,
    equations: usize,
    rack: bool,
}

impl Count {
    fn of(architecture: &Architecture) -> Self {
        let sides = if architecture.is_axle() { 2 } else { 1 };
        let bodies = architecture.bodies().iter();
        let times = |shared: bool| if shared { 1 } else { sides };
        let both =
            |joint: &Joint| architecture.is_shared(joint.i) && architecture.is_shared(joint.j);
        let joints = architecture.joints().iter();
        let own: usize = joints.map(|joint| times(both(joint)) * joint.kind.equations()).sum();
        let across = architecture.axle_joints().iter().map(|joint| joint.kind.equations());
        Self {
            bodies: bodies.map(|body| times(body.shared)).sum(),
            equations: own + across.sum::<usize>(),
            rack: architecture.rack().is_some(),
        }
    }

    /// The motions that joints leave free, by the rule of Grübler, with the rack held.
    fn words(&self) -> String {
        let held = usize::from(self.rack);
        let coordinates = 6 * self.bodies;
        let free = coordinates.saturating_sub(self.equations + held);
        let rack = if self.rack { " − 1 for the rack that is held" } else { "" };
        format!(
            "6 · {} bodies − {} equations of joints{rack} = {free}",
            self.bodies, self.equations
        )
    }
}

/// Writes one line for each built-in architecture.
///
/// # Errors
/// Those of the writer.
pub fn write_architectures(writer: &mut dyn Write) -> io::Result<()> {
    let all = built_in();
    let width = all.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    for (name, architecture) in &all {
        let what = if architecture.is_axle() { "axle  " } else { "corner" };
        writeln!(writer, "{name:<width$}  {what}  {}", architecture.title())?;
    }
    Ok(())
}

/// Writes all built-in architectures as Markdown with their drawings; `docs/architectures/README.md` is this text.
///
/// # Errors
/// Those of the writer.
pub fn write_catalogue(writer: &mut dyn Write) -> io::Result<()> {
    writeln!(writer, "# Architectures\n")?;
    writeln!(
        writer,
        "Written by `hardpoint architectures --list`; [architectures.md](../architectures.md) shows how to write \
         one's own. The drawings are those of the examples, `models/NAME.toml`.\n"
    )?;
    writeln!(writer, "| name | what | of |\n|---|---|---|")?;
    let all = built_in();
    for (name, architecture) in &all {
        let of = if architecture.is_axle() { "an axle" } else { "a corner" };
        writeln!(writer, "| [`{name}`](#{name}) | {} | {of} |", architecture.title())?;
    }
    for (name, architecture) in &all {
        writeln!(writer)?;
        write_architecture(writer, name, architecture)?;
        writeln!(writer, "\n![{}]({name}.svg)", architecture.title())?;
    }
    Ok(())
}

/// Writes one architecture as Markdown: its points, bodies, joints and free motions.
///
/// # Errors
/// Those of the writer.
pub fn write_architecture(
    writer: &mut dyn Write,
    name: &str,
    architecture: &Architecture,
) -> io::Result<()> {
    writeln!(writer, "## {name}\n\n**{}.**", architecture.title())?;
    if let Some(description) = architecture.description() {
        writeln!(writer, "{}", description.trim())?;
    }
    let of = if architecture.is_axle() { "Both sides are one mechanism. " } else { "" };
    writeln!(writer, "\n{of}Free motions: {}.\n", Count::of(architecture).words())?;
    writeln!(writer, "| point | what it is |\n|---|---|")?;
    let point = |writer: &mut dyn Write, role: &PointRole, optional: &str| {
        writeln!(writer, "| `{}` | {}{optional} |", role.name, role.meaning)
    };
    for role in architecture.points() {
        point(writer, role, "")?;
    }
    for role in architecture.optional_points() {
        point(writer, role, " (optional)")?;
    }
    writeln!(writer, "\n| body | what it is |\n|---|---|")?;
    for body in architecture.bodies() {
        let shared = if body.shared { " (one for both sides)" } else { "" };
        writeln!(writer, "| `{}` | {}{shared} |", body.name, body.meaning)?;
    }
    writeln!(writer, "\n| joint | kind | between | at | bushings |\n|---|---|---|---|---|")?;
    let bushed: Vec<&str> = architecture.bushed_joints().collect();
    for joint in architecture.joints().iter().chain(architecture.axle_joints()) {
        let [i, j] = [joint.i, joint.j].map(|body| body_name(architecture, body));
        let usual = if bushed.contains(&joint.name.as_str()) { "usual" } else { "" };
        let (kind, at) = (joint.kind.name(), places(architecture, joint.kind));
        writeln!(writer, "| `{}` | {kind} | `{i}`, `{j}` | {at} | {usual} |", joint.name)?;
    }
    Ok(())
}

fn built_in() -> Vec<(&'static str, Architecture)> {
    let names = Architecture::built_in_names().into_iter();
    names.filter_map(|name| Some((name, Architecture::built_in(name)?.ok()?))).collect()
}

fn body_name(architecture: &Architecture, body: BodyId) -> String {
    let number = architecture.bodies().len();
    match body.0 {
        0 => architecture.ground().to_owned(),
        this if this <= number => architecture.bodies()[this - 1].name.clone(),
        other => format!("other.{}", architecture.bodies()[other - number - 1].name),
    }
}

fn point_name(architecture: &Architecture, point: PointId) -> String {
    let number = architecture.points().len();
    match point.0 {
        this if this < number => format!("`{}`", architecture.points()[this].name),
        other => format!("`other.{}`", architecture.points()[other - number].name),
    }
}

/// The points and the line of a joint.
fn places(architecture: &Architecture, kind: JointKind) -> String {
    let name = |point| point_name(architecture, point);
    let [first, second] = kind.points();
    let at = match first == second {
        true => name(first),
        false => format!("{}–{}", name(first), name(second)),
    };
    match kind.directions().next() {
        None => at,
        Some(Direction::Between(from, to)) => format!("{at}, along {}–{}", name(from), name(to)),
        Some(Direction::Fixed(line)) => {
            let axis = ["x", "y", "z"].into_iter().zip(line).find(|(_, part)| *part != 0.0);
            format!("{at}, along {}", axis.map_or("x", |(axis, _)| axis))
        }
    }
}
