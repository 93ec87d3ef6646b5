//! The paper's statements, judged from the findings: no verdict here is typed.

use crate::case::Verdict;
use crate::case::{hertz, pin};
use crate::solve::run::Run;
use crate::solve::{Element, Iteration};
use crate::study::refinement::{LEFT_OUT, QUARTER};
use crate::study::unsorted::{Finding, Series};
use crate::study::{gaertner, sweep};

/// How a statement of the paper fared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Judgement {
    /// It holds as stated.
    Reproduced,
    /// It holds under the condition given with it.
    UnderCondition,
    /// It does not hold here.
    NotReproduced,
    /// Nothing to judge it by.
    NotJudged,
}

impl std::fmt::Display for Judgement {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Reproduced => "reproduced",
            Self::UnderCondition => "reproduced under a stated condition",
            Self::NotReproduced => "not reproduced",
            Self::NotJudged => "not judged",
        })
    }
}

/// A statement of the paper with what was measured.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What the paper says.
    pub text: &'static str,
    /// What was measured.
    pub measured: String,
    /// The judgement.
    pub judgement: Judgement,
}

/// All statements, judged.
pub fn judge(findings: &[Finding]) -> Vec<Statement> {
    let f = Findings(findings);
    vec![
        agreement(&f),
        dependence_on_stiffness(&f),
        stability(&f),
        two_steps(&f),
        no_difference(&f),
        top_quarter(&f),
        constant_saves(&f),
        least_work(&f),
        pin_rod_converges_alike(&f),
        condensation_pays(&f),
        reasonable_agreement(&f),
    ]
}

/// Look-ups in the findings.
struct Findings<'a>(&'a [Finding]);

impl<'a> Findings<'a> {
    fn case(&self, case: &str) -> impl Iterator<Item = &'a Finding> + use<'a> {
        let case = case.to_string();
        self.0.iter().filter(move |finding| finding.case == case)
    }

    fn runs(&self, case: &str) -> Vec<&'a Run> {
        self.case(case).filter_map(|finding| finding.run.as_ref()).collect()
    }

    fn passes(&self, case: &str) -> bool {
        let mut verdicts = self.case(case).map(Finding::verdict).peekable();
        verdicts.peek().is_some() && verdicts.all(|verdict| verdict == Verdict::Pass)
    }

    /// Curve of steps over stiffness of an element and algorithm.
    fn sweep(&self, scene: &str, element: Element, algorithm: Iteration) -> Option<&'a Series> {
        let name = format!("{}.{}", element.name(), algorithm.name());
        self.case(&sweep::study(scene)).find(|finding| finding.name == name)?.series.first()
    }

    /// Curves of an algorithm over all scenes and the elements the paper used with it.
    fn sweeps(&self, algorithm: Iteration) -> Vec<(&'static str, Element, &'a Series)> {
        let of = |scene: &'static str| Element::ALL.map(|element| (scene, element));
        let all = sweep::SCENES.iter().flat_map(|&(scene, _)| of(scene));
        all.filter_map(|(scene, element)| Some((scene, element, self.sweep(scene, element, algorithm)?))).collect()
    }

    fn run(&self, case: &str, element: Element, algorithm: Iteration) -> Option<&'a Run> {
        self.runs(case).into_iter().find(|r| r.formulation.element == element && r.formulation.algorithm == algorithm)
    }
}

fn judged(holds: bool) -> Judgement {
    if holds { Judgement::Reproduced } else { Judgement::NotReproduced }
}

/// `n of m` converged runs of some sweeps.
fn share(sweeps: &[(&str, Element, &Series)]) -> (usize, usize) {
    let converged: usize = sweeps.iter().map(|(_, _, series)| series.points.len()).sum();
    (converged, converged + sweeps.iter().map(|(_, _, series)| series.failed.len()).sum::<usize>())
}

/// Fewest and most steps of some sweeps.
fn steps(sweeps: &[(&str, Element, &Series)]) -> [f64; 2] {
    let all = sweeps.iter().flat_map(|(_, _, series)| series.points.iter().map(|point| point[1]));
    all.fold([f64::INFINITY, 0.0], |[low, high], s| [low.min(s), high.max(s)])
}

