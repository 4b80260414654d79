//! Axles and suspensions of their own of Project Chrono, in files that are invented: points of both sides, masses,
//! springs about axes.
#![allow(missing_docs)]

use std::fs;

use hardpoint::import::{self, Imported};
use hardpoint::model::{Document, Model, Setup, Side};
use hardpoint::rig::{Axle, Stand};
use hardpoint::solve::System;

fn text(file: &str) -> String {
    let path = format!("tests/fixtures/import/{file}");
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

#[track_caller]
fn imported(file: &str) -> Imported {
    import::import(file, &text(file)).unwrap_or_else(|e| panic!("{}", e.diagnostics().render()))
}

fn model(imported: &Imported) -> Model {
    Model::parse("imported.toml", &imported.text).unwrap_or_else(|e| panic!("{}", e.render()))
}

fn table(imported: &Imported) -> toml::Table {
    imported.text.parse().expect("it is TOML")
}

fn numbers(value: &toml::Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_float().expect("a number")).collect()
}

#[track_caller]
fn near(found: &[f64], expected: &[f64]) {
    let off = |(a, b): (&f64, &f64)| (a - b).abs() > 1e-12 * (1.0 + b.abs());
    assert!(
        found.len() == expected.len() && !found.iter().zip(expected).any(off),
        "{found:?}, not {expected:?}"
    );
}

/// The section of a list with this name.
#[track_caller]
fn section<'a>(table: &'a toml::Table, list: &str, name: &str) -> &'a toml::Value {
    let mut sections = table[list].as_array().unwrap().iter();
    sections.find(|item| item["name"].as_str() == Some(name)).unwrap_or_else(|| panic!("no {name}"))
}

#[test]
fn a_drag_link_to_the_right_makes_a_model_of_the_right_side() {
    let imported = imported("toe-bar-axle.json");
    let table = table(&imported);
    assert_eq!(table["side"].as_str(), Some("right"));
    let point = |name: &str| numbers(&table["points"][name]);
    // What is there on both sides is mirrored, what is there once stays.
    assert_eq!(point("kingpin_lower"), [0.01, -0.72, -0.1]);
    assert_eq!(point("wheel_center"), [0.0, -0.8, 0.0]);
    assert_eq!(point("spring_upper"), [0.0, -0.5, 0.35]);
    assert_eq!(point("draglink_outer"), [0.2, -0.6, 0.12]);
    assert_eq!(point("draglink_chassis"), [0.2, 0.5, 0.16]);
    assert_eq!(point("watt_left_chassis"), [0.15, 0.44, 0.05]);
    near(&point("watt_pivot"), &[0.15, 0.0, 0.15]);
    let body = |name: &str, key: &str| table["bodies"][name][key].clone();
    near(&numbers(&body("knuckle", "center_of_mass")), &[0.004, -0.76, 0.0]);
    // Knuckle and spindle, 10 mm and 100 mm apart, and the products of the knuckle mirrored: Jxy and Jyz.
    let steiner = 8.0 * 12.0 / 20.0;
    let expected = [
        0.14 + steiner * 0.01,
        0.19 + steiner * 0.0001,
        0.14 + steiner * 0.0101,
        -0.002 - steiner * 0.001,
        0.003,
        -0.004,
    ];
    near(&numbers(&body("knuckle", "inertia")), &expected);
    near(&numbers(&body("tierod", "center_of_mass")), &[-0.18, 0.0, 0.02]);
    near(&numbers(&body("draglink", "center_of_mass")), &[0.2, -0.05, 0.14]);
    near(&numbers(&body("watt_crank", "center_of_mass")), &[0.15, 0.0, 0.15]);
    assert_eq!(body("watt_left_link", "mass").as_float(), Some(3.0));
    assert!(
        imported.assumed.iter().any(|what| what.contains("drag link")),
        "{:?}",
        imported.assumed
    );
    let mut axle = Axle::new(&model(&imported), &Setup::default()).unwrap();
    assert!(axle.freedom().is_exact(), "{}", axle.freedom());
    axle.move_to([0.05, -0.05], 0.0).unwrap();
}

