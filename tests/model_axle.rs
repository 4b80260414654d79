//! Axles: both sides of a model in one mechanism.
#![allow(missing_docs)]

use hardpoint::mechanism::{Direction, ForceKind, Mechanism};
use hardpoint::model::{Chassis, Model, Setup, Side, SuspensionError, WheelSupport};
use hardpoint::solve::System;

const AXLE: &str = include_str!("../models/sedan-axle.toml");

fn parse(text: &str) -> Model {
    Model::parse("models/model.toml", text).unwrap_or_else(|e| panic!("{}", e.render()))
}

fn names<T>(parts: &[T], name: impl Fn(&T) -> &String) -> Vec<&str> {
    parts.iter().map(|part| name(part).as_str()).collect()
}

fn bodies(mechanism: &Mechanism) -> Vec<&str> {
    names(mechanism.bodies(), |body| &body.name)
}

#[test]
fn shared_parts_are_there_once_and_all_others_on_both_sides() {
    let model = parse(AXLE);
    let axle = model.axle(&Setup::default()).unwrap();
    let sides = ["left", "right"];
    let mut expected = vec!["chassis".to_owned(), "rack".to_owned()];
    for side in sides {
        expected.extend(["lca", "uca", "upright", "tierod"].map(|body| format!("{side}_{body}")));
    }
    expected.extend(sides.map(|side| format!("{side}_arb_arm")));
    assert_eq!(bodies(&axle.mechanism), expected);

    let joints = names(axle.mechanism.joints(), |joint| &joint.name);
    assert_eq!(joints.iter().filter(|joint| joint.contains("rack_slide")).count(), 1);
    // Six joints of each side but one on bushings, the bearing and the link of the bar, the rack.
    assert_eq!(joints.len(), 1 + 2 * (5 + 2), "{joints:?}");
    let forces = names(axle.mechanism.forces(), |force| &force.name);
    assert_eq!(
        forces,
        [
            "left_spring",
            "left_lca_front_bushing",
            "left_lca_rear_bushing",
            "right_spring",
            "right_lca_front_bushing",
            "right_lca_rear_bushing",
            "anti_roll_bar",
        ]
    );
    let drivers = names(axle.mechanism.drivers(), |driver| &driver.name);
    assert_eq!(drivers, ["rack", "left_travel", "right_travel"]);
    let masses = axle.mechanism.bodies().iter().filter(|body| body.mass.is_some()).count();
    assert_eq!(masses, 8);
}

/// Rigid joints: travel of both wheels and the rack are all that is left.
#[test]
fn an_axle_has_three_motions_and_all_are_driven() {
    let model = parse(AXLE);
    let setup = Setup { kinematic: true, ..Setup::default() };
    let system = System::new(model.axle(&setup).unwrap().mechanism).unwrap();
    assert!(system.freedom().is_exact(), "{}", system.freedom());
}

#[test]
fn the_other_side_is_the_mirror_image() {
    for model in [parse(AXLE), parse(AXLE).mirrored()] {
        let axle = model.axle(&Setup::default()).unwrap();
        let position = |name: &str| {
            let point = axle.mechanism.point_named(name).unwrap();
            axle.mechanism.points()[point.index()].position
        };
        for point in model.points() {
            let [x, y, z] = position(&format!("left_{}", point.name));
            assert!(y > 0.0);
            assert_eq!([x, -y, z], position(&format!("right_{}", point.name)));
        }
        assert_eq!(axle.sides.map(|side| side.side), [Side::Left, Side::Right]);
        let [left, right] = axle.sides.map(|side| side.wheel.spin_axis);
        assert_eq!([left[0], -left[1], left[2]], right);
    }
}

