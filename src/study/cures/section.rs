//! The section: shares and reach of the accelerations, the rules, nested starts.

use crate::algorithm::Acceleration;
use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::cures::judge::TIMES;
use crate::study::cures::nested::{DENSITIES, Nested, OnMesh, Start};
use crate::study::cures::picture::{FILE, TITLE, called, reaches};
use crate::study::cures::record::{ITERATIONS, PLANES, Runs, TOLERANCES, stiffnesses};
use crate::study::cures::rules::{Ended, Rule};
use crate::study::cures::run::{Numbers, Reach};
use crate::study::drawn::picture;

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let planes: Vec<Vec<String>> = reaches(findings).flat_map(rows_of_planes).collect();
    let caption = format!(
        "{TITLE}; runs that take more than {ITERATIONS} iterations are drawn as hollow markers above the chart"
    );
    Ok([
        introduction(),
        shares(findings),
        "\n".into(),
        picture(FILE, &caption),
        markdown::folded("Lowest and highest κ₀ that converge, on each plane", &table(head_of_planes(), &planes), false),
        rules(findings),
        "\nThe rule `literal` keeps stiffnesses beside its forces: it is no fixed point of them. \
         The rule `secant` drives the spring of a closed gap to its ceiling.\n\n\
         **Kinematic load, nested start.** Every point starts as the nearest one of a mesh half as fine has ended, down to \
         one element. Iterations with every candidate closed → iterations from the nested start (+ all iterations on \
         coarser meshes).\n\n"
            .into(),
        nested(findings),
    ]
    .concat())
}

fn introduction() -> String {
    let (starts, planes, possible) = (stiffnesses(), PLANES.len(), 100.0 / TIMES);
    let [least, most] = [starts[0], starts[starts.len() - 1]];
    format!(
        "Beside the paper's algorithms: the program takes Anderson acceleration, the others are options. Accelerated varying stiffness \
         stands in *Elements and iterations*.\n\n\
         **Constant stiffness, accelerated.** With the rule `correction` its iteration is Douglas–Rachford splitting (Lions & \
         Mercier 1979): it converges whatever κ₀, but slowly away from the best one. Crossed secant (Ramière & Helfer 2015; \
         for Uzawa's iteration of contact Koliesnikova & Ramière, arXiv:2603.12205) and Anderson acceleration (Walker & Ni \
         2011) with the safeguard of Zhang, O'Donoghue & Boyd 2020, on truncated Hertz: initial stiffnesses in third decades \
         from {least:e} to {most:e}, on {planes} planes of candidate stretch and mesh. Where the plain share exceeds \
         {possible:.0} %, no share can be {TIMES} times as large: the possible factor is given in brackets, and the \
         requirement is made at the tight tolerance. Iteration counts of long accelerated runs depend on round-off: the table \
         shows the recorded ones, and the runs of today are held against them within the drift that noise causes.\n\n",
    )
}

fn table(head: impl IntoIterator<Item = impl Into<String>>, rows: &[Vec<String>]) -> String {
    markdown::table(&head.into_iter().map(Into::into).collect::<Vec<String>>(), rows)
}

fn shares(findings: &[Found<Numbers>]) -> String {
    let of = |Reach { recorded, .. }: &Reach| {
        recorded.iter().flat_map(|runs| [0, 1].map(|k| row_of_shares(&recorded[0], runs, k))).collect::<Vec<_>>()
    };
    let within = format!("starts that converge within {ITERATIONS} iterations");
    let head = [
        "formulation",
        "iteration error ≤",
        &within,
        "times plain (possible)",
        "κ₀ at which all planes converge",
        "accelerated iterations given up",
    ];
    table(head, &reaches(findings).flat_map(of).collect::<Vec<_>>())
}

