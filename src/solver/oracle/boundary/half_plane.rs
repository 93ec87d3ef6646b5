//! A rigid profile on a half-plane, closed on given stretches: pressure, resultants, opening, and the stresses below.
//!
//! With `Φ(ζ) = ∫ p ds/(s − ζ)`, which jumps by `2πi p` across the contact L and whose mean there is `−πE* g'/2`, and
//! `X(ζ) = Π √(ζ − b_k) √(ζ − e_k)` over the stretches `b_k…e_k`, the pressure that vanishes at every end is that of
//!
//! `Φ(ζ) = (E*/2) X(ζ) I(ζ)`, `I(ζ) = Σ_k σ_k ∫ g'(t) / (|X(t)| (t − ζ)) dt`, `σ_k = (−1)^{stretches to the right}`
//!
//! (N. I. Muskhelishvili, Singular Integral Equations, 1953, ch. 11; of one stretch it is Glauert's series). It is a
//! solution where the moments `Σ σ_k ∫ g' t^j/|X| dt` vanish for all j below the number of stretches; the next one is
//! 2P/E*.

use std::f64::consts::{FRAC_2_PI, PI};

use nalgebra::Complex;

use super::{gap, quadrature};
use crate::oracle::analytic::top;
use crate::scene::Profile;

/// A search for the largest pressure looks at so many places on 0.2 rad of a stretch, and at least on a part between
/// two breaks.
const PLACES: [f64; 2] = [8.0, 2.0];
/// Angle within which a place is that of a break \[rad\].
const SAME: f64 = 1e-9;

/// A contact of the half-plane.
#[derive(Clone, Debug)]
pub struct HalfPlane {
    /// Contact modulus `E*` \[MPa\].
    pub modulus: f64,
    /// The gap, over both signs of s.
    pub profile: Profile,
    /// Where its closed stretches begin and end, ascending \[mm\].
    pub stretches: Vec<[f64; 2]>,
}

/// Where the distance from the middle of a stretch is measured from, and half its length.
fn about([begin, end]: [f64; 2]) -> [f64; 2] {
    [0.5 * (begin + end), 0.5 * (end - begin)]
}

impl HalfPlane {
    /// `X` at a place beside the contact.
    fn root(&self, z: Complex<f64>) -> Complex<f64> {
        self.stretches.iter().flatten().map(|end| (z - end).sqrt()).product()
    }

    /// `|X|` of all stretches but one.
    fn other_roots(&self, own: usize, t: f64) -> f64 {
        let others = self.stretches.iter().enumerate().filter(|(k, _)| *k != own);
        others.map(|(_, [begin, end])| ((t - begin) * (t - end)).abs().sqrt()).product()
    }

    /// `σ_k`.
    fn sign(&self, stretch: usize) -> f64 {
        if (self.stretches.len() - stretch) % 2 == 1 { 1.0 } else { -1.0 }
    }

    /// Points t and weights of `Σ σ_k ∫ … dt/|X|`, closer towards a place; a place within a smooth part of the contact
    /// needs none there.
    fn points(&self, near: Option<Complex<f64>>) -> Vec<[f64; 2]> {
        let breaks = gap::breaks(&self.profile);
        let mut all = Vec::new();
        let mut angles = Vec::new();
        for (k, &stretch) in self.stretches.iter().enumerate() {
            let [centre, half] = about(stretch);
            let angle = |x: f64| ((x - centre) / half).clamp(-1.0, 1.0).acos();
            let mut parts = vec![0.0];
            parts.extend(breaks.iter().rev().filter(|x| (**x - centre).abs() < half).map(|x| angle(*x)));
            parts.push(PI);
            let ends = self.stretches.iter().enumerate().filter(|(other, _)| *other != k);
            let mut poles: Vec<_> = ends.flat_map(|(_, ends)| ends.map(|x| beside(x.into(), stretch))).collect();
            let inside = near.filter(|z| z.im <= 0.0 && (z.re - centre).abs() <= half).map(|z| angle(z.re));
            poles.extend(near.map(|z| beside(z, stretch)));
            angles.clear();
            for part in parts.windows(2) {
                let own = inside.is_some_and(|at| part[0] - SAME <= at && at <= part[1] + SAME);
                let poles = if own { &poles[..poles.len() - 1] } else { &poles };
                quadrature::panels([part[0], part[1]], poles, &mut angles);
            }
            let sign = self.sign(k);
            all.extend(angles.iter().map(|[theta, weight]| {
                let t = centre + half * theta.cos();
                [t, sign * weight / self.other_roots(k, t)]
            }));
        }
        all
    }

