//! Axles whose body rolls on the rig.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;

use std::collections::HashMap;

use axles::{axle, close};
use hardpoint::factors::{Convention, find, roll_axis};
use hardpoint::model::{Chassis, Drive, Model, Setup, Side, SuspensionError};
use hardpoint::rig::{
    Axle, Corner, Event, Held, Hold, LoadPoint, Pose, RigError, Row, Supports, Sweep, SweepPlan,
    Target,
};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// The rows of a reference table by the names of its columns.
fn table(text: &str) -> Vec<HashMap<String, f64>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader.deserialize().map(|row| row.expect("the table is well-formed")).collect()
}

/// The axle with a body that rolls about the static roll centre.
fn rolling(model: &Model, setup: &Setup) -> Axle {
    let mut fixed = Axle::new(model, setup).unwrap();
    fixed.move_to([0.0; 2], 0.0).unwrap();
    let poses = [Side::Left, Side::Right].map(|side| fixed.pose(side));
    let axis = roll_axis([&poses[0], &poses[1]]).expect("there is a roll centre");
    let height = find("rc_height").unwrap().value(Convention::Iso, &poses[0]).unwrap();
    close("axis", axis, poses[0].wheel.contact_patch()[2] + height, 1e-10);
    Axle::new(model, &Setup { chassis: Chassis::Roll { axis }, ..*setup }).unwrap()
}

fn roll(axle: &mut Axle, to: f64, step: f64, held: Held) -> Vec<Row> {
    let plan = SweepPlan {
        event: Event::Roll,
        from: -to * DEGREE,
        to: to * DEGREE,
        step: step * DEGREE,
        held,
    };
    let sweep = Sweep::run(axle, &plan, |_| {});
    assert!(sweep.stops.is_empty(), "{:?}", sweep.stops);
    sweep.rows
}

fn poses(row: &Row) -> [Pose<f64>; 2] {
    [row.poses[0], row.poses[1]]
}

/// Every printed column of Lotus' roll table, both sides: angles to 1.1e-4°, lengths to 0.008 mm, ratios to
/// 0.0006, the roll centre to 0.1 mm in height and 0.92 mm across,
/// where Lotus is 1.4 % nearer to the middle at all angles.
#[test]
fn lotus_has_all_columns_of_its_roll_tables() {
    const COLUMNS: &[(&str, &str, f64)] = &[
        ("camber_deg", "camber", 1.1e-4),
        ("toe_deg", "toe", 1.1e-4),
        ("castor_deg", "caster", 1.1e-4),
        ("kingpin_deg", "kpi", 1.1e-4),
        ("damper_ratio", "damper_ratio_patch", 6e-4),
        ("spring_ratio", "spring_ratio_patch", 6e-4),
        ("half_track_change_mm", "half_track_change", 0.008),
        ("wheelbase_change_mm", "wheelbase_change", 0.008),
        ("damper_travel_mm", "damper_travel", 0.008),
        ("spring_travel_mm", "spring_travel", 0.008),
        ("rc_x_mm", "roll_center_x", 1e-9),
        ("rc_y_mm", "roll_center_y", 0.92),
        ("rc_z_mm", "roll_center_z", 0.1),
    ];
    let text = include_str!("../models/lotus-front.toml");
    let model = Model::parse("models/lotus-front.toml", text).unwrap();
    let mut axle = rolling(&model, &Setup::from(Drive::ContactPatch));
    assert!(axle.freedom().is_exact(), "{}", axle.freedom());
    let rows = roll(&mut axle, 3.0, 0.3, Held::default());
    let references = [
        table(include_str!("reference/lotus-roll-left.csv")),
        table(include_str!("reference/lotus-roll-right.csv")),
    ];
    assert_eq!(rows.len(), 21);
    for (index, reference) in references.iter().enumerate() {
        assert_eq!(reference.len(), 21);
        for (row, expected) in rows.iter().zip(reference) {
            // The table has the angle besides.
            assert_eq!(expected.len(), COLUMNS.len() + 1);
            let poses = poses(row);
            let at = format!("{} at {}", poses[index].side.name(), expected["roll_deg"]);
            close(&at, row.value / DEGREE, expected["roll_deg"], 1e-12);
            for (column, name, tolerance) in COLUMNS {
                let factor = find(name).unwrap();
                let found = factor.show_by(Convention::Lotus, model.units, &poses[index]);
                close(&format!("{at}: {column}"), found.unwrap(), expected[*column], *tolerance);
            }
        }
    }
}

