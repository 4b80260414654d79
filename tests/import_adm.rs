//! Adams/Solver datasets, imported and moved by the program as a user runs it.

#[path = "common/adams.rs"]
mod adams;
#[path = "common/program.rs"]
mod program;

use std::fs;
use std::path::Path;

use adams::{Row, carried, folder, history, hold};
use hardpoint::import::{Imported, adm};
use hardpoint::model::Document;
use hardpoint::vector::{add, cross, norm, scale, sub};
use program::{hardpoint, stderr, stdout};
use toml::Table;

type Vector = [f64; 3];

/// A motion that `hardpoint settle` has written, in SI units.
struct Motion {
    model: Table,
    header: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Motion {
    /// Imports a dataset and moves it, both by the program.
    fn of(text: &str, name: &str, seconds: f64, step: f64) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path =
            |ending: &str| folder.path().join(format!("{name}.{ending}")).display().to_string();
        let (dataset, model, motion) = (path("adm"), path("toml"), path("csv"));
        fs::write(&dataset, text).unwrap();
        hardpoint(&["import", &dataset, "-o", &model]).success();
        let (seconds, step) = (seconds.to_string(), step.to_string());
        hardpoint(&[
            "settle",
            &model,
            "--seconds",
            &seconds,
            "--step",
            &step,
            "--interval",
            "0.01",
            "--reactions",
            "-o",
            &motion,
        ])
        .success();
        let mut reader = csv::Reader::from_path(motion).unwrap();
        let header = reader.headers().unwrap().iter().map(str::to_owned).collect();
        let numbers = |row: csv::StringRecord| row.iter().map(|n| n.parse().unwrap()).collect();
        let rows = reader.records().map(|row| numbers(row.unwrap())).collect();
        Self { model: fs::read_to_string(model).unwrap().parse().unwrap(), header, rows }
    }

    /// The value of a column in SI units.
    fn value(&self, row: usize, name: &str) -> f64 {
        let unit =
            |header: &&String| header.strip_prefix(name).is_some_and(|unit| unit.starts_with('_'));
        let found = |header: &&String| *header == name || unit(header);
        let index = self.header.iter().position(|header| found(&header));
        let index = index.unwrap_or_else(|| panic!("no column {name} in {:?}", self.header));
        let millimetres = self.header[index].contains("mm");
        self.rows[row][index] * if millimetres { 1e-3 } else { 1.0 }
    }

    fn vector(&self, row: usize, name: &str, ends: [&str; 3]) -> Vector {
        ends.map(|end| self.value(row, &format!("{name}_{end}")))
    }

    fn list(&self, key: &str) -> Vec<Table> {
        let list = self.model.get(key).and_then(|list| list.as_array());
        let list = list.into_iter().flatten();
        list.map(|section| section.as_table().unwrap().clone()).collect()
    }

    /// A row as the histories have it: the motion of the only marker, and what acts on the ground about
    /// the place of the joint.
    fn row(&self, row: usize, joint: Vector) -> Row {
        let marker = &self.list("markers")[0];
        let marker = marker["name"].as_str().unwrap();
        let vector = |ends| self.vector(row, marker, ends);
        let position = vector(["x", "y", "z"]);
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for joint_file in self.list("joints") {
            let (name, [_, body_j]) = (text(&joint_file, "name"), between(&joint_file));
            let found = self.vector(row, &name, ["fx", "fy", "fz"]);
            let about = self.vector(row, &name, ["mx", "my", "mz"]);
            if self.is_ground(&body_j) {
                force = add(force, found);
                moment = add(moment, about);
            } else {
                // What the ground feels is the opposite, about its own point.
                let place = self.vector(row, &body_j, ["x", "y", "z"]);
                force = sub(force, found);
                moment = sub(moment, add(about, cross(sub(place, joint), found)));
            }
        }
        for spring in self.list("forces") {
            let (name, [_, body_j]) = (text(&spring, "name"), between(&spring));
            if text(&spring, "kind") == "spring" {
                let way = sub(position, joint);
                let tension = self.value(row, &format!("{name}_force"));
                force = add(force, scale(tension / norm(way), way));
            } else {
                // Its torque turns body j back against the axis.
                let torque = self.value(row, &format!("{name}_torque"));
                let sign = if self.is_ground(&body_j) { -1.0 } else { 1.0 };
                assert_eq!(text(&spring, "axis"), "y");
                moment[1] += sign * torque;
            }
        }
        let euler = ["e0", "e1", "e2", "e3"].map(|end| self.value(row, &format!("{marker}_{end}")));
        let parts = [
            position.to_vec(),
            euler.to_vec(),
            vector(["vx", "vy", "vz"]).to_vec(),
            vector(["wx", "wy", "wz"]).to_vec(),
            vector(["ax", "ay", "az"]).to_vec(),
            vector(["wdx", "wdy", "wdz"]).to_vec(),
            force.to_vec(),
            moment.to_vec(),
        ];
        parts.concat().try_into().unwrap()
    }

