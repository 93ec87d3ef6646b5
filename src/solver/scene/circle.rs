//! A circle, and the rays that meet it.

/// A circle.
#[derive(Clone, Copy, Debug)]
pub struct Circle {
    /// Centre \[mm\].
    pub centre: [f64; 2],
    /// Radius \[mm\].
    pub radius: f64,
}

impl Circle {
    /// Distance from `pole` to the circle along the ray at angle `θ` from the downward vertical \[mm\].
    ///
    /// With `e = pole − centre` and the ray's direction `d`: `r = −e·d + √(ρ² − |e|² + (e·d)²)`; the pole lies inside.
    pub fn along_ray(&self, pole: [f64; 2], angle: f64) -> f64 {
        let (s, c) = angle.sin_cos();
        let e = [pole[0] - self.centre[0], pole[1] - self.centre[1]];
        let forward = e[0] * s - e[1] * c;
        let offset = e[0] * e[0] + e[1] * e[1];
        (self.radius * self.radius - offset + forward * forward).sqrt() - forward
    }
}
