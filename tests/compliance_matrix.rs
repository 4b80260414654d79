//! The compliance matrix against finely stepped load cases and closed forms.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;

use axles::{CUT, NO_TYRE, axle, close, load};
use hardpoint::model::{Model, Setup, Side, WheelSupport};
use hardpoint::rig::{Axle, Compliance, Corner, Load, LoadPoint, Pose};
use hardpoint::solve::compliance::ComplianceError;

const SIDES: [Side; 2] = [Side::Left, Side::Right];
const RIGID: fn() -> Setup = || Setup { kinematic: true, ..Setup::default() };

/// The turn from one rotation to another as a rotation vector: to third order of a small angle, from
/// the skew part.
fn turn(from: [[f64; 3]; 3], to: [[f64; 3]; 3]) -> [f64; 3] {
    let r: [[f64; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..3).map(|k| to[i][k] * from[j][k]).sum())
    });
    let axis = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]].map(|x| 0.5 * x);
    let sine = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
    let angle = if sine > 0.0 { sine.asin() / sine } else { 1.0 };
    axis.map(|x| angle * x)
}

/// Displacement and rotation between two poses, per unit of what lies between them.
fn difference(from: &Pose<f64>, to: &Pose<f64>, step: f64) -> [f64; 6] {
    let turned = turn(from.rotation, to.rotation);
    std::array::from_fn(|k| match k {
        0..3 => (to.wheel.center[k] - from.wheel.center[k]) / step,
        _ => turned[k - 3] / step,
    })
}

/// Central differences with the error of second order taken out.
fn richardson<const N: usize>(half: [f64; N], whole: [f64; N]) -> [f64; N] {
    std::array::from_fn(|k| (4.0 * half[k] - whole[k]) / 3.0)
}

/// The largest entry of the kind of one: m/N, rad/N or m/(N·m), rad/(N·m).
fn scale(compliance: &Compliance, row: usize, column: usize) -> f64 {
    let kind = |index: usize| index % 6 / 3;
    let mut largest: f64 = 0.0;
    for i in (0..compliance.order()).filter(|&i| kind(i) == kind(row)) {
        for j in (0..compliance.order()).filter(|&j| kind(j) == kind(column)) {
            largest = largest.max(compliance.entry(i, j).abs());
        }
    }
    largest
}

#[track_caller]
fn entries_close(
    what: &str,
    compliance: &Compliance,
    expected: impl Fn(usize, usize) -> f64,
    tolerance: f64,
) {
    for row in 0..compliance.order() {
        for column in 0..compliance.order() {
            let size = scale(compliance, row, column);
            let (found, expected) = (compliance.entry(row, column), expected(row, column));
            close(&format!("{what} C[{row}, {column}]"), found, expected, tolerance * size);
        }
    }
}

/// A load that is changed in one component.
fn stepped(load: &Load, component: usize, step: f64) -> Load {
    let mut load = *load;
    load.components[component] += step;
    load
}

/// An axle without tyres whose wheels hang on loads alone.
struct Hanging {
    axle: Axle,
    loads: [Load; 2],
}

impl Hanging {
    /// The same state as that of an axle whose wheels are held and loaded.
    fn at(model: &Model, held: &mut Axle, at: LoadPoint, loads: [Load; 2], rack: f64) -> Self {
        let setup = Setup { support: WheelSupport::Free, ..Setup::default() };
        let mut axle = Axle::with_loads(model, &setup, at).unwrap();
        let loads = SIDES.map(|side| {
            // The rig pushes at the wheel centre.
            stepped(&loads[side.index()], 2, held.pose(side).load.unwrap().force)
        });
        axle.set_load(&loads);
        axle.move_to([0.0; 2], rack).unwrap();
        axle.rest().unwrap();
        for side in SIDES {
            let apart = difference(&held.pose(side), &axle.pose(side), 1.0);
            assert!(apart.iter().all(|x| x.abs() < 1e-9), "{apart:?}");
        }
        Self { axle, loads }
    }

