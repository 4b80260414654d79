//! The sequence of Sobol against published points and its own properties.

use hardpoint::design::sqp::{Sobol, TooManyDimensions};

#[test]
fn the_sequence_of_sobol_is_the_published_one() {
    // The first points that the program of Joe and Kuo prints (sobol.cc with new-joe-kuo-6.21201).
    let known = [
        [0.0, 0.0, 0.0],
        [0.5, 0.5, 0.5],
        [0.75, 0.25, 0.25],
        [0.25, 0.75, 0.75],
        [0.375, 0.375, 0.625],
        [0.875, 0.875, 0.125],
        [0.625, 0.125, 0.875],
        [0.125, 0.625, 0.375],
        [0.1875, 0.3125, 0.9375],
        [0.6875, 0.8125, 0.4375],
    ];
    let points: Vec<Vec<f64>> = Sobol::new(3).expect("few dimensions").take(10).collect();
    assert_eq!(points, known);
    // Point 1000 in dimensions 2, 10, 33 and 64, from the recurrence of that program written apart.
    let far = Sobol::new(64).expect("64 are there").nth(1000).expect("a long sequence");
    let far = [1, 9, 32, 63].map(|dimension| far[dimension]);
    assert_eq!(far, [0.0966796875, 0.0693359375, 0.2958984375, 0.4462890625]);
    // The points whose Gray codes have one bit are the direction numbers; this sum sees all of them.
    let points: Vec<Vec<f64>> = Sobol::new(64).expect("64 are there").take(4096).collect();
    let weighted = |bit: usize, (d, value): (usize, &f64)| ((bit + 1) * (d + 1)) as f64 * value;
    let sum: f64 = (0..12)
        .flat_map(|bit| {
            points[(2 << bit) - 1].iter().enumerate().map(move |pair| weighted(bit, pair))
        })
        .sum();
    assert_eq!(sum, 83050.341796875);
    assert_eq!(Sobol::new(65).err(), Some(TooManyDimensions(65)));
}

#[test]
fn each_dimension_of_sobol_is_a_net() {
    // 2^k points have one in each of 2^k equal parts of every axis, and pairs of neighbouring
    // dimensions differ.
    let points: Vec<Vec<f64>> = Sobol::new(64).expect("64 are there").take(256).collect();
    for dimension in 0..64 {
        let mut cells: Vec<usize> =
            points.iter().map(|point| (point[dimension] * 256.0) as usize).collect();
        if dimension > 0 {
            assert!(points.iter().any(|point| point[dimension] != point[dimension - 1]));
        }
        cells.sort_unstable();
        assert_eq!(cells, (0..256).collect::<Vec<_>>());
    }
}
