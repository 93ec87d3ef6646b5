//! What the stresses of a half-plane say of the points below a contact: how far they sink, and where the shear stress is largest.

use crate::scene::{Material, PlaneHypothesis};

/// Parts of the Simpson rule over the depth, graded towards the surface.
const PARTS: usize = 200;
/// Places of the coarse search for the largest shear stress along the contact, and into the depth.
const PLACES: [usize; 2] = [32, 48];
/// Half-widths down to which it is looked for.
const DEPTH: f64 = 2.0;
/// Halvings of the step of the search that follows.
const HALVINGS: usize = 40;

/// `u_z(0, z) − u_z(0, 0) = ∫ (σ_z − ν' σ_x) dz / E'` in plane strain, `E' = E/(1−ν²)`, `ν' = ν/(1−ν)` \[mm\]; the stresses are
/// those at x and the depth z, `[σ_x, σ_z, τ]` \[MPa\].
pub fn sunk(stress: impl Fn([f64; 2]) -> [f64; 3], material: Material, depth: f64) -> f64 {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let ratio = material.poisson / (1.0 - material.poisson);
    // z = depth · t²; at the surface itself the rule has the weight 0.
    let part = |k: usize| {
        let t = k as f64 / PARTS as f64;
        let [along, into, _] = stress([0.0, depth * t * t]);
        (into - ratio * along) * 2.0 * depth * t
    };
    let weight = |k: usize| match k {
        PARTS => 1.0,
        odd if !odd.is_multiple_of(2) => 4.0,
        _ => 2.0,
    };
    let sum: f64 = (1..=PARTS).map(|k| weight(k) * part(k)).sum();
    sum / (3.0 * PARTS as f64 * modulus)
}

/// Largest in-plane shear stress `½ (σ₁ − σ₂)` below a part of the surface \[MPa\], and its depth \[mm\].
pub fn largest_shear(stress: impl Fn([f64; 2]) -> [f64; 3], [from, to]: [f64; 2]) -> [f64; 2] {
    let length = to - from;
    let value = |[x, z]: [f64; 2]| {
        let [along, into, shear] = stress([from + length * x, length * z]);
        (0.5 * (along - into)).hypot(shear)
    };
    let [across, down] = PLACES;
    let place = |i: usize, j: usize| [i as f64 / across as f64, DEPTH * (j as f64 / down as f64).powi(2)];
    let all = (0..across).flat_map(|i| (1..=down).map(move |j| place(i, j)));
    let (mut at, mut best) = ([f64::NAN; 2], f64::NEG_INFINITY);
    for place in all {
        let found = value(place);
        if found > best {
            (at, best) = (place, found);
        }
    }
    let mut step = 1.0 / across as f64;
    for _ in 0..HALVINGS {
        for [dx, dz] in [[-step, 0.0], [step, 0.0], [0.0, -step], [0.0, step]] {
            let next = [(at[0] + dx).clamp(0.0, 1.0), (at[1] + dz).max(0.0)];
            let found = value(next);
            if found > best {
                (at, best) = (next, found);
            }
        }
        step *= 0.5;
    }
    [best, length * at[1]]
}
