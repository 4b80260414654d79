//! A double wishbone at the ends of its travel and under targets without meaning.

mod common;

use common::{TieRod, difference, double_wishbone};
use hardpoint::solve::System;

#[test]
fn the_end_of_travel_does_not_depend_on_a_spinning_tie_rod() {
    let ends = [TieRod::Universal, TieRod::Spherical].map(|tie_rod| {
        let car = double_wishbone(tie_rod, |p| p, |v| v).unwrap();
        let mut system = System::new(car.mechanism).unwrap();
        [0.9, -0.9].map(|target| {
            let stop = system.move_to(&[(car.travel, target)]).unwrap_err();
            let message = stop.to_string();
            assert!(message.starts_with("stopped at travel = "), "{message}");
            assert!(message.contains("nearest to singular is uca_outer"), "{message}");
            assert!(message.contains("lca turns about the line lca_front–lca_rear"), "{message}");
            // The state is the one that was reached, on the branch of the design position.
            let reached = system.driver_value(car.travel);
            let height = system.point_position(car.upright, car.wheel_center)[2];
            assert!((height - (-0.1199 + reached)).abs() < 1e-12);
            system.move_to(&[(car.travel, 0.0)]).unwrap();
            let rotation = system.rotation(car.upright);
            assert!((rotation[0][0] - 1.0).abs() < 1e-12);
            reached
        })
    });
    assert!(difference(&ends[0], &ends[1]) < 1e-8, "{ends:?}");
}

#[test]
fn a_target_that_is_no_number_is_refused_and_changes_nothing() {
    let car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let mut system = System::new(car.mechanism).unwrap();
    system.move_to(&[(car.travel, 0.02)]).unwrap();
    let before = system.state().to_vec();
    let stop = system.move_to(&[(car.travel, f64::NAN)]).unwrap_err();
    assert!(stop.to_string().contains("driver travel was given a value"), "{stop}");
    assert_eq!(system.state(), before);
    system.move_to(&[(car.steer, 0.01)]).unwrap();
    assert_eq!(system.driver_value(car.travel), 0.02);
}

#[test]
fn systems_can_be_sent_to_other_threads() {
    fn sent<T: Send>() {}
    sent::<System>();
}
