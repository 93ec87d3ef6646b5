//! Iterations against initial stiffness (the paper's Fig. 11), the condition of its "two iterations", and the rules of each algorithm.

use serde::Serialize;

use crate::algorithm::logarithms::STOOD;
use crate::algorithm::{Acceleration, StiffnessRule, StiffnessUnit};
use crate::case::library::{Cylinder, PinRod};
use crate::case::{Case, Check, Judged, Quantity, Reference};
use crate::drawing::palette::{Dash, Style};
use crate::drawing::{Axis, Chart, Drawing, panels};
use crate::error::{Error, Kind};
use crate::markdown;
use crate::measure::larger;
use crate::mesh::Resolution;
use crate::oracle::ReferenceKind;
use crate::solution::Outcome;
use crate::solve::{Discretisation, Element, Formulation, Iteration, Run, Settings};
use crate::study::about::About;
use crate::study::drawn::{Curve, label, picture, style};
use crate::study::{Found, Planned};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Elements and iterations",
    asked: "How many iterations each formulation takes from each initial stiffness.",
    limits: "The scenes of the paper only; the atlas asks the same over candidates and meshes.",
};

/// What is swept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Scene {
    /// The cylinder, candidates to twice the half-width.
    Cylinder,
    /// The pin in the connecting-rod eye.
    PinRod,
    /// The cylinder, candidates that end where the contact does.
    AtTheEdge,
}

impl Scene {
    /// The paper's two examples.
    pub const PAPER: [Self; 2] = [Self::Cylinder, Self::PinRod];

    /// Name in charts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cylinder => "cylinder",
            Self::PinRod => "pin-rod",
            Self::AtTheEdge => "candidates end at the edge",
        }
    }

    /// The case on the mesh of the sweep.
    fn case(self) -> Case {
        let case = self.of_library();
        let elements = match self {
            Self::Cylinder | Self::AtTheEdge => 8,
            Self::PinRod => 12,
        };
        Case { resolution: Resolution { elements, ..case.resolution }, ..case }
    }

    /// The case on the mesh of the library.
    fn of_library(self) -> Case {
        match self {
            Self::Cylinder => Cylinder::default().case(),
            Self::PinRod => PinRod::default().case(),
            Self::AtTheEdge => Cylinder { stretch: 1.0, ..Default::default() }.case(),
        }
    }
}

/// Start stiffnesses: half decades from 1e-3 to 1e6.
fn stiffnesses() -> impl Iterator<Item = f64> {
    (-6..=12).map(|k| 10f64.powf(0.5 * f64::from(k)))
}

/// Every formulation on both scenes, as it stands in the paper and accelerated, what that saves, the rules, and the condition of
/// "two iterations".
pub fn plan() -> Vec<Planned<Numbers>> {
    let sweep = |scene: Scene, formulation: Formulation| {
        let name = formulation.name();
        Planned::new(format!("stiffness sweep, {}", scene.name()), name, move || sweep(scene, &formulation))
    };
    let accelerated = || Formulation::compared().into_iter().filter(|one| one.acceleration != Acceleration::None);
    let each = || Formulation::nine().into_iter().chain(accelerated());
    let mut trials: Vec<_> =
        Scene::PAPER.into_iter().flat_map(|scene| each().map(move |formulation| sweep(scene, formulation))).collect();
    trials
        .extend(Scene::PAPER.map(|scene| {
            Planned::new(format!("before and after, {}", scene.name()), "all nine", move || saved(scene))
        }));
    trials.push(Planned::new("rules, cylinder", "all rules", rules));
    trials.push(sweep(Scene::AtTheEdge, Formulation::new(Element::Node, Iteration::Kinematic)));
    trials
}

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

/// Most iterations of a formulation of the paper: more than any takes on the cylinder; on the pin–rod some take fifty thousand, which
/// would tell no more.
const ENOUGH: usize = 6_000;

/// Initial stiffnesses of the rules.
const STARTS: [f64; 3] = [0.1, 1.0, 10.0];

