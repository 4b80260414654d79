//! Problems of Hock and Schittkowski, *Test Examples for Nonlinear Programming Codes*, Lecture Notes in
//! Economics and Mathematical Systems 187, Springer 1981, with the optima printed there.

#[path = "common/sqp.rs"]
mod stated;

use num_dual::{Dual64, DualNum};
use stated::{AT_LEAST_0, FREE, Stated, Values, ZERO, assert_minimum};

/// Solves a problem, checks the conditions of a minimum and compares the objective with the printed
/// one. `shown` is half a unit of its last digit where it has fewer digits than 1e-8 asks for.
fn check(name: &str, mut stated: Stated, start: &[f64], optimum: f64, shown: f64) {
    let outcome = stated.solve(start);
    println!(
        "{name:8} {:3} iterations {:3} evaluations, f − f* = {:9.1e}  {:?}",
        outcome.iterations,
        outcome.evaluations,
        outcome.objective - optimum,
        outcome.status
    );
    assert_minimum(&stated, &outcome, 1e-7);
    let tolerance = (1e-8 * optimum.abs().max(1.0)).max(shown);
    assert!((outcome.objective - optimum).abs() <= tolerance, "{name}: {}", outcome.objective);
}

fn phi(phi: Dual64, constraints: Vec<Dual64>) -> Values {
    Values { phi, residuals: vec![], constraints }
}

/// Residuals whose squares add up to the objective of the book, which has no factor ½.
fn squares(residuals: Vec<Dual64>, constraints: Vec<Dual64>) -> Values {
    let root = std::f64::consts::SQRT_2;
    let residuals = residuals.into_iter().map(|residual| residual * root).collect();
    Values { phi: Dual64::from(0.0), residuals, constraints }
}

fn rosenbrock(x: &[Dual64]) -> Vec<Dual64> {
    vec![(x[1] - x[0] * x[0]) * 10.0, -x[0] + 1.0]
}

fn sum_of_squares(values: &[Dual64]) -> Dual64 {
    values.iter().map(|value| value * value).sum()
}

#[test]
fn hs1_2_bounds() {
    let lowest = |bound| [FREE, (bound, f64::INFINITY)];
    let least = |bound| Stated::new(&lowest(bound), &[], |x| squares(rosenbrock(x), vec![]));
    let general =
        |bound| Stated::new(&lowest(bound), &[], |x| phi(sum_of_squares(&rosenbrock(x)), vec![]));
    check("HS1 r", least(-1.5), &[-2.0, 1.0], 0.0, 0.0);
    check("HS1 φ", general(-1.5), &[-2.0, 1.0], 0.0, 0.0);
    // The second problem has another local minimum, 4.9412, nearer to the start of the book.
    check("HS2 r", least(1.5), &[2.0, 2.0], 0.0504261879, 0.0);
    check("HS2 φ", general(1.5), &[2.0, 2.0], 0.0504261879, 0.0);
}

#[test]
fn hs3_4_5_bounds() {
    let f = |x: &[Dual64]| phi(x[1] + (x[1] - x[0]).powi(2) * 1e-5, vec![]);
    check("HS3", Stated::new(&[FREE, AT_LEAST_0], &[], f), &[10.0, 1.0], 0.0, 0.0);
    let f = |x: &[Dual64]| phi((x[0] + 1.0).powi(3) / 3.0 + x[1], vec![]);
    let bounds = [(1.0, f64::INFINITY), AT_LEAST_0];
    check("HS4", Stated::new(&bounds, &[], f), &[1.125, 0.125], 8.0 / 3.0, 0.0);
    let f = |x: &[Dual64]| {
        phi((x[0] + x[1]).sin() + (x[0] - x[1]).powi(2) - x[0] * 1.5 + x[1] * 2.5 + 1.0, vec![])
    };
    let optimum = -0.5 * 3f64.sqrt() - std::f64::consts::FRAC_PI_3;
    check("HS5", Stated::new(&[(-1.5, 4.0), (-3.0, 3.0)], &[], f), &[0.0, 0.0], optimum, 0.0);
}