    fn is_ground(&self, body: &str) -> bool {
        self.model["ground"].as_str() == Some(body)
    }

    /// Holds a motion against a history that begins at a time.
    fn hold(&self, name: &str, reference: &[(f64, Row)], start: f64, joint: Vector) {
        let rows = reference.iter().filter(|(time, _)| *time > start - 1e-9);
        let rows = rows.map(|(time, expected)| {
            let row = ((time - start) / 0.01).round();
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let row = row as usize;
            assert!((self.value(row, "time") - (time - start)).abs() < 1e-9);
            (self.row(row, joint), *expected)
        });
        hold(name, rows);
    }
}

fn text(section: &Table, key: &str) -> String {
    section[key].as_str().unwrap_or_else(|| panic!("{key} of {section:?}")).to_owned()
}

fn between(section: &Table) -> [String; 2] {
    let bodies = section["between"].as_array().unwrap();
    [0, 1].map(|k| bodies[k].as_str().unwrap().to_owned())
}

fn fixture(name: &str) -> String {
    let path = Path::new("tests/fixtures/adams").join(format!("{name}.adm"));
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

const CORNER: Vector = [1.0, 2.0, 3.0];
const ORIGIN: Vector = [0.0; 3];

#[test]
fn datasets_of_our_own_reproduce_histories() {
    for (file, name, joint, start) in [
        ("revolute", "Revolute_Case02", CORNER, 0.0),
        ("spherical", "Spherical_Case02", CORNER, 0.0),
        ("universal", "Universal_Case03", ORIGIN, 0.0),
        ("cylindrical", "Cylindrical_Case01", ORIGIN, 0.0),
        ("prismatic", "Prismatic_Case03", CORNER, 0.0),
        ("distance", "Distance_Case01", ORIGIN, 0.0),
        ("line-spring", "TranSpring_Case02", ORIGIN, 0.0),
        ("thrown-spring", "TranSpring_Case01", ORIGIN, 0.1),
        ("torsion-spring", "RotSpring_Case01", ORIGIN, 0.0),
        ("torsion-expression", "RotSpring_Case02", ORIGIN, 0.0),
    ] {
        let motion = Motion::of(&fixture(file), file, 1.0, 1e-4);
        motion.hold(name, &carried(name), start, joint);
    }
}

/// The datasets that made the histories, and the springs with the constants that made theirs.
#[test]
fn datasets_of_adams_reproduce_their_histories() {
    let Some(folder) = folder() else { return };
    let read = |name: &str| {
        let path = folder.join("adams_models").join(format!("test_{name}.adm"));
        fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
    };
    for name in JOINTS {
        let joint = if INCLINED.contains(&name) { CORNER } else { ORIGIN };
        let step = if name == "Distance_Case02" { 2e-5 } else { 1e-4 };
        Motion::of(&read(name), name, 1.0, step).hold(name, &history(&folder, name), 0.0, joint);
    }
    let line = read("TransSpring_Case01");
    let angle = read("RotSpring_Case01");
    let torque = "1.0*RTOD*(az(207,208)-0.0*DTOR)";
    let damping = "5.0E-002*RTOD*wz";
    for (name, text, start) in [
        ("TranSpring_Case02", replace(&line, &[("1.0*vr", "5.0*vr")]), 0.0),
        (
            "TranSpring_Case01",
            replace(
                &line,
                &[
                    ("100.0*(dm(204,205)-2.0)", "10.0*dm(204,205)"),
                    ("1.0*vr", "0.5*vr"),
                    ("QP = 0, 2, 0", "QP = 0, 0, -0.0478269"),
                    (", MASS = 1\n", ", MASS = 1, VZ = -0.94069\n"),
                ],
            ),
            0.1,
        ),
        (
            "RotSpring_Case01",
            replace(&angle, &[(torque, "200*az(207,208)"), (damping, "10*wz")]),
            0.0,
        ),
        (
            "RotSpring_Case02",
            replace(
                &angle,
                &[(torque, "(50+10*abs(az(207,208)))*az(207,208)"), (damping, "10*wz")],
            ),
            0.0,
        ),
    ] {
        Motion::of(&text, name, 1.0, 1e-4).hold(name, &history(&folder, name), start, ORIGIN);
    }
}

/// The joint datasets of Project Chrono's tests.
const JOINTS: [&str; 16] = [
    "Revolute_Case01",
    "Revolute_Case02",
    "Spherical_Case01",
    "Spherical_Case02",
    "Universal_Case01",
    "Universal_Case02",
    "Universal_Case03",
    "Cylindrical_Case01",
    "Cylindrical_Case02",
    "Cylindrical_Case03",
    "Prismatic_Case01",
    "Prismatic_Case02",
    "Prismatic_Case03",
    "Distance_Case01",
    "Distance_Case02",
    "Distance_Case03",
];

/// Those whose joint is not at the origin.
const INCLINED: [&str; 6] = [
    "Revolute_Case02",
    "Spherical_Case02",
    "Cylindrical_Case03",
    "Prismatic_Case02",
    "Prismatic_Case03",
    "Distance_Case02",
];

fn replace(text: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text.to_owned(), |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replace(old, new)
    })
}

