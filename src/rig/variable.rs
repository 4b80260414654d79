//! What can take other hard points and say how it changes with them.

use super::settled::Settled;
use super::shape::Shape;
use super::stand::Stand;
use super::sweep::Specimen;
use super::varied::Varied;
use crate::assembly::ElementConstant;
use crate::mechanism::DriverId;
use crate::model::{Model, Side};
use crate::scalar::Scalar;
use crate::solve::linear::Singular;

/// Why a state cannot say how it changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VaryError {
    /// The wheel is not held at a travel.
    #[error(
        "sensitivities are those of wheels that the rig holds at a travel; these stand on their tyres"
    )]
    Free,
    /// The model asks for a static state, which other hard points would have to be brought to anew.
    #[error(
        "a search starts from the design position, but [static] or the settings of adjusters put the model \
         elsewhere; leave them out for it"
    )]
    Adjusted,
    /// There is no equilibrium to start from.
    #[error("the forces are not in balance in this state, so it does not say how it changes")]
    NoEquilibrium,
    /// A dead centre.
    #[error("the state is a dead centre: neighbouring states are not determined")]
    Singular,
}

impl From<Singular> for VaryError {
    fn from(_: Singular) -> Self {
        Self::Singular
    }
}

/// What can be asked how it changes.
pub trait Variable: Specimen {
    /// The mechanism on the rig.
    fn stand(&self) -> &Stand;

    /// Sets whether poses measure how wheels give way to loads.
    fn measure_compliance(&mut self, measures: bool);

    /// The adjusters, one of each side, that one of the model is.
    fn adjusters(&self, adjuster: usize) -> Vec<DriverId>;

    /// 1 of a corner, 2 of an axle.
    fn sides(&self) -> usize;

    /// The static state that the model asks for, where it does.
    fn settled(&self) -> Option<&Settled>;

    /// The shapes of all sides, left first, that go with one of a model: the other side is the mirror image, or
    /// stays where a file of its own describes it.
    fn both_sides<S: Scalar>(&self, model: &Model, shape: Shape<S>) -> Vec<Shape<S>> {
        both_sides(self.sides(), model, shape)
    }

    /// Takes the shapes of other models of the same build for all sides, left first, and returns to the design
    /// position. `constants` are new values of laws, `lengths` those of parameters of force elements. Loads and what
    /// is measured stay.
    ///
    /// # Errors
    /// [`VaryError::Adjusted`] for a model with a static state.
    fn reshape(
        &mut self,
        shapes: &[Shape<f64>],
        constants: &[(ElementConstant, f64)],
        lengths: &[(usize, f64)],
    ) -> Result<(), VaryError>;

    /// The current state, to ask how its poses change with the model and with some constants of force elements.
    ///
    /// # Errors
    /// [`VaryError`].
    fn vary(
        &mut self,
        constants: &[ElementConstant],
        compliance: bool,
    ) -> Result<Varied<'_>, VaryError>;
}

pub(super) fn both_sides<S: Scalar>(sides: usize, model: &Model, shape: Shape<S>) -> Vec<Shape<S>> {
    if sides < 2 {
        return vec![shape];
    }
    let other = match model.has_other_side() {
        true => Shape::of(&model.other_side()).lifted(),
        false => shape.mirrored(),
    };
    match model.side {
        Side::Left => vec![shape, other],
        Side::Right => vec![other, shape],
    }
}
