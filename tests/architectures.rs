//! Every built-in architecture with its example model: freedom, symmetry, and kinematics checked from the
//! positions of points alone.
#![allow(missing_docs)]

#[path = "common/joints.rs"]
mod joints;

use std::fs;
use std::path::PathBuf;

use hardpoint::mechanism::{DriverId, Mechanism};
use hardpoint::model::{Architecture, Model, Setup, Side};
use hardpoint::report::{drawing, write_catalogue};
use hardpoint::rig::Axle;
use hardpoint::solve::System;
use joints::{distance, largest_error};

/// Motions that joints leave free with the rack held, as tabulated for one side, or for an axle where the
/// sides are one mechanism. Those of [`ELASTIC`] leave too little or too much for an axle.
const FREE: [(&str, usize); 35] = [
    ("double-wishbone", 1),
    ("double-wishbone-pitman", 1),
    ("double-wishbone-pullrod", 1),
    ("double-wishbone-pushrod", 1),
    ("double-wishbone-pushrod-t-bar", 2),
    ("double-wishbone-reduced", 1),
    ("five-link", 1),
    ("five-link-steered", 1),
    ("h-arm", 1),
    ("integral-link", 1),
    ("macpherson", 1),
    ("macpherson-two-links", 1),
    ("semi-trailing-arm", 1),
    ("split-lower-arm", 1),
    ("three-link-irs", 1),
    ("trailing-arm", 1),
    ("de-dion", 2),
    ("de-dion-toe-bar", 2),
    ("leaf-spring-axle", 2),
    ("leaf-spring-axle-toe-bar", 2),
    ("push-pipe", 2),
    ("push-pipe-toe-bar", 2),
    ("rigid-panhard-axle", 2),
    ("rigid-panhard-axle-toe-bar", 2),
    ("solid-axle", 2),
    ("solid-axle-bellcrank", 2),
    ("solid-axle-panhard", 2),
    ("solid-axle-steered", 2),
    ("solid-axle-three-link", 2),
    ("solid-axle-three-link-bellcrank", 2),
    ("solid-axle-watt", 2),
    ("solid-axle-four-trailing-links", 1),
    ("twist-beam", 1),
    ("sae-leaf-spring-axle", 4),
    ("sae-leaf-spring-axle-toe-bar", 4),
];

/// Axles that move in equilibrium only: in bushings that take the place of joints, or held by springs where joints
/// do not.
const ELASTIC: [&str; 4] = [
    "solid-axle-four-trailing-links",
    "twist-beam",
    "sae-leaf-spring-axle",
    "sae-leaf-spring-axle-toe-bar",
];

const RIGID: Setup = Setup {
    drive: hardpoint::model::Drive::WheelCenter,
    support: hardpoint::model::WheelSupport::Held,
    chassis: hardpoint::model::Chassis::Fixed,
    kinematic: true,
};

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn model(name: &str) -> Model {
    let file = path(&format!("models/{name}.toml"));
    Model::load(file).unwrap_or_else(|error| panic!("{}", error.render()))
}

/// What moves, and its travels and rack.
fn rigid(model: &Model) -> (Mechanism, Vec<DriverId>, Option<DriverId>) {
    if model.is_axle() {
        let axle = model.axle(&RIGID).unwrap();
        return (axle.mechanism, axle.sides.map(|side| side.travel).to_vec(), axle.rack);
    }
    let corner = model.suspension(&RIGID).unwrap();
    (corner.mechanism, vec![corner.travel], corner.rack)
}

/// The architectures whose joints alone move as an axle or a corner does.
fn rigid_names() -> impl Iterator<Item = &'static str> {
    FREE.into_iter().map(|(name, _)| name).filter(|name| !ELASTIC.contains(name))
}

/// Travels (m) of the left and the right wheel, or of the wheel alone.
fn travels(wheels: usize) -> Vec<Vec<f64>> {
    let range = [0.02, 0.04, 0.06, 0.08, 0.04, 0.0, -0.02, -0.04, -0.06, -0.08];
    let parallel = range.iter().map(|travel| vec![*travel; wheels]);
    let opposite = range.iter().map(|travel| vec![*travel, -travel]);
    parallel.chain(opposite.filter(|_| wheels == 2)).collect()
}

