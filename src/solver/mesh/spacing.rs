//! One-dimensional spacing laws: lists of positions from which structured blocks are built.

use crate::mesh::Order;

/// `n` equal intervals from `from` to `to`: `n + 1` positions.
pub fn uniform(from: f64, to: f64, n: usize) -> Vec<f64> {
    stretched(from, to, n, 1.0)
}

/// `n` intervals in geometric progression; the last is `end` times the first.
pub fn stretched(from: f64, to: f64, n: usize, end: f64) -> Vec<f64> {
    let ratio = if n > 1 { end.powf(1.0 / (n as f64 - 1.0)) } else { 1.0 };
    let sizes = (0..n).map(|k| ratio.powi(k as i32)).collect();
    positions(from, to, sizes)
}

/// About `n` intervals in geometric progression, the last `end` times the first, and none longer than that asks by more
/// than a twentieth: every one of the ascending `breaks` between the ends is a position.
pub fn broken(from: f64, to: f64, n: usize, end: f64, breaks: &[f64]) -> Vec<f64> {
    let asked = stretched(from, to, n, end);
    // Positions and places among them count from 0 on.
    let count = |place: f64| {
        let k = asked.partition_point(|position| *position <= place).clamp(1, n) - 1;
        k as f64 + (place - asked[k]) / (asked[k + 1] - asked[k])
    };
    let place = |count: f64| {
        let k = (count as usize).min(n - 1);
        asked[k] + (asked[k + 1] - asked[k]) * (count - k as f64)
    };
    let mut all = vec![from];
    let mut begin = 0.0;
    let within = breaks.iter().copied().filter(|place| *place > from && *place < to);
    for next in within.chain([to]) {
        let last = all[all.len() - 1];
        if next < to && (next - last <= TOGETHER * (to - from) || to - next <= TOGETHER * (to - from)) {
            continue;
        }
        let length = count(next) - begin;
        let parts = (length - ROUNDED).ceil().max(1.0);
        all.extend((1..parts as usize).map(|k| place(begin + length * k as f64 / parts)));
        all.push(next);
        begin = count(next);
    }
    all
}

/// Distance of two breaks, over the whole length, up to which they share a position.
const TOGETHER: f64 = 1e-6;

/// Intervals growing from `first` by `ratio` up to `coarsest`, scaled to end at `to` exactly.
pub fn growing(from: f64, to: f64, first: f64, ratio: f64, coarsest: f64) -> Vec<f64> {
    let length = (to - from).abs();
    let mut sizes = Vec::new();
    let (mut size, mut covered) = (first, 0.0);
    while covered < length * (1.0 - 1e-9) {
        sizes.push(size);
        covered += size;
        size = (size * ratio).min(coarsest.max(first));
    }
    let surplus = covered - length;
    if sizes.len() > 1 && surplus > 0.5 * sizes[sizes.len() - 1] {
        sizes.pop();
    }
    positions(from, to, sizes)
}

/// Intervals growing by `ratio` from `ends[0]` at the start and from `ends[1]` at the end up to `coarsest` between
/// them, scaled to end at `to` exactly.
pub fn growing_from_both(from: f64, to: f64, ends: [f64; 2], ratio: f64, coarsest: f64) -> Vec<f64> {
    let length = (to - from).abs();
    let [mut first, mut last] = ends;
    let (mut at_start, mut at_end, mut covered) = (Vec::new(), Vec::new(), 0.0);
    while covered < length * (1.0 - 1e-9) {
        let (sizes, size) = if first <= last { (&mut at_start, &mut first) } else { (&mut at_end, &mut last) };
        sizes.push(*size);
        covered += *size;
        *size = (*size * ratio).min(coarsest.max(*size));
    }
    at_end.reverse();
    at_start.extend(at_end);
    positions(from, to, at_start)
}

/// Part of an interval that need not be one of its own.
const ROUNDED: f64 = 0.05;
/// Difference of positions, over the whole length, below which they are one.
const SAME: f64 = 1e-9;

