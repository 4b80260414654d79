//! Requests that no design meets: what contradicts itself is named, and what is missed.
#![allow(missing_docs)]

#[path = "common/designs.rs"]
mod designs;

use designs::{Rig, model, parse, seek, written};
use hardpoint::design::synthesis::Verdict;
use hardpoint::vector::{dot, norm, scale, sub};

/// What stands between a request of the double wishbone and a design.
fn conflict(request: &str) -> Vec<String> {
    let model = model("double-wishbone");
    let request = parse(&format!("format = 1\n{request}"), &model);
    match seek(&model, &request).verdict {
        Verdict::Conflict { mut between } => {
            between.sort();
            between
        }
        other => panic!("{other:?}"),
    }
}

const UP_AND_DOWN: &str =
    "[[variables]]\npoint = \"lca_outer\"\ncoordinates = [\"z\"]\nrange = 10.0\n";

#[test]
fn a_target_out_of_reach_is_named_with_what_stops_it() {
    let between = conflict(&format!(
        "[[targets]]\nfactor = \"rc_height\"\nvalue = 300.0\nhard = true\n{UP_AND_DOWN}"
    ));
    assert_eq!(between, ["lca_outer.z at least -330 mm", "target `rc_height` equal to 300 mm"]);
}

#[test]
fn targets_that_contradict_each_other_are_named() {
    let target = |name: &str, value: f64, more: &str| {
        format!(
            "[[targets]]\nname = \"{name}\"\nfactor = \"rc_height\"\n{more} = {value}\nhard = true\n"
        )
    };
    let both = target("low", 100.0, "max") + &target("high", 110.0, "min");
    let other = "[[targets]]\nfactor = \"bump_steer\"\nvalue = 0.0\nhard = true\n\
                 [[variables]]\npoint = \"tierod_inner\"\ncoordinates = [\"z\"]\nrange = 40.0\n";
    let between =
        conflict(&format!("{both}{other}{UP_AND_DOWN}").replace("range = 10.0", "range = 60.0"));
    assert_eq!(between, ["target `high` at least 110 mm", "target `low` at most 100 mm"]);
}

const OPEN: &str = "[[targets]]\nfactor = \"bump_steer\"\nvalue = 0.0\n";

#[test]
fn a_box_without_its_point_is_named() {
    let rest = "[[boxes]]\nname = \"rack room\"\npoints = [\"tierod_inner\"]\nz = [-50.0, 0.0]\n\
                at = { travel = 0.0 }\n[[boxes]]\npoints = [\"tierod_outer\"]\ny = [700.0, 800.0]\n";
    let variable = "[[variables]]\npoint = \"tierod_inner\"\ncoordinates = [\"z\"]\nrange = 10.0\n";
    assert_eq!(
        conflict(&format!("{OPEN}{variable}{rest}")),
        ["rack room: tierod_inner.z at least -50 mm", "tierod_inner.z at most -110 mm"]
    );
    // A point that cannot change contradicts the box alone.
    let other = "[[variables]]\npoint = \"tierod_outer\"\ncoordinates = [\"z\"]\nrange = 10.0\n";
    let alone = ["rack room: tierod_inner.z at least -50 mm"];
    assert_eq!(conflict(&format!("{OPEN}{other}{rest}")), alone);
}

#[test]
fn a_clearance_that_bounds_do_not_allow_is_named() {
    let rest = "[[clearances]]\nname = \"tie rod\"\nbetween = [\"tierod_outer\", \"lca_outer\"]\n\
                distance = 300.0\nat = { travel = 0.0 }\n";
    let variable = "[[variables]]\npoint = \"tierod_outer\"\ncoordinates = [\"z\"]\nrange = 10.0\n";
    assert_eq!(
        conflict(&format!("{OPEN}{variable}{rest}")),
        ["tie rod: at least 300 mm", "tierod_outer.z at most -110 mm"]
    );
}

#[test]
fn movement_that_does_not_reach_is_named() {
    let variable =
        "[[variables]]\npoint = \"tierod_inner\"\nrange = 30.0\n[limits]\nmovement = 5.0\n";
    let rest = "[[boxes]]\npoints = [\"tierod_inner\"]\nz = [-100.0, 0.0]\nat = { travel = 0.0 }\n";
    assert_eq!(
        conflict(&format!("{OPEN}{variable}{rest}")),
        ["box 1: tierod_inner.z at least -100 mm", "movement of tierod_inner: at most 5 mm"]
    );
}

/// What is not hard and out of reach is told as missed, with limits kept.
#[test]
fn soft_targets_out_of_reach_are_missed() {
    let model = model("double-wishbone");
    let text = format!(
        "format = 1\n[[targets]]\nfactor = \"rc_height\"\nvalue = 300.0\n\
         [[targets]]\nfactor = \"toe\"\nhold = true\n{UP_AND_DOWN}"
    );
    let request = parse(&text, &model);
    let found = seek(&model, &request);
    let Verdict::Compromise { unmet } = &found.verdict else { panic!("{:?}", found.verdict) };
    assert_eq!(unmet.iter().map(|unmet| unmet.target).collect::<Vec<_>>(), [0]);
    assert!(unmet[0].off < -0.01 && unmet[0].tolerances > 100.0, "{unmet:?}");
    assert_eq!(found.held.len(), 1, "{:?}", found.held);
    assert_eq!(found.held[0].name, "lca_outer.z at least -330 mm");
    assert!(found.held[0].cost > 1.0);
}

/// A rim keeps what lies within its width, which is about a place on the spin axis.
#[test]
fn the_rim_is_where_its_offset_says() {
    let model = model("double-wishbone");
    let radial = |offset: f64| {
        let text = format!(
            "format = 1\n[[targets]]\nfactor = \"toe\"\nhold = true\n[[variables]]\npoint = \"tierod_outer\"\n\
             coordinates = [\"x\"]\nrange = 60.0\n[rim]\nradius = 130.0\nwidth = 40.0\noffset = {offset}\n\
             [[clearances]]\nbetween = [\"tierod_outer\", \"rim\"]\ndistance = 10.0\nat = {{ travel = 0.0 }}\n"
        );
        let request = parse(&text, &model);
        let found = seek(&model, &request);
        assert_eq!(found.verdict, Verdict::Met);
        let mut rig = Rig::new(&written("double-wishbone", &request, &found));
        rig.go_to([0.0; 2]);
        let [center, spin] = rig.wheel();
        let way = sub(rig.point("tierod_outer", "tierod"), center);
        norm(sub(way, scale(dot(way, spin), spin)))
    };
    // The point lies 28 mm inboard of the wheel centre, 150 mm off the axis.
    assert!((radial(-28.0) - 0.12).abs() < 2e-8, "{}", radial(-28.0));
    assert!(radial(60.0) > 0.149, "{}", radial(60.0));
}
