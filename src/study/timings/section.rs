//! The page on speed against accuracy, and the sentences that its charts and the front page share with it.

use std::collections::BTreeSet;

use crate::clock::Stage;
use crate::markdown::{self, Column, significant};
use crate::mesh::Order;
use crate::study::drawn::picture;
use crate::study::timings::growth::{Growth, exponent};
use crate::study::timings::others::{PeerPoint, cells};
use crate::study::timings::pareto::{cheapest, sound};
use crate::study::timings::precision::{LOADS, Point};
use crate::study::timings::record::{Beside, Record};
use crate::study::timings::series::{Series, TOLERANCE};
use crate::study::timings::targets::{COMPARED, NOT_ASKED, Target, ours, targets};

/// What a parabola misses of the top of `√(1 − x²/a²)`, fitted by least squares to x < a/4: its next term is x⁴/8a⁴, and the best
/// parabola for x⁴ on 0 to h is at 0 off by 3h⁴/35.
const PARABOLA: f64 = 3.0 / 35.0 / 8.0 * (0.25 * 0.25 * 0.25 * 0.25);

/// Columns of the table of targets.
const ASKED: [Column<Target>; 4] = [
    ("what", |target| target.what.clone()),
    ("asked for", |target| target.asked.clone()),
    ("measured", |target| target.measured.clone()),
    ("met", |target| target.met.map_or("–", |met| if met { "✓" } else { "✗" }).into()),
];

/// The page of a record.
pub fn page(record: &Record) -> String {
    let asked = markdown::columns(&ASKED, &targets(record));
    [machine(record), asked, counted(record), precision(), growth(record)].concat()
}

/// What the seconds of each code on our meshes count, by its own account.
fn counted(record: &Record) -> String {
    let told = |peer: &PeerPoint| format!("{} {}: {}.", peer.code.name(), peer.version, peer.counted);
    let each: BTreeSet<String> = record.measured.peers.iter().map(told).collect();
    let lead = "The same mesh is handed to codes that one would pick instead; ours is the contact solve from the assembled matrix on, theirs";
    format!("\n{lead} count:\n\n{}", each.into_iter().map(|line| format!("* {line}\n")).collect::<String>())
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
    let skipped = record.measured.absent.iter().map(|(code, why)| format!("Skipped: {code}: {why}.\n\n"));
    let beside = beside(record).into_iter().map(|sentence| sentence + "\n\n");
    text + &skipped.chain(beside).collect::<String>()
}

fn precision() -> String {
    let text = format!(
        "\n## Error against seconds and work\n\nThe mesh does not know the answer: it is graded for a nominal half-width, and {LOADS} loads \
         move the contact edge across one of its elements. Finding the contact is part of the cost. All runs to the tolerance \
         {TOLERANCE:e}. The other codes solve on meshes and by methods of their own: scikit-fem by exact active sets, dolfinx by a penalty, \
         NGSolve ({}) by an augmented Lagrangian. No mesh of theirs knows where the contact ends. scikit-fem and dolfinx read p₀ by a parabola over a quarter of the \
         half-width, which leaves {} of Hertz's ellipse even where the pressure is exact; NGSolve's is read with a term in x⁴, so that its \
         error is free of that.\n\n",
        cells(Series::Ngsolve),
        significant(PARABOLA, 1)
    );
    let caption = "Truncated Hertz: worst error of peak and second-moment width against seconds and counted operations";
    text + &picture("work-precision.svg", caption)
}

