//! What the programme consists of.

use super::stage::{Body, Stage};
use crate::model::{Model, Quantity, Side};
use crate::rig::{Event, LoadPoint};

/// How far the events go, to both sides (SI).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranges {
    /// Travel of both wheels in parallel (m).
    pub travel: f64,
    /// Roll of the body (rad).
    pub roll: f64,
    /// Displacement of the rack (m).
    pub rack: f64,
    /// Force on a wheel (N).
    pub force: f64,
    /// Moment on a wheel (N·m).
    pub moment: f64,
}

impl Default for Ranges {
    fn default() -> Self {
        let roll = 3.0_f64.to_radians();
        Self { travel: 0.08, roll, rack: 0.04, force: 2000.0, moment: 100.0 }
    }
}

impl Ranges {
    /// The default, the rack within the limits of the model.
    pub fn of(model: &Model) -> Self {
        let limits = model.steering.and_then(|steering| steering.limits);
        let nearer = |[a, b]: [f64; 2]| a.abs().min(b.abs());
        Self { rack: limits.map_or(Self::default().rack, nearer), ..Self::default() }
    }
}

/// The parts of events from one end to the middle.
const PARTS: f64 = 8.0;

/// In roll as many as in the printed reports of Lotus.
const PARTS_OF_ROLL: f64 = 10.0;

/// Of each value of a grid.
const PARTS_OF_GRID: f64 = 4.0;

/// Places of the components in [`LOAD_COMPONENTS`](crate::rig::LOAD_COMPONENTS).
const FX: usize = 0;
const FY: usize = 1;
const MX: usize = 3;
const MZ: usize = 5;

/// The events that an axle of a model can go through: those with loads need forces, those that steer a
/// rack.
pub fn standard(model: &Model, ranges: &Ranges) -> Vec<Stage> {
    let mut stages = travels(ranges);
    if model.axle_has_forces() {
        stages.push(Stage {
            name: "roll-load",
            title: "roll of the body at constant axle load",
            body: Body::RollsUnderLoad,
            ..roll(ranges)
        });
    }
    if model.steers() {
        stages.extend(steers(ranges));
    }
    if model.axle_has_forces() {
        stages.extend(loads(ranges));
    }
    stages
}

fn travel(event: Event, name: &'static str, title: &'static str, range: f64) -> Stage {
    Stage {
        name,
        title,
        event,
        quantity: Quantity::Length,
        range,
        step: range / PARTS,
        at: LoadPoint::ContactPatch,
        body: Body::Fixed,
        under_load: false,
        racks: vec![0.0],
    }
}

fn roll(ranges: &Ranges) -> Stage {
    Stage {
        quantity: Quantity::Angle,
        step: ranges.roll / PARTS_OF_ROLL,
        body: Body::Rolls,
        ..travel(Event::Roll, "roll", "roll of the body about the static roll centre", ranges.roll)
    }
}

fn travels(ranges: &Ranges) -> Vec<Stage> {
    let half = 0.5 * ranges.travel;
    vec![
        travel(Event::Travel, "parallel", "parallel wheel travel", ranges.travel),
        travel(Event::Opposite, "opposite", "opposite wheel travel", half),
        travel(Event::Single(Side::Left), "left", "travel of the left wheel", half),
        travel(Event::Single(Side::Right), "right", "travel of the right wheel", half),
        roll(ranges),
    ]
}

fn steers(ranges: &Ranges) -> [Stage; 2] {
    let steer = travel(Event::Steer, "steer", "steering by the rack", ranges.rack);
    let racks = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|part| part * ranges.rack);
    let title = "parallel wheel travel at several racks";
    let grid = travel(Event::Travel, "envelope", title, ranges.travel);
    [steer, Stage { step: ranges.travel / PARTS_OF_GRID, racks: racks.to_vec(), ..grid }]
}

fn loads(ranges: &Ranges) -> Vec<Stage> {
    let load = |event, name, title, at, is_moment| Stage {
        quantity: if is_moment { Quantity::Torque } else { Quantity::Force },
        at,
        under_load: true,
        ..travel(event, name, title, if is_moment { ranges.moment } else { ranges.force })
    };
    let (patch, center) = (LoadPoint::ContactPatch, LoadPoint::WheelCenter);
    let left = |component| Event::LoadSingle(component, Side::Left);
    vec![
        load(
            Event::Load(FX),
            "braking-parallel",
            "longitudinal force at both patches",
            patch,
            false,
        ),
        load(left(FX), "braking-left", "longitudinal force at the left patch", patch, false),
        load(
            Event::LoadOpposed(FX),
            "braking-opposed",
            "opposed longitudinal forces at the patches",
            patch,
            false,
        ),
        load(
            Event::Load(FX),
            "traction-parallel",
            "longitudinal force at both wheel centres",
            center,
            false,
        ),
        load(
            Event::LoadOpposed(FX),
            "traction-opposed",
            "opposed longitudinal forces at the wheel centres",
            center,
            false,
        ),
        load(Event::Load(FY), "lateral-parallel", "lateral force at both patches", patch, false),
        load(left(FY), "lateral-left", "lateral force at the left patch", patch, false),
        load(
            Event::LoadOpposed(FY),
            "lateral-opposed",
            "opposed lateral forces at the patches",
            patch,
            false,
        ),
        load(Event::Load(MZ), "aligning-parallel", "aligning moment on both wheels", patch, true),
        load(left(MZ), "aligning-left", "aligning moment on the left wheel", patch, true),
        load(Event::LoadOpposed(MZ), "aligning-opposed", "opposed aligning moments", patch, true),
        load(
            Event::LoadOpposed(MX),
            "overturning-opposed",
            "opposed overturning moments",
            patch,
            true,
        ),
    ]
}
