//! The front page: one computed answer to each question, the paper's statements, the verdicts, and the way to every
//! page; and the chart of the page of all checks: how much of their tolerances they use, by what they are held against.

use std::cmp::Reverse;

use crate::case::judged::worst;
use crate::case::{Judged, Relation, Verdict};
use crate::drawing::Colour;
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Direction, Drawing, Guide, Series};
use crate::markdown::{self, Column};
use crate::oracle::ReferenceKind;
use crate::report::links::{CHECKS, PAGES, to_page as link};
use crate::report::{case_page, matrix, record, statements, study_page, symbols, told};
use crate::solve::{Element, Ended, Iteration};
use crate::study::atlas;
use crate::study::atlas::plane::{Digest, digests};
use crate::study::drawn::{how_stopped, picture};
use crate::study::grouped::{counted, in_order};
use crate::study::method::Method;
use crate::study::paper::statement::{Judgement, Statement};
use crate::study::paper::{self, NOT_COVERED};
use crate::study::timings::record::Record;
use crate::study::timings::{self, FRONTS, conclusion};
use crate::study::{Finding, Room, Study, cases, faults, limits, measured, promised, refinement, scoreboard};

/// The page.
pub fn page(findings: &[Finding]) -> String {
    let parts = [
        ("Is it right?", right(findings)),
        ("Against what?", against(findings)),
        ("What does accuracy cost?", cost()),
        ("Where does it fail, and what should I use?", advice(findings)),
        ("The paper's statements", paper_statements(findings)),
        ("Verdicts", verdicts(findings)),
        ("What was never compared", never_compared(findings)),
        ("All pages", index(findings)),
    ];
    let body: String = parts.map(|(question, answer)| format!("## {question}\n\n{answer}\n")).concat();
    format!(
        "# Validation report\n\nThree contact elements × three iterations for frictionless elastic contact in 2D \
        (Égert 1999). Numbers, verdicts and conditions are computed, and with them the sentences that have any; typed \
        are definitions, sources, hypotheses, the paper's misprints, decisions where it is silent, reasons, limits \
        and obstacles. Do not edit. What letters stand for: {}.\n\n{}\n",
        link("symbols", symbols::FILE),
        body.trim_end()
    )
}

/// A link to the page of a study.
fn to_study(text: &str, study: &str) -> String {
    link(text, &study_page::file(study))
}

/// What a check of each kind can show.
const SHOWS: [(ReferenceKind, &str, &str); 4] = [
    (ReferenceKind::SelfConsistency, "the code itself, asked in another way", "that nothing contradicts itself"),
    (ReferenceKind::Analytic, "closed forms and orders of accuracy", "that the equations are solved (verification)"),
    (ReferenceKind::CrossCode, "other codes", "that others find the same (benchmarking)"),
    (ReferenceKind::Measured, "measurements", "that the equations are the right ones (validation)"),
];

/// Closed forms that are named.
const NAMED: usize = 4;

