//! Static equilibria with springs, tyres and weights against independent solutions.

mod common;

use common::sedan::{placed_sedan, sedan};
use hardpoint::mechanism::{
    Acts, BodyId, Contact, Curve, Direction, DriverKind, ForceKind, JointKind, Law, LoadFrame,
    MassProperties, Mechanism, PointId, Reference, Spline,
};
use hardpoint::solve::equilibrium::Equilibrium;
use hardpoint::solve::{StaticFailure, StaticReport, System};

/// Sedan on a fixed chassis: independent minimal-coordinate solution on 50-digit kinematics.
#[test]
fn the_sedan_stands_on_its_tyre() {
    let car = sedan(true);
    let wheel = (car.upright, car.wheel_center);
    let system = System::new(car.mechanism).unwrap();
    let mut equilibrium = Equilibrium::released(&system, &[car.travel]);
    let report = equilibrium.find().unwrap();
    assert_eq!((report.load_steps, report.relaxation_steps), (1, 0), "{report:?}");
    assert!(report.iterations <= 6 && report.stiffness > 0.0, "{report:?}");
    let at = equilibrium.loaded().point(wheel.0, wheel.1);
    let expected = [-9.523906459998993e-06, 0.7980005181811466, -0.11879230494277739];
    for k in 0..3 {
        assert!((at[k] - expected[k]).abs() < 1e-12, "{at:?}");
    }
    let forces = equilibrium.elements().responses();
    assert!((forces[0].force / -6587.479673434271 - 1.0).abs() < 1e-10);
    assert!((forces[1].force / -3826.307087411026 - 1.0).abs() < 1e-10);
}

/// The equilibrium moves with the car over level ground and turns with it.
#[test]
fn an_equilibrium_does_not_depend_on_place_and_heading() {
    let (sin, cos) = 0.7_f64.sin_cos();
    let turn = |v: [f64; 3]| [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1], v[2]];
    let place = |p: [f64; 3]| {
        let [x, y, z] = turn(p);
        [x + 12.5, y - 3.25, z]
    };
    let results: Vec<_> = [sedan(true), placed_sedan(true, place, turn)]
        .into_iter()
        .map(|car| {
            let wheel = (car.upright, car.wheel_center);
            let system = System::new(car.mechanism).unwrap();
            let mut equilibrium = Equilibrium::released(&system, &[car.travel]);
            equilibrium.find().unwrap();
            let forces = equilibrium.elements().responses().to_vec();
            let reactions: Vec<[f64; 3]> =
                equilibrium.reactions().iter().map(|r| r.on_j.force).collect();
            (equilibrium.loaded().point(wheel.0, wheel.1), forces, reactions)
        })
        .collect();
    let (here, there) = (&results[0], &results[1]);
    assert!(common::difference(&place(here.0), &there.0) < 1e-12);
    for (a, b) in here.1.iter().zip(&there.1) {
        assert!((a.force - b.force).abs() < 1e-8);
    }
    for (a, b) in here.2.iter().zip(&there.2) {
        assert!(common::difference(&turn(*a), b) < 1e-7);
    }
}

/// 27 travel points: wheel force, joint forces and wheel rate to 1e-8 relative.
#[test]
fn the_sedan_is_held_at_each_travel() {
    let text = include_str!("reference/sedan-quasi-static.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let rows: Vec<std::collections::HashMap<String, f64>> =
        reader.deserialize().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 27);
    let car = sedan(false);
    let mut system = System::new(car.mechanism.clone()).unwrap();
    let joint =
        |name: &str| car.mechanism.joints().iter().position(|joint| joint.name == name).unwrap();
    let joints =
        [("LBJ", joint("lca_outer")), ("UBJ", joint("uca_outer")), ("TIE", joint("tierod_outer"))];
    // Largest absolute value of each column, which small entries are compared with.
    let largest = |column: &str| rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
    let close = |found: f64, row: &std::collections::HashMap<String, f64>, column: &str| {
        let expected = row[column];
        let size = expected.abs().max(1e-3 * largest(column));
        let at = row["travel_mm"];
        assert!((found - expected).abs() <= 1e-8 * size, "{column} at {at}: {found}, {expected}");
    };
    for row in &rows {
        system.move_to(&[(car.travel, row["travel_mm"] / 1000.0)]).unwrap();
        let mut equilibrium = Equilibrium::new(&system);
        equilibrium.find().unwrap();
        close(-equilibrium.driver_multiplier(car.travel), row, "Fz_wheel");
        close(equilibrium.elements().responses()[0].force, row, "spring_force_tension");
        close(equilibrium.elements().values()[0] + 0.605, row, "spring_length");
        let reactions = equilibrium.reactions();
        for (name, joint) in joints {
            for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
                let force = reactions[joint].on_j.force[axis];
                close(force, row, &format!("{name}_on_KN_{letter}"));
            }
        }
        let equation = equilibrium.equation_of(car.travel);
        let rate = -equilibrium.driver_tangent(car.travel).unwrap().multiplier(equation);
        close(rate, row, "wheel_rate_N_per_m");
    }
}

