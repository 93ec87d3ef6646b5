//! How the cost grows with the mesh, where the time goes, and where it goes in other codes.

use crate::clock::Stage;
use crate::markdown;
use crate::study::drawn::picture;
use crate::study::timings::growth::LARGE;
use crate::study::timings::others::Stages;
use crate::study::timings::record::Record;
use crate::study::timings::statistics::exponent;
use crate::study::timings::targets::{COMPARED, cheapest, theirs};

/// Elements per half-width and times halved of the default cylinder.
const DEFAULT: (usize, u32) = (8, 0);

/// The part of the section.
pub fn section(record: &Record) -> String {
    let caption = format!(
        "Seconds by stage, whole solves and memory; exponents fitted from {LARGE} degrees of freedom on. A boundary method needs far \
         fewer unknowns for Hertz itself: this is the price of a method that takes any body"
    );
    let chart = picture("growth.svg", &caption);
    let parts = [operations(record), stages(record), stage_for_stage(record), peers(record)];
    format!("## Growth\n\n{chart}{}", parts.concat())
}

/// How the counted operations grow, which seconds follow in the end.
fn operations(record: &Record) -> String {
    let large = record.measured.growth.iter().map(|one| &one.counts).filter(|counts| counts.dofs as f64 >= LARGE);
    let (operations, entries): (Vec<_>, Vec<_>) = large
        .map(|counts| {
            let n = counts.dofs as f64;
            ([n, counts.factor_operations], [n, counts.factor_entries as f64])
        })
        .unzip();
    format!(
        "The operations of the factorisation grow with the exponent {:.2} over the same meshes, the entries of its factor with {:.2}. \
         Nested dissection of a plane mesh of n nodes leads to n^1.5 operations (George 1973): the time of a direct method grows \
         slower only as long as something else takes most of it.\n\n",
        exponent(&operations),
        exponent(&entries)
    )
}

/// Where the time goes on the default cylinder.
fn stages(record: &Record) -> String {
    let default = record.measured.growth.iter().find(|one| (one.counts.elements, one.counts.refinement) == DEFAULT);
    let Some(one) = default else { return "## Where the time goes\n\nNot recorded.\n\n".into() };
    let total = one.seconds(&Stage::ALL);
    let row = |stage: Stage| {
        let seconds = one.seconds(&[stage]);
        let share = seconds / total;
        let bar = "█".repeat((40.0 * share).round() as usize);
        vec![stage.name().into(), markdown::significant(1e3 * seconds, 2), format!("{:.0} %", 100.0 * share), bar]
    };
    let rows: Vec<Vec<String>> = Stage::ALL.into_iter().map(row).collect();
    format!(
        "## Where the time goes\n\nThe default cylinder, {} degrees of freedom, {} retained, {} iterations:\n\n{}\n",
        one.counts.dofs,
        one.counts.retained,
        one.counts.iterations,
        markdown::table(&["stage", "ms", "share", ""].map(String::from), &rows)
    )
}

/// Where other codes spend their time on the way to 0.1 %, and where we do.
fn stage_for_stage(record: &Record) -> String {
    let mut rows = Vec::new();
    let mut row = |code: String, dofs: usize, stages: &Stages| {
        let milliseconds = [stages.stiffness, stages.linear, stages.rest].map(|s| markdown::significant(1e3 * s, 2));
        rows.push([vec![code, dofs.to_string()], milliseconds.into()].concat());
    };
    for beside in &record.measured.beside {
        if let (Some(theirs), Some(own)) = (theirs(record, beside.code), cheapest(&record.points)) {
            row(format!("{} {}", theirs.code, theirs.version), theirs.dofs, &theirs.stages);
            row(format!("ours beside {}", beside.code), own.dofs, &beside.stages);
        }
    }
    if rows.is_empty() {
        return String::new();
    }
    let head = ["code", "dofs", "stiffness [ms]", "linear solutions [ms]", "contact and all else [ms]"];
    format!(
        "## Stage for stage\n\nTruncated Hertz to {} % in p₀ and a, each code on its own cheapest mesh, one thread. Stiffness: \
         cells integrated and assembled. Linear solutions: ordering, factorisation, elimination, as often as a code does them. Ours count \
         the mesh too, theirs do not.\n\n{}\n",
        100.0 * COMPARED,
        markdown::table(&head.map(String::from), &rows)
    )
}

/// Other codes on our mesh of the cylinder.
fn peers(record: &Record) -> String {
    let rows: Vec<Vec<String>> = (record.measured.peers.iter())
        .map(|p| {
            let percent = |x: f64| format!("{:.2} %", 100.0 * x);
            vec![
                format!("{} {}", p.code.name(), p.version),
                p.dofs.to_string(),
                p.iterations.to_string(),
                markdown::significant(p.seconds.median, 3),
                markdown::significant(p.ours.median, 3),
                format!("{:.0}", p.seconds.median / p.ours.median),
                p.errors.map(percent).join(", "),
                p.our_errors.map(percent).join(", "),
            ]
        })
        .collect();
    if rows.is_empty() {
        return String::new();
    }
    let head = ["code", "our dofs", "its iterations", "seconds", "ours", "ratio", "its errors of p₀, a", "ours"];
    let mut counted: Vec<String> = Vec::new();
    for peer in &record.measured.peers {
        let line = format!("{}: {}", peer.code.name(), peer.counted);
        if !counted.contains(&line) {
            counted.push(line);
        }
    }
    format!(
        "## The same mesh in codes one would pick instead\n\nThe cylinder on our 8-node mesh, handed over; ours is the contact solve from the \
         assembled matrix on; errors against the converged answer of the scene. {}.\n\n{}\n",
        counted.join(". "),
        markdown::table(&head.map(String::from), &rows)
    )
}
