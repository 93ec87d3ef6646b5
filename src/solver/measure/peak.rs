//! The peak of a pressure profile, wherever it lies: the top of a polynomial through the mean pressures over pairs of
//! edges around the highest one.
//!
//! Means over two edges, because they are what all contact elements tell alike: pressures that alternate from point to
//! point or from edge to edge, and the consistent nodal pressures of 3-node edges, above the profile at corners and
//! below it at mid-sides, leave them untouched.

use std::ops::RangeInclusive;

use crate::measure::fit::{Fit, Peak, ROUNDING};
use crate::measure::larger;
use crate::solution::EdgeState;

/// Pairs whose mean differs from the one in question by no more than this part take part in the fit: on a semi-ellipse
/// those within
/// 0.28 half-widths, where a quartic is off by 1e-6.
pub(super) const DROP: f64 = 0.04;
/// Departure of the means from the fit, root mean square over the peak, from which on a narrower fit is looked for: a
/// quartic over [`DROP`] of a semi-ellipse departs by 1e-6, one over both humps and the hollow of a profile that peaks
/// off its centre by 1e-3, on any mesh.
const MISFIT: f64 = 1e-5;
/// Fewest pairs of a narrower fit: two more than the coefficients, so that its departure says something.
const NARROW: usize = QUARTIC + 2;
/// Part of the departure that a narrower fit must stay below: of a smooth profile it falls with the fifth power of the
/// width or faster, of pressures that oscillate hardly at all.
const BETTER: f64 = 0.5;
/// Halvings of [`DROP`] that are tried.
const HALVINGS: i32 = 6;
/// Coefficients of the polynomial, and the fewest pairs: as many, so that on a coarse mesh it goes through their means.
pub(super) const QUARTIC: usize = 5;
/// Difference from the one in question up to which a pair may be one of these: beyond, the end of the contact bends the
/// profile.
const FAR: f64 = 0.3;
/// Coefficients and fewest pairs of a parabola, where a quartic finds too few.
pub(super) const PARABOLA: usize = 3;
/// The largest pressure of a contact from the means over its edges, in the order of the contact coordinate; where that
/// is the same all around, at `centre`. NaN without an edge.
pub fn of(edges: &[EdgeState], centre: f64) -> Peak {
    let pairs = pairs(edges);
    let Some(highest) = highest(&pairs) else { return Peak { position: f64::NAN, pressure: f64::NAN } };
    let fit = around(&pairs, highest);
    let top = fit.top();
    let middle = fit.value(centre);
    let moved = middle.is_none_or(|middle| top.pressure > middle * (1.0 + ROUNDING));
    if moved { top } else { Peak { position: centre, pressure: top.pressure } }
}

/// The largest pressure read in another way: by a parabola through the highest pair and its neighbours, or, where that
/// is farther from the peak that is given, through another pair that stands out and whose top is higher \[MPa\]. How
/// far both are apart tells whether the mesh resolves the top, and whether it is another one. NaN without an edge.
pub fn by_parabola(edges: &[EdgeState], peak: f64) -> f64 {
    let pairs = pairs(edges);
    let Some(highest) = highest(&pairs) else { return f64::NAN };
    let own = parabola(&pairs, highest);
    let [first, last] = highest;
    let near = |k: usize| pairs[k].pressure >= (1.0 - FAR) * pairs[first].pressure;
    let stands_out = |k: &usize| {
        let around = [k.checked_sub(1), Some(k + 1).filter(|&l| l < pairs.len())];
        let is_lower = |l: usize| pairs[l].pressure <= pairs[*k].pressure;
        // In the midst of pairs that are the same there is no other top.
        let is_other = |l: usize| pairs[l].pressure < pairs[*k].pressure * (1.0 - ROUNDING);
        let around = || around.into_iter().flatten();
        near(*k) && around().all(is_lower) && around().any(is_other)
    };
    let others = (0..first).chain(last + 1..pairs.len()).filter(stands_out);
    let other = others.map(|k| parabola(&pairs, [k, k])).fold(f64::NEG_INFINITY, f64::max);
    if other - peak > (own - peak).abs() { other } else { own }
}

