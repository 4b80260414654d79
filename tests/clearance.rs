//! Clearances against brute force, and their derivatives against differences.
#![allow(missing_docs)]

use hardpoint::design::clearance::{
    Cylinder, Keeps, Segment, angle, between_segments, cosine, segment_to_point,
};
use hardpoint::scalar::Dual;
use hardpoint::vector::{add, norm, scale, sub, unit};
use proptest::prelude::*;

/// Places along a segment for brute force.
const PLACES: usize = 200;

fn point() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1.0..1.0)
}

fn segment() -> impl Strategy<Value = Segment<f64>> {
    [point(), point()]
}

fn at([from, to]: Segment<f64>, part: f64) -> [f64; 3] {
    add(from, scale(part, sub(to, from)))
}

fn parts() -> impl Iterator<Item = f64> {
    (0..=PLACES).map(|k| k as f64 / PLACES as f64)
}

/// Derivative of a function of twelve or so numbers along a direction, by dual numbers and by differences.
fn derivatives<const N: usize>(
    x: [f64; N],
    direction: [f64; N],
    plain: impl Fn([f64; N]) -> f64,
    dual: impl Fn([Dual; N]) -> Dual,
) -> [f64; 2] {
    let step = 1e-6;
    let moved = |by: f64| plain(std::array::from_fn(|k| x[k] + by * direction[k]));
    let exact = dual(std::array::from_fn(|k| Dual::new(x[k], direction[k])));
    assert_eq!(exact.value, plain(x));
    [exact.derivative, (moved(step) - moved(-step)) / (2.0 * step)]
}

