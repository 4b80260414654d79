//! Motion in time against closed forms, and what cannot move.

mod common;

use common::pendulum::{GRAVITY, PERIOD, Y, Z, difference, dynamics, pendulum};
use hardpoint::mechanism::{
    Acts, BodyId, Curve, DriverKind, ForceKind, InitialVelocity, JointKind, Law, MassProperties,
    Mechanism, PointId, Reference,
};
use hardpoint::solve::System;
use hardpoint::solve::dynamics::{Dynamics, Integrator, Rest, SettlePlan, Start};

/// Errors of two runs, the second with half the step, fall as those of a method of second order.
fn assert_second_order(coarse: f64, fine: f64) {
    let ratio = coarse / fine;
    assert!((ratio - 4.0).abs() < 0.2, "{coarse:e} / {fine:e} = {ratio}");
}

#[test]
fn a_pendulum_is_back_after_its_period() {
    let (m, rod, bob) = pendulum();
    let run = |steps: u32| {
        let mut motion = dynamics(&m, Integrator::fixed(PERIOD / f64::from(steps))).unwrap();
        motion.advance_to(PERIOD).unwrap();
        assert_eq!(motion.time(), PERIOD);
        // Back at rest: speed is error of phase times g.
        (motion.point_velocity(rod, bob)[2], motion.report().energy_drift)
    };
    let (coarse, fine) = (run(2000), run(4000));
    assert!(fine.0.abs() < 2e-5 && fine.1 < 2e-5, "{fine:?}");
    assert_second_order(coarse.0, fine.0);
    assert_second_order(coarse.1, fine.1);
}

#[test]
fn accelerations_reactions_and_velocities_of_a_pendulum_are_those_of_its_circle() {
    let (m, rod, bob) = pendulum();
    let mut motion = dynamics(&m, Integrator::fixed(1e-4)).unwrap();
    // At the start it falls freely, and the hinge carries nothing.
    assert!(difference(motion.point_acceleration(rod, bob), GRAVITY) < 1e-12);
    assert!(difference(motion.reactions()[0].on_j.force, [0.0; 3]) < 1e-12);
    motion.advance_to(0.7).unwrap();
    let [x, _, z] = motion.point_position(rod, bob);
    let speed = (-2.0 * 9.81 * z).sqrt();
    // Angle rate about y, falling from −x: counted down.
    let omega = motion.angular_velocity(rod);
    assert!(difference(omega, [0.0, -speed, 0.0]) < 1e-6, "{omega:?} and {speed}");
    let tangential = 9.81 * x;
    let alpha = motion.angular_acceleration(rod);
    assert!(difference(alpha, [0.0, tangential, 0.0]) < 1e-5, "{alpha:?} and {tangential}");
    // The rod carries the weight and the centripetal force: 3 m g times the depth.
    let force = motion.reactions()[0].on_j.force;
    let tension = -3.0 * 9.81 * z;
    assert!(difference(force, [-tension * x, 0.0, -tension * z]) < 1e-4, "{force:?}");
}

#[test]
fn a_thrown_body_flies_along_its_parabola_to_the_last_digit() {
    let mut m = Mechanism::new("ground");
    m.set_gravity(GRAVITY).unwrap();
    let stone = m.add_body("stone", [0.3, 0.0, 1.0]).unwrap();
    let center = m.add_point("center", [0.4, 0.1, 1.0]).unwrap();
    let inertia = [0.02, 0.03, 0.04, 0.0, 0.0, 0.0];
    m.set_mass(stone, MassProperties { mass: 2.0, center: [0.4, 0.1, 1.0], inertia }).unwrap();
    let velocity = [3.0, -1.0, 4.0];
    m.set_initial_velocity(stone, InitialVelocity { velocity, rotation: [0.0; 3] }).unwrap();
    let mut motion = dynamics(&m, Integrator::fixed(0.01)).unwrap();
    assert!(!motion.start().contradicts);
    motion.advance_to(0.8).unwrap();
    let at = motion.point_position(stone, center);
    let expected = [0.4 + 2.4, 0.1 - 0.8, 1.0 + 3.2 - 0.5 * 9.81 * 0.64];
    assert!(difference(at, expected) < 1e-12, "{at:?} and {expected:?}");
    assert!(motion.report().energy_drift < 1e-11, "{:?}", motion.report());
}

