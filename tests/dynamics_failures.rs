//! What cannot move, and where a motion ends.

mod common;

use common::pendulum::{PERIOD, X, Y, dynamics, pendulum};
use hardpoint::mechanism::{
    Acts, BodyId, ForceKind, JointKind, Law, MassProperties, Mechanism, Reference,
};
use hardpoint::solve::System;
use hardpoint::solve::dynamics::{
    Dynamics, DynamicsFailure, Integrator, SettlePlan, Start, StepSize,
};

#[test]
fn what_cannot_move_is_told_by_name() {
    // A rod without mass that is free to turn.
    let (mut m, rod, _) = pendulum();
    let free = m.add_body("flag", [0.0; 3]).unwrap();
    let pin = m.point_named("pin").unwrap();
    m.add_joint("pole", rod, free, JointKind::Revolute { at: pin, axis: X }).unwrap();
    let failure = dynamics(&m, Integrator::fixed(1e-3)).err().unwrap();
    assert!(matches!(&failure, DynamicsFailure::NoInertia { bodies, .. } if bodies == &["flag"]));
    assert!(failure.to_string().contains("body flag has no mass"), "{failure}");
    // Held by the joints it needs no mass.
    let bob = m.point_named("bob").unwrap();
    m.add_joint("bolt", rod, free, JointKind::InPlane { at: bob, normal: Y }).unwrap();
    let (m, rod, bob) = {
        let (mut m, rod, bob) = pendulum();
        let flag = m.add_body("flag", [0.0; 3]).unwrap();
        m.add_joint("bolt", rod, flag, JointKind::Fixed { at: bob }).unwrap();
        (m, rod, bob)
    };
    let mut motion = dynamics(&m, Integrator::fixed(PERIOD / 4000.0)).unwrap();
    motion.advance_to(PERIOD).unwrap();
    assert!(motion.point_velocity(rod, bob)[2].abs() < 2e-5);

    // A point mass can turn about its axis without inertia.
    let mut m = Mechanism::new("ground");
    let bead = m.add_body("bead", [0.0; 3]).unwrap();
    m.set_mass(bead, MassProperties { mass: 1.0, center: [0.0; 3], inertia: [0.0; 6] }).unwrap();
    let failure = dynamics(&m, Integrator::fixed(1e-3)).err().unwrap();
    assert!(matches!(&failure, DynamicsFailure::NoInertia { bodies, .. } if bodies == &["bead"]));

    // A spring without length has no direction.
    let (mut m, rod, bob) = pendulum();
    let law = Law::spring(10.0);
    let reference = Reference::Length(0.1);
    let spring = ForceKind::Line { on_i: bob, on_j: bob, reference, law };
    m.add_force("spring", BodyId::GROUND, rod, spring).unwrap();
    let failure = dynamics(&m, Integrator::fixed(1e-3)).err().unwrap();
    assert!(matches!(&failure, DynamicsFailure::NoForce { force, .. } if force == "spring"));
}

#[test]
fn settings_and_states_without_meaning_are_refused() {
    let (m, rod, _) = pendulum();
    let adaptive = |tolerance, largest| StepSize::Adaptive { tolerance, largest };
    for (spectral_radius, step) in [
        (1.1, StepSize::Fixed(1e-3)),
        (f64::NAN, StepSize::Fixed(1e-3)),
        (0.8, StepSize::Fixed(0.0)),
        (0.8, StepSize::Fixed(f64::NAN)),
        (0.8, adaptive(0.0, 1e-2)),
        (0.8, adaptive(1e-6, -1.0)),
    ] {
        let failure = dynamics(&m, Integrator { spectral_radius, step }).err().unwrap();
        assert!(matches!(failure, DynamicsFailure::Setting { .. }), "{failure}");
    }
    let system = System::new(m.clone()).unwrap();
    let begin =
        |start: &Start<'_>| Dynamics::new(&system, start, Integrator::fixed(1e-3)).err().unwrap();
    let mut state = system.state().to_vec();
    state[rod.index()][0] += 1e-3;
    let failure = begin(&Start { state: Some(&state), ..Start::default() });
    assert!(failure.to_string().contains("hinge (revolute joint"), "{failure}");
    state[rod.index()][0] = f64::NAN;
    let failure = begin(&Start { state: Some(&state), ..Start::default() });
    assert!(matches!(failure, DynamicsFailure::NotFinite { what: "position", .. }), "{failure}");
    let load = [f64::INFINITY; 7];
    let failure = begin(&Start { load: Some(&load), ..Start::default() });
    assert!(matches!(failure, DynamicsFailure::NotFinite { what: "load", .. }), "{failure}");
    let mut motion = dynamics(&m, Integrator::fixed(1e-3)).unwrap();
    motion.advance_to(0.5).unwrap();
    for time in [0.4, f64::NAN, f64::INFINITY] {
        assert!(matches!(motion.advance_to(time), Err(DynamicsFailure::Time { .. })));
    }
    let plan = SettlePlan { until: 1.0, interval: 0.0, rest: None };
    assert!(matches!(motion.settle(&plan, |_| ()), Err(DynamicsFailure::Setting { .. })));
}

