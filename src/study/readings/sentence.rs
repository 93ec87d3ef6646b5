//! What the paper says of iterations, sentence by sentence, and whether it holds under a reading.

use crate::named::named_enum;
use crate::solve::{Element, Iteration};
use crate::study::readings::course::is_shown;
use crate::study::readings::reading::{End, ended, error, extremes};

named_enum! {
    /// A sentence of the paper.
    pub enum Sentence {
        /// Good agreement with the exact solution for every combination.
        Agrees = "good agreement for every combination",
        /// The iterations of varying stiffness depend strongly on the initial stiffness.
        VaryingDepends = "varying: iterations depend strongly on κ₀",
        /// Those of constant stiffness do.
        ConstantDepends = "constant: iterations depend strongly on κ₀",
        /// In some cases there was no convergence at all.
        Fails = "in some cases no convergence",
        /// Varying stiffness is more stable than constant stiffness.
        MoreStable = "varying more stable than constant",
        /// Varying stiffness with line elements converges in every case.
        LineAlways = "varying with line elements converges in every case",
        /// Provided that line elements are used: with layer elements it does not.
        Proviso = "with layer elements it does not",
        /// Kinematic load with node elements converges in two iterations for any initial stiffness.
        TwoSteps = "kinematic with node elements: two iterations from any κ₀",
        /// It takes fewer iterations than the others.
        Fewest = "kinematic takes the fewest iterations",
        /// It needs the least computing time.
        LeastWork = "kinematic takes the fewest operations",
        /// Constant stiffness saves operations against varying stiffness.
        Saves = "constant saves operations against varying",
        /// The second example shows the same convergence properties as the first.
        Alike = "the pin–rod converges as the cylinder does",
    }
}

/// Error of a peak up to which a chart shows good agreement.
pub const GOOD: f64 = 0.05;
/// Most over fewest iterations from which a dependence is strong.
pub const STRONG: f64 = 3.0;
/// Iterations of kinematic load.
const TWO: usize = 2;

/// The starts of one example under a reading, as far as the paper shows them, or of all nine formulations.
pub struct Seen {
    of: Vec<(Element, Iteration, Vec<End>)>,
}

impl Seen {
    /// Of all nine formulations.
    pub fn nine(of: Vec<(Element, Iteration, Vec<End>)>) -> Self {
        Self { of }
    }

    /// Of the paper's five combinations.
    pub fn five(of: Vec<(Element, Iteration, Vec<End>)>) -> Self {
        Self { of: of.into_iter().filter(|(element, algorithm, _)| is_shown(*element, *algorithm)).collect() }
    }

    /// Every element with an algorithm and its starts.
    pub fn all(&self) -> impl Iterator<Item = (Element, Iteration, &[End])> {
        self.of.iter().map(|(element, algorithm, ends)| (*element, *algorithm, ends.as_slice()))
    }

    /// The elements of an algorithm with their starts.
    pub fn by(&self, algorithm: Iteration) -> impl Iterator<Item = (Element, &[End])> {
        self.of.iter().filter(move |one| one.1 == algorithm).map(|(element, _, ends)| (*element, ends.as_slice()))
    }

    /// The starts of an element with an algorithm.
    pub fn starts(&self, element: Element, algorithm: Iteration) -> &[End] {
        self.by(algorithm).find(|(own, _)| *own == element).map_or(&[], |(_, ends)| ends)
    }

    /// Whether a start is missing, so that nothing can be said.
    fn is_empty(&self) -> bool {
        self.of.iter().any(|(_, _, ends)| ends.is_empty())
    }

    /// Whether the iterations of an algorithm depend strongly on the start, with every element.
    fn depends(&self, algorithm: Iteration) -> bool {
        self.by(algorithm).all(|(_, ends)| extremes(ends).is_some_and(|[low, high]| high as f64 >= STRONG * low as f64))
    }

