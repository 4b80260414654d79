//! Wheels that the rig holds by forces, grids of events, and cases.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;

use axles::{axle, close, load};
use hardpoint::model::{Drive, LoadCases, Model, Setup, Side};
use hardpoint::rig::{
    Axle, Corner, Event, Held, Hold, LoadPoint, Pose, Row, Specimen, Supports, Sweep, SweepPlan,
    Target, Vertical,
};
use hardpoint::solve::StopReason;

fn on_rig(model: &Model, setup: &Setup) -> Axle {
    Axle::with_loads(model, setup, LoadPoint::ContactPatch).unwrap()
}

fn run(axle: &mut Axle, event: Event, [from, to]: [f64; 2], held: Held) -> Vec<Row> {
    axle.reset();
    let plan = SweepPlan { event, from, to, step: (to - from) / 4.0, held };
    let sweep = Sweep::run(axle, &plan, |_| {});
    assert!(sweep.stops.is_empty(), "{event:?}: {:?}", sweep.stops);
    assert_eq!(sweep.rows.len(), 5);
    sweep.rows
}

fn forces(row: &Row) -> [f64; 2] {
    [row.poses[0], row.poses[1]].map(|pose| pose.load.unwrap().force)
}

fn travels(row: &Row) -> [f64; 2] {
    [row.poses[0], row.poses[1]].map(|pose| pose.travel)
}

/// Every event of wheels that forces hold; what travels hold with the forces that were found is the same state.
#[test]
fn forces_hold_wheels_in_every_event() {
    for setup in [
        Setup::default(),
        Setup { kinematic: true, ..Setup::default() },
        Setup::from(Drive::ContactPatch),
    ] {
        let mut axle = on_rig(&axle(&[]), &setup);
        let held = Held { travel: 0.005, rack: 0.002, ..Held::default() };
        let at_rest = Supports::find(&mut axle, &held).unwrap().wheels;
        let change = Held { vertical: Vertical::ForceChange(at_rest), ..held };
        let force = Held { vertical: Vertical::Force(at_rest), ..held };
        type Expected = fn(f64, [f64; 2]) -> [f64; 2];
        let events: [(Event, [f64; 2], Held, Expected); 7] = [
            (Event::Travel, [2000.0, 5000.0], force, |f, _| [f, f]),
            (Event::Travel, [-1500.0, 1500.0], change, |f, [l, r]| [l + f, r + f]),
            (Event::Opposite, [-1000.0, 1000.0], force, |f, [l, r]| [l + f, r - f]),
            (Event::Single(Side::Left), [3000.0, 5000.0], force, |f, [_, r]| [f, r]),
            (Event::Single(Side::Right), [-800.0, 800.0], change, |f, [l, r]| [l, r + f]),
            (Event::Steer, [-0.03, 0.03], force, |_, forces| forces),
            (Event::LoadOpposed(1), [-1500.0, 1500.0], force, |_, forces| forces),
        ];
        for (event, range, held, expected) in events {
            let rows = run(&mut axle, event, range, held);
            for row in &rows {
                let expected = expected(row.value, at_rest);
                let (found, travel) = (forces(row), travels(row));
                for side in 0..2 {
                    let at = format!("{event:?} at {}", row.value);
                    close(&at, found[side], expected[side], 1e-9 * expected[side]);
                }
                // Where joints hold the wheel, a step of the force takes a few steps of its travel.
                let few = !setup.kinematic || row.iterations < 60;
                assert!(few, "{} iterations in {event:?}", row.iterations);
                // Not a step that stayed where it was.
                assert!(row.value == 0.0 || travel != [0.005; 2], "{event:?} at {}", row.value);
            }
            // Back by the travels.
            let last = rows.last().unwrap();
            let plan = SweepPlan { event, from: last.value, to: last.value, step: 0.0, held };
            let wheels = travels(last).map(Hold::Value);
            axle.go_to(&Target { wheels, ..plan.target(last.value) }).unwrap();
            let again = axle.supports().wheels;
            for side in 0..2 {
                close("back", again[side], forces(last)[side], 1e-7 * again[side]);
            }
        }
    }
}

/// A corner finds the travel of a force that it carried before.
#[test]
fn a_corner_is_held_by_its_force() {
    let model = axle(&[]);
    let mut corner = Corner::new(&model, &Setup::default()).unwrap();
    corner.move_to(0.03, 0.0).unwrap();
    let force = corner.pose().load.unwrap().force;
    corner.reset();
    corner.hold(Hold::Force(force), 0.0).unwrap();
    close("travel", corner.pose().travel, 0.03, 1e-12);
}

