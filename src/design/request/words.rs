//! States of the rig in words.

use crate::model::{CaseInput, LOAD_COMPONENTS, Quantity, Side, Units};
use crate::rig::{Hold, Target};

/// What the rig holds at a state, such as `travel 30 mm, rack -5 mm`; empty at the design position.
pub fn state_words(state: &Target, units: Units) -> String {
    let mut words = vec![];
    let shown = |quantity: Quantity, value: f64| {
        format!("{} {}", short(quantity.show(units, value)), quantity.symbol(units))
    };
    let [left, right] = state.wheels;
    let wheels: &[(&str, Hold)] = match left == right {
        true => &[("", left)],
        false => &[("left ", left), ("right ", right)],
    };
    for (side, hold) in wheels {
        match hold {
            Hold::Value(0.0) => {}
            Hold::Value(travel) => {
                words.push(format!("{side}travel {}", shown(Quantity::Length, *travel)));
            }
            Hold::Force(force) => {
                words.push(format!("{side}wheel force {}", shown(Quantity::Force, *force)));
            }
        }
    }
    if state.rack != 0.0 {
        words.push(format!("rack {}", shown(Quantity::Length, state.rack)));
    }
    for (component, name) in LOAD_COMPONENTS.iter().enumerate() {
        let quantity = CaseInput::Load(component, None).quantity();
        let values = state.load.map(|load| load.components[component]);
        let both = values[0] == values[1];
        for (side, value) in [Side::Left, Side::Right].into_iter().zip(values) {
            match (value == 0.0, both, side) {
                (true, ..) | (_, true, Side::Right) => {}
                (_, true, _) => words.push(format!("{name} {}", shown(quantity, value))),
                _ => words.push(format!("{} {name} {}", side.name(), shown(quantity, value))),
            }
        }
    }
    if state.roll != 0.0 {
        words.push(format!("roll {}", shown(Quantity::Angle, state.roll)));
    }
    words.join(", ")
}

/// A number as short as it can be to six decimals.
pub fn short(value: f64) -> String {
    ((value * 1e6).round() / 1e6 + 0.0).to_string()
}