/// A symmetric top without forces: its axis goes around the angular momentum at |L| ∕ J₁.
#[test]
fn a_free_top_precesses_about_its_angular_momentum() {
    let (transverse, axial) = (0.3, 0.5);
    let mut m = Mechanism::new("ground");
    let top = m.add_body("top", [0.0; 3]).unwrap();
    // Its centre of mass is apart from the origin of its frame.
    let center = [0.2, -0.1, 0.3];
    let inertia = [transverse, transverse, axial, 0.0, 0.0, 0.0];
    m.set_mass(top, MassProperties { mass: 4.0, center, inertia }).unwrap();
    let rotation = [2.0, 0.0, 9.0];
    m.set_initial_velocity(top, InitialVelocity { velocity: [0.0; 3], rotation }).unwrap();
    let momentum: [f64; 3] = [transverse * rotation[0], 0.0, axial * rotation[2]];
    let size = (momentum[0] * momentum[0] + momentum[2] * momentum[2]).sqrt();
    let time = 1.3;
    let (sin, cos) = (size / transverse * time).sin_cos();
    // Rodrigues' rotation of the z axis about L.
    let n = momentum.map(|l| l / size);
    let cross = [n[1], -n[0], 0.0];
    let expected: [f64; 3] = std::array::from_fn(|k| {
        let z = if k == 2 { 1.0 } else { 0.0 };
        cos * z + sin * cross[k] + (1.0 - cos) * n[2] * n[k]
    });
    let run = |step: f64| {
        let mut motion = dynamics(&m, Integrator::fixed(step)).unwrap();
        motion.advance_to(time).unwrap();
        let a = motion.rotation(top);
        (difference([a[0][2], a[1][2], a[2][2]], expected), motion.report().energy_drift)
    };
    let (coarse, fine) = (run(2e-3), run(1e-3));
    assert!(fine.0 < 1e-3, "{fine:?}");
    assert_second_order(coarse.0, fine.0);
    assert!(coarse.1 / fine.1 > 3.8, "{coarse:?} {fine:?}");
}

/// A mass of 2 kg on a slide, hung on a spring with a damper.
fn oscillator(damping: f64) -> (Mechanism, BodyId, PointId) {
    let mut m = Mechanism::new("ground");
    m.set_gravity(GRAVITY).unwrap();
    let block = m.add_body("block", [0.0; 3]).unwrap();
    let hook = m.add_point("hook", [0.0, 0.0, 1.0]).unwrap();
    let eye = m.add_point("eye", [0.0; 3]).unwrap();
    m.add_joint("slide", BodyId::GROUND, block, JointKind::Translational { at: eye, axis: Z })
        .unwrap();
    let inertia = [0.1, 0.1, 0.1, 0.0, 0.0, 0.0];
    m.set_mass(block, MassProperties { mass: 2.0, center: [0.0; 3], inertia }).unwrap();
    let law = Law { viscous: Curve::linear(damping), ..Law::spring(450.0) };
    let spring = ForceKind::Line { on_i: hook, on_j: eye, reference: Reference::Length(1.0), law };
    m.add_force("spring", BodyId::GROUND, block, spring).unwrap();
    (m, block, eye)
}

