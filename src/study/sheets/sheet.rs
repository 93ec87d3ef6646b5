//! One sheet as a page.

use crate::markdown::{significant, table, to_bound, value as shown};
use crate::study::sheets::run::{Numbers, Value};

/// Name of its file and its text.
pub fn sheet(numbers: &Numbers) -> (String, String) {
    let Numbers { name, title, scene, sources, dofs, values } = numbers;
    let head =
        ["of", "quantity", "unit", "value ± bound", "cells", "closed form", "other codes, ± standard uncertainty"]
            .map(String::from);
    let rows: Vec<Vec<String>> = values.iter().map(row).collect();
    let sources = match &sources[..] {
        [] => "none but this sheet".into(),
        some => some.join("\n* "),
    };
    let text = format!(
        "# {name}: {title}\n\nLengths in mm, forces in N, stresses in MPa. Generated; do not edit. `contact-vv solve {name}` solves it.\n\n\
         {}\n\n## Reference values\n\nBy exact active sets (*node*, *kinematic load*): on {dofs} degrees of freedom of 8-node cells, with the \
         error bar of the number as bound (mesh, iteration and penalty); or, where these tell more, on cells of order 8 fitted to the contact, with twice the \
         largest difference to three other meshes as bound ([reference answers](../pages/references.md)). A closed form may be of an idealised scene (a half-plane, an infinite plate).\n\n{}\n\
         ## Sources\n\n* {sources}\n",
        scene.join("\n\n"),
        table(&head, &rows),
    );
    (format!("{name}.md"), text)
}

fn row(of: &Value) -> Vec<String> {
    let quoted = |value: f64, bound: f64| match value.is_nan() {
        true => "without limit".into(),
        false if bound.is_nan() => format!("{}, bound unknown", shown(value)),
        false => format!("{} ± {}", to_bound(value, bound), significant(bound, 2)),
    };
    let others = of.others.iter().map(|other| format!("{}: {}", other.script, quoted(other.value, other.uncertainty)));
    vec![
        of.of.clone(),
        of.quantity.clone(),
        of.unit.into(),
        quoted(of.value, of.bound),
        if of.fitted { "order 8" } else { "8-node" }.into(),
        of.closed_form.map_or("–".into(), |value| format!("{value:.7}")),
        if of.others.is_empty() { "–".into() } else { others.collect::<Vec<_>>().join("; ") },
    ]
}
