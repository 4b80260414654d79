//! Files of other programs become models with the same numbers.
#![allow(missing_docs)]

use std::fs;

use hardpoint::export::{self, Format};
use hardpoint::import::{self, Imported, Options};
use hardpoint::model::{Architecture, Axes, Axle, Document, LengthUnit, Model, Setup, Side};
use hardpoint::rig::{Corner, Event, Held, Sweep, SweepPlan};
use hardpoint::solve::System;

const FIXTURES: &str = "tests/fixtures/import";

fn read(path: &str) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

#[track_caller]
fn imported_with(file: &str, options: &Options) -> Imported {
    let path = format!("{FIXTURES}/{file}");
    import::import_with(&path, &read(&path), options)
        .unwrap_or_else(|error| panic!("{}", error.diagnostics().render()))
}

#[track_caller]
fn imported(file: &str) -> Imported {
    imported_with(file, &Options::default())
}

/// The message of an import that fails.
#[track_caller]
fn refused(name: &str, text: &str, options: &Options) -> String {
    import::import_with(name, text, options)
        .expect_err("it should not import")
        .diagnostics()
        .render()
}

#[track_caller]
fn model(imported: &Imported) -> Model {
    Model::parse("imported.toml", &imported.text).unwrap_or_else(|e| panic!("{}", e.render()))
}

fn table(imported: &Imported) -> toml::Table {
    imported.text.parse().expect("it is TOML")
}

fn numbers(value: &toml::Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_float().expect("a number")).collect()
}

/// Lines and texts of what was left out.
fn left_out(imported: &Imported) -> Vec<(usize, &str)> {
    imported.left_out.iter().map(|item| (item.line, item.what.as_str())).collect()
}

