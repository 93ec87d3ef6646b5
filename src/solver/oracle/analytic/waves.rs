//! A sinusoidal gap on a half-plane (Westergaard 1939).

use std::f64::consts::{FRAC_PI_2, PI};

use super::{answer, positive};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Points of the midpoint rule of the second moment.
const PARTS: usize = 512;

/// The gap `Δ (1 − cos(2πx/λ))` on a half-plane under a mean pressure, one contact a wave.
///
/// With `p* = πE*Δ/λ` and `sin² ψ = p̄/p*`: `p = 2p* cos(πx/λ) √(sin² ψ − sin²(πx/λ))`, half-width `a = λψ/π`; from
/// `p̄ = p*` on the whole wave touches and `p = p̄ + p* cos(2πx/λ)`, half-width λ/2 (Johnson, Contact Mechanics, 1985,
/// §13.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waves {
    /// Contact modulus `E*` \[MPa\].
    pub modulus: f64,
    /// Amplitude `Δ` \[mm\].
    pub amplitude: f64,
    /// Wavelength `λ` \[mm\].
    pub wavelength: f64,
    /// Mean pressure `p̄` on a wave \[MPa\].
    pub mean: f64,
}

impl Waves {
    /// Mean pressure `p* = πE*Δ/λ` that flattens the wave \[MPa\].
    pub fn complete(&self) -> f64 {
        PI * self.modulus * self.amplitude / self.wavelength
    }

    /// `sin ψ`; 1 where the wave is pressed flat.
    fn sine(&self) -> f64 {
        (self.mean / self.complete()).min(1.0).sqrt()
    }

    /// Pressure beyond that which flattens the wave: the same everywhere \[MPa\].
    fn beyond(&self) -> f64 {
        (self.mean - self.complete()).max(0.0)
    }

    /// Half-width \[mm\].
    pub fn half_width(&self) -> f64 {
        self.wavelength / PI * self.sine().asin()
    }

    /// How far the surface has sunk on the mean over a wave, `Δ S (1 − ln S)` with `S = p̄/p*` \[mm\]: the mean gap
    /// that is left is `Δ (1 − S + S ln S)`, of which the slope by S is `Δ ln S`; from S = 1 on none is left.
    pub fn sunk(&self) -> f64 {
        let share = (self.mean / self.complete()).min(1.0);
        self.amplitude * share * (1.0 - share.ln())
    }

    /// Pressure at `x` \[MPa\], zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        let (sin, cos) = (PI * x / self.wavelength).sin_cos();
        let below = (self.sine().powi(2) - sin * sin).max(0.0);
        self.beyond() + 2.0 * self.complete() * cos.abs() * below.sqrt()
    }

    /// `2 √(∫p x²/∫p)` \[mm\], by the midpoint rule in t, `sin(πx/λ) = sin ψ sin t`, where the integrand is smooth;
    /// that of the same pressure everywhere is `λ²/12`.
    pub fn second_moment(&self) -> f64 {
        let (mut moment, mut total) = (0.0, 0.0);
        for part in 0..PARTS {
            let (sin, cos) = (FRAC_PI_2 * (part as f64 + 0.5) / PARTS as f64).sin_cos();
            let place = self.wavelength / PI * (self.sine() * sin).asin();
            total += cos * cos;
            moment += cos * cos * place * place;
        }
        let rest = self.beyond() / self.mean;
        2.0 * ((1.0 - rest) * moment / total + rest * self.wavelength.powi(2) / 12.0).sqrt()
    }
}

impl Oracle for Waves {
    fn source(&self) -> Source {
        Source::new("Westergaard", "Westergaard 1939; Johnson, Contact Mechanics, 1985, §13.2", "as printed")
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters = vec![
            positive("modulus", self.modulus),
            positive("amplitude", self.amplitude),
            positive("wavelength", self.wavelength),
            positive("mean", self.mean),
        ];
        let value = match quantity {
            Quantity::HalfWidth => self.half_width(),
            Quantity::SecondMomentWidth => self.second_moment(),
            Quantity::PeakPressure => self.pressure(0.0),
            Quantity::Resultant => self.mean * self.wavelength,
            Quantity::Pressure { at } => self.pressure(*at),
            _ => return Reading::Silent,
        };
        answer(parameters, quantity, value)
    }
}
