//! Properties that hold for any geometry.

mod common;

use common::{SEDAN, TieRod, difference, double_wishbone};
use hardpoint::mechanism::{BodyId, Direction, DriverKind, JointKind, Mechanism};
use hardpoint::solve::System;
use proptest::prelude::*;

fn yaw(angle: f64, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y, z]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The whole vehicle yawed and moved makes the same motion.
    #[test]
    fn motion_does_not_depend_on_where_the_vehicle_stands(
        angle in -3.0..3.0_f64,
        offset in prop::array::uniform3(-5.0..5.0_f64),
        travel in -0.1..0.1_f64,
        rack in -0.03..0.03_f64,
    ) {
        let place = |p| {
            let turned = yaw(angle, p);
            [turned[0] + offset[0], turned[1] + offset[1], turned[2] + offset[2]]
        };
        let here = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
        let there = double_wishbone(TieRod::Universal, place, |v| yaw(angle, v)).unwrap();
        let mut here_system = System::new(here.mechanism).unwrap();
        let mut there_system = System::new(there.mechanism).unwrap();
        here_system.move_to(&[(here.travel, travel), (here.steer, rack)]).unwrap();
        there_system.move_to(&[(there.travel, travel), (there.steer, rack)]).unwrap();
        let expected = place(here_system.point_position(here.upright, here.wheel_center));
        let actual = there_system.point_position(there.upright, there.wheel_center);
        prop_assert!(difference(&actual, &expected) < 1e-12);
    }

    /// Any double wishbone keeps its distances and comes back to where it was,
    /// whichever way it goes.
    #[test]
    fn every_double_wishbone_keeps_its_lengths(
        shifts in prop::array::uniform9(prop::array::uniform3(-0.03..0.03_f64)),
        travel in -0.06..0.06_f64,
        rack in -0.02..0.02_f64,
    ) {
        // The tie rod's inner point moves with its body, so shift by the position it had.
        let shift = |p: [f64; 3]| {
            let k = SEDAN.iter().position(|(_, position)| *position == p).unwrap();
            [p[0] + shifts[k][0], p[1] + shifts[k][1], p[2] + shifts[k][2]]
        };
        let car = double_wishbone(TieRod::Universal, shift, |v| v).unwrap();
        let mut system = System::new(car.mechanism).unwrap();
        let upright = car.upright;
        let point = |name: &str| system.mechanism().point_named(name).unwrap();
        let outer = ["lca_outer", "uca_outer", "tierod_outer"].map(point);
        let design = SEDAN.map(|(_, position)| shift(position));
        let report = system.move_to(&[(car.travel, travel), (car.steer, rack)]).unwrap();
        prop_assert!(report.relative_residual < 1e-12);

        let [lca, uca, tie] = outer.map(|point| system.point_position(upright, point));
        for (arm, k) in [(lca, 0), (uca, 3)] {
            for inner in [k, k + 1] {
                let length = distance(design[inner], design[k + 2]);
                prop_assert!((distance(design[inner], arm) - length).abs() < 1e-12);
            }
        }
        let rack_end = [design[6][0], design[6][1] + rack, design[6][2]];
        let length = distance(design[6], design[7]);
        prop_assert!((distance(rack_end, tie) - length).abs() < 1e-12);
        let wheel = system.point_position(upright, car.wheel_center);
        prop_assert!((wheel[2] - design[8][2] - travel).abs() < 1e-12);

        // In two steps to the same place: the solution depends on the drivers alone.
        let once = system.state().to_vec();
        system.reset();
        system.move_to(&[(car.steer, rack)]).unwrap();
        system.move_to(&[(car.travel, travel)]).unwrap();
        prop_assert!(difference(once.as_flattened(), system.state().as_flattened()) < 1e-11);
        system.move_to(&[(car.travel, 0.0), (car.steer, 0.0)]).unwrap();
        for (q, body) in system.state().iter().zip(system.mechanism().bodies()) {
            prop_assert!(difference(&q[..3], &body.origin) < 1e-12);
            prop_assert!((q[3] - 1.0).abs() < 1e-12);
        }
    }

    /// A crank–rocker in space (revolute, spherical, universal, revolute) with random
    /// axes keeps the length of its coupler through whole turns of the crank.
    #[test]
    fn a_spatial_crank_turns_its_rocker(
        tilt in prop::array::uniform2(-0.3..0.3_f64),
        height in -0.05..0.05_f64,
        turns in prop::sample::select(vec![-1.5, 0.5, 1.0, 2.25]),
    ) {
        let mut m = Mechanism::new("frame");
        let o = m.add_point("o", [0.0; 3]).unwrap();
        let a = m.add_point("a", [0.1, 0.0, height]).unwrap();
        let b = m.add_point("b", [0.5, 0.35, 0.0]).unwrap();
        let c = m.add_point("c", [0.5, 0.0, 0.0]).unwrap();
        let crank = m.add_body("crank", [0.0; 3]).unwrap();
        let coupler = m.add_body("coupler", [0.1, 0.2, 0.0]).unwrap();
        let rocker = m.add_body("rocker", [0.5, 0.0, 0.0]).unwrap();
        let axis = Direction::Fixed([tilt[0], tilt[1], 1.0]);
        let ground = BodyId::GROUND;
        m.add_joint("crank_pivot", ground, crank, JointKind::Revolute { at: o, axis }).unwrap();
        m.add_joint("ball", crank, coupler, JointKind::Spherical { at: a }).unwrap();
        let shaft = Direction::Between(a, b);
        m.add_joint("cross", coupler, rocker, JointKind::Universal { at: b, shaft }).unwrap();
        let upright = Direction::Fixed([0.0, 0.0, 1.0]);
        let hinge = JointKind::Revolute { at: c, axis: upright };
        m.add_joint("rocker_pivot", ground, rocker, hinge).unwrap();
        let drive = m.add_driver("drive", ground, crank, DriverKind::Rotation { axis }).unwrap();
        let length = distance([0.1, 0.0, height], [0.5, 0.35, 0.0]);
        let mut system = System::new(m).unwrap();
        prop_assert!(system.freedom().is_exact(), "{}", system.freedom());
        let angle = turns * std::f64::consts::TAU;
        let report = system.move_to(&[(drive, angle)]).unwrap();
        prop_assert!(report.relative_residual < 1e-12);
        let [a, b] = [system.point_position(crank, a), system.point_position(rocker, b)];
        prop_assert!((distance(a, b) - length).abs() < 1e-12);
        prop_assert!((distance(b, [0.5, 0.0, 0.0]) - 0.35).abs() < 1e-12 && b[2].abs() < 1e-12);
        // Always on the side of the base line on which it was assembled.
        let base = [b[0] - a[0], b[1] - a[1]];
        let to_pivot = [0.5 - b[0], -b[1]];
        prop_assert!(base[0] * to_pivot[1] - base[1] * to_pivot[0] < 0.0);
    }
}
