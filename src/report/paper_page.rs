//! The page on the paper: its statements in full, where it is silent, its misprints, and all sources.

use crate::markdown;
use crate::report::{decisions, heading, statements};
use crate::solve::Formulation;
use crate::study::Finding;

/// Name of the file.
pub const FILE: &str = "paper.md";

/// The page.
pub fn page(findings: &[Finding]) -> String {
    let rows: Vec<Vec<String>> = statements::judge(findings)
        .into_iter()
        .map(|one| vec![one.text.into(), one.measured, format!("**{}**", one.judgement)])
        .collect();
    let own: Vec<String> = Formulation::nine().iter().filter(|f| f.is_in_the_paper()).map(Formulation::name).collect();
    let list = |items: &[&str]| items.iter().map(|item| format!("* {item}\n")).collect::<String>();
    let body = format!(
        "## Its statements\n\n{}\n\n{}\n\
         The paper itself shows {} of the nine formulations: {}. The others are ours.\n\n\
         ## Where it is silent\n\nThe figures of the paper are not at hand: none of its dimensions, loads or plotted values is known.\n\n{}\n\
         ## Misprints and gaps\n\n{}\n## Sources\n\n{}",
        statements::readings::RULE,
        markdown::table(&["statement", "measured", "judgement"].map(String::from), &rows),
        own.len(),
        own.join(", "),
        decisions::open_points(),
        decisions::misprints(),
        list(&decisions::REFERENCES),
    );
    heading::page(
        "The paper",
        "What of János Égert's paper of 1999 is reproduced, and what had to be decided.",
        &[],
        &body,
    )
}
