//! Where a mechanism cannot go on, and why.

use std::fmt;

use thiserror::Error;

use super::motion::{Precision, Twist, describe, point_position, twists};
use super::position::Position;
use super::rank::{scaled_jacobian, weakest};
use super::statics::StaticFailure;
use super::travel::Failure;
use crate::assembly::Terms;
use crate::mechanism::{BodyId, DriverId, Expansion, JointKind, Mechanism, Owner};
use crate::relation::Coordinates;
use crate::vector::{cross, norm, scale, sub, unit};

/// Why a mechanism stopped.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum StopReason {
    /// The drivers lose control of the mechanism: a lock-up or toggle position.
    DeadCentre {
        /// The joint nearest to singular, in words.
        joint: Option<String>,
        /// The motion that the drivers no longer control, in words.
        motion: String,
    },
    /// Newton's method does not converge although the mechanism is not near a dead centre.
    NoConvergence {
        /// The equation with the largest residual, in words.
        equation: String,
        /// The residual of the last attempt, relative.
        relative_residual: f64,
    },
    /// No step is short enough to stay on the assembled branch, although the mechanism is not near a dead
    /// centre.
    LostBranch,
    /// An equation that was left out as redundant at the design position is no longer satisfied.
    Inconsistent {
        /// The equation in words.
        equation: String,
        /// By how much, in the unit of the equation.
        residual: f64,
    },
    /// A driver has a limit.
    Limit {
        /// The driver.
        driver: String,
        /// The limit (m).
        limit: f64,
    },
    /// A driver was given a value that is not finite.
    NotFinite {
        /// The driver.
        driver: String,
    },
    /// The mechanism is held, but its forces have no equilibrium.
    NoEquilibrium(StaticFailure),
    /// No value of the drivers that are held by forces has these forces, or the mechanism stopped on
    /// the way there.
    NoForce(Vec<Carried>, Option<Box<Stop>>),
}

/// What a driver that is held by a force carried when the mechanism stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct Carried {
    /// Name of the driver.
    pub driver: String,
    /// Unit of both values: `N` or `N·m`.
    pub unit: &'static str,
    /// The force or moment that was reached.
    pub force: f64,
    /// The one that was asked for.
    pub target: f64,
}

/// Where one driver was when the mechanism stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct Reached {
    /// Name of the driver.
    pub driver: String,
    /// Unit of both values: `m` or `rad`.
    pub unit: &'static str,
    /// The value that was reached.
    pub value: f64,
    /// The value that was asked for.
    pub target: f64,
}

/// A mechanism cannot go on. The state is the last one that was reached.
#[derive(Clone, Debug, PartialEq, Error)]
pub struct Stop {
    /// All drivers that were on their way.
    pub reached: Vec<Reached>,
    /// Why.
    pub reason: StopReason,
}

impl Stop {
    pub(super) fn new(
        mechanism: &Mechanism,
        reason: StopReason,
        values: &[f64],
        targets: &[f64],
    ) -> Self {
        let ways = values.iter().zip(targets).enumerate();
        let ways = ways.map(|(driver, (&value, &target))| (DriverId(driver), value, target));
        Self { reached: on_the_way(mechanism, ways), reason }
    }

    /// A driver would go beyond a limit (m) on its way from a value to a target.
    pub fn limit(driver: &str, value: f64, target: f64, limit: f64) -> Self {
        let reached = Reached { driver: driver.to_owned(), unit: "m", value, target };
        let reason = StopReason::Limit { driver: driver.to_owned(), limit };
        Self { reached: vec![reached], reason }
    }

    /// The forces have no equilibrium. `ways` lists drivers with their values and their targets.
    pub fn no_equilibrium(
        mechanism: &Mechanism,
        failure: StaticFailure,
        ways: &[(DriverId, f64, f64)],
    ) -> Self {
        let reached = on_the_way(mechanism, ways.iter().copied());
        Self { reached, reason: StopReason::NoEquilibrium(failure) }
    }

