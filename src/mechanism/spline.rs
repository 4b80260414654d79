//! Tabulated functions of one variable.

use super::error::MechanismError;

/// A natural cubic spline through the points of a table: twice continuously differentiable.
///
/// Outside the table it goes on as a straight line with the slope that it has at the end,
/// where its second derivative is zero, so it is twice continuously differentiable there, too.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    points: Vec<[f64; 2]>,
    // Second derivatives at the points; zero at both ends.
    second: Vec<f64>,
    // The integral from the first point to each point.
    areas: Vec<f64>,
}

/// A function with its first two derivatives at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Jet {
    /// The value.
    pub value: f64,
    /// The first derivative.
    pub first: f64,
    /// The second derivative.
    pub second: f64,
}

impl Spline {
    /// The spline through points (x, y) with increasing x.
    ///
    /// # Errors
    /// [`MechanismError::Table`] for fewer than two points, x that does not increase, or a
    /// number that is not finite. `name` is that of the force element.
    pub fn new(name: &str, points: Vec<[f64; 2]>) -> Result<Self, MechanismError> {
        let wrong = |row: usize, problem: &'static str| {
            Err(MechanismError::Table { name: name.to_owned(), row: row + 1, problem })
        };
        if points.len() < 2 {
            return wrong(points.len(), "a table needs at least two rows");
        }
        if let Some(row) = points.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
            return wrong(row, "a number is not finite");
        }
        if let Some(row) = points.windows(2).position(|pair| pair[1][0] <= pair[0][0]) {
            return wrong(row + 1, "the first column does not increase");
        }
        let second = second_derivatives(&points);
        if let Some(row) = second.iter().position(|x| !x.is_finite()) {
            return wrong(row, "two rows are too close to each other");
        }
        Ok(Self::from_parts(points, second))
    }

    fn from_parts(points: Vec<[f64; 2]>, second: Vec<f64>) -> Self {
        let mut spline = Self { areas: vec![0.0; points.len()], points, second };
        for k in 1..spline.points.len() {
            let end = spline.points[k][0];
            spline.areas[k] = spline.areas[k - 1] + spline.area_within(k - 1, end);
        }
        spline
    }

    /// The function −f(−x).
    #[must_use]
    pub fn reversed(&self) -> Self {
        let points = self.points.iter().rev().map(|&[x, y]| [-x, -y]).collect();
        Self::from_parts(points, self.second.iter().rev().map(|second| -second).collect())
    }

    /// The function f(x − d).
    #[must_use]
    pub fn shifted(&self, d: f64) -> Self {
        let points = self.points.iter().map(|&[x, y]| [x + d, y]).collect();
        Self::from_parts(points, self.second.clone())
    }

    /// The rows of the table.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The function and its derivatives at x.
    pub fn at(&self, x: f64) -> Jet {
        let last = self.points.len() - 1;
        if x <= self.points[0][0] {
            return self.line(0, 0, x);
        }
        if x >= self.points[last][0] {
            return self.line(last - 1, last, x);
        }
        self.within(self.points.partition_point(|p| p[0] <= x) - 1, x)
    }

    /// The function times a factor.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        let points = self.points.iter().map(|&[x, y]| [x, factor * y]).collect();
        Self::from_parts(points, self.second.iter().map(|second| factor * second).collect())
    }

    /// The function with another y in a row, numbered from 0.
    pub(super) fn with_row(&self, row: usize, y: f64) -> Self {
        let mut points = self.points.clone();
        points[row][1] = y;
        let second = second_derivatives(&points);
        Self::from_parts(points, second)
    }

    /// The derivative of the function by the y of a row, numbered from 0, with its derivatives by x.
    pub(super) fn by_row(&self, row: usize, x: f64) -> Jet {
        let unit = |(k, &[x, _]): (usize, &[f64; 2])| [x, if k == row { 1.0 } else { 0.0 }];
        let points: Vec<[f64; 2]> = self.points.iter().enumerate().map(unit).collect();
        let second = second_derivatives(&points);
        Self::from_parts(points, second).at(x)
    }

    /// The integral from zero to x.
    pub fn integral(&self, x: f64) -> f64 {
        self.antiderivative(x) - self.antiderivative(0.0)
    }

    /// The integral from the first point to x.
    fn antiderivative(&self, x: f64) -> f64 {
        let last = self.points.len() - 1;
        let line = |end: usize| {
            let ([x_end, y_end], jet) = (self.points[end], self.at(x));
            self.areas[end] + 0.5 * (y_end + jet.value) * (x - x_end)
        };
        if x <= self.points[0][0] {
            return line(0);
        }
        if x >= self.points[last][0] {
            return line(last);
        }
        let k = self.points.partition_point(|p| p[0] <= x) - 1;
        self.areas[k] + self.area_within(k, x)
    }

    /// The integral from the start of an interval to x.
    fn area_within(&self, k: usize, x: f64) -> f64 {
        let ([x0, y0], [x1, y1]) = (self.points[k], self.points[k + 1]);
        let (m0, m1) = (self.second[k], self.second[k + 1]);
        let h = x1 - x0;
        let b = (x - x0) / h;
        let a = 1.0 - b;
        let (a2, b2) = (1.0 - a * a, b * b);
        // The integrals of a³ − a and b³ − b over b from 0.
        let (a4, b4) = (0.25 * (1.0 - a * a * a * a) - 0.5 * a2, 0.25 * b2 * b2 - 0.5 * b2);
        h * (0.5 * (a2 * y0 + b2 * y1) + (a4 * m0 + b4 * m1) * h * h / 6.0)
    }

    /// The straight line that goes on from an end of an interval.
    fn line(&self, interval: usize, end: usize, x: f64) -> Jet {
        let [x_end, y_end] = self.points[end];
        let first = self.within(interval, x_end).first;
        Jet { value: y_end + first * (x - x_end), first, second: 0.0 }
    }

    fn within(&self, k: usize, x: f64) -> Jet {
        let ([x0, y0], [x1, y1]) = (self.points[k], self.points[k + 1]);
        let (m0, m1) = (self.second[k], self.second[k + 1]);
        let h = x1 - x0;
        let (a, b) = ((x1 - x) / h, (x - x0) / h);
        Jet {
            value: a * y0 + b * y1 + ((a * a * a - a) * m0 + (b * b * b - b) * m1) * h * h / 6.0,
            first: (y1 - y0) / h + ((3.0 * b * b - 1.0) * m1 - (3.0 * a * a - 1.0) * m0) * h / 6.0,
            second: a * m0 + b * m1,
        }
    }
}

