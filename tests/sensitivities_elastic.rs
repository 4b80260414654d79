//! Derivatives of factors of compliant suspensions against models made anew.

#[path = "common/varying.rs"]
mod varying;

use hardpoint::model::{Chassis, Setup};
use hardpoint::rig::{Axle, Hold, Specimen as _, Target};

use varying::{Case, check};

#[test]
fn bushed_corners_have_the_derivatives_of_models_made_anew() {
    check(&Case::new("compliant-corner"), 10);
    let pushed = [900.0, -700.0, 300.0, 5.0, -20.0, 30.0];
    check(&Case::new("compliant-corner").at(0.0, 12.0, 3.0).loaded([0.0; 6], pushed), 8);
    check(&Case::new("bushed-double-wishbone").at(-15.0, 0.0, 4.0).loaded(pushed, [0.0; 6]), 12);
}

#[test]
fn an_axle_with_an_anti_roll_bar_has_them() {
    let loads = [[-800.0, 600.0, 0.0, 0.0, 0.0, 25.0], [500.0, 900.0, 0.0, 0.0, 10.0, 0.0]];
    check(&Case::axle("sedan-axle").at(18.0, -11.0, 5.0).loaded(loads[0], loads[1]), 10);
}

#[test]
fn a_twist_beam_has_them() {
    check(&Case::axle("twist-beam").at(20.0, -14.0, 0.0), 12);
}

/// Tables, stops, preloads, whose numbers are those of the file, on either side.
#[test]
fn laws_of_all_kinds_have_them() {
    let more = "
[[forces]]
name = \"progressive\"
kind = \"spring\"
between = [\"chassis\", \"lca\"]
on = [\"spring_upper\", \"spring_lower\"]
table = [[-10.0, -300.0], [0.0, 0.0], [50.0, 900.0], [100.0, 2600.0], [150.0, 5200.0]]
free_length = 520.0

[[forces]]
name = \"bump_stop\"
kind = \"bump-stop\"
between = [\"chassis\", \"lca\"]
on = [\"spring_upper\", \"spring_lower\"]
clearance = 2.0
table = [[0.0, 60.0], [5.0, 190.0], [10.0, 700.0], [30.0, 4000.0]]

[[forces]]
name = \"rebound_stop\"
kind = \"rebound-stop\"
between = [\"chassis\", \"lca\"]
on = [\"spring_upper\", \"spring_lower\"]
clearance = -25.0
stiffness = 30.0

[[forces]]
name = \"actuator\"
kind = \"actuator\"
between = [\"chassis\", \"uca\"]
on = [\"spring_upper\", \"uca_outer\"]
force = 250.0

[[forces]]
name = \"torsion_bar\"
kind = \"torsion-spring\"
between = [\"chassis\", \"uca\"]
axis = [\"uca_rear\", \"uca_front\"]
stiffness = 9000.0
preload = 20000.0
";
    let tables = "stiffness = [600.0, 0.0, 4000.0]
preload = [50.0, -80.0, 30.0]
rotational_preload = [900.0, -1200.0, 700.0]
tables = { y = [[-2.0, -4000.0], [-0.5, -1500.0], [1.0, 2600.0], [3.0, 9000.0]], rz = [[-3.0, -15000.0], [0.5, 1800.0], [4.0, 21000.0]] }
rotational_stiffness = [1220.0, 3490.0, 0.0]";
    let case = |case: Case| {
        let plain = "stiffness = [600.0, 2500.0, 4000.0]
rotational_stiffness = [1220.0, 3490.0, 4540.0]";
        case.with(plain, tables).and(more)
    };
    check(&case(Case::new("sedan-axle")).at(16.0, 0.0, -3.0), 24);
    check(&case(Case::axle("sedan-axle")).at(16.0, 9.0, -3.0), 30);
}

#[test]
fn forces_across_an_axle_and_a_subframe_have_them() {
    check(&Case::axle("subframe-axle").at(7.0, -5.0, 2.0), 10);
    check(&Case::new("subframe-axle").at(7.0, 0.0, 2.0), 8);
}

#[test]
fn a_chassis_that_rolls_on_springs_has_them() {
    let rolls = |s: &mut Setup| s.chassis = Chassis::Roll { axis: 0.05 };
    let case = Case::axle("sedan-axle").with_setup(rolls).at(8.0, 3.0, 2.0);
    check(&case.with_target(|t| t.roll = 0.02), 8);
}

/// Wheels held by forces go where they have them again, and so does a body that is held by one.
#[test]
fn wheels_and_a_body_that_forces_hold_have_them() {
    let forces = |case: Case, left: f64, right: f64| {
        case.with_target(|t| t.wheels = [left, right].map(Hold::Force))
    };
    check(&forces(Case::new("bushed-double-wishbone"), 3900.0, 0.0), 10);
    check(&forces(Case::new("sedan-axle").with_setup(|s| s.kinematic = true), 4200.0, 0.0), 8);
    let axle = Case::axle("sedan-axle").at(0.0, 0.0, 4.0);
    let loads = [[0.0, 700.0, 0.0, 0.0, 0.0, 0.0], [0.0, 900.0, 0.0, 0.0, 0.0, 0.0]];
    check(&forces(axle.loaded(loads[0], loads[1]), 4300.0, 3500.0), 8);
    let rolls = |s: &mut Setup| s.chassis = Chassis::Roll { axis: 0.05 };
    let case = Case::axle("sedan-axle").with_setup(rolls).at(8.0, 3.0, 2.0);
    let mut held = Axle::new(&case.model(), &case.setup).unwrap();
    held.go_to(&Target { roll: 0.02, ..case.target }).unwrap();
    let force = Hold::Force(1.03 * held.supports().chassis);
    check(&case.with_target(|t| (t.roll, t.heave) = (0.02, force)), 8);
}
