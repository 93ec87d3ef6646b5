//! Stresses and displacements of the elastic half-space under a pressure of revolution, without friction.
//!
//! With r from the axis and `z ≥ 0` into the body \[mm\], the harmonic `f = (1/2π) ∫ p dA/ρ` has `f_z = −p` on the
//! surface, and with `φ_z = −f` (Boussinesq 1885; Barber, Elasticity, 2010, §21.5)
//!
//! * `2G u_r = (1 − 2ν) φ_r − z f_r`, `2G u_z = 2(1 − ν) f − z f_z`,
//! * `σ_z = f_z − z f_zz`, `τ_rz = −z f_rz`, `σ_r = f_z + z (f_zz + f_r/r) − (1 − 2ν) φ_r/r`,
//! * `σ_θ = φ_r/r − z f_r/r + 2ν (f_z − φ_r/r)`.
//!
//! The potentials are imaginary parts of functions of `ζ = z + ia` and `ρ = √(r² + ζ²)`: a punch, moved by ia along the
//! axis.

use nalgebra::Complex;

use crate::scene::Material;

/// Stresses at a place \[MPa\], tension positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stress {
    /// `σ_r`.
    pub radial: f64,
    /// `σ_z`.
    pub axial: f64,
    /// `σ_θ`.
    pub hoop: f64,
    /// `τ_rz`.
    pub shear: f64,
}

impl Stress {
    /// `[σ_r, σ_z, τ_rz]` \[MPa\], as a [`Action::Stress`](crate::scene::Action::Stress) has them.
    pub fn in_plane(&self) -> [f64; 3] {
        [self.radial, self.axial, self.shear]
    }

    /// Largest shear stress in the plane of r and z, `√((σ_r − σ_z)²/4 + τ_rz²)` \[MPa\].
    pub fn largest_shear(&self) -> f64 {
        (0.5 * (self.radial - self.axial)).hypot(self.shear)
    }
}

/// The potential f and its derivatives at a place, `r` from the axis and `z` deep \[mm\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Potential {
    r: f64,
    z: f64,
    /// `f, f_z, f_zz, f_r/r, f_rz/r, φ_r/r`.
    parts: [f64; 6],
}

impl Potential {
    /// Of the pressure `1/√(a² − r²)` under a flat punch: `f = Im ln(ζ + ρ)` (Sneddon 1946).
    ///
    /// Not a number at the edge `r = a, z = 0`.
    pub fn flat(a: f64, r: f64, z: f64) -> Self {
        let (zeta, root) = complex(a, r, z);
        let sum = zeta + root;
        let cube = root * root * root;
        let parts = [sum.arg(), root.inv().im, -(zeta / cube).im, (root * sum).inv().im, -cube.inv().im, sum.inv().im];
        Self { r, z, parts }
    }

    /// Of Hertz's pressure `√(a² − r²)`: that of the flat punches of all radii `t ≤ a`, times `t dt` (Huber 1904).
    ///
    /// Not a number at the edge `r = a, z = 0`.
    pub fn hertz(a: f64, r: f64, z: f64) -> Self {
        let (zeta, root) = complex(a, r, z);
        let (sum, edge) = (zeta + root, Complex::new(0.0, a));
        let angle = sum.arg();
        let third = (root * root + root * zeta + zeta * zeta) / (sum * 3.0);
        let parts = [
            (0.5 * (a * a + z * z) - 0.25 * r * r) * angle + ((zeta * 0.25 - z) * root).im,
            z * angle - root.im,
            angle - (edge / root).im,
            0.5 * ((edge - z) / sum).im - 0.5 * angle,
            -((edge + root) / (root * sum)).im,
            0.5 * z * (angle + (zeta / sum).im) - third.im,
        ];
        Self { r, z, parts }
    }

    /// So many times this one.
    pub fn times(self, factor: f64) -> Self {
        Self { parts: self.parts.map(|part| factor * part), ..self }
    }

    /// Both together, at the same place.
    pub fn with(self, other: Self) -> Self {
        Self { parts: std::array::from_fn(|k| self.parts[k] + other.parts[k]), ..self }
    }

    /// The stresses.
    pub fn stress(&self, poisson: f64) -> Stress {
        let z = self.z;
        let [_, down, down_twice, outward, turned, inner] = self.parts;
        Stress {
            radial: down + z * (down_twice + outward) - (1.0 - 2.0 * poisson) * inner,
            axial: down - z * down_twice,
            hoop: inner - z * outward + 2.0 * poisson * (down - inner),
            shear: -z * self.r * turned,
        }
    }

    /// Displacements `[u_r, u_z]` \[mm\], those far away being zero.
    pub fn displacement(&self, Material { young, poisson }: Material) -> [f64; 2] {
        let [own, down, _, outward, _, inner] = self.parts;
        let along = self.r * ((1.0 - 2.0 * poisson) * inner - self.z * outward);
        let into = 2.0 * (1.0 - poisson) * own - self.z * down;
        [along, into].map(|twice| twice * (1.0 + poisson) / young)
    }
}

/// `ζ = z + ia` and `ρ = √(r² + ζ²)`, neither part of which is negative.
fn complex(a: f64, r: f64, z: f64) -> (Complex<f64>, Complex<f64>) {
    (Complex::new(z, a), Complex::new((r - a) * (r + a) + z * z, 2.0 * a * z).sqrt())
}