#[test]
fn wheels_that_are_one_with_the_axle_weigh_on_both_sides() {
    let imported = imported("panhard-axle.json");
    let table = table(&imported);
    let axle = &table["bodies"]["axle"];
    assert_eq!(axle["mass"].as_float(), Some(120.0));
    near(&numbers(&axle["center_of_mass"]), &[0.0, 0.0, 0.1 / 6.0]);
    // 100 kg and 20 kg 0.1 m apart: 100·20/120·0.01, and the wheels 0.75 m aside: 20·0.5625.
    let heights = 100.0 * 20.0 / 120.0 * 0.01;
    near(&numbers(&axle["inertia"]), &[20.08 + heights + 11.25, 0.64 + heights, 20.08 + 11.25]);
    near(&numbers(&table["bodies"]["arb_arm"]["center_of_mass"]), &[0.4, 0.2, -0.05]);
    let bar = section(&table, "axle_forces", "anti_roll_bar");
    assert_eq!(bar["stiffness"].as_float(), Some(1000.0));
    // The bar twists by the travels over its arms of 0.4 m: ±20 mm at 0.4 m of 0.75 m.
    let mut axle = Axle::new(&model(&imported), &Setup::default()).unwrap();
    let mut twist = |travel: [f64; 2]| {
        axle.move_to(travel, 0.0).unwrap();
        let place = axle.element_channels().iter().position(|c| c.name == "anti_roll_bar_angle");
        hardpoint::rig::Specimen::channel_values(&axle)[place.expect("the bar has an angle")]
    };
    assert!(twist([0.02, 0.02]).abs() < 1e-9);
    let rolled = twist([0.02, -0.02]).abs();
    let expected = 2.0 * (0.02 * 0.4 / 0.75) / 0.4;
    assert!((rolled / expected - 1.0).abs() < 0.02, "{rolled}, not about {expected}");
}

#[test]
fn leaf_springs_become_springs_about_their_clamps() {
    let imported = imported("leaf-axle.json");
    let table = table(&imported);
    let force = |name: &str, key: &str| section(&table, "forces", name)[key].as_float().unwrap();
    // 500 mm and 400 mm from clamp to eye, 40 % and 60 % of the stiffness, half of 4000 N at each eye.
    near(&[force("front_leaf_bending", "stiffness")], &[40_000.0 * 0.25]);
    near(&[force("rear_leaf_bending", "stiffness")], &[60_000.0 * 0.16]);
    near(&[force("front_leaf_bending", "preload")], &[-2000.0 * 0.5]);
    near(&[force("rear_leaf_bending", "preload")], &[2000.0 * 0.4]);
    near(&[force("front_leaf_bending_sideways", "stiffness")], &[320_000.0 * 0.25]);
    near(&[force("rear_leaf_bending_sideways", "damping")], &[4800.0 * 0.16]);
    let body = |name: &str| numbers(&table["bodies"][name]["center_of_mass"]);
    near(&body("clamp_front_half"), &[0.025, 0.5, 0.1]);
    near(&body("clamp_rear_half"), &[-0.025, 0.5, 0.1]);
    near(&body("shackle"), &[-0.45, 0.5, 0.16]);
    // Leaves lie level and the shackle stands upright. The eyes are 550 mm and 450 mm from the axle, so it winds up
    // until their forces balance about it, by φ with 0.55 · 2 (1000 − 11000 φ) = 0.45 · 2.5 (800 + 10800 φ): that is
    // 8.25 mrad, with 1819 N and 2223 N. The wheel carries these and its weight: that of half the axle, the
    // spindle and the clamps, half of the leaves, and nothing of the shackle.
    let mut axle = Axle::new(&model(&imported), &Setup::default()).unwrap();
    axle.move_to([0.0; 2], 0.0).unwrap();
    let load = axle.pose(Side::Left).load.expect("its springs hold it").force;
    let weight = 9.81 * (50.0 + 12.0 + 1.6 + 3.5);
    assert!((load - 1818.6 - 2222.7 - weight).abs() < 1.0, "{load} N");
}

