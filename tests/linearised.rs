//! All derivatives at a state from one factorisation: tangents, rates, compliance; wheels held and free.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;

use axles::{axle, close, load};
use hardpoint::factors::{Convention, FACTORS, Need};
use hardpoint::mechanism::DriverId;
use hardpoint::model::{Chassis, Drive, Model, Setup, Side, WheelSupport};
use hardpoint::rig::{Axle, Corner, LoadPoint, Pose, Stand};
use hardpoint::solve::Twist;
use hardpoint::solve::equilibrium::Equilibrium;

fn free(setup: Setup) -> Setup {
    Setup { support: WheelSupport::Free, ..setup }
}

fn bushed() -> Model {
    let text = include_str!("../models/bushed-double-wishbone.toml");
    Model::parse("models/bushed-double-wishbone.toml", text).unwrap()
}

#[test]
fn both_wheels_and_their_compliance_take_one_factorisation() {
    for kinematic in [false, true] {
        let setup = Setup { kinematic, ..Setup::default() };
        let mut axle = Axle::new(&axle(&[]), &setup).unwrap();
        axle.measure_compliance(true);
        axle.move_to([0.01, -0.02], 0.005).unwrap();
        let before = axle.equilibrium().factorisations();
        let [left, right] = axle.poses();
        assert_eq!(axle.equilibrium().factorisations() - before, 1);
        for pose in [left, right] {
            let motions = pose.motions.unwrap();
            assert!(motions.rack.is_some() && motions.across.is_some());
            assert!(pose.load.unwrap().rate.is_some() && pose.compliance.is_some());
        }
    }
}

/// Drivers are let go at the edge of the matrix that holds them. Without their rows the matrix is another
/// one, with another factorisation.
#[test]
fn drivers_that_let_go_give_the_matrix_without_their_rows() {
    let model = axle(&[]);
    let loads = [load(&[("fx", -1500.0), ("mz", 40.0)]), load(&[("fy", 900.0)])];
    for kinematic in [false, true] {
        let setup = Setup { kinematic, ..Setup::default() };
        let mut axle = Axle::with_loads(&model, &setup, LoadPoint::WheelCenter).unwrap();
        axle.set_load(&loads);
        axle.move_to([0.015, -0.02], 0.006).unwrap();
        let bordered = axle.compliance().unwrap();

        let held = axle.equilibrium();
        let sides = axle.suspension().sides;
        let drivers = sides.map(|part| part.travel);
        let mut released = Equilibrium::released(axle.stand().system(), &drivers);
        for driver in axle.stand().mechanism().driver_ids() {
            released.set_driver(driver, held.driver_value(driver));
        }
        released.state_mut().copy_from_slice(held.state());
        released.multipliers_mut().copy_from_slice(held.multipliers());
        released.elements_mut().laws_mut().clone_from_slice(held.elements().laws());
        let points = sides.map(|part| (part.wheel.body, part.wheel.center));
        let matrix = released.compliance(&[], &points).unwrap();
        for i in 0..12 {
            for j in 0..12 {
                let kind = |row: usize, column: usize| {
                    row % 6 / 3 == i % 6 / 3 && column % 6 / 3 == j % 6 / 3
                };
                let all = (0..144).filter(|k| kind(k / 12, k % 12));
                let size = all.fold(0.0, |size: f64, k| size.max(matrix[k].abs()));
                close(
                    &format!("C[{i}, {j}]"),
                    bordered.entry(i, j),
                    matrix[12 * i + j],
                    1e-12 * size,
                );
            }
        }
    }
}

#[track_caller]
fn twists_close(what: &str, found: Twist, expected: Twist) {
    for k in 0..3 {
        close(&format!("{what} v{k}"), found.velocity[k], expected.velocity[k], 1e-9);
        close(&format!("{what} ω{k}"), found.rotation[k], expected.rotation[k], 1e-9);
    }
}

/// What travel and rack say is the same, whether the rig or the tyre carries the wheel.
#[track_caller]
fn same(free: &Pose<f64>, held: &Pose<f64>) {
    let (a, b) = (free.motions.unwrap(), held.motions.unwrap());
    twists_close("travel", a.travel.wheel, b.travel.wheel);
    assert_eq!(a.rack.is_some(), b.rack.is_some());
    if let (Some(a), Some(b)) = (a.rack, b.rack) {
        twists_close("rack", a.wheel, b.wheel);
    }
    assert_eq!(a.across.is_some(), b.across.is_some());
    if let (Some(a), Some(b)) = (a.across, b.across) {
        twists_close("across", a, b);
    }
    let elastic = [Need::Forces, Need::Compliance, Need::Tyre];
    let mut compared = 0;
    for factor in FACTORS {
        let kinematic = factor.missing(&blank(held)).all(|need| !elastic.contains(&need));
        for convention in [Convention::Iso, Convention::Lotus] {
            let [a, b] = [free, held].map(|pose| factor.value(convention, pose));
            if let (true, Some(b)) = (kinematic, b) {
                let a = a.unwrap_or_else(|| panic!("{} of a free wheel", factor.name));
                close(factor.name, a, b, 1e-9 * (1.0 + b.abs()).powi(2));
                compared += 1;
            }
        }
    }
    assert!(compared > 100, "{compared}");
}

/// The pose without anything that forces say.
fn blank(pose: &Pose<f64>) -> Pose<f64> {
    Pose { load: None, tyre: None, compliance: None, ..*pose }
}

