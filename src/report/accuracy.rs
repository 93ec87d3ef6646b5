//! The section on accuracies that are asked for.

use crate::markdown;
use crate::report::checks;
use crate::study::accuracy::ACCURACY;
use crate::study::met::STUDY;
use crate::study::met::scenes::GUESS;
use crate::study::unsorted::Finding;

/// The section: one row a scene and an accuracy, and the checks.
pub fn section(findings: &[Finding]) -> String {
    let own: Vec<&Finding> = findings.iter().filter(|finding| finding.case == ACCURACY).collect();
    let tables = || own.iter().flat_map(|finding| finding.tables.iter().map(|table| (&finding.name, table)));
    let Some((_, first)) = tables().next() else { return String::new() };
    let head: Vec<String> = ["scene, asked".to_owned()].into_iter().chain(first.head.iter().cloned()).collect();
    let rows: Vec<Vec<String>> = tables()
        .flat_map(|(name, table)| table.rows.iter().map(move |row| [vec![name.clone()], row.clone()].concat()))
        .collect();
    format!(
        "## An accuracy asked for instead of a mesh\n\n\
         `accuracy = \"0.1 %\"` in a scene file, or `--accuracy`, chooses elements, growth and candidates of 8-node cells. Errors are the \
         larger ones of peak pressure and half-width (second-moment angle). A mesh made by hand is the cheapest found whose worst \
         error over eight loads is within the asked one. Meshes finer than the one answered are solved for the estimate: *in all* \
         counts the freedoms of every mesh solved.\n\n{}\n{}\n{}",
        markdown::table(&head, &rows),
        checks::table(&own),
        met(findings)
    )
}

/// Whether an accuracy called met is met: answers by family and accuracy, and the checks.
fn met(findings: &[Finding]) -> String {
    let own: Vec<&Finding> = findings.iter().filter(|finding| finding.case == STUDY).collect();
    let [shortest, longest] = GUESS;
    let mut text = format!(
        "### Whether an accuracy called met is met\n\n\
         Random scenes of closed form: even polynomials and wedges with a round tip on blocks that carry the stresses of the \
         half-plane on their sides (`src/oracle/analytic/even_gap.rs`), waves (Westergaard), cylinders (Hertz) and pins in a wide plate \
         (Persson); such scenes whose body brings a coarse mesh, its inner nodes shaken, and two of them in one, whatever their \
         sizes. Size, material, load and the guess of the candidate stretch, {shortest} to {longest} times the contact, are drawn. The error is \
         the larger one of peak pressure and half-width against the closed form, over both contacts. `cargo run --release -- met` renews the record; the \
         report recomputes a part of it.\n\n",
    );
    for table in own.iter().flat_map(|finding| &finding.tables) {
        text += &format!("{}\n", markdown::table(&table.head, &table.rows));
    }
    text + &checks::table(&own) + "\n"
}