fn agreement(f: &Findings) -> Statement {
    let worst = |case: &str, quantity: &str| {
        let checks = f
            .case(case)
            .flat_map(|finding| &finding.checks)
            .filter(|check| check.check.quantity.to_string().ends_with(quantity));
        100.0 * checks.map(|check| check.error).fold(0.0, |a: f64, e| if e.is_nan() { e } else { a.max(e) })
    };
    Statement {
        text: "Every combination of element and algorithm agrees with Hertz, and for the pin–rod with one another (Figs 10, 14, 15)",
        measured: format!(
            "cylinder, all nine: p₀ within {:.2} %, a within {:.2} %; pin–rod, all nine: peak within {:.2} %, profile L2 within {:.2} %",
            worst(hertz::CYLINDER, "p₀ [MPa]"),
            worst(hertz::CYLINDER, "a [mm]"),
            worst(pin::PIN_ROD, "peak [MPa]"),
            worst(pin::PIN_ROD, "L2(p)"),
        ),
        judgement: judged(f.passes(hertz::CYLINDER) && f.passes(pin::PIN_ROD)),
    }
}

fn dependence_on_stiffness(f: &Findings) -> Statement {
    // Within one scene and element: the most a start changes the steps, and the share of starts that fail.
    let describe = |algorithm: Iteration| {
        let sweeps = f.sweeps(algorithm);
        let ratio = |sweep: &(&str, Element, &Series)| {
            let [low, high] = steps(std::slice::from_ref(sweep));
            high / low
        };
        let ratios: Vec<f64> = sweeps.iter().map(ratio).collect();
        let (low, high) = ratios.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &r| (a.min(r), b.max(r)));
        let (n, m) = share(&sweeps);
        let text = format!(
            "{}: most over fewest steps {low:.1} to {high:.1} by scene and element, {n} of {m} starts converged",
            algorithm.name()
        );
        (text, low > STRONG, n < m)
    };
    let (varying, varying_strong, varying_fails) = describe(Iteration::Varying);
    let (constant, constant_strong, constant_fails) = describe(Iteration::Constant);
    let judgement = match (varying_strong && varying_fails, constant_strong && constant_fails) {
        (true, true) => Judgement::Reproduced,
        (false, true) => Judgement::UnderCondition,
        _ => Judgement::NotReproduced,
    };
    let condition = if judgement == Judgement::UnderCondition { ". Condition: constant stiffness" } else { "" };
    Statement {
        text: "With varying and with constant stiffness the steps depend strongly on the initial stiffness; in some cases there is no convergence (Fig. 11)",
        measured: format!("{varying}; {constant}{condition}"),
        judgement,
    }
}

/// Most over fewest steps from which a dependence counts as strong.
const STRONG: f64 = 10.0;

fn stability(f: &Findings) -> Statement {
    let (varying, constant) = (f.sweeps(Iteration::Varying), f.sweeps(Iteration::Constant));
    let line: Vec<_> = varying.iter().filter(|(_, element, _)| *element == Element::Line).copied().collect();
    let ((v, of_v), (c, of_c), (l, of_l)) = (share(&varying), share(&constant), share(&line));
    let more_stable = v * of_c > c * of_v;
    let first_failure = line.iter().flat_map(|(_, _, series)| &series.failed).fold(f64::INFINITY, |a, &x| a.min(x));
    let below = line.iter().flat_map(|(_, _, series)| &series.points).map(|p| p[0]).filter(|&x| x < first_failure);
    let judgement = match (more_stable, l == of_l) {
        (true, true) => Judgement::Reproduced,
        (true, false) => Judgement::UnderCondition,
        _ => Judgement::NotReproduced,
    };
    let condition = if judgement == Judgement::UnderCondition {
        format!(". Condition: with line elements in every case up to κ₀ = {}", below.fold(0.0, f64::max))
    } else {
        String::new()
    };
    Statement {
        text: "Varying stiffness is more stable than constant stiffness; with line elements it converged in every case",
        measured: format!(
            "converged starts: varying {v} of {of_v}, constant {c} of {of_c}, varying with line elements {l} of {of_l}{condition}"
        ),
        judgement,
    }
}

