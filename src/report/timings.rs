//! The section on speed against accuracy, from the record.

use std::fmt::Write;

use crate::error::Error;
use crate::markdown;
use crate::oracle::cross_code::Code;
use crate::report::checks;
use crate::study::timings::growth::{LARGE, STAGES};
use crate::study::timings::judge::TIMINGS;
use crate::study::timings::others::Stages;
use crate::study::timings::precision::{ASKED, Family, LOADS, Point, TOLERANCE};
use crate::study::timings::record::Record;
use crate::study::timings::statistics::exponent;
use crate::study::timings::targets::{cheapest, targets, theirs};
use crate::study::unsorted::Finding;

/// The whole section.
pub fn section(findings: &[Finding]) -> Result<String, Error> {
    let record = Record::read()?;
    let mut text = String::from("## Speed against accuracy\n\n");
    text += &machine(&record);
    let rows: Vec<Vec<String>> = (targets(&record).into_iter())
        .map(|t| {
            let met = t.met.map_or("–", |met| if met { "✓" } else { "✗" });
            vec![t.what, t.asked, t.measured, met.into()]
        })
        .collect();
    text += &markdown::table(&["what", "asked for", "measured", "met"].map(String::from), &rows);
    text += &precision();
    text += &what_pays(&record);
    text += &default_meshes(findings);
    let _ = write!(
        text,
        "### Growth\n\n![Growth with the number of freedoms](snapshots/charts/growth.svg)\n\
         *Seconds by stage, whole solves and memory; exponents fitted from {LARGE} freedoms on. A boundary method needs far fewer \
         unknowns for Hertz itself: this is the price of a method that takes any body.*\n\n"
    );
    text += &operations(&record);
    text += &stages(&record);
    text += &stage_for_stage(&record);
    text += &peers(&record);
    let own = |finding: &&Finding| finding.case == TIMINGS;
    Ok(text + &checks::table(&findings.iter().filter(own).collect::<Vec<_>>()))
}

