//! Linkages with closed-form solutions.

use std::f64::consts::{PI, TAU};

use hardpoint::mechanism::{
    BodyId, Direction, DriverId, DriverKind, JointKind, Mechanism, PointId,
};
use hardpoint::solve::{Stop, StopReason, System};

const GROUND: BodyId = BodyId::GROUND;
const X: Direction = Direction::Fixed([1.0, 0.0, 0.0]);
const Y: Direction = Direction::Fixed([0.0, 1.0, 0.0]);
const Z: Direction = Direction::Fixed([0.0, 0.0, 1.0]);

/// A planar four-bar in the x–z plane, crank on the left, all joints revolute about y.
struct FourBar {
    system: System,
    crank: BodyId,
    rocker: BodyId,
    a: PointId,
    b: PointId,
    drive: DriverId,
}

const LENGTHS: [f64; 4] = [0.1, 0.35, 0.3, 0.4];

/// The rocker pin of a four-bar with crank angle `theta`; `side` chooses the assembly.
fn rocker_pin([crank, coupler, rocker, base]: [f64; 4], theta: f64, side: f64) -> [f64; 3] {
    let (ax, az) = (crank * theta.cos(), crank * theta.sin());
    let (dx, dz) = (base - ax, -az);
    let d = dx.hypot(dz);
    let along = (d * d + coupler * coupler - rocker * rocker) / (2.0 * d);
    let across = side * (coupler * coupler - along * along).sqrt();
    [ax + (along * dx - across * dz) / d, 0.0, az + (along * dz + across * dx) / d]
}

fn four_bar(lengths: [f64; 4], theta: f64, side: f64) -> FourBar {
    let mut m = Mechanism::new("frame");
    let o = m.add_point("o", [0.0; 3]).unwrap();
    let a = m.add_point("a", [lengths[0] * theta.cos(), 0.0, lengths[0] * theta.sin()]).unwrap();
    let b = m.add_point("b", rocker_pin(lengths, theta, side)).unwrap();
    let c = m.add_point("c", [lengths[3], 0.0, 0.0]).unwrap();
    let crank = m.add_body("crank", [0.0; 3]).unwrap();
    let coupler = m.add_body("coupler", [0.01, 0.02, 0.03]).unwrap();
    let rocker = m.add_body("rocker", [0.2, 0.0, 0.1]).unwrap();
    let pin = |at| JointKind::Revolute { at, axis: Y };
    m.add_joint("crank_pivot", GROUND, crank, pin(o)).unwrap();
    m.add_joint("crank_pin", crank, coupler, pin(a)).unwrap();
    m.add_joint("rocker_pin", coupler, rocker, pin(b)).unwrap();
    m.add_joint("rocker_pivot", rocker, GROUND, pin(c)).unwrap();
    // A rotation about +y turns z into x, so a growing angle in the x–z plane is about −y.
    let axis = Direction::Fixed([0.0, -1.0, 0.0]);
    let drive = m.add_driver("crank_angle", GROUND, crank, DriverKind::Rotation { axis }).unwrap();
    let system = System::new(m).unwrap();
    FourBar { system, crank, rocker, a, b, drive }
}

fn assert_near(actual: [f64; 3], expected: [f64; 3], tolerance: f64) {
    for (a, e) in actual.iter().zip(&expected) {
        assert!((a - e).abs() < tolerance, "{actual:?} instead of {expected:?}");
    }
}

#[test]
fn four_bar_runs_through_several_turns() {
    let theta = 0.7;
    let mut bar = four_bar(LENGTHS, theta, 1.0);
    for step in 1..=60 {
        let turn = 0.2 * f64::from(step);
        bar.system.move_to(&[(bar.drive, turn)]).unwrap();
        let expected = rocker_pin(LENGTHS, theta + turn, 1.0);
        assert_near(bar.system.point_position(bar.rocker, bar.b), expected, 1e-12);
        let [x, z] = [(theta + turn).cos(), (theta + turn).sin()].map(|c| LENGTHS[0] * c);
        assert_near(bar.system.point_position(bar.crank, bar.a), [x, 0.0, z], 1e-12);
    }
}

