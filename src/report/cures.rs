//! Cures of what fails or is slow: options that are not the paper's.

use crate::markdown;
use crate::report::checks;
use crate::study::cures::{self, nested, reach, record};
use crate::study::unsorted::{Finding, Table};

/// The section.
pub fn section(findings: &[Finding]) -> String {
    let (starts, planes) = (record::stiffnesses(), record::PLANES.len());
    let [least, most] = [starts[0], starts[starts.len() - 1]];
    let (times, share) = (reach::TIMES, 100.0 / reach::TIMES);
    let mut text = format!(
        "## Cures\n\n\
         Options beside the paper's algorithms, off by default.\n\n\
         **Constant stiffness, accelerated.** With the rule `correction` its step is Douglas–Rachford splitting (Lions & Mercier \
         1979): converging whatever κ₀, but slowly away from the best one. Crossed secant (Ramière & Helfer 2015; \
         for Uzawa's iteration of contact Koliesnikova & Ramière, arXiv:2603.12205) and Anderson acceleration (Walker & Ni \
         2011) with the safeguard of Zhang, O'Donoghue & Boyd 2020, on truncated Hertz: initial stiffnesses in third decades \
         from {least:e} to {most:e}, on {planes} planes of candidate stretch and mesh. Where the plain share exceeds {share:.0} %, no share can be \
         {times} times as large: at the engineering tolerance the possible factor stands in brackets, and the \
         requirement is gated at the tight one. Step counts of long accelerated runs depend on round-off: these are \
         the recorded ones, held live within the drift that noise causes.\n\n",
    );
    let of = |case: &str, title: &str| {
        let all = findings.iter().filter(|f| f.case == case).flat_map(|f| &f.tables);
        all.filter(|table| table.title == title).flat_map(|table| table.rows.clone()).collect::<Vec<_>>()
    };
    text += &markdown::table(&reach::SHARES_HEAD.map(String::from), &of(cures::REACH, "shares"));
    text += &format!(
        "\n![Steps of constant stiffness, plain and accelerated](snapshots/charts/cures.svg)\n\
         *Steps of constant stiffness, plain and accelerated; runs that take more than {} stand hollow above the frame.*\n\n",
        record::STEPS
    );
    let planes = markdown::table(&reach::PLANES_HEAD.map(String::from), &of(cures::REACH, "planes"));
    text += &markdown::folded("Lowest and highest κ₀ that converge, on each plane", &planes, false);
    for table in tables(findings, cures::RULES) {
        text += &(crate::study::unsorted::titled(table) + "\n");
    }
    text += "The rule `literal` keeps stiffnesses beside its forces: it is no fixed point of them. \
             The rule `secant` drives the spring of a closed gap to its ceiling.\n\n\
             **Kinematic load, nested start.** Every point starts as the nearest one of a mesh half as fine has ended, down to \
             one element. Steps with every candidate closed → steps from the nested start (+ all steps on \
             coarser meshes).\n\n";
    let rows: Vec<Vec<String>> = tables(findings, cures::NESTED).flat_map(|table| table.rows.clone()).collect();
    text += &markdown::folded("Steps by scene, element and mesh", &markdown::table(&nested::head(), &rows), false);
    let own = |finding: &&Finding| [cures::REACH, cures::RULES, cures::NESTED].contains(&finding.case.as_str());
    text + &checks::table(&findings.iter().filter(own).collect::<Vec<_>>())
}

fn tables<'a>(findings: &'a [Finding], case: &'a str) -> impl Iterator<Item = &'a Table> {
    findings.iter().filter(move |finding| finding.case == case).flat_map(|finding| &finding.tables)
}
