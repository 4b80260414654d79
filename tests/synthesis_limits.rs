//! Limits of requests hold in every result.
#![allow(missing_docs)]

#[path = "common/designs.rs"]
mod designs;

use std::fmt::Write as _;

use designs::{Rig, angle, between, model, parse, seek, written};
use hardpoint::design::synthesis::{Synthesis, Verdict};
use hardpoint::factors;
use hardpoint::model::{Model, Setup};
use hardpoint::rig::Corner;
use hardpoint::vector::{dot, norm, scale, sub};
use proptest::prelude::*;

/// A limit may be passed by this (m, rad): the file has six decimals of a millimetre, and constraints are met to 1e-9 of
/// their typical change.
const SLACK: f64 = 2e-8;

/// Travels and racks (m) at which limits count.
const STATES: [[f64; 2]; 4] = [[0.0, 0.0], [-0.03, 0.0], [0.03, 0.0], [0.0, 0.01]];

/// What is known of a model to ask for limits.
struct Known {
    name: &'static str,
    /// Points that may change; the first three are those of the limits.
    points: [&'static str; 7],
    /// A link of two points of a body to keep away from the tie rod.
    other: ([&'static str; 2], &'static str),
}

const KNOWN: [Known; 2] = [
    Known {
        name: "double-wishbone",
        points: [
            "tierod_inner",
            "lca_front",
            "lca_rear",
            "tierod_outer",
            "lca_outer",
            "uca_outer",
            "uca_front",
        ],
        other: (["lca_rear", "lca_outer"], "lca"),
    },
    Known {
        name: "macpherson",
        points: [
            "tierod_inner",
            "lca_front",
            "lca_rear",
            "tierod_outer",
            "lca_outer",
            "strut_upper",
            "strut_lower",
        ],
        other: (["lca_rear", "lca_outer"], "lca"),
    },
];

/// A random request. All parts are from 0 to 1.
#[derive(Clone, Debug)]
struct Wish {
    macpherson: bool,
    /// Which coordinates may change, and how far.
    ranges: Vec<(usize, usize, f64)>,
    /// How far factors are to change.
    targets: [f64; 3],
    movement: Option<f64>,
    total: Option<f64>,
    tie: Option<usize>,
    boxed: Option<f64>,
    clearance: Option<f64>,
    rim: Option<f64>,
    angle: Option<f64>,
    locked: usize,
}

fn wish() -> impl Strategy<Value = Wish> {
    let part = || 0.0..1.0;
    let maybe = || prop::option::of(0.0..1.0);
    let ranges = prop::collection::vec((0..7_usize, 0..3_usize, part()), 2..6);
    let limits =
        (maybe(), maybe(), prop::option::of(0..3_usize), maybe(), maybe(), maybe(), maybe());
    (any::<bool>(), ranges, prop::array::uniform3(-1.0..1.0), limits, 0..7_usize).prop_map(
        |(macpherson, ranges, targets, limits, locked)| {
            let (movement, total, tie, boxed, clearance, rim, angle) = limits;
            Wish {
                macpherson,
                ranges,
                targets,
                movement,
                total,
                tie,
                boxed,
                clearance,
                rim,
                angle,
                locked,
            }
        },
    )
}

/// A request with the numbers (m, rad) that its limits have.
struct Asked {
    text: String,
    known: &'static Known,
    movement: Option<f64>,
    total: Option<f64>,
    tie: Option<usize>,
    boxed: Option<[f64; 2]>,
    clearance: Option<f64>,
    rim: Option<f64>,
    angle: Option<f64>,
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The distance of the tie rod from another link, that of its outer end from the axis of the wheel, and the angle of
/// its socket on the upright, the worst of all states.
fn worst(model: &Model, known: &Known) -> [f64; 3] {
    let mut rig = Rig::new(model);
    let mut worst = [f64::INFINITY, 0.0, 0.0];
    for state in STATES {
        rig.go_to(state);
        let rod = ["tierod_inner", "tierod_outer"].map(|name| rig.point(name, "tierod"));
        let (ends, body) = known.other;
        let other = ends.map(|name| rig.point(name, body));
        worst[0] = f64::min(worst[0], between(rod, other));
        let [center, spin] = rig.wheel();
        let way = sub(rod[1], center);
        let radial = norm(sub(way, scale(dot(way, spin), spin)));
        worst[1] = f64::max(worst[1], radial);
        let design =
            sub(model.point("tierod_outer").unwrap(), model.point("tierod_inner").unwrap());
        worst[2] = f64::max(worst[2], angle(sub(rod[1], rod[0]), rig.turned("upright", design)));
    }
    worst
}

fn ask(wish: &Wish) -> Asked {
    let known = &KNOWN[usize::from(wish.macpherson)];
    let model = model(known.name);
    let [distance, radial, turned] = worst(&model, known);
    let factor = |name: &str| {
        let mut corner = Corner::new(&model, &Setup::default()).unwrap();
        corner.move_to(0.0, 0.0).unwrap();
        factors::find(name).unwrap().show(model.units, &corner.pose()).unwrap()
    };
    let mut text = "format = 1\n".to_owned();
    let mut used: Vec<(usize, usize)> = vec![];
    let locked = known.points[wish.locked];
    let free = |point: usize| known.points[point] != locked;
    let mut variables = String::new();
    let mut variable = |point: usize, axis: usize, part: f64| {
        if free(point) && !used.contains(&(point, axis)) {
            used.push((point, axis));
            let range = 2.0 + 18.0 * part;
            writeln!(
                variables,
                "[[variables]]\npoint = \"{}\"\ncoordinates = [\"{}\"]\nrange = [{}, {range}]",
                known.points[point], AXES[axis], -range
            )
            .unwrap();
        }
    };
    for &(point, axis, part) in &wish.ranges {
        variable(point, axis, part);
    }
    let tie = wish.tie.filter(|_| free(1) && free(2));
    if let Some(axis) = tie {
        variable(1, axis, 0.5);
        variable(2, axis, 0.4);
    }
    variable(3, 2, 0.5);
    variable(5, 1, 0.5);
    writeln!(text, "locked = [\"{locked}\"]\n{variables}").unwrap();
    let wanted = ["rc_height", "bump_steer", "camber_change"];
    for (name, (part, size)) in wanted.iter().zip(wish.targets.iter().zip([60.0, 40.0, 1.0])) {
        let (factor_name, at) = match *name {
            "camber_change" => ("camber", "at = { travel = 30.0 }\n"),
            other => (other, ""),
        };
        let value = factor(factor_name) + part * size;
        writeln!(text, "[[targets]]\nfactor = \"{factor_name}\"\nvalue = {value}\n{at}").unwrap();
    }
    let mm = |part: Option<f64>, from: f64, size: f64| part.map(|part| from + part * size);
    let movement = mm(wish.movement, 1.0, 10.0);
    let total = mm(wish.total, 2.0, 20.0);
    if movement.is_some() || total.is_some() {
        writeln!(text, "[limits]").unwrap();
        if let Some(most) = movement {
            writeln!(text, "movement = {most}").unwrap();
        }
        if let Some(most) = total {
            writeln!(text, "total_movement = {most}").unwrap();
        }
    }
    if let Some(axis) = tie {
        writeln!(
            text,
            "[[ties]]\npoints = [\"lca_front\", \"lca_rear\"]\ncoordinate = \"{}\"\nrelation = \"offset\"",
            AXES[axis]
        )
        .unwrap();
    }
    let at = "at = [{ travel = 0.0 }, { travel = -30.0 }, { travel = 30.0 }, { rack = 10.0 }]";
    let inner = 1e3 * model.point("tierod_inner").unwrap()[2];
    let boxed = wish.boxed.map(|part| [inner - 1.0 - 6.0 * part, inner + 7.0 - 8.0 * part]);
    if let Some([least, most]) = boxed {
        writeln!(text, "[[boxes]]\npoints = [\"tierod_inner\"]\nz = [{least}, {most}]\n{at}")
            .unwrap();
    }
    // Up to a millimetre more than the model has.
    let clearance = mm(wish.clearance, 1e3 * distance - 9.0, 10.0);
    if let Some(least) = clearance {
        let ([from, to], _) = known.other;
        writeln!(
            text,
            "[[clearances]]\nbetween = [[\"tierod_inner\", \"tierod_outer\"], [\"{from}\", \"{to}\"]]\n\
             distance = {least}\n{at}"
        )
        .unwrap();
    }
    let rim = mm(wish.rim, 1e3 * radial - 1.0, 10.0);
    if let Some(most) = rim {
        writeln!(
            text,
            "[rim]\nradius = {}\nwidth = 900.0\n[[clearances]]\nbetween = [\"tierod_outer\", \"rim\"]\n\
             distance = 5.0\n{at}",
            most + 5.0
        )
        .unwrap();
    }
    let most = wish.angle.map(|part| turned.to_degrees() - 0.5 + 3.0 * part);
    if let Some(most) = most {
        writeln!(
            text,
            "[[angles]]\nlink = [\"tierod_inner\", \"tierod_outer\"]\non = \"upright\"\nmax = {most}\n{at}"
        )
        .unwrap();
    }
    writeln!(text, "[search]\nstarts = 4").unwrap();
    let metres = |number: Option<f64>| number.map(|number| 1e-3 * number);
    Asked {
        text,
        known,
        movement: metres(movement),
        total: metres(total),
        tie,
        boxed: boxed.map(|ends| ends.map(|end| 1e-3 * end)),
        clearance: metres(clearance),
        rim: metres(rim),
        angle: most.map(f64::to_radians),
    }
}

/// What a design breaks, in words.
fn broken(asked: &Asked, found: &Synthesis) -> Vec<String> {
    let old = model(asked.known.name);
    let request = parse(&asked.text, &old);
    let new = written(asked.known.name, &request, found);
    let mut broken = vec![];
    let mut check = |kept: bool, what: String| {
        if !kept {
            broken.push(what);
        }
    };
    let mut together = 0.0;
    for (index, (before, after)) in old.points().iter().zip(new.points()).enumerate() {
        let way = norm(sub(after.position, before.position));
        together += way * way;
        if let Some(most) = asked.movement {
            check(way <= most + SLACK, format!("{} moved by {way}", before.name));
        }
        for axis in 0..3 {
            let (start, end) = (before.position[axis], after.position[axis]);
            let own = request.variables.iter().find(|variable| {
                variable.parameter.point() == Some(index) && variable.parameter.axis() == Some(axis)
            });
            match own {
                None => check(start == end, format!("{} moved along {axis}", before.name)),
                Some(variable) => {
                    let [least, most] = variable.bounds;
                    let inside = end >= least - SLACK && end <= most + SLACK;
                    check(inside, format!("{} is {end}", variable.name));
                }
            }
        }
    }
    if let Some(most) = asked.total {
        check(f64::sqrt(together) <= most + SLACK, format!("all moved by {together}"));
    }
    if let Some(axis) = asked.tie {
        let offset = |model: &Model| {
            model.point("lca_front").unwrap()[axis] - model.point("lca_rear").unwrap()[axis]
        };
        check((offset(&old) - offset(&new)).abs() < SLACK, format!("the tie is {}", offset(&new)));
    }
    let mut rig = Rig::new(&new);
    for state in STATES {
        rig.go_to(state);
        let inner = rig.point("tierod_inner", "tierod")[2];
        if let Some([least, most]) = asked.boxed {
            let inside = inner >= least - SLACK && inner <= most + SLACK;
            check(inside, format!("the box at {state:?}: {inner}"));
        }
    }
    let [distance, radial, turned] = worst(&new, asked.known);
    if let Some(least) = asked.clearance {
        check(distance >= least - SLACK, format!("the distance is {distance}, not {least}"));
    }
    if let Some(most) = asked.rim {
        check(radial <= most + SLACK, format!("the rim: {radial}, not {most}"));
    }
    if let Some(most) = asked.angle {
        check(turned <= most + 1e-6, format!("the angle is {turned}, not {most}"));
    }
    broken
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, max_shrink_iters: 20, ..ProptestConfig::default() })]

    /// Bounds, locks, ties and limits hold in the file of the design, or it is said what contradicts itself.
    #[test]
    fn limits_hold_in_every_result(wish in wish()) {
        let asked = ask(&wish);
        let old = model(asked.known.name);
        let found = seek(&old, &parse(&asked.text, &old));
        match &found.verdict {
            Verdict::Met | Verdict::Compromise { .. } => {
                let broken = broken(&asked, &found);
                prop_assert!(broken.is_empty(), "{broken:?}\n{:?}\n{}", found.verdict, asked.text);
            }
            // Neither is written; limits on curved ways such as movements may hide a contradiction.
            Verdict::Conflict { between: limits } | Verdict::Unfinished { broken: limits } => {
                prop_assert!(!limits.is_empty(), "{}", asked.text);
            }
            other => prop_assert!(false, "{other:?}\n{}", asked.text),
        }
    }
}
