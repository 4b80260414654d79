//! Drivers that are held by a force instead of at a value.

use super::stand::Stand;
use crate::mechanism::DriverId;
use crate::solve::{StepReport, Stop};

/// How the rig holds a driver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// At a value (m or rad, from the design position).
    Value(f64),
    /// With a force (N) or moment (N·m) on its body *j*, positive in the sense of its value,
    /// at whatever value that takes.
    Force(f64),
}

impl Default for Hold {
    fn default() -> Self {
        Self::Value(0.0)
    }
}

/// A force counts as reached within this part of the largest force that is asked for or carried.
const REACHED: f64 = 1e-10;

/// What rounding of a state may leave, as a part of the same force.
const ROUNDING: f64 = 1e-8;

/// The way (m or rad) whose force is the least that forces are measured with.
const LEAST_WAY: f64 = 1e-3;

/// Newton steps, halved ones counted. Five are usual; bump stops and drivers that start far away
/// take more.
const MOST_STEPS: usize = 60;

/// The longest Newton step (m or rad): farther away the rates say nothing, and the way could lead past
/// the end of a travel.
const LONGEST: f64 = 0.1;

/// The shortest part of a Newton step.
const SHORTEST: f64 = 1e-3;

impl Stand {
    /// Moves drivers to values and to forces: Newton's method on the values of those that are held by
    /// forces, with the exact matrix of their rates, −∂λ/∂v.
    ///
    /// # Errors
    /// [`Stop`] where the mechanism cannot go on, or no value of the drivers has these forces.
    /// It then stays where it got to.
    pub fn hold(&mut self, targets: &[(DriverId, Hold)]) -> Result<StepReport, Stop> {
        let mut values: Vec<(DriverId, f64)> = vec![];
        let mut sought: Vec<(DriverId, f64)> = vec![];
        for &(driver, hold) in targets {
            match hold {
                Hold::Value(value) => values.push((driver, value)),
                Hold::Force(force) => sought.push((driver, force)),
            }
        }
        // Those that are held by forces come last.
        values.extend(sought.iter().map(|&(driver, _)| (driver, self.driver_value(driver))));
        let report = self.move_to(&values)?;
        if sought.is_empty() {
            return Ok(report);
        }
        let report = self.seek(&sought, values, report)?;
        self.hold_by_force(sought.into_iter().map(|(driver, _)| driver));
        Ok(report)
    }

    /// Seeks the values of drivers, the last ones of `values`, that have the forces.
    fn seek(
        &mut self,
        sought: &[(DriverId, f64)],
        mut values: Vec<(DriverId, f64)>,
        mut sum: StepReport,
    ) -> Result<StepReport, Stop> {
        let first = values.len() - sought.len();
        let mut add = |report: StepReport| {
            sum.iterations += report.iterations;
            sum.steps += report.steps;
            sum.relative_residual = report.relative_residual;
        };
        let mut lacking = self.lacking(sought);
        let mut rates = self.slopes(sought);
        let (mut fraction, mut why) = (1.0, None);
        for _ in 0..MOST_STEPS {
            let worst = largest(&lacking);
            let measure = self.measure(sought, rates.as_deref());
            if worst <= REACHED * measure {
                return Ok(sum);
            }
            let step = rates.as_ref().and_then(|rates| solved(rates, &lacking));
            let Some(step) = step else { break };
            let part = fraction * f64::min(1.0, LONGEST / largest(&step));
            let before = values.clone();
            for ((_, value), step) in values[first..].iter_mut().zip(&step) {
                *value += part * step;
            }
            let moved = self.move_to(&values).map(&mut add);
            if moved.is_ok() && largest(&self.lacking(sought)) < worst {
                lacking = self.lacking(sought);
                rates = self.slopes(sought);
                fraction = f64::min(1.0, 2.0 * fraction);
                continue;
            }
            values = before;
            let back = self.move_to(&values).map(&mut add);
            if back.is_ok() && worst <= ROUNDING * measure {
                return Ok(sum);
            }
            fraction *= 0.5;
            if back.is_err() || fraction < SHORTEST {
                why = moved.and(back).err();
                break;
            }
        }
        // What it carried where it was last in equilibrium, not on the way that failed.
        let forces = sought.iter().zip(&lacking);
        let forces = forces.map(|(&(driver, force), lacking)| (driver, force - lacking, force));
        Err(Stop::no_force(self.mechanism(), forces, why))
    }

    /// The force (N) or moment (N·m) with which a driver is held, positive in the sense of its value.
    pub fn driver_force(&self, driver: DriverId) -> f64 {
        -self.equilibrium().driver_multiplier(driver)
    }

    /// What each force lacks.
    fn lacking(&self, sought: &[(DriverId, f64)]) -> Vec<f64> {
        sought.iter().map(|&(driver, force)| force - self.driver_force(driver)).collect()
    }

    /// What forces are measured with.
    fn measure(&self, sought: &[(DriverId, f64)], rates: Option<&[f64]>) -> f64 {
        let forces =
            sought.iter().map(|&(driver, force)| force.abs().max(self.driver_force(driver).abs()));
        let stiff = largest(rates.unwrap_or_default());
        forces.fold(LEAST_WAY * stiff, f64::max)
    }

    /// The derivatives of forces (rows) by values (columns), row by row; `None` where the equilibrium is
    /// not isolated.
    fn slopes(&mut self, sought: &[(DriverId, f64)]) -> Option<Vec<f64>> {
        let count = sought.len();
        let mut rates = vec![0.0; count * count];
        let equations: Vec<usize> =
            sought.iter().map(|&(driver, _)| self.equilibrium().equation_of(driver)).collect();
        let mut near = self.rates();
        for (column, &(driver, _)) in sought.iter().enumerate() {
            let tangent = near.equilibrium().tangent(driver).ok()?;
            for (row, &equation) in equations.iter().enumerate() {
                rates[row * count + column] = -tangent.multiplier(equation);
            }
        }
        Some(rates)
    }
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |largest: f64, number| {
        if number.is_nan() { f64::INFINITY } else { largest.max(number.abs()) }
    })
}

/// The solution of a square system; `None` where its matrix is singular to rounding.
fn solved(matrix: &[f64], right_side: &[f64]) -> Option<Vec<f64>> {
    use faer::linalg::solvers::Solve as _;
    let count = right_side.len();
    let matrix = faer::Mat::from_fn(count, count, |row, column| matrix[row * count + column]);
    let right_side = faer::Mat::from_fn(count, 1, |row, _| right_side[row]);
    let solution = matrix.full_piv_lu().solve(right_side);
    let solution: Vec<f64> = (0..count).map(|row| solution[(row, 0)]).collect();
    // A way of a hundred metres is none that a wheel could go.
    solution.iter().all(|step| step.abs() < 1e2).then_some(solution)
}
