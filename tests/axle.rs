//! Axles on the rig: events, mirror images, the anti-roll bar.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;

use axles::{CUT, axle, close, load};
use hardpoint::model::{Axes, Drive, Model, Setup, Side, WheelSupport};
use hardpoint::rig::{Axle, Corner, Event, Held, LoadPoint, Pose, Sweep, SweepPlan, WheelLoad};
use hardpoint::solve::Twist;

/// All numbers of a pose that do not depend on axes and side.
fn numbers(pose: &Pose<f64>) -> Vec<f64> {
    let mut numbers = vec![pose.travel, pose.rack];
    numbers.extend(pose.wheel.center);
    numbers.extend(pose.wheel.spin);
    numbers.extend(pose.rotation.as_flattened());
    let axis = pose.steer_axis.expect("a double wishbone has a steer axis");
    numbers.extend(axis.from);
    numbers.extend(axis.to);
    if let Some(spring) = pose.spring {
        numbers.extend([spring.from, spring.to].as_flattened());
    }
    if let Some(motions) = &pose.motions {
        let Twist { velocity, rotation } = motions.travel.wheel;
        // Rates, like loads, are solutions of one linear system and have two digits less.
        numbers.extend([velocity, rotation].as_flattened().iter().map(|rate| 0.01 * rate));
    }
    if let Some(WheelLoad { force, rate }) = pose.load {
        numbers.extend([force * 1e-5, rate.unwrap_or_default() * 1e-6]);
    }
    numbers
}

/// The numbers of the mirror image of a pose.
fn mirrored(pose: &Pose<f64>) -> Vec<f64> {
    let mut image = *pose;
    let turn = |[x, y, z]: [f64; 3]| [x, -y, z];
    image.rack = -image.rack;
    image.wheel.center = turn(image.wheel.center);
    image.wheel.spin = turn(image.wheel.spin);
    let [a, b, c] = image.rotation.map(turn);
    image.rotation = [a, b.map(|x| -x), c];
    if let Some(axis) = &mut image.steer_axis {
        (axis.from, axis.to) = (turn(axis.from), turn(axis.to));
    }
    if let Some(spring) = &mut image.spring {
        (spring.from, spring.to) = (turn(spring.from), turn(spring.to));
    }
    if let Some(motions) = &mut image.motions {
        let Twist { velocity, rotation } = &mut motions.travel.wheel;
        *velocity = turn(*velocity);
        *rotation = turn(*rotation).map(|x| -x);
    }
    numbers(&image)
}

#[track_caller]
fn same(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        close(&format!("{what}, number {index}"), *found, *expected, tolerance);
    }
}

fn plan(event: Event, to: f64, held: Held) -> SweepPlan {
    SweepPlan { event, from: -to, to, step: to / 2.0, held }
}

/// Every event that needs no coupling, on an axle whose bar is cut and on its two corners.
fn compare_with_corners(model: &Model, setup: &Setup, tolerance: f64) {
    let at = LoadPoint::ContactPatch;
    let fx = load(&[("fx", -800.0), ("mz", 20.0)]);
    let fy = load(&[("fy", 500.0)]);
    let both = Held { travel: 0.01, rack: 0.004, load: fx, right_load: Some(fy) };
    let events = [
        (Event::Travel, 0.04, Held { rack: 0.01, ..Held::default() }),
        (Event::Opposite, 0.03, both),
        (Event::Single(Side::Left), 0.03, both),
        (Event::Single(Side::Right), 0.03, both),
        (Event::Steer, 0.02, both),
        (Event::Load(1), 600.0, both),
        (Event::LoadOpposed(5), 40.0, both),
        (Event::LoadSingle(0, Side::Right), 600.0, both),
    ];
    let mut axle = Axle::with_loads(model, setup, at).unwrap();
    let other = model.mirrored();
    let (left, right) = match model.side {
        Side::Left => (model, &other),
        Side::Right => (&other, model),
    };
    let mut corners = [left, right].map(|model| Corner::with_loads(model, setup, at).unwrap());
    for (event, to, held) in events {
        let plan = plan(event, to, held);
        axle.reset();
        let sweep = Sweep::run(&mut axle, &plan, |_| {});
        assert!(sweep.stops.is_empty(), "{event:?}: {:?}", sweep.stops);
        assert_eq!(sweep.rows.len(), 5);
        for (index, corner) in corners.iter_mut().enumerate() {
            corner.reset();
            let alone = Sweep::run(corner, &plan, |_| {});
            for (row, expected) in sweep.rows.iter().zip(&alone.rows) {
                let pose = row.poses[index];
                let expected = expected.poses[0];
                let what = format!("{event:?} at {} on the {}", row.value, pose.side.name());
                assert_eq!(pose.side, expected.side);
                same(&what, &numbers(&pose), &numbers(&expected), tolerance);
            }
        }
    }
}

#[test]
fn sides_without_a_bar_are_corners() {
    let model = axle(&[CUT]);
    let rigid = Setup { kinematic: true, ..Setup::default() };
    compare_with_corners(&model, &rigid, 1e-11);
    compare_with_corners(&model, &Setup::default(), 1e-10);
    compare_with_corners(&model.mirrored(), &Setup::from(Drive::ContactPatch), 1e-10);
}

