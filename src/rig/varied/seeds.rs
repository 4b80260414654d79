//! The adjoint way: each entry of a state that poses depend on is given a derivative in turn.

use super::Varied;
use crate::relation::BODY_COORDINATES;
use crate::rig::pose::Pose;
use crate::rig::station::Station;
use crate::scalar::Dual;
use crate::solve::sensitivity::{Change, Frame, Gradient, Response, SensitivityError};

impl Varied<'_> {
    /// The derivatives of results of the poses by everything that a change has. `results` gives values and
    /// derivatives for poses; `count` is the number of them.
    ///
    /// # Errors
    /// [`SensitivityError`].
    pub fn gradients(
        &mut self,
        count: usize,
        results: impl Fn(&[Pose<Dual>]) -> Vec<f64>,
    ) -> Result<Vec<Change>, SensitivityError> {
        let mut seeded = self.sensitivity.still(&self.frame);
        let mut gradients = vec![Gradient::default(); count];
        let tangents = seeded.tangents.len();
        for gradient in &mut gradients {
            gradient.unknowns = vec![0.0; self.frame.size()];
            gradient.tangents = vec![vec![0.0; self.frame.size()]; tangents];
            gradient.ways = vec![0.0; self.question.by_force.len()];
            gradient.direct = self.no_change();
        }
        for seed in self.seeds(&seeded) {
            seed.entry(&mut seeded).derivative = 1.0;
            let poses = self.poses_of(&seeded);
            seed.entry(&mut seeded).derivative = 0.0;
            for (gradient, by) in gradients.iter_mut().zip(results(&poses)) {
                *seed.place(gradient, &self.frame) = by;
            }
        }
        let Self { sensitivity, frame, .. } = self;
        let adjoint = |gradient: &Gradient| Ok(sensitivity.adjoint(frame, gradient)?);
        gradients.iter().map(adjoint).collect()
    }

    /// The entries of a response that poses depend on.
    fn seeds(&self, response: &Response) -> Vec<Seed> {
        let mut bodies: Vec<usize> = self.stations.iter().flat_map(Station::bodies).collect();
        bodies.sort_unstable();
        bodies.dedup();
        bodies.retain(|&body| body != 0);
        let mut points: Vec<usize> = self.stations.iter().flat_map(Station::points).collect();
        points.sort_unstable();
        points.dedup();
        let travels = self.stations.iter().map(|station| self.equation(station.travel));
        let rows = travels.filter_map(|e| Some((e, self.frame.multiplier(e)?)));
        let rows: Vec<(usize, usize)> = rows.collect();
        let mut seeds = vec![];
        for &body in &bodies {
            for k in 0..BODY_COORDINATES {
                seeds.push(Seed::Coordinate { body, k });
                let entry = BODY_COORDINATES * (body - 1) + k;
                // Of the tangents by loads only the motions of wheels are asked.
                let is_wheel = self.question.points.iter().any(|(wheel, _)| wheel.index() == body);
                let tangents = match is_wheel {
                    true => 0..response.tangents.len(),
                    false => 0..self.question.drivers.len(),
                };
                seeds.extend(tangents.map(|tangent| Seed::Tangent { tangent, entry }));
            }
        }
        for (equation, entry) in rows {
            seeds.push(Seed::Multiplier { equation, entry });
            let tangents = 0..self.question.drivers.len();
            seeds.extend(tangents.map(|tangent| Seed::Tangent { tangent, entry }));
        }
        for point in points {
            seeds.extend((0..3).map(|axis| Seed::Point { point, axis }));
        }
        seeds.extend((0..response.ways.len()).map(|driver| Seed::Way { driver }));
        seeds.extend((0..response.others.len()).map(|other| Seed::Other { other }));
        let places = self.stations.iter().flat_map(Station::adjusted_parameters);
        seeds.extend(places.map(|parameter| Seed::Parameter { parameter }));
        seeds
    }
}

/// An entry of a response that is given a derivative.
#[derive(Clone, Copy)]
enum Seed {
    Coordinate { body: usize, k: usize },
    Tangent { tangent: usize, entry: usize },
    Multiplier { equation: usize, entry: usize },
    Point { point: usize, axis: usize },
    Parameter { parameter: usize },
    Way { driver: usize },
    Other { other: usize },
}

impl Seed {
    fn entry(self, response: &mut Response) -> &mut Dual {
        match self {
            Self::Coordinate { body, k } => &mut response.state[body][k],
            Self::Tangent { tangent, entry } => &mut response.tangents[tangent][entry],
            Self::Multiplier { equation, .. } => &mut response.lambda[equation],
            Self::Point { point, axis } => &mut response.points[point][axis],
            Self::Parameter { parameter } => &mut response.h[parameter],
            Self::Way { driver } => &mut response.ways[driver],
            Self::Other { other } => &mut response.others[other],
        }
    }

    fn place<'g>(self, gradient: &'g mut Gradient, frame: &Frame<'_>) -> &'g mut f64 {
        match self {
            Self::Coordinate { body, k } => {
                &mut gradient.unknowns[BODY_COORDINATES * (body - 1) + k]
            }
            Self::Tangent { tangent, entry } => &mut gradient.tangents[tangent][entry],
            Self::Multiplier { entry, .. } => {
                debug_assert!(entry >= frame.unknowns());
                &mut gradient.unknowns[entry]
            }
            Self::Point { point, axis } => &mut gradient.direct.points[point][axis],
            Self::Parameter { parameter } => &mut gradient.direct.h[parameter],
            Self::Way { driver } => &mut gradient.ways[driver],
            Self::Other { other } => &mut gradient.direct.others[other],
        }
    }
}
