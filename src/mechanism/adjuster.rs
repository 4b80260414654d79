//! Dimensions of parts that can be set, such as shims and rod lengths.
//!
//! An adjuster is a driver without an equation of its own: its value is added to parameters that joints and
//! force elements have anyway. So whatever moves drivers sets adjusters, too.

use std::ops::Range;

use super::build::{Mechanism, new_name};
use super::error::MechanismError;
use super::expansion::{Expansion, Owner};
use super::recipe::Recipe;
use super::topology::{BodyId, Direction, Driver, DriverId, DriverKind, JointKind, PointId};

/// What the value (m) of an adjuster is added to.
#[derive(Clone, Debug, PartialEq)]
pub enum Adjuster {
    /// The place of joints or force elements on one of their bodies, along a direction fixed in it: a shim, the
    /// length of a rod that is a body.
    Place {
        /// Joints and force elements, each with the body on which its place moves.
        of: Vec<(Owner, BodyId)>,
        /// The positive direction.
        along: Direction,
    },
    /// The length that a joint or a force element has as its last parameter: that of a
    /// [`JointKind::Link`], or the free length of a line force.
    Length {
        /// The joint or force element.
        of: Owner,
    },
}

impl Mechanism {
    /// Adds an adjuster. It is a driver as all others, but holds no motion.
    ///
    /// # Errors
    /// [`MechanismError`] for a name that is taken or a direction without length.
    ///
    /// # Panics
    /// If joints, force elements or bodies belong to another mechanism, or if a length is that of a joint
    /// or a force element that has none.
    pub fn add_adjuster(
        &mut self,
        name: &str,
        adjuster: Adjuster,
    ) -> Result<DriverId, MechanismError> {
        new_name("driver", name, self.drivers.iter().map(|driver| &*driver.name))?;
        let j = match &adjuster {
            Adjuster::Place { of, along } => {
                self.check_direction("driver", name, *along)?;
                of.first().map_or(BodyId::GROUND, |(_, body)| *body)
            }
            Adjuster::Length { of } => match *of {
                Owner::Joint(joint) => {
                    let joint = &self.joints()[joint];
                    assert!(
                        matches!(joint.kind, JointKind::Link { .. }),
                        "only links have a length"
                    );
                    joint.j
                }
                Owner::Force(force) => {
                    let force = &self.forces[force.index()];
                    assert!(force.kind.is_line(), "only line forces have a length");
                    force.j
                }
                _ => panic!("only links and line forces have a length"),
            },
        };
        let id = DriverId(self.drivers.len());
        let kind = DriverKind::Adjuster;
        self.drivers.push(Driver {
            name: name.to_owned(),
            i: BodyId::GROUND,
            j,
            kind,
            course: None,
        });
        self.adjusters.push((id, adjuster));
        Ok(id)
    }
}

impl Expansion {
    /// The parameters that an adjuster changes, with how much each changes per metre.
    pub(super) fn adjusted(&self, mechanism: &Mechanism, adjuster: &Adjuster) -> Vec<(usize, f64)> {
        match adjuster {
            Adjuster::Length { of } => {
                let last = self.parts(*of).map(|parameters| parameters.end - 1);
                last.map(|slot| (slot, 1.0)).collect()
            }
            Adjuster::Place { of, along } => {
                let along = along.at(&mechanism.positions());
                let places = self.moved_places(of).into_iter();
                let mut slots: Vec<(usize, f64)> =
                    places.flat_map(|slot| (0..3).map(move |k| (slot + k, along[k]))).collect();
                slots.retain(|(_, factor)| *factor != 0.0);
                slots
            }
        }
    }

    /// The parameters of the adjusters whose directions lie between points: the adjuster, its direction, and the
    /// first ones of the three parameters of each place that it moves. When the points move, so does what it adds.
    pub fn directed_adjusters(
        &self,
        mechanism: &Mechanism,
    ) -> Vec<(DriverId, Direction, Vec<usize>)> {
        let directed = |(driver, adjuster): &(DriverId, Adjuster)| match adjuster {
            Adjuster::Place { of, along: along @ Direction::Between(..) } => {
                Some((*driver, *along, self.moved_places(of)))
            }
            _ => None,
        };
        mechanism.adjusters.iter().filter_map(directed).collect()
    }

    /// Where the places on bodies are among the parameters.
    fn moved_places(&self, of: &[(Owner, BodyId)]) -> Vec<usize> {
        let of_owner = |(owner, body): &(Owner, BodyId)| -> Vec<usize> {
            self.parts(*owner).flat_map(|parameters| self.places_on(*body, &parameters)).collect()
        };
        of.iter().flat_map(of_owner).collect()
    }

    /// The first of the three parameters that say where a point is on a body, where an adjuster moves
    /// the joint that has its place there.
    pub fn adjusted_place(&self, body: BodyId, point: PointId) -> Option<usize> {
        let is_place = |recipe: &Recipe| matches!(recipe, Recipe::Local { body: on, point: at, .. } if (*on, *at) == (body, point));
        let places = self.slots().filter(|(_, recipe)| is_place(recipe));
        places.map(|(slot, _)| slot).find(|slot| self.driver_slots().changes(*slot..*slot + 3))
    }

    /// The parameter that is the length of a link or of a line force.
    pub fn length(&self, owner: Owner) -> Option<usize> {
        self.parts(owner).map(|parameters| parameters.end - 1).last()
    }

    /// All recipes with their first parameters.
    fn slots(&self) -> impl Iterator<Item = (usize, &Recipe)> {
        self.recipes.iter().scan(0, |next, recipe| {
            let slot = *next;
            *next += recipe.size();
            Some((slot, recipe))
        })
    }

    /// Where the parameters of the relations of a joint or force element are.
    fn parts(&self, owner: Owner) -> impl Iterator<Item = Range<usize>> + '_ {
        let elements = self.elements().iter().map(|element| &element.instance);
        let own = self.instances().iter().chain(elements).filter(move |part| part.owner == owner);
        own.map(|part| part.parameters.clone())
    }

    /// Where the places on a body are among some parameters.
    fn places_on(&self, body: BodyId, parameters: &Range<usize>) -> Vec<usize> {
        let of_body =
            |recipe: &Recipe| matches!(recipe, Recipe::Local { body: on, .. } if *on == body);
        let places =
            self.slots().filter(|(slot, recipe)| parameters.contains(slot) && of_body(recipe));
        places.map(|(slot, _)| slot).collect()
    }
}