#[test]
fn a_damped_oscillator_follows_its_exponential() {
    let (mass, stiffness, damping, time) = (2.0, 450.0, 12.0, 0.6);
    let (m, block, eye) = oscillator(damping);
    // z = z₀ (1 − e^(−δt) (cos ωt + δ/ω sin ωt)) with the deflection z₀ by the weight.
    let deflection = -mass * 9.81 / stiffness;
    let delta: f64 = damping / (2.0 * mass);
    let omega: f64 = (stiffness / mass - delta * delta).sqrt();
    let decay = (-delta * time).exp();
    let (sin, cos) = (omega * time).sin_cos();
    let z = deflection * (1.0 - decay * (cos + delta / omega * sin));
    let speed = deflection * decay * sin * (delta * delta + omega * omega) / omega;
    let acceleration = -9.81 - (stiffness * z + damping * speed) / mass;
    let run = |step: f64| {
        let mut motion = dynamics(&m, Integrator::fixed(step)).unwrap();
        motion.advance_to(time).unwrap();
        let drift = motion.energy().drift;
        let error = [
            motion.point_position(block, eye)[2] - z,
            motion.point_velocity(block, eye)[2] - speed,
            motion.point_acceleration(block, eye)[2] - acceleration,
        ];
        (error, drift, motion.energy())
    };
    let (coarse, fine) = (run(2e-3), run(1e-3));
    for k in 0..3 {
        assert_second_order(coarse.0[k], fine.0[k]);
    }
    assert!(fine.0[0].abs() < 1e-5 && fine.1.abs() < 1e-4, "{fine:?}");
    assert!(coarse.1 / fine.1 > 3.8, "{coarse:?} {fine:?}");
    // What the damper took is what is missing.
    assert!(fine.2.work < 0.0, "{fine:?}");
}

#[test]
fn adaptive_steps_keep_their_tolerance_and_end_where_they_should() {
    let (m, block, eye) = oscillator(12.0);
    let mut reference = dynamics(&m, Integrator::fixed(2e-5)).unwrap();
    let mut motions = [1e-6, 1e-9].map(|tolerance| {
        let mut motion = dynamics(&m, Integrator::adaptive(tolerance)).unwrap();
        for k in 1..=5 {
            let time = 0.13 * f64::from(k);
            motion.advance_to(time).unwrap();
            assert_eq!(motion.time(), time);
        }
        motion
    });
    reference.advance_to(0.65).unwrap();
    let expected = reference.point_position(block, eye);
    let errors = motions.each_mut().map(|motion| {
        let report = *motion.report();
        assert!(report.smallest_step < report.largest_step && report.largest_step <= 0.02);
        difference(motion.point_position(block, eye), expected)
    });
    let steps = motions.each_ref().map(|motion| motion.report().steps);
    assert!(errors[0] < 1e-4 && errors[1] < 1e-6, "{errors:?} in {steps:?}");
    assert!(steps[0] < 300 && steps[1] > 3 * steps[0], "{steps:?}");
}

#[test]
fn a_block_falls_on_a_stop_and_comes_to_rest() {
    let (mut m, block, eye) = oscillator(0.0);
    let floor = m.add_point("floor", [0.0, 0.0, -0.6]).unwrap();
    let law = Law { viscous: Curve::linear(300.0), acts: Acts::Below, ..Law::spring(2e5) };
    let stop = ForceKind::Line { on_i: floor, on_j: eye, reference: Reference::Length(0.55), law };
    m.add_force("stop", BodyId::GROUND, block, stop).unwrap();
    let plan = |rest| SettlePlan { until: 20.0, interval: 0.05, rest };
    let rest = Rest { speed: 1e-6, acceleration: 1e-4 };
    for integrator in [Integrator::fixed(2e-4), Integrator::adaptive(1e-8)] {
        let mut motion = dynamics(&m, integrator).unwrap();
        let trajectory =
            motion.settle(&plan(Some(rest)), |now| now.point_position(block, eye)[2]).unwrap();
        assert_eq!(trajectory.stop, None);
        // Without damping in the air it swings on above the stop for ever.
        assert_eq!(trajectory.rest, None);
        assert_eq!(trajectory.samples.len(), 401);
        let lowest = trajectory.samples.iter().map(|&(_, z)| z).fold(0.0, f64::min);
        assert!(lowest < -0.049 && lowest > -0.06, "{lowest}");
        assert!(motion.energy().drift.abs() < 0.02, "{:?}", motion.energy());
    }
    let (mut damped, block, eye) = oscillator(12.0);
    damped.set_gravity([0.0, 0.0, -30.0]).unwrap();
    let mut motion = dynamics(&damped, Integrator::adaptive(1e-8)).unwrap();
    let trajectory = motion.settle(&plan(Some(rest)), |_| ()).unwrap();
    assert!(trajectory.rest.is_some_and(|time| time < 8.0), "{:?}", trajectory.rest);
    let z = motion.point_position(block, eye)[2];
    assert!((z + 2.0 * 30.0 / 450.0).abs() < 1e-6, "{z}");
}

