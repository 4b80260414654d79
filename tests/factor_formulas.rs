//! The formulas of factors: exact derivatives, mirror images, closed forms, undefined values.
#![allow(missing_docs)]

use hardpoint::factors::{Convention, FACTORS, Factor, Need, find};
use hardpoint::model::{Axle, Brakes, Drive, Model, Quantity, Setup, WheelSupport};
use hardpoint::rig::{
    self, Corner, Design, Line, Motion, Motions, OtherWheel, Pose, TyreState, Wheel,
    WheelCompliance, WheelLoad,
};
use hardpoint::scalar::{Dual, Scalar};
use hardpoint::solve::Twist;

fn model(name: &str) -> Model {
    let path = format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    Model::load(path).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

/// A model with an architecture of its own, from `tests/fixtures/architectures`.
fn with_architecture(name: &str, points: &str, more: &str) -> Model {
    let text = format!(
        "format = 1\nname = \"{name}\"\narchitecture = \"{name}.toml\"\naxes = \"iso8855\"\n\
         side = \"left\"\n[units]\nlength = \"mm\"\nangle = \"deg\"\nforce = \"N\"\n[points]\n{points}\n\
         [wheel]\nradius = 326.6\ntoe = 0.0\ncamber = 0.0\n{more}"
    );
    let model = Model::parse("tests/fixtures/architectures/model.toml", &text);
    model.unwrap_or_else(|e| panic!("{}", e.render()))
}

fn pose(model: &Model, travel: f64, rack: f64) -> Pose<f64> {
    let mut corner = Corner::new(model, &Setup::default()).unwrap();
    corner.move_to(travel, rack).unwrap();
    corner.pose()
}

fn value(name: &str, pose: &Pose<f64>) -> Option<f64> {
    find(name).unwrap().value(Convention::Iso, pose)
}

#[track_caller]
fn near(name: &str, pose: &Pose<f64>, expected: f64, tolerance: f64) {
    let found = value(name, pose).unwrap_or_else(|| panic!("{name} is undefined"));
    assert!((found - expected).abs() <= tolerance, "{name}: {found} instead of {expected}");
}

/// The pose with every number replaced.
fn replaced<S: Scalar>(pose: &Pose<f64>, new: &mut impl FnMut(f64) -> S) -> Pose<S> {
    type Vector = [f64; 3];
    fn vector<S>(v: Vector, new: &mut impl FnMut(f64) -> S) -> [S; 3] {
        v.map(new)
    }
    fn line<S>(line: Line<f64>, new: &mut impl FnMut(f64) -> S) -> Line<S> {
        Line { from: vector(line.from, new), to: vector(line.to, new) }
    }
    fn wheel<S>(wheel: Wheel<f64>, new: &mut impl FnMut(f64) -> S) -> Wheel<S> {
        let (center, spin) = (vector(wheel.center, new), vector(wheel.spin, new));
        Wheel { center, spin, radius: new(wheel.radius) }
    }
    fn twist<S>(twist: Twist<f64>, new: &mut impl FnMut(f64) -> S) -> Twist<S> {
        let Twist { velocity, rotation } = twist;
        Twist { velocity: vector(velocity, new), rotation: vector(rotation, new) }
    }
    // Newtons and metres per newton are replaced in such units that their numbers are near one.
    fn in_unit<S: Scalar>(unit: f64, value: f64, new: &mut impl FnMut(f64) -> S) -> S {
        S::from_f64(unit) * new(value / unit)
    }
    fn load<S: Scalar>(load: WheelLoad<f64>, new: &mut impl FnMut(f64) -> S) -> WheelLoad<S> {
        let rate = load.rate.map(|rate| in_unit(1e4, rate, new));
        WheelLoad { force: in_unit(1e3, load.force, new), rate }
    }
    fn tyre<S: Scalar>(tyre: TyreState<f64>, new: &mut impl FnMut(f64) -> S) -> TyreState<S> {
        TyreState { rate: in_unit(1e5, tyre.rate, new), deflection: new(tyre.deflection) }
    }
    fn compliance<S: Scalar>(
        compliance: WheelCompliance<f64>,
        new: &mut impl FnMut(f64) -> S,
    ) -> WheelCompliance<S> {
        let mut block = |block: [[f64; 6]; 6]| block.map(|row| row.map(|v| in_unit(1e-5, v, new)));
        WheelCompliance { own: block(compliance.own), across: block(compliance.across) }
    }
    fn motion<S>(motion: Motion<f64>, new: &mut impl FnMut(f64) -> S) -> Motion<S> {
        Motion {
            wheel: twist(motion.wheel, new),
            steer_axis: motion.steer_axis.map(|rates| line(rates, new)),
            spring: motion.spring.map(|rates| line(rates, new)),
            damper: motion.damper.map(|rates| line(rates, new)),
            fastest: motion.fastest,
        }
    }
    Pose {
        travel: new(pose.travel),
        rack: new(pose.rack),
        wheel: wheel(pose.wheel, new),
        rotation: pose.rotation.map(|row| vector(row, new)),
        steer_axis: pose.steer_axis.map(|axis| line(axis, new)),
        spring: pose.spring.map(|spring| line(spring, new)),
        damper: pose.damper.map(|damper| line(damper, new)),
        design: Design {
            wheel: wheel(pose.design.wheel, new),
            spring: pose.design.spring.map(|spring| line(spring, new)),
            damper: pose.design.damper.map(|damper| line(damper, new)),
        },
        motions: pose.motions.map(|motions| Motions {
            travel: motion(motions.travel, new),
            rack: motions.rack.map(|rack| motion(rack, new)),
            across: motions.across.map(|across| twist(across, new)),
        }),
        load: pose.load.map(|own| load(own, new)),
        tyre: pose.tyre.map(|own| tyre(own, new)),
        compliance: pose.compliance.map(|own| compliance(own, new)),
        other: pose.other.map(|other| OtherWheel {
            wheel: wheel(other.wheel, new),
            design: wheel(other.design, new),
            travel: other.travel.map(|motion| twist(motion, new)),
            across: other.across.map(|motion| twist(motion, new)),
            rack: other.rack.map(|motion| twist(motion, new)),
            load: other.load.map(|own| load(own, new)),
            tyre: other.tyre.map(|own| tyre(own, new)),
            compliance: other.compliance.map(|own| compliance(own, new)),
        }),
        vehicle: pose.vehicle,
        side: pose.side,
        axes: pose.axes,
    }
}

/// Every formula of the table, in both conventions: its derivative on dual numbers against
/// differences of the fourth order along the same random direction of all numbers of a pose.
#[test]
fn derivatives_of_all_formulas_are_exact() {
    let mut front = model("sedan-axle");
    front.vehicle = model("double-wishbone").vehicle;
    front.vehicle.rack_per_radian = Some(-0.008);
    front.vehicle.mass = Some(1600.0);
    front.vehicle.sprung_mass = Some(380.0);
    front.vehicle.unsprung_mass = Some(45.0);
    let mut rear = front.mirrored();
    rear.vehicle.axle = Some(Axle::Rear);
    rear.vehicle.brakes = Brakes::Inboard;
    let mut compared = 0;
    for (seed, model) in [front, rear].iter().enumerate() {
        let mut axle = rig::Axle::new(model, &Setup::default()).unwrap();
        axle.measure_compliance(true);
        axle.move_to([0.04, 0.03], 0.01).unwrap();
        let base = axle.poses()[seed];
        assert!(base.compliance.is_some() && base.tyre.is_some());
        let along = |h: f64| {
            let mut rng = fastrand::Rng::with_seed(seed as u64);
            replaced(&base, &mut |value| value + h * (rng.f64() - 0.5))
        };
        let mut rng = fastrand::Rng::with_seed(seed as u64);
        let dual = replaced(&base, &mut |value| Dual::new(value, rng.f64() - 0.5));
        for factor in FACTORS.iter().filter(|factor| factor.applies(&base)) {
            for convention in [Convention::Iso, Convention::Adams, Convention::Lotus] {
                let formula = factor.by(convention).value;
                let plain = |h: f64| (formula.plain)(&along(h)).expect(factor.name);
                let h = 1e-4;
                let difference = (8.0 * (plain(h) - plain(-h))
                    - (plain(2.0 * h) - plain(-2.0 * h)))
                    / (12.0 * h);
                let found = (formula.dual)(&dual).expect(factor.name);
                assert_eq!(found.value, plain(0.0), "{}", factor.name);
                // Compliances are near a hundredth of a millimetre or a millidegree by newton.
                let least = match factor.quantity {
                    Quantity::AngleByForce | Quantity::LengthByForce | Quantity::AngleByTorque => {
                        1e-6
                    }
                    _ => 1e-2,
                };
                let size = found.derivative.abs().max(1e-2 * found.value.abs()).max(least);
                let error = (found.derivative - difference).abs();
                assert!(
                    error <= 1e-6 * size,
                    "{}: {} instead of {difference}",
                    factor.name,
                    found.derivative
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 6 * (FACTORS.len() - 10));
}

/// Gradients are the slopes of what a sweep shows.
#[test]
fn gradients_are_slopes_of_the_sweep() {
    const PAIRS: &[(&str, &str)] = &[
        ("bump_steer", "toe"),
        ("bump_camber", "camber"),
        ("bump_caster", "caster"),
        ("center_velocity_x", "wheel_center_x"),
        ("center_velocity_y", "wheel_center_y"),
        ("patch_path_x", "contact_patch_x"),
        ("patch_path_y", "contact_patch_y"),
        ("patch_path_z", "contact_patch_z"),
    ];
    // The strut's axis ends on the chassis, so its points move differently.
    for model in [model("double-wishbone"), macpherson("")] {
        for travel in [-0.05, 0.0, 0.03] {
            let at = |offset: f64| pose(&model, travel + offset, 0.004);
            let (here, h) = (at(0.0), 5e-4);
            let around = [at(-2.0 * h), at(-h), at(h), at(2.0 * h)];
            let slope = |name: &str| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|k| value(name, &around[k]).unwrap());
                (8.0 * (c - b) - (d - a)) / (12.0 * h)
            };
            for (gradient, of) in PAIRS {
                near(gradient, &here, slope(of), 1e-8);
            }
            if here.spring.is_some() {
                near("motion_ratio", &here, -slope("spring_length"), 1e-9);
                let ratio = value("motion_ratio", &here).unwrap();
                near("spring_ratio", &here, 1.0 / ratio, 1e-14);
            }
            let patch = slope("contact_patch_z");
            let lotus = |name: &str| find(name).unwrap().value(Convention::Lotus, &here).unwrap();
            assert!((lotus("bump_steer") - slope("toe") / patch).abs() < 1e-8);
            assert!((lotus("bump_caster") - slope("caster") / patch).abs() < 1e-8);
        }
    }
}

/// Whichever height is driven, the same state has the same factors.
#[test]
fn factors_do_not_depend_on_the_drive() {
    let model = model("double-wishbone");
    let mut corner = Corner::new(&model, &Setup::from(Drive::ContactPatch)).unwrap();
    corner.move_to(0.05, -0.01).unwrap();
    let by_patch = corner.pose();
    let travel = by_patch.wheel.center[2] - by_patch.design.wheel.center[2];
    let by_center = pose(&model, travel, -0.01);
    for factor in FACTORS.iter().filter(|factor| factor.name != "travel") {
        let (a, b) =
            (factor.value(Convention::Iso, &by_patch), factor.value(Convention::Iso, &by_center));
        assert_eq!(a.is_some(), b.is_some(), "{}", factor.name);
        let (a, b) = (a.unwrap_or_default(), b.unwrap_or_default());
        assert!((a - b).abs() <= 1e-10 * a.abs().max(1.0), "{}: {a} {b}", factor.name);
    }
}

/// Factors with a sign rule of their own are the same on both sides; components in the axes of the model
/// are those of the mirror image.
#[test]
fn mirror_image_has_the_same_factors() {
    let left = model("quarter-car");
    let right = left.mirrored();
    let pose = |model: &Model, travel: f64, rack: f64| {
        let mut corner = Corner::new(model, &Setup::default()).unwrap();
        corner.measure_compliance(true);
        corner.move_to(travel, rack).unwrap();
        corner.pose()
    };
    let changes = |factor: &Factor| {
        let axial = ["angular_velocity_", "screw_axis_", "wheel_rot_"];
        let axial = axial.iter().any(|vector| factor.name.starts_with(vector));
        let handed = factor.name.ends_with("pitch");
        let to_a_side = ["rack", "steer_angle", "inclination"].contains(&factor.name);
        let along_y = factor.sign.ends_with("model's +y");
        let component = if axial { !factor.name.ends_with("_y") } else { along_y };
        component || handed || to_a_side
    };
    for (travel, rack) in [(0.0, 0.0), (0.06, 0.012), (-0.08, -0.02)] {
        let (a, b) = (pose(&left, travel, rack), pose(&right, travel, -rack));
        for factor in FACTORS {
            let [a, b] = [&a, &b].map(|pose| factor.value(Convention::Iso, pose));
            assert_eq!(a.is_some(), b.is_some(), "{}", factor.name);
            let (a, b) = (a.unwrap_or_default(), b.unwrap_or_default());
            let b = if changes(factor) { -b } else { b };
            assert!((a - b).abs() <= 1e-9 * a.abs().max(1.0), "{}: {a} {b}", factor.name);
        }
    }
}

/// Arms that are parallel and equal carry the wheel without turning it.
#[test]
fn parallel_arms_have_their_centers_at_infinity() {
    let mut model = model("double-wishbone");
    for (name, position) in [
        ("lca_front", [0.2, 0.42, -0.3]),
        ("lca_rear", [-0.2, 0.42, -0.3]),
        ("lca_outer", [0.0, 0.77, -0.3]),
        ("uca_front", [0.2, 0.42, 0.1]),
        ("uca_rear", [-0.2, 0.42, 0.1]),
        ("uca_outer", [0.0, 0.77, 0.1]),
        ("tierod_inner", [-0.15, 0.42, -0.12]),
        ("tierod_outer", [-0.15, 0.77, -0.12]),
    ] {
        assert!(model.set_point(name, position));
    }
    for travel in [0.0, 0.05, -0.1] {
        let pose = pose(&model, travel, 0.0);
        for name in [
            "fvic_y",
            "fvic_z",
            "fvsa_length",
            "svic_x",
            "svic_z",
            "svsa_length",
            "fvic_patch_y",
            "svic_patch_x",
            "screw_axis_x",
            "screw_point_z",
            "screw_pitch",
        ] {
            assert_eq!(value(name, &pose), None, "{name} at {travel}");
        }
        // On a circle of 350 mm about y = 420 mm.
        let slope = -travel / (0.35_f64.powi(2) - travel * travel).sqrt();
        near("fvsa_angle", &pose, slope.atan(), 1e-12);
        near("svsa_angle", &pose, 0.0, 1e-12);
        near("bump_steer", &pose, 0.0, 1e-12);
        near("rc_height", &pose, pose.wheel.contact_patch()[1] * slope, 1e-12);
        near("tan_brake", &pose, 0.0, 1e-12);
        // The joints are fixed in the upright, and the axis is plumb.
        near("vk_caster", &pose, 0.0, 1e-12);
        near("vk_kpi", &pose, value("kpi", &pose).unwrap(), 1e-10);
    }
}

/// A wheel on one hinge turns about it: the screw axis is the hinge, all centres lie on it.
#[test]
fn trailing_arm_has_its_hinge_as_screw_axis() {
    let model = with_architecture(
        "trailing-arm",
        "arm_inner = [400.0, -10.0, 0.0]\narm_outer = [400.0, 600.0, 0.0]\n\
         wheel_center = [0.0, 700.0, -100.0]",
        "[vehicle]\naxle = \"rear\"\nwheelbase = 2000.0\ncg_height = 500.0\nbrake_share = 0.4\n\
         drive_share = 1.0\n",
    );
    let at_design = pose(&model, 0.0, 0.0);
    near("svic_x", &at_design, 0.4, 1e-12);
    near("svic_z", &at_design, 0.0, 1e-12);
    near("svic_patch_x", &at_design, 0.4, 1e-12);
    near("screw_axis_y", &at_design, 1.0, 1e-12);
    near("screw_pitch", &at_design, 0.0, 1e-12);
    near("screw_point_x", &at_design, 0.4, 1e-12);
    near("svsa_length", &at_design, -(0.4_f64.hypot(0.1)), 1e-12);
    // The hinge is 100 mm above the wheel centre, 426.6 mm above the ground and 400 mm ahead, which
    // of a rear axle resists lift in braking and squat in driving.
    near("tan_drive", &at_design, 0.25, 1e-12);
    near("tan_brake", &at_design, 0.4266 / 0.4, 1e-12);
    near("anti_squat", &at_design, 0.25 * 2.0 / 0.5, 1e-12);
    near("anti_lift", &at_design, 0.4 * 0.4266 / 0.4 * 2.0 / 0.5, 1e-12);
    near("rc_height", &at_design, 0.0, 1e-12);
    near("recession_angle", &at_design, 0.25_f64.atan(), 1e-12);
    for name in ["anti_dive", "anti_lift_drive"] {
        assert!(!find(name).unwrap().applies(&at_design));
        assert_eq!(value(name, &at_design), None);
    }
    for (name, needs) in [
        ("caster", vec![Need::SteerAxis]),
        ("vk_caster", vec![Need::Rack]),
        ("motion_ratio", vec![Need::Spring]),
        ("wheel_load", vec![Need::Forces]),
        ("fvic_y", vec![]),
    ] {
        let missing: Vec<Need> = find(name).unwrap().missing(&at_design).collect();
        assert_eq!(missing, needs, "{name}");
        assert_eq!(value(name, &at_design), None);
    }
    // The wheel turns with its arm, the top forward.
    let raised = pose(&model, 0.05, 0.0);
    let turned = 0.05_f64.atan2((0.17_f64 - 0.0025).sqrt()) - 0.1_f64.atan2(0.4);
    near("side_view_angle", &raised, turned, 1e-12);
    near("wheelbase_change", &raised, -(raised.wheel.center[0]), 1e-12);
    near("recession", &raised, -raised.wheel.center[0], 1e-12);
    near("half_track_change", &raised, 0.0, 1e-12);
}

fn macpherson(more: &str) -> Model {
    with_architecture(
        "macpherson",
        "lca_front = [150.0, 350.0, -50.0]\nlca_rear = [-150.0, 350.0, -50.0]\n\
         lca_outer = [0.0, 700.0, -80.0]\nstrut_lower = [-5.0, 640.0, 150.0]\n\
         strut_top = [-30.0, 590.0, 540.0]\ntierod_inner = [-140.0, 330.0, 0.0]\n\
         tierod_outer = [-140.0, 680.0, -20.0]\nwheel_center = [0.0, 750.0, 0.0]",
        more,
    )
}

/// With the strut held at its length a MacPherson wheel steers about its mount and its ball joint.
#[test]
fn virtual_axis_of_a_strut_is_that_of_its_joints() {
    let spring = "[[forces]]\nname = \"strut\"\nkind = \"spring\"\nbetween = [\"chassis\", \"upright\"]\n\
                  on = [\"strut_top\", \"strut_lower\"]\nstiffness = 30.0\nfree_length = 500.0\n";
    let model = macpherson(spring);
    for (travel, rack) in [(0.0, 0.0), (0.05, 0.02), (-0.06, -0.01)] {
        let pose = pose(&model, travel, rack);
        assert!(value("wheel_load", &pose).is_some());
        for name in ["caster", "kpi", "scrub_radius", "mechanical_trail", "kingpin_offset"] {
            near(&format!("vks_{name}"), &pose, value(name, &pose).unwrap(), 1e-11);
        }
        near("vks_pitch", &pose, 0.0, 1e-12);
        // With the height held the strut moves, and so does the axis.
        let (a, b) = (value("vk_scrub_radius", &pose), value("scrub_radius", &pose));
        assert!((a.unwrap() - b.unwrap()).abs() > 1e-5);
    }
}

/// A rear axle counts the other way, inboard brakes act at the wheel centre.
#[test]
fn axle_and_brakes_decide_what_resists_pitch() {
    let mut model = model("double-wishbone");
    let front = pose(&model, 0.02, 0.0);
    model.vehicle.axle = Some(Axle::Rear);
    let rear = pose(&model, 0.02, 0.0);
    let of = |name: &str, pose: &Pose<f64>| value(name, pose).unwrap();
    assert_eq!(of("anti_lift", &rear), -of("anti_dive", &front));
    assert_eq!(of("anti_squat", &rear), -of("anti_lift_drive", &front));
    assert_eq!(of("wheelbase_change", &rear), -of("wheelbase_change", &front));
    model.vehicle.brakes = Brakes::Inboard;
    let inboard = pose(&model, 0.02, 0.0);
    assert_eq!(of("tan_brake", &inboard), of("tan_drive", &inboard));
    assert_ne!(of("tan_brake", &inboard), of("tan_brake", &rear));
}

/// A wheel whose equilibrium is not known yet has no motion, so nothing is said by travel.
#[test]
fn free_wheel_has_a_motion_in_equilibrium_only() {
    let model = model("quarter-car");
    let setup = Setup { support: WheelSupport::Free, ..Setup::default() };
    let mut corner = Corner::new(&model, &setup).unwrap();
    let pose = corner.pose();
    assert!(pose.motions.is_none());
    assert_eq!(value("rc_height", &pose), None);
    let missing: Vec<Need> = find("rc_height").unwrap().missing(&pose).collect();
    assert_eq!(missing, [Need::Motion]);
    assert!(value("spring_length", &pose).is_some());
    corner.rest().unwrap();
    assert!(value("rc_height", &corner.pose()).is_some());
}

/// With bushings the wheel follows states of equilibrium, and so do its slopes.
#[test]
fn bushed_corner_has_the_slopes_of_its_equilibria() {
    let model = model("bushed-double-wishbone");
    let mut corner = Corner::new(&model, &Setup::default()).unwrap();
    let mut at = |travel: f64| {
        corner.move_to(travel, 0.0).unwrap();
        corner.pose()
    };
    let (here, h) = (at(0.01), 1e-3);
    let around = [at(0.01 - 2.0 * h), at(0.01 - h), at(0.01 + h), at(0.01 + 2.0 * h)];
    for (gradient, of, sign) in [
        ("bump_steer", "toe", 1.0),
        ("bump_camber", "camber", 1.0),
        ("center_velocity_x", "wheel_center_x", 1.0),
        ("motion_ratio", "spring_length", -1.0),
    ] {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| value(of, &around[k]).unwrap());
        near(gradient, &here, sign * (8.0 * (c - b) - (d - a)) / (12.0 * h), 1e-7);
    }
    // Rigid joints have other slopes.
    let setup = Setup { kinematic: true, ..Setup::default() };
    let mut rigid = Corner::new(&model, &setup).unwrap();
    rigid.move_to(0.01, 0.0).unwrap();
    let rigid = value("bump_steer", &rigid.pose()).unwrap();
    assert!((rigid - value("bump_steer", &here).unwrap()).abs() > 1e-4);
}
