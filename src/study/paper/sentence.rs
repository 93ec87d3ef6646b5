//! What the paper says of iterations, sentence by sentence: whether it holds, and the numbers that it rests on.

use crate::measure::larger;
use crate::named::named_enum;
use crate::solve::{Element, Iteration};

named_enum! {
    /// A sentence of the paper.
    pub enum Sentence {
        /// Every combination is in good agreement with the exact solution.
        Agrees = "Every combination of element and algorithm agrees with Hertz, and for the pin–rod with one another \
            (Figs 10, 14, 15)",
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
        /// Kinematic load with node elements, the paper's own algorithm, converges in every case.
        KinematicAlways = "Kinematic load with node elements has proved to be convergent in every case (§5)",
        /// Kinematic load with node elements converges in two iterations for any initial stiffness.
        TwoSteps = "Kinematic load with node elements converged in two iterations for any initial stiffness, in both \
            examples",
        /// From each start it takes fewer iterations than the others.
        Fewest = "Kinematic load takes the fewest iterations",
        /// It needs the least computing time.
        LeastWork = "Kinematic load takes the least computing time (counted in operations)",
        /// From some start constant stiffness saves a great deal of operations against varying stiffness.
        Saves = "With constant stiffness, which needs one factorisation only, it is possible to save a great deal of \
            operations (3.10)",
        /// The second example shows the same convergence properties as the first.
        Alike = "For the pin–rod the elements and algorithms converge as they do for the cylinder",
        /// None is more accurate than another, and some take far fewer iterations.
        NoDifference = "Within the prescribed accuracy there is no remarkable difference between elements or \
            algorithms; the differences are in iterations and time",
    }
}

/// Error of a peak up to which a chart shows good agreement.
pub const GOOD: f64 = 0.05;
/// Most over fewest iterations from which a dependence is strong, and operations over others from which these save a
/// great deal.
pub const STRONG: f64 = 3.0;
/// Error of a peak that counts as no difference.
pub const UNREMARKABLE: f64 = 0.01;
/// Most over fewest iterations of all that count as one.
pub const DIFFERENT: f64 = 10.0;
/// So many more starts end of what is much more stable.
pub const MUCH: usize = 2;
/// Iterations of kinematic load.
const TWO: usize = 2;

/// When a criterion was met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Met {
    /// Iterations until then.
    pub iterations: usize,
    /// Error of the peak against the discrete solution then.
    pub error: f64,
}

/// An element with an algorithm under a reading, from every start.
pub struct Starts {
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Dofs of the condensed system.
    pub retained: usize,
    /// When the criterion was met; none where the cap came first.
    pub met: Vec<Option<Met>>,
}

impl Starts {
    fn ended(&self) -> usize {
        self.met.iter().flatten().count()
    }

    fn all_end(&self) -> bool {
        self.ended() == self.met.len()
    }

    /// Largest error of those that ended.
    fn error(&self) -> f64 {
        self.met.iter().flatten().map(|met| met.error).fold(0.0, larger)
    }

    /// From each start that ended: operations of a dense Cholesky factorisation a run, or an iteration but for constant
    /// stiffness, and a pair of substitutions an iteration.
    fn operations(&self) -> impl Iterator<Item = Option<f64>> {
        let n = self.retained as f64;
        self.met.iter().map(move |met| {
            let iterations = (*met)?.iterations as f64;
            let factorisations = if self.algorithm == Iteration::Constant { 1.0 } else { iterations };
            Some(factorisations * n.powi(3) / 3.0 + 2.0 * iterations * n * n)
        })
    }

    /// Its operations over those of another, from every start where both end.
    fn over(&self, other: &Self) -> Vec<f64> {
        self.operations().zip(other.operations()).filter_map(|(own, other)| Some(own? / other?)).collect()
    }

    /// From every start where both end, whether it takes fewer iterations than another.
    fn is_faster_than(&self, other: &Self) -> Vec<bool> {
        let fewer = |(own, other): (&Option<Met>, &Option<Met>)| Some((*own)?.iterations < (*other)?.iterations);
        self.met.iter().zip(&other.met).filter_map(fewer).collect()
    }

    /// Whether the same starts end; beside one where that changes a neighbour may stand in.
    fn nearly_alike(&self, other: &Self) -> bool {
        let is_alike = |(k, own): (usize, &Option<Met>)| {
            let near = &other.met[k.saturating_sub(1)..(k + 2).min(other.met.len())];
            near.iter().any(|other| other.is_some() == own.is_some())
        };
        self.met.len() == other.met.len() && self.met.iter().enumerate().all(is_alike)
    }

