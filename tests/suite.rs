//! Every trial of the suite as one line, and one frozen snapshot per scene × element × algorithm.

mod frozen;
mod truth;

use std::fmt::Write;

use contact_vv::case::Verdict;
use contact_vv::case::library::{NAMES, find};
use contact_vv::markdown::significant;
use contact_vv::solve::Run;
use contact_vv::solve::{Discretisation, Formulation};
use contact_vv::study::{self, promised};
use libtest_mimic::{Arguments, Failed, Trial};
use truth::{Findings, counted, truth};

/// Scenes whose runs are frozen.
const FROZEN: [&str; 6] = ["cylinder", "truncated-hertz", "pin-rod", "sphere", "truncated-sphere", "cone"];

/// Where other codes' answers come from here.
const FROZEN_ANSWERS: &str =
    "as they were frozen (`bash oracles/setup.sh && cargo test --release --workspace` asks scikit-fem and dolfinx)";

fn main() {
    let arguments = Arguments::from_args();
    let findings = Findings::default();
    // Truth lock: all checks of a trial hold.
    let mut tests: Vec<Trial> = study::trials().into_iter().map(|trial| truth(trial, findings.clone())).collect();
    tests.extend(FROZEN.into_iter().flat_map(runs));
    tests.extend(frozen::trials());
    tests.push(Trial::test("every snapshot belongs to a run of the suite", no_stray_snapshot));
    let conclusion = libtest_mimic::run(&arguments, tests);
    if arguments.list {
        conclusion.exit();
    }
    let findings = findings.lock().expect("no test panics while keeping");
    println!("{}, {FROZEN_ANSWERS}", counted(&findings));
    let bars = study::on_bars(&findings).expect("judged");
    let all = matches!(bars.numbers(), Some(promised::Numbers::Checks(all, _)) if *all > 0);
    // Of some trials only there may be none to judge.
    let beyond = bars.judged.iter().filter(|one| all && one.verdict != Verdict::Pass);
    let beyond: Vec<String> = beyond.map(|one| format!("{}: {}", one.requirement(), one.value)).collect();
    if !beyond.is_empty() {
        println!("{}", beyond.join("\n"));
        std::process::exit(1);
    }
    conclusion.exit();
}

/// Drift lock: counts and measures of the nine formulations of a scene are what they were.
fn runs(scene: &'static str) -> Vec<Trial> {
    let test = |formulation: Formulation| {
        Trial::test(format!("snapshot, {scene} × {}", formulation.name()), move || {
            let problem = find(scene, None).map_err(|error| error.to_string())?;
            let discretisation =
                Discretisation::of(problem.scene, problem.resolution).map_err(|error| error.to_string())?;
            let run = Run::of(&discretisation, &formulation).map_err(|error| error.to_string())?;
            frozen::freeze(scene, Some(&formulation.name()), summary(&run))
        })
    };
    Formulation::compared().into_iter().map(test).collect()
}

/// What is frozen of a run; of one that did not converge, the outcome only.
fn summary(run: &Run) -> String {
    let (solution, measures) = (&run.solution, &run.measures());
    let mut text = format!("outcome: {}\n", solution.outcome);
    if !solution.converged() {
        return text;
    }
    let work = &solution.work;
    let [last, before] = run.decision_margin();
    let _ = writeln!(text, "iterations: {}", work.iterations);
    let _ = writeln!(text, "factorisations: {}", work.factorisations);
    let _ = writeln!(text, "back-substitutions: {}", work.back_substitutions);
    let _ = writeln!(text, "dofs: {}", run.dofs);
    let _ = writeln!(text, "retained: {}", run.retained);
    let _ = writeln!(
        text,
        "active points by iteration: {}",
        run_lengths(solution.history.iter().map(|iteration| iteration.active))
    );
    let _ = writeln!(text, "half-width: {}", significant(measures.second_moment_width, 6));
    let _ = writeln!(text, "half-width by counting: {}", significant(measures.half_width_nodes, 6));
    let _ = writeln!(text, "peak pressure: {}", significant(measures.peak.pressure, 6));
    let _ = writeln!(text, "resultant: {}", significant(run.transmitted(), 6));
    let _ = writeln!(text, "decades from the tolerance, last two iterations: {before:+.2}, {last:+.2}");
    text
}

/// `17 × 2, 13, 11 × 40`: equal neighbours counted.
fn run_lengths(values: impl Iterator<Item = usize>) -> String {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for value in values {
        match runs.last_mut() {
            Some((last, count)) if *last == value => *count += 1,
            _ => runs.push((value, 1)),
        }
    }
    let write =
        |(value, count): (usize, usize)| if count > 1 { format!("{value} × {count}") } else { value.to_string() };
    runs.into_iter().map(write).collect::<Vec<_>>().join(", ")
}

/// A snapshot that no run asks for would freeze nothing.
fn no_stray_snapshot() -> Result<(), Failed> {
    assert!(FROZEN.iter().all(|scene| NAMES.iter().any(|(name, _)| name == scene)), "frozen scenes are in the library");
    let expected: Vec<String> = FROZEN
        .iter()
        .flat_map(|scene| Formulation::compared().into_iter().map(move |f| format!("{scene}@{}.snap", f.name())))
        .chain(frozen::names())
        .collect();
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    for entry in std::fs::read_dir(&folder).map_err(|error| error.to_string())?.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.ends_with(".snap") && !expected.contains(&name) {
            return Err(format!("{name} belongs to no run: delete it or add the run").into());
        }
    }
    Ok(())
}
