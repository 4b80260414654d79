//! New numbers in the text of model files.
#![allow(missing_docs)]

use hardpoint::design::edit::{EditError, ModelText};
use hardpoint::design::request::Request;
use hardpoint::model::{Document, Model, Quantity, Side};

/// The suspensions of `models/`, with their texts.
fn suspensions() -> Vec<(String, String, Model)> {
    let mut found = vec![];
    for entry in std::fs::read_dir("models").unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "toml") {
            continue;
        }
        let (name, text) = (path.display().to_string(), std::fs::read_to_string(&path).unwrap());
        if let Ok(Document::Suspension(model)) = Document::parse(&name, &text) {
            found.push((name, text, model));
        }
    }
    assert!(found.len() > 20);
    found.sort_by(|a, b| a.0.cmp(&b.0));
    found
}

/// The part of each line that is a comment.
fn comments(text: &str) -> Vec<&str> {
    text.lines().filter_map(|line| line.split_once('#').map(|(_, comment)| comment)).collect()
}

#[test]
fn points_that_move_are_read_back_and_all_else_stays() {
    let mut random = fastrand::Rng::with_seed(6);
    for (name, text, model) in suspensions() {
        for text in [text.clone(), text.replace('\n', "\r\n"), format!("\u{feff}{text}")] {
            let mut edited = ModelText::new(&name, &text).unwrap();
            let mut moved = vec![];
            for point in model.points() {
                if random.bool() {
                    continue;
                }
                let at = point.position.map(|x| x + 0.001 * (random.f64() - 0.5));
                edited.set_point(&point.name, at, model.side).unwrap();
                moved.push((point.name.as_str(), at));
            }
            let read = edited.read().unwrap_or_else(|error| panic!("{}", error.render()));
            // Half of the last decimal, in the unit of the file.
            let rounding = 0.51e-6 * Quantity::Length.to_si(model.units, 1.0);
            for point in read.points() {
                let is = |(name, _): &&(&str, [f64; 3])| *name == point.name;
                match moved.iter().find(is) {
                    Some((_, at)) => {
                        for k in 0..3 {
                            assert!((point.position[k] - at[k]).abs() < rounding, "{name}");
                        }
                    }
                    None => assert_eq!(Some(point.position), model.point(&point.name)),
                }
            }
            assert_eq!(comments(edited.text()), comments(&text));
            let [before, after] = [text.as_str(), edited.text()].map(|text| text.split('\n'));
            assert_eq!(before.clone().count(), after.clone().count());
            for (before, after) in before.zip(after).filter(|(before, after)| before != after) {
                let key = |line: &str| {
                    line.trim_start_matches('\u{feff}')
                        .split('=')
                        .next()
                        .map(|key| key.trim().to_owned())
                };
                assert_eq!(key(before), key(after));
                let key = key(before).unwrap();
                assert!(moved.iter().any(|(name, _)| *name == key), "{name}: {before}");
                assert_eq!(before.ends_with('\r'), after.ends_with('\r'));
            }
        }
    }
}

#[test]
fn what_does_not_change_keeps_its_digits() {
    let text = std::fs::read_to_string("models/double-wishbone.toml").unwrap();
    let odd = text
        .replace(
            "lca_front = [200.0, 420.0, -270.0]",
            "lca_front = [ 2e2,420.000_000_01 ,\t-0270.0e0]  # odd",
        )
        .replace("-0270.0e0", "-270.0e0");
    let mut edited = ModelText::new("odd.toml", &odd).unwrap();
    edited.set_point("lca_front", [0.2, 0.420_000_000_01, -0.2705], Side::Left).unwrap();
    assert_eq!(edited.text(), odd.replace("-270.0e0", "-270.5"));
    // Nothing at all.
    let mut edited = ModelText::new("odd.toml", &odd).unwrap();
    for point in edited.read().unwrap().points() {
        edited.set_point(&point.name, point.position, Side::Left).unwrap();
    }
    assert_eq!(edited.text(), odd);
    // With three decimals.
    let mut edited = ModelText::new("odd.toml", &odd).unwrap().with_decimals(3);
    edited.set_point("lca_front", [0.2, 0.420_123_456, -0.27], Side::Left).unwrap();
    assert_eq!(edited.text(), odd.replace("420.000_000_01", "420.123"));
}

