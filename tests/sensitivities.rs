//! Derivatives of factors by parameters of models.

#[path = "common/varying.rs"]
mod varying;

use std::collections::HashMap;

use hardpoint::design::{Parameter, Sensitivities, Way, sensitivities};
use hardpoint::factors::{Convention, Factor, find};
use hardpoint::model::{Chassis, Drive, Model, Quantity, Setup};
use hardpoint::rig::Corner;

use varying::{Case, check};

const COLUMNS: [(&str, &str); 15] = [
    ("toe_deg", "toe"),
    ("camber_deg", "camber"),
    ("wc_x", "wheel_center_x"),
    ("wc_y", "wheel_center_y"),
    ("rc_height", "rc_height"),
    ("anti_brake_pct", "anti_dive"),
    ("motion_ratio", "motion_ratio"),
    ("dtoe_dz_deg_per_m", "bump_steer"),
    ("dcamber_dz_deg_per_m", "bump_camber"),
    ("caster_deg", "caster"),
    ("kpi_deg", "kpi"),
    ("mech_trail", "mechanical_trail"),
    ("scrub", "scrub_radius"),
    ("vk_caster_deg", "vk_caster"),
    ("vk_kpi_deg", "vk_kpi"),
];

fn model(name: &str) -> Model {
    Model::load(format!("models/{name}.toml")).unwrap()
}

/// The derivatives of the reference: parameter, travel (mm), output, value.
fn reference() -> Vec<(String, f64, String, f64)> {
    let text = include_str!("reference/sedan-sensitivities.csv");
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    let mut list = vec![];
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let travel = cells[1].parse().unwrap();
        for (column, cell) in columns.iter().zip(&cells).skip(2) {
            list.push((cells[0].to_owned(), travel, (*column).to_owned(), cell.parse().unwrap()));
        }
    }
    list
}

/// A derivative in the unit of the reference.
fn shown(factor: &Factor, derivative: f64) -> f64 {
    match factor.quantity {
        Quantity::Angle | Quantity::Gradient => derivative.to_degrees(),
        Quantity::Percent => 100.0 * derivative,
        _ => derivative,
    }
}

