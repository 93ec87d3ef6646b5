//! Iterations from every initial stiffness: when each criterion would have stopped them, and how far off they were then.

use serde::{Deserialize, Serialize};

use crate::algorithm::{Spring, StiffnessRule};
use crate::case::library::{Cylinder, PinRod};
use crate::error::{Error, Kind};
use crate::mesh::{Order, Resolution};
use crate::scene::Scene;
use crate::solution::{Iterated, Outcome, Solution};
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run, Settings};
use crate::study::readings::axes::{CAPS, Candidates, Example, Rule, Stop, THICKNESSES, TOLERANCES, starts};
use crate::study::readings::reading::{End, Reading};

/// Unit of recorded errors.
pub const UNIT: f64 = 1e-4;

/// A mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ground {
    /// Example.
    pub example: Example,
    /// Candidates.
    pub candidates: Candidates,
    /// Elements per half-width, or per 10 mm of arc.
    pub elements: usize,
    /// Order of the cells.
    pub order: Order,
}

/// A mesh, an element and a rule: iterations from every start are one site of the survey.
#[derive(Clone, Copy, Debug)]
pub struct Site {
    /// The mesh.
    pub ground: Ground,
    /// Contact element.
    pub element: Element,
    /// Thickness of a layer element over the length of its edge.
    pub thickness: f64,
    /// Rule.
    pub rule: Rule,
}

/// One start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Example.
    pub example: Example,
    /// Candidates.
    pub candidates: Candidates,
    /// Contact element.
    pub element: Element,
    /// Thickness of a layer element over the length of its edge.
    pub thickness: f64,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: StiffnessRule,
    /// Largest factor in an iteration.
    pub bound: f64,
    /// What has a stiffness of its own.
    pub spring: Spring,
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Dofs of the condensed system.
    pub retained: usize,
    /// Iterations until each [`Stop`] of all; `-` where it was not met within the largest cap.
    pub iterations: String,
    /// Error of the peak against the discrete solution there, in [`UNIT`]s.
    pub errors: String,
}

impl Ground {
    /// The mesh that is searched: that of the stiffness sweep.
    pub fn searched(example: Example, candidates: Candidates) -> Self {
        let elements = match example {
            Example::Cylinder => 8,
            Example::PinRod => 12,
        };
        Self { example, candidates, elements, order: Order::Quadratic }
    }

    /// The scene, whose candidates may have to be looked for.
    fn scene(&self, resolution: Resolution) -> Result<Scene, Error> {
        Ok(match (self.example, self.candidates) {
            (Example::Cylinder, Candidates::Wide) => Cylinder::default().scene(),
            (Example::Cylinder, Candidates::AtEdge) => Cylinder { stretch: 1.0, ..Default::default() }.scene(),
            (Example::PinRod, Candidates::Wide) => PinRod::default().scene(),
            (Example::PinRod, Candidates::AtEdge) => {
                let wide = Discretisation::of(PinRod::default().scene(), resolution)?;
                let run = Run::of(&wide, &Formulation::verification())?;
                let stretch = run.measures().edge();
                PinRod { stretch, ..Default::default() }.scene()
            }
        })
    }

    /// The mesh with its condensed system.
    pub fn discretised(&self) -> Result<Discretisation, Error> {
        let resolution = Resolution { elements: self.elements, refinement: 0, order: self.order };
        Discretisation::of(self.scene(resolution)?, resolution)
    }
}

impl Site {
    /// All of the search, in the order of the record.
    pub fn all() -> Vec<Self> {
        let mut sites = Vec::new();
        for example in Example::ALL {
            for candidates in Candidates::ALL {
                let ground = Ground::searched(example, candidates);
                for (element, thickness) in elements() {
                    sites.extend(Rule::all().into_iter().map(|rule| Self { ground, element, thickness, rule }));
                }
            }
        }
        sites
    }

    /// Name of its unfinished record.
    pub fn key(&self) -> String {
        let Self { ground, element, thickness, rule } = self;
        let of_ground = format!("{}-{}", ground.example.name(), ground.candidates.name());
        let of_rule = format!("{}-{}-{}-{}", rule.algorithm.name(), rule.rule.name(), rule.bound, rule.spring.name());
        format!("{of_ground}-{}-{thickness}-{of_rule}", element.name())
    }

    /// Every start.
    pub fn records(&self) -> Result<Vec<Record>, Error> {
        let discretisation = self.ground.discretised()?;
        starts().map(|stiffness| self.record(&discretisation, stiffness)).collect()
    }

    /// A start under one reading alone.
    fn end(&self, discretisation: &Discretisation, reading: &Reading, stiffness: f64) -> Result<End, Error> {
        let base = Formulation { stiffness, layer_thickness: self.thickness, ..self.rule.formulation(self.element) };
        let Stop { criterion, tolerance } = reading.stop;
        let settings = Settings { criterion, tolerance, max_iterations: reading.cap, ..base.settings };
        let met = met(discretisation, &Formulation { settings, ..base })?;
        let retained = discretisation.condensed.retained();
        let error = met.as_ref().map_or(f64::NAN, |met| met.error);
        Ok(End { stiffness, iterations: met.map(|met| met.iterations), error, retained })
    }

