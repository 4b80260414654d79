//! From the text of a model to a suspension that moves.
#![allow(missing_docs)]

use hardpoint::mechanism::{BodyId, Direction, DriverKind, PointId};
use hardpoint::model::{Alignment, Drive, Model, Setup, Suspension};
use hardpoint::solve::System;

fn load(name: &str) -> Model {
    Model::load(format!("models/{name}.toml")).unwrap_or_else(|e| panic!("{}", e.render()))
}

/// A suspension driven to a travel and a rack displacement (mm).
struct Moved {
    suspension: Suspension,
    system: System,
}

impl Moved {
    fn new(model: &Model, drive: Drive, travel: f64, rack: f64) -> Self {
        let suspension = model.suspension(&drive.into()).unwrap();
        let mut system = System::new(suspension.mechanism.clone()).unwrap();
        let mut targets = vec![(suspension.travel, travel / 1000.0)];
        targets.extend(suspension.rack.map(|driver| (driver, rack / 1000.0)));
        system.move_to(&targets).unwrap();
        Self { suspension, system }
    }

    fn point(&self, (point, body): (PointId, BodyId)) -> [f64; 3] {
        self.system.point_position(body, point)
    }

    fn wheel_center(&self) -> [f64; 3] {
        let wheel = self.suspension.wheel;
        self.point((wheel.center, wheel.body))
    }

    fn spin_axis(&self) -> [f64; 3] {
        let rotation = self.system.rotation(self.suspension.wheel.body);
        let spin = self.suspension.wheel.spin_axis;
        rotation.map(|row| row[0] * spin[0] + row[1] * spin[1] + row[2] * spin[2])
    }

    /// Toe and camber (deg).
    fn alignment(&self) -> [f64; 2] {
        let Alignment { toe, camber } = Alignment::of_spin_axis(self.spin_axis());
        [toe.to_degrees(), camber.to_degrees()]
    }
}

#[track_caller]
fn assert_near(actual: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(actual.len(), expected.len());
    for (a, e) in actual.iter().zip(expected) {
        assert!((a - e).abs() <= tolerance, "{actual:?} is not {expected:?}");
    }
}

#[test]
fn double_wishbone_has_the_bodies_and_joints_of_its_architecture() {
    let suspension = load("double-wishbone").suspension(&Setup::default()).unwrap();
    let mechanism = &suspension.mechanism;
    let bodies: Vec<&str> = mechanism.bodies().iter().map(|b| b.name.as_str()).collect();
    assert_eq!(bodies, ["chassis", "lca", "uca", "upright", "tierod", "rack"]);
    let joints: Vec<(&str, &str)> =
        mechanism.joints().iter().map(|joint| (joint.name.as_str(), joint.kind.name())).collect();
    let expected = [
        ("lca_pivot", "revolute"),
        ("uca_pivot", "revolute"),
        ("lower_ball_joint", "spherical"),
        ("upper_ball_joint", "spherical"),
        ("tierod_inner_joint", "universal"),
        ("tierod_outer_joint", "spherical"),
        ("rack_slide", "translational"),
    ];
    assert_eq!(joints, expected);
    let drivers: Vec<&str> = mechanism.drivers().iter().map(|d| d.name.as_str()).collect();
    assert_eq!(drivers, ["rack", "travel"]);
    assert_eq!(suspension.wheel.body, mechanism.body_named("upright").unwrap());
    assert_eq!(suspension.wheel.radius, 0.3266);
    // The mean of lca_front, lca_rear and lca_outer.
    let origin = mechanism.bodies()[1].origin;
    assert_near(&origin, &[0.0, 1.66 / 3.0, -0.285], 1e-15);
}

#[test]
fn joints_and_drivers_leave_no_freedom_and_no_redundancy() {
    for name in ["double-wishbone", "lotus-front", "adams-tr-front"] {
        for drive in [Drive::WheelCenter, Drive::ContactPatch] {
            let suspension = load(name).suspension(&drive.into()).unwrap();
            let system = System::new(suspension.mechanism).unwrap();
            assert!(system.freedom().redundant.is_empty(), "{name}");
            assert!(system.freedom().free_motions.is_empty(), "{name}");
        }
    }
}

#[test]
fn spin_axis_follows_the_points_that_define_it() {
    let suspension = load("lotus-front").suspension(&Drive::ContactPatch.into()).unwrap();
    let point = |name| suspension.mechanism.point_named(name).unwrap();
    // The spindle point lies inboard, so the axis runs from it to the wheel centre.
    let outboard = Direction::Between(point("wheel_spindle"), point("wheel_center"));
    assert_eq!(suspension.wheel.spin, outboard);
    let travel = suspension.mechanism.drivers().last().unwrap();
    let expected =
        DriverKind::PatchHeight { center: point("wheel_center"), spin: outboard, radius: 0.27 };
    assert_eq!(travel.kind, expected);
}

