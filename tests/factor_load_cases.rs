//! Factors from the compliance against finely stepped load cases.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;
#[path = "common/elastic.rs"]
mod elastic;
#[path = "common/hanging.rs"]
mod hanging;

use axles::{NO_TYRE, axle, close};
use elastic::{poses, value, with_vehicle};
use hanging::{Hanging, PATCH, Slopes};
use hardpoint::factors::{Convention, FACTORS, Need};
use hardpoint::model::{Axle as AxleOf, Model, Setup};
use hardpoint::rig::{Corner, Pose};

const BUSHED: &str = include_str!("../models/bushed-double-wishbone.toml");
const BUSHED_TYRE: &str = "[tyre]\ncontact = \"wheel-center\"\nstiffness = 220.0\n\
                           ground = -428.0\nlift_off = false\n";

fn bushed(tyre: bool) -> Model {
    assert!(BUSHED.contains(BUSHED_TYRE));
    let text = if tyre { BUSHED.to_owned() } else { BUSHED.replace(BUSHED_TYRE, "") };
    Model::parse("models/model.toml", &text).unwrap_or_else(|e| panic!("{}", e.render()))
}

/// The load cases of one wheel, `w`, and of the other one.
struct Case<'a> {
    w: usize,
    hanging: &'a mut Hanging,
}

impl Case<'_> {
    /// Slopes under the same load on both wheels, and under opposed ones.
    fn slopes(&mut self, component: usize, at_patch: bool, opposed: bool) -> [Slopes; 2] {
        // The own wheel has the unit load, whichever it is.
        let sign = if opposed { -1.0 } else { 1.0 };
        let [own, other] = [self.w, 1 - self.w];
        let mut signs = [0.0; 2];
        (signs[own], signs[other]) = (1.0, sign);
        let both = self.hanging.slopes(component, at_patch, signs);
        [both[own], both[other]]
    }
}

