//! Masses: bodies of Chrono that are one body here are put together.

use super::template::{Center, Frame, Mass, Template};
use crate::import::draft::{Body, Draft, Point};
use crate::import::json::Json;
use crate::import::{LeftOut, Mistakes};
use crate::model::{Architecture, Side};
use crate::vector::{add, cross, dot, scale, sub, unit};

/// A mass with its tensor about its centre, in the axes of the vehicle.
#[derive(Clone, Copy)]
pub(super) struct Lump {
    pub(super) mass: f64,
    pub(super) center: [f64; 3],
    pub(super) tensor: [[f64; 3]; 3],
}

/// The bodies of a model with the masses of the file.
pub(super) fn bodies(
    root: &Json,
    template: &Template,
    architecture: Option<&Architecture>,
    draft: &mut Draft,
    mistakes: &mut Mistakes,
) -> Vec<Body> {
    // Bodies of both sides stand as the file has them; those of one are its left ones.
    let shared = |name: &str| {
        let mut bodies = architecture.into_iter().flat_map(Architecture::bodies);
        bodies.any(|body| body.name == name && body.shared)
    };
    let mut bodies: Vec<(Body, Lump)> = vec![];
    for row in template.masses {
        let called = row.object.join(" / ");
        let found = row.object.iter().try_fold(root, |object, key| object.get(key));
        let Some(object) = found.filter(|object| object.has(&format!("{}Mass", row.prefix))) else {
            continue;
        };
        let mirrored = draft.side == Some(Side::Right) && !shared(row.body);
        let Some(lump) = lump(root, object, row, mirrored, &draft.points, mistakes) else {
            draft.left_out.push(LeftOut {
                line: object.line,
                what: format!("the mass of `{called}`"),
                why: "its centre or its inertia is not there".to_owned(),
            });
            continue;
        };
        if let Some((body, first)) = bodies.iter_mut().find(|(body, _)| body.name == row.body) {
            body.called = format!("{} and {called}", body.called);
            *first = together(*first, lump);
        } else {
            let body = Body {
                name: row.body.to_owned(),
                line: object.line,
                called: format!(
                    "{called}{}{}",
                    if row.prefix.is_empty() { "" } else { ", " },
                    row.prefix.trim_end()
                ),
                mass: 0.0,
                center: [0.0; 3],
                inertia: [0.0; 6],
            };
            bodies.push((body, lump));
        }
    }
    bodies.into_iter().map(|(body, lump)| lump.write(body)).collect()
}

fn lump(
    root: &Json,
    object: &Json,
    row: &Mass,
    mirrored: bool,
    points: &[Point],
    mistakes: &mut Mistakes,
) -> Option<Lump> {
    let at =
        |name: &str| points.iter().find(|point| point.name == name).map(|point| point.position);
    let key = |name: &str| format!("{}{name}", row.prefix);
    let mass = object.number(&key("Mass"), mistakes)?;
    let center = match row.center {
        Center::Own | Center::Both => {
            let [x, y, z] = object.vector("COM", mistakes)?;
            [x, if mirrored { 0.0 - y } else { y }, z]
        }
        Center::Mean(names) => mean(names, at)?,
        Center::Across(names) => {
            let [x, _, z] = mean(names, at)?;
            [x, 0.0, z]
        }
        Center::Half(name) => {
            let [x, y, z] = at(name)?;
            [x, 0.5 * y, z]
        }
    };
    let moments = match object.has(&key("Inertia")) {
        true => object.vector(&key("Inertia"), mistakes)?,
        false => object.vector(&key("Moments of Inertia"), mistakes)?,
    };
    let products = match object.has("Inertia Products") {
        true => object.vector("Inertia Products", mistakes)?,
        false => object.vector("Products of Inertia", mistakes).unwrap_or_default(),
    };
    let [xy, xz, yz] = products;
    let (xy, yz) = if mirrored { (0.0 - xy, 0.0 - yz) } else { (xy, yz) };
    let tensor = [[moments[0], xy, xz], [xy, moments[1], yz], [xz, yz, moments[2]]];
    let vehicle = root
        .get("Vehicle-Frame Inertia")
        .is_some_and(|flag| matches!(flag.take().kind, crate::import::json::Kind::Bool(true)));
    let frame = match row.frame {
        Frame::Vehicle => None,
        // The inertia of a rod is always in its own axes.
        Frame::Rod(inner, outer) => {
            let along = unit(sub(at(outer)?, at(inner)?));
            let normal = unit(cross(along, [1.0, 0.0, 0.0]));
            Some([cross(normal, along), normal, along])
        }
        Frame::Arm(..) if vehicle => None,
        Frame::Arm(rear, front, outer) => {
            let (rear, front, outer) = (at(rear)?, at(front)?, at(outer)?);
            let normal = unit(cross(sub(rear, outer), sub(front, outer)));
            let along = unit(sub(front, rear));
            Some([along, cross(normal, along), normal])
        }
        Frame::Plane(from, to, third) => {
            let (from, to) = (at(from)?, at(to)?);
            let third = third.map_or(Some([0.0; 3]), at)?;
            let normal = unit(cross(sub(from, third), sub(to, third)));
            let along = unit(sub(to, from));
            Some([cross(normal, along), normal, along])
        }
    };
    let tensor = frame.map_or(tensor, |axes| turned(tensor, axes));
    // Points that coincide leave no axes; the model will be told so.
    let lump = Lump { mass, center, tensor };
    let finite = tensor.iter().flatten().all(|entry| entry.is_finite());
    finite.then_some(if matches!(row.center, Center::Both) {
        together(lump, lump.mirrored())
    } else {
        lump
    })
}

