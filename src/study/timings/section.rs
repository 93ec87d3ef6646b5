//! The section on speed against accuracy.

use crate::error::Error;
use crate::markdown::{self, significant};
use crate::solve::{Element, Iteration};
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::pairing::Pairing;
use crate::study::timings::code::Code;
use crate::study::timings::compared::apart;
use crate::study::timings::digits_section;
use crate::study::timings::growth_section;
use crate::study::timings::precision::{ASKED, Family, LOADS, Point, TOLERANCE};
use crate::study::timings::record::Record;
use crate::study::timings::run::{Numbers, record};
use crate::study::timings::targets::targets;

/// Families whose meshes are compared, and how they are graded.
const GRADED: [(Family, &str); 3] =
    [(Family::Truncated, "graded"), (Family::Steep, "steep"), (Family::Uniform, "uniform")];

/// What a parabola misses of the top of `√(1 − x²/a²)`, fitted by least squares to x < a/4: its next term is x⁴/8a⁴, and the best
/// parabola for x⁴ on 0 to h is at 0 off by 3h⁴/35.
const PARABOLA: f64 = 3.0 / 35.0 / 8.0 * (0.25 * 0.25 * 0.25 * 0.25);

/// The whole section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let record = record(findings)?;
    let parts = [
        machine(&record),
        asked(&record),
        precision(),
        digits_section::section(&record),
        what_pays(&record),
        growth_section::section(&record),
    ];
    Ok(parts.concat())
}

fn asked(record: &Record) -> String {
    let rows: Vec<Vec<String>> = (targets(record).into_iter())
        .map(|t| {
            let met = t.met.map_or("–", |met| if met { "✓" } else { "✗" });
            vec![t.what, t.asked, t.measured, met.into()]
        })
        .collect();
    markdown::table(&["what", "asked for", "measured", "met"].map(String::from), &rows)
}

fn machine(record: &Record) -> String {
    let machine = &record.measured.machine;
    let versions: Vec<String> = machine.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let text = format!(
        "Seconds and ratios are the record of one machine ({}, {} threads, {}; {}; {}), on one thread unless said otherwise; \
         `cargo run --release -- timings` renews it. Ratios are medians of runs by turns in one process. The *plain solve* is one \
         sparse Cholesky solve of the same matrix by faer's own high-level solver with its default ordering, the *contact solve* \
         everything from the assembled matrix to the full displacement: ordering, factorisation, Schur complement, all iterations \
         of node + kinematic load, recovery. Errors and counts beside the seconds are computed again with every report.\n\n",
        machine.processor,
        machine.threads,
        machine.system,
        machine.compiler,
        versions.join(", ")
    );
    let skipped = record.measured.skipped().into_iter().map(|why| format!("Skipped: {why}.\n\n"));
    let apart = apart(record).into_iter().map(|sentence| sentence + "\n\n");
    text + &skipped.chain(apart).collect::<String>()
}

fn precision() -> String {
    let mut text = format!(
        "\n## Error against seconds and work\n\nThe mesh does not know the answer: it is graded for a nominal half-width, and {LOADS} loads \
         move the contact edge across one of its elements. Finding the contact is part of the cost. All runs to the tolerance \
         {TOLERANCE:e}. Errors of the cylinder are those against the converged answer of its own scene. The other codes solve on \
         meshes and by methods of their own: scikit-fem by exact active sets, dolfinx by a penalty, NGSolve ({}) by an augmented \
         Lagrangian. No mesh of theirs knows where the contact ends. scikit-fem and dolfinx read p₀ by a parabola over a quarter of the \
         half-width, which leaves {} of Hertz's ellipse even where the pressure is exact; NGSolve's is read with a term in x⁴, so that its \
         error is free of that.\n\n",
        Code::Ngsolve.cells(),
        significant(PARABOLA, 1)
    );
    text += &picture(
        "work-precision.svg",
        "Truncated Hertz: worst error of peak and second-moment width against seconds and counted operations",
    );
    text += &picture(
        "work-precision-cylinder.svg",
        "Cylinder: the same, and GetFEM and CalculiX on our meshes under one load",
    );
    let detail = picture(
        "work-precision-detail.svg",
        "Worst error against seconds of all nine formulations; hollow: some load did not converge",
    );
    text + &markdown::folded("By formulation and kind of cells", &detail, false)
}

/// Degrees of freedom and seconds needed for each error asked for.
fn what_pays(record: &Record) -> String {
    let mut rows = Vec::new();
    for (family, grading) in GRADED {
        for nodes in [4, 8] {
            for element in Element::ALL {
                let pairing = Pairing { element, algorithm: Iteration::Kinematic };
                let points = record.of_meshes(family, nodes, pairing);
                let first = [format!("{nodes}-node, {grading}"), element.name().to_owned()];
                rows.push(first.into_iter().chain(ASKED.map(|error| needed(&points, error))).collect());
            }
        }
    }
    let head = ["cells", "element"].map(String::from).into_iter();
    let head: Vec<String> = head.chain(ASKED.map(|error| format!("{} %", 100.0 * error))).collect();
    format!(
        "## What pays\n\n{}Degrees of freedom and milliseconds of the cheapest mesh whose median errors of p₀ and a are \
         both within:\n\n{}\n",
        picture(
            "what-pays.svg",
            "Graded against uniform meshes, 4-node against 8-node cells, node against line and layer elements"
        ),
        markdown::table(&head, &rows)
    )
}

/// Degrees of freedom and milliseconds of the fastest point within an error; – without one.
fn needed(points: &[&Point], error: f64) -> String {
    let enough = points.iter().filter(|point| point.error() <= error);
    let cheapest = enough.min_by(|a, b| a.seconds.total_cmp(&b.seconds));
    cheapest.map_or("–".into(), |p| format!("{}, {} ms", p.dofs, significant(1e3 * p.seconds, 2)))
}
