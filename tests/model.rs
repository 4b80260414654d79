//! Models mean the same in every unit, axis system and on every side.
#![allow(missing_docs)]

use hardpoint::model::{
    Alignment, AngleUnit, Architecture, Axes, Document, LengthUnit, Model, Side,
};
use proptest::prelude::*;

const AXES: [Axes; 3] = [Axes::Iso8855, Axes::Adams, Axes::Sae];
const LENGTHS: [LengthUnit; 4] =
    [LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch];
const SEDAN: &str = include_str!("../models/double-wishbone.toml");
const EVERY_FORCE: &str = include_str!("fixtures/every-force.toml");

fn load(name: &str) -> Model {
    Model::load(format!("models/{name}.toml")).unwrap_or_else(|e| panic!("{}", e.render()))
}

fn parse(text: &str) -> Model {
    Model::parse("model.toml", text).unwrap_or_else(|e| panic!("{}", e.render()))
}

#[track_caller]
fn assert_near(actual: [f64; 3], expected: [f64; 3], tolerance: f64) {
    for (a, e) in actual.iter().zip(expected) {
        assert!((a - e).abs() <= tolerance, "{actual:?} is not {expected:?}");
    }
}

/// A model file in other units and axes, with the numbers of `model`.
fn written_as(model: &Model, axes: Axes, length: LengthUnit, angle: AngleUnit) -> String {
    let mut text = format!(
        "format = 1\nname = \"copy\"\narchitecture = \"double-wishbone\"\naxes = \"{}\"\n\
         side = \"{}\"\n[units]\nlength = \"{}\"\nangle = \"{}\"\n[wheel]\nradius = {:e}\n\
         toe = {:e}\ncamber = {:e}\n[points]\n",
        axes.name(),
        model.side.name(),
        length.symbol(),
        angle.symbol(),
        length.from_metres(model.wheel_radius),
        angle.from_radians(model.alignment().toe),
        angle.from_radians(model.alignment().camber),
    );
    for point in model.points() {
        let [x, y, z] = axes.from_iso(point.position).map(|c| length.from_metres(c));
        text += &format!("{} = [{x:e}, {y:e}, {z:e}]\n", point.name);
    }
    text
}

#[test]
fn shipped_models_load() {
    for entry in std::fs::read_dir("models").unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|end| end == "toml") {
            Document::load(&path).unwrap_or_else(|e| panic!("{}", e.render()));
        }
    }
}

#[test]
fn built_in_architectures_are_right() {
    let names = Architecture::built_in_names();
    assert!(names.contains(&"double-wishbone"));
    for name in names {
        let architecture = Architecture::built_in(name).unwrap();
        architecture.unwrap_or_else(|e| panic!("{}", e.render()));
    }
    assert!(Architecture::built_in("rocket").is_none());
}

#[test]
fn sedan_is_in_metres_and_iso_axes() {
    let model = load("double-wishbone");
    assert_eq!(model.side, Side::Left);
    assert_eq!(model.point("lca_front"), Some([0.2, 0.42, -0.27]));
    let center = model.point("wheel_center").unwrap();
    assert_near(center, [0.0, 0.7979, -0.1199], 1e-15);
    assert_eq!(model.point("strut_top"), None);
    assert_eq!(model.wheel_radius, 0.3266);
    // Toe 0.1° and camber −0.5°, as an independent kinematics program states the axis.
    let spin = [0.001_745_261_909_142_120_4, 0.999_960_400_035_453_5, 0.008_726_535_498_373_935];
    assert_near(model.spin_axis(), spin, 1e-15);
}

#[test]
fn lotus_points_turn_into_iso_axes() {
    let model = load("lotus-front");
    assert_eq!(model.side, Side::Right);
    // Lotus: x rearward, y right.
    assert_eq!(model.point("tierod_outer"), Some([0.12, -0.65, 0.225]));
    // The spindle lies inboard of the wheel centre, yet the axis points outboard.
    assert_eq!(model.spin_axis(), [0.0, -1.0, 0.0]);
    let alignment = model.alignment();
    assert_eq!((alignment.toe, alignment.camber), (0.0, 0.0));
}

