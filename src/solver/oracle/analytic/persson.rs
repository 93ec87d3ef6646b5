//! A pin in a hole of a wide plate, with clearance.

use std::f64::consts::PI;

use super::{Parameter, Plane, answer, non_negative, poisson_ratio, positive};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Frictionless pin in a hole of an infinite plate of the same material (Persson 1964).
///
/// Angles are measured from the load line; `b = tan(ε/2)` with the contact half-angle `ε`, `y = tan(φ/2)`.
/// Methods return NaN where a parameter is out of range; [`Oracle::read`] says which one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PinInHole {
    /// Radius of the pin `R` \[mm\].
    pub radius: f64,
    /// Radial clearance `ΔR ≥ 0` \[mm\].
    pub clearance: f64,
    /// Full force per unit thickness `P = F/t` \[N/mm\], positive when pressing the pin against the hole.
    pub load: f64,
    /// Plane modulus of one body `E_p` \[MPa\]: `E` in plane stress, `E/(1−ν²)` in plane strain.
    pub modulus: f64,
    /// Poisson's ratio `ν` of both bodies; enters the hoop stresses only.
    pub poisson: f64,
    /// The two-dimensional state of both bodies.
    pub plane: Plane,
}

impl PinInHole {
    /// Half-angle `ε` of the contact \[rad\]: `E_p ΔR/P` equals its closed form in `b`, found by bisection.
    pub fn half_angle(&self) -> f64 {
        2.0 * self.half_angle_tangent().atan()
    }

    /// Contact pressure \[MPa\] at `φ` \[rad\], zero outside the contact.
    ///
    /// `R p/P = (2/π) √(b²−y²) / [√(1+b²)(1+y²)] + artanh√[(b²−y²)/(1+b²)] / [π b²(1+b²)]`.
    pub fn pressure(&self, phi: f64) -> f64 {
        self.load / self.radius * unit_pressure(self.half_angle_tangent(), phi)
    }

    /// Largest contact pressure, at `φ = 0` \[MPa\].
    pub fn peak_pressure(&self) -> f64 {
        self.pressure(0.0)
    }

    /// Half-angle by second moment `2 √(∫pφ²/∫p)` \[rad\].
    ///
    /// By the midpoint rule in `φ = ε sin t`, where the integrand is smooth: 64 points already give all digits.
    pub fn second_moment(&self) -> f64 {
        const PARTS: usize = 256;
        let b = self.half_angle_tangent();
        let edge = 2.0 * b.atan();
        let (mut moment, mut total) = (0.0, 0.0);
        for part in 0..PARTS {
            let (sin, cos) = (0.5 * PI * (part as f64 + 0.5) / PARTS as f64).sin_cos();
            let share = unit_pressure(b, edge * sin) * cos;
            total += share;
            moment += share * (edge * sin).powi(2);
        }
        2.0 * (moment / total).sqrt()
    }

    /// Hoop stress on the rim of the hole \[MPa\] at `φ` \[rad\], tension positive.
    ///
    /// `R σ_θθ/P = −R p/P + 2m + [2κ'/(κ'+1)] cos φ/π` with `m = [2b⁴ + ln(1+b²)] / [2π b²(1+b²)]`,
    /// the mean of `R p/P` over the full rim.
    pub fn hole_hoop_stress(&self, phi: f64) -> f64 {
        let b = self.half_angle_tangent();
        let kolosov = self.plane.kolosov(self.poisson);
        let bending = 2.0 * kolosov / (kolosov + 1.0) * phi.cos() / PI;
        self.load / self.radius * (2.0 * mean_pressure(b) - unit_pressure(b, phi) + bending)
    }

    /// Hoop stress on the rim of the pin \[MPa\] at `φ` \[rad\], tension positive; the pin is fixed at its centre.
    ///
    /// `R σ_θθ/P = −R p/P + [2/(κ'+1)] cos φ/π`.
    pub fn pin_hoop_stress(&self, phi: f64) -> f64 {
        let kolosov = self.plane.kolosov(self.poisson);
        let bending = 2.0 / (kolosov + 1.0) * phi.cos() / PI;
        self.load / self.radius * (bending - unit_pressure(self.half_angle_tangent(), phi))
    }

