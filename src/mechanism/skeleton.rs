//! Where bodies are held: what drawings and clearances see of them.

use super::build::Mechanism;
use super::force::ForceKind;
use super::topology::{BodyId, Direction, JointKind, PointId};

impl Mechanism {
    /// Every body, the ground too, with each point at which a joint or a bushing holds it. A second point of the
    /// axis of a revolute joint belongs to both of its bodies unless it is that of a joint itself; those of other axes are
    /// places on the way of a slide or the far end of a link.
    pub(crate) fn held_points(&self) -> Vec<(BodyId, PointId)> {
        let mut held = vec![];
        for joint in self.joints() {
            let [on_i, on_j] = joint.kind.points();
            held.extend([(joint.i, on_i), (joint.j, on_j)]);
            if let JointKind::Revolute { axis: Direction::Between(from, to), .. } = joint.kind {
                for end in [from, to].into_iter().filter(|end| !self.is_held_at(*end)) {
                    held.extend([(joint.i, end), (joint.j, end)]);
                }
            }
        }
        for force in self.forces() {
            if let (ForceKind::Bushing(_), Some([on_i, on_j])) = (&force.kind, force.kind.points())
            {
                held.extend([(force.i, on_i), (force.j, on_j)]);
            }
        }
        held.sort_unstable();
        held.dedup();
        held
    }

    fn is_held_at(&self, point: PointId) -> bool {
        self.joints().iter().any(|joint| joint.kind.points().contains(&point))
    }
}