    /// Operations of varying and of constant stiffness from every start where both end.
    pub fn of_constant(&self) -> Vec<[f64; 2]> {
        let pairs = self.by(Iteration::Varying).flat_map(|(element, varying)| {
            let constant = self.starts(element, Iteration::Constant);
            varying.iter().zip(constant).filter_map(|(a, b)| Some([a.operations(true)?, b.operations(false)?]))
        });
        pairs.collect()
    }

    /// Operations of each other algorithm and of kinematic load with node elements from every start where both end.
    pub fn of_kinematic(&self) -> Vec<[f64; 2]> {
        let own = self.starts(Element::Node, Iteration::Kinematic);
        let others = [(Iteration::Varying, true), (Iteration::Constant, false)].into_iter();
        let pairs = others.flat_map(|(algorithm, factorises)| {
            self.by(algorithm).flat_map(move |(_, ends)| {
                let pair = move |(a, b): (&End, &End)| Some([a.operations(factorises)?, b.operations(true)?]);
                ends.iter().zip(own).filter_map(pair)
            })
        });
        pairs.collect()
    }
}

/// Whether the second of every pair is the smaller one; of none nothing is known.
fn is_less(pairs: &[[f64; 2]]) -> bool {
    !pairs.is_empty() && pairs.iter().all(|[other, own]| own < other)
}

/// Whether the same starts end; beside one where that changes a neighbour, half a decade away, may stand in.
fn nearly_alike(ours: &[End], theirs: &[End]) -> bool {
    let ends = |end: &End| end.iterations.is_some();
    ours.len() == theirs.len()
        && ours.iter().enumerate().all(|(k, own)| {
            let near = &theirs[k.saturating_sub(1)..(k + 2).min(theirs.len())];
            near.iter().any(|other| ends(other) == ends(own))
        })
}

impl Sentence {
    /// Whether it holds in one example; of two the last alone speaks.
    pub fn holds_in(self, seen: &Seen) -> bool {
        if seen.is_empty() {
            return false;
        }
        let all = || seen.of.iter().map(|(_, _, ends)| ends.as_slice());
        let none_fails = |ends: &[End]| ended(ends) == ends.len();
        match self {
            Self::Agrees => all().all(|ends| ended(ends) > 0 && error(ends) <= GOOD),
            Self::VaryingDepends => seen.depends(Iteration::Varying),
            Self::ConstantDepends => seen.depends(Iteration::Constant),
            Self::Fails => {
                let own = [Iteration::Varying, Iteration::Constant];
                own.into_iter().flat_map(|algorithm| seen.by(algorithm)).any(|(_, ends)| !none_fails(ends))
            }
            Self::MoreStable => seen
                .by(Iteration::Varying)
                .all(|(element, ends)| ended(ends) > ended(seen.starts(element, Iteration::Constant))),
            Self::LineAlways => none_fails(seen.starts(Element::Line, Iteration::Varying)),
            Self::Proviso => !none_fails(seen.starts(Element::Layer, Iteration::Varying)),
            Self::TwoSteps => {
                let own = seen.starts(Element::Node, Iteration::Kinematic);
                none_fails(own) && extremes(own).is_some_and(|[_, most]| most <= TWO)
            }
            Self::Fewest => {
                let own = seen.starts(Element::Node, Iteration::Kinematic);
                let others = seen.by(Iteration::Varying).chain(seen.by(Iteration::Constant));
                let least = others.filter_map(|(_, ends)| extremes(ends)).map(|[least, _]| least).min();
                none_fails(own) && extremes(own).zip(least).is_some_and(|([_, most], least)| most < least)
            }
            Self::Saves => is_less(&seen.of_constant()),
            Self::LeastWork => is_less(&seen.of_kinematic()),
            Self::Alike => true,
        }
    }

    /// Whether it holds in both.
    pub fn holds(self, seen: &[Seen; 2]) -> bool {
        let alike = || {
            let pairs = seen[0].of.iter().zip(&seen[1].of);
            pairs.into_iter().all(|(a, b)| nearly_alike(&a.2, &b.2))
        };
        seen.iter().all(|seen| self.holds_in(seen)) && (self != Self::Alike || alike())
    }
}
