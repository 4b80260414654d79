//! Designs of synthesis looked at from outside: as the file has them, on a fresh corner.
#![allow(dead_code, reason = "each test binary uses a part of it")]

use hardpoint::design::edit::ModelText;
use hardpoint::design::request::Request;
use hardpoint::design::synthesis::{Synthesis, synthesize};
use hardpoint::model::{Model, Setup};
use hardpoint::rig::Corner;
use hardpoint::vector::{add, dot, norm, rotate, scale, sub};

pub type Vector = [f64; 3];

pub fn path(model: &str) -> String {
    format!("{}/models/{model}.toml", env!("CARGO_MANIFEST_DIR"))
}

pub fn model(name: &str) -> Model {
    Model::load(path(name)).unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

pub fn parse(text: &str, model: &Model) -> Request {
    Request::parse("targets.toml", text, model)
        .unwrap_or_else(|mistakes| panic!("{}\n{text}", mistakes.render()))
}

pub fn seek(model: &Model, request: &Request) -> Synthesis {
    synthesize(request, model, &Setup::default()).unwrap_or_else(|obstacle| panic!("{obstacle}"))
}

/// The design as its file would have it.
pub fn written(name: &str, request: &Request, found: &Synthesis) -> Model {
    let mut text = ModelText::load(path(name)).unwrap();
    let model = text.read().unwrap();
    for (variable, value) in request.variables.iter().zip(&found.values) {
        variable.write(&model, *value, &mut text).unwrap();
    }
    text.read().unwrap_or_else(|mistakes| panic!("{}", mistakes.render()))
}

/// A corner that says where its parts are.
pub struct Rig {
    corner: Corner,
    model: Model,
}

impl Rig {
    pub fn new(model: &Model) -> Self {
        Self { corner: Corner::new(model, &Setup::default()).unwrap(), model: model.clone() }
    }

    pub fn go_to(&mut self, [travel, rack]: [f64; 2]) {
        self.corner.reset();
        self.corner.move_to(travel, rack).unwrap_or_else(|stop| panic!("{stop}"));
    }

    /// A direction of a body in the axes of the ground.
    pub fn turned(&self, body: &str, direction: Vector) -> Vector {
        let bodies = self.corner.stand().mechanism().bodies();
        let index = bodies.iter().position(|other| other.name == body).expect("a body");
        let q = self.corner.stand().state()[index];
        rotate([q[3], q[4], q[5], q[6]], direction)
    }

    /// Where a point of a body is (m).
    pub fn point(&self, name: &str, body: &str) -> Vector {
        let bodies = self.corner.stand().mechanism().bodies();
        let index = bodies.iter().position(|other| other.name == body).expect("a body");
        let q = self.corner.stand().state()[index];
        let local = sub(self.model.point(name).expect("a point"), bodies[index].origin);
        add([q[0], q[1], q[2]], self.turned(body, local))
    }

    /// Wheel centre and spin axis.
    pub fn wheel(&mut self) -> [Vector; 2] {
        let wheel = self.corner.pose().wheel;
        [wheel.center, wheel.spin]
    }
}

/// The distance of a point from a segment.
pub fn to_segment(point: Vector, [from, to]: [Vector; 2]) -> f64 {
    let along = sub(to, from);
    let part = (dot(sub(point, from), along) / dot(along, along)).clamp(0.0, 1.0);
    norm(sub(point, add(from, scale(part, along))))
}

/// The distance of two segments by trying many places on the first: too large by less than 1e-6 m where they are
/// some centimetres apart.
pub fn between(first: [Vector; 2], second: [Vector; 2]) -> f64 {
    places(first).map(|place| to_segment(place, second)).fold(f64::INFINITY, f64::min)
}

/// Many places on a segment.
pub fn places([from, to]: [Vector; 2]) -> impl Iterator<Item = Vector> {
    (0..=4000).map(move |k| add(from, scale(f64::from(k) / 4000.0, sub(to, from))))
}

/// The angle of two directions (rad).
pub fn angle(a: Vector, b: Vector) -> f64 {
    (dot(a, b) / (norm(a) * norm(b))).clamp(-1.0, 1.0).acos()
}
