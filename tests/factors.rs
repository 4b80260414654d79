//! The kinematic design factors against other programs.
#![allow(missing_docs)]

use std::collections::HashMap;

use hardpoint::factors::{Convention, find};
use hardpoint::model::{Drive, Model, Quantity, Setup};
use hardpoint::rig::{Corner, Event, Held, Pose, Sweep, SweepPlan};

/// The rows of a reference table by the names of its columns.
fn table(text: &str) -> Vec<HashMap<String, f64>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader.deserialize().map(|row| row.expect("the table is well-formed")).collect()
}

fn model(name: &str) -> Model {
    let path = format!("{}/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    Model::load(path).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

fn poses(model: &Model, drive: Drive, range: f64, step: f64) -> Vec<Pose<f64>> {
    let mut corner = Corner::new(model, &Setup { drive, ..Setup::default() }).unwrap();
    let (event, held) = (Event::Travel, Held::default());
    let plan = SweepPlan { event, from: -range, to: range, step, held };
    let sweep = Sweep::run(&mut corner, &plan, |_| {});
    assert!(sweep.stops.is_empty(), "{:?}", sweep.stops);
    sweep.rows.iter().map(|row| row.poses[0]).collect()
}

/// The factor of a column of the sedan's reference, and what its mirror image does to the sign.
fn factor_of(column: &str) -> Option<(String, f64)> {
    const PAIRS: &[(&str, &str, f64)] = &[
        ("wc", "wheel_center", 1.0),
        ("spin", "spin_axis", 1.0),
        ("cp", "contact_patch", 1.0),
        ("vwc", "center_velocity", 1.0),
        ("om", "angular_velocity", -1.0),
        ("isa_dir", "screw_axis", -1.0),
        ("isa_pt", "screw_point", 1.0),
        ("vcp", "patch_velocity", 1.0),
        ("dcp", "patch_path", 1.0),
        ("fvic", "fvic", 1.0),
        ("svic", "svic", 1.0),
        ("fvic_cp", "fvic_patch", 1.0),
        ("svic_cp", "svic_patch", 1.0),
    ];
    const NAMES: &[(&str, &str)] = &[
        ("travel_mm", "travel"),
        ("toe_deg", "toe"),
        ("camber_deg", "camber"),
        ("dtoe_dz_deg_per_m", "bump_steer"),
        ("dcamber_dz_deg_per_m", "bump_camber"),
        ("rc_height", "rc_height"),
        ("rc_height_track", "rc_height_track"),
        ("tan_brake", "tan_brake"),
        ("tan_drive", "tan_drive"),
        ("anti_brake_pct", "anti_dive"),
        ("anti_drive_pct", "anti_lift_drive"),
        ("spring_length", "spring_length"),
        ("motion_ratio", "motion_ratio"),
        ("motion_ratio_cp", "motion_ratio_patch"),
    ];
    const OF_AXES: &[(&str, &str, f64)] = &[
        ("caster_deg", "caster", 1.0),
        ("kpi_deg", "kpi", 1.0),
        ("kpg_x", "axis_ground_x", 1.0),
        ("kpg_y", "axis_ground_y", -1.0),
        ("mech_trail", "mechanical_trail", 1.0),
        ("scrub", "scrub_radius", 1.0),
        ("trail_vehx", "trail_x", 1.0),
        ("scrub_vehy", "scrub_y", 1.0),
        ("wc_trail", "wheel_center_trail", 1.0),
        ("wc_offset", "kingpin_offset", 1.0),
        // The mirror image of a right-handed screw is a left-handed one.
        ("pitch_m_per_rad", "pitch", -1.0),
    ];
    if let Some((_, name)) = NAMES.iter().find(|(theirs, _)| *theirs == column) {
        return Some(((*name).to_owned(), 1.0));
    }
    if column == "isa_pitch_m_per_rad" {
        return Some(("screw_pitch".to_owned(), -1.0));
    }
    for prefix in ["vks_", "vk_", ""] {
        let Some(rest) = column.strip_prefix(prefix) else { continue };
        if let Some((_, name, mirror)) = OF_AXES.iter().find(|(theirs, ..)| *theirs == rest) {
            return Some((format!("{prefix}{name}"), *mirror));
        }
    }
    let (vector, axis) = column.rsplit_once('_')?;
    let (_, name, polar) = PAIRS.iter().find(|(theirs, ..)| *theirs == vector)?;
    // Of a polar vector y changes its sign, of an axial one x and z.
    let mirror = if axis == "y" { -polar } else { *polar };
    Some((format!("{name}_{axis}"), mirror))
}

/// All columns of the sedan's reference, to 1e-8 of the value or of a thousandth of the largest
/// value in the column, whichever is more; both sides of the vehicle. Rotation matrices stand in no factor.
#[test]
fn sedan_has_all_factors_of_independent_kinematics() {
    let left = model("double-wishbone");
    let reference = table(include_str!("reference/sedan-kinematics.csv"));
    assert_eq!(reference.len(), 27);
    let mut largest: HashMap<&str, f64> = HashMap::new();
    for row in &reference {
        for (name, value) in row {
            let entry = largest.entry(name).or_default();
            *entry = entry.max(value.abs());
        }
    }
    assert_eq!(largest.len(), 91);
    let mut worst: (f64, String) = (0.0, String::new());
    for model in [left.mirrored(), left] {
        let poses = poses(&model, Drive::WheelCenter, 0.13, 0.01);
        for (pose, row) in poses.iter().zip(&reference) {
            for (column, &expected) in row {
                let (found, expected) = if let Some(entry) = column.strip_prefix('R') {
                    let (i, j) = (entry.as_bytes()[0] - b'0', entry.as_bytes()[1] - b'0');
                    let crosses = (i == 1) != (j == 1);
                    let mirror = if crosses { model.side.sign() } else { 1.0 };
                    (pose.rotation[usize::from(i)][usize::from(j)], mirror * expected)
                } else {
                    let (name, mirror) = factor_of(column).expect(column);
                    let factor = find(&name).unwrap();
                    let value = factor.value(Convention::Iso, pose).expect(column);
                    let shown = match factor.quantity {
                        Quantity::Angle | Quantity::Gradient if !column.starts_with("om_") => {
                            value.to_degrees()
                        }
                        Quantity::Percent => 100.0 * value,
                        _ if column == "travel_mm" => 1000.0 * value,
                        _ => value,
                    };
                    (shown, if model.side.sign() < 0.0 { mirror * expected } else { expected })
                };
                let size = expected.abs().max(1e-3 * largest[column.as_str()]);
                // True zeros: 1e-12 m, or in the unit of the column.
                let allowed = if expected.abs() < 1e-20 { 1e-12 } else { 1e-8 * size };
                let difference = (found - expected).abs();
                let at = format!("{} {column} at {}", model.side.name(), row["travel_mm"]);
                assert!(
                    difference <= allowed,
                    "{at}: {found} instead of {expected}, {difference:e} of {allowed:e}"
                );
                if difference / allowed > worst.0 && expected.abs() >= 1e-20 {
                    worst = (difference / allowed, at);
                }
            }
        }
    }
    // What is reached is rounding: far below what is promised.
    assert!(worst.0 < 1e-3, "{} of the tolerance: {}", worst.0, worst.1);
}

/// Every printed column of Lotus' bump table, by Lotus' definitions and with the patch driven: angles
/// to 6e-5°, lengths to 0.006 mm, ratios to 0.0006, anti-dive to 0.01 %, roll centre to 0.1 mm.
#[test]
fn lotus_has_all_columns_of_its_bump_table() {
    const COLUMNS: &[(&str, &str, f64)] = &[
        ("bump_mm", "travel", 1e-9),
        ("camber_deg", "camber", 6e-5),
        ("toe_deg", "toe", 6e-5),
        ("castor_deg", "caster", 6e-5),
        ("kingpin_deg", "kpi", 6e-5),
        ("damper_ratio", "damper_ratio_patch", 6e-4),
        ("spring_ratio", "spring_ratio_patch", 6e-4),
        ("anti_dive_pct", "anti_dive", 0.01),
        ("anti_squat_pct", "anti_lift_drive", 0.01),
        ("roll_centre_to_body_mm", "rc_height_body", 0.1),
        ("roll_centre_to_grnd_mm", "rc_height", 0.1),
        ("half_track_change_mm", "half_track_change", 0.006),
        ("wheelbase_change_mm", "wheelbase_change", 0.006),
        ("damper_travel_mm", "damper_travel", 0.006),
        ("spring_travel_mm", "spring_travel", 0.006),
    ];
    let right = model("lotus-front");
    let reference = table(include_str!("reference/lotus-bump.csv"));
    assert_eq!(reference.len(), 11);
    for model in [right.mirrored(), right] {
        let poses = poses(&model, Drive::ContactPatch, 0.0375, 0.0075);
        for (pose, row) in poses.iter().zip(&reference) {
            assert_eq!(row.len(), COLUMNS.len());
            for (column, name, tolerance) in COLUMNS {
                let factor = find(name).unwrap();
                let found = factor.show_by(Convention::Lotus, model.units, pose).expect(name);
                let difference = (found - row[*column]).abs();
                assert!(
                    difference <= *tolerance,
                    "{column} at {}: {found} instead of {}, {difference:e}",
                    row["bump_mm"],
                    row[*column]
                );
            }
        }
    }
}

/// The static values of Lotus' report, to its last digit (0.01 mm, 0.01°).
#[test]
fn lotus_has_its_static_values() {
    let model = model("lotus-front");
    let mut corner = Corner::new(&model, &Setup::from(Drive::ContactPatch)).unwrap();
    let pose = corner.pose();
    let differs = |name: &str, expected: f64| {
        let found = find(name).unwrap().show_by(Convention::Lotus, model.units, &pose);
        (found.expect(name) - expected).abs()
    };
    for (name, expected) in [
        ("camber", 0.0),
        ("toe", 0.0),
        ("toe_plane", 0.0),
        ("caster", 4.94),
        ("wheel_center_trail", -0.07),
        ("trail_x", 23.39),
        ("kpi", 7.0),
        ("kingpin_offset", 59.11),
        ("scrub_y", 25.98),
        ("scrub_radius", 25.98),
        ("mechanical_trail", 23.3),
    ] {
        assert!(differs(name, expected) <= 0.0051, "{name}");
    }
    assert!(differs("rc_height", 49.79) <= 0.1);
}
