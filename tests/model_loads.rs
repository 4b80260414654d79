//! Forces, masses, bushings and tyres of models in SI units, in all axes and on both sides.
#![allow(missing_docs)]

#[path = "common/elements.rs"]
mod elements;

use elements::{Answer, answer};
use hardpoint::mechanism::{
    Acts, Contact, Curve, Direction, Force, ForceKind, Law, LoadFrame, Mechanism, MomentLaw,
    Reference, RotationMeasure,
};
use hardpoint::model::{
    AngleUnit, Axes, Chassis, Drive, ForceUnit, LengthUnit, MassUnit, Model, Quantity, Setup,
    TyreContact, Units, WheelSupport,
};
use hardpoint::relation::Coordinates;
use hardpoint::solve::System;

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

/// The suspension of a file in ISO axes written in other axes, with every vector turned.
fn in_axes(text: &str, axes: Axes) -> Model {
    let turn = |line: &str| -> String {
        let Some((key, value)) = line.split_once(" = [") else {
            return match line.split_once("ground = ") {
                Some((before, z)) => {
                    let z = axes.from_iso([0.0, 0.0, z.parse().unwrap()])[2];
                    format!("{before}ground = {z}")
                }
                None => line.to_owned(),
            };
        };
        let numbers: Result<Vec<f64>, _> =
            value.trim_end_matches(']').split(", ").map(str::parse).collect();
        let principal = ["stiffness", "damping", "preload"].iter().any(|word| key.ends_with(word));
        match numbers.as_deref() {
            Ok(&[x, y, z]) if !principal => format!("{key} = {:?}", axes.from_iso([x, y, z])),
            Ok(&[xx, yy, zz, xy, xz, yz]) => {
                let [x, y, z] = axes.signs();
                format!("{key} = {:?}", [xx, yy, zz, x * y * xy, x * z * xz, y * z * yz])
            }
            _ => line.to_owned(),
        }
    };
    let text: Vec<String> = text.lines().map(turn).collect();
    parse(&text.join("\n").replace("\"iso8855\"", &format!("\"{}\"", axes.name())))
}

/// A state and its rate for every moving body, away from the design position.
fn random_motion(mechanism: &Mechanism) -> [Vec<Coordinates<f64>>; 2] {
    let mut random = fastrand::Rng::with_seed(5);
    let mut small = || 0.1 * (random.f64() - 0.5);
    let (mut state, mut velocity) = (vec![], vec![]);
    for (index, body) in mechanism.bodies().iter().enumerate() {
        let [x, y, z] = body.origin;
        let moving = |by: f64| if index == 0 { 0.0 } else { by };
        let e: [f64; 3] = std::array::from_fn(|_| moving(small()));
        let e0 = (1.0 - e.iter().map(|e| e * e).sum::<f64>()).sqrt();
        state.push([
            x + moving(small()),
            y + moving(small()),
            z + moving(small()),
            e0,
            e[0],
            e[1],
            e[2],
        ]);
        let v: [f64; 7] = std::array::from_fn(|_| moving(10.0 * small()));
        // Rates of Euler parameters lie across them.
        let along = e0 * v[3] + e[0] * v[4] + e[1] * v[5] + e[2] * v[6];
        let p = [e0, e[0], e[1], e[2]];
        velocity.push(std::array::from_fn(|k| if k < 3 { v[k] } else { v[k] - along * p[k - 3] }));
    }
    [state, velocity]
}

fn full(drive: Drive) -> Setup {
    Setup { drive, support: WheelSupport::Free, ..Setup::default() }
}

fn close(a: &Answer, b: &Answer, what: &str) {
    assert_eq!(a.force.len(), b.force.len());
    for (body, (a, b)) in a.force.iter().zip(&b.force).enumerate() {
        for k in 0..7 {
            let error = (a[k] - b[k]).abs();
            assert!(error <= 1e-9 * a[k].abs().max(1.0), "{what}, body {body}, {k}: {a:?} {b:?}");
        }
    }
}

