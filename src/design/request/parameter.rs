//! What of a model can change: coordinates of points, stiffnesses, lengths, static angles.

use std::ops::Range;

use super::read::{AXES, Context};
use crate::mechanism::{Bushing, Curve, Force, ForceKind, Law, Reference};
use crate::model::{Model, Quantity, Report, SpinAxis, suggest};

/// A number of a model that can change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// A coordinate of a hard point, in ISO 8855 axes (m).
    Coordinate {
        /// The point, by its place in [`Model::points`].
        point: usize,
        /// 0, 1 or 2 for x, y or z.
        axis: usize,
    },
    /// A stiffness.
    Stiffness(Stiffness),
    /// The free length of a spring, by its place in [`Model::forces`] (m).
    FreeLength {
        /// The spring.
        force: usize,
    },
    /// Static toe of `[wheel]` (rad).
    Toe,
    /// Static camber of `[wheel]` (rad).
    Camber,
}

/// A linear stiffness (N/m or N·m/rad).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stiffness {
    /// Of a force element along a line or about an axis, by its place in [`Model::forces`].
    Force {
        /// The element.
        force: usize,
    },
    /// Of a bushing among the forces: components x, y, z, rx, ry, rz of its own axes, from 0.
    BushingForce {
        /// The element, by its place in [`Model::forces`].
        force: usize,
        /// The component.
        component: usize,
    },
    /// Of a bushing of `[bushings]`, in the same way.
    Bushing {
        /// The bushing, by its place in [`Model::bushings`].
        bushing: usize,
        /// The component.
        component: usize,
    },
    /// Of the anti-roll bar.
    AntiRollBar,
}

impl Parameter {
    /// Its kind.
    pub fn quantity(self, model: &Model) -> Quantity {
        match self {
            Self::Coordinate { .. } | Self::FreeLength { .. } => Quantity::Length,
            Self::Toe | Self::Camber => Quantity::Angle,
            Self::Stiffness(stiffness) => match stiffness {
                Stiffness::Force { force } => match model.forces()[force].kind {
                    ForceKind::Torsion { .. } => Quantity::RotationalStiffness,
                    _ => Quantity::Stiffness,
                },
                Stiffness::BushingForce { component, .. }
                | Stiffness::Bushing { component, .. } => {
                    if component < 3 {
                        Quantity::Stiffness
                    } else {
                        Quantity::RotationalStiffness
                    }
                }
                Stiffness::AntiRollBar => Quantity::RotationalStiffness,
            },
        }
    }

    /// The hard point that it is a coordinate of, by its place in [`Model::points`].
    pub fn point(self) -> Option<usize> {
        match self {
            Self::Coordinate { point, .. } => Some(point),
            _ => None,
        }
    }

    /// The axis (0, 1 or 2) of a coordinate.
    pub fn axis(self) -> Option<usize> {
        match self {
            Self::Coordinate { axis, .. } => Some(axis),
            _ => None,
        }
    }

    /// The value (SI) that a model has, `None` where a table stands for a stiffness, or where the model says
    /// it otherwise.
    pub fn value(self, model: &Model) -> Option<f64> {
        match self {
            Self::Coordinate { point, axis } => Some(model.points()[point].position[axis]),
            Self::FreeLength { force } => match model.forces()[force].kind {
                ForceKind::Line { reference: Reference::Length(free), .. } => Some(free),
                _ => None,
            },
            Self::Toe => alignment(model).map(|(toe, _)| toe),
            Self::Camber => alignment(model).map(|(_, camber)| camber),
            Self::Stiffness(stiffness) => match stiffness {
                Stiffness::Force { force } => match &model.forces()[force].kind {
                    ForceKind::Line { law, .. } | ForceKind::Torsion { law, .. } => linear(law),
                    _ => None,
                },
                Stiffness::BushingForce { force, component } => {
                    component_of(&model.forces()[force], component)
                }
                Stiffness::Bushing { bushing, component } => {
                    component_of(&model.bushings()[bushing].force, component)
                }
                Stiffness::AntiRollBar => model.anti_roll_bar().map(|bar| bar.stiffness),
            },
        }
    }

    /// Where the number stands in the file of the model: keys, names of forces, and places in lists from 0.
    pub fn path(self, model: &Model) -> Vec<String> {
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
        let bushing = |list: &str, name: &str, component: usize| {
            let key = if component < 3 { "stiffness" } else { "rotational_stiffness" };
            words(&[list, name, key, ["0", "1", "2"][component % 3]])
        };
        let force = |force: usize| model.forces()[force].name.as_str();
        match self {
            Self::Coordinate { point, axis } => {
                words(&["points", &model.points()[point].name, ["0", "1", "2"][axis]])
            }
            Self::FreeLength { force: of } => words(&["forces", force(of), "free_length"]),
            Self::Toe => words(&["wheel", "toe"]),
            Self::Camber => words(&["wheel", "camber"]),
            Self::Stiffness(Stiffness::Force { force: of }) => {
                words(&["forces", force(of), "stiffness"])
            }
            Self::Stiffness(Stiffness::BushingForce { force: of, component }) => {
                bushing("forces", force(of), component)
            }
            Self::Stiffness(Stiffness::Bushing { bushing: of, component }) => {
                bushing("bushings", &model.bushings()[of].force.name, component)
            }
            Self::Stiffness(Stiffness::AntiRollBar) => words(&["anti_roll_bar", "stiffness"]),
        }
    }
}

