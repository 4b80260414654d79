//! The axle of the sedan and what can be changed of it.
#![allow(dead_code)] // Every test uses its part.

use hardpoint::model::Model;
use hardpoint::rig::{LOAD_COMPONENTS, Load};

pub const AXLE: &str = include_str!("../../models/sedan-axle.toml");

/// Changes of [`AXLE`] that cut the anti-roll bar, or take the tyres away.
pub const CUT: (&str, &str) = ("stiffness = 10000.0", "stiffness = 0.0");
pub const NO_TYRE: (&str, &str) =
    ("[tyre]\ncontact = \"contact-patch\"\nstiffness = 220.0\nground = -428.0\n", "");

/// The axle with some of its words exchanged.
pub fn axle(changes: &[(&str, &str)]) -> Model {
    let mut text = AXLE.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "`{from}` is not in the model");
        text = text.replace(from, to);
    }
    Model::parse("models/model.toml", &text).unwrap_or_else(|e| panic!("{}", e.render()))
}

pub fn load(components: &[(&str, f64)]) -> Load {
    let mut load = Load::default();
    for &(component, value) in components {
        let index = LOAD_COMPONENTS.iter().position(|name| *name == component);
        load.components[index.expect("the component exists")] = value;
    }
    load
}

#[track_caller]
pub fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let difference = (found - expected).abs();
    assert!(difference <= tolerance, "{what}: {found} for {expected}, off by {difference:e}");
}