#[test]
fn a_purely_kinematic_axle_moves_like_its_corners() {
    let text = include_str!("../models/adams-tr-front.toml");
    let model = Model::parse("models/adams-tr-front.toml", text).unwrap();
    let mut both = Axle::new(&model, &Setup::default()).unwrap();
    assert!(both.freedom().is_exact(), "{}", both.freedom());
    both.move_to([0.03, -0.02], 0.005).unwrap();
    for (model, travel) in [(&model, [0.03, -0.02]), (&model.mirrored(), [0.03, -0.02])] {
        let mut corner = Corner::new(model, &Setup::default()).unwrap();
        corner.move_to(travel[model.side.index()], 0.005).unwrap();
        let expected = numbers(&corner.pose());
        same(model.side.name(), &numbers(&both.pose(model.side)), &expected, 1e-13);
    }
}

/// The bar couples the sides; a state that is symmetric stays so to rounding.
#[test]
fn symmetric_states_have_mirror_images() {
    for model in [axle(&[]), axle(&[]).mirrored()] {
        for kinematic in [false, true] {
            let setup = Setup { kinematic, ..Setup::default() };
            let mut axle = Axle::with_loads(&model, &setup, LoadPoint::ContactPatch).unwrap();
            let outward =
                |side: f64| load(&[("fx", 300.0), ("fy", 400.0 * side), ("mz", 9.0 * side)]);
            axle.set_load(&[outward(1.0), outward(-1.0)]);
            axle.move_to([0.03, 0.03], 0.0).unwrap();
            let [left, right] = [Side::Left, Side::Right].map(|side| axle.pose(side));
            same("parallel travel", &numbers(&left), &mirrored(&right), 1e-13);

            // Roll to one side and to the other, steered to one side and to the other.
            axle.move_to([0.02, -0.03], 0.01).unwrap();
            let first = [Side::Left, Side::Right].map(|side| axle.pose(side));
            axle.reset();
            axle.move_to([-0.03, 0.02], -0.01).unwrap();
            let second = [Side::Left, Side::Right].map(|side| axle.pose(side));
            same("left and right", &numbers(&first[0]), &mirrored(&second[1]), 1e-12);
            same("right and left", &numbers(&first[1]), &mirrored(&second[0]), 1e-12);
        }
    }
}

#[test]
fn a_bar_works_in_roll_alone() {
    let loads = |changes: &[(&str, &str)], travel| {
        let mut axle = Axle::new(&axle(changes), &Setup::default()).unwrap();
        axle.move_to(travel, 0.0).unwrap();
        let channels = axle.stand().force_channels().to_vec();
        let loaded = axle.equilibrium().loaded();
        let reactions = axle.equilibrium().reactions();
        let torque = channels.iter().find(|channel| channel.name == "anti_roll_bar_torque");
        let torque = torque.map(|channel| channel.value(&loaded, &reactions, Axes::Iso8855));
        let forces = [Side::Left, Side::Right].map(|side| axle.pose(side).load.unwrap().force);
        (forces, torque)
    };
    let (with, torque) = loads(&[], [0.03, 0.03]);
    let (without, none) = loads(&[CUT], [0.03, 0.03]);
    assert_eq!(none, None);
    close("torque in ride", torque.unwrap(), 0.0, 1e-7);
    close("load in ride", with[0], without[0], 1e-6);

    // The arms reach rearward: an end that goes up is a positive turn about y.
    let (with, torque) = loads(&[], [0.02, -0.02]);
    let (without, _) = loads(&[CUT], [0.02, -0.02]);
    let (left, right) = (with[0] - without[0], with[1] - without[1]);
    assert!(left > 100.0 && right < -100.0, "{left} {right}");
    assert!(torque.unwrap() > 1.0, "{torque:?}");
}

#[test]
fn an_axle_stands_on_its_tyres() {
    let free = Setup { support: WheelSupport::Free, ..Setup::default() };
    let mut axle = Axle::new(&axle(&[]), &free).unwrap();
    axle.rest().unwrap();
    let [left, right] = [Side::Left, Side::Right].map(|side| axle.pose(side));
    same("on its tyres", &numbers(&left), &mirrored(&right), 1e-12);
    assert!(left.load.unwrap().force > 1000.0);

    // A load to the left on both wheels is no symmetric state.
    let fy = load(&[("fy", 1000.0)]);
    axle.set_load(&[fy, fy]);
    axle.rest().unwrap();
    let [left, right] = [Side::Left, Side::Right].map(|side| axle.pose(side));
    assert!((left.wheel.center[1] + right.wheel.center[1]).abs() > 1e-4);
}

#[test]
fn two_models_make_one_axle() {
    let soft = axle(&[("stiffness = 70.0", "stiffness = 50.0")]).mirrored();
    let mut both =
        Axle::with_sides(&axle(&[]), &soft, &Setup::default(), LoadPoint::default()).unwrap();
    both.move_to([0.0, 0.0], 0.0).unwrap();
    let [left, right] = [Side::Left, Side::Right].map(|side| both.pose(side).load.unwrap());
    assert!(right.force < 0.9 * left.force, "{left:?} {right:?}");
}
