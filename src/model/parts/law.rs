//! Force laws: numbers in proportion, or tables.

use toml::Spanned;

use super::Parts;
use crate::mechanism::{Curve, MechanismError, Spline};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

/// What a law is a function of, and what it gives.
#[derive(Clone, Copy)]
pub(super) struct Axis {
    /// The first column of a table.
    pub(super) value: Quantity,
    /// The second.
    pub(super) force: Quantity,
    /// Their ratio.
    pub(super) stiffness: Quantity,
    /// Whether a table may not have forces below zero.
    pub(super) pushes_only: bool,
}

pub(super) const LENGTH: Axis = Axis {
    value: Quantity::Length,
    force: Quantity::Force,
    stiffness: Quantity::Stiffness,
    pushes_only: false,
};

/// A stop pushes back and does nothing else.
pub(super) const STOP: Axis = Axis { pushes_only: true, ..LENGTH };

pub(super) const ANGLE: Axis = Axis {
    value: Quantity::Angle,
    force: Quantity::Torque,
    stiffness: Quantity::RotationalStiffness,
    pushes_only: false,
};

pub(super) const SPEED: Axis = Axis {
    value: Quantity::Velocity,
    force: Quantity::Force,
    stiffness: Quantity::Damping,
    pushes_only: false,
};

impl Parts<'_> {
    /// `stiffness` or `table`: the curve with the signs of the file. `columns` names those of the table.
    pub(super) fn elastic(
        &self,
        section: &mut Section,
        name: &str,
        axis: Axis,
        columns: &str,
        report: &mut Report,
    ) -> Option<Curve> {
        self.linear_or_table(section, ["stiffness", "table"], name, axis, columns, report)
    }

    /// One number or a table, of which exactly one has to be there.
    pub(super) fn linear_or_table(
        &self,
        section: &mut Section,
        [number, table]: [&'static str; 2],
        name: &str,
        axis: Axis,
        columns: &str,
        report: &mut Report,
    ) -> Option<Curve> {
        let help = format!("give one number, `{number} = …`, or `{table} = [[{columns}], …]`");
        if section.one_of(&[number, table], &help, report)? == number {
            let factor = self.number(section, number, axis.stiffness, &help, report)?;
            return Some(Curve::linear(factor.into_inner()));
        }
        let rows = section.required(table, &help, report)?;
        self.table(&rows, name, axis, report)
    }

    /// A table; `name` is that of its force element.
    pub(super) fn table(
        &self,
        rows: &Spanned<Vec<Spanned<[f64; 2]>>>,
        name: &str,
        axis: Axis,
        report: &mut Report,
    ) -> Option<Curve> {
        let pulls = |row: &&Spanned<[f64; 2]>| axis.pushes_only && row.get_ref()[1] < 0.0;
        if let Some(row) = rows.get_ref().iter().find(pulls) {
            report
                .mistake(&row.span(), format!("`{name}` has a force below zero"), "this row")
                .help("a stop only pushes back: write forces that are not negative");
            return None;
        }
        let points = rows.get_ref().iter().map(|row| {
            let ([x, y], span) = (*row.get_ref(), row.span());
            [(axis.value, x), (axis.force, y)].map(|(q, v)| self.units.to_si(q, v, &span, report))
        });
        let points = points.collect();
        match Spline::new(name, points) {
            Ok(spline) => Some(Curve::Table(spline)),
            Err(MechanismError::Table { row, problem, .. }) => {
                let wrong =
                    rows.get_ref().get(row.wrapping_sub(1)).filter(|_| rows.get_ref().len() > 1);
                let (span, label) = match wrong {
                    Some(wrong) => (wrong.span(), format!("row {row}")),
                    None => (rows.span(), "this table".to_owned()),
                };
                report
                    .mistake(&span, format!("the table of `{name}` is wrong: {problem}"), label)
                    .help("write at least two rows, the first column from small to large");
                None
            }
            Err(_) => None,
        }
    }
}

/// The only value at which a curve gives a force, or why there is none.
pub(super) fn inverse(curve: &Curve, force: f64) -> Result<f64, &'static str> {
    const NONE: &str = "it never has this force";
    let spline = match curve {
        Curve::Zero => return if force == 0.0 { Ok(0.0) } else { Err(NONE) },
        Curve::Linear(factor) => return Ok(force / factor),
        Curve::Table(spline) => spline,
    };
    let points = spline.points();
    let (first, last) = (points[0], points[points.len() - 1]);
    let beyond = |[x, y]: [f64; 2]| x + (force - y) / spline.at(x).first;
    // A value at the end of one row and the start of the next counts once.
    let crosses = |y0: f64, y1: f64| (y0 <= force && force < y1) || (y0 >= force && force > y1);
    let mut found: Vec<f64> = vec![];
    found.extend(Some(beyond(first)).filter(|x| *x < first[0] && x.is_finite()));
    let pairs = points.windows(2).filter(|pair| crosses(pair[0][1], pair[1][1]));
    found.extend(pairs.map(|pair| bisect(|x| spline.at(x).value - force, pair[0][0], pair[1][0])));
    let after = if last[1] == force { last[0] } else { beyond(last) };
    found.extend(Some(after).filter(|x| *x >= last[0] && x.is_finite()));
    match found[..] {
        [] => Err(NONE),
        [one] => Ok(one),
        _ => Err("it has this force more than once"),
    }
}

/// A zero between two values at which the function has different signs.
fn bisect(function: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    let at_a = function(a);
    if at_a == 0.0 {
        return a;
    }
    loop {
        let middle = 0.5 * (a + b);
        if middle <= a || middle >= b {
            return middle;
        }
        if (function(middle) > 0.0) == (at_a > 0.0) {
            a = middle;
        } else {
            b = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_is_found_inside_and_beyond_a_table() {
        let rows = vec![[0.0, 0.0], [0.01, 500.0], [0.02, 1500.0], [0.03, 4000.0]];
        let curve = Curve::Table(Spline::new("spring", rows).unwrap());
        for force in [-300.0, 0.0, 1.0, 500.0, 777.0, 1500.0, 3999.0, 4000.0, 9000.0] {
            let x = inverse(&curve, force).unwrap();
            assert!((curve.at(x).value - force).abs() < 1e-9, "{force}: {x}");
        }
        assert_eq!(inverse(&Curve::Linear(2.0), 3.0), Ok(1.5));
        assert!(inverse(&Curve::Zero, 1.0).is_err());
        let hill =
            Curve::Table(Spline::new("x", vec![[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]).unwrap());
        assert!(inverse(&hill, 0.5).is_err() && inverse(&hill, 3.0).is_err());
        let level = Curve::Table(Spline::new("x", vec![[0.0, 0.0], [1.0, 0.0]]).unwrap());
        assert!(inverse(&level, -1.0).is_err() && inverse(&level, 1.0).is_err());
    }
}
