//! Properties that hold for any geometry.

mod common;

use common::{SEDAN, TieRod, difference, double_wishbone};
use hardpoint::mechanism::{
    BodyId, Direction, DriverId, DriverKind, JointKind, Mechanism, PointId,
};
use hardpoint::solve::{StopReason, System};
use proptest::prelude::*;

fn yaw(angle: f64, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y, z]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, max_global_rejects: 1_000_000, ..ProptestConfig::default() })]

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

    /// A planar four-bar, driven far: it either arrives on its own branch or stops
    /// where coupler and rocker come in line.
    #[test]
    fn a_four_bar_never_leaves_its_branch(
        lengths in prop::array::uniform4(0.1..0.5_f64),
        theta in -3.0..3.0_f64,
        side in prop::sample::select(vec![-1.0, 1.0]),
        turn in -9.0..9.0_f64,
    ) {
        let across = |theta: f64| FourBar { lengths, side }.across_squared(theta);
        prop_assume!(across(theta) > 1e-3);
        let samples = 4000;
        let at = |k: usize| theta + turn * k as f64 / samples as f64;
        let first_outside = (0..=samples).find(|&k| across(at(k)) <= 0.0);
        // Branches that nearly touch are not told apart by sampling.
        let inside = first_outside.unwrap_or(samples + 1);
        prop_assume!((1..inside.saturating_sub(1)).all(|k| {
            let dip = across(at(k)) < across(at(k - 1)) && across(at(k)) < across(at(k + 1));
            !dip || across(at(k)) > 1e-5
        }));

        let bar = FourBar { lengths, side };
        let (mut system, drive, rocker, b) = bar.build(theta);
        match first_outside {
            None => {
                let report = system.move_to(&[(drive, turn)]);
                prop_assert!(report.is_ok(), "{}", report.unwrap_err());
                let actual = system.point_position(rocker, b);
                prop_assert!(difference(&actual, &bar.rocker_pin(theta + turn)) < 1e-10);
            }
            Some(k) => {
                let (mut low, mut high) = (at(k - 1), at(k));
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if across(middle) > 0.0 { low = middle } else { high = middle }
                }
                prop_assume!((theta + turn - low).abs() > 1e-6);
                let stop = system.move_to(&[(drive, turn)]);
                prop_assert!(stop.is_err(), "passed {low}");
                let stop = stop.unwrap_err();
                let reached = system.driver_value(drive);
                prop_assert!((reached - (low - theta)).abs() < 1e-7, "{stop}, not {low}");
                let StopReason::DeadCentre { joint, .. } = &stop.reason else {
                    return Err(TestCaseError::fail(stop.to_string()));
                };
                let elbow = "rocker_pin (revolute joint of coupler and rocker)";
                prop_assert_eq!(joint.as_deref(), Some(elbow));
            }
        }
    }
}

/// A four-bar in the x–y plane with its crank pivot at the origin.
#[derive(Clone, Copy)]
struct FourBar {
    /// Crank, coupler, rocker, base (m).
    lengths: [f64; 4],
    /// Which of the two assemblies.
    side: f64,
}

impl FourBar {
    fn crank_pin(&self, theta: f64) -> [f64; 3] {
        [self.lengths[0] * theta.cos(), self.lengths[0] * theta.sin(), 0.0]
    }

    /// The square of the rocker pin's distance from the line between crank pin and rocker
    /// pivot, with its sign: negative where the mechanism cannot be.
    fn across_squared(&self, theta: f64) -> f64 {
        let [_, coupler, rocker, base] = self.lengths;
        let d = distance(self.crank_pin(theta), [base, 0.0, 0.0]);
        let along = (d * d + coupler * coupler - rocker * rocker) / (2.0 * d);
        coupler * coupler - along * along
    }

    fn rocker_pin(&self, theta: f64) -> [f64; 3] {
        let [_, coupler, rocker, base] = self.lengths;
        let a = self.crank_pin(theta);
        let (dx, dy) = (base - a[0], -a[1]);
        let d = dx.hypot(dy);
        let along = (d * d + coupler * coupler - rocker * rocker) / (2.0 * d);
        let across = self.side * self.across_squared(theta).sqrt();
        [a[0] + (along * dx - across * dy) / d, a[1] + (along * dy + across * dx) / d, 0.0]
    }

    /// The mechanism at a crank angle, all joints revolute.
    fn build(&self, theta: f64) -> (System, DriverId, BodyId, PointId) {
        let axis = Direction::Fixed([0.0, 0.0, 1.0]);
        let mut m = Mechanism::new("frame");
        let o = m.add_point("o", [0.0; 3]).unwrap();
        let a = m.add_point("a", self.crank_pin(theta)).unwrap();
        let b = m.add_point("b", self.rocker_pin(theta)).unwrap();
        let c = m.add_point("c", [self.lengths[3], 0.0, 0.0]).unwrap();
        let crank = m.add_body("crank", [0.0; 3]).unwrap();
        let coupler = m.add_body("coupler", self.crank_pin(theta)).unwrap();
        let rocker = m.add_body("rocker", [self.lengths[3], 0.0, 0.0]).unwrap();
        let hinge = |at| JointKind::Revolute { at, axis };
        m.add_joint("crank_pivot", BodyId::GROUND, crank, hinge(o)).unwrap();
        m.add_joint("crank_pin", crank, coupler, hinge(a)).unwrap();
        m.add_joint("rocker_pin", coupler, rocker, hinge(b)).unwrap();
        m.add_joint("rocker_pivot", BodyId::GROUND, rocker, hinge(c)).unwrap();
        let rotation = DriverKind::Rotation { axis };
        let drive = m.add_driver("drive", BodyId::GROUND, crank, rotation).unwrap();
        (System::new(m).unwrap(), drive, rocker, b)
    }
}
