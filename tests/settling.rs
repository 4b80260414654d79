//! The sedan settles on its tyre.

mod common;

use common::sedan::{quarter_car, sedan};
use hardpoint::solve::System;
use hardpoint::solve::dynamics::{Dynamics, Integrator, SettlePlan, Start};
use hardpoint::solve::equilibrium::Equilibrium;

/// Time, height of the wheel centre and displacement of the chassis of the reference.
fn reference() -> Vec<[f64; 3]> {
    let lines = include_str!("reference/sedan-settling.csv").lines();
    let rows = lines.filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    rows.map(|row| {
        let mut numbers = row.split(',').map(|number| number.parse().unwrap());
        std::array::from_fn(|_| numbers.next().unwrap())
    })
    .collect()
}

const HALF_MILLISECOND: f64 = 5e-4;

#[test]
fn a_quarter_car_follows_the_reference_within_a_micrometre() {
    let (car, chassis) = quarter_car();
    let (upright, wheel, released) = (car.upright, car.wheel_center, [car.travel]);
    let origin = car.mechanism.point_named("slide").unwrap();
    let system = System::new(car.mechanism).unwrap();
    let rows = reference();
    let errors = [HALF_MILLISECOND, 0.5 * HALF_MILLISECOND].map(|step| {
        let start = Start { released: &released, ..Start::default() };
        let mut motion = Dynamics::new(&system, &start, Integrator::fixed(step)).unwrap();
        let plan = SettlePlan { until: 5.0, interval: 0.01, rest: None };
        let trajectory = motion
            .settle(&plan, |now| {
                [now.point_position(upright, wheel)[2], now.point_position(chassis, origin)[2]]
            })
            .unwrap();
        assert_eq!((trajectory.samples.len(), &trajectory.stop), (501, &None));
        let energy = motion.energy();
        assert!(energy.drift.abs() < 1e-4 * energy.work.abs(), "{energy:?}");
        rows.iter().fold([0.0_f64; 2], |worst, [t, wheel, chassis]| {
            let (time, heights) = trajectory.samples[(t / 0.01).round() as usize];
            assert!((time - t).abs() < 1e-12);
            let errors = [heights[0] - wheel, heights[1] - chassis];
            std::array::from_fn(|k| worst[k].max(errors[k].abs()))
        })
    });
    for k in 0..2 {
        assert!(errors[0][k] < 1e-6, "{errors:?}");
        let ratio = errors[0][k] / errors[1][k];
        assert!((ratio - 4.0).abs() < 0.2, "{ratio} of {errors:?}");
    }
}

#[test]
fn adaptive_steps_settle_in_fewer_of_them() {
    let (car, _) = quarter_car();
    let (upright, wheel, released) = (car.upright, car.wheel_center, [car.travel]);
    let system = System::new(car.mechanism).unwrap();
    let start = Start { released: &released, ..Start::default() };
    let mut motion = Dynamics::new(&system, &start, Integrator::adaptive(1e-8)).unwrap();
    let worst = reference().iter().fold(0.0_f64, |worst, [t, height, _]| {
        motion.advance_to(*t).unwrap();
        worst.max((motion.point_position(upright, wheel)[2] - height).abs())
    });
    let steps = motion.report().steps;
    assert!(worst < 1e-6 && steps < 1200, "{worst:e} in {steps} steps");
}

/// The pose after five seconds and the pose of static equilibrium.
#[test]
fn after_five_seconds_the_fixed_car_stands_in_its_static_equilibrium() {
    let car = sedan(true);
    let (upright, wheel, released) = (car.upright, car.wheel_center, [car.travel]);
    let system = System::new(car.mechanism).unwrap();
    let start = Start { released: &released, ..Start::default() };
    let integrator = Integrator::fixed(HALF_MILLISECOND);
    let mut motion = Dynamics::new(&system, &start, integrator).unwrap();
    motion.advance_to(5.0).unwrap();
    let at = motion.point_position(upright, wheel);
    let expected = [-9.523906459998606e-06, 0.7980005181811466, -0.11879230494277743];
    let mut equilibrium = Equilibrium::released(&system, &released);
    equilibrium.find().unwrap();
    let fixed = equilibrium.loaded().point(upright, wheel);
    for k in 0..3 {
        assert!((at[k] - expected[k]).abs() < 1e-12, "{at:?}");
        assert!((at[k] - fixed[k]).abs() < 1e-12, "{at:?} {fixed:?}");
    }
}

#[test]
fn after_five_seconds_the_quarter_car_is_where_the_reference_is() {
    let (car, chassis) = quarter_car();
    let (upright, wheel, released) = (car.upright, car.wheel_center, [car.travel]);
    let origin = car.mechanism.point_named("slide").unwrap();
    let system = System::new(car.mechanism).unwrap();
    let start = Start { released: &released, ..Start::default() };
    let integrator = Integrator::fixed(HALF_MILLISECOND);
    let mut motion = Dynamics::new(&system, &start, integrator).unwrap();
    motion.advance_to(5.0).unwrap();
    let at = motion.point_position(upright, wheel);
    let expected = [-0.0002152465467039636, 0.7990158123473972, -0.1203556955916569];
    for k in 0..3 {
        assert!((at[k] - expected[k]).abs() < 1e-10, "{at:?}");
    }
    let sunk = motion.point_position(chassis, origin)[2];
    assert!((sunk + 0.019377286210049978).abs() < 1e-10, "{sunk}");
    // It still swings by a tenth of a micrometre: the paper's B − A.
    let mut equilibrium = Equilibrium::released(&system, &released);
    equilibrium.find().unwrap();
    let fixed = equilibrium.loaded().point(upright, wheel);
    let difference = (0..3).map(|k| (at[k] - fixed[k]).abs()).fold(0.0, f64::max);
    assert!(difference < 1e-6 && difference > 1e-8, "{difference:e}");
}
