//! Every trial of the suite as one line, and one frozen snapshot per scene × element × algorithm.

mod frozen;
mod truth;

use std::fmt::Write;
use std::sync::{Arc, OnceLock};

use contact_vv::case::Verdict;
use contact_vv::case::library::{NAMES, find};
use contact_vv::error::Error;
use contact_vv::markdown::significant;
use contact_vv::solve::Run;
use contact_vv::solve::{Discretisation, Formulation};
use contact_vv::study::{self, Finding};
use contact_vv::{checkout, report};
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
    let trials = study::trials();
    let titles: Vec<String> = trials.iter().map(study::Trial::title).collect();
    let mut tests: Vec<Trial> = trials.into_iter().map(|trial| truth(trial, findings.clone())).collect();
    tests.extend(FROZEN.into_iter().flat_map(runs));
    tests.extend(frozen::trials());
    tests.push(Trial::test("every snapshot belongs to a run of the suite", no_stray_snapshot));
    let conclusion = libtest_mimic::run(&arguments, tests);
    if arguments.list {
        conclusion.exit();
    }
    let mut findings = findings.lock().expect("no test panics while keeping").clone();
    println!("{}, {FROZEN_ANSWERS}", counted(&findings));
    // Of some trials only there may be no bar to judge, and there is no report.
    if findings.len() == titles.len() {
        findings.sort_by_key(|one| titles.iter().position(|title| *title == format!("{} × {}", one.case, one.name)));
        whole(findings).unwrap_or_else(|missed| {
            println!("{missed}");
            std::process::exit(1);
        });
    }
    conclusion.exit();
}

/// What all trials together are held to: the error bars of their checks, and the report as it is committed.
fn whole(mut findings: Vec<Finding>) -> Result<(), String> {
    let said = |error: Error| error.to_string();
    let bars = study::on_bars(&findings).map_err(said)?;
    let beyond = bars.judged.iter().filter(|one| one.verdict != Verdict::Pass);
    let mut missed: Vec<String> = beyond.map(|one| format!("{}: {}", one.requirement(), one.value)).collect();
    findings.push(bars);
    let report = report::compose(&findings).map_err(said)?;
    if let Some(difference) = report::difference(&report, &checkout::root()).map_err(said)? {
        missed.push(difference.text(report::diff::LINES).trim_end().into());
        missed.push("the report is not what the code makes: `cargo run --release` writes it".into());
    }
    if missed.is_empty() { Ok(()) } else { Err(missed.join("\n")) }
}

/// Drift lock: counts and measures of the nine formulations of a scene, on one mesh, are what they were.
fn runs(scene: &'static str) -> Vec<Trial> {
    let mesh: Arc<OnceLock<Result<Discretisation, Error>>> = Arc::default();
    let meshed = move || find(scene, None).and_then(|case| Discretisation::of(case.scene, case.resolution));
    let test = |formulation: Formulation| {
        let mesh = mesh.clone();
        Trial::test(format!("snapshot, {scene} × {}", formulation.name()), move || {
            let discretisation = mesh.get_or_init(meshed).as_ref();
            let run = discretisation.map_err(Clone::clone).and_then(|mesh| Run::of(mesh, &formulation));
            let run = run.map_err(|error| error.to_string())?;
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
    // Decades between the last two iteration errors and the tolerance.
    let errors = solution.history.iter().rev().map(|iteration| iteration.error.largest().max(1e-99));
    let mut decades = errors.map(|error| (error / run.formulation.settings.tolerance).log10());
    let [last, before] = [(); 2].map(|()| decades.next().unwrap_or(f64::NAN));
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
