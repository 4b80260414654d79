//! What stands where: tyres, slides and bushings of shipped models.
#![allow(missing_docs)]

#[path = "common/elements.rs"]
mod elements;

use elements::answer;
use hardpoint::mechanism::{Acts, Contact, Curve, ForceKind, Law, Mechanism};
use hardpoint::model::{Chassis, Model, Setup, WheelSupport};
use hardpoint::relation::Coordinates;
use hardpoint::solve::System;

fn load(name: &str) -> Model {
    Model::load(format!("models/{name}.toml")).unwrap_or_else(|e| panic!("{}", e.render()))
}

#[track_caller]
fn near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{actual} {expected}");
}

/// Every body where it was designed.
fn design(mechanism: &Mechanism) -> Vec<Coordinates<f64>> {
    let place = |[x, y, z]: [f64; 3]| [x, y, z, 1.0, 0.0, 0.0, 0.0];
    mechanism.bodies().iter().map(|body| place(body.origin)).collect()
}

#[test]
fn weights_pull_down() {
    let suspension = load("quarter-car").suspension(&Setup::default()).unwrap();
    let mechanism = &suspension.mechanism;
    assert_eq!(mechanism.gravity(), [0.0, 0.0, -9.81]);
    let state = design(mechanism);
    let forces = answer(mechanism, &state, &vec![[0.0; 7]; state.len()]).force;
    let upright = forces[mechanism.body_named("upright").unwrap().index()];
    near(upright[2], -38.0 * 9.81);
    // The spring of 605 mm pushes the arm down.
    let lca = forces[mechanism.body_named("lca").unwrap().index()];
    assert!(lca[2] < -6000.0 && lca[2] > -7000.0, "{lca:?}");
}

#[test]
fn setups_choose_what_stands_where() {
    let model = load("quarter-car");
    assert!(model.has_forces() && model.has_tyre() && model.is_quarter_car());
    let held = model.suspension(&Setup::default()).unwrap();
    assert!(held.tyre.is_none());
    assert_eq!(held.mechanism.bodies()[held.chassis.index()].name, "chassis");
    assert_eq!(held.chassis.index(), 0);

    let setup = Setup { support: WheelSupport::Free, chassis: Chassis::Slide, ..Setup::default() };
    let standing = model.suspension(&setup).unwrap();
    let m = &standing.mechanism;
    let names: Vec<&str> = m.bodies().iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["road", "chassis", "lca", "uca", "upright", "tierod", "rack"]);
    assert_eq!(m.bodies()[1].mass.unwrap().mass, 380.0);
    assert_eq!(m.bodies()[standing.wheel.body.index()].name, "upright");
    assert_eq!(standing.steer_axis.unwrap().upper.1, standing.wheel.body);
    let tyre = &m.forces()[standing.tyre.unwrap().index()];
    assert_eq!((tyre.i.index(), tyre.j), (0, standing.wheel.body));
    let ForceKind::Tyre { contact, free_radius, ground, law } = &tyre.kind else { panic!() };
    assert!(matches!(contact, Contact::Center(_)));
    assert_eq!((*free_radius, *ground, law.acts), (0.3266, -0.428, Acts::Always));
    assert_eq!(law.elastic, Curve::Linear(220e3));
    let spring = &m.forces()[m.force_named("spring").unwrap().index()];
    assert_eq!((spring.i.index(), spring.j.index()), (1, 2));
    // Road, slide and driven wheel leave the chassis free to move up and down.
    let system = System::new(standing.mechanism.clone()).unwrap();
    let freedom = system.freedom();
    assert_eq!((freedom.redundant.len(), freedom.free_motions.len()), (0, 1), "{freedom}");

    let plain = load("double-wishbone");
    assert!(!plain.has_forces() && !plain.has_tyre() && !plain.is_quarter_car());
    let free = Setup { support: WheelSupport::Free, ..Setup::default() };
    assert_eq!(plain.suspension(&free).unwrap().tyre, None);
    let slide = Setup { chassis: Chassis::Slide, ..Setup::default() };
    let error = plain.suspension(&slide).unwrap_err();
    assert!(error.to_string().contains("quarter_car"), "{error}");
}

#[test]
fn bushings_stand_for_joints_unless_kinematic() {
    let model = load("bushed-double-wishbone");
    assert_eq!(model.bushed_joints(), ["lca_pivot"]);
    let joints = |kinematic| {
        let suspension = model.suspension(&Setup { kinematic, ..Setup::default() }).unwrap();
        let m = suspension.mechanism;
        let named = m.joints().iter().any(|joint| joint.name == "lca_pivot");
        let bushings =
            m.forces().iter().filter(|f| matches!(f.kind, ForceKind::Bushing(_))).count();
        let freedom = System::new(m.clone()).unwrap().freedom().free_motions.len();
        (named, m.joints().len(), m.forces().len(), bushings, freedom)
    };
    assert_eq!(joints(true), (true, 7, 1, 0, 0));
    // Five motions that the hinge held are left to the bushings.
    assert_eq!(joints(false), (false, 6, 3, 2, 5));
    let ForceKind::Bushing(front) = &model.bushings()[0].force.kind else { panic!() };
    near(front.rotation[0].at(1.0, 0.0).force, 90.0);
    near(front.rotation[2].at(1.0, 0.0).force, 350.0);
    assert_eq!(front.translation[1], Law::spring(9e6));
    assert_eq!(load("compliant-corner").bushed_joints(), ["lca_pivot", "uca_pivot"]);
}

/// Forces refer to points, so they follow them.
#[test]
fn forces_follow_points_that_move() {
    let mut model = load("quarter-car");
    model.set_point("spring_upper", [-0.04, 0.52, 0.33]);
    let suspension = model.suspension(&Setup::default()).unwrap();
    let values = |m: &Mechanism| {
        let state = design(m);
        answer(m, &state, &vec![[0.0; 7]; state.len()]).values
    };
    let length = (0.04_f64.powi(2) + 0.1_f64.powi(2) + 0.6_f64.powi(2)).sqrt();
    near(values(&suspension.mechanism)[0], length - 0.605);
}
