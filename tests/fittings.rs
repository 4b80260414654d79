//! Steering gear, hub bearing, subframe and another side: what a model adds to its architecture.
#![allow(missing_docs)]

#[path = "common/axles.rs"]
mod axles;

use std::f64::consts::TAU;

use axles::{CUT, NO_TYRE, axle, close, load};
use hardpoint::factors::{Convention, find};
use hardpoint::model::{Model, Setup, Side, WheelSupport};
use hardpoint::rig::{Axle, Compliance, Corner, Event, Held, LoadPoint, Pose, Sweep, SweepPlan};
use hardpoint::solve::StopReason;

const SIDES: [Side; 2] = [Side::Left, Side::Right];

/// At design nothing has a force, so that compliances of parts in a row add up exactly.
const NO_LOAD: [(&str, &str); 4] =
    [CUT, NO_TYRE, ("gravity = 9.81", "gravity = 0.0"), ("free_length = 605.0", "preload = 0.0")];

/// The sedan without loads at design, with more sections and points and with other words.
fn sedan(sections: &str, points: &str, changes: &[(&str, &str)]) -> Model {
    let wheel = format!("{points}\n[wheel]\n");
    let spring = format!("{sections}\n[[forces]]\n");
    let more = [("\n[wheel]\n", wheel.as_str()), ("\n[[forces]]\n", spring.as_str())];
    axle(&[&NO_LOAD[..], &more, changes].concat())
}

const GEAR: &str = "
[steering]
limits = [-60.0, 55.0]
rack_per_turn = -52.0
torsion_bar_stiffness = 2000.0
column_stiffness = 12000.0
mount_stiffness = 8000.0
";

const BEARING: &str = "
[hub_bearing]
radial = 180000.0
axial = 90000.0
tilt = [7.0e6, 6.0e6]
";

const MOUNTS: &str = "
[subframe.mounts.front_mount]
at = \"front_mount\"
stiffness = [2500.0, 6000.0, 4000.0]
rotational_stiffness = [90000.0, 70000.0, 50000.0]

[subframe.mounts.rear_mount]
at = \"rear_mount\"
stiffness = [3500.0, 8000.0, 4500.0]
";

const PLACES: &str = "front_mount = [250.0, 360.0, -230.0]\nrear_mount = [-330.0, 340.0, -215.0]\n";

fn rigid() -> Setup {
    Setup { kinematic: true, ..Setup::default() }
}

fn corner_compliance(model: &Model) -> Compliance {
    let mut corner = Corner::new(model, &Setup::default()).unwrap();
    corner.move_to(0.0, 0.0).unwrap();
    corner.compliance().unwrap()
}

fn axle_compliance(model: &Model) -> Compliance {
    let mut axle = Axle::new(model, &Setup::default()).unwrap();
    axle.move_to([0.0; 2], 0.0).unwrap();
    axle.compliance().unwrap()
}

/// What a part adds to the compliance, against a closed form. Entries are compared with the largest of their
/// kind: translation or rotation.
#[track_caller]
fn adds(
    with: &Compliance,
    without: &Compliance,
    expected: impl Fn(usize, usize) -> f64,
    tolerance: f64,
) {
    let order = with.order();
    let kind = |index: usize| index % 6 / 3;
    for row in 0..order {
        for column in 0..order {
            let alike = |i: usize, j: usize| kind(i) == kind(row) && kind(j) == kind(column);
            let size = (0..order * order)
                .map(|k| (k / order, k % order))
                .filter(|&(i, j)| alike(i, j))
                .fold(0.0, |size: f64, (i, j)| size.max(with.entry(i, j).abs()));
            let found = with.entry(row, column) - without.entry(row, column);
            close(&format!("C[{row}, {column}]"), found, expected(row, column), tolerance * size);
        }
    }
}

fn factor(name: &str, pose: &Pose<f64>) -> f64 {
    find(name).unwrap().value(Convention::Iso, pose).unwrap_or_else(|| panic!("no {name}"))
}

