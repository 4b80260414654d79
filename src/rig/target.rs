//! What the rig does: events, plans, and the target of every state.

use super::hold::Hold;
use super::load::Load;
use crate::mechanism::DriverId;
use crate::model::{CaseInput, LoadCases, Side};

/// What changes in an event; all else is held. A corner takes the part of its side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// The wheel goes up and down, the rack is held. The wheels of an axle go in parallel.
    Travel,
    /// The left wheel goes up from what is held by as much as the right one goes down: roll with a
    /// constant track of the rig.
    Opposite,
    /// One wheel goes up and down, the other is held.
    Single(Side),
    /// The rack moves, the wheel is held.
    Steer,
    /// The chassis of an axle rolls; the wheels stay at their heights above the road.
    Roll,
    /// One component of the load on the wheel grows, by its position in
    /// [`LOAD_COMPONENTS`](super::LOAD_COMPONENTS). Both wheels of an axle carry the same.
    Load(usize),
    /// One component of the load grows on the left wheel, and as much against it on the right one.
    LoadOpposed(usize),
    /// One component of the load on one wheel grows.
    LoadSingle(usize, Side),
    /// A driver of a mechanism moves, all others are held.
    Driver(DriverId),
}

/// What holds the wheels vertically, and so what the values of travel events are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Vertical {
    /// Their travels (m).
    #[default]
    Travel,
    /// Forces of the rig on the wheels (N, positive up): those of the left and the right wheel where an
    /// event holds them.
    Force([f64; 2]),
    /// The same forces; the values of events are changes of them.
    ForceChange([f64; 2]),
}

/// What an event does not change.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// Travel of the wheel or wheels (m), where it is held.
    pub travel: f64,
    /// Travel of the right wheel of an axle (m), where it is another one.
    pub right_travel: Option<f64>,
    /// What holds the wheels.
    pub vertical: Vertical,
    /// Displacement of the rack (m).
    pub rack: f64,
    /// How the chassis of an axle that rolls is held vertically: at a heave (m), or by the force (N) of the
    /// rig on it, which keeps the load of the axle constant.
    pub heave: Hold,
    /// Load on the wheel (N and N·m).
    pub load: Load,
    /// Load on the right wheel of an axle, where it is another one.
    pub right_load: Option<Load>,
}

/// What the rig does at one state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    /// The left and the right wheel: travel (m) or vertical force (N, positive up on the wheel).
    pub wheels: [Hold; 2],
    /// Displacement of the rack (m).
    pub rack: f64,
    /// Load (N and N·m) on the left and the right wheel.
    pub load: [Load; 2],
    /// Roll angle (rad) of a chassis that rolls, right-handed about the x axis of the model.
    pub roll: f64,
    /// Heave (m) of such a chassis, or the vertical force (N) on it.
    pub heave: Hold,
    /// A driver of a mechanism and its value (m or rad).
    pub driver: Option<(DriverId, f64)>,
}

/// The vertical forces (N, positive up) with which the rig holds wheels and chassis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Supports {
    /// On the left and the right wheel.
    pub wheels: [f64; 2],
    /// On a chassis that rolls.
    pub chassis: f64,
}

/// The states that a sweep visits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepPlan {
    /// What moves.
    pub event: Event,
    /// First value (m, rad, N or N·m).
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// Distance of values; its sign does not matter. Zero leaves out all between first and last.
    pub step: f64,
    /// What is held.
    pub held: Held,
}

impl Held {
    /// What the rig does where no event has begun.
    pub fn target(&self) -> Target {
        let Self { travel, right_travel, vertical, rack, heave, load, right_load } = *self;
        let wheels = match vertical {
            Vertical::Travel => [travel, right_travel.unwrap_or(travel)].map(Hold::Value),
            Vertical::Force(forces) | Vertical::ForceChange(forces) => forces.map(Hold::Force),
        };
        let load = [load, right_load.unwrap_or(load)];
        Target { wheels, rack, load, heave, ..Target::default() }
    }
}

impl Target {
    /// What the rig does in each case of a file, with their names. What the cases do not say is as in `held`.
    pub fn of_cases(cases: &LoadCases, held: &Held) -> Vec<(String, Self)> {
        let target = |values: &[Option<f64>]| {
            let mut target = held.target();
            for (column, value) in cases.columns.iter().zip(values) {
                if let Some(value) = value {
                    target.set(column.input, *value);
                }
            }
            target
        };
        let named = cases.cases.iter();
        named.map(|case| (case.name.clone(), target(&case.values))).collect()
    }

    fn set(&mut self, input: CaseInput, value: f64) {
        let sides = input.side().map_or(0..2, |side| side.index()..side.index() + 1);
        match input {
            CaseInput::Rack => self.rack = value,
            CaseInput::Travel(_) => self.wheels[sides].fill(Hold::Value(value)),
            CaseInput::WheelForce(_) => self.wheels[sides].fill(Hold::Force(value)),
            CaseInput::Load(component, _) => {
                self.load[sides].iter_mut().for_each(|load| load.components[component] = value);
            }
        }
    }
}

