//! What the page shows of other codes: their versions, and what they make of our mesh.

use crate::case::Verdict;
use crate::error::Error;
use crate::figure::Drawing;
use crate::markdown;
use crate::oracle::cross_code::frozen::Frozen;
use crate::oracle::cross_code::{Code, SET_UP};
use crate::study::Found;
use crate::study::cross_code::discrete::{Compared, Part};
use crate::study::cross_code::judge::assembled_alike;

/// The verdicts, with the versions the frozen answers came from.
pub fn section(findings: &[Found<Compared>]) -> Result<String, Error> {
    let mut text = String::new();
    for code in Code::ALL {
        text += &frozen(code, &Frozen::read(code)?);
    }
    Ok(format!(
        "{text}\nTo ask the codes themselves, {SET_UP} and test with the feature `python`.\n\n\
         Each code takes our mesh and assembles stiffness, loads and edge functions for itself; supports and penalty line elements \
         (two Gauss points an edge) are put together from these in Python, condensed nowhere.\n\n{}\n",
        code_check(findings)
    ))
}

/// None: the verdicts say all.
pub fn pictures(_: &[Found<Compared>]) -> Result<Vec<(String, Drawing)>, Error> {
    Ok(Vec::new())
}

fn frozen(code: Code, frozen: &Frozen) -> String {
    let versions: Vec<String> = frozen.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let hash: String = frozen.scripts.chars().take(12).collect();
    format!("* {code}: frozen results under `oracles/frozen`, from {}; scripts {hash}….\n", versions.join(", "))
}

/// One row per problem and code: the verdict on stiffness, loads and contact, and the tolerance they meet.
fn code_check(findings: &[Found<Compared>]) -> String {
    let head = ["problem, code", "stiffness", "loads", "contact"].map(String::from);
    let row = |found: &Found<Compared>| {
        let parts = Part::ALL.map(|part| verdict(found.numbers, part));
        [found.name.to_string()].into_iter().chain(parts).collect()
    };
    markdown::table(&head, &findings.iter().map(row).collect::<Vec<_>>())
}

fn verdict(compared: &Compared, part: Part) -> String {
    let own = compared.differences.iter().filter(|difference| difference.part == part);
    let judged: Vec<_> = own.map(|difference| assembled_alike(compared.code, difference)).collect();
    let passed = !judged.is_empty() && judged.iter().all(|one| one.verdict == Verdict::Pass);
    let tolerance = judged.iter().map(|one| one.check.tolerance).fold(0.0, f64::max);
    format!("{} to {tolerance:.0e}", if passed { "✓" } else { "✗" })
}
