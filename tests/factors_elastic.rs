//! Factors from the compliance against the kinematic ones and Adams' formulas.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;
#[path = "common/elastic.rs"]
mod elastic;

use std::f64::consts::PI;

use axles::{CUT, NO_TYRE, axle, close};
use elastic::{poses, value, value_by, with_vehicle};
use hardpoint::factors::{Convention, FACTORS, Need, find};
use hardpoint::model::{Axle as AxleOf, Brakes, Model, Quantity, Setup};
use hardpoint::rig::{Axle, Corner, Pose};

const RIGID: fn() -> Setup = || Setup { kinematic: true, ..Setup::default() };

/// A rigid wheel has one way to go, φ, whatever the load: C = φ φᵀ/k.
#[test]
fn rigid_axle_has_the_kinematic_factors() {
    const PAIRS: &[(&str, &str)] = &[
        ("ride_steer", "bump_steer"),
        ("ride_camber", "bump_camber"),
        ("svic_elastic_x", "svic_x"),
        ("svic_elastic_z", "svic_z"),
        ("svsa_elastic_length", "svsa_length"),
        ("svsa_elastic_angle", "svsa_angle"),
        ("fvic_elastic_y", "fvic_y"),
        ("fvic_elastic_z", "fvic_z"),
        ("fvsa_elastic_length", "fvsa_length"),
        ("fvsa_elastic_angle", "fvsa_angle"),
        ("roll_steer_elastic", "roll_steer"),
        ("roll_camber_elastic", "roll_camber"),
        ("rc_height_elastic", "rc_height"),
        ("force_rc_height", "rc_height"),
        ("roll_center_elastic_y", "roll_center_y"),
        ("roll_center_elastic_z", "roll_center_z"),
    ];
    let anti = |axle| match axle {
        AxleOf::Front => ["anti_dive", "anti_lift_drive"],
        AxleOf::Rear => ["anti_lift", "anti_squat"],
    };
    for axle_of in [AxleOf::Front, AxleOf::Rear] {
        for brakes in [Brakes::Outboard, Brakes::Inboard] {
            let mut model = with_vehicle(axle(&[NO_TYRE]), axle_of);
            model.vehicle.brakes = brakes;
            for pose in poses(&model, &RIGID(), [0.02, 0.02], 0.0) {
                let near = |name: &str, expected: f64| {
                    close(name, value(name, &pose), expected, 1e-9 * expected.abs().max(0.1));
                };
                for (elastic, kinematic) in PAIRS {
                    near(elastic, value(kinematic, &pose));
                }
                near("ride_caster", -value("angular_velocity_y", &pose));
                near("tread_change", 2.0 * pose.side.sign() * value("patch_path_y", &pose));
                for kinematic in anti(axle_of) {
                    near(&format!("{kinematic}_elastic"), value(kinematic, &pose));
                }
                near("force_brake_angle", value("tan_brake", &pose).atan());
                near("force_drive_angle", value("tan_drive", &pose).atan());
                let lever = value("rc_height", &pose) / pose.wheel.contact_patch()[1].abs();
                near("jacking_lateral", lever);
                // The load transfer, less what the links take up, goes into the spring.
                let transfer = 1600.0 * 9.80665 * 0.55 / 2.776 / 2.0;
                let rate = value("wheel_rate_parallel", &pose);
                let [_, driven] =
                    anti(axle_of).map(|name| value(&format!("{name}_elastic"), &pose));
                let name = match axle_of {
                    AxleOf::Front => "lift_driving",
                    AxleOf::Rear => "squat_driving",
                };
                near(name, transfer / rate * (1.0 - driven));
                near(&format!("{name}_pitch"), transfer / rate * (1.0 - driven) / 2.776);
            }
        }
    }
    // Without a bar the wheels do not know of each other.
    let [cut, _] = poses(&axle(&[NO_TYRE, CUT]), &RIGID(), [0.02, 0.02], 0.0);
    let rate = value("wheel_rate", &cut);
    for name in ["wheel_rate_parallel", "wheel_rate_opposed"] {
        close(name, value(name, &cut), rate, 1e-9 * rate);
    }
    let roll_rate = 0.5 * value("track", &cut).powi(2) * rate;
    close("roll_rate", value("roll_rate", &cut), roll_rate, 1e-9 * roll_rate);
    close("roll_bar_rate", value("roll_bar_rate", &cut), 0.0, 1e-9 * roll_rate);
    let [coupled, _] = poses(&axle(&[NO_TYRE]), &RIGID(), [0.02, 0.02], 0.0);
    assert!(value("roll_bar_rate", &coupled) > 0.1 * roll_rate);
}