#[test]
fn every_dataset_of_the_references_imports() {
    let Some(folder) = folder() else { return };
    let mut count = 0;
    for entry in fs::read_dir(folder.join("adams_models")).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let Imported { left_out, .. } = import(&text);
        // Drawings, settings, variables and requests, and nothing else.
        for part in left_out {
            let known = ["GRAPHICS", "OUTPUT", "REQUEST", "VARIABLE"];
            assert!(known.iter().any(|word| part.what.contains(word)), "{path:?}: {part:?}");
        }
        count += 1;
    }
    assert_eq!(count, 19);
}

fn import(text: &str) -> Imported {
    adm::import("dataset.adm", text, false)
        .unwrap_or_else(|error| panic!("{}", error.diagnostics().render()))
}

const PLATFORM: &str = "\
A plate and a lever
UNITS/FORCE=KILOGRAM_FORCE, MASS=POUND_MASS, LENGTH=FOOT, TIME=MILLISECOND
PART/1, GROUND
MARKER/1, PART=1
MARKER/2, PART=1, QP=1, 0, 0
PART/2, MASS=2, CM=20, IP=3, 4, 5, 0.5, 0.25, 0.125, VX=0.001, WY=0.002
MARKER/20, PART=2, QP=1, 0, 0, REULER=90D, 0, 0
MARKER/21, PART=2
MARKER/22, PART=2, QP=1, 0, 0.5
BUSHING/1, I=20, J=2, K=100, 200, 300, C=1, 2, 3, FORCE=4, 5, 6, CT=7, 8, 9
SPRINGDAMPER/1, TRANSLATION, I=22, J=1, K=12, C=0.5, LENGTH=1, FORCE=3
SFORCE/7, TRANSLATIONAL, ACTIONONLY, I=20, J=22, FUNCTION=2*3
GFORCE/1, I=21, JFLOAT=3, RM=2, FX=1\\FY=2\\TZ=PI
MARKER/3, PART=1, FLOATING
ACCGRAV/IGRAV=0.001
END
";

