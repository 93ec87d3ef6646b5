//! The page of a study: what it asked, its numbers and charts, all of its checks, and what it cannot tell.

use crate::case::{Judged, Verdict};
use crate::error::Error;
use crate::report::{checks, links, statements, told};
use crate::study::grouped::counted;
use crate::study::{Finding, Room, Study, atlas, cases, paper};

/// Name of the file of a study of this name.
pub fn file(study: &str) -> String {
    format!("{}.md", study.replace('_', "-"))
}

/// The page.
pub fn page(room: &Room, findings: &[Finding]) -> Result<String, Error> {
    let Room { name, about, .. } = *room;
    let own: Vec<&Judged> = of(name, findings).flat_map(|finding| &finding.judged).collect();
    let checks = match name {
        cases::Numbers::NAME => "The page of each case has its checks.\n\n".into(),
        _ if own.is_empty() => "None: the tests hold what is recorded against what the code finds now.\n\n".into(),
        _ => tables(name, findings),
    };
    // What the paper says is judged by the findings of all studies, of which its own sees only its part.
    let first = match name {
        paper::Numbers::NAME => statements::section(findings),
        atlas::Numbers::NAME => statements::two_stops() + "\n",
        _ => String::new(),
    };
    let body = format!("{first}{}\n## Checks\n\n{checks}{}", (room.section)(findings)?, limits(about.limits, &own));
    Ok(links::page(about.title, about.asked, &told::once(own), &body))
}

/// Findings of a study.
pub fn of<'a>(study: &str, findings: &'a [Finding]) -> impl Iterator<Item = &'a Finding> {
    findings.iter().filter(move |finding| finding.study == study)
}

/// Studies of which something was found, in their order.
pub fn asked(findings: &[Finding]) -> impl Iterator<Item = &'static Room> {
    Room::ALL.iter().filter(|room| of(room.name, findings).next().is_some())
}

/// All checks of a study, one part a case: none can be forgotten.
pub fn tables(study: &str, findings: &[Finding]) -> String {
    let own: Vec<&Finding> = of(study, findings).collect();
    let of_every_run = |members: &[&Finding]| checks::of_every_run(members.iter().flat_map(|one| &one.judged), false);
    checks::by_case(&own, |own, members| own + &of_every_run(members))
}

/// What a study cannot tell, and what of it was not run.
fn limits(limits: &str, own: &[&Judged]) -> String {
    let absent = own.iter().filter_map(|one| match &one.verdict {
        Verdict::NotRun(why) => Some(format!("{}: {why}", one.check.quantity)),
        Verdict::Pass | Verdict::Fail => None,
    });
    let absent: Vec<String> = counted(absent).into_iter().map(|(told, _)| told).collect();
    let absent = if absent.is_empty() { String::new() } else { format!(" Not run: {}.", absent.join("; ")) };
    format!("## Limits\n\n{limits}{absent}\n")
}
