//! Degrees of freedom, redundant equations and free motions in words.

mod common;

use common::{TieRod, double_wishbone};
use hardpoint::mechanism::{BodyId, Direction, DriverKind, JointKind, Mechanism};
use hardpoint::solve::freedom::analyse;
use hardpoint::solve::{System, SystemError};

const GROUND: BodyId = BodyId::GROUND;

#[test]
fn a_tie_rod_between_ball_joints_spins_and_the_suspension_moves_all_the_same() {
    let car = double_wishbone(TieRod::Spherical, |p| p, |v| v).unwrap();
    let exact = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let mut system = System::new(car.mechanism).unwrap();
    let mut reference = System::new(exact.mechanism).unwrap();
    let freedom = system.freedom();
    assert_eq!(freedom.degrees_of_freedom, 3);
    assert_eq!(freedom.free_motions.len(), 1);
    assert_eq!(
        freedom.free_motions[0].description,
        "tierod turns about the line tierod_inner–tierod_outer"
    );
    for travel in [-0.13, 0.0, 0.07, 0.13] {
        let targets = [(car.travel, travel), (car.steer, 0.1 * travel)];
        let report = system.move_to(&targets).unwrap();
        reference.move_to(&targets).unwrap();
        assert!(report.relative_residual < 1e-12, "{report:?}");
        let [here, there] = [&system, &reference]
            .map(|system| system.point_position(car.upright, car.wheel_center));
        assert!(common::difference(&here, &there) < 1e-12);
    }
}

#[test]
fn missing_drivers_are_free_motions() {
    let mut m = Mechanism::new("ground");
    let a = m.add_point("pin", [0.0; 3]).unwrap();
    let b = m.add_point("far_pin", [0.0, 1.0, 0.0]).unwrap();
    let c = m.add_point("guide", [2.0, 0.0, 0.0]).unwrap();
    let door = m.add_body("door", [0.3, 0.0, 0.0]).unwrap();
    let sledge = m.add_body("sledge", [2.0, 0.0, 0.0]).unwrap();
    let axis = Direction::Between(a, b);
    m.add_joint("hinge", GROUND, door, JointKind::Revolute { at: a, axis }).unwrap();
    let axis = Direction::Fixed([3.0, 0.0, 4.0]);
    m.add_joint("rail", GROUND, sledge, JointKind::Translational { at: c, axis }).unwrap();
    let report = analyse(&m);
    let mut words: Vec<_> =
        report.free_motions.iter().map(|motion| motion.description.as_str()).collect();
    words.sort_unstable();
    assert_eq!(
        words,
        ["door turns about the line pin–far_pin", "sledge moves along (0.6000, 0.0000, 0.8000)"]
    );
}

#[test]
fn a_loose_body_has_six_free_motions() {
    let mut m = Mechanism::new("ground");
    m.add_point("p", [0.1, 0.0, 0.0]).unwrap();
    m.add_point("q", [0.0, 0.2, 0.7]).unwrap();
    m.add_body("stone", [1.0, 2.0, 3.0]).unwrap();
    let report = analyse(&m);
    assert_eq!(report.degrees_of_freedom, 6);
    assert_eq!(report.free_motions.len(), 6, "{report}");
    assert!(report.free_motions.iter().all(|motion| motion.bodies.len() == 1));
}