/// Solves the tridiagonal equations of the natural spline by elimination.
fn second_derivatives(points: &[[f64; 2]]) -> Vec<f64> {
    let n = points.len();
    let mut second = vec![0.0; n];
    let mut factor = vec![0.0; n];
    let slope = |k: usize| (points[k + 1][1] - points[k][1]) / (points[k + 1][0] - points[k][0]);
    for k in 1..n - 1 {
        let (left, right) = (points[k][0] - points[k - 1][0], points[k + 1][0] - points[k][0]);
        let pivot = 2.0 * (left + right) - left * factor[k - 1];
        factor[k] = right / pivot;
        second[k] = (6.0 * (slope(k) - slope(k - 1)) - left * second[k - 1]) / pivot;
    }
    for k in (1..n - 1).rev() {
        second[k] -= factor[k] * second[k + 1];
    }
    second
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(points: &[[f64; 2]]) -> Spline {
        Spline::new("spring", points.to_vec()).unwrap()
    }

    #[test]
    fn a_straight_table_is_a_straight_line_everywhere() {
        let line = table(&[[-2.0, -5.0], [-0.5, -2.0], [1.0, 1.0], [4.0, 7.0]]);
        for x in [-10.0, -2.0, -1.0, 0.3, 4.0, 50.0] {
            let jet = line.at(x);
            assert!((jet.value - (2.0 * x - 1.0)).abs() < 1e-12, "{jet:?}");
            assert!((jet.first - 2.0).abs() < 1e-12 && jet.second.abs() < 1e-12, "{jet:?}");
        }
    }

    #[test]
    fn it_is_twice_continuously_differentiable_and_passes_through_its_points() {
        let points = [[-3.0, 4.0], [-1.0, -1.0], [0.0, 0.5], [2.5, 3.0], [3.0, 9.0]];
        let spline = table(&points);
        for [x, y] in points {
            let (before, after) = (spline.at(x - 1e-9), spline.at(x + 1e-9));
            assert!((spline.at(x).value - y).abs() < 1e-14);
            assert!((before.first - after.first).abs() < 1e-7, "{before:?} {after:?}");
            assert!((before.second - after.second).abs() < 1e-7, "{before:?} {after:?}");
        }
        for x in [-4.0, -2.2, 0.7, 2.9, 5.0] {
            let d = 1e-5;
            let (minus, here, plus) = (spline.at(x - d), spline.at(x), spline.at(x + d));
            assert!((here.first - (plus.value - minus.value) / (2.0 * d)).abs() < 1e-8);
            assert!((here.second - (plus.first - minus.first) / (2.0 * d)).abs() < 1e-8);
        }
    }

    #[test]
    fn reversed_and_shifted_are_what_they_say() {
        let spline = table(&[[-3.0, 4.0], [-1.0, -1.0], [0.0, 0.5], [2.5, 3.0]]);
        for x in [-4.0, -2.0, -0.5, 0.0, 1.0, 3.0] {
            assert_eq!(spline.reversed().at(x).value, -spline.at(-x).value);
            assert!((spline.shifted(0.5).at(x).value - spline.at(x - 0.5).value).abs() < 1e-14);
        }
        assert_eq!(spline.reversed().reversed(), spline);
    }

    #[test]
    fn tables_without_meaning_are_refused() {
        for (points, row) in [
            (vec![[0.0, 1.0]], 2),
            (vec![[0.0, 1.0], [0.0, 2.0]], 2),
            (vec![[0.0, 1.0], [1.0, 2.0], [0.5, 2.0]], 3),
            (vec![[0.0, f64::NAN], [1.0, 2.0]], 1),
            (vec![[0.0, 0.0], [1.0, f64::INFINITY]], 2),
        ] {
            match Spline::new("spring", points) {
                Err(MechanismError::Table { row: found, .. }) => assert_eq!(found, row),
                other => panic!("{other:?}"),
            }
        }
    }
}
