//! Shape functions of the 4-node and the 8-node (serendipity) quadrilateral, of tensor products of order p, and of
//! their edges.
//!
//! Corners counter-clockwise from (−1, −1), then mid-sides from the bottom edge on (Bathe, Finite Element Procedures,
//! §5.3); nodes of tensor products as [`Order::places`] numbers them, on Gauss–Lobatto–Legendre points (Karniadakis &
//! Sherwin 2005).

use crate::mesh::{Mesh, Order, lobatto};

/// Natural coordinates of the eight nodes.
pub const NODES: [[f64; 2]; 8] =
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];

/// Values `N_a` and gradients `[∂N_a/∂ξ, ∂N_a/∂η]` at (ξ, η) of a cell of `n` nodes: 4, 8 or `(p + 1)²`.
pub fn cell(n: usize, at: [f64; 2]) -> Vec<(f64, [f64; 2])> {
    match Order::of_nodes(n) {
        Some(order) if order.is_tensor() => tensor(order, at),
        Some(Order::Linear) => (0..n).map(|a| bilinear(NODES[a], at)).collect(),
        _ => NODES.into_iter().take(n).map(|node| serendipity(node, at)).collect(),
    }
}

/// The values alone.
pub fn values(n: usize, at: [f64; 2]) -> Vec<f64> {
    cell(n, at).into_iter().map(|(value, _)| value).collect()
}

/// `N = N_i(ξ) N_j(η)`.
fn tensor(order: Order, at: [f64; 2]) -> Vec<(f64, [f64; 2])> {
    let [along, across] = at.map(|x| lobatto::lagrange(lobatto::points(order.intervals() + 1), x));
    let product = |[i, j]: [usize; 2]| {
        let ((n, slope), (m, rise)) = (along[i], across[j]);
        (n * m, [slope * m, n * rise])
    };
    order.places().into_iter().map(product).collect()
}

/// `N = (1 + ξ_a ξ)(1 + η_a η)/4`.
fn bilinear([xa, ya]: [f64; 2], [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
    let (p, q) = (1.0 + xa * x, 1.0 + ya * y);
    (p * q / 4.0, [xa * q / 4.0, ya * p / 4.0])
}

/// Corner: `(1 + ξ_a ξ)(1 + η_a η)(ξ_a ξ + η_a η − 1)/4`; mid-side: `(1 − ξ²)(1 + η_a η)/2` or `(1 + ξ_a ξ)(1 − η²)/2`.
fn serendipity([xa, ya]: [f64; 2], [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
    let (p, q) = (1.0 + xa * x, 1.0 + ya * y);
    if xa.abs() < 0.5 {
        return ((1.0 - x * x) * q / 2.0, [-x * q, ya * (1.0 - x * x) / 2.0]);
    }
    if ya.abs() < 0.5 {
        return (p * (1.0 - y * y) / 2.0, [xa * (1.0 - y * y) / 2.0, -y * p]);
    }
    let s = xa * x + ya * y;
    (p * q * (s - 1.0) / 4.0, [xa * q * (s + xa * x) / 4.0, ya * p * (s + ya * y) / 4.0])
}

/// Gradients of the area coordinates `1 − ξ − η, ξ, η`.
const SLOPES: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

/// Values and gradients at (ξ, η) of a triangle of 3 or 6 nodes: corners `L_a (2 L_a − 1)`, or `L_a` alone, then
/// mid-sides `4 L_a L_b`.
pub fn triangle(n: usize, [x, y]: [f64; 2]) -> Vec<(f64, [f64; 2])> {
    let area = [1.0 - x - y, x, y];
    let along = |k: usize, factor: f64| SLOPES[k].map(|slope| factor * slope);
    if n == 3 {
        return (0..3).map(|k| (area[k], SLOPES[k])).collect();
    }
    let corner = |k: usize| (area[k] * (2.0 * area[k] - 1.0), along(k, 4.0 * area[k] - 1.0));
    let middle = |k: usize| {
        let next = (k + 1) % 3;
        let (a, b) = (along(k, 4.0 * area[next]), along(next, 4.0 * area[k]));
        (4.0 * area[k] * area[next], [a[0] + b[0], a[1] + b[1]])
    };
    (0..3).map(corner).chain((0..3).map(middle)).collect()
}

/// Values and slopes `(N_a, dN_a/dξ)` on an edge of 2 nodes, of 3 (first, last, middle), or of more (first, last, those
/// between).
pub fn edge(n: usize, x: f64) -> Vec<(f64, f64)> {
    match n {
        2 => vec![((1.0 - x) / 2.0, -0.5), ((1.0 + x) / 2.0, 0.5)],
        3 => vec![(x * (x - 1.0) / 2.0, x - 0.5), (x * (x + 1.0) / 2.0, x + 0.5), (1.0 - x * x, -2.0 * x)],
        _ => {
            let mut shapes = lobatto::lagrange(lobatto::points(n), x);
            let last = shapes.remove(n - 1);
            shapes.insert(1, last);
            shapes
        }
    }
}

/// Shape functions with their slopes, place, and slope `dx/dξ` at a natural coordinate of an edge \[mm\].
pub type OnEdge = (Vec<(f64, f64)>, [f64; 2], [f64; 2]);

/// Those of an edge of a mesh.
pub fn on_edge(mesh: &Mesh, edge: &[usize], xi: f64) -> OnEdge {
    let shapes = self::edge(edge.len(), xi);
    let (mut point, mut slope) = ([0.0; 2], [0.0; 2]);
    for (&node, (value, derivative)) in edge.iter().zip(&shapes) {
        for k in 0..2 {
            point[k] += value * mesh.points[node][k];
            slope[k] += derivative * mesh.points[node][k];
        }
    }
    (shapes, point, slope)
}
