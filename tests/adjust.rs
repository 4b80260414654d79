//! Adjusters bring a suspension to its static state.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;

use axles::close;
use hardpoint::factors::{Convention, find};
use hardpoint::mechanism::DriverId;
use hardpoint::model::{
    Alignment, Chassis, Drive, Model, STATIC_FACTORS, Setup, Side, SpinAxis, WheelSupport,
};
use hardpoint::rig::{Axle, Corner, LoadPoint, Pose, RigError, Stand};
use hardpoint::solve::Twist;

const SEDAN: &str = include_str!("../models/double-wishbone.toml");
const SETUP: &str = include_str!("../models/sedan-setup.toml");

const TIE_ROD: &str = "
[adjusters.tie_rod_length]
kind = \"length\"
body = \"tierod\"
ends = [\"tierod_inner\", \"tierod_outer\"]
";
const SHIMS: &str = "
[adjusters.camber_shim]
kind = \"shim\"
joint = \"upper_ball_joint\"
on = \"upright\"
direction = \"y\"
[adjusters.caster_shim]
kind = \"shim\"
joint = \"upper_ball_joint\"
on = \"uca\"
direction = [\"uca_front\", \"uca_rear\"]
";
const SEAT: &str = "
[adjusters.spring_seat]
kind = \"seat\"
force = \"spring\"
";
const SPRING: &str = "
[[forces]]
name = \"spring\"
kind = \"spring\"
between = [\"chassis\", \"lca\"]
on = [\"spring_upper\", \"spring_lower\"]
stiffness = 70.0
free_length = 605.0
";

#[track_caller]
fn model(parts: &[&str]) -> Model {
    let text = parts.concat();
    Model::parse("models/model.toml", &text).unwrap_or_else(|e| panic!("{}", e.render()))
}

/// The sedan without forces, with these lines in its `[static]`.
#[track_caller]
fn sedan(targets: &str) -> Model {
    model(&[SEDAN, TIE_ROD, SHIMS, "[static]\n", targets])
}

/// The sedan on rigid joints and a spring.
#[track_caller]
fn sprung(targets: &str) -> Model {
    let units = SEDAN.replace("angle = \"deg\"", "angle = \"deg\"\nforce = \"N\"");
    model(&[&units, SPRING, TIE_ROD, SHIMS, SEAT, "[static]\n", targets])
}

fn corner(model: &Model) -> Corner {
    at_rest(Corner::new(model, &Setup::default()).unwrap_or_else(|error| panic!("{error}")))
}

/// The corner at zero travel, its wheel load known.
fn at_rest(mut corner: Corner) -> Corner {
    corner.move_to(0.0, 0.0).unwrap();
    corner
}

#[track_caller]
fn value(name: &str, pose: &Pose<f64>) -> f64 {
    let factor = find(name).unwrap();
    factor.value(Convention::Iso, pose).unwrap_or_else(|| panic!("{name} is not defined"))
}

fn degrees(name: &str, pose: &Pose<f64>) -> f64 {
    value(name, pose).to_degrees()
}

fn settings(corner: &Corner) -> Vec<f64> {
    corner.adjustments().iter().map(|adjustment| adjustment.value).collect()
}

const ALL: &str = "ride_height = -12.0
toe = { value = 0.25, by = \"tie_rod_length\" }
camber = { value = -1.5, by = \"camber_shim\" }
caster = { value = 6.0, by = \"caster_shim\" }
";

/// About a vertical steer axis nothing moves but the upright and the tie rod, so the
/// length of the tie rod is that between its ends when the steering arm has turned by the toe.
#[test]
fn length_of_a_tie_rod_follows_from_the_triangle_of_the_steering_arm() {
    let geometry = "format = 1
name = \"Bare\"
architecture = \"double-wishbone\"
axes = \"iso8855\"
side = \"left\"
[units]
length = \"mm\"
angle = \"deg\"
[points]
lca_front = [150.0, 350.0, -200.0]
lca_rear = [-150.0, 350.0, -200.0]
lca_outer = [0.0, 700.0, -200.0]
uca_front = [150.0, 400.0, 200.0]
uca_rear = [-150.0, 400.0, 200.0]
uca_outer = [0.0, 700.0, 200.0]
tierod_inner = [-130.0, 350.0, 30.0]
tierod_outer = [-120.0, 680.0, 0.0]
wheel_center = [0.0, 760.0, 0.0]
[wheel]
radius = 300.0
toe = 0.0
camber = 0.0
";
    for toe in [-4.0_f64, -0.3, 1.5] {
        let target = format!("[static]\ntoe = {{ value = {toe:?}, by = \"tie_rod_length\" }}\n");
        let corner = corner(&model(&[geometry, TIE_ROD, &target]));
        // Toe-in of a left wheel turns it to the right.
        let (sin, cos) = (-toe.to_radians()).sin_cos();
        let arm = [-0.120, -0.020];
        let outer = [cos * arm[0] - sin * arm[1], 0.7 + sin * arm[0] + cos * arm[1], 0.0];
        let inner = [-0.130, 0.350, 0.030];
        let distance =
            |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
        let expected = distance(outer, inner) - distance([-0.120, 0.680, 0.0], inner);
        close("tie rod", settings(&corner)[0], expected, 1e-13);
    }
}

/// A tie rod that is a link has the same length as one that is a body.
#[test]
fn a_link_is_as_long_as_a_rod() {
    let target = "[static]\nride_height = 20.0\ntoe = { value = -0.8, by = \"tie_rod_length\" }\n";
    let rod = corner(&model(&[SEDAN, TIE_ROD, target]));
    let links =
        SEDAN.replace("\"double-wishbone\"", "\"../tests/fixtures/architectures/five-links.toml\"");
    let length = "[adjusters.tie_rod_length]\nkind = \"length\"\njoint = \"tierod\"\n";
    let mut link = corner(&model(&[&links, length, target]));
    close("toe", degrees("toe", &link.pose()), -0.8, 1e-10);
    assert!(settings(&rod)[0].abs() > 1e-3);
    close("length", settings(&link)[0], settings(&rod)[0], 1e-12);
}

#[test]
fn targets_are_met_together_and_changes_count_from_there() {
    for drive in [Drive::WheelCenter, Drive::ContactPatch] {
        let setup = Setup { drive, ..Setup::default() };
        let mut corner = at_rest(Corner::new(&sedan(ALL), &setup).unwrap());
        let high = corner.pose();
        for pass in 0..2 {
            let pose = corner.pose();
            close("toe", degrees("toe", &pose), 0.25, 1e-10);
            close("camber", degrees("camber", &pose), -1.5, 1e-10);
            close("caster", degrees("caster", &pose), 6.0, 1e-10);
            let changes =
                ["travel", "half_track_change", "recession", "spring_travel", "wheel_rot_z"];
            for change in changes.into_iter().chain(["wheel_rot_x", "side_view_angle"]) {
                close(change, value(change, &pose), 0.0, 1e-12);
            }
            let height = match drive {
                Drive::WheelCenter => pose.wheel.center[2] + 0.1199,
                Drive::ContactPatch => {
                    // The patch at design, with a camber of −0.5°.
                    let camber = 0.5_f64.to_radians();
                    pose.wheel.contact_patch()[2] + 0.1199 + 0.3266 * camber.cos()
                }
            };
            close("wheel above design", height, 0.012, 1e-12);
            if pass == 0 {
                corner.move_to(0.03, 0.01).unwrap();
                let moved = corner.pose();
                assert!((value("toe", &moved) - value("toe", &high)).abs() > 1e-3);
                corner.reset();
            }
        }
    }
}

/// Where all is rigid, a suspension that has been set is one with other hard points.
#[test]
fn a_suspension_that_is_set_moves_as_one_with_its_points_there() {
    let set = sedan(ALL);
    for set in [set.mirrored(), set] {
        let mut corner = at_rest(Corner::new(&set, &Setup::default()).unwrap());
        let mut other = model(&[SEDAN]);
        if set.side == Side::Right {
            other = other.mirrored();
        }
        let axis = corner.pose().steer_axis.expect("the steer axis passes two joints");
        let system = corner.stand().system();
        let mechanism = system.mechanism();
        let bodies =
            [("tierod_outer", "upright"), ("wheel_center", "upright"), ("spring_lower", "lca")];
        for (name, body) in bodies {
            let point = mechanism.point_named(name).unwrap();
            let body = mechanism.body_named(body).unwrap();
            assert!(other.set_point(name, system.point_position(body, point)));
        }
        assert!(other.set_point("lca_outer", axis.from) && other.set_point("uca_outer", axis.to));
        let alignment = Alignment { toe: 0.25_f64.to_radians(), camber: (-1.5_f64).to_radians() };
        other.spin = SpinAxis::Alignment(alignment);
        let mut expected = Corner::new(&other, &Setup::default()).unwrap();
        for (travel, rack) in [(0.0, 0.0), (0.05, 0.0), (-0.06, 0.02), (0.02, -0.03)] {
            corner.move_to(travel, rack).unwrap();
            expected.move_to(travel, rack).unwrap();
            let (found, expected) = (corner.pose(), expected.pose());
            for factor in hardpoint::factors::FACTORS {
                let by = |pose| factor.value(Convention::Iso, pose);
                match (by(&found), by(&expected)) {
                    (Some(a), Some(b)) => {
                        close(factor.name, a, b, 1e-9 * b.abs().max(1.0));
                    }
                    (a, b) => assert_eq!(a.is_some(), b.is_some(), "{}", factor.name),
                }
            }
        }
    }
}

#[test]
fn adjusters_stay_where_the_hard_points_have_the_values() {
    let caster = degrees("caster", &corner(&model(&[SEDAN])).pose());
    let targets = format!(
        "toe = {{ value = 0.1, by = \"tie_rod_length\" }}\ncamber = {{ value = -0.5, by = \"camber_shim\" }}\n\
         caster = {{ value = {caster:?}, by = \"caster_shim\" }}"
    );
    for setting in settings(&corner(&sedan(&targets))) {
        close("setting", setting, 0.0, 1e-15);
    }
}

/// On rigid joints the wheel load grows with the free length by stiffness times motion ratio.
#[test]
fn seat_of_a_spring_sets_the_wheel_load() {
    let mut before = corner(&sprung(""));
    let (load, ratio) =
        (value("wheel_load", &before.pose()), value("motion_ratio", &before.pose()));
    let mut corner = corner(&sprung("wheel_load = { value = 4100.0, by = \"spring_seat\" }"));
    let pose = corner.pose();
    close("wheel load", value("wheel_load", &pose), 4100.0, 1e-7);
    let seat = settings(&corner)[3];
    close("seat", seat, (4100.0 - load) / (70e3 * ratio), 1e-12);
    // The spring is where it was, only with another force.
    close("spring", value("spring_length", &pose), value("spring_length", &before.pose()), 1e-14);
}

#[test]
fn compliant_axle_meets_all_its_targets_on_both_sides() {
    let model = model(&[SETUP]);
    for kinematic in [false, true] {
        let setup = Setup { kinematic, ..Setup::default() };
        let mut alone = at_rest(Corner::new(&model, &setup).unwrap());
        for base in [model.clone(), model.mirrored()] {
            let mut axle = Axle::new(&base, &setup).unwrap();
            axle.move_to([0.0; 2], 0.0).unwrap();
            for side in [Side::Left, Side::Right] {
                let pose = axle.pose(side);
                close("toe", degrees("toe", &pose), 0.15, 1e-10);
                close("camber", degrees("camber", &pose), -1.5, 1e-10);
                close("caster", degrees("caster", &pose), 6.0, 1e-10);
                close("load", value("wheel_load", &pose), 4000.0, 1e-5);
                close("track", value("half_track_change", &pose), 0.0, 1e-12);
            }
            // The anti-roll bar has no torque, so each side is as if it were alone.
            let found: Vec<f64> = axle.adjustments().iter().map(|a| a.value).collect();
            assert_eq!(found.len(), 10, "four adjusters and the ride height of each side");
            for (found, alone) in found.iter().zip(settings(&alone).repeat(2)) {
                close("setting", *found, alone, 1e-10);
            }
        }
        assert_eq!(alone.adjustments()[0].sets, Some("toe"));
        let pose = alone.pose();
        close("camber", degrees("camber", &pose), -1.5, 1e-10);
    }
}

#[test]
fn sides_of_an_axle_may_be_set_apart() {
    let left = model(&[SETUP]);
    let mut right = left.mirrored();
    right.set_static("toe", -0.4).unwrap();
    right.set_static("wheel_load", 4300.0).unwrap();
    let mut axle =
        Axle::with_sides(&left, &right, &Setup::default(), LoadPoint::default()).unwrap();
    axle.move_to([0.0; 2], 0.0).unwrap();
    let [on_left, on_right] = [Side::Left, Side::Right].map(|side| axle.pose(side));
    close("left toe", degrees("toe", &on_left), 0.15, 1e-10);
    close("right toe", degrees("toe", &on_right), -0.4, 1e-10);
    close("left load", value("wheel_load", &on_left), 4000.0, 1e-5);
    close("right load", value("wheel_load", &on_right), 4300.0, 1e-5);
    assert!(axle.adjustments().iter().any(|set| set.name == "right_spring_seat"));
}

/// Tangents along all kinds of adjusters against central differences, rigid and compliant.
#[test]
fn tangents_along_adjusters_are_exact() {
    for (model, kinematic) in [(sprung(""), true), (model(&[SETUP]), false)] {
        let setup = Setup { kinematic, ..Setup::default() };
        let suspension = model.suspension(&setup).unwrap();
        let mut stand = Stand::new(suspension.mechanism.clone(), &[], model.axes).unwrap();
        let away = [0.004, -0.003, 0.002, 0.005];
        let at: Vec<(DriverId, f64)> = suspension.adjusters.iter().copied().zip(away).collect();
        let mut values = at.clone();
        values.push((suspension.travel, 0.02));
        for &(driver, value) in &at {
            let (h, body) = (1e-5, suspension.wheel.body);
            let mut side = |step: f64| {
                let mut moved = values.clone();
                let entry = moved.iter_mut().find(|(other, _)| *other == driver).unwrap();
                entry.1 = value + step;
                stand.move_to(&moved).unwrap();
                let load = -stand.equilibrium().driver_multiplier(suspension.travel);
                (stand.state()[body.index()], load)
            };
            let ((ahead, more), (behind, less)) = (side(h), side(-h));
            stand.move_to(&values).unwrap();
            let differences: Vec<f64> =
                ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * h)).collect();
            let here = stand.state()[body.index()];
            let expected = Twist::new(&here, &differences);
            let name = &suspension.mechanism.drivers()[driver.index()].name;
            let twist = stand.rates().tangent(driver).unwrap().twist(body);
            for k in 0..3 {
                close(name, twist.velocity[k], expected.velocity[k], 2e-6);
                close(name, twist.rotation[k], expected.rotation[k], 2e-6);
            }
            // The load by another driver, through the multipliers.
            let held = stand.rates().force_rate(suspension.travel, driver).unwrap();
            let expected = (more - less) / (2.0 * h);
            close(name, held, expected, 1e-6 * expected.abs().max(1e4));
        }
    }
}

/// The wheel is free on its tyre, but what changes are counted from is the state in which it is held.
#[test]
fn a_wheel_on_its_tyre_has_the_settings_of_the_held_one() {
    let model = model(&[SETUP]);
    let held = corner(&model);
    let setup = Setup { support: WheelSupport::Free, chassis: Chassis::Fixed, ..Setup::default() };
    let mut free = Corner::new(&model, &setup).unwrap();
    free.rest().unwrap();
    assert_eq!(settings(&free), settings(&held));
    let pose = free.pose();
    let center = held.pose_at(held.stand().state()).wheel.center;
    close("travel", value("travel", &pose), pose.wheel.center[2] - center[2], 1e-12);
    // The ground is 10 mm nearer to the chassis, so the tyre carries what it did at the hard points.
    let tyre = model.tyre().unwrap();
    let deflection = tyre.ground + 0.01 - pose.wheel.contact_patch()[2];
    close("load", value("wheel_load", &pose), 220e3 * deflection, 1e-6);
    assert!(value("travel", &pose).abs() > 1e-4, "the tyre stands elsewhere");
}

#[test]
fn names_and_kinds_of_static_factors_are_those_of_the_table() {
    for (name, quantity) in STATIC_FACTORS {
        assert_eq!(find(name).map(|factor| factor.quantity), Ok(*quantity), "{name}");
    }
}

fn refused(model: &Model) -> String {
    match Corner::new(model, &Setup::default()) {
        Err(error @ RigError::Adjust(_)) => error.to_string(),
        Err(error) => panic!("{error}"),
        Ok(_) => panic!("the static state was reached"),
    }
}

#[test]
fn what_cannot_be_set_is_said_by_name() {
    insta::assert_snapshot!(
        "limit",
        refused(&model(&[
            SEDAN,
            TIE_ROD,
            "limits = [-2.0, 2.0]\n[static]\ntoe = { value = 5.0, by = \"tie_rod_length\" }",
        ]))
    );
    let far = "toe = { value = 150.0, by = \"tie_rod_length\" }";
    let out_of_reach = refused(&sedan(far));
    assert!(out_of_reach.starts_with("toe cannot be brought to 150.0000 deg"), "{out_of_reach}");
    insta::assert_snapshot!(
        "no_effect",
        refused(&sprung("toe = { value = 0.2, by = \"spring_seat\" }"))
    );
    insta::assert_snapshot!(
        "undefined",
        refused(&model(&[
            &SEDAN.replace("angle = \"deg\"", "angle = \"deg\"\nforce = \"N\""),
            TIE_ROD,
            "[static]\nwheel_load = { value = 4000.0, by = \"tie_rod_length\" }",
        ]))
    );
    let twice = "
[adjusters.other_end]
kind = \"length\"
body = \"tierod\"
ends = [\"tierod_outer\", \"tierod_inner\"]
[static]
toe = { value = 0.2, by = \"tie_rod_length\" }
camber = { value = -1.0, by = \"other_end\" }
";
    insta::assert_snapshot!("alike", refused(&model(&[SEDAN, TIE_ROD, twice])));
    let low = refused(&sedan("ride_height = 900.0"));
    assert!(low.starts_with("the static state cannot be reached from the hard points: "), "{low}");
}

#[test]
fn targets_and_settings_are_exchanged_by_name() {
    let mut model = sedan("toe = { value = 0.25, by = \"tie_rod_length\" }");
    model.set_static("toe", -0.2).unwrap();
    model.set_static("ride_height", 5.0).unwrap();
    model.set_static("camber_shim", 3.0).unwrap();
    let mut corner = corner(&model);
    close("toe", degrees("toe", &corner.pose()), -0.2, 1e-10);
    close("shim", settings(&corner)[1], 0.003, 0.0);
    close("ride height", corner.pose().wheel.center[2], -0.1199 - 0.005, 1e-12);
    let refuse = |model: &mut Model, name, value| model.set_static(name, value).unwrap_err();
    assert!(refuse(&mut model, "tie_rod_length", 1.0).contains("set `toe` instead"));
    assert!(refuse(&mut model, "caster", 1.0).contains("no adjuster of the model sets `caster`"));
    assert!(refuse(&mut model, "camber_shm", 1.0).contains("did you mean `camber_shim`"));
    assert!(refuse(&mut model, "camber_shim", 101.0).contains("from -100 to 100 mm"));
    assert!(refuse(&mut model, "toe", f64::NAN).contains("not a finite number"));
}
