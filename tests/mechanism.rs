//! Building mechanisms: what is refused, and how parameters follow from hard points.

use hardpoint::mechanism::{
    BodyId, Direction, DriverKind, Expansion, JointKind, Mechanism, MechanismError, Owner,
};
use hardpoint::scalar::Dual;

const GROUND: BodyId = BodyId::GROUND;

fn arm() -> (Mechanism, BodyId) {
    let mut m = Mechanism::new("chassis");
    m.add_point("pivot", [0.0, 0.4, 0.1]).unwrap();
    m.add_point("outer", [0.0, 0.7, 0.0]).unwrap();
    m.add_point("same", [0.0, 0.7, 1e-8]).unwrap();
    let arm = m.add_body("arm", [0.0; 3]).unwrap();
    (m, arm)
}

#[test]
fn names_are_unique_and_not_empty() {
    let (mut m, arm) = arm();
    let duplicate = |what, name: &str| MechanismError::DuplicateName { what, name: name.into() };
    assert_eq!(m.add_body("arm", [0.0; 3]), Err(duplicate("body", "arm")));
    assert_eq!(m.add_body("chassis", [0.0; 3]), Err(duplicate("body", "chassis")));
    assert_eq!(m.add_point("outer", [0.0; 3]), Err(duplicate("point", "outer")));
    let at = m.point_named("outer").unwrap();
    let ball = JointKind::Spherical { at };
    m.add_joint("ball", GROUND, arm, ball).unwrap();
    assert_eq!(m.add_joint("ball", GROUND, arm, ball), Err(duplicate("joint", "ball")));
    let height = DriverKind::Height { at };
    m.add_driver("lift", GROUND, arm, height).unwrap();
    assert_eq!(m.add_driver("lift", GROUND, arm, height), Err(duplicate("driver", "lift")));
    assert_eq!(m.add_point(" ", [0.0; 3]), Err(MechanismError::EmptyName { what: "point" }));
    assert_eq!((m.joints().len(), m.drivers().len(), m.bodies().len()), (1, 1, 2));
}

#[test]
fn every_mistake_is_named_with_its_place() {
    let (mut m, arm) = arm();
    let [pivot, outer, same] = ["pivot", "outer", "same"].map(|name| m.point_named(name).unwrap());
    let y = Direction::Fixed([0.0, 1.0, 0.0]);
    let zero = Direction::Fixed([0.0; 3]);
    let mut messages = vec![
        m.add_body("b", [f64::NAN, 0.0, 0.0]).unwrap_err(),
        m.add_point("p", [0.0, f64::INFINITY, 0.0]).unwrap_err(),
        m.add_joint("j", arm, arm, JointKind::Fixed { at: pivot }).unwrap_err(),
        m.add_joint("j", GROUND, arm, JointKind::Link { on_i: outer, on_j: same }).unwrap_err(),
        m.add_driver("d", GROUND, GROUND, DriverKind::Height { at: outer }).unwrap_err(),
        m.add_driver("d", arm, GROUND, DriverKind::Height { at: outer }).unwrap_err(),
        m.add_driver("d", arm, arm, DriverKind::Rotation { axis: y }).unwrap_err(),
        m.add_driver("d", GROUND, arm, DriverKind::Length { on_i: outer, on_j: outer })
            .unwrap_err(),
    ];
    for axis in [zero, Direction::Between(outer, same), Direction::Fixed([f64::NAN, 0.0, 0.0])] {
        let joint = JointKind::Revolute { at: pivot, axis };
        messages.push(m.add_joint("j", GROUND, arm, joint).unwrap_err());
        messages.push(m.add_driver("d", GROUND, arm, DriverKind::Rotation { axis }).unwrap_err());
    }
    let vertical = Direction::Fixed([0.0, 0.0, 2.0]);
    for (spin, radius) in [(y, 0.0), (y, -0.3), (y, f64::NAN), (vertical, 0.3)] {
        let patch = DriverKind::PatchHeight { center: outer, spin, radius };
        messages.push(m.add_driver("d", GROUND, arm, patch).unwrap_err());
    }
    // Identifiers of a larger mechanism.
    let mut other = m.clone();
    let far = other.add_body("far", [0.0; 3]).unwrap();
    let point = other.add_point("far", [0.0; 3]).unwrap();
    messages.push(m.add_joint("j", GROUND, far, JointKind::Fixed { at: pivot }).unwrap_err());
    messages.push(m.add_joint("j", GROUND, arm, JointKind::Fixed { at: point }).unwrap_err());
    let axis = Direction::Between(pivot, point);
    messages.push(m.add_driver("d", GROUND, arm, DriverKind::Rotation { axis }).unwrap_err());

    assert!(m.joints().is_empty() && m.drivers().is_empty(), "a refused part was added");
    let expected = [
        "body `b` has a number that is not finite (NaN); give a finite number",
        "point `p` has a number that is not finite (inf); give a finite number",
        "joint `j` joins `arm` with itself; name two different bodies",
        "the length of joint `j` runs from `outer` [0.0, 0.7, 0.0] to `same` [0.0, 0.7, 1e-8], which are 1e-8 m apart: move one of the points",
        "driver `d` measures a height between `chassis` and `chassis`; a height is measured from the ground (`chassis`) as first body to a moving second body",
        "driver `d` measures a height between `arm` and `chassis`; a height is measured from the ground (`chassis`) as first body to a moving second body",
        "driver `d` joins `arm` with itself; name two different bodies",
        "the length of driver `d` runs from `outer` [0.0, 0.7, 0.0] to `outer` [0.0, 0.7, 0.0], which are 0e0 m apart: move one of the points",
        "the direction of joint `j` is [0.0, 0.0, 0.0], which has no length; give a vector other than zero",
        "the direction of driver `d` is [0.0, 0.0, 0.0], which has no length; give a vector other than zero",
        "the direction of joint `j` runs from `outer` [0.0, 0.7, 0.0] to `same` [0.0, 0.7, 1e-8], which are 1e-8 m apart: move one of the points",
        "the direction of driver `d` runs from `outer` [0.0, 0.7, 0.0] to `same` [0.0, 0.7, 1e-8], which are 1e-8 m apart: move one of the points",
        "joint `j` has a number that is not finite (NaN); give a finite number",
        "driver `d` has a number that is not finite (NaN); give a finite number",
        "driver `d` has a radius of 0 m at `outer`; a radius has to be greater than zero",
        "driver `d` has a radius of -0.3 m at `outer`; a radius has to be greater than zero",
        "driver `d` has a number that is not finite (NaN); give a finite number",
        "the spin axis of driver `d` at `outer` is vertical, so that the disc has no lowest point; turn the spin axis",
        "joint `j` refers to body number 2, which this mechanism does not have; use the identifiers that this mechanism returned",
        "joint `j` refers to point number 3, which this mechanism does not have; use the identifiers that this mechanism returned",
        "driver `d` refers to point number 3, which this mechanism does not have; use the identifiers that this mechanism returned",
    ];
    let messages: Vec<String> = messages.iter().map(ToString::to_string).collect();
    assert_eq!(messages, expected);
}

