//! Mechanism files, and the mechanisms that ship.
#![allow(missing_docs)]

use hardpoint::mechanism::{Direction, DriverKind, ForceKind, JointKind, Mechanism};
use hardpoint::model::{Document, MechanismModel};
use hardpoint::solve::System;

fn mechanism(document: Document) -> MechanismModel {
    match document {
        Document::Mechanism(model) => model,
        Document::Suspension(model) => panic!("{} is a suspension", model.name),
    }
}

fn load(name: &str) -> Mechanism {
    let document = Document::load(format!("models/{name}.toml"));
    mechanism(document.unwrap_or_else(|e| panic!("{}", e.render()))).mechanism
}

fn parse(text: &str) -> MechanismModel {
    mechanism(Document::parse("file.toml", text).unwrap_or_else(|e| panic!("{}", e.render())))
}

#[track_caller]
fn near(actual: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(actual.len(), expected.len());
    for (a, e) in actual.iter().zip(expected) {
        assert!((a - e).abs() <= tolerance, "{actual:?} is not {expected:?}");
    }
}

const LEVER: &str = r#"
format = 1
name = "Lever"
ground = "frame"
gravity = [0.0, 0.0, -9.81]

[units]
length = "in"
angle = "deg"
force = "lbf"
mass = "lb"

[points]
pivot = [0.0, 0.0, 0.0]
tip = [10.0, 0.0, 0.0]
anchor = [10.0, 0.0, 10.0]

[bodies]
slider = "Slider on the tip"

[bodies.lever]
meaning = "Lever"
mass = 10.0
center_of_mass = [5.0, 0.0, 0.0]
inertia = [1.0, 100.0, 100.0, 0.5, 0.0, 0.0]
velocity = [0.0, 0.0, 5.0]
angular_velocity = [0.0, -90.0, 0.0]

[[joints]]
name = "hinge"
kind = "revolute"
between = ["frame", "lever"]
at = "pivot"
axis = "y"

[[joints]]
name = "slide"
kind = "translational"
between = ["lever", "slider"]
at = "tip"
axis = ["pivot", "tip"]

[[drivers]]
name = "angle"
kind = "rotation"
between = ["frame", "lever"]
axis = "y"

[[drivers]]
name = "way"
kind = "displacement"
between = ["lever", "slider"]
at = "tip"
along = ["pivot", "tip"]

[[drivers]]
name = "rope"
kind = "length"
between = ["frame", "lever"]
on = ["anchor", "tip"]

[[drivers]]
name = "height"
kind = "height"
between = ["frame", "lever"]
at = "tip"

[[forces]]
name = "wheel"
kind = "tyre"
body = "lever"
center = "tip"
axis = "y"
contact = "contact-patch"
stiffness = 100.0
free_radius = 12.0
ground = -11.0
"#;

#[test]
fn a_mechanism_file_is_in_si_units() {
    let model = parse(LEVER);
    assert_eq!(model.name, "Lever");
    assert_eq!(model.units.force.symbol(), "lbf");
    let m = &model.mechanism;
    let names: Vec<&str> = m.bodies().iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["frame", "slider", "lever"]);
    let lever = &m.bodies()[2];
    let mass = lever.mass.unwrap();
    near(&[mass.mass], &[4.535_923_7], 1e-15);
    near(&mass.center, &[0.127, 0.0, 0.0], 1e-16);
    let unit = 2.926_396_534_292e-4;
    near(&mass.inertia, &[unit, 100.0 * unit, 100.0 * unit, 0.5 * unit, 0.0, 0.0], 1e-15);
    let start = lever.initial_velocity;
    near(&start.velocity, &[0.0, 0.0, 0.127], 1e-16);
    near(&start.rotation, &[0.0, -std::f64::consts::FRAC_PI_2, 0.0], 1e-15);
    // The mean of the points of its joints: the hinge and the slide.
    near(&lever.origin, &[0.127, 0.0, 0.0], 1e-16);
    assert_eq!(m.gravity(), [0.0, 0.0, -9.81]);
    let point = |name| m.point_named(name).unwrap();
    let kinds: Vec<DriverKind> = m.drivers().iter().map(|driver| driver.kind).collect();
    let line = Direction::Between(point("pivot"), point("tip"));
    assert_eq!(kinds[0], DriverKind::Rotation { axis: Direction::Fixed([0.0, 1.0, 0.0]) });
    assert_eq!(kinds[1], DriverKind::Displacement { at: point("tip"), along: line });
    assert_eq!(kinds[2], DriverKind::Length { on_i: point("anchor"), on_j: point("tip") });
    assert_eq!(kinds[3], DriverKind::Height { at: point("tip") });
    let ForceKind::Tyre { free_radius, ground, law, .. } = &m.forces()[0].kind else { panic!() };
    near(&[*free_radius, *ground], &[0.3048, -0.2794], 1e-16);
    near(&[law.at(-0.0254, 0.0).force], &[-444.822_161_526_05], 1e-12);
    assert_eq!(law.at(0.0254, 0.0).force, 0.0);
}

#[test]
fn a_number_for_gravity_is_downward() {
    let model = parse(&LEVER.replace("[0.0, 0.0, -9.81]", "9.81"));
    assert_eq!(model.mechanism.gravity(), [0.0, 0.0, -9.81]);
}