    /// `8 of 10`.
    fn count(&self) -> String {
        format!("{} of {}", self.ended(), self.met.len())
    }
}

/// Fewest and most iterations of the starts that ended; none where none did.
fn extremes<'a>(all: impl IntoIterator<Item = &'a Starts>) -> Option<[usize; 2]> {
    let iterations: Vec<usize> = all.into_iter().flat_map(|one| &one.met).flatten().map(|met| met.iterations).collect();
    Some([*iterations.iter().min()?, *iterations.iter().max()?])
}

/// What the paper shows of one example under a reading.
pub struct Seen {
    /// Every element and algorithm that it shows, in the order of the nine.
    pub of: Vec<Starts>,
}

impl Seen {
    /// The elements of an algorithm.
    fn by(&self, algorithm: Iteration) -> impl Iterator<Item = &Starts> {
        self.of.iter().filter(move |one| one.algorithm == algorithm)
    }

    /// An element with varying stiffness.
    fn varying(&self, element: Element) -> impl Iterator<Item = &Starts> {
        self.by(Iteration::Varying).filter(move |one| one.element == element)
    }

    /// All but kinematic load.
    fn others(&self) -> impl Iterator<Item = &Starts> {
        self.of.iter().filter(|one| one.algorithm != Iteration::Kinematic)
    }

    /// Varying beside constant stiffness, with every element.
    fn pairs(&self) -> impl Iterator<Item = (&Starts, &Starts)> {
        self.by(Iteration::Varying).zip(self.by(Iteration::Constant))
    }

    /// Whether the iterations of an algorithm depend strongly on the start, with every element.
    fn depends(&self, algorithm: Iteration) -> bool {
        let strongly = |[low, high]: [usize; 2]| high as f64 >= STRONG * low as f64;
        self.by(algorithm).all(|one| extremes([one]).is_some_and(strongly))
    }

    /// Operations of varying over those of constant stiffness.
    fn over_constant(&self) -> Vec<f64> {
        self.pairs().flat_map(|(varying, constant)| varying.over(constant)).collect()
    }

    /// Operations of each other algorithm over those of kinematic load.
    fn over_kinematic(&self) -> Vec<f64> {
        self.by(Iteration::Kinematic).flat_map(|own| self.others().flat_map(|other| other.over(own))).collect()
    }

    /// Start by start, whether kinematic load takes fewer iterations than each other algorithm.
    fn is_fewer(&self) -> Vec<bool> {
        self.by(Iteration::Kinematic)
            .flat_map(|own| self.others().flat_map(|other| own.is_faster_than(other)))
            .collect()
    }

    /// Start by start, whether constant stiffness saves a great deal of the operations of varying stiffness.
    fn is_saved(&self) -> Vec<bool> {
        self.over_constant().iter().map(|quotient| *quotient >= STRONG).collect()
    }

    /// Whether every run that ended is in good agreement with the discrete solution.
    fn agrees(&self) -> bool {
        self.of.iter().all(|one| one.error() <= GOOD)
    }

    fn is_there(&self) -> bool {
        self.of.iter().all(|one| !one.met.is_empty())
    }
}

/// Whether every combination is in good agreement with the exact solution in both examples (Figs 10, 14, 15); where
/// starts are missing none is.
pub fn agrees(seen: &[Seen; 2]) -> bool {
    seen.iter().all(|seen| seen.is_there() && seen.agrees())
}

impl Sentence {
    /// Whether it holds in both examples; where starts are missing nothing does.
    pub fn holds(self, seen: &[Seen; 2]) -> bool {
        seen.iter().all(|seen| seen.is_there() && self.holds_in(seen))
            && (self != Self::Alike || seen[0].of.iter().zip(&seen[1].of).all(|(a, b)| a.nearly_alike(b)))
    }