#[test]
fn adams_left_side_has_positive_y_in_iso_axes() {
    let model = load("adams-tr-front");
    assert_eq!(model.side, Side::Left);
    assert_eq!(model.point("wheel_center"), Some([0.267, 0.76, 0.33]));
    assert_eq!(model.spin_axis(), [0.0, 1.0, 0.0]);
}

#[test]
fn a_model_means_the_same_in_all_axes_and_units() {
    let model = load("double-wishbone");
    for axes in AXES {
        for length in LENGTHS {
            for angle in [AngleUnit::Degree, AngleUnit::Radian] {
                let copy = parse(&written_as(&model, axes, length, angle));
                assert_eq!(copy.points().len(), model.points().len());
                for (a, b) in copy.points().iter().zip(model.points()) {
                    assert_eq!(a.name, b.name);
                    assert_near(a.position, b.position, 1e-15);
                }
                assert_near(copy.spin_axis(), model.spin_axis(), 1e-15);
                assert!((copy.wheel_radius - model.wheel_radius).abs() < 1e-15);
            }
        }
    }
}

#[test]
fn axes_map_the_named_directions() {
    // Forward, left and up in each system.
    let directions = [
        (Axes::Iso8855, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        (Axes::Adams, [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
        (Axes::Sae, [1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]),
    ];
    for (axes, forward, left, up) in directions {
        assert_eq!(axes.to_iso(forward), [1.0, 0.0, 0.0]);
        assert_eq!(axes.to_iso(left), [0.0, 1.0, 0.0]);
        assert_eq!(axes.to_iso(up), [0.0, 0.0, 1.0]);
        assert_eq!(axes.signs().iter().product::<f64>(), 1.0, "right-handed");
    }
}

#[test]
fn mirroring_changes_the_side_and_nothing_else() {
    for name in ["double-wishbone", "lotus-front", "adams-tr-front"] {
        let model = load(name);
        let mirrored = model.mirrored();
        assert_eq!(mirrored.side, model.side.other());
        for (a, b) in mirrored.points().iter().zip(model.points()) {
            assert_eq!(a.position, [b.position[0], 0.0 - b.position[1], b.position[2]]);
        }
        let (s, m) = (model.spin_axis(), mirrored.spin_axis());
        assert_eq!(m, [s[0], -s[1], s[2]]);
        assert_eq!(mirrored.alignment(), model.alignment());
        assert_eq!(mirrored.mirrored().points(), model.points());
        assert_eq!(mirrored.mirrored().side, model.side);
    }
}

#[test]
fn windows_line_ends_and_byte_order_mark_do_no_harm() {
    let model = parse(SEDAN);
    for text in [SEDAN.replace('\n', "\r\n"), format!("\u{feff}{SEDAN}")] {
        assert_eq!(parse(&text).points(), model.points());
    }
}

#[test]
fn points_move() {
    let mut model = parse(SEDAN);
    assert!(model.set_point("uca_outer", [0.0, 0.7, 0.1]));
    assert_eq!(model.point("uca_outer"), Some([0.0, 0.7, 0.1]));
    assert!(!model.set_point("strut_top", [0.0; 3]));
}

#[test]
fn architectures_of_the_user_are_relative_to_the_model() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("own-architecture");
    std::fs::create_dir_all(folder.join("parts")).unwrap();
    let architecture = include_str!("../architectures/double-wishbone.toml");
    let architecture = architecture.replace("lca_front", "lower_front");
    std::fs::write(folder.join("parts/mine.toml"), architecture).unwrap();
    let text = SEDAN
        .replace("\"double-wishbone\"", "\"parts/mine.toml\"")
        .replace("lca_front", "lower_front");
    std::fs::write(folder.join("model.toml"), text).unwrap();
    let model = Model::load(folder.join("model.toml")).unwrap_or_else(|e| panic!("{}", e.render()));
    assert_eq!(model.point("lower_front"), Some([0.2, 0.42, -0.27]));
}

#[test]
fn files_that_cannot_be_opened_are_named() {
    let missing = Model::load("models/no-such-model.toml").unwrap_err().render();
    assert!(missing.contains("there is no file `models/no-such-model.toml`"), "{missing}");
    let folder = Model::load("models").unwrap_err().render();
    assert!(folder.contains("`models` is a folder"), "{folder}");
}

proptest! {
    #[test]
    fn units_go_there_and_back(value in -1e6..1e6_f64) {
        for unit in LENGTHS {
            let back = unit.from_metres(unit.to_metres(value));
            prop_assert!((back - value).abs() <= 4.0 * f64::EPSILON * value.abs());
        }
        for unit in [AngleUnit::Degree, AngleUnit::Radian] {
            let back = unit.from_radians(unit.to_radians(value));
            prop_assert!((back - value).abs() <= 4.0 * f64::EPSILON * value.abs());
        }
    }

    #[test]
    fn axes_go_there_and_back(v in prop::array::uniform3(-10.0..10.0_f64),
                              m in prop::array::uniform3(prop::array::uniform3(-1.0..1.0_f64))) {
        let times = |m: [[f64; 3]; 3], v: [f64; 3]| m.map(|r| r[0] * v[0] + r[1] * v[1] + r[2] * v[2]);
        for axes in AXES {
            prop_assert_eq!(axes.from_iso(axes.to_iso(v)), v);
            prop_assert_eq!(axes.rotation_from_iso(axes.rotation_to_iso(m)), m);
            // A matrix turns vectors in the same way in both systems.
            let turned = axes.to_iso(times(m, v));
            let in_iso = times(axes.rotation_to_iso(m), axes.to_iso(v));
            for (a, b) in turned.iter().zip(in_iso) {
                prop_assert!((a - b).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn toe_and_camber_come_back_from_the_spin_axis(toe in -0.78..0.78_f64, camber in -0.78..0.78_f64) {
        for side in [Side::Left, Side::Right] {
            let spin = Alignment { toe, camber }.spin_axis(side);
            prop_assert!((spin.iter().map(|s| s * s).sum::<f64>() - 1.0).abs() < 1e-14);
            prop_assert!(spin[1] * side.sign() > 0.0, "points outboard");
            let back = Alignment::of_spin_axis(spin);
            prop_assert!((back.toe - toe).abs() < 1e-14);
            prop_assert!((back.camber - camber).abs() < 1e-14);
        }
    }

    #[test]
    fn no_text_panics(text in "\\PC{0,200}") {
        let _ = Model::parse("x.toml", &text).map_err(|e| e.render());
    }

    #[test]
    fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let text = String::from_utf8_lossy(&bytes);
        let _ = Model::parse("x.toml", &text).map_err(|e| e.render());
        let _ = Architecture::parse("x.toml", &text).map_err(|e| e.render());
    }

    /// Right files with a piece cut out, doubled or replaced reach the code behind the parser.
    #[test]
    fn no_damage_panics(start in 0.0..1.0_f64, length in 0..60_usize,
                        piece in prop::sample::select(vec!["", "[", "\"", "0", "nan", "lca_front", "é", "\n", " = ", "-1e300", "[]", "1e308", "\n[[forces]]\n"])) {
        let architecture = include_str!("../architectures/double-wishbone.toml");
        let mechanism = include_str!("../models/anti-roll-bar.toml");
        for text in [SEDAN, architecture, EVERY_FORCE, mechanism] {
            let start = text.floor_char_boundary((start * text.len() as f64) as usize);
            let end = text.ceil_char_boundary((start + length).min(text.len()));
            let damaged = format!("{}{piece}{}", &text[..start], &text[end..]);
            let _ = Model::parse("x.toml", &damaged).map_err(|e| e.render());
            let _ = Architecture::parse("x.toml", &damaged).map_err(|e| e.render());
            let _ = Document::parse("x.toml", &damaged).map_err(|e| e.render());
        }
    }
}
