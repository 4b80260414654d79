//! Derivatives of factors by parameters of the model.

use thiserror::Error;

use super::parameter::Parameter;
use super::resolve::Resolved;
use crate::assembly::ElementConstant;
use crate::factors::{Convention, Factor, Need};
use crate::model::{Model, Side};
use crate::rig::{Pose, Variable, VaryError};
use crate::scalar::Dual;
use crate::solve::sensitivity::{Change, SensitivityError};

/// Which way derivatives are found. Both give the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    /// The cheaper one.
    #[default]
    Automatic,
    /// From each parameter to all factors.
    Direct,
    /// From each factor to all parameters.
    Adjoint,
}

/// The derivatives at one state.
#[derive(Clone)]
pub struct Sensitivities {
    /// One row for each factor of each wheel; a factor of an axle has one.
    pub rows: Vec<Sensitivity>,
    /// The parameters by which there is no derivative, with the reason; their entries are empty.
    pub refused: Vec<(String, String)>,
    /// The factors that the state does not have, with what they need.
    pub lacking: Vec<(&'static str, String)>,
}

/// A factor of a wheel with its derivatives.
#[derive(Clone)]
pub struct Sensitivity {
    /// The factor.
    pub factor: &'static Factor,
    /// The wheel; of a factor of an axle the first.
    pub side: Side,
    /// The value (SI); `None` where it is not defined.
    pub value: Option<f64>,
    /// The derivatives (SI), in the order of the parameters.
    pub by: Vec<Option<f64>>,
}

/// Why there are no derivatives.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SensitivityFailure {
    /// The state does not say.
    #[error(transparent)]
    State(#[from] VaryError),
}

/// The derivatives of factors by parameters at the state of a corner or an axle.
///
/// # Errors
/// [`SensitivityFailure`] where the state has no derivatives at all.
pub fn sensitivities(
    specimen: &mut impl Variable,
    model: &Model,
    factors: &[&'static Factor],
    convention: Convention,
    parameters: &[Parameter],
    way: Way,
) -> Result<Sensitivities, SensitivityFailure> {
    let compliance = factors.iter().any(|factor| factor.needs.contains(&Need::Compliance));
    specimen.measure_compliance(compliance);
    let poses = specimen.poses();
    let compliance = poses.iter().any(|pose| pose.compliance.is_some());
    let resolved: Vec<Resolved> = parameters.iter().map(|p| p.resolve(specimen, model)).collect();
    let mut constants: Vec<ElementConstant> = vec![];
    for resolved in &resolved {
        constants.extend(resolved.constants.iter().map(|(constant, _)| constant));
    }
    let mut rows = rows(&poses, factors, convention);
    let lacking = factors.iter().filter_map(|factor| Some((factor.name, lacking(factor, &poses)?)));
    let lacking = lacking.collect();
    let mut varied = specimen.vary(&constants, compliance)?;
    let changes: Vec<Result<Change, SensitivityError>> = parameters
        .iter()
        .zip(&resolved)
        .map(|(parameter, resolved)| resolved.change(parameter, model, &mut varied, &constants))
        .collect();
    let adjoint = match way {
        // What an adjoint needs of the formulas costs half as much as a direct solution; see benches/README.md.
        Way::Automatic => 3 * rows.len() < 2 * parameters.len(),
        Way::Direct => false,
        Way::Adjoint => true,
    };
    let mut refused = vec![];
    let gradients = match adjoint {
        true => {
            let derivatives = |poses: &[Pose<Dual>]| -> Vec<f64> {
                let by =
                    |row: &Row| row.dual(convention, poses).map_or(0.0, |dual| dual.derivative);
                rows.iter().map(by).collect()
            };
            varied.gradients(rows.len(), derivatives).map_err(|_| VaryError::Singular)?
        }
        false => vec![],
    };
    for (parameter, change) in parameters.iter().zip(changes) {
        let found = change.and_then(|change| -> Result<Vec<Option<f64>>, SensitivityError> {
            if adjoint {
                varied.check(&change)?;
                return Ok(gradients.iter().map(|gradient| Some(gradient.dot(&change))).collect());
            }
            let poses = varied.poses(&change)?;
            let by = |row: &Row| Some(row.dual(convention, &poses)?.derivative);
            Ok(rows.iter().map(by).collect())
        });
        let found = found.unwrap_or_else(|error| {
            let reason = match error {
                SensitivityError::Singular(error) => error.to_string(),
                SensitivityError::Redundant { equation } => format!(
                    "the joints would no longer fit together: {} is redundant, and holds only as long as \
                     the points keep their proportions",
                    varied.label(equation)
                ),
            };
            refused.push((parameter.name.clone(), reason));
            vec![None; rows.len()]
        });
        for (row, by) in rows.iter_mut().zip(found) {
            row.result.by.push(by);
        }
    }
    let rows = rows.into_iter().map(Row::finish).collect();
    Ok(Sensitivities { rows, refused, lacking })
}

/// What a factor needs and the state does not have.
fn lacking(factor: &Factor, poses: &[Pose<f64>]) -> Option<String> {
    let first = poses.first()?;
    if let Some(axle) = factor.axle.filter(|_| !factor.applies(first)) {
        return Some(format!("a {} axle", axle.name()));
    }
    let missing: Vec<&str> = factor.missing(first).map(Need::words).collect();
    (!missing.is_empty()).then(|| missing.join(" and "))
}

/// A row on its way.
struct Row {
    wheel: usize,
    result: Sensitivity,
}

fn rows(poses: &[Pose<f64>], factors: &[&'static Factor], convention: Convention) -> Vec<Row> {
    let mut rows = vec![];
    for factor in factors {
        let wheels = if factor.is_of_axle() { &poses[..1] } else { poses };
        for (wheel, pose) in wheels.iter().enumerate() {
            let value = factor.value(convention, pose);
            let result = Sensitivity { factor, side: pose.side, value, by: vec![] };
            rows.push(Row { wheel, result });
        }
    }
    rows
}

impl Row {
    fn dual(&self, convention: Convention, poses: &[Pose<Dual>]) -> Option<Dual> {
        (self.result.factor.by(convention).value.dual)(&poses[self.wheel])
    }

    /// A factor without a value has no derivatives.
    fn finish(self) -> Sensitivity {
        let defined = self.result.value.is_some();
        let by = self.result.by.into_iter().map(|by| by.filter(|by| defined && by.is_finite()));
        Sensitivity { by: by.collect(), ..self.result }
    }
}