    /// `Σ σ_k ∫ g' t^j / |X| dt` for the first powers j, t measured from one place in units of a length.
    pub(super) fn moments(&self, number: usize, [centre, length]: [f64; 2]) -> Vec<f64> {
        let mut moments = vec![0.0; number];
        // |X| has the unit of as many lengths as there are stretches, one of which dt takes.
        let unit = length.powi(self.stretches.len() as i32 - 1);
        for [t, weight] in self.points(None) {
            let mut term = unit * weight * gap::slope(&self.profile, t);
            for moment in &mut moments {
                *moment += term;
                term *= (t - centre) / length;
            }
        }
        moments
    }

    /// `∫ p ds`, `∫ p s ds` and `∫ p s² ds` \[N/mm, N, N mm\]: what Φ is far away.
    pub fn resultants(&self) -> [f64; 3] {
        let (number, scale) = (self.stretches.len(), self.scale());
        let [centre, length] = scale;
        let moments = self.moments(number + 3, scale);
        let ends = || self.stretches.iter().flatten().map(|end| (end - centre) / length);
        let [first, second] = [ends().sum::<f64>(), ends().map(|x| x * x).sum::<f64>()];
        // X = ζ^M (1 − S₁/2ζ + (S₁²/8 − S₂/4)/ζ² …), S_j = Σ b^j + e^j.
        let [x, y] = [-0.5 * first, 0.125 * first * first - 0.25 * second];
        let [m, n, o] = [moments[number], moments[number + 1], moments[number + 2]];
        let [force, moment, square] = [m, n + x * m, o + x * n + y * m].map(|part| 0.5 * self.modulus * length * part);
        let turned = moment * length + force * centre;
        [force, turned, square * length * length + 2.0 * centre * turned - force * centre * centre]
    }

    /// Middle and half the length of the whole.
    pub(super) fn scale(&self) -> [f64; 2] {
        let [first, last] = [self.stretches.first(), self.stretches.last()];
        first.zip(last).map_or([f64::NAN; 2], |(first, last)| about([first[0], last[1]]))
    }

    /// Full load per unit length \[N/mm\].
    pub fn load(&self) -> f64 {
        self.resultants()[0]
    }

    /// Centre of pressure `∫p s/∫p` and half-width by second moment about it, `2 √(∫p (s − c)²/∫p)` \[mm\].
    pub fn centre_and_width(&self) -> [f64; 2] {
        let [force, moment, square] = self.resultants();
        let centre = moment / force;
        [centre, 2.0 * (square / force - centre * centre).sqrt()]
    }