    fn record(&self, discretisation: &Discretisation, stiffness: f64) -> Result<Record, Error> {
        let base = Formulation { stiffness, layer_thickness: self.thickness, ..self.rule.formulation(self.element) };
        // Kinematic load looks at the tolerance, and is over soon: it is run for each. Of the others one run tells all.
        let met = match self.rule.algorithm {
            Iteration::Kinematic => {
                Stop::all().iter().map(|stop| own(discretisation, &base, stop)).collect::<Result<_, _>>()?
            }
            _ => of_one(discretisation, &base)?,
        };
        let Rule { algorithm, rule, bound, spring } = self.rule;
        let text = |of: fn(&Met) -> String| {
            let each = met.iter().map(|met: &Option<Met>| met.as_ref().map_or("-".into(), of));
            each.collect::<Vec<_>>().join(" ")
        };
        Ok(Record {
            example: self.ground.example,
            candidates: self.ground.candidates,
            element: self.element,
            thickness: self.thickness,
            algorithm,
            rule,
            bound,
            spring,
            stiffness,
            retained: discretisation.condensed.retained(),
            iterations: text(|met| met.iterations.to_string()),
            errors: text(|met| format!("{:.0}", met.error / UNIT)),
        })
    }
}

/// The ends of the paper's elements and algorithms from some starts on one mesh, under one reading alone.
pub fn ends(ground: &Ground, reading: &Reading, starts: &[f64]) -> Result<Vec<(Element, Iteration, Vec<End>)>, Error> {
    let discretisation = ground.discretised()?;
    let of = |(algorithm, element): (Iteration, Element)| {
        let site = Site { ground: *ground, element, thickness: reading.thickness, rule: reading.rule(algorithm) };
        let ends =
            starts.iter().map(|&stiffness| site.end(&discretisation, reading, stiffness)).collect::<Result<_, _>>()?;
        Ok((element, algorithm, ends))
    };
    pairs().filter(|&(algorithm, element)| is_shown(element, algorithm)).map(of).collect()
}

/// Whether the paper shows results of an element with an algorithm.
pub fn is_shown(element: Element, algorithm: Iteration) -> bool {
    Formulation::new(element, algorithm).is_in_the_paper()
}

/// Algorithms with elements.
pub fn pairs() -> impl Iterator<Item = (Iteration, Element)> {
    Iteration::ALL.into_iter().flat_map(|algorithm| Element::ALL.map(|element| (algorithm, element)))
}

/// Elements with the thicknesses that they are run with; line and node have none.
pub fn elements() -> Vec<(Element, f64)> {
    let thicknesses = |element| if element == Element::Layer { &THICKNESSES[..] } else { &THICKNESSES[..1] };
    Element::ALL.into_iter().flat_map(|element| thicknesses(element).iter().map(move |&t| (element, t))).collect()
}

/// When a criterion was met.
struct Met {
    iterations: usize,
    error: f64,
}

/// One run to the smallest tolerance, and where it passed the others.
fn of_one(discretisation: &Discretisation, base: &Formulation) -> Result<Vec<Option<Met>>, Error> {
    let least = TOLERANCES.into_iter().fold(f64::INFINITY, f64::min);
    let settings = Settings { tolerance: least, max_iterations: CAPS[CAPS.len() - 1], ..base.settings };
    let history = match solved(discretisation, &Formulation { settings, ..base.clone() })? {
        Some(solution) => solution.history,
        None => Vec::new(),
    };
    let met = |stop: &Stop| {
        let is_met = |iterated: &Iterated| stop.criterion.of(&iterated.seen).is_some_and(|seen| seen <= stop.tolerance);
        let at = history.iter().position(is_met)?;
        Some(Met { iterations: at + 1, error: history[at].error.peak })
    };
    Ok(Stop::all().iter().map(met).collect())
}

/// A run that stops by a criterion.
fn own(discretisation: &Discretisation, base: &Formulation, stop: &Stop) -> Result<Option<Met>, Error> {
    let settings = Settings { criterion: stop.criterion, tolerance: stop.tolerance, ..base.settings };
    met(discretisation, &Formulation { settings, ..base.clone() })
}

/// When a run stopped by its criterion.
fn met(discretisation: &Discretisation, formulation: &Formulation) -> Result<Option<Met>, Error> {
    let solution = solved(discretisation, formulation)?;
    let ended = solution.filter(|solution| [Outcome::Converged, Outcome::Stopped].contains(&solution.outcome));
    Ok(ended.map(|solution| Met { iterations: solution.work.iterations, error: solution.error().peak }))
}

/// A solution; none where no spring holds, the named error.
fn solved(discretisation: &Discretisation, formulation: &Formulation) -> Result<Option<Solution>, Error> {
    match discretisation.solve(formulation) {
        Err(Error { kind: Kind::NoSpringLeft { .. } | Kind::SpringsTooSoft, .. }) => Ok(None),
        solution => solution.map(Some),
    }
}
