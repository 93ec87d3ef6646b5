//! An elastic ring on a rigid pin with clearance, by Michell's series.
//!
//! A pressure `cos nθ` on the inner circle moves it outwards by `c_n cos nθ`; towards large n `c_n → 2a/E*n`, whose sum
//! is the logarithm `Σ cos nθ cos nφ/n = −½ ln 2|cos θ − cos φ|`. With `y = sin(θ/2)/sin(ε/2)` that is `ln|y² − y'²|`,
//! which Chebyshev's polynomials of the pressure `p = cos(θ/2) √(1 − y²) Σ d_k U_2k(y)` make a sum of cosines; what is
//! left of the series is smooth. The harmonic n = 1 is that of a rigid motion, and says only what force the ring
//! carries.

use std::f64::consts::{LN_2, PI};

use nalgebra::{DMatrix, DVector};

use crate::oracle::analytic::Plane;
use crate::oracle::analytic::michell::Harmonic;
use crate::oracle::analytic::shell::{Shape, Shell};
use crate::scene::{Material, Profile};

/// Polynomials of the pressure.
const TERMS: usize = 24;
/// Harmonics of the series.
const HARMONICS: usize = 800;
/// Points of the quadrature over half of the contact.
const POINTS: usize = 600;
/// Places that are looked at, on the contact and beyond it.
const PLACES: usize = 200;

/// Elastic constants and radii of a ring.
#[derive(Clone, Copy, Debug)]
pub struct Ring {
    /// Inner and outer radius \[mm\].
    pub radii: [f64; 2],
    /// Its material.
    pub material: Material,
    /// Plane state.
    pub plane: Plane,
    /// Pressure that acts on all of its outside \[MPa\].
    pub pressure: f64,
}

/// Its contact with a pin.
#[derive(Clone, Debug)]
pub struct OnPin {
    /// The ring.
    pub ring: Ring,
    /// Half-angle ε of the contact \[rad\].
    pub half_angle: f64,
    /// `d_k` \[MPa\].
    pub terms: Vec<f64>,
}

impl Ring {
    /// `c_n` of pressures on the inside \[mm/MPa\]; 0 for n = 1.
    fn compliance(&self, n: usize) -> f64 {
        match n {
            0 => self.under([1.0, 0.0]),
            1 => 0.0,
            _ => {
                let pressed = Harmonic::pressed(n, 0, self.radii, self.material, self.plane);
                pressed.displacement(self.radii[0])[0]
            }
        }
    }

    /// How far the inside moves outwards under pressures inside and outside \[mm\].
    fn under(&self, pressures: [f64; 2]) -> f64 {
        let (shape, material) = (Shape::of_ring(self.plane), self.material);
        Shell { shape, radii: self.radii, pressures, material }.displacement(self.radii[0])
    }

    /// The contact of a half-angle \[rad\] with a pin in it, whose gap is measured on the ring; none where the pressure
    /// is not one all over it, or the ring is not open beyond.
    pub fn on_pin(self, gap: &Profile, half_angle: f64) -> Option<OnPin> {
        let half = 0.5 * half_angle;
        let [inner, _] = self.radii;
        let Material { young, poisson } = self.material;
        let scale = inner * (1.0 + poisson) / young;
        // 2a/E*: (κ + 1)/4μ per unit of the radius.
        let far = 0.5 * scale * (self.plane.kolosov(poisson) + 1.0);
        let parts = moments(half.sin());
        let left = |n: usize| match n {
            0 => self.compliance(0) / PI,
            1 => 0.0,
            _ => 2.0 / PI * (self.compliance(n) - far / n as f64),
        };
        let rest: Vec<f64> = (0..HARMONICS).map(left).collect();
        let moved = |angle: f64| -> Vec<f64> {
            let y = (0.5 * angle).sin() / half.sin();
            let cosines: Vec<f64> = (0..HARMONICS).map(|n| rest[n] * (n as f64 * angle).cos()).collect();
            let smooth = |k: usize| cosines.iter().zip(&parts[k]).map(|(c, part)| c * part).sum::<f64>();
            (0..TERMS).map(|k| smooth(k) - far / PI * logarithm(k, y, half.sin())).collect()
        };
        let place = |i: usize| 2.0 * (half.sin() * (0.5 * PI * (i as f64 + 0.5) / (TERMS + 1) as f64).cos()).asin();
        let mut matrix = DMatrix::zeros(TERMS + 1, TERMS + 1);
        let mut right = DVector::zeros(TERMS + 1);
        let uniform = self.under([0.0, self.pressure]);
        for i in 0..=TERMS {
            for (k, value) in moved(place(i)).into_iter().enumerate() {
                matrix[(i, k)] = value;
            }
            matrix[(i, TERMS)] = place(i).cos();
            right[i] = -gap.gap(place(i)) - uniform;
        }
        let answer = matrix.lu().solve(&right)?;
        let found = OnPin { ring: self, half_angle, terms: answer.iter().take(TERMS).copied().collect() };
        let open = |k: usize| {
            let angle = half_angle + (PI - half_angle) * (k as f64 + 1.0) / PLACES as f64;
            let bent: f64 = moved(angle).iter().zip(&found.terms).map(|(value, term)| value * term).sum();
            gap.gap(angle) + uniform + bent + answer[TERMS] * angle.cos() >= 0.0
        };
        let pressed = |k: usize| found.pressure(half_angle * k as f64 / PLACES as f64) > 0.0;
        ((0..PLACES).all(pressed) && (0..PLACES).all(open)).then_some(found)
    }
}