#[test]
fn bodies_without_joints_stand_in_their_centre_of_mass() {
    let model = parse(
        "format = 1\nname = \"Brick\"\nground = \"space\"\ngravity = 0\n[units]\nlength = \"m\"\n\
         angle = \"rad\"\nmass = \"kg\"\n[points]\norigin = [0, 0, 0]\n[bodies]\nghost = \"No mass\"\n\
         [bodies.brick]\nmass = 2\ncenter_of_mass = [1, 2, 3]\ninertia = [1, 2, 2]\n\
         [[joints]]\nname = \"tie\"\nkind = \"spherical\"\nbetween = [\"space\", \"ghost\"]\nat = \"origin\"\n",
    );
    assert_eq!(model.mechanism.bodies()[2].origin, [1.0, 2.0, 3.0]);
}

#[test]
fn a_file_is_what_it_names() {
    assert!(matches!(Document::load("models/double-wishbone.toml"), Ok(Document::Suspension(_))));
    assert!(matches!(Document::load("models/pendulum.toml"), Ok(Document::Mechanism(_))));
    let error = Document::load("models/no-such-file.toml").unwrap_err().render();
    assert!(error.contains("there is no file"), "{error}");
}

/// Degrees of freedom of the mechanisms that ship, and their redundant equations.
#[test]
fn shipped_mechanisms_move_as_they_should() {
    for (name, redundant, free) in [
        ("four-bar", 0, 0),
        ("pendulum", 0, 1),
        ("squeezer", 9, 1),
        ("double-four-bar", 6, 1),
        ("bricard", 1, 1),
        ("anti-roll-bar", 0, 2),
    ] {
        let system = System::new(load(name)).unwrap();
        let freedom = system.freedom();
        let found = (freedom.redundant.len(), freedom.free_motions.len());
        assert_eq!(found, (redundant, free), "{name}: {freedom}");
    }
}

/// The four-bar linkage against the closed form of Freudenstein.
#[test]
fn the_four_bar_turns_all_round() {
    let m = load("four-bar");
    let crank = m.driver_named("crank_angle").unwrap();
    let [pin, rocker_pin, pivot] =
        ["crank_pin", "rocker_pin", "rocker_pivot"].map(|name| m.point_named(name).unwrap());
    let [crank_body, rocker] = ["crank", "rocker"].map(|name| m.body_named(name).unwrap());
    let mut system = System::new(m).unwrap();
    for degrees in [30.0, 90.0, 170.0, 250.0, 360.0_f64] {
        system.move_to(&[(crank, degrees.to_radians())]).unwrap();
        let angle = degrees.to_radians();
        let crank_pin = system.point_position(crank_body, pin);
        near(&crank_pin, &[0.04 * angle.sin(), 0.0, 0.04 * angle.cos()], 1e-12);
        let end = system.point_position(rocker, rocker_pin);
        let square = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>();
        near(&[square(end, crank_pin).sqrt()], &[0.12], 1e-12);
        let pivot = system.point_position(rocker, pivot);
        near(&[square(end, pivot).sqrt(), end[1]], &[0.08, 0.0], 1e-12);
    }
}

/// Andrews' mechanism closes at its initial angles: the chains to the squeeze point have the
/// lengths of the parameters.
#[test]
fn the_squeezer_has_its_parameters() {
    let m = load("squeezer");
    let at = |name: &str| m.points()[m.point_named(name).unwrap().index()].position;
    let distance = |a: &str, b: &str| {
        let (a, b) = (at(a), at(b));
        (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
    };
    for (a, b, length) in [
        ("crank_pivot", "crank_pin", 0.007),
        ("crank_pin", "squeeze_point", 0.028),
        ("lever_pivot", "squeeze_point", 0.035),
        ("arm_pivot", "upper_knee", 0.04),
        ("upper_knee", "squeeze_point", 0.02),
        ("arm_pivot", "lower_knee", 0.04),
        ("lower_knee", "squeeze_point", 0.02),
    ] {
        near(&[distance(a, b)], &[length], 1e-16);
    }
    near(&[distance("lever_pivot", "spring_lever")], &[0.018_f64.hypot(0.02)], 1e-16);
    let centers = [("k1", "crank_pivot", 0.00092), ("k2", "crank_pin", 0.0115)];
    let more = [("k4", "squeeze_point", 0.01421), ("k6", "squeeze_point", 0.01421)];
    let arms = [("k5", "arm_pivot", 0.02308_f64.hypot(0.00916))];
    let other = [
        ("k3", "lever_pivot", 0.01874_f64.hypot(0.01043)),
        ("k7", "arm_pivot", 0.01228_f64.hypot(0.00449)),
    ];
    for (body, point, length) in centers.into_iter().chain(more).chain(arms).chain(other) {
        let center = m.bodies()[m.body_named(body).unwrap().index()].mass.unwrap().center;
        let point = at(point);
        let found = (0..3).map(|k| (center[k] - point[k]).powi(2)).sum::<f64>().sqrt();
        near(&[found], &[length], 1e-16);
    }
    let masses: f64 = m.bodies().iter().filter_map(|body| body.mass).map(|mass| mass.mass).sum();
    near(&[masses], &[0.04325 + 0.00365 + 0.02373 + 0.00706 + 0.0705 + 0.00706 + 0.05498], 1e-15);
    assert!(m.joints().iter().all(|joint| matches!(joint.kind, JointKind::Revolute { .. })));
}
