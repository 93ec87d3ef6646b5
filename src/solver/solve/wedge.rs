//! How the pressure grows towards an end of a contact where the faces end at a corner: `p ∝ r^(λ−1)`.
//!
//! Near such an end each body is a wedge of interior angle θ, loaded by `σ_φφ = −p`, `p = r^(λ−1)`, without friction on
//! its contact face φ = 0; the other face φ = θ is free, or held. With Airy's function `r^(λ+1) F(φ)` (Williams 1952),
//!
//! `F = A cos (λ+1)φ + B sin (λ+1)φ + C cos (λ−1)φ + D sin (λ−1)φ`,
//!
//! `σ_φφ = λ(λ+1) r^(λ−1) F`, `τ_rφ = −λ r^(λ−1) F'`, and, κ Kolosov's constant,
//!
//! `2μ u_r = r^λ (−(λ+1)F + (κ+1)(C cos (λ−1)φ + D sin (λ−1)φ))`,
//! `2μ u_φ = r^λ (−F' + (κ+1)(C sin (λ−1)φ − D cos (λ−1)φ))`.
//!
//! The contact face moves inwards by `u_φ(0) = c(θ, λ) r^λ/E'`, `c = −4D`. Of a wedge whose other face is free
//!
//! `c = −(sin 2λθ + λ sin 2θ) / (λ (sin² λθ − λ² sin² θ))`,
//!
//! which is `−(2/λ) cot λπ` of a half-plane, θ = π. What both faces do together is a rigid motion, so that
//! `c₁/E₁' + c₂/E₂' = 0`: the exponent is a root of that between 0 and 1. A rigid side has none of it. Without a root
//! the pressure is finite (Dundurs & Lee 1972 for a wedge on a half-plane; Comninou 1976 with friction).

use std::f64::consts::PI;

/// A body at the end of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wedge {
    /// Interior angle between the contact face and the other one; π of a body that goes on smoothly \[rad\].
    pub angle: f64,
    /// Plane modulus E' \[MPa\].
    pub modulus: f64,
    /// Direction of the displacement component in which the other face is held: along it, away from the corner, and out
    /// of the body; none where it is free, whatever finite traction acts on it \[1\].
    pub held: Option<[f64; 2]>,
}

/// A quantity that is linear in C and D: its part without them, and its coefficients.
type Linear = [f64; 3];

impl Wedge {
    /// A body whose contact face goes on.
    pub fn half_plane(modulus: f64) -> Self {
        Self { angle: PI, modulus, held: None }
    }

    /// `c(θ, λ)`: how far `p = r^(λ−1)` moves the contact face inwards, over `r^λ/E'`.
    pub fn compliance(&self, lambda: f64) -> f64 {
        let (m, n) = (lambda - 1.0, lambda + 1.0);
        let p = 1.0 / (lambda * n);
        let ((sm, cm), (sn, cn)) = ((m * self.angle).sin_cos(), (n * self.angle).sin_cos());
        // A = −p − C and B = −D m/n leave the pressure and no shear on the contact face.
        let f: Linear = [-p * cn, cm - cn, sm - m / n * sn];
        let slope: Linear = [p * n * sn, n * sn - m * sm, m * (cm - cn)];
        let [first, second] = match self.held {
            None => [f, slope],
            // No traction across the direction in which it is held, and with that no displacement along it.
            Some([along, out]) => {
                let traction = [0, 1, 2].map(|k| along * n * f[k] + out * slope[k]);
                [traction, [0.0, along * cm + out * sm, along * sm - out * cm]]
            }
        };
        let determinant = first[1] * second[2] - first[2] * second[1];
        -4.0 * (first[0] * second[1] - first[1] * second[0]) / determinant
    }
}

/// Difference `1 − λ` below which a pressure is as good as finite: it grows by less than 0.01 % from the width of a
/// contact to an atom.
const WEAKEST: f64 = 1e-6;
/// Intervals of 0 < λ < 1 in which a root is looked for, and of the decades of 1 − λ towards 1.
const INTERVALS: usize = 200;
const DECADES: usize = 8;
/// Halvings after which a root has all its digits.
const HALVINGS: usize = 60;

/// The exponent λ of the pressure `r^(λ−1)` of two bodies at the end of their contact, or of one on a rigid other side:
/// the smallest root of `Σ c/E' = 0` in 0 < λ < 1; none where the pressure is finite.
pub fn exponent(wedges: &[Wedge]) -> Option<f64> {
    let compliance = |lambda: f64| -> f64 { wedges.iter().map(|one| one.compliance(lambda) / one.modulus).sum() };
    let even = (1..INTERVALS).map(|k| k as f64 / INTERVALS as f64);
    let last = 1.0 / INTERVALS as f64;
    let steps = ((last / WEAKEST).log10() * DECADES as f64).ceil() as usize;
    let towards_one = (1..=steps).map(|k| 1.0 - last * (WEAKEST / last).powf(k as f64 / steps as f64));
    let all: Vec<[f64; 2]> = even.chain(towards_one).map(|lambda| [lambda, compliance(lambda)]).collect();
    all.windows(2).find_map(|pair| {
        let [[mut low, below], [mut high, above]] = [pair[0], pair[1]];
        if below * above > 0.0 {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            *if compliance(middle) * below > 0.0 { &mut low } else { &mut high } = middle;
        }
        // Where a wedge alone has an exponent of its own, the sum leaps from one infinity to the other.
        let root = 0.5 * (low + high);
        (compliance(root).abs() <= below.abs().max(above.abs())).then_some(root)
    })
}