/// Units that a file does not have become SI units, by their definitions.
#[test]
fn numbers_come_over_in_the_units_of_the_file() {
    let model: Table = import(PLATFORM).text.parse().unwrap();
    let units = &model["units"];
    assert_eq!(["length", "force", "mass"].map(|k| units[k].as_str().unwrap()), ["m", "N", "lb"]);
    let numbers = |value: &toml::Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|n| n.as_float().unwrap()).collect()
    };
    let close = |value: &toml::Value, expected: &[f64]| {
        for (found, expected) in numbers(value).into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{value:?}");
        }
    };
    let (foot, kgf, milli) = (0.3048, 9.80665, 1e-3);
    close(&model["gravity"], &[1e-3 * foot / (milli * milli), 0.0, 0.0]);
    let body = &model["bodies"]["part_2"];
    close(&body["center_of_mass"], &[foot, 0.0, 0.0]);
    // A quarter turn exchanges x and y: Jxx = 4, Jyy = 3, Jxy = +∫xy dm, Jxz = +0.125, Jyz = −0.25.
    let square = foot * foot;
    close(&body["inertia"], &[4.0, 3.0, 5.0, 0.5, 0.125, -0.25].map(|j: f64| j * square));
    close(&body["velocity"], &[foot, 0.0, 0.0]);
    // About y of the marker of the centre of mass, which is −x of the ground.
    close(&body["angular_velocity"], &[-2.0, 0.0, 0.0]);
    let forces = model["forces"].as_array().unwrap();
    let force = |name: &str| forces.iter().find(|f| f["name"].as_str() == Some(name)).unwrap();
    let (bushing, spring) = (force("bushing_1"), force("springdamper_1"));
    close(&bushing["stiffness"], &[100.0, 200.0, 300.0].map(|k: f64| k * kgf / foot));
    close(&bushing["damping"], &[1.0, 2.0, 3.0].map(|c: f64| c * milli * kgf / foot));
    close(&bushing["preload"], &[4.0, 5.0, 6.0].map(|f: f64| f * kgf));
    close(&bushing["rotational_damping"], &[7.0, 8.0, 9.0].map(|c: f64| c * milli * kgf * foot));
    let number = |value: &toml::Value| value.as_float().unwrap();
    assert!((number(&spring["stiffness"]) - 12.0 * kgf / foot).abs() < 1e-12);
    assert!((number(&spring["free_length"]) - (1.0 + 3.0 / 12.0) * foot).abs() < 1e-15);
    assert!((number(&spring["damping"]) - 0.5 * milli * kgf / foot).abs() < 1e-15);
    close(&force("sforce_7")["force"], &[0.0, 0.0, 6.0 * kgf]);
    assert_eq!(force("sforce_7")["frame"].as_str(), Some("body"));
    close(&force("gforce_1")["force"], &[kgf, 2.0 * kgf, 0.0]);
    close(&force("gforce_1_2")["moment"], &[0.0, 0.0, std::f64::consts::PI * kgf * foot]);
}

/// A crank that follows a function of time drags a rod of known motion.
#[test]
fn motions_follow_functions_of_time() {
    let text = "\
Crank and slide
UNITS/FORCE=NEWTON, MASS=KILOGRAM, LENGTH=METER, TIME=SECOND
PART/1, GROUND
MARKER/1, PART=1
PART/2, MASS=2, CM=20, IP=0.1, 0.2, 0.3
MARKER/20, PART=2, QP=0.5, 0, 0
MARKER/21, PART=2
PART/3, MASS=4, CM=30, IP=1, 1, 1
MARKER/30, PART=3
JOINT/1, REVOLUTE, I=21, J=1
JOINT/2, TRANSLATIONAL, I=30, J=1
MOTION/1, JOINT=1, ROTATION, FUNCTION = 90D*TIME + 3*TIME**2 - 0.5*SIN(10*TIME)
MOTION/2, JOINT=2, TRANSLATION, FUNCTION = STEP5(TIME, 0.2, 0, 0.8, 0.1) + 0.2*COS(5*TIME) - 0.2
REQUEST/1, D, I=20
REQUEST/2, D, I=30
END
";
    let motion = Motion::of(text, "crank", 1.0, 1e-4);
    for row in (0..=100).step_by(10) {
        let t = motion.value(row, "time");
        let angle = std::f64::consts::FRAC_PI_2 * t + 3.0 * t * t - 0.5 * (10.0 * t).sin();
        let speed = std::f64::consts::FRAC_PI_2 + 6.0 * t - 5.0 * (10.0 * t).cos();
        let acceleration = 6.0 + 50.0 * (10.0 * t).sin();
        let close = |name: &str, expected: f64, tolerance: f64| {
            let found = motion.value(row, name);
            assert!((found - expected).abs() < tolerance, "{name} at {t}: {found}, {expected}");
        };
        close("marker_20_x", 0.5 * angle.cos(), 1e-12);
        close("marker_20_y", 0.5 * angle.sin(), 1e-12);
        close("marker_20_wz", speed, 1e-5);
        close("marker_20_wdz", acceleration, 1e-3);
        // The driver turns the crank about its pin: J + m r².
        close("motion_1_torque", (0.3 + 2.0 * 0.25) * acceleration, 1e-3);
        let s = ((t - 0.2) / 0.6).clamp(0.0, 1.0);
        let step = 0.1 * s * s * s * (10.0 - s * (15.0 - 6.0 * s));
        let step_acceleration = 0.1 * 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / 0.36;
        close("marker_30_z", step + 0.2 * (5.0 * t).cos() - 0.2, 1e-12);
        close("marker_30_az", step_acceleration - 5.0 * (5.0 * t).cos(), 1e-3);
        close("motion_2_force", 4.0 * (step_acceleration - 5.0 * (5.0 * t).cos()), 4e-3);
    }
    let drift = motion.rows.iter().map(|row| row[row.len() - 1].abs()).fold(0.0, f64::max);
    assert!(drift < 1e-4, "{drift}");
}