    fn holds_in(self, seen: &Seen) -> bool {
        use Iteration::{Constant, Kinematic, Varying};
        match self {
            Self::Agrees => seen.agrees(),
            Self::NoDifference => {
                seen.of.iter().all(|one| one.ended() > 0 && one.error() <= UNREMARKABLE)
                    && extremes(&seen.of).is_some_and(|[low, high]| high as f64 >= DIFFERENT * low as f64)
            }
            Self::VaryingDepends => seen.depends(Varying),
            Self::ConstantDepends => seen.depends(Constant),
            Self::Fails => !seen.others().all(Starts::all_end),
            Self::MoreStable => seen.pairs().all(|(varying, constant)| varying.ended() >= constant.ended() + MUCH),
            Self::LineAlways => seen.varying(Element::Line).all(Starts::all_end),
            Self::Proviso => !seen.varying(Element::Layer).all(Starts::all_end),
            Self::KinematicAlways => seen.by(Kinematic).all(Starts::all_end),
            Self::TwoSteps => {
                seen.by(Kinematic).all(Starts::all_end)
                    && extremes(seen.by(Kinematic)).is_some_and(|[_, most]| most <= TWO)
            }
            Self::Fewest => seen.by(Kinematic).all(Starts::all_end) && seen.is_fewer().iter().all(|fewer| *fewer),
            Self::LeastWork => {
                let quotients = seen.over_kinematic();
                // Of none nothing is known.
                !quotients.is_empty() && quotients.iter().all(|quotient| *quotient > 1.0)
            }
            Self::Saves => seen.is_saved().contains(&true),
            Self::Alike => true,
        }
    }

    /// Of a sentence that is told start by start, whether it is so from each where both end; none of another sentence.
    pub fn by_start(self) -> Option<fn(&Seen) -> Vec<bool>> {
        match self {
            Self::Fewest => Some(Seen::is_fewer),
            Self::Saves => Some(Seen::is_saved),
            _ => None,
        }
    }

    /// From how many starts of both examples it is so, where it is told start by start.
    pub fn starts(self, seen: &[Seen; 2]) -> Option<String> {
        let is_so = self.by_start()?;
        let count = |all: Vec<bool>| format!("{} of {}", all.iter().filter(|so| **so).count(), all.len());
        Some(format!("so from {} starts where both end", seen.each_ref().map(|seen| count(is_so(seen))).join(" and ")))
    }

    /// The numbers that it rests on, of the first example and of the second.
    pub fn numbers(self, seen: &[Seen; 2]) -> String {
        use Iteration::{Constant, Kinematic, Varying};
        let both = |text: &dyn Fn(&Seen) -> String| seen.each_ref().map(text).join(" and ");
        let ratios = |algorithm| format!("most over fewest iterations {}", both(&|seen| each(seen, algorithm, ratio)));
        let kinematic = || both(&|seen| range(seen.by(Kinematic)));
        let largest = |seen: &Seen| 100.0 * seen.of.iter().map(Starts::error).fold(0.0, larger);
        let errors =
            || format!("largest error of a peak where a run ends {}", both(&|seen| format!("{:.2} %", largest(seen))));
        match self {
            Self::Agrees => errors(),
            Self::NoDifference => format!("{}; {} iterations", errors(), both(&|seen| range(&seen.of))),
            Self::VaryingDepends => ratios(Varying),
            Self::ConstantDepends => ratios(Constant),
            Self::Fails | Self::MoreStable | Self::Alike => {
                let of = |algorithm| both(&|seen| each(seen, algorithm, Starts::count));
                format!("starts that ended: varying {}; constant {}", of(Varying), of(Constant))
            }
            Self::LineAlways => format!("starts that ended: {}", both(&|seen| counts(seen.varying(Element::Line)))),
            Self::Proviso => format!("starts that ended: {}", both(&|seen| counts(seen.varying(Element::Layer)))),
            Self::KinematicAlways => format!("starts that ended: {}", both(&|seen| counts(seen.by(Kinematic)))),
            Self::TwoSteps => format!("{} iterations", kinematic()),
            Self::Fewest => {
                format!("{} iterations, the others {}", kinematic(), both(&|seen| range(seen.others())))
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

/// `8 of 10 (line), …`: what is said of each element of an algorithm.
fn each(seen: &Seen, algorithm: Iteration, told: fn(&Starts) -> String) -> String {
    let own = seen.by(algorithm).map(|one| format!("{} ({})", told(one), one.element.name()));
    own.collect::<Vec<_>>().join(", ")
}

fn counts<'a>(all: impl Iterator<Item = &'a Starts>) -> String {
    all.map(Starts::count).collect()
}

/// Most over fewest iterations.
fn ratio(one: &Starts) -> String {
    extremes([one]).map_or("–".into(), |[low, high]| format!("{:.1}", high as f64 / low as f64))
}

/// Fewest and most iterations.
fn range<'a>(all: impl IntoIterator<Item = &'a Starts>) -> String {
    match extremes(all) {
        Some([low, high]) if low < high => format!("{low} to {high}"),
        Some([low, _]) => low.to_string(),
        None => "no".into(),
    }
}

fn quotients(all: &[f64]) -> String {
    let low = all.iter().copied().fold(f64::INFINITY, f64::min);
    format!("{low:.2} to {:.0}", all.iter().copied().fold(0.0, larger))
}
