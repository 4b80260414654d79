//! The working range: its end, dead centres, and links that come near to each other.
#![allow(missing_docs)]

#[path = "common/program.rs"]
mod program;

use hardpoint::model::{Model, Setup};
use hardpoint::programme::WorkingRange;
use hardpoint::rig::{Axle, Danger, NEARLY_DEAD};
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

/// Whatever the order of the bodies of its joint, an arm goes from both of its pivots to its outer joint; one that
/// carries a pushrod, too. What turns on a pivot in the middle of a link does not touch it there.
#[test]
fn arms_are_links_on_both_legs() {
    let text = std::fs::read_to_string("architectures/double-wishbone.toml").unwrap();
    let plain = range("double-wishbone", 0.05, &[0.0]);
    let turned = text.replace(r#"["chassis", "lca"]"#, r#"["lca", "chassis"]"#);
    assert_ne!(text, turned);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("own.toml"), turned).unwrap();
    let text = std::fs::read_to_string("models/double-wishbone.toml").unwrap();
    let text = text.replace("\"double-wishbone\"", "\"own.toml\"");
    let path = folder.path().join("model.toml");
    std::fs::write(&path, text).unwrap();
    let own = Model::load(path).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()));
    let own = WorkingRange::find(&own, &Setup::default(), 0.05, &[0.0]).unwrap();
    let sorted = |found: &WorkingRange| {
        let pairs = found.clearances.iter().map(|pair| (pair.links.join(" "), pair.distance));
        let mut pairs: Vec<(String, f64)> = pairs.collect();
        pairs.sort_by(|a, b| a.0.cmp(&b.0));
        pairs
    };
    let (own, plain_pairs) = (sorted(&own), sorted(&plain));
    assert_eq!(own.len(), plain_pairs.len());
    for (own, plain) in own.iter().zip(&plain_pairs) {
        assert!(own.0 == plain.0 && (own.1 - plain.1).abs() < 1e-12, "{own:?} {plain:?}");
    }
    let has = |found: &WorkingRange, a: &str, b: &str| {
        found.clearances.iter().any(|pair| pair.links == [a, b] || pair.links == [b, a])
    };
    assert!(has(&plain, "left_lca", "left_tierod"));
    assert!(has(&range("double-wishbone-pushrod", 0.05, &[0.0]), "left_lca", "left_tierod"));
    // A rigid link without a body is one, too.
    let steered = range("solid-axle-steered", 0.05, &[0.0]);
    assert!(has(&steered, "draglink", "left_upper_link"), "{:?}", steered.clearances);
    assert!(!has(&range("de-dion", 0.05, &[0.0]), "axle", "watt_crank"));
}

/// A rocker goes over the centre of its spring, then the pushrod locks up.
#[test]
fn events_warn_of_dead_centres() {
    let model = "models/double-wishbone-pushrod.toml";
    let sweep = |more: &[&str]| stderr(&hardpoint(&[&["sweep", model], more].concat()));
    let quiet = sweep(&["--from", "-80", "--to", "80"]);
    assert_eq!(quiet, "");
    let told = sweep(&["--from", "0", "--to", "120", "--step", "10"]);
    let line = "warning: left wheel between 100 mm and 110 mm: dead centre of the spring: its motion ratio \
                changes its sign";
    assert_eq!(told.trim_end(), line);
    let told = sweep(&["--from", "-97.64", "--to", "-90", "--step", "0.02"]);
    let line = told.lines().next().expect("a warning");
    assert!(line.starts_with("warning: left wheel from -9"), "{line}");
    assert!(line.contains(" to -97.64 mm: near to a dead centre: "), "{line}");
    assert_eq!(told.lines().count(), 1, "{told}");
    let near = range("double-wishbone-pushrod", 0.0976, &[0.0]);
    let spring = near.warnings.iter().filter(|w| matches!(w.danger, Danger::Turns { .. })).count();
    assert_eq!(spring, 0, "{:?}", near.warnings);
}

#[test]
fn check_tells_the_working_range() {
    let check = |arguments: &[&str]| hardpoint(&[&["check"], arguments].concat());
    let text = stdout(&check(&["models/lotus-front.toml", "--range", "200"]).success());
    assert!(text.contains("left_uca – left_tierod"), "{text}");
    assert!(text.contains("they cross before: one would cut the other"), "{text}");
    let text = stdout(&check(&["models/double-wishbone.toml", "--range"]).success());
    assert!(text.contains("±80.0 mm: 99 states reached"), "{text}");
    assert!(text.contains("no two links come nearer than 30.0 mm"), "{text}");
    assert!(text.contains("smallest distances of middle lines, 8 of "), "{text}");
    let asked = ["models/double-wishbone.toml", "--range", "--clearance", "100"];
    let text = stdout(&check(&asked).success());
    assert!(text.contains("pairs of links come nearer than 100.0 mm"), "{text}");
    assert!(text.contains("  nearer than asked"), "{text}");
    let text = stdout(&check(&["models/double-wishbone-pushrod.toml", "--range", "110"]).success());
    assert!(
        text.contains("left wheel, from travel 103.1 mm, rack 0.0 mm to travel 110.0 mm"),
        "{text}"
    );
    assert!(
        text.contains("dead centre of the spring: its motion ratio changes its sign"),
        "{text}"
    );
    for (arguments, words) in [
        (&["models/pendulum.toml", "--range"][..], "this file is a mechanism"),
        (
            &["models/double-wishbone.toml", "--range", "--clearance", "-1"],
            "--clearance is not a positive length",
        ),
        (&["models/double-wishbone.toml", "--range", "0"], "--range is not a positive length"),
    ] {
        let told = stderr(&check(arguments).code(2));
        assert!(told.contains(words), "{told}");
    }
}
