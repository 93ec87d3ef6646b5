//! What it costs.

use super::found::{Findings, extremes};
use super::statement::{Judgement, Statement, judged};
use crate::case::library::{cylinder, pin_rod};
use crate::solve::{Element, Iteration, Run};

/// The paper's two examples.
const CASES: [&str; 2] = [cylinder::NINE, pin_rod::NINE];

/// Pairs of runs (varying, constant) of both scenes and all elements, as ratios of their operations.
pub fn constant_saves(f: &Findings) -> Statement {
    let ratio = |case: &'static str, element| {
        let of = |algorithm| f.run(case, element, algorithm).map(|run| run.solution.work.operations);
        Some(of(Iteration::Varying)? / of(Iteration::Constant)?)
    };
    let ratios: Vec<f64> =
        CASES.into_iter().flat_map(|case| Element::ALL.map(|element| ratio(case, element))).flatten().collect();
    let [low, high] = extremes(ratios.iter().copied());
    Statement {
        text: "Constant stiffness needs one factorisation only and saves a great deal of operations",
        measured: format!("operations of varying over constant stiffness at their defaults: {low:.0} to {high:.0}"),
        judgement: judged(low > 1.0 && ratios.len() == CASES.len() * Element::ALL.len()),
    }
}

/// Kinematic load is the cheapest.
pub fn least(f: &Findings) -> Statement {
    let (mut least_iterations, mut dearer, mut described) = (true, Vec::new(), Vec::new());
    for case in CASES {
        let of = |algorithm| f.run(case, Element::Node, algorithm);
        let (Some(a), Some(b), Some(c)) = (of(Iteration::Varying), of(Iteration::Constant), of(Iteration::Kinematic))
        else {
            least_iterations = false;
            continue;
        };
        let iterations = [a, b, c].map(|run| run.solution.work.iterations);
        let operations = [a, b, c].map(|run| run.solution.work.operations / c.solution.work.operations);
        least_iterations &= iterations[2] < iterations[0].min(iterations[1]);
        if operations[2] > operations[0].min(operations[1]) {
            dearer.push(case);
        }
        described.push(format!(
            "{case}: {} / {} / {} iterations, operations {:.2} / {:.2} / 1 of kinematic's",
            iterations[0], iterations[1], iterations[2], operations[0], operations[1]
        ));
    }
    let judgement = match (least_iterations, dearer.is_empty()) {
        (true, true) => Judgement::Reproduced,
        (true, false) => Judgement::UnderCondition,
        _ => Judgement::NotReproduced,
    };
    let condition = if judgement == Judgement::UnderCondition {
        format!(". Condition: counted in iterations; in operations another is cheaper for {}", dearer.join(" and "))
    } else {
        String::new()
    };
    Statement {
        text: "Kinematic load takes the fewest iterations and the least computing time",
        measured: format!("node elements, varying / constant / kinematic: {}{condition}", described.join("; ")),
        judgement,
    }
}

/// Condensation pays.
pub fn condensation_pays(f: &Findings) -> Statement {
    let runs: Vec<&Run> = CASES.into_iter().flat_map(|case| f.runs(case)).collect();
    // Without condensation every factorisation would be the sparse one; with it there is one, and dense small ones.
    let gain = |run: &&Run| {
        run.sparse_operations * run.solution.work.factorisations as f64
            / (run.sparse_operations + run.solution.work.operations)
    };
    let single = |run: &&&Run| run.formulation.algorithm == Iteration::Constant;
    let refactoring: Vec<f64> = runs.iter().filter(|run| !single(run)).map(gain).collect();
    let [low, high] = extremes(refactoring.into_iter());
    Statement {
        text: "It pays to iterate on the external dofs alone (substructuring)",
        measured: format!(
            "operations without over with condensation, where the algorithm factorises at every iteration: {low:.1} to {high:.0}; with constant stiffness one factorisation serves either way"
        ),
        judgement: judged(low > 1.0),
    }
}
