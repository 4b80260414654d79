//! How bodies move per unit of a driver: derivatives from the factorisation.

mod common;

use common::{TieRod, difference, double_wishbone, sedan};
use hardpoint::mechanism::{
    BodyId, Direction, DriverId, DriverKind, JointKind, Mechanism, PointId,
};
use hardpoint::solve::equilibrium::Equilibrium;
use hardpoint::solve::{System, Twist};
use hardpoint::vector::cross;

/// The twist of a body by a driver, from states on both sides: central differences of the way of
/// a point and of the rotation, by Richardson to the fourth order.
fn by_differences(system: &mut System, driver: DriverId, body: BodyId, point: PointId) -> Twist {
    let middle = system.driver_value(driver);
    let rotation = system.rotation(body);
    let position = system.point_position(body, point);
    let mut slope = |h: f64| {
        let mut at = |value: f64| {
            system.move_to(&[(driver, value)]).unwrap();
            (system.point_position(body, point), system.rotation(body))
        };
        let (ahead, behind) = (at(middle + h), at(middle - h));
        let velocity: [f64; 3] = std::array::from_fn(|k| (ahead.0[k] - behind.0[k]) / (2.0 * h));
        // ω̃ = Ṙ Rᵀ.
        let rate = |i: usize, j: usize| -> f64 {
            (0..3).map(|k| (ahead.1[i][k] - behind.1[i][k]) / (2.0 * h) * rotation[j][k]).sum()
        };
        [velocity, [rate(2, 1), rate(0, 2), rate(1, 0)]]
    };
    let (wide, narrow) = (slope(4e-4), slope(2e-4));
    let better = |k: usize, c: usize| (4.0 * narrow[k][c] - wide[k][c]) / 3.0;
    let [velocity, omega]: [[f64; 3]; 2] =
        std::array::from_fn(|k| std::array::from_fn(|c| better(k, c)));
    system.move_to(&[(driver, middle)]).unwrap();
    let to_origin = cross(omega, position);
    Twist { velocity: std::array::from_fn(|k| velocity[k] - to_origin[k]), rotation: omega }
}

/// All bodies, both drivers, also where a tie rod may spin and where equations are left out.
#[test]
fn tangents_are_the_slopes_of_the_motion() {
    for tie_rod in [TieRod::Universal, TieRod::Spherical] {
        let car = double_wishbone(tie_rod, |p| p, |v| v).unwrap();
        let point = car.wheel_center;
        let mut system = System::new(car.mechanism).unwrap();
        for (travel, rack) in [(0.0, 0.0), (0.08, -0.01), (-0.11, 0.02)] {
            system.move_to(&[(car.travel, travel), (car.steer, rack)]).unwrap();
            for driver in [car.travel, car.steer] {
                let upright = system.tangent(driver).unwrap().twist(car.upright);
                let center = system.point_position(car.upright, point);
                let up = if driver == car.travel { 1.0 } else { 0.0 };
                assert!((upright.at(center)[2] - up).abs() < 1e-14, "the drivers are kept");
                let bodies: Vec<BodyId> = system.mechanism().body_ids().collect();
                for body in bodies {
                    let found = system.tangent(driver).unwrap().twist(body);
                    let expected = by_differences(&mut system, driver, body, point);
                    // The spin of a tie rod is not determined; its differences depend on the way.
                    let spins = tie_rod == TieRod::Spherical
                        && system.mechanism().bodies()[body.index()].name == "tierod";
                    if !spins {
                        let error = difference(&found.velocity, &expected.velocity)
                            .max(difference(&found.rotation, &expected.rotation));
                        assert!(error < 1e-9, "{travel} {rack} {body:?}: {error:e}");
                    }
                }
            }
        }
    }
}

/// A slider crank against its closed form, also where the crank stands across.
#[test]
fn slider_crank_has_its_closed_form() {
    let mut m = Mechanism::new("ground");
    let [o, a, b] = [("o", 0.0), ("a", 1.0), ("b", 3.0)]
        .map(|(name, x)| m.add_point(name, [x, 0.0, 0.0]).unwrap());
    let axis = Direction::Fixed([0.0, 1.0, 0.0]);
    let [crank, rod] = ["crank", "rod"].map(|name| m.add_body(name, [0.0; 3]).unwrap());
    let revolute = |at| JointKind::Revolute { at, axis };
    m.add_joint("main", BodyId::GROUND, crank, revolute(o)).unwrap();
    m.add_joint("big_end", crank, rod, revolute(a)).unwrap();
    // The small end slides along x without turning out of the plane.
    let kind = JointKind::InPlane { at: b, normal: Direction::Fixed([0.0, 0.0, 1.0]) };
    m.add_joint("slide", BodyId::GROUND, rod, kind).unwrap();
    let turn = m.add_driver("turn", BodyId::GROUND, crank, DriverKind::Rotation { axis }).unwrap();
    let mut system = System::new(m).unwrap();
    let quarter = std::f64::consts::FRAC_PI_2;
    system.move_to(&[(turn, 0.3)]).unwrap();
    // The crank's pin at (cos, −sin), the rod's end at 2 beyond it: closed form of the slider.
    let end = system.tangent(turn).unwrap().twist(rod).at(system.point_position(rod, b));
    let (sin, cos) = 0.3_f64.sin_cos();
    let slope = -sin - sin * cos / (4.0 - sin * sin).sqrt();
    assert!((end[0] - slope).abs() < 1e-13, "{end:?} instead of {slope}");
    assert!(end[2].abs() < 1e-13);
    system.move_to(&[(turn, quarter)]).unwrap();
    let end = system.tangent(turn).unwrap().twist(rod).at(system.point_position(rod, b));
    assert!((end[0] + 1.0).abs() < 1e-13, "{end:?}");
}

/// With rigid joints the tangent of an equilibrium is that of the joints, whatever the springs.
#[test]
fn springs_do_not_matter_where_joints_determine_the_motion() {
    let car = sedan::sedan(false);
    let mut system = System::new(car.mechanism).unwrap();
    system.move_to(&[(car.travel, 0.05)]).unwrap();
    let mut equilibrium = Equilibrium::new(&system);
    equilibrium.find().unwrap();
    for driver in [car.travel, car.steer] {
        let kinematic = system.tangent(driver).unwrap();
        let elastic = equilibrium.driver_tangent(driver).unwrap().motion;
        assert_eq!(kinematic.twist(BodyId::GROUND), Twist::default());
        let (a, b) = (kinematic.twist(car.upright), elastic.twist(car.upright));
        assert!(difference(&a.velocity, &b.velocity) < 1e-11);
        assert!(difference(&a.rotation, &b.rotation) < 1e-11);
    }
}

/// A tangent is a result of the state, not of the way to it, and costs no allocation.
#[test]
fn tangents_do_not_depend_on_the_way_and_do_not_allocate() {
    let car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let mut system = System::new(car.mechanism).unwrap();
    let mut twist = |way: &[f64]| {
        for &travel in way {
            system.move_to(&[(car.travel, travel)]).unwrap();
        }
        system.tangent(car.travel).unwrap().twist(car.upright)
    };
    let (a, b) = (twist(&[0.02, 0.06]), twist(&[-0.09, 0.1, 0.06]));
    assert!(difference(&a.velocity, &b.velocity) < 1e-13);
    assert!(difference(&a.rotation, &b.rotation) < 1e-13);
    let counted = allocation_counter::measure(|| {
        system.move_to(&[(car.travel, 0.05)]).unwrap();
        system.tangent(car.travel).unwrap();
        system.tangent(car.steer).unwrap();
    });
    assert_eq!(counted.count_total, 0);
}