/// Where a wheel is and how it has turned.
fn place(pose: &Pose<f64>) -> Vec<f64> {
    [&pose.wheel.center[..], pose.rotation.as_flattened()].concat()
}

#[track_caller]
fn same_place(what: &str, found: &Pose<f64>, expected: &Pose<f64>, tolerance: f64) {
    for (found, expected) in place(found).into_iter().zip(place(expected)) {
        close(what, found, expected, tolerance);
    }
}

// ---- steering gear

#[test]
fn springs_of_the_steering_gear_lie_in_series() {
    let model = sedan(GEAR, "", &[]);
    let steering = model.steering.unwrap();
    let r = -0.052 / TAU;
    close("ratio", steering.rack_per_radian.unwrap(), r, 1e-15);
    assert_eq!(steering.limits, Some([-0.06, 0.055]));
    // N·mm/deg in N·m/rad.
    let per_degree = 1e-3 * 180.0 / std::f64::consts::PI;
    let [bar, column] = [2000.0, 12000.0].map(|k| k * per_degree);
    let expected = 1.0 / (1.0 / 8.0e6 + r * r / column + r * r / bar);
    close("stiffness", steering.stiffness.unwrap() / expected, 1.0, 1e-13);
    // Any of the three alone.
    let alone = "[steering]\nmount_stiffness = 8000.0\n";
    close("mount", sedan(alone, "", &[]).steering.unwrap().stiffness.unwrap(), 8.0e6, 1e-6);
    let none = sedan("[steering]\nlimits = [-60.0, 60.0]\n", "", &[]).steering.unwrap();
    assert_eq!((none.stiffness, none.rack_per_radian), (None, None));
}

/// The rack gives way by F ∕ k, and F is what the wheels' loads do per unit of the rack, so the gear
/// adds v vᵀ ∕ k, with v the motion of both wheels by the rack.
#[test]
fn a_soft_gear_adds_one_motion_to_the_compliance_of_an_axle() {
    let (soft, direct) = (sedan(GEAR, "", &[]), sedan("", "", &[]));
    let free = Setup { support: WheelSupport::Free, ..Setup::default() };
    let mut axle = Axle::new(&direct, &free).unwrap();
    let step = 1e-4;
    let mut at = |rack: f64| {
        axle.reset();
        axle.move_to([0.0; 2], rack).unwrap();
        SIDES.map(|side| axle.pose(side))
    };
    let mut slope = |step: f64| -> Vec<f64> {
        let (plus, minus) = (at(step), at(-step));
        let pairs = plus.iter().zip(&minus);
        let motion = |(plus, minus): (&Pose<f64>, &Pose<f64>)| {
            let [a, b] = [plus, minus].map(|pose| pose.rotation);
            let skew = |i: usize, j: usize| (a[i][j] - a[j][i] - b[i][j] + b[j][i]) / 4.0 / step;
            let along = |k: usize| (plus.wheel.center[k] - minus.wheel.center[k]) / 2.0 / step;
            vec![along(0), along(1), along(2), skew(2, 1), skew(0, 2), skew(1, 0)]
        };
        pairs.flat_map(motion).collect()
    };
    let (half, whole) = (slope(step / 2.0), slope(step));
    let v: Vec<f64> = half.iter().zip(whole).map(|(h, w)| (4.0 * h - w) / 3.0).collect();
    let k = soft.steering.unwrap().stiffness.unwrap();
    adds(&axle_compliance(&soft), &axle_compliance(&direct), |i, j| v[i] * v[j] / k, 1e-7);
}

