//! Loads that the rig puts on a wheel.

use super::adjust::Home;
use super::line::Wheel;
use crate::mechanism::{
    BodyId, ForceId, ForceKind, Law, LoadFrame, Mechanism, MechanismError, Owner,
};
use crate::model::{self, Axes, LOAD_COMPONENTS};
use crate::solve::equilibrium::Equilibrium;

/// The end of the name of the point at which the rig loads a wheel.
pub(super) const PATCH: &str = "contact patch at design";

/// Where a load acts on the wheel's body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LoadPoint {
    /// The point of the wheel's body that is the contact patch in the static state, or at the design position.
    #[default]
    ContactPatch,
    /// The wheel centre.
    WheelCenter,
}

impl LoadPoint {
    /// The name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::ContactPatch => "contact-patch",
            Self::WheelCenter => "wheel-center",
        }
    }
}

/// Force (N) along and moment (N·m) about the axes of the model; both keep their direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// Fx, Fy, Fz, Mx, My, Mz.
    pub components: [f64; 6],
}

/// The force elements by which the rig loads a wheel.
#[derive(Clone, Debug)]
pub(super) struct WheelLoads {
    forces: [ForceId; 6],
}

impl WheelLoads {
    /// Adds the elements, all without force, to the wheel of a mechanism. Their names have the prefix.
    pub(super) fn add(
        mechanism: &mut Mechanism,
        wheel: &model::Wheel,
        prefix: &str,
        point: LoadPoint,
        home: Option<&Home<f64>>,
        axes: Axes,
    ) -> Result<Self, MechanismError> {
        let at = match point {
            LoadPoint::WheelCenter => wheel.center,
            LoadPoint::ContactPatch => {
                let center = mechanism.points()[wheel.center.index()].position;
                let disc = Wheel { center, spin: wheel.spin_axis, radius: wheel.radius };
                let patch = home.map_or_else(|| disc.contact_patch(), |home| home.patch(center));
                mechanism.add_point(&format!("{prefix}{PATCH}"), patch)?
            }
        };
        let mut forces = vec![];
        for (component, name) in LOAD_COMPONENTS.into_iter().enumerate() {
            let mut direction = [0.0; 3];
            direction[component % 3] = 1.0;
            let (direction, frame, size) = (axes.to_iso(direction), LoadFrame::Space, 0.0);
            let kind = if component < 3 {
                ForceKind::PointForce { at, frame, direction, size }
            } else {
                ForceKind::Moment { frame, direction, size }
            };
            // Names of files are one word, so no force of a model has this name.
            let name = format!("{prefix}rig load {name}");
            forces.push(mechanism.add_force(&name, BodyId::GROUND, wheel.body, kind)?);
        }
        let forces = forces.try_into().expect("there are six components");
        Ok(Self { forces })
    }

    /// Sets all components.
    pub(super) fn set(&self, equilibrium: &mut Equilibrium, load: &Load) {
        for (force, size) in self.forces.iter().zip(load.components) {
            let values: Vec<usize> = equilibrium
                .elements()
                .owners()
                .filter(|(owner, _)| *owner == Owner::Force(*force))
                .flat_map(|(_, values)| values)
                .collect();
            for value in values {
                equilibrium.elements_mut().laws_mut()[value] = Law::constant(-size);
            }
        }
    }
}
