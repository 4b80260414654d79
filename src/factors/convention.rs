//! Which program's definitions are followed where they differ.

/// A set of definitions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Convention {
    /// ISO 8855.
    #[default]
    Iso,
    /// Adams/Car.
    Adams,
    /// Lotus Suspension Analysis.
    Lotus,
}

impl Convention {
    /// The name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Iso => "iso",
            Self::Adams => "adams",
            Self::Lotus => "lotus",
        }
    }
}