/// Whether any check fails, and how many error bars hold.
pub fn right(findings: &[Finding]) -> String {
    let all = told::each(findings);
    let [pass, fail, absent] = told::tally(all.iter().copied());
    let not_run = if absent > 0 { format!(", {absent} could not be run") } else { String::new() };
    let propositions = told::propositions(all.iter().copied());
    let of_codes = told::each(findings.iter().filter(|finding| is_of_codes(finding))).len();
    let verdict = match (all.len(), fail) {
        (0, _) => "**Nothing was checked.**".to_string(),
        (number, 0) => {
            format!(
                "**No check fails**: {pass} of {number} pass{not_run}: {propositions} propositions, judged in {number} \
                rows, {of_codes} of them of what other codes answer."
            )
        }
        (number, _) => format!("**✗ {fail} of {number} checks fail**; {pass} pass{not_run}.{}", told::failures(&all)),
    };
    let bars = findings.iter().filter_map(|finding| match finding.numbers() {
        Some(promised::Numbers::Checks(all, outside)) => {
            let unknown = outside.iter().filter(|(_, one)| !one.has_known_bar()).count();
            let beyond = outside.len() - unknown;
            Some(format!(
                " Of {all} numbers beside a closed form {beyond} are off by more than their error bar and the model \
                error that their case states; of {unknown} the bar is not known ({}).",
                link("which", &format!("{}#error-bars-beside-checks", study_page::file(promised::Numbers::NAME)))
            ))
        }
        _ => None,
    });
    format!(
        "{verdict}{} {} How they end by criteria of their own, {}.\n\n{}{}",
        bars.collect::<String>(),
        how_stopped(),
        to_study("the paper's statements tell", paper::Numbers::NAME),
        spoiled(),
        picture(
            "pressure-cylinder.svg",
            "Contact pressure on the cylinder by all nine formulations, and their difference to Hertz",
        )
    )
}

/// What changes that a program makes in the code turn red; none where that is not recorded.
fn spoiled() -> String {
    let link = to_study("planted faults and mutants", faults::Numbers::NAME);
    faults::rooms().map_or_else(
        |_| String::new(),
        |rooms| {
            let share = faults::by_truths_alone(&rooms);
            format!(
                "Of small changes that a program makes in the code, mutants, closed forms and other codes alone catch \
                {share}; claims and the code itself are asked besides: {link}.\n\n"
            )
        },
    )
}

/// Whether it judges what other codes answer, not this one.
fn is_of_codes(finding: &Finding) -> bool {
    finding.study == scoreboard::Numbers::NAME
}

/// Counts of checks by kind, the truths with the agreement with each, and what no measurement has seen.
pub fn against(findings: &[Finding]) -> String {
    let (theirs, ours): (Vec<&Finding>, Vec<&Finding>) = findings.iter().partition(|finding| is_of_codes(finding));
    let (all, of_codes) = (told::each(ours), told::each(theirs).len());
    let own = |kind: ReferenceKind| all.iter().copied().filter(move |one| one.reference.kind == kind);
    let mut kinds = SHOWS;
    kinds.sort_by_key(|(kind, ..)| Reverse(own(*kind).count()));
    let rows = kinds.map(|(kind, against, shows)| {
        let [pass, fail, absent] = told::tally(own(kind)).map(|number| number.to_string());
        let share = markdown::significant(100.0 * own(kind).count() as f64 / all.len().max(1) as f64, 2);
        vec![format!("{against} ({kind})"), shows.into(), own(kind).count().to_string(), share, pass, fail, absent]
    });
    let head = ["held against", "what it can show", "checks", "%", "pass", "fail", "not run"].map(String::from);
    let truths = truths(findings);
    let all_of_them = truths.len();
    let (analytic, outside): (Vec<Passed>, Vec<Passed>) =
        truths.into_iter().partition(|((_, kind), _)| *kind == ReferenceKind::Analytic);
    let named: Vec<Passed> = analytic.into_iter().take(NAMED).chain(outside).collect();
    let more = all_of_them - named.len();
    format!(
        "{}\nOf what other codes answer {of_codes} more checks are made: {}. {} {}. The {NAMED} closed forms with the \
        most numbers that agree with them, not by round-off alone, every other code, and what was measured; {more} \
        more closed forms and orders expected stand in {}:\n\n{}",
        markdown::table(&head, &rows),
        to_study("the scoreboard", scoreboard::Numbers::NAME),
        experiments(findings),
        link("Each check, and how near it is to its limit", CHECKS),
        link("the table of all truths", &format!("{CHECKS}#truths")),
        table_of(&named),
    )
}

/// The name and the kind of a truth, and the passed checks against it.
type Passed<'a> = ((&'a str, ReferenceKind), Vec<&'a Judged>);

