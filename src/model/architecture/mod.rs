//! Suspension topologies as data: which points, bodies and joints a suspension has.

mod across;
mod check;
mod read;

use std::path::Path;

use include_dir::{Dir, include_dir};

pub(crate) use across::{Across, point_across};

use super::diagnostics::{ModelDiagnostics, Report, SourceFile};
use super::parts::joint_points;
use crate::mechanism::{BodyId, Joint, PointId};

/// The architectures that come with the program, so that an installed binary has them.
static BUILT_IN: Dir = include_dir!("$CARGO_MANIFEST_DIR/architectures");

/// A suspension topology, read from `architectures/NAME.toml` or a file of the user.
///
/// Its joints number the bodies with the ground as 0 and the points in the order of the file;
/// [`Model::suspension`](super::Model::suspension) adds them to the mechanism in that order.
#[derive(Clone, Debug)]
pub struct Architecture {
    pub(crate) title: String,
    pub(crate) description: Option<String>,
    pub(crate) ground: String,
    pub(crate) points: Vec<PointRole>,
    pub(crate) optional_points: Vec<PointRole>,
    /// Moving bodies; `BodyId(1)` is the first of them.
    pub(crate) bodies: Vec<BodyRole>,
    pub(crate) joints: Vec<Joint>,
    /// Whether both sides are one mechanism, such as a beam axle, so that there is no corner.
    pub(crate) is_axle: bool,
    /// Joints between the two sides, there once; bodies and points of the other side have the
    /// numbers behind those of this side.
    pub(crate) axle_joints: Vec<Joint>,
    /// The joints that are bushings on real suspensions, by their places in `joints`.
    pub(crate) bushed: Vec<usize>,
    /// Index of the joint along or about which steering moves the rack or the pitman arm.
    pub(crate) rack: Option<usize>,
    /// The point of a pitman arm whose way along y is what steering prescribes.
    pub(crate) pitman_point: Option<PointId>,
    pub(crate) wheel: WheelRole,
    pub(crate) steer_axis: Option<SteerAxis>,
    pub(crate) spring: Option<Seats>,
    pub(crate) damper: Option<Seats>,
}

/// A named point and what it is.
#[derive(Clone, Debug)]
pub struct PointRole {
    /// The name, as in model files.
    pub name: String,
    /// What the point is on a real suspension.
    pub meaning: String,
    /// Whether the point may lie across the centre line of the vehicle.
    pub may_cross: bool,
}

/// A moving body and what it is.
#[derive(Clone, Debug)]
pub struct BodyRole {
    /// The name that messages use.
    pub name: String,
    /// What the body is on a real suspension.
    pub meaning: String,
    /// Whether both sides of an axle have it together, such as the rack.
    pub shared: bool,
}

/// Which body carries the wheel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WheelRole {
    pub(crate) body: BodyId,
    pub(crate) center: PointId,
}

/// A steer axis through two joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteerAxis {
    /// The lower point and the body it belongs to.
    pub lower: (PointId, BodyId),
    /// The upper point and the body it belongs to.
    pub upper: (PointId, BodyId),
}

/// The seats of a spring or a damper in models that have these points, by the name of the point and the body.
#[derive(Clone, Debug)]
pub(crate) struct Seats {
    pub(crate) lower: (String, BodyId),
    pub(crate) upper: (String, BodyId),
}

impl Architecture {
    /// The names of the built-in architectures, sorted.
    pub fn built_in_names() -> Vec<&'static str> {
        let mut names: Vec<_> = BUILT_IN
            .files()
            .filter_map(|file| file.path().file_name()?.to_str()?.strip_suffix(".toml"))
            .collect();
        names.sort_unstable();
        names
    }

    /// The built-in architecture of this name, `None` where there is none.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] where the file is wrong.
    pub fn built_in(name: &str) -> Option<Result<Self, ModelDiagnostics>> {
        let file = BUILT_IN.get_file(format!("{name}.toml"))?;
        let text = file.contents_utf8()?;
        Some(Self::parse(&format!("architectures/{name}.toml"), text))
    }

    /// Reads an architecture file.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] where the file cannot be read, and with every mistake of it.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, ModelDiagnostics> {
        let (name, text) = super::load::read_file(path.as_ref())?;
        Self::parse(&name, &text)
    }

    /// Reads an architecture from the text of a file; `name` is the file name that messages show.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the file.
    pub fn parse(name: &str, text: &str) -> Result<Self, ModelDiagnostics> {
        let file = SourceFile::new(name, text);
        let mut report = Report::new(file.clone());
        let architecture = super::read::read_file(&file, &mut report, read::read);
        super::finish(architecture, report)
    }

    /// The title, such as `Double wishbone`.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// What the suspension is made of.
    pub fn description(&self) -> Option<&str> {
        self.description.as_deref()
    }

    /// The points that a model must have, in the order of the file.
    pub fn points(&self) -> &[PointRole] {
        &self.points
    }

    /// The points that a model may have.
    pub fn optional_points(&self) -> &[PointRole] {
        &self.optional_points
    }

    /// The moving bodies.
    pub fn bodies(&self) -> &[BodyRole] {
        &self.bodies
    }

    /// The wheel centre.
    pub fn wheel_center(&self) -> PointId {
        self.wheel.center
    }

    /// Whether the two sides are one mechanism, such as a beam axle: there is no corner to look at alone.
    pub fn is_axle(&self) -> bool {
        self.is_axle
    }

    /// The joints of one side and those that both sides have together.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// The joints between the two sides. Bodies and points of the other side have the numbers behind those of
    /// this side.
    pub fn axle_joints(&self) -> &[Joint] {
        &self.axle_joints
    }

    /// The joint along or about which steering moves the rack or the pitman arm.
    pub fn rack(&self) -> Option<&Joint> {
        self.rack.map(|joint| &self.joints[joint])
    }

    /// The names of the joints that are bushings on real suspensions.
    pub fn bushed_joints(&self) -> impl Iterator<Item = &str> {
        self.bushed.iter().map(|joint| self.joints[*joint].name.as_str())
    }

    /// The body that never moves, such as `chassis`.
    pub fn ground(&self) -> &str {
        &self.ground
    }

    pub(crate) fn point_name(&self, point: PointId) -> &str {
        &self.points[point.0].name
    }

    pub(crate) fn body_name(&self, body: BodyId) -> &str {
        match body.0 {
            0 => &self.ground,
            moving => &self.bodies[moving - 1].name,
        }
    }

    /// Whether an axle has the body once; the ground is one of those.
    pub(crate) fn is_shared(&self, body: BodyId) -> bool {
        body == BodyId::GROUND || self.bodies[body.0 - 1].shared
    }

    /// The points at which joints hold a body, each once. A line that the body
    /// shares with its neighbour counts with both of its points.
    pub(crate) fn joint_points(&self, body: BodyId) -> Vec<PointId> {
        joint_points(&self.joints, body)
    }
}
