//! Redundant equations and free motions at the design position, in words.

use std::fmt;

use faer::MatRef;

use super::motion::{Precision, describe, localise};
use super::position::Scales;
use super::rank::{holders, null_space, scaled_jacobian, select};
use crate::assembly::Terms;
use crate::mechanism::{BodyId, DriverId, Expansion, Mechanism, Owner};
use crate::relation::Coordinates;

/// An equation of a joint that other joints already satisfy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RedundantEquation {
    /// Its number in Φ. It is left out and its reaction is not unique.
    pub equation: usize,
    /// The equation in words: joint and held motion.
    pub label: String,
    /// The joints, and drivers if any, that already hold it.
    pub held_by: Vec<String>,
}

/// A motion that nothing holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FreeMotion {
    /// What moves and how, such as `tierod turns about the line tierod_inner–tierod_outer`.
    pub description: String,
    /// The bodies that move.
    pub bodies: Vec<BodyId>,
}

/// A driver whose motion is already held.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BlockedDriver {
    /// The driver.
    pub driver: DriverId,
    /// Its name.
    pub name: String,
    /// The joints and drivers that hold its motion.
    pub held_by: Vec<String>,
}

/// What joints and drivers leave free and what they hold twice, at the design position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FreedomReport {
    /// Number of moving bodies.
    pub bodies: usize,
    /// Degrees of freedom that the joints leave, before drivers.
    pub degrees_of_freedom: usize,
    /// Number of drivers.
    pub drivers: usize,
    /// Equations that are left out because others imply them.
    pub redundant: Vec<RedundantEquation>,
    /// Motions that remain with all drivers held.
    pub free_motions: Vec<FreeMotion>,
    /// Drivers that cannot move.
    pub blocked_drivers: Vec<BlockedDriver>,
}

impl FreedomReport {
    /// Whether drivers and joints determine every position, each equation once.
    pub fn is_exact(&self) -> bool {
        self.redundant.is_empty() && self.free_motions.is_empty() && self.blocked_drivers.is_empty()
    }
}

impl fmt::Display for FreedomReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural =
            |n: usize, one: &'static str, many: &'static str| if n == 1 { one } else { many };
        write!(
            f,
            "{} moving {}, {} {} of freedom, {} {}",
            self.bodies,
            plural(self.bodies, "body", "bodies"),
            self.degrees_of_freedom,
            plural(self.degrees_of_freedom, "degree", "degrees"),
            self.drivers,
            plural(self.drivers, "driver", "drivers"),
        )?;
        for equation in &self.redundant {
            write!(
                f,
                "\nredundant: {}; already held by {}",
                equation.label,
                equation.held_by.join(", ")
            )?;
        }
        for motion in &self.free_motions {
            write!(f, "\nfree: {}", motion.description)?;
        }
        for driver in &self.blocked_drivers {
            write!(
                f,
                "\nblocked: driver {}; its motion is held by {}",
                driver.name,
                driver.held_by.join(", ")
            )?;
        }
        Ok(())
    }
}

/// Analyses a mechanism at its design position.
///
/// A mechanism without moving bodies has nothing free and nothing redundant.
pub fn analyse(mechanism: &Mechanism) -> FreedomReport {
    let expansion = Expansion::new(mechanism);
    let state = crate::assembly::design_state(mechanism.bodies());
    let h = expansion.parameters(&mechanism.positions());
    let scales = Scales::of(mechanism);
    let terms = Terms::new(&expansion);
    let (jacobian, _) = scaled_jacobian(&expansion, &terms, &state, &h, scales);
    report(mechanism, &expansion, jacobian.as_ref(), &state, scales)
}

pub(super) fn report(
    mechanism: &Mechanism,
    expansion: &Expansion,
    jacobian: MatRef<'_, f64>,
    state: &[Coordinates<f64>],
    scales: Scales,
) -> FreedomReport {
    let mut report = FreedomReport {
        bodies: mechanism.bodies().len() - 1,
        degrees_of_freedom: 0,
        drivers: mechanism.driver_ids().filter(|&id| mechanism.adjuster(id).is_none()).count(),
        redundant: vec![],
        free_motions: vec![],
        blocked_drivers: vec![],
    };
    if report.bodies == 0 {
        return report;
    }
    let selection = select(expansion, jacobian);
    report.degrees_of_freedom = jacobian.ncols() - selection.joint_rank;
    let held_by = |equation: usize| {
        let holders = holders(jacobian, &selection.kept, equation);
        names(mechanism, expansion, expansion.owner(equation), &holders)
    };
    report.redundant = selection
        .left_out
        .iter()
        .map(|&equation| RedundantEquation {
            equation,
            label: expansion.label(equation).to_owned(),
            held_by: held_by(equation),
        })
        .collect();
    for &equation in &selection.blocked {
        if let Owner::Driver(driver) = expansion.owner(equation) {
            report.blocked_drivers.push(BlockedDriver {
                driver,
                name: mechanism.drivers()[driver.index()].name.clone(),
                held_by: held_by(equation),
            });
        }
    }
    let basis = null_space(jacobian, &selection.kept);
    report.free_motions = localise(state, basis.as_ref(), scales)
        .iter()
        .map(|twists| {
            let (description, bodies) =
                describe(mechanism, state, twists, scales.length, Precision::EXACT);
            FreeMotion { description, bodies }
        })
        .collect();
    report
}

/// The joints and drivers of the equations, each once. The normalisations of
/// Euler parameters hold no motion and are not named.
fn names(
    mechanism: &Mechanism,
    expansion: &Expansion,
    of: Owner,
    equations: &[usize],
) -> Vec<String> {
    let mut names: Vec<String> = vec![];
    for &equation in equations {
        let owner = expansion.owner(equation);
        let name = match owner {
            Owner::Joint(joint) => mechanism.joints()[joint].name.clone(),
            Owner::Driver(driver) => mechanism.drivers()[driver.index()].name.clone(),
            // Euler parameters hold no motion, and forces hold nothing.
            Owner::Body(_) | Owner::Force(_) | Owner::Weight(_) => continue,
        };
        let name = if owner == of { format!("{name} itself") } else { name };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.sort();
    names
}
