//! What can be wrong with the parts of a mechanism.

use thiserror::Error;

use super::topology::Point;

/// Why a mechanism cannot be built. Positions are in metres.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MechanismError {
    /// Two things have one name.
    #[error("there are two {what}s named `{name}`; give one of them another name")]
    DuplicateName {
        /// `body`, `point`, `joint`, `driver` or `force`.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A name without a visible character.
    #[error("a {what} has an empty name; name it, because messages refer to it")]
    EmptyName {
        /// `body`, `point`, `joint`, `driver` or `force`.
        what: &'static str,
    },
    /// A coordinate, component or radius is infinite or not a number.
    #[error("{what} `{name}` has a number that is not finite ({value}); give a finite number")]
    NotFinite {
        /// What kind of thing.
        what: &'static str,
        /// Its name.
        name: String,
        /// The number.
        value: f64,
    },
    /// An identifier that belongs to another mechanism.
    #[error(
        "{what} `{name}` refers to {target} number {number}, which this mechanism does not have; \
         use the identifiers that this mechanism returned"
    )]
    UnknownId {
        /// `joint`, `driver` or `force`.
        what: &'static str,
        /// Its name.
        name: String,
        /// `body` or `point`.
        target: &'static str,
        /// The number.
        number: usize,
    },
    /// Both bodies are the same.
    #[error("{what} `{name}` joins `{body}` with itself; name two different bodies")]
    SameBody {
        /// `joint`, `driver` or `force`.
        what: &'static str,
        /// Its name.
        name: String,
        /// The body.
        body: String,
    },
    /// The pins of a cross are not at right angles.
    #[error(
        "joint `{name}` has two axes at {angle:.6}° that should be normal to each other; correct \
         one of them"
    )]
    NotNormal {
        /// The joint.
        name: String,
        /// The angle between them (°).
        angle: f64,
    },
    /// A course of time without a meaning.
    #[error(
        "the motion of driver `{name}` has a number that is not finite or a step that does not end after it \
         begins; correct it"
    )]
    Course {
        /// The driver.
        name: String,
    },
    /// A rack or a screw that goes nowhere.
    #[error(
        "joint `{name}` has a pitch radius or a lead of zero; give another one, or use a fixed joint"
    )]
    NoWay {
        /// The joint.
        name: String,
    },
    /// A line between two points has no length.
    #[error(
        "the {part} of {what} `{name}` runs from `{}` {:?} to `{}` {:?}, which are {distance:e} m apart: \
         move one of the points",
        .from.name, .from.position, .to.name, .to.position
    )]
    CoincidentPoints {
        /// `joint`, `driver` or `force`.
        what: &'static str,
        /// Its name.
        name: String,
        /// `direction` or `length`.
        part: &'static str,
        /// First point.
        from: Box<Point>,
        /// Second point.
        to: Box<Point>,
        /// Distance (m).
        distance: f64,
    },
    /// A constant direction is the zero vector.
    #[error(
        "the direction of {what} `{name}` is {direction:?}, which has no length; give a vector other than zero"
    )]
    ZeroDirection {
        /// `joint`, `driver` or `force`.
        what: &'static str,
        /// Its name.
        name: String,
        /// The vector.
        direction: [f64; 3],
    },
    /// A disc without size.
    #[error(
        "{what} `{name}` has a radius of {radius} m at `{center}`; a radius has to be greater than zero"
    )]
    Radius {
        /// `driver` or `force`.
        what: &'static str,
        /// Its name.
        name: String,
        /// The radius (m).
        radius: f64,
        /// Centre of the disc.
        center: String,
    },
    /// A disc that lies flat has no lowest point.
    #[error(
        "the spin axis of {what} `{name}` at `{center}` is vertical, so that the disc has no lowest point; \
         turn the spin axis"
    )]
    VerticalSpin {
        /// `driver` or `force`.
        what: &'static str,
        /// Its name.
        name: String,
        /// Centre of the disc.
        center: String,
    },
    /// Heights are measured from the ground, on a moving body.
    #[error(
        "{what} `{name}` measures a height between `{i}` and `{j}`; a height is measured from the ground \
         (`{ground}`) as first body to a moving second body"
    )]
    HeightBodies {
        /// `driver` or `force`.
        what: &'static str,
        /// Its name.
        name: String,
        /// Body *i*.
        i: String,
        /// Body *j*.
        j: String,
        /// Name of the ground.
        ground: String,
    },
    /// A table that is no function.
    #[error("the table of force `{name}` is wrong in row {row}: {problem}; correct this row")]
    Table {
        /// The force element.
        name: String,
        /// The row, counted from 1.
        row: usize,
        /// What is wrong.
        problem: &'static str,
    },
    /// Masses and inertias that no body has.
    #[error("the mass of body `{name}` is wrong: {problem}")]
    Mass {
        /// The body.
        name: String,
        /// What is wrong and what to do.
        problem: &'static str,
    },
    /// Axes that span no plane.
    #[error(
        "the x and z axes of {what} `{name}` are parallel, so they give no frame; give another z axis"
    )]
    ParallelAxes {
        /// `force` or `marker`.
        what: &'static str,
        /// Its name.
        name: String,
    },
    /// A load or a tyre between two moving bodies.
    #[error(
        "force `{name}` acts on `{j}` from the ground, but its first body is `{i}`; name the ground first"
    )]
    NotFromGround {
        /// The force element.
        name: String,
        /// Body *i*.
        i: String,
        /// Body *j*.
        j: String,
    },
}
