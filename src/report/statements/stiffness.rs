//! How far iterations and convergence depend on the initial stiffness.

use super::found::{Findings, extremes, iterations, share};
use super::statement::{Judgement, Statement};
use crate::solve::{Element, Iteration};
use crate::study::sweep::run::Sweep;
use crate::study::sweep::scene::Scene;

/// Most over fewest iterations from which a dependence counts as strong.
const STRONG: f64 = 10.0;

/// Iterations depend on the initial stiffness.
pub fn dependence(f: &Findings) -> Statement {
    // Within one scene and element: the most a start changes the iterations, and the share of starts that fail.
    let describe = |algorithm: Iteration| {
        let sweeps = f.sweeps(algorithm);
        let ratio = |sweep: &&Sweep| {
            let [low, high] = iterations(&[*sweep]);
            high / low
        };
        // A sweep in which nothing converges has no ratio.
        let some = sweeps.iter().filter(|sweep| !sweep.iterations.points.is_empty());
        let [low, high] = extremes(some.map(ratio));
        let (n, m) = share(&sweeps);
        let text = format!(
            "{}: most over fewest iterations {low:.1} to {high:.1} by scene and element, {n} of {m} starts converged",
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
        text: "With varying and with constant stiffness the iterations depend strongly on the initial stiffness; in some cases there is no convergence (Fig. 11)",
        measured: format!("{varying}; {constant}{condition}"),
        judgement,
    }
}

/// Varying stiffness is more stable than constant stiffness.
pub fn stability(f: &Findings) -> Statement {
    let (varying, constant) = (f.sweeps(Iteration::Varying), f.sweeps(Iteration::Constant));
    let line: Vec<_> = varying.iter().filter(|sweep| sweep.formulation.element == Element::Line).copied().collect();
    let ((v, of_v), (c, of_c), (l, of_l)) = (share(&varying), share(&constant), share(&line));
    let more_stable = v * of_c > c * of_v;
    let first_failure = line.iter().flat_map(|sweep| &sweep.iterations.failed).fold(f64::INFINITY, |a, &x| a.min(x));
    let below = line.iter().flat_map(|sweep| &sweep.iterations.points).map(|p| p[0]).filter(|&x| x < first_failure);
    let up_to = below.fold(0.0, f64::max);
    let judgement = match (more_stable, l == of_l) {
        (true, true) => Judgement::Reproduced,
        (true, false) if up_to > 0.0 => Judgement::UnderCondition,
        _ => Judgement::NotReproduced,
    };
    let condition = match judgement {
        Judgement::UnderCondition => format!(". Condition: with line elements in every case up to κ₀ = {up_to}"),
        _ => String::new(),
    };
    Statement {
        text: "Varying stiffness is more stable than constant stiffness; with line elements it converged in every case",
        measured: format!(
            "converged starts: varying {v} of {of_v}, constant {c} of {of_c}, varying with line elements {l} of {of_l}{condition}"
        ),
        judgement,
    }
}

/// Kinematic load takes two iterations.
pub fn two_iterations(f: &Findings) -> Statement {
    let of_nodes = |sweep: &&Sweep| sweep.formulation.element == Element::Node;
    let wide: Vec<&Sweep> = f.sweeps(Iteration::Kinematic).into_iter().filter(of_nodes).collect();
    let edge = f.sweeps_of(Scene::AtTheEdge);
    let ([low, high], (n, m)) = (iterations(&wide), share(&wide));
    let ([_, edge_high], (k, of_k)) = (iterations(&edge), share(&edge));
    let judgement = match (high <= 2.0 && n == m, edge_high <= 2.0 && k == of_k) {
        (true, _) => Judgement::Reproduced,
        (false, true) => Judgement::UnderCondition,
        _ => Judgement::NotReproduced,
    };
    let condition = match judgement {
        Judgement::UnderCondition => ". Condition: the candidates end where the contact does",
        _ => "",
    };
    Statement {
        text: "Kinematic load with node elements converged in two iterations for any initial stiffness, in both examples",
        measured: format!(
            "candidates wider than the contact: {low} to {high} iterations, {n} of {m} starts converged; candidates ending at the contact edge (cylinder): at most {edge_high} iterations, {k} of {of_k}{condition}"
        ),
        judgement,
    }
}

/// The same start stiffnesses converge in both scenes, for the same element and algorithm; a start next to one where
/// convergence ends may differ.
pub fn alike(f: &Findings) -> Statement {
    let (mut alike, mut nearly, mut all) = (0, 0, 0);
    for algorithm in Iteration::ALL {
        for element in Element::ALL {
            let own = |sweep: &&Sweep| sweep.formulation.element == element && sweep.formulation.algorithm == algorithm;
            let [a, b] = Scene::PAPER.map(|scene| f.sweeps_of(scene).into_iter().find(own).map_or(vec![], outcomes));
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
fn outcomes(sweep: &Sweep) -> Vec<bool> {
    let converged = sweep.iterations.points.iter().map(|point| (point[0], true));
    let mut all: Vec<(f64, bool)> = converged.chain(sweep.iterations.failed.iter().map(|&x| (x, false))).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, converged)| converged).collect()
}
