//! Derivatives of factors of models with a static state, which follows the change, against models made anew.

#[path = "common/varying.rs"]
mod varying;

use hardpoint::model::{Chassis, Setup};
use hardpoint::rig::{Hold, Target};

use varying::{Case, check};

const NO_CAMBER: (&str, &str) = ("camber = { value = -1.5, by = \"camber_shim\" }\n", "");

#[test]
fn a_corner_that_is_set_up_has_the_derivatives_of_models_made_anew() {
    check(&Case::new("sedan-setup"), 14);
    let pushed = [300.0, -700.0, 0.0, 0.0, 0.0, 30.0];
    check(&Case::new("sedan-setup").at(17.0, 0.0, -4.0).loaded(pushed, pushed), 20);
}

#[test]
fn so_has_an_axle() {
    let loads = [[0.0, 500.0, 0.0, 0.0, 0.0, 10.0], [-400.0, 0.0, 0.0, 0.0, 0.0, 0.0]];
    check(&Case::axle("sedan-setup").at(9.0, -13.0, 5.0).loaded(loads[0], loads[1]), 16);
}

/// What the static state asks for and what is set by hand, all of it.
#[test]
fn so_have_the_numbers_of_the_static_state() {
    let names = ["static.", "adjusters."];
    let case = Case::new("sedan-setup").with(NO_CAMBER.0, NO_CAMBER.1).at(12.0, 0.0, 3.0);
    check(&case.by(&names), 20);
    check(&Case::axle("sedan-setup").at(12.0, 4.0, 3.0).by(&names), 20);
}

/// A tie rod that is set longer than its points say grows along a line that turns with them.
#[test]
fn so_have_the_points_that_give_an_adjuster_its_direction() {
    check(&Case::new("sedan-setup").by(&["tierod", "lca_outer", "uca_outer"]), 12);
}

#[test]
fn so_has_one_without_forces() {
    let adjusters = "
[adjusters.tie_rod_length]
kind = \"length\"
body = \"tierod\"
ends = [\"tierod_inner\", \"tierod_outer\"]

[adjusters.camber_shim]
kind = \"shim\"
joint = \"uca_pivot\"
on = \"chassis\"
direction = \"y\"

[static]
ride_height = 6.0
toe = { value = -0.2, by = \"tie_rod_length\" }
camber = { value = -1.2, by = \"camber_shim\" }
";
    check(&Case::new("double-wishbone").and(adjusters).at(25.0, 0.0, 7.0), 12);
    let rolls = |s: &mut Setup| s.chassis = Chassis::Roll { axis: 0.05 };
    let axle = Case::axle("double-wishbone").and(adjusters).with_setup(rolls).at(8.0, 3.0, 2.0);
    check(&axle.with_target(|t| t.roll = 0.02), 10);
}

#[test]
fn so_has_one_whose_wheels_forces_hold() {
    let forces = |t: &mut Target| t.wheels = [4300.0, 3700.0].map(Hold::Force);
    check(&Case::axle("sedan-setup").at(0.0, 0.0, 5.0).with_target(forces), 8);
}
