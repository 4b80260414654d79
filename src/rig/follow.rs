//! Markers of a mechanism in motion.

use crate::model::{Marker, Quantity, Units};
use crate::solve::dynamics::Dynamics;
use crate::vector::dot;

/// The ends of the names of a marker's columns with their kinds, in the order of [`values`]: position,
/// velocity and acceleration, Euler parameters of its axes, angular velocity and acceleration; all in the
/// axes of the ground.
const COLUMNS: [(&str, Quantity); 19] = [
    ("x", Quantity::Length),
    ("y", Quantity::Length),
    ("z", Quantity::Length),
    ("vx", Quantity::Velocity),
    ("vy", Quantity::Velocity),
    ("vz", Quantity::Velocity),
    ("ax", Quantity::Acceleration),
    ("ay", Quantity::Acceleration),
    ("az", Quantity::Acceleration),
    ("e0", Quantity::Ratio),
    ("e1", Quantity::Ratio),
    ("e2", Quantity::Ratio),
    ("e3", Quantity::Ratio),
    ("wx", Quantity::AngularVelocity),
    ("wy", Quantity::AngularVelocity),
    ("wz", Quantity::AngularVelocity),
    ("wdx", Quantity::AngularAcceleration),
    ("wdy", Quantity::AngularAcceleration),
    ("wdz", Quantity::AngularAcceleration),
];

/// The columns of a marker, in the units of a file.
pub fn columns(marker: &Marker, units: Units) -> impl Iterator<Item = String> {
    COLUMNS
        .iter()
        .map(move |(end, quantity)| quantity.column(&format!("{}_{end}", marker.name), units))
}

/// The values of a marker's columns, in the units of a file.
pub fn values(marker: &Marker, motion: &Dynamics, units: Units) -> impl Iterator<Item = f64> {
    let Marker { body, at, axes, .. } = *marker;
    // Columns of this matrix are the axes of the marker: A B with the axes B at the design position.
    let axes = axes.at(&motion.mechanism().positions());
    let turned = motion.rotation(body).map(|row| axes.map(|axis| dot(row, axis)));
    let values = [
        motion.point_position(body, at).to_vec(),
        motion.point_velocity(body, at).to_vec(),
        motion.point_acceleration(body, at).to_vec(),
        euler_parameters(turned).to_vec(),
        motion.angular_velocity(body).to_vec(),
        motion.angular_acceleration(body).to_vec(),
    ];
    let values = values.into_iter().flatten();
    values.zip(COLUMNS).map(move |(value, (_, quantity))| quantity.show(units, value))
}

/// Euler parameters of a rotation matrix (rows first), e0 not negative; found from the largest of them
/// (Haug, section 9.3).
fn euler_parameters(a: [[f64; 3]; 3]) -> [f64; 4] {
    let trace = a[0][0] + a[1][1] + a[2][2];
    let squares =
        [trace, a[0][0], a[1][1], a[2][2]].map(|entry| 0.25 * (1.0 + 2.0 * entry - trace));
    let largest = (0..4).max_by(|&i, &j| squares[i].total_cmp(&squares[j])).unwrap_or(0);
    // Four times the products of two parameters.
    let with_e0 = [a[2][1] - a[1][2], a[0][2] - a[2][0], a[1][0] - a[0][1]];
    let product = |i: usize, j: usize| match (i.min(j), i.max(j)) {
        (i, j) if i == j => 4.0 * squares[i],
        (0, j) => with_e0[j - 1],
        (i, j) => a[i - 1][j - 1] + a[j - 1][i - 1],
    };
    let divisor = 4.0 * squares[largest].sqrt();
    let p: [f64; 4] = std::array::from_fn(|k| product(largest, k) / divisor);
    if p[0] < 0.0 { p.map(|e| -e) } else { p }
}

#[cfg(test)]
mod tests {
    use super::euler_parameters;
    use crate::vector::rotate;

    #[test]
    fn euler_parameters_give_their_rotation_again() {
        let mut rng = fastrand::Rng::with_seed(5);
        for k in 0..200 {
            let mut p: [f64; 4] = std::array::from_fn(|_| rng.f64() - 0.5);
            // Half turns, where e0 is zero, too.
            p[0] = if k % 4 == 0 { 0.0 } else { p[0].abs() };
            let length = p.iter().map(|e| e * e).sum::<f64>().sqrt();
            let p = p.map(|e| e / length);
            let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| rotate(p, e));
            let rows = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
            let found = euler_parameters(rows);
            let same = |sign: f64| p.iter().zip(found).all(|(e, f)| (sign * e - f).abs() < 1e-14);
            assert!(same(1.0) || p[0] == 0.0 && same(-1.0), "{p:?} {found:?}");
        }
    }
}
