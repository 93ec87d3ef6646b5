//! The largest pressure of a contact around an axis whose end lies on a mesh line, by the forces of all of it.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{DMatrix, DVector};

use crate::contact::Interface;
use crate::elasticity::quadrature;
use crate::measure::{Measures, Peak, Stretch, larger};
use crate::mesh::lobatto::legendre;
use crate::solution::{Part, PointState};

/// Fewest functions that tell a series, and the one of a term less.
const FEWEST: usize = 3;
/// What the last term of a series may matter, over the peak, if it shall be taken whatever points tell.
const SETTLED: f64 = 1e-4;
/// How far such a top may be from what points tell, over what two readings of these are apart, besides what the points
/// of cells of order 4, and of each further order, miss of a smooth top (spheres: 1.2e-3, 1.7e-4, 7e-5, 5e-6, 2e-6):
/// where a few terms do not draw the pressure, as of a thin layer, two series may agree by chance.
const AGREES: f64 = 3.0;
const SMOOTH_TOP: (f64, f64) = (1.5e-3, 0.2);
/// Part of the radius that rounding explains.
const NEAR: f64 = 1e-9;
/// Gauss points of an edge, by the angle in which the integrands are smooth.
const RULE: usize = 16;
/// Places at which the top is looked for, and how far from the axis, over the radius.
const GRID: u32 = 64;
const WITHIN: f64 = 0.9;

/// `p = q(x)/√(1 − x²)` over a circle, x = r/a.
struct Series {
    /// Of powers of x.
    coefficients: Vec<f64>,
    radius: f64,
}

impl Series {
    /// q and its first two derivatives.
    fn derivatives(&self, x: f64) -> [f64; 3] {
        self.coefficients
            .iter()
            .rev()
            .fold([0.0; 3], |[q, slope, bend], c| [c + x * q, q + x * slope, 2.0 * slope + x * bend])
    }

    fn pressure(&self, x: f64) -> f64 {
        self.derivatives(x)[0] / (1.0 - x * x).sqrt()
    }

    /// The largest pressure, away from the ends: where `q′ (1 − x²) + x q` vanishes, by Newton's method from the best
    /// place of a grid.
    fn top(&self) -> Peak {
        let places = (0..=GRID).map(|k| WITHIN * f64::from(k) / f64::from(GRID));
        let mut x = places.max_by(|a, b| self.pressure(*a).total_cmp(&self.pressure(*b))).unwrap_or(0.0);
        for _ in 0..8 {
            let [q, slope, bend] = self.derivatives(x);
            let step = (slope * (1.0 - x * x) + x * q) / (bend * (1.0 - x * x) - x * slope + q);
            if step.abs() <= 1.0 / f64::from(GRID) {
                x -= step;
            }
        }
        Peak { position: self.radius * x, pressure: self.pressure(x) }
    }
}

/// Reads the largest pressure of a contact around an axis, with one closed stretch that ends on a mesh line and an
/// analytic gap: between the tops of two series of which one has a term more, as they lie above and below, of those
/// that are nearest to one another. Leaves what was read of the points around the highest where that is told better,
/// the last term matters much, or points tell another.
pub(super) fn read(interface: &Interface, one: &Stretch, part: Part, measures: &mut Measures) {
    let all = by_series(interface, one, part.points).unwrap_or_default();
    let between = |two: &[Series]| {
        let [less, more] = [&two[0], &two[1]].map(Series::top);
        (Peak { pressure: 0.5 * (less.pressure + more.pressure), ..more }, more.pressure)
    };
    let apart = |(top, other): &(Peak, f64)| (top.pressure - other).abs();
    let nearest = all.windows(2).map(between).min_by(|a, b| apart(a).total_cmp(&apart(b)));
    let by_points = (measures.peak, measures.peak_by_parabola);
    let order = interface.edges.first().map_or(0, |edge| edge.len() as i32 - 1);
    let missed = SMOOTH_TOP.0 * SMOOTH_TOP.1.powi(order - 4) * measures.peak.pressure;
    let is_taken = |found: &(Peak, f64)| {
        let off = (found.0.pressure - by_points.0.pressure).abs();
        let is_settled = apart(found) <= larger(SETTLED * measures.peak.pressure, apart(&by_points));
        is_settled && off <= AGREES * apart(&by_points) + missed
    };
    if let Some((top, other)) = nearest.filter(is_taken) {
        if top.position.abs() <= 0.0 {
            measures.pressure_at_origin = top.pressure;
        }
        (measures.peak, measures.peak_by_parabola) = (top, other);
    }
}

/// Series of more and more terms.
///
/// `p √(1 − x²)` is as smooth as the gap, and `Σ g(s_a) F_a` is `∫ g p dA` to twice the order of the cells for a
/// polynomial g of their degree (Babuška & Miller 1984): so it is fitted to such sums over the whole circle. About the
/// axis both have even powers only.
fn by_series(interface: &Interface, one: &Stretch, points: &[PointState]) -> Option<Vec<Series>> {
    let x_of = |r: f64| r / one.end;
    let degree = interface.edges.first()?.len().checked_sub(1)?;
    let powers: Vec<usize> = (0..=degree).step_by(2).collect();
    let rows = Some(powers.len()).filter(|rows| *rows >= FEWEST)?;
    let functions = |x: f64| DVector::from_fn(rows, |j, _| if j == 0 { 1.0 } else { legendre(powers[j], x)[1] });
    let is_within = |x: f64| x.abs() <= 1.0 + NEAR;
    let mut of_series = DMatrix::<f64>::zeros(rows, rows);
    for (edge, span) in interface.edges.iter().zip(interface.contact_edges()) {
        let ends = span.ends.map(x_of);
        if !ends.iter().all(|x| is_within(*x)) {
            continue;
        }
        let at: Vec<f64> = edge.iter().map(|&a| x_of(interface.nodes[a].coordinate)).collect();
        let forwards = if at[0] < at[1] { 1.0 } else { -1.0 };
        let angle = |x: f64| if x.abs() < 1.0 { x.asin() } else { FRAC_PI_2.copysign(x) };
        let [from, to] = ends.map(angle);
        for (xi, weight) in quadrature::gauss(RULE) {
            let x = (from + 0.5 * (1.0 + xi) * (to - from)).sin();
            let areas = interface.areas_at(edge, forwards * (2.0 * x - ends[0] - ends[1]) / (ends[1] - ends[0]));
            let g = at.iter().zip(areas).fold(DVector::zeros(rows), |sum, (x, area)| sum + functions(*x) * area);
            // Per ξ of the edge, and dx = √(1 − x²) dθ.
            let weight = weight * (to - from) / (ends[1] - ends[0]);
            of_series += g * DVector::from_fn(rows, |k, _| weight * x.powi(powers[k] as i32)).transpose();
        }
    }
    let own = points.iter().map(|point| (x_of(point.position), point.weight * point.pressure));
    let sums =
        own.filter(|(x, _)| is_within(*x)).fold(DVector::zeros(rows), |sum, (x, force)| sum + functions(x) * force);
    let series = |terms: usize| {
        let found = of_series.columns(0, terms).svd(true, true).solve(&sums, f64::EPSILON).ok()?;
        let mut coefficients = vec![0.0; degree + 1];
        powers.iter().zip(found.iter()).for_each(|(power, c)| coefficients[*power] = *c);
        Some(Series { coefficients, radius: one.end })
    };
    let all: Vec<Series> = (FEWEST - 1..=rows).map(series).collect::<Option<_>>()?;
    Some(all)
}
