//! The section on accuracies that are asked for.

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::accuracy::run::Numbers;

/// Columns beside the name of the trial.
const HEAD: [&str; 8] = [
    "scene, asked",
    "estimated",
    "against closed form",
    "against finer mesh",
    "dofs",
    "dofs of all meshes",
    "by hand",
    "worst by hand",
];

/// One row a scene and an accuracy.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let rows: Vec<Vec<String>> = findings.iter().map(|found| row(found.name, found.numbers)).collect();
    Ok(format!(
        "`accuracy = \"0.1 %\"` in a scene file, or `--accuracy`, chooses elements, growth and candidates of 8-node cells, from 0.1 % on \
         the order of cells fitted to the contact. Errors are the \
         larger ones of peak pressure and second-moment width (second-moment angle). A mesh made by hand is the cheapest found whose worst \
         error over eight loads is within the asked one. The estimate is the error bar of every solve: *dofs of all \
         meshes* counts those of the meshes before the one answered, and of the coarser ones of their bars.\n\n{}\n",
        markdown::table(&HEAD.map(String::from), &rows)
    ))
}

fn row(name: &str, numbers: &Numbers) -> Vec<String> {
    let percent = |error: f64| format!("{:.3} %", 100.0 * error);
    vec![
        name.into(),
        percent(numbers.estimate),
        percent(numbers.closed_form),
        percent(numbers.finer),
        numbers.dofs.to_string(),
        numbers.dofs_in_all.to_string(),
        numbers.by_hand.dofs.to_string(),
        percent(numbers.by_hand.worst),
    ]
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
