//! The events of corners and axles, by their names on the command line.

use std::f64::consts::{FRAC_PI_6, PI};

use clap::{Args, ValueEnum};
use hardpoint::model::{Model, Quantity, Side, Units};
use hardpoint::rig::{Event, LOAD_COMPONENTS, Supports, Vertical};

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
    /// The body of an axle rolls about the static roll centre, its height held; the wheels stay on the
    /// ground (Lotus' roll).
    Roll,
    /// The body of an axle rolls and heaves so that the load of the axle stays what it is without roll
    /// (Adams' roll and vertical force).
    RollLoad,
    /// The wheels go up and down at each of several rack displacements; see --over.
    Envelope,
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

/// What holds the wheels vertically.
#[derive(Args)]
pub struct VerticalOptions {
    /// What holds the wheels vertically, and what the values of travel events are [default: travel].
    #[arg(long, value_enum)]
    vertical: Option<VerticalName>,
    /// Vertical force on each wheel that is held by a force [default: that at the held travel].
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    wheel_force: Option<f64>,
}

/// What holds the wheels vertically.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum VerticalName {
    /// Their travels.
    Travel,
    /// Vertical forces of the rig on the wheels, constant where they do not change.
    Force,
    /// The same; the values of travel events are changes of the forces.
    ForceChange,
}

impl VerticalOptions {
    /// Whether forces hold the wheels.
    pub fn is_force(&self) -> bool {
        self.vertical.is_some_and(|name| name != VerticalName::Travel)
    }

    /// Whether an option was given.
    pub fn given(&self) -> Option<&'static str> {
        let given = [
            (self.vertical.is_some(), "--vertical"),
            (self.wheel_force.is_some(), "--wheel-force"),
        ];
        given.into_iter().find(|(given, _)| *given).map(|(_, option)| option)
    }

    /// Refuses what does not belong to the event or the model.
    pub fn check(&self, event: EventName, has_forces: bool) -> Result<(), Failure> {
        let usage = |message: &str| Err(Failure::Usage(message.to_owned()));
        if self.wheel_force.is_some_and(|force| !force.is_finite()) {
            return usage("--wheel-force is not a finite number");
        }
        if !self.is_force() {
            return match self.wheel_force {
                Some(_) => usage("--wheel-force belongs to --vertical force or force-change"),
                None => Ok(()),
            };
        }
        if !has_forces {
            return usage(
                "no force holds the wheels of a model without forces; add [[forces]] to the model",
            );
        }
        if matches!(event, EventName::Roll | EventName::RollLoad) {
            return usage(
                "in roll the wheels stay at their heights; leave out --vertical, or choose roll-load",
            );
        }
        Ok(())
    }

    /// What holds the wheels, from the forces at the held travel.
    pub fn vertical(&self, supports: &Supports, units: Units) -> Vertical {
        let force = self.wheel_force.map(|force| [Quantity::Force.to_si(units, force); 2]);
        let forces = force.unwrap_or(supports.wheels);
        match self.vertical {
            None | Some(VerticalName::Travel) => Vertical::Travel,
            Some(VerticalName::Force) => Vertical::Force(forces),
            Some(VerticalName::ForceChange) => Vertical::ForceChange(forces),
        }
    }
}

impl Course {
    /// The course of wheels that forces hold: the values of travel events are forces. Those that are not
    /// changes from what is held have no range of their own.
    pub fn held(self, vertical: &VerticalOptions, ranged: bool) -> Result<Self, Failure> {
        let event = self.event;
        let moves = matches!(event, Event::Travel | Event::Opposite | Event::Single(_));
        if !moves || !vertical.is_force() {
            return Ok(self);
        }
        let changes =
            event == Event::Opposite || vertical.vertical == Some(VerticalName::ForceChange);
        if !changes && !ranged {
            return Err(Failure::Usage(
                "say the range of the wheel force with --from and --to".into(),
            ));
        }
        let what = if changes { "force change" } else { "force" };
        let name = match self.name.strip_suffix("travel") {
            Some(before) => format!("{before}{what}"),
            None => what.to_owned(),
        };
        Ok(Self { quantity: Quantity::Force, range: [-1000.0, 1000.0], step: 100.0, name, event })
    }

    /// The event of a corner. A load event changes the component `vary`, a steer event goes `by` rack or
    /// steering wheel.
    pub fn of_corner(
        event: EventName,
        model: &Model,
        vary: Option<&str>,
        by: SteerBy,
    ) -> Result<Self, Failure> {
        match event {
            EventName::Travel | EventName::Envelope => Ok(Self::travel(Event::Travel, "travel")),
            EventName::Steer => Self::steer(model, by),
            EventName::Load => {
                let (component, name) = component(vary)?;
                Ok(Self::load(Event::Load(component), component, format!("load {name}")))
            }
            _ => Err(Failure::Usage(
                "parallel, opposite, left, right, roll and roll-load are events of both wheels; \
                 add --axle"
                    .into(),
            )),
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
            EventName::Travel | EventName::Parallel | EventName::Envelope => {
                Self::travel(Event::Travel, "parallel travel")
            }
            EventName::Opposite => Self::travel(Event::Opposite, "opposite travel"),
            EventName::Left => Self::travel(Event::Single(Side::Left), "left travel"),
            EventName::Right => Self::travel(Event::Single(Side::Right), "right travel"),
            EventName::Steer => Self::steer(model, by)?,
            EventName::Roll | EventName::RollLoad => {
                let (event, quantity, name) = (Event::Roll, Quantity::Angle, "roll".to_owned());
                let range = [-PI / 60.0, PI / 60.0];
                Self { event, quantity, range, step: PI / 360.0, name }
            }
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
