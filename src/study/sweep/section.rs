//! The section on initial stiffness and rules.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::sweep::run::{End, Numbers, Rule, STARTS};

/// Elements, chart, and the table of the rules.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let mut text = String::new();
    text += &picture("contact-problem.svg", "As Figs 1 and 2: bodies in contact, and contact elements on the potential contact area");
    text += &picture("contact-elements.svg", "As Figs 3, 4 and 5: line, layer and node contact element");
    text += &picture(
        "iterations-against-stiffness.svg",
        "As Fig. 11 with all nine formulations, by the iteration error: iterations against initial stiffness; runs that did not converge are drawn as hollow markers above the chart",
    );
    let rules = findings.iter().filter_map(|found| match found.numbers {
        Numbers::Rules(rules) => Some(rules),
        Numbers::Sweep(_) => None,
    });
    let rows: Vec<Vec<String>> = rules.flatten().map(row).collect();
    let head = ["algorithm", "rule"].map(String::from).into_iter().chain(STARTS.map(|k| format!("κ₀ = {k}")));
    text += "**The rules of each algorithm on the cylinder, node element; `penalty` converges to its own springs' law**\n\n";
    Ok(text + &markdown::table(&head.collect::<Vec<_>>(), &rows) + "\n")
}

fn row(rule: &Rule) -> Vec<String> {
    let ends = rule.runs.iter().map(end);
    [rule.algorithm, rule.rule].map(String::from).into_iter().chain(ends).collect()
}

/// How a run ended, with its iterations where it converged.
fn end(run: &End) -> String {
    match (&run.outcome, run.iterations) {
        (None, _) => "refused: contact reaches the end of the candidate surface".into(),
        (Some(outcome), Some(iterations)) => format!("{outcome}, {iterations} iterations"),
        (Some(outcome), None) => outcome.clone(),
    }
}
