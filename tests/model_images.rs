//! Forces mean the same in all axes, and their mirror image on the other side.
#![allow(missing_docs)]

#[path = "common/elements.rs"]
mod elements;

use elements::{Answer, answer};
use hardpoint::mechanism::{Direction, Force, ForceKind, Mechanism};
use hardpoint::model::{Axes, Chassis, Drive, Model, Setup, WheelSupport};
use hardpoint::relation::Coordinates;

const EVERY_FORCE: &str = include_str!("fixtures/every-force.toml");

fn parse(text: &str) -> Model {
    Model::parse("model.toml", text).unwrap_or_else(|e| panic!("{}", e.render()))
}

fn force<'m>(model: &'m Model, name: &str) -> &'m Force {
    model.forces().iter().find(|force| force.name == name).unwrap_or_else(|| panic!("{name}"))
}

/// The suspension of a file in ISO axes written in other axes, with every vector turned.
fn in_axes(text: &str, axes: Axes) -> Model {
    let turn = |line: &str| -> String {
        let Some((key, value)) = line.split_once(" = [") else {
            return match line.split_once("ground = ") {
                Some((before, z)) => {
                    let z = axes.from_iso([0.0, 0.0, z.parse().unwrap()])[2];
                    format!("{before}ground = {z}")
                }
                None => line.to_owned(),
            };
        };
        let numbers: Result<Vec<f64>, _> =
            value.trim_end_matches(']').split(", ").map(str::parse).collect();
        let principal = ["stiffness", "damping", "preload"].iter().any(|word| key.ends_with(word));
        match numbers.as_deref() {
            Ok(&[x, y, z]) if !principal => format!("{key} = {:?}", axes.from_iso([x, y, z])),
            Ok(&[xx, yy, zz, xy, xz, yz]) => {
                let [x, y, z] = axes.signs();
                format!("{key} = {:?}", [xx, yy, zz, x * y * xy, x * z * xz, y * z * yz])
            }
            _ => line.to_owned(),
        }
    };
    let text: Vec<String> = text.lines().map(turn).collect();
    parse(&text.join("\n").replace("\"iso8855\"", &format!("\"{}\"", axes.name())))
}

/// A state and its rate for every moving body, away from the design position.
fn random_motion(mechanism: &Mechanism) -> [Vec<Coordinates<f64>>; 2] {
    let mut random = fastrand::Rng::with_seed(5);
    let mut small = || 0.1 * (random.f64() - 0.5);
    let (mut state, mut velocity) = (vec![], vec![]);
    for (index, body) in mechanism.bodies().iter().enumerate() {
        let [x, y, z] = body.origin;
        let moving = |by: f64| if index == 0 { 0.0 } else { by };
        let e: [f64; 3] = std::array::from_fn(|_| moving(small()));
        let e0 = (1.0 - e.iter().map(|e| e * e).sum::<f64>()).sqrt();
        state.push([
            x + moving(small()),
            y + moving(small()),
            z + moving(small()),
            e0,
            e[0],
            e[1],
            e[2],
        ]);
        let v: [f64; 7] = std::array::from_fn(|_| moving(10.0 * small()));
        // Rates of Euler parameters lie across them.
        let along = e0 * v[3] + e[0] * v[4] + e[1] * v[5] + e[2] * v[6];
        let p = [e0, e[0], e[1], e[2]];
        velocity.push(std::array::from_fn(|k| if k < 3 { v[k] } else { v[k] - along * p[k - 3] }));
    }
    [state, velocity]
}

fn full(drive: Drive) -> Setup {
    Setup { drive, support: WheelSupport::Free, ..Setup::default() }
}

fn close(a: &Answer, b: &Answer, what: &str) {
    assert_eq!(a.force.len(), b.force.len());
    for (body, (a, b)) in a.force.iter().zip(&b.force).enumerate() {
        for k in 0..7 {
            let error = (a[k] - b[k]).abs();
            assert!(error <= 1e-9 * a[k].abs().max(1.0), "{what}, body {body}, {k}: {a:?} {b:?}");
        }
    }
}

