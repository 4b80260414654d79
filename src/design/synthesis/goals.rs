//! What the targets of a request ask of the states.

use super::Obstacle;
use super::trial::{Reached, Trial};
use crate::design::request::{Goal, Request, Target};
use crate::design::sqp::{Constraint, Evaluation};
use crate::model::Model;
use crate::rig::{self, Moved, Pose, Variable};
use crate::scalar::Dual;

/// One factor at one state, and what it is for.
#[derive(Clone, Debug)]
pub(super) struct Wish {
    /// The target, by its place in the request.
    pub target: usize,
    /// The state, by its place in [`Goals::states`].
    pub state: usize,
    /// The wheel, by its place among the poses.
    pub wheel: usize,
    pub kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// A residual: the factor minus this value.
    Residual { row: usize, wanted: f64 },
    /// A residual outside of a band.
    Band { row: usize, limits: [f64; 2] },
    /// A constraint, with a residual outside of its limits, too: where it is met that is zero, and on the way there
    /// the search does not lose sight of it where other targets are curved.
    Hard { row: usize, residual: usize, limits: [f64; 2] },
    /// A part of the objective with this factor.
    Open { factor: f64 },
}

/// All wishes, and the states where they are.
#[derive(Clone, Debug, Default)]
pub(super) struct Goals {
    pub states: Vec<rig::Target>,
    pub wishes: Vec<Wish>,
    pub weights: Vec<f64>,
    pub constraints: Vec<Constraint>,
    /// How much each target counts, times its weight.
    pub factors: Vec<f64>,
    /// A target that is a constraint for a while, and its row: how far it is off.
    pub bounded: Option<(usize, usize)>,
}

impl Goals {
    /// The wishes of a request for a model that has these values of the factors, target by target and state
    /// by state.
    pub fn of(request: &Request, model: &Model, sides: usize, own: &[Vec<f64>]) -> Self {
        let mut goals = Self { factors: vec![1.0; request.targets.len()], ..Self::default() };
        for (index, target) in request.targets.iter().enumerate() {
            for (k, state) in target.states.iter().enumerate() {
                let state = goals.state(state.rig);
                let wheel = wheel_of(target, sides);
                let kind = goals.kind(target, k, own[index].get(k).copied());
                goals.wishes.push(Wish { target: index, state, wheel, kind });
            }
        }
        debug_assert!(sides == 2 || request.targets.iter().all(|t| t.side == model.side));
        goals
    }

    /// The number of a state, which is new or not.
    pub fn state(&mut self, state: rig::Target) -> usize {
        self.states.iter().position(|known| *known == state).unwrap_or_else(|| {
            self.states.push(state);
            self.states.len() - 1
        })
    }

    fn kind(&mut self, target: &Target, k: usize, own: Option<f64>) -> Kind {
        let weight = target.weight / target.tolerance;
        #[allow(clippy::cast_precision_loss)] // A target has a handful of states.
        let states = target.states.len() as f64;
        let share = weight / states;
        let weight = weight / states.sqrt();
        let wanted = match &target.goal {
            Goal::Values(values) => values[k],
            Goal::Hold => own.unwrap_or_default(),
            Goal::Minimise => return Kind::Open { factor: share },
            Goal::Maximise => return Kind::Open { factor: -share },
            Goal::Band { min, max } => {
                let limits = [min.unwrap_or(f64::NEG_INFINITY), max.unwrap_or(f64::INFINITY)];
                self.weights.push(weight);
                if target.hard {
                    return self.hard(limits, target.tolerance);
                }
                return Kind::Band { row: self.weights.len() - 1, limits };
            }
        };
        self.weights.push(weight);
        if target.hard {
            return self.hard([wanted; 2], target.tolerance);
        }
        Kind::Residual { row: self.weights.len() - 1, wanted }
    }

    /// A constraint with the residual whose weight was added last.
    fn hard(&mut self, limits: [f64; 2], typical: f64) -> Kind {
        Kind::Hard {
            row: self.constrain(limits, typical),
            residual: self.weights.len() - 1,
            limits,
        }
    }

    /// Adds a constraint and returns its row.
    pub fn constrain(&mut self, [lower, upper]: [f64; 2], typical: f64) -> usize {
        self.constraints.push(Constraint { lower, upper, typical });
        self.constraints.len() - 1
    }

