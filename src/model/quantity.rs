//! Kinds of quantities and their units: force and mass, and what follows from them.

use super::units::Units;

/// A kind of quantity; the units of a file say how it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A length, in m inside.
    Length,
    /// An angle, in rad inside.
    Angle,
    /// A force, in N inside.
    Force,
    /// A mass, in kg inside.
    Mass,
    /// A moment, in N·m inside.
    Torque,
    /// Force by length, in N/m inside.
    Stiffness,
    /// Force by speed, in N·s/m inside.
    Damping,
    /// Moment by angle, in N·m/rad inside.
    RotationalStiffness,
    /// Moment by angular speed, in N·m·s/rad inside.
    RotationalDamping,
    /// Moment of inertia, in kg·m² inside.
    Inertia,
    /// Speed, in m/s inside.
    Velocity,
    /// Angular speed, in rad/s inside.
    AngularVelocity,
    /// Acceleration, in m/s² inside.
    Acceleration,
    /// Angular acceleration, in rad/s² inside.
    AngularAcceleration,
    /// Time, always in s.
    Time,
    /// A number without dimension.
    Ratio,
    /// A number without dimension, shown as a percentage.
    Percent,
    /// Angle by length, in rad/m inside. It is shown per metre, whatever the unit of length, as
    /// suspension engineers do.
    Gradient,
    /// Way along a screw axis by angle, in m/rad inside.
    Pitch,
    /// Angle by force, in rad/N inside; shown per kN in every model, as all that follow are in the units that
    /// test rigs print.
    AngleByForce,
    /// Length by force, in m/N inside, shown per kN.
    LengthByForce,
    /// Angle by moment, in rad/(N·m) inside, shown per kN·m.
    AngleByTorque,
    /// Moment by angle, in N·m/rad inside, shown in N·m by angle.
    RollStiffness,
    /// Frequency, in Hz inside.
    Frequency,
    /// Length by the acceleration of the vehicle in multiples of g, in m inside.
    LengthByG,
    /// Angle by the acceleration of the vehicle in multiples of g, in rad inside.
    AngleByG,
}

impl Quantity {
    /// The powers of force, mass, length, angle and time that it is made of.
    const fn powers(self) -> [i32; 5] {
        match self {
            Self::Length => [0, 0, 1, 0, 0],
            Self::Angle => [0, 0, 0, 1, 0],
            Self::Force => [1, 0, 0, 0, 0],
            Self::Mass => [0, 1, 0, 0, 0],
            Self::Torque => [1, 0, 1, 0, 0],
            Self::Stiffness => [1, 0, -1, 0, 0],
            Self::Damping => [1, 0, -1, 0, 1],
            Self::RotationalStiffness => [1, 0, 1, -1, 0],
            Self::RotationalDamping => [1, 0, 1, -1, 1],
            Self::Inertia => [0, 1, 2, 0, 0],
            Self::Velocity => [0, 0, 1, 0, -1],
            Self::AngularVelocity => [0, 0, 0, 1, -1],
            Self::Acceleration => [0, 0, 1, 0, -2],
            Self::AngularAcceleration => [0, 0, 0, 1, -2],
            Self::Time => [0, 0, 0, 0, 1],
            Self::Ratio | Self::Percent => [0; 5],
            Self::Pitch => [0, 0, 1, -1, 0],
            Self::Gradient | Self::AngleByForce | Self::AngleByTorque | Self::AngleByG => {
                [0, 0, 0, 1, 0]
            }
            Self::LengthByForce | Self::LengthByG => [0, 0, 1, 0, 0],
            Self::RollStiffness => [0, 0, 0, -1, 0],
            Self::Frequency => [0, 0, 0, 0, -1],
        }
    }

    /// Whether it is made of a force.
    pub(crate) const fn has_force(self) -> bool {
        self.powers()[0] != 0
    }

    /// Whether it is made of a mass.
    pub(crate) const fn has_mass(self) -> bool {
        self.powers()[1] != 0
    }

    /// The symbol of its unit, such as `N/mm` or `N·mm/deg`; `1` for a number without dimension.
    pub fn symbol(self, units: Units) -> String {
        let (length, angle) = (units.length.symbol(), units.angle.symbol());
        match self {
            Self::Ratio => return "1".to_owned(),
            Self::Percent => return "%".to_owned(),
            Self::Gradient => return format!("{angle}/m"),
            Self::AngleByForce => return format!("{angle}/kN"),
            Self::LengthByForce => return format!("{length}/kN"),
            Self::AngleByTorque => return format!("{angle}/(kN·m)"),
            Self::RollStiffness => return format!("N·m/{angle}"),
            Self::Frequency => return "Hz".to_owned(),
            Self::LengthByG => return format!("{length}/g"),
            Self::AngleByG => return format!("{angle}/g"),
            _ => {}
        }
        let symbols = [units.force.symbol(), units.mass.symbol(), length, angle, "s"];
        let (mut above, mut below) = (vec![], vec![]);
        for (symbol, power) in symbols.into_iter().zip(self.powers()) {
            let factor = format!("{symbol}{}", if power.abs() == 2 { "²" } else { "" });
            match power.signum() {
                1 => above.push(factor),
                -1 => below.push(factor),
                _ => {}
            }
        }
        let above = above.join("·");
        if below.is_empty() { above } else { format!("{above}/{}", below.join("·")) }
    }

    /// The heading of a column with values of this kind: the name with the unit, where there is one.
    pub fn column(self, name: &str, units: Units) -> String {
        match self {
            Self::Ratio => name.to_owned(),
            Self::Percent => format!("{name}_pct"),
            _ => format!("{name}_{}", self.symbol(units)),
        }
    }

    /// A value in the units of a file, in SI.
    pub fn to_si(self, units: Units, value: f64) -> f64 {
        let (numerator, denominator) = self.ratio(units);
        let value = value * numerator / denominator;
        match self.powers()[3] {
            1 => units.angle.to_radians(value),
            -1 => units.angle.from_radians(value),
            _ => value,
        }
    }

    /// A value (SI) in the units of a file.
    pub fn show(self, units: Units, value: f64) -> f64 {
        let (numerator, denominator) = self.ratio(units);
        let value = value * denominator / numerator;
        match self.powers()[3] {
            1 => units.angle.from_radians(value),
            -1 => units.angle.to_radians(value),
            _ => value,
        }
    }

    /// The unit in SI units, but for the angle in it.
    fn ratio(self, units: Units) -> (f64, f64) {
        let ratios = [units.force.ratio(), units.mass.ratio(), units.length.ratio()];
        let mut product = match self {
            Self::Percent => (1.0, 100.0),
            Self::AngleByForce | Self::LengthByForce | Self::AngleByTorque => (1.0, 1000.0),
            _ => (1.0, 1.0),
        };
        for ((numerator, denominator), power) in ratios.into_iter().zip(self.powers()) {
            let (times, by) =
                if power < 0 { (denominator, numerator) } else { (numerator, denominator) };
            product.0 *= times.powi(power.abs());
            product.1 *= by.powi(power.abs());
        }
        product
    }
}
