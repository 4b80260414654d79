//! Force laws: what a force element answers to the value of its relation.

use super::spline::{Jet, Spline};
use crate::scalar::Real;

/// A function of one variable that is zero at zero unless it is a table.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Curve {
    /// No force.
    #[default]
    Zero,
    /// In proportion, with this factor.
    Linear(f64),
    /// A table.
    Table(Spline),
}

impl Curve {
    /// A linear curve; none where the factor is zero.
    pub fn linear(factor: f64) -> Self {
        if factor == 0.0 { Self::Zero } else { Self::Linear(factor) }
    }

    /// The value with its derivatives.
    pub fn at(&self, x: f64) -> Jet {
        match self {
            Self::Zero => Jet::default(),
            Self::Linear(factor) => Jet { value: factor * x, first: *factor, second: 0.0 },
            Self::Table(spline) => spline.at(x),
        }
    }

    /// The integral from zero to x.
    pub fn integral(&self, x: f64) -> f64 {
        match self {
            Self::Zero => 0.0,
            Self::Linear(factor) => 0.5 * factor * x * x,
            Self::Table(spline) => spline.integral(x),
        }
    }

    /// The curve −f(−x).
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Zero => Self::Zero,
            Self::Linear(factor) => Self::Linear(*factor),
            Self::Table(spline) => Self::Table(spline.reversed()),
        }
    }

    fn is_zero(&self) -> bool {
        matches!(self, Self::Zero)
    }
}

/// A number of a law that can be varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawConstant {
    /// The stiffness (N/m or N·m/rad) of a linear law; of a table, a factor of all its forces, which is 1.
    Stiffness,
    /// The constant force (N or N·m).
    Preload,
    /// The force (N or N·m) in a row of the table, numbered from 0.
    Row(usize),
}

/// When a force element acts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Acts {
    /// Always, with both signs.
    #[default]
    Always,
    /// Where the value is below zero, with a force that is never above zero: a bump stop or a
    /// tyre that can lift off.
    Below,
    /// Where the value is above zero, with a force that is never below zero: a rebound stop.
    Above,
}

/// λ = preload + elastic(Φ) + viscous(Φ̇): the force (N or N·m) that a relation with the value Φ
/// (m or rad) puts on its bodies as −Wᵀλ. Between two points λ > 0 is tension.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Law {
    /// Force by Φ.
    pub elastic: Curve,
    /// Force by Φ̇.
    pub viscous: Curve,
    /// Constant force.
    pub preload: f64,
    /// When it acts.
    pub acts: Acts,
}

/// λ with its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Response {
    /// λ.
    pub force: f64,
    /// The sum of the sizes of the parts of λ, of which rounding is a share where they cancel.
    pub size: f64,
    /// ∂λ/∂Φ, the stiffness.
    pub by_value: f64,
    /// ∂λ/∂Φ̇, the damping.
    pub by_rate: f64,
    /// ∂²λ/∂Φ².
    pub by_value_twice: f64,
}

impl Law {
    /// A constant force.
    pub fn constant(force: f64) -> Self {
        Self { preload: force, ..Self::default() }
    }

    /// A linear spring.
    pub fn spring(stiffness: f64) -> Self {
        Self { elastic: Curve::linear(stiffness), ..Self::default() }
    }

