//! Static equilibria with springs, tyres and weights against independent solutions.

mod common;

use common::{DoubleWishbone, TieRod, double_wishbone};
use hardpoint::mechanism::{
    Acts, BodyId, Contact, Curve, Direction, ForceKind, JointKind, Law, MassProperties, Mechanism,
    Reference,
};
use hardpoint::solve::equilibrium::Equilibrium;
use hardpoint::solve::{StaticFailure, System};

/// Mass and centre of mass of the sedan's bodies; inertias do not matter here.
const MASSES: [(&str, f64, [f64; 3]); 4] = [
    ("lca", 4.2, [0.0048, 0.6112, -0.2932]),
    ("uca", 2.1, [-0.1083, 0.5972, 0.1063]),
    ("upright", 38.0, [-0.006, 0.775, -0.118]),
    ("tierod", 0.8, [-0.175, 0.595, -0.12]),
];

/// The sedan's suspension with its masses, its spring and its tyre, the chassis fixed.
fn sedan(tyre: bool) -> DoubleWishbone {
    let mut car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let m = &mut car.mechanism;
    m.set_gravity([0.0, 0.0, -9.81]).unwrap();
    for (name, mass, center) in MASSES {
        let body = m.body_named(name).unwrap();
        m.set_mass(body, MassProperties { mass, center, inertia: [0.0; 6] }).unwrap();
    }
    let on_i = m.add_point("spring_upper", [-0.04, 0.52, 0.23]).unwrap();
    let on_j = m.add_point("spring_lower", [0.0, 0.62, -0.27]).unwrap();
    let lca = m.body_named("lca").unwrap();
    let law = Law { viscous: Curve::Linear(6000.0), ..Law::spring(70_000.0) };
    let reference = Reference::Length(0.605);
    let spring = ForceKind::Line { on_i, on_j, reference, law };
    m.add_force("spring", BodyId::GROUND, lca, spring).unwrap();
    if tyre {
        let kind = ForceKind::Tyre {
            contact: Contact::Center(car.wheel_center),
            free_radius: 0.3266,
            ground: -0.428,
            law: Law::spring(220_000.0),
        };
        m.add_force("tyre", BodyId::GROUND, car.upright, kind).unwrap();
    }
    car
}

/// Sedan on a fixed chassis: independent minimal-coordinate solution, 50-digit kinematics.
#[test]
fn the_sedan_stands_on_its_tyre() {
    let car = sedan(true);
    let wheel = (car.upright, car.wheel_center);
    let mut system = System::new(car.mechanism).unwrap();
    let mut equilibrium = Equilibrium::released(&system, &[car.travel]);
    let report = equilibrium.find().unwrap();
    println!("{report:?}");
    let at = equilibrium.loaded().point(wheel.0, wheel.1);
    let expected = [-9.523906459998993e-06, 0.7980005181811466, -0.11879230494277739];
    for k in 0..3 {
        assert!((at[k] - expected[k]).abs() < 1e-12, "{at:?}");
    }
    let forces = equilibrium.elements().responses();
    println!("{} {}", forces[0].force, forces[1].force);
    assert!((forces[0].force + 6587.479673434271).abs() < 1e-6);
    assert!((forces[1].force + 3826.307087411026).abs() < 1e-6);
    system.reset();
}
