//! Springs about axes: anti-roll bars, and the leaves of the SAE's three-link model.

use crate::import::Mistakes;
use crate::import::draft::{Draft, Part, PartKind};
use crate::import::json::Json;
use crate::import::sheet::Value;
use crate::vector::{norm, sub};

/// Damping of the leaves (s) as Chrono has it: a hundredth of the stiffness for each radian a second.
const LEAF_DAMPING: f64 = 0.01;

/// The bar turns in the middle: a torsion spring between its halves.
pub(super) fn anti_roll_bar(root: &Json, draft: &mut Draft, mistakes: &mut Mistakes) {
    let Some(object) = root.get("Anti Roll Bar") else { return };
    let [stiffness, damping] =
        ["Rotational Stiffness", "Rotational Damping"].map(|key| object.number(key, mistakes));
    let Some(stiffness) = stiffness else {
        mistakes.note(object.line, "the anti-roll bar has no `Rotational Stiffness`", "add it");
        return;
    };
    let mut entries = vec![("axis", Value::from("y")), ("stiffness", Value::from(stiffness))];
    entries.extend(damping.map(|damping| ("damping", Value::from(damping))));
    draft.add_part(Part {
        name: "anti_roll_bar".to_owned(),
        line: object.line,
        called: "Anti Roll Bar".to_owned(),
        kind: PartKind::AxleForce(
            "torsion-spring",
            ["arb_arm", "other.arb_arm"].map(str::to_owned),
        ),
        entries,
        points: vec![],
        comments: vec![],
    });
}

/// A half of a leaf spring: its names here, its point on the clamp and its eye.
struct Leaf {
    leaf: &'static str,
    clamp_half: &'static str,
    clamp: &'static str,
    eye: &'static str,
}

const LEAVES: [Leaf; 2] = [
    Leaf {
        leaf: "front_leaf",
        clamp_half: "clamp_front_half",
        clamp: "clamp_front",
        eye: "front_hanger",
    },
    Leaf {
        leaf: "rear_leaf",
        clamp_half: "clamp_rear_half",
        clamp: "clamp_rear",
        eye: "shackle_end",
    },
];

/// What is given for the whole spring, shared among its halves: the rear one has `Stiffness Bias` times the
/// stiffness of the front one, and each carries half of the preload. A force at the eye, a lever away from the
/// clamp, becomes a moment about the clamp.
pub(super) fn leaf_springs(root: &Json, draft: &mut Draft, mistakes: &mut Mistakes) {
    let Some(object) = root.get("Leafspring") else { return };
    let keys =
        ["Vertical Stiffness", "Lateral Stiffness", "Stiffness Bias", "Vertical Preload Force"];
    let numbers = keys.map(|key| {
        let number = object.number(key, mistakes);
        if number.is_none() && !object.has(key) {
            mistakes.note(object.line, format!("`Leafspring` has no `{key}`"), "add it");
        }
        number
    });
    let [Some(vertical), Some(lateral), Some(bias), Some(preload)] = numbers else { return };
    if !(bias > 0.0 && vertical > 0.0 && lateral > 0.0) {
        let what = "the stiffnesses and the bias of a leaf spring are above zero";
        mistakes.note(object.line, what, "correct the numbers that are not");
        return;
    }
    for (Leaf { leaf, clamp_half, clamp, eye }, share) in LEAVES.iter().zip([1.0, bias]) {
        let (Some(from), Some(to)) = (draft.position(clamp), draft.position(eye)) else { continue };
        let lever = sub(to, from);
        let by = share / (1.0 + bias) * norm(lever).powi(2);
        // The chassis presses the eye down, and the clamp turns the leaf up against it: a moment about y of −x times the force.
        let moment = 0.0 - 0.5 * preload * lever[0];
        let spring =
            |name: String, bodies: [&str; 2], axis, stiffness: f64, preload: Option<f64>| Part {
                name,
                line: object.line,
                called: "Leafspring".to_owned(),
                kind: PartKind::Force("torsion-spring", bodies.map(str::to_owned)),
                entries: [
                    Some(("axis", Value::from(axis))),
                    Some(("stiffness", Value::from(stiffness))),
                    preload.map(|moment| ("preload", Value::from(moment))),
                    Some(("damping", Value::from(LEAF_DAMPING * stiffness))),
                ]
                .into_iter()
                .flatten()
                .collect(),
                points: vec![],
                comments: vec![],
            };
        let bending = format!("{leaf}_bending");
        let sideways = format!("{bending}_sideways");
        draft.add_part(spring(bending, [clamp_half, leaf], "y", vertical * by, Some(moment)));
        draft.add_part(spring(sideways, ["axle", clamp_half], "z", lateral * by, None));
    }
}