    /// Full force per unit thickness \[N/mm\] that makes a contact of half-angle `ε` \[rad\], `P = E_p ΔR / f(b)`.
    ///
    /// NaN without clearance, where the half-angle does not depend on the load.
    pub fn load_for(half_angle: f64, clearance: f64, modulus: f64) -> f64 {
        let load = modulus * clearance / relative_clearance((0.5 * half_angle).tan());
        if clearance > 0.0 && load > 0.0 { load } else { f64::NAN }
    }

    /// `b = tan(ε/2)`, or NaN where no half-angle fits.
    fn half_angle_tangent(&self) -> f64 {
        let target = self.modulus * self.clearance / self.load;
        let sound = self.radius > 0.0 && self.load > 0.0 && self.modulus > 0.0 && self.clearance >= 0.0;
        if !(sound && target.is_finite()) {
            return f64::NAN;
        }

        // The right side falls from +∞ to a negative value at b = 1, so halving from 1 brackets the root.
        let mut below = 0.5;
        while relative_clearance(below) < target {
            below *= 0.5;
        }
        bisect(below, 2.0 * below, target)
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![
            positive("radius", self.radius),
            non_negative("clearance", self.clearance),
            positive("load", self.load),
            positive("modulus", self.modulus),
            poisson_ratio("poisson", self.poisson),
        ]
    }
}

/// `E_p ΔR/P = [2 − ln(1+b²) − 2b⁴] / [π b²(1+b²)]`, falling in `b`.
fn relative_clearance(b: f64) -> f64 {
    let square = b.powi(2);
    (2.0 - square.ln_1p() - 2.0 * square.powi(2)) / (PI * square * (1.0 + square))
}

/// `R p/P` at `φ` for `b = tan(ε/2)`.
fn unit_pressure(b: f64, phi: f64) -> f64 {
    if phi.abs() >= 2.0 * b.atan() {
        return 0.0;
    }
    let y = (0.5 * phi).tan();
    let square = b.powi(2);
    let inside = (b - y) * (b + y);
    let ratio = (inside.max(0.0) / (1.0 + square)).sqrt();
    2.0 / PI * ratio / (1.0 + y.powi(2)) + ratio.atanh() / (PI * square * (1.0 + square))
}

/// Mean of `R p/P` over the full rim, `m = [2b⁴ + ln(1+b²)] / [2π b²(1+b²)]`.
fn mean_pressure(b: f64) -> f64 {
    let square = b.powi(2);
    (2.0 * square.powi(2) + square.ln_1p()) / (2.0 * PI * square * (1.0 + square))
}

/// The `b` between `low` and `high` with the given relative clearance, to the last digit.
fn bisect(mut low: f64, mut high: f64, target: f64) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            return middle;
        }
        *if relative_clearance(middle) > target { &mut low } else { &mut high } = middle;
    }
}

impl Oracle for PinInHole {
    fn source(&self) -> Source {
        Source::new(
            "Persson",
            "B. G. A. Persson, On the stress distribution of cylindrical elastic bodies in contact, 1964; \
             M. Ciavarella and P. Decuzzi, Int. J. Solids Struct. 38, 2001",
            "re-derived from the Michell series, originals not at hand; checked by equilibrium",
        )
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters = self.parameters();
        let value = match quantity {
            Quantity::HalfWidth => self.half_angle(),
            Quantity::PeakPressure => self.peak_pressure(),
            Quantity::Resultant => self.load,
            Quantity::Pressure { at } => self.pressure(*at),
            Quantity::HoopStress { at } => self.hole_hoop_stress(*at),
            Quantity::PinHoopStress { at } => self.pin_hoop_stress(*at),
            Quantity::SecondMomentWidth => self.second_moment(),
            _ => return Reading::Silent,
        };
        answer(parameters, quantity, value)
    }
}
