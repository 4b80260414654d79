//! A text report in the order in which Lotus Suspension Analysis prints its tables, for direct comparison.

use std::io;

use super::table::cell_to;
use crate::factors::{Convention, Factor, find};
use crate::model::{Drive, Model, Quantity};
use crate::programme::Run;
use crate::rig::{Pose, Row};

/// What the report shows: an axle whose contact patches are driven.
#[derive(Clone, Copy)]
pub struct LotusReport<'a> {
    /// The model.
    pub model: &'a Model,
    /// Which height the travel means; Lotus drives the contact patch.
    pub drive: Drive,
    /// The left and the right wheel at the static position.
    pub poses: &'a [Pose<f64>; 2],
    /// Parallel wheel travel.
    pub bump: &'a Run,
    /// Roll about the static roll centre.
    pub roll: &'a Run,
    /// Steering by the rack, where there is one.
    pub steering: Option<&'a Run>,
}

/// A column: three lines of heading, a factor and its decimals.
type Column = ([&'static str; 2], &'static str, usize);

const STATIC: &[(&str, &str, usize)] = &[
    ("Camber angle", "camber", 4),
    ("Toe angle (SAE)", "toe", 4),
    ("Toe angle (wheel plane)", "toe_plane", 4),
    ("Castor angle", "caster", 2),
    ("Castor trail (hub)", "wheel_center_trail", 2),
    ("Castor offset", "trail_x", 2),
    ("Kingpin angle", "kpi", 2),
    ("Kingpin offset (wheel)", "kingpin_offset", 2),
    ("Kingpin offset (ground)", "scrub_y", 2),
    ("Mechanical trail", "mechanical_trail", 2),
    ("Roll centre height", "rc_height", 2),
];

const ANGLES: [Column; 4] = [
    (["camber", "angle"], "camber", 4),
    (["toe", "angle"], "toe", 4),
    (["castor", "angle"], "caster", 4),
    (["kingpin", "angle"], "kpi", 4),
];

const RATIOS: [Column; 2] = [
    (["damper", "ratio"], "damper_ratio_patch", 3),
    (["spring", "ratio"], "spring_ratio_patch", 3),
];

const ENDS: [Column; 4] = [
    (["half-track", "change"], "half_track_change", 2),
    (["wheelbase", "change"], "wheelbase_change", 2),
    (["damper", "travel"], "damper_travel", 2),
    (["spring", "travel"], "spring_travel", 2),
];

const OF_FRONT: [Column; 2] =
    [(["anti", "dive"], "anti_dive", 2), (["anti", "lift (drive)"], "anti_lift_drive", 2)];

const OF_REAR: [Column; 2] =
    [(["anti", "lift"], "anti_lift", 2), (["anti", "squat"], "anti_squat", 2)];

const BUMP_CENTER: [Column; 2] = [
    (["roll centre", "to body"], "rc_height_body", 2),
    (["roll centre", "to ground"], "rc_height", 2),
];

const ROLL_CENTER: [Column; 3] = [
    (["roll centre", "x"], "roll_center_x", 2),
    (["roll centre", "y"], "roll_center_y", 2),
    (["roll centre", "z"], "roll_center_z", 2),
];

impl LotusReport<'_> {
    /// Writes the report; a value that is not defined or that the model lacks is a dash.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write(&self, mut writer: impl io::Write) -> io::Result<()> {
        let (model, units) = (self.model, self.model.units);
        writeln!(writer, "SUSPENSION REPORT: {}", model.name)?;
        writeln!(
            writer,
            "axes {}; the {} is driven; definitions of Lotus\n",
            model.axes.name(),
            self.drive.words()
        )?;
        self.general(&mut writer)?;
        self.points(&mut writer)?;
        writeln!(writer, "STATIC VALUES{:>26}{:>12}", "left", "right")?;
        for (label, name, decimals) in STATIC {
            let Ok(factor) = find(name) else { continue };
            let [left, right] =
                self.poses.each_ref().map(|pose| self.show(factor, pose, *decimals));
            let symbol = factor.quantity.symbol(units);
            writeln!(writer, "  {label:<25}{left:>12}{right:>12} {symbol}")?;
        }
        let rear = self.model.vehicle.axle == Some(crate::model::Axle::Rear);
        let anti = if rear { OF_REAR } else { OF_FRONT };
        let bump = [&ANGLES[..], &RATIOS, &anti, &BUMP_CENTER, &ENDS].concat();
        let roll = [&ANGLES[..], &RATIOS, &ROLL_CENTER, &ENDS].concat();
        for (wheel, side) in ["LEFT", "RIGHT"].into_iter().enumerate() {
            let title = format!("BUMP, {side} WHEEL (+ bump is up)");
            self.table(&mut writer, &title, "bump", self.bump, wheel, &bump)?;
        }
        for (wheel, side) in ["LEFT", "RIGHT"].into_iter().enumerate() {
            let title = format!(
                "ROLL, {side} WHEEL (in ground axes; + right-handed about the x axis of the model)"
            );
            self.table(&mut writer, &title, "roll", self.roll, wheel, &roll)?;
        }
        self.steering(&mut writer)
    }

    fn show(&self, factor: &Factor, pose: &Pose<f64>, decimals: usize) -> String {
        cell_to(factor.show_by(Convention::Lotus, self.model.units, pose), decimals)
    }

    fn general(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let (vehicle, units) = (&self.model.vehicle, self.model.units);
        let length = |metres: Option<f64>| cell_to(metres.map(|m| units.length.from_metres(m)), 2);
        let percent = |share: Option<f64>| cell_to(share.map(|share| 100.0 * share), 1);
        let symbol = units.length.symbol();
        writeln!(writer, "GENERAL DATA")?;
        let radius = Some(self.model.wheel_radius);
        for (label, value, unit) in [
            ("Axle", vehicle.axle.map_or("–".to_owned(), |axle| axle.name().to_owned()), ""),
            ("Wheelbase", length(vehicle.wheelbase), symbol),
            ("C of G height", length(vehicle.cg_height), symbol),
            ("Braking on this axle", percent(vehicle.brake_share), "%"),
            ("Drive on this axle", percent(vehicle.drive_share), "%"),
            ("Tyre rolling radius", length(radius), symbol),
        ] {
            writeln!(writer, "  {label:<25}{value:>12} {unit}")?;
        }
        writeln!(writer)
    }

    /// The points of the file, and those of the other side where that is a file of its own.
    fn points(&self, writer: &mut impl io::Write) -> io::Result<()> {
        self.points_of(self.model, writer)?;
        if self.model.has_other_side() {
            self.points_of(&self.model.other_side(), writer)?;
        }
        Ok(())
    }

    fn points_of(&self, model: &Model, writer: &mut impl io::Write) -> io::Result<()> {
        // Both in the units and axes of the file that is read.
        let Model { axes, units, .. } = *self.model;
        let side = model.side.name();
        writeln!(writer, "HARD POINTS, {side} side{:>22}{:>12}{:>12}", "x", "y", "z")?;
        for point in model.points() {
            let at = axes.from_iso(point.position).map(|c| units.length.from_metres(c));
            let [x, y, z] = at.map(|c| cell_to(Some(c), 3));
            writeln!(
                writer,
                "  {:<25}{x:>12}{y:>12}{z:>12} {}",
                point.name,
                units.length.symbol()
            )?;
        }
        writeln!(writer)
    }

    fn table(
        &self,
        writer: &mut impl io::Write,
        title: &str,
        input: &str,
        run: &Run,
        wheel: usize,
        columns: &[Column],
    ) -> io::Result<()> {
        let quantity = self.quantity(run);
        let mut heads = vec![[input.to_owned(), String::new(), quantity.symbol(self.model.units)]];
        let mut factors = vec![];
        for (head, name, decimals) in columns {
            let Ok(factor) = find(name) else { continue };
            let [first, second] = head.map(str::to_owned);
            heads.push([first, second, factor.quantity.symbol(self.model.units)]);
            factors.push((factor, *decimals));
        }
        let line = |row: &Row| {
            let value = self.value(quantity, row);
            let pose = row.poses.get(wheel);
            let cells = factors.iter().map(|(factor, decimals)| {
                pose.map_or("–".to_owned(), |pose| self.show(factor, pose, *decimals))
            });
            std::iter::once(value).chain(cells).collect()
        };
        let rows: Vec<Vec<String>> = run.sweep.rows.iter().map(line).collect();
        write_columns(writer, title, &heads, &rows)?;
        stops(writer, run)
    }

    /// Steering shows both wheels beside each other.
    fn steering(&self, writer: &mut impl io::Write) -> io::Result<()> {
        let Some(run) = self.steering else { return Ok(()) };
        const COLUMNS: &[(&str, &str, usize, usize)] = &[
            ("right", "toe", 1, 4),
            ("left", "toe", 0, 4),
            ("right", "camber", 1, 4),
            ("left", "camber", 0, 4),
            ("", "ackermann", 0, 2),
            ("", "turning_radius", 0, 2),
        ];
        let (units, quantity) = (self.model.units, self.quantity(run));
        let mut heads = vec![["rack".to_owned(), "travel".to_owned(), quantity.symbol(units)]];
        for (side, name, ..) in COLUMNS {
            let Ok(factor) = find(name) else { continue };
            let name = name.replace('_', " ");
            heads.push([name, (*side).to_owned(), factor.quantity.symbol(units)]);
        }
        let line = |row: &Row| {
            let cells = COLUMNS.iter().filter_map(|(_, name, wheel, decimals)| {
                let factor = find(name).ok()?;
                Some(
                    row.poses
                        .get(*wheel)
                        .map_or("–".to_owned(), |pose| self.show(factor, pose, *decimals)),
                )
            });
            std::iter::once(self.value(quantity, row)).chain(cells).collect()
        };
        let rows: Vec<Vec<String>> = run.sweep.rows.iter().map(line).collect();
        let title = "STEERING (rack + along the model's y axis; toe + toe-in)";
        write_columns(writer, title, &heads, &rows)?;
        stops(writer, run)
    }

    fn quantity(&self, run: &Run) -> Quantity {
        match run.plan.event {
            crate::rig::Event::Roll => Quantity::Angle,
            _ => Quantity::Length,
        }
    }

    fn value(&self, quantity: Quantity, row: &Row) -> String {
        cell_to(Some(quantity.show(self.model.units, row.value)), 2)
    }
}

fn write_columns(
    writer: &mut impl io::Write,
    title: &str,
    heads: &[[String; 3]],
    rows: &[Vec<String>],
) -> io::Result<()> {
    writeln!(writer, "\n{title}")?;
    let widths: Vec<usize> = (0..heads.len())
        .map(|k| {
            let cells = rows.iter().map(|row| row[k].chars().count());
            cells.chain(heads[k].iter().map(|head| head.chars().count())).max().unwrap_or(0)
        })
        .collect();
    let mut line = |fields: &mut dyn Iterator<Item = &String>| {
        let padded: Vec<String> =
            fields.zip(&widths).map(|(field, width)| format!("{field:>width$}")).collect();
        writeln!(writer, "  {}", padded.join("  ").trim_end())
    };
    for k in 0..3 {
        line(&mut heads.iter().map(|head| &head[k]))?;
    }
    for row in rows {
        line(&mut row.iter())?;
    }
    Ok(())
}

/// States that were not reached are told, not left out in silence.
fn stops(writer: &mut impl io::Write, run: &Run) -> io::Result<()> {
    for stop in &run.sweep.stops {
        writeln!(writer, "  stopped: {stop}")?;
    }
    Ok(())
}
