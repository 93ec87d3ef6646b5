//! One sheet as a page.

use crate::markdown::{significant, table, value as shown};
use crate::study::sheets::run::{Numbers, Value};

/// Name of its file and its text.
pub fn sheet(numbers: &Numbers) -> (String, String) {
    let Numbers { name, title, scene, sources, dofs, values } = numbers;
    let head = ["of", "quantity", "unit", "value ± bound", "closed form", "other codes, ± standard uncertainty"].map(String::from);
    let rows: Vec<Vec<String>> = values.iter().map(row).collect();
    let sources = match &sources[..] {
        [] => "none but this sheet".into(),
        some => some.join("\n* "),
    };
    let text = format!(
        "# {name}: {title}\n\nLengths in mm, forces in N, stresses in MPa. Generated; do not edit. `contact-vv solve {name}` solves it.\n\n\
         {}\n\n## Reference values\n\nOn {dofs} degrees of freedom, by exact active sets (*node*, *kinematic load*) on 8-node cells. The bound is the \
         error bar of the number: mesh, iteration and penalty. A closed form may be of an idealised scene (a half-plane, an infinite plate).\n\n{}\n\
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
        false => format!("{} ± {}", digits(value, bound), significant(bound, 2)),
    };
    let others = of.others.iter().map(|other| format!("{}: {}", other.script, quoted(other.value, other.uncertainty)));
    vec![
        of.of.clone(),
        of.quantity.clone(),
        of.unit.into(),
        quoted(of.value, of.bound),
        of.closed_form.map_or("–".into(), |value| format!("{value:.7}")),
        if of.others.is_empty() { "–".into() } else { others.collect::<Vec<_>>().join("; ") },
    ]
}

/// A value to the second digit of its bound.
fn digits(value: f64, bound: f64) -> String {
    let places = (1.0 - bound.abs().max(1e-12).log10().floor()).clamp(0.0, 10.0);
    format!("{value:.*}", places as usize)
}