#[test]
fn all_axes_mean_the_same_forces() {
    let reference =
        in_axes(EVERY_FORCE, Axes::Iso8855).suspension(&full(Drive::WheelCenter)).unwrap();
    let [state, velocity] = random_motion(&reference.mechanism);
    let expected = answer(&reference.mechanism, &state, &velocity);
    assert!(expected.force.iter().skip(1).filter(|f| f.iter().any(|x| x.abs() > 1.0)).count() > 2);
    for axes in [Axes::Adams, Axes::Sae] {
        let turned = in_axes(EVERY_FORCE, axes).suspension(&full(Drive::WheelCenter)).unwrap();
        close(&answer(&turned.mechanism, &state, &velocity), &expected, axes.name());
        for (a, b) in turned.mechanism.bodies().iter().zip(reference.mechanism.bodies()) {
            assert_eq!(a.mass.is_some(), b.mass.is_some());
            if let (Some(a), Some(b)) = (a.mass, b.mass) {
                assert_eq!((a.center, a.inertia), (b.center, b.inertia));
            }
        }
    }
}

/// A bushing without axes of its own has those of the file.
#[test]
fn default_axes_of_bushings_are_those_of_the_file() {
    for axes in [Axes::Iso8855, Axes::Adams, Axes::Sae] {
        let text = EVERY_FORCE.replace("x_axis = [\"lca_front\", \"lca_rear\"]\n", "");
        let model = in_axes(&text, axes);
        let ForceKind::Bushing(bushing) = &force(&model, "bush").kind else { panic!() };
        assert_eq!(bushing.axes.x, Direction::Fixed(axes.to_iso([1.0, 0.0, 0.0])));
        let torsion = text.replace("axis = [\"lca_rear\", \"lca_front\"]", "axis = \"x\"");
        let model = in_axes(&torsion, axes);
        let ForceKind::Torsion { axis, .. } = force(&model, "torsion_bar").kind else { panic!() };
        assert_eq!(axis, Direction::Fixed(axes.to_iso([1.0, 0.0, 0.0])));
    }
}

/// The coordinates of the mirror image: y changes its sign, and rotations about x and z theirs.
fn mirrored(q: &[f64; 7]) -> [f64; 7] {
    [q[0], -q[1], q[2], q[3], -q[4], q[5], -q[6]]
}

#[test]
fn the_mirrored_model_has_the_mirrored_forces() {
    let model = parse(EVERY_FORCE);
    for chassis in [Chassis::Fixed, Chassis::Slide] {
        let setup = Setup { chassis, ..full(Drive::ContactPatch) };
        let left = model.suspension(&setup).unwrap().mechanism;
        let right = model.mirrored().suspension(&setup).unwrap().mechanism;
        let [state, velocity] = random_motion(&left);
        let expected = answer(&left, &state, &velocity);
        let image = |list: &[Coordinates<f64>]| list.iter().map(mirrored).collect::<Vec<_>>();
        let found = answer(&right, &image(&state), &image(&velocity));
        let back = Answer { force: image(&found.force), values: found.values };
        close(&back, &expected, "mirror image");
    }
    let (mass, image) = (model.mass("upright").unwrap(), model.mirrored().mass("upright").unwrap());
    assert_eq!(image.center, [mass.center[0], -mass.center[1], mass.center[2]]);
    assert_eq!(image.inertia, [0.85, 1.3, 0.95, -0.01, -0.02, -0.03]);
    let twice = model.mirrored().mirrored();
    assert_eq!(twice.forces(), model.forces());
    assert_eq!(twice.bushings(), model.bushings());
}

#[test]
fn weights_pull_down() {
    let suspension = load("quarter-car").suspension(&Setup::default()).unwrap();
    let mechanism = &suspension.mechanism;
    assert_eq!(mechanism.gravity(), [0.0, 0.0, -9.81]);
    let bodies = mechanism.bodies().iter();
    let state: Vec<_> = bodies
        .map(|body| [body.origin[0], body.origin[1], body.origin[2], 1.0, 0.0, 0.0, 0.0])
        .collect();
    let forces = answer(mechanism, &state, &vec![[0.0; 7]; state.len()]).force;
    let upright = forces[mechanism.body_named("upright").unwrap().index()];
    near(upright[2], -38.0 * 9.81);
    // The spring of 605 mm pushes the arm down.
    let lca = forces[mechanism.body_named("lca").unwrap().index()];
    assert!(lca[2] < -6000.0 && lca[2] > -7000.0, "{lca:?}");
}