/// A body of 2 kg, its centre 0.5 m from a hinge about x, turned from hanging by an angle.
fn pendulum(angle: f64) -> Mechanism {
    let mut m = Mechanism::new("ground");
    let pin = m.add_point("pin", [0.0; 3]).unwrap();
    let center = [0.0, 0.5 * angle.sin(), -0.5 * angle.cos()];
    m.add_point("bob", center).unwrap();
    let rod = m.add_body("rod", center).unwrap();
    let axis = Direction::Fixed([1.0, 0.0, 0.0]);
    m.add_joint("hinge", BodyId::GROUND, rod, JointKind::Revolute { at: pin, axis }).unwrap();
    m.set_mass(rod, MassProperties { mass: 2.0, center, inertia: [0.0; 6] }).unwrap();
    m.set_gravity([0.0, 0.0, -9.81]).unwrap();
    m
}

fn find(m: Mechanism) -> (Result<StaticReport, StaticFailure>, Equilibrium) {
    let mut equilibrium = Equilibrium::new(&System::new(m).unwrap());
    (equilibrium.find(), equilibrium)
}

#[test]
fn a_pendulum_hangs_down_from_wherever_it_starts() {
    for angle in [0.0, 0.3, 1.2, std::f64::consts::FRAC_PI_2, 2.0, 3.0, -2.5] {
        let m = pendulum(angle);
        let (found, equilibrium) = find(m);
        let report = found.unwrap_or_else(|failure| panic!("{angle}: {failure}"));
        let q = equilibrium.state()[1];
        assert!(q[1].abs() < 1e-12 && (q[2] + 0.5).abs() < 1e-12, "{angle}: {q:?} {report:?}");
        let force = equilibrium.reactions()[0].on_j.force;
        assert!((force[2] - 19.62).abs() < 1e-9 && force[1].abs() < 1e-9, "{force:?}");
    }
}

#[test]
fn a_pendulum_on_its_head_is_unstable() {
    let (found, _) = find(pendulum(std::f64::consts::PI));
    let failure = found.unwrap_err();
    assert!(matches!(failure, StaticFailure::Unstable { .. }), "{failure:?}");
    assert!(failure.to_string().contains("rod turns about"), "{failure}");
}

/// A carriage of 3 kg on a vertical rail between two springs' worth of stiffness.
fn carriage(law: Option<Law>) -> (Mechanism, PointId) {
    let mut m = Mechanism::new("ground");
    let low = m.add_point("low", [0.0; 3]).unwrap();
    let high = m.add_point("high", [0.0, 0.0, 0.4]).unwrap();
    let body = m.add_body("carriage", [0.0, 0.0, 0.4]).unwrap();
    let axis = Direction::Fixed([0.0, 0.0, 1.0]);
    m.add_joint("rail", BodyId::GROUND, body, JointKind::Translational { at: high, axis }).unwrap();
    let center = [0.0, 0.0, 0.4];
    m.set_mass(body, MassProperties { mass: 3.0, center, inertia: [0.0; 6] }).unwrap();
    m.set_gravity([0.0, 0.0, -9.81]).unwrap();
    if let Some(law) = law {
        let reference = Reference::Length(0.4);
        let kind = ForceKind::Line { on_i: low, on_j: high, reference, law };
        m.add_force("spring", BodyId::GROUND, body, kind).unwrap();
    }
    (m, high)
}

