//! Masses: bodies of Chrono that are one body here are put together.

use super::template::{Center, Frame, Mass, Template};
use crate::import::draft::{Body, Point};
use crate::import::json::Json;
use crate::import::{LeftOut, Mistakes};
use crate::vector::{cross, dot, scale, sub, unit};

/// A mass with its tensor about its centre, in the axes of the vehicle.
#[derive(Clone, Copy)]
struct Lump {
    mass: f64,
    center: [f64; 3],
    tensor: [[f64; 3]; 3],
}

/// The bodies of a model with the masses of the file.
pub(super) fn bodies(
    root: &Json,
    template: &Template,
    left_out: &mut Vec<LeftOut>,
    points: &[Point],
    mistakes: &mut Mistakes,
) -> Vec<Body> {
    let mut bodies: Vec<(Body, Lump)> = vec![];
    for row in template.masses {
        let Some(object) = root.get(row.object).filter(|object| object.has("Mass")) else {
            continue;
        };
        let Some(lump) = lump(root, object, row, points, mistakes) else {
            left_out.push(LeftOut {
                line: object.line,
                what: format!("the mass of `{}`", row.object),
                why: "its centre or its inertia is not there".to_owned(),
            });
            continue;
        };
        if let Some((body, first)) = bodies.iter_mut().find(|(body, _)| body.name == row.body) {
            body.called = format!("{} and {}", body.called, row.object);
            *first = together(*first, lump);
        } else {
            let body = Body {
                name: row.body.to_owned(),
                line: object.line,
                called: row.object.to_owned(),
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
    points: &[Point],
    mistakes: &mut Mistakes,
) -> Option<Lump> {
    let at =
        |name: &str| points.iter().find(|point| point.name == name).map(|point| point.position);
    let mass = object.number("Mass", mistakes)?;
    let center = match row.center {
        Center::Own => object.vector("COM", mistakes)?,
        Center::Between(a, b) => {
            let (a, b) = (at(a)?, at(b)?);
            std::array::from_fn(|axis| 0.5 * (a[axis] + b[axis]))
        }
    };
    let moments = match object.has("Inertia") {
        true => object.vector("Inertia", mistakes)?,
        false => object.vector("Moments of Inertia", mistakes)?,
    };
    let products = match object.has("Inertia Products") {
        true => object.vector("Inertia Products", mistakes)?,
        false => object.vector("Products of Inertia", mistakes).unwrap_or_default(),
    };
    let [xy, xz, yz] = products;
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
    };
    let tensor = frame.map_or(tensor, |axes| turned(tensor, axes));
    // Points that coincide leave no axes; the model will be told so.
    tensor.iter().flatten().all(|entry| entry.is_finite()).then_some(Lump { mass, center, tensor })
}

/// A tensor given in these axes, in those of the vehicle: Σ J_ab e_a e_bᵀ.
fn turned(tensor: [[f64; 3]; 3], axes: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
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
    fn write(self, body: Body) -> Body {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = self.tensor;
        // A sum of products of zeros may be −0.
        let inertia = [xx, yy, zz, xy, xz, yz].map(|entry| entry + 0.0);
        Body { mass: self.mass, center: self.center, inertia, ..body }
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
