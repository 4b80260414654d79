//! A sequence of Sobol, which spreads starts evenly.

use thiserror::Error;

/// Dimensions that there are direction numbers for.
const DIMENSIONS: usize = DIRECTIONS.len() + 1;
/// Bits of a coordinate, and the logarithm of the length of the sequence.
const BITS: usize = 32;

/// More dimensions than there are direction numbers for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("a sequence of Sobol has at most {DIMENSIONS} dimensions here, not {0}")]
pub struct TooManyDimensions(pub usize);

/// The sequence of Sobol in the unit cube, in the order of Gray codes (Antonov and Saleev 1979; Bratley
/// and Fox, *ACM Trans. Math. Softw.* 14 (1988) 88–100) with the direction numbers of Joe and Kuo.
///
/// The first point is the origin. The iterator ends after 2³² points.
#[derive(Clone, Debug)]
pub struct Sobol {
    directions: Vec<[u32; BITS]>,
    point: Vec<u32>,
    index: u64,
}

impl Sobol {
    /// The sequence from its start.
    ///
    /// # Errors
    /// [`TooManyDimensions`] above 64.
    pub fn new(dimensions: usize) -> Result<Self, TooManyDimensions> {
        if dimensions > DIMENSIONS {
            return Err(TooManyDimensions(dimensions));
        }
        let directions = (0..dimensions).map(directions).collect();
        Ok(Self { directions, point: vec![0; dimensions], index: 0 })
    }
}

impl Iterator for Sobol {
    type Item = Vec<f64>;

    fn next(&mut self) -> Option<Vec<f64>> {
        if self.index >> BITS > 0 {
            return None;
        }
        if self.index > 0 {
            // The codes of two neighbours differ in the bit of the lowest zero of the first.
            let bit = (self.index - 1).trailing_ones() as usize;
            for (coordinate, directions) in self.point.iter_mut().zip(&self.directions) {
                *coordinate ^= directions[bit];
            }
        }
        self.index += 1;
        let unit = (BITS as f64).exp2();
        Some(self.point.iter().map(|&coordinate| f64::from(coordinate) / unit).collect())
    }
}

/// The direction numbers of a dimension, as binary fractions.
fn directions(dimension: usize) -> [u32; BITS] {
    let mut numbers = [0; BITS];
    let Some((polynomial, first)) = dimension.checked_sub(1).map(|row| DIRECTIONS[row]) else {
        for (bit, number) in numbers.iter_mut().enumerate() {
            *number = 1 << (BITS - 1 - bit);
        }
        return numbers;
    };
    let degree = first.len();
    for (bit, &number) in first.iter().enumerate() {
        numbers[bit] = number << (BITS - 1 - bit);
    }
    for bit in degree..BITS {
        numbers[bit] = numbers[bit - degree] ^ (numbers[bit - degree] >> degree);
        for k in 1..degree {
            if polynomial >> (degree - 1 - k) & 1 == 1 {
                numbers[bit] ^= numbers[bit - k];
            }
        }
    }
    numbers
}

/// The inner coefficients of the primitive polynomial and the first direction numbers m for
/// dimensions 2 to 64: `new-joe-kuo-6` of Joe and Kuo, *SIAM J. Sci. Comput.* 30 (2008) 2635–2654.
#[rustfmt::skip]
const DIRECTIONS: [(u32, &[u32]); 63] = [
    (0, &[1]),
    (1, &[1, 3]),
    (1, &[1, 3, 1]),
    (2, &[1, 1, 1]),
    (1, &[1, 1, 3, 3]),
    (4, &[1, 3, 5, 13]),
    (2, &[1, 1, 5, 5, 17]),
    (4, &[1, 1, 5, 5, 5]),
    (7, &[1, 1, 7, 11, 19]),
    (11, &[1, 1, 5, 1, 1]),
    (13, &[1, 1, 1, 3, 11]),
    (14, &[1, 3, 5, 5, 31]),
    (1, &[1, 3, 3, 9, 7, 49]),
    (13, &[1, 1, 1, 15, 21, 21]),
    (16, &[1, 3, 1, 13, 27, 49]),
    (19, &[1, 1, 1, 15, 7, 5]),
    (22, &[1, 3, 1, 15, 13, 25]),
    (25, &[1, 1, 5, 5, 19, 61]),
    (1, &[1, 3, 7, 11, 23, 15, 103]),
    (4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, &[1, 1, 3, 13, 7, 35, 63]),
    (8, &[1, 3, 5, 9, 1, 25, 53]),
    (14, &[1, 3, 1, 13, 9, 35, 107]),
    (19, &[1, 3, 1, 5, 27, 61, 31]),
    (21, &[1, 1, 5, 11, 19, 41, 61]),
    (28, &[1, 3, 5, 3, 3, 13, 69]),
    (31, &[1, 1, 7, 13, 1, 19, 1]),
    (32, &[1, 3, 7, 5, 13, 19, 59]),
    (37, &[1, 1, 3, 9, 25, 29, 41]),
    (41, &[1, 3, 5, 13, 23, 1, 55]),
    (42, &[1, 3, 7, 3, 13, 59, 17]),
    (50, &[1, 3, 1, 3, 5, 53, 69]),
    (55, &[1, 1, 5, 5, 23, 33, 13]),
    (56, &[1, 1, 7, 7, 1, 61, 123]),
    (59, &[1, 1, 7, 9, 13, 61, 49]),
    (62, &[1, 3, 3, 5, 3, 55, 33]),
    (14, &[1, 3, 1, 15, 31, 13, 49, 245]),
    (21, &[1, 3, 5, 15, 31, 59, 63, 97]),
    (22, &[1, 3, 1, 11, 11, 11, 77, 249]),
    (38, &[1, 3, 1, 11, 27, 43, 71, 9]),
    (47, &[1, 1, 7, 15, 21, 11, 81, 45]),
    (49, &[1, 3, 7, 3, 25, 31, 65, 79]),
    (50, &[1, 3, 1, 1, 19, 11, 3, 205]),
    (52, &[1, 1, 5, 9, 19, 21, 29, 157]),
    (56, &[1, 3, 7, 11, 1, 33, 89, 185]),
    (67, &[1, 3, 3, 3, 15, 9, 79, 71]),
    (70, &[1, 3, 7, 11, 15, 39, 119, 27]),
    (84, &[1, 1, 3, 1, 11, 31, 97, 225]),
    (97, &[1, 1, 1, 3, 23, 43, 57, 177]),
    (103, &[1, 3, 7, 7, 17, 17, 37, 71]),
    (115, &[1, 3, 1, 5, 27, 63, 123, 213]),
    (122, &[1, 1, 3, 5, 11, 43, 53, 133]),
    (8, &[1, 3, 5, 5, 29, 17, 47, 173, 479]),
    (13, &[1, 3, 3, 11, 3, 1, 109, 9, 69]),
    (16, &[1, 1, 1, 5, 17, 39, 23, 5, 343]),
    (22, &[1, 3, 1, 5, 25, 15, 31, 103, 499]),
    (25, &[1, 1, 1, 11, 11, 17, 63, 105, 183]),
    (44, &[1, 1, 5, 11, 9, 29, 97, 231, 363]),
    (47, &[1, 1, 5, 15, 19, 45, 41, 7, 383]),
    (52, &[1, 3, 7, 7, 31, 19, 83, 137, 221]),
    (55, &[1, 1, 1, 3, 23, 15, 111, 223, 83]),
    (59, &[1, 1, 5, 13, 31, 15, 55, 25, 161]),
    (62, &[1, 1, 3, 13, 25, 47, 39, 87, 257]),
];
