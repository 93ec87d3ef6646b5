//! What the paper says of iterations, sentence by sentence: whether it holds, and the numbers that it rests on.

use serde::Serialize;

use crate::measure::larger;
use crate::named::named_enum;
use crate::solve::{Element, Iteration};

named_enum! {
    /// A sentence of the paper.
    pub enum Sentence {
        /// Good agreement with the exact solution for every combination.
        Agrees = "Every combination is in good agreement with the exact solution (Figs 10, 14, 15)",
        /// The iterations of varying stiffness depend strongly on the initial stiffness.
        VaryingDepends = "The iterations of varying stiffness depend strongly on the initial stiffness (Fig. 11, §5)",
        /// Those of constant stiffness do.
        ConstantDepends = "The iterations of constant stiffness depend strongly on the initial stiffness (Fig. 11, §5)",
        /// In some cases there was no convergence at all.
        Fails = "In some cases there was no convergence found at all (Fig. 11, §5)",
        /// Varying stiffness is more stable than constant stiffness.
        MoreStable = "Varying stiffness is much more stable than constant stiffness (Fig. 11)",
        /// Varying stiffness with line elements converges in every case.
        LineAlways = "With varying stiffness and line elements convergence was found in every case (Fig. 11, §5)",
        /// Provided that line elements are used: with layer elements it does not.
        Proviso = "… provided that line elements have been used: with layer elements not in every case (§5)",
        /// Kinematic load with node elements converges in two iterations for any initial stiffness.
        TwoSteps = "Kinematic load with node elements converged in two iterations for any initial stiffness, in both examples",
        /// It takes fewer iterations than the others.
        Fewest = "Kinematic load takes the fewest iterations",
        /// It needs the least computing time.
        LeastWork = "Kinematic load takes the least computing time (counted in operations)",
        /// Constant stiffness saves operations against varying stiffness.
        Saves = "Constant stiffness needs one factorisation only and saves a great deal of operations against varying stiffness",
        /// The second example shows the same convergence properties as the first.
        Alike = "For the pin–rod the elements and algorithms converge as they do for the cylinder",
    }
}

/// Error of a peak up to which a chart shows good agreement.
pub const GOOD: f64 = 0.05;
/// Most over fewest iterations from which a dependence is strong.
pub const STRONG: f64 = 3.0;
/// Iterations of kinematic load.
const TWO: usize = 2;

/// When a criterion was met.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Met {
    /// Iterations until then.
    pub iterations: usize,
    /// Error of the peak against the discrete solution then.
    pub error: f64,
}

/// A run from one start under a reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Dofs of the condensed system.
    pub retained: usize,
    /// When the criterion was met; none where the cap came first.
    pub met: Option<Met>,
}

/// The starts of one example under a reading, as far as the paper shows them.
pub struct Seen {
    /// Elements with their algorithms and starts.
    pub of: Vec<(Element, Iteration, Vec<End>)>,
}

impl End {
    /// Operations of a dense Cholesky factorisation a run, or an iteration but for constant stiffness, and a pair of substitutions an
    /// iteration.
    fn operations(&self, algorithm: Iteration) -> Option<f64> {
        let [n, iterations] = [self.retained as f64, self.met?.iterations as f64];
        let factorisations = if algorithm == Iteration::Constant { 1.0 } else { iterations };
        Some(factorisations * n.powi(3) / 3.0 + 2.0 * iterations * n * n)
    }
}

/// Fewest and most iterations of the starts that ended; none where none did.
fn extremes<'a>(ends: impl IntoIterator<Item = &'a End>) -> Option<[usize; 2]> {
    let iterations: Vec<usize> = ends.into_iter().filter_map(|end| Some(end.met?.iterations)).collect();
    Some([*iterations.iter().min()?, *iterations.iter().max()?])
}

/// Starts that ended.
fn ended(ends: &[End]) -> usize {
    ends.iter().filter(|end| end.met.is_some()).count()
}

/// Whether all did.
fn none_fails(ends: &[End]) -> bool {
    ended(ends) == ends.len()
}

