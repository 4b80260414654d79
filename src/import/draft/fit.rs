//! Holds a draft against its architecture: what has no place, what is missing, what has to be assumed.

use super::{Draft, PartKind, Spin};
use crate::import::options::Options;
use crate::import::{ImportError, LeftOut, Mistakes};
use crate::mechanism::{MassProperties, Mechanism};
use crate::model::{Architecture, Quantity, Side};

/// The radius (m) that is written where a source has none.
const ASSUMED_RADIUS: f64 = 0.3;

/// Why an inertia is left out.
pub(crate) const POINT_MASS: &str = "no body has such moments: the largest is more than the sum of the others, or one is below zero; a \
                                     point mass is written";

/// Whether no body has this inertia (SI units), though one may have this mass.
pub(crate) fn beyond_any_body(mass: MassProperties) -> bool {
    let mut trial = Mechanism::new("ground");
    let id = trial.add_body("body", [0.0; 3]);
    let mut possible = |mass| id.clone().and_then(|id| trial.set_mass(id, mass)).is_ok();
    !possible(mass) && possible(MassProperties { inertia: [0.0; 6], ..mass })
}

impl Draft {
    /// Files of examples have inertias that no body can have, which a model must not: what remains is
    /// a point mass.
    pub(super) fn drop_impossible_inertias(&mut self) {
        let units = self.units;
        for body in &mut self.bodies {
            let mass = MassProperties {
                mass: Quantity::Mass.to_si(units, body.mass),
                center: body.center.map(|x| Quantity::Length.to_si(units, x)),
                inertia: body.inertia.map(|entry| Quantity::Inertia.to_si(units, entry)),
            };
            if beyond_any_body(mass) {
                let what = format!("the inertia of {}", body.called);
                self.left_out.push(LeftOut { line: body.line, what, why: POINT_MASS.to_owned() });
                body.inertia = [0.0; 6];
            }
        }
    }

    /// Lists bodies, forces and bushings that the architecture has no place for.
    pub(super) fn drop_what_has_no_place(&mut self, architecture: &Architecture) {
        let title = architecture.title();
        let moving = |name: &str| architecture.bodies().iter().any(|body| body.name == name);
        let mut left_out = vec![];
        let mut leave = |line, what: &str, why| {
            left_out.push(LeftOut { line, what: what.to_owned(), why });
        };
        self.bodies.retain(|body| {
            let kept = moving(&body.name);
            if !kept {
                let why = format!("`{title}` has no body `{}`", body.name);
                leave(body.line, &format!("the mass of {}", body.called), why);
            }
            kept
        });
        let points = &self.points;
        self.parts.retain(|part| {
            let missing = match &part.kind {
                PartKind::Force(_, bodies) | PartKind::AxleForce(_, bodies) => {
                    let known = |name: &&String| {
                        let name = name.strip_prefix("other.").unwrap_or(name);
                        moving(name) || name == architecture.ground()
                    };
                    bodies.iter().find(|name| !known(name)).map(|name| format!("body `{name}`"))
                }
                PartKind::Bushing(joint) => {
                    let known = architecture.joints.iter().any(|known| known.name == *joint);
                    (!known).then(|| format!("joint `{joint}`"))
                }
            };
            let lost = part.points.iter().find(|name| points.iter().all(|p| p.name != **name));
            if let Some(missing) = &missing {
                leave(part.line, &part.called, format!("`{title}` has no {missing}"));
            } else if let Some(point) = lost {
                leave(
                    part.line,
                    &part.called,
                    format!("the source has no point for its `{point}`"),
                );
            }
            missing.is_none() && lost.is_none()
        });
        let spin = match &self.spin {
            Spin::Point(name) => Some(name.clone()),
            _ => None,
        };
        let parts = &self.parts;
        self.points.retain(|point| {
            let mut roles = architecture.points().iter().chain(architecture.optional_points());
            let kept = roles.any(|role| role.name == point.name)
                || parts.iter().any(|part| part.points.contains(&point.name))
                || spin.as_ref() == Some(&point.name);
            if !kept {
                let why = format!("`{title}` has no point `{}`, and no force names it", point.name);
                leave(point.line, &format!("the point `{}`", point.called), why);
            }
            kept
        });
        self.left_out.append(&mut left_out);
    }

    /// All points that the architecture needs are there, each once.
    pub(super) fn check_points(
        &self,
        name: &str,
        text: &str,
        architecture: &Architecture,
    ) -> Result<(), ImportError> {
        let mut mistakes = Mistakes::new(name, text);
        for (index, point) in self.points.iter().enumerate() {
            if let Some(first) = self.points[..index].iter().find(|first| first.name == point.name)
            {
                let what = format!(
                    "`{}` and `{}` are both the point `{}`",
                    first.called, point.called, point.name
                );
                mistakes.note(
                    point.line,
                    what,
                    format!("keep one of them; the other is in line {}", first.line),
                );
            }
        }
        let missing =
            architecture.points().iter().filter(|role| self.position(&role.name).is_none());
        let missing: Vec<String> =
            missing.map(|role| format!("{}: {}", role.name, role.meaning)).collect();
        mistakes.finish()?;
        if missing.is_empty() {
            return Ok(());
        }
        let what = format!("`{}` needs points that the source does not have", architecture.title());
        Err(ImportError::whole(
            name,
            what,
            format!("add them to the source:\n{}", missing.join("\n")),
        ))
    }

    /// What the source does not say and a model needs.
    pub(super) fn assume(&mut self, options: &Options, architecture: &Architecture) {
        let unit = self.units.length;
        self.wheel_radius = self.wheel_radius.or(options.wheel_radius);
        self.axle = self.axle.or(options.axle);
        if self.wheel_radius.is_none() {
            let radius = unit.from_metres(ASSUMED_RADIUS);
            self.wheel_radius = Some(radius);
            self.assumed.push(format!(
                "the source has no wheel radius: {radius} {} is a placeholder; write that of the tyre \
                 into [wheel], or import with --wheel-radius",
                unit.symbol()
            ));
        }
        if matches!(self.spin, Spin::Unknown) {
            self.spin = Spin::Angles { toe: 0.0, camber: 0.0 };
            self.assumed.push(
                "the source has neither static toe nor camber: both are written as zero".to_owned(),
            );
        }
        if self.side.is_none() {
            let center = &architecture.point_name(architecture.wheel.center);
            let y = self.position(center).map_or(0.0, |position| self.axes.to_iso(position)[1]);
            self.side = Some(if y < 0.0 { Side::Right } else { Side::Left });
        }
        if !self.bodies.is_empty() && self.gravity.is_none() {
            self.gravity = Some(9.81);
            self.assumed
                .push("the source has masses and no gravity: 9.81 m/s² is written".to_owned());
        }
    }
}
