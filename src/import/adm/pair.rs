//! The two markers of a joint or a force.

use super::dataset::{Dataset, Marker, NEAR, Part, along};
use super::expression::Measure;
use super::notes::Notes;
use super::output::{Output, quoted};
use super::statement::Statement;
use crate::vector::{Vector, cross, dot, norm, sub};

/// Markers I and J on two parts.
pub(super) struct Pair<'d> {
    pub(super) dataset: &'d Dataset,
    pub(super) i: &'d Marker,
    pub(super) j: &'d Marker,
}

impl<'d> Pair<'d> {
    /// The markers of I and J; a mistake is noted.
    pub(super) fn of(
        dataset: &'d Dataset,
        statement: &Statement,
        notes: &mut Notes,
    ) -> Option<Self> {
        let [i, j] = ["I", "J"].map(|key| marker(dataset, statement, key, notes));
        Self::new(dataset, i?, j?, statement, notes)
    }

    /// Two markers that are on two parts.
    pub(super) fn new(
        dataset: &'d Dataset,
        i: &'d Marker,
        j: &'d Marker,
        statement: &Statement,
        notes: &mut Notes,
    ) -> Option<Self> {
        if i.part == j.part {
            let what = format!("{} has both markers on PART/{}", statement.title(), i.part);
            notes.mistake(statement.line, what, "name markers of two different parts");
            return None;
        }
        Some(Self { dataset, i, j })
    }

    pub(super) fn body_i(&self) -> &Part {
        self.dataset.body(self.i)
    }

    pub(super) fn body_j(&self) -> &Part {
        self.dataset.body(self.j)
    }

    /// `between`, the part of J first: what I does is then seen from J, as Adams does.
    pub(super) fn j_to_i(&self) -> (&'static str, String) {
        between(self.body_j(), self.body_i())
    }

    /// `between`, the part of I first.
    pub(super) fn i_to_j(&self) -> (&'static str, String) {
        between(self.body_i(), self.body_j())
    }

    /// `on`, both points, that of I first.
    pub(super) fn on(&self, output: &mut Output) -> (&'static str, String) {
        ("on", format!("[{}, {}]", output.point(self.i), output.point(self.j)))
    }

    pub(super) fn z_i(&self) -> Vector<f64> {
        self.i.frame.axes[2]
    }

    pub(super) fn z_j(&self) -> Vector<f64> {
        self.j.frame.axes[2]
    }

    /// From the origin of J to that of I.
    pub(super) fn way(&self) -> Vector<f64> {
        sub(self.i.frame.origin, self.j.frame.origin)
    }

    /// How far the markers are apart.
    pub(super) fn distance(&self) -> f64 {
        norm(self.way())
    }

    /// Notes markers that are apart by more than rounding.
    pub(super) fn together(&self, statement: &Statement, notes: &mut Notes) -> bool {
        self.holds(self.distance(), "are apart", statement, notes)
    }

    /// Notes a marker I that is not on the z axis of J.
    pub(super) fn in_line(&self, statement: &Statement, notes: &mut Notes) -> bool {
        let offset = norm(cross(self.way(), self.z_j()));
        self.holds(offset, "are beside their common axis", statement, notes)
    }

    /// Notes a marker I that is not in the plane of x and y of J.
    pub(super) fn in_plane(&self, statement: &Statement, notes: &mut Notes) -> bool {
        let offset = dot(self.way(), self.z_j()).abs();
        self.holds(offset, "are beside their common plane", statement, notes)
    }

    fn holds(&self, offset: f64, what: &str, statement: &Statement, notes: &mut Notes) -> bool {
        let holds = offset <= NEAR * self.dataset.size;
        if !holds {
            let (i, j) = (self.i.id, self.j.id);
            let what =
                format!("the markers {i} and {j} of {} {what} by {offset:.3e}", statement.title());
            not_assembled(statement.line, what, notes);
        }
        holds
    }

    /// Notes z axes that are not along one line; otherwise says whether they point the same way.
    pub(super) fn aligned(&self, statement: &Statement, notes: &mut Notes) -> Option<f64> {
        let sense = along(self.z_i(), self.z_j());
        if sense.is_none() {
            let (i, j) = (self.i.id, self.j.id);
            let what = format!(
                "the z axes of the markers {i} and {j} of {} are not parallel",
                statement.title()
            );
            not_assembled(statement.line, what, notes);
        }
        sense
    }

    /// Whether a measure is between these two parts: 1, or −1 where it is the other way round.
    pub(super) fn sense(&self, measure: &Measure) -> Option<f64> {
        let parts = [0, 1].map(|place| self.dataset.part_of(measure, place));
        if parts == [Some(self.i.part), Some(self.j.part)] {
            Some(1.0)
        } else if parts == [Some(self.j.part), Some(self.i.part)] {
            Some(-1.0)
        } else {
            None
        }
    }
}

/// The marker of a key.
pub(super) fn marker<'d>(
    dataset: &'d Dataset,
    statement: &Statement,
    key: &str,
    notes: &mut Notes,
) -> Option<&'d Marker> {
    if !statement.has(key) {
        let what = format!("{} names no marker {key}", statement.title());
        notes.mistake(statement.line, what, format!("write {key} = …"));
        return None;
    }
    let id = statement.reference(key, notes)?;
    let found = dataset.markers.get(&id);
    if found.is_none() {
        let what = format!("{} names MARKER/{id}, which does not exist", statement.title());
        notes.mistake(statement.line, what, "correct the number of the marker");
    }
    found
}

pub(super) fn between(i: &Part, j: &Part) -> (&'static str, String) {
    ("between", format!("[{}, {}]", quoted(&i.name), quoted(&j.name)))
}

/// What to do where joints do not hold.
pub(super) fn not_assembled(line: usize, what: String, notes: &mut Notes) {
    let help = "the parts have to be where the joints hold: let Adams find the initial conditions and save the dataset there";
    notes.mistake(line, what, help);
}
