//! A row a run, and what the rows come to.

use std::fmt::Write;

use crate::error::Error;
use crate::markdown;
use crate::study::Found;
use crate::study::drawn::picture;
use crate::study::scoreboard::board::Board;
use crate::study::scoreboard::picture::{FILE, FLOOR};
use crate::study::scoreboard::run::{Ended, Numbers, ROUND_OFF, Row};
use crate::study::scoreboard::setting::{Code, Setting};

const HEAD: [&str; 8] =
    ["code", "contact", "p₀ − truth", "a − truth", "truth ±", "iterations", "seconds ÷ Cholesky", "not met"];

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let board = Board::load()?;
    let mut text = format!(
        "Each case is exported by `contact-vv export`, and solved on the exported mesh by the scripts that are exported with it. What each code \
         writes is judged by what `contact-vv judge` judges by: errors of the peak pressure p₀ and of the half-width a are relative to the \
         truth, which may itself be off by the larger of its bars in the fifth column. *First choice* is the contact that a code documents; \
         scikit-fem and dolfinx have none of their own, and are given what one writes first: springs. The best setting that was tried is set \
         in bold: the one with the least that is not met, then with the smaller error of p₀ and a together. Seconds are those of the solution by the script's own account, CalculiX's of the whole \
         process, over one sparse Cholesky solve of the exported mesh just before, of one machine ({}), and are recorded; errors and \
         verdicts are computed from the frozen files with every report. CalculiX makes bricks of plane cells, so that it solves for more unknowns. \
         In the plane the contact of SfePy, of Kratos and of Akantu has edges with 2 nodes alone: they are given each 8-node cell cut into four with 4 nodes. \
         Akantu finds pairs, gaps and the forces on the first side; the forces on the other side, the tangent and a turn of the scene are ours, since its \
         contact in the plane has faults there. FElupe's contact knows rigid planes only: beside a second body each node has a plane of its own, which \
         moves with the node that faces it, and these pairs are ours.\n\n",
        board.processor
    );
    text += &summary(findings);
    text += &picture(
        FILE,
        &format!(
            "Scoreboard: larger error of p₀ and a over seconds; hollow: runs that failed; errors below {} are drawn there",
            markdown::bound(FLOOR)
        ),
    );
    for found in findings {
        let numbers = found.numbers;
        let rows: Vec<Vec<String>> = numbers.rows.iter().map(|row| line(numbers, row)).collect();
        let _ =
            write!(text, "\n## {}, {} degrees of freedom, truth: {}\n\n", numbers.case, numbers.dofs[0], numbers.kind);
        text += &markdown::table(&HEAD.map(String::from), &rows);
    }
    Ok(text)
}

/// Code by code: how many cases are met, by the first choice and by the best setting.
fn summary(findings: &[Found<Numbers>]) -> String {
    let head = [
        "code",
        "all met, first choice",
        "all met, best setting",
        "worst error, first choice",
        "worst error, best setting",
        "runs that failed",
    ];
    let row = |code: Code| {
        let first = |numbers: &'_ Numbers| {
            numbers.rows.iter().find(|row| row.setting().code == code && row.setting().first).cloned()
        };
        let best = |numbers: &'_ Numbers| numbers.best(|setting| setting.code == code).cloned();
        let [first, best] = [&first as &dyn Fn(&Numbers) -> Option<Row>, &best]
            .map(|of| findings.iter().map(|found| of(found.numbers)).collect::<Vec<_>>());
        let met = |rows: &[Option<Row>]| {
            let met = rows
                .iter()
                .flatten()
                .filter(|row| matches!(&row.ended, Ended::Judged { failed, .. } if failed.is_empty()))
                .count();
            format!("{met} of {}", rows.len())
        };
        let worst = |rows: &[Option<Row>]| {
            let errors = rows.iter().flatten().map(Row::error).filter(|error| error.is_finite());
            errors.reduce(f64::max).map_or("–".into(), markdown::error)
        };
        let runs = findings.iter().flat_map(|found| &found.numbers.rows).filter(|row| row.setting().code == code);
        let failed = runs.filter(|row| matches!(row.ended, Ended::Failed { .. })).count();
        vec![code.name().into(), met(&first), met(&best), worst(&first), worst(&best), failed.to_string()]
    };
    markdown::table(&head.map(String::from), &Code::ALL.map(row)) + "\n"
}

fn line(numbers: &Numbers, row: &Row) -> Vec<String> {
    let Setting { code, says, first, .. } = row.setting();
    let version = row.version.as_ref().map_or(String::new(), |version| format!(" {version}"));
    let best = numbers.best(|setting| setting.code == code).is_some_and(|best| best.setting == row.setting);
    let says = if best { format!("**{says}**") } else { says.to_owned() };
    let says = if first { format!("first choice: {says}") } else { says };
    let start = [format!("{}{version}", code.name()), says];
    let seconds = markdown::significant(row.seconds, 2);
    let rest = match &row.ended {
        Ended::Failed { why, .. } => ["failed", "failed", "–", "–", &seconds, why].map(String::from),
        Ended::Judged { iterations, scores: [peak, width], failed, .. } => {
            let percent = |x: f64| match x.abs() < ROUND_OFF {
                true => markdown::error(x.abs()),
                false => format!("{} %", markdown::signed(100.0 * x, 2)),
            };
            let bar = markdown::error(crate::measure::larger(peak.bar, width.bar));
            let failed = if failed.is_empty() { "–".into() } else { failed.join("; ") };
            [percent(peak.error), percent(width.error), bar, iterations.to_string(), seconds, failed]
        }
    };
    start.into_iter().chain(rest).collect()
}