#[test]
fn coupled_bodies_are_one_motion() {
    // Two links on hinges, joined by a coupler: a parallelogram, planar joints for all but one.
    let car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let mut m = Mechanism::new("chassis");
    let names = ["lca_front", "lca_rear", "lca_outer"];
    let mut ids = vec![];
    for point in car.mechanism.points().iter().filter(|point| names.contains(&&*point.name)) {
        ids.push(m.add_point(&point.name, point.position).unwrap());
    }
    let arm = m.add_body("lca", [0.0; 3]).unwrap();
    let hub = m.add_body("hub", [0.5, 0.5, 0.0]).unwrap();
    let axis = Direction::Between(ids[0], ids[1]);
    m.add_joint("pivot", GROUND, arm, JointKind::Revolute { at: ids[0], axis }).unwrap();
    m.add_joint("weld", arm, hub, JointKind::Fixed { at: ids[2] }).unwrap();
    let report = analyse(&m);
    assert_eq!(report.free_motions.len(), 1);
    assert_eq!(
        report.free_motions[0].description,
        "lca, hub together: turns about the line lca_front–lca_rear"
    );
    let mentioned = report.to_string();
    assert!(
        mentioned.starts_with("2 moving bodies, 1 degree of freedom, 0 drivers"),
        "{mentioned}"
    );
}

#[test]
fn a_driver_against_the_joints_is_refused_by_name() {
    let mut m = Mechanism::new("ground");
    let p = m.add_point("p", [0.0; 3]).unwrap();
    let tip = m.add_point("tip", [0.0, 0.0, 0.4]).unwrap();
    let arm = m.add_body("arm", [0.0; 3]).unwrap();
    let axis = Direction::Fixed([0.0, 1.0, 0.0]);
    m.add_joint("hinge", GROUND, arm, JointKind::Revolute { at: p, axis }).unwrap();
    m.add_driver("swing", GROUND, arm, DriverKind::Rotation { axis }).unwrap();
    m.add_driver("lift", GROUND, arm, DriverKind::Height { at: tip }).unwrap();
    let report = analyse(&m);
    assert_eq!(report.blocked_drivers.len(), 1, "{report}");
    let Err(SystemError::BlockedDriver(blocked)) = System::new(m) else { panic!("{report}") };
    assert_eq!(blocked.held_by, ["hinge"]);
}

#[test]
fn a_dead_centre_at_the_design_position_names_the_driver() {
    // Crank and rod in line: the slider cannot be pushed.
    let mut m = Mechanism::new("block");
    let y = Direction::Fixed([0.0, 1.0, 0.0]);
    let x = Direction::Fixed([1.0, 0.0, 0.0]);
    let o = m.add_point("o", [0.0; 3]).unwrap();
    let a = m.add_point("a", [0.1, 0.0, 0.0]).unwrap();
    let b = m.add_point("b", [0.35, 0.0, 0.0]).unwrap();
    let crank = m.add_body("crank", [0.0; 3]).unwrap();
    let rod = m.add_body("rod", [0.0; 3]).unwrap();
    let slider = m.add_body("slider", [0.0; 3]).unwrap();
    m.add_joint("main", GROUND, crank, JointKind::Revolute { at: o, axis: y }).unwrap();
    m.add_joint("crank_pin", crank, rod, JointKind::Spherical { at: a }).unwrap();
    m.add_joint("gudgeon", rod, slider, JointKind::Universal { at: b, shaft: x }).unwrap();
    m.add_joint("bore", GROUND, slider, JointKind::Translational { at: b, axis: x }).unwrap();
    m.add_driver("stroke", GROUND, slider, DriverKind::Displacement { at: b, along: x }).unwrap();
    let Err(error) = System::new(m) else { panic!("a slider at its dead centre was accepted") };
    let message = error.to_string();
    for word in ["`stroke`", "main", "crank_pin", "gudgeon", "dead centre"] {
        assert!(message.contains(word), "{message}");
    }
}