#[test]
fn hs6_7_8_9_equations() {
    let parabola = |x: &[Dual64]| vec![(x[1] - x[0] * x[0]) * 10.0];
    let f = move |x: &[Dual64]| squares(vec![-x[0] + 1.0], parabola(x));
    check("HS6 r", Stated::new(&[FREE; 2], &[ZERO], f), &[-1.2, 1.0], 0.0, 0.0);
    let f = move |x: &[Dual64]| phi((-x[0] + 1.0).powi(2), parabola(x));
    check("HS6 φ", Stated::new(&[FREE; 2], &[ZERO], f), &[-1.2, 1.0], 0.0, 0.0);
    let f = |x: &[Dual64]| {
        let bracket = x[0] * x[0] + 1.0;
        phi(bracket.ln() - x[1], vec![bracket * bracket + x[1] * x[1] - 4.0])
    };
    check("HS7", Stated::new(&[FREE; 2], &[ZERO], f), &[2.0, 2.0], -3f64.sqrt(), 0.0);
    let f = |x: &[Dual64]| {
        phi(Dual64::from(-1.0), vec![x[0] * x[0] + x[1] * x[1] - 25.0, x[0] * x[1] - 9.0])
    };
    check("HS8", Stated::new(&[FREE; 2], &[ZERO; 2], f), &[2.0, 1.0], -1.0, 0.0);
    let f = |x: &[Dual64]| {
        let pi = std::f64::consts::PI;
        phi((x[0] * pi / 12.0).sin() * (x[1] * pi / 16.0).cos(), vec![x[0] * 4.0 - x[1] * 3.0])
    };
    check("HS9", Stated::new(&[FREE; 2], &[ZERO], f), &[0.0, 0.0], -0.5, 0.0);
}

#[test]
fn hs10_11_12_inequalities() {
    let f = |x: &[Dual64]| {
        phi(x[0] - x[1], vec![x[0] * x[0] * -3.0 + x[0] * x[1] * 2.0 - x[1] * x[1] + 1.0])
    };
    check("HS10", Stated::new(&[FREE; 2], &[AT_LEAST_0], f), &[-10.0, 10.0], -1.0, 0.0);
    let f =
        |x: &[Dual64]| phi((x[0] - 5.0).powi(2) + x[1] * x[1] - 25.0, vec![-x[0] * x[0] + x[1]]);
    check("HS11", Stated::new(&[FREE; 2], &[AT_LEAST_0], f), &[4.9, 0.1], -8.498464223, 0.0);
    let f = |x: &[Dual64]| {
        let quadratic = x[0] * x[0] * 0.5 + x[1] * x[1] - x[0] * x[1];
        let c = -x[0] * x[0] * 4.0 - x[1] * x[1] + 25.0;
        phi(quadratic - x[0] * 7.0 - x[1] * 7.0, vec![c])
    };
    check("HS12", Stated::new(&[FREE; 2], &[AT_LEAST_0], f), &[0.0, 0.0], -30.0, 0.0);
}

#[test]
fn hs14_22_distances() {
    let distance = |x: &[Dual64]| vec![x[0] - 2.0, x[1] - 1.0];
    let hs14 = |x: &[Dual64]| vec![-x[0] * x[0] / 4.0 - x[1] * x[1] + 1.0, x[0] - x[1] * 2.0 + 1.0];
    let limits = [AT_LEAST_0, ZERO];
    let optimum = 9.0 - 2.875 * 7f64.sqrt();
    let f = move |x: &[Dual64]| squares(distance(x), hs14(x));
    check("HS14 r", Stated::new(&[FREE; 2], &limits, f), &[2.0, 2.0], optimum, 0.0);
    let f = move |x: &[Dual64]| phi(sum_of_squares(&distance(x)), hs14(x));
    check("HS14 φ", Stated::new(&[FREE; 2], &limits, f), &[2.0, 2.0], optimum, 0.0);
    let hs22 = |x: &[Dual64]| vec![-x[0] - x[1] + 2.0, -x[0] * x[0] + x[1]];
    let f = move |x: &[Dual64]| squares(distance(x), hs22(x));
    check("HS22 r", Stated::new(&[FREE; 2], &[AT_LEAST_0; 2], f), &[2.0, 2.0], 1.0, 0.0);
    let f = move |x: &[Dual64]| phi(sum_of_squares(&distance(x)), hs22(x));
    check("HS22 φ", Stated::new(&[FREE; 2], &[AT_LEAST_0; 2], f), &[2.0, 2.0], 1.0, 0.0);
}