/// A four-bar linkage in space has three equations too many.
fn four_bar() -> (Mechanism, [BodyId; 3]) {
    let mut m = Mechanism::new("ground");
    m.set_gravity([0.0, -9.81, 0.0]).unwrap();
    let corners = [[0.0, 0.0, 0.0], [0.1, 0.3, 0.0], [0.7, 0.5, 0.0], [0.8, 0.0, 0.0]];
    let points: Vec<PointId> = corners
        .iter()
        .enumerate()
        .map(|(k, &at)| m.add_point(&format!("P{k}"), at).unwrap())
        .collect();
    let mut ring = vec![BodyId::GROUND];
    for k in 0..3 {
        let center = std::array::from_fn(|c| 0.5 * (corners[k][c] + corners[k + 1][c]));
        let body = m.add_body(["crank", "coupler", "rocker"][k], center).unwrap();
        let inertia = [0.01, 0.01, 0.02, 0.0, 0.0, 0.0];
        m.set_mass(body, MassProperties { mass: 1.5, center, inertia }).unwrap();
        ring.push(body);
    }
    ring.push(BodyId::GROUND);
    for k in 0..4 {
        let kind = JointKind::Revolute { at: points[k], axis: Z };
        m.add_joint(&format!("J{k}"), ring[k], ring[k + 1], kind).unwrap();
    }
    (m, [ring[1], ring[2], ring[3]])
}

#[test]
fn velocities_that_do_not_fit_are_changed_as_little_as_possible_and_told() {
    let (mut m, [crank, coupler, rocker]) = four_bar();
    let motion = dynamics(&m, Integrator::fixed(1e-3)).unwrap();
    assert!(!motion.start().contradicts && motion.start().requested == 0.0);
    // A velocity that fits, taken from a motion, is left alone.
    let mut moving = motion;
    moving.advance_to(0.1).unwrap();
    let state = moving.state().to_vec();
    let system = System::new(m.clone()).unwrap();
    let velocity: Vec<InitialVelocity> = (0..4)
        .map(|index| {
            let body = [BodyId::GROUND, crank, coupler, rocker][index];
            let v = moving.velocity()[index];
            let rotation = moving.angular_velocity(body);
            InitialVelocity { velocity: [v[0], v[1], v[2]], rotation }
        })
        .collect();
    let start = Start { state: Some(&state), velocity: Some(&velocity), ..Start::default() };
    let mut again = Dynamics::new(&system, &start, Integrator::fixed(1e-3)).unwrap();
    // What the joints drift in velocity is all that is changed.
    assert!(again.start().velocity_change < 1e-5, "{:?}", again.start());
    moving.advance_to(0.3).unwrap();
    again.advance_to(0.2).unwrap();
    let (a, b) = (moving.state()[2], again.state()[2]);
    assert!((0..7).all(|k| (a[k] - b[k]).abs() < 1e-5), "{a:?} {b:?}");

    // The crank alone cannot turn.
    let wish = InitialVelocity { velocity: [0.0; 3], rotation: [0.0, 0.0, 5.0] };
    m.set_initial_velocity(crank, wish).unwrap();
    let motion = dynamics(&m, Integrator::fixed(1e-3)).unwrap();
    let start = motion.start();
    assert!(start.contradicts && start.rotation_change > 0.5, "{start:?}");
    assert_eq!(start.body, "crank");
    assert!(motion.report().velocity_drift < 1e-12, "{:?}", motion.report());
}