fn at(corner: &mut Corner, travel: f64, factors: &[&'static Factor], way: Way) -> Sensitivities {
    let model = model("double-wishbone");
    let parameters = Parameter::coordinates(&model);
    corner.move_to(travel, 0.0).unwrap();
    sensitivities(corner, &model, factors, Convention::Iso, &parameters, way).unwrap()
}

/// Every output and coordinate of the sedan's reference, central differences of 50-digit kinematics, to
/// 1e-7 of the value or of a thousandth of the largest one of its column.
#[test]
fn sedan_has_the_derivatives_of_independent_kinematics() {
    let model = model("double-wishbone");
    let reference = reference();
    let mut largest: HashMap<&str, f64> = HashMap::new();
    for (_, _, output, value) in &reference {
        let entry = largest.entry(output).or_default();
        *entry = entry.max(value.abs());
    }
    let mut corner = Corner::new(&model, &Setup::default()).unwrap();
    let factors: Vec<&Factor> = COLUMNS.iter().map(|(_, name)| find(name).unwrap()).collect();
    let parameters = Parameter::coordinates(&model);
    let mut compared = 0;
    let travels = [-80.0, 0.0, 80.0];
    for way in [Way::Direct, Way::Adjoint] {
        let tables = travels.map(|travel| at(&mut corner, 1e-3 * travel, &factors, way));
        for (name, travel, output, expected) in &reference {
            let state = travels.iter().position(|t| t == travel).unwrap();
            let k = parameters.iter().position(|parameter| parameter.name == *name).unwrap();
            let j = COLUMNS.iter().position(|(column, _)| column == output).unwrap();
            let found = shown(factors[j], tables[state].rows[j].by[k].unwrap());
            let allowed = 1e-7 * expected.abs().max(1e-3 * largest[output.as_str()]);
            assert!(
                (found - expected).abs() <= allowed,
                "{way:?} d{output}/d{name} at {travel} mm: {found} for {expected}"
            );
            compared += 1;
        }
    }
    assert_eq!(compared, 2 * 99 * 15);
}

#[test]
fn double_wishbones_have_the_derivatives_of_models_made_anew() {
    check(&Case::new("double-wishbone").at(37.0, 0.0, 6.0), 10);
    check(
        &Case::new("double-wishbone")
            .with_setup(|s| s.drive = Drive::ContactPatch)
            .at(-20.0, 0.0, -9.0),
        8,
    );
    check(&Case::axle("double-wishbone").at(20.0, -31.0, 12.0), 8);
}

#[test]
fn a_right_side_in_adams_axes_with_a_point_on_its_spin_axis_has_them() {
    check(&Case::new("lotus-front").at(0.0, 23.0, 4.0), 12);
    check(&Case::axle("lotus-front").at(11.0, 23.0, 4.0), 8);
}

#[test]
fn struts_links_and_rockers_have_them() {
    check(&Case::new("macpherson").at(31.0, 0.0, -7.0), 10);
    check(&Case::new("five-link").at(-28.0, 0.0, 0.0), 10);
    check(&Case::new("double-wishbone-pushrod").at(14.0, 0.0, 3.0), 12);
    check(&Case::axle("double-wishbone-pushrod").at(14.0, -9.0, 3.0), 10);
}

#[test]
fn axles_of_one_mechanism_have_them() {
    check(&Case::axle("solid-axle").at(25.0, -12.0, 0.0), 10);
    check(&Case::axle("solid-axle-watt").at(5.0, 30.0, 0.0), 8);
}

#[test]
fn a_chassis_that_rolls_has_them() {
    let rolls = |s: &mut Setup| s.chassis = Chassis::Roll { axis: 0.05 };
    let case = Case::axle("double-wishbone").with_setup(rolls).at(8.0, 3.0, 2.0);
    check(&case.with_target(|t| t.roll = 0.03), 8);
}

/// A trailing arm on two hinges, of which the second one is redundant: it may move along their common axis
/// and no other way. Else the derivatives are those of the arm on one hinge.
#[test]
fn what_breaks_redundant_equations_is_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let root = env!("CARGO_MANIFEST_DIR");
    let read = |path: &str| std::fs::read_to_string(format!("{root}/{path}")).unwrap();
    let hinge = "
[[joints]]
name = \"second_pivot\"
kind = \"revolute\"
between = [\"chassis\", \"arm\"]
at = \"arm_far\"
axis = [\"arm_inner\", \"arm_far\"]

[wheel]";
    let points = "[points]\narm_far = \"Second pivot\"";
    let architecture = read("architectures/trailing-arm.toml");
    let architecture = architecture.replace("[points]", points).replace("\n[wheel]", hinge);
    std::fs::write(folder.path().join("two-hinges.toml"), architecture).unwrap();
    let text = read("models/trailing-arm.toml");
    let one = Model::parse("models/model.toml", &text).unwrap();
    let [inner, outer] = ["arm_inner", "arm_outer"].map(|name| one.point(name).unwrap());
    let far: [f64; 3] = std::array::from_fn(|k| 1e3 * (1.6 * outer[k] - 0.6 * inner[k]));
    let text = text
        .replace("architecture = \"trailing-arm\"", "architecture = \"two-hinges.toml\"")
        .replace("[points]", &format!("[points]\narm_far = {far:?}"));
    let path = folder.path().join("model.toml");
    let two =
        Model::parse(path.to_str().unwrap(), &text).unwrap_or_else(|e| panic!("{}", e.render()));
    let factors = ["toe", "bump_camber", "wheel_center_x"].map(|name| find(name).unwrap());
    let found = |model: &Model, way: Way| {
        let parameters = Parameter::coordinates(model);
        let mut corner = Corner::new(model, &Setup::default()).unwrap();
        corner.move_to(0.03, 0.0).unwrap();
        let found =
            sensitivities(&mut corner, model, &factors, Convention::Iso, &parameters, way).unwrap();
        (parameters, found)
    };
    let (of_one, expected) = found(&one, Way::Direct);
    for way in [Way::Direct, Way::Adjoint] {
        let (parameters, found) = found(&two, way);
        let refused: Vec<&str> = found.refused.iter().map(|(name, _)| name.as_str()).collect();
        let moves = ["arm_inner", "arm_far"].map(|p| ["x", "z"].map(|axis| format!("{p}.{axis}")));
        // The axes of both hinges go through the inner point, but the first one has its direction from the outer one.
        for name in moves.as_flattened() {
            assert!(refused.contains(&name.as_str()), "{name} is not among {refused:?}");
        }
        assert!(found.refused[0].1.contains("redundant"), "{:?}", found.refused);
        for (k, parameter) in parameters.iter().enumerate() {
            let Some(one) = of_one.iter().position(|other| other.name == parameter.name) else {
                continue;
            };
            if refused.contains(&parameter.name.as_str()) {
                assert!(found.rows.iter().all(|row| row.by[k].is_none()));
                continue;
            }
            for (row, expected) in found.rows.iter().zip(&expected.rows) {
                let off = row.by[k].unwrap() - expected.by[one].unwrap();
                assert!(off.abs() < 1e-9, "{}/{}: {off:e}", row.factor.name, parameter.name);
            }
        }
    }
}
