//! How far a contact ends from the mesh line that was laid on its end, by the forces near that line.

use nalgebra::{DMatrix, DVector};

use crate::contact::Interface;
use crate::elasticity::quadrature;
use crate::mesh::lobatto::legendre;
use crate::scene::contact_pair::LAYER;

/// Part of the half-width that rounding explains.
const SAME: f64 = 1e-9;
/// Terms of a series that smooth profiles need no more of, and of the longest one: as many as there are functions on
/// cells of order 8.
const TERMS: [usize; 2] = [4, 7];
/// Fewest functions that tell a series, and the one of a term less.
const FEWEST: usize = 3;
/// Parts of the stretch on which profiles that are steep at its end have a series of so few terms: up to the outermost
/// layer of cells, and the next one.
const NARROW: [f64; 2] = [LAYER, LAYER * LAYER];
/// Order to which the functions vanish where the piece ends that is looked at.
const VANISHES: usize = 2;
/// Gauss points, exact for polynomials in √d of degree 31.
const RULE: usize = 16;

/// A mesh line on which a stretch ends, or is taken to end.
pub(super) struct Tip {
    /// Its contact coordinate.
    pub(super) end: f64,
    /// 1 where the stretch lies at greater coordinates, −1 where it lies at smaller ones.
    pub(super) inwards: f64,
    /// Half the distance to its other end.
    pub(super) half_width: f64,
}

impl Tip {
    /// Distance into the stretch.
    pub(super) fn away(&self, position: f64) -> f64 {
        (position - self.end) * self.inwards
    }

    /// How far the end lies beyond the line, over the half-width, and how far another series is from that; by the
    /// `[contact coordinate, force]` of closed nodes, where the gap is smooth up to a distance. None where the pressure
    /// does not fall towards the end.
    ///
    /// Closed up to a place that is not its end, a frictionless contact has the pressure of a sharp corner at the
    /// distance d from there, as it may have at the other end, D = 2a away: `p √(d (D − d)) = A + B d/D + …`. At the
    /// end itself A, the stress intensity, vanishes. Where the end lies at −δ, `p ∝ √(δ + d) = √d + δ/(2√d) + …`, so
    /// that `δ = 2AD/(B + A/2)`.
    ///
    /// Of some series the one whose last term matters least is taken.
    pub(super) fn moved(&self, interface: &Interface, forces: &[[f64; 2]], smooth: f64) -> Option<[f64; 2]> {
        let [few, many] = TERMS;
        let [narrow, narrower] = NARROW.map(|part| part * smooth);
        let pieces = [(smooth, few), (smooth, many), (narrow, many), (narrower, many)];
        let by_series = |(within, terms)| self.by_series(interface, forces, within, terms);
        let mut known: Vec<[f64; 2]> = pieces.into_iter().filter_map(by_series).collect();
        known.sort_by(|a, b| a[1].total_cmp(&b[1]));
        known.dedup();
        let [moved, last] = *known.first()?;
        Some([moved, known.get(1).map_or(last, |other| (other[0] - moved).abs())])
    }

    /// The same by a series of so many terms up to the farthest corner of a cell within a distance, and what the last
    /// term changes.
    ///
    /// The force of a node by itself says little, as no cell follows a root; but `Σ g(s_a) F_a` is `∫ g p dA` to twice
    /// the order, for what it misses is what the mesh leaves of the solution times what it would leave under a load g
    /// (Babuška & Miller 1984). So the series is fitted to such sums, with polynomials g of the degree of the cells
    /// that vanish where the piece ends.
    fn by_series(&self, interface: &Interface, forces: &[[f64; 2]], within: f64, terms: usize) -> Option<[f64; 2]> {
        let [same, width] = [SAME, 2.0].map(|part| part * self.half_width);
        let span = |[a, b]: [f64; 2]| [self.away(a).min(self.away(b)), self.away(a).max(self.away(b))];
        let spans: Vec<[f64; 2]> = interface.contact_edges().map(|edge| span(edge.ends)).collect();
        let corners =
            spans.iter().map(|[_, far]| *far).filter(|far| *far > same && *far <= within * (1.0 + SAME) + same);
        let reach = corners.reduce(f64::max)?;
        let rows = interface.edges.first()?.len().checked_sub(VANISHES).filter(|rows| *rows >= FEWEST)?;
        let functions = |d: f64| {
            let z = (d / reach).clamp(0.0, 1.0);
            let polynomial = |j: usize| if j == 0 { 1.0 } else { legendre(j, 2.0 * z - 1.0)[1] };
            DVector::from_fn(rows, |j, _| (1.0 - z).powi(VANISHES as i32) * polynomial(j))
        };
        let is_within = |[near, far]: [f64; 2]| near >= -same && far <= reach + same;
        let terms = terms.min(rows);
        let mut of_series = DMatrix::<f64>::zeros(rows, terms);
        for (edge, [near, far]) in interface.edges.iter().zip(spans).filter(|(_, span)| is_within(*span)) {
            let at: Vec<f64> = edge.iter().map(|&a| self.away(interface.nodes[a].coordinate)).collect();
            let forwards = if at[0] < at[1] { 1.0 } else { -1.0 };
            // By √d, in which every term is smooth.
            let [low, high] = [near.max(0.0).sqrt(), far.sqrt()];
            for (x, weight) in quadrature::gauss(RULE) {
                let root = low + 0.5 * (1.0 + x) * (high - low);
                let d = root * root;
                let areas = interface.areas_at(edge, forwards * (2.0 * d - near - far) / (far - near));
                let g = at.iter().zip(areas).fold(DVector::zeros(rows), |sum, (d, area)| sum + functions(*d) * area);
                let per_xi = 2.0 * root * (high - low) / (far - near);
                let term = |k: usize| (d / width).powi(k as i32) / (root * (width - d).sqrt());
                of_series += g * DVector::from_fn(terms, |k, _| weight * per_xi * term(k)).transpose();
            }
        }
        let own = forces.iter().map(|[s, force]| (self.away(*s), *force)).filter(|(d, _)| is_within([*d, *d]));
        let sums = own.fold(DVector::zeros(rows), |sum, (d, force)| sum + functions(d) * force);
        let moved = |terms: usize| {
            let series = of_series.columns(0, terms).svd(true, true).solve(&sums, f64::EPSILON).ok()?;
            let slope = series[1] + 0.5 * series[0];
            let moved = 2.0 * series[0] / slope * width / self.half_width;
            (slope > 0.0 && moved.is_finite()).then_some(moved)
        };
        let [moved, other] = [moved(terms)?, moved(terms - 1)?];
        Some([moved, (moved - other).abs()])
    }
}