#[test]
fn redundant_equations_hold_along_the_way() {
    let (m, [crank, ..]) = four_bar();
    let system = System::new(m).unwrap();
    assert_eq!(system.freedom().redundant.len(), 3);
    let drift = |step: f64| {
        let mut motion =
            Dynamics::new(&system, &Start::default(), Integrator::fixed(step)).unwrap();
        motion.advance_to(3.0).unwrap();
        assert!(motion.report().position_drift < 1e-12, "{:?}", motion.report());
        assert!(motion.angular_velocity(crank)[2].abs() > 0.0);
        motion.report().energy_drift
    };
    let (coarse, fine) = (drift(1e-3), drift(5e-4));
    assert!(fine < 1e-3 && coarse / fine > 3.5, "{coarse:e} {fine:e}");
}

#[test]
fn drivers_hold_until_they_are_released() {
    let (mut m, rod, bob) = pendulum();
    let swing = m.add_driver("swing", BodyId::GROUND, rod, DriverKind::Rotation { axis: Y });
    let swing = swing.unwrap();
    let mut system = System::new(m).unwrap();
    system.move_to(&[(swing, 0.5)]).unwrap();
    let mut held = Dynamics::new(&system, &Start::default(), Integrator::fixed(0.01)).unwrap();
    held.advance_to(1.0).unwrap();
    let at = system.point_position(rod, bob);
    assert!(difference(held.point_position(rod, bob), at) < 1e-13);
    // −λ is the moment that holds the rod level against its weight, about y.
    let lambda = held.multipliers().last().unwrap();
    assert!((lambda.abs() - 9.81 * 0.5_f64.cos()).abs() < 1e-9, "{lambda}");
    let start = Start { released: &[swing], ..Start::default() };
    let mut free = Dynamics::new(&system, &start, Integrator::fixed(1e-3)).unwrap();
    free.advance_to(0.2).unwrap();
    assert!(free.point_velocity(rod, bob)[2] < -1.0);
    assert_eq!(*free.multipliers().last().unwrap(), 0.0);
}

#[test]
fn a_load_works_as_weight_does() {
    let (mut m, rod, bob) = pendulum();
    let mut weighed = dynamics(&m, Integrator::fixed(1e-3)).unwrap();
    weighed.advance_to(0.4).unwrap();
    m.set_gravity([0.0; 3]).unwrap();
    // The frame of the rod is at the pin, so the weight of the bob is no constant load: a force at the
    // bob is one.
    let force = ForceKind::PointForce {
        at: bob,
        frame: hardpoint::mechanism::LoadFrame::Space,
        direction: GRAVITY,
        size: 9.81,
    };
    m.add_force("weight", BodyId::GROUND, rod, force).unwrap();
    let mut pulled = dynamics(&m, Integrator::fixed(1e-3)).unwrap();
    pulled.advance_to(0.4).unwrap();
    let both = [&weighed, &pulled].map(|motion| motion.point_position(rod, bob));
    assert!(difference(both[0], both[1]) < 1e-12);

    // A constant load on the origin of a free body is a uniform acceleration, and its work is kept.
    let mut m = Mechanism::new("ground");
    let body = m.add_body("body", [0.0; 3]).unwrap();
    let inertia = [0.1, 0.1, 0.1, 0.0, 0.0, 0.0];
    m.set_mass(body, MassProperties { mass: 4.0, center: [0.0; 3], inertia }).unwrap();
    let system = System::new(m).unwrap();
    let load = [8.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let start = Start { load: Some(&load), ..Start::default() };
    let mut motion = Dynamics::new(&system, &start, Integrator::fixed(0.01)).unwrap();
    motion.advance_to(2.0).unwrap();
    assert!((motion.state()[1][0] - 4.0).abs() < 1e-12);
    assert!((motion.energy().work - 32.0).abs() < 1e-10, "{:?}", motion.energy());
    assert!(motion.report().energy_drift < 1e-10);
}