/// Positions between two ends, with those of every fine stretch `[begin, end, size]` among them: within it intervals
/// have about its size at most, outside all of them they grow by `ratio` up to `coarsest`, and so they do away from a
/// finer one.
pub fn fine_within([from, to]: [f64; 2], fine: &[[f64; 3]], ratio: f64, coarsest: f64) -> Vec<f64> {
    let mut breaks: Vec<f64> = fine.iter().flat_map(|one| [one[0], one[1]]).chain([from, to]).collect();
    breaks.retain(|at| (from..=to).contains(at));
    breaks.sort_by(f64::total_cmp);
    breaks.dedup_by(|next, before| *next - *before <= SAME * (to - from));
    if let Some(last) = breaks.last_mut() {
        *last = to;
    }
    let size = |middle: f64| {
        let around = fine.iter().filter(|one| one[0] <= middle && middle <= one[1]);
        around.map(|one| one[2]).fold(f64::INFINITY, f64::min)
    };
    let sizes: Vec<f64> = breaks.windows(2).map(|ends| size(0.5 * (ends[0] + ends[1]))).collect();
    let lists = breaks.windows(2).enumerate().map(|(k, ends)| {
        let neighbour = |k: Option<usize>| k.and_then(|k| sizes.get(k)).copied().unwrap_or(f64::INFINITY);
        let beside = [neighbour(k.checked_sub(1)), neighbour(Some(k + 1))];
        let length = ends[1] - ends[0];
        if beside.iter().all(|beside| *beside >= sizes[k] * (1.0 - ROUNDED)) && sizes[k] < coarsest {
            return uniform(ends[0], ends[1], (length / sizes[k] - ROUNDED).ceil().max(1.0) as usize);
        }
        // Next to a finer neighbour the first interval is one ratio longer than its last.
        let first = beside.map(|beside| sizes[k].min(ratio * beside).min(coarsest));
        growing_from_both(ends[0], ends[1], first, ratio, sizes[k].min(coarsest))
    });
    joined(&lists.collect::<Vec<_>>())
}

/// `n` intervals in geometric progression, the first as near to `first` as `n` intervals allow.
pub fn fitted(from: f64, to: f64, n: usize, first: f64) -> Vec<f64> {
    let length = (to - from).abs();
    let covered = |ratio: f64| -> f64 { (0..n).map(|k| first * ratio.powi(k as i32)).sum() };
    let (mut low, mut high) = (0.2_f64, 5.0_f64);
    for _ in 0..200 {
        let ratio = 0.5 * (low + high);
        *if covered(ratio) < length { &mut low } else { &mut high } = ratio;
    }
    let sizes = (0..n).map(|k| low.powi(k as i32)).collect();
    positions(from, to, sizes)
}

/// Ascending positions, those of the places among them that lie between the ends: the nearest one is moved to a place,
/// or one is added where that was moved to another place, or would pass its neighbour.
pub fn through(positions: &[f64], places: &[f64]) -> Vec<f64> {
    let [from, .., to] = positions[..] else { return positions.to_vec() };
    let near = SAME * (to - from);
    let mut all = positions.to_vec();
    for place in places.iter().filter(|place| from + near < **place && **place < to - near) {
        let away = |k: &usize| (positions[*k] - place).abs();
        let nearest = (1..positions.len() - 1).min_by(|a, b| away(a).total_cmp(&away(b)));
        let between = |k: usize| all[k - 1] < *place && *place < all[k + 1];
        match nearest.filter(|k| all[*k] == positions[*k] && between(*k)) {
            Some(k) => all[k] = *place,
            None => all.push(*place),
        }
    }
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, before| *next - *before <= near);
    all
}

/// Joins lists that meet: the last position of one is the first of the next.
pub fn joined(lists: &[Vec<f64>]) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::new();
    for list in lists {
        let skip = usize::from(!all.is_empty());
        all.extend(list.iter().skip(skip));
    }
    all
}

/// Halves every interval `levels` times, so that meshes are nested, and puts the positions of a cell of an order into
/// each.
pub fn lattice(breaks: &[f64], levels: u32, order: Order) -> Vec<f64> {
    let (parts, own) = (1usize << levels, order.fractions());
    let within = &own[..order.intervals()];
    let mut all = Vec::with_capacity((breaks.len() - 1) * parts * within.len() + 1);
    for pair in breaks.windows(2) {
        let at = |k: usize, t: &f64| pair[0] + (pair[1] - pair[0]) * (k as f64 + t) / parts as f64;
        all.extend((0..parts).flat_map(|k| within.iter().map(move |t| at(k, t))));
    }
    all.extend(breaks.last());
    all
}

fn positions(from: f64, to: f64, sizes: Vec<f64>) -> Vec<f64> {
    let total: f64 = sizes.iter().sum();
    let mut covered = 0.0;
    let mut all = vec![from];
    for size in &sizes {
        covered += size;
        all.push(from + (to - from) * covered / total);
    }
    if let Some(last) = all.last_mut() {
        *last = to;
    }
    all
}