#[test]
fn joints_that_lock_a_redundant_mechanism_are_found_by_its_residual() {
    // Two hinges with axes that are parallel but not the same line: at the design
    // position each holds what the other holds, but no rotation is left.
    let mut m = Mechanism::new("ground");
    let z = Direction::Fixed([0.0, 0.0, 1.0]);
    let a = m.add_point("a", [0.0; 3]).unwrap();
    let b = m.add_point("b", [0.5, 0.0, 0.0]).unwrap();
    let door = m.add_body("door", [0.0; 3]).unwrap();
    m.add_joint("hinge", GROUND, door, JointKind::Revolute { at: a, axis: z }).unwrap();
    // A link along the radius: to first order the door can turn, in truth it cannot.
    m.add_joint("link", GROUND, door, JointKind::Link { on_i: a, on_j: b }).unwrap();
    let c = m.add_point("c", [2.0, 0.0, 0.0]).unwrap();
    let stay = JointKind::Link { on_i: c, on_j: b };
    m.add_joint("stay", GROUND, door, stay).unwrap();
    let swing = m.add_driver("swing", GROUND, door, DriverKind::Rotation { axis: z }).unwrap();
    let mut system = System::new(m).unwrap();
    assert_eq!(system.freedom().redundant.len(), 2, "{}", system.freedom());
    let stop = system.move_to(&[(swing, 0.5)]).unwrap_err();
    let message = stop.to_string();
    assert!(message.contains("stay (rigid link of ground and door)"), "{message}");
    assert!(system.driver_value(swing).abs() < 1e-3, "{message}");
}

/// Two legs of two plates each, hinged about y and about x: the top can only rise.
#[test]
fn a_sarrus_linkage_is_movable_with_one_redundant_equation() {
    let (width, height) = (0.2_f64, 0.5_f64);
    let mut m = Mechanism::new("floor");
    let top = m.add_body("top", [0.0, 0.0, height]).unwrap();
    let mut knees = vec![];
    for (name, out, axis) in
        [("x", [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), ("y", [0.0, 1.0, 0.0], [1.0, 0.0, 0.0])]
    {
        let at = |distance: f64, z: f64| [distance * out[0], distance * out[1], z];
        let foot = m.add_point(&format!("foot_{name}"), at(1.0, 0.0)).unwrap();
        let knee = m.add_point(&format!("knee_{name}"), at(1.0 + width, 0.5 * height)).unwrap();
        let head = m.add_point(&format!("head_{name}"), at(1.0, height)).unwrap();
        let lower = m.add_body(&format!("lower_{name}"), at(1.0, 0.0)).unwrap();
        let upper = m.add_body(&format!("upper_{name}"), at(1.0, height)).unwrap();
        let axis = Direction::Fixed(axis);
        let hinge = |at| JointKind::Revolute { at, axis };
        m.add_joint(&format!("foot_{name}"), GROUND, lower, hinge(foot)).unwrap();
        m.add_joint(&format!("knee_{name}"), lower, upper, hinge(knee)).unwrap();
        m.add_joint(&format!("head_{name}"), upper, top, hinge(head)).unwrap();
        knees.push((lower, knee, out));
    }
    let head = m.point_named("head_x").unwrap();
    let rise = m.add_driver("rise", GROUND, top, DriverKind::Height { at: head }).unwrap();
    let mut system = System::new(m).unwrap();
    let freedom = system.freedom();
    assert_eq!((freedom.redundant.len(), freedom.degrees_of_freedom), (1, 1), "{freedom}");
    assert!(freedom.free_motions.is_empty(), "{freedom}");
    let leg = width.hypot(0.5 * height);
    for dz in [0.1, -0.35, 0.0, 0.13] {
        system.move_to(&[(rise, dz)]).unwrap();
        let half = 0.5 * (height + dz);
        let reach = 1.0 + (leg * leg - half * half).sqrt();
        for (lower, knee, out) in &knees {
            let expected = [reach * out[0], reach * out[1], half];
            let actual = system.point_position(*lower, *knee);
            assert!(common::difference(&actual, &expected) < 1e-10, "{actual:?} {expected:?}");
        }
        let upright = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        assert!(common::difference(system.rotation(top).as_flattened(), &upright) < 1e-10);
    }
    let stop = system.move_to(&[(rise, 1.0)]).unwrap_err();
    let limit = 2.0 * leg - height;
    assert!((stop.reached[0].value - limit).abs() < 1e-8, "{stop} {limit}");
}