/// Top of the parabola through some pairs and their neighbours; at the end of the contact through the two before it
/// \[MPa\].
fn parabola(pairs: &[EdgeState], [first, last]: [usize; 2]) -> f64 {
    let end = (last + 1).min(pairs.len() - 1);
    let start = first.saturating_sub(1).min(end.saturating_sub(PARABOLA - 1));
    over(pairs, start..=end.max(start + PARABOLA - 1).min(pairs.len() - 1)).top().pressure
}

/// Pressure at a place, by the same fit around the pairs that hold it; 0 where no pressed one does.
pub fn pressure_at(edges: &[EdgeState], place: f64) -> f64 {
    let pairs = pairs(edges);
    let away = |k: &usize| (pairs[*k].position() - place).abs();
    let holds = |pair: &EdgeState| {
        let near = ROUNDING * pair.length();
        pair.pressure > 0.0 && pair.ends[0] - near <= place && place <= pair.ends[1] + near
    };
    let nearest = (0..pairs.len()).filter(|&k| holds(&pairs[k])).min_by(|a, b| away(a).total_cmp(&away(b)));
    nearest.map_or(0.0, |k| around(&pairs, [k, k]).value(place).unwrap_or(f64::NAN))
}

/// Neighbouring edges two by two, each with the one after it, and with their images where the contact begins on a
/// symmetry line, s = 0; a single edge stays alone.
fn pairs(edges: &[EdgeState]) -> Vec<EdgeState> {
    let images = if on_one_side(edges) { edges.iter().rev().map(EdgeState::mirrored).collect() } else { Vec::new() };
    let all = [images, edges.to_vec()].concat();
    let joined = |two: &[EdgeState]| {
        let weight = two[0].weight + two[1].weight;
        let force = two[0].weight * two[0].pressure + two[1].weight * two[1].pressure;
        EdgeState { ends: [two[0].ends[0], two[1].ends[1]], weight, pressure: force / weight, axis: two[0].axis }
    };
    if all.len() < 2 { all } else { all.windows(2).map(joined).collect() }
}

/// Whether a contact begins on a symmetry line, s = 0.
pub(super) fn on_one_side(edges: &[EdgeState]) -> bool {
    edges.first().zip(edges.last()).is_some_and(|(a, b)| a.ends[0].abs() <= ROUNDING * b.ends[1])
}

/// The pair of the largest mean, first and last of neighbours that are the same; none where a mean is no number.
fn highest(pairs: &[EdgeState]) -> Option<[usize; 2]> {
    let largest = pairs.iter().map(|pair| pair.pressure).reduce(larger)?;
    let same = |pair: &EdgeState| pair.pressure >= largest * (1.0 - ROUNDING);
    let first = pairs.iter().position(same)?;
    let count = pairs[first..].iter().take_while(|pair| same(pair)).count();
    Some([first, first + count - 1])
}

/// Top of a fit over the largest mean, beyond which it is none of the profile: of pairs of very unlike lengths.
pub(super) const BEYOND: f64 = 2.0;

/// The widest fit around some pairs, unless a narrower one departs far less from its means; the largest mean where its
/// top lies far above that.
fn around(pairs: &[EdgeState], at: [usize; 2]) -> Fit {
    let widest = window(pairs, at, DROP);
    let (mut count, mut best) = (widest.clone().count(), over(pairs, widest));
    let size = pairs[at[0]].pressure.abs();
    for halving in 1..=HALVINGS {
        let own = window(pairs, at, DROP * 0.5_f64.powi(halving));
        if best.misfit <= MISFIT * size || own.clone().count() < NARROW {
            break;
        }
        if own.clone().count() < count {
            count = own.clone().count();
            let narrower = over(pairs, own);
            best = if narrower.misfit <= BETTER * best.misfit { narrower } else { best };
        }
    }
    if best.top().pressure <= BEYOND * size { best } else { over(pairs, at[0]..=at[1]) }
}

