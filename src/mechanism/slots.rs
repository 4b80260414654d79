//! Where the values of drivers are among the parameters h.

use std::ops::Range;

use super::topology::DriverId;

/// The parameters that the value of each driver is added to, each with its factor.
#[derive(Clone, Debug, Default)]
pub struct DriverSlots {
    list: Vec<Vec<(usize, f64)>>,
}

impl DriverSlots {
    /// Adds the parameters of the next driver.
    pub(super) fn push(&mut self, slots: Vec<(usize, f64)>) {
        self.list.push(slots);
    }

    /// Gives a driver other parameters.
    pub(super) fn replace(&mut self, driver: DriverId, slots: Vec<(usize, f64)>) {
        self.list[driver.0] = slots;
    }

    /// The parameters of a driver: one, with the factor 1, for a driver that prescribes a motion.
    pub fn of(&self, driver: DriverId) -> &[(usize, f64)] {
        &self.list[driver.0]
    }

    /// Whether a driver changes one of these parameters.
    pub(super) fn changes(&self, parameters: Range<usize>) -> bool {
        self.list.iter().flatten().any(|(slot, _)| parameters.contains(slot))
    }

    /// How the three parameters from `first` on change per unit of a driver.
    pub fn rate(&self, driver: DriverId, first: usize) -> [f64; 3] {
        let mut rate = [0.0; 3];
        for &(slot, factor) in self.of(driver) {
            if let Some(entry) = slot.checked_sub(first).and_then(|k| rate.get_mut(k)) {
                *entry += factor;
            }
        }
        rate
    }

    /// Writes the parameters that the drivers change to `h`. `base` has all parameters with
    /// the drivers at zero, `values` the value (m or rad) of every driver.
    pub fn set(&self, base: &[f64], values: &[f64], h: &mut [f64]) {
        // Two adjusters may change one parameter.
        for &(slot, _) in self.list.iter().flatten() {
            h[slot] = base[slot];
        }
        for (slots, value) in self.list.iter().zip(values) {
            for &(slot, factor) in slots {
                h[slot] += factor * value;
            }
        }
    }

    /// Adds what the parameters change by when the drivers go this far.
    pub fn add(&self, ways: impl IntoIterator<Item = (DriverId, f64)>, dh: &mut [f64]) {
        for (driver, way) in ways {
            for &(slot, factor) in self.of(driver) {
                dh[slot] += factor * way;
            }
        }
    }
}
