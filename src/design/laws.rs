//! The numbers of force elements that a designer can change, with the names and signs of the model file.

use super::parameter::{AXES, Kind, Parameter};
use crate::mechanism::{Acts, Bushing, Curve, Force, ForceKind, Law, LawConstant, Reference};
use crate::model::Quantity;

/// A number of a law, as the file writes it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LawNumber {
    /// The force element.
    pub force: String,
    /// Which of its laws.
    pub part: usize,
    /// The constant of the law of the model's own side.
    pub constant: LawConstant,
    /// The change of the constant by that of the number in the file.
    pub factor: f64,
    /// The rows of the table, if the law of the other side is the reversed one.
    pub reversed: Option<usize>,
}

impl LawNumber {
    /// A number that is the constant itself, on both sides.
    pub fn plain(force: &str, constant: LawConstant) -> Self {
        Self { force: force.to_owned(), part: 0, constant, factor: 1.0, reversed: None }
    }

    /// The constant of the mirror image and how it changes with the number.
    pub fn image(&self) -> (LawConstant, f64) {
        match (self.reversed, self.constant) {
            (Some(_), LawConstant::Preload) => (LawConstant::Preload, -self.factor),
            (Some(rows), LawConstant::Row(row)) => (LawConstant::Row(rows - 1 - row), -self.factor),
            (_, constant) => (constant, self.factor),
        }
    }
}

/// How the file writes a law.
struct Written<'a> {
    law: &'a Law,
    part: usize,
    turns: bool,
    /// Whether the law is that of the file reversed, as that of a spring is, which the file gives by compression.
    by_compression: bool,
    /// Whether the law of the other side is the reversed one.
    reverses: bool,
    /// What a positive preload of the file means; it has none where this is `None`.
    preload: Option<&'static str>,
}

impl Parameter {
    /// The numbers of a force element in a section of the file.
    pub(super) fn of_force(section: &str, force: &Force) -> Vec<Self> {
        // The element of a fitting, of which there is one, is called like its section.
        let name = |of: &str| match section {
            "" => format!("{}.{of}", force.name),
            _ => format!("{section}.{}.{of}", force.name),
        };
        match &force.kind {
            ForceKind::Line { reference, law, .. } => of_line(force, *reference, law, name),
            ForceKind::Slide { law, .. } => {
                let written = Written {
                    law,
                    part: 0,
                    turns: false,
                    by_compression: false,
                    reverses: true,
                    preload: None,
                };
                written.numbers(force, name)
            }
            ForceKind::Torsion { law, .. } => {
                let written = Written {
                    law,
                    part: 0,
                    turns: true,
                    by_compression: false,
                    reverses: false,
                    preload: Some("+ turns the second body right-handed about the axis"),
                };
                written.numbers(force, name)
            }
            ForceKind::Bushing(bushing) => of_bushing(force, bushing, name),
            _ => vec![],
        }
    }
}

fn of_line(
    force: &Force,
    reference: Reference,
    law: &Law,
    name: impl Fn(&str) -> String,
) -> Vec<Parameter> {
    let of = Parameter::new;
    if law.elastic == Curve::Zero {
        let constant = LawNumber::plain(&force.name, LawConstant::Preload);
        let pull =
            of(name("force"), Quantity::Force, "+ pulls the ends together", Kind::Law(constant));
        // A damper has no force at rest.
        return if law.viscous == Curve::Zero { vec![pull] } else { vec![] };
    }
    let written = Written {
        law,
        part: 0,
        turns: false,
        by_compression: law.acts != Acts::Above,
        reverses: false,
        preload: (law.acts == Acts::Always).then_some("+ pushes the ends apart"),
    };
    let mut list = written.numbers(force, &name);
    let length = |factor| Kind::Length { force: force.name.clone(), factor };
    let free = || of(name("free_length"), Quantity::Length, "+ longer spring", length(1.0));
    let clearance = |factor| {
        of(name("clearance"), Quantity::Length, "+ the stop touches later", length(factor))
    };
    list.push(match (law.acts, reference) {
        (Acts::Always, _) | (_, Reference::Length(_)) => free(),
        (Acts::Below, Reference::Design(_)) => clearance(-1.0),
        (Acts::Above, Reference::Design(_)) => clearance(1.0),
    });
    list
}

/// The six laws of a bushing; those of a kind that is all zero are not in the mechanism.
fn of_bushing(force: &Force, bushing: &Bushing, name: impl Fn(&str) -> String) -> Vec<Parameter> {
    let mut list = vec![];
    let mut first = 0;
    for (laws, turns) in [(&bushing.translation, false), (&bushing.rotation, true)] {
        if laws.iter().all(Law::is_zero) {
            continue;
        }
        for (axis, law) in laws.iter().enumerate() {
            let written = Written {
                law,
                part: first + axis,
                turns,
                by_compression: false,
                // Displacement along y and rotation about x and z change their signs in the mirror image.
                reverses: turns != (axis == 1),
                preload: Some("+ on the second body"),
            };
            let (before, component) = if turns { ("rotational_", "r") } else { ("", "") };
            let axis = AXES[axis];
            list.extend(written.numbers(force, |of: &str| match of.strip_prefix("table.") {
                Some(row) => name(&format!("table.{component}{axis}.{row}")),
                None => name(&format!("{before}{of}.{axis}")),
            }));
        }
        first += laws.len();
    }
    list
}

impl Written<'_> {
    fn numbers(&self, force: &Force, name: impl Fn(&str) -> String) -> Vec<Parameter> {
        let Self { law, part, turns, by_compression, reverses, preload } = *self;
        let (size, stiffness) = match turns {
            false => (Quantity::Force, Quantity::Stiffness),
            true => (Quantity::Torque, Quantity::RotationalStiffness),
        };
        let rows = match &law.elastic {
            Curve::Table(spline) => spline.points().len(),
            _ => 0,
        };
        let make = |of: &str, quantity, sign, constant, factor| {
            let reversed = reverses.then_some(rows);
            let number = LawNumber { force: force.name.clone(), part, constant, factor, reversed };
            Parameter::new(name(of), quantity, sign, Kind::Law(number))
        };
        let mut list = vec![];
        match &law.elastic {
            Curve::Zero => {}
            Curve::Linear(value) => {
                let made = make("stiffness", stiffness, "+ stiffer", LawConstant::Stiffness, 1.0);
                list.push(made.compared_by(0.01 * value.abs()));
            }
            Curve::Table(_) => {
                let sign = "+ stiffer: a factor of all forces of the table";
                list.push(make("scale", Quantity::Ratio, sign, LawConstant::Stiffness, 1.0));
                for row in 0..rows {
                    let (constant, factor) = match by_compression {
                        true => (LawConstant::Row(rows - 1 - row), -1.0),
                        false => (LawConstant::Row(row), 1.0),
                    };
                    let of = format!("table.{}", row + 1);
                    list.push(make(&of, size, "+ as in the table", constant, factor));
                }
            }
        }
        if let (false, Some(sign)) = (law.elastic == Curve::Zero, preload) {
            list.push(make("preload", size, sign, LawConstant::Preload, -1.0));
        }
        list
    }
}
