//! What an event passes that a suspension should keep away from: dead centres, and what comes near to them.

use std::fmt;

use super::line::Line;
use super::pose::Pose;
use crate::mechanism::{BodyId, Mechanism, PointId};
use crate::model::Side;
use crate::vector::{dot, sub};

/// Near a dead centre a point moves more than this many times as fast as the wheel that moves it.
pub const NEARLY_DEAD: f64 = 10.0;

/// Motion ratios below this are rounding: the strut does not move with the wheel.
const STILL: f64 = 1e-6;

/// The fastest joint of a suspension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fastest {
    /// The body that has it.
    pub body: BodyId,
    /// The point.
    pub point: PointId,
    /// Its speed by that of the height of the wheel.
    pub ratio: f64,
}

/// What is dangerous.
#[derive(Clone, Debug, PartialEq)]
pub enum Danger {
    /// A joint is much faster than the wheel: the mechanism comes near to a dead centre.
    Fast {
        /// The body that has the joint.
        body: String,
        /// The point.
        point: String,
        /// Its largest speed by that of the wheel.
        ratio: f64,
    },
    /// The wheel goes on and the strut turns back: its motion ratio is zero.
    Turns {
        /// `spring` or `damper`.
        strut: &'static str,
    },
    /// How the mechanism moves with the wheel is not determined.
    Dead,
}

impl fmt::Display for Danger {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fast { body, point, ratio } => write!(
                f,
                "near to a dead centre: {point} of {body} goes up to {ratio:.1} times as far as the wheel"
            ),
            Self::Turns { strut } => {
                write!(f, "dead centre of the {strut}: its motion ratio changes its sign")
            }
            Self::Dead => write!(f, "dead centre: the wheel does not say how the joints move"),
        }
    }
}

/// A danger and the stretch of the event, from state to state, on which it was seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning<P> {
    /// What.
    pub danger: Danger,
    /// At which wheel.
    pub side: Side,
    /// The first state.
    pub from: P,
    /// The last state.
    pub to: P,
}

/// What was seen of one wheel.
#[derive(Clone, Debug)]
struct Seen<P> {
    at: P,
    /// Motion ratios of spring and damper.
    ratios: [Option<f64>; 2],
    moves: bool,
    /// The warning that is still going on.
    fast: Option<usize>,
}

/// Looks at the states of an event one after the other.
#[derive(Clone, Debug)]
pub struct Watch<P> {
    warnings: Vec<Warning<P>>,
    before: [Option<Seen<P>>; 2],
}

impl<P> Default for Watch<P> {
    fn default() -> Self {
        Self { warnings: vec![], before: [None, None] }
    }
}

impl<P: Clone> Watch<P> {
    /// The next state is no neighbour of the last one.
    pub fn restart(&mut self) {
        self.before = [None, None];
    }

    /// Looks at the wheels of one state of a mechanism.
    pub fn look(&mut self, poses: &[Pose<f64>], mechanism: &Mechanism, at: &P) {
        for pose in poses {
            self.look_at(pose, mechanism, at);
        }
    }

    /// What was seen, in the order in which it began.
    pub fn warnings(self) -> Vec<Warning<P>> {
        self.warnings
    }

    fn look_at(&mut self, pose: &Pose<f64>, mechanism: &Mechanism, at: &P) {
        let before = self.before[pose.side.index()].take();
        let mut now = Seen {
            at: at.clone(),
            ratios: ratios(pose),
            moves: pose.motions.is_some(),
            fast: None,
        };
        if let Some(before) = &before {
            for (k, strut) in ["spring", "damper"].into_iter().enumerate() {
                // Where there is no ratio the last one that there was counts on.
                let ratio = now.ratios[k].filter(|ratio| ratio.abs() > STILL);
                if let (Some(a), Some(b)) = (before.ratios[k], ratio)
                    && a * b < 0.0
                {
                    self.warn(Danger::Turns { strut }, pose.side, &before.at, at);
                }
                now.ratios[k] = ratio.or(before.ratios[k]);
            }
            if before.moves && !now.moves {
                self.warn(Danger::Dead, pose.side, at, at);
            }
        }
        let fastest = pose.motions.and_then(|motions| motions.travel.fastest);
        if let Some(fastest) = fastest.filter(|fastest| fastest.ratio > NEARLY_DEAD) {
            now.fast = Some(self.go_on(
                before.and_then(|seen| seen.fast),
                fastest,
                pose.side,
                mechanism,
                at,
            ));
        }
        self.before[pose.side.index()] = Some(now);
    }

    /// Goes on with a warning or begins one; it keeps the fastest joint. Gives its number.
    fn go_on(
        &mut self,
        begun: Option<usize>,
        fastest: Fastest,
        side: Side,
        mechanism: &Mechanism,
        at: &P,
    ) -> usize {
        let danger = Danger::Fast {
            body: mechanism.bodies()[fastest.body.index()].name.clone(),
            point: mechanism.points()[fastest.point.index()].name.clone(),
            ratio: fastest.ratio,
        };
        let Some(number) = begun else {
            self.warn(danger, side, at, at);
            return self.warnings.len() - 1;
        };
        let warning = &mut self.warnings[number];
        warning.to = at.clone();
        if matches!(warning.danger, Danger::Fast { ratio, .. } if ratio < fastest.ratio) {
            warning.danger = danger;
        }
        number
    }

    fn warn(&mut self, danger: Danger, side: Side, from: &P, to: &P) {
        self.warnings.push(Warning { danger, side, from: from.clone(), to: to.clone() });
    }
}

/// How much longer spring and damper become for each metre of travel. A damper on the line of the spring is left out.
fn ratios(pose: &Pose<f64>) -> [Option<f64>; 2] {
    let motion = pose.motions.map(|motions| motions.travel);
    let ratio = |line: Option<Line<f64>>, rates: Option<Line<f64>>| {
        let (line, rates) = (line?, rates?);
        Some(dot(line.direction(), sub(rates.to, rates.from)))
    };
    let damper = if pose.damper == pose.spring { None } else { pose.damper };
    [
        ratio(pose.spring, motion.and_then(|motion| motion.spring)),
        ratio(damper, motion.and_then(|motion| motion.damper)),
    ]
}
