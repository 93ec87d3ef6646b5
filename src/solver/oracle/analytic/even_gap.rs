//! A rigid profile of even gap on a half-plane: pressure, half-width, opening outside, and the stresses below.
//!
//! With the contact `|x| ≤ a` and the slope of the gap as a cosine series, `g'(a cos θ) = Σ b_n cos nθ` over odd n, the
//! equation of the half-plane `∫ p ds/(x − s) = (πE*/2) g'(x)` has the solution `p(a cos φ) = (E*/2) Σ b_n sin nφ`,
//! from `∫₀^π sin nφ sin φ dφ/(cos φ − cos θ) = −π cos nθ` (Glauert's integral; Johnson, Contact Mechanics, 1985,
//! §2.7).

use std::f64::consts::{FRAC_PI_2, PI};

use super::{answer, grown_to, largest, positive};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Terms of the potentials below this part of the first one are left out.
const ROUNDING: f64 = 1e-18;

/// Contact of an even gap on a half-plane.
#[derive(Clone, Debug)]
pub struct EvenGap {
    /// Contact modulus `E*` \[MPa\].
    pub modulus: f64,
    /// Half-width `a` of the contact \[mm\].
    pub half_width: f64,
    /// `b₁, b₃, b₅, …` of the slope.
    pub slopes: Vec<f64>,
}

impl EvenGap {
    /// The gap `g = c₂ s² + c₄ s⁴ + c₆ s⁶`, pressed to a half-width.
    ///
    /// With `α = 2c₂a`, `β = 4c₄a³`, `γ = 6c₆a⁵`: `b₁ = α + 3β/4 + 5γ/8`, `b₃ = β/4 + 5γ/16`, `b₅ = γ/16`.
    pub fn polynomial(modulus: f64, half_width: f64, [c2, c4, c6]: [f64; 3]) -> Self {
        let a = half_width;
        let [alpha, beta, gamma] = [2.0 * c2 * a, 4.0 * c4 * a.powi(3), 6.0 * c6 * a.powi(5)];
        let slopes = vec![alpha + 0.75 * beta + 0.625 * gamma, 0.25 * beta + 0.3125 * gamma, 0.0625 * gamma];
        Self { modulus, half_width, slopes }
    }

    /// A wedge with a round tip, `g' = s/R` up to `b` and `b/R` beyond, pressed to a half-width `a > b`.
    ///
    /// With `cos θ_b = b/a`: `b_n = (4/πR) [b sin nθ_b / n + a ∫_{θ_b}^{π/2} cos θ cos nθ dθ]`; so many terms.
    pub fn rounded_wedge(modulus: f64, half_width: f64, radius: f64, round: f64, terms: usize) -> Self {
        let tip = (round / half_width).acos();
        let sine = |m: f64| (m * tip).sin() / m;
        let slope = |n: f64| {
            let inner = if n > 1.0 {
                -0.5 * (sine(n - 1.0) + sine(n + 1.0))
            } else {
                0.5 * (FRAC_PI_2 - tip - 0.5 * (2.0 * tip).sin())
            };
            4.0 / (PI * radius) * (round * sine(n) + half_width * inner)
        };
        Self { modulus, half_width, slopes: (0..terms).map(|k| slope((2 * k + 1) as f64)).collect() }
    }

    /// The contact that a load per unit length makes \[N/mm\], given that of every half-width, which it grows with.
    ///
    /// The half-width lies between two \[mm\].
    pub fn of_load(load: f64, between: [f64; 2], of: impl Fn(f64) -> Self) -> Self {
        of(grown_to(load, between, |half_width| of(half_width).load()))
    }

    /// `n` and `b_n`.
    fn terms(&self) -> impl Iterator<Item = (f64, f64)> {
        self.slopes.iter().enumerate().map(|(k, b)| ((2 * k + 1) as f64, *b))
    }

    /// Full load per unit length `P = πaE*b₁/4` \[N/mm\].
    pub fn load(&self) -> f64 {
        0.25 * PI * self.half_width * self.modulus * self.slopes[0]
    }

    /// Pressure at `x = a cos φ` \[MPa\].
    pub fn pressure(&self, phi: f64) -> f64 {
        0.5 * self.modulus * self.terms().map(|(n, b)| b * (n * phi).sin()).sum::<f64>()
    }

    /// Largest pressure, wherever it lies \[MPa\].
    pub fn peak_pressure(&self) -> f64 {
        self.pressure(self.peak_place())
    }

