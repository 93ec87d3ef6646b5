//! Hertz's contact of cylinders as somebody computed it, and that of the scene `tiny` on the contact side of small
//! meshes: 49 nodes, 0.1 mm apart.

use std::f64::consts::PI;

use contact_vv::referee::Answer;

/// Hertz's contact of cylinders: force \[N\], radius \[mm\], E* \[MPa\], thickness \[mm\].
#[derive(Clone, Copy)]
pub struct Hertz {
    pub force: f64,
    pub radius: f64,
    pub modulus: f64,
    pub thickness: f64,
}

/// That of `tiny`, which is in plane strain.
pub const RIGHT: Hertz = Hertz { force: 314.1593, radius: 1000.0, modulus: 91000.0 / 0.91, thickness: 1.0 };

impl Hertz {
    /// `a = √(4FR/πE*t)` \[mm\].
    pub fn half_width(&self) -> f64 {
        (4.0 * self.force * self.radius / (PI * self.modulus * self.thickness)).sqrt()
    }

    /// `p₀ = 2F/πat` \[MPa\].
    pub fn peak(&self) -> f64 {
        2.0 * self.force / (PI * self.half_width() * self.thickness)
    }

    /// `p₀ √(1 − s²/a²)` \[MPa\].
    pub fn pressure(&self, s: f64) -> f64 {
        self.peak() * (1.0 - (s / self.half_width()).powi(2)).max(0.0).sqrt()
    }
}

pub const NODES: usize = 49;

pub fn place(k: usize) -> f64 {
    0.1 * k as f64
}

pub fn pressure(s: f64) -> f64 {
    RIGHT.pressure(s)
}

/// The gap beyond the contact of a half-plane, `(a²/2R) (ξ √(ξ² − 1) − ln(ξ + √(ξ² − 1)))`, ξ = s/a.
pub fn gap(s: f64) -> f64 {
    let a = RIGHT.half_width();
    let x = (s / a).max(1.0);
    let root = (x * x - 1.0).sqrt();
    a.powi(2) / (2.0 * RIGHT.radius) * (x * root - (x + root).ln())
}

/// Lines of two numbers.
pub fn rows(separator: &str, number: impl Fn(f64) -> String) -> String {
    let row = |k| format!("{}{separator}{}\n", number(place(k)), number(pressure(place(k))));
    (0..NODES).map(row).collect()
}

/// A number of every node.
pub fn list(of: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..NODES).map(|k| of(place(k))).collect()
}

/// The edges of a document, with means of straight lines between so many times the pressures.
pub fn edges(times: f64) -> serde_json::Value {
    let edge = |k: usize| {
        let [from, to] = [k, k + 1].map(place);
        let mean = 0.5 * times * (pressure(from) + pressure(to));
        serde_json::json!({ "from": from, "to": to, "area": to - from, "pressure": mean })
    };
    (0..NODES - 1).map(edge).collect()
}

pub fn text() -> String {
    format!("position [mm],pressure [MPa]\n{}", rows(",", |x| x.to_string()))
}

/// That an answer holds every node with its pressure and, where it was handed in, its gap; `share` of them.
pub fn assert(answer: &Answer, digits: f64) {
    assert_share(answer, digits, 1.0);
}

pub fn assert_share(answer: &Answer, digits: f64, share: f64) {
    let points = &answer.contacts[0].points;
    assert_eq!(points.len(), NODES);
    for (k, point) in points.iter().enumerate() {
        let s = place(k);
        assert!((point.position - s).abs() <= 5.0 * digits, "{point:?} at {s}");
        assert!((point.value - share * pressure(s)).abs() <= 100.0 * digits, "{point:?} at {s}");
        assert!(point.gap.is_none_or(|own| (own - gap(s)).abs() <= 0.3 * digits), "{point:?} at {s}");
    }
}