#[test]
fn setups_choose_what_stands_where() {
    let model = load("quarter-car");
    assert!(model.has_forces() && model.has_tyre() && model.is_quarter_car());
    let held = model.suspension(&Setup::default()).unwrap();
    assert!(held.tyre.is_none());
    assert_eq!(held.mechanism.bodies()[held.chassis.index()].name, "chassis");
    assert_eq!(held.chassis.index(), 0);

    let setup = Setup { support: WheelSupport::Free, chassis: Chassis::Slide, ..Setup::default() };
    let standing = model.suspension(&setup).unwrap();
    let m = &standing.mechanism;
    let names: Vec<&str> = m.bodies().iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["road", "chassis", "lca", "uca", "upright", "tierod", "rack"]);
    assert_eq!(m.bodies()[1].mass.unwrap().mass, 380.0);
    assert_eq!(m.bodies()[standing.wheel.body.index()].name, "upright");
    assert_eq!(standing.steer_axis.unwrap().upper.1, standing.wheel.body);
    let tyre = &m.forces()[standing.tyre.unwrap().index()];
    assert_eq!((tyre.i.index(), tyre.j), (0, standing.wheel.body));
    let ForceKind::Tyre { contact, free_radius, ground, law } = &tyre.kind else { panic!() };
    assert!(matches!(contact, Contact::Center(_)));
    assert_eq!((*free_radius, *ground, law.acts), (0.3266, -0.428, Acts::Always));
    assert_eq!(law.elastic, Curve::Linear(220e3));
    let spring = &m.forces()[m.force_named("spring").unwrap().index()];
    assert_eq!((spring.i.index(), spring.j.index()), (1, 2));
    // Road, slide and driven wheel leave the chassis free to move up and down.
    let system = System::new(standing.mechanism.clone()).unwrap();
    let freedom = system.freedom();
    assert_eq!((freedom.redundant.len(), freedom.free_motions.len()), (0, 1), "{freedom}");

    let plain = load("double-wishbone");
    assert!(!plain.has_forces() && !plain.has_tyre() && !plain.is_quarter_car());
    let tyre = Setup { support: WheelSupport::Free, ..Setup::default() };
    assert_eq!(plain.suspension(&tyre).unwrap().tyre, None);
    let slide = Setup { chassis: Chassis::Slide, ..Setup::default() };
    let error = plain.suspension(&slide).unwrap_err();
    assert!(error.to_string().contains("quarter_car"), "{error}");
}

#[test]
fn bushings_stand_for_joints_unless_kinematic() {
    let model = load("bushed-double-wishbone");
    assert_eq!(model.bushed_joints(), ["lca_pivot"]);
    let joints = |kinematic| {
        let suspension = model.suspension(&Setup { kinematic, ..Setup::default() }).unwrap();
        let m = suspension.mechanism;
        let named = m.joints().iter().any(|joint| joint.name == "lca_pivot");
        let bushings =
            m.forces().iter().filter(|f| matches!(f.kind, ForceKind::Bushing(_))).count();
        let freedom = System::new(m.clone()).unwrap().freedom().free_motions.len();
        (named, m.joints().len(), m.forces().len(), bushings, freedom)
    };
    assert_eq!(joints(true), (true, 7, 1, 0, 0));
    // Five motions that the hinge held are left to the bushings.
    assert_eq!(joints(false), (false, 6, 3, 2, 5));
    let ForceKind::Bushing(front) = &model.bushings()[0].force.kind else { panic!() };
    near(front.rotation[0].at(1.0, 0.0).force, 90.0);
    near(front.rotation[2].at(1.0, 0.0).force, 350.0);
    assert_eq!(front.translation[1], Law::spring(9e6));
    assert_eq!(load("compliant-corner").bushed_joints(), ["lca_pivot", "uca_pivot"]);
}

/// Forces refer to points, so they follow them.
#[test]
fn forces_follow_points_that_move() {
    let mut model = load("quarter-car");
    model.set_point("spring_upper", [-0.04, 0.52, 0.33]);
    let suspension = model.suspension(&Setup::default()).unwrap();
    let values = |m: &Mechanism| {
        let state: Vec<_> = m
            .bodies()
            .iter()
            .map(|body| [body.origin[0], body.origin[1], body.origin[2], 1.0, 0.0, 0.0, 0.0])
            .collect();
        answer(m, &state, &vec![[0.0; 7]; state.len()]).values
    };
    let length = (0.04_f64.powi(2) + 0.1_f64.powi(2) + 0.6_f64.powi(2)).sqrt();
    near(values(&suspension.mechanism)[0], length - 0.605);
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