    /// No values of drivers have the forces that are asked for. `forces` lists drivers with what they
    /// carry and their targets; `why` is the stop on the way there.
    pub fn no_force(
        mechanism: &Mechanism,
        forces: impl Iterator<Item = (DriverId, f64, f64)>,
        why: Option<Self>,
    ) -> Self {
        let carried = forces.map(|(driver, force, target)| {
            let driver = &mechanism.drivers()[driver.index()];
            let unit = if driver.kind.unit() == "rad" { "N·m" } else { "N" };
            Carried { driver: driver.name.clone(), unit, force, target }
        });
        Self { reached: vec![], reason: StopReason::NoForce(carried.collect(), why.map(Box::new)) }
    }
}

/// The drivers that have not reached their targets.
fn on_the_way(
    mechanism: &Mechanism,
    ways: impl Iterator<Item = (DriverId, f64, f64)>,
) -> Vec<Reached> {
    ways.filter(|(_, value, target)| value != target)
        .map(|(driver, value, target)| {
            let driver = &mechanism.drivers()[driver.index()];
            Reached { driver: driver.name.clone(), unit: driver.kind.unit(), value, target }
        })
        .collect()
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, reached) in self.reached.iter().enumerate() {
            let (value, target, unit) = match reached.unit {
                "rad" => (reached.value.to_degrees(), reached.target.to_degrees(), "°"),
                _ => (reached.value * 1e3, reached.target * 1e3, " mm"),
            };
            let start = if index == 0 { "stopped at" } else { " and" };
            write!(
                f,
                "{start} {} = {}{unit} on the way to {}{unit}",
                reached.driver,
                plain(value),
                plain(target)
            )?;
        }
        if !self.reached.is_empty() {
            write!(f, ": ")?;
        }
        write!(f, "{}", self.reason)
    }
}

impl fmt::Display for StopReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DeadCentre { joint, motion } => {
                write!(f, "lock-up, the mechanism is at a dead centre")?;
                if let Some(joint) = joint {
                    write!(f, "; nearest to singular is {joint}")?;
                }
                write!(f, "; the drivers no longer control this motion: {motion}")
            }
            Self::NoConvergence { equation, relative_residual } => write!(
                f,
                "no convergence; the largest relative residual is {relative_residual:.1e} in {equation}"
            ),
            Self::LostBranch => write!(
                f,
                "no step is short enough to stay with the assembled position; \
                 this is a defect of the program, please report the model"
            ),
            Self::Inconsistent { equation, residual } => write!(
                f,
                "{equation}, is redundant at the design position but is violated by {residual:.1e} here: \
                 the joints hold this motion; make their axes exactly parallel, or free one of them"
            ),
            Self::Limit { driver, limit } => write!(
                f,
                "{driver} has a limit at {} mm; stay within it, or change the limits of the model",
                plain(limit * 1e3)
            ),
            Self::NotFinite { driver } => {
                write!(f, "driver {driver} was given a value that is not a finite number")
            }
            Self::NoEquilibrium(failure) => write!(f, "{failure}"),
            Self::NoForce(carried, why) => {
                for (index, Carried { driver, unit, force, target }) in carried.iter().enumerate() {
                    let start = if index == 0 { "stopped at" } else { " and" };
                    let (force, target) = (plain(*force), plain(*target));
                    write!(f, "{start} {force} {unit} at {driver} on the way to {target} {unit}")?;
                }
                match why {
                    Some(why) => write!(f, ": {why}"),
                    None => write!(
                        f,
                        ": no position near the last one carries this; ask for less, or check \
                         springs and stops"
                    ),
                }
            }
        }
    }
}