#[test]
fn the_driven_end_and_the_rack_are_told_apart() {
    let model = sedan(GEAR, "", &[]);
    let mut corner = Corner::with_loads(&model, &Setup::default(), LoadPoint::WheelCenter).unwrap();
    let held = Held { rack: 0.01, load: load(&[("mz", 100.0)]), ..Held::default() };
    let plan = SweepPlan { event: Event::Load(1), from: -2000.0, to: 2000.0, step: 500.0, held };
    let sweep = Sweep::run(&mut corner, &plan, |_| {});
    assert!(sweep.stops.is_empty());
    let column = |name: &str| sweep.channels.iter().position(|c| c.name == name).expect(name);
    let [moved, held, twist] =
        ["rack_displacement", "rack_force", "steering_gear_displacement"].map(column);
    let k = model.steering.unwrap().stiffness.unwrap();
    for row in &sweep.rows {
        let channels = &row.channels;
        assert_eq!(row.poses[0].rack, 0.01);
        close("twist", channels[moved], 0.01 + channels[twist], 1e-15);
        close("force", channels[held], -k * channels[twist], 1e-6);
    }
    let span = sweep.rows[8].channels[moved] - sweep.rows[0].channels[moved];
    assert!(span.abs() > 1e-4, "{span}");
}

#[test]
fn steering_ratio_is_the_slope_of_the_steering_wheel_by_the_wheel() {
    for (setup, tolerance) in [(rigid(), 1e-7), (Setup::default(), 1e-6)] {
        let mut corner = Corner::new(&sedan(GEAR, "", &[]), &setup).unwrap();
        let mut at = |rack: f64| {
            corner.move_to(0.02, rack).unwrap();
            let pose = corner.pose();
            ["steering_wheel_angle", "steer_angle", "steering_ratio"].map(|f| factor(f, &pose))
        };
        let (before, here, after) = (at(0.0149), at(0.015), at(0.0151));
        let slope = (after[0] - before[0]) / (after[1] - before[1]);
        close("ratio", here[2] / slope, 1.0, tolerance);
        close("angle", here[0], 0.015 * TAU / -0.052, 1e-12);
        assert!((10.0..40.0).contains(&here[2]), "{}", here[2]);
    }
}

#[test]
fn the_rack_stops_at_its_limits() {
    let mut corner = Corner::new(&sedan(GEAR, "", &[]), &rigid()).unwrap();
    corner.move_to(0.0, 0.055).unwrap();
    for (rack, limit) in [(0.0551, 0.055), (-0.07, -0.06)] {
        let stop = corner.move_to(0.0, rack).unwrap_err();
        assert_eq!(stop.reason, StopReason::Limit { driver: "rack".into(), limit });
        assert_eq!(corner.pose().rack, 0.055);
    }
    let mut axle = Axle::new(&sedan(GEAR, "", &[]), &rigid()).unwrap();
    let stop = axle.move_to([0.0; 2], 0.06).unwrap_err().to_string();
    let said = "stopped at rack = 0 mm on the way to 60 mm: rack has a limit at 55 mm";
    assert!(stop.starts_with(said), "{stop}");
}

// ---- hub bearing

/// The bearing lies between the wheel and all else, so its compliance adds up: that of a bushing about the
/// spin axis, the vehicle and the vertical, without rotation about the spin axis where that is locked.
#[test]
fn a_hub_bearing_adds_its_compliance() {
    let per_degree = 1e-3 * 180.0 / std::f64::consts::PI;
    let without = sedan("", "", &[]);
    for spin in [None, Some(3.0e6)] {
        let key = spin.map_or(String::new(), |spin| format!("spin = {spin:e}\n"));
        let with = sedan(&format!("{BEARING}{key}"), "", &[]);
        let x = without.spin_axis();
        let level = x[0].hypot(x[1]);
        let y = [-x[1] / level, x[0] / level, 0.0];
        let z = [-x[2] * x[0] / level, -x[2] * x[1] / level, level];
        let axes = [x, y, z];
        let pushed = [1.0 / 90.0e6, 1.0 / 180.0e6, 1.0 / 180.0e6];
        let about = |k: f64| 1.0 / (k * per_degree);
        let turned = [spin.map_or(0.0, about), about(7.0e6), about(6.0e6)];
        let part = |c: [f64; 3], i: usize, j: usize| -> f64 {
            (0..3).map(|k| axes[k][i] * c[k] * axes[k][j]).sum()
        };
        let expected = |i: usize, j: usize| match (i, j) {
            (0..3, 0..3) => part(pushed, i, j),
            (3..6, 3..6) => part(turned, i - 3, j - 3),
            _ => 0.0,
        };
        adds(&corner_compliance(&with), &corner_compliance(&without), expected, 1e-11);
        let (with, without) = (with.mirrored(), without.mirrored());
        let image = |i: usize, j: usize| {
            let sign = |k: usize| if [1, 3, 5].contains(&k) { -1.0 } else { 1.0 };
            sign(i) * sign(j) * expected(i, j)
        };
        adds(&corner_compliance(&with), &corner_compliance(&without), image, 1e-11);
    }
}

