//! A half-space pressed by a rigid profile of revolution.
//!
//! The transform `w(t) = t ∫₀ᵗ g'(r) dr/√(t² − r²)` of the profile g gives, of the contact `r ≤ a` (Sneddon 1965; Popov
//! and Heß, Method of Dimensionality Reduction, 2015, §3), the approach `δ = w(a)`, the load `F = 2E* ∫₀ᵃ t w'(t) dt`
//! and the pressure `p = (E*/π) ∫ᵣᵃ w'(t) dt/√(t² − r²)`. A punch that ends at `a` may be pressed deeper, by e: then
//! `δ = w(a) + e`, and `2E*ae` and `E*e/π√(a² − r²)` are added.

use std::f64::consts::{PI, TAU};

use libm::lgamma;
use nalgebra::Complex;

use super::half_space::Potential;
use crate::oracle::analytic::{Parameter, answer, finite, grown_to, largest, non_negative, positive};
use crate::oracle::boundary::quadrature::panels;
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Contact of the profile `g = Σ c rⁿ`, n > 0, with a half-space.
#[derive(Debug, Clone, PartialEq)]
pub struct Indentation {
    /// Contact modulus `E*` \[MPa\].
    pub modulus: f64,
    /// Radius of the contact `a` \[mm\].
    pub radius: f64,
    /// `[c, n]` of every term, lengths in mm.
    pub powers: Vec<[f64; 2]>,
    /// Part `e` of the approach that a punch with an edge is pressed beyond contact up to that edge \[mm\]; else zero.
    pub beyond: f64,
}

impl Indentation {
    /// A profile without an edge, in contact up to a radius \[mm\].
    pub fn smooth(modulus: f64, radius: f64, powers: Vec<[f64; 2]>) -> Self {
        Self { modulus, radius, powers, beyond: 0.0 }
    }

    /// The same under a load \[N\] that makes a radius between `low` and `high` \[mm\], where the load grows with the
    /// radius.
    pub fn of_load(load: f64, modulus: f64, powers: &[[f64; 2]], between: [f64; 2]) -> Self {
        let of = |radius| Self::smooth(modulus, radius, powers.to_vec());
        of(grown_to(load, between, |radius| of(radius).load()))
    }

    /// A flat punch with a sharp edge, `e = F/2E*a` (Boussinesq 1885).
    pub fn flat(modulus: f64, radius: f64, load: f64) -> Self {
        Self { modulus, radius, powers: vec![], beyond: load / (2.0 * modulus * radius) }
    }

    /// The circle `g = R − √(R² − r²)`, as so many even powers: `c₁ = 1/2R`, `c_{k+1} = c_k (2k − 1)/(2k + 2)R²`.
    pub fn circle(radius: f64, terms: usize) -> Vec<[f64; 2]> {
        let first = [0.5 / radius, 2.0];
        let next = |[c, n]: &[f64; 2]| Some([c * (n - 1.0) / ((n + 2.0) * radius * radius), n + 2.0]);
        std::iter::successors(Some(first), next).take(terms).collect()
    }

    /// `b` and `n` of `w = Σ b tⁿ`.
    ///
    /// `b = c √π Γ(n/2 + 1)/Γ(n/2 + 1/2)`: twice c of a paraboloid, π/2 of it of a cone.
    fn transformed(&self) -> impl Iterator<Item = [f64; 2]> {
        let ratio = |n: f64| (lgamma(0.5 * n + 1.0) - lgamma(0.5 * n + 0.5)).exp();
        self.powers.iter().map(move |&[c, n]| [c * PI.sqrt() * ratio(n), n])
    }

    /// Approach `δ` \[mm\].
    pub fn approach(&self) -> f64 {
        self.beyond + self.transformed().map(|[b, n]| b * self.radius.powf(n)).sum::<f64>()
    }

    /// Load `F = 2E* [ae + Σ b n aⁿ⁺¹/(n + 1)]` \[N\].
    pub fn load(&self) -> f64 {
        let terms = self.transformed().map(|[b, n]| b * n / (n + 1.0) * self.radius.powf(n + 1.0));
        2.0 * self.modulus * (self.radius * self.beyond + terms.sum::<f64>())
    }

    /// Radius by second moment, `√(5/2 ∫p r² dA/F)` with `∫p r² dA = (4E*/3) [a³e + Σ b n aⁿ⁺³/(n + 3)]`; a
    /// paraboloid's is a \[mm\].
    pub fn second_moment_radius(&self) -> f64 {
        let terms = self.transformed().map(|[b, n]| b * n / (n + 3.0) * self.radius.powf(n + 3.0));
        let moment = 4.0 / 3.0 * self.modulus * (self.radius.powi(3) * self.beyond + terms.sum::<f64>());
        (2.5 * moment / self.load()).sqrt()
    }