#[test]
fn four_bar_in_space_has_three_redundant_equations_and_is_solved_all_the_same() {
    let bar = four_bar(LENGTHS, 0.7, 1.0);
    let freedom = bar.system.freedom();
    assert_eq!(freedom.redundant.len(), 3, "{freedom}");
    assert_eq!(freedom.degrees_of_freedom, 1);
    assert!(freedom.free_motions.is_empty());
    for equation in &freedom.redundant {
        assert!(equation.label.contains("(revolute joint of"), "{freedom}");
        assert!(equation.held_by.len() >= 3, "{freedom}");
        let out_of_plane =
            equation.label.contains("y position") || equation.label.contains("alignment");
        assert!(out_of_plane, "{freedom}");
    }
}

#[test]
fn a_big_step_does_not_jump_to_the_other_assembly() {
    // The two assemblies meet at the limits, where coupler and rocker are in line.
    let lengths = [0.3, 0.2, 0.25, 0.4];
    let limit = ((0.09 + 0.16 - 0.45_f64.powi(2)) / 0.24).acos();
    for (theta, side) in [(0.3, 1.0), (0.3, -1.0), (-0.9, 1.0)] {
        let mut bar = four_bar(lengths, theta, side);
        for target in [limit - 0.01, -limit + 0.01, 0.4, limit - 1e-4, 0.5] {
            bar.system.move_to(&[(bar.drive, target - theta)]).unwrap();
            let expected = rocker_pin(lengths, target, side);
            assert_near(bar.system.point_position(bar.rocker, bar.b), expected, 1e-9);
        }
    }
}

#[test]
fn four_bar_stops_at_its_limit_and_names_the_elbow() {
    let lengths = [0.3, 0.2, 0.25, 0.4];
    // Coupler and rocker are in line when the distance of their far ends is 0.45.
    let limit = ((0.09 + 0.16 - 0.45_f64.powi(2)) / 0.24).acos();
    let theta = 0.3;
    let mut bar = four_bar(lengths, theta, 1.0);
    let stop = bar.system.move_to(&[(bar.drive, PI)]).unwrap_err();
    assert!((stop.reached[0].value - (limit - theta)).abs() < 1e-8, "{stop}");
    assert_eq!(bar.system.driver_value(bar.drive), stop.reached[0].value);
    let StopReason::DeadCentre { joint, motion } = &stop.reason else { panic!("{stop}") };
    assert_eq!(joint.as_deref(), Some("rocker_pin (revolute joint of coupler and rocker)"));
    assert!(motion.contains("coupler turns about"), "{stop}");
    assert!(motion.contains("rocker turns about"), "{stop}");
    // It can go back, on its branch.
    bar.system.move_to(&[(bar.drive, 0.0)]).unwrap();
    let expected = rocker_pin(lengths, theta, 1.0);
    assert_near(bar.system.point_position(bar.rocker, bar.b), expected, 1e-12);
}

/// A slider-crank whose slider is driven along x: crank 0.1, rod 0.25.
fn slider_crank(theta: f64, side: f64) -> (System, DriverId, BodyId, PointId) {
    let (crank_length, rod_length) = (0.1, 0.25);
    let (ax, az) = (crank_length * theta.cos(), crank_length * theta.sin());
    let slider_x = ax + side * (rod_length * rod_length - az * az).sqrt();
    let mut m = Mechanism::new("block");
    let o = m.add_point("o", [0.0; 3]).unwrap();
    let a = m.add_point("a", [ax, 0.0, az]).unwrap();
    let b = m.add_point("b", [slider_x, 0.0, 0.0]).unwrap();
    let crank = m.add_body("crank", [0.0; 3]).unwrap();
    let rod = m.add_body("rod", [0.0; 3]).unwrap();
    let slider = m.add_body("slider", [0.0; 3]).unwrap();
    m.add_joint("main", GROUND, crank, JointKind::Revolute { at: o, axis: Y }).unwrap();
    m.add_joint("crank_pin", crank, rod, JointKind::Spherical { at: a }).unwrap();
    m.add_joint("gudgeon", rod, slider, JointKind::Universal { at: b, shaft: X }).unwrap();
    m.add_joint("bore", GROUND, slider, JointKind::Translational { at: b, axis: X }).unwrap();
    let along = DriverKind::Displacement { at: b, along: X };
    let drive = m.add_driver("stroke", GROUND, slider, along).unwrap();
    (System::new(m).unwrap(), drive, crank, a)
}