#[test]
fn hs26_27_28_three_variables() {
    let c = |x: &[Dual64]| vec![(x[1] * x[1] + 1.0) * x[0] + x[2].powi(4) - 3.0];
    let f = move |x: &[Dual64]| squares(vec![x[0] - x[1], (x[1] - x[2]).powi(2)], c(x));
    check("HS26 r", Stated::new(&[FREE; 3], &[ZERO], f), &[-2.6, 2.0, 2.0], 0.0, 0.0);
    let f = move |x: &[Dual64]| phi((x[0] - x[1]).powi(2) + (x[1] - x[2]).powi(4), c(x));
    check("HS26 φ", Stated::new(&[FREE; 3], &[ZERO], f), &[-2.6, 2.0, 2.0], 0.0, 0.0);
    let r = |x: &[Dual64]| vec![(x[0] - 1.0) * 0.1, x[1] - x[0] * x[0]];
    let c = |x: &[Dual64]| vec![x[0] + x[2] * x[2] + 1.0];
    let f = move |x: &[Dual64]| squares(r(x), c(x));
    check("HS27 r", Stated::new(&[FREE; 3], &[ZERO], f), &[2.0, 2.0, 2.0], 0.04, 0.0);
    let f = move |x: &[Dual64]| phi(sum_of_squares(&r(x)), c(x));
    check("HS27 φ", Stated::new(&[FREE; 3], &[ZERO], f), &[2.0, 2.0, 2.0], 0.04, 0.0);
    let f = |x: &[Dual64]| {
        squares(vec![x[0] + x[1], x[1] + x[2]], vec![x[0] + x[1] * 2.0 + x[2] * 3.0 - 1.0])
    };
    check("HS28", Stated::new(&[FREE; 3], &[ZERO], f), &[-4.0, 1.0, 1.0], 0.0, 0.0);
}

#[test]
fn hs35_76_quadratic_programs() {
    let f = |x: &[Dual64]| {
        let linear = x[0] * -8.0 - x[1] * 6.0 - x[2] * 4.0 + 9.0;
        let quadratic = x[0] * x[0] * 2.0 + x[1] * x[1] * 2.0 + x[2] * x[2];
        let mixed = (x[0] * x[1] + x[0] * x[2]) * 2.0;
        phi(linear + quadratic + mixed, vec![-x[0] - x[1] - x[2] * 2.0 + 3.0])
    };
    let stated = Stated::new(&[AT_LEAST_0; 3], &[AT_LEAST_0], f);
    check("HS35", stated, &[0.5; 3], 1.0 / 9.0, 0.0);
    let f = |x: &[Dual64]| {
        let squares = x[0] * x[0] + x[1] * x[1] * 0.5 + x[2] * x[2] + x[3] * x[3] * 0.5;
        let mixed = -x[0] * x[2] + x[2] * x[3];
        let linear = -x[0] - x[1] * 3.0 + x[2] - x[3];
        let constraints = vec![
            -x[0] - x[1] * 2.0 - x[2] - x[3] + 5.0,
            x[0] * -3.0 - x[1] - x[2] * 2.0 + x[3] + 4.0,
            x[1] + x[2] * 4.0 - 1.5,
        ];
        phi(squares + mixed + linear, constraints)
    };
    let stated = Stated::new(&[AT_LEAST_0; 4], &[AT_LEAST_0; 3], f);
    check("HS76", stated, &[0.5; 4], -4.681818181, 1e-9);
}