#[test]
fn all_axes_mean_the_same_forces() {
    let reference =
        in_axes(EVERY_FORCE, Axes::Iso8855).suspension(&full(Drive::WheelCenter)).unwrap();
    let [state, velocity] = random_motion(&reference.mechanism);
    let expected = answer(&reference.mechanism, &state, &velocity);
    assert!(expected.force.iter().skip(1).filter(|f| f.iter().any(|x| x.abs() > 1.0)).count() > 2);
    for axes in [Axes::Adams, Axes::Sae] {
        let turned = in_axes(EVERY_FORCE, axes).suspension(&full(Drive::WheelCenter)).unwrap();
        close(&answer(&turned.mechanism, &state, &velocity), &expected, axes.name());
        for (a, b) in turned.mechanism.bodies().iter().zip(reference.mechanism.bodies()) {
            assert_eq!(a.mass.is_some(), b.mass.is_some());
            if let (Some(a), Some(b)) = (a.mass, b.mass) {
                assert_eq!((a.center, a.inertia), (b.center, b.inertia));
            }
        }
    }
}

/// A bushing without axes of its own has those of the file.
#[test]
fn default_axes_of_bushings_are_those_of_the_file() {
    for axes in [Axes::Iso8855, Axes::Adams, Axes::Sae] {
        let text = EVERY_FORCE.replace("x_axis = [\"lca_front\", \"lca_rear\"]\n", "");
        let model = in_axes(&text, axes);
        let ForceKind::Bushing(bushing) = &force(&model, "bush").kind else { panic!() };
        assert_eq!(bushing.axes.x, Direction::Fixed(axes.to_iso([1.0, 0.0, 0.0])));
        let torsion = text.replace("axis = [\"lca_rear\", \"lca_front\"]", "axis = \"x\"");
        let model = in_axes(&torsion, axes);
        let ForceKind::Torsion { axis, .. } = force(&model, "torsion_bar").kind else { panic!() };
        assert_eq!(axis, Direction::Fixed(axes.to_iso([1.0, 0.0, 0.0])));
    }
}

/// The coordinates of the mirror image: y changes its sign, and rotations about x and z theirs.
fn mirrored(q: &[f64; 7]) -> [f64; 7] {
    [q[0], -q[1], q[2], q[3], -q[4], q[5], -q[6]]
}

/// A steering gear that gives way, a hub bearing and a subframe, with one mount beside the centre line and one
/// on it.
const FITTINGS: &str = "
[steering]
mount_stiffness = 8.0

[hub_bearing]
radial = 180.0
axial = 90.0
tilt = [7000.0, 6000.0]

[subframe]
carries = [\"lca_pivot\", \"rack_slide\"]

[subframe.mounts.beside]
at = \"patch\"
x_axis = [\"uca_rear\", \"uca_front\"]
stiffness = [2.5, 6.0, 4.0]
rotational_stiffness = [90.0, 70.0, 50.0]
preload = [0.1, 0.2, 0.3]

[subframe.mounts.middle]
at = \"middle\"
stiffness = [2.5, 6.0, 4.0]
";

#[test]
fn the_mirrored_model_has_the_mirrored_forces() {
    let points = "\nmiddle = [-400.0, 0.0, -200.0]\n\n[wheel]";
    let fitted = EVERY_FORCE.replace("\n[wheel]", points) + FITTINGS;
    for model in [parse(EVERY_FORCE), parse(&fitted)] {
        assert_mirrored(&model);
    }
}

fn assert_mirrored(model: &Model) {
    for chassis in [Chassis::Fixed, Chassis::Slide] {
        let setup = Setup { chassis, ..full(Drive::ContactPatch) };
        let left = model.suspension(&setup).unwrap().mechanism;
        let right = model.mirrored().suspension(&setup).unwrap().mechanism;
        let [state, velocity] = random_motion(&left);
        let expected = answer(&left, &state, &velocity);
        let image = |list: &[Coordinates<f64>]| list.iter().map(mirrored).collect::<Vec<_>>();
        let found = answer(&right, &image(&state), &image(&velocity));
        let back = Answer { force: image(&found.force), values: found.values };
        close(&back, &expected, "mirror image");
    }
    let (mass, image) = (model.mass("upright").unwrap(), model.mirrored().mass("upright").unwrap());
    assert_eq!(image.center, [mass.center[0], -mass.center[1], mass.center[2]]);
    assert_eq!(image.inertia, [0.85, 1.3, 0.95, -0.01, -0.02, -0.03]);
    let twice = model.mirrored().mirrored();
    assert_eq!(twice.forces(), model.forces());
    assert_eq!(twice.bushings(), model.bushings());
}