/// `∫ p cos nφ dφ` over half of the contact, of every polynomial for every harmonic.
fn moments(sine: f64) -> Vec<Vec<f64>> {
    let mut all = vec![vec![0.0; HARMONICS]; TERMS];
    for i in 0..POINTS {
        // Half of Gauss's points for √(1 − y²).
        let psi = PI * (i as f64 + 0.5) / (2 * POINTS) as f64;
        let weight = 2.0 * sine * PI / (2 * POINTS) as f64 * psi.sin();
        let angle = 2.0 * (sine * psi.cos()).asin();
        let cosines: Vec<f64> = (0..HARMONICS).map(|n| (n as f64 * angle).cos()).collect();
        for (k, own) in all.iter_mut().enumerate() {
            let value = weight * ((2 * k + 1) as f64 * psi).sin();
            own.iter_mut().zip(&cosines).for_each(|(sum, cosine)| *sum += value * cosine);
        }
    }
    all
}

/// `∫₀^π sin ψ sin (2k + 1)ψ ln|y − cos ψ| dψ`; `y > 1` beyond the contact.
pub(super) fn under_logarithm(k: usize, y: f64) -> f64 {
    // ∫₀^π cos mψ ln|y − cos ψ| dψ = −(π/m) T_m(y), of which beyond the contact e^{−mη} is left.
    let cosine = |m: f64| if y <= 1.0 { (m * y.acos()).cos() } else { (-m * y.acosh()).exp() };
    let integral = |m: usize| match m {
        0 if y <= 1.0 => -PI * LN_2,
        0 => PI * (y.acosh() - LN_2),
        _ => -PI / m as f64 * cosine(m as f64),
    };
    0.5 * (integral(2 * k) - integral(2 * k + 2))
}

/// `∫ p ln 2|cos θ − cos φ| dφ` over half of the contact, of a polynomial at y; `y > 1` beyond it.
fn logarithm(k: usize, y: f64, sine: f64) -> f64 {
    let weight = if k == 0 { 0.25 * PI } else { 0.0 };
    2.0 * sine * (under_logarithm(k, y) + weight * (4.0 * sine * sine).ln())
}

impl OnPin {
    /// Pressure at an angle \[MPa\].
    pub fn pressure(&self, angle: f64) -> f64 {
        let y = (0.5 * angle).sin() / (0.5 * self.half_angle).sin();
        if y.abs() >= 1.0 {
            return 0.0;
        }
        let psi = y.acos();
        let terms = self.terms.iter().enumerate();
        (0.5 * angle).cos() * terms.map(|(k, d)| d * ((2 * k + 1) as f64 * psi).sin()).sum::<f64>()
    }

    /// `∫ p f(φ) dφ` over half of the contact.
    fn integral(&self, of: impl Fn(f64) -> f64) -> f64 {
        let sine = (0.5 * self.half_angle).sin();
        let one = |i: usize| {
            let psi = PI * (i as f64 + 0.5) / (2 * POINTS) as f64;
            let angle = 2.0 * (sine * psi.cos()).asin();
            self.pressure(angle) * of(angle) * 2.0 * sine * psi.sin() / (0.5 * angle).cos()
        };
        (0..POINTS).map(one).sum::<f64>() * PI / (2 * POINTS) as f64
    }

    /// Force along the load line on the whole contact \[N/mm\].
    pub fn load(&self) -> f64 {
        2.0 * self.ring.radii[0] * self.integral(f64::cos)
    }

    /// `2 √(∫p θ²/∫p)` \[rad\].
    pub fn second_moment(&self) -> f64 {
        2.0 * (self.integral(|angle| angle * angle) / self.integral(|_| 1.0)).sqrt()
    }

    /// Largest pressure \[MPa\], and where it lies \[rad\].
    pub fn peak(&self) -> [f64; 2] {
        let places = (0..20 * PLACES).map(|k| self.half_angle * k as f64 / (20 * PLACES) as f64);
        let best = places.map(|angle| [self.pressure(angle), angle]).max_by(|a, b| a[0].total_cmp(&b[0]));
        best.unwrap_or([f64::NAN; 2])
    }
}