#[test]
fn what_makes_no_equilibrium_is_named() {
    let (found, equilibrium) = find(carriage(Some(Law::spring(1000.0))).0);
    let report = found.unwrap();
    assert!((equilibrium.state()[1][2] - (0.4 - 0.02943)).abs() < 1e-12);
    assert!(report.stiffness > 0.0);

    let no_spring = [None, Some(Law::spring(0.0)), Some(Law::constant(-3.0))];
    for law in no_spring {
        let failure = find(carriage(law.clone()).0).0.unwrap_err();
        assert!(matches!(failure, StaticFailure::FreeMotion { .. }), "{law:?}: {failure:?}");
        assert!(failure.to_string().contains("carriage moves along z"), "{failure}");
    }
    let failure = find(carriage(Some(Law::spring(-1000.0))).0).0.unwrap_err();
    assert!(failure.to_string().contains("carriage moves along z"), "{failure}");
    assert!(!matches!(failure, StaticFailure::FreeMotion { .. }), "{failure:?}");

    // A spring without length has no direction.
    let (mut m, high) = carriage(None);
    let kind = ForceKind::Line {
        on_i: high,
        on_j: high,
        reference: Reference::Length(0.1),
        law: Law::spring(10.0),
    };
    m.add_force("spring", BodyId::GROUND, BodyId::GROUND, kind.clone()).unwrap_err();
    let body = m.body_named("carriage").unwrap();
    m.add_force("spring", BodyId::GROUND, body, kind).unwrap();
    let failure = find(m).0.unwrap_err();
    assert!(matches!(&failure, StaticFailure::NotFinite { force, .. } if force == "spring"));
}

#[test]
fn a_tyre_in_the_air_is_named() {
    for (ground, lands) in [(-0.05, true), (0.05, true), (-5.0, false)] {
        let (mut m, high) = carriage(Some(Law::spring(100.0)));
        let body = m.body_named("carriage").unwrap();
        let kind = ForceKind::Tyre {
            contact: Contact::Center(high),
            free_radius: 0.3,
            ground,
            law: Law { acts: Acts::Below, ..Law::spring(50_000.0) },
        };
        m.add_force("tyre", BodyId::GROUND, body, kind).unwrap();
        let (found, equilibrium) = find(m);
        if lands {
            found.unwrap();
            let responses = equilibrium.elements().responses();
            let sum = responses[0].force + responses[1].force;
            assert!((sum + 29.43).abs() < 1e-9, "{sum}");
        } else {
            let failure = found.unwrap_err();
            assert!(matches!(failure, StaticFailure::Airborne { .. }), "{failure:?}");
            assert!(failure.to_string().contains("the tyre `tyre` is in the air"), "{failure}");
        }
    }
}

/// Two inclined springs under a load that they cannot hold before they snap through: what is
/// found is the equilibrium beyond, which is stable.
#[test]
fn a_snap_through_ends_in_a_stable_equilibrium() {
    let build = |load: f64| {
        let (mut m, high) = carriage(None);
        m.set_gravity([0.0; 3]).unwrap();
        let body = m.body_named("carriage").unwrap();
        for (name, x) in [("left", -1.0), ("right", 1.0)] {
            let foot = m.add_point(name, [x, 0.0, 0.0]).unwrap();
            let kind = ForceKind::Line {
                on_i: foot,
                on_j: high,
                reference: Reference::Design(0.0),
                law: Law::spring(1000.0),
            };
            m.add_force(name, BodyId::GROUND, body, kind).unwrap();
        }
        let load = ForceKind::PointForce {
            at: high,
            frame: LoadFrame::Space,
            direction: [0.0, 0.0, -1.0],
            size: load,
        };
        m.add_force("load", BodyId::GROUND, body, load).unwrap();
        m
    };
    let force = |z: f64| {
        let (length, free) = ((1.0 + z * z).sqrt(), 1.16_f64.sqrt());
        -2.0 * 1000.0 * (length - free) * z / length
    };
    // The largest load that the springs hold above the middle is about 25 N.
    for (load, above) in [(15.0, true), (60.0, false)] {
        let (found, equilibrium) = find(build(load));
        let report = found.unwrap();
        let z = equilibrium.state()[1][2];
        assert_eq!(z > 0.0, above, "{z} {report:?}");
        assert!((force(z) - load).abs() < 1e-8, "{z} {} {report:?}", force(z));
        assert!(report.stiffness > 0.0);
    }
}