/// Largest error of those that ended.
fn error(ends: &[End]) -> f64 {
    ends.iter().filter_map(|end| end.met).map(|met| met.error).fold(0.0, larger)
}

/// Whether the same starts end; beside one where that changes a neighbour may stand in.
fn nearly_alike(ours: &[End], theirs: &[End]) -> bool {
    let is_alike = |(k, own): (usize, &End)| {
        let near = &theirs[k.saturating_sub(1)..(k + 2).min(theirs.len())];
        near.iter().any(|other| other.met.is_some() == own.met.is_some())
    };
    ours.len() == theirs.len() && ours.iter().enumerate().all(is_alike)
}

impl Seen {
    /// The elements of an algorithm with their starts.
    fn by(&self, algorithm: Iteration) -> impl Iterator<Item = (Element, &[End])> {
        self.of.iter().filter(move |one| one.1 == algorithm).map(|(element, _, ends)| (*element, ends.as_slice()))
    }

    /// The starts of an element with an algorithm.
    pub fn starts(&self, element: Element, algorithm: Iteration) -> &[End] {
        self.by(algorithm).find(|(own, _)| *own == element).map_or(&[], |(_, ends)| ends)
    }

    /// Those of kinematic load.
    fn kinematic(&self) -> &[End] {
        self.starts(Element::Node, Iteration::Kinematic)
    }

    /// All others.
    fn others(&self) -> impl Iterator<Item = &[End]> {
        self.of.iter().filter(|one| one.1 != Iteration::Kinematic).map(|one| one.2.as_slice())
    }

    /// Whether the iterations of an algorithm depend strongly on the start, with every element.
    fn depends(&self, algorithm: Iteration) -> bool {
        self.by(algorithm).all(|(_, ends)| extremes(ends).is_some_and(|[low, high]| high as f64 >= STRONG * low as f64))
    }

    /// Operations of varying over those of constant stiffness, from every start where both end.
    fn over_constant(&self) -> Vec<f64> {
        use Iteration::{Constant, Varying};
        let own = self.by(Varying).flat_map(|(element, ends)| ends.iter().zip(self.starts(element, Constant)));
        own.filter_map(|(a, b)| Some(a.operations(Varying)? / b.operations(Constant)?)).collect()
    }

    /// Operations of each other algorithm over those of kinematic load, from every start where both end.
    fn over_kinematic(&self) -> Vec<f64> {
        let others = self.of.iter().filter(|one| one.1 != Iteration::Kinematic);
        let pairs = others.flat_map(|one| one.2.iter().zip(self.kinematic()).map(|(a, b)| (one.1, a, b)));
        pairs.filter_map(|(of, a, b)| Some(a.operations(of)? / b.operations(Iteration::Kinematic)?)).collect()
    }
}

/// Whether every quotient is above one; of none nothing is known.
fn all_above_one(quotients: &[f64]) -> bool {
    !quotients.is_empty() && quotients.iter().all(|quotient| *quotient > 1.0)
}

impl Sentence {
    /// Whether it holds in both examples; where starts are missing nothing does.
    pub fn holds(self, seen: &[Seen; 2]) -> bool {
        let is_there = |seen: &Seen| seen.of.iter().all(|(_, _, ends)| !ends.is_empty());
        seen.iter().all(|seen| is_there(seen) && self.holds_in(seen))
            && (self != Self::Alike || seen[0].of.iter().zip(&seen[1].of).all(|(a, b)| nearly_alike(&a.2, &b.2)))
    }

