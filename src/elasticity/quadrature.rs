//! Gauss–Legendre rules on −1 … 1.

use std::f64::consts::PI;

/// Points and weights of the `n`-point Gauss–Legendre rule, exact for polynomials of degree `2n − 1`.
///
/// Newton's iteration on the Legendre polynomial from Tricomi's first guess (Abramowitz & Stegun, 25.4.29).
pub fn gauss(n: usize) -> Vec<(f64, f64)> {
    (0..n)
        .map(|i| {
            let mut x = -(PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
            for _ in 0..8 {
                let (value, slope) = legendre(n, x);
                x -= value / slope;
            }
            let (_, slope) = legendre(n, x);
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// Points and weights of the `n`-point rule of tensor products on the square.
pub fn gauss_square(n: usize) -> Vec<([f64; 2], f64)> {
    let line = gauss(n);
    let rows = line.iter().flat_map(|&(eta, v)| line.iter().map(move |&(xi, w)| ([xi, eta], w * v)));
    rows.collect()
}

/// Three-point Lobatto rule: the ends and the middle, exact for cubics.
pub fn lobatto_three() -> Vec<(f64, f64)> {
    vec![(-1.0, 1.0 / 3.0), (0.0, 4.0 / 3.0), (1.0, 1.0 / 3.0)]
}

/// Two-point Lobatto (trapezoidal) rule, exact for linear functions.
pub fn lobatto_two() -> Vec<(f64, f64)> {
    vec![(-1.0, 1.0), (1.0, 1.0)]
}

/// Legendre polynomial `P_n` and its derivative at `x`, by the three-term recurrence.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
    }
    (value, n as f64 * (x * value - before) / (x * x - 1.0))
}
