//! How a stand moves and what it takes, near one of its states.

use super::view::View;
use crate::mechanism::{DriverId, DriverSlots};
use crate::solve::linearised::Linearised;
use crate::solve::{System, Tangent};
use crate::vector::Vector;

/// All derivatives of a stand at its state, from one factorisation. The stand cannot change meanwhile.
pub struct Rates<'a> {
    /// Asked for motions where joints and drivers alone say how bodies move, or there are no forces.
    system: Option<&'a mut System>,
    equilibrium: Linearised<'a>,
    /// Whether the state is one of equilibrium.
    found: bool,
    released: &'a [DriverId],
    positions: &'a [Vector<f64>],
}

impl<'a> Rates<'a> {
    /// Released drivers are held as far as rates go, where the state is one of equilibrium.
    pub(super) fn new(
        system: Option<&'a mut System>,
        equilibrium: Linearised<'a>,
        found: bool,
        released: &'a [DriverId],
        positions: &'a [Vector<f64>],
    ) -> Self {
        Self { system, equilibrium: equilibrium.holding(released), found, released, positions }
    }

    /// How all bodies move per unit (m or rad) of a driver, the other drivers held: as the joints
    /// allow where they determine the position, else along states of equilibrium. So a released
    /// driver is one whose force changes as its value does.
    /// `None` in a dead centre, where equilibrium is sought but not found or not isolated, and for
    /// a released driver of a mechanism without forces.
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn tangent(&mut self, driver: DriverId) -> Option<Tangent<'_>> {
        match &mut self.system {
            Some(_) if self.released.contains(&driver) => None,
            Some(system) => system.tangent(driver).ok(),
            None if self.found => Some(self.equilibrium.tangent(driver).ok()?.motion),
            None => None,
        }
    }

    /// As [`Self::tangent`], for the last question.
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn into_tangent(self, driver: DriverId) -> Option<Tangent<'a>> {
        match self.system {
            Some(_) if self.released.contains(&driver) => None,
            Some(system) => system.tangent(driver).ok(),
            None if self.found => Some(self.equilibrium.into_tangent(driver).ok()?.motion),
            None => None,
        }
    }

    /// How the force (N) or moment (N·m) that holds a driver grows with its value, −dλ/dv, the other
    /// drivers held. `None` where the state is no equilibrium, or one that is not isolated.
    ///
    /// # Panics
    /// If the driver belongs to another mechanism.
    pub fn driver_rate(&mut self, driver: DriverId) -> Option<f64> {
        if !self.found {
            return None;
        }
        self.equilibrium.driver_rate(driver).ok()
    }

    /// How the force (N) or moment (N·m) that holds a driver grows with the value of another one. `None` as
    /// for [`Self::driver_rate`].
    ///
    /// # Panics
    /// If a driver belongs to another mechanism, or is an adjuster and holds nothing.
    pub fn force_rate(&mut self, held: DriverId, by: DriverId) -> Option<f64> {
        if !self.found {
            return None;
        }
        let equation = self.equilibrium.at().equation_of(held);
        Some(-self.equilibrium.tangent(by).ok()?.multiplier(equation))
    }

    /// The state.
    pub(super) fn view(&self) -> View<'_, f64> {
        View::of(self.equilibrium.at(), self.positions)
    }

    /// Which parameters the drivers change.
    pub(super) fn slots(&self) -> &DriverSlots {
        self.equilibrium.at().driver_slots()
    }

    /// The linearised equilibrium itself.
    pub fn equilibrium(&mut self) -> &mut Linearised<'a> {
        &mut self.equilibrium
    }
}