    fn holds_in(self, seen: &Seen) -> bool {
        match self {
            Self::Agrees => seen.of.iter().all(|(_, _, ends)| ended(ends) > 0 && error(ends) <= GOOD),
            Self::VaryingDepends => seen.depends(Iteration::Varying),
            Self::ConstantDepends => seen.depends(Iteration::Constant),
            Self::Fails => !seen.others().all(none_fails),
            Self::MoreStable => seen
                .by(Iteration::Varying)
                .all(|(element, ends)| ended(ends) > ended(seen.starts(element, Iteration::Constant))),
            Self::LineAlways => none_fails(seen.starts(Element::Line, Iteration::Varying)),
            Self::Proviso => !none_fails(seen.starts(Element::Layer, Iteration::Varying)),
            Self::TwoSteps => {
                none_fails(seen.kinematic()) && extremes(seen.kinematic()).is_some_and(|[_, most]| most <= TWO)
            }
            Self::Fewest => {
                let [own, others] = [extremes(seen.kinematic()), extremes(seen.others().flatten())];
                none_fails(seen.kinematic()) && own.zip(others).is_some_and(|([_, most], [least, _])| most < least)
            }
            Self::LeastWork => all_above_one(&seen.over_kinematic()),
            Self::Saves => all_above_one(&seen.over_constant()),
            Self::Alike => true,
        }
    }

    /// The numbers that it rests on, of the first example and of the second.
    pub fn numbers(self, seen: &[Seen; 2]) -> String {
        use Iteration::{Constant, Varying};
        let both = |text: &dyn Fn(&Seen) -> String| seen.each_ref().map(text).join(" and ");
        match self {
            Self::Agrees => {
                let worst = |seen: &Seen| 100.0 * seen.of.iter().map(|(_, _, ends)| error(ends)).fold(0.0, larger);
                format!("peak of what ended off by up to {}", both(&|seen| format!("{:.1} %", worst(seen))))
            }
            Self::VaryingDepends => format!("most over fewest iterations {}", both(&|seen| ratios(seen, Varying))),
            Self::ConstantDepends => format!("most over fewest iterations {}", both(&|seen| ratios(seen, Constant))),
            Self::Fails | Self::MoreStable | Self::Alike => {
                let of =
                    |algorithm: Iteration| format!("{} {}", algorithm.name(), both(&|seen| counts(seen, algorithm)));
                format!("starts that ended: {}; {}", of(Varying), of(Constant))
            }
            Self::LineAlways => {
                format!("starts that ended: {}", both(&|seen| count(seen.starts(Element::Line, Varying))))
            }
            Self::Proviso => {
                format!("starts that ended: {}", both(&|seen| count(seen.starts(Element::Layer, Varying))))
            }
            Self::TwoSteps => format!("{} iterations", both(&|seen| range(seen.kinematic()))),
            Self::Fewest => {
                let others = both(&|seen| range(seen.others().flatten()));
                format!("{} iterations, the others {others}", both(&|seen| range(seen.kinematic())))
            }
            Self::LeastWork => {
                format!("operations, the others' over kinematic's: {}", both(&|seen| quotients(&seen.over_kinematic())))
            }
            Self::Saves => {
                format!("operations, varying's over constant's: {}", both(&|seen| quotients(&seen.over_constant())))
            }
        }
    }
}

/// Most over fewest iterations with each element.
fn ratios(seen: &Seen, algorithm: Iteration) -> String {
    let ratio = |(element, ends): (Element, &[End])| match extremes(ends) {
        Some([low, high]) => format!("{:.1} ({})", high as f64 / low as f64, element.name()),
        None => format!("– ({})", element.name()),
    };
    seen.by(algorithm).map(ratio).collect::<Vec<_>>().join(", ")
}

/// `8 of 10 (line), …`.
fn counts(seen: &Seen, algorithm: Iteration) -> String {
    let own = seen.by(algorithm).map(|(element, ends)| format!("{} ({})", count(ends), element.name()));
    own.collect::<Vec<_>>().join(", ")
}

fn count(ends: &[End]) -> String {
    format!("{} of {}", ended(ends), ends.len())
}

/// Fewest and most iterations.
fn range<'a>(ends: impl IntoIterator<Item = &'a End>) -> String {
    match extremes(ends) {
        Some([low, high]) if low < high => format!("{low} to {high}"),
        Some([low, _]) => low.to_string(),
        None => "no".into(),
    }
}

fn quotients(all: &[f64]) -> String {
    let low = all.iter().copied().fold(f64::INFINITY, f64::min);
    format!("{low:.2} to {:.0}", all.iter().copied().fold(0.0, larger))
}
