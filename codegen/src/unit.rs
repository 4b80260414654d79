//! Units of quantities: products of powers of the base units m, kg, s and rad.

use std::fmt;

/// Exponents of m, kg, s in halves, so that a square root stays exact.
///
/// The radian counts as dimensionless: angles come from ratios of lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Unit([i32; 3]);

const BASE: [&str; 3] = ["m", "kg", "s"];

/// No unit of mechanics has a larger power.
const LARGEST_POWER: i32 = 12;

impl Unit {
    /// No dimension.
    pub const ONE: Self = Self([0; 3]);
    /// Metre.
    pub const METRE: Self = Self([2, 0, 0]);
    /// Metre per second.
    pub const METRE_PER_SECOND: Self = Self([2, 0, -2]);
    /// Radian per second.
    pub const PER_SECOND: Self = Self([0, 0, -2]);
    /// Joule.
    pub const JOULE: Self = Self([4, 2, -4]);

    /// Reads a unit such as `m`, `N*m/rad`, `kg*m^2` or `1`.
    ///
    /// # Errors
    /// The part that is not understood.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut unit = Self::ONE;
        let mut sign = 1;
        let mut rest = text.trim();
        loop {
            let end = rest.find(['*', '/']).unwrap_or(rest.len());
            let factor = rest[..end].trim();
            let (name, power) = factor.split_once('^').unwrap_or((factor, "1"));
            let power: i32 = power.trim().parse().map_err(|_| factor.to_owned())?;
            if !(-LARGEST_POWER..=LARGEST_POWER).contains(&power) {
                return Err(factor.to_owned());
            }
            let exponents = match name.trim() {
                "1" | "rad" => [0, 0, 0],
                "m" => [2, 0, 0],
                "kg" => [0, 2, 0],
                "s" => [0, 0, 2],
                "N" => [2, 2, -4],
                "J" => [4, 2, -4],
                _ => return Err(factor.to_owned()),
            };
            for (sum, exponent) in unit.0.iter_mut().zip(exponents) {
                *sum += sign * power * exponent;
            }
            if end == rest.len() {
                return Ok(unit);
            }
            sign = if rest.as_bytes()[end] == b'/' { -1 } else { 1 };
            rest = &rest[end + 1..];
        }
    }

    /// The unit of a product.
    pub fn times(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }

    /// The unit of a quotient.
    pub fn over(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }

    /// The unit of a square root; `None` where a quarter power would be needed.
    pub fn root(self) -> Option<Self> {
        self.0.iter().all(|exponent| exponent % 2 == 0).then(|| Self(self.0.map(|e| e / 2)))
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut separator = "";
        for (name, &halves) in BASE.iter().zip(&self.0) {
            if halves != 0 {
                write!(formatter, "{separator}{name}")?;
                match (halves % 2, halves / 2) {
                    (0, 1) => {}
                    (0, whole) => write!(formatter, "^{whole}")?,
                    _ => write!(formatter, "^({halves}/2)")?,
                }
                separator = "*";
            }
        }
        if separator.is_empty() { formatter.write_str("1") } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_multiply_and_print_in_base_units() {
        assert_eq!(Unit::parse("N*m/rad").unwrap().to_string(), "m^2*kg*s^-2");
        assert_eq!(Unit::parse("1").unwrap(), Unit::ONE);
        assert_eq!(Unit::parse("m^2").unwrap().root(), Some(Unit::METRE));
        assert_eq!(Unit::parse("m").unwrap().root().unwrap().to_string(), "m^(1/2)");
        assert_eq!(Unit::parse("mm").unwrap_err(), "mm");
        assert_eq!(Unit::parse("m^x").unwrap_err(), "m^x");
        assert_eq!(Unit::parse("m^2000000000").unwrap_err(), "m^2000000000");
    }
}
