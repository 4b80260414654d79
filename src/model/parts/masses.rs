//! Masses, inertias and gravity.

use std::ops::Range;

use toml::Spanned;

use super::Parts;
use crate::mechanism::{InitialVelocity, MassProperties};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

impl Parts<'_> {
    /// The mass, centre of mass and inertia tensor of a section of a body.
    pub(crate) fn mass(
        &self,
        section: &mut Section,
        report: &mut Report,
    ) -> Option<MassProperties> {
        let mass =
            self.number(section, "mass", Quantity::Mass, "write its mass: `mass = 4.2`", report);
        let help = "write where it is at the design position: `center_of_mass = [x, y, z]`";
        let center = section.required::<[f64; 3]>("center_of_mass", help, report);
        let help = "write the moments about the centre of mass, `inertia = [Jxx, Jyy, Jzz]`, or all zero for a point mass";
        let inertia = section.required::<Vec<f64>>("inertia", help, report);
        let center = center.map(|center| self.vector(&center, Quantity::Length, report));
        let inertia = inertia.and_then(|inertia| self.inertia(&inertia, report));
        Some(MassProperties { mass: mass?.into_inner(), center: center?, inertia: inertia? })
    }

    /// Three moments of inertia, or with three products; in axes that differ by signs the products
    /// change theirs.
    fn inertia(&self, numbers: &Spanned<Vec<f64>>, report: &mut Report) -> Option<[f64; 6]> {
        let [x, y, z] = self.axes.signs();
        let signs = [1.0, 1.0, 1.0, x * y, x * z, y * z];
        let mut tensor = [0.0; 6];
        let given = numbers.get_ref();
        if given.len() != 3 && given.len() != 6 {
            let message = format!("`inertia` must be three or six numbers, not {}", given.len());
            report
                .mistake(&numbers.span(), message, format!("{} values here", given.len()))
                .help("write `[Jxx, Jyy, Jzz]` or `[Jxx, Jyy, Jzz, Jxy, Jxz, Jyz]`");
            return None;
        }
        for (k, number) in given.iter().enumerate() {
            let number = self.units.to_si(Quantity::Inertia, *number, &numbers.span(), report);
            tensor[k] = signs[k] * number + 0.0;
        }
        Some(tensor)
    }

    /// How a body moves at the start of dynamics; it rests where nothing is said.
    pub(crate) fn initial_velocity(
        &self,
        section: &mut Section,
        report: &mut Report,
    ) -> InitialVelocity {
        let mut vector = |key, quantity| {
            let numbers = section.optional::<[f64; 3]>(key, report);
            numbers.map_or([0.0; 3], |numbers| self.vector(&numbers, quantity, report))
        };
        InitialVelocity {
            velocity: vector("velocity", Quantity::Velocity),
            rotation: vector("angular_velocity", Quantity::AngularVelocity),
        }
    }
}

/// What to write for gravity.
const GRAVITY: &str = "masses need it: write `gravity = 9.81`, in m/s² and downward, or 0 for none";

const DOWNWARD: &str = "a positive number is downward: write `gravity = 9.81`";

/// Gravity (m/s², positive downward); it must be there where something has a mass.
pub(crate) fn gravity(
    root: &mut Section,
    mass: Option<&Range<usize>>,
    report: &mut Report,
) -> Option<f64> {
    if missing_gravity(root, mass, report) {
        return None;
    }
    match root.optional::<f64>("gravity", report) {
        Some(gravity) => super::not_negative(&gravity, "gravity", DOWNWARD, report),
        None => (!root.has("gravity")).then_some(0.0),
    }
}

/// Gravity of a mechanism (m/s²): a vector, or a number for one along −z.
pub(crate) fn gravity_vector(
    root: &mut Section,
    mass: Option<&Range<usize>>,
    report: &mut Report,
) -> Option<[f64; 3]> {
    if root.value("gravity").is_some_and(|value| value.get_ref().is_array()) {
        return root.optional::<[f64; 3]>("gravity", report).map(Spanned::into_inner);
    }
    gravity(root, mass, report).map(|down| [0.0, 0.0, 0.0 - down])
}

fn missing_gravity(root: &mut Section, mass: Option<&Range<usize>>, report: &mut Report) -> bool {
    let Some(mass) = mass.filter(|_| root.value("gravity").is_none()) else {
        return false;
    };
    report.mistake(mass, "`gravity` is missing", "has a mass").help(GRAVITY);
    true
}