/// A corner that is rigid, with a tyre, whose rate is in series with the wheel rate.
#[test]
fn quarter_car_has_its_frequencies() {
    let mut model = Model::load("models/quarter-car.toml").unwrap();
    model.vehicle.unsprung_mass = Some(45.0);
    let mut corner = Corner::new(&model, &Setup::default()).unwrap();
    corner.measure_compliance(true);
    corner.move_to(0.03, 0.0).unwrap();
    let pose = corner.pose();
    let (rate, tyre) = (value("wheel_rate", &pose), 220_000.0);
    close("tyre_rate", value("tyre_rate", &pose), tyre, 1e-6);
    close("wheel_rate_parallel", value("wheel_rate_parallel", &pose), rate, 1e-9 * rate);
    let ride = rate * tyre / (rate + tyre);
    close("ride_rate", value("ride_rate", &pose), ride, 1e-9 * ride);
    // 380 kg stand in [quarter_car].
    close("ride_frequency", value("ride_frequency", &pose), (ride / 380.0).sqrt() / 2.0 / PI, 1e-9);
    let hop = ((rate + tyre) / 45.0).sqrt() / 2.0 / PI;
    close("hop_frequency", value("hop_frequency", &pose), hop, 1e-8);
    let radius = 0.3266 - value("wheel_load", &pose) / tyre;
    close("loaded_radius", value("loaded_radius", &pose), radius, 1e-12);
    for (elastic, kinematic) in [
        ("ride_steer", "bump_steer"),
        ("ride_camber", "bump_camber"),
        ("svsa_elastic_length", "svsa_length"),
        ("fvsa_elastic_length", "fvsa_length"),
    ] {
        let expected = value(kinematic, &pose);
        close(elastic, value(elastic, &pose), expected, 1e-9 * expected.abs());
    }
}

/// The matrix in the axes of Adams/Car, with its numbers from one.
fn by_adams(axle: &mut Axle) -> impl Fn(usize, usize) -> f64 {
    const TURNED: [f64; 6] = [-1.0, -1.0, 1.0, -1.0, -1.0, 1.0];
    let matrix = axle.compliance().unwrap();
    move |i: usize, j: usize| TURNED[(i - 1) % 6] * TURNED[(j - 1) % 6] * matrix.entry(i - 1, j - 1)
}

