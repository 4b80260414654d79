//! A static equilibrium: pose, joints, force elements.

use std::io;

use serde_json::{Map, Value, json};

use super::rounded;
use super::table::cell;
use crate::factors::{Factor, basic};
use crate::mechanism::ForceKind;
use crate::model::{Axes, Quantity, Units};
use crate::rig::{Channel, Pose};
use crate::solve::equilibrium::Equilibrium;
use crate::solve::{StaticReport, rotation};
use crate::vector::{rotation_angles, sub};

/// An equilibrium and all that is needed to show it.
#[derive(Clone, Copy)]
pub struct StaticsReport<'a> {
    /// Name of the model, with what was asked for.
    pub title: &'a str,
    /// Axes in which components are shown.
    pub axes: Axes,
    /// Units of the report.
    pub units: Units,
    /// The equilibrium.
    pub equilibrium: &'a Equilibrium,
    /// How it was found.
    pub found: &'a StaticReport,
    /// The wheel, those on the left and the right of an axle, or none.
    pub poses: &'a [Pose<f64>],
    /// The channels of force elements.
    pub elements: &'a [Channel],
}

/// A named row of numbers in the units of the report.
struct Line {
    name: String,
    note: String,
    values: Vec<f64>,
}

impl StaticsReport<'_> {
    /// Writes the report for people.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_text(&self, mut writer: impl io::Write) -> io::Result<()> {
        writeln!(writer, "{}", self.title)?;
        writeln!(writer, "{}", self.how())?;
        for pose in self.poses {
            writeln!(writer, "\n{}wheel", self.side(pose, " "))?;
            for factor in basic() {
                if let Some(value) = factor.show(self.units, pose) {
                    let unit = factor.quantity.symbol(self.units);
                    let value = cell(Some(value));
                    writeln!(
                        writer,
                        "  {:<24} {value:>14} {unit:<6} {}",
                        factor.title, factor.sign
                    )?;
                }
            }
        }
        let [length, angle, force, torque] =
            [Quantity::Length, Quantity::Angle, Quantity::Force, Quantity::Torque]
                .map(|quantity| quantity.symbol(self.units));
        let head = format!(
            "bodies: displacement [{length}] of the body's origin, rotation [{angle}] Rx(a) Ry(b) Rz(c), from design"
        );
        lines(&mut writer, &head, ["dx", "dy", "dz", "a", "b", "c"], &self.bodies())?;
        let head = format!(
            "joints: force [{force}] and moment [{torque}] on the second body, at the joint, along the model's axes"
        );
        lines(&mut writer, &head, ["Fx", "Fy", "Fz", "Mx", "My", "Mz"], &self.joints())?;
        let head = format!(
            "bushings: displacement [{length}] and rotation [{angle}] of the second body, in the bushing's axes"
        );
        lines(&mut writer, &head, ["x", "y", "z", "rx", "ry", "rz"], &self.bushings(false))?;
        let head = format!(
            "bushings: force [{force}] and moment [{torque}] on the second body, in the bushing's axes"
        );
        lines(&mut writer, &head, ["Fx", "Fy", "Fz", "Mx", "My", "Mz"], &self.bushings(true))?;
        self.write_channels(&mut writer, "drivers", |channel| channel.force().is_none())?;
        self.write_channels(&mut writer, "other force elements", |channel| {
            channel.force().is_some() && !self.is_bushing(channel)
        })
    }

    /// Writes the channels of a group, one in a line; nothing where there are none.
    fn write_channels(
        &self,
        writer: &mut impl io::Write,
        head: &str,
        belongs: impl Fn(&Channel) -> bool,
    ) -> io::Result<()> {
        let channels: Vec<&Channel> = self.elements.iter().filter(|c| belongs(c)).collect();
        if channels.is_empty() {
            return Ok(());
        }
        writeln!(writer, "\n{head}")?;
        let width = channels.iter().map(|c| c.title.chars().count()).max().unwrap_or(0);
        for channel in channels {
            let unit = channel.quantity.symbol(self.units);
            let value = cell(Some(self.element_value(channel)));
            let (title, sign) = (&channel.title, channel.sign);
            writeln!(writer, "  {title:<width$} {value:>14} {unit:<8} {sign}")?;
        }
        Ok(())
    }

    /// Writes one object to 15 significant digits.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, &self.json())?;
        writeln!(writer)
    }

    fn json(&self) -> Value {
        let unit = |quantity: Quantity| quantity.symbol(self.units);
        let object = |lines: Vec<Line>, keys: [&str; 2]| -> Value {
            let entry = |line: Line| {
                let values: Vec<f64> = line.values.into_iter().map(rounded).collect();
                let value = json!({
                    keys[0]: values[..3], keys[1]: values[3..], "note": line.note,
                });
                (line.name, value)
            };
            Value::Object(lines.into_iter().map(entry).collect::<Map<_, _>>())
        };
        let factors = self.poses.iter().map(|pose| {
            let factor = |factor: &'static Factor| {
                let value = factor.show(self.units, pose)?;
                Some((factor.column(self.units), json!(rounded(value))))
            };
            let factors: Map<_, _> = basic().filter_map(factor).collect();
            (format!("{}wheel", self.side(pose, "_")), Value::Object(factors))
        });
        let wheels: Map<_, _> = factors.collect();
        let channels = |drivers: bool| -> Map<_, _> {
            let group = self.elements.iter().filter(|c| c.force().is_none() == drivers);
            let value = |channel: &Channel| {
                let value = rounded(self.element_value(channel));
                (format!("{}_{}", channel.name, unit(channel.quantity)), json!(value))
            };
            group.map(value).collect()
        };
        let stiffness = self.found.stiffness;
        let mut report = json!({
            "title": self.title,
            "axes": self.axes.name(),
            "units": {
                "length": unit(Quantity::Length), "angle": unit(Quantity::Angle),
                "force": unit(Quantity::Force), "moment": unit(Quantity::Torque),
            },
            "iterations": self.found.iterations,
            "load_steps": self.found.load_steps,
            "relaxation_steps": self.found.relaxation_steps,
            "relative_residual": self.found.relative_residual,
            "smallest_stiffness_N_per_m": stiffness.is_finite().then_some(stiffness),
            "bodies": object(self.bodies(), ["displacement", "rotation"]),
            "joints": object(self.joints(), ["force", "moment"]),
            "drivers": channels(true),
            "force_elements": channels(false),
        });
        // A mechanism has no wheel, which is told, too.
        let none = wheels.is_empty().then(|| ("wheel".to_owned(), json!({})));
        if let Some(report) = report.as_object_mut() {
            report.extend(wheels.into_iter().chain(none));
        }
        report
    }

    /// The side of a wheel of an axle with what joins it to a word.
    fn side(&self, pose: &Pose<f64>, joint: &str) -> String {
        if self.poses.len() > 1 { format!("{}{joint}", pose.side.name()) } else { String::new() }
    }

    /// How the equilibrium was found, in a sentence.
    fn how(&self) -> String {
        let StaticReport { iterations, load_steps, relaxation_steps, relative_residual, stiffness } =
            *self.found;
        let steps = match (load_steps, relaxation_steps) {
            (_, 1..) => format!("{relaxation_steps} steps of viscous relaxation"),
            (0 | 1, _) => "one load step".to_owned(),
            (many, _) => format!("{many} load steps"),
        };
        let stable = if stiffness.is_finite() {
            let quantity = Quantity::Stiffness;
            let shown = quantity.show(self.units, stiffness);
            format!("; stable, smallest stiffness {shown:.4e} {}", quantity.symbol(self.units))
        } else {
            String::new()
        };
        format!(
            "static equilibrium after {iterations} Newton iterations in {steps}, relative residual {relative_residual:.1e}{stable}"
        )
    }

    fn bodies(&self) -> Vec<Line> {
        let mechanism = self.equilibrium.mechanism();
        let state = self.equilibrium.state();
        let bodies = mechanism.body_ids().skip(1);
        bodies
            .map(|id| {
                let (body, q) = (&mechanism.bodies()[id.index()], &state[id.index()]);
                let moved = self.axes.from_iso(sub([q[0], q[1], q[2]], body.origin));
                let turned = rotation_angles(self.axes.rotation_from_iso(rotation(state, id)));
                let lengths = moved.map(|x| Quantity::Length.show(self.units, x));
                let angles = turned.map(|x| Quantity::Angle.show(self.units, x));
                let [x, y, z] = self.axes.from_iso(body.origin).map(|x| {
                    let length = rounded(Quantity::Length.show(self.units, x));
                    format!("{length:.3}")
                });
                Line {
                    name: body.name.clone(),
                    note: format!("origin at ({x}, {y}, {z}) at design"),
                    values: [lengths, angles].concat(),
                }
            })
            .collect()
    }

    fn joints(&self) -> Vec<Line> {
        let mechanism = self.equilibrium.mechanism();
        let joints = mechanism.joints().iter().zip(self.equilibrium.reactions());
        joints
            .map(|(joint, reaction)| {
                let show = |quantity: Quantity, vector| {
                    self.axes.from_iso(vector).map(|x| quantity.show(self.units, x))
                };
                let force = show(Quantity::Force, reaction.on_j.force);
                let moment = show(Quantity::Torque, reaction.on_j.moment);
                let body = &mechanism.bodies()[joint.j.index()].name;
                let unique = if reaction.unique { "" } else { ", not unique: redundant" };
                Line {
                    name: joint.name.clone(),
                    note: format!("{} on {body}{unique}", joint.kind.name()),
                    values: [force, moment].concat(),
                }
            })
            .collect()
    }

    fn is_bushing(&self, channel: &Channel) -> bool {
        let forces = self.equilibrium.mechanism().forces();
        let force = channel.force().map(|force| &forces[force.index()].kind);
        matches!(force, Some(ForceKind::Bushing(_)))
    }

    /// What every bushing does in each of its six directions: deflections or forces. A direction
    /// without a law has none.
    fn bushings(&self, forces: bool) -> Vec<Line> {
        let mechanism = self.equilibrium.mechanism();
        let bushings = mechanism.force_ids().filter(|force| {
            matches!(mechanism.forces()[force.index()].kind, ForceKind::Bushing(_))
        });
        bushings
            .map(|id| {
                let force = &mechanism.forces()[id.index()];
                let names = match forces {
                    true => ["fx", "fy", "fz", "mx", "my", "mz"],
                    false => ["x", "y", "z", "rx", "ry", "rz"],
                };
                let value = |end: &str| {
                    let mut own = self.elements.iter().filter(|c| c.force() == Some(id));
                    // A number behind the name tells it from another part with this name.
                    let channel = own.find(|channel| {
                        let rest = channel.name[force.name.len() + 1..].strip_prefix(end);
                        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
                    });
                    channel.map_or(f64::NAN, |channel| self.element_value(channel))
                };
                let body = &mechanism.bodies()[force.j.index()].name;
                Line {
                    name: force.name.clone(),
                    note: format!("on {body}"),
                    values: names.map(value).to_vec(),
                }
            })
            .collect()
    }

    fn element_value(&self, channel: &Channel) -> f64 {
        let value = channel.value(&self.equilibrium.loaded(), &[], self.axes);
        channel.quantity.show(self.units, value)
    }
}

fn lines(
    writer: &mut impl io::Write,
    head: &str,
    names: [&str; 6],
    lines: &[Line],
) -> io::Result<()> {
    if lines.is_empty() {
        return Ok(());
    }
    writeln!(writer, "\n{head}")?;
    let width = lines.iter().map(|line| line.name.chars().count()).max().unwrap_or(0);
    let names: Vec<String> = names.iter().map(|name| format!("{name:>12}")).collect();
    writeln!(writer, "  {:<width$} {}", "", names.join(" "))?;
    for line in lines {
        let cell = |value: &f64| format!("{:>12}", cell(Some(*value).filter(|x| x.is_finite())));
        let values: Vec<String> = line.values.iter().map(cell).collect();
        let note = if line.note.is_empty() { String::new() } else { format!("  {}", line.note) };
        writeln!(writer, "  {:<width$} {}{note}", line.name, values.join(" "))?;
    }
    Ok(())
}