#[test]
fn tyres_belong_to_free_wheels() {
    let model = parse(AXLE);
    let free = Setup { support: WheelSupport::Free, ..Setup::default() };
    let axle = model.axle(&free).unwrap();
    let tyres = axle.sides.map(|side| side.tyre.unwrap());
    let names = tyres.map(|tyre| axle.mechanism.forces()[tyre.index()].name.as_str());
    assert_eq!(names, ["left_tyre", "right_tyre"]);
    assert!(model.axle(&Setup::default()).unwrap().sides.iter().all(|side| side.tyre.is_none()));
}

#[test]
fn the_bar_turns_about_y_of_the_model_and_may_be_cut() {
    let bar = |model: &Model| {
        let axle = model.axle(&Setup::default()).unwrap();
        axle.mechanism.force_named("anti_roll_bar").map(|bar| {
            let force = &axle.mechanism.forces()[bar.index()];
            let bodies = bodies(&axle.mechanism);
            assert_eq!(
                [bodies[force.i.index()], bodies[force.j.index()]],
                ["right_arb_arm", "left_arb_arm"]
            );
            match &force.kind {
                ForceKind::Torsion { axis, law } => (*axis, law.at(1.0, 0.0).force),
                other => panic!("{other:?}"),
            }
        })
    };
    let (axis, torque) = bar(&parse(AXLE)).unwrap();
    assert_eq!(axis, Direction::Fixed([0.0, 1.0, 0.0]));
    // 10 000 N·mm/deg.
    assert!((torque - 10.0_f64.to_degrees()).abs() < 1e-9);

    let cut = AXLE.replace("stiffness = 10000.0", "stiffness = 0.0");
    assert_eq!(bar(&parse(&cut)), None);
    let axle = parse(&cut).axle(&Setup::default()).unwrap();
    assert!(bodies(&axle.mechanism).contains(&"right_arb_arm"));
}

/// What lies between the ground and a shared body is not mirrored: mirror images would cancel.
#[test]
fn a_force_on_the_rack_acts_once() {
    let force = "[[forces]]\nname = \"assist\"\nkind = \"force\"\nbody = \"rack\"\nat = \"tierod_inner\"\nforce = [0.0, 100.0, 0.0]\n";
    let axle = parse(&format!("{AXLE}{force}")).axle(&Setup::default()).unwrap();
    let forces = names(axle.mechanism.forces(), |force| &force.name);
    assert_eq!(
        forces.iter().filter(|name| name.contains("assist")).collect::<Vec<_>>(),
        [&"assist"]
    );
}

#[test]
fn both_sides_may_be_given() {
    let left = parse(AXLE);
    let soft = parse(&AXLE.replace("stiffness = 70.0", "stiffness = 50.0")).mirrored();
    let axle = left.axle_with(&soft, &Setup::default()).unwrap();
    let stiffness = ["left_spring", "right_spring"].map(|name| {
        let spring = axle.mechanism.force_named(name).unwrap();
        match &axle.mechanism.forces()[spring.index()].kind {
            ForceKind::Line { law, .. } => law.at(1.0, 0.0).force.round(),
            other => panic!("{other:?}"),
        }
    });
    assert_eq!(stiffness, [70_000.0, 50_000.0]);
}

#[test]
fn what_is_no_axle_is_refused() {
    let left = parse(AXLE);
    let slide = Setup { chassis: Chassis::Slide, ..Setup::default() };
    assert_eq!(left.axle(&slide).unwrap_err(), SuspensionError::AxleSlides);

    let error = left.axle_with(&left, &Setup::default()).unwrap_err().to_string();
    assert!(error.contains("both lie on the left"), "{error}");

    let start = AXLE.find("[anti_roll_bar]").unwrap();
    let end = AXLE.find("# The x axis").unwrap();
    let text = format!("{}{}", &AXLE[..start], &AXLE[end..]);
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with("arb_")).collect();
    let without = parse(&lines.join("\n"));
    let error = left.axle_with(&without.mirrored(), &Setup::default()).unwrap_err().to_string();
    assert!(error.contains("only one of them has an anti-roll bar"), "{error}");
}
