//! A reading: one choice on every axis that the paper leaves open; and the designed set of them.

use crate::algorithm::{Criterion, Leeway, Spring, StiffnessRule};
use crate::named::named_enum;
use crate::solve::{Element, Formulation, Iteration, Settings};
use crate::study::grouped::in_order;

named_enum! {
    /// What is open; its name begins a sentence that a choice ends.
    pub enum Axis {
        /// Rule of varying stiffness.
        Varying = "varying stiffness changes by",
        /// Rule of constant stiffness.
        Constant = "constant stiffness changes by",
        /// Thickness of layers.
        Thickness = "layers over their edges are",
        /// Reach of the candidates.
        Candidates = "candidates end",
        /// Mesh.
        Mesh = "the mesh has",
        /// Stop criterion.
        Stop = "runs stop by",
        /// Cap of iterations.
        Cap = "the cap is",
    }
}

named_enum! {
    /// How far the candidates reach.
    pub enum Candidates {
        /// A "potential contact area".
        Wide = "beyond the contact",
        /// As far as the contact does.
        AtEdge = "where the contact does",
    }
}

named_enum! {
    /// The mesh, whose figures are not at hand.
    pub enum Mesh {
        /// That of the stiffness sweep.
        Sweep = "8-node cells",
        /// The same with other cells.
        Linear = "4-node cells",
        /// The same cells, more of them.
        Finer = "half as many cells again along the contact",
    }
}

/// How an algorithm changes its springs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    /// Rule.
    pub rule: StiffnessRule,
    /// How far an iteration may go, and what has a stiffness of its own.
    pub leeway: Leeway,
}

/// A criterion with its tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Criterion.
    pub criterion: Criterion,
    /// Tolerance; of no meaning to the contact state.
    pub tolerance: f64,
}

/// One choice on every axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// How varying stiffness changes its springs.
    pub varying: Rule,
    /// How constant stiffness does.
    pub constant: Rule,
    /// Thickness of the layer element over the length of its edge.
    pub thickness: f64,
    /// How far the candidates reach.
    pub candidates: Candidates,
    /// Mesh.
    pub mesh: Mesh,
    /// When to stop.
    pub stop: Stop,
    /// Iterations after which a run is given up.
    pub cap: usize,
}

/// Factors that a rule may be bounded by.
const BOUNDS: [f64; 3] = [2.0, 10.0, f64::INFINITY];
/// Another thickness than the program's own: a tenth of it.
const THIN: f64 = 0.005;
/// Caps of iterations.
pub const CAPS: [usize; 7] = [20, 30, 50, 100, 200, 500, 2000];
/// Tolerances of each criterion that has one.
const TOLERANCES: [f64; 6] = [1e-1, 1e-2, 5e-3, 1e-3, 1e-4, 1e-6];
/// Those at which a statement shall hold.
pub const JUDGED: [f64; 3] = [1e-2, 1e-3, 1e-4];

impl Rule {
    /// Those of varying stiffness: its own with another bound or for whole elements, and every other rule.
    fn varying() -> Vec<Self> {
        let own = Self::own(Iteration::Varying);
        let of = |leeway| Self { leeway, ..own };
        let mut rules = BOUNDS.map(|bound| of(Leeway { bound, ..own.leeway })).to_vec();
        rules.push(of(Leeway { spring: Spring::Element, ..own.leeway }));
        let all = Iteration::Varying.rules().iter().chain(Iteration::Varying.further_rules());
        rules.extend(all.map(|&rule| Self { rule, ..own }));
        rules
    }

    /// That of an algorithm where the paper does not tell.
    fn own(algorithm: Iteration) -> Self {
        Self { rule: algorithm.rules()[0], leeway: Leeway::default() }
    }

    /// `squared by at most 2 per element`.
    fn name(&self, algorithm: Iteration) -> String {
        use StiffnessRule::{Secant, Squared, Step};
        let Self { rule, leeway: Leeway { bound, spring } } = self;
        let bounded = match algorithm == Iteration::Varying && [Secant, Squared, Step].contains(rule) {
            true if bound.is_finite() => format!(" by at most {bound}"),
            true => " unbounded".into(),
            false => String::new(),
        };
        format!("{}{bounded}{}", rule.name(), if *spring == Spring::Element { " per element" } else { "" })
    }
}

impl Stop {
    /// All that can be had without the discrete solution.
    pub fn all() -> Vec<Self> {
        let visible = Criterion::ALL.into_iter().filter(|criterion| *criterion != Criterion::Error);
        let of = |criterion: Criterion| {
            let tolerances = if criterion == Criterion::State { &TOLERANCES[..1] } else { &TOLERANCES[..] };
            tolerances.iter().map(move |&tolerance| Self { criterion, tolerance })
        };
        visible.flat_map(of).collect()
    }

    /// `residuals 1e-3`.
    pub fn name(&self) -> String {
        match self.criterion {
            Criterion::State => "contact state".into(),
            criterion => format!("{} {:.0e}", criterion.name(), self.tolerance),
        }
    }
}

impl Reading {
    /// The one nearest to the text and to what it cites: gap elements whose strain drives them (its reference 8), a
    /// potential contact area, contact conditions whose fulfilment is checked; what it does not say as this program has
    /// it.
    pub fn nearest() -> Self {
        let Settings { tolerance, max_iterations: cap, .. } = Settings::default();
        Self {
            varying: Rule::own(Iteration::Varying),
            constant: Rule::own(Iteration::Constant),
            thickness: Formulation::new(Element::Layer, Iteration::Varying).layer_thickness,
            candidates: Candidates::Wide,
            mesh: Mesh::Sweep,
            stop: Stop { criterion: Criterion::Conditions, tolerance },
            cap,
        }
    }

