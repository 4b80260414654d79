//! Which parts of a suspension have which points.

use toml::Spanned;

use crate::mechanism::{BodyId, Direction, ForceKind, JointKind, PointId};
use crate::model::{Model, Report, SpinAxis, StrutLine, suggest};

/// A point of a body, which moves with it. Bodies and points have the numbers of the architecture and the model: the
/// chassis is [`BodyId::GROUND`], the points are in the order of [`Model::points`].
pub type End = (PointId, BodyId);

/// All points of all bodies.
pub(super) struct Attached {
    ends: Vec<End>,
    /// Links without a body of their own, and springs.
    lines: Vec<(Option<String>, [End; 2])>,
    names: Vec<String>,
    bodies: Vec<String>,
    pub(super) spring: Option<StrutLine>,
    pub(super) damper: Option<StrutLine>,
}

impl Attached {
    pub(super) fn of(model: &Model) -> Self {
        let architecture = &model.architecture;
        let (mut ends, mut lines): (Vec<End>, _) = (vec![], vec![]);
        for joint in architecture.joints() {
            let [on_i, on_j] = joint.kind.points();
            ends.extend([(on_i, joint.i), (on_j, joint.j)]);
            match joint.kind {
                JointKind::Link { .. } => lines.push((None, [(on_i, joint.i), (on_j, joint.j)])),
                // Both bodies share the axis.
                JointKind::Revolute { axis: Direction::Between(from, to), .. }
                | JointKind::Cylindrical { axis: Direction::Between(from, to), .. } => {
                    for body in [joint.i, joint.j] {
                        ends.extend([(from, body), (to, body)]);
                    }
                }
                _ => {}
            }
        }
        for force in model.forces().iter().chain(model.bushings().iter().map(|b| &b.force)) {
            let Some([on_i, on_j]) = force.kind.points() else { continue };
            let own = [(on_i, force.i), (on_j, force.j)];
            if let ForceKind::Line { .. } = force.kind {
                lines.push((Some(force.name.clone()), own));
            }
            // Loads act from the ground, which does not carry their points.
            let carried = !matches!(force.kind, ForceKind::PointForce { .. });
            ends.extend(own.into_iter().skip(usize::from(!carried)));
        }
        let wheel = architecture.wheel;
        ends.push((wheel.center, wheel.body));
        if let SpinAxis::Point(name) = &model.spin
            && let Some(point) = model.points().iter().position(|point| point.name == *name)
        {
            ends.push((PointId(point), wheel.body));
        }
        ends.extend(architecture.steer_axis.iter().flat_map(|axis| [axis.lower, axis.upper]));
        let (spring, damper) = (model.spring_line(|body| body), model.damper_line(|body| body));
        ends.extend([&spring, &damper].into_iter().flatten().flat_map(|line| line.ends));
        // Bodies that a load or a mount of the other side brings along are none of the architecture.
        ends.retain(|(_, body)| body.index() <= architecture.bodies().len());
        let names = model.points().iter().map(|point| point.name.clone()).collect();
        let ground = std::iter::once(architecture.ground().to_owned());
        let bodies = ground.chain(architecture.bodies().iter().map(|body| body.name.clone()));
        Self { ends, lines, names, bodies: bodies.collect(), spring, damper }
    }

    /// The body of a name.
    pub(super) fn body(&self, name: &Spanned<String>, report: &mut Report) -> Option<BodyId> {
        let word = name.get_ref();
        let found = self.bodies.iter().position(|body| body == word);
        if found.is_none() {
            let known: Vec<&str> = self.bodies.iter().map(String::as_str).collect();
            report
                .mistake(&name.span(), format!("there is no body `{word}`"), "unknown body")
                .help(suggest::choices(word, &known));
        }
        found.map(BodyId)
    }

    /// The points of a body, each once.
    pub(super) fn points_of(&self, body: BodyId) -> Vec<End> {
        let mut ends: Vec<End> = self.ends.iter().copied().filter(|end| end.1 == body).collect();
        ends.sort_unstable();
        ends.dedup();
        ends
    }

    /// A point with the body that moves it: the first moving one that has it.
    pub(super) fn end(&self, point: usize) -> Option<End> {
        let mut of_point = self.ends.iter().copied().filter(|(of, _)| of.index() == point);
        let moving = of_point.clone().find(|(_, body)| *body != BodyId::GROUND);
        moving.or_else(|| of_point.next())
    }

    /// The part that has both points: a body, a link without one, or a spring.
    pub(super) fn link(&self, points: [usize; 2]) -> Option<[End; 2]> {
        let bodies = self.ends.iter().filter(|(of, _)| of.index() == points[0]);
        let with_both = bodies.map(|(_, body)| *body).find(|body| {
            *body != BodyId::GROUND && self.ends.contains(&(PointId(points[1]), *body))
        });
        if let Some(body) = with_both {
            return Some(points.map(|point| (PointId(point), body)));
        }
        let of = |ends: &[End; 2]| ends.map(|(point, _)| point.index());
        self.lines.iter().map(|(_, ends)| *ends).find_map(|ends| match of(&ends) {
            same if same == points => Some(ends),
            [b, a] if [a, b] == points => Some([ends[1], ends[0]]),
            _ => None,
        })
    }

    /// The ends of a spring, damper or stop by its name.
    pub(super) fn line(&self, name: &str) -> Option<[End; 2]> {
        let found = self.lines.iter().find(|(of, _)| of.as_deref() == Some(name));
        found.map(|(_, ends)| *ends)
    }

    /// The names of points and of forces along lines.
    pub(super) fn names(&self) -> Vec<&str> {
        let lines = self.lines.iter().filter_map(|(name, _)| name.as_deref());
        self.names.iter().map(String::as_str).chain(lines).collect()
    }

    /// The name of a point.
    pub(super) fn name(&self, point: usize) -> &str {
        &self.names[point]
    }
}
