//! Shape functions of the 4-node and the 8-node (serendipity) quadrilateral and of their edges.
//!
//! Corners counter-clockwise from (−1, −1), then mid-sides from the bottom edge on (Bathe, Finite Element Procedures, §5.3).

/// Natural coordinates of the eight nodes.
pub const NODES: [[f64; 2]; 8] =
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];

/// Values `N_a` and gradients `[∂N_a/∂ξ, ∂N_a/∂η]` at (ξ, η) of a cell of `n` = 4 or 8 nodes.
pub fn cell(n: usize, at: [f64; 2]) -> Vec<(f64, [f64; 2])> {
    (0..n).map(|a| if n == 4 { bilinear(NODES[a], at) } else { serendipity(NODES[a], at) }).collect()
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

/// Values and slopes `(N_a, dN_a/dξ)` on an edge of 2 nodes, or of 3 (first, last, middle).
pub fn edge(n: usize, x: f64) -> Vec<(f64, f64)> {
    if n == 2 {
        return vec![((1.0 - x) / 2.0, -0.5), ((1.0 + x) / 2.0, 0.5)];
    }
    vec![(x * (x - 1.0) / 2.0, x - 0.5), (x * (x + 1.0) / 2.0, x + 0.5), (1.0 - x * x, -2.0 * x)]
}
