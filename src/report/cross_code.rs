//! The section on other codes, and the record of planted faults.

use std::fmt::Write;

use crate::case::{Judged, Verdict};
use crate::error::Error;
use crate::markdown;
use crate::oracle::cross_code::frozen::Frozen;
use crate::oracle::cross_code::{Code, SET_UP};
use crate::study::cross_code::{DISCRETE, PHYSICAL, shown};
use crate::study::unsorted::Finding;

/// Both senses, with the versions the frozen answers came from.
pub fn section(findings: &[Finding]) -> Result<String, Error> {
    let mut text = String::from("## Against other codes\n\n");
    for code in Code::ALL {
        let frozen = Frozen::read(code)?;
        let versions: Vec<String> = frozen.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
        let _ = writeln!(
            text,
            "* {code}: frozen results under `oracles/frozen`, from {}; scripts {}….",
            versions.join(", "),
            &frozen.scripts.chars().take(12).collect::<String>()
        );
    }
    let _ = write!(
        text,
        "\nTo ask the codes themselves, {SET_UP} and test with the feature `python`.\n\n\
         ### The same discrete problem (code check)\n\n\
         Each code takes our mesh and assembles stiffness, loads and edge functions for itself; supports and penalty line elements \
         (two Gauss points an edge) are put together from these in Python, condensed nowhere.\n\n{}\n\
         ### The same physical problem (benchmark)\n\n\
         Meshes of curved 6-node triangles, loads, contact and measures are Python's own and shared by both codes; stiffness, edge \
         functions and linear solver are each code's. Bodies in contact have non-matching meshes. Uncertainties by Richardson from \
         three nested meshes. \
         *Beyond* says that the uncertainties do not cover a difference; for the cylinder the closed form differs by the model.\n\n{}\n",
        discrete(findings),
        benchmark(findings, PHYSICAL, &shown::HEAD),
    );
    let _ = write!(
        text,
        "What the penalty costs, apart from the mesh (scikit-fem with and without it, both extrapolated):\n\n{}\n",
        benchmark(findings, shown::PENALTY, &shown::PENALTY_HEAD),
    );
    Ok(text)
}

/// One row per problem and code: the verdict on stiffness, loads and contact, and the tolerance they meet.
fn discrete(findings: &[Finding]) -> String {
    let groups = [("stiffness", "the same stiffness"), ("loads", "the same loads"), ("contact", "the same contact")];
    let head = ["problem, code".to_string()].into_iter().chain(groups.map(|(name, _)| name.to_string()));
    let rows = findings.iter().filter(|finding| finding.case == DISCRETE).map(|finding| {
        let cell = |(_, words): (&str, &str)| {
            let checks: Vec<&Judged> =
                finding.checks.iter().filter(|check| check.requirement().contains(words)).collect();
            let tolerance = checks.iter().map(|check| check.check.tolerance).fold(0.0, f64::max);
            let passed = !checks.is_empty() && checks.iter().all(|check| check.verdict == Verdict::Pass);
            format!("{} to {tolerance:.0e}", if passed { "✓" } else { "✗" })
        };
        std::iter::once(finding.name.clone()).chain(groups.map(cell)).collect()
    });
    markdown::table(&head.collect::<Vec<_>>(), &rows.collect::<Vec<_>>())
}

/// The rows of one table over all scenes.
fn benchmark(findings: &[Finding], title: &str, head: &[&str]) -> String {
    let tables = findings.iter().filter(|finding| finding.case == PHYSICAL).flat_map(|finding| &finding.tables);
    let rows: Vec<Vec<String>> =
        tables.filter(|table| table.title == title).flat_map(|table| table.rows.clone()).collect();
    markdown::table(&head.iter().map(|cell| cell.to_string()).collect::<Vec<_>>(), &rows)
}
