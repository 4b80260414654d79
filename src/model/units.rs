//! Units of a file. Everything inside is in metres, radians, newtons, kilograms and seconds.

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthUnit {
    /// Millimetre.
    Millimetre,
    /// Centimetre.
    Centimetre,
    /// Metre.
    Metre,
    /// Inch, 25.4 mm.
    Inch,
}

impl LengthUnit {
    /// The symbols of model files.
    pub(crate) const CHOICES: &[(&str, Self)] = &[
        ("mm", Self::Millimetre),
        ("cm", Self::Centimetre),
        ("m", Self::Metre),
        ("in", Self::Inch),
    ];

    /// The symbol, as in model files.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "in",
        }
    }

    /// How many of this unit make `numerator / denominator` metres, as a ratio of whole numbers:
    /// dividing by 1000 rounds once, multiplying by 0.001 twice.
    pub(super) const fn ratio(self) -> (f64, f64) {
        match self {
            Self::Millimetre => (1.0, 1000.0),
            Self::Centimetre => (1.0, 100.0),
            Self::Metre => (1.0, 1.0),
            Self::Inch => (127.0, 5000.0),
        }
    }

    /// A length in this unit, in metres.
    pub fn to_metres(self, length: f64) -> f64 {
        let (numerator, denominator) = self.ratio();
        length * numerator / denominator
    }

    /// A length in metres, in this unit.
    pub fn from_metres(self, metres: f64) -> f64 {
        let (numerator, denominator) = self.ratio();
        metres * denominator / numerator
    }
}

/// A unit of angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AngleUnit {
    /// Degree.
    Degree,
    /// Radian.
    Radian,
}

impl AngleUnit {
    /// The symbols of model files.
    pub(crate) const CHOICES: &[(&str, Self)] = &[("deg", Self::Degree), ("rad", Self::Radian)];

    /// The symbol, as in model files.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Degree => "deg",
            Self::Radian => "rad",
        }
    }

    /// An angle in this unit, in radians.
    pub fn to_radians(self, angle: f64) -> f64 {
        match self {
            Self::Degree => angle.to_radians(),
            Self::Radian => angle,
        }
    }

    /// An angle in radians, in this unit.
    pub fn from_radians(self, radians: f64) -> f64 {
        match self {
            Self::Degree => radians.to_degrees(),
            Self::Radian => radians,
        }
    }
}

/// A unit of force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceUnit {
    /// Newton.
    Newton,
    /// Kilonewton.
    Kilonewton,
    /// Pound-force, 4.4482216152605 N.
    PoundForce,
}

impl ForceUnit {
    /// The symbols of model files.
    pub(crate) const CHOICES: &[(&str, Self)] =
        &[("N", Self::Newton), ("kN", Self::Kilonewton), ("lbf", Self::PoundForce)];

    /// The symbol, as in model files.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Newton => "N",
            Self::Kilonewton => "kN",
            Self::PoundForce => "lbf",
        }
    }

    /// One of this unit in newtons, as a ratio of whole numbers.
    pub(super) const fn ratio(self) -> (f64, f64) {
        match self {
            Self::Newton => (1.0, 1.0),
            Self::Kilonewton => (1000.0, 1.0),
            // 0.45359237 kg times 9.80665 m/s².
            Self::PoundForce => (8_896_443_230_521.0, 2e12),
        }
    }
}

/// A unit of mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MassUnit {
    /// Kilogram.
    Kilogram,
    /// Gram.
    Gram,
    /// Tonne, 1000 kg.
    Tonne,
    /// Pound, 0.45359237 kg.
    Pound,
}

impl MassUnit {
    /// The symbols of model files.
    pub(crate) const CHOICES: &[(&str, Self)] =
        &[("kg", Self::Kilogram), ("g", Self::Gram), ("t", Self::Tonne), ("lb", Self::Pound)];

    /// The symbol, as in model files.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Kilogram => "kg",
            Self::Gram => "g",
            Self::Tonne => "t",
            Self::Pound => "lb",
        }
    }

    /// One of this unit in kilograms, as a ratio of whole numbers.
    pub(super) const fn ratio(self) -> (f64, f64) {
        match self {
            Self::Kilogram => (1.0, 1.0),
            Self::Gram => (1.0, 1000.0),
            Self::Tonne => (1000.0, 1.0),
            Self::Pound => (45_359_237.0, 1e8),
        }
    }
}

/// The units of a file; all others follow from these four and the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Units {
    /// Unit of every length and coordinate.
    pub length: LengthUnit,
    /// Unit of every angle.
    pub angle: AngleUnit,
    /// Unit of every force; newtons where the file names none because it has no forces.
    pub force: ForceUnit,
    /// Unit of every mass; kilograms where the file names none because it has no masses.
    pub mass: MassUnit,
}
