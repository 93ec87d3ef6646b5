//! What the page shows of other codes: versions, both senses, the price of the penalty.

use std::fmt::Write;

use crate::case::Verdict;
use crate::error::Error;
use crate::markdown;
use crate::oracle::cross_code::frozen::Frozen;
use crate::oracle::cross_code::{Code, SET_UP};
use crate::study::cross_code::Numbers;
use crate::study::cross_code::benchmark::Scene;
use crate::study::cross_code::discrete::Part;
use crate::study::cross_code::judge::assembled_alike;
use crate::study::cross_code::physical::{Compared, Found as Answer, Measured};
use crate::study::cross_code::validation::{Number, against};
use crate::study::drawn::picture;
use crate::study::{Found, cross_code::discrete};
use crate::uncertainty::COVERAGE;

/// Both senses, with the versions the frozen answers came from.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let physical: Vec<&Compared> = findings.iter().filter_map(|found| found.numbers.physical()).collect();
    let mut text = String::new();
    for code in Code::ALL {
        text += &frozen(code, &Frozen::read(code)?);
    }
    let _ = write!(
        text,
        "\nTo ask the codes themselves, {SET_UP} and test with the feature `python`.\n\n\
         ## The same discrete problem (code check)\n\n\
         Each code takes our mesh and assembles stiffness, loads and edge functions for itself; supports and penalty line elements \
         (two Gauss points an edge) are put together from these in Python, condensed nowhere.\n\n{}\n\
         ## The same physical problem: assembly twin\n\n\
         Meshes of curved 6-node triangles, loads, contact and measures are Python's own and shared by both codes; stiffness, edge \
         functions and linear solver are each code's: one oracle with two assemblers, held to each other on one mesh and counted once, as \
         scikit-fem. Bodies in contact have non-matching meshes. ± is the standard uncertainty from \
         three nested meshes; closed forms of *another model*, the half-space or the infinite plate, differ by that.\n\n{}\n\
         Comparison errors after ASME V&V 20: |E| shall be at most {COVERAGE} u_val, u_val² the sum of the squares of all sources. Beside the \
         meshes these are known differences that are not corrected for: what the penalty (springs, and two pressures an edge instead of one a \
         corner) changes in the code that also solves without it, on the same meshes and in the limit; and what their fit of the peak, a \
         parabola over edge means, makes of our own profile. All over theirs.\n\n{}\n\
         What the penalty costs, apart from the mesh (scikit-fem with and without it, in the limit):\n\n{}\n",
        code_check(findings),
        benchmark(&physical),
        comparisons(&physical),
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
    let head = ["case", "quantity", "closed form", "code", "found ± u", "difference to the closed form"];
    let rows: Vec<Vec<String>> = each_number(physical)
        .flat_map(|(compared, number)| compared.all().map(move |found| quoted(compared, number, found)))
        .collect();
    markdown::table(&head.map(String::from), &rows)
}

/// Each number of each scene.
fn each_number<'a>(physical: &'a [&'a Compared]) -> impl Iterator<Item = (&'a Compared, Number)> {
    physical.iter().flat_map(|compared| Number::ALL.map(|number| (*compared, number)))
}

/// What a number is shown as.
pub fn shown(scene: Scene, number: Number) -> &'static str {
    match number {
        Number::Peak => "peak [MPa]",
        Number::Width => number.unit(scene),
    }
}

/// A share in per cent with two significant digits.
pub fn percent(share: f64) -> String {
    format!("{} %", markdown::significant(100.0 * share, 2))
}

fn quoted(compared: &Compared, number: Number, found: &Answer) -> Vec<String> {
    let quantity = shown(compared.scene, number);
    let Measured { value, uncertainty, .. } = number.of(compared.scene, found);
    let exact = compared.closed_form.as_ref().map(|exact| number.of_closed_form(compared.scene, exact));
    vec![
        compared.scene.name().into(),
        quantity.into(),
        exact.map_or("none".into(), |exact| format!("{:.5}", exact)),
        format!("{} ({} dofs)", found.by, found.dofs),
        format!("{:.5} ± {}", value, percent(uncertainty / value.abs())),
        exact.map_or(String::new(), |exact| {
            let kind = if compared.scene.closed_form_is_exact() { "" } else { ", another model" };
            format!("{} %{kind}", markdown::signed(100.0 * (value / exact - 1.0), 2))
        }),
    ]
}

/// Comparison errors, what their uncertainties are made of, and whether these cover them.
fn comparisons(physical: &[&Compared]) -> String {
    let head = [
        "case",
        "quantity",
        "code",
        "E = ours − theirs",
        "u, our mesh",
        "u, their mesh",
        "u, penalty",
        "u, measure",
        "u_val",
        "|E| / u_val",
        "",
    ];
    let rows: Vec<Vec<String>> = each_number(physical)
        .flat_map(|(compared, number)| compared.counted().map(move |found| comparison(compared, number, found)))
        .collect();
    markdown::table(&head.map(String::from), &rows)
}

fn comparison(compared: &Compared, number: Number, found: &Answer) -> Vec<String> {
    let (comparison, sources) = against(compared, found, number);
    let scale = number.of(compared.scene, found).value.abs();
    let source = |u: f64| if u.abs() <= 0.0 { "–".into() } else { percent(u / scale) };
    let covered = comparison.ratio() <= COVERAGE;
    vec![
        compared.scene.name().into(),
        shown(compared.scene, number).into(),
        found.by.to_string(),
        format!("{} %", markdown::signed(100.0 * comparison.error / scale, 2)),
        source(sources.ours),
        source(sources.theirs),
        source(sources.penalty),
        source(sources.measure),
        percent(comparison.uncertainty / scale),
        format!("{:.2}", comparison.ratio()),
        if covered { "✓" } else { "✗" }.into(),
    ]
}

/// What the penalty costs, apart from the mesh: both series extrapolated to no mesh size.
fn penalty(physical: &[&Compared]) -> String {
    let head = ["case", "quantity", "by penalty, limit", "without penalty, limit", "penalty error"];
    let rows = each_number(physical).filter_map(|(compared, number)| {
        let quantity = shown(compared.scene, number);
        let [soft, exact] = compared.both_methods()?.map(|found| number.of(compared.scene, found).limit);
        Some(vec![
            compared.scene.name().into(),
            quantity.into(),
            format!("{:.5}", soft),
            format!("{:.5}", exact),
            format!("{} %", markdown::signed(100.0 * (soft / exact - 1.0), 2)),
        ])
    });
    markdown::table(&head.map(String::from), &rows.collect::<Vec<_>>())
}