fn segments<S: Copy>(x: &[S; 12]) -> [Segment<S>; 2] {
    let point = |k: usize| [x[k], x[k + 1], x[k + 2]];
    [[point(0), point(3)], [point(6), point(9)]]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, max_global_rejects: 10_000, ..ProptestConfig::default() })]

    #[test]
    fn segments_are_as_far_as_the_nearest_of_many_places(a in segment(), b in segment()) {
        let found = between_segments(a, b);
        let sampled = parts().map(|part| segment_to_point(b, at(a, part)));
        let least = sampled.fold(f64::INFINITY, f64::min);
        // Between two samples the distance changes by less than half of their way.
        let way = norm(sub(a[1], a[0])) / PLACES as f64;
        prop_assert!(found <= least + 1e-14 && least - found <= 0.5 * way + 1e-14, "{found} {least}");
        prop_assert!((found - between_segments(b, a)).abs() < 1e-14);
        let turned = between_segments([a[1], a[0]], b);
        prop_assert!((found - turned).abs() < 1e-13);
    }

    #[test]
    fn parallel_segments_are_as_far_as_the_nearest_of_many_places(
        a in segment(), from in point(), length in -2.0..2.0_f64,
    ) {
        let b = [from, add(from, scale(length, sub(a[1], a[0])))];
        let found = between_segments(a, b);
        let sampled = parts().map(|part| segment_to_point(b, at(a, part)));
        let least = sampled.fold(f64::INFINITY, f64::min);
        let way = norm(sub(a[1], a[0])) / PLACES as f64;
        prop_assert!(found <= least + 1e-12 && least - found <= 0.5 * way + 1e-12, "{found} {least}");
    }

    #[test]
    fn points_are_as_far_as_the_nearest_of_many_places(a in segment(), p in point()) {
        let found = segment_to_point(a, p);
        let least = parts().map(|part| norm(sub(p, at(a, part)))).fold(f64::INFINITY, f64::min);
        let way = norm(sub(a[1], a[0])) / PLACES as f64;
        prop_assert!(found <= least + 1e-14 && least - found <= 0.5 * way, "{found} {least}");
    }

    #[test]
    fn distances_have_their_derivatives(
        x in prop::array::uniform12(-1.0..1.0_f64), direction in prop::array::uniform12(-1.0..1.0_f64),
    ) {
        let distance = |x: [f64; 12]| { let [a, b] = segments(&x); between_segments(a, b) };
        let dual = |x: [Dual; 12]| { let [a, b] = segments(&x); between_segments(a, b) };
        prop_assume!(distance(x) > 0.02);
        let [exact, difference] = derivatives(x, direction, distance, dual);
        // At the change from one case to another differences see both, which have the same slope.
        prop_assert!((exact - difference).abs() < 1e-5 * (1.0 + difference.abs()), "{exact} {difference}");
    }

    #[test]
    fn rods_are_as_far_from_a_wheel_as_the_nearest_of_many_places(
        rod in segment(), center in point(), axis in point(), radius in 0.2..0.9_f64,
        width in 0.1..0.8_f64, inside: bool,
    ) {
        prop_assume!(norm(axis) > 0.1);
        let keeps = if inside { Keeps::Inside } else { Keeps::Outside };
        let wheel = Cylinder { center, axis: unit(axis), radius, width, keeps };
        let found = wheel.to_segment(rod);
        let least = parts().map(|part| wheel.to_point(at(rod, part))).fold(f64::INFINITY, f64::min);
        let way = norm(sub(rod[1], rod[0])) / PLACES as f64;
        prop_assert!(found <= least + 0.5 * way && least - found <= 0.5 * way, "{found} {least}");
    }

    #[test]
    fn points_are_as_far_from_a_wheel_as_the_nearest_of_many_places_of_its_surface(
        p in point(), axis in point(), inside: bool,
    ) {
        prop_assume!(norm(axis) > 0.1);
        let keeps = if inside { Keeps::Inside } else { Keeps::Outside };
        let (radius, width) = (0.5, 0.4);
        let wheel = Cylinder { center: [0.0; 3], axis: unit(axis), radius, width, keeps };
        let found = wheel.to_point(p);
        // By symmetry the nearest place lies in the plane of the point and the axis: a polar grid of it.
        let along: f64 = (0..3).map(|k| p[k] * unit(axis)[k]).sum();
        let radial = (norm(p).powi(2) - along * along).max(0.0).sqrt();
        let forbidden = |a: f64, r: f64| a.abs() < 0.5 * width && ((r > radius) == inside);
        let far = if inside { 2.0 } else { radius };
        let near = if inside { radius } else { 0.0 };
        let grid = parts().flat_map(|i| parts().map(move |j| {
            let (a, r) = (width * (i - 0.5), near + (far - near) * j);
            ((a - along).powi(2) + (r - radial).powi(2)).sqrt()
        }));
        let least = grid.fold(f64::INFINITY, f64::min);
        if forbidden(along, radial) {
            prop_assert!(found <= 0.0);
        } else {
            prop_assert!(found >= 0.0 && (found - least).abs() < 0.01, "{found} {least}");
        }
    }

    #[test]
    fn distances_from_a_wheel_have_their_derivatives(
        x in prop::array::uniform12(-1.0..1.0_f64), direction in prop::array::uniform12(-1.0..1.0_f64),
        inside: bool,
    ) {
        let keeps = if inside { Keeps::Inside } else { Keeps::Outside };
        // Rod, wheel centre and spin axis all move.
        let distance = |x: [f64; 12]| {
            let [rod, [center, axis]] = segments(&x);
            Cylinder { center, axis: unit(axis), radius: 0.5, width: 0.3, keeps }.to_segment(rod)
        };
        let dual = |x: [Dual; 12]| {
            let [rod, [center, axis]] = segments(&x);
            Cylinder { center, axis: unit(axis), radius: 0.5, width: 0.3, keeps }.to_segment(rod)
        };
        let there = distance(x);
        prop_assume!(there > 0.02 && norm([x[9], x[10], x[11]]) > 0.3);
        let [exact, difference] = derivatives(x, direction, distance, dual);
        // Two places of a rod may be equally near to a barrel: no derivative there.
        let close = (exact - difference).abs() < 1e-4 * (1.0 + difference.abs());
        let step = 1e-6;
        let jumps = {
            let slope = |by: f64| {
                let moved = |by: f64| distance(std::array::from_fn(|k| x[k] + by * direction[k]));
                (moved(by + step) - moved(by)) / step
            };
            (slope(0.0) - slope(-step)).abs() > 1e-4
        };
        prop_assert!(close || jumps, "{exact} {difference}");
    }

    #[test]
    fn angles_have_their_derivatives(
        x in prop::array::uniform6(-1.0..1.0_f64), direction in prop::array::uniform6(-1.0..1.0_f64),
    ) {
        let a = |x: [f64; 6]| angle([x[0], x[1], x[2]], [x[3], x[4], x[5]]);
        let c = |x: [f64; 6]| cosine([x[0], x[1], x[2]], [x[3], x[4], x[5]]);
        let bounded = norm([x[0], x[1], x[2]]) > 0.2 && norm([x[3], x[4], x[5]]) > 0.2;
        prop_assume!(bounded && (0.1..3.0).contains(&a(x)));
        prop_assert!((a(x).cos() - c(x)).abs() < 1e-14);
        let [exact, difference] = derivatives(
            x, direction, a, |x| angle([x[0], x[1], x[2]], [x[3], x[4], x[5]]),
        );
        prop_assert!((exact - difference).abs() < 1e-6 * (1.0 + difference.abs()));
        let [exact, difference] = derivatives(
            x, direction, c, |x| cosine([x[0], x[1], x[2]], [x[3], x[4], x[5]]),
        );
        prop_assert!((exact - difference).abs() < 1e-6 * (1.0 + difference.abs()));
    }
}