/// Rack and pinion, and a screw, against their closed forms.
#[test]
fn racks_and_screws_couple_ways_and_turns() {
    let text = "\
Rack, pinion and screw under gravity
UNITS/FORCE=NEWTON, MASS=KILOGRAM, LENGTH=METER, TIME=SECOND
PART/1, GROUND
MARKER/1, PART=1
MARKER/2, PART=1, REULER=90D, 90D, 0
MARKER/3, PART=1, QP=0, 0.05, 0
MARKER/4, PART=1, QP=1, 0, 0
PART/2, MASS=1, CM=20, IP=0.1, 0.1, 0.04
MARKER/20, PART=2, REULER=90D, 90D, 0
PART/3, MASS=2, CM=30, IP=1, 1, 1
MARKER/30, PART=3, QP=0, 0.05, 0
PART/4, MASS=3, CM=40, IP=0.1, 0.1, 0.02
MARKER/40, PART=4, QP=1, 0, 0
JOINT/1, REVOLUTE, I=20, J=2
JOINT/2, TRANSLATIONAL, I=30, J=3
JOINT/3, RACKPIN, I=20, J=30, PD=0.1
JOINT/4, CYLINDRICAL, I=40, J=4
JOINT/5, SCREW, I=40, J=4, PITCH=0.2
ACCGRAV/KGRAV=-10
REQUEST/1, D, I=20
REQUEST/2, D, I=30
REQUEST/3, D, I=40
END
";
    let motion = Motion::of(text, "rack", 1.0, 1e-4);
    // z of marker 20 is the x axis. The rack lies at +y of the pinion, where that goes up as it
    // turns right-handed.
    let rack = -10.0 * 2.0 / (2.0 + 0.04 / 0.0025);
    let lead = 0.2 / std::f64::consts::TAU;
    let screw = -10.0 * 3.0 / (3.0 + 0.02 / (lead * lead));
    for row in [10, 50, 100] {
        let t = motion.value(row, "time");
        let close = |name: &str, expected: f64, tolerance: f64| {
            let found = motion.value(row, name);
            assert!((found - expected).abs() < tolerance, "{name} at {t}: {found}, {expected}");
        };
        close("marker_30_z", 0.5 * rack * t * t, 1e-6);
        close("marker_20_wx", rack * t / 0.05, 2e-5);
        close("marker_40_z", 0.5 * screw * t * t, 1e-6);
        // Several turns.
        close("marker_40_wz", screw * t / lead, 2e-4);
    }
}

