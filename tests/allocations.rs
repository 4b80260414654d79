//! The solve loop does not allocate.

mod common;

use common::sedan::quarter_car;
use common::{TieRod, double_wishbone};
use hardpoint::solve::System;
use hardpoint::solve::dynamics::{Dynamics, Integrator, Start};
use hardpoint::solve::equilibrium::Equilibrium;

#[test]
fn a_sweep_does_not_allocate_after_its_first_pass() {
    for tie_rod in [TieRod::Universal, TieRod::Spherical] {
        let car = double_wishbone(tie_rod, |p| p, |v| v).unwrap();
        let mut system = System::new(car.mechanism).unwrap();
        let mut sweep = || {
            for step in -13..=13 {
                system.move_to(&[(car.travel, 0.01 * f64::from(step))]).unwrap();
            }
        };
        // The factors find their size in the first pass.
        sweep();
        let counted = allocation_counter::measure(sweep);
        assert_eq!(counted.count_total, 0);
    }
}

#[test]
fn an_equilibrium_step_does_not_allocate_after_the_first() {
    let car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let system = System::new(car.mechanism).unwrap();
    let mut equilibrium = Equilibrium::new(&system);
    equilibrium.load_mut()[1] = 1.0;
    assert!(equilibrium.newton_step());
    let counted = allocation_counter::measure(|| {
        equilibrium.newton_step();
    });
    assert_eq!(counted.count_total, 0);
}

#[test]
fn a_motion_does_not_allocate_after_its_first_steps() {
    let (car, _) = quarter_car();
    let released = [car.travel];
    let system = System::new(car.mechanism).unwrap();
    let start = Start { released: &released, ..Start::default() };
    for integrator in [Integrator::fixed(1e-3), Integrator::adaptive(1e-7)] {
        let mut motion = Dynamics::new(&system, &start, integrator).unwrap();
        motion.advance_to(0.1).unwrap();
        let counted = allocation_counter::measure(|| motion.advance_to(1.0).unwrap());
        assert_eq!(counted.count_total, 0);
    }
}
