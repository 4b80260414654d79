//! Forces, masses, bushings and tyres of models in SI units.
#![allow(missing_docs)]

use hardpoint::mechanism::{
    Acts, Force, ForceKind, Law, LoadFrame, MomentLaw, Reference, RotationMeasure,
};
use hardpoint::model::{
    AngleUnit, ForceUnit, LengthUnit, MassUnit, Model, Quantity, TyreContact, Units,
};

const EVERY_FORCE: &str = include_str!("fixtures/every-force.toml");
/// The length of the spring at the design position (m).
const SPRING: f64 = 0.511_468_474_101_776_9;

fn load(name: &str) -> Model {
    Model::load(format!("models/{name}.toml")).unwrap_or_else(|e| panic!("{}", e.render()))
}

fn parse(text: &str) -> Model {
    Model::parse("model.toml", text).unwrap_or_else(|e| panic!("{}", e.render()))
}

fn force<'m>(model: &'m Model, name: &str) -> &'m Force {
    model.forces().iter().find(|force| force.name == name).unwrap_or_else(|| panic!("{name}"))
}

#[track_caller]
fn near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{actual} {expected}");
}

/// λ of a line force at a length (m) and a rate (m/s).
fn tension(model: &Model, name: &str, length: f64, rate: f64) -> f64 {
    match &force(model, name).kind {
        ForceKind::Line { reference, law, .. } => {
            let reference = match reference {
                Reference::Length(length) => *length,
                Reference::Design(offset) => SPRING + offset,
            };
            law.at(length - reference, rate).force
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_design_length_of_the_spring_is_what_it_says() {
    let model = parse(EVERY_FORCE);
    let (upper, lower) =
        (model.point("spring_upper").unwrap(), model.point("spring_lower").unwrap());
    near((0..3).map(|k| (upper[k] - lower[k]).powi(2)).sum::<f64>().sqrt(), SPRING);
}

#[test]
fn springs_push_with_their_compression() {
    let model = parse(EVERY_FORCE);
    near(tension(&model, "free_length", 0.6, 0.0), -70e3 * 0.005);
    near(tension(&model, "free_length", 0.605, 0.5), 6e3 * 0.5);
    // At the design position as if it were 505 mm long, wherever the points are.
    near(tension(&model, "installed_length", SPRING, 0.0), -7000.0);
    near(tension(&model, "installed_length", SPRING + 0.01, 0.0), -6300.0);
    near(tension(&model, "preload", SPRING, 0.0), -6500.0);
    near(tension(&model, "preload", SPRING - 0.01, 0.0), -7200.0);
    near(tension(&model, "actuator", SPRING - 0.3, 9.0), 500.0);
}

#[test]
fn tables_of_springs_and_dampers_keep_the_signs_of_the_file() {
    let model = parse(EVERY_FORCE);
    near(tension(&model, "table_with_preload", SPRING, 0.0), -6500.0);
    // Somewhere between 50 mm and 100 mm of compression; 4 kN are at 50 mm.
    let ForceKind::Line { reference: Reference::Design(compression), law, .. } =
        &force(&model, "table_with_preload").kind
    else {
        panic!()
    };
    assert!((0.05..0.1).contains(compression), "{compression}");
    near(law.at(-0.05, 0.0).force, -4000.0);
    near(law.at(0.01, 0.0).force, 500.0);
    near(law.at(-0.05, 1.0).force, -4000.0 + 1000.0);
    near(law.at(-0.05, -1.0).force, -4000.0 - 2000.0);
    near(tension(&model, "damper", 0.3, 1.0), 1000.0);
    near(tension(&model, "damper", 0.3, -1.0), -2000.0);
}

#[test]
fn stops_act_beyond_their_clearance_only() {
    let model = parse(EVERY_FORCE);
    near(tension(&model, "bump_stop", SPRING - 0.002, 0.0), 0.0);
    near(tension(&model, "bump_stop", SPRING - 0.007, 0.0), -200.0);
    near(tension(&model, "bump_stop", SPRING - 0.007, -0.1), -200.0 - 20.0);
    near(tension(&model, "bump_stop", SPRING + 0.05, 0.0), 0.0);
    // A negative clearance: it pulls at the design position already.
    near(tension(&model, "rebound_stop", SPRING, 0.0), 300.0);
    near(tension(&model, "rebound_stop", SPRING - 0.001, 0.0), 0.0);
}

#[test]
fn torsion_springs_return_to_their_free_angle() {
    let model = parse(EVERY_FORCE);
    let law = |name| match &force(&model, name).kind {
        ForceKind::Torsion { law, .. } => law.clone(),
        other => panic!("{other:?}"),
    };
    let (bar, table) = (law("torsion_bar"), law("torsion_table"));
    // 1 kN·mm/deg. At the design position it turns body j with +10 N·m towards +10°.
    near(bar.at(0.0, 0.0).force, -10.0);
    near(bar.at(10_f64.to_radians(), 0.0).force, 0.0);
    near(bar.at(10_f64.to_radians(), 2_f64.to_radians()).force, 0.2);
    near(table.at(0.0, 0.0).force, -25.0);
}

#[test]
fn bushings_have_six_laws() {
    let model = parse(EVERY_FORCE);
    let ForceKind::Bushing(bushing) = &force(&model, "bush").kind else { panic!() };
    let at = |law: &Law, value, rate| law.at(value, rate).force;
    near(at(&bushing.translation[0], 0.001, 0.0), 1000.0 - 100.0);
    near(at(&bushing.translation[1], 0.002, 0.0), 5000.0 - 200.0);
    near(at(&bushing.translation[1], -0.002, 0.5), -3000.0 - 200.0 + 1000.0);
    near(at(&bushing.translation[2], 0.0, 1.0), -300.0 + 3000.0);
    near(at(&bushing.rotation[0], 1_f64.to_radians(), 0.0), 40.0 - 1.0);
    near(at(&bushing.rotation[1], 0.0, 1_f64.to_radians()), 0.5 - 2.0);
    near(at(&bushing.rotation[2], 3_f64.to_radians(), 0.0), 40.0 - 3.0);
    assert_eq!(bushing.moment, MomentLaw::Torque);
    assert_eq!(bushing.measure, RotationMeasure::Angles);
    let arm = &model.bushings()[0];
    let ForceKind::Bushing(bushing) = &arm.force.kind else { panic!() };
    assert_eq!(bushing.moment, MomentLaw::Energy);
    assert_eq!(bushing.measure, RotationMeasure::RotationVector);
    assert_eq!(model.points()[bushing.at.index()].name, "uca_front");
    assert_eq!(model.bushed_joints(), ["uca_pivot"]);
}

#[test]
fn loads_masses_and_tyre_are_in_si() {
    let model = parse(EVERY_FORCE);
    let ForceKind::PointForce { at, frame, direction, size } = force(&model, "load_in_space").kind
    else {
        panic!()
    };
    assert_eq!((frame, direction), (LoadFrame::Space, [300.0, -400.0, 1200.0]));
    near(size, 1300.0);
    assert_eq!(model.points()[at.index()].name, "patch");
    let ForceKind::Moment { frame, direction, size } = force(&model, "moment_in_body").kind else {
        panic!()
    };
    assert_eq!((frame, direction), (LoadFrame::Body, [10.0, -20.0, 30.0]));
    near(size, 1400_f64.sqrt());
    let mass = model.mass("upright").unwrap();
    assert_eq!(mass.mass, 38.0);
    assert_eq!(mass.center, [-0.006, 0.775, -0.118]);
    assert_eq!(mass.inertia, [0.85, 1.3, 0.95, 0.01, -0.02, 0.03]);
    assert_eq!(
        (model.mass("lca"), model.gravity(), model.sprung_mass()),
        (None, 9.81, Some(380.0))
    );
    let tyre = model.tyre().unwrap();
    assert_eq!(
        (tyre.contact, tyre.free_radius, tyre.ground),
        (TyreContact::ContactPatch, 0.3266, -0.428)
    );
    assert_eq!(tyre.law.acts, Acts::Below);
    near(tyre.law.at(-0.01, 0.0).force, -2000.0);
    near(tyre.law.at(-0.01, -0.5).force, -2000.0 - 50.0);
    near(tyre.law.at(0.01, 0.0).force, 0.0);
}

#[test]
fn units_have_exact_ratios_and_symbols() {
    let us = Units {
        length: LengthUnit::Inch,
        angle: AngleUnit::Degree,
        force: ForceUnit::PoundForce,
        mass: MassUnit::Pound,
    };
    let mm = Units {
        length: LengthUnit::Millimetre,
        angle: AngleUnit::Degree,
        force: ForceUnit::Newton,
        mass: MassUnit::Kilogram,
    };
    for (quantity, in_us, us_symbol, in_mm, mm_symbol) in [
        (Quantity::Force, 4.448_221_615_260_5, "lbf", 1.0, "N"),
        (Quantity::Mass, 0.453_592_37, "lb", 1.0, "kg"),
        (Quantity::Stiffness, 175.126_835_246_476_36, "lbf/in", 1000.0, "N/mm"),
        (Quantity::Damping, 175.126_835_246_476_36, "lbf·s/in", 1000.0, "N·s/mm"),
        (Quantity::Torque, 0.112_984_829_027_616_7, "lbf·in", 1e-3, "N·mm"),
        (
            Quantity::RotationalStiffness,
            0.112_984_829_027_616_7_f64.to_degrees(),
            "lbf·in/deg",
            0.18 / std::f64::consts::PI,
            "N·mm/deg",
        ),
        (
            Quantity::RotationalDamping,
            0.112_984_829_027_616_7_f64.to_degrees(),
            "lbf·in·s/deg",
            0.18 / std::f64::consts::PI,
            "N·mm·s/deg",
        ),
        (Quantity::Inertia, 2.926_396_534_292e-4, "lb·in²", 1e-6, "kg·mm²"),
        (Quantity::Velocity, 0.0254, "in/s", 1e-3, "mm/s"),
        (Quantity::AngularVelocity, 1_f64.to_radians(), "deg/s", 1_f64.to_radians(), "deg/s"),
    ] {
        for (units, factor, symbol) in [(us, in_us, us_symbol), (mm, in_mm, mm_symbol)] {
            assert_eq!(quantity.symbol(units), symbol);
            let si = quantity.to_si(units, 3.0);
            assert!((si / (3.0 * factor) - 1.0).abs() < 1e-15, "{symbol}: {si}");
            assert!((quantity.show(units, si) - 3.0).abs() < 2e-15, "{symbol}");
        }
    }
    // What can be exact is exact.
    assert_eq!(Quantity::Stiffness.to_si(mm, 70.0), 70_000.0);
    assert_eq!(Quantity::Inertia.to_si(mm, 30_000.0), 0.03);
}

/// The rod of the sedan: m l²/12 across, given along, turned to its direction.
#[test]
fn the_tie_rod_has_the_inertia_of_a_rod() {
    let model = load("quarter-car");
    let mass = model.mass("tierod").unwrap();
    let (inner, outer) =
        (model.point("tierod_inner").unwrap(), model.point("tierod_outer").unwrap());
    let d: [f64; 3] = std::array::from_fn(|k| outer[k] - inner[k]);
    let length = d.iter().map(|x| x * x).sum::<f64>();
    let (across, along) = (0.8 * length / 12.0, 0.0002);
    let entry = |a: usize, b: usize| {
        let unit = if a == b { across } else { 0.0 };
        unit + (along - across) * d[a] * d[b] / length
    };
    for (k, (a, b)) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
        assert!((mass.inertia[k] - entry(a, b)).abs() < 1e-15, "{k}");
        let center = 0.5 * (inner[a] + outer[a]);
        near(mass.center[a], center);
    }
}
