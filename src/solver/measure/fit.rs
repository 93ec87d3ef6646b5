//! Polynomials of any degree through pressures, by least squares: over the means of pairs of edges, or over points.
//!
//! A mean is taken for what it is: `c_k` of `Σ c_k s^k` contributes the mean of `s^k` over both edges, not its value in
//! the middle; over rings of a body of revolution weighted by the radius.

use std::ops::RangeInclusive;

use nalgebra::{DMatrix, DVector};

use crate::solution::{EdgeState, PointState};

/// A pressure and where it is.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Peak {
    /// Contact coordinate \[mm, or rad on an arc\].
    pub position: f64,
    /// Pressure there \[MPa\].
    pub pressure: f64,
}

/// Part of a pressure that rounding explains: a uniform one has its top anywhere.
pub(super) const ROUNDING: f64 = 1e-9;

/// Most coefficients of a polynomial.
const MOST: usize = 9;

/// A polynomial in `x = (s − centre)/width` over some pairs of edges.
pub(super) struct Fit {
    coefficients: Vec<f64>,
    centre: f64,
    width: f64,
    /// The middles of its first and last pair, as x, beyond which it extrapolates; the end of the surface where the
    /// contact goes on to that.
    within: [f64; 2],
    /// Root mean square of what its means depart from it \[MPa\].
    pub(super) misfit: f64,
}

impl Fit {
    /// Least squares with so many coefficients over the means of some pairs, weighted by their lengths.
    pub(super) fn of_means(pairs: &[EdgeState], own: RangeInclusive<usize>, count: usize) -> Self {
        let taken = &pairs[own.clone()];
        let (from, to) = (taken[0].ends[0], taken[taken.len() - 1].ends[1]);
        let (centre, width) = (0.5 * (from + to), 0.5 * (to - from));
        let scaled = |s: f64| (s - centre) / width;
        let row_of = |pair: &EdgeState| {
            let [a, b] = pair.ends.map(scaled);
            let mean = |k: i32| match pair.axis {
                Some(axis) => mean_of_power_over_ring([a, b], scaled(axis), k),
                None => mean_of_power(a, b, k),
            };
            (b - a, powers(count, mean), pair.pressure)
        };
        let (coefficients, misfit) = least_squares(count, taken.iter().map(row_of));
        let [first, last] = [taken[0].position(), taken[taken.len() - 1].position()].map(scaled);
        let [begins, ends] = [*own.start() == 0, *own.end() + 1 == pairs.len()];
        let within = [if begins { -1.0 } else { first }, if ends { 1.0 } else { last }];
        Self { coefficients, centre, width, within, misfit }
    }

    /// The same over the pressures of some points, weighted by their areas.
    pub(super) fn of_points(points: &[PointState], count: usize) -> Self {
        let (from, to) = (points[0].position, points[points.len() - 1].position);
        let (centre, width) = (0.5 * (from + to), 0.5 * (to - from).abs());
        let row_of = |point: &PointState| {
            let x = (point.position - centre) / width;
            (point.weight, powers(count, |k| x.powi(k)), point.pressure)
        };
        let (coefficients, misfit) = least_squares(count, points.iter().map(row_of));
        Self { coefficients, centre, width, within: [-1.0, 1.0], misfit }
    }

    fn at(&self, x: f64) -> f64 {
        self.coefficients.iter().rev().fold(0.0, |sum, c| c + sum * x)
    }

    /// Value at a contact coordinate; none beyond its edges.
    pub(super) fn value(&self, s: f64) -> Option<f64> {
        let x = (s - self.centre) / self.width;
        (x.abs() <= 1.0 + ROUNDING).then(|| self.at(x))
    }

    /// The highest point between the middles of its outermost pairs: the best of a fine grid, then Newton's method on
    /// the slope.
    pub(super) fn top(&self) -> Peak {
        const GRID: usize = 64;
        let [from, to] = self.within;
        let place = |k: usize| from + (to - from) * k as f64 / GRID as f64;
        let best = (0..=GRID).max_by(|&a, &b| self.at(place(a)).total_cmp(&self.at(place(b)))).unwrap_or(0);
        let mut x = place(best);
        if best > 0 && best < GRID {
            for _ in 0..8 {
                let [slope, bend] = [1, 2].map(|order| self.derivative(x, order));
                let next = x - slope / bend;
                if !next.is_finite() || (next - place(best)).abs() > (to - from) / GRID as f64 {
                    break;
                }
                x = next;
            }
        }
        Peak { position: self.centre + self.width * x, pressure: self.at(x) }
    }

    /// Where it vanishes, by Newton's method from a contact coordinate; no number where it does not.
    pub(super) fn root(&self, from: f64) -> f64 {
        let mut x = (from - self.centre) / self.width;
        for _ in 0..8 {
            x -= self.at(x) / self.derivative(x, 1);
        }
        self.centre + self.width * x
    }

    fn derivative(&self, x: f64, order: usize) -> f64 {
        let mut coefficients = self.coefficients.clone();
        for _ in 0..order {
            coefficients = coefficients.iter().enumerate().skip(1).map(|(k, c)| k as f64 * c).collect();
        }
        coefficients.iter().rev().fold(0.0, |sum, c| c + sum * x)
    }
}

/// Coefficients of a polynomial by least squares over (weight, powers, value), and the root mean square of what
/// remains.
pub(super) fn least_squares(
    count: usize,
    rows: impl ExactSizeIterator<Item = (f64, [f64; MOST], f64)> + Clone,
) -> (Vec<f64>, f64) {
    let (mut normal, mut rhs) = ([[0.0; MOST]; MOST], [0.0; MOST]);
    for (weight, row, value) in rows.clone() {
        for i in 0..count {
            (0..count).for_each(|j| normal[i][j] += row[i] * row[j] * weight);
            rhs[i] += row[i] * (value * weight);
        }
    }
    let normal = DMatrix::from_fn(count, count, |i, j| normal[i][j]).lu();
    let solved = normal.solve(&DVector::from_fn(count, |i, _| rhs[i]));
    let solved = solved.unwrap_or_else(|| DVector::from_element(count, f64::NAN));
    let freedom = rows.len().saturating_sub(count).max(1) as f64;
    let value_of = |row: &[f64; MOST]| row.iter().zip(&solved).map(|(x, c)| x * c).sum::<f64>();
    let squares = rows.map(|(_, row, value)| (value_of(&row) - value).powi(2));
    let misfit = (squares.sum::<f64>() / freedom).sqrt();
    (solved.iter().copied().collect(), misfit)
}

/// So many powers from the zeroth on; zeros behind.
pub(super) fn powers(count: usize, of: impl Fn(i32) -> f64) -> [f64; MOST] {
    std::array::from_fn(|k| if k < count { of(k as i32) } else { 0.0 })
}

/// Mean of `x^k` over an interval.
fn mean_of_power(a: f64, b: f64, k: i32) -> f64 {
    (b.powi(k + 1) - a.powi(k + 1)) / (f64::from(k + 1) * (b - a))
}

/// Mean `∫ x^k |x − c| dx / ∫ |x − c| dx` over an interval, c the place of the axis.
fn mean_of_power_over_ring([a, b]: [f64; 2], axis: f64, k: i32) -> f64 {
    let outwards = |from: f64, to: f64, k: i32| {
        let term = |k: i32| (to.powi(k + 1) - from.powi(k + 1)) / f64::from(k + 1);
        term(k + 1) - axis * term(k)
    };
    let split = axis.clamp(a, b);
    let integral = |k: i32| outwards(split, b, k) - outwards(a, split, k);
    integral(k) / integral(0)
}
