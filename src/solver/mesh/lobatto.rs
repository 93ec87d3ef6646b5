//! Gauss–Lobatto–Legendre points: nodes of cells of order four and more, and the polynomials through them.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// Most points that are tabulated: those of cells of order 8.
const MOST: usize = 9;

/// The points of every rule, by their number.
static POINTS: LazyLock<Vec<Vec<f64>>> = LazyLock::new(|| (0..=MOST).map(computed).collect());

/// The `n` points on −1 … 1, from 2 to 9: the ends and the roots of `P′ₙ₋₁`.
pub fn points(n: usize) -> &'static [f64] {
    &POINTS[n.min(MOST)]
}

/// Newton's iteration `x ← x − (x P_N − P_{N−1})/((N+1) P_N)`, `N = n − 1`, from the Chebyshev–Lobatto points
/// (Hesthaven & Warburton 2008, App. A); the upper half is the image of the lower one.
fn computed(n: usize) -> Vec<f64> {
    let Some(degree) = n.checked_sub(1).filter(|degree| *degree > 0) else { return vec![0.0; n] };
    let root = |i: usize| {
        let mut x = -(PI * i as f64 / degree as f64).cos();
        for _ in 0..8 {
            let [before, value] = legendre(degree, x);
            x -= (x * value - before) / (n as f64 * value);
        }
        x
    };
    let lower: Vec<f64> = (0..n / 2).map(|i| if i == 0 { -1.0 } else { root(i) }).collect();
    let middle = (n % 2 == 1).then_some(0.0);
    lower.iter().copied().chain(middle).chain(lower.iter().rev().map(|x| -x)).collect()
}

/// Legendre polynomials `P_{n−1}` and `P_n` at `x`, n ≥ 1, by the three-term recurrence.
pub fn legendre(n: usize, x: f64) -> [f64; 2] {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
    }
    [before, value]
}

/// Lagrange polynomials through some points, `N_a = Π (x − x_k)/(x_a − x_k)`, and their slopes at `x`.
pub fn lagrange(points: &[f64], x: f64) -> Vec<(f64, f64)> {
    let of = |a: usize| {
        let others = || (0..points.len()).filter(move |&k| k != a);
        let factor = |k: usize| (x - points[k]) / (points[a] - points[k]);
        let without = |m: usize| others().filter(|&k| k != m).map(factor).product::<f64>() / (points[a] - points[m]);
        (others().map(factor).product(), others().map(without).sum())
    };
    (0..points.len()).map(of).collect()
}