#[test]
fn hs39_40_42_43_four_variables() {
    let f = |x: &[Dual64]| {
        let first = x[1] - x[0].powi(3) - x[2] * x[2];
        phi(-x[0], vec![first, x[0] * x[0] - x[1] - x[3] * x[3]])
    };
    check("HS39", Stated::new(&[FREE; 4], &[ZERO; 2], f), &[2.0; 4], -1.0, 0.0);
    let f = |x: &[Dual64]| {
        let first = x[0].powi(3) + x[1] * x[1] - 1.0;
        let constraints = vec![first, x[0] * x[0] * x[3] - x[2], x[3] * x[3] - x[1]];
        phi(-x[0] * x[1] * x[2] * x[3], constraints)
    };
    check("HS40", Stated::new(&[FREE; 4], &[ZERO; 3], f), &[0.8; 4], -0.25, 0.0);
    let f = |x: &[Dual64]| {
        let residuals = (0..4).map(|k| x[k] - (k + 1) as f64).collect();
        squares(residuals, vec![x[0] - 2.0, x[2] * x[2] + x[3] * x[3] - 2.0])
    };
    let optimum = 28.0 - 10.0 * 2f64.sqrt();
    check("HS42", Stated::new(&[FREE; 4], &[ZERO; 2], f), &[1.0; 4], optimum, 0.0);
    let f = |x: &[Dual64]| {
        let s: Vec<Dual64> = x.iter().map(|value| value * value).collect();
        let linear = x[0] * -5.0 - x[1] * 5.0 - x[2] * 21.0 + x[3] * 7.0;
        let constraints = vec![
            -s[0] - s[1] - s[2] - s[3] - x[0] + x[1] - x[2] + x[3] + 8.0,
            -s[0] - s[1] * 2.0 - s[2] - s[3] * 2.0 + x[0] + x[3] + 10.0,
            s[0] * -2.0 - s[1] - s[2] - x[0] * 2.0 + x[1] + x[3] + 5.0,
        ];
        phi(s[0] + s[1] + s[2] * 2.0 + s[3] + linear, constraints)
    };
    check("HS43", Stated::new(&[FREE; 4], &[AT_LEAST_0; 3], f), &[0.0; 4], -44.0, 0.0);
}

#[test]
fn hs60_63_65_66_three_variables() {
    let f = |x: &[Dual64]| {
        let c = x[0] * (x[1] * x[1] + 1.0) + x[2].powi(4) - 4.0 - 3.0 * 2f64.sqrt();
        squares(vec![x[0] - 1.0, x[0] - x[1], (x[1] - x[2]).powi(2)], vec![c])
    };
    let stated = Stated::new(&[(-10.0, 10.0); 3], &[ZERO], f);
    check("HS60", stated, &[2.0; 3], 0.03256820025, 0.0);
    let f = |x: &[Dual64]| {
        let quadratic = x[0] * x[0] + x[1] * x[1] * 2.0 + x[2] * x[2] + x[0] * (x[1] + x[2]);
        let plane = x[0] * 8.0 + x[1] * 14.0 + x[2] * 7.0 - 56.0;
        phi(-quadratic + 1000.0, vec![plane, sum_of_squares(x) - 25.0])
    };
    check("HS63", Stated::new(&[AT_LEAST_0; 3], &[ZERO; 2], f), &[2.0; 3], 961.7151721, 0.0);
    let f = |x: &[Dual64]| {
        let residuals = vec![x[0] - x[1], (x[0] + x[1] - 10.0) / 3.0, x[2] - 5.0];
        squares(residuals, vec![-sum_of_squares(x) + 48.0])
    };
    let bounds = [(-4.5, 4.5), (-4.5, 4.5), (-5.0, 5.0)];
    let stated = Stated::new(&bounds, &[AT_LEAST_0], f);
    check("HS65", stated, &[-5.0, 5.0, 0.0], 0.9535288567, 0.0);
    let f = |x: &[Dual64]| phi(x[2] * 0.2 - x[0] * 0.8, vec![x[1] - x[0].exp(), x[2] - x[1].exp()]);
    let bounds = [(0.0, 100.0), (0.0, 100.0), (0.0, 10.0)];
    let stated = Stated::new(&bounds, &[AT_LEAST_0; 2], f);
    check("HS66", stated, &[0.0, 1.05, 2.9], 0.5181632741, 0.0);
}

