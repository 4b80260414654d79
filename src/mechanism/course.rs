//! What drivers prescribe in the course of time.

use super::spline::{Jet, Spline};

/// A motion in time as a sum of parts, zero at the start. Values are in m or rad, times in s.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Course {
    /// The factors of t, t², and so on.
    pub polynomial: Vec<f64>,
    /// Harmonic parts.
    pub waves: Vec<Wave>,
    /// Smooth steps.
    pub steps: Vec<Step>,
    /// A table of times and values, a natural cubic spline that goes on straight.
    pub table: Option<Spline>,
}

/// A sin(2π f t + φ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// A (m or rad).
    pub amplitude: f64,
    /// f (Hz).
    pub frequency: f64,
    /// φ (rad).
    pub phase: f64,
}

/// A change between two times, level outside of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Where it begins (s).
    pub from: f64,
    /// Where it ends (s), later.
    pub to: f64,
    /// The value behind it minus that before it (m or rad).
    pub change: f64,
    /// Whether it is the polynomial of fifth degree, whose acceleration has no jumps, instead of that of
    /// third degree: Adams' STEP5 and STEP.
    pub fifth: bool,
}

impl Course {
    /// Value, speed and acceleration at a time (s).
    pub fn at(&self, time: f64) -> Jet {
        let (now, start) = (self.sum(time), self.sum(0.0));
        Jet { value: now.value - start.value, ..now }
    }

    /// Whether all its numbers are finite and its steps end after they begin.
    pub(super) fn is_sound(&self) -> bool {
        let waves = self.waves.iter().flat_map(|wave| [wave.amplitude, wave.frequency, wave.phase]);
        let steps = self.steps.iter().flat_map(|step| [step.from, step.to, step.change]);
        let mut numbers = self.polynomial.iter().copied().chain(waves).chain(steps);
        numbers.all(f64::is_finite) && self.steps.iter().all(|step| step.from < step.to)
    }

    fn sum(&self, t: f64) -> Jet {
        let mut sum = self.table.as_ref().map_or(Jet::default(), |table| table.at(t));
        // Horner's scheme for Σ c_k t^k and its derivatives; there is no constant.
        let mut polynomial = Jet::default();
        for factor in self.polynomial.iter().rev().chain([&0.0]) {
            polynomial.second = polynomial.second * t + 2.0 * polynomial.first;
            polynomial.first = polynomial.first * t + polynomial.value;
            polynomial.value = polynomial.value * t + factor;
        }
        let waves = self.waves.iter().map(|wave| {
            let omega = std::f64::consts::TAU * wave.frequency;
            let (sine, cosine) = (omega * t + wave.phase).sin_cos();
            let value = wave.amplitude * sine;
            Jet { value, first: wave.amplitude * omega * cosine, second: -omega * omega * value }
        });
        for part in waves.chain(self.steps.iter().map(|step| step.at(t))).chain([polynomial]) {
            sum.value += part.value;
            sum.first += part.first;
            sum.second += part.second;
        }
        sum
    }
}

impl Step {
    fn at(&self, t: f64) -> Jet {
        let length = self.to - self.from;
        let s = ((t - self.from) / length).clamp(0.0, 1.0);
        let (value, first, second) = if self.fifth {
            let r = s * (1.0 - s);
            (s * s * s * (10.0 - s * (15.0 - 6.0 * s)), 30.0 * r * r, 60.0 * r * (1.0 - 2.0 * s))
        } else {
            // The jumps of the acceleration belong to the inside.
            let inside = if (0.0..1.0).contains(&((t - self.from) / length)) { 1.0 } else { 0.0 };
            (s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s), inside * (6.0 - 12.0 * s))
        };
        Jet {
            value: self.change * value,
            first: self.change * first / length,
            second: self.change * second / (length * length),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speed_and_acceleration_are_derivatives_and_the_start_is_zero() {
        let table = vec![[-1.0, 2.0], [0.3, 1.0], [0.9, -1.0], [2.0, 0.5]];
        let course = Course {
            polynomial: vec![2.0, -1.0, 0.5],
            waves: vec![Wave { amplitude: 0.3, frequency: 2.0, phase: 0.7 }],
            steps: [false, true]
                .map(|fifth| Step { from: 0.2, to: 1.5, change: -4.0, fifth })
                .to_vec(),
            table: Some(Spline::new("course", table).unwrap()),
        };
        assert_eq!(course.at(0.0).value, 0.0);
        let d = 1e-5;
        for t in [0.1, 0.25, 0.8, 1.2, 1.7] {
            let [before, now, after] = [t - d, t, t + d].map(|t| course.at(t));
            assert!(((after.value - before.value) / (2.0 * d) - now.first).abs() < 1e-6, "{t}");
            assert!(((after.first - before.first) / (2.0 * d) - now.second).abs() < 1e-4, "{t}");
        }
        let step = Step { from: 1.0, to: 3.0, change: 5.0, fifth: true };
        assert_eq!([0.0, 2.0, 4.0].map(|t| step.at(t).value), [0.0, 2.5, 5.0]);
    }
}
