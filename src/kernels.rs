//! The generated kernels: one module for each file of `constraints/`.
//!
//! With the feature `symbolic` they are derived when the crate is built;
//! without it the committed copy in `kernels/`, which is the same text, is compiled.

#![allow(clippy::too_many_arguments, reason = "a kernel has one argument for each array")]

use crate::energy::{EnergyShape, KineticEnergy, Motion};
use crate::relation::{
    Coordinates, Operations, Parameter, Place, Relation, Shape, exact, exact_mut,
};
use crate::scalar::Scalar;

#[cfg(feature = "symbolic")]
include!(concat!(env!("OUT_DIR"), "/kernels.rs"));
#[cfg(not(feature = "symbolic"))]
include!("../kernels/kernels.rs");
