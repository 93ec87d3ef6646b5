//! A ring under a pressure `cos nθ` on one of its circles, by Michell's series (J. H. Michell 1899; J. R. Barber,
//! Elasticity, 2010, tables 8.1 and 9.1).
//!
//! `φ = b² Σ A_k (r/b_k)^{m_k} cos nθ` with `m = n, −n, n + 2, 2 − n`, b the loaded radius, and `b_k` the outer radius
//! where a term grows and the inner one where it falls, so that no power is large. Its tractions are
//! `σ_rr = (m − n²) φ/r²` and `σ_rθ = n (m − 1) φ tan nθ/r²`.

use nalgebra::{Matrix4, Vector4};

use super::Plane;
use crate::scene::Material;

/// One harmonic, n ≥ 2.
#[derive(Clone, Copy, Debug)]
pub struct Harmonic {
    n: f64,
    radii: [f64; 2],
    loaded: f64,
    /// `A_k`.
    terms: [f64; 4],
    /// `b (1 + ν)/E` \[mm/MPa\].
    scale: f64,
    kappa: f64,
}

impl Harmonic {
    /// The ring of inner and outer radius \[mm\] under a pressure of 1 MPa times `cos nθ`, without shear, on the one or
    /// the other; NaN where both radii are one.
    pub fn pressed(
        n: usize,
        side: usize,
        radii: [f64; 2],
        Material { young, poisson }: Material,
        plane: Plane,
    ) -> Self {
        let n = n as f64;
        let loaded = radii[side];
        let mut own = Self {
            n,
            radii,
            loaded,
            terms: [0.0; 4],
            scale: loaded * (1.0 + poisson) / young,
            kappa: plane.kolosov(poisson),
        };
        let powers = own.powers();
        let matrix = Matrix4::from_fn(|row, k| {
            let radius = radii[row / 2];
            let traction = if row % 2 == 0 { powers[k] - n * n } else { n * (powers[k] - 1.0) };
            traction * own.grown(k, radius) * (loaded / radius).powi(2)
        });
        let mut tractions = Vector4::zeros();
        tractions[2 * side] = -1.0;
        own.terms = matrix.lu().solve(&tractions).map_or([f64::NAN; 4], Into::into);
        own
    }

    /// Displacement outwards and along the angle at a radius \[mm/MPa\], over `cos nθ` and `sin nθ`.
    pub fn displacement(&self, radius: f64) -> [f64; 2] {
        let (n, kappa) = (self.n, self.kappa);
        let outwards = [-n, n, kappa - n - 1.0, kappa + n - 1.0];
        let along = [n, n, kappa + n + 1.0, n - 1.0 - kappa];
        [outwards, along].map(|moves| {
            let sum: f64 = (0..4).map(|k| self.terms[k] * self.grown(k, radius) * moves[k]).sum();
            self.scale * sum * self.loaded / radius
        })
    }

    fn powers(&self) -> [f64; 4] {
        [self.n, -self.n, self.n + 2.0, 2.0 - self.n]
    }

    /// `(r/b_k)^{m_k}`, at most 1 in the ring.
    fn grown(&self, k: usize, radius: f64) -> f64 {
        let [inner, outer] = self.radii;
        (radius / if k.is_multiple_of(2) { outer } else { inner }).powf(self.powers()[k])
    }
}