#[test]
fn a_file_of_the_other_side_has_the_mirror_image() {
    let text = std::fs::read_to_string("models/double-wishbone.toml").unwrap();
    let mut edited = ModelText::new("left.toml", &text).unwrap();
    edited.set_point("lca_front", [0.201, -0.42, -0.27], Side::Right).unwrap();
    assert_eq!(edited.text(), text.replace("[200.0, 420.0, -270.0]", "[201.0, 420.0, -270.0]"));
}

#[test]
fn parameters_are_set_by_their_paths() {
    let name = "models/sedan-axle.toml";
    let text = std::fs::read_to_string(name).unwrap();
    let mut edited = ModelText::new(name, &text).unwrap();
    edited.set(&["forces", "spring", "stiffness"], Quantity::Stiffness, 65.25e3).unwrap();
    edited.set(&["forces", "spring", "free_length"], Quantity::Length, 0.61).unwrap();
    edited
        .set(&["bushings", "lca_rear_bushing", "stiffness", "1"], Quantity::Stiffness, 2.6e6)
        .unwrap();
    edited.set(&["wheel", "toe"], Quantity::Angle, 0.25_f64.to_radians()).unwrap();
    edited.set(&["anti_roll_bar", "stiffness"], Quantity::RotationalStiffness, 500.0).unwrap();
    let expected = text
        .replace("stiffness = 70.0", "stiffness = 65.25")
        .replace("free_length = 605.0", "free_length = 610.0")
        .replace("[600.0, 2500.0, 4000.0]", "[600.0, 2600.0, 4000.0]")
        .replace("toe = 0.1\n", "toe = 0.25\n")
        // 500 N·m/rad in N·mm/deg.
        .replace("stiffness = 10000.0", "stiffness = 8726.64626");
    assert_eq!(edited.text(), expected);

    let before = edited.text().to_owned();
    let missing = edited.set(&["forces", "helper", "stiffness"], Quantity::Stiffness, 1.0);
    assert!(matches!(missing, Err(EditError::Missing { .. })));
    let text = edited.set(&["forces", "spring", "kind"], Quantity::Stiffness, 1.0);
    assert!(matches!(text, Err(EditError::NotANumber { .. })));
    let infinite = edited.set(&["wheel", "toe"], Quantity::Angle, f64::NAN);
    assert!(matches!(infinite, Err(EditError::NotFinite { .. })));
    assert!(edited.set_point("nowhere", [0.0; 3], Side::Left).is_err());
    assert!(edited.set_point("lca_front", [0.3, 0.4, f64::NAN], Side::Left).is_err());
    assert_eq!(edited.text(), before);
}

#[test]
fn every_variable_of_a_request_finds_its_number() {
    for name in ["models/sedan-axle.toml", "models/adams-tr-front.toml"] {
        let text = std::fs::read_to_string(name).unwrap();
        let model = Model::parse(name, &text).unwrap();
        let mut request = "format = 1\n[[targets]]\nfactor = \"toe\"\nvalue = 0.0\n[[variables]]\n\
                           all_points = true\nrange = 5.0\n[[variables]]\nparameter = \"wheel.camber\"\nrange = 0.5\n"
            .to_owned();
        if name.contains("sedan") {
            for parameter in [
                "forces.spring.stiffness",
                "forces.spring.free_length",
                "bushings.lca_front_bushing.stiffness",
                "bushings.lca_front_bushing.rotational_stiffness",
                "anti_roll_bar.stiffness",
            ] {
                request += &format!("[[variables]]\nparameter = \"{parameter}\"\npercent = 10.0\n");
            }
        }
        let request = Request::parse("request.toml", &request, &model);
        let request = request.unwrap_or_else(|error| panic!("{}", error.render()));
        let mut edited = ModelText::new(name, &text).unwrap();
        let value = |variable: &hardpoint::design::request::Variable, part: f64| {
            variable.bounds[0] + part * (variable.bounds[1] - variable.bounds[0])
        };
        for variable in &request.variables {
            variable.write(&model, value(variable, 0.3), &mut edited).unwrap();
        }
        let read = edited.read().unwrap_or_else(|error| panic!("{}", error.render()));
        for variable in &request.variables {
            let (found, expected) =
                (variable.parameter.value(&read).unwrap(), value(variable, 0.3));
            let unit = variable.parameter.quantity(&model).to_si(model.units, 1.0);
            assert!(
                (found - expected).abs() < 1e-6 * unit,
                "{}: {found} {expected}",
                variable.name
            );
        }
    }
}