fn row_of_shares(plain: &Runs, runs: &Runs, tolerance: usize) -> Vec<String> {
    let planes = &runs.iterations[tolerance];
    let everywhere: Vec<bool> =
        (0..stiffnesses().len()).map(|k| planes.iter().all(|plane| plane[k].is_some())).collect();
    let [share, plain] = [runs, plain].map(|runs| runs.share(tolerance));
    vec![
        runs.formulation().name(),
        format!("{:e}", TOLERANCES[tolerance]),
        format!("{:.0} %", 100.0 * share),
        format!("{:.1} ({:.1})", share / plain, 1.0 / plain),
        interval(&everywhere),
        runs.rejected.to_string(),
    ]
}

fn head_of_planes() -> Vec<&'static str> {
    let place = ["element", "iteration error ≤", "L/a", "elements per a"];
    place.into_iter().chain(Acceleration::OF_FORCES.map(called)).collect()
}

fn rows_of_planes(Reach { recorded, .. }: &Reach) -> Vec<Vec<String>> {
    let row = |tolerance: usize, plane: usize| {
        let (stretch, elements) = PLANES[plane];
        let element = recorded.first().map_or("", |runs| runs.element.name()).into();
        let place = [element, format!("{:e}", TOLERANCES[tolerance]), stretch.to_string(), elements.to_string()];
        let converged = |runs: &Runs| runs.iterations[tolerance][plane].iter().map(Option::is_some).collect::<Vec<_>>();
        place.into_iter().chain(recorded.iter().map(|runs| interval(&converged(runs)))).collect()
    };
    [0, 1].into_iter().flat_map(|tolerance| (0..PLANES.len()).map(move |plane| row(tolerance, plane))).collect()
}

/// Lowest and highest start that converge, and how many between them do not.
fn interval(found: &[bool]) -> String {
    let (Some(first), Some(last)) = (found.iter().position(|f| *f), found.iter().rposition(|f| *f)) else {
        return "–".into();
    };
    let stiffnesses = stiffnesses();
    let gaps = found[first..=last].iter().filter(|found| !**found).count();
    let but = if gaps > 0 { format!(" but {gaps}") } else { String::new() };
    format!("{:.1e} … {:.1e}{but}", stiffnesses[first], stiffnesses[last])
}

fn rules(findings: &[Found<Numbers>]) -> String {
    let rules = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Rules(rules) => Some(rules),
        Numbers::Reach(_) | Numbers::Nested(_) => None,
    });
    let cell = |ended: &Ended| ended.converged().map_or("not".into(), |iterations| format!("{iterations} iterations"));
    let row = |rule: &Rule| {
        let place = [rule.rule.name().to_string(), rule.stiffness.to_string()];
        place.into_iter().chain(rule.ended.iter().map(cell)).collect()
    };
    let head = ["rule", "κ₀"].into_iter().chain(Acceleration::OF_FORCES.map(called));
    format!(
        "**Every rule within {ITERATIONS} iterations, iteration error ≤ 1e-3, node element**\n\n{}",
        table(head, &rules.flatten().map(row).collect::<Vec<_>>())
    )
}

fn nested(findings: &[Found<Numbers>]) -> String {
    let scenes = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Nested(nested) => Some(nested),
        Numbers::Reach(_) | Numbers::Rules(_) => None,
    });
    let rows = scenes.flat_map(|Nested { scene, starts }| starts.iter().map(|start| row_of_start(scene, start)));
    let densities = DENSITIES.map(|elements| format!("{elements} elements"));
    let head = ["scene", "element", "κ₀"].map(String::from).into_iter().chain(densities);
    markdown::folded("Iterations by scene, element and mesh", &table(head, &rows.collect::<Vec<_>>()), false)
}

fn row_of_start(scene: &str, start: &Start) -> Vec<String> {
    let place = [scene.into(), start.element.name().into(), format!("{:e}", start.stiffness)];
    place.into_iter().chain(start.meshes.iter().map(both_starts)).collect()
}

fn both_starts(mesh: &OnMesh) -> String {
    let count = |ended: Ended| ended.converged().map_or(ended.outcome.to_string(), |iterations| iterations.to_string());
    let nested = format!("{} (+{})", count(mesh.nested), mesh.coarser);
    mesh.closed.map_or(nested.clone(), |closed| format!("{} → {nested}", count(closed)))
}