fn alignment(model: &Model) -> Option<(f64, f64)> {
    match &model.spin {
        SpinAxis::Alignment(alignment) => Some((alignment.toe, alignment.camber)),
        SpinAxis::Point(_) => None,
    }
}

fn linear(law: &Law) -> Option<f64> {
    match law.elastic {
        Curve::Linear(stiffness) => Some(stiffness),
        Curve::Zero => Some(0.0),
        Curve::Table(_) => None,
    }
}

fn component_of(force: &Force, component: usize) -> Option<f64> {
    let ForceKind::Bushing(bushing) = &force.kind else { return None };
    let Bushing { translation, rotation, .. } = bushing.as_ref();
    linear(translation.iter().chain(rotation).nth(component)?)
}

/// The parameters that a text such as `bushings.front.stiffness.x` names: all three of a bushing where it names
/// no component. Each has its own name.
pub(super) fn named(
    word: &str,
    span: &Range<usize>,
    context: &Context,
    report: &mut Report,
) -> Option<Vec<(String, Parameter)>> {
    let model = context.model;
    let all = all(model);
    let exact = all.iter().filter(|(name, _)| name == word);
    let inner = |name: &str| {
        name.strip_prefix(word)
            .and_then(|rest| rest.strip_prefix('.'))
            .is_some_and(|rest| AXES.contains(&rest))
    };
    let mut found: Vec<(String, Parameter)> = exact.cloned().collect();
    if found.is_empty() {
        found = all.iter().filter(|(name, _)| inner(name)).cloned().collect();
    }
    if found.is_empty() {
        let mut known: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
        known.truncate(40);
        report
            .mistake(span, format!("the model has no parameter `{word}`"), "unknown parameter")
            .help(suggest::choices(word, &known));
        return None;
    }
    for (name, parameter) in &found {
        if parameter.value(model).is_some() {
            continue;
        }
        let (message, help) = match parameter {
            Parameter::FreeLength { .. } => (
                format!("`{name}` is not in the file of the model"),
                "write a `free_length` there instead of a `preload`, without `installed_length`",
            ),
            Parameter::Toe | Parameter::Camber => (
                format!("`{name}` is not in the file of the model"),
                "let the point on the spin axis change: `point = \"…\"`",
            ),
            _ => (
                format!("a table stands for `{name}`"),
                "only a stiffness that is a number can change",
            ),
        };
        report.mistake(span, message, "cannot change").help(help);
        return None;
    }
    Some(found)
}

/// All parameters but coordinates, by their names in requests.
fn all(model: &Model) -> Vec<(String, Parameter)> {
    let mut all = vec![];
    let components = |before: String, of: &dyn Fn(usize) -> Stiffness| {
        let name = move |component: usize| {
            let key = if component < 3 { "stiffness" } else { "rotational_stiffness" };
            format!("{before}.{key}.{}", AXES[component % 3])
        };
        (0..6)
            .map(|component| (name(component), Parameter::Stiffness(of(component))))
            .collect::<Vec<_>>()
    };
    for (index, force) in model.forces().iter().enumerate() {
        let name = &force.name;
        let stiffness = || {
            let of = Parameter::Stiffness(Stiffness::Force { force: index });
            (format!("forces.{name}.stiffness"), of)
        };
        match &force.kind {
            ForceKind::Line { law, .. } if law.elastic != Curve::Zero => {
                all.push(stiffness());
                if let crate::mechanism::Acts::Always = law.acts {
                    let of = Parameter::FreeLength { force: index };
                    all.push((format!("forces.{name}.free_length"), of));
                }
            }
            ForceKind::Torsion { .. } => all.push(stiffness()),
            ForceKind::Bushing(_) => {
                let of = |component| Stiffness::BushingForce { force: index, component };
                all.extend(components(format!("forces.{name}"), &of));
            }
            _ => {}
        }
    }
    for (index, bushing) in model.bushings().iter().enumerate() {
        // Those of fittings are not in [bushings].
        let joint = &model.architecture.joints()[bushing.joint].name;
        let fitting = ["hub_bearing", "subframe_mounts", "steering_gear"];
        if bushing.each_side
            || fitting.contains(&joint.as_str())
            || fitting.contains(&bushing.force.name.as_str())
        {
            continue;
        }
        let of = |component| Stiffness::Bushing { bushing: index, component };
        all.extend(components(format!("bushings.{}", bushing.force.name), &of));
    }
    if model.anti_roll_bar().is_some() {
        let of = Parameter::Stiffness(Stiffness::AntiRollBar);
        all.push(("anti_roll_bar.stiffness".to_owned(), of));
    }
    all.push(("wheel.toe".to_owned(), Parameter::Toe));
    all.push(("wheel.camber".to_owned(), Parameter::Camber));
    all
}