#[test]
fn formulas_of_adams_are_those_of_its_help() {
    for axle_of in [AxleOf::Front, AxleOf::Rear] {
        let model = with_vehicle(axle(&[]), axle_of);
        let mut axle = Axle::new(&model, &Setup::default()).unwrap();
        axle.measure_compliance(true);
        axle.move_to([0.015, -0.02], 0.006).unwrap();
        let [left, right] = axle.poses();
        let c = by_adams(&mut axle);
        let is = |name: &str, pose: &Pose<f64>, expected: f64| {
            let found = value_by(Convention::Adams, name, pose);
            close(name, found, expected, 1e-12 * expected.abs().max(1e-9));
        };
        let [kt, rt] = [&left, &right].map(|pose| pose.tyre.unwrap().rate);
        let track = value("track", &left);
        let bracket = c(3, 3) - c(3, 9) - c(9, 3) + c(9, 9);
        let rise = bracket + 1.0 / kt + 1.0 / rt;
        let steer = 0.5 * (c(6, 3) - c(6, 9) + c(12, 3) - c(12, 9));
        for pose in [&left, &right] {
            is("roll_rate", pose, track * track / bracket);
            is("total_roll_rate", pose, track * track / rise);
            is("roll_steer_total", pose, steer * track / rise);
        }
        is("wheel_rate_parallel", &left, 1.0 / (c(3, 3) + c(3, 9)));
        is("wheel_rate_parallel", &right, 1.0 / (c(9, 3) + c(9, 9)));
        is("center_stiffness_x", &right, 1.0 / (c(7, 1) + c(7, 7)));
        // +z is to the left: toe-out on the left wheel.
        is("ride_steer", &left, -(c(6, 3) + c(6, 9)) / (c(3, 3) + c(3, 9)));
        is("ride_steer", &right, (c(12, 3) + c(12, 9)) / (c(9, 3) + c(9, 9)));
        is("ride_camber", &left, (c(4, 3) + c(4, 9)) / (c(3, 3) + c(3, 9)));
        is("ride_camber", &right, -(c(10, 3) + c(10, 9)) / (c(9, 3) + c(9, 9)));
        is("ride_caster", &left, (c(5, 3) + c(5, 9)) / (c(3, 3) + c(3, 9)));
        is("ride_caster", &right, (c(11, 3) + c(11, 9)) / (c(9, 3) + c(9, 9)));
        is("roll_camber_total", &left, 1.0 - (c(4, 9) - c(4, 3)) * track / rise);
        is("roll_camber_total", &right, 1.0 - (c(10, 9) - c(10, 3)) * track / rise);
        is("roll_caster_total", &left, (c(5, 3) - c(5, 9)) * track / rise);
        is("roll_caster_total", &right, (c(11, 3) - c(11, 9)) * track / rise);
        is("aligning_torque_steer", &left, c(6, 6) + c(6, 12));
        is("aligning_torque_steer", &right, c(12, 6) + c(12, 12));
        is("aligning_torque_camber", &left, c(4, 6) + c(4, 12));
        is("aligning_torque_camber", &right, -(c(10, 6) + c(10, 12)));
        let [a, b] = [&left, &right].map(|pose| value("loaded_radius", pose));
        let radius = 0.5 * (a + b);
        let (name, sign) = match axle_of {
            AxleOf::Front => ("anti_dive_elastic", 1.0),
            AxleOf::Rear => ("anti_lift_elastic", -1.0),
        };
        let (force, weight) = (0.65 / 2.0, sign * 0.55 / 2.0 / 2.776);
        let zf = force * (c(3, 1) - radius * c(3, 5)) + force * (c(3, 7) - radius * c(3, 11));
        is(name, &left, -zf / (weight * (c(3, 3) + c(3, 9))));
        let zf = force * (c(9, 1) - radius * c(9, 5)) + force * (c(9, 7) - radius * c(9, 11));
        is(name, &right, -zf / (weight * (c(9, 3) + c(9, 9))));
        // Its angles are turns about the axes of the vehicle, ours toe and camber.
        for (name, size) in [("ride_camber", 0.0), ("aligning_torque_steer", 0.0), (name, 1.0)] {
            let (ours, theirs) = (value(name, &left), value_by(Convention::Adams, name, &left));
            close(name, ours, theirs, 2e-2 * theirs.abs().max(size));
        }
        let (ours, theirs) = (
            value("roll_camber_total", &left),
            value_by(Convention::Adams, "roll_camber_total", &left),
        );
        close("lean", 1.0 - ours, theirs, 1e-2);
    }
}

/// What changes its sign from one side to the other: what is counted by a turn or a side in space.
fn changes(convention: Convention, name: &str) -> bool {
    match (convention, name) {
        (Convention::Adams, "roll_caster_total" | "aligning_torque_camber") => true,
        (Convention::Adams, "roll_camber_total") => false,
        _ if name.starts_with("roll_camber_") || name.starts_with("roll_caster_") => true,
        _ => name.ends_with("_y") && !name.contains("stiffness"),
    }
}

#[test]
fn mirror_images_have_mirrored_factors() {
    let model = with_vehicle(axle(&[]), AxleOf::Front);
    let mirrored = model.mirrored();
    let straight = poses(&model, &Setup::default(), [0.02, 0.02], 0.0);
    let turned = poses(&model, &Setup::default(), [0.02, -0.01], 0.005);
    let image = poses(&mirrored, &Setup::default(), [-0.01, 0.02], -0.005);
    let pairs = [(straight[0], straight[1]), (turned[0], image[1]), (turned[1], image[0])];
    let elastic = |need: &Need| *need == Need::Compliance;
    for factor in FACTORS.iter().filter(|factor| factor.needs.iter().any(elastic)) {
        if !factor.applies(&straight[0]) {
            continue;
        }
        for convention in [Convention::Iso, Convention::Adams, Convention::Lotus] {
            for (a, b) in &pairs {
                let [a, b] = [a, b].map(|pose| value_by(convention, factor.name, pose));
                let b = if changes(convention, factor.name) { -b } else { b };
                let least = if factor.quantity == Quantity::Length { 1e-2 } else { 1e-7 };
                close(factor.name, a, b, 1e-8 * b.abs().max(least));
            }
        }
    }
}

