//! The working range: its end, dead centres, and links that come near to each other.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use hardpoint::model::{Model, Setup};
use hardpoint::programme::{NEARLY_DEAD, WorkingRange};
use hardpoint::rig::Axle;
use program::{hardpoint, stderr, stdout};

fn model(name: &str) -> Model {
    let path = format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    Model::load(path).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

fn range(name: &str, travel: f64, racks: &[f64]) -> WorkingRange {
    WorkingRange::find(&model(name), &Setup::default(), travel, racks).unwrap()
}

/// The least distance of the tie rod and a part of the upper arm, from a thousand points of each.
#[test]
fn clearances_are_those_of_the_lines() {
    let found = range("lotus-front", 0.08, &[0.0]);
    let links = |a: &str, b: &str| {
        let mut all = found.clearances.iter();
        all.find(|found| found.links == [a, b]).expect("both are links").clone()
    };
    let nearest = links("left_uca", "left_tierod");
    assert!(!nearest.crosses);
    let mut axle = Axle::new(&model("lotus-front"), &Setup::default()).unwrap();
    axle.move_to([nearest.at.travel; 2], nearest.at.rack).unwrap();
    let stand = axle.stand();
    let (mechanism, state) = (stand.mechanism(), stand.state());
    let place = |body: &str, point: &str| {
        let body = mechanism.body_named(body).unwrap();
        let point = mechanism.point_named(point).unwrap();
        hardpoint::solve::point_position(mechanism, state, body, point)
    };
    let rod =
        [place("left_tierod", "left_tierod_inner"), place("left_tierod", "left_tierod_outer")];
    let outer = place("left_uca", "left_uca_outer");
    let parts = ["left_uca_front", "left_uca_rear"].map(|point| [place("left_uca", point), outer]);
    let along = |[from, to]: [[f64; 3]; 2], part: f64| {
        [0, 1, 2].map(|k| from[k] + part * (to[k] - from[k]))
    };
    let mut least = f64::INFINITY;
    for part in parts {
        for i in 0..=1000 {
            for j in 0..=1000 {
                let a = along(rod, f64::from(i) / 1000.0);
                let b = along(part, f64::from(j) / 1000.0);
                let square: f64 = (0..3).map(|k| (a[k] - b[k]).powi(2)).sum();
                least = least.min(square.sqrt());
            }
        }
    }
    assert!((nearest.distance - least).abs() < 1e-6, "{} {least}", nearest.distance);
    assert!(nearest.distance <= least);
}

#[test]
fn a_symmetric_axle_has_symmetric_clearances() {
    let found = range("sedan-axle", 0.05, &[-0.02, 0.0, 0.02]);
    assert!(found.stops.is_empty() && found.states == 99, "{found:?}");
    let least = |side: &str| {
        let of = |name: &String| name.starts_with(side);
        let mut all = found.clearances.iter().filter(|found| found.links.iter().all(of));
        all.next().expect("the side has links").distance
    };
    assert!((least("left_") - least("right_")).abs() < 1e-9);
}

/// Far up, the arms stretch: joints race before the mechanism stops.
#[test]
fn the_end_of_the_range_is_a_dead_centre() {
    let found = range("lotus-front", 0.4, &[0.0]);
    assert!(!found.stops.is_empty());
    let far = found.fastest.expect("something moves");
    let near = range("lotus-front", 0.05, &[0.0]).fastest.expect("something moves");
    assert!(near.ratio < 2.0 && far.ratio > near.ratio, "{near:?} {far:?}");
    assert!(near.ratio < NEARLY_DEAD);
}

#[test]
fn check_tells_the_working_range() {
    let check = |arguments: &[&str]| hardpoint(&[&["check"], arguments].concat());
    let text = stdout(&check(&["models/lotus-front.toml", "--range", "200"]).success());
    assert!(text.contains("left_uca and left_tierod cross before travel"), "{text}");
    let text = stdout(&check(&["models/double-wishbone.toml", "--range"]).success());
    assert!(text.contains("±80.0 mm: 99 states reached"), "{text}");
    assert!(text.contains("no two links come nearer than 30.0 mm"), "{text}");
    for (arguments, words) in [
        (&["models/pendulum.toml", "--range"][..], "this file is a mechanism"),
        (&["models/double-wishbone.toml", "--range", "0"], "--range is not a positive length"),
    ] {
        let told = stderr(&check(arguments).code(2));
        assert!(told.contains(words), "{told}");
    }
}