impl SweepPlan {
    /// What the rig does at a value.
    pub fn target(&self, value: f64) -> Target {
        let mut target = self.held.target();
        let from_held = |hold: Hold, change: f64| match hold {
            Hold::Value(travel) => Hold::Value(travel + change),
            Hold::Force(force) => Hold::Force(force + change),
        };
        let wheel = |hold: Hold| match self.held.vertical {
            Vertical::Travel => Hold::Value(value),
            Vertical::Force(_) => Hold::Force(value),
            Vertical::ForceChange(_) => from_held(hold, value),
        };
        let (left, right) = (Side::Left.index(), Side::Right.index());
        let mut load = |component: usize, side: Side, value| {
            target.load[side.index()].components[component] = value;
        };
        match self.event {
            Event::Travel => target.wheels = target.wheels.map(wheel),
            Event::Opposite => {
                target.wheels[left] = from_held(target.wheels[left], value);
                target.wheels[right] = from_held(target.wheels[right], -value);
            }
            Event::Single(side) => {
                target.wheels[side.index()] = wheel(target.wheels[side.index()]);
            }
            Event::Steer => target.rack = value,
            Event::Roll => target.roll = value,
            Event::Load(component) => {
                load(component, Side::Left, value);
                load(component, Side::Right, value);
            }
            Event::LoadOpposed(component) => {
                load(component, Side::Left, value);
                load(component, Side::Right, -value);
            }
            Event::LoadSingle(component, side) => load(component, side, value),
            Event::Driver(driver) => target.driver = Some((driver, value)),
        }
        target
    }

    /// The values (m, rad, N or N·m), `from` first. `to` is the last value even where the distance is
    /// no multiple of the step.
    pub fn values(&self) -> Vec<f64> {
        let distance = self.to - self.from;
        let exact = (distance / self.step).abs();
        if exact.is_infinite() {
            return vec![self.from, self.to];
        }
        // A distance that is a multiple of the step but for rounding has no short last step.
        let whole = (exact + 1e-9).floor();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let steps = whole as usize;
        let step = self.step.abs().copysign(distance);
        #[allow(clippy::cast_precision_loss)]
        let mut values: Vec<f64> = (0..=steps)
            .map(|k| self.from + k as f64 * step)
            // Zero is zero, not what rounding leaves of it.
            .map(|value| if value.abs() < 1e-9 * step.abs() { 0.0 } else { value })
            .collect();
        if exact - whole > 1e-9 {
            values.push(self.to);
        } else if let Some(last) = values.last_mut() {
            *last = self.to;
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(from: f64, to: f64, step: f64) -> Vec<f64> {
        SweepPlan { event: Event::Travel, from, to, step, held: Held::default() }.values()
    }

    #[test]
    fn values_end_exactly_where_they_are_asked_to() {
        assert_eq!(values(-0.13, 0.13, 0.01).len(), 27);
        assert_eq!(values(-0.13, 0.13, 0.01).last(), Some(&0.13));
        assert_eq!(values(0.0, 1.0, 0.4), [0.0, 0.4, 0.8, 1.0]);
        assert_eq!(values(1.0, 0.0, 0.5), [1.0, 0.5, 0.0]);
        assert_eq!(values(2.0, 2.0, 0.5), [2.0]);
        assert_eq!(values(0.0, 1.0, 0.0), [0.0, 1.0]);
        assert_eq!(values(-0.3, 0.1, 0.1)[3], 0.0);
    }

    #[test]
    fn wheels_are_held_by_travels_or_by_forces() {
        let wheels = |event, vertical| {
            let held = Held { travel: 0.01, right_travel: Some(0.02), vertical, ..Held::default() };
            SweepPlan { event, from: 0.0, to: 1.0, step: 1.0, held }.target(5.0).wheels
        };
        let (travel, forces) = (Vertical::Travel, [100.0, 200.0]);
        let (force, change) = (Vertical::Force(forces), Vertical::ForceChange(forces));
        let right = Event::Single(Side::Right);
        assert_eq!(wheels(Event::Travel, travel), [5.0; 2].map(Hold::Value));
        assert_eq!(wheels(Event::Opposite, travel), [5.01, -4.98].map(Hold::Value));
        assert_eq!(wheels(right, travel), [0.01, 5.0].map(Hold::Value));
        assert_eq!(wheels(Event::Steer, travel), [0.01, 0.02].map(Hold::Value));
        assert_eq!(wheels(Event::Travel, force), [5.0; 2].map(Hold::Force));
        assert_eq!(wheels(Event::Travel, change), [105.0, 205.0].map(Hold::Force));
        assert_eq!(wheels(Event::Opposite, force), [105.0, 195.0].map(Hold::Force));
        assert_eq!(wheels(right, force), [100.0, 5.0].map(Hold::Force));
        assert_eq!(wheels(right, change), [100.0, 205.0].map(Hold::Force));
        assert_eq!(wheels(Event::Steer, change), forces.map(Hold::Force));
    }
}