/// The table of truths.
pub fn table_of(truths: &[Passed]) -> String {
    let columns: [Column<Passed>; 4] = [
        ("truth", |((name, kind), _)| format!("{name} ({kind})")),
        ("numbers", |(_, passed)| passed.len().to_string()),
        ("tightest agreement", |(_, passed)| told_agreement(agreements(passed).first())),
        ("loosest", |(_, passed)| told_agreement(agreements(passed).last())),
    ];
    markdown::columns(&columns, truths)
}

/// Passed checks whose relative error is above round-off, by that error.
fn agreements<'a>(passed: &[&'a Judged]) -> Vec<&'a Judged> {
    let is_agreement = |one: &&Judged| {
        let near = !matches!(one.check.relation, Relation::AtLeast | Relation::AtMost);
        near && one.check.tolerance < COUNTED && one.error >= told::ROUND_OFF
    };
    let mut agreements: Vec<&Judged> = passed.iter().copied().filter(is_agreement).collect();
    agreements.sort_by(|a, b| a.error.total_cmp(&b.error));
    agreements
}

fn told_agreement(one: Option<&&Judged>) -> String {
    one.map_or("round-off, or a bound".into(), |one| format!("{}: {}", told::error(one), one.check.quantity.name()))
}

/// A tolerance from which on an error is counted in what it may be, and is no agreement.
const COUNTED: f64 = 1.0;

/// Every truth that some check passed against but for those of the scoreboard, those with the most agreements first,
/// then those with the most numbers.
pub fn truths(findings: &[Finding]) -> Vec<Passed<'_>> {
    let all = told::each(findings.iter().filter(|finding| !is_of_codes(finding)));
    let passed = all.into_iter().filter(|one| one.verdict == Verdict::Pass && OUTSIDE.contains(&one.reference.kind));
    let mut truths: Vec<Passed> = in_order(passed.map(|one| ((&*one.reference.name, one.reference.kind), one)));
    truths.sort_by_key(|(_, passed)| Reverse((agreements(passed).len(), passed.len())));
    truths
}

/// Kinds of what is not this code.
const OUTSIDE: [ReferenceKind; 3] = [ReferenceKind::Analytic, ReferenceKind::CrossCode, ReferenceKind::Measured];

/// How many comparisons with measurements were judged, and of what kind.
fn experiments(findings: &[Finding]) -> String {
    let of_photographs = |yes: bool| {
        let own = findings.iter().filter(move |finding| {
            finding.numbers().is_some_and(|numbers| matches!(numbers, measured::Numbers::Photograph(_)) == yes)
        });
        own.flat_map(|finding| &finding.judged).filter(|judged| !matches!(judged.verdict, Verdict::NotRun(_)))
    };
    let shape = if of_photographs(true).next().is_some() {
        "One shape-only comparison with a photograph"
    } else {
        "No photograph compared"
    };
    let measured = of_photographs(false).filter(|judged| judged.reference.kind == ReferenceKind::Measured);
    match measured.count() {
        0 => format!("**{shape}; no calibrated experiment yet.**"),
        n => format!("**{shape}; calibrated curves compared: {n}.**"),
    }
}

/// What accuracy costs: the conclusion of the recorded timings; says so where there are none.
fn cost() -> String {
    let Ok(record) = Record::read().map(Record::in_one_run) else { return "No timings were read.".into() };
    let processor = &record.measured.machine.processor;
    format!(
        "{}\nSeconds of one machine ({processor}), one thread, those of other codes scaled by our own solve beside \
        them. {} {}.\n\n{}",
        conclusion(&record),
        timings::met(&record),
        to_study("All our runs, growth, stages, memory, targets", timings::Numbers::NAME),
        picture(FRONTS[0], FRONTS[1])
    )
}

/// The map of where methods fail, and what it shows.
const MAP: [&str; 2] = [
    "atlas-stretch.svg",
    "How every run ends over initial stiffness and candidate surface, with the predicted boundary",
];