#[test]
fn every_architecture_has_an_example_and_a_tabulated_freedom() {
    let mut tabulated: Vec<_> = FREE.iter().map(|(name, _)| *name).collect();
    tabulated.sort_unstable();
    assert_eq!(tabulated, Architecture::built_in_names());
    for (name, free) in FREE {
        let model = model(name);
        let built_in = Architecture::built_in(name).unwrap().unwrap();
        assert_eq!(model.architecture.title(), built_in.title(), "{name}");
        let (mut mechanism, travels, rack) = rigid(&model);
        // Rule of Grübler on the one hand, the rank of the equations on the other.
        let equations: usize = mechanism.joints().iter().map(|joint| joint.kind.equations()).sum();
        let bodies = mechanism.bodies().len() - 1;
        let held = usize::from(rack.is_some());
        assert_eq!(6 * bodies - equations - held, free, "{name}");
        if free < travels.len() {
            // Two travels cannot be driven: refused at once, or, where the sides hold each other in second
            // order only, on the way.
            let moved = System::new(mechanism).map(|mut system| {
                system.move_to(&[(travels[0], 0.05), (travels[1], -0.05)]).map(drop)
            });
            assert!(!matches!(moved, Ok(Ok(()))), "{name} rolls without bushings");
            continue;
        }
        mechanism = rigid(&model).0;
        let system = System::new(mechanism).unwrap();
        let exact = free == travels.len();
        assert_eq!(system.freedom().is_exact(), exact, "{name}: {}", system.freedom());
        assert_eq!(system.freedom().degrees_of_freedom - held, free, "{name}");
    }
}

/// Bars keep their lengths, joints their points and axes, to 1e-10 m, at every state of ±80 mm.
#[test]
fn joints_hold_over_the_travel() {
    for name in rigid_names() {
        let (mechanism, drivers, _) = rigid(&model(name));
        let mut system = System::new(mechanism).unwrap();
        for travel in travels(drivers.len()) {
            let targets: Vec<_> = drivers.iter().copied().zip(travel.iter().copied()).collect();
            system.move_to(&targets).unwrap_or_else(|stop| panic!("{name}: {stop}"));
            let (error, joint) = largest_error(&system);
            assert!(error < 1e-10, "{name} at {travel:?}: {joint} is off by {error:e}");
        }
    }
}

/// The check above notices a body that is a hundredth of a millimetre away.
#[test]
fn the_check_of_joints_sees_what_does_not_hold() {
    let (mechanism, drivers, _) = rigid(&model("five-link"));
    let mut system = System::new(mechanism).unwrap();
    system.move_to(&[(drivers[0], 0.05)]).unwrap();
    assert!(largest_error(&system).0 < 1e-10);
    assert!(joints::largest_error_of(&system, 1e-5).0 > 1e-6);
}

/// The mirror image of a model moves as the mirror image of its motion: left and right change places.
#[test]
fn mirror_images_move_alike() {
    for name in rigid_names() {
        let [here, there] = [model(name), model(name).mirrored()];
        let (mechanism, drivers, rack) = rigid(&here);
        let (image, image_drivers, image_rack) = rigid(&there);
        let mut systems = [mechanism, image].map(|mechanism| System::new(mechanism).unwrap());
        for (travel, steer) in
            [([0.08, 0.08], 0.0), ([0.05, -0.03], 0.004), ([-0.08, 0.02], -0.004)]
        {
            let mut targets: Vec<_> = drivers.iter().copied().zip(travel).collect();
            let mut exchanged = travel[..drivers.len()].to_vec();
            exchanged.reverse();
            let mut image_targets: Vec<_> = image_drivers.iter().copied().zip(exchanged).collect();
            targets.extend(rack.map(|rack| (rack, steer)));
            // The rack moves along y.
            image_targets.extend(image_rack.map(|rack| (rack, -steer)));
            systems[0].move_to(&targets).unwrap_or_else(|stop| panic!("{name}: {stop}"));
            systems[1].move_to(&image_targets).unwrap_or_else(|stop| panic!("{name}: {stop}"));
            let [system, image] = &systems;
            for (body, point, place) in joints::places(system) {
                let [body, point] = [body, point].map(|name| exchange(&name));
                let [x, y, z] = joints::place(image, &body, &point);
                let off = distance([x, -y, z], place);
                assert!(off < 1e-10, "{name}: {point} of {body} is off by {off:e}");
            }
        }
    }
}

/// The name on the other side.
fn exchange(name: &str) -> String {
    let to = |from: &str, to: &str| name.strip_prefix(from).map(|rest| format!("{to}{rest}"));
    to("left_", "right_").or_else(|| to("right_", "left_")).unwrap_or(name.to_owned())
}

