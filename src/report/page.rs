//! The page: a loop over the studies.

use crate::case::Verdict;
use crate::error::Error;
use crate::figure;
use crate::markdown;
use crate::oracle::ReferenceKind;
use crate::report::{checks, decisions, matrix, record, statements};
use crate::solve::Formulation;
use crate::study::sheets::sheet;
use crate::study::{Finding, Numbers, Room};

/// The page and its charts.
#[derive(Clone, Debug)]
pub struct Page {
    /// Text of `VALIDATION.md`.
    pub markdown: String,
    /// File names and SVG texts of the charts.
    pub charts: Vec<(String, String)>,
    /// File names and texts of the benchmark sheets.
    pub sheets: Vec<(String, String)>,
    /// Paths and texts of the record.
    pub record: Vec<(String, String)>,
}

/// Makes the page from the findings of the whole suite.
pub fn compose(findings: &[Finding]) -> Result<Page, Error> {
    let mut text = [head(findings), paper(findings), verdicts(findings)].concat();
    let mut charts = [
        figure::contact_problem()?.files("contact-problem.svg"),
        figure::contact_elements()?.files("contact-elements.svg"),
    ]
    .concat();
    for room in Room::ALL {
        text += &room.section(findings)?;
        text += &judged(*room, findings);
        charts.extend(room.pictures(findings)?);
    }
    text += &silent();
    text += &closing();
    let sheets = findings.iter().filter_map(|finding| match &finding.numbers {
        Numbers::Sheets(numbers) => Some(sheet(numbers)),
        _ => None,
    });
    Ok(Page { markdown: text, charts, sheets: sheets.collect(), record: record::files(findings)? })
}

/// The checks of a room, one table a case: none can be forgotten.
fn judged(room: Room, findings: &[Finding]) -> String {
    let own: Vec<&Finding> = findings.iter().filter(|finding| finding.room == room).collect();
    let table = |members: &[&Finding]| {
        let named: Vec<checks::Named> = members.iter().map(|f| (f.name.as_str(), &f.judged[..])).collect();
        let table = checks::of(&named);
        if table.is_empty() { table } else { format!("**{}**\n\n{table}\n", members[0].case) }
    };
    own.chunk_by(|a, b| a.case == b.case).map(table).collect()
}

fn head(findings: &[Finding]) -> String {
    let [pass, fail, not_run] = matrix::counts(findings);
    let runs = matrix::runs(findings).count();
    format!(
        "# Validation report\n\n\
         Three contact elements × three iterations for frictionless elastic contact in 2D (Égert 1999), held against closed forms and other codes.\n\
         **{}**\n\n\
         {runs} runs, {} checks: {pass} passed, {fail} failed, {not_run} not run. Generated; do not edit.\n\n\
         *Verification* holds the code against closed forms and orders of accuracy (kind *analytic*); *benchmarking* \
         holds it against other codes (*cross-code*); *self-consistency* asks it the same in another way; *validation* \
         compares with measurement.\n\n",
        experiments(findings),
        pass + fail + not_run
    )
}

/// How many comparisons with measurements were judged, and of what kind.
fn experiments(findings: &[Finding]) -> String {
    let judged = |room: Room| {
        findings.iter().any(|finding| finding.room == room && !matches!(finding.verdict(), Verdict::NotRun(_)))
    };
    let shape = if judged(Room::Photoelastic) {
        "One shape-only comparison with a photograph"
    } else {
        "No photograph compared"
    };
    let judgements =
        findings.iter().filter(|finding| finding.room == Room::Digitised).flat_map(|finding| &finding.judged);
    let measured = judgements.filter(|judged| judged.reference.kind == ReferenceKind::Measured);
    let calibrated = measured.filter(|judged| !matches!(judged.verdict, Verdict::NotRun(_))).count();
    match calibrated {
        0 => format!("{shape}; no calibrated experiment yet."),
        n => format!("{shape}; calibrated curves compared: {n}."),
    }
}

fn paper(findings: &[Finding]) -> String {
    let rows: Vec<Vec<String>> = statements::judge(findings)
        .into_iter()
        .map(|s| vec![s.text.into(), s.measured, format!("**{}**", s.judgement)])
        .collect();
    let own: Vec<String> = Formulation::nine().iter().filter(|f| f.is_in_the_paper()).map(Formulation::name).collect();
    format!(
        "## The paper's statements\n\n{}\nThe paper itself shows {} of the nine formulations: {}. The others are ours.\n\n",
        markdown::table(&["statement", "measured", "judgement"].map(String::from), &rows),
        own.len(),
        own.join(", ")
    )
}

fn verdicts(findings: &[Finding]) -> String {
    format!(
        "## Verdicts\n\nIterations to convergence; ✓ all checks of the run pass, ✗ some fail, · reported only. Several numbers: several load increments. In tables of checks, value ± u: u is the standard uncertainty that the check carries for that value, half of a bound that covers about 95 %, from refinement (`contact-vv verdicts` prints it for both).\n\n{}\n{}\n{}\n{}\n",
        matrix::verdict_matrix(findings),
        matrix::by_kind(findings),
        matrix::study_table(findings),
        checks::universal(findings.iter().flat_map(|finding| &finding.judged))
    )
}

fn silent() -> String {
    format!(
        "## Where the source is silent\n\nThe figures of the paper are not at hand: none of its dimensions, loads or plotted values is known.\n\n{}\n### Misprints and gaps\n\n{}\n",
        decisions::open_points(),
        decisions::misprints()
    )
}

fn closing() -> String {
    let list = |items: &[&str]| items.iter().map(|item| format!("* {item}\n")).collect::<String>();
    format!(
        "## Deliberately not covered\n\n{}\n## References\n\n{}",
        list(&decisions::NOT_COVERED),
        list(&decisions::REFERENCES)
    )
}