/// What the surveyed planes say of each method; none where nothing was surveyed.
fn surveyed(findings: &[Finding]) -> Option<Vec<Digest>> {
    let charts = findings.iter().filter_map(|finding| match finding.numbers() {
        Some(atlas::Numbers::Surveyed(chart)) => Some(chart),
        _ => None,
    });
    let charts: Vec<&atlas::Chart> = charts.collect();
    (!charts.is_empty()).then(|| digests(&charts))
}

/// Where methods fail, and what to use: the recommendation and the map.
fn advice(findings: &[Finding]) -> String {
    let Some(digests) = surveyed(findings) else { return "Nothing was surveyed.".into() };
    let converged = findings.iter().find_map(|finding| match finding.numbers() {
        Some(promised::Numbers::Converged(recorded, _)) => Some(promised::converged::of_default(recorded)),
        _ => None,
    });
    let default = converged.map(|table| {
        format!(
            "If nothing is said, `contact-vv` takes `{}`. Runs of it on all scenes, on candidates of their own and on \
            longer ones:\n\n{table}\n\
            *{}* is the named error that no spring is left to hold a body. It names what may be the cause: a load \
            that pulls the bodies apart, a soft start, or a contact smaller than two elements, for which `--accuracy` \
            seeks a mesh.\n\n",
            Method::default(Element::Node, Iteration::Kinematic),
            Ended::Unsupported.name(),
        )
    });
    format!(
        "{}{}\n{} {}\n\n{}\n{}, {}, {}.\n\n{}",
        default.unwrap_or_default(),
        atlas::recommendation(&digests),
        refinement::in_front(findings.iter().filter_map(Finding::numbers)),
        to_study("Both by mesh", refinement::Numbers::NAME) + ".",
        statements::two_stops(),
        to_study("Why", atlas::Numbers::NAME),
        to_study("where everything else ends", limits::Numbers::NAME),
        to_study("what is called converged", promised::Numbers::NAME),
        picture(MAP[0], MAP[1])
    )
}

/// The paper's statements: judgement and one measured clause.
fn paper_statements(findings: &[Finding]) -> String {
    let judged = statements::judge(findings);
    let sources = format!("{PAGES}/{}#sources", study_page::file(paper::Numbers::NAME));
    let row = |one: &Statement| vec![one.text.into(), statements::linked(&one.judgement, &sources), one.clause.clone()];
    let words = counted(judged.iter().map(|one| match one.judgement {
        Judgement::Undecidable(_) => format!("[{}]({sources})", one.judgement.word()),
        _ => one.judgement.word().into(),
    }));
    let words: Vec<String> = words.iter().map(|(word, count)| format!("{count} {word}")).collect();
    let together = findings.iter().find_map(|finding| Some(paper::together(finding.numbers::<paper::Numbers>()?)));
    format!(
        "{} Of {} statements: {}. {}.\n\n{}",
        together.unwrap_or_default(),
        judged.len(),
        words.join(", "),
        to_study("Measurements and conditions in full, misprints, decisions, sources", paper::Numbers::NAME),
        markdown::table(
            &["statement", "judgement", "measured"].map(String::from),
            &judged.iter().map(row).collect::<Vec<_>>()
        )
    )
}

/// The matrix of the cases that all formulations solve, and the others in short.
fn verdicts(findings: &[Finding]) -> String {
    let best = surveyed(findings).and_then(|digests| atlas::recommended(&digests));
    let recommended = best.map(|method| (method.element, method.algorithm));
    let first = recommended.map_or(String::new(), |(element, algorithm)| {
        format!(", first by what is recommended, {} + {}", element.name(), algorithm.name())
    });
    format!(
        "Iterations to convergence{first}; ✓ all checks of the run pass, ✗ some fail, ○ some could not be run, · \
        reported only.\n\n{}\n{}",
        matrix::verdict_matrix(findings, recommended, named),
        matrix::other_cases(findings, named)
    )
}