/// A quartic over the means of some pairs; a parabola, or their mean, over few.
fn over(pairs: &[EdgeState], own: RangeInclusive<usize>) -> Fit {
    let count = match own.clone().count() {
        n if n >= QUARTIC => QUARTIC,
        n if n >= PARABOLA => PARABOLA,
        _ => 1,
    };
    Fit::of_means(pairs, own, count)
}

/// Pressed pairs around some: those that differ from them by no more than a drop, and as many as a polynomial needs.
fn window(pairs: &[EdgeState], [from, to]: [usize; 2], drop: f64) -> RangeInclusive<usize> {
    let size = pairs[from].pressure.max(pairs[to].pressure);
    let pressed = |k: usize| pairs[k].pressure > 0.0;
    let off = |k: usize| (pairs[k].pressure - size).abs() / size;
    let (mut first, mut last) = (from, to);
    loop {
        let before = first.checked_sub(1).filter(|&k| pressed(k));
        let after = Some(last + 1).filter(|&k| k < pairs.len() && pressed(k));
        let allowed = match last - first + 1 {
            n if n < PARABOLA => f64::INFINITY,
            n if n < QUARTIC => FAR,
            _ => drop,
        };
        let within = |k: &usize| off(*k) <= allowed;
        match (before.filter(within), after.filter(within)) {
            // The nearer one in pressure first, so that the window stays around them.
            (Some(k), Some(l)) if off(k) <= off(l) => first = k,
            (_, Some(l)) => last = l,
            (Some(k), None) => first = k,
            (None, None) => return first..=last,
        }
    }
}

/// How well its elements draw the top of a profile.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drawn {
    /// Largest fourth difference of the means over pairs at the highest one and its neighbours, over that mean:
    /// `3 (h/a)⁴` in the middle of a semi-ellipse, and of order one of a top that is narrower than its elements. 0
    /// without pressure, NaN where that is no number.
    pub rough: f64,
    /// Pressed edges between the highest one and the nearer end of its stretch.
    pub from_end: usize,
}

/// How well the edges of a contact draw its top; beyond them there is no pressure.
pub fn drawn(edges: &[EdgeState], floor: f64) -> Drawn {
    let pairs = pairs(edges);
    let Some([first, last]) = highest(&pairs) else { return Drawn { rough: f64::NAN, from_end: 0 } };
    if pairs[first].pressure <= 0.0 {
        return Drawn::default();
    }
    let pressure = |k: usize| pairs.get(k).map_or(0.0, |pair| pair.pressure);
    // The mean of a parabola over a circle is above that over the strip which the means over rings continue, by a sixth
    // of what the rings fall from the first to the second.
    let above_strip = |k: usize| {
        let is_circle = pairs[k].axis.is_some_and(|axis| pairs[k].ends[0] < axis && axis < pairs[k].ends[1]);
        if is_circle { (pressure(k + 1) - pressure(k + 2)) / 6.0 } else { 0.0 }
    };
    let within = |k: isize| usize::try_from(k).ok().filter(|&k| k < pairs.len());
    let mean = |k: isize| within(k).map_or(0.0, |k| pressure(k) - above_strip(k));
    let difference = |k: isize| 6.0 * mean(k) - 4.0 * (mean(k - 1) + mean(k + 1)) + mean(k - 2) + mean(k + 2);
    let around = first as isize - 1..=last as isize + 1;
    let rough = around.map(|k| difference(k).abs()).fold(0.0, larger) / pairs[first].pressure;
    let top = edges.iter().enumerate().max_by(|a, b| a.1.pressure.total_cmp(&b.1.pressure)).map_or(0, |(k, _)| k);
    let pressed = |edge: &&EdgeState| edge.pressure > floor;
    let above = edges[top + 1..].iter().take_while(pressed).count();
    // On a symmetry line a stretch goes on.
    let below = edges[..top].iter().rev().take_while(pressed).count();
    let below = if below == top && on_one_side(edges) { usize::MAX } else { below };
    Drawn { rough, from_end: above.min(below) }
}
