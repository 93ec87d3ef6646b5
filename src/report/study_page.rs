//! The page of a study: what it asked, its numbers and charts, all of its checks, and what it cannot tell.

use crate::case::{Judged, Verdict};
use crate::error::Error;
use crate::report::grouped::counted;
use crate::report::{checks, heading, statements};
use crate::study::{Finding, Room};

/// Name of the file.
pub fn file(room: Room) -> String {
    format!("{}.md", room.name().replace('_', "-"))
}

/// The page.
pub fn page(room: Room, findings: &[Finding]) -> Result<String, Error> {
    let about = room.about();
    let own: Vec<&Judged> = of(room, findings).flat_map(|finding| &finding.judged).collect();
    let checks = match room {
        Room::Cases => "The page of each case has its checks.\n\n".into(),
        _ => tables(room, findings),
    };
    // What the paper says is judged by the findings of all studies, of which its own sees only its part.
    let first = if room == Room::Paper { statements::section(findings) } else { String::new() };
    let body = format!("{first}{}\n## Checks\n\n{checks}{}", room.section(findings)?, limits(about.limits, &own));
    Ok(heading::page(about.title, about.asked, &own, &body))
}

/// Findings of a study.
pub fn of(room: Room, findings: &[Finding]) -> impl Iterator<Item = &Finding> {
    findings.iter().filter(move |finding| finding.room == room)
}

/// Studies of which something was found, in their order.
pub fn asked(findings: &[Finding]) -> Vec<Room> {
    Room::ALL.iter().copied().filter(|room| of(*room, findings).next().is_some()).collect()
}

/// All checks of a study, one part a case: none can be forgotten.
pub fn tables(room: Room, findings: &[Finding]) -> String {
    let own: Vec<&Finding> = of(room, findings).collect();
    let parts: Vec<&[&Finding]> = own.chunk_by(|a, b| a.case == b.case).collect();
    let table = |members: &&[&Finding]| {
        let named: Vec<checks::Named> = members.iter().map(|one| (one.name.as_str(), &one.judged[..])).collect();
        let table = checks::of(&named) + &checks::of_every_run(members.iter().flat_map(|one| &one.judged));
        if parts.len() > 1 { format!("### {}\n\n{table}", members[0].case) } else { table }
    };
    parts.iter().map(table).collect()
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