fn check_against_load_cases(tyred: &Model, bare: &Model, travel: [f64; 2], rack: f64) {
    let setup = Setup::default();
    let poses = poses(tyred, &setup, travel, rack);
    let mut hanging = Hanging::at(bare, &setup, &poses, rack);
    for (w, pose) in poses.iter().enumerate() {
        let sigma = pose.side.sign();
        let other = poses[1 - w];
        let mut case = Case { w, hanging: &mut hanging };
        let mut compared = 0;
        let mut is = |name: &str, expected: f64, size: f64| {
            let found = value(name, pose);
            close(name, found, expected, 1e-7 * expected.abs().max(size));
            compared += 1;
        };
        // Angles by force are near a microradian by newton, ways near a micrometre.
        const BY_FORCE: f64 = 1e-6;
        let tyres = [pose.tyre.unwrap().rate, other.tyre.unwrap().rate];
        let track = sigma * (pose.wheel.contact_patch()[1] - other.wheel.contact_patch()[1]);

        let [own, across] = case.slopes(2, false, false);
        is("wheel_rate_parallel", 1.0 / own.center[2], 1.0);
        is("ride_rate", 1.0 / (own.center[2] + 1.0 / tyres[0]), 1.0);
        is("hop_rate", 1.0 / own.center[2] + tyres[0], 1.0);
        is("ride_steer", own.toe / own.center[2], 1e-2);
        is("ride_camber", own.camber / own.center[2], 1e-2);
        is("ride_caster", own.windup / own.center[2], 1e-2);
        let wider = sigma * (own.lowest[1] - across.lowest[1]);
        is("tread_change", 2.0 * wider / (own.center[2] + across.center[2]), 1e-2);
        is("svsa_elastic_angle", (own.center[0] / own.center[2]).atan(), 1e-2);
        let length = own.center[0].hypot(own.center[2]);
        is("svsa_elastic_length", length / own.windup, 1.0);
        let alone = 0.25 * track * track * (1.0 / own.center[2] + 1.0 / across.center[2]);

        let [own, across] = case.slopes(2, false, true);
        is("wheel_rate_opposed", 1.0 / own.center[2], 1.0);
        let apart = own.center[2] - across.center[2];
        let roll_rate = track * track / apart;
        is("roll_rate", roll_rate, 1.0);
        is("roll_bar_rate", roll_rate - alone, roll_rate);
        let soft = 1.0 / tyres[0] + 1.0 / tyres[1];
        is("total_roll_rate", track * track / (apart + soft), 1.0);
        is("fvsa_elastic_angle", (sigma * own.center[1] / own.center[2]).atan(), 1e-2);
        let length = own.center[1].hypot(own.center[2]);
        is("fvsa_elastic_length", sigma * length / own.turn[0], 1.0);
        let apart = [across.lowest[1] - own.lowest[1], across.lowest[2] - own.lowest[2]];
        let base = [1, 2].map(|k| other.wheel.contact_patch()[k] - pose.wheel.contact_patch()[k]);
        let roll_of = |rise: f64| {
            -(rise * base[0] - apart[0] * base[1]) / (base[0].powi(2) + base[1].powi(2))
        };
        for (end, roll) in [("elastic", roll_of(apart[1])), ("total", roll_of(apart[1] - soft))] {
            is(&format!("roll_steer_{end}"), -sigma * own.toe / roll, 1e-2);
            is(&format!("roll_camber_{end}"), own.camber / roll, 1e-2);
            is(&format!("roll_caster_{end}"), own.windup / roll, 1e-2);
        }

        for (end, opposed) in [("", false), ("_opposed", true)] {
            let [own, _] = case.slopes(1, PATCH, opposed);
            is(&format!("lateral_force_deflection{end}"), own.center[1], BY_FORCE);
            is(&format!("lateral_force_deflection_patch{end}"), own.patch[1], BY_FORCE);
            is(&format!("lateral_force_steer{end}"), -sigma * own.toe, BY_FORCE);
            is(&format!("lateral_force_camber{end}"), -sigma * own.camber, BY_FORCE);
            let [own, _] = case.slopes(5, false, opposed);
            is(&format!("aligning_torque_steer{end}"), -sigma * own.toe, 1e-5);
            is(&format!("aligning_torque_camber{end}"), -sigma * own.camber, 1e-5);
            if !opposed {
                is("toe_stiffness", 1.0 / own.turn[2], 1.0);
            }
        }
        let [own, _] = case.slopes(1, PATCH, false);
        is("patch_stiffness_y", 1.0 / own.patch[1], 1.0);
        let [own, _] = case.slopes(1, false, false);
        is("center_stiffness_y", 1.0 / own.center[1], 1.0);
        for (component, name) in [(3, "camber_stiffness"), (4, "caster_stiffness")] {
            let [own, _] = case.slopes(component, false, false);
            is(name, 1.0 / own.turn[component - 3], 1.0);
        }
        let [driven, _] = case.slopes(0, false, false);
        is("center_stiffness_x", 1.0 / driven.center[0], 1.0);
        is("traction_deflection", driven.center[0], BY_FORCE);
        is("traction_steer", driven.toe, BY_FORCE);
        is("traction_camber", driven.camber, BY_FORCE);
        is("traction_caster", driven.windup, BY_FORCE);
        let [braked, _] = case.slopes(0, PATCH, false);
        is("patch_stiffness_x", 1.0 / braked.patch[0], 1.0);
        is("braking_deflection", braked.center[0], BY_FORCE);
        is("braking_deflection_patch", braked.patch[0], BY_FORCE);
        is("braking_steer", -braked.toe, BY_FORCE);
        is("braking_camber", -braked.camber, BY_FORCE);
        is("braking_caster", -braked.windup, BY_FORCE);

        let [pressed, _] = case.slopes(2, PATCH, false);
        let share = 0.65 * 2.776 / 0.55;
        let anti = share * braked.center[2] / pressed.center[2];
        is("anti_dive_elastic", anti, 1e-2);
        let weight = 1600.0 * 9.80665 / 2.0;
        let dive = weight * (0.55 / 2.776 * pressed.center[2] - 0.65 * braked.center[2]);
        is("dive_braking", dive, 1e-3);
        is("dive_braking_pitch", dive / 2.776, 1e-3);

        check_holding(&mut case, &poses);
        check_roll_center(&mut case, pose, &other, soft);
        assert!(compared > 40);
    }
}

/// A vertical force on a wheel by the force that both have along an axis of the vehicle.
type Jacking = fn(&Pose<f64>) -> f64;

