//! The paper's statements, the verdicts, what was never compared, and the index.

use crate::case::Verdict;
use crate::markdown;
use crate::report::grouped::counted;
use crate::report::links::to_page as link;
use crate::report::matrix::{self, Column};
use crate::report::{case_page, checks_page, statements, study_page, told};
use crate::study::cases::page;
use crate::study::paper::NOT_COVERED;
use crate::study::paper::statement::Judgement;
use crate::study::{Finding, Room, Study, cases, paper};

/// Judgement and one measured clause.
pub fn statements(findings: &[Finding]) -> String {
    let judged = statements::judge(findings);
    let rows: Vec<Vec<String>> = judged
        .iter()
        .map(|one| {
            let judgement = format!("**{}**", one.judgement.brief());
            let judgement = if matches!(one.judgement, Judgement::Undecidable(_)) {
                link(&judgement, &study_page::file(paper::Numbers::NAME))
            } else {
                judgement
            };
            vec![one.text.into(), judgement, one.clause.clone()]
        })
        .collect();
    let words = counted(judged.iter().map(|one| one.judgement.word()));
    let words: Vec<String> = words.iter().map(|(word, count)| format!("{count} {word}")).collect();
    format!(
        "Of {} statements: {}. {}.\n\n{}",
        judged.len(),
        words.join(", "),
        link(
            "Measurements and conditions in full, misprints, decisions, sources",
            &study_page::file(paper::Numbers::NAME)
        ),
        markdown::table(&["statement", "judgement", "measured"].map(String::from), &rows)
    )
}

/// The matrix of the cases that all formulations solve, and the others in short.
pub fn verdicts(findings: &[Finding], recommended: Option<Column>) -> String {
    let first = recommended.map_or(String::new(), |(element, algorithm)| {
        format!(", first by what is recommended, {} + {}", element.name(), algorithm.name())
    });
    format!(
        "Iterations to convergence{first}; ✓ all checks of the run pass, ✗ some fail, ○ some could not be run, · reported only.\n\n{}\n{}",
        matrix::verdict_matrix(findings, recommended, named),
        matrix::other_cases(findings, named)
    )
}

/// Name of a case with the link to its page.
fn named(finding: &Finding) -> String {
    let name = finding.case.trim_end_matches(".toml");
    match finding.numbers::<cases::Numbers>() {
        Some(numbers) => link(name, &case_page::file(&page(&numbers.case))),
        None => name.into(),
    }
}

/// What could not be run, and what is out of scope.
pub fn never_compared(findings: &[Finding]) -> String {
    let absent = counted(findings.iter().flat_map(|finding| {
        finding.judged.iter().filter_map(move |one| match &one.verdict {
            Verdict::NotRun(why) => Some(format!("{} ({why})", link(&finding.case, &file(finding)))),
            Verdict::Pass | Verdict::Fail => None,
        })
    }));
    let told =
        |(what, count): &(String, usize)| if *count > 1 { format!("{what}, {count} checks") } else { what.clone() };
    let absent = match &absent[..] {
        [] => "Every check was run.".into(),
        some => format!("Checks that could not be run: {}.", some.iter().map(told).collect::<Vec<_>>().join("; ")),
    };
    format!("{absent}\n\nOut of scope: {}.\n", NOT_COVERED.join("; "))
}

/// The page of a finding.
fn file(finding: &Finding) -> String {
    match finding.numbers::<cases::Numbers>() {
        Some(numbers) => case_page::file(&page(&numbers.case)),
        None => study_page::file(finding.study),
    }
}

/// Every page of a study, with its sign and number of checks.
pub fn index(findings: &[Finding]) -> String {
    let one = |room: &Room| {
        let judged = study_page::of(room.name, findings).flat_map(|finding| &finding.judged);
        let [pass, fail, absent] = told::counts(judged);
        let sign = match (fail, absent) {
            (0, 0) => "✓",
            (0, _) => "○",
            _ => "✗",
        };
        format!("{sign} {} {}", link(room.about.title, &study_page::file(room.name)), pass + fail + absent)
    };
    let rooms: Vec<String> = study_page::asked(findings).map(one).collect();
    format!(
        "Studies, with their numbers of checks: {}.\n\nBesides: {}. The README says how to read them and how to make them again.\n",
        rooms.join(" · "),
        link("all checks", checks_page::FILE)
    )
}
