//! Functions of numbers that expressions have.

/// The value of a function or a constant.
///
/// # Errors
/// Its name where hardpoint does not know it.
pub(super) fn function(name: &str, arguments: &[f64]) -> Result<f64, String> {
    Ok(match (name, arguments) {
        ("PI", []) => std::f64::consts::PI,
        ("RTOD", []) => 1.0_f64.to_degrees(),
        ("DTOR", []) => 1.0_f64.to_radians(),
        ("SIN", [x]) => x.sin(),
        ("COS", [x]) => x.cos(),
        ("TAN", [x]) => x.tan(),
        ("ASIN", [x]) => x.asin(),
        ("ACOS", [x]) => x.acos(),
        ("ATAN", [x]) => x.atan(),
        ("ATAN2", [y, x]) => y.atan2(*x),
        ("SINH", [x]) => x.sinh(),
        ("COSH", [x]) => x.cosh(),
        ("TANH", [x]) => x.tanh(),
        ("EXP", [x]) => x.exp(),
        ("LOG", [x]) => x.ln(),
        ("LOG10", [x]) => x.log10(),
        ("SQRT", [x]) => x.sqrt(),
        ("ABS", [x]) => x.abs(),
        ("AINT", [x]) => x.trunc(),
        ("ANINT", [x]) => x.round(),
        ("SIGN", [size, sign]) => size.abs().copysign(*sign),
        ("DIM", [x, y]) => (x - y).max(0.0),
        ("MOD", [x, y]) => x % y,
        ("MIN", [x, y]) => x.min(*y),
        ("MAX", [x, y]) => x.max(*y),
        ("IF", [x, below, at, above]) => match x.total_cmp(&0.0) {
            _ if *x == 0.0 => *at,
            std::cmp::Ordering::Less => *below,
            _ => *above,
        },
        ("STEP", [x, x0, h0, x1, h1]) => {
            let s = ((x - x0) / (x1 - x0)).clamp(0.0, 1.0);
            h0 + (h1 - h0) * s * s * (3.0 - 2.0 * s)
        }
        ("STEP5", [x, x0, h0, x1, h1]) => {
            let s = ((x - x0) / (x1 - x0)).clamp(0.0, 1.0);
            h0 + (h1 - h0) * s * s * s * (10.0 - s * (15.0 - 6.0 * s))
        }
        ("HAVSIN", [x, x0, h0, x1, h1]) => {
            let s = ((x - x0) / (x1 - x0)).clamp(0.0, 1.0);
            let (middle, half) = (0.5 * (h0 + h1), 0.5 * (h1 - h0));
            middle + half * (std::f64::consts::PI * (s - 0.5)).sin()
        }
        ("POLY", [x, x0, coefficients @ ..]) => {
            coefficients.iter().rev().fold(0.0, |sum, c| sum * (x - x0) + c)
        }
        ("SHF", [x, x0, a, w, phase, b]) => a * (w * (x - x0) - phase).sin() + b,
        (name, _) => {
            let count = arguments.len();
            let with = if count == 0 { String::new() } else { format!(" with {count} arguments") };
            return Err(format!("hardpoint does not know the function {name}{with}"));
        }
    })
}