#[test]
fn a_wheel_on_a_bearing_carries_tyre_and_mass() {
    let section = format!(
        "{BEARING}\n[bodies.wheel]\nmass = 24.0\ncenter_of_mass = [0.0, 797.9, -119.9]\ninertia = [0.0, 0.0, 0.0]\n"
    );
    let with = format!("{section}\n[[forces]]\n");
    let model = axle(&[CUT, ("\n[[forces]]\n", &with)]);
    let free = Setup { support: WheelSupport::Free, ..Setup::default() };
    let mut corner = Corner::new(&model, &free).unwrap();
    corner.rest().unwrap();
    let found = factor("wheel_load", &corner.pose());
    let without = axle(&[CUT]);
    let mut corner = Corner::new(&without, &free).unwrap();
    corner.rest().unwrap();
    let expected = factor("wheel_load", &corner.pose());
    // The tyre carries the weight of the wheel and a spring that has moved a little.
    assert!((found - expected - 24.0 * 9.81).abs() < 0.1 * 24.0 * 9.81, "{found} {expected}");
}

// ---- subframe

/// A dense inverse by elimination, as an independent reference.
fn inverse(mut a: [[f64; 6]; 6]) -> [[f64; 6]; 6] {
    let mut b: [[f64; 6]; 6] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    for k in 0..6 {
        let pivot = (k..6).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap();
        a.swap(k, pivot);
        b.swap(k, pivot);
        let scale = 1.0 / a[k][k];
        a[k].iter_mut().chain(&mut b[k]).for_each(|x| *x *= scale);
        let (row, image) = (a[k], b[k]);
        for i in (0..6).filter(|i| *i != k) {
            let factor = a[i][k];
            (0..6).for_each(|j| a[i][j] -= factor * row[j]);
            (0..6).for_each(|j| b[i][j] -= factor * image[j]);
        }
    }
    b
}

/// The displacement of a point by displacement and rotation vector of a body at the origin.
fn carried(p: [f64; 3]) -> [[f64; 6]; 3] {
    let [x, y, z] = p;
    [[1.0, 0.0, 0.0, 0.0, z, -y], [0.0, 1.0, 0.0, -z, 0.0, x], [0.0, 0.0, 1.0, y, -x, 0.0]]
}

/// The compliance of a body on mounts: places, stiffness along and about the axes.
fn on_mounts(mounts: &[([f64; 3], [f64; 3], [f64; 3])]) -> [[f64; 6]; 6] {
    let mut k = [[0.0; 6]; 6];
    for (place, along, about) in mounts {
        for (row, stiffness) in carried(*place).iter().zip(along) {
            for i in 0..6 {
                (0..6).for_each(|j| k[i][j] += row[i] * stiffness * row[j]);
            }
        }
        (0..3).for_each(|i| k[3 + i][3 + i] += about[i]);
    }
    inverse(k)
}