/// How the counted operations grow, which seconds follow in the end.
fn operations(record: &Record) -> String {
    let large = record.measured.growth.iter().map(|one| &one.counts).filter(|counts| counts.freedoms as f64 >= LARGE);
    let (operations, entries): (Vec<_>, Vec<_>) = large
        .map(|counts| {
            let n = counts.freedoms as f64;
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

fn machine(record: &Record) -> String {
    let machine = &record.measured.machine;
    let versions: Vec<String> = machine.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let mut text = format!(
        "Seconds and ratios are the record of one machine ({}, {} threads, {}; {}; {}), on one thread unless said otherwise; \
         `cargo run --release -- timings` renews it. Ratios are medians of runs by turns in one process. The *plain solve* is one \
         sparse Cholesky solve of the same matrix by faer's own high-level solver with its default ordering, the *contact solve* \
         everything from the assembled matrix to the full displacement: ordering, factorisation, Schur complement, all steps \
         of node + kinematic load, recovery. Errors and counts beside the seconds are computed again with every report.\n\n",
        machine.processor,
        machine.threads,
        machine.system,
        machine.compiler,
        versions.join(", ")
    );
    for why in &record.measured.absent {
        let _ = writeln!(text, "Skipped: {why}.\n");
    }
    text
}

fn precision() -> String {
    let chart = |file: &str, caption: &str| format!("![{caption}](snapshots/charts/{file}.svg)\n*{caption}.*\n\n");
    let mut text = format!(
        "\n### Error against seconds and work\n\nThe mesh does not know the answer: it is graded for a nominal half-width, and {LOADS} loads \
         move the contact edge across one of its elements. Finding the contact is part of the cost. All runs to the tolerance \
         {TOLERANCE:e}. Meshes on which some load did not converge within the steps stand hollow above the frame. The other codes solve on \
         meshes and by methods of their own (scikit-fem exact active sets, dolfinx penalty).\n\n"
    );
    text += &chart("precision-truncated-8-node-seconds", "Truncated Hertz, 8-node cells: error against seconds");
    text += &chart(
        "precision-cylinder-8-node-seconds",
        "Cylinder, 8-node cells: error against seconds, with Hertz's model error; GetFEM and CalculiX on our meshes under the nominal load",
    );
    let mut rest = chart("precision-truncated-4-node-seconds", "Truncated Hertz, 4-node cells: error against seconds");
    rest += &chart("precision-cylinder-4-node-seconds", "Cylinder, 4-node cells: error against seconds");
    for (name, title) in [("truncated", "Truncated Hertz"), ("cylinder", "Cylinder")] {
        for nodes in [8, 4] {
            let caption = format!("{title}, {nodes}-node cells: error against counted operations");
            rest += &chart(&format!("precision-{name}-{nodes}-node-work"), &caption);
        }
    }
    text + &markdown::folded("4-node cells, and the same against counted operations", &rest, false)
}

/// Freedoms and seconds needed for each error asked for.
fn what_pays(record: &Record) -> String {
    let mut rows = Vec::new();
    for (family, grading) in [(Family::Truncated, "graded"), (Family::Steep, "steep"), (Family::Uniform, "uniform")] {
        for nodes in [4, 8] {
            for formulation in family.formulations().iter().filter(|f| f.name().ends_with("kinematic")) {
                let of = |p: &&Point| {
                    p.family == family.name() && p.cell_nodes == nodes && p.formulation == formulation.name()
                };
                let points: Vec<&Point> = record.points.iter().filter(of).collect();
                let needed = ASKED.map(|error| {
                    let enough = points.iter().filter(|point| point.error() <= error);
                    let cheapest = enough.min_by(|a, b| a.seconds.total_cmp(&b.seconds));
                    cheapest.map_or("–".into(), |p| {
                        format!("{}, {} ms", p.freedoms, markdown::significant(1e3 * p.seconds, 2))
                    })
                });
                let first = [format!("{nodes}-node, {grading}"), formulation.element.name().to_owned()];
                rows.push(first.into_iter().chain(needed).collect());
            }
        }
    }
    let head = ["cells", "element"].map(String::from).into_iter();
    let head: Vec<String> = head.chain(ASKED.map(|error| format!("{} %", 100.0 * error))).collect();
    format!(
        "### What pays\n\n![What pays](snapshots/charts/what-pays.svg)\n*Graded against uniform meshes, 4-node against 8-node cells, node \
         against line and layer elements.*\n\nFreedoms and milliseconds of the cheapest mesh whose median errors of p₀ and a are \
         both within:\n\n{}\n",
        markdown::table(&head, &rows)
    )
}

/// What growth the scenes have by default, and what others would change.
fn default_meshes(findings: &[Finding]) -> String {
    let mut text = String::from(
        "### The default meshes\n\nThe scene's own growth stands first. Those of truncated Hertz, the cylinder and the plate are the fastest tried \
         that kept every row which judges the scene: faster growth cost truncated Hertz the order of its half-width on 4-node cells, the \
         cylinder the predicted steps of kinematic load, and the plate the hoop stress of its rim opposite the pin. The pin–rod grows as the \
         cylinder does.\n\n",
    );
    for table in findings.iter().filter(|finding| finding.case == TIMINGS).flat_map(|finding| &finding.tables) {
        let _ = write!(text, "{}:\n\n{}\n", table.title, markdown::table(&table.head, &table.rows));
    }
    text
}

/// Where other codes spend their time on the way to 0.1 %, and where we do.
fn stage_for_stage(record: &Record) -> String {
    let mut rows = Vec::new();
    let mut row = |code: String, freedoms: usize, stages: &Stages| {
        let milliseconds = [stages.stiffness, stages.linear, stages.rest].map(|s| markdown::significant(1e3 * s, 2));
        rows.push([vec![code, freedoms.to_string()], milliseconds.into()].concat());
    };
    for beside in &record.measured.beside {
        let theirs =
            Code::ALL.into_iter().find(|code| code.name() == beside.code).and_then(|code| theirs(record, code));
        if let (Some(theirs), Some(own)) = (theirs, cheapest(&record.points)) {
            row(format!("{} {}", theirs.code, theirs.version), theirs.freedoms, &theirs.stages);
            row(format!("ours beside {}", beside.code), own.freedoms, &beside.stages);
        }
    }
    if rows.is_empty() {
        return String::new();
    }
    let head = ["code", "freedoms", "stiffness [ms]", "linear solutions [ms]", "contact and all else [ms]"];
    format!(
        "### Stage for stage\n\nTruncated Hertz to 0.1 % in p₀ and a, each code on its own cheapest mesh, one thread. Stiffness: \
         cells integrated and assembled. Linear solutions: ordering, factorisation, elimination, as often as a code does them. Ours count \
         the mesh too, theirs do not.\n\n{}\n",
        markdown::table(&head.map(String::from), &rows)
    )
}

/// Where the time goes on the default cylinder.
fn stages(record: &Record) -> String {
    let default = record.measured.growth.iter().find(|one| (one.counts.elements, one.counts.refinement) == (8, 0));
    let Some(one) = default else { return String::new() };
    let median = |stage: &str| one.stages.get(stage).map_or(f64::NAN, |spread| spread.median);
    let total: f64 = STAGES.iter().map(|stage| median(stage)).sum();
    let row = |stage: &&str| {
        let share = median(stage) / total;
        let bar = "█".repeat((40.0 * share).round() as usize);
        vec![(*stage).to_owned(), markdown::significant(1e3 * median(stage), 2), format!("{:.0} %", 100.0 * share), bar]
    };
    let rows: Vec<Vec<String>> = STAGES.iter().map(row).collect();
    format!(
        "### Where the time goes\n\nThe default cylinder, {} freedoms, {} retained, {} steps:\n\n{}\n",
        one.counts.freedoms,
        one.counts.retained,
        one.counts.steps,
        markdown::table(&["stage", "ms", "share", ""].map(String::from), &rows)
    )
}

/// Other codes on our mesh of the cylinder.
fn peers(record: &Record) -> String {
    let rows: Vec<Vec<String>> = (record.measured.peers.iter())
        .map(|p| {
            let percent = |x: f64| format!("{:.2} %", 100.0 * x);
            vec![
                format!("{} {}", p.code, p.version),
                p.freedoms.to_string(),
                p.steps.to_string(),
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
    let head = ["code", "our freedoms", "its steps", "seconds", "ours", "ratio", "its errors of p₀, a", "ours"];
    let mut counted: Vec<String> = Vec::new();
    for peer in &record.measured.peers {
        let line = format!("{}: {}", peer.code, peer.counted);
        if !counted.contains(&line) {
            counted.push(line);
        }
    }
    format!(
        "### The same mesh in codes one would pick instead\n\nThe cylinder on our 8-node mesh, handed over; ours is the contact solve from the \
         assembled matrix on; errors against Hertz, whose model error is part of them. {}.\n\n{}\n",
        counted.join(". "),
        markdown::table(&head.map(String::from), &rows)
    )
}