/// Runs a formulation from every initial stiffness.
fn sweep(scene: Scene, formulation: &Formulation) -> Result<Numbers, Error> {
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

/// Every formulation as it stands in the paper, for as long as it takes within reason, and as the program takes it, on the mesh of the library.
fn saved(scene: Scene) -> Result<Numbers, Error> {
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
fn rules() -> Result<Numbers, Error> {
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

/// Error of a peak or a half-width that an iteration within its tolerance may have, in tolerances.
const SLACK: f64 = 3.0;

/// The largest error of what converged; where nothing did there is nothing to judge, and the check says so. What the program takes
/// converges.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let (error, tolerance, starts) = match numbers {
        Numbers::Sweep(sweep) => (
            sweep.error,
            sweep.formulation.settings.tolerance,
            format!("{} starts converge", sweep.iterations.points.len()),
        ),
        Numbers::Rules(rules) => {
            let errors = || rules.iter().flat_map(|rule| &rule.runs).filter_map(|run| run.error);
            (errors().reduce(larger), Settings::default().tolerance, format!("{} runs converge", errors().count()))
        }
        Numbers::Saved(scene, saved) => {
            let worst = saved.iter().map(|one| one.error).reduce(larger);
            (worst, Settings::default().tolerance, format!("{}, all nine as the program takes them", scene.name()))
        }
    };
    let because = "the iteration error bounds norms of pressure and width; a single number may be off by more, never by this much";
    let quantity = Quantity::at("error of p₀ and a of what converges, from any initial stiffness", starts);
    let check = Check::error(quantity, Reference::own("the discrete solution", 0.0), SLACK * tolerance, because);
    let converging = match numbers {
        Numbers::Saved(scene, saved) => Some(converging(scene.name(), saved)),
        Numbers::Sweep(_) | Numbers::Rules(_) => None,
    };
    let right = match error {
        Some(error) => check.judge(error),
        None => {
            check.not_run(ReferenceKind::SelfConsistency, "the discrete solution", "not run: no start converges".into())
        }
    };
    Ok([right].into_iter().chain(converging).collect())
}

/// That all nine converge as the program takes them.
fn converging(scene: &str, saved: &[Saved]) -> Judged {
    let failing = saved.iter().filter(|one| one.iterations[1].is_none()).count();
    let quantity = Quantity::at("formulation that does not converge as the program takes it", scene);
    let because = "acceleration, κ₀ and tolerance are chosen so that all nine do";
    Check::none(quantity, because).judge(failing as f64)
}

/// Elements, chart, and the table of the rules.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::new();
    text += &picture(
        "contact-problem.svg",
        "As Figs 1 and 2: bodies in contact, and contact elements on the potential contact area",
    );
    text += &picture("contact-elements.svg", "As Figs 3, 4 and 5: line, layer and node contact element");
    text += &picture(
        "iterations-against-stiffness.svg",
        "As Fig. 11 with all nine formulations, by the iteration error: iterations against initial stiffness, as they stand in the paper and, dash-dotted, accelerated; runs that did not converge are drawn as hollow markers above the chart",
    );
    text += &before_and_after(findings);
    let rules = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Rules(rules) => Some(rules),
        Numbers::Sweep(_) | Numbers::Saved(..) => None,
    });
    let rows: Vec<Vec<String>> = rules.flatten().map(row).collect();
    let head = ["algorithm", "rule"].map(String::from).into_iter().chain(STARTS.map(|k| format!("κ₀ = {k}")));
    text += "**The rules of each algorithm on the cylinder, node element; `penalty` converges to its own springs' law**\n\n";
    Ok(text + &markdown::table(&head.collect::<Vec<_>>(), &rows) + "\n")
}