#[test]
fn slider_crank_follows_its_closed_form() {
    let (theta, design) =
        (1.0_f64, |t: f64| 0.1 * t.cos() + (0.0625 - 0.01 * t.sin().powi(2)).sqrt());
    let (mut system, drive, crank, a) = slider_crank(theta, 1.0);
    assert!(system.freedom().is_exact(), "{}", system.freedom());
    for target in [0.5, 0.2, 1.7, 2.9, 1.0_f64] {
        system.move_to(&[(drive, design(target) - design(theta))]).unwrap();
        let expected = [0.1 * target.cos(), 0.0, 0.1 * target.sin()];
        assert_near(system.point_position(crank, a), expected, 1e-11);
    }
}

#[test]
fn slider_crank_locks_up_at_both_dead_centres() {
    for (outwards, limit) in [(1.0, 0.35), (-1.0, 0.15)] {
        let theta = 1.0_f64;
        let design = 0.1 * theta.cos() + (0.0625 - 0.01 * theta.sin().powi(2)).sqrt();
        let (mut system, drive, ..) = slider_crank(theta, 1.0);
        let stop: Stop = system.move_to(&[(drive, 0.5 * outwards)]).unwrap_err();
        assert!((stop.reached[0].value - (limit - design)).abs() < 1e-9, "{stop}");
        let StopReason::DeadCentre { joint, .. } = &stop.reason else { panic!("{stop}") };
        assert_eq!(joint.as_deref(), Some("crank_pin (spherical joint of crank and rod)"));
        let message = stop.to_string();
        assert!(message.starts_with("stopped at stroke = "), "{message}");
    }
}

#[test]
fn pendulum_counts_its_turns() {
    let mut m = Mechanism::new("ground");
    let pin = m.add_point("pin", [0.1, 0.2, 0.3]).unwrap();
    let tip = m.add_point("tip", [0.1, 0.2, -0.7]).unwrap();
    let rod = m.add_body("rod", [0.1, 0.2, -0.2]).unwrap();
    m.add_joint("hinge", GROUND, rod, JointKind::Revolute { at: pin, axis: X }).unwrap();
    let swing = m.add_driver("swing", GROUND, rod, DriverKind::Rotation { axis: X }).unwrap();
    let mut system = System::new(m).unwrap();
    for angle in [0.5, PI, 5.0, 3.0 * TAU + 0.25, -2.0 * TAU, 0.0] {
        system.move_to(&[(swing, angle)]).unwrap();
        let expected = [0.1, 0.2 + angle.sin(), 0.3 - angle.cos()];
        assert_near(system.point_position(rod, tip), expected, 1e-12);
    }
    // Euler parameters change their sign with every turn.
    system.move_to(&[(swing, TAU)]).unwrap();
    assert!((system.state()[1][3] + 1.0).abs() < 1e-12);
    system.reset();
    assert_eq!(system.driver_value(swing), 0.0);
    assert_eq!(system.state()[1][3], 1.0);
}