fn two_steps(f: &Findings) -> Statement {
    let wide: Vec<_> = f.sweeps(Iteration::Kinematic).into_iter().filter(|(_, e, _)| *e == Element::Node).collect();
    let edge: Vec<_> = (f.case(sweep::AT_THE_EDGE).filter_map(|finding| finding.series.first()))
        .map(|series| ("cylinder", Element::Node, series))
        .collect();
    let ([low, high], (n, m)) = (steps(&wide), share(&wide));
    let ([_, edge_high], (k, of_k)) = (steps(&edge), share(&edge));
    let judgement = match (high <= 2.0 && n == m, edge_high <= 2.0 && k == of_k) {
        (true, _) => Judgement::Reproduced,
        (false, true) => Judgement::UnderCondition,
        _ => Judgement::NotReproduced,
    };
    Statement {
        text: "Kinematic load with node elements converged in two steps for any initial stiffness, in both examples",
        measured: format!(
            "candidates wider than the contact: {low} to {high} steps, {n} of {m} starts converged; candidates ending at the contact edge (cylinder): at most {edge_high} steps, {k} of {of_k}. Condition: the candidates end where the contact does"
        ),
        judgement,
    }
}

fn no_difference(f: &Findings) -> Statement {
    let work = |run: &&Run| run.solution.work.steps as f64;
    let runs = f.runs(hertz::CYLINDER);
    let (low, high) = runs.iter().map(work).fold((f64::INFINITY, 0.0_f64), |(a, b), s| (a.min(s), b.max(s)));
    let spread = |of: fn(&Run) -> f64| {
        let values = || runs.iter().map(|run| of(run));
        100.0 * (values().fold(0.0, f64::max) / values().fold(f64::INFINITY, f64::min) - 1.0)
    };
    let (peak, width) = (spread(|r| r.measures().peak.pressure), spread(|r| r.measures().half_width));
    Statement {
        text: "Within the prescribed accuracy there is no remarkable difference between elements or algorithms; the differences are in steps and time",
        measured: format!("cylinder: spread of the nine {peak:.2} % in p₀, {width:.2} % in a; {low} to {high} steps"),
        judgement: judged(peak < 1.0 && width < 1.0 && high / low > STRONG),
    }
}

fn top_quarter(f: &Findings) -> Statement {
    let points: Vec<[f64; 2]> = f
        .case(QUARTER_CASE)
        .flat_map(|finding| &finding.series)
        .filter(|s| s.picture == QUARTER)
        .flat_map(|s| s.points.clone())
        .collect();
    let small = points.iter().filter(|p| p[1] <= LEFT_OUT).map(|p| p[0]).fold(0.0, f64::max);
    let all = points.iter().all(|p| p[1] <= LEFT_OUT);
    let worst =
        points.iter().map(|p| format!("{:.3} % at a/R = {}", 100.0 * p[1], p[0])).collect::<Vec<_>>().join(", ");
    Statement {
        text: "The top quarter of the half cylinder does not influence the contact and may be left out",
        measured: format!("change of p₀ or a: {worst}; below {} % up to a/R = {small}", 100.0 * LEFT_OUT),
        judgement: if all {
            Judgement::Reproduced
        } else if small > 0.0 {
            Judgement::UnderCondition
        } else {
            Judgement::NotReproduced
        },
    }
}

const QUARTER_CASE: &str = "half cylinder against quarter";

/// Pairs of runs (varying, constant) of both scenes and all elements, as ratios of their operations.
fn constant_saves(f: &Findings) -> Statement {
    let ratio = |case: &str, element| {
        let of = |algorithm| f.run(case, element, algorithm).map(|run| run.solution.work.operations);
        Some(of(Iteration::Varying)? / of(Iteration::Constant)?)
    };
    let cases = [hertz::CYLINDER, pin::PIN_ROD];
    let ratios: Vec<f64> =
        cases.iter().flat_map(|case| Element::ALL.map(|element| ratio(case, element))).flatten().collect();
    let (low, high) = ratios.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &r| (a.min(r), b.max(r)));
    Statement {
        text: "Constant stiffness needs one factorisation only and saves a great deal of operations",
        measured: format!("operations of varying over constant stiffness at their defaults: {low:.0} to {high:.0}"),
        judgement: judged(low > 1.0 && ratios.len() == cases.len() * Element::ALL.len()),
    }
}

