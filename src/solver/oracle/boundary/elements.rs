//! Pressures that are linear between equally spaced nodes, and an active set: no series, no ends to be found.
//!
//! Displacement of the surface under a pressure: `u(x) = −(2/πE*) ∫ p(t) ln|x − t| dt` but for a constant (Flamant;
//! Johnson, Contact Mechanics, 1985, §2.8). `oracles/boundary/half_plane.py` is the same for a parabola.

use std::f64::consts::FRAC_2_PI;

use nalgebra::{DMatrix, DVector};

use crate::scene::Profile;

/// Iterations after which the active set should be at rest.
const ITERATIONS: usize = 60;

/// A pressure by its values at nodes, and linear between them.
#[derive(Clone, Debug)]
pub struct Elements {
    /// Nodes, ascending \[mm\].
    pub places: Vec<f64>,
    /// Pressure there \[MPa\], zero where the surface is open.
    pub pressures: Vec<f64>,
}

impl Elements {
    /// A profile pressed on the half-plane by a load \[N/mm\], between two places on so many elements; none where
    /// contact reaches their ends or the active set does not come to rest.
    pub fn pressed(modulus: f64, profile: &Profile, load: f64, [from, to]: [f64; 2], number: usize) -> Option<Self> {
        let step = (to - from) / number as f64;
        let places: Vec<f64> = (0..=number).map(|k| from + step * k as f64).collect();
        let gaps: Vec<f64> = places.iter().map(|x| profile.gap(*x)).collect();
        let hats: Vec<f64> = (0..=number).map(|apart| -FRAC_2_PI / modulus * step * hat(apart as f64)).collect();
        let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        // A rigid profile under the load sinks by P/E* and more, but for a logarithm.
        let mut active: Vec<bool> = gaps.iter().map(|gap| gap - lowest <= 2.0 * load / modulus).collect();
        for _ in 0..ITERATIONS {
            let on: Vec<usize> = (0..=number).filter(|&k| active[k]).collect();
            let last = on.len();
            let matrix = DMatrix::from_fn(last + 1, last + 1, |i, j| match (on.get(i), on.get(j)) {
                (Some(i), Some(j)) => hats[i.abs_diff(*j)],
                (Some(_), None) => -1.0,
                (None, Some(_)) => step * modulus.recip(),
                (None, None) => 0.0,
            });
            let right = DVector::from_fn(last + 1, |i, _| on.get(i).map_or(load / modulus, |&i| -gaps[i]));
            let answer = matrix.lu().solve(&right)?;
            let mut pressures = vec![0.0; number + 1];
            for (k, &i) in on.iter().enumerate() {
                pressures[i] = answer[k];
            }
            let under = |i: usize| on.iter().map(|&j| hats[i.abs_diff(j)] * pressures[j]).sum::<f64>();
            let closed = |i: usize| if active[i] { pressures[i] > 0.0 } else { gaps[i] + under(i) < answer[last] };
            let next: Vec<bool> = (0..=number).map(closed).collect();
            if next == active {
                let is_within = !active[0] && !active[number];
                return is_within.then_some(Self { places, pressures });
            }
            active = next;
        }
        None
    }

    /// Where the closed stretches begin and end: near an end `p²` is linear \[mm\].
    pub fn stretches(&self) -> Vec<[f64; 2]> {
        let pressed = |k: usize| self.pressures[k] > 0.0;
        let step = self.places[1] - self.places[0];
        let beyond = |last: usize, before: usize| {
            let [p, q] = [last, before].map(|k| self.pressures[k].powi(2));
            step * if q > p { (p / (q - p)).min(1.0) } else { 0.5 }
        };
        let mut stretches = Vec::new();
        for k in 1..self.places.len() - 1 {
            if pressed(k) && !pressed(k - 1) {
                stretches.push([self.places[k] - beyond(k, k + 1), f64::NAN]);
            }
            if let Some(last) = stretches.last_mut().filter(|_| pressed(k) && !pressed(k + 1)) {
                last[1] = self.places[k] + beyond(k, k - 1);
            }
        }
        stretches
    }

    /// `∫ p ds`, `∫ p s ds` and `∫ p s² ds`, of linear pressures exactly \[N/mm, N, N mm\].
    pub fn resultants(&self) -> [f64; 3] {
        let step = self.places[1] - self.places[0];
        let mut sums = [0.0; 3];
        for (x, p) in self.places.iter().zip(&self.pressures) {
            sums[0] += step * p;
            sums[1] += step * p * x;
            sums[2] += step * p * (x * x + step * step / 6.0);
        }
        sums
    }
}

/// `∫ ln|s − t| (1 − |t|)⁺ dt`, but for a constant that a rigid motion takes.
fn hat(s: f64) -> f64 {
    [(-1.0, 1.0), (0.0, -2.0), (1.0, 1.0)].iter().map(|(shift, weight)| weight * twice(s + shift)).sum()
}

/// Second antiderivative of `ln|s|`: `s²/2 ln|s| − 3s²/4`.
fn twice(s: f64) -> f64 {
    if s.abs() > 0.0 { 0.5 * s * s * s.abs().ln() - 0.75 * s * s } else { 0.0 }
}