#[test]
fn a_chain_of_sliding_and_turning_joints_has_its_closed_form() {
    let mut m = Mechanism::new("ground");
    let base = m.add_point("base", [0.3, -0.2, 0.1]).unwrap();
    let hub = m.add_point("hub", [0.3, -0.2, 0.6]).unwrap();
    let tip = m.add_point("tip", [0.8, -0.2, 0.6]).unwrap();
    let carriage = m.add_body("carriage", [1.0, 0.0, 0.0]).unwrap();
    let column = m.add_body("column", [0.3, -0.2, 0.3]).unwrap();
    let arm = m.add_body("arm", [0.5, 0.5, 0.5]).unwrap();
    let slide = JointKind::Translational { at: base, axis: X };
    m.add_joint("slide", GROUND, carriage, slide).unwrap();
    let sleeve = JointKind::Cylindrical { at: base, axis: Z };
    m.add_joint("sleeve", carriage, column, sleeve).unwrap();
    // The universal joint leaves two cross axes; the rotation about its shaft follows the column.
    let cross = JointKind::Universal { at: hub, shaft: Z };
    m.add_joint("cross", column, arm, cross).unwrap();
    let displacement = |at, along| DriverKind::Displacement { at, along };
    let x = m.add_driver("x", GROUND, carriage, displacement(base, X)).unwrap();
    let z = m.add_driver("z", carriage, column, displacement(base, Z)).unwrap();
    let turn = m.add_driver("turn", carriage, column, DriverKind::Rotation { axis: Z }).unwrap();
    // Two heights over a universal joint: the tip follows both tilts.
    let pitch = m.add_driver("pitch", GROUND, arm, DriverKind::Height { at: tip }).unwrap();
    let left = m.add_point("left", [0.3, 0.3, 0.6]).unwrap();
    let roll = m.add_driver("roll", GROUND, arm, DriverKind::Height { at: left }).unwrap();
    let mut system = System::new(m).unwrap();
    assert!(system.freedom().is_exact(), "{}", system.freedom());
    let (dx, dz, angle) = (0.4_f64, -0.15_f64, 1.3_f64);
    system.move_to(&[(x, dx), (z, dz), (turn, angle), (pitch, dz), (roll, dz)]).unwrap();
    let hub_now = [0.3 + dx, -0.2, 0.6 + dz];
    assert_near(system.point_position(arm, hub), hub_now, 1e-12);
    let tip_now = [hub_now[0] + 0.5 * angle.cos(), -0.2 + 0.5 * angle.sin(), hub_now[2]];
    assert_near(system.point_position(arm, tip), tip_now, 1e-10);
    // Pitching the arm by β about its left axis lowers the tip by half a metre times sin β.
    let beta = 0.4_f64;
    system.move_to(&[(pitch, dz - 0.5 * beta.sin())]).unwrap();
    let reach = 0.5 * beta.cos();
    let tip_now = [
        hub_now[0] + reach * angle.cos(),
        -0.2 + reach * angle.sin(),
        hub_now[2] - 0.5 * beta.sin(),
    ];
    assert_near(system.point_position(arm, tip), tip_now, 1e-10);
}

#[test]
fn fixed_joints_links_planes_and_lines_hold_what_they_say() {
    let mut m = Mechanism::new("ground");
    let o = m.add_point("o", [0.0; 3]).unwrap();
    let p = m.add_point("p", [0.5, 0.1, 0.2]).unwrap();
    let far = m.add_point("far", [0.9, 0.6, -0.1]).unwrap();
    let q = m.add_point("q", [0.7, 0.3, 0.4]).unwrap();
    let plate = m.add_body("plate", [0.5, 0.1, 0.2]).unwrap();
    let bracket = m.add_body("bracket", [0.5, 0.2, 0.2]).unwrap();
    m.add_joint("weld", plate, bracket, JointKind::Fixed { at: p }).unwrap();
    m.add_joint("guide", GROUND, plate, JointKind::InLine { at: p, axis: X }).unwrap();
    m.add_joint("plane", GROUND, plate, JointKind::InPlane { at: q, normal: Z }).unwrap();
    m.add_joint("link", GROUND, bracket, JointKind::Link { on_i: o, on_j: far }).unwrap();
    let x = DriverKind::Displacement { at: p, along: X };
    let x = m.add_driver("x", GROUND, plate, x).unwrap();
    let length = DriverKind::Length { on_i: o, on_j: q };
    let length = m.add_driver("length", GROUND, bracket, length).unwrap();
    let mut system = System::new(m).unwrap();
    let freedom = system.freedom();
    assert!(freedom.is_exact() && freedom.degrees_of_freedom == 2, "{freedom}");
    system.move_to(&[(x, 0.05), (length, 0.02)]).unwrap();
    let norm = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    assert_near(system.point_position(plate, p), [0.55, 0.1, 0.2], 1e-13);
    assert!((system.point_position(plate, q)[2] - 0.4).abs() < 1e-13);
    let link = norm(system.point_position(bracket, far));
    assert!((link - norm([0.9, 0.6, -0.1])).abs() < 1e-13);
    let length = norm(system.point_position(bracket, q));
    assert!((length - norm([0.7, 0.3, 0.4]) - 0.02).abs() < 1e-13);
    for (a, b) in system.rotation(plate).into_iter().zip(system.rotation(bracket)) {
        assert_near(a, b, 1e-13);
    }
}