#[test]
fn a_bell_crank_turns_normal_to_its_arms() {
    let imported = imported("bell-crank-axle.json");
    let axis = &table(&imported)["points"]["bellcrank_axis"];
    near(&numbers(axis), &[0.0, 0.3, 0.95]);
    let mut axle = Axle::new(&model(&imported), &Setup::default()).unwrap();
    assert!(axle.freedom().is_exact(), "{}", axle.freedom());
    axle.move_to([0.05, -0.05], 0.0).unwrap();
    let bar = "\"Trackbar\": { \"Mass\": 5.0 }, \"Type\"";
    let held = text("bell-crank-axle.json").replacen("\"Type\"", bar, 1);
    let error = import::import("x.json", &held).unwrap_err().diagnostics().render();
    assert!(error.contains("leave a rigid axle one motion"), "{error}");
}

#[test]
fn suspensions_of_their_own_become_mechanisms() {
    let imported = imported("generic.json");
    let table = table(&imported);
    // The arm's axes are turned by 45 degrees about z: (0.1 + 0.3) / 2 on both, and ∓0.1 as product.
    near(&numbers(&table["bodies"]["left_arm"]["inertia"]), &[0.2, 0.2, 0.35, -0.1, 0.0, 0.0]);
    near(&numbers(&table["bodies"]["right_arm"]["inertia"]), &[0.2, 0.2, 0.35, 0.1, 0.0, 0.0]);
    let bar = section(&table, "forces", "right_bar");
    near(&numbers(&bar["axis"]), &[0.0, -1.0, 0.0]);
    near(&[bar["preload"].as_float().unwrap()], &[25.0]);
    section(&table, "forces", "left_coil_bump_stop");
    let stay = section(&table, "forces", "stay")["between"].as_array().unwrap();
    assert_eq!(stay[0].as_str(), Some("left_arm"));
    let left_out: Vec<&str> = imported.left_out.iter().map(|item| item.what.as_str()).collect();
    assert!(left_out.contains(&"`Bodies / Arm / Visualization`"), "{left_out:?}");
    let Ok(Document::Mechanism(file)) = Document::parse("generic.toml", &imported.text) else {
        panic!("it is a mechanism");
    };
    let mut system = System::new(file.mechanism.clone()).unwrap();
    assert!(system.freedom().is_exact(), "{}", system.freedom());
    let driver = |name: &str| file.mechanism.driver_named(name).unwrap();
    system.move_to(&[(driver("left_wheel"), 0.06), (driver("right_wheel"), -0.04)]).unwrap();
    // Each wheel is on a circle about y through the pivots, 0.5 m behind and 0.1 m below them.
    for (side, travel) in [("left", 0.06), ("right", -0.04)] {
        let body = system.mechanism().body_named(&format!("{side}_spindle")).unwrap();
        let center = system.mechanism().point_named(&format!("{side}_wheel_center")).unwrap();
        let [x, y, z] = system.point_position(body, center);
        let height: f64 = -0.1 + travel;
        let aside = if side == "left" { 0.7 } else { -0.7 };
        let expected = [-(0.26 - height * height).sqrt(), aside, height];
        assert!((x - expected[0]).abs() < 1e-10 && (y - expected[1]).abs() < 1e-10, "{side}");
        assert!((z - expected[2]).abs() < 1e-10, "{side}");
    }
    Stand::new(file.mechanism, &[], hardpoint::model::Axes::Iso8855).unwrap();
}

#[test]
fn wrong_suspensions_of_their_own_are_told_with_their_lines() {
    let right = text("generic.json");
    for (from, to, words) in [
        ("\"Type\": \"Revolute\"", "\"Type\": \"Gear\"", "does not know the joint `Gear`"),
        (
            "\"Body2\": \"Arm\", \"Position\"",
            "\"Body2\": \"Leg\", \"Position\"",
            "`Body2` names no body",
        ),
        ("[\"Arm\", \"Left\"]", "\"Arm\"", "`Body1` names no body"),
        ("\"Rotation\": [1, 0, 0, 0]", "\"Rotation\": [0, 0, 0, 0]", "no rotation"),
        (
            "\"Axis\": [0, 1, 0], \"Spring Coefficient\": 50.0",
            "\"Axis\": [0, 1, 0]",
            "`Spring Coefficient`",
        ),
        ("\"Name\": \"Beam\", \"Mirrored\": false,", "\"Name\": \"Beam\",", "no `Mirrored`"),
    ] {
        assert!(right.contains(from), "{from}");
        let error = import::import("x.json", &right.replacen(from, to, 1)).unwrap_err();
        let message = error.diagnostics().render();
        assert!(message.contains(words), "{to}: {message}");
    }
}
