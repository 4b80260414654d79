//! Units of length and angle of a model file. Everything inside is in metres and radians.

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
    const fn ratio(self) -> (f64, f64) {
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

/// The units of a model file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Units {
    /// Unit of every length and coordinate.
    pub length: LengthUnit,
    /// Unit of every angle.
    pub angle: AngleUnit,
}