#[test]
fn a_motion_into_a_dead_end_stops_there_and_keeps_what_was_reached() {
    let (mut m, rod, bob) = pendulum();
    let wall = m.add_point("wall", [1.0, 0.0, 0.0]).unwrap();
    let law = Law { acts: Acts::Below, ..Law::spring(1e18) };
    let stop = ForceKind::Line { on_i: wall, on_j: bob, reference: Reference::Length(1.0), law };
    m.add_force("wall", BodyId::GROUND, rod, stop).unwrap();
    let mut motion = dynamics(&m, Integrator::adaptive(1e-10)).unwrap();
    let plan = SettlePlan { until: 5.0, interval: 0.1, rest: None };
    let trajectory = motion.settle(&plan, Dynamics::time).unwrap();
    // The contact takes nanoseconds; it begins when the bob has come down.
    let stop = trajectory.stop.unwrap();
    assert!(matches!(stop, DynamicsFailure::TooInexact { .. }), "{stop}");
    assert!(motion.time() > 0.7 && motion.time() < 0.8, "{}", motion.time());
    assert_eq!(trajectory.samples.len(), 8);
    assert!(motion.report().energy_drift < 1e-5, "{:?}", motion.report());
    assert!(motion.state().iter().flatten().all(|x| x.is_finite()));

    // With a step that is far too long for the wall nothing converges behind it.
    let mut motion = dynamics(&m, Integrator::fixed(1e-3)).unwrap();
    let failure = motion.advance_to(5.0).unwrap_err();
    assert!(
        matches!(&failure, DynamicsFailure::NoConvergence { equation, time, .. }
            if equation == "the balance of forces on rod" && *time == motion.time()),
        "{failure}"
    );
    assert!(motion.state().iter().flatten().all(|x| x.is_finite()));
}

/// A spring that pushes away what leaves it: the motion grows without bound, in fewer and fewer
/// microseconds a step, and is told as what it is.
#[test]
fn a_runaway_ends_in_a_named_failure() {
    let mut m = Mechanism::new("ground");
    let (low, high) =
        (m.add_point("low", [0.0; 3]).unwrap(), m.add_point("high", [0.0, 0.0, 0.4]).unwrap());
    let body = m.add_body("carriage", [0.0, 0.0, 0.4]).unwrap();
    let axis = hardpoint::mechanism::Direction::Fixed([0.0, 0.0, 1.0]);
    m.add_joint("rail", BodyId::GROUND, body, JointKind::Translational { at: high, axis }).unwrap();
    let center = [0.0, 0.0, 0.4];
    m.set_mass(body, MassProperties { mass: 3.0, center, inertia: [0.0; 6] }).unwrap();
    let (reference, law) = (Reference::Length(0.399), Law::spring(-3000.0));
    let spring = ForceKind::Line { on_i: low, on_j: high, reference, law };
    m.add_force("spring", BodyId::GROUND, body, spring).unwrap();
    let mut motion = dynamics(&m, Integrator::adaptive(1e-8)).unwrap();
    let failure = motion.advance_to(5.0).unwrap_err();
    assert!(matches!(failure, DynamicsFailure::RanAway { .. }), "{failure}");
    assert!(failure.to_string().contains("carriage is 1"), "{failure}");
    // x'' = 1000 x from 1 mm reaches 1000 m after ln(2e6)/√1000 s.
    assert!((motion.time() - 2e6_f64.ln() / 1000.0_f64.sqrt()).abs() < 0.01, "{}", motion.time());
}