    fn poses(&mut self, column: usize, step: f64) -> [Pose<f64>; 2] {
        let mut loads = self.loads;
        loads[column / 6] = stepped(&loads[column / 6], column % 6, step);
        self.axle.set_load(&loads);
        self.axle.rest().unwrap();
        SIDES.map(|side| self.axle.pose(side))
    }

    /// One column of the compliance from stepped loads.
    fn column(&mut self, column: usize) -> Vec<f64> {
        let step = if column % 6 < 3 { 20.0 } else { 4.0 };
        let mut slope = |step: f64| {
            let (less, more) = (self.poses(column, -step), self.poses(column, step));
            SIDES.map(|side| difference(&less[side.index()], &more[side.index()], 2.0 * step))
        };
        let (half, whole) = (slope(0.5 * step), slope(step));
        SIDES.iter().flat_map(|side| richardson(half[side.index()], whole[side.index()])).collect()
    }
}

/// The wheels are held at different travels and loaded, so the drivers that let go carry kilonewtons.
#[test]
fn the_matrix_is_that_of_stepped_load_cases() {
    let model = axle(&[NO_TYRE]);
    for moment in [0.0, 60.0] {
        let loads = [
            load(&[("fx", -1500.0), ("fy", 400.0), ("mx", moment)]),
            load(&[("fx", -300.0), ("fy", 900.0), ("mz", -moment)]),
        ];
        let at = LoadPoint::WheelCenter;
        let mut held = Axle::with_loads(&model, &Setup::default(), at).unwrap();
        held.set_load(&loads);
        held.move_to([0.015, -0.02], 0.006).unwrap();
        let compliance = held.compliance().unwrap();
        assert!(SIDES.iter().all(|side| held.pose(*side).load.unwrap().force.abs() > 1000.0));

        let mut hanging = Hanging::at(&model, &mut held, at, loads, 0.006);
        let columns: Vec<Vec<f64>> = (0..12).map(|column| hanging.column(column)).collect();
        entries_close("load cases", &compliance, |row, column| columns[column][row], 1e-7);

        let asymmetry = compliance.asymmetry();
        if moment == 0.0 {
            assert!(asymmetry < 1e-10, "{asymmetry:e}");
        } else {
            // A moment that keeps its direction has no energy.
            assert!(asymmetry > 1e-6, "{asymmetry:e}");
        }
    }
}

/// At the design position the patch is the point at which the rig loads the wheel. A dead load at the
/// wheel centre carries it, as the rig does.
#[test]
fn the_matrix_of_the_contact_patches_is_that_of_loads_at_the_patches() {
    let at = LoadPoint::ContactPatch;
    let mut held = Axle::with_loads(&axle(&[NO_TYRE]), &RIGID(), at).unwrap();
    held.rest().unwrap();
    let force = held.pose(Side::Left).load.unwrap().force;
    let compliance = held.compliance().unwrap();
    let dead = format!(
        "[[forces]]\nname = \"dead\"\nkind = \"force\"\nbody = \"upright\"\nat = \"wheel_center\"\nforce = [0.0, 0.0, {force}]\n\n[anti_roll_bar]"
    );
    let model = axle(&[NO_TYRE, ("[anti_roll_bar]", &dead)]);
    assert_eq!(compliance.at(), LoadPoint::WheelCenter);
    let patches = compliance.at_contact_patch();
    assert_eq!((patches.at(), &patches.at_contact_patch()), (at, &patches));

    let setup = Setup { support: WheelSupport::Free, ..RIGID() };
    let mut axle = Axle::with_loads(&model, &setup, at).unwrap();
    let mut places = |column: usize, step: f64| {
        let mut loads = [Load::default(); 2];
        loads[column / 6].components[column % 6] = step;
        axle.set_load(&loads);
        axle.rest().unwrap();
        SIDES.map(|side| {
            let name = format!("{} contact patch at design", side.name());
            let point = axle.stand().mechanism().point_named(&name).unwrap();
            let body = axle.suspension().sides[side.index()].wheel.body;
            let mut pose = axle.pose(side);
            pose.wheel.center = axle.equilibrium().loaded().point(body, point);
            pose
        })
    };
    let columns: Vec<Vec<f64>> = (0..12)
        .map(|column| {
            let mut slope = |step: f64| {
                let (less, more) = (places(column, -step), places(column, step));
                SIDES.map(|s| difference(&less[s.index()], &more[s.index()], 2.0 * step))
            };
            let step = if column % 6 < 3 { 20.0 } else { 4.0 };
            let (half, whole) = (slope(0.5 * step), slope(step));
            SIDES.iter().flat_map(|s| richardson(half[s.index()], whole[s.index()])).collect()
        })
        .collect();
    entries_close("patches", &patches, |row, column| columns[column][row], 1e-7);
}

