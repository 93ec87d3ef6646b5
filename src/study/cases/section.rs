//! The chapters on the paper's two examples, on the contacts with a closed form beside them, and on exact solutions.

use crate::case::library::{cylinder, pin_rod, truncated_hertz};
use crate::error::Error;
use crate::markdown;
use crate::measure::display_factor;
use crate::study::Found;
use crate::study::cases::run::Numbers;
use crate::study::drawn::picture;

/// What is shown of every run under all nine formulations.
const HEAD: [&str; 10] = [
    "formulation",
    "outcome",
    "iterations",
    "factorisations",
    "back-substitutions",
    "peak [MPa]",
    "half-width by moment",
    "by counting",
    "last active point",
    "resultant [N]",
];

/// Both examples, and the references of all cases.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::from("## Elastic cylinder on a rigid plane\n\n");
    text += &picture(
        "scene-cylinder.svg",
        "As Fig. 8. The scene: lower quarter, half by symmetry, uniform load on the horizontal cut",
    );
    text += "Reference: Hertz line contact. The quarter cylinder under uniform load is not quite Hertz's problem; the model error is shown by a/R.\n\n";
    text += &measures(findings, cylinder::NINE);
    text += &picture(
        "figure-10.svg",
        "Fig. 10: Hertz's exact solution and the five combinations of elements and algorithms that the paper shows",
    );
    text += &picture(
        "pressure-cylinder.svg",
        "As Fig. 10 with all nine formulations, and their difference to Hertz",
    );
    text += "### Truncated Hertz: the same contact without model error\n\nA block between the closed-form tractions of Hertz's half-space and a rigid parabola: all errors are discretisation errors.\n\n";
    text += &measures(findings, truncated_hertz::NINE);
    text += "## Pin in a connecting-rod eye\n\n";
    text += &picture("scene-pin-rod.svg", "As Fig. 12. The scene: pin fixed on its horizontal diameter, rod pulled by a rigid end face");
    text += "No closed form: the nine formulations are held against one another, the refinement series gives its own uncertainty, and \
         other codes solve the same problem. A pin in a wide plate is the same contact with a closed form.\n\n";
    text += &measures(findings, pin_rod::NINE);
    text += &picture(
        "figure-14.svg",
        "Fig. 14: pressure against angle of the five combinations that the paper shows; the place of Gaertner's curves is empty",
    );
    text += &picture("pressure-pin-rod.svg", "As Fig. 14 with all nine formulations");
    text += "### All cases\n\n";
    Ok(text + &references(findings))
}

/// What each case is, what it is held against, and where that comes from.
fn references(findings: &[Found<Numbers>]) -> String {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for Found { case, numbers, .. } in findings {
        if rows.last().is_some_and(|row| row[0] == *case) {
            continue;
        }
        let reference = match &numbers.case.oracle {
            Some(oracle) => oracle.name().to_owned(),
            None if numbers.case.is_reported() => "reported only".into(),
            None => "its own checks".into(),
        };
        let cited = numbers.case.oracle.iter().map(|oracle| oracle.source().citation);
        let sources = [numbers.case.source.clone()].into_iter().filter(|source| !source.is_empty()).chain(cited);
        let sources = sources.collect::<Vec<_>>().join("; ");
        rows.push(vec![(*case).into(), numbers.case.title.clone(), reference, sources]);
    }
    markdown::table(&["case", "what it is", "reference", "source"].map(String::from), &rows) + "\n"
}

/// What one quotes of every run of a case.
fn measures(findings: &[Found<Numbers>], case: &str) -> String {
    let own = || findings.iter().filter(|found| found.case == case);
    let straight = own().all(|found| found.numbers.case.scene.contact().path.is_straight());
    let unit = if straight { "mm" } else { "degrees" };
    let rows: Vec<Vec<String>> = own().map(|found| row(found.numbers)).collect();
    let table = markdown::table(&HEAD.map(String::from), &rows);
    format!("**{case}: measures** (widths in {unit})\n\n{table}\n")
}

fn row(Numbers { case, run, .. }: &Numbers) -> Vec<String> {
    let (work, measures) = (&run.solution.work, run.measures());
    let factor = display_factor(&case.scene.contact().path);
    let quoted = [
        measures.peak.pressure,
        factor * measures.half_width,
        factor * measures.half_width_nodes,
        factor * measures.edge(),
        run.transmitted(),
    ];
    let counts = [work.iterations, work.factorisations, work.back_substitutions].map(|n| n.to_string());
    let quoted = quoted.map(|x| if run.solution.converged() { markdown::significant(x, 5) } else { "–".into() });
    let first = [run.formulation.name(), run.solution.outcome.to_string()];
    first.into_iter().chain(counts).chain(quoted).collect()
}