#[test]
fn a_free_wheel_of_a_rigid_corner_moves_as_a_held_one() {
    let model = axle(&[]);
    for drive in [Drive::WheelCenter, Drive::ContactPatch] {
        let setup = Setup { kinematic: true, drive, ..Setup::default() };
        let mut standing = Corner::new(&model, &free(setup)).unwrap();
        standing.move_to(0.0, 0.01).unwrap();
        standing.rest().unwrap();
        let pose = standing.pose();
        assert!(pose.travel.abs() > 1e-3);
        let mut held = Corner::new(&model, &setup).unwrap();
        held.move_to(pose.travel, 0.01).unwrap();
        same(&pose, &held.pose());
    }
}

/// The tyre pushes where the driver would, and so takes nothing from the motion of bushings either.
#[test]
fn a_free_wheel_on_bushings_moves_as_a_held_one() {
    let model = bushed();
    let mut standing = Corner::new(&model, &free(Setup::default())).unwrap();
    standing.rest().unwrap();
    let pose = standing.pose();
    let mut held = Corner::new(&model, &Setup::default()).unwrap();
    held.move_to(pose.travel, 0.0).unwrap();
    same(&pose, &held.pose());
}

#[test]
fn the_free_wheels_of_an_axle_move_as_held_ones() {
    let model = axle(&[]);
    for kinematic in [false, true] {
        let setup = Setup { kinematic, drive: Drive::ContactPatch, ..Setup::default() };
        let loads = [load(&[("fy", 700.0)]), load(&[("fy", 300.0), ("fz", -900.0)])];
        let mut axles = [free(setup), setup].map(|setup| Axle::new(&model, &setup).unwrap());
        axles.iter_mut().for_each(|axle| axle.set_load(&loads));
        let [standing, held] = &mut axles;
        standing.move_to([0.0; 2], -0.004).unwrap();
        standing.rest().unwrap();
        let poses = standing.poses();
        held.move_to(poses.map(|pose| pose.travel), -0.004).unwrap();
        let expected = held.poses();
        assert!((poses[0].travel - poses[1].travel).abs() > 1e-3);
        for side in 0..2 {
            same(&poses[side], &expected[side]);
        }
        // What a free wheel gives way to is no compliance of the suspension alone.
        standing.measure_compliance(true);
        assert!(standing.pose(Side::Left).compliance.is_none());
    }
}

/// The chassis of a quarter car goes up with its wheel, so the suspension does not move.
#[test]
fn a_chassis_that_goes_with_the_wheel_leaves_no_motion() {
    let text = include_str!("../models/quarter-car.toml");
    let model = Model::parse("models/quarter-car.toml", text).unwrap();
    for (chassis, moves) in [(Chassis::Fixed, true), (Chassis::Slide, false)] {
        let setup = Setup { chassis, ..free(Setup::default()) };
        let mut corner = Corner::new(&model, &setup).unwrap();
        corner.rest().unwrap();
        assert_eq!(corner.pose().motions.is_some(), moves, "{chassis:?}");
    }
}

/// A corner on the rig as a bare stand, and its travel driver.
fn stand(model: &Model, support: WheelSupport) -> (Stand, DriverId) {
    let setup = Setup { support, drive: Drive::ContactPatch, ..Setup::default() };
    let suspension = model.suspension(&setup).unwrap();
    let released: &[DriverId] = match support {
        WheelSupport::Held => &[],
        WheelSupport::Free => &[suspension.travel],
    };
    let stand = Stand::new(suspension.mechanism, released, model.axes).unwrap();
    (stand, suspension.travel)
}

/// The force that would hold a free wheel grows by the rate of the wheel and that of its tyre.
#[test]
fn the_rate_of_a_free_wheel_has_its_tyre_in_it() {
    let model = axle(&[]);
    let (mut standing, travel) = stand(&model, WheelSupport::Free);
    standing.rest().unwrap();
    let mut corner = Corner::new(
        &model,
        &Setup { support: WheelSupport::Free, drive: Drive::ContactPatch, ..Setup::default() },
    )
    .unwrap();
    corner.rest().unwrap();
    let height = corner.pose().travel;
    let (mut held, driver) = stand(&model, WheelSupport::Held);
    held.move_to(&[(driver, height)]).unwrap();
    let alone = held.rates().driver_rate(driver).unwrap();
    let both = standing.rates().driver_rate(travel).unwrap();
    close("rate", both - alone, 220e3, 1e-4);
}

/// Released, not held and yet asked for: no tangent rather than a motion that stands still.
#[test]
fn a_driver_that_is_let_go_has_a_tangent_only_where_it_is_held() {
    let model = axle(&[]);
    let (mut standing, travel) = stand(&model, WheelSupport::Free);
    standing.rest().unwrap();
    let equilibrium = standing.equilibrium_mut();
    assert!(equilibrium.driver_tangent(travel).is_err());
    assert!(equilibrium.linearised().holding(&[travel]).tangent(travel).is_ok());
    assert!(equilibrium.linearised().tangent(travel).is_err());
}

#[test]
fn rates_do_not_allocate_after_the_first() {
    let model = axle(&[]);
    for support in [WheelSupport::Held, WheelSupport::Free] {
        let (mut stand, travel) = stand(&model, support);
        stand.rest().unwrap();
        let mut ask = || {
            let mut rates = stand.rates();
            assert!(rates.tangent(travel).is_some() && rates.driver_rate(travel).is_some());
        };
        ask();
        assert_eq!(allocation_counter::measure(ask).count_total, 0);
    }
}