/// What is wrong with a dataset is told with its line, all at once.
#[test]
fn mistakes_are_told_with_their_lines() {
    let good = fixture("revolute");
    for (old, new, expected) in [
        ("MARKER/21, PART=2", "MARKER/21, PART=5", "PART/5, which does not exist"),
        ("I=11, J=21", "I=11, J=99", "MARKER/99, which does not exist"),
        ("I=11, J=21", "I=11, J=11", "both markers on PART/1"),
        ("MARKER/21, PART=2", "MARKER/21, PART=2, QP=0, 0, 0.01", "are apart by 1.000e-2"),
        ("MARKER/21, PART=2", "MARKER/21, PART=2, REULER=0, 5D, 0", "are not parallel"),
        ("CM=20", "CM=99", "has CM = 99"),
        ("IP=0.04, 0.1, 0.1", "IP=0.04, 0.1", "IP of PART/2 has 2 numbers"),
        ("IP=0.04, 0.1, 0.1", "IP=9, 0.1, 0.1", "larger than the sum"),
        ("QP=2, 0, 0", "QP=2, zero, 0", "has 1 numbers instead of 3"),
        ("QP=2, 0, 0", "QP=2, 0x0, 0", "no list of numbers"),
        ("LENGTH=METER", "LENGTH=PARSEC", "the unit LENGTH = PARSEC"),
        ("LENGTH=METER, ", "", "UNITS lacks LENGTH"),
        ("JOINT/1, REVOLUTE", "JOINT/1", "does not say what kind it is"),
        ("JOINT/1, REVOLUTE", "JOINT/1, CONVEL", "constant-velocity"),
        ("ACCGRAV", "FRICTION/1\nACCGRAV", "no friction in joints"),
        ("ACCGRAV", "FOO/1\nACCGRAV", "knows no such statement"),
        ("ACCGRAV", "JOINT/1, FIXED, I=11, J=21\nACCGRAV", "two JOINT/1"),
        ("MASS=1, CM=20, ", "", "names no CM"),
        ("END", "", "does not end with END"),
        ("ACCGRAV", ", X=1\n, Y\nACCGRAV", ""),
        ("PART/1, GROUND", "PART/1", "no PART is the GROUND"),
        ("ACCGRAV", "MOTION/1, JOINT=1, ROTATION, FUNCTION=5D\nACCGRAV", "begins at 8.7"),
        (
            "ACCGRAV",
            "MOTION/1, JOINT=1, ROTATION, FUNCTION=EXP(TIME)\nACCGRAV",
            "polynomials, sines",
        ),
        ("ACCGRAV", "GCON/1, FUNCTION=DM(11, 20) - 3\nACCGRAV", "is not zero where the parts are"),
        ("ACCGRAV", "GCON/1, FUNCTION=VX(20)\nACCGRAV", "VX is a velocity"),
        ("ACCGRAV", "GCON/1, FUNCTION=DX(20)-DY(20)-1\nACCGRAV", "of one measure only"),
        ("ACCGRAV", "SFORCE/1, ROT, I=11, J=21, FUN=TIME\nACCGRAV", "it changes with time"),
        ("ACCGRAV", "SFORCE/1, ROT, I=11, J=21, FUN=IF(AZ(11,21): 0, 1, 2)\nACCGRAV", "it jumps"),
        ("ACCGRAV", "SFORCE/1, ROT, I=11, J=21, FUN=AZ(11,21)*WZ(11,21,21)\nACCGRAV", "no sum"),
        ("ACCGRAV", "SFORCE/1, TRANS, I=1, J=20, FUN=DM(11, 20)\nACCGRAV", "not measured between"),
        ("ACCGRAV", "SFORCE/1, TRANS, I=1, J=20, FUN=SFORCE(1,0,8,0)\nACCGRAV", "function SFORCE"),
        ("ACCGRAV", "SFORCE/1, TRANS, I=1, J=20, FUN=2*\nACCGRAV", "expression ends"),
    ] {
        assert!(good.contains(old), "{old}");
        let text = good.replacen(old, new, 1);
        match adm::import("dataset.adm", &text, false) {
            Ok(_) => assert_eq!(expected, "", "{new} is taken"),
            Err(error) => {
                let told = error.diagnostics().render();
                assert!(told.contains(expected) && !expected.is_empty(), "{new}: {told}");
                assert!(told.contains("dataset.adm"), "{told}");
            }
        }
    }
    let many = good.replace("I=11, J=21", "I=98, J=99").replace("CM=20", "CM=97");
    let error = adm::import("dataset.adm", &many, false).unwrap_err();
    let places: Vec<_> =
        error.diagnostics().mistakes().iter().map(|m| m.line_and_column().unwrap().0).collect();
    assert_eq!(places, [10, 15, 15]);
}