/// A trailing arm is a circle about its axis: the closed form of its wheel centre.
#[test]
fn a_trailing_arm_moves_on_a_circle() {
    let model = model("trailing-arm");
    let [pivot, center] = ["arm_inner", "wheel_center"].map(|name| model.point(name).unwrap());
    let (dx, dz) = (center[0] - pivot[0], center[2] - pivot[2]);
    let radius = dx.hypot(dz);
    let (mechanism, drivers, _) = rigid(&model);
    let mut system = System::new(mechanism).unwrap();
    for [travel] in travels(1).into_iter().map(|travel| [travel[0]]) {
        system.move_to(&[(drivers[0], travel)]).unwrap();
        let [x, y, z] = joints::place(&system, "arm", "wheel_center");
        let height = dz + travel;
        let expected = pivot[0] - (radius * radius - height * height).sqrt();
        assert!((x - expected).abs() < 1e-10 && (y - center[1]).abs() < 1e-10);
        assert!((z - center[2] - travel).abs() < 1e-10);
    }
}

/// With equal links on both sides of its bell crank a Watt linkage leads the pivot nearly straight, where a
/// Panhard rod leads it on a circle.
#[test]
fn a_watt_linkage_leads_straighter_than_a_panhard_rod() {
    let aside = |name: &str| {
        let (mechanism, drivers, _) = rigid(&model(name));
        let mut system = System::new(mechanism).unwrap();
        let middle = |system: &System| {
            let [left, right] = ["left_wheel_center", "right_wheel_center"]
                .map(|point| joints::place(system, "axle", point)[1]);
            (left + right) / 2.0
        };
        let design = middle(&system);
        system.move_to(&[(drivers[0], 0.08), (drivers[1], 0.08)]).unwrap();
        (middle(&system) - design).abs()
    };
    let (watt, panhard) = (aside("solid-axle-watt"), aside("solid-axle-panhard"));
    assert!(watt < 1e-4, "{watt}");
    assert!(panhard > 1e-3, "{panhard}");
}

/// Where joints alone do not move, bushings and springs do: the sweep in equilibrium, and its mirror image.
#[test]
fn elastic_axles_sweep_in_equilibrium() {
    for name in ELASTIC {
        let (model, image) = (model(name), model(name).mirrored());
        let mut axles = [&model, &image].map(|model| Axle::new(model, &Setup::default()).unwrap());
        for travel in travels(2) {
            let [left, right] = [travel[0], travel[1]];
            for (axle, travel) in axles.iter_mut().zip([[left, right], [right, left]]) {
                axle.move_to(travel, 0.0).unwrap_or_else(|stop| panic!("{name}: {stop}"));
            }
            let [axle, image] = &mut axles;
            for side in [Side::Left, Side::Right] {
                let [x, y, z] = axle.pose(side).wheel.center;
                let there = image.pose(side.other()).wheel.center;
                let off = distance([x, -y, z], there);
                assert!(off < 1e-8, "{name} at {travel:?}: off by {off:e}");
            }
        }
    }
}

/// Roll twists the beam, heave does not.
#[test]
fn a_twist_beam_twists_in_roll_only() {
    let model = model("twist-beam");
    let mut axle = Axle::new(&model, &Setup::default()).unwrap();
    let mut twist = |travel: [f64; 2]| {
        axle.move_to(travel, 0.0).unwrap();
        let channel = axle.element_channels().iter().position(|c| c.name == "twist_angle");
        let channel = channel.expect("the beam has an angle");
        hardpoint::rig::Specimen::channel_values(&axle)[channel]
    };
    assert!(twist([0.05, 0.05]).abs() < 1e-9);
    // Half the difference of the heights over the length of the arms, about 430 mm.
    let rolled = twist([0.05, -0.05]).abs();
    assert!((0.1..0.4).contains(&rolled), "{rolled}");
}

/// An axle that leaf springs lead straight: its wheels go up and down, and in roll about its centre.
#[test]
fn a_straight_axle_rolls_about_its_centre() {
    let (mechanism, drivers, _) = rigid(&model("leaf-spring-axle"));
    let mut system = System::new(mechanism).unwrap();
    for travel in travels(2) {
        let targets: Vec<_> = drivers.iter().copied().zip(travel.iter().copied()).collect();
        system.move_to(&targets).unwrap();
        let (half, roll) = (0.74, (travel[0] - travel[1]) / 2.0);
        let [x, y, z] = joints::place(&system, "axle", "left_wheel_center");
        let aside = (half * half - roll * roll).sqrt();
        assert!(x.abs() < 1e-10 && (y - aside).abs() < 1e-10, "{travel:?}: {x} {y}");
        assert!((z - travel[0]).abs() < 1e-10, "{travel:?}: {z}");
    }
}