fn least_work(f: &Findings) -> Statement {
    let cases = [hertz::CYLINDER, pin::PIN_ROD];
    let (mut least_steps, mut least_operations, mut described) = (true, true, Vec::new());
    for case in cases {
        let of = |algorithm| f.run(case, Element::Node, algorithm);
        let (Some(a), Some(b), Some(c)) = (of(Iteration::Varying), of(Iteration::Constant), of(Iteration::Kinematic))
        else {
            least_steps = false;
            continue;
        };
        let steps = [a, b, c].map(|run| run.solution.work.steps);
        let operations = [a, b, c].map(|run| run.solution.work.operations / c.solution.work.operations);
        least_steps &= steps[2] < steps[0].min(steps[1]);
        least_operations &= operations[2] <= operations[0].min(operations[1]);
        described.push(format!(
            "{case}: {} / {} / {} steps, operations {:.2} / {:.2} / 1 of kinematic's",
            steps[0], steps[1], steps[2], operations[0], operations[1]
        ));
    }
    let judgement = match (least_steps, least_operations) {
        (true, true) => Judgement::Reproduced,
        (true, false) => Judgement::UnderCondition,
        _ => Judgement::NotReproduced,
    };
    let condition = if judgement == Judgement::UnderCondition {
        ". Condition: counted in steps; in operations another is cheaper in one of them"
    } else {
        ""
    };
    Statement {
        text: "Kinematic load takes the fewest steps and the least computing time",
        measured: format!("node elements, varying / constant / kinematic: {}{condition}", described.join("; ")),
        judgement,
    }
}

/// The same start stiffnesses converge in both scenes, for the same element and algorithm; a start next to one where
/// convergence ends may differ.
fn pin_rod_converges_alike(f: &Findings) -> Statement {
    let (mut alike, mut nearly, mut all) = (0, 0, 0);
    for algorithm in Iteration::ALL {
        for element in Element::ALL {
            let of = |scene: &str| f.sweep(scene, element, algorithm);
            let (Some(a), Some(b)) = (of("cylinder"), of("pin-rod")) else { continue };
            let (a, b) = (outcomes(a), outcomes(b));
            for (i, ours) in a.iter().enumerate() {
                let near = b[i.saturating_sub(1)..(i + 2).min(b.len())].contains(ours);
                all += 1;
                alike += usize::from(b.get(i) == Some(ours));
                nearly += usize::from(near);
            }
        }
    }
    Statement {
        text: "For the pin–rod the elements and algorithms converge as they do for the cylinder",
        measured: format!(
            "the same outcome in both scenes at {alike} of {all} starts; at {nearly} where a neighbouring start, half a decade away, may stand in"
        ),
        judgement: match (all, all - alike, all - nearly) {
            (0, _, _) => Judgement::NotJudged,
            (_, 0, _) => Judgement::Reproduced,
            (_, _, 0) => Judgement::UnderCondition,
            _ => Judgement::NotReproduced,
        },
    }
}

/// Whether each start of a sweep converged, from the softest to the stiffest.
fn outcomes(series: &Series) -> Vec<bool> {
    let converged = series.points.iter().map(|point| (point[0], true));
    let mut all: Vec<(f64, bool)> = converged.chain(series.failed.iter().map(|&x| (x, false))).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, converged)| converged).collect()
}

fn condensation_pays(f: &Findings) -> Statement {
    let runs: Vec<&Run> = [hertz::CYLINDER, pin::PIN_ROD].iter().flat_map(|case| f.runs(case)).collect();
    // Without condensation every factorisation would be the sparse one; with it there is one, and dense small ones.
    let gain = |run: &&Run| {
        run.sparse_operations * run.solution.work.factorisations as f64
            / (run.sparse_operations + run.solution.work.operations)
    };
    let single = |run: &&&Run| run.formulation.algorithm == Iteration::Constant;
    let refactoring: Vec<f64> = runs.iter().filter(|run| !single(run)).map(gain).collect();
    let (low, high) = refactoring.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &g| (a.min(g), b.max(g)));
    Statement {
        text: "It pays to iterate on the external freedoms alone (substructuring)",
        measured: format!(
            "operations without over with condensation, where the algorithm factorises at every step: {low:.1} to {high:.0}; with constant stiffness one factorisation serves either way"
        ),
        judgement: judged(low > 1.0),
    }
}

fn reasonable_agreement(f: &Findings) -> Statement {
    let verdict = f.case(gaertner::CASE).map(Finding::verdict).next();
    let (measured, judgement) = match verdict {
        Some(Verdict::Pass) => ("within the combined uncertainty".to_string(), Judgement::Reproduced),
        Some(Verdict::Fail) => ("outside the combined uncertainty".to_string(), Judgement::NotReproduced),
        Some(Verdict::NotRun(why)) => (why, Judgement::NotJudged),
        None => ("not asked".to_string(), Judgement::NotJudged),
    };
    Statement {
        text: "Reasonable agreement with Gaertner's finite elements and experiment (Figs 14, 15)",
        measured,
        judgement,
    }
}
