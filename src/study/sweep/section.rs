//! The section on initial stiffness and rules.

use crate::algorithm::logarithms::STOOD;
use crate::error::Error;
use crate::markdown;
use crate::solve::{Element, Formulation, Iteration, Settings};
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::sweep::run::{End, Numbers, Rule, STARTS, Saved};
use crate::study::sweep::scene::Scene;

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
    let count =
        |iterations: Option<usize>| iterations.map_or_else(|| "not converged".into(), |count| count.to_string());
    let cell = |saved: &Saved| saved.iterations.map(count).join(" → ");
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