#[test]
fn hs71() {
    let f = |x: &[Dual64]| {
        let constraints = vec![x[0] * x[1] * x[2] * x[3] - 25.0, sum_of_squares(x) - 40.0];
        phi(x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2], constraints)
    };
    let stated = Stated::new(&[(1.0, 5.0); 4], &[AT_LEAST_0, ZERO], f);
    check("HS71", stated, &[1.0, 5.0, 5.0, 1.0], 17.0140173, 5e-8);
}

#[test]
fn hs77_79_five_variables() {
    let c = |x: &[Dual64]| {
        vec![
            x[0] * x[0] * x[3] + (x[3] - x[4]).sin() - 2.0 * 2f64.sqrt(),
            x[1] + x[2].powi(4) * x[3] * x[3] - 8.0 - 2f64.sqrt(),
        ]
    };
    let r = |x: &[Dual64]| {
        let powers = [(x[3] - 1.0).powi(2), (x[4] - 1.0).powi(3)];
        vec![x[0] - 1.0, x[0] - x[1], x[2] - 1.0, powers[0], powers[1]]
    };
    let f = move |x: &[Dual64]| squares(r(x), c(x));
    check("HS77 r", Stated::new(&[FREE; 5], &[ZERO; 2], f), &[2.0; 5], 0.24150513, 5e-9);
    let f = move |x: &[Dual64]| phi(sum_of_squares(&r(x)), c(x));
    check("HS77 φ", Stated::new(&[FREE; 5], &[ZERO; 2], f), &[2.0; 5], 0.24150513, 5e-9);
    let c = |x: &[Dual64]| {
        vec![
            x[0] + x[1] * x[1] + x[2].powi(3) - 2.0 - 3.0 * 2f64.sqrt(),
            x[1] - x[2] * x[2] + x[3] + 2.0 - 2.0 * 2f64.sqrt(),
            x[0] * x[4] - 2.0,
        ]
    };
    let r = |x: &[Dual64]| {
        let powers = [(x[2] - x[3]).powi(2), (x[3] - x[4]).powi(2)];
        vec![x[0] - 1.0, x[0] - x[1], x[1] - x[2], powers[0], powers[1]]
    };
    let f = move |x: &[Dual64]| squares(r(x), c(x));
    check("HS79 r", Stated::new(&[FREE; 5], &[ZERO; 3], f), &[2.0; 5], 0.0787768209, 0.0);
    let f = move |x: &[Dual64]| phi(sum_of_squares(&r(x)), c(x));
    check("HS79 φ", Stated::new(&[FREE; 5], &[ZERO; 3], f), &[2.0; 5], 0.0787768209, 0.0);
}

#[test]
fn hs78_80_81_products() {
    fn product(x: &[Dual64]) -> Dual64 {
        x[0] * x[1] * x[2] * x[3] * x[4]
    }
    fn c(x: &[Dual64]) -> Vec<Dual64> {
        let cubes = x[0].powi(3) + x[1].powi(3) + 1.0;
        vec![sum_of_squares(x) - 10.0, x[1] * x[2] - x[3] * x[4] * 5.0, cubes]
    }
    let f = |x: &[Dual64]| phi(product(x), c(x));
    let start = [-2.0, 1.5, 2.0, -1.0, -1.0];
    check("HS78", Stated::new(&[FREE; 5], &[ZERO; 3], f), &start, -2.91970041, 5e-9);
    let bounds = [(-2.3, 2.3), (-2.3, 2.3), (-3.2, 3.2), (-3.2, 3.2), (-3.2, 3.2)];
    let start = [-2.0, 2.0, 2.0, -1.0, -1.0];
    let f = |x: &[Dual64]| phi(product(x).exp(), c(x));
    check("HS80", Stated::new(&bounds, &[ZERO; 3], f), &start, 0.0539498478, 0.0);
    let f = |x: &[Dual64]| phi(product(x).exp() - c(x)[2].powi(2) * 0.5, c(x));
    check("HS81", Stated::new(&bounds, &[ZERO; 3], f), &start, 0.0539498478, 0.0);
}