/// Roll to one side is the mirror image of roll to the other one.
#[test]
fn roll_to_both_sides_mirrors_the_wheels() {
    for model in [axle(&[]), axle(&[]).mirrored()] {
        for setup in [Setup::default(), Setup::from(Drive::ContactPatch)] {
            let mut axle = rolling(&model, &setup);
            let held = Held { travel: 0.01, ..Held::default() };
            let rows = roll(&mut axle, 4.0, 2.0, held);
            for (row, image) in rows.iter().zip(rows.iter().rev()) {
                let (found, image) = (poses(row), poses(image));
                for (pose, image) in [(found[0], image[1]), (found[1], image[0])] {
                    let at = format!("roll {} of the {} wheel", row.value, pose.side.name());
                    close(&at, pose.travel, image.travel, 1e-12);
                    for (axis, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
                        let (found, image) = (&pose.wheel, &image.wheel);
                        close(&at, found.center[axis], sign * image.center[axis], 1e-12);
                        close(&at, found.spin[axis], sign * image.spin[axis], 1e-12);
                    }
                    let (found, image) = (pose.load.unwrap(), image.load.unwrap());
                    close(&at, found.force, image.force, 1e-7);
                    close(&at, found.rate.unwrap(), image.rate.unwrap(), 1e-3);
                }
            }
        }
    }
}

/// The wheel goes in the body as the body goes about the wheel: by the arm times the angle, to first order.
#[test]
fn travel_in_roll_is_that_in_the_body() {
    let model = axle(&[]);
    let mut axle = rolling(&model, &Setup { kinematic: true, ..Setup::default() });
    let angle = 1e-4;
    axle.hold(&Target { roll: angle, ..Target::default() }).unwrap();
    let poses = [Side::Left, Side::Right].map(|side| axle.pose(side));
    for pose in &poses {
        // In ISO axes the left side rises, so that its wheel droops.
        let expected = -angle * pose.design.wheel.center[1];
        close(pose.side.name(), pose.travel, expected, 2e-3 * expected.abs());
        close("height", pose.wheel.center[2], pose.design.wheel.center[2], 1e-12);
    }
    // The whole axle rises with the body when the wheels follow: no travel in the body.
    let up = [Hold::Value(0.05); 2];
    axle.hold(&Target { wheels: up, heave: Hold::Value(0.05), ..Target::default() }).unwrap();
    for side in [Side::Left, Side::Right] {
        let pose = axle.pose(side);
        close(side.name(), pose.travel, 0.0, 1e-12);
        close("design", pose.wheel.center[2], pose.design.wheel.center[2], 1e-12);
    }
}

/// The load of the axle stays; the torque that rolls the body balances the wheels about the roll axis.
#[test]
fn constant_axle_load_finds_its_heave() {
    let mut axle = rolling(&axle(&[("gravity = 9.81", "gravity = 0.0")]), &Setup::default());
    let supports = Supports::find(&mut axle, &Held::default()).unwrap();
    let load = supports.wheels[0] + supports.wheels[1];
    close("body", supports.chassis, -load, 1e-6);
    let held = Held { heave: Hold::Force(supports.chassis), ..Held::default() };
    let channel = |axle: &Axle, row: &Row, name: &str| {
        let names = axle.element_channels().iter().map(|channel| channel.name.as_str());
        row.channels[names.into_iter().position(|channel| channel == name).unwrap()]
    };
    let rows = roll(&mut axle, 4.0, 2.0, held);
    let free = roll(&mut axle, 4.0, 2.0, Held::default());
    for (row, fixed) in rows.iter().zip(&free) {
        let [left, right] = poses(row);
        let forces = [left, right].map(|pose| pose.load.unwrap().force);
        close("load", forces[0] + forces[1], load, 1e-9 * load);
        let moment = forces[0] * left.wheel.center[1] + forces[1] * right.wheel.center[1];
        close("moment", channel(&axle, row, "roll_torque"), -moment, 1e-9 * load);
        let heave = channel(&axle, row, "heave");
        assert!((heave.abs() > 1e-5) == (row.value != 0.0), "{heave} at {}", row.value);
        // Without heave the load changes.
        let other: f64 = poses(fixed).map(|pose| pose.load.unwrap().force).iter().sum();
        assert!(row.value == 0.0 || (other - load).abs() > 1.0, "{other} {load}");
    }
}

#[test]
fn one_side_alone_does_not_roll() {
    let setup = Setup { chassis: Chassis::Roll { axis: 0.0 }, ..Setup::default() };
    let error = Corner::with_loads(&axle(&[]), &setup, LoadPoint::default()).err();
    assert_eq!(error, Some(RigError::Suspension(SuspensionError::CornerRolls)));
}