    /// Writes what is wished at a state.
    pub fn evaluate(
        &self,
        request: &Request,
        state: usize,
        reached: &Reached,
        out: &mut Evaluation,
    ) -> Result<(), Obstacle> {
        let n = reached.by.len();
        for wish in self.wishes.iter().filter(|wish| wish.state == state) {
            let target = &request.targets[wish.target];
            let (value, by) = reached
                .of(|moved| dual(target, wish.wheel, moved))
                .ok_or_else(|| Obstacle::Undefined(target.name.clone()))?;
            let off = match wish.kind {
                Kind::Residual { wanted, .. } => value - wanted,
                Kind::Band { limits: [least, _], .. } if value < least => value - least,
                Kind::Band { limits: [_, most], .. } => (value - most).max(0.0),
                Kind::Hard { .. } | Kind::Open { .. } => value,
            };
            let add = |sum: &mut f64, gradient: &mut [f64], amount: f64, factor: f64| {
                *sum += amount;
                gradient.iter_mut().zip(&by).for_each(|(sum, by)| *sum += factor * by);
            };
            let bounded = self.bounded.filter(|(target, _)| *target == wish.target);
            match wish.kind {
                Kind::Hard { row, residual, limits: [least, most] } => {
                    out.constraints[row] = off;
                    out.constraint_jacobian[row * n..][..n].copy_from_slice(&by);
                    let outside = (value - most).max(0.0) + (value - least).min(0.0);
                    out.residuals[residual] = outside;
                    if outside != 0.0 || least == most {
                        out.residual_jacobian[residual * n..][..n].copy_from_slice(&by);
                    }
                }
                Kind::Open { factor } => {
                    if let Some((_, row)) = bounded {
                        let gradient = &mut out.constraint_jacobian[row * n..][..n];
                        add(&mut out.constraints[row], gradient, factor * value, factor);
                    }
                    let factor = factor * self.factors[wish.target];
                    add(&mut out.objective, &mut out.gradient, factor * value, factor);
                }
                Kind::Residual { row, .. } | Kind::Band { row, .. } => {
                    if let Some((_, of_target)) = bounded {
                        let scaled = self.weights[row] * off;
                        let gradient = &mut out.constraint_jacobian[of_target * n..][..n];
                        let factor = 2.0 * self.weights[row] * scaled;
                        add(&mut out.constraints[of_target], gradient, scaled * scaled, factor);
                    }
                    out.residuals[row] = off;
                    // Inside of a band nothing changes.
                    if off != 0.0 || matches!(wish.kind, Kind::Residual { .. }) {
                        out.residual_jacobian[row * n..][..n].copy_from_slice(&by);
                    }
                }
            }
        }
        Ok(())
    }
}

impl Goals {
    /// How far a target is off for residuals and factors of a design: the root of the mean square of its
    /// differences in tolerances, or its mean in tolerances, less being better, where it is as small or great as possible.
    pub fn off(&self, target: usize, residuals: &[f64], values: &[f64]) -> f64 {
        let own = self.wishes.iter().filter(|wish| wish.target == target);
        let (mut squares, mut sum, mut open) = (0.0, 0.0, false);
        for (wish, value) in own.zip(values) {
            match wish.kind {
                Kind::Residual { row, .. } | Kind::Band { row, .. } => {
                    squares += (self.weights[row] * residuals[row]).powi(2);
                }
                Kind::Open { factor } => {
                    open = true;
                    sum += factor * value;
                }
                Kind::Hard { .. } => {}
            }
        }
        if open { sum } else { squares.sqrt() }
    }

    /// Whether a target is as small or great as possible.
    pub fn is_open(&self, target: usize) -> bool {
        let mut own = self.wishes.iter().filter(|wish| wish.target == target);
        own.any(|wish| matches!(wish.kind, Kind::Open { .. }))
    }
}

/// Which of the poses is the wheel of a target.
pub(super) fn wheel_of(target: &Target, sides: usize) -> usize {
    match sides {
        1 => 0,
        _ => target.side.index(),
    }
}

/// The factor of a target on dual numbers.
pub(super) fn dual(target: &Target, wheel: usize, moved: &Moved) -> Option<Dual> {
    (target.factor.by(target.convention).value.dual)(&moved.poses[wheel])
}

/// The factor of a target.
pub(super) fn plain(target: &Target, poses: &[Pose<f64>]) -> Option<f64> {
    target.factor.value(target.convention, &poses[wheel_of(target, poses.len())])
}

/// The values (SI) of the factors of all targets at their states, with the present parameters; `None` where one is
/// not defined.
pub(super) fn values<V: Variable>(
    request: &Request,
    trial: &mut Trial<V>,
) -> Result<Vec<Vec<Option<f64>>>, Obstacle> {
    let mut known: Vec<(rig::Target, Vec<Pose<f64>>)> = vec![];
    let mut values = vec![];
    for target in &request.targets {
        let mut list = vec![];
        for state in &target.states {
            let poses = match known.iter().find(|(known, _)| *known == state.rig) {
                Some((_, poses)) => poses.clone(),
                None => {
                    trial.go_to(&state.rig)?;
                    let poses = trial.poses();
                    known.push((state.rig, poses.clone()));
                    poses
                }
            };
            list.push(plain(target, &poses));
        }
        values.push(list);
    }
    Ok(values)
}