    /// Every single departure from the nearest reading, axis by axis.
    pub fn departures() -> Vec<Self> {
        let nearest = Self::nearest();
        let constant = |&rule: &StiffnessRule| Self { constant: Rule { rule, ..nearest.constant }, ..nearest };
        let mut all: Vec<Self> = Rule::varying().into_iter().map(|varying| Self { varying, ..nearest }).collect();
        all.extend(Iteration::Constant.rules().iter().map(constant));
        all.push(Self { thickness: THIN, ..nearest });
        all.extend(Candidates::ALL.map(|candidates| Self { candidates, ..nearest }));
        all.extend(Mesh::ALL.map(|mesh| Self { mesh, ..nearest }));
        all.extend(Stop::all().into_iter().map(|stop| Self { stop, ..nearest }));
        all.extend(CAPS.map(|cap| Self { cap, ..nearest }));
        all.retain(|one| *one != nearest);
        all
    }

    /// Pairs of departures: candidates that end where the contact does, by every stop. Of kinematic load, whose
    /// iterations the paper counts, these two decide together: which contacts it has to open, and when their opening is
    /// seen to be done.
    pub fn pairs() -> Vec<Self> {
        let nearest = Self::nearest();
        let stops = Stop::all().into_iter().filter(|stop| *stop != nearest.stop);
        stops.map(|stop| Self { candidates: Candidates::AtEdge, stop, ..nearest }).collect()
    }

    /// The same at another tolerance.
    pub fn at(self, tolerance: f64) -> Self {
        Self { stop: Stop { tolerance, ..self.stop }, ..self }
    }

    /// The reading at each tolerance of [`JUDGED`]; alone where it stops otherwise than the nearest one.
    pub fn judged(&self) -> Vec<Self> {
        match self.stop == Self::nearest().stop {
            true => JUDGED.map(|tolerance| self.at(tolerance)).to_vec(),
            false => vec![*self],
        }
    }

    /// The designed set: the nearest reading, every departure and pair, at the tolerances that each is judged at.
    pub fn designed() -> Vec<Self> {
        let mut set: Vec<Self> = Vec::new();
        for one in [vec![Self::nearest()], Self::departures(), Self::pairs()].concat().iter().flat_map(Self::judged) {
            if !set.contains(&one) {
                set.push(one);
            }
        }
        set
    }

    /// The rule of an algorithm.
    pub fn rule(&self, algorithm: Iteration) -> Rule {
        match algorithm {
            Iteration::Varying => self.varying,
            Iteration::Constant => self.constant,
            Iteration::Kinematic => Rule::own(algorithm),
        }
    }

    /// The same with another's choice on an axis.
    fn with(self, axis: Axis, other: &Self) -> Self {
        match axis {
            Axis::Varying => Self { varying: other.varying, ..self },
            Axis::Constant => Self { constant: other.constant, ..self },
            Axis::Thickness => Self { thickness: other.thickness, ..self },
            Axis::Candidates => Self { candidates: other.candidates, ..self },
            Axis::Mesh => Self { mesh: other.mesh, ..self },
            Axis::Stop => Self { stop: other.stop, ..self },
            Axis::Cap => Self { cap: other.cap, ..self },
        }
    }

    /// Axes on which it departs from the nearest reading.
    pub fn axes(&self) -> Vec<Axis> {
        let nearest = Self::nearest();
        Axis::ALL.into_iter().filter(|&axis| nearest.with(axis, self) != nearest).collect()
    }

    /// The single departures that make it up.
    pub fn parts(&self) -> Vec<Self> {
        self.axes().into_iter().map(|axis| Self::nearest().with(axis, self)).collect()
    }

    /// What it has on an axis.
    fn choice(&self, axis: Axis) -> String {
        match axis {
            Axis::Varying => self.varying.name(Iteration::Varying),
            Axis::Constant => self.constant.name(Iteration::Constant),
            Axis::Thickness => self.thickness.to_string(),
            Axis::Candidates => self.candidates.name().into(),
            Axis::Mesh => self.mesh.name().into(),
            Axis::Stop => self.stop.name(),
            Axis::Cap => self.cap.to_string(),
        }
    }

    /// All choices in words.
    pub fn name(&self) -> String {
        Axis::ALL.map(|axis| format!("{} {}", axis.name(), self.choice(axis))).join(", ")
    }
}

/// Departures in words: `candidates end where the contact does and runs stop by contact state`, `the cap is 20, or 30`.
pub fn told<'a>(readings: impl IntoIterator<Item = &'a Reading>) -> Vec<String> {
    let departure = |reading: &Reading| {
        let axes = reading.axes();
        let (last, before) = axes.split_last()?;
        let before = before.iter().map(|axis| format!("{} {} and ", axis.name(), reading.choice(*axis)));
        Some((before.collect::<String>() + last.name(), reading.choice(*last)))
    };
    let groups = in_order(readings.into_iter().filter_map(departure)).into_iter();
    groups.map(|(begins, choices)| format!("{begins} {}", choices.join(", or "))).collect()
}
