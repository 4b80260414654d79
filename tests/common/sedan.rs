//! The sedan's suspension with masses, spring and tyre.

use hardpoint::mechanism::{
    BodyId, Contact, Curve, Direction, ForceKind, JointKind, Law, MassProperties, Mechanism,
    Reference,
};

use super::{DoubleWishbone, TieRod, double_wishbone, suspend};

/// Mass, centre of mass and moments of inertia about it, in ISO 8855 axes.
const MASSES: [(&str, f64, [f64; 3], [f64; 6]); 4] = [
    ("lca", 4.2, [0.0048, 0.6112, -0.2932], [0.03, 0.042, 0.072, 0.0, 0.0, 0.0]),
    ("uca", 2.1, [-0.1083, 0.5972, 0.1063], [0.012, 0.0039, 0.0157, 0.0, 0.0, 0.0]),
    ("upright", 38.0, [-0.006, 0.775, -0.118], [0.85, 1.3, 0.85, 0.0, 0.0, 0.0]),
    // A uniform rod along (0.05, 0.35, 0) m with 2e-4 kg m² about its own axis.
    ("tierod", 0.8, [-0.175, 0.595, -0.12], TIE_ROD),
];

/// J = J_t (1 − u uᵀ) + J_a u uᵀ with J_t = m l² ∕ 12 and u = (1, 7, 0) ∕ √50.
const TIE_ROD: [f64; 6] = {
    let (transverse, axial) = (0.8 * 0.125 / 12.0, 2e-4);
    let less = (transverse - axial) / 50.0;
    [transverse - less, transverse - 49.0 * less, transverse, -7.0 * less, 0.0, 0.0]
};

/// The sedan on a fixed chassis, with its tyre if asked for.
pub fn sedan(tyre: bool) -> DoubleWishbone {
    placed_sedan(tyre, |p| p, |v| v)
}

/// The same with its points moved by `place`, a rigid motion that keeps heights, and vectors turned
/// by `turn`.
pub fn placed_sedan(
    tyre: bool,
    place: impl Fn([f64; 3]) -> [f64; 3] + Copy,
    turn: impl Fn([f64; 3]) -> [f64; 3],
) -> DoubleWishbone {
    let car = double_wishbone(TieRod::Universal, place, turn).unwrap();
    loaded(car, BodyId::GROUND, tyre, place)
}

/// A quarter of the sedan: 380 kg of chassis on a vertical slide, the tyre on the ground.
pub fn quarter_car() -> (DoubleWishbone, BodyId) {
    let mut m = Mechanism::new("ground");
    let chassis = m.add_body("chassis", [0.0; 3]).unwrap();
    let inertia = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    m.set_mass(chassis, MassProperties { mass: 380.0, center: [0.0; 3], inertia }).unwrap();
    let at = m.add_point("slide", [0.0; 3]).unwrap();
    let axis = Direction::Fixed([0.0, 0.0, 1.0]);
    m.add_joint("slide", BodyId::GROUND, chassis, JointKind::Translational { at, axis }).unwrap();
    let car = suspend(m, chassis, TieRod::Universal, |p| p, |v| v).unwrap();
    (loaded(car, chassis, true, |p| p), chassis)
}

fn loaded(
    mut car: DoubleWishbone,
    chassis: BodyId,
    tyre: bool,
    place: impl Fn([f64; 3]) -> [f64; 3],
) -> DoubleWishbone {
    let m = &mut car.mechanism;
    m.set_gravity([0.0, 0.0, -9.81]).unwrap();
    for (name, mass, center, inertia) in MASSES {
        let body = m.body_named(name).unwrap();
        let center = place(center);
        m.set_mass(body, MassProperties { mass, center, inertia }).unwrap();
    }
    let on_i = m.add_point("spring_upper", place([-0.04, 0.52, 0.23])).unwrap();
    let on_j = m.add_point("spring_lower", place([0.0, 0.62, -0.27])).unwrap();
    let lca = m.body_named("lca").unwrap();
    let law = Law { viscous: Curve::Linear(6000.0), ..Law::spring(70_000.0) };
    let reference = Reference::Length(0.605);
    let spring = ForceKind::Line { on_i, on_j, reference, law };
    m.add_force("spring", chassis, lca, spring).unwrap();
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
