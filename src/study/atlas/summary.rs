//! What the atlas says of each method: where every run ends right, how the others end, and which to use from where.

use std::fmt::Write;

use crate::algorithm::StiffnessRule;
use crate::solve::Ended;
use crate::solve::Iteration;
use crate::study::atlas::record::{Chart, Record, same};
use crate::study::method::Method;

/// What the scenes say of a method: the planes over scenes, meshes and candidate stretches, which have the same initial stiffnesses.
#[derive(Clone, Debug)]
pub struct Digest {
    /// What was run.
    pub method: Method,
    /// Where every run ends right.
    pub safe: Option<Safe>,
    /// Runs by how they ended.
    pub ends: Vec<(Ended, usize)>,
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
    /// Whether the range has more decades than another, if there is one.
    pub fn is_wider_than(&self, other: Option<Self>) -> bool {
        let decades = |range: &Self| (range.to / range.from).log10();
        let own = decades(self);
        other.is_none_or(|other| own > decades(&other) && !same(own, decades(&other)))
    }
}

/// Digests of every method, element by element.
pub fn digests(charts: &[&Chart]) -> Vec<Digest> {
    Method::all().into_iter().map(|method| digest(charts, method)).collect()
}

fn digest(charts: &[&Chart], method: Method) -> Digest {
    let scenes = charts.iter().filter(|chart| !chart.plane.is_slice());
    let rows: Vec<&[Record]> = scenes.flat_map(|chart| chart.of_method(method)).collect();
    let all = || rows.iter().flat_map(|row| row.iter());
    let count = |class: Ended| (class, all().filter(|record| record.class == class).count());
    Digest {
        method,
        safe: safe(&rows, method.algorithm.default_stiffness()),
        ends: Ended::ALL.map(count).into_iter().filter(|(_, number)| *number > 0).collect(),
        predicted: all().filter(|record| record.predicted_iterations.is_some()).count(),
    }
}

/// The range, from rows with the same initial stiffnesses; of equal starts the one nearest to the algorithm's own is the best.
fn safe(rows: &[&[Record]], usual: f64) -> Option<Safe> {
    let columns = rows.first().map_or(0, |row| row.len());
    let column = |c: usize| rows.iter().map(move |row| &row[c]);
    let right: Vec<usize> = (0..columns).filter(|&c| column(c).all(Record::is_right)).collect();
    // Of equally long ranges the first.
    let range = right.chunk_by(|a, b| a + 1 == *b).rev().max_by_key(|range| range.len())?;
    let stiffness = |c: usize| rows[0][c].stiffness;
    let worst = |c: usize| column(c).map(|record| record.iterations).max().unwrap_or(0);
    let away = |c: usize| (stiffness(c) / usual).ln().abs();
    let better = |a: &usize, b: &usize| worst(*a).cmp(&worst(*b)).then(away(*a).total_cmp(&away(*b)));
    let best = range.iter().copied().min_by(better)?;
    Some(Safe {
        from: stiffness(range[0]),
        to: stiffness(range[range.len() - 1]),
        iterations: range.iter().copied().map(worst).max()?,
        best: stiffness(best),
        best_iterations: worst(best),
    })
}

/// Which element and algorithm to use from which initial stiffness, and which not.
pub fn recommendation(digests: &[Digest]) -> String {
    let points: usize = digests.iter().flat_map(|digest| &digest.ends).map(|(_, count)| count).sum();
    let predicted: usize = digests.iter().map(|digest| digest.predicted).sum();
    let mut text = format!(
        "From {points} runs over candidate surface, mesh and both paper scenes, {predicted} of them predicted before they were run:\n\n"
    );
    let reliable = reliable(digests);
    let constant = reliable.iter().find(|(method, _)| method.algorithm == Iteration::Constant);
    if let Some(first) = reliable.iter().find(|(method, _)| !method.is_accelerated()) {
        let _ = writeln!(text, "* **Use** {}.", sentence(first));
    }
    if let Some(constant) = constant {
        let _ = writeln!(text, "* **Where one factorisation must do**: {}.", sentence(constant));
    }
    let widest = widest(&reliable);
    if !widest.is_empty() {
        let _ = writeln!(text, "* **Where nothing is known of the stiffness**: {}.", widest.join(", "));
    }
    let nowhere = digests.iter().filter(|digest| digest.safe.is_none());
    let nowhere: Vec<String> = nowhere.map(|digest| format!("`{}`", digest.method)).collect();
    if !nowhere.is_empty() {
        let _ =
            writeln!(text, "* **Do not use** {}: at no initial stiffness do all runs end right.", nowhere.join(", "));
    }
    text
}

/// The method to use, of those to which nothing is added; none where there is none of which every surveyed run ends right.
pub fn recommended(digests: &[Digest]) -> Option<Method> {
    reliable(digests).into_iter().map(|(method, _)| method).find(|method| !method.is_accelerated())
}

/// Methods with a range, fewest iterations first; a penalty stops at a penetration of its own and is not among them.
fn reliable(digests: &[Digest]) -> Vec<(Method, Safe)> {
    let exact = digests.iter().filter(|digest| digest.method.rule != StiffnessRule::Penalty);
    let mut reliable: Vec<(Method, Safe)> =
        exact.filter_map(|digest| digest.safe.map(|safe| (digest.method, safe))).collect();
    reliable.sort_by_key(|(_, safe)| safe.best_iterations);
    reliable
}

fn sentence((method, safe): &(Method, Safe)) -> String {
    let Safe { from, to, best, best_iterations, .. } = safe;
    format!(
        "`{method}` from κ₀ = {best:e} (at most {best_iterations} iterations; every surveyed run ends right for κ₀ from {from:e} to {to:e})"
    )
}

/// The methods whose range no other's exceeds.
fn widest(reliable: &[(Method, Safe)]) -> Vec<String> {
    let is_widest = |safe: &Safe| !reliable.iter().any(|(_, other)| other.is_wider_than(Some(*safe)));
    let widest = reliable.iter().filter(|(_, safe)| is_widest(safe));
    let told = |(method, Safe { from, to, iterations, .. }): &(Method, Safe)| {
        format!("`{method}` (at most {iterations} iterations from any κ₀ from {from:e} to {to:e})")
    };
    widest.map(told).collect()
}
