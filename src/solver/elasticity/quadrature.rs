//! Gauss–Legendre and Lobatto rules on −1 … 1.

use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::mesh::lobatto;

/// Points and weights of the `n`-point Gauss–Legendre rule, exact for polynomials of degree `2n − 1`.
///
/// Newton's iteration on the Legendre polynomial from Tricomi's first guess (Abramowitz & Stegun, 25.4.29).
pub fn gauss(n: usize) -> Vec<(f64, f64)> {
    RULES.get(n).cloned().unwrap_or_else(|| computed(n))
}

/// Rules of few points, which every edge of a contact takes.
static RULES: LazyLock<Vec<Vec<(f64, f64)>>> = LazyLock::new(|| (0..=16).map(computed).collect());

fn computed(n: usize) -> Vec<(f64, f64)> {
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

/// Points and weights `2/(n (n−1) P²_{n−1})` of the `n`-point Lobatto rule: the ends and points between, exact for
/// polynomials of degree `2n − 3`.
pub fn lobatto(n: usize) -> Vec<(f64, f64)> {
    let degree = n - 1;
    let weight = |x: f64| 2.0 / ((n * degree) as f64 * lobatto::legendre(degree, x)[1].powi(2));
    lobatto::points(n).iter().map(|&x| (x, weight(x))).collect()
}

/// Legendre polynomial `P_n` and its derivative at `x`.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let [before, value] = lobatto::legendre(n, x);
    (value, n as f64 * (x * value - before) / (x * x - 1.0))
}