#[test]
fn a_subsystem_of_adams_comes_with_its_property_files() {
    let imported = imported("car.cdb/subsystems.tbl/front.sub");
    let table = table(&imported);
    assert_eq!(numbers(&table["points"]["lca_outer"]), [1.25, -750.0, 100.0]);
    assert_eq!(numbers(&table["points"]["damper_upper"]), [40.0, -500.0, 650.0]);
    assert_eq!(table["wheel"]["toe"].as_float(), Some(0.1));
    assert_eq!(table["wheel"]["camber"].as_float(), Some(-0.5));
    let forces = table["forces"].as_array().unwrap();
    let kinds: Vec<&str> = forces.iter().map(|force| force["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["spring", "damper", "bump-stop"]);
    assert_eq!(forces[0]["preload"].as_float(), Some(4500.0));
    assert_eq!(numbers(&forces[1]["table"][2]), [1000.0, 3000.0]);
    // The property file of the bushing is in metres and its z axis is that of the joint: z is x here, x is y.
    let front = &table["bushings"]["lca_front_bushing"];
    assert_eq!(numbers(&front["tables"]["x"][2]), [2.0, 6000.0]);
    assert_eq!(numbers(&front["tables"]["y"][2]), [2.0, 12000.0]);
    assert_eq!(numbers(&front["preload"]), [0.0, 12.0, 0.0]);
    assert_eq!(numbers(&front["damping"]), [0.5, 1.0, 1.0]);
    let torque = numbers(&front["tables"]["rx"][2]);
    assert!((torque[0] - 10.0).abs() < 1e-12 && (torque[1] - 25000.0).abs() < 1e-9, "{torque:?}");
    let lines = left_out(&imported);
    assert!(lines.contains(&(24, "the point `drive_shaft_inr`")), "{lines:?}");
    assert!(lines.contains(&(84, "[BUSHING_ASSEMBLY] `subframe_front`")), "{lines:?}");
    assert!(lines.contains(&(89, "[PART_ASSEMBLY] `lower_control_arm`")), "{lines:?}");
    assert!(imported.assumed.iter().any(|assumed| assumed.contains("wheel radius")));

    // It moves, on its bushings and on rigid joints, and the spring starts with its preload.
    let model = model(&imported);
    for kinematic in [false, true] {
        let setup = Setup { kinematic, ..Setup::default() };
        let mut corner = Corner::new(&model, &setup).unwrap();
        let plan = SweepPlan {
            event: Event::Travel,
            from: -0.05,
            to: 0.05,
            step: 0.025,
            held: Held::default(),
        };
        let sweep = Sweep::run(&mut corner, &plan, |_| {});
        assert!(sweep.stops.is_empty(), "{:?}", sweep.stops);
        assert_eq!(sweep.rows.len(), 5);
    }
}

#[test]
fn the_right_side_of_a_symmetric_subsystem_is_its_mirror_image() {
    let right = Options { side: Some(Side::Right), ..Options::default() };
    let right = model(&imported_with("car.cdb/subsystems.tbl/front.sub", &right));
    let left = model(&imported("car.cdb/subsystems.tbl/front.sub"));
    assert_eq!(right.side, Side::Right);
    for point in left.points() {
        let [x, y, z] = point.position;
        assert_eq!(right.point(&point.name), Some([x, -y, z]), "{}", point.name);
    }
}

#[test]
fn an_assembly_leads_to_its_suspension() {
    let assembly = imported("car.cdb/assemblies.tbl/car.asy");
    assert_eq!(assembly.text, imported("car.cdb/subsystems.tbl/front.sub").text);
    let body = assembly.left_out.iter().find(|item| item.what.contains("body.sub")).unwrap();
    assert!(body.line == 16 && body.why.contains("is not there"), "{body:?}");
    let options = Options { axle: Some(Axle::Rear), ..Options::default() };
    let path = format!("{FIXTURES}/car.cdb/assemblies.tbl/car.asy");
    let message = refused(&path, &read(&path), &options);
    assert!(
        message.contains("body.sub` is not there") && message.contains("--database"),
        "{message}"
    );
}

#[test]
fn databases_are_found_by_their_names() {
    let text = read(&format!("{FIXTURES}/car.cdb/subsystems.tbl/front.sub"));
    let lost = import::import("elsewhere/front.sub", &text).unwrap();
    assert!(!lost.text.contains("[[forces]]") && !lost.text.contains("[bushings"));
    let why = &lost.left_out.iter().find(|item| item.what.contains("ride_spring")).unwrap().why;
    assert!(why.contains("coil.spr") && why.contains("--database"), "{why}");
    let root = format!("{FIXTURES}/car.cdb").into();
    let options = Options { databases: vec![("CAR".to_owned(), root)], ..Options::default() };
    let found = import::import_with("elsewhere/front.sub", &text, &options).unwrap();
    assert!(found.text.contains("[bushings.lca_rear_bushing]"), "{}", found.text);
}

#[test]
fn a_table_and_a_file_of_lotus_hold_the_same_points() {
    let (shark, report) = (imported("lotus.shk"), imported("lotus-table.txt"));
    let (shark_table, report_table) = (table(&shark), table(&report));
    assert_eq!(shark_table["points"], report_table["points"]);
    assert_eq!(numbers(&shark_table["points"]["lca_front"]), [-110.5, 257.0, 69.0]);
    assert_eq!(shark_table["wheel"]["radius"].as_float(), Some(270.0));
    let model = model(&shark);
    assert_eq!((model.side, model.axes), (Side::Right, Axes::Adams));
    assert!(left_out(&shark).contains(&(165, "`TYRE`")), "{:?}", left_out(&shark));
    assert!(
        left_out(&report).contains(&(18, "the point `Part 1 C of G`")),
        "{:?}",
        left_out(&report)
    );

    // The numbers of the points are enough for those of template type 1.
    let text: String = read(&format!("{FIXTURES}/lotus-table.txt"))
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .filter(|words| words.len() > 4 && words[0] != "20")
        .map(|words| [&words[..1], &words[words.len() - 3..]].concat().join(" ") + "\n")
        .collect();
    let bare = import::import("points.txt", &text).unwrap();
    assert_eq!(table(&bare)["points"], report_table["points"]);
}

#[test]
fn tables_of_points_are_read_as_teams_write_them() {
    let imported_points = imported("points.csv");
    let points = &table(&imported_points)["points"];
    assert_eq!(numbers(&points["lca_front"]), [200.1, 420.0, -270.0]);
    assert_eq!(left_out(&imported_points), [(14, "the point `Mystery bracket`")]);
    assert_eq!(model(&imported_points).side, Side::Left);

    let options = Options {
        architecture: Some("double-wishbone".to_owned()),
        length: Some(LengthUnit::Millimetre),
        axes: Some(Axes::Iso8855),
        axle: Some(Axle::Rear),
        wheel_radius: Some(228.6),
        ..Options::default()
    };
    let rear = imported_with("team.csv", &options);
    let found = table(&rear);
    assert_eq!(numbers(&found["points"]["lca_front"]), [-1450.0, 200.5, 120.0]);
    assert_eq!(found["wheel"]["radius"].as_float(), Some(228.6));
    let front = Options { axle: Some(Axle::Front), ..options.clone() };
    let front = imported_with("team.csv", &front);
    let mirrored = (62, "the point `LCA_O_R`");
    assert!(left_out(&front).contains(&mirrored), "{:?}", left_out(&front));

    let text = read(&format!("{FIXTURES}/team.csv"));
    let message = refused("team.csv", &text, &Options { axle: None, ..options });
    assert!(message.contains("--axle front"), "{message}");
}

#[test]
fn nothing_is_guessed() {
    let rows = "lca_front,1,2,3\n";
    let double_wishbone =
        Options { architecture: Some("double-wishbone".into()), ..Options::default() };
    for (text, options, words) in [
        (rows, Options::default(), "--architecture"),
        (rows, double_wishbone.clone(), "--length mm"),
        ("name,x [mm],y,z\nlca_front,1,2,3\n", double_wishbone.clone(), "--axes"),
        (
            "# length = ells\nlca_front,1,2,3\n",
            double_wishbone.clone(),
            "`ells` is no unit of length",
        ),
        ("lca_front,1,two,3\n", double_wishbone.clone(), "`two` in the row of `lca_front`"),
        ("lca_front,1,2\n", double_wishbone.clone(), "`lca_front` lacks a number in column 4"),
        ("lca_front,1,2,inf\n", double_wishbone.clone(), "`inf` in the row"),
        (
            "# length = mm\n# axes = iso8855\nlca_front,1,2,3\nLCA-F,4,5,6\n",
            double_wishbone.clone(),
            "are both the point `lca_front`",
        ),
        (
            "# length = mm\n# axes = iso8855\nlca_front,1,2,3\n",
            double_wishbone,
            "lca_rear: Lower control arm",
        ),
    ] {
        let message = refused("points.csv", text, &options);
        assert!(message.contains(words), "{text}: {message}");
    }
}

#[test]
fn files_that_are_no_suspension_are_refused_with_what_to_do() {
    let none = Options::default();
    let header = "[MDI_HEADER]\nFILE_TYPE = 'spr'\n";
    for (name, text, words) in [
        ("x.json", "{\"Type\": \"Wheel\"}", "a file of type `Wheel`"),
        (
            "x.json",
            "{\"Type\": \"Suspension\", \"Template\": \"Hover\"}",
            "Chrono's template `Hover`",
        ),
        ("x.json", "{\"a\": [1, }", "this is not valid JSON"),
        ("x.json", "{\"a\": 1, \"a\": 2}", "`a` stands twice"),
        ("x.json", "{\"a\": 1e999}", "no number that fits"),
        ("x.json", "", "empty"),
        ("x.spr", header, "import the subsystem (.sub)"),
        ("x.sub", "<?xml version='1.0'?>", "XML"),
        ("x.sub", "LENGTH = 'mm'\n", "before the first block"),
        (
            "x.sub",
            "[MDI_HEADER]\nFILE_TYPE = 'sub'\n[SUBSYSTEM_HEADER]\nTEMPLATE_NAME = '_hover'\n",
            "template `_hover`",
        ),
        (
            "x.sub",
            "[MDI_HEADER]\nFILE_TYPE='sub'\n[SUBSYSTEM_HEADER]\nTEMPLATE_NAME='_double_wishbone'\n[UNITS]\nLENGTH='ell'\n",
            "the unit `ell`",
        ),
        ("x.shk", "TEMP_SETTINGS\n1\nname\n9999 9999\n", "fewer lines"),
        ("x.dat", "hello", "format of this file is not known"),
    ] {
        let message = refused(name, text, &none);
        assert!(message.contains(words), "{name} {text}: {message}");
    }
}

#[test]
fn a_strut_of_chrono_keeps_springs_stops_masses_and_angles() {
    let options = Options { wheel_radius: Some(0.31), ..Options::default() };
    let imported = imported_with("strut.json", &options);
    let table = table(&imported);
    assert_eq!(numbers(&table["points"]["strut_upper"]), [-0.03, 0.58, 0.55]);
    assert!((table["wheel"]["toe"].as_float().unwrap().to_degrees() - 0.25).abs() < 1e-15);
    assert!((table["wheel"]["camber"].as_float().unwrap().to_degrees() + 1.0).abs() < 1e-15);
    // Inertias of the arm are in the axes of the vehicle, as the file says.
    let arm = &table["bodies"]["lca"];
    assert_eq!(numbers(&arm["inertia"]), [0.03, 0.05, 0.03, 0.001, 0.0, 0.0]);
    // Upright of 20 kg and spindle of 10 kg, 60 mm apart in y: 20·10/30·0.06² = 0.024 about x and z.
    let upright = &table["bodies"]["upright"];
    assert_eq!(upright["mass"].as_float(), Some(30.0));
    let inertia = numbers(&upright["inertia"]);
    for (found, expected) in inertia.iter().zip([0.2 + 0.04 + 0.024, 0.27, 0.05 + 0.04 + 0.024]) {
        assert!((found - expected).abs() < 1e-15, "{inertia:?}");
    }
    let forces = table["forces"].as_array().unwrap();
    let kinds: Vec<&str> = forces.iter().map(|force| force["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["spring", "bump-stop", "rebound-stop", "damper"]);
    // f = 100 N − F(l − l0): compressed by 0.2 m it pushes with 9100 N.
    let rows = forces[0]["table"].as_array().unwrap();
    let rows: Vec<Vec<f64>> = rows.iter().map(numbers).collect();
    assert_eq!(rows, [[-0.2, -5900.0], [0.0, 100.0], [0.2, 9100.0]]);
    let length = (0.03_f64.powi(2) + 0.06_f64.powi(2) + 0.35_f64.powi(2)).sqrt();
    assert!((forces[1]["clearance"].as_float().unwrap() - (length - 0.25)).abs() < 1e-15);
    assert!((forces[2]["clearance"].as_float().unwrap() - (0.45 - length)).abs() < 1e-15);
    // 3000 v / (1 + d |v|) at −1 and 1 m/s.
    let damping: Vec<Vec<f64>> =
        forces[3]["table"].as_array().unwrap().iter().map(numbers).collect();
    assert!(
        damping.contains(&vec![-1.0, -750.0]) && damping.contains(&vec![1.0, 1500.0]),
        "{damping:?}"
    );
    let lines = left_out(&imported);
    assert!(
        lines.contains(&(9, "`Spindle / Radius`")) && lines.contains(&(32, "`Axle`")),
        "{lines:?}"
    );
    Corner::new(&model_beside(&imported), &Setup::default()).unwrap();
}

#[test]
fn wishbones_of_chrono_keep_bushings_and_maps() {
    let imported = imported("wishbone.json");
    let table = table(&imported);
    let bushing = &table["bushings"]["uca_pivot_bushing"];
    assert_eq!(numbers(&bushing["stiffness"]), [7e6; 3]);
    assert_eq!(numbers(&bushing["rotational_stiffness"]), [12.0, 1e4, 1e4]);
    assert_eq!(numbers(&bushing["rotational_damping"]), [0.0, 50.0, 50.0]);
    let middle = numbers(&table["points"]["uca_pivot_center"]);
    let near = middle.iter().zip([-0.05, 0.41, 0.205]).all(|(a, b)| (a - b).abs() < 1e-15);
    assert!(near, "{middle:?}");
    let forces = table["forces"].as_array().unwrap();
    // 600 N of preload are those of 10 mm.
    assert!((forces[0]["free_length"].as_float().unwrap() - 0.61).abs() < 1e-15);
    // The map at the length of the design position, between its columns at 0.4 and 0.6 m.
    let share = (0.05_f64.hypot(0.52) - 0.4) / 0.2;
    let rows: Vec<Vec<f64>> = forces[1]["table"].as_array().unwrap().iter().map(numbers).collect();
    for (row, [speed, force]) in rows.iter().zip([
        [-1.0, -1000.0 - 1000.0 * share],
        [0.0, 0.0],
        [1.0, 3000.0 + 2000.0 * share],
    ]) {
        assert!(row[0] == speed && (row[1] - force).abs() < 1e-9, "{rows:?}");
    }
    // An inertia that no body has leaves a point mass.
    assert_eq!(table["bodies"]["lca"]["mass"].as_float(), Some(6.0));
    assert_eq!(numbers(&table["bodies"]["lca"]["inertia"]), [0.0; 3]);
    let lines = left_out(&imported);
    assert!(lines.contains(&(14, "the inertia of Lower Control Arm")), "{lines:?}");
    assert!(lines.iter().any(|(_, what)| what.contains("Map Data")), "{lines:?}");
    // The rod of 2 kg is slender: its own axis is between its ends, near y.
    let rod = numbers(&table["bodies"]["tierod"]["inertia"]);
    assert!((rod[0] + rod[1] + rod[2] - 0.041).abs() < 1e-15 && rod[1] < rod[0], "{rod:?}");
    Corner::new(&model(&imported), &Setup::default()).unwrap();
}

#[test]
fn a_pitman_arm_moves_its_link() {
    let imported = imported("pitman.json");
    let Ok(Document::Mechanism(pitman)) = Document::parse("pitman.toml", &imported.text) else {
        panic!("it is a mechanism");
    };
    let mut system = System::new(pitman.mechanism).unwrap();
    let driver = system.mechanism().driver_named("pitman").unwrap();
    let link = system.mechanism().body_named("link").unwrap();
    let end = system.mechanism().point_named("tierod_pitman_side").unwrap();
    let angle = 25.0_f64.to_radians();
    system.move_to(&[(driver, angle)]).unwrap();
    // Arm and idler are parallel and of one length, so the link moves without turning.
    let [x, y, z] = system.point_position(link, end);
    let (sin, cos) = angle.sin_cos();
    let expected = [0.2 + 0.12 * (cos - 1.0), 0.4 + 0.12 * sin, 0.0];
    assert!((x - expected[0]).abs() < 1e-12 && (y - expected[1]).abs() < 1e-12 && z.abs() < 1e-12);
}

/// A model whose architecture lies beside the fixtures.
fn model_beside(imported: &Imported) -> Model {
    let path = format!("{FIXTURES}/imported.toml");
    Model::parse(&path, &imported.text).unwrap_or_else(|e| panic!("{}", e.render()))
}

/// Suspensions among the shipped models.
const SUSPENSIONS: &[&str] = &[
    "double-wishbone",
    "lotus-front",
    "adams-tr-front",
    "quarter-car",
    "sedan-axle",
    "compliant-corner",
    "bushed-double-wishbone",
];

#[test]
fn json_holds_all_of_every_model() {
    for path in fs::read_dir("models").unwrap() {
        let path = path.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let name = path.display().to_string();
        let text = read(&name);
        let exported = export::export(&name, &text, Format::Json).unwrap();
        assert!(exported.left_out.is_empty());
        let imported = import::import("model.json", &exported.text).unwrap();
        assert_eq!(flat(&text), flat(&imported.text), "{name}");
        let again = export::export("model.toml", &imported.text, Format::Json).unwrap();
        let third = import::import("model.json", &again.text).unwrap();
        assert_eq!(third, imported, "{name}");
    }
}

/// All values with whole numbers as floating-point ones, which they are to a model.
fn flat(text: &str) -> toml::Value {
    fn floats(value: toml::Value) -> toml::Value {
        match value {
            toml::Value::Integer(number) => toml::Value::Float(number as f64),
            toml::Value::Array(items) => {
                toml::Value::Array(items.into_iter().map(floats).collect())
            }
            toml::Value::Table(table) => toml::Value::Table(
                table.into_iter().map(|(key, value)| (key, floats(value))).collect(),
            ),
            other => other,
        }
    }
    floats(toml::Value::Table(text.parse().unwrap()))
}

#[test]
fn points_come_back_from_csv_with_the_same_bits() {
    for name in SUSPENSIONS {
        let path = format!("models/{name}.toml");
        let text = read(&path);
        let exported = export::export(&path, &text, Format::Csv).unwrap();
        let imported = import::import("points.csv", &exported.text).unwrap();
        let (before, after) = (Model::parse(&path, &text).unwrap(), model(&imported));
        for point in after.points() {
            assert_eq!(before.point(&point.name), Some(point.position), "{name}: {}", point.name);
        }
        let required = before.architecture.points();
        assert!(required.iter().all(|role| after.point(&role.name).is_some()));
        assert_eq!(
            (before.side, before.axes, before.units.length),
            (after.side, after.axes, after.units.length)
        );
        assert_eq!(
            (before.wheel_radius, &before.spin),
            (after.wheel_radius, &after.spin),
            "{name}"
        );
        // And once more from what came back.
        let again = export::export("model.toml", &imported.text, Format::Csv).unwrap();
        let third = import::import("points.csv", &again.text).unwrap();
        assert_eq!(table(&third)["points"], table(&imported)["points"], "{name}");
    }
}

#[test]
fn hard_points_come_back_from_a_subsystem_with_the_same_bits() {
    for name in SUSPENSIONS {
        let path = format!("models/{name}.toml");
        let text = read(&path);
        let exported = export::export(&path, &text, Format::Adams).unwrap();
        let imported = import::import("front.sub", &exported.text).unwrap();
        let (before, after) = (Model::parse(&path, &text).unwrap(), model(&imported));
        let mirror = if before.side == Side::Right { -1.0 } else { 1.0 };
        for point in after.points() {
            let [x, y, z] = before.point(&point.name).expect("it was there");
            assert_eq!(point.position, [x, mirror * y + 0.0, z], "{name}: {}", point.name);
        }
        let (a, b) = (before.alignment(), after.alignment());
        assert!((a.toe - b.toe).abs() < 1e-15 && (a.camber - b.camber).abs() < 1e-15, "{name}");
        let again = export::export("model.toml", &imported.text, Format::Adams).unwrap();
        let third = import::import("front.sub", &again.text).unwrap();
        for section in ["points", "wheel"] {
            assert_eq!(table(&third)[section], table(&imported)[section], "{name}");
        }
        assert_eq!(before.vehicle.axle, after.vehicle.axle, "{name}");
    }
}

/// All architectures, those without a template of the shared database, too: the subsystem names one after the
/// architecture, from which it is known again.
#[test]
fn every_architecture_comes_back_from_a_subsystem() {
    for name in Architecture::built_in_names() {
        let path = format!("models/{name}.toml");
        let text = read(&path);
        let exported = export::export(&path, &text, Format::Adams).unwrap();
        let told = exported.left_out.iter().any(|what| what.starts_with("bodies and joints"));
        assert_eq!(told, !["double-wishbone", "macpherson"].contains(&name), "{name}");
        let imported = import::import("rear.sub", &exported.text).unwrap();
        let (before, after) = (Model::parse(&path, &text).unwrap(), model(&imported));
        assert_eq!(before.architecture.title(), after.architecture.title(), "{name}");
        assert!(after.points().len() >= before.architecture.points().len(), "{name}");
        for point in after.points() {
            assert_eq!(before.point(&point.name), Some(point.position), "{name}: {}", point.name);
        }
    }
}

/// What both sides have together, such as a Panhard rod, stays where it is: only points of one side are mirrored.
#[test]
fn shared_points_of_a_right_side_are_not_mirrored() {
    let path = "models/solid-axle-panhard.toml";
    let left = read(path);
    let mut table: toml::Table = left.parse().unwrap();
    table["side"] = "right".into();
    let own = Model::parse(path, &left).unwrap();
    for (name, place) in table["points"].as_table_mut().unwrap() {
        if !own.architecture.points().iter().any(|role| role.name == *name && role.may_cross) {
            let y = place[1].as_float().unwrap();
            place[1] = (0.0 - y).into();
        }
    }
    let exported = export::export("right.toml", &table.to_string(), Format::Adams).unwrap();
    assert!(
        exported.text.contains("'panhard_axle            '  'single    '"),
        "{}",
        exported.text
    );
    let imported = model(&import::import("right.sub", &exported.text).unwrap());
    for point in imported.points() {
        assert_eq!(own.point(&point.name), Some(point.position), "{}", point.name);
    }
}

#[test]
fn a_mechanism_has_json_only() {
    let text = read("models/four-bar.toml");
    let message = export::export("four-bar.toml", &text, Format::Adams).unwrap_err().render();
    assert!(message.contains("--to json"), "{message}");
    let json = export::export("four-bar.toml", &text, Format::Json).unwrap();
    let imported = import::import("four-bar.json", &json.text).unwrap();
    assert!(matches!(Document::parse("x", &imported.text), Ok(Document::Mechanism(_))));
}