/// Six decimals at most, without rounding noise such as 199.99999999999994.
fn plain(value: f64) -> String {
    if value.abs() >= 1e9 {
        return format!("{value:e}");
    }
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A singular value this much smaller than with all drivers at zero is a dead centre.
const DEAD_CENTRE: f64 = 0.03;

/// Finds the reason in the state that was reached.
pub(super) fn explain(
    mechanism: &Mechanism,
    expansion: &Expansion,
    terms: &Terms,
    position: &Position,
    (start, base): (&[Coordinates<f64>], &[f64]),
    failure: Failure,
) -> StopReason {
    if let Failure::Inconsistent { equation, value } = failure {
        return StopReason::Inconsistent {
            equation: expansion.label(equation).to_owned(),
            residual: value,
        };
    }
    let scales = position.scales;
    let weakest = |state: &[Coordinates<f64>], h: &[f64]| {
        let (jacobian, _) = scaled_jacobian(expansion, terms, state, h, scales);
        weakest(jacobian.as_ref(), position.kept().len())
    };
    let at_start = weakest(start, base);
    let here = weakest(&position.state, &position.h);
    if let (Some((reference, ..)), Some((value, left, right))) = (at_start, here)
        && (value < DEAD_CENTRE * reference || matches!(failure, Failure::Singular))
    {
        let motion = twists(&position.state, &right, scales);
        let (words, _) =
            describe(mechanism, &position.state, &motion, scales.length, Precision::NEAR);
        let joint =
            nearest_joint(mechanism, expansion, &position.state, &left, &motion, scales.length);
        return StopReason::DeadCentre {
            joint: joint.map(|joint| {
                let joint = &mechanism.joints()[joint];
                crate::mechanism::joint_in_words(mechanism, joint)
            }),
            motion: words,
        };
    }
    match failure {
        Failure::Corrector { equation, relative_residual } => StopReason::NoConvergence {
            equation: expansion.label(equation).to_owned(),
            relative_residual,
        },
        _ => StopReason::LostBranch,
    }
}

/// The joint at which the mechanism locks.
///
/// At a dead centre the joints carry a system of loads that balances itself
/// (the left null vector) and the bodies have a motion that the drivers do not
/// control (the right one). The elbow of a toggle carries that load between two
/// moving bodies that no driver loads, and turns most. Without such a joint it
/// is the one that turns most between moving bodies, then any.
fn nearest_joint(
    mechanism: &Mechanism,
    expansion: &Expansion,
    state: &[Coordinates<f64>],
    load: &[f64],
    motion: &[Twist],
    length: f64,
) -> Option<usize> {
    let largest = load.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let loaded = |owner: Owner, share: f64| {
        let mut loads = load.iter().enumerate();
        loads.any(|(equation, x)| expansion.owner(equation) == owner && x.abs() > share * largest)
    };
    let mut driven = vec![];
    for (index, driver) in mechanism.drivers().iter().enumerate() {
        if loaded(Owner::Driver(DriverId(index)), 1e-6) {
            driven.extend([driver.i, driver.j]);
        }
    }
    let candidates = mechanism.joints().iter().enumerate();
    candidates
        .filter(|&(index, _)| loaded(Owner::Joint(index), 1e-2))
        .map(|(index, joint)| {
            let [on_i, on_j] = joint.kind.points();
            let here = point_position(mechanism, state, joint.j, on_j);
            let there = point_position(mechanism, state, joint.i, on_i);
            let [i, j] = [joint.i, joint.j].map(|body| &motion[body.index()]);
            let amount = if let JointKind::Link { .. } = joint.kind {
                let link = sub(here, there);
                let turning = cross(unit(link), sub(j.at(here), i.at(there)));
                norm(turning) / norm(link)
            } else {
                let relative = j.minus(i);
                norm(relative.rotation) + norm(scale(1.0 / length, relative.at(here)))
            };
            let moving = joint.i != BodyId::GROUND && joint.j != BodyId::GROUND;
            let elbow = moving && !driven.contains(&joint.i) && !driven.contains(&joint.j);
            (index, [elbow, moving], amount)
        })
        .max_by(|a, b| a.1.cmp(&b.1).then(a.2.total_cmp(&b.2)))
        .map(|(index, ..)| index)
}
