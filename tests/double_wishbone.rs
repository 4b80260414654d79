//! The whole way from hard points to wheel positions, against 50-digit references.

mod common;
#[path = "common/sedan.rs"]
mod sedan;

use common::{TieRod, difference, double_wishbone};
use hardpoint::solve::System;

#[test]
fn travel_agrees_with_the_reference_in_three_iterations_a_point() {
    let car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let mut system = System::new(car.mechanism).unwrap();
    assert!(system.freedom().is_exact(), "{}", system.freedom());
    assert_eq!(system.freedom().degrees_of_freedom, 2);
    for (index, (travel, center, rotation)) in sedan::TRAVEL.iter().enumerate() {
        let report = system.move_to(&[(car.travel, travel * 1e-3)]).unwrap();
        if index > 0 {
            assert!(report.iterations <= 3, "{travel} mm: {report:?}");
            assert_eq!(report.steps, 1, "{travel} mm: {report:?}");
        }
        assert!(report.relative_residual <= 1e-12, "{travel} mm: {report:?}");
        let position = difference(&system.point_position(car.upright, car.wheel_center), center);
        assert!(position < 1e-13, "{travel} mm: {position:e} m");
        let turned = system.rotation(car.upright);
        let angle = difference(turned.as_flattened(), rotation.as_flattened());
        assert!(angle < 1e-12, "{travel} mm: {angle:e} rad");
    }
}

#[test]
fn steering_agrees_with_the_reference() {
    let car = double_wishbone(TieRod::Universal, |p| p, |v| v).unwrap();
    let mut system = System::new(car.mechanism).unwrap();
    for (rack, center, rotation) in &sedan::STEER {
        let report = system.move_to(&[(car.steer, rack * 1e-3)]).unwrap();
        assert!(report.relative_residual <= 1e-12, "{rack} mm: {report:?}");
        let position = difference(&system.point_position(car.upright, car.wheel_center), center);
        assert!(position < 1e-13, "{rack} mm: {position:e} m");
        let turned = system.rotation(car.upright);
        let angle = difference(turned.as_flattened(), rotation.as_flattened());
        assert!(angle < 1e-12, "{rack} mm: {angle:e} rad");
    }
}
