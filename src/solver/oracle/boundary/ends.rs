//! Where the closed stretches of a contact begin and end under a load: Newton's method from boundary elements.
//!
//! Of M stretches the 2M ends make M moments vanish, carry the load, and leave the surface of every open part between
//! two stretches as far from the profile at its one end as at its other.

use nalgebra::{DMatrix, DVector};

use super::elements::Elements;
use super::{HalfPlane, gap};
use crate::scene::Profile;

/// Elements of the start.
const ELEMENTS: usize = 320;
/// Iterations of Newton's method.
const ITERATIONS: usize = 40;
/// Part of the smallest length between two ends by which one is moved for a derivative.
const MOVED: f64 = 1e-5;
/// Part of it by which an end moves at most in an iteration.
const FARTHEST: f64 = 0.4;
/// Move of the ends, over the whole, at which they are at rest.
const AT_REST: f64 = 1e-13;
/// Move at which an iteration that no longer improves is good enough.
const GOOD: f64 = 1e-9;
/// Part of the largest pressure, and of `P/E*`, that round-off may leave on the wrong side.
const ROUND_OFF: f64 = 1e-9;
/// Places on an open part that are looked at.
const PLACES: usize = 60;

impl HalfPlane {
    /// A profile under a load \[N/mm\], closed somewhere between two places; none where contact reaches them, or what
    /// is found is not a contact: pressed throughout, and open elsewhere.
    pub fn of_load(modulus: f64, profile: Profile, load: f64, within: [f64; 2]) -> Option<Self> {
        let [low, high] = gap::reach(&profile);
        let within = [within[0].max(low), within[1].min(high)];
        let stretches = Elements::pressed(modulus, &profile, load, within, ELEMENTS)?.stretches();
        let start = Self { modulus, profile, stretches };
        start.settled(load).filter(|found| found.is_contact(within))
    }

    /// The same with the ends that carry a load.
    fn settled(mut self, load: f64) -> Option<Self> {
        let number = 2 * self.stretches.len();
        let scale = self.scale();
        let mut before = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let residuals = self.residuals(load, scale);
            let shortest = self.shortest();
            let step = MOVED * shortest;
            let mut derivatives = DMatrix::zeros(number, number);
            for end in 0..number {
                let [ahead, back] = [step, -step].map(|by| self.moved(|k| if k == end { by } else { 0.0 }));
                let slope = (ahead.residuals(load, scale) - back.residuals(load, scale)) / (2.0 * step);
                derivatives.set_column(end, &slope);
            }
            let move_by = derivatives.lu().solve(&residuals)?;
            let farthest = move_by.amax();
            let part = (FARTHEST * shortest / farthest).min(1.0);
            self = self.moved(|k| -part * move_by[k]);
            if farthest <= AT_REST * scale[1] || (farthest <= GOOD * scale[1] && farthest >= 0.5 * before) {
                return Some(self);
            }
            before = farthest;
        }
        None
    }

    /// The same with every end moved.
    fn moved(&self, by: impl Fn(usize) -> f64) -> Self {
        let ends = self.stretches.iter().enumerate();
        let stretches = ends.map(|(k, [begin, end])| [begin + by(2 * k), end + by(2 * k + 1)]).collect();
        Self { stretches, ..self.clone() }
    }

    /// What does not vanish yet, without units.
    fn residuals(&self, load: f64, scale: [f64; 2]) -> DVector<f64> {
        let number = self.stretches.len();
        let mut all = self.moments(number + 1, scale);
        all[number] -= 2.0 * load / (self.modulus * scale[1]);
        all.extend(self.open().map(|part| self.opened(part) / scale[1]));
        DVector::from_vec(all)
    }

    /// Open parts between two stretches.
    fn open(&self) -> impl Iterator<Item = [f64; 2]> {
        self.stretches.windows(2).map(|two| [two[0][1], two[1][0]])
    }

    /// Smallest length between two ends \[mm\].
    pub fn shortest(&self) -> f64 {
        let lengths = self.stretches.iter().copied().chain(self.open());
        lengths.map(|[from, to]| to - from).fold(f64::INFINITY, f64::min)
    }

    /// Whether it is pressed wherever it is closed, and open elsewhere between two places.
    fn is_contact(&self, [from, to]: [f64; 2]) -> bool {
        let pressures: Vec<f64> = self.places().iter().map(|x| self.pressure(*x)).collect();
        let largest = pressures.iter().copied().fold(0.0, f64::max);
        let pressed = pressures.iter().all(|p| *p >= -ROUND_OFF * largest);
        let Some([first, last]) = self.stretches.first().zip(self.stretches.last()).map(|(a, b)| [a[0], b[1]]) else {
            return false;
        };
        pressed
            && self.is_open(first, from)
            && self.is_open(last, to)
            && self.open().all(|[from, to]| self.is_open(from, to))
    }

    /// Whether the surface is open from an end to another place, by the trapezoidal rule.
    fn is_open(&self, from: f64, to: f64) -> bool {
        let at = |k: usize| from + (to - from) * (k as f64 / PLACES as f64).powi(2);
        let (mut opened, mut slope, mut deepest) = (0.0, 0.0, 0.0);
        for k in 1..PLACES {
            let next = self.opening(at(k));
            opened += 0.5 * (slope + next) * (at(k) - at(k - 1));
            slope = next;
            deepest = f64::min(deepest, opened);
        }
        deepest >= -ROUND_OFF * self.load() / self.modulus
    }
}
