//! What the benchmarks share.
#![allow(dead_code, unused_imports, reason = "each benchmark uses a part of it")]

pub mod assembly;
#[path = "../../tests/common/dual.rs"]
pub mod dual;
pub mod measure;
pub mod methods;
pub mod scene;

/// Stops the benchmark if an alternative does not compute the same numbers.
/// The tolerance is relative to the largest expected number.
pub fn assert_same(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let scale = expected.iter().fold(0.0_f64, |scale, value| scale.max(value.abs()));
    for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!(
            (found - expected).abs() <= tolerance * scale,
            "{what}: number {k} is {found}, expected {expected}"
        );
    }
}
