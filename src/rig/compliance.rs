//! The compliance matrix of a corner or an axle.

use super::load::LoadPoint;
use super::pose::{Pose, WheelCompliance};
use super::station::Station;
use crate::mechanism::{BodyId, DriverId, PointId};
use crate::model::Side;
use crate::solve::compliance::{ComplianceError, WRENCH};
use crate::solve::linearised::Linearised;
use crate::vector::{Vector, cross, sub};

/// How wheels give way to loads that are small: C, 6×6 for a corner and 12×12 for an axle, left wheel
/// first (m, rad, N, N·m, ISO 8855 axes).
///
/// Column j is a unit load: a force along x, y, z or a moment about x, y, z at a wheel. Row i is the
/// displacement or rotation of a wheel. Rotations are increments of the rotation vector in ground
/// axes. Wheels that the rig holds are let go: what held them stays on as a dead load. The rack
/// stays held.
#[derive(Clone, Debug, PartialEq)]
pub struct Compliance {
    sides: Vec<Side>,
    /// From the wheel centres to the contact patches.
    arms: Vec<Vector<f64>>,
    at: LoadPoint,
    /// Row by row.
    matrix: Vec<f64>,
}

impl Compliance {
    /// The sides of the wheels, in the order of rows and columns.
    pub fn sides(&self) -> &[Side] {
        &self.sides
    }

    /// Where loads act and displacements are taken.
    pub fn at(&self) -> LoadPoint {
        self.at
    }

    /// The number of rows: six for each wheel.
    pub fn order(&self) -> usize {
        WRENCH * self.sides.len()
    }

    /// The displacement `row` per unit load `column`.
    ///
    /// # Panics
    /// If there is no such row or column.
    pub fn entry(&self, row: usize, column: usize) -> f64 {
        assert!(column < self.order(), "the matrix has {} columns", self.order());
        self.matrix[row * self.order() + column]
    }

    /// How the wheel of a row of [`Self::sides`] gives way.
    pub(super) fn of_wheel(&self, wheel: usize) -> WheelCompliance<f64> {
        WheelCompliance::of_wheel(wheel, self.sides.len(), &self.matrix, 0.0)
    }

    /// ‖C − Cᵀ‖ ∕ ‖C‖ in SI units, Frobenius norm. It is rounding where all forces have an energy
    /// and no moment is applied.
    pub fn asymmetry(&self) -> f64 {
        let order = self.order();
        let (mut difference, mut size) = (0.0, 0.0);
        for row in 0..order {
            for column in 0..order {
                difference += (self.entry(row, column) - self.entry(column, row)).powi(2);
                size += self.entry(row, column).powi(2);
            }
        }
        (difference / size).sqrt()
    }

    /// The matrix CP, whose loads act and whose displacements are taken at the contact patches: points of
    /// the wheels' bodies that are the lowest ones of the tyres now.
    #[must_use]
    pub fn at_contact_patch(&self) -> Self {
        if self.at == LoadPoint::ContactPatch {
            return self.clone();
        }
        let order = self.order();
        let mut matrix = self.matrix.clone();
        // A force F at the patch is F and the moment a × F at the wheel centre.
        for row in 0..order {
            for (wheel, arm) in self.arms.iter().enumerate() {
                let first = row * order + WRENCH * wheel;
                let moments = triple(&self.matrix, first + 3, 1);
                // Cⱼ + C_rot · (a × e_j) for the forces j; (a × e_j)·m = e_j·(m × a).
                let more = cross(moments, *arm);
                (0..3).for_each(|j| matrix[first + j] += more[j]);
            }
        }
        // The patch moves by what the centre does and θ × a.
        for column in 0..order {
            for (wheel, arm) in self.arms.iter().enumerate() {
                let first = WRENCH * wheel * order + column;
                let turned = triple(&matrix, first + 3 * order, order);
                let more = cross(turned, *arm);
                (0..3).for_each(|i| matrix[first + i * order] += more[i]);
            }
        }
        Self { matrix, at: LoadPoint::ContactPatch, ..self.clone() }
    }

    /// The compliance of wheels at the state of a linearised equilibrium.
    pub(super) fn of(
        equilibrium: &mut Linearised<'_>,
        stations: &[Station],
        poses: &[Pose<f64>],
    ) -> Result<Self, ComplianceError> {
        let travels: Vec<DriverId> = stations.iter().map(|station| station.travel).collect();
        let centers: Vec<(BodyId, PointId)> =
            stations.iter().map(|Station { wheel, .. }| (wheel.body, wheel.center)).collect();
        let arm = |Pose { wheel, .. }: &Pose<f64>| sub(wheel.contact_patch(), wheel.center);
        Ok(Self {
            sides: stations.iter().map(|station| station.side).collect(),
            arms: poses.iter().map(arm).collect(),
            at: LoadPoint::WheelCenter,
            // The driver of a wheel that is free has been let go before.
            matrix: equilibrium.compliance(&travels, &centers)?,
        })
    }
}

/// Three entries, `stride` apart.
fn triple(matrix: &[f64], first: usize, stride: usize) -> Vector<f64> {
    std::array::from_fn(|k| matrix[first + k * stride])
}
