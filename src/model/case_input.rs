//! What the columns of load cases say.

use super::{Quantity, Side};

/// The names of the components of a load.
pub const LOAD_COMPONENTS: [&str; 6] = ["fx", "fy", "fz", "mx", "my", "mz"];

/// What a column of cases says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CaseInput {
    /// Travel of a wheel, or of both.
    Travel(Option<Side>),
    /// Vertical force of the rig on a wheel, or on each of both, instead of a travel.
    WheelForce(Option<Side>),
    /// Displacement of the rack.
    Rack,
    /// A component of the load on a wheel, or on each of both, by its position in [`LOAD_COMPONENTS`].
    Load(usize, Option<Side>),
}

impl CaseInput {
    /// What its values are.
    pub fn quantity(self) -> Quantity {
        match self {
            Self::Travel(_) | Self::Rack => Quantity::Length,
            Self::WheelForce(_) => Quantity::Force,
            Self::Load(component, _) if component < 3 => Quantity::Force,
            Self::Load(..) => Quantity::Torque,
        }
    }

    /// What a positive value means.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Travel(_) => "+ jounce",
            Self::WheelForce(_) => "+ up on the wheel",
            Self::Rack => "+ along the model's +y",
            Self::Load(component, _) if component < 3 => "+ along the model's axis",
            Self::Load(..) => "+ right-handed about the model's axis",
        }
    }

    /// The wheel that it belongs to.
    pub fn side(self) -> Option<Side> {
        match self {
            Self::Travel(side) | Self::WheelForce(side) | Self::Load(_, side) => side,
            Self::Rack => None,
        }
    }

    /// Whether it holds a wheel vertically.
    pub fn holds(self) -> bool {
        matches!(self, Self::Travel(_) | Self::WheelForce(_))
    }

    /// The input without its side: what two columns must not say of one wheel.
    fn subject(self) -> Self {
        match self {
            Self::Travel(_) => Self::Travel(None),
            Self::WheelForce(_) => Self::WheelForce(None),
            Self::Load(component, _) => Self::Load(component, None),
            Self::Rack => Self::Rack,
        }
    }

    /// Whether both say the same of one wheel.
    pub(crate) fn collides(self, other: Self) -> bool {
        let wheels = [self.side(), other.side()];
        self.subject() == other.subject() && (wheels[0] == wheels[1] || wheels.contains(&None))
    }

    /// All inputs with their names.
    pub(super) fn all() -> impl Iterator<Item = (String, Self)> {
        let sides = [None, Some(Side::Left), Some(Side::Right)].into_iter();
        let of_side = |side: Option<Side>| {
            let before = side.map_or_else(String::new, |side| format!("{}_", side.name()));
            let loads = LOAD_COMPONENTS.iter().enumerate();
            let loads = loads.map(|(component, name)| (*name, Self::Load(component, side)));
            let holds = [("travel", Self::Travel(side)), ("wheel_force", Self::WheelForce(side))];
            let named = holds.into_iter().chain(loads);
            named.map(|(name, input)| (format!("{before}{name}"), input)).collect::<Vec<_>>()
        };
        sides.flat_map(of_side).chain([("rack".to_owned(), Self::Rack)])
    }
}
