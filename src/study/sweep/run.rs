//! A curve of one formulation over initial stiffnesses; the outcomes of all rules.

use serde::Serialize;

use crate::algorithm::{StiffnessRule, StiffnessUnit};
use crate::error::{Error, Kind};
use crate::measure::larger;
use crate::solution::Outcome;
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run};
use crate::study::drawn::Curve;
use crate::study::sweep::scene::{Scene, stiffnesses};

/// What a trial found.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// Iterations over initial stiffness.
    Sweep(Sweep),
    /// Every rule of every algorithm.
    Rules(Vec<Rule>),
    /// What acceleration and initial stiffness save each formulation.
    Saved(Scene, Vec<Saved>),
}

/// A formulation as it stands in the paper, and as the program takes it.
#[derive(Clone, Debug, Serialize)]
pub struct Saved {
    /// Name of the element and the algorithm.
    pub paper: String,
    /// Name of what the program takes.
    pub program: String,
    /// Iterations of both; none where it does not converge.
    pub iterations: [Option<usize>; 2],
    /// Peak pressure \[MPa\] and second-moment width \[mm\] of the paper's.
    pub measured: [f64; 2],
    /// Error of p₀ and a of what the program takes.
    pub error: f64,
}

/// Iterations of one formulation from every initial stiffness.
#[derive(Clone, Debug, Serialize)]
pub struct Sweep {
    /// Where.
    pub scene: Scene,
    /// By what.
    pub formulation: Formulation,
    /// Iterations over κ₀; starts without convergence.
    pub iterations: Curve,
    /// Largest error of p₀ and a among the runs that converged; none where none did.
    pub error: Option<f64>,
}

/// A rule from some initial stiffnesses.
#[derive(Clone, Debug, Serialize)]
pub struct Rule {
    /// Name of the algorithm.
    pub algorithm: &'static str,
    /// Name of the rule.
    pub rule: &'static str,
    /// What came of each start.
    pub runs: Vec<End>,
}

/// How a run ended.
#[derive(Clone, Debug, Serialize)]
pub struct End {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Outcome; none where contact reaches the end of the candidate surface, which is refused.
    pub outcome: Option<String>,
    /// Iterations, where it converged.
    pub iterations: Option<usize>,
    /// Error of p₀ and a, where it converged.
    pub error: Option<f64>,
}

/// Most iterations of a formulation of the paper: more than any takes on both scenes.
const ENOUGH: usize = 100_000;

/// Initial stiffnesses of the rules.
pub(super) const STARTS: [f64; 3] = [0.1, 1.0, 10.0];

/// Runs a formulation from every initial stiffness.
pub(super) fn sweep(scene: Scene, formulation: &Formulation) -> Result<Numbers, Error> {
    let case = scene.case();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let (mut iterations, mut error) = (Curve::default(), None);
    for stiffness in stiffnesses() {
        let stiffness_unit = StiffnessUnit::Reference;
        let run = Run::of(&discretisation, &Formulation { stiffness, stiffness_unit, ..formulation.clone() })?;
        if !run.solution.converged() {
            iterations.failed.push(stiffness);
            continue;
        }
        iterations.points.push([stiffness, run.solution.work.iterations as f64]);
        error = Some(error.map_or(run.iteration_error(), |worst| larger(worst, run.iteration_error())));
    }
    Ok(Numbers::Sweep(Sweep { scene, formulation: formulation.clone(), iterations, error }))
}

/// Every formulation as it stands in the paper, for as long as it takes, and as the program takes it, on the mesh of the library.
pub(super) fn saved(scene: Scene) -> Result<Numbers, Error> {
    let case = scene.of_library();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let pairs = Formulation::nine().into_iter().zip(Formulation::compared());
    let of = |(mut paper, program): (Formulation, Formulation)| {
        paper.settings.max_iterations = ENOUGH;
        let [before, after] = [&paper, &program].map(|formulation| Run::of(&discretisation, formulation));
        let (before, after) = (before?, after?);
        let iterations = [&before, &after].map(|run| run.solution.converged().then_some(run.solution.work.iterations));
        let measures = before.measures();
        let measured = [measures.peak.pressure, measures.second_moment_width];
        Ok(Saved { paper: paper.name(), program: program.name(), iterations, measured, error: after.iteration_error() })
    };
    Ok(Numbers::Saved(scene, pairs.map(of).collect::<Result<_, Error>>()?))
}

/// Every rule of every algorithm on the cylinder, node element.
pub(super) fn rules() -> Result<Numbers, Error> {
    let case = Scene::Cylinder.case();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let rules =
        Iteration::ALL.into_iter().flat_map(|algorithm| algorithm.rules().iter().map(move |rule| (algorithm, *rule)));
    let of = |(algorithm, rule): (Iteration, StiffnessRule)| {
        let runs = STARTS.map(|stiffness| {
            let formulation = Formulation { rule, stiffness, ..Formulation::new(Element::Node, algorithm) };
            end(&discretisation, &formulation)
        });
        let runs = runs.into_iter().collect::<Result<_, _>>()?;
        Ok(Rule { algorithm: algorithm.name(), rule: rule.name(), runs })
    };
    rules.map(of).collect::<Result<_, Error>>().map(Numbers::Rules)
}

fn end(discretisation: &Discretisation, formulation: &Formulation) -> Result<End, Error> {
    let stiffness = formulation.stiffness;
    let run = match Run::of(discretisation, formulation) {
        // Soft springs of a penalty spread the contact beyond any candidates.
        Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }) => {
            return Ok(End { stiffness, outcome: None, iterations: None, error: None });
        }
        run => run?,
    };
    let converged = run.solution.outcome == Outcome::Converged;
    Ok(End {
        stiffness,
        outcome: Some(run.solution.outcome.to_string()),
        iterations: converged.then_some(run.solution.work.iterations),
        error: converged.then(|| run.iteration_error()),
    })
}