#[test]
fn equations_have_names_that_a_user_knows() {
    let (mut m, arm) = arm();
    let at = m.point_named("outer").unwrap();
    m.add_joint("ball", GROUND, arm, JointKind::Spherical { at }).unwrap();
    let link = JointKind::Link { on_i: m.point_named("pivot").unwrap(), on_j: at };
    m.add_joint("rod", GROUND, arm, link).unwrap();
    let lift = m.add_driver("lift", GROUND, arm, DriverKind::Height { at }).unwrap();
    let expansion = Expansion::new(&m);
    let labels: Vec<_> = (0..expansion.equation_count()).map(|k| expansion.label(k)).collect();
    assert_eq!(
        labels,
        [
            "arm (Euler parameters), normalisation",
            "ball (spherical joint of chassis and arm), x position",
            "ball (spherical joint of chassis and arm), y position",
            "ball (spherical joint of chassis and arm), z position",
            "rod (rigid link of chassis and arm), length",
            "lift (height driver of arm)",
        ]
    );
    assert_eq!(expansion.owner(4), Owner::Joint(1));
    assert_eq!(expansion.owner(5), Owner::Driver(lift));
    let h: Vec<f64> = expansion.parameters(&m.positions());
    assert_eq!(h[expansion.driver_slot(lift)], 0.0);
}

#[test]
fn parameters_have_exact_derivatives_with_respect_to_points() {
    let mut m = Mechanism::new("ground");
    let a = m.add_point("a", [0.1, -0.2, 0.3]).unwrap();
    let b = m.add_point("b", [0.7, 0.4, -0.1]).unwrap();
    let arm = m.add_body("arm", [0.3, 0.0, 0.1]).unwrap();
    let axis = Direction::Between(a, b);
    for (name, kind) in [
        ("revolute", JointKind::Revolute { at: a, axis }),
        ("universal", JointKind::Universal { at: b, shaft: axis }),
        ("translational", JointKind::Translational { at: b, axis }),
        ("link", JointKind::Link { on_i: a, on_j: b }),
        ("plane", JointKind::InPlane { at: a, normal: axis }),
        ("perpendicular", JointKind::Perpendicular { at: a, axis }),
        ("parallel", JointKind::ParallelAxes { at: a, axis }),
        ("rack", JointKind::RackAndPinion { at: a, axis, along: axis, pitch_radius: 0.1 }),
        ("screw", JointKind::Screw { at: b, axis, lead: 0.1 }),
    ] {
        m.add_joint(name, GROUND, arm, kind).unwrap();
    }
    let patch = DriverKind::PatchHeight { center: a, spin: axis, radius: 0.3 };
    m.add_driver("patch", GROUND, arm, patch).unwrap();
    m.add_driver("turn", GROUND, arm, DriverKind::Rotation { axis }).unwrap();
    m.add_driver("length", GROUND, arm, DriverKind::Length { on_i: b, on_j: a }).unwrap();
    let expansion = Expansion::new(&m);
    let positions = m.positions();
    for point in 0..positions.len() {
        for axis in 0..3 {
            let mut dual: Vec<[Dual; 3]> =
                positions.iter().map(|p| p.map(|c| Dual::new(c, 0.0))).collect();
            dual[point][axis].derivative = 1.0;
            let exact = expansion.parameters(&dual);
            let at = |step: f64| {
                let mut moved = positions.clone();
                moved[point][axis] += step;
                expansion.parameters::<f64>(&moved)
            };
            let (plus, minus) = (at(1e-5), at(-1e-5));
            for ((exact, plus), minus) in exact.iter().zip(plus).zip(minus) {
                let difference = (plus - minus) / 2e-5;
                assert!((exact.derivative - difference).abs() < 1e-8);
            }
            assert!(exact.iter().any(|h| h.derivative != 0.0));
        }
    }
}
