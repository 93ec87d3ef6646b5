//! Both ends of the disc in fringe orders: fitted at the bottom, predicted at the top.

use serde::Serialize;

use crate::error::Error;
use crate::measure::larger;
use crate::oracle::digitised::fringes::{Channel, End, Fringe};
use crate::study::photoelastic::field::Field;
use crate::study::photoelastic::fit::Constants;

/// Half-widths over the radius at which the disc is solved; the best lies on the parabola through the least three.
const WIDTHS: [f64; 10] = [0.030, 0.035, 0.040, 0.045, 0.050, 0.055, 0.060, 0.065, 0.070, 0.075];
/// Halvings of the mesh, and of the one twice as coarse that says what ours is worth.
const REFINEMENTS: [u32; 2] = [1, 0];
/// Constants that are fitted.
const CONSTANTS: usize = 5;
/// Depths at which computed fringes are looked for, over the radius, and halvings of their place.
const DEPTHS: usize = 27;
const HALVINGS: usize = 40;

/// What the photograph says of our disc.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// Half-width by Hertz over the radius, fitted, and its standard deviation if readings were independent.
    pub half_width: [f64; 2],
    /// The other constants.
    pub constants: Constants,
    /// Root mean square at each end, in fringe orders.
    pub ends: Vec<Residuals>,
    /// By half-width, at the bottom.
    pub widths: Vec<Width>,
    /// Root mean square of what a mesh twice as coarse changes at all points, and the largest of it.
    pub mesh: [f64; 2],
    /// Measured fringes, and computed ones.
    pub curves: Vec<Curve>,
}

/// How far computed orders are from measured ones.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Residuals {
    /// The end.
    pub end: End,
    /// Points.
    pub points: usize,
    /// Root mean square.
    pub rms: f64,
}

/// A half-width at the bottom.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Width {
    /// Over the radius.
    pub a_over_r: f64,
    /// Root mean square with all other constants held.
    pub held: f64,
    /// The same with them fitted.
    pub fitted: f64,
}

/// A fringe of an end: `[x, z]` over the radius.
#[derive(Clone, Debug, Serialize)]
pub struct Curve {
    /// The end.
    pub end: End,
    /// Channel.
    pub channel: Channel,
    /// Order.
    pub order: f64,
    /// As read.
    pub measured: Vec<[f64; 2]>,
    /// As computed.
    pub computed: Vec<[f64; 2]>,
}

/// Fits at the bottom, predicts the top.
pub fn compare(fringes: &[Fringe]) -> Result<Numbers, Error> {
    let of = |end: End| fringes.iter().copied().filter(|fringe| fringe.end == end).collect::<Vec<_>>();
    let [bottom, top] = [End::Bottom, End::Top].map(of);
    let fields: Vec<Field> = WIDTHS.into_iter().map(|a| Field::of(a, REFINEMENTS[0])).collect::<Result<_, _>>()?;
    let sums: Vec<f64> = fields.iter().map(|field| Constants::fitted(field, &bottom).1).collect();
    let (best, least, curvature) = parabola(&sums);
    let freedom = (bottom.len() - CONSTANTS) as f64;
    let deviation = (2.0 * least / freedom / curvature).sqrt();

    let field = Field::of(best, REFINEMENTS[0])?;
    let (constants, _) = Constants::fitted(&field, &bottom);
    let rms = |sum: f64, points: usize| (sum / points as f64).sqrt();
    let end = |end: End, own: &[Fringe]| Residuals {
        end,
        points: own.len(),
        rms: rms(constants.sum_of_squares(&field, own), own.len()),
    };
    let width = |((a_over_r, other), fitted): ((&f64, &Field), &f64)| Width {
        a_over_r: *a_over_r,
        held: rms(constants.sum_of_squares(other, &bottom), bottom.len()),
        fitted: rms(*fitted, bottom.len()),
    };
    let coarse = Field::of(best, REFINEMENTS[1])?;
    let changed = |fringe: &Fringe| (constants.residual(&coarse, fringe) - constants.residual(&field, fringe)).abs();
    let squares = fringes.iter().map(|fringe| changed(fringe).powi(2)).sum();
    Ok(Numbers {
        half_width: [best, deviation],
        ends: vec![end(End::Bottom, &bottom), end(End::Top, &top)],
        widths: WIDTHS.iter().zip(&fields).zip(&sums).map(width).collect(),
        mesh: [rms(squares, fringes.len()), fringes.iter().map(changed).fold(0.0, larger)],
        curves: [(End::Bottom, &bottom), (End::Top, &top)]
            .into_iter()
            .flat_map(|(end, own)| curves(&field, &constants, end, own))
            .collect(),
        constants,
    })
}

/// Place, value and second derivative of the minimum of a parabola through the least of the sums and its neighbours.
fn parabola(sums: &[f64]) -> (f64, f64, f64) {
    let least = (1..sums.len() - 1).min_by(|&a, &b| sums[a].total_cmp(&sums[b])).unwrap_or(1);
    let step = WIDTHS[1] - WIDTHS[0];
    let [before, at, after] = [sums[least - 1], sums[least], sums[least + 1]];
    let (slope, curvature) = ((after - before) / (2.0 * step), (after - 2.0 * at + before) / (step * step));
    let shift = -slope / curvature;
    (WIDTHS[least] + shift, at + 0.5 * slope * shift, curvature)
}

/// The fringes of an end.
fn curves(field: &Field, constants: &Constants, end: End, own: &[Fringe]) -> Vec<Curve> {
    let mut all = Vec::new();
    for channel in Channel::ALL {
        for order in [1.0, 2.0, 3.0, 4.0] {
            let same = |fringe: &&Fringe| fringe.channel == channel && (fringe.order - order).abs() < 0.5;
            let measured: Vec<[f64; 2]> = own.iter().filter(same).map(|f| [f.half_spacing, f.depth]).collect();
            let Some(deepest) = measured.iter().map(|point| point[1]).reduce(f64::max) else { continue };
            let shallowest = measured.iter().map(|point| point[1]).fold(deepest, f64::min);
            let depths = (0..=DEPTHS).map(|k| shallowest + (deepest - shallowest) * k as f64 / DEPTHS as f64);
            let around = |z: f64| {
                measured.iter().min_by(|a, b| (a[1] - z).abs().total_cmp(&(b[1] - z).abs())).map_or(0.1, |p| p[0])
            };
            let computed =
                depths.filter_map(|z| Some([place(field, constants, channel, order, z, around(z))?, z])).collect();
            all.push(Curve { end, channel, order, measured, computed });
        }
    }
    all
}

/// Where an order lies on a line, between half and one and a half times a place near it; none where it does not.
fn place(field: &Field, constants: &Constants, channel: Channel, order: f64, z: f64, near: f64) -> Option<f64> {
    let over = |x: f64| constants.order_at(field, channel, [x, z]) - order;
    let [mut inner, mut outer] = [0.5 * near, 1.5 * near];
    if !(over(inner) > 0.0 && over(outer) < 0.0) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inner + outer);
        if over(middle) > 0.0 { inner = middle } else { outer = middle }
    }
    Some(0.5 * (inner + outer))
}
