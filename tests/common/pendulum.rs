//! A pendulum, for tests of motion.

use hardpoint::mechanism::{BodyId, Direction, JointKind, MassProperties, Mechanism, PointId};
use hardpoint::solve::System;
use hardpoint::solve::dynamics::{Dynamics, DynamicsFailure, Integrator, Start};

pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
pub const X: Direction = Direction::Fixed([1.0, 0.0, 0.0]);
pub const Y: Direction = Direction::Fixed([0.0, 1.0, 0.0]);
pub const Z: Direction = Direction::Fixed([0.0, 0.0, 1.0]);

/// A mechanism that begins to move as it states.
pub fn dynamics(
    mechanism: &Mechanism,
    integrator: Integrator,
) -> Result<Dynamics, DynamicsFailure> {
    let system = System::new(mechanism.clone()).unwrap();
    Dynamics::new(&system, &Start::default(), integrator)
}

/// The largest difference of two vectors.
pub fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max)
}

/// IFToMM A01: a point mass of 1 kg on a massless rod of 1 m that turns about y, released level.
pub fn pendulum() -> (Mechanism, BodyId, PointId) {
    let mut m = Mechanism::new("ground");
    m.set_gravity(GRAVITY).unwrap();
    let rod = m.add_body("rod", [0.0; 3]).unwrap();
    let pin = m.add_point("pin", [0.0; 3]).unwrap();
    let bob = m.add_point("bob", [-1.0, 0.0, 0.0]).unwrap();
    m.add_joint("hinge", BodyId::GROUND, rod, JointKind::Revolute { at: pin, axis: Y }).unwrap();
    let mass = MassProperties { mass: 1.0, center: [-1.0, 0.0, 0.0], inertia: [0.0; 6] };
    m.set_mass(rod, mass).unwrap();
    (m, rod, bob)
}

/// T = 4 K(sin ½θ₀) √(L/g) with θ₀ = ½π, L = 1 m and g = 9.81 m/s².
pub const PERIOD: f64 = 2.3678419475762;