    /// Pressure at `x` \[MPa\], zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        let Some(own) = self.stretches.iter().position(|[begin, end]| *begin < x && x < *end) else { return 0.0 };
        let slope = gap::slope(&self.profile, x);
        let [begin, end] = self.stretches[own];
        // The integral of 1/(|X| (t − x)) over all stretches vanishes.
        let integral: f64 = (self.points(Some(x.into())).into_iter())
            .map(|[t, weight]| weight * (gap::slope(&self.profile, t) - slope) / (t - x))
            .sum();
        let root = ((x - begin) * (end - x)).sqrt() * self.other_roots(own, x);
        0.5 * self.modulus / PI * self.sign(own) * root * integral
    }

    /// Places that see all there is of the pressure, ascending \[mm\].
    pub fn places(&self) -> Vec<f64> {
        let breaks = gap::breaks(&self.profile);
        let mut places = Vec::new();
        for &[begin, end] in &self.stretches {
            let [centre, half] = about([begin, end]);
            let mut parts = vec![begin];
            parts.extend(breaks.iter().filter(|x| begin < **x && **x < end));
            parts.push(end);
            for part in parts.windows(2) {
                let [from, to] = [0, 1].map(|k| ((part[k] - centre) / half).clamp(-1.0, 1.0).acos());
                let number = (PLACES[0] * (from - to) / 0.2).max(PLACES[1]).ceil();
                let at = |k: usize| from + (to - from) * k as f64 / number;
                places.extend((0..number as usize).map(|k| centre + half * at(k).cos()));
            }
            places.push(end);
        }
        places
    }

    /// Largest pressure \[MPa\], and where it lies \[mm\]: the best of many places, then a golden section.
    pub fn peak(&self) -> [f64; 2] {
        let places = self.places();
        let found: Vec<f64> = places.iter().map(|x| self.pressure(*x)).collect();
        let Some(best) = (0..found.len()).max_by(|&a, &b| found[a].total_cmp(&found[b])) else { return [f64::NAN; 2] };
        let around = [places[best.saturating_sub(1)], places[(best + 1).min(places.len() - 1)]];
        let inside = top(around, |x| self.pressure(x));
        let value = self.pressure(inside);
        // Where it has a kink itself, or is as high all along.
        if value > found[best] { [value, inside] } else { [found[best], places[best]] }
    }

    /// `Φ` and its derivative at `ζ` beside the contact.
    fn potential(&self, z: Complex<f64>) -> [Complex<f64>; 2] {
        let [mut integral, mut derivative] = [Complex::new(0.0, 0.0); 2];
        for [t, weight] in self.points(Some(z)) {
            let distance = (Complex::from(t) - z).inv();
            let term = distance * (weight * gap::slope(&self.profile, t));
            integral += term;
            derivative += term * distance;
        }
        let root = self.root(z);
        let steepness: Complex<f64> = self.stretches.iter().flatten().map(|end| (z - end).inv()).sum();
        let scale = 0.5 * self.modulus;
        [root * integral * scale, root * (steepness * 0.5 * integral + derivative) * scale]
    }

    /// Slope of the opening at `x` outside the contact, `h' = g' + 2Φ/πE*`.
    pub fn opening(&self, x: f64) -> f64 {
        let [potential, _] = self.potential(x.into());
        gap::slope(&self.profile, x) + FRAC_2_PI / self.modulus * potential.re
    }

    /// How much farther open the surface is at the end of an open part than at its beginning \[mm\].
    pub fn opened(&self, [from, to]: [f64; 2]) -> f64 {
        let [centre, half] = about([from, to]);
        let mut angles = Vec::new();
        quadrature::panels([0.0, PI], &[], &mut angles);
        let lowered = |&[theta, weight]: &[f64; 2]| {
            let (sin, cos) = theta.sin_cos();
            weight * half * sin * self.potential((centre + half * cos).into())[0].re
        };
        let sum: f64 = angles.iter().map(lowered).sum();
        let risen = self.profile.gap(to) - self.profile.gap(from);
        risen + FRAC_2_PI / self.modulus * sum
    }

    /// Stresses `[σ_x, σ_z, τ_xz]` \[MPa\] in the half-plane; `x` right, `z ≥ 0` into the body \[mm\], tension
    /// positive.
    ///
    /// Flamant's solution, integrated:
    ///
    /// * `σ_x + σ_z = −(2/π) Im Φ`,
    /// * `σ_z − σ_x = (2/π) z Re Φ'`,
    /// * `τ_xz = (1/π) z Im Φ'`.
    pub fn stress(&self, x: f64, z: f64) -> [f64; 3] {
        let [potential, derivative] = self.potential(Complex::new(x, z));
        let sum = -FRAC_2_PI * potential.im;
        let [difference, shear] = [FRAC_2_PI * z * derivative.re, z / PI * derivative.im];
        [0.5 * (sum - difference), 0.5 * (sum + difference), shear]
    }
}

/// A place as it lies beside a stretch: with `ζ = c + a cos(θ + iη)`.
fn beside(z: Complex<f64>, stretch: [f64; 2]) -> quadrature::Pole {
    let [centre, half] = about(stretch);
    let [x, y] = [(z.re - centre) / half, z.im / half];
    let cosh = 0.5 * ((x + 1.0).hypot(y) + (x - 1.0).hypot(y)).max(2.0);
    [(x / cosh).clamp(-1.0, 1.0).acos(), cosh.acosh()]
}