/// The mean of points of the model.
fn mean(names: &[&str], at: impl Fn(&str) -> Option<[f64; 3]>) -> Option<[f64; 3]> {
    let places: Vec<[f64; 3]> = names.iter().map(|name| at(name)).collect::<Option<_>>()?;
    let sum = places.iter().copied().fold([0.0; 3], add);
    Some(sum.map(|x| x / places.len() as f64))
}

/// A tensor given in these axes, in those of the vehicle: Σ J_ab e_a e_bᵀ.
pub(super) fn turned(tensor: [[f64; 3]; 3], axes: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let entry = |row: usize, column: usize| {
        let mut sum = 0.0;
        for (a, inner) in tensor.iter().enumerate() {
            for (b, value) in inner.iter().enumerate() {
                sum += axes[a][row] * value * axes[b][column];
            }
        }
        sum
    };
    std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)))
}

/// Two masses as one body, about the common centre (Huygens–Steiner).
fn together(a: Lump, b: Lump) -> Lump {
    let mass = a.mass + b.mass;
    let center =
        std::array::from_fn(|axis| (a.mass * a.center[axis] + b.mass * b.center[axis]) / mass);
    let mut tensor = [[0.0; 3]; 3];
    for part in [a, b] {
        let from = sub(part.center, center);
        let steiner = scale(part.mass, from);
        for row in 0..3 {
            for column in 0..3 {
                let square = if row == column { dot(steiner, from) } else { 0.0 };
                tensor[row][column] +=
                    part.tensor[row][column] + square - steiner[row] * from[column];
            }
        }
    }
    Lump { mass, center, tensor }
}

impl Lump {
    /// Its mirror image on the other side of the vehicle.
    pub(super) fn mirrored(self) -> Self {
        let [x, y, z] = self.center;
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = self.tensor;
        let tensor = [[xx, -xy, xz], [-xy, yy, -yz], [xz, -yz, zz]];
        Self { center: [x, -y, z], tensor, ..self }
    }

    fn write(self, body: Body) -> Body {
        let (center, inertia) = self.center_and_inertia();
        Body { mass: self.mass, center, inertia, ..body }
    }

    /// The centre of mass, and Jxx, Jyy, Jzz, Jxy, Jxz, Jyz.
    pub(super) fn center_and_inertia(self) -> ([f64; 3], [f64; 6]) {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = self.tensor;
        // A sum of products of zeros may be −0.
        let inertia = [xx, yy, zz, xy, xz, yz].map(|entry| entry + 0.0);
        (self.center.map(|x| x + 0.0), inertia)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_points_make_a_dumbbell() {
        let point = |x| Lump { mass: 2.0, center: [x, 1.0, 0.0], tensor: [[0.0; 3]; 3] };
        let both = together(point(-3.0), point(3.0));
        assert_eq!((both.mass, both.center), (4.0, [0.0, 1.0, 0.0]));
        assert_eq!(both.tensor, [[0.0, 0.0, 0.0], [0.0, 36.0, 0.0], [0.0, 0.0, 36.0]]);
    }

    #[test]
    fn axes_turn_a_tensor() {
        let tensor = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
        let axes = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
        assert_eq!(turned(tensor, axes), [[3.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.0]]);
    }
}
