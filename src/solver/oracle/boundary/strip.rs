//! Layers and rows: surfaces that differ from that of the half-plane by a smooth kernel.
//!
//! A pressure moves the surface by `u(x) = (2/πE*) ∫ p(t) G(x − t) dt`, and `G(y) + ln|y|` is smooth:
//!
//! * a layer of thickness h: `G = ∫₀^∞ F(q)/q cos(qy/h) dq`, with `F = (cosh 2q − 1)/(sinh 2q + 2q)` on a smooth base
//!   and `F = (2κ sinh 2q − 4q)/(2κ cosh 2q + 1 + κ² + 4q²)`, `κ = 3 − 4ν`, where it is bonded (Johnson, Contact
//!   Mechanics, 1985, §5.8); `∫ tanh q/q cos(qy/h) dq = −ln tanh(πy/4h)` has the same logarithm;
//! * a row of contacts, one in every period λ: `G = −ln|2 sin(πy/λ)|`, but for the mean (Westergaard, 1939).
//!
//! The pressure that vanishes at both ends is `p = Σ c_k sin (2k + 1)ψ`, `s = a cos ψ`.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

use nalgebra::{DMatrix, DVector};

use super::{quadrature, ring};
use crate::scene::Profile;

/// Polynomials of the pressure.
const TERMS: usize = 32;
/// Points of the quadrature over the contact.
const POINTS: usize = 256;
/// q beyond which F is that of the half-plane: e^−40.
const FARTHEST: f64 = 20.0;
/// Places that are looked at on the contact.
const PLACES: usize = 200;
/// Places that are looked at beyond it, where the surface takes a quadrature each.
const BEYOND: usize = 40;
/// Iterations of Newton's method for the top.
const ITERATIONS: usize = 8;

/// What lies below the surface.
#[derive(Clone, Copy, Debug)]
pub enum Strip {
    /// A layer of a thickness on a base without friction.
    Sliding(f64),
    /// The same bonded to its base: thickness and Poisson's ratio.
    Bonded(f64, f64),
    /// A half-plane with a contact in every period.
    Row(f64),
}

/// The contact of a strip with an even profile.
#[derive(Clone, Debug)]
pub struct OnStrip {
    /// Half-width a \[mm\].
    pub half_width: f64,
    /// `c_k` \[MPa\].
    pub terms: Vec<f64>,
    /// How far the profile is pressed in at s = 0; of a row from the mean of its surface \[mm\].
    pub approach: f64,
}

impl Strip {
    /// F, which tends to 1.
    fn transform(self, q: f64) -> f64 {
        let (sinh, cosh) = ((2.0 * q).sinh(), (2.0 * q).cosh());
        match self {
            Self::Sliding(_) => (cosh - 1.0) / (sinh + 2.0 * q),
            Self::Bonded(_, poisson) => {
                let kappa = 3.0 - 4.0 * poisson;
                (2.0 * kappa * sinh - 4.0 * q) / (2.0 * kappa * cosh + 1.0 + kappa * kappa + 4.0 * q * q)
            }
            Self::Row(_) => 1.0,
        }
    }

    /// `G(y) + ln|y|`.
    fn smooth(self, y: f64, points: &[[f64; 2]]) -> f64 {
        let ratio = |of: fn(f64) -> f64, z: f64| if z > 0.0 { of(z) / z } else { 1.0 };
        match self {
            Self::Row(period) => {
                let z = PI * y.abs() / period;
                -(2.0 * PI / period * ratio(f64::sin, z)).ln()
            }
            Self::Sliding(thickness) | Self::Bonded(thickness, _) => {
                let z = 0.25 * PI * y.abs() / thickness;
                let rest: f64 = points.iter().map(|[q, weight]| weight * (q * y / thickness).cos()).sum();
                rest - (0.25 * PI / thickness * ratio(f64::tanh, z)).ln()
            }
        }
    }

