//! Masses, inertias and initial velocities of parts, in the axes of the ground.

use super::dataset::{Dataset, Part};
use super::frame::Frame;
use crate::vector::{Vector, dot, sub};

impl Dataset {
    /// The mass moments of a part about its centre of mass, in the axes of the ground: Jxx, Jyy, Jzz, and
    /// the elements Jxy, Jxz, Jyz of the tensor. The centre comes with it.
    pub(super) fn mass_of(
        &self,
        part: &Part,
        mass: f64,
    ) -> Result<(Vector<f64>, [f64; 6]), String> {
        let marker = |id: Option<u32>, what: &str| match id {
            None => Err(format!("names no {what}")),
            Some(id) => self
                .markers
                .get(&id)
                .ok_or(format!("has {what} = {id}, a marker that does not exist")),
        };
        let center = marker(part.center, "CM")?;
        let about = match part.inertia_marker {
            None => center,
            some => marker(some, "IM")?,
        };
        let [xx, yy, zz, xy, xz, yz] = part.inertia;
        let tensor = [[xx, -xy, -xz], [-xy, yy, -yz], [-xz, -yz, zz]];
        let axes = about.frame.axes;
        // The parallel-axis theorem takes away what the way from the centre adds.
        let way = sub(about.frame.origin, center.frame.origin);
        let element = |i: usize, j: usize| {
            let turned: f64 = (0..3)
                .flat_map(|a| (0..3).map(move |b| (a, b)))
                .map(|(a, b)| axes[a][i] * tensor[a][b] * axes[b][j])
                .sum();
            let square = if i == j { dot(way, way) } else { 0.0 };
            turned - mass * (square - way[i] * way[j])
        };
        let places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        Ok((center.frame.origin, places.map(|(i, j)| element(i, j))))
    }

    /// The initial velocity of the centre of mass and the angular velocity of a part, in ground axes.
    pub(super) fn motion_of(&self, part: &Part) -> Option<[Vector<f64>; 2]> {
        let axes = |marker: Option<u32>, default: Option<Frame>| match marker {
            None | Some(0) => default,
            Some(id) => self.markers.get(&id).map(|marker| marker.frame),
        };
        let velocity = axes(part.velocity.1, Some(Frame::GROUND))?.vector(part.velocity.0);
        let center = part.center.and_then(|id| self.markers.get(&id)).map(|marker| marker.frame);
        let rotation = axes(part.rotation.1, center.or(Some(part.frame)))?.vector(part.rotation.0);
        Some([velocity, rotation])
    }
}
