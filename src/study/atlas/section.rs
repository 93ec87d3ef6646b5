//! The chapter on where methods fail: recommendation, maps, laws, methods, slices, and predictions against runs.

use std::fmt::Write;

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::atlas::agreement::{Agreement, FACTOR, HALVINGS, Share, agreements};
use crate::study::atlas::chart::Chart;
use crate::study::atlas::plane::STRETCH;
use crate::study::atlas::recommended::{methods, recommendation};
use crate::study::atlas::run::Numbers;
use crate::study::atlas::slices::slices;
use crate::study::atlas::summary;
use crate::study::drawn::picture;

/// The chapter.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let charts: Vec<&Chart> = findings.iter().map(|found| &found.numbers.chart).collect();
    let digests = summary::digests(&charts);
    let mut text = String::new();
    let _ = writeln!(text, "{}", recommendation(&digests));
    text += &picture(
        "iterations-predicted.svg",
        &format!(
            "As Fig. 11, predicted: measured points on curves predicted from the condensed matrices; truncated Hertz, candidates to \
             {STRETCH} half-widths; colours tell the rules apart. Hollow markers above the frame: how the others ended"
        ),
    );
    text += LAWS;
    let _ = writeln!(text, "{}", methods(&digests));
    text += &picture(
        "atlas-stretch.svg",
        "How every run ends over initial stiffness and candidate surface, with the predicted boundary",
    );
    text += &picture("atlas-mesh.svg", "The same over initial stiffness and mesh");
    text += &slices(&charts);
    let _ = writeln!(text, "**Predictions against runs**\n\n{}", predictions(&agreements(&charts)));
    Ok(text + EXPLAINED)
}

/// How often each prediction fails, by method.
fn predictions(agreements: &[Agreement]) -> String {
    let head = [
        "method".into(),
        "converged against the prediction".into(),
        "failed against it".into(),
        format!("iterations off by a factor above {FACTOR}, or under kinematic load by more than {HALVINGS}"),
    ];
    let cell = |Share { count, of }: Share| if of == 0 { "–".into() } else { format!("{count} of {of}") };
    let row = |one: &Agreement| vec![one.method.to_string(), cell(one.converged), cell(one.failed), cell(one.off)];
    markdown::table(&head, &agreements.iter().map(row).collect::<Vec<_>>())
}

const LAWS: &str = "\
The curves, *a posteriori* but for kinematic load: from the condensed matrices and the final active set, which needs the solved contact. \
*Constant stiffness with correction* is followed as a \
linear iteration from its start to the tolerance, and takes no fewer iterations than hard springs need to work off their gaps, \
k₀ g/p̄; *varying stiffness* is as slow as the slowest point near the contact edge, whose force falls by w/g, or by κ (w − g), an iteration; \
*kinematic load* halves L² − a². *A priori*, for any scene: constant stiffness with correction is an averaged map, which comes no farther from its limit at any \
iteration, so that from no κ₀ > 0 it diverges or cycles. Derivations are given beside the formulas in `src/solver/stability`.\n\n";

const EXPLAINED: &str = "\
What the predictions leave out: *line and layer elements* have an alternating pressure mode, which hard springs raise and soft ones \
hardly feel; the rates at the limit do not know how much of it a start raises. *Varying stiffness with correction* is predicted next to \
the contact: whether a run from afar gets there is not. *Constant stiffness with secant* may pass where the whole gap of the point \
nearest the centre, in which its instability sits, is below the tolerance: the error does not see it swing.\n\n";