/// What grows with the mesh, by its name.
type Growing = (&'static str, fn(&Growth) -> f64);

/// Rows of the table of the growth below those of the stages.
const WHOLE: [Growing; 6] = [
    ("contact solve [ms]", |one| 1e3 * one.contact.median),
    ("plain solve [ms]", |one| 1e3 * one.plain.median),
    ("from nothing [ms]", |one| 1e3 * one.seconds(&Stage::ALL)),
    ("operations of the factorisation [million]", |one| 1e-6 * one.counts.factor_operations),
    ("sparse factor [MB]", |one| 8e-6 * one.counts.factor_entries as f64),
    ("whole process, at most [MB]", |one| {
        one.memory_ratio.map_or(f64::NAN, |ratio| 8e-6 * ratio * one.counts.factor_entries as f64)
    }),
];

/// How seconds, memory and the counted operations grow, which seconds follow in the end.
fn growth(record: &Record) -> String {
    let growth = &record.measured.growth;
    let row = |name: String, of: &dyn Fn(&Growth) -> f64| {
        let cells = growth.iter().map(|one| significant(of(one), 3));
        std::iter::once(name).chain(cells).chain([format!("{:.2}", exponent(growth, of))]).collect()
    };
    let stages = Stage::ALL.map(|stage| row(format!("{} [ms]", stage.name()), &|one| 1e3 * one.seconds(&[stage])));
    let rows: Vec<Vec<String>> = stages.into_iter().chain(WHOLE.map(|(name, of)| row(name.into(), &of))).collect();
    let sizes = growth.iter().map(|one| format!("{} dofs, {} iterations", one.counts.dofs, one.counts.iterations));
    let head: Vec<String> = std::iter::once("".into()).chain(sizes).chain(["exponent".into()]).collect();
    format!(
        "## Growth\n\nThe cylinder by node + kinematic load, one thread. A boundary method needs far fewer unknowns for Hertz itself: this is \
         the price of a method that takes any body.\n\n{}\nNested dissection of a plane mesh of n nodes leads to n^1.5 operations (George \
         1973): the time of a direct method grows slower only as long as something else takes most of it.\n\n",
        markdown::table(&head, &rows),
    )
}

/// The cheapest run of each code that keeps the error in both quantities under every load.
pub fn conclusion(record: &Record) -> String {
    let best = |points: Vec<&Point>| cheapest(points, |point| point.seconds, Point::worst, COMPARED).cloned();
    let own = best(sound(&record.points)).map(|Point { series, seconds, formulation, mesh, dofs, .. }| {
        let formulation = formulation.map_or_else(String::new, |formulation| formulation.to_string());
        let (told, nodes) = (milliseconds(seconds), series.order().map_or(0, Order::nodes_per_cell));
        format!("ours {told} ({formulation}, {nodes}-node cells, {mesh} per half-width, {dofs} dofs)")
    });
    let theirs = Series::CODES.map(|code| match best(record.of(code).collect()) {
        Some(best) => format!("{} {} ({} dofs)", code.name(), milliseconds(best.seconds), best.dofs),
        None if record.of(code).next().is_some() => format!("{} on none of its meshes", code.name()),
        None => format!("{} {NOT_ASKED}", code.name()),
    });
    let own = own.unwrap_or("ours on no mesh".into());
    format!("Within {} in p₀ and a under each of the {LOADS} loads: {own}; {}.", percent(), theirs.join("; "))
}

/// What our own solve took beside each of the other codes.
pub fn beside(record: &Record) -> Vec<String> {
    let own = ours(&record.points).map_or(f64::NAN, |own| own.seconds);
    let told = |Beside { code, version, seconds, machine }: &Beside| {
        format!(
            "Beside {} {version} ({}, {} threads, {}) our solve to {} took {} against {} in the chart: its seconds compare with ours by the \
             ratio to these alone.",
            code.name(),
            machine.processor,
            machine.threads,
            machine.system,
            percent(),
            milliseconds(seconds.median),
            milliseconds(own)
        )
    };
    record.measured.beside.iter().map(told).collect()
}

/// The error to which codes are compared.
pub fn percent() -> String {
    format!("{} %", 100.0 * COMPARED)
}

/// Seconds in milliseconds.
pub fn milliseconds(seconds: f64) -> String {
    format!("{} ms", significant(1e3 * seconds, 2))
}