#[test]
fn what_is_rigid_or_at_infinity_has_no_value() {
    let mut model = axle(&[NO_TYRE]);
    for (name, position) in [
        ("lca_front", [0.2, 0.42, -0.3]),
        ("lca_rear", [-0.2, 0.42, -0.3]),
        ("lca_outer", [0.0, 0.77, -0.3]),
        ("uca_front", [0.2, 0.42, 0.1]),
        ("uca_rear", [-0.2, 0.42, 0.1]),
        ("uca_outer", [0.0, 0.77, 0.1]),
        ("tierod_inner", [-0.15, 0.42, -0.12]),
        ("tierod_outer", [-0.15, 0.77, -0.12]),
    ] {
        assert!(model.set_point(name, position));
    }
    let [pose, _] = poses(&model, &RIGID(), [0.0; 2], 0.0);
    let found = |name: &str| find(name).unwrap().value(Convention::Iso, &pose);
    for name in [
        "fvic_elastic_y",
        "fvsa_elastic_length",
        "svic_elastic_x",
        "svsa_elastic_length",
        "center_stiffness_x",
        "center_stiffness_y",
        "patch_stiffness_y",
        "toe_stiffness",
        "camber_stiffness",
        "caster_stiffness",
    ] {
        assert_eq!(found(name), None, "{name}");
    }
    for name in ["lateral_force_steer", "ride_steer", "jacking_lateral", "rc_height_elastic"] {
        close(name, found(name).unwrap(), 0.0, 1e-10);
    }
    for name in ["ride_rate", "ride_frequency", "roll_steer_total", "dive_braking"] {
        assert_eq!(found(name), None, "{name}");
    }
    let missing = |name: &str| find(name).unwrap().missing(&pose).collect::<Vec<Need>>();
    assert_eq!(missing("ride_frequency"), [Need::Tyre, Need::SprungMass]);
    assert!(missing("dive_braking").contains(&Need::Mass));

    // Nothing holds the wheel: no compliance, no factor of it.
    let mut bare =
        Corner::new(&Model::load("models/double-wishbone.toml").unwrap(), &RIGID()).unwrap();
    bare.measure_compliance(true);
    let pose = bare.pose();
    let missing = |name: &str| find(name).unwrap().missing(&pose).collect::<Vec<Need>>();
    assert_eq!(missing("ride_steer"), [Need::Compliance]);
    assert_eq!(find("ride_steer").unwrap().value(Convention::Iso, &pose), None);
}

/// Compliances are shown as test rigs print them, whatever the unit of force of the model.
#[test]
fn units_are_those_of_test_rigs() {
    let model = with_vehicle(axle(&[]), AxleOf::Front);
    let [pose, _] = poses(&model, &Setup::default(), [0.0; 2], 0.0);
    for (name, column, factor) in [
        ("lateral_force_steer", "lateral_force_steer_deg/kN", 1e3 * 180.0 / PI),
        ("lateral_force_deflection", "lateral_force_deflection_mm/kN", 1e6),
        ("aligning_torque_steer", "aligning_torque_steer_deg/(kN·m)", 1e3 * 180.0 / PI),
        ("roll_rate", "roll_rate_N·m/deg", PI / 180.0),
        ("ride_frequency", "ride_frequency_Hz", 1.0),
        ("dive_braking", "dive_braking_mm/g", 1e3),
        ("dive_braking_pitch", "dive_braking_pitch_deg/g", 180.0 / PI),
        ("roll_steer_total", "roll_steer_total_pct", 100.0),
    ] {
        let definition = find(name).unwrap();
        assert_eq!(definition.column(model.units), column);
        let shown = definition.show(model.units, &pose).unwrap();
        close(name, shown, factor * value(name, &pose), 1e-12 * shown.abs());
        let quantity = definition.quantity;
        close(name, quantity.to_si(model.units, shown), value(name, &pose), 1e-14 * shown.abs());
    }
}
