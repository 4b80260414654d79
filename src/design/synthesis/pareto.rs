//! The trade-off between two targets.

use super::Obstacle;
use super::problem::Task;
use super::search::settle;
use crate::design::request::{Pareto, Request};
use crate::rig::Variable;

/// The least distance (in tolerances) between the ends of a trade-off.
const APART: f64 = 1e-6;

/// A design of a trade-off.
#[derive(Clone, Debug, PartialEq)]
pub struct TradeOff {
    /// How far both targets are off: the root of the mean square of differences in tolerances, times the weight; of one that is
    /// as small or great as possible its mean in tolerances, less being better.
    pub off: [f64; 2],
    /// The values (SI, coordinates in ISO 8855 axes) of the variables.
    pub values: Vec<f64>,
    /// The factors (SI), target by target and state by state.
    pub factors: Vec<Vec<Option<f64>>>,
}

/// The designs that are best for one target while the other is off by no more than so much: the ε-constraint
/// method (Haimes, Lasdon and Wismer 1971). They begin with the best for the second target.
pub(super) fn trade_off<V: Variable>(
    request: &Request,
    pareto: Pareto,
    task: &mut Task<'_, V>,
    start: &[f64],
) -> Result<Vec<TradeOff>, Obstacle> {
    let [first, second] = pareto.targets;
    let without = |target: usize| -> Vec<f64> {
        (0..request.targets.len()).map(|k| if k == target { 0.0 } else { 1.0 }).collect()
    };
    task.weigh(&without(first));
    let best = settle(request, task, start)?.x;
    let best = design(task, pareto, best)?;
    task.weigh(&without(second));
    let worst = settle(request, task, start)?.x;
    let worst = design(task, pareto, worst)?;
    let (least, most) = (best.off[1], worst.off[1]);
    let mut list = vec![best];
    if most - least > APART {
        for k in 1..pareto.points - 1 {
            let part = f64::from(k) / f64::from(pareto.points - 1);
            let limit = least + part * (most - least);
            task.bound(Some((second, limit)));
            let from = list.last().map_or_else(|| start.to_vec(), |design| design.values.clone());
            let found = settle(request, task, &from)?.x;
            list.push(design(task, pareto, found)?);
        }
        list.push(worst);
    }
    task.bound(None);
    task.weigh(&vec![1.0; request.targets.len()]);
    Ok(list)
}

fn design<V: Variable>(
    task: &mut Task<'_, V>,
    pareto: Pareto,
    values: Vec<f64>,
) -> Result<TradeOff, Obstacle> {
    let factors = task.values(&values)?;
    let residuals = task.residuals(&factors);
    let off = pareto.targets.map(|target| {
        let own: Vec<f64> = factors[target].iter().map(|value| value.unwrap_or(f64::NAN)).collect();
        task.goals.off(target, &residuals, &own)
    });
    Ok(TradeOff { off, values, factors })
}