const ALL: &str = "carries = [\"lca_pivot\", \"uca_pivot\", \"rack_slide\"]\n";
const SPRING: (&str, &str) =
    ("between = [\"chassis\", \"lca\"]", "between = [\"subframe\", \"lca\"]");

/// A subframe that carries all adds its motion on the mounts, of the model's side and their images,
/// to that of both wheels.
#[test]
fn a_subframe_adds_the_compliance_of_its_mounts() {
    let per_degree = 1e-3 * 180.0 / std::f64::consts::PI;
    let middle =
        "\n[subframe.mounts.middle_mount]\nat = \"middle\"\nstiffness = [500.0, 700.0, 900.0]\n";
    let front = ([2.5e6, 6.0e6, 4.0e6], [90e3, 70e3, 50e3].map(|k| k * per_degree));
    let rear = ([3.5e6, 8.0e6, 4.5e6], [0.0; 3]);
    let mut mounts = vec![];
    for side in [1.0, -1.0] {
        mounts.push(([0.25, side * 0.36, -0.23], front.0, front.1));
        mounts.push(([-0.33, side * 0.34, -0.215], rear.0, rear.1));
    }
    // One on the centre line is there once.
    mounts.push(([-0.4, 0.0, -0.2], [0.5e6, 0.7e6, 0.9e6], [0.0; 3]));
    let c = on_mounts(&mounts);
    let without = sedan("", "", &[]);
    let section = format!("[subframe]\n{ALL}{MOUNTS}{middle}");
    let points = format!("{PLACES}middle = [-400.0, 0.0, -200.0]\n");
    let with = sedan(&section, &points, &[SPRING]);
    let center = without.point("wheel_center").unwrap();
    // Rows of a wheel: its displacement and rotation by those of the subframe at the origin.
    let row = |index: usize| -> [f64; 6] {
        let mut place = center;
        place[1] *= if index < 6 { 1.0 } else { -1.0 };
        match index % 6 {
            k @ 0..3 => carried(place)[k],
            k => std::array::from_fn(|j| f64::from(j == k)),
        }
    };
    let expected = |i: usize, j: usize| -> f64 {
        let (a, b) = (row(i), row(j));
        (0..36).map(|k| a[k / 6] * c[k / 6][k % 6] * b[k % 6]).sum()
    };
    adds(&corner_compliance(&with), &corner_compliance(&without), expected, 1e-10);
    adds(&axle_compliance(&with), &axle_compliance(&without), expected, 1e-10);
}

#[test]
fn mounts_with_axes_between_points_have_images() {
    let turned = MOUNTS.replace(
        "at = \"front_mount\"",
        "at = \"front_mount\"\nx_axis = [\"rear_mount\", \"front_mount\"]",
    );
    let section = format!("[subframe]\n{ALL}{turned}");
    let model = sedan(&section, PLACES, &[SPRING]);
    // The image in a corner is what the other side of an axle has.
    let (corner, axle) = (corner_compliance(&model), axle_compliance(&model));
    let whole = corner_compliance(&sedan("", "", &[]));
    for i in 0..6 {
        for j in 0..6 {
            close(
                "image",
                axle.entry(i, j),
                corner.entry(i, j),
                1e-12 * whole.entry(i, i).abs().max(whole.entry(j, j)),
            );
        }
    }
    let mirrored = corner_compliance(&model.mirrored());
    let sign = |k: usize| if [1, 3, 5].contains(&k) { -1.0 } else { 1.0 };
    for i in 0..6 {
        for j in 0..6 {
            let expected = sign(i) * sign(j) * corner.entry(i, j);
            close(
                "mirrored",
                mirrored.entry(i, j),
                expected,
                1e-12 * whole.entry(i, i).abs().max(whole.entry(j, j)),
            );
        }
    }
}

// ---- all of them

