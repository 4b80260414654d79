//! What is read of requests.
#![allow(missing_docs)]

use hardpoint::design::request::{Goal, Parameter, Part, Reference, Relation, Request, Stiffness};
use hardpoint::factors::Convention;
use hardpoint::mechanism::BodyId;
use hardpoint::model::{Model, Side};
use hardpoint::rig::{Event, Hold};

fn model(path: &str) -> Model {
    Model::load(path).unwrap_or_else(|error| panic!("{}", error.render()))
}

fn complete() -> (Model, Request) {
    let model = model("models/sedan-axle.toml");
    let request = Request::load("tests/fixtures/requests/complete.toml", &model);
    (model, request.unwrap_or_else(|error| panic!("{}", error.render())))
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-12 * expected.abs().max(1e-3), "{found} {expected}");
}

#[test]
fn targets_are_read_in_si() {
    let (model, request) = complete();
    let names: Vec<&str> = request.targets.iter().map(|target| &*target.name).collect();
    let expected = [
        "toe",
        "measured toe",
        "toe_2",
        "camber",
        "rc_height",
        "anti_dive",
        "bump_steer",
        "wheel_rate",
    ];
    assert_eq!(names, expected);
    let [toe, measured, steer, camber, roll, anti, gradient, rate] = &request.targets[..] else {
        panic!("eight targets");
    };
    assert_eq!(toe.goal, Goal::Values(vec![0.2_f64.to_radians()]));
    let [state] = &toe.states[..] else { panic!("one state") };
    assert_eq!((state.value, state.rig.wheels), (None, [Hold::Value(0.03); 2]));
    assert_eq!(state.rig.rack, -0.005);
    assert_eq!(state.rig.load[0].components, [-2000.0, 0.0, 0.0, 0.0, 0.0, 10.0]);
    assert_eq!(state.rig.load[1].components, [-2000.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    near(toe.tolerance, 0.05_f64.to_radians());
    assert_eq!((toe.weight, toe.hard, toe.side), (2.0, false, Side::Left));

    // The rows of the file in the order of travel, in the units of its columns.
    assert_eq!(measured.event, Some(Event::Travel));
    assert_eq!(measured.goal, Goal::Values(vec![0.002, 0.0, -0.001]));
    let travels: Vec<Option<f64>> = measured.states.iter().map(|state| state.value).collect();
    assert_eq!(travels, [Some(-0.04), Some(0.0), Some(0.04)]);
    assert_eq!(measured.states[0].rig.wheels, [Hold::Value(-0.04); 2]);
    near(measured.tolerance, 0.01_f64.to_radians());

    assert_eq!((steer.event, steer.hard), (Some(Event::Steer), true));
    assert_eq!(steer.states[1].rig.rack, 0.01);
    assert_eq!((camber.side, camber.hard, camber.states.len()), (Side::Right, true, 5));
    let Goal::Band { min: Some(min), max: Some(max) } = camber.goal else { panic!("a band") };
    near(min, (-2.0_f64).to_radians());
    near(max, 0.5_f64.to_radians());
    let wheels = camber.states[0].rig.wheels;
    let travels = wheels.map(|hold| if let Hold::Value(travel) = hold { travel } else { f64::NAN });
    near(travels[0], -0.01);
    near(travels[1], 0.03);
    assert_eq!((&roll.goal, roll.states.len()), (&Goal::Hold, 11));
    assert_eq!((&anti.goal, anti.convention), (&Goal::Maximise, Convention::Lotus));
    assert_eq!(gradient.unit(model.units), "deg/m");
    assert_eq!(gradient.goal, Goal::Values(vec![(-36.0_f64).to_radians()]));
    near(gradient.tolerance, 0.1_f64.to_radians());
    assert_eq!(rate.goal, Goal::Band { min: None, max: Some(30e3) });
    assert!(!rate.hard);
    let [first, second] = rate.states[1].rig.load;
    assert_eq!([first.components[1], second.components[1]], [1000.0, -1000.0]);
    assert!(request.needs_axle(&model));
}

#[test]
fn variables_have_bounds_around_what_the_model_has() {
    let (model, request) = complete();
    let find = |name: &str| {
        request.variables.iter().find(|variable| variable.name == name).expect("it is a variable")
    };
    let bounds = |name: &str, least: f64, most: f64| {
        near(find(name).bounds[0], least);
        near(find(name).bounds[1], most);
    };
    bounds("tierod_inner.y", 0.415, 0.423);
    bounds("tierod_inner.z", -0.13, -0.11);
    bounds("lca_front.z", -0.3, -0.25);
    // Other points go as far as [limits] says.
    bounds("uca_outer.z", 0.09, 0.12);
    bounds("forces.spring.stiffness", 56e3, 77e3);
    bounds("forces.spring.free_length", 0.58, 0.63);
    bounds("bushings.lca_front_bushing.stiffness.y", 4.5e6, 13.5e6);
    // 1 N·mm/deg = 0.001 · 180/π N·m/rad.
    let per_degree = 1e-3 * 1.0_f64.to_degrees();
    let rear = "bushings.lca_rear_bushing.rotational_stiffness.y";
    bounds(rear, 3000.0 * per_degree, 4000.0 * per_degree);
    bounds("anti_roll_bar.stiffness", 5e3 * per_degree, 20e3 * per_degree);
    bounds("wheel.toe", (-0.1_f64).to_radians(), 0.3_f64.to_radians());
    assert_eq!(find("wheel.toe").parameter, Parameter::Toe);
    let bar = Parameter::Stiffness(Stiffness::AntiRollBar);
    assert_eq!(find("anti_roll_bar.stiffness").parameter, bar);
    for variable in &request.variables {
        assert_eq!(Some(variable.start), variable.parameter.value(&model));
        assert!(variable.bounds[0] < variable.bounds[1], "{}", variable.name);
        assert!(!variable.name.starts_with("wheel_center"), "it is locked");
        let same = request.variables.iter().filter(|other| other.parameter == variable.parameter);
        assert_eq!(same.count(), 1);
    }
    // All points but the locked one in z, of one also y.
    let coordinates = |variable: &&hardpoint::design::request::Variable| {
        matches!(variable.parameter, Parameter::Coordinate { .. })
    };
    assert_eq!(request.variables.iter().filter(coordinates).count(), model.points().len());
}

#[test]
fn coordinates_are_those_of_the_model_s_axes() {
    let model = model("models/adams-tr-front.toml");
    assert_eq!(model.axes.signs(), [-1.0, -1.0, 1.0]);
    let name = &model.points()[0].name;
    let at = model.axes.from_iso(model.points()[0].position)[0] * 1000.0;
    let text = format!(
        "format = 1\n[[targets]]\nfactor = \"toe\"\nvalue = 0.0\n[[variables]]\npoint = \"{name}\"\n\
         coordinates = [\"x\"]\nrange = [-1.0, 5.0]\n[[variables]]\npoint = \"{name}\"\ncoordinates = [\"y\"]\n\
         bounds = [{}, {}]\n[[boxes]]\npoints = [\"{name}\"]\nx = [{}, {}]\n",
        -model.points()[0].position[1] * 1000.0 - 2.0,
        -model.points()[0].position[1] * 1000.0 + 7.0,
        at - 1.0,
        at + 5.0,
    );
    let request = Request::parse("request.toml", &text, &model);
    let request = request.unwrap_or_else(|error| panic!("{}", error.render()));
    let [x, y] = &request.variables[..] else { panic!("two variables") };
    near(x.bounds[0], x.start - 0.005);
    near(x.bounds[1], x.start + 0.001);
    near(y.bounds[0], y.start - 0.007);
    near(y.bounds[1], y.start + 0.002);
    near(request.limits.boxes[0].limits[0][0], x.bounds[0]);
    near(request.limits.boxes[0].limits[0][1], x.bounds[1]);
    assert_eq!(request.limits.boxes[0].limits[2], [f64::NEG_INFINITY, f64::INFINITY]);
}

#[test]
fn ties_are_linear_equations() {
    let (model, request) = complete();
    let [offset, equal, mirror] = &request.ties[..] else { panic!("three ties") };
    let value = |tie: &hardpoint::design::request::Tie| -> f64 {
        tie.terms.iter().map(|(variable, factor)| factor * request.variables[*variable].start).sum()
    };
    assert_eq!(
        (offset.relation, offset.name.as_str()),
        (Relation::Offset, "lca_front.z and lca_rear.z")
    );
    assert_eq!(offset.terms.iter().map(|term| term.1).collect::<Vec<_>>(), [1.0, -1.0]);
    near(offset.value, -0.005);
    near(value(offset), offset.value);
    // The locked point counts as it is.
    assert_eq!((equal.relation, equal.terms.len()), (Relation::Equal, 1));
    near(equal.value, model.point("wheel_center").unwrap()[2]);
    assert_eq!(mirror.terms.iter().map(|term| term.1).collect::<Vec<_>>(), [1.0, 1.0]);
    near(mirror.value, 0.2);
}

#[test]
fn limits_know_their_bodies_and_states() {
    let (model, request) = complete();
    let limits = &request.limits;
    near(limits.movement.unwrap(), 0.015);
    near(limits.total_movement.unwrap(), 0.04);
    let body = |name: &str| {
        1 + model.architecture.bodies().iter().position(|body| body.name == name).unwrap()
    };
    let named = |end: &hardpoint::design::request::End| {
        (model.points()[end.0.index()].name.as_str(), end.1.index())
    };
    let [tierod, rack] = &limits.boxes[..] else { panic!("two boxes") };
    let points: Vec<_> = tierod.points.iter().map(named).collect();
    assert_eq!(points, [("tierod_inner", body("tierod")), ("tierod_outer", body("tierod"))]);
    assert_eq!((tierod.name.as_str(), rack.name.as_str()), ("box 1", "rack"));
    assert_eq!(tierod.limits[1], [0.3, 0.9]);
    // The design position, and the ends of travel and rack of all targets.
    let states: Vec<_> = tierod.states.iter().map(|s| (s.wheels[0], s.rack)).collect();
    let travel = |travel, rack| (Hold::Value(travel), rack);
    let expected = [
        travel(0.0, 0.0),
        travel(-0.05, 0.0),
        travel(0.05, 0.0),
        travel(0.0, -0.01),
        travel(0.0, 0.01),
    ];
    assert_eq!(states, expected);
    assert_eq!(rack.states.len(), 1);

    let [spring, rim, tyre] = &limits.clearances[..] else { panic!("three clearances") };
    let [Part::Link(rod), Part::Link(line)] = spring.between else { panic!("two links") };
    let rod: Vec<_> = rod.iter().map(named).collect();
    assert_eq!(rod, [("tierod_outer", body("tierod")), ("tierod_inner", body("tierod"))]);
    let line: Vec<_> = line.iter().map(named).collect();
    assert_eq!(line, [("spring_upper", 0), ("spring_lower", body("lca"))]);
    assert_eq!((spring.radii, spring.distance), ([0.009, 0.06], 0.008));
    assert_eq!(spring.states.len(), 9);
    assert_eq!(spring.states[8].rack, 0.04);
    assert!(matches!(rim.between, [Part::Point(_), Part::Rim]));
    assert_eq!(rim.states.len(), 2);
    assert!(matches!(tyre.between, [Part::Link(_), Part::Tyre]));
    let wheel = limits.rim.unwrap();
    near(wheel.offset, -0.02);

    let [design, lower, between] = &limits.angles[..] else { panic!("three angles") };
    assert_eq!((design.from, design.on.index()), (Reference::Design, body("upright")));
    near(design.max, 22.0_f64.to_radians());
    assert_eq!(lower.from, Reference::Direction([0.0, 1.0, 0.0]));
    assert_eq!(lower.name, "lower ball joint");
    assert_eq!(between.on, BodyId::GROUND);
    assert!(matches!(between.from, Reference::Between(_)));

    assert_eq!((request.search.starts, request.search.seed, request.search.iterations), (8, 3, 50));
    let pareto = request.pareto.unwrap();
    assert_eq!((pareto.targets, pareto.points), ([1, 4], 5));
    let robust = request.robustness.as_ref().unwrap();
    let deviation = |name: &str| {
        robust.deviations[model.points().iter().position(|point| point.name == name).unwrap()]
    };
    near(deviation("lca_front"), 0.0002);
    near(deviation("lca_outer"), 0.0001);
    assert_eq!(deviation("wheel_center"), 0.0);
    assert_eq!((&robust.targets[..], robust.weight, robust.samples), (&[1][..], 0.5, 1000));
}

#[test]
fn later_mistakes_have_their_places() {
    let (_, request) = complete();
    let place = &request.targets[5].place;
    let mistake = request.mistake(place, "it is not defined there", "this target", "leave it out");
    let text = std::fs::read_to_string("tests/fixtures/requests/complete.toml").unwrap();
    let line = 1 + text[..text.find("factor = \"anti_dive\"").unwrap()].matches('\n').count();
    assert_eq!(mistake.line_and_column(), Some((line - 1, 1)));
    let rendered = request.refuse(vec![mistake]).render();
    assert!(rendered.contains("it is not defined there"), "{rendered}");
}

#[test]
fn the_examples_of_the_documentation_are_requests() {
    let model = model("models/sedan-axle.toml");
    let text = std::fs::read_to_string("docs/synthesis.md").unwrap();
    let first = text.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let request = Request::parse("first.toml", first, &model);
    let request = request.unwrap_or_else(|error| panic!("{}", error.render()));
    assert_eq!((request.targets.len(), request.variables.len()), (2, 2));
    // Limits, search, trade-off and robustness belong to one request.
    let blocks: Vec<&str> =
        text.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    let found = |start: &str| blocks.iter().find(|block| block.starts_with(start)).unwrap();
    let parts = [first, found("[limits]"), found("[search]")].join("\n");
    let request = Request::parse("limits.toml", &parts, &model);
    let request = request.unwrap_or_else(|error| panic!("{}", error.render()));
    assert_eq!(request.limits.clearances.len(), 2);
    assert!(request.pareto.is_some() && request.robustness.is_some());
    assert!(!request.needs_axle(&model));
}