#[test]
fn mirrored_sedan_moves_as_a_mirror_image() {
    let model = load("double-wishbone");
    let left = Moved::new(&model, Drive::ContactPatch, 40.0, 10.0);
    let right = Moved::new(&model.mirrored(), Drive::ContactPatch, 40.0, -10.0);
    let [x, y, z] = left.wheel_center();
    assert_near(&right.wheel_center(), &[x, -y, z], 1e-12);
    assert_near(&right.alignment(), &left.alignment(), 1e-10);
}

/// A model file with an architecture of its own, from `tests/fixtures/architectures`.
fn with_architecture(name: &str, points: &str) -> Model {
    let text = format!(
        "format = 1\nname = \"{name}\"\narchitecture = \"{name}.toml\"\naxes = \"iso8855\"\n\
         side = \"left\"\n[units]\nlength = \"mm\"\nangle = \"deg\"\n[points]\n{points}\n\
         [wheel]\nradius = 326.6\ntoe = 0.1\ncamber = -0.5\n"
    );
    let model = Model::parse("tests/fixtures/architectures/model.toml", &text);
    model.unwrap_or_else(|e| panic!("{}", e.render()))
}

/// Five rods guide the upright as two arms and a tie rod do.
#[test]
fn architectures_are_data() {
    let sedan = include_str!("../models/double-wishbone.toml");
    let from = sedan.find("[points]").unwrap() + "[points]".len();
    let to = sedan.find("[wheel]").unwrap();
    let rods = with_architecture("five-links", &sedan[from..to]);
    let arms = load("double-wishbone");
    for (travel, rack) in [(-100.0, 0.0), (60.0, 20.0), (0.0, -40.0)] {
        let a = Moved::new(&arms, Drive::ContactPatch, travel, rack);
        let b = Moved::new(&rods, Drive::ContactPatch, travel, rack);
        assert_near(&b.wheel_center(), &a.wheel_center(), 1e-12);
        assert_near(&b.alignment(), &a.alignment(), 1e-10);
    }
}

/// An arm on one hinge moves its wheel on a circle about that hinge, here parallel to y.
#[test]
fn trailing_arm_needs_neither_rack_nor_steer_axis() {
    let model = with_architecture(
        "trailing-arm",
        "arm_inner = [400.0, -10.0, 0.0]\narm_outer = [400.0, 600.0, 0.0]\n\
         wheel_center = [0.0, 700.0, 0.0]",
    );
    let moved = Moved::new(&model, Drive::WheelCenter, 240.0, 0.0);
    assert!(moved.suspension.rack.is_none() && moved.suspension.steer_axis.is_none());
    // A radius of 400 mm raised by 240 mm comes forward by 400 − 320 mm.
    assert_near(&moved.wheel_center(), &[0.08, 0.7, 0.24], 1e-12);
}

/// The upper point of the steer axis belongs to the chassis and stays where it is.
#[test]
fn strut_mount_is_the_top_of_the_steer_axis() {
    let model = with_architecture(
        "macpherson",
        "lca_front = [150.0, 350.0, -50.0]\nlca_rear = [-150.0, 350.0, -50.0]\n\
         lca_outer = [0.0, 700.0, -80.0]\nstrut_lower = [-5.0, 640.0, 150.0]\n\
         strut_top = [-30.0, 590.0, 540.0]\ntierod_inner = [-140.0, 330.0, 0.0]\n\
         tierod_outer = [-140.0, 680.0, -20.0]\nwheel_center = [0.0, 750.0, 0.0]",
    );
    for travel in [-60.0, 60.0] {
        let moved = Moved::new(&model, Drive::WheelCenter, travel, 5.0);
        let freedom = moved.system.freedom();
        assert!(freedom.is_exact(), "{freedom}");
        let axis = moved.suspension.steer_axis.unwrap();
        assert_eq!(axis.upper.1, BodyId::GROUND);
        assert_near(&moved.point(axis.upper), &[-0.03, 0.59, 0.54], 0.0);
        // The strut keeps pointing at its mount: its axis is fixed in the upright.
        let mechanism = &moved.suspension.mechanism;
        let lower = mechanism.point_named("strut_lower").unwrap();
        let lower = moved.point((lower, moved.suspension.wheel.body));
        let strut = [-0.025, -0.05, 0.39];
        let rotation = moved.system.rotation(moved.suspension.wheel.body);
        let turned = rotation.map(|r| r[0] * strut[0] + r[1] * strut[1] + r[2] * strut[2]);
        let to_mount = [-0.03 - lower[0], 0.59 - lower[1], 0.54 - lower[2]];
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let cross = turned[i] * to_mount[j] - turned[j] * to_mount[i];
            assert!(cross.abs() < 1e-12, "{travel} mm: {cross:e}");
        }
    }
}

#[test]
fn points_moved_onto_each_other_are_refused_by_name() {
    let mut model = load("double-wishbone");
    let front = model.point("lca_front").unwrap();
    model.set_point("lca_rear", front);
    let error = model.suspension(&Setup::default()).unwrap_err().to_string();
    assert!(error.contains("lca_pivot") && error.contains("lca_rear"), "{error}");
}