#[test]
fn rigid_joints_leave_fittings_without_effect() {
    let section = format!("{GEAR}{BEARING}[subframe]\n{ALL}{MOUNTS}");
    let with = sedan(&section, PLACES, &[SPRING]);
    let without = sedan("", "", &[]);
    let mut corners = [&with, &without].map(|model| Corner::new(model, &rigid()).unwrap());
    let mut axles = [&with, &without].map(|model| Axle::new(model, &rigid()).unwrap());
    assert!(corners[0].freedom().is_exact() && axles[0].freedom().redundant.is_empty());
    for (travel, rack) in [(0.05, 0.02), (-0.06, -0.03), (0.0, 0.05)] {
        let [found, expected] = corners.each_mut().map(|corner| {
            corner.move_to(travel, rack).unwrap();
            corner.pose()
        });
        same_place("corner", &found, &expected, 1e-12);
        for side in SIDES {
            let [found, expected] = axles.each_mut().map(|axle| {
                axle.move_to([travel, -travel], rack).unwrap();
                axle.pose(side)
            });
            same_place("axle", &found, &expected, 1e-12);
        }
    }
}

#[test]
fn the_shipped_axle_with_all_fittings_is_symmetric() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/models/subframe-axle.toml");
    let model = Model::load(path).unwrap_or_else(|e| panic!("{}", e.render()));
    for model in [model.mirrored(), model] {
        let mut axle = Axle::new(&model, &Setup::default()).unwrap();
        axle.set_load(&[load(&[("fx", -900.0)]); 2]);
        axle.move_to([0.03; 2], 0.0).unwrap();
        let [left, right] = SIDES.map(|side| axle.pose(side));
        for name in ["toe", "camber", "wheel_center_x", "wheel_center_z", "wheel_load"] {
            let scale = if name == "wheel_load" { 1e-6 } else { 1.0 };
            close(name, scale * factor(name, &left), scale * factor(name, &right), 1e-11);
        }
        assert!(factor("steering_ratio", &left) > 0.0);
    }
}

// ---- another side

fn pair() -> Model {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/left-sedan.toml");
    Model::load(path).unwrap_or_else(|e| panic!("{}", e.render()))
}

#[test]
fn both_files_of_a_pair_make_an_axle() {
    let left = pair();
    let right = left.other_side();
    assert_eq!((right.side, right.name.as_str()), (Side::Right, "Right sedan"));
    assert_eq!(right.other_side().name, "Left sedan");
    let mut corners = [&left, &right].map(|model| Corner::new(model, &Setup::default()).unwrap());
    for model in [&left, &right] {
        let mut axle = Axle::new(model, &Setup::default()).unwrap();
        axle.move_to([0.03, -0.02], 0.01).unwrap();
        for (corner, travel) in corners.iter_mut().zip([0.03, -0.02]) {
            corner.move_to(travel, 0.01).unwrap();
            let expected = corner.pose();
            same_place("side", &axle.pose(expected.side), &expected, 1e-12);
        }
    }
    let [left, right] = corners.each_mut().map(|corner| factor("kpi", &corner.pose()));
    assert!((left - right).abs() > 1e-3, "{left} {right}");
}

#[test]
fn the_mirror_image_of_a_pair_exchanges_its_sides() {
    let image = pair().mirrored();
    assert_eq!(image.side, Side::Right);
    let other = image.other_side();
    assert_eq!((other.side, other.name.as_str()), (Side::Left, "Right sedan"));
    let mut axle = Axle::new(&image, &Setup::default()).unwrap();
    let mut straight = Axle::new(&pair(), &Setup::default()).unwrap();
    axle.move_to([-0.02, 0.03], -0.01).unwrap();
    straight.move_to([0.03, -0.02], 0.01).unwrap();
    for side in SIDES {
        let (found, expected) = (axle.pose(side), straight.pose(side.other()));
        for name in ["toe", "camber", "caster", "kpi", "wheel_center_x", "wheel_center_z"] {
            close(name, factor(name, &found), factor(name, &expected), 1e-11);
        }
    }
}