/// A leaf bends by the travel over its length, so the rate at the wheel is that of both its bending springs by
/// the squares of their lengths; the shackle and the preload change it by some percent.
#[test]
fn leaves_carry_the_wheel() {
    let mut axle = Axle::new(&model("sae-leaf-spring-axle"), &Setup::default()).unwrap();
    let mut load = |travel| {
        axle.move_to([travel, travel], 0.0).unwrap();
        let load = axle.pose(Side::Left).load.map(|load| load.force);
        load.expect("its springs hold it")
    };
    let (below, at, above) = (load(-0.001), load(0.0), load(0.001));
    // 170 N·m/deg at both clamps, 450 mm from the eyes; 2500 N of preload.
    let bending = 170.0_f64 * 180.0 / std::f64::consts::PI;
    let expected = 2.0 * bending / (0.45 * 0.45);
    let rate = (above - below) / 0.002;
    assert!((rate / expected - 1.0).abs() < 0.1, "{rate} N/m, not about {expected}");
    assert!((at / 2500.0 - 1.0).abs() < 0.05, "{at} N");
}

#[test]
fn corners_of_whole_axles_are_refused() {
    let error = model("solid-axle").suspension(&Setup::default()).unwrap_err().to_string();
    assert!(error.contains("`Solid axle on four links`"), "{error}");
}

/// The example of the documents is an architecture that moves.
#[test]
fn the_suspension_of_ones_own_is_right() {
    let text = fs::read_to_string(path("docs/architectures.md")).unwrap().replace("\r\n", "\n");
    let examples: Vec<&str> = text.split("```toml\n").skip(1).collect();
    let example = |number: usize| examples[number].split_once("```").unwrap().0;
    let own = Architecture::parse("swing-axle.toml", example(0))
        .unwrap_or_else(|e| panic!("{}", e.render()));
    assert_eq!(own.bushed_joints().collect::<Vec<_>>(), ["arm_pivot"]);
    assert!(!own.is_axle());
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("swing-axle.toml"), example(0)).unwrap();
    let car = folder.path().join("my-car.toml");
    fs::write(&car, example(1)).unwrap();
    let car = Model::load(car).unwrap_or_else(|e| panic!("{}", e.render()));
    let (mechanism, drivers, _) = rigid(&car);
    let mut system = System::new(mechanism).unwrap();
    assert!(system.freedom().is_exact());
    // The wheel goes on a circle about the pivots.
    for travel in [-0.08, 0.08] {
        system.move_to(&[(drivers[0], travel)]).unwrap();
        let [_, y, z] = joints::place(&system, "arm", "wheel_center");
        assert!((z - travel).abs() < 1e-12 && ((y - 0.12).hypot(z) - 0.58).abs() < 1e-12);
    }
}

/// The rack of an architecture with a pitman arm: the joint at its end goes along y as prescribed, on a circle
/// about the shaft.
#[test]
fn a_pitman_arm_turns() {
    let (mechanism, drivers, rack) = rigid(&model("double-wishbone-pitman"));
    let mut system = System::new(mechanism).unwrap();
    let design = joints::place(&system, "pitman", "pitman_outer");
    for way in [-0.03, 0.03] {
        system.move_to(&[(drivers[0], 0.02), (rack.unwrap(), way)]).unwrap();
        let moved = joints::place(&system, "pitman", "pitman_outer");
        assert!((moved[1] - design[1] - way).abs() < 1e-10);
        let pivot = joints::place(&system, "pitman", "pitman_pivot");
        assert!((distance(moved, pivot) - distance(design, pivot)).abs() < 1e-10);
        assert!(largest_error(&system).0 < 1e-10);
    }
}

#[test]
fn the_drawings_are_those_of_the_examples() {
    for (name, _) in FREE {
        let svg = drawing(&model(name)).unwrap();
        let file = format!("docs/architectures/{name}.svg");
        let committed = fs::read_to_string(path(&file)).unwrap_or_default();
        let old = committed.replace("\r\n", "\n") != svg;
        assert!(!old, "{file} is old; draw it anew: hardpoint draw models/{name}.toml -o {file}");
    }
}

#[test]
fn the_catalogue_is_that_of_the_data() {
    let mut text = vec![];
    write_catalogue(&mut text).unwrap();
    let committed = fs::read_to_string(path("docs/architectures/README.md")).unwrap_or_default();
    assert!(
        committed.replace("\r\n", "\n") == String::from_utf8(text).unwrap(),
        "docs/architectures/README.md is old; write it anew: hardpoint architectures --list -o \
         docs/architectures/README.md"
    );
}