/// A force that no position carries is told with the name of the wheel; the last position stays.
#[test]
fn forces_out_of_reach_are_told() {
    let mut corner = Corner::new(&axle(&[]), &Setup::default()).unwrap();
    corner.hold(Hold::Force(7000.0), 0.0).unwrap();
    let stop = corner.hold(Hold::Force(12000.0), 0.0).unwrap_err();
    assert!(matches!(stop.reason, StopReason::NoForce(..)), "{stop}");
    assert!(stop.to_string().contains("N at travel on the way to 12000 N"), "{stop}");
    let StopReason::NoForce(carried, _) = &stop.reason else { panic!("{stop}") };
    assert!((6999.0..12000.0).contains(&carried[0].force), "{stop}");
    // Without forces there is none to hold.
    let text = include_str!("../models/lotus-front.toml");
    let model = Model::parse("models/lotus-front.toml", text).unwrap();
    let mut corner = Corner::new(&model, &Setup::default()).unwrap();
    let stop = corner.hold(Hold::Force(1000.0), 0.0).unwrap_err();
    assert!(stop.to_string().contains("stopped at 0 N at travel"), "{stop}");
}

/// A grid has the states of its plans in their order, and a stop in one leaves the others.
#[test]
fn grids_go_on_after_a_stop() {
    let model = axle(&[]);
    let mut both = on_rig(&model, &Setup { kinematic: true, ..Setup::default() });
    let plan = |from: f64, rack: f64| {
        let held = Held { rack, ..Held::default() };
        let plan = SweepPlan { event: Event::Travel, from, to: 0.04, step: 0.04, held };
        (format!("rack {rack}"), plan)
    };
    let plans = [plan(-0.04, 0.01), plan(-0.8, -0.01), plan(-0.04, -0.01)];
    let grid = Sweep::grid(&mut both, &plans, |_| {});
    assert_eq!(grid.stops.len(), 1, "{:?}", grid.stops);
    assert!(grid.stops[0].to_string().starts_with("rack -0.01: stopped at left_travel"));
    assert_eq!(grid.planned, 3 + 22 + 3);
    let one = Sweep::run(
        &mut on_rig(&model, &Setup { kinematic: true, ..Setup::default() }),
        &plans[2].1,
        |_| {},
    );
    let last = &grid.rows[grid.rows.len() - 3..];
    for (row, expected) in last.iter().zip(&one.rows) {
        assert_eq!(row.value, expected.value);
        let (found, expected) = (row.poses[0], expected.poses[0]);
        close("rack", found.rack, -0.01, 1e-15);
        (0..3).for_each(|k| close("W", found.wheel.center[k], expected.wheel.center[k], 1e-12));
    }
}

/// Each case is what the rig does when it is told the same by hand, whatever was before it.
#[test]
fn cases_are_independent_states() {
    let model = axle(&[]);
    let text = "name,left_fx,fy,travel,right_travel_mm,rack\n";
    assert!(LoadCases::parse("cases.csv", &format!("{text}a,1,2,3,4,5\n"), &model, true).is_err());
    let text = "name,left_fx,fy,left_travel,right_travel_mm,right_wheel_force,rack\n\
                braking,-2000,,20,10,,\n\
                far,,,900,,,\n\
                cornering,,1500,,,3000,5\n\
                braking again,-2000,,20,10,,\n";
    let cases = LoadCases::parse("cases.csv", text, &model, true).unwrap();
    let targets = Target::of_cases(&cases, &Held::default());
    let mut axle = on_rig(&model, &Setup::default());
    let sweep = Sweep::cases(&mut axle, &targets, |_| {});
    assert_eq!(sweep.planned, 4);
    assert_eq!(
        sweep.rows.iter().map(|row| row.case).collect::<Vec<_>>(),
        [Some(0), Some(2), Some(3)]
    );
    assert_eq!(sweep.stops.len(), 1);
    assert!(sweep.stops[0].to_string().starts_with("far: "), "{}", sweep.stops[0]);
    // The order of elimination may have changed between, and with it rounding.
    let same = |found: &Pose<f64>, expected: &Pose<f64>| {
        for (found, expected) in
            [(found.wheel.center, expected.wheel.center), (found.wheel.spin, expected.wheel.spin)]
        {
            (0..3).for_each(|k| close("wheel", found[k], expected[k], 1e-13));
        }
    };
    (0..2).for_each(|k| same(&sweep.rows[0].poses[k], &sweep.rows[2].poses[k]));

    axle.reset();
    axle.set_load(&[load(&[("fx", -2000.0)]), load(&[])]);
    axle.move_to([0.02, 0.01], 0.0).unwrap();
    same(&sweep.rows[0].poses[0], &axle.pose(Side::Left));
    let cornering = &sweep.rows[1];
    close("force", forces(cornering)[1], 3000.0, 1e-6);
    close("travel", travels(cornering)[0], 0.0, 0.0);
    close("rack", cornering.poses[0].rack, 0.005, 1e-15);
}