/// A rigid corner has one way to go, φ per unit of travel, and its wheel rate k against it.
#[test]
fn a_rigid_corner_gives_way_along_its_travel() {
    let mut corner = Corner::new(&axle(&[]), &RIGID()).unwrap();
    let (travel, rack) = (0.025, -0.01);
    corner.move_to(travel, rack).unwrap();
    let rate = corner.pose().load.unwrap().rate.unwrap();
    let compliance = corner.compliance().unwrap();
    assert_eq!((compliance.order(), compliance.sides()), (6, &[Side::Left][..]));
    assert!(compliance.asymmetry() < 1e-13);

    let mut slope = |step: f64| {
        let [less, more] = [-step, step].map(|step| {
            corner.move_to(travel + step, rack).unwrap();
            corner.pose()
        });
        difference(&less, &more, 2.0 * step)
    };
    let phi = richardson(slope(1e-3), slope(2e-3));
    close("φ_z", phi[2], 1.0, 1e-12);
    entries_close("φφᵀ/k", &compliance, |row, column| phi[row] * phi[column] / rate, 1e-8);
}

/// Signs of the mirror image of displacement and rotation.
const MIRROR: [f64; 6] = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];

#[test]
fn sides_without_coupling_do_not_see_each_other() {
    let mut both = Axle::new(&axle(&[CUT]), &Setup::default()).unwrap();
    both.move_to([0.02, 0.02], 0.0).unwrap();
    let compliance = both.compliance().unwrap();
    let mut corner = Corner::new(&axle(&[]), &Setup::default()).unwrap();
    corner.move_to(0.02, 0.0).unwrap();
    let alone = corner.compliance().unwrap();
    let expected = |row: usize, column: usize| {
        let sign = MIRROR[row % 6] * MIRROR[column % 6];
        match (row / 6, column / 6) {
            (0, 0) => alone.entry(row, column),
            (1, 1) => sign * alone.entry(row - 6, column - 6),
            _ => 0.0,
        }
    };
    entries_close("cut", &compliance, expected, 1e-12);

    // The bar couples them, symmetrically.
    let mut coupled = Axle::new(&axle(&[]), &Setup::default()).unwrap();
    coupled.move_to([0.02, 0.02], 0.0).unwrap();
    let coupled = coupled.compliance().unwrap();
    assert!(coupled.entry(2, 8) > 1e-2 * coupled.entry(2, 2));
    let swapped = |row: usize, column: usize| {
        let sign = MIRROR[row % 6] * MIRROR[column % 6];
        sign * coupled.entry((row + 6) % 12, (column + 6) % 12)
    };
    entries_close("mirror", &coupled, swapped, 1e-11);
    assert!(coupled.asymmetry() < 1e-10);
}