    /// Points and weights of `∫ (F − tanh q)/q … dq`.
    fn points(self) -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        quadrature::panels([0.0, FARTHEST], &[], &mut points);
        points.into_iter().map(|[q, weight]| [q, weight * (self.transform(q) - q.tanh()) / q]).collect()
    }

    /// The contact of a half-width \[mm\] with an even profile; none where it is not pressed all over, or not open
    /// beyond, up to a place.
    pub fn pressed(self, modulus: f64, profile: &Profile, half_width: f64, open_to: f64) -> Option<OnStrip> {
        let (a, points) = (half_width, self.points());
        let moved = |x: f64| -> Vec<f64> {
            let smooth = |i: usize| {
                let psi = PI * (i as f64 + 0.5) / POINTS as f64;
                (psi, psi.sin() * self.smooth(x - a * psi.cos(), &points))
            };
            let rest: Vec<(f64, f64)> = (0..POINTS).map(smooth).collect();
            let of = |k: usize| {
                let own: f64 = rest.iter().map(|(psi, value)| value * ((2 * k + 1) as f64 * psi).sin()).sum();
                let whole = if k == 0 { FRAC_PI_2 * a.ln() } else { 0.0 };
                let logarithm = ring::under_logarithm(k, x.abs() / a) + whole;
                FRAC_2_PI / modulus * a * (own * PI / POINTS as f64 - logarithm)
            };
            (0..TERMS).map(of).collect()
        };
        let place = |i: usize| a * (FRAC_PI_2 * (i as f64 + 0.5) / (TERMS + 1) as f64).cos();
        let rows: Vec<Vec<f64>> = (0..=TERMS).map(|i| moved(place(i))).collect();
        let matrix = DMatrix::from_fn(TERMS + 1, TERMS + 1, |i, k| rows[i].get(k).copied().unwrap_or(-1.0));
        let right = DVector::from_fn(TERMS + 1, |i, _| -profile.gap(place(i)));
        let answer = matrix.lu().solve(&right)?;
        let found =
            OnStrip { half_width, terms: answer.iter().take(TERMS).copied().collect(), approach: answer[TERMS] };
        let open = |k: usize| {
            let x = a + (open_to - a) * (k as f64 + 1.0) / BEYOND as f64;
            let under: f64 = moved(x).iter().zip(&found.terms).map(|(value, term)| value * term).sum();
            profile.gap(x) + under - found.approach >= 0.0
        };
        let pressed = |k: usize| found.pressure(a * k as f64 / PLACES as f64) > 0.0;
        ((0..PLACES).all(pressed) && (0..BEYOND).all(open)).then_some(found)
    }
}

impl OnStrip {
    /// `Σ c_k (2k + 1)^n` times a sine or cosine of `(2k + 1)ψ`.
    fn sum(&self, power: i32, of: impl Fn(f64) -> f64) -> f64 {
        let terms = self.terms.iter().enumerate();
        terms.map(|(k, c)| ((2 * k + 1) as f64, c)).map(|(m, c)| c * m.powi(power) * of(m)).sum()
    }

    /// Pressure at a place \[MPa\].
    pub fn pressure(&self, s: f64) -> f64 {
        let y = s / self.half_width;
        if y.abs() >= 1.0 { 0.0 } else { self.sum(0, |m| (m * y.acos()).sin()) }
    }

    /// Force on the whole contact \[N/mm\]: `πa c₀/2`.
    pub fn load(&self) -> f64 {
        FRAC_PI_2 * self.half_width * self.terms[0]
    }

    /// `2 √(∫p s²/∫p)` \[mm\]: `a √(1 + c₁/c₀)`.
    pub fn second_moment(&self) -> f64 {
        self.half_width * (1.0 + self.terms[1] / self.terms[0]).sqrt()
    }

    /// Largest pressure \[MPa\], and where it lies \[mm\]: the best of many places, then Newton's method.
    pub fn peak(&self) -> [f64; 2] {
        let angle = |k: usize| FRAC_PI_2 * k as f64 / PLACES as f64;
        let at = |psi: f64| self.sum(0, |m| (m * psi).sin());
        let best = (0..=PLACES).max_by(|&k, &l| at(angle(k)).total_cmp(&at(angle(l)))).unwrap_or(PLACES);
        let mut psi = angle(best);
        for _ in 0..ITERATIONS {
            let [slope, bend] = [self.sum(1, |m| (m * psi).cos()), -self.sum(2, |m| (m * psi).sin())];
            psi = (psi - slope / bend).clamp(angle(best.saturating_sub(1)), FRAC_PI_2);
        }
        let place = if best == PLACES { 0.0 } else { self.half_width * psi.cos() };
        [self.pressure(place), place]
    }
}
