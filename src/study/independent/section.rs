//! What the page shows of the independent scripts.

use std::fmt::Write;

use crate::error::Error;
use crate::markdown;
use crate::oracle::cross_code::independent::{Folder, Independent};
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::independent::found::{Measured, Number};
use crate::study::independent::judge::against;
use crate::study::independent::run::{Compared, Other};
use crate::uncertainty::COVERAGE;

/// The scripts, and their numbers beside ours.
pub fn section(findings: &[Found<Compared>]) -> Result<String, Error> {
    let frozen = Independent::read()?;
    let mut text = String::new();
    for folder in Folder::ALL {
        let hash: String = frozen.scripts.get(&folder).map_or("", String::as_str).chars().take(12).collect();
        let version = frozen.apart.get(&folder).or_else(|| frozen.versions.get(folder.name()));
        let live = if folder.is_set_up() { "asked again by the tests" } else { "asked when the answers were frozen" };
        let _ = writeln!(text, "* {} {}: script {hash}…, {live}.", folder.name(), version.map_or("", String::as_str));
    }
    let _ = write!(
        text,
        "\nEach script has its own mesh, its own contact terms in the language of its code, its own iteration and its own measures; none imports \
         from another. They share the numbers of the scene and the names of what is asked. ± is the standard uncertainty from three meshes; \
         |E| shall be at most {COVERAGE} u_val, of both meshes and of the script's penalty (what springs of its stiffness change on our mesh).\n\n{}\n",
        numbers(findings)
    );
    text += &picture("difference-independent.svg", "Difference of the profiles of independent codes to ours");
    Ok(text)
}

fn numbers(findings: &[Found<Compared>]) -> String {
    let head = [
        "case",
        "quantity",
        "ours ± u",
        "code",
        "found ± u",
        "E = ours − theirs",
        "u_val",
        "|E| / u_val",
        "",
        "to the closed form",
    ];
    let rows = findings.iter().flat_map(|found| {
        let compared = found.numbers;
        Number::ALL
            .into_iter()
            .flat_map(move |number| compared.others.iter().map(move |other| row(compared, number, other)))
    });
    markdown::table(&head.map(String::from), &rows.collect::<Vec<_>>())
}

fn row(compared: &Compared, number: Number, other: &Other) -> Vec<String> {
    let quantity = match number {
        Number::Peak => "peak [MPa]",
        Number::Width => number.unit(compared.scene),
    };
    let percent = |share: f64| format!("{} %", markdown::significant(100.0 * share, 2));
    let quoted = |of: Measured| format!("{:.5} ± {}", of.value, percent(of.uncertainty / of.value.abs()));
    let (ours, theirs) = (number.of(compared.scene, &compared.ours), number.of(compared.scene, &other.found));
    let comparison = against(compared, other, number);
    let scale = theirs.value.abs();
    let exact = compared.closed_form.as_ref().map(|exact| number.of_closed_form(compared.scene, exact));
    vec![
        compared.scene.name().into(),
        quantity.into(),
        quoted(ours),
        format!("{} ({} dofs)", other.script, other.found.dofs),
        quoted(theirs),
        format!("{} %", markdown::signed(100.0 * comparison.error / scale, 2)),
        percent(comparison.uncertainty / scale),
        format!("{:.2}", comparison.ratio()),
        if comparison.ratio() <= COVERAGE { "✓" } else { "✗" }.into(),
        exact.map_or("–".into(), |exact| format!("{} %", markdown::signed(100.0 * (theirs.value / exact - 1.0), 2))),
    ]
}