/// The arm turns by α per metre of travel. In roll the bar twists by 2 α z, and its torque k α pushes
/// each wheel with 2 k α² z.
#[test]
fn a_bar_adds_its_roll_stiffness_and_no_ride_rate() {
    const STIFFNESS: f64 = 10_000.0 * 1e-3 * 180.0 / std::f64::consts::PI;
    let rates = |changes: &[(&str, &str)]| {
        let mut axle = Axle::new(&axle(changes), &RIGID()).unwrap();
        let c = axle.compliance().unwrap();
        let (own, other) = (c.entry(2, 2), c.entry(2, 8));
        (1.0 / (own + other), 1.0 / (own - other))
    };
    let ((ride, roll), (ride_cut, roll_cut)) = (rates(&[]), rates(&[CUT]));
    close("a cut bar", roll_cut, ride_cut, 1e-12 * ride_cut);
    close("ride rate", ride, ride_cut, 1e-11 * ride_cut);

    // How the end of the drop link on the lower arm moves with the travel.
    let model = axle(&[]);
    let mut corner = Corner::new(&model, &RIGID()).unwrap();
    let mut place = |travel: f64| {
        corner.move_to(travel, 0.0).unwrap();
        let mechanism = corner.stand().mechanism();
        let lca = mechanism.body_named("lca").unwrap();
        corner.equilibrium().loaded().point(lca, mechanism.point_named("arb_link_lower").unwrap())
    };
    let mut slope = |step: f64| -> [f64; 3] {
        let (less, more) = (place(-step), place(step));
        std::array::from_fn(|k| (more[k] - less[k]) / (2.0 * step))
    };
    let velocity = richardson(slope(1e-3), slope(2e-3));
    let [pivot, arm_end, link] =
        ["arb_pivot", "arb_arm_end", "arb_link_lower"].map(|name| model.point(name).unwrap());
    let minus = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| a[k] - b[k]) };
    let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
    let (along, arm) = (minus(arm_end, link), minus(arm_end, pivot));
    // The link keeps its length: alongᵀ (α e_y × arm − velocity) = 0.
    let alpha = dot(along, velocity) / dot(along, [arm[2], 0.0, -arm[0]]);
    let expected = 2.0 * STIFFNESS * alpha * alpha;
    assert!(expected > 1000.0, "{expected}");
    close("roll", roll - roll_cut, expected, 1e-8 * expected);
}

#[test]
fn forces_without_energy_have_an_unsymmetric_matrix() {
    let text = include_str!("../models/bushed-double-wishbone.toml");
    let model = Model::parse("models/bushed-double-wishbone.toml", text).unwrap();
    let mut corner =
        Corner::with_loads(&model, &Setup::default(), LoadPoint::ContactPatch).unwrap();
    corner.set_load(&load(&[("fx", -3000.0)]));
    corner.move_to(0.04, 0.0).unwrap();
    let asymmetry = corner.compliance().unwrap().asymmetry();
    assert!(asymmetry > 1e-7, "{asymmetry:e}");
}

#[test]
fn without_stiffness_there_is_no_compliance() {
    let text = include_str!("../models/double-wishbone.toml");
    let model = Model::parse("models/double-wishbone.toml", text).unwrap();
    let error = Corner::new(&model, &Setup::default()).unwrap().compliance().unwrap_err();
    assert!(matches!(error, ComplianceError::NoStiffness { .. }), "{error}");
    assert!(error.to_string().contains("nothing holds this motion: "), "{error}");
    let error = Axle::new(&model, &Setup::default()).unwrap().compliance().unwrap_err();
    assert!(matches!(error, ComplianceError::NoStiffness { .. }), "{error}");

    // A bar alone holds roll and leaves ride free.
    let start = axles::AXLE.find("[[forces]]").unwrap();
    let end = axles::AXLE.find("# The arms").unwrap();
    let text = format!("{}{}", &axles::AXLE[..start], &axles::AXLE[end..]);
    let text = text.replace("gravity = 9.81", "gravity = 0.0");
    let bar = Model::parse("models/model.toml", &text).unwrap();
    let error = Axle::new(&bar, &RIGID()).unwrap().compliance().unwrap_err();
    assert!(matches!(error, ComplianceError::NoStiffness { .. }), "{error}");
}

/// An actuator that pulls the arm up has a stiffness below zero: its lever arm grows with the travel.
#[test]
fn a_wheel_that_would_run_away_has_no_compliance() {
    let spring = "kind = \"spring\"\nbetween = [\"chassis\", \"lca\"]\non = [\"spring_upper\", \"spring_lower\"]\nstiffness = 70.0\nfree_length = 605.0\ndamping = 6.0";
    let push = "kind = \"actuator\"\nbetween = [\"chassis\", \"lca\"]\non = [\"spring_upper\", \"spring_lower\"]\nforce = 6000.0";
    let mut corner = Corner::new(&axle(&[(spring, push)]), &RIGID()).unwrap();
    let error = corner.compliance().unwrap_err();
    assert!(matches!(error, ComplianceError::Unstable { .. }), "{error}");
}
