//! Static equilibrium: coordinates and multipliers together.

mod common;

use common::{TieRod, double_wishbone};
use hardpoint::mechanism::{BodyId, Direction, DriverKind, JointKind, Mechanism};
use hardpoint::relation::BODY_COORDINATES;
use hardpoint::solve::equilibrium::Equilibrium;
use hardpoint::solve::{System, Tolerances};

#[test]
fn a_driver_holds_the_moment_of_the_load() {
    let mut m = Mechanism::new("ground");
    let pin = m.add_point("pin", [0.0; 3]).unwrap();
    // The frame of the rod is at its tip, so a force there is a load on r alone.
    let rod = m.add_body("rod", [0.0, 0.0, -0.8]).unwrap();
    let axis = Direction::Fixed([1.0, 0.0, 0.0]);
    let hinge = JointKind::Revolute { at: pin, axis };
    m.add_joint("hinge", BodyId::GROUND, rod, hinge).unwrap();
    let rotation = DriverKind::Rotation { axis };
    let swing = m.add_driver("swing", BodyId::GROUND, rod, rotation).unwrap();
    let mut system = System::new(m).unwrap();
    for angle in [0.0, 0.4, -1.2, 2.8_f64] {
        system.move_to(&[(swing, angle)]).unwrap();
        let mut equilibrium = Equilibrium::new(&system);
        let (lateral, vertical) = (30.0, -120.0);
        equilibrium.load_mut()[1] = lateral;
        equilibrium.load_mut()[2] = vertical;
        let outcome = equilibrium.solve(&Tolerances::default());
        assert!(outcome.converged(), "{outcome:?}");
        assert!(outcome.relative_residual < 1e-12, "{outcome:?}");
        let moment = 0.8 * (angle.sin() * vertical + angle.cos() * lateral);
        let lambda = equilibrium.multipliers().last().unwrap();
        assert!((lambda - moment).abs() < 1e-11 * 120.0, "{lambda} and {moment}");
    }
}

/// At −130, 0 and 130 mm of travel: how far the wheel centre moves in x and in y per metre of
/// travel. Independent velocities of the sedan's suspension, computed with 50 digits.
const WHEEL_RATES: [(f64, [f64; 2]); 3] = [
    (-0.13, [0.01859639572748789, 0.7121390525073961]),
    (0.0, [-0.008426777172158386, 0.0927370617997924]),
    (0.13, [-0.05125852300730108, -0.3868919656650834]),
];

#[test]
fn a_horizontal_force_on_the_wheel_is_held_by_virtual_work() {
    for (travel, [along_x, along_y]) in WHEEL_RATES {
        let car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
        let upright = car.upright.index();
        let mut system = System::new(car.mechanism).unwrap();
        system.move_to(&[(car.travel, travel)]).unwrap();
        for (axis, rate) in [along_x, along_y, 1.0].into_iter().enumerate() {
            let mut equilibrium = Equilibrium::new(&system);
            equilibrium.load_mut()[BODY_COORDINATES * (upright - 1) + axis] = 1000.0;
            let outcome = equilibrium.solve(&Tolerances::default());
            assert!(outcome.converged(), "{outcome:?}");
            // Drivers are the last equations, in their order: travel, then steer.
            let lambda = equilibrium.multipliers();
            let held = lambda[lambda.len() - 2] / 1000.0;
            assert!((held - rate).abs() < 1e-11, "{held} and {rate}");
        }
    }
}

#[test]
fn any_multipliers_and_a_disturbed_state_lead_back_to_the_unloaded_mechanism() {
    let car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let mut system = System::new(car.mechanism).unwrap();
    system.move_to(&[(car.travel, 0.04)]).unwrap();
    let expected = system.state().to_vec();
    let mut random = fastrand::Rng::with_seed(5);
    for _ in 0..20 {
        let mut equilibrium = Equilibrium::new(&system);
        for q in equilibrium.state_mut().iter_mut().skip(1) {
            q.iter_mut().for_each(|x| *x += 0.02 * (random.f64() - 0.5));
        }
        equilibrium.multipliers_mut().fill_with(|| random.f64() - 0.5);
        let outcome = equilibrium.solve(&Tolerances::default());
        assert!(outcome.converged(), "{outcome:?}");
        let largest = equilibrium.multipliers().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        assert!(largest < 1e-12, "{largest}");
        for (actual, expected) in equilibrium.state().iter().zip(&expected) {
            assert!(common::difference(actual, expected) < 1e-12);
        }
    }
}

#[test]
fn a_free_motion_without_stiffness_is_singular_and_not_a_number_out_of_nowhere() {
    let car = double_wishbone(TieRod::Spherical, |p| p, |v| v).unwrap();
    let system = System::new(car.mechanism).unwrap();
    let mut equilibrium = Equilibrium::new(&system);
    equilibrium.load_mut()[2] = 100.0;
    assert!(!equilibrium.solve(&Tolerances::default()).converged());
}