/// The jacking forces at the patches hold the patches; those of the other wheel are its own.
fn check_holding(case: &mut Case<'_>, poses: &[Pose<f64>; 2]) {
    let [own, across] = [poses[case.w], poses[1 - case.w]];
    // By a force to the left on both wheels: inboard on the right one.
    let left: Jacking = |pose| -pose.side.sign() * value("jacking_lateral", pose);
    let rear: Jacking = |pose| -value("jacking_braking", pose);
    let ahead: Jacking = |pose| value("jacking_traction", pose);
    let lifts = [(1, PATCH, left), (0, PATCH, rear), (0, false, ahead)];
    for (component, at_patch, jacking) in lifts {
        let height = |slopes: &Slopes| if at_patch { slopes.patch[2] } else { slopes.center[2] };
        let (same, opposed) =
            (0.5 * (jacking(&own) + jacking(&across)), 0.5 * (jacking(&own) - jacking(&across)));
        let loaded = case.slopes(component, at_patch, false);
        let lifted = case.slopes(2, at_patch, false);
        let rolled = case.slopes(2, at_patch, true);
        for k in 0..2 {
            let rise =
                height(&loaded[k]) + same * height(&lifted[k]) + opposed * height(&rolled[k]);
            close("held height", rise, 0.0, 1e-7 * height(&lifted[0]));
        }
    }
    // The heights of the patches are held at the loaded radius, a little above the lowest point.
    let arm = |pose: &Pose<f64>| {
        let (wheel, tyre) = (pose.wheel, pose.tyre.unwrap());
        wheel.center[1]
            + (wheel.contact_patch()[1] - wheel.center[1]) * (1.0 - tyre.deflection / wheel.radius)
    };
    let moment = arm(&own) * left(&own) + arm(&across) * left(&across);
    close("force_rc_height", value("force_rc_height", &own), -0.5 * moment, 1e-12);
    let angle = value("force_drive_angle", &own);
    close("force_drive_angle", angle, -ahead(&own).atan(), 1e-12);
    close("force_brake_angle", value("force_brake_angle", &own), -rear(&own).atan(), 1e-12);
}

/// Adams' lines through the patches.
fn check_roll_center(case: &mut Case<'_>, own: &Pose<f64>, other: &Pose<f64>, soft: f64) {
    let slopes = case.slopes(2, PATCH, true);
    let tyre = 0.5 * soft;
    for (end, more) in [("elastic", 0.0), ("total", tyre)] {
        let lines =
            [(own, slopes[0], more), (other, slopes[1], -more)].map(|(pose, slopes, more)| {
                let (wheel, tyre) = (pose.wheel, pose.tyre.unwrap());
                let part = 1.0 - tyre.deflection / wheel.radius;
                let p = [1, 2]
                    .map(|k| wheel.center[k] + part * (wheel.contact_patch()[k] - wheel.center[k]));
                (p, slopes.patch[1], slopes.patch[2] + more)
            });
        let [(p, dy, dz), (q, ey, ez)] = lines;
        let [a, b] = [dy * p[0] + dz * p[1], ey * q[0] + ez * q[1]];
        let determinant = dy * ez - ey * dz;
        let [y, z] = [(a * ez - b * dz) / determinant, (dy * b - ey * a) / determinant];
        let ground = p[1] + (q[1] - p[1]) * (y - p[0]) / (q[0] - p[0]);
        let name = format!("roll_center_{end}");
        // The tyres of both wheels have the same rate.
        let found = [value(&format!("{name}_y"), own), value(&format!("{name}_z"), own)];
        close(&name, found[0], y, 1e-6);
        close(&name, found[1], z - ground, 1e-7);
        if more == 0.0 {
            close("rc_height_elastic", value("rc_height_elastic", own), p[0] * dy / dz, 1e-8);
        }
    }
}

/// The wheels are held at different travels and steered, so every load comes from its own state.
#[test]
fn factors_of_an_axle_are_slopes_of_load_cases() {
    let tyred = with_vehicle(axle(&[]), AxleOf::Front);
    check_against_load_cases(&tyred, &axle(&[NO_TYRE]), [0.015, -0.02], 0.006);
}

/// The bushings of this model have no energy.
#[test]
fn factors_without_energy_are_slopes_of_load_cases() {
    let tyred = with_vehicle(bushed(true), AxleOf::Front);
    check_against_load_cases(&tyred, &bushed(false), [0.01, 0.01], -0.004);
    // A corner is one side of an axle that nothing couples.
    let [left, _] = poses(&tyred, &Setup::default(), [0.01, 0.01], 0.0);
    let mut corner = Corner::new(&tyred, &Setup::default()).unwrap();
    corner.measure_compliance(true);
    corner.move_to(0.01, 0.0).unwrap();
    let pose = corner.pose();
    let mut compared = 0;
    for factor in FACTORS.iter().filter(|factor| factor.needs.contains(&Need::Compliance)) {
        if factor.needs.contains(&Need::BothWheels) {
            assert_eq!(factor.value(Convention::Iso, &pose), None, "{}", factor.name);
            continue;
        }
        let [a, b] = [&pose, &left].map(|pose| factor.value(Convention::Iso, pose));
        let [Some(a), Some(b)] = [a, b] else {
            assert!(!factor.applies(&pose), "{}", factor.name);
            continue;
        };
        close(factor.name, a, b, 1e-10 * b.abs().max(1e-6));
        compared += 1;
    }
    assert!(compared > 40, "{compared}");
}