#[test]
fn hs100_113_many_inequalities() {
    let f = |x: &[Dual64]| {
        let mut sum = (x[0] - 10.0).powi(2) + (x[1] - 12.0).powi(2) * 5.0 + x[2].powi(4);
        sum += (x[3] - 11.0).powi(2) * 3.0 + x[4].powi(6) * 10.0 + x[5].powi(2) * 7.0;
        sum += x[6].powi(4) - x[5] * x[6] * 4.0 - x[5] * 10.0 - x[6] * 8.0;
        let constraints = vec![
            x[0].powi(2) * -2.0 - x[1].powi(4) * 3.0 - x[2] - x[3].powi(2) * 4.0 - x[4] * 5.0
                + 127.0,
            x[0] * -7.0 - x[1] * 3.0 - x[2].powi(2) * 10.0 - x[3] + x[4] + 282.0,
            x[0] * -23.0 - x[1].powi(2) - x[5].powi(2) * 6.0 + x[6] * 8.0 + 196.0,
            x[0].powi(2) * -4.0 - x[1].powi(2) + x[0] * x[1] * 3.0
                - x[2].powi(2) * 2.0
                - x[5] * 5.0
                + x[6] * 11.0,
        ];
        phi(sum, constraints)
    };
    let start = [1.0, 2.0, 0.0, 4.0, 0.0, 1.0, 1.0];
    check("HS100", Stated::new(&[FREE; 7], &[AT_LEAST_0; 4], f), &start, 680.6300573, 0.0);
    let f = |x: &[Dual64]| {
        let mut sum = x[0].powi(2) + x[1].powi(2) + x[0] * x[1] - x[0] * 14.0 - x[1] * 16.0;
        sum += (x[2] - 10.0).powi(2) + (x[3] - 5.0).powi(2) * 4.0 + (x[4] - 3.0).powi(2);
        sum += (x[5] - 1.0).powi(2) * 2.0 + x[6].powi(2) * 5.0 + (x[7] - 11.0).powi(2) * 7.0;
        sum += (x[8] - 10.0).powi(2) * 2.0 + (x[9] - 7.0).powi(2) + 45.0;
        let s = |k: usize, middle: f64| (x[k] - middle).powi(2);
        let constraints = vec![
            x[0] * -4.0 - x[1] * 5.0 + x[6] * 3.0 - x[7] * 9.0 + 105.0,
            x[0] * -10.0 + x[1] * 8.0 + x[6] * 17.0 - x[7] * 2.0,
            x[0] * 8.0 - x[1] * 2.0 - x[8] * 5.0 + x[9] * 2.0 + 12.0,
            s(0, 2.0) * -3.0 - s(1, 3.0) * 4.0 - x[2].powi(2) * 2.0 + x[3] * 7.0 + 120.0,
            x[0].powi(2) * -5.0 - x[1] * 8.0 - s(2, 6.0) + x[3] * 2.0 + 40.0,
            s(0, 8.0) * -0.5 - s(1, 4.0) * 2.0 - x[4].powi(2) * 3.0 + x[5] + 30.0,
            -x[0].powi(2) - s(1, 2.0) * 2.0 + x[0] * x[1] * 2.0 - x[4] * 14.0 + x[5] * 6.0,
            x[0] * 3.0 - x[1] * 6.0 - s(8, 8.0) * 12.0 + x[9] * 7.0,
        ];
        phi(sum, constraints)
    };
    let start = [2.0, 3.0, 5.0, 5.0, 1.0, 2.0, 7.0, 3.0, 6.0, 10.0];
    check("HS113", Stated::new(&[FREE; 10], &[AT_LEAST_0; 8], f), &start, 24.3062091, 5e-8);
}