/// Name of a case with the link to its page.
fn named(finding: &Finding) -> String {
    let name = finding.case.trim_end_matches(".toml");
    match finding.numbers::<cases::Numbers>() {
        Some(numbers) => link(name, &case_page::file(&cases::page(&numbers.case))),
        None => name.into(),
    }
}

/// What could not be run, and what is out of scope.
fn never_compared(findings: &[Finding]) -> String {
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
        Some(numbers) => case_page::file(&cases::page(&numbers.case)),
        None => study_page::file(finding.study),
    }
}

/// Every page of a study, with its sign and number of checks.
fn index(findings: &[Finding]) -> String {
    let one = |room: &Room| {
        let judged = || study_page::of(room.name, findings).flat_map(|finding| &finding.judged);
        let sign = worst(judged()).map_or("–", |worst| worst.mark().told()[0]);
        format!("{sign} {} {}", to_study(room.about.title, room.name), told::once(judged()).len())
    };
    let rooms: Vec<String> = study_page::asked(findings).map(one).collect();
    format!(
        "Studies, with their numbers of checks: {}.\n\nBesides: {}. The README says how to read them and how to make \
        them again.\n",
        rooms.join(" · "),
        link("all checks", CHECKS)
    )
}

/// The chart's file, and what it shows.
pub const NEARNESS: [&str; 2] = [
    "nearness.svg",
    "Of the checks held against each kind of reference, the part whose error uses at most so much of its tolerance",
];

/// Shares that are drawn: of what lies below the first the curve tells how many there are.
const RANGE: [f64; 2] = [1e-4, 10.0];
/// Steps of a curve in a decade.
const PER_DECADE: i32 = 8;
/// A kind, and how its curve is drawn.
const CURVES: [(ReferenceKind, Colour, Dash, Marker); 4] = [
    (ReferenceKind::SelfConsistency, palette::LINE, Dash::Solid, Marker::Circle),
    (ReferenceKind::CrossCode, palette::LAYER, Dash::Dashed, Marker::Square),
    (ReferenceKind::Analytic, palette::NODE, Dash::Dotted, Marker::Diamond),
    (ReferenceKind::Measured, palette::PURPLE, Dash::DashDot, Marker::Circle),
];

/// A curve for each kind that has checks; a check without an error counts as beyond every share.
pub fn nearness(findings: &[Finding]) -> Drawing {
    let rows = record::rows(findings);
    let [least, most] = RANGE;
    let share = Axis::log("share of the tolerance that is used [–]").over(least, most);
    let mut chart = Chart::new(
        "How near checks are to their limits",
        share,
        Axis::linear("part of the checks [%]").over(0.0, 100.0),
    );
    chart.notes.push("A check that could not be run is beyond every share.".into());
    chart.guides.push(Guide { direction: Direction::Vertical, at: 1.0, label: "limit".into() });
    for (kind, colour, dash, marker) in CURVES {
        let shares: Vec<f64> = rows.iter().filter(|row| row.kind == kind).map(|row| row.share).collect();
        if !shares.is_empty() {
            let label = format!("{kind}, {} checks", shares.len());
            let style = Style::run(colour, dash, marker);
            chart.series.push(Series::new(label, cumulated(&shares), style));
        }
    }
    chart.drawing()
}

/// The part of the shares, in per cent, that are at most so large.
pub fn cumulated(shares: &[f64]) -> Vec<(f64, f64)> {
    let [from, to] = RANGE.map(|end| (f64::from(PER_DECADE) * end.log10()).round() as i32);
    let part = |k: i32| {
        let at = 10f64.powf(f64::from(k) / f64::from(PER_DECADE));
        (at, 100.0 * shares.iter().filter(|share| **share <= at).count() as f64 / shares.len() as f64)
    };
    (from..=to).map(part).collect()
}
