//! What the page shows of other codes: versions, both senses, the price of the penalty.

use std::fmt::Write;

use crate::case::Verdict;
use crate::error::Error;
use crate::markdown;
use crate::oracle::cross_code::frozen::Frozen;
use crate::oracle::cross_code::{Code, Method, SET_UP};
use crate::study::cross_code::Numbers;
use crate::study::cross_code::discrete::Part;
use crate::study::cross_code::judge::assembled_alike;
use crate::study::cross_code::physical::{Compared, Finder, Found as Answer, Measured};
use crate::study::drawn::picture;
use crate::study::{Found, cross_code::discrete};

/// Both senses, with the versions the frozen answers came from.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let physical: Vec<&Compared> = findings.iter().filter_map(|found| found.numbers.physical()).collect();
    let mut text = String::from("## Against other codes\n\n");
    for code in Code::ALL {
        text += &frozen(code, &Frozen::read(code)?);
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
         *Beyond* says that the uncertainties do not cover a difference; for the cylinder the closed form differs by the model.\n\n{}\n\
         What the penalty costs, apart from the mesh (scikit-fem with and without it, both extrapolated):\n\n{}\n",
        code_check(findings),
        benchmark(&physical),
        penalty(&physical),
    );
    text += &picture("pressure-cross-code.svg", "Contact pressure of the same physical problem in three codes");
    text += &picture("difference-cross-code.svg", "Difference of each code to the closed form");
    Ok(text)
}

fn frozen(code: Code, frozen: &Frozen) -> String {
    let versions: Vec<String> = frozen.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let hash: String = frozen.scripts.chars().take(12).collect();
    format!("* {code}: frozen results under `oracles/frozen`, from {}; scripts {hash}….\n", versions.join(", "))
}

impl Numbers {
    fn discrete(&self) -> Option<&discrete::Compared> {
        match self {
            Self::Discrete(compared) => Some(compared),
            Self::Physical(_) => None,
        }
    }

    /// The same physical problem, where it is that.
    pub(super) fn physical(&self) -> Option<&Compared> {
        match self {
            Self::Physical(compared) => Some(compared),
            Self::Discrete(_) => None,
        }
    }
}

/// One row per problem and code: the verdict on stiffness, loads and contact, and the tolerance they meet.
fn code_check(findings: &[Found<Numbers>]) -> String {
    let head = ["problem, code", "stiffness", "loads", "contact"].map(String::from);
    let rows = findings.iter().filter_map(|found| {
        let compared = found.numbers.discrete()?;
        Some([found.name.to_string()].into_iter().chain(Part::ALL.map(|part| verdict(compared, part))).collect())
    });
    markdown::table(&head, &rows.collect::<Vec<_>>())
}

fn verdict(compared: &discrete::Compared, part: Part) -> String {
    let own = compared.differences.iter().filter(|difference| difference.part == part);
    let judged: Vec<_> = own.map(|difference| assembled_alike(compared.code, difference)).collect();
    let passed = !judged.is_empty() && judged.iter().all(|one| one.verdict == Verdict::Pass);
    let tolerance = judged.iter().map(|one| one.check.tolerance).fold(0.0, f64::max);
    format!("{} to {tolerance:.0e}", if passed { "✓" } else { "✗" })
}

/// Peak and width of every code beside the closed form.
fn benchmark(physical: &[&Compared]) -> String {
    let head = [
        "case",
        "quantity",
        "closed form",
        "code",
        "found ± its own uncertainty",
        "ours − theirs",
        "its difference to the closed form",
    ];
    let rows: Vec<Vec<String>> = physical.iter().flat_map(|compared| quoted(compared)).collect();
    markdown::table(&head.map(String::from), &rows)
}

fn quoted(compared: &Compared) -> Vec<Vec<String>> {
    let (unit, factor) =
        if compared.scene.is_arc() { ("2 √(∫pθ²/∫p) [°]", 180.0 / std::f64::consts::PI) } else { ("a [mm]", 1.0) };
    let exact = compared.closed_form.as_ref();
    let peaks = rows(compared, "peak [MPa]", 1.0, exact.map(|exact| exact.peak), |found| found.peak);
    let widths = rows(compared, unit, factor, exact.map(|exact| exact.half_width), |found| found.half_width);
    peaks.into_iter().chain(widths).collect()
}

fn rows(
    compared: &Compared,
    quantity: &str,
    factor: f64,
    exact: Option<f64>,
    of: fn(&Answer) -> Measured,
) -> Vec<Vec<String>> {
    let row = |found: &Answer| {
        let Measured { value, uncertainty, .. } = of(found);
        let from_ours = match found.by {
            Finder::Ours => String::new(),
            Finder::Theirs(..) => difference(of(&compared.ours), of(found)),
        };
        let exactly = |value| Measured { value, uncertainty: 0.0, limit: value };
        vec![
            compared.scene.name().into(),
            quantity.into(),
            exact.map_or("none".into(), |exact| format!("{:.5}", factor * exact)),
            format!("{} ({} dofs)", found.by, found.dofs),
            format!("{:.5} ± {:.3} %", factor * value, 100.0 * uncertainty / value.abs()),
            from_ours,
            exact.map_or(String::new(), |exact| difference(of(found), exactly(exact))),
        ]
    };
    compared.all().map(row).collect()
}

/// A relative difference in per cent, and whether the uncertainties cover it.
fn difference(a: Measured, b: Measured) -> String {
    let covered = (a.value - b.value).abs() <= a.uncertainty.hypot(b.uncertainty);
    let word = if covered { "within" } else { "**beyond**" };
    format!("{:+.3} %, {word} the uncertainty", 100.0 * (a.value - b.value) / b.value.abs())
}

/// What the penalty costs, apart from the mesh: both series extrapolated to no mesh size.
fn penalty(physical: &[&Compared]) -> String {
    let head =
        ["case", "quantity", "by penalty, extrapolated", "without penalty, extrapolated", "penalty error"];
    let mut rows = Vec::new();
    for compared in physical {
        for other in &compared.others {
            let by = |method| other.found.iter().find(|found| found.by == Finder::Theirs(other.code, method));
            if let (Some(soft), Some(exact)) = (by(Method::Penalty), by(Method::ActiveSet)) {
                rows.push(cost(compared, "peak", soft.peak.limit, exact.peak.limit));
                rows.push(cost(compared, "second-moment width", soft.half_width.limit, exact.half_width.limit));
            }
        }
    }
    markdown::table(&head.map(String::from), &rows)
}

fn cost(compared: &Compared, quantity: &str, soft: f64, exact: f64) -> Vec<String> {
    let error = format!("{:+.4} %", 100.0 * (soft / exact - 1.0));
    vec![compared.scene.name().into(), quantity.into(), format!("{soft:.5}"), format!("{exact:.5}"), error]
}