/// A driver that is released lets go; held, it carries what the spring does not.
#[test]
fn drivers_hold_or_let_go() {
    let (mut m, high) = carriage(Some(Law::spring(1000.0)));
    let body = m.body_named("carriage").unwrap();
    let lift = m.add_driver("lift", BodyId::GROUND, body, DriverKind::Height { at: high }).unwrap();
    let system = System::new(m).unwrap();
    let mut held = Equilibrium::new(&system);
    held.find().unwrap();
    assert!((held.driver_multiplier(lift) + 29.43).abs() < 1e-9);
    held.move_to(&[(lift, 0.05)]).unwrap();
    assert!((held.driver_multiplier(lift) + 29.43 + 50.0).abs() < 1e-9);
    let equation = held.equation_of(lift);
    let rate = held.driver_tangent(lift).unwrap().multiplier(equation);
    assert!((rate + 1000.0).abs() < 1e-9, "{rate}");
    let mut free = Equilibrium::released(&system, &[lift]);
    free.find().unwrap();
    assert!((free.state()[1][2] - 0.37057).abs() < 1e-12);
}

/// A spring wound up by several turns: spring and preload cancel where it comes to rest, and what
/// rounding leaves of them is no load.
#[test]
fn a_preload_of_several_turns_unwinds() {
    for preload in [100.0, 180.0, 250.0, 500.0] {
        let mut m = Mechanism::new("ground");
        let pivot = m.add_point("pivot", [0.0; 3]).unwrap();
        let rod = m.add_body("rod", [0.0; 3]).unwrap();
        let axis = Direction::Fixed([0.0, 1.0, 0.0]);
        m.add_joint("hinge", BodyId::GROUND, rod, JointKind::Revolute { at: pivot, axis }).unwrap();
        let law = Law { preload: -preload, ..Law::spring(0.5_f64.to_degrees()) };
        m.add_force("spring", BodyId::GROUND, rod, ForceKind::Torsion { axis, law }).unwrap();
        let (found, equilibrium) = find(m);
        found.unwrap();
        let angle = equilibrium.elements().values()[0].to_degrees();
        assert!((angle - 2.0 * preload).abs() < 1e-9, "{preload}: {angle}");
    }
}

/// A stiffness that is nothing but rounding is none.
#[test]
fn a_constant_force_holds_nothing() {
    for force in [0.1, 0.7, 3.0, 5.0, 7.3, 11.1, 29.0] {
        let table = vec![[-0.1, force], [0.2, force], [0.7, force]];
        let elastic = Curve::Table(Spline::new("spring", table).unwrap());
        let (m, _) = carriage(Some(Law { elastic, ..Law::default() }));
        let failure = find(m).0.unwrap_err();
        assert!(matches!(failure, StaticFailure::FreeMotion { .. }), "{force}: {failure}");
    }
}

/// A door on two hinges: what they hold twice is shared in a way that rigid bodies do not say.
#[test]
fn shared_reactions_are_marked_at_both_joints() {
    let mut m = Mechanism::new("ground");
    let door = m.add_body("door", [0.0; 3]).unwrap();
    let axis = Direction::Fixed([0.0, 0.0, 1.0]);
    for (name, height) in [("low", 0.0), ("high", 1.0)] {
        let at = m.add_point(name, [0.0, 0.0, height]).unwrap();
        m.add_joint(name, BodyId::GROUND, door, JointKind::Revolute { at, axis }).unwrap();
    }
    let edge = m.add_point("edge", [0.8, 0.0, 0.5]).unwrap();
    let leaf = m.add_body("leaf", [0.8, 0.0, 0.5]).unwrap();
    m.add_joint("alone", door, leaf, JointKind::Fixed { at: edge }).unwrap();
    let law = Law::spring(10.0);
    m.add_force("spring", BodyId::GROUND, door, ForceKind::Torsion { axis, law }).unwrap();
    let center = [0.8, 0.0, 0.5];
    m.set_mass(leaf, MassProperties { mass: 3.0, center, inertia: [0.0; 6] }).unwrap();
    m.set_gravity([0.0, 0.0, -9.81]).unwrap();
    let (found, equilibrium) = find(m);
    found.unwrap();
    let unique: Vec<bool> = equilibrium.reactions().iter().map(|r| r.unique).collect();
    assert_eq!(unique, [false, false, true]);
    let weight: f64 = equilibrium.reactions()[..2].iter().map(|r| r.on_j.force[2]).sum();
    assert!((weight - 29.43).abs() < 1e-12, "{weight}");
}
