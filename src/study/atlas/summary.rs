//! What the atlas says of each method: where every run ends right, how the others end, and from where to start.

use crate::study::atlas::chart::Chart;
use crate::study::atlas::plane::Plane;
use crate::study::atlas::record::{Record, same};
use crate::study::class::Class;
use crate::study::method::Method;

/// Planes over all scenes, meshes and candidate stretches, each with the same initial stiffnesses.
const SCENES: [Plane; 4] = [Plane::Stretch, Plane::Mesh, Plane::Cylinder, Plane::PinRod];

/// What the scenes say of a method.
#[derive(Clone, Debug)]
pub struct Digest {
    /// What was run.
    pub method: Method,
    /// Where every run ends right.
    pub safe: Option<Safe>,
    /// Runs by how they ended.
    pub ends: Vec<(Class, usize)>,
    /// Runs that had a prediction.
    pub predicted: usize,
}

/// The longest range of initial stiffnesses from which every run ends right.
#[derive(Clone, Copy, Debug)]
pub struct Safe {
    /// Softest start of the range.
    pub from: f64,
    /// Hardest start of the range.
    pub to: f64,
    /// Most iterations of any run in the range.
    pub iterations: usize,
    /// The start with the fewest iterations in the worst case.
    pub best: f64,
    /// Most iterations of any run from there.
    pub best_iterations: usize,
}

impl Safe {
    /// Decades of the range.
    pub fn decades(&self) -> f64 {
        (self.to / self.from).log10()
    }

    /// Whether the range is wider than another, if there is one.
    pub fn is_wider_than(&self, other: Option<Self>) -> bool {
        other.is_none_or(|other| self.decades() > other.decades() && !same(self.decades(), other.decades()))
    }
}

/// Digests of every method, element by element.
pub fn digests(charts: &[&Chart]) -> Vec<Digest> {
    Method::all().into_iter().map(|method| digest(charts, method)).collect()
}

fn digest(charts: &[&Chart], method: Method) -> Digest {
    let scenes = charts.iter().filter(|chart| SCENES.contains(&chart.plane));
    let rows: Vec<&[Record]> = scenes.flat_map(|chart| chart.of_method(method)).collect();
    let all = || rows.iter().flat_map(|row| row.iter());
    let count = |class: Class| (class, all().filter(|record| record.class == class).count());
    Digest {
        method,
        safe: safe(&rows, method.algorithm.default_stiffness()),
        ends: Class::ALL.map(count).into_iter().filter(|(_, number)| *number > 0).collect(),
        predicted: all().filter(|record| !record.predicted_iterations.is_nan()).count(),
    }
}

/// The range, from rows with the same initial stiffnesses; of equal starts the one nearest to the algorithm's own is the best.
fn safe(rows: &[&[Record]], usual: f64) -> Option<Safe> {
    let columns = rows.first().map_or(0, |row| row.len());
    let column = |c: usize| rows.iter().map(move |row| &row[c]);
    let [from, to] = longest_run(columns, |c| column(c).all(Record::is_right))?;
    let stiffness = |c: usize| rows[0][c].stiffness;
    let worst = |c: usize| column(c).map(|record| record.iterations).max().unwrap_or(0);
    let away = |c: usize| (stiffness(c) / usual).ln().abs();
    let better = |a: &usize, b: &usize| worst(*a).cmp(&worst(*b)).then(away(*a).total_cmp(&away(*b)));
    let best = (from..=to).min_by(better)?;
    Some(Safe {
        from: stiffness(from),
        to: stiffness(to),
        iterations: (from..=to).map(worst).max()?,
        best: stiffness(best),
        best_iterations: worst(best),
    })
}

/// First and last of the longest run of numbers that hold.
fn longest_run(count: usize, holds: impl Fn(usize) -> bool) -> Option<[usize; 2]> {
    let mut best: Option<[usize; 2]> = None;
    let mut start = None;
    for c in 0..=count {
        match (c < count && holds(c), start) {
            (true, None) => start = Some(c),
            (false, Some(from)) => {
                if best.is_none_or(|[a, b]| c - from > b - a + 1) {
                    best = Some([from, c - 1]);
                }
                start = None;
            }
            _ => {}
        }
    }
    best
}
