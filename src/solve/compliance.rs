//! How points of bodies give way to loads, from one factorisation.

use thiserror::Error;

use super::equilibrium::Equilibrium;
use super::linearised::Linearised;
use super::motion::{Twist, point_position};
use super::stability::{Softest, softest};
use super::statics::StaticFailure;
use crate::mechanism::{BodyId, DriverId, PointId};
use crate::relation::{BODY_COORDINATES, Coordinates};
use crate::scalar::Scalar;
use crate::vector::{Vector, add, cross, dot, scale, sub};

/// Displacement and rotation of one point, and force and moment at it: x, y, z, then about x, y, z.
pub const WRENCH: usize = 6;

/// Why there is no compliance.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ComplianceError {
    /// There is no state at which it could be found.
    #[error(transparent)]
    NoEquilibrium(#[from] StaticFailure),
    /// A motion without any stiffness.
    #[error(
        "there is no compliance: with the wheel let go, nothing holds this motion: {motion}. Add a \
         spring, a bushing or a tyre that holds it"
    )]
    NoStiffness {
        /// The motion in words.
        motion: String,
    },
    /// A motion that runs away.
    #[error(
        "there is no compliance: the wheel let go would run away, {motion} has a stiffness of \
         {stiffness:.4e} N/m; check the signs of stiffnesses and the loads"
    )]
    Unstable {
        /// The motion in words.
        motion: String,
        /// Its stiffness (N/m), below zero.
        stiffness: f64,
    },
}

impl Equilibrium {
    /// As [`Linearised::compliance`], for whoever wants nothing else of the state.
    ///
    /// # Errors
    /// As for [`Linearised::compliance`].
    ///
    /// # Panics
    /// As [`Linearised::compliance`] does.
    pub fn compliance(
        &mut self,
        let_go: &[DriverId],
        points: &[(BodyId, PointId)],
    ) -> Result<Vec<f64>, ComplianceError> {
        self.linearised().compliance(let_go, points)
    }
}

impl Linearised<'_> {
    /// The compliance at the state that was found last, row by row: entry (6 k + i, 6 l + j) is the
    /// displacement or rotation i (m or rad) of point k per unit of the force or moment j (N or N·m) at
    /// point l. All are along and about the axes of the ground, and a rotation is an increment of the
    /// rotation vector. Points are those of the given bodies.
    ///
    /// The given drivers let go; those that are released are free anyway, held here or not. What a
    /// driver holds with stays on as a dead load: it keeps its size and acts where and as the driver did,
    /// so its curvature (Φ_qᵀλ)_q is part of the stiffness.
    ///
    /// # Errors
    /// [`ComplianceError`] where something has no stiffness without these drivers.
    ///
    /// # Panics
    /// If a driver, body or point belongs to another mechanism.
    pub fn compliance(
        &mut self,
        let_go: &[DriverId],
        points: &[(BodyId, PointId)],
    ) -> Result<Vec<f64>, ComplianceError> {
        let factorised = self.factorise();
        self.solved = None;
        let it = &mut *self.equilibrium;
        let row = |&driver: &DriverId| it.problem.numbering.row(it.equation_of(driver));
        let rows: Vec<usize> = let_go.iter().filter_map(row).collect();
        it.problem.measure_forces();
        if let Some(Softest { stiffness, motion, holds: false }) = softest(it, &rows) {
            return Err(if stiffness < 0.0 {
                ComplianceError::Unstable { motion, stiffness }
            } else {
                ComplianceError::NoStiffness { motion }
            });
        }
        let singular = |_| ComplianceError::NoStiffness {
            motion: "a motion that the matrix of the equilibrium does not tell apart".to_owned(),
        };
        factorised.map_err(singular)?;
        let Equilibrium { problem, mechanism, linear, step, scratch, .. } = it;
        let free = &mut scratch.let_go;
        free.begin(step.len(), rows.len());
        for (k, row) in rows.iter().enumerate() {
            free.condition_mut(k)[problem.numbering.unknowns() + row] = 1.0;
        }
        free.close(linear.as_mut()).map_err(singular)?;
        let mut excess = vec![0.0; rows.len()];
        let state = &problem.state;
        let places: Vec<Vector<f64>> = points
            .iter()
            .map(|&(body, point)| point_position(mechanism, state, body, point))
            .collect();
        let order = WRENCH * points.len();
        let mut compliance = vec![0.0; order * order];
        for column in 0..order {
            let (body, _) = points[column / WRENCH];
            let at = places[column / WRENCH];
            step.fill(0.0);
            let first = coordinates_of(body);
            let load = unit_load(&state[body.index()], at, column % WRENCH);
            step[first..first + BODY_COORDINATES].copy_from_slice(&load);
            linear.solve_refined(step).map_err(singular)?;
            free.keep(step, &mut excess);
            for (k, (&(body, _), &at)) in points.iter().zip(&places).enumerate() {
                let first = coordinates_of(body);
                let rates = &step[first..first + BODY_COORDINATES];
                let twist = Twist::new(&state[body.index()], rates);
                let moved = [twist.at(at), twist.rotation].concat();
                for (i, moved) in moved.into_iter().enumerate() {
                    compliance[(WRENCH * k + i) * order + column] = moved;
                }
            }
        }
        Ok(compliance)
    }
}

/// The first coordinate of a moving body.
pub(super) fn coordinates_of(body: BodyId) -> usize {
    BODY_COORDINATES * (body.index() - 1)
}

/// The generalized force of a unit force or moment at a place of a body: Q_r = F and
/// Q_p = 2 Eᵀ (M + (at − r) × F), because ω = 2 E ṗ with E = [−e, e0 I + ẽ].
pub(super) fn unit_load<S: Scalar>(
    q: &Coordinates<S>,
    at: Vector<S>,
    component: usize,
) -> Coordinates<S> {
    let zero = [S::from_f64(0.0); 3];
    let mut unit = zero;
    unit[component % 3] = S::from_f64(1.0);
    let arm = sub(at, [q[0], q[1], q[2]]);
    let (force, moment) = if component < 3 { (unit, cross(arm, unit)) } else { (zero, unit) };
    let (e0, e) = (q[3], [q[4], q[5], q[6]]);
    // Eᵀm is −eᵀm, and e0 m − e × m, because ẽᵀ = −ẽ.
    let turn = scale(S::from_f64(2.0), add(scale(e0, moment), cross(moment, e)));
    let along = S::from_f64(-2.0) * dot(e, moment);
    [force[0], force[1], force[2], along, turn[0], turn[1], turn[2]]
}