    /// Pressure at `r` \[MPa\], zero outside the contact; infinite at a sharp edge, and at the tip where an n is at
    /// most 1.
    pub fn pressure(&self, r: f64) -> f64 {
        let (a, r) = (self.radius, r.abs());
        if r > a {
            return 0.0;
        }
        let edge = if self.beyond > 0.0 { self.beyond / ((a - r) * (a + r)).sqrt() } else { 0.0 };
        let terms = self.transformed().map(|[b, n]| b * n * a.powf(n - 1.0) * abel(n, r / a));
        self.modulus / PI * (edge + terms.sum::<f64>())
    }

    /// Largest pressure, wherever it lies \[MPa\]; infinite where there is an edge or a tip.
    pub fn peak_pressure(&self) -> f64 {
        if self.beyond > 0.0 || self.powers.iter().any(|[_, n]| *n <= 1.0) {
            return f64::INFINITY;
        }
        self.pressure(largest([self.radius, 0.0], |r| self.pressure(r)))
    }

    /// The potential below the contact, `(E*/π) [∫₀ᵃ w'(t) f_t dt + e f_a]` with that of flat punches of radius t;
    /// `z > 0` \[mm\].
    pub fn potential(&self, r: f64, z: f64) -> Potential {
        let terms: Vec<[f64; 2]> = self.transformed().collect();
        // With t = a sin θ. The potentials have a pole at t = r + iz, and w' of a broken power one at zero.
        let pole = Complex::new(r / self.radius, z / self.radius).asin();
        let tip = terms.iter().any(|[_, n]| n.fract() > 0.0).then_some([0.0, 0.0]);
        let poles: Vec<[f64; 2]> = [[pole.re, pole.im]].into_iter().chain(tip).collect();
        let mut points = vec![];
        panels([0.0, 0.25 * TAU], &poles, &mut points);
        let edge = Potential::flat(self.radius, r, z).times(self.beyond);
        let sum = points.iter().fold(edge, |sum, [angle, weight]| {
            let t = self.radius * angle.sin();
            let slope: f64 = terms.iter().map(|[b, n]| b * n * t.powf(n - 1.0)).sum();
            sum.with(Potential::flat(t, r, z).times(slope * self.radius * angle.cos() * weight))
        });
        sum.times(self.modulus / PI)
    }
}

/// `A_n = ∫_s^1 t^{n−1} dt/√(t² − s²)`: `√(1 − s²)` for n = 2, by quadrature for n < 2, and from there by
/// `(n − 1) A_n = √(1 − s²) + (n − 2) s² A_{n−2}`.
fn abel(n: f64, s: f64) -> f64 {
    if s <= 0.0 {
        return if n > 1.0 { 1.0 / (n - 1.0) } else { f64::INFINITY };
    }
    let root = ((1.0 - s) * (1.0 + s)).sqrt();
    let steps = (0.5 * n - 1.0).ceil().max(0.0);
    let least = n - 2.0 * steps;
    let mut value = root;
    if least < 2.0 {
        // t = s cosh θ.
        let mut points = vec![];
        panels([0.0, (root / s).asinh()], &[], &mut points);
        value = points.iter().map(|[angle, weight]| weight * (s * angle.cosh()).powf(least - 1.0)).sum();
    }
    for k in 1..=steps as usize {
        let n = least + 2.0 * k as f64;
        value = (root + (n - 2.0) * s * s * value) / (n - 1.0);
    }
    value
}

/// Largest power: its pressure takes half as many steps.
const STEEPEST: f64 = 1000.0;

impl Oracle for Indentation {
    fn source(&self) -> Source {
        Source::new(
            "profile of revolution on a half-space",
            "I. N. Sneddon 1965; V. L. Popov and M. Heß, Method of Dimensionality Reduction, 2015, §3",
            "re-derived; checked by quadrature of the transform and by surface displacements",
        )
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let mut parameters = vec![
            positive("modulus", self.modulus),
            positive("radius", self.radius),
            non_negative("beyond", self.beyond),
            positive("load", self.load()),
        ];
        for &[coefficient, power] in &self.powers {
            let holds = power > 0.0 && power <= STEEPEST;
            parameters.push(finite("coefficient", coefficient));
            parameters.push(Parameter { holds, range: "above 0 and at most 1000", ..finite("power", power) });
        }
        if parameters.iter().any(|parameter| !parameter.holds) {
            return answer(parameters, quantity, f64::NAN);
        }
        let value = match quantity {
            Quantity::HalfWidth => self.radius,
            Quantity::SecondMomentWidth => self.second_moment_radius(),
            Quantity::PeakPressure if self.peak_pressure() == f64::INFINITY => return Reading::Silent,
            Quantity::PeakPressure => self.peak_pressure(),
            Quantity::Resultant => self.load(),
            Quantity::Approach => self.approach(),
            Quantity::Pressure { at } => self.pressure(*at),
            _ => return Reading::Silent,
        };
        answer(parameters, quantity, value)
    }
}
