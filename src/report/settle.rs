//! Dynamics that settles beside the quasi-static equilibrium: the table of the method paper's Fig. 5.

use std::io;

use serde_json::{Value, json};

use super::rounded;
use crate::model::{Quantity, Units};
use crate::solve::StaticReport;
use crate::solve::dynamics::{DynamicsReport, Energy, StartReport};

/// One quantity after dynamics and in quasi-static equilibrium (SI).
#[derive(Clone, Debug, PartialEq)]
pub struct SettleRow {
    /// What it is.
    pub title: String,
    /// Its kind.
    pub quantity: Quantity,
    /// A: at the end of the motion.
    pub dynamic: f64,
    /// B: in equilibrium; `None` where there is none.
    pub quasi_static: Option<f64>,
}

/// A motion, its end, and the equilibrium that it should end in.
#[derive(Clone, Copy)]
pub struct SettleReport<'a> {
    /// Name of the model, with what was asked for.
    pub title: &'a str,
    /// Units of the report.
    pub units: Units,
    /// The time of the end (s).
    pub seconds: f64,
    /// The table.
    pub rows: &'a [SettleRow],
    /// What the integration has done.
    pub motion: &'a DynamicsReport,
    /// The energies at the end.
    pub energy: Energy,
    /// The largest speed at the end (m/s).
    pub speed: f64,
    /// How the initial velocities fit the joints.
    pub start: &'a StartReport,
    /// How the equilibrium was found, or why there is none.
    pub equilibrium: Result<&'a StaticReport, &'a str>,
}

/// A speed below this (m/s) is rest.
const REST: f64 = 1e-4;

impl SettleReport<'_> {
    /// Writes the table and how it came about.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_text(&self, mut writer: impl io::Write) -> io::Result<()> {
        let seconds = self.seconds;
        writeln!(writer, "{}", self.title)?;
        writeln!(writer)?;
        let width = self.rows.iter().map(|row| row.title.chars().count()).max().unwrap_or(0);
        writeln!(
            writer,
            "{:<width$} {:>6} {:>18} {:>18} {:>12}",
            "", "", "A dynamic", "B quasi-static", "B − A"
        )?;
        for row in self.rows {
            let show = |value: f64| row.quantity.show(self.units, value);
            let unit = row.quantity.symbol(self.units);
            let a = rounded(show(row.dynamic));
            let (b, difference) = match row.quasi_static {
                Some(b) => {
                    let difference = show(b - row.dynamic);
                    (format!("{:.9}", rounded(show(b))), format!("{difference:.2e}"))
                }
                None => ("–".to_owned(), "–".to_owned()),
            };
            writeln!(writer, "{:<width$} {unit:>6} {a:>18.9} {b:>18} {difference:>12}", row.title)?;
        }
        writeln!(writer)?;
        for (what, value) in self.facts() {
            writeln!(writer, "{what:<26} {value}")?;
        }
        match self.equilibrium {
            Ok(_) if self.speed > REST => writeln!(
                writer,
                "\nnot at rest after {seconds} s: the largest speed is {:.2e} m/s, so B − A says little; \
                 give it more --seconds, or the model more damping",
                self.speed
            ),
            Ok(_) => Ok(()),
            Err(failure) => writeln!(writer, "\nno quasi-static equilibrium: {failure}"),
        }
    }

    /// What is known of the motion, in words.
    fn facts(&self) -> Vec<(&'static str, String)> {
        let (motion, energy) = (self.motion, self.energy);
        let steps = if motion.largest_step - motion.smallest_step <= 1e-9 * motion.largest_step {
            format!("{} of {:.4e} s", motion.steps, motion.largest_step)
        } else {
            let (smallest, largest) = (motion.smallest_step, motion.largest_step);
            format!(
                "{} of {smallest:.2e} … {largest:.2e} s, {} rejected",
                motion.steps, motion.rejected
            )
        };
        let mut facts = vec![
            ("time", format!("{} s", self.seconds)),
            ("steps", steps),
            ("Newton iterations", motion.iterations.to_string()),
            ("largest speed at the end", format!("{:.2e} m/s", self.speed)),
            ("kinetic energy", format!("{:.6e} J", energy.kinetic)),
            ("potential energy", format!("{:.6e} J", energy.potential)),
            ("work of other forces", format!("{:.6e} J, − is dissipated", energy.work)),
            (
                "drift of the energy",
                format!(
                    "{:.2e} J at most; the largest kinetic energy was {:.2e} J",
                    motion.energy_drift, motion.largest_kinetic
                ),
            ),
            (
                "drift of the constraints",
                format!(
                    "{:.1e} in position, {:.1e} 1/s in velocity, relative",
                    motion.position_drift, motion.velocity_drift
                ),
            ),
        ];
        if self.start.contradicts {
            facts.push((
                "initial velocities",
                format!(
                    "changed to fit the joints, most for {}: {:.3e} m/s and {:.3e} rad/s",
                    self.start.body, self.start.velocity_change, self.start.rotation_change
                ),
            ));
        }
        facts
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
        let rows: Vec<Value> = self
            .rows
            .iter()
            .map(|row| {
                let show = |value: f64| rounded(row.quantity.show(self.units, value));
                json!({
                    "quantity": row.title,
                    "unit": row.quantity.symbol(self.units),
                    "dynamic": show(row.dynamic),
                    "quasi_static": row.quasi_static.map(show),
                    "difference": row.quasi_static.map(|b| show(b - row.dynamic)),
                })
            })
            .collect();
        let (motion, energy) = (self.motion, self.energy);
        json!({
            "title": self.title,
            "seconds": self.seconds,
            "rows": rows,
            "steps": motion.steps,
            "rejected_steps": motion.rejected,
            "smallest_step_s": motion.smallest_step,
            "largest_step_s": motion.largest_step,
            "newton_iterations": motion.iterations,
            "largest_speed_m_per_s": self.speed,
            "kinetic_energy_J": energy.kinetic,
            "potential_energy_J": energy.potential,
            "work_of_other_forces_J": energy.work,
            "energy_drift_J": motion.energy_drift,
            "position_drift": motion.position_drift,
            "velocity_drift_per_s": motion.velocity_drift,
            "initial_velocities_changed": self.start.contradicts,
            "no_equilibrium": self.equilibrium.err(),
        })
    }
}