    /// φ of the largest pressure, `x = a cos φ`, on the half x ≥ 0.
    pub fn peak_place(&self) -> f64 {
        largest([0.0, FRAC_PI_2], |phi| self.pressure(phi))
    }

    /// Half-width by second moment `2 √(∫p x²/∫p) = a √(1 + b₃/b₁)` \[mm\].
    pub fn second_moment(&self) -> f64 {
        self.half_width * (1.0 + self.slopes.get(1).unwrap_or(&0.0) / self.slopes[0]).sqrt()
    }

    /// Slope of the opening at `x > a`, given that of the gap there: `h' = g' − Σ b_n e^{−nη}`, `x = a cosh η`.
    pub fn opening(&self, x: f64, slope: f64) -> f64 {
        let eta = (x / self.half_width).acosh();
        slope - self.terms().map(|(n, b)| b * (-n * eta).exp()).sum::<f64>()
    }

    /// Stresses `[σ_x, σ_z, τ_xz]` \[MPa\] in the half-plane; `x` right, `z ≥ 0` into the body \[mm\], tension
    /// positive.
    ///
    /// Flamant's solution, integrated: with `ζ = x + iz = a cosh ω`, `ω = η + iθ` and `F = ∫ p ds/(s − ζ) = −(πE*/2) Σ
    /// b_n e^{−nω}`,
    ///
    /// * `σ_x + σ_z = −(2/π) Im F`,
    /// * `σ_z − σ_x = (2/π) z Re F'`,
    /// * `τ_xz = (1/π) z Im F'`, `F' = (πE*/2a) Σ n b_n e^{−nω} / sinh ω`.
    ///
    /// Not a number at the edges `x = ±a, z = 0`, where `sinh ω = 0`.
    pub fn stress(&self, x: f64, z: f64) -> [f64; 3] {
        let a = self.half_width;
        let (eta, theta) = elliptic(x / a, z / a);
        let [mut potential, mut derivative] = [[0.0; 2]; 2];
        for (n, b) in self.terms() {
            let size = (-n * eta).exp();
            if n * size < ROUNDING * (-eta).exp() {
                break;
            }
            let (sin, cos) = (n * theta).sin_cos();
            for (k, part) in [cos, -sin].into_iter().enumerate() {
                potential[k] += b * size * part;
                derivative[k] += n * b * size * part;
            }
        }
        let [real, imaginary] = [eta.sinh() * theta.cos(), eta.cosh() * theta.sin()];
        let square = real * real + imaginary * imaginary;
        let quotient = [
            (derivative[0] * real + derivative[1] * imaginary) / square,
            (derivative[1] * real - derivative[0] * imaginary) / square,
        ];
        let sum = self.modulus * potential[1];
        let [difference, shear] = [quotient[0], 0.5 * quotient[1]].map(|part| self.modulus * z / a * part);
        [0.5 * (sum - difference), 0.5 * (sum + difference), shear]
    }
}

/// Elliptic coordinates `x + iz = cosh(η + iθ)`, `z ≥ 0`.
fn elliptic(x: f64, z: f64) -> (f64, f64) {
    // sinh² η and sin² θ are the roots of s² − (x² + z² − 1) s − z² = 0, up to sign.
    let difference = (x - 1.0) * (x + 1.0) + z * z;
    let root = difference.hypot(2.0 * z);
    let [sinh, sin] = if difference >= 0.0 {
        let sinh = (0.5 * (root + difference)).sqrt();
        [sinh, z / sinh]
    } else {
        let sin = (0.5 * (root - difference)).sqrt();
        [z / sin, sin]
    };
    let eta = sinh.asinh();
    (eta, sin.atan2(x / eta.cosh()))
}

impl Oracle for EvenGap {
    fn source(&self) -> Source {
        Source::new(
            "even gap on a half-plane",
            "Johnson, Contact Mechanics, 1985, §2.7",
            "Glauert's integral, term by term",
        )
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters = vec![
            positive("modulus", self.modulus),
            positive("half_width", self.half_width),
            positive("first slope", self.slopes.first().copied().unwrap_or(f64::NAN)),
        ];
        let value = match quantity {
            Quantity::HalfWidth => self.half_width,
            Quantity::SecondMomentWidth => self.second_moment(),
            Quantity::PeakPressure => self.peak_pressure(),
            Quantity::Resultant => self.load(),
            Quantity::Pressure { at } => {
                let cosine = *at / self.half_width;
                if cosine.abs() < 1.0 { self.pressure(cosine.acos()) } else { 0.0 }
            }
            _ => return Reading::Silent,
        };
        answer(parameters, quantity, value)
    }
}
