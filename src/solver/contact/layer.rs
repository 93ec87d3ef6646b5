//! Layer contact element: a thin isoparametric element of fictitious material between an edge and its opposite.

use nalgebra::Vector2;

use crate::contact::{ContactPoint, Interface, Quadrature};

/// A thin element of thickness `t(ξ) = t₀ + g(ξ)` (`t₀` where the bodies interfere), moduli `E_n` across and `G = 0`
/// along it, and no membrane stiffness.
///
/// Its nodes lie on both edges, `X_a` and `X_a + (t₀ + g_a) n_a`. On η = 0 the strain across it is
/// `ε = e·∇u·e` with the director `e = ∂x/∂η / |∂x/∂η|`, and `σ = E_n ε = (E_n/t) w` with `w = t ε`.
/// For parallel faces `w` is the line element's approach; what sets the layer apart is its spring
/// `k_i = E_n / t(ξ_i)`: stiff where the gap is narrow, soft where it is wide.
///
/// Its thickness `t₀` is given over the length of the edge, and the quadrature is that on η = 0.
pub fn points(interface: &Interface, quadrature: Quadrature, thickness: f64) -> Vec<ContactPoint> {
    let mut thicknesses = Vec::new();
    let mut points = interface.points(quadrature, |edge, at, gap| {
        let t0 = thickness * length(interface, edge);
        thicknesses.push(t0 + gap.max(0.0));
        (normal_row(interface, edge, t0, at), 1.0 / (t0 + gap.max(0.0)))
    });
    let mean = thicknesses.iter().sum::<f64>() / thicknesses.len() as f64;
    points.iter_mut().for_each(|point| point.relative_stiffness *= mean);
    points
}

fn length(interface: &Interface, edge: &[usize]) -> f64 {
    let coordinate = |k: usize| interface.nodes[edge[k]].coordinate;
    (coordinate(1) - coordinate(0)).abs() * interface.pair.path.metric()
}

/// Row of `w = t ε` on the retained normal dofs.
///
/// Across the element `u = ½(1−η) u₁ + ½(1+η) u₂`. As `e` runs along `∂x/∂η`, with `t = 2 |∂x/∂η|`,
/// `e·∇u = (u₂ − u₁)/t` exactly, however wedge-shaped the element is. The first body moves by `u n_a`, the second by
/// `−u n_b`, `n` out of the first; closing is compression, and a displacement contributes `N (n·e)`. Its tangential
/// part is dropped.
fn normal_row(interface: &Interface, edge: &[usize], t0: f64, (shapes, position): (&[f64], f64)) -> Vec<(usize, f64)> {
    let across = |(&a, &value): (&usize, &f64)| {
        let node = &interface.nodes[a];
        Vector2::from(node.normal) * (0.5 * value * (t0 + node.gap.max(0.0)))
    };
    let director = edge.iter().zip(shapes).map(across).sum::<Vector2<f64>>().normalize();
    let terms = interface.terms(edge, (shapes, position)).into_iter();
    terms.map(|(dof, value, normal)| (dof, value * director.dot(&Vector2::from(normal)))).collect()
}