/// Iterations of the paper's formulations, and of what the program takes in their place, on both scenes.
fn before_and_after(findings: &[Found<Numbers>]) -> String {
    let scenes: Vec<(&Scene, &[Saved])> = findings
        .iter()
        .filter_map(|found| match found.numbers {
            Numbers::Saved(scene, saved) => Some((scene, saved.as_slice())),
            Numbers::Sweep(_) | Numbers::Rules(_) => None,
        })
        .collect();
    let Some((_, first)) = scenes.first() else { return String::new() };
    let head = ["in the paper", "as the program takes it"].map(String::from).into_iter();
    let head: Vec<String> = head.chain(scenes.iter().map(|(scene, _)| scene.name().into())).collect();
    let cell = |saved: &Saved| {
        let [before, after] = saved.iterations.map(|iterations| iterations.map(|count| count.to_string()));
        let before = before.unwrap_or_else(|| format!("not converged in {ENOUGH}"));
        format!("{before} → {}", after.unwrap_or_else(|| "not converged".into()))
    };
    let row = |(k, one): (usize, &Saved)| {
        let cells = scenes.iter().map(|(_, saved)| cell(&saved[k]));
        [one.paper.clone(), one.program.clone()].into_iter().chain(cells).collect()
    };
    let rows: Vec<Vec<String>> = first.iter().enumerate().map(row).collect();
    let kinematic = Formulation::accelerated(Element::Line, Iteration::Kinematic).stiffness;
    format!(
        "**Iterations to {:e} on the meshes of the library, before → after**\n\n{}\n\
         Two Gauss points on an edge carry differences that the bodies feel only through their change from edge to edge: under varying \
         stiffness these die out in iterations that grow with the square of the number of edges, whatever κ₀. The program takes \
         varying stiffness by Newton's method on ln k of the points that press, damped, once these have stood for {STOOD} iterations, each with a \
         back-substitution for every such point; and constant stiffness by Newton's method on the carried forces, damped, with its one \
         factorisation and as many back-substitutions as there are points before the first step. κ₀ of kinematic load on Gauss points is \
         {kinematic} times √(E*/L · s), L the candidate stretch and s what the bodies resist at a point. With `--acceleration none` varying and constant stiffness are the paper's.\n\n",
        Settings::default().tolerance,
        markdown::table(&head, &rows)
    )
}

fn row(rule: &Rule) -> Vec<String> {
    let ends = rule.runs.iter().map(told);
    [rule.algorithm, rule.rule].map(String::from).into_iter().chain(ends).collect()
}

/// How a run ended, with its iterations where it converged.
fn told(run: &End) -> String {
    match (&run.outcome, run.iterations) {
        (None, _) => "refused: contact reaches the end of the candidate surface".into(),
        (Some(outcome), Some(iterations)) => format!("{outcome}, {iterations} iterations"),
        (Some(outcome), None) => outcome.clone(),
    }
}

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let sweeps = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Sweep(sweep) => Some(sweep),
        Numbers::Rules(_) | Numbers::Saved(..) => None,
    });
    let sweeps: Vec<&Sweep> = sweeps.collect();
    let panels_of = |scene| Iteration::ALL.map(|algorithm| panel(&sweeps, scene, algorithm));
    let charts: Vec<Chart> = Scene::PAPER.into_iter().flat_map(panels_of).collect();
    Ok(vec![("iterations-against-stiffness.svg".into(), panels("Iterations against initial stiffness", &charts, 3))])
}

fn panel(sweeps: &[&Sweep], scene: Scene, algorithm: Iteration) -> Chart {
    let title = format!("{}: {}", scene.name(), algorithm.name());
    let mut chart = Chart::new(
        &title,
        Axis::log("initial stiffness κ₀ [–]").over(1e-3, 1e6),
        Axis::log("iterations [–]").over(1.0, 3000.0),
    );
    let own = sweeps.iter().filter(|sweep| sweep.scene == scene && sweep.formulation.algorithm == algorithm);
    chart.series =
        own.map(|sweep| sweep.iterations.drawn(label(&sweep.formulation), drawn(&sweep.formulation))).collect();
    chart
}

/// Accelerated ones are dash-dotted.
fn drawn(formulation: &Formulation) -> Style {
    match formulation.acceleration {
        Acceleration::None => style(formulation),
        _ => Style { dash: Dash::DashDot, ..style(formulation) },
    }
}
