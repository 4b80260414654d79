//! The events of corners and axles, by their names on the command line.

use std::f64::consts::FRAC_PI_6;

use clap::ValueEnum;
use hardpoint::model::{Model, Quantity, Side};
use hardpoint::rig::{Event, LOAD_COMPONENTS};

use crate::failure::Failure;
use crate::loads;
use crate::steering::{SteerBy, rack_per_radian};

/// What changes.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum EventName {
    /// The wheel goes up and down; both wheels of an axle.
    Travel,
    /// Both wheels of an axle go up and down.
    Parallel,
    /// The left wheel of an axle goes up by as much as the right one goes down.
    Opposite,
    /// The left wheel of an axle goes up and down.
    Left,
    /// The right wheel of an axle goes up and down.
    Right,
    /// The rack moves from side to side.
    Steer,
    /// One component of the load on the wheel grows.
    Load,
}

/// The wheels that a load event loads.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Wheels {
    /// Both, in the same direction.
    Parallel,
    /// The left one, and the right one against it.
    Opposed,
    /// The left one.
    Left,
    /// The right one.
    Right,
}

/// An event and how it goes where the user says no more.
pub struct Course {
    /// What changes.
    pub event: Event,
    /// What its values are.
    pub quantity: Quantity,
    /// First and last value (SI).
    pub range: [f64; 2],
    /// Distance of the values (SI).
    pub step: f64,
    /// The name for reports.
    pub name: String,
}

impl Course {
    /// The event of a corner. A load event changes the component `vary`, a steer event goes `by` rack or
    /// steering wheel.
    pub fn of_corner(
        event: EventName,
        model: &Model,
        vary: Option<&str>,
        by: SteerBy,
    ) -> Result<Self, Failure> {
        match event {
            EventName::Travel => Ok(Self::travel(Event::Travel, "travel")),
            EventName::Steer => Self::steer(model, by),
            EventName::Load => {
                let (component, name) = component(vary)?;
                Ok(Self::load(Event::Load(component), component, format!("load {name}")))
            }
            EventName::Parallel | EventName::Opposite | EventName::Left | EventName::Right => {
                Err(Failure::Usage(
                    "parallel, opposite, left and right are events of both wheels; add --axle"
                        .into(),
                ))
            }
        }
    }

    /// The event of an axle, as for a corner. A load event loads the `wheels`.
    pub fn of_axle(
        event: EventName,
        model: &Model,
        vary: Option<&str>,
        by: SteerBy,
        wheels: Option<Wheels>,
    ) -> Result<Self, Failure> {
        Ok(match event {
            EventName::Travel | EventName::Parallel => {
                Self::travel(Event::Travel, "parallel travel")
            }
            EventName::Opposite => Self::travel(Event::Opposite, "opposite travel"),
            EventName::Left => Self::travel(Event::Single(Side::Left), "left travel"),
            EventName::Right => Self::travel(Event::Single(Side::Right), "right travel"),
            EventName::Steer => Self::steer(model, by)?,
            EventName::Load => {
                let (component, name) = component(vary)?;
                let (event, wheels) = match wheels.unwrap_or(Wheels::Parallel) {
                    Wheels::Parallel => (Event::Load(component), "parallel"),
                    Wheels::Opposed => (Event::LoadOpposed(component), "opposed"),
                    Wheels::Left => (Event::LoadSingle(component, Side::Left), "left"),
                    Wheels::Right => (Event::LoadSingle(component, Side::Right), "right"),
                };
                Self::load(event, component, format!("{wheels} load {name}"))
            }
        })
    }

    fn travel(event: Event, name: &str) -> Self {
        let quantity = Quantity::Length;
        Self { event, quantity, range: [-0.13, 0.13], step: 0.01, name: name.to_owned() }
    }

    /// The steer event of a model, from one limit of its rack to the other, by rack or steering wheel.
    fn steer(model: &Model, by: SteerBy) -> Result<Self, Failure> {
        let range = model.steering.and_then(|steering| steering.limits).unwrap_or([-0.04, 0.04]);
        let (event, name) = (Event::Steer, "steer".to_owned());
        if by == SteerBy::Rack {
            return Ok(Self { event, quantity: Quantity::Length, range, step: 0.005, name });
        }
        let per_radian = rack_per_radian(model)?;
        let mut range = range.map(|rack| rack / per_radian);
        range.sort_by(f64::total_cmp);
        Ok(Self { event, quantity: Quantity::Angle, range, step: FRAC_PI_6, name })
    }

    fn load(event: Event, component: usize, name: String) -> Self {
        let range = if component < 3 { 1000.0 } else { 100.0 };
        let quantity = loads::quantity(component);
        Self { event, quantity, range: [-range, range], step: range / 10.0, name }
    }
}

/// The component of a load that changes, and its name.
fn component(vary: Option<&str>) -> Result<(usize, &str), Failure> {
    let Some(name) = vary else {
        return Err(Failure::Usage(
            "say which component of the load changes, such as --vary fx".into(),
        ));
    };
    let Some(component) = loads::component(name) else {
        return Err(Failure::Usage(format!(
            "there is no load component `{name}`; the choices are {}",
            LOAD_COMPONENTS.join(", ")
        )));
    };
    Ok((component, name))
}
