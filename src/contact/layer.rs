//! Layer contact element: a thin isoparametric element of fictitious material between two facing edges.

use nalgebra::{Matrix2, Vector2};

use crate::contact::{ContactElement, ContactPoint, Interface, Quadrature};
use crate::elasticity::shape_functions;

/// A thin element of thickness `t(ξ) = t₀ + g(ξ)` (`t₀` where the bodies interfere), moduli `E_n` across and `G = 0` along it, and no membrane stiffness.
///
/// Its nodes lie on both edges, `X_a` and `X_a + (t₀ + g_a) n_a`. On η = 0 the strain across it is
/// `ε = e·∇u·e` with the director `e = ∂x/∂η / |∂x/∂η|`, and `σ = E_n ε = (E_n/t) w` with `w = t ε`.
/// For parallel faces `w` is the line element's approach; what sets the layer apart is its spring
/// `k_i = E_n / t(ξ_i)`: stiff where the gap is narrow, soft where it is wide.
#[derive(Clone, Copy, Debug)]
pub struct Layer {
    /// Quadrature on η = 0.
    pub quadrature: Quadrature,
    /// `t₀` over the length of the edge.
    pub thickness: f64,
}

impl ContactElement for Layer {
    fn points(&self, interface: &Interface) -> Vec<ContactPoint> {
        let mut points = Vec::new();
        let mut thicknesses = Vec::new();
        for (index, edge) in interface.edges.iter().enumerate() {
            let t0 = self.thickness * length(interface, edge);
            for (xi, weight) in self.quadrature.rule(edge.len()) {
                let (_, position, length) = interface.at(edge, xi);
                let gap = interface.pair.profile.gap(position);
                let t = t0 + gap.max(0.0);
                let area = weight * length * interface.thickness;
                points.push(ContactPoint {
                    row: normal_row(interface, edge, t0, xi),
                    position,
                    weight: area,
                    gap,
                    relative_stiffness: 1.0 / t,
                    shares: vec![(index, area)],
                });
                thicknesses.push(t);
            }
        }
        let mean = thicknesses.iter().sum::<f64>() / thicknesses.len() as f64;
        points.iter_mut().for_each(|point| point.relative_stiffness *= mean);
        points.sort_by(|a, b| a.position.total_cmp(&b.position));
        points
    }
}

fn length(interface: &Interface, edge: &[usize]) -> f64 {
    let coordinate = |k: usize| interface.stations[edge[k]].coordinate;
    (coordinate(1) - coordinate(0)).abs() * interface.pair.path.metric()
}

/// Row of `w = t ε` on the retained normal freedoms, from the strain–displacement matrix of the thin element at (ξ, 0).
///
/// `n_a` points from the first body (side −1, moved by `u n_a`) to the second (side +1, moved by `−u n_a`), and closing
/// is compression: both give `side · t e·∇N · (n_a·e)`. The tangential parts of a wedge-shaped layer are dropped.
fn normal_row(interface: &Interface, edge: &[usize], t0: f64, xi: f64) -> Vec<(usize, f64)> {
    let shapes = shape_functions::edge(edge.len(), xi);
    let mut jacobian = Matrix2::<f64>::zeros();
    for (&a, &(value, slope)) in edge.iter().zip(&shapes) {
        let station = &interface.stations[a];
        let point = Vector2::from(station.point);
        let across = Vector2::from(station.normal) * (t0 + station.gap.max(0.0));
        let along = (point + across * 0.5) * slope;
        let over = across * (0.5 * value);
        jacobian += Matrix2::new(along.x, along.y, over.x, over.y);
    }
    let over = Vector2::new(jacobian[(1, 0)], jacobian[(1, 1)]);
    let thickness = 2.0 * over.norm();
    let director = over / over.norm();
    let inverse = jacobian.try_inverse().expect("t0 + g is positive and edges have length");
    let mut row = Vec::new();
    for (&a, &(value, slope)) in edge.iter().zip(&shapes) {
        let station = &interface.stations[a];
        let tilt = director.dot(&Vector2::from(station.normal));
        for (side, &freedom) in [-1.0, 1.0].into_iter().zip(&station.freedoms) {
            let gradient = inverse * Vector2::new(0.5 * slope, 0.5 * side * value);
            let strain = director.dot(&gradient) * tilt;
            row.push((freedom, thickness * side * strain));
        }
    }
    row
}
