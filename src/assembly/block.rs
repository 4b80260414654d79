//! Dense blocks that one or two bodies add to the equations of motion.

use crate::relation::BODY_COORDINATES;

/// Coordinates of two bodies.
const SIZE: usize = 2 * BODY_COORDINATES;

/// A generalized force on the coordinates of two bodies and a matrix between them.
#[derive(Clone)]
pub(super) struct Block {
    force: [f64; SIZE],
    size: [f64; SIZE],
    matrix: [[f64; SIZE]; SIZE],
}

impl Block {
    pub(super) fn new() -> Self {
        Self { force: [0.0; SIZE], size: [0.0; SIZE], matrix: [[0.0; SIZE]; SIZE] }
    }

    pub(super) fn clear(&mut self) {
        *self = Self::new();
    }

    /// Adds a force that is the sum of parts of the given size together.
    pub(super) fn add_force(&mut self, local: u8, value: f64, size: f64) {
        self.force[usize::from(local)] += value;
        self.size[usize::from(local)] += size.abs();
    }

    pub(super) fn add(&mut self, row: u8, column: u8, value: f64) {
        self.matrix[usize::from(row)][usize::from(column)] += value;
    }
}

/// Where the entries of a block belong.
#[derive(Clone)]
pub(super) struct Places {
    /// Local coordinate and unknown.
    unknowns: Vec<(usize, usize)>,
    /// The place among the values of the matrix, row by row of the unknowns.
    slots: Vec<usize>,
}

impl Places {
    /// The unknown of each local coordinate; none for the ground and where a block is empty.
    pub(super) fn new(unknowns: impl Iterator<Item = Option<usize>>) -> Self {
        let unknowns = unknowns.enumerate();
        let unknowns = unknowns.filter_map(|(local, unknown)| Some((local, unknown?))).collect();
        Self { unknowns, slots: vec![] }
    }

    /// All (row, column) pairs of the block.
    pub(super) fn entries(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let columns = |row| self.unknowns.iter().map(move |&(_, column)| (row, column));
        self.unknowns.iter().flat_map(move |&(_, row)| columns(row))
    }

    /// Looks the places up.
    pub(super) fn find(&mut self, slot: impl Fn(usize, usize) -> usize) {
        self.slots = self.entries().map(|(row, column)| slot(row, column)).collect();
    }

    /// Adds the force of a block; `magnitude` takes the sizes of its parts.
    pub(super) fn scatter_force(&self, block: &Block, force: &mut [f64], magnitude: &mut [f64]) {
        for &(local, unknown) in &self.unknowns {
            force[unknown] += block.force[local];
            magnitude[unknown] += block.size[local];
        }
    }

    /// Adds the matrix of a block.
    pub(super) fn scatter(&self, block: &Block, values: &mut [f64]) {
        let mut slots = self.slots.iter();
        for &(row, _) in &self.unknowns {
            for (&(column, _), &slot) in self.unknowns.iter().zip(&mut slots) {
                values[slot] += block.matrix[row][column];
            }
        }
    }
}