    /// The law of −Φ, which gives −λ: that of the mirror image where Φ changes its sign.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            elastic: self.elastic.reversed(),
            viscous: self.viscous.reversed(),
            preload: -self.preload,
            acts: match self.acts {
                Acts::Always => Acts::Always,
                Acts::Below => Acts::Above,
                Acts::Above => Acts::Below,
            },
        }
    }

    /// λ at rest and ∂λ/∂Φ on any scalar: what derivatives Φ has, they have, too.
    pub fn lifted<S: Real>(&self, value: S) -> [S; 2] {
        let Response { force, by_value, by_value_twice, .. } = self.at(value.value(), 0.0);
        let change = value - S::from_f64(value.value());
        let taylor = |value: f64, first: f64| S::from_f64(value) + S::from_f64(first) * change;
        [taylor(force, by_value), taylor(by_value, by_value_twice)]
    }

    /// ∂λ/∂c of one of its constants at rest, on any scalar; zero where the law has no such constant.
    pub fn by_constant<S: Real>(&self, constant: LawConstant, value: S) -> S {
        let x = value.value();
        let change = value - S::from_f64(x);
        let idle = self.at(x, 0.0).size == 0.0 && self.acts != Acts::Always;
        let jet = match (constant, &self.elastic) {
            _ if idle => Jet::default(),
            (LawConstant::Preload, _) => Jet { value: 1.0, ..Jet::default() },
            (LawConstant::Stiffness, Curve::Zero | Curve::Linear(_)) => {
                Jet { value: x, first: 1.0, second: 0.0 }
            }
            (LawConstant::Stiffness, table) => table.at(x),
            (LawConstant::Row(row), Curve::Table(spline)) => spline.by_row(row, x),
            (LawConstant::Row(_), _) => Jet::default(),
        };
        S::from_f64(jet.value) + S::from_f64(jet.first) * change
    }

    /// Gives a constant another value; a stiffness makes a curve that is not a table linear, and multiplies the
    /// forces of a table.
    pub fn set_constant(&mut self, constant: LawConstant, value: f64) {
        match (constant, &mut self.elastic) {
            (LawConstant::Preload, _) => self.preload = value,
            (LawConstant::Stiffness, Curve::Table(spline)) => *spline = spline.scaled(value),
            (LawConstant::Stiffness, curve) => *curve = Curve::Linear(value),
            (LawConstant::Row(row), Curve::Table(spline)) => *spline = spline.with_row(row, value),
            (LawConstant::Row(_), _) => {}
        }
    }

    /// Whether there is never any force.
    pub fn is_zero(&self) -> bool {
        self.elastic.is_zero() && self.viscous.is_zero() && self.preload == 0.0
    }

    /// The part of the force that has a potential: preload and elastic force where the element acts.
    pub fn conservative(&self, value: f64) -> f64 {
        if self.is_idle(value) { 0.0 } else { self.preload + self.elastic.at(value).value }
    }

    /// The value Φ at which the part of the force that is at rest has a size, found from Φ = 0; `None` where no
    /// value near there has it.
    pub fn value_under(&self, force: f64) -> Option<f64> {
        let mut value = 0.0;
        for _ in 0..50 {
            let elastic = self.elastic.at(value);
            let step = (force - self.preload - elastic.value) / elastic.first;
            value += step;
            if !value.is_finite() {
                return None;
            }
            if step.abs() <= 1e-14 * (1.0 + value.abs()) {
                return Some(value);
            }
        }
        None
    }

    /// The potential energy (J) of [`Self::conservative`], zero at Φ = 0.
    pub fn potential(&self, value: f64) -> f64 {
        if self.is_idle(value) {
            return 0.0;
        }
        self.preload * value + self.elastic.integral(value)
    }

    fn is_idle(&self, value: f64) -> bool {
        match self.acts {
            Acts::Always => false,
            Acts::Below => value >= 0.0,
            Acts::Above => value <= 0.0,
        }
    }

    /// The force for a value Φ and its rate Φ̇.
    pub fn at(&self, value: f64, rate: f64) -> Response {
        if self.is_idle(value) {
            return Response::default();
        }
        let (elastic, viscous) = (self.elastic.at(value), self.viscous.at(rate));
        let force = self.preload + elastic.value + viscous.value;
        let pulls = match self.acts {
            Acts::Always => false,
            Acts::Below => force > 0.0,
            Acts::Above => force < 0.0,
        };
        if pulls {
            return Response::default();
        }
        Response {
            force,
            size: self.preload.abs() + elastic.value.abs() + viscous.value.abs(),
            by_value: elastic.first,
            by_rate: viscous.first,
            by_value_twice: elastic.second,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Dual;

    #[test]
    fn a_stop_pushes_only_and_only_after_its_clearance() {
        let bump = Law {
            elastic: Curve::Linear(1000.0),
            viscous: Curve::Linear(50.0),
            acts: Acts::Below,
            ..Law::default()
        };
        assert_eq!(bump.at(0.01, -1.0), Response::default());
        assert_eq!(bump.at(-0.01, 0.0).force, -10.0);
        assert_eq!(bump.at(-0.01, 0.1).force, -5.0);
        // It does not hold back what leaves it.
        assert_eq!(bump.at(-0.01, 1.0), Response::default());
        let rebound = Law { acts: Acts::Above, ..Law::spring(1000.0) };
        assert_eq!(rebound.at(0.01, 0.0).force, 10.0);
        assert_eq!(rebound.at(-0.01, 0.0), Response::default());
    }

    #[test]
    fn the_potential_has_the_conservative_force_as_its_derivative() {
        let table = vec![[-0.02, -300.0], [0.01, 40.0], [0.03, 500.0], [0.05, 600.0]];
        let table = Curve::Table(Spline::new("spring", table).unwrap());
        for acts in [Acts::Always, Acts::Below, Acts::Above] {
            for elastic in [Curve::Zero, Curve::Linear(2e4), table.clone()] {
                let viscous = Curve::Linear(300.0);
                let law = Law { elastic, viscous, preload: 20.0, acts };
                for x in [-0.031, -0.007, 0.004, 0.017, 0.044, 0.06] {
                    let d = 1e-6;
                    let slope = (law.potential(x + d) - law.potential(x - d)) / (2.0 * d);
                    assert!((slope - law.conservative(x)).abs() < 1e-5, "{law:?} at {x}");
                }
                assert_eq!(law.potential(0.0), 0.0);
            }
        }
    }

    #[test]
    fn the_value_under_a_force_has_that_force() {
        let table = vec![[-0.04, -9000.0], [-0.02, -4200.0], [0.0, 0.0], [0.01, 1900.0]];
        let table = Curve::Table(Spline::new("tyre", table).unwrap());
        for elastic in [Curve::Linear(2e5), table] {
            let law = Law { elastic, acts: Acts::Below, ..Law::default() };
            let value = law.value_under(-5000.0).unwrap();
            assert!((law.at(value, 0.0).force + 5000.0).abs() < 1e-8);
        }
        assert_eq!(Law::default().value_under(-1.0), None);
    }

    #[test]
    fn a_reversed_law_answers_the_reversed_motion() {
        let table = Spline::new("stop", vec![[-2.0, -9.0], [0.0, 0.0], [1.0, 1.0]]).unwrap();
        let law = Law {
            elastic: Curve::Table(table),
            viscous: Curve::Linear(3.0),
            preload: -1.0,
            acts: Acts::Below,
        };
        for (value, rate) in [(-1.0, -0.2), (-1.5, 0.4), (0.5, 0.0)] {
            assert_eq!(law.reversed().at(-value, -rate).force, -law.at(value, rate).force);
        }
    }

    #[test]
    fn derivatives_by_constants_are_those_of_the_law_with_other_constants() {
        let rows = vec![[-0.02, -300.0], [0.01, 40.0], [0.03, 500.0], [0.05, 600.0]];
        let table = |k: usize, by: f64| {
            let mut rows = rows.clone();
            rows[k][1] += by;
            Law { elastic: Curve::Table(Spline::new("spring", rows).unwrap()), ..Law::default() }
        };
        for x in [-0.03, 0.002, 0.04, 0.07] {
            let dual = Dual::new(x, 2.0);
            for row in 0..4 {
                let found = table(0, 0.0).by_constant(LawConstant::Row(row), dual);
                // The spline depends on its forces linearly.
                let [more, less] = [10.0, -10.0].map(|by| table(row, by).at(x, 0.0));
                assert!((found.value - (more.force - less.force) / 20.0).abs() < 1e-12);
                let slope = 2.0 * (more.by_value - less.by_value) / 20.0;
                assert!((found.derivative - slope).abs() < 1e-10);
            }
            let scaled = table(0, 0.0).by_constant(LawConstant::Stiffness, x);
            assert_eq!(scaled, table(0, 0.0).at(x, 0.0).force);
            let linear = Law::spring(50.0).by_constant(LawConstant::Stiffness, dual);
            assert_eq!(linear, dual);
            let lifted = table(0, 0.0).lifted(dual);
            let response = table(0, 0.0).at(x, 0.0);
            assert_eq!(lifted[0], Dual::new(response.force, 2.0 * response.by_value));
            assert_eq!(lifted[1], Dual::new(response.by_value, 2.0 * response.by_value_twice));
        }
        let stop = Law { acts: Acts::Below, ..Law::spring(50.0) };
        assert_eq!(stop.by_constant(LawConstant::Stiffness, 0.1), 0.0);
        assert_eq!(stop.by_constant(LawConstant::Stiffness, -0.1), -0.1);
    }

    #[test]
    fn a_law_adds_its_parts() {
        let law = Law { preload: -3.0, ..Law::spring(20.0) };
        let response = law.at(0.5, 9.0);
        assert_eq!((response.force, response.by_value, response.by_rate), (7.0, 20.0, 0.0));
        assert!(!law.is_zero() && Law::default().is_zero());
    }
}