#[test]
fn what_is_left_out_is_listed() {
    let text = fixture("revolute").replace(
        "ACCGRAV",
        "GRAPHICS/1, CYLINDER, CM=20\nGRAPHICS/2, BOX\n, X=1\nCOUPLER/1, JOINTS=1, 2\nJOINT/9, CONVEL, I=11, J=21\nACCGRAV",
    );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pendulum.adm").display().to_string();
    fs::write(&path, text).unwrap();
    let refused = hardpoint(&["import", &path]).failure().code(1);
    assert!(stdout(&refused).is_empty());
    for what in ["COUPLER/1", "JOINT/9", "--lenient"] {
        assert!(stderr(&refused).contains(what), "{what}");
    }
    let taken = hardpoint(&["import", &path, "--lenient"]).success();
    Document::parse("pendulum.toml", &stdout(&taken)).unwrap();
    let told = stderr(&taken);
    let told: Vec<&str> = told.lines().skip(1).map(str::trim).collect();
    assert_eq!(
        told,
        [
            "line 16: 2 GRAPHICS, lines 16, 17: it is a drawing",
            "line 19: COUPLER/1: hardpoint has no couplers of joints",
            "line 20: JOINT/9: hardpoint has no constant-velocity joint yet",
        ]
    );
}

#[test]
fn names_of_adams_view_are_kept() {
    let text = import(&fixture("revolute")).text;
    for line in
        ["ground = \"chassis\"", "[bodies.bar]", "at = \"pin_on_chassis\"", "name = \"middle\""]
    {
        assert!(text.contains(line), "{line}\n{text}");
    }
}

/// Variables that name each other twice would be evaluated more often than there are atoms.
#[test]
fn expressions_that_grow_without_end_are_refused() {
    let variables: String = (1..60)
        .map(|k| format!("VARIABLE/{k}, FUN=VARVAL({})+VARVAL({})\n", k + 1, k + 1))
        .collect();
    let circle = "VARIABLE/60, FUN=VARVAL(1)*DM(1, 20)\n";
    for last in [circle, "VARIABLE/60, FUN=DM(1, 20)\n"] {
        let force = "SFORCE/1, TRANS, I=1, J=20, FUN=-VARVAL(1)**2\nACCGRAV";
        let text = fixture("revolute").replace("ACCGRAV", &format!("{variables}{last}{force}"));
        let error = adm::import("dataset.adm", &text, false).unwrap_err();
        assert!(error.diagnostics().render().contains("VARIABLE/1"), "{error:?}");
    }
}

/// Random changes of datasets neither panic nor hang. The number of them is that of the variable
/// HARDPOINT_FUZZ.
#[test]
fn any_text_is_taken_or_refused() {
    let count = std::env::var("HARDPOINT_FUZZ").ok().and_then(|count| count.parse().ok());
    let files = fs::read_dir("tests/fixtures/adams").unwrap();
    let files: Vec<Vec<u8>> = files.map(|file| fs::read(file.unwrap().path()).unwrap()).collect();
    let mut rng = fastrand::Rng::with_seed(11);
    for _ in 0..count.unwrap_or(2000_u32) {
        let mut bytes = files[rng.usize(..files.len())].clone();
        for _ in 0..rng.usize(1..8) {
            let at = rng.usize(..bytes.len());
            match rng.u8(..5) {
                0 => bytes.truncate(at.max(1)),
                1 => bytes[at] = rng.u8(..),
                2 => bytes.insert(at, b"(),=/*-&\\!'\n.eD0"[rng.usize(..16)]),
                3 => drop(bytes.remove(at)),
                _ => {
                    let other = &files[rng.usize(..files.len())];
                    let from = rng.usize(..other.len());
                    let to = (from + rng.usize(1..60)).min(other.len());
                    bytes.splice(at..at, other[from..to].iter().copied());
                }
            }
            if bytes.is_empty() {
                bytes.push(b' ');
            }
        }
        let text = String::from_utf8_lossy(&bytes);
        for lenient in [false, true] {
            if let Ok(imported) = adm::import("dataset.adm", &text, lenient) {
                assert!(Document::parse("dataset.toml", &imported.text).is_ok());
            }
        }
    }
}
