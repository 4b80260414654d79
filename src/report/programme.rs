//! What the standard programme found, on one page.

use std::io;

use super::adjustments::write_adjustments;
use super::rounded;
use super::table::cell;
use crate::factors::{Convention, FACTORS, Factor, Subject};
use crate::model::{Drive, Model};
use crate::programme::Stage;
use crate::rig::{Adjustment, Pose};

/// What came of one stage.
#[derive(Clone, Debug, PartialEq)]
pub struct StageResult {
    /// The stage.
    pub stage: Stage,
    /// The name of the file with its states, where there is one.
    pub file: Option<String>,
    /// States reached.
    pub reached: usize,
    /// Newton iterations of all states.
    pub iterations: usize,
    /// Where it stopped, or why it did not begin.
    pub notes: Vec<String>,
    /// Dead centres that it came near to or passed.
    pub warnings: Vec<String>,
}

/// The page.
#[derive(Clone, Copy)]
pub struct ProgrammeSummary<'a> {
    /// The model.
    pub model: &'a Model,
    /// Which height the travel means.
    pub drive: Drive,
    /// By whose definitions.
    pub convention: Convention,
    /// The left and the right wheel at the static position.
    pub poses: &'a [Pose<f64>; 2],
    /// What the adjusters of the model are set to.
    pub adjustments: &'a [Adjustment],
    /// The stages.
    pub stages: &'a [StageResult],
}

/// What coordinates and velocities say is in the sheet of all factors.
const IN_DETAIL: [Subject; 3] = [Subject::Place, Subject::VirtualAxis, Subject::VirtualAxisSpring];

impl ProgrammeSummary<'_> {
    /// Writes the stages with their states, and the factors of the static position with unit and sign.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write(&self, mut writer: impl io::Write) -> io::Result<()> {
        let (model, units) = (self.model, self.model.units);
        writeln!(
            writer,
            "{}: standard programme of the rig, both wheels\n{} axes, definitions of {}, {} driven\n",
            model.name,
            model.axes.name(),
            self.convention.name(),
            self.drive.words()
        )?;
        for result in self.stages {
            let StageResult { stage, file, reached, iterations, notes, warnings } = result;
            let range = cell(Some(rounded(stage.quantity.show(units, stage.range))));
            let symbol = stage.quantity.symbol(units);
            let file = file.as_deref().unwrap_or("–");
            writeln!(
                writer,
                "{file:<26} {reached:>4} of {:<4} states {iterations:>5} Newton iterations  {}, ±{range} {symbol}",
                stage.states(),
                stage.title
            )?;
            for note in notes.iter().chain(warnings) {
                writeln!(writer, "    {}", note.trim_end().replace('\n', "\n    "))?;
            }
        }
        let reached: usize = self.stages.iter().map(|result| result.reached).sum();
        writeln!(writer, "{:<26} {reached:>4} states in all", "")?;
        write_adjustments(&mut writer, units, self.adjustments)?;
        self.factors(&mut writer)
    }

    fn factors(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let shown = |factor: &&Factor| {
            !IN_DETAIL.contains(&factor.subject)
                && self.poses.iter().any(|pose| factor.value(self.convention, pose).is_some())
        };
        let width = FACTORS.iter().filter(shown).map(|factor| factor.name.len()).max().unwrap_or(0);
        writeln!(
            writer,
            "\n{:<width$}   {:>13} {:>13}",
            "At the static position", "left", "right"
        )?;
        let mut subject = None;
        for factor in FACTORS.iter().filter(shown) {
            if subject.replace(factor.subject) != Some(factor.subject) {
                writeln!(writer, "\n{}", factor.subject.title())?;
            }
            let value = |pose| cell(factor.show_by(self.convention, self.model.units, pose));
            let [left, right] = self.poses.each_ref().map(value);
            let right = if factor.is_of_axle() { String::new() } else { right };
            let (name, symbol) = (factor.name, factor.quantity.symbol(self.model.units));
            let sign = factor.by(self.convention).sign;
            writeln!(
                writer,
                "  {name:<width$} {left:>13} {right:>13} {symbol:<6} {}; {sign}",
                factor.title
            )?;
        }
        Ok(())
    }
}
