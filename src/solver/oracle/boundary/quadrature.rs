//! Points between the places where an integrand is not smooth, closer towards poles beside the path.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// Points of a panel.
const POINTS: usize = 16;
/// Iterations of Newton's method for the zeros of a Legendre polynomial.
const ITERATIONS: usize = 8;
/// Halvings after which a panel is no longer halved.
const DEEPEST: usize = 50;
/// Longest panel \[rad\]: cos 20θ is integrated to round-off.
const LONGEST: f64 = PI / 8.0;

/// Gauss's points and weights on −1…1.
static GAUSS: LazyLock<[[f64; 2]; POINTS]> = LazyLock::new(|| {
    std::array::from_fn(|k| {
        let mut x = (PI * (k as f64 + 0.75) / (POINTS as f64 + 0.5)).cos();
        let mut slope = f64::NAN;
        for _ in 0..ITERATIONS {
            let (mut before, mut value) = (1.0, x);
            for n in 2..=POINTS {
                let n = n as f64;
                (before, value) = (value, ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n);
            }
            slope = POINTS as f64 * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        [x, 2.0 / ((1.0 - x * x) * slope * slope)]
    })
});

/// A place `[θ, η]` beside the path θ, η from it, where an integrand has a pole.
pub type Pole = [f64; 2];

/// Points and weights of `∫ dθ` between two places, for poles outside it.
pub fn panels([from, to]: [f64; 2], poles: &[Pole], points: &mut Vec<[f64; 2]>) {
    let number = ((to - from) / LONGEST).ceil().max(1.0);
    for k in 0..number as usize {
        let end = |k: usize| from + (to - from) * k as f64 / number;
        halved([end(k), end(k + 1)], poles, DEEPEST, points);
    }
}

/// A panel no longer than twice its distance from any pole; else both its halves.
fn halved([from, to]: [f64; 2], poles: &[Pole], deepest: usize, points: &mut Vec<[f64; 2]>) {
    let half = 0.5 * (to - from);
    let apart = |&[at, beside]: &Pole| (from - at).max(at - to).max(0.0).hypot(beside);
    if deepest > 0 && poles.iter().any(|pole| apart(pole) < half) {
        let middle = from + half;
        halved([from, middle], poles, deepest - 1, points);
        halved([middle, to], poles, deepest - 1, points);
        return;
    }
    points.extend(GAUSS.iter().map(|[x, weight]| [from + half * (1.0 + x), half * weight]));
}
