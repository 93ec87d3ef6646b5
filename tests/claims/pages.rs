//! The report: a short front page, pages behind it that links reach, every check on one of them, and sentences that
//! follow the numbers; one page of it by the name of its case or study.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use contact_vv::case::{Check, Judged, Quantity, Reference, Verdict};
use contact_vv::checkout::root;
use contact_vv::oracle::ReferenceKind;
use contact_vv::report::front::{self, against, cumulated, right};
use contact_vv::report::links::{CHARTS, PAGES};
use contact_vv::report::{Only, case_page, diff, difference, matrix, page, record, study_page, symbols, told, write};
use contact_vv::study::sheet::SHEETS;
use contact_vv::study::{Files, Finding, Room, Study, Trial, cases, drawn, paper};

use crate::letters;
use crate::program::{Folder, ended, program};
use crate::workbench::spoiled;

/// Most lines of the front page.
const LINES: usize = 220;

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The front page and every page behind it.
fn all_pages() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join(PAGES)).expect("pages are committed");
    let mut pages: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    pages.push(root().join(page::PAGE));
    pages.sort();
    pages
}

/// Files that a page links or shows, each with the heading that is meant in it, if one is.
fn targets(page: &Path) -> Vec<(PathBuf, String)> {
    let text = text(page);
    let after = |begin: &str, end: char| {
        let parts =
            text.split(begin).skip(1).filter_map(|part| part.split_once(end)).map(|(target, _)| target.to_string());
        parts.collect::<Vec<_>>()
    };
    let all = [after("](", ')'), after("src=\"", '"'), after("href=\"", '"')].concat();
    let folder = page.parent().expect("a page is in a folder");
    let own = all
        .iter()
        .filter(|target| !target.starts_with("http"))
        .map(|target| target.split_once('#').unwrap_or((target, "")));
    own.map(|(file, heading)| (folder.join(file), heading.to_string())).collect()
}

/// What a link to a heading calls it.
fn anchor(heading: &str) -> String {
    heading.trim_start_matches('#').trim().to_lowercase().replace(' ', "-")
}

/// A passed run of a small case.
fn small() -> Finding {
    let trial = cases::Numbers::plan()
        .into_iter()
        .find(|trial| trial.case == "bars, u/g = 3" && trial.name == "node.kinematic");
    let numbers = trial.expect("bars are in the library").run().expect("solved");
    Finding::of("bars, u/g = 3", "node.kinematic", numbers).expect("judged")
}

fn marker(name: &'static str) -> Judged {
    Check::at_most(name, Reference::own("none", 1.0), "a reason").judge(0.5)
}

#[test]
fn error_that_fails_is_recorded_however_small_it_is() {
    let mut finding = small();
    let check = || Check::error("error", Reference::own("exact", 0.0), 1e-12, "a reason");
    finding.judged = vec![check().judge(3.21e-12)];
    let files = record::files(&[finding]).expect("written");
    let rows: Vec<record::CheckRow> = record::parsed(&files[0].1).expect("rows");
    assert!((rows[0].error - 3.21e-12).abs() <= 1e-18, "{}", files[0].1);
}

#[test]
fn no_page_shows_a_number_that_is_none() {
    for page in all_pages() {
        let cells = text(&page);
        let none = cells.split('|').find(|cell| ["NaN", "not a number"].contains(&cell.trim()));
        assert_eq!(none, None, "{}", page.display());
    }
}

#[test]
fn front_page_is_short() {
    let lines = text(&root().join(page::PAGE)).lines().count();
    assert!(lines <= LINES, "{lines} lines");
}

/// What a reader sees of a cell: links without their addresses, no marks.
fn seen(cell: &str) -> String {
    let mut parts = cell.split("](");
    let first = parts.next().unwrap_or_default().to_owned();
    let rest = parts.map(|part| part.split_once(')').map_or(part, |(_, behind)| behind));
    std::iter::once(first).chain(rest.map(String::from)).collect::<String>().replace(['[', '*'], "")
}

/// Least width at which a browser sets a table of these lines in GitHub's style: letters of 16, 13 left and right of
/// what a cell holds, a line of 1 between cells \[px\]. Words are not parted, and code is set smaller.
fn least_width(lines: &[&str]) -> f64 {
    let row = |line: &&str| line.trim_matches('|').split(" | ").map(seen).collect::<Vec<_>>();
    let rows: Vec<Vec<String>> = lines.iter().filter(|line| !line.starts_with("|---")).map(row).collect();
    let wide = |cell: &String, is_head: bool| {
        let words = cell.split("<br>").flat_map(str::split_whitespace);
        let of = |word: &str| match word.contains('`') {
            true => 0.85 * 0.61 * word.chars().count() as f64,
            false => letters::width(word, is_head),
        };
        words.map(of).fold(0.0, f64::max)
    };
    let columns = (0..rows[0].len()).map(|k| {
        let cells = rows.iter().enumerate().filter_map(|(r, row)| Some(wide(row.get(k)?, r == 0)));
        16.0 * cells.fold(0.0, f64::max) + 27.0
    });
    1.0 + columns.sum::<f64>()
}

#[test]
fn every_table_of_the_front_page_fits_the_width_of_github() {
    let text = text(&root().join(page::PAGE));
    let lines: Vec<&str> = text.lines().collect();
    let parts = lines.chunk_by(|a, b| a.starts_with('|') == b.starts_with('|'));
    let tables: Vec<&[&str]> = parts.filter(|lines| lines[0].starts_with('|')).collect();
    assert!(tables.len() > 5);
    for table in tables {
        let width = least_width(table);
        assert!(width <= 960.0, "{width:.0} px: {}", table[0]);
    }
    // Nine formulations beside one another do not.
    let heads = ["line", "layer", "node"].map(|element| {
        ["kinematic", "varying<br>+ newton", "constant<br>+ newton"].map(|way| format!("{element}<br>{way}"))
    });
    let head = format!("| case | {} |", heads.concat().join(" | "));
    let row = format!("| [truncated sphere](case.md) |{}", " ✓ 1203 |".repeat(9));
    assert!(least_width(&[&head, &row]) > 960.0, "{}", least_width(&[&head, &row]));
}

#[test]
fn what_the_reference_12_of_the_paper_is_cited_for_links_it() {
    for page in [root().join(page::PAGE), root().join(PAGES).join(study_page::file(paper::Numbers::NAME))] {
        let text = text(&page);
        // But where it is named in full.
        let mentions = text.match_indices("[12]").filter(|(at, _)| !text[..*at].ends_with("\n* "));
        let is_plain = |at: &usize| !text[at + 4..].trim_start_matches('*').starts_with("](");
        let plain: Vec<&str> = mentions
            .filter(|(at, _)| is_plain(at))
            .map(|(at, _)| text[..at].lines().last().unwrap_or_default())
            .collect();
        assert!(text.contains("[12]") && plain.is_empty(), "{}: {plain:?}", page.display());
    }
}

#[test]
fn every_picture_of_all_nine_says_what_stops_them() {
    let pages = ["VALIDATION.md", "README.md", "snapshots/pages/case-cylinder.md", "snapshots/pages/case-pin-rod.md"];
    for page in pages {
        assert!(text(&root().join(page)).contains(&drawn::how_stopped()), "{page}");
    }
}

#[test]
fn every_link_and_picture_of_a_page_resolves() {
    for page in all_pages() {
        for (target, heading) in targets(&page) {
            assert!(target.exists(), "{}: no {}", page.display(), target.display());
            let is_there = |text: String| text.lines().any(|line| line.starts_with('#') && anchor(line) == heading);
            assert!(heading.is_empty() || is_there(text(&target)), "{}: no {heading}", page.display());
        }
    }
}

#[test]
fn every_page_is_reached_from_the_front_page() {
    let mut reached = BTreeSet::new();
    let mut ahead = vec![root().join(page::PAGE)];
    while let Some(page) = ahead.pop() {
        let page = page.canonicalize().expect("links resolve");
        if page.extension().is_some_and(|extension| extension == "md") && reached.insert(page.clone()) {
            ahead.extend(targets(&page).into_iter().map(|(file, _)| file));
        }
    }
    let sheets = std::fs::read_dir(root().join("snapshots/sheets")).expect("sheets are committed");
    for page in all_pages().into_iter().chain(sheets.flatten().map(|entry| entry.path())) {
        assert!(reached.contains(&page.canonicalize().expect("it was listed")), "nothing links {}", page.display());
    }
}

#[test]
fn every_page_links_the_symbols_and_their_page_has_each_once() {
    for page in all_pages() {
        let text = text(&page);
        let head = text.split("\n## ").next().expect("a page has a head");
        assert!(head.contains("symbols.md)"), "{}", page.display());
    }
    let page = symbols::page(&[]);
    for [symbol, meaning] in symbols::SYMBOLS {
        assert_eq!(page.matches(&format!("| {symbol} | {meaning} |")).count(), 1, "{symbol}");
    }
}

#[test]
fn every_check_of_any_study_is_on_its_page() {
    let sound = small();
    let judged = vec![marker("fault seen by one"), marker("fault seen by another"), {
        let one = marker("fault of every run");
        Judged { check: one.check.clone().universal(), ..one }
    }];
    for room in Room::ALL {
        let own = |finding: &mut Finding| (finding.study, finding.judged) = (room.name, judged.clone());
        let findings = [spoiled(&sound, own)];
        let text = match room.name {
            cases::Numbers::NAME => case_page::page(&case_page::shared(&findings)[0], false),
            _ => study_page::tables(room.name, &findings),
        };
        for one in &judged {
            let name = one.check.quantity.name();
            assert!(text.to_lowercase().contains(name), "{}: {name} is missing:\n{text}", room.name);
        }
    }
}

#[test]
fn first_sentence_follows_the_verdicts() {
    let sound = small();
    assert!(right(std::slice::from_ref(&sound)).starts_with("**No check fails**"));
    let failed = spoiled(&sound, |finding| finding.judged[0].verdict = Verdict::Fail);
    let asked = told::once(sound.judged.iter().chain(&failed.judged)).len();
    let said = right(&[sound.clone(), failed]);
    assert!(said.starts_with(&format!("**✗ 1 of {asked} checks fail**")), "{said}");
    assert!(said.contains(&sound.judged[0].requirement()), "{said}");
    let absent = |finding: &mut Finding| finding.judged[0].verdict = Verdict::NotRun("no figures".into());
    assert!(right(&[spoiled(&sound, absent)]).contains("1 could not be run"));
    assert!(right(&[]).starts_with("**Nothing was checked.**"));
}

#[test]
fn what_most_checks_are_held_against_follows_their_kinds() {
    let mut finding = small();
    let first = |finding: &Finding| against(std::slice::from_ref(finding)).lines().nth(2).expect("a row").to_owned();
    assert!(first(&finding).starts_with("| the code itself"), "{}", first(&finding));
    finding.judged.iter_mut().for_each(|one| one.reference.kind = ReferenceKind::CrossCode);
    assert!(first(&finding).starts_with("| other codes"), "{}", first(&finding));
}

#[test]
fn truths_are_named_with_the_tightest_and_the_loosest_agreement_of_what_passed() {
    let mut finding = small();
    let judge = |at: &str, value: f64| {
        let reference = Reference { kind: ReferenceKind::CrossCode, ..Reference::own("another code", 1.0) };
        Check::near(Quantity::at("pressure of the trial", at), reference, 0.1, "a reason").judge(value)
    };
    finding.judged = vec![judge("a", 1.01), judge("b", 1.0 + 1e-5), judge("c", 1.05), judge("d", 2.0)];
    let said = against(&[finding]);
    let row = said.lines().find(|line| line.starts_with("| another code (cross-code) | 3 |")).expect("what passed");
    let place = |text: &str| row.find(text).unwrap_or_else(|| panic!("no {text} in {row}"));
    assert!(place("1.0e-5") < place("5.0 %"), "{row}");
}

#[test]
fn page_of_a_case_follows_its_verdicts_and_outcome() {
    let mut finding = small();
    let page = |finding: &Finding| case_page::page(&case_page::shared(std::slice::from_ref(finding))[0], false);
    let sound = page(&finding);
    assert!(sound.contains("✓ **All") && sound.contains("## Input") | sound.contains("## Scene"), "{sound}");
    finding.judged[0].verdict = Verdict::Fail;
    let spoiled = page(&finding);
    assert!(spoiled.contains("✗ **1 of"), "{spoiled}");
    let front = front::page(&[finding]);
    assert!(front.lines().any(|line| line.contains("[bars") && line.contains("✗")), "{front}");
}

#[test]
fn pages_are_written_compared_and_removed_as_a_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let of = |pages: &[&str]| -> Files {
        let pages = pages.iter().map(|name| format!("{PAGES}/{name}"));
        let others = [format!("{CHARTS}/a.svg"), format!("{SHEETS}/s.md"), page::PAGE.into()];
        pages.chain(others).map(|path| (path, "text\n".into())).collect()
    };
    let (before, after) = (of(&["one.md", "two.md"]), of(&["one.md"]));
    let told = |page: &Files| {
        difference(page, folder.path()).expect("compared").map(|difference| difference.text(diff::LINES))
    };
    write(&before, folder.path()).expect("written");
    assert_eq!(told(&before), None);
    assert!(told(&after).expect("a page less").contains("two.md"));
    write(&after, folder.path()).expect("written");
    assert!(!folder.path().join(PAGES).join("two.md").exists());
    assert_eq!(told(&after), None);
    std::fs::write(folder.path().join(PAGES).join("one.md"), "other\n").expect("written");
    assert!(told(&after).expect("another text").contains("one.md"));
}

#[test]
fn rows_of_bounds_tell_how_much_of_them_is_used_and_those_of_errors_how_much_of_the_tolerance() {
    let bound = || Reference::own("none", 2.0);
    let least = |name: &'static str, value: f64| Check::at_least(name, bound(), "a reason").judge(value);
    let most = |name: &'static str, value: f64| Check::at_most(name, bound(), "a reason").judge(value);
    let near = Check::near("e", Reference::analytic("Hertz", 100.0), 0.1, "a reason").judge(99.0);
    let mut finding = small();
    finding.judged = vec![least("a", 8.0), least("b", 1.0), most("c", 0.5), most("d", 4.0), near];
    let rows = record::rows(&[finding]);
    assert_eq!(rows.iter().map(|row| row.share).collect::<Vec<f64>>(), [0.25, 2.0, 0.25, 2.0, 0.1]);
}

#[test]
fn the_worst_of_some_runs_is_the_sign_of_their_case_and_failures_that_are_not_named_are_counted() {
    let failed = || Check::at_most("number", Reference::own("none", 1.0), "a reason").judge(2.0);
    let fails: Vec<Judged> = (0..5).map(|_| failed()).collect();
    let told = told::failures(&fails.iter().collect::<Vec<_>>());
    assert!(told.ends_with("; and 2 more."), "{told}");
    let [passed, mut broken] = [small(), small()];
    broken.judged = vec![failed()];
    for findings in [[passed.clone(), broken.clone()], [broken, passed]] {
        let row = matrix::other_cases(&findings, |finding| finding.case.clone());
        assert!(row.contains("| ✗ "), "{row}");
    }
}

#[test]
fn checks_without_an_error_are_beyond_every_share_of_their_tolerance() {
    let parts = cumulated(&[0.0, 0.1, 2.0, f64::NAN]);
    let at = |share: f64| parts.iter().rfind(|(x, _)| *x <= share * (1.0 + 1e-9)).expect("a share").1;
    assert_eq!([at(1e-3), at(0.1), at(1.0), at(10.0)], [25.0, 50.0, 50.0, 75.0]);
}

#[test]
fn numbers_of_cases_alone_have_error_bars_so_that_the_page_of_what_is_promised_needs_no_other() {
    let table = text(&root().join(record::CHECKS));
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let head: Vec<String> = rows.headers().expect("columns").iter().map(String::from).collect();
    let at = |name: &str| head.iter().position(|column| column == name).expect("a column");
    // What is itself an error has no true one to hold its bar against.
    let is_number = |row: &csv::StringRecord| !row[at("bar")].is_empty() && &row[at("relation")] != "error";
    let barred: Vec<csv::StringRecord> = rows.records().flatten().filter(is_number).collect();
    assert!(barred.len() > 50, "{} checks have a bar", barred.len());
    for row in barred {
        assert_eq!(&row[at("study")], cases::Numbers::NAME, "{row:?}");
    }
    let asked: BTreeSet<String> = Only::named("promised").expect("a study").trials().iter().map(Trial::title).collect();
    let of = |room: &str| Room::ALL.iter().find(|one| one.name == room).expect("a study");
    for trial in ["cases", "promised"].into_iter().flat_map(|room| (of(room).plan)()) {
        assert!(asked.contains(&trial.title()), "{}", trial.title());
    }
}

#[test]
fn one_page_of_a_case_is_that_of_the_report_and_a_mistyped_name_is_told_with_its_like() {
    let folder = Folder::made();
    // A checkout with what pages are made from, and none of them.
    folder.with("Cargo.toml", "");
    for (inside, of) in
        [("tests/cases", "toml"), ("tests/cases/meshes", "msh"), ("snapshots", "csv"), ("snapshots", "json")]
    {
        folder.copied(inside, of);
    }
    for inside in ["pages", "charts", "sheets"] {
        std::fs::create_dir_all(folder.path().join("snapshots").join(inside)).expect("made");
    }
    let report = |name: &str| ended(program(&["report", "--only", name]).current_dir(folder.path()));
    for (name, page) in [
        ("blocks.toml", "case-blocks-toml"),
        ("tests/cases/moment.toml", "case-moment-toml"),
        ("press-fit", "case-press-fit"),
    ] {
        let (code, shown, error) = report(name);
        let file = format!("snapshots/pages/{page}.md");
        let read = |root: &Path| std::fs::read_to_string(root.join(&file)).expect("a page");
        let committed = read(&root());
        assert_eq!(code, Some(0), "{name}: {error}");
        assert!(read(folder.path()) == committed && shown.starts_with(committed.trim_end()), "{name}: {shown:.300}");
        assert!(shown.trim_end().ends_with(&file), "{name}");
        assert!(error.starts_with(&format!("{name}: ")) && error.trim_end().ends_with(" trials"), "{error}");
    }
    let (_, _, again) = report("blocks.toml");
    assert!(again.contains(" trials, ") && again.trim_end().ends_with(" s the last time"), "{again}");
    let (code, shown, error) = report("blocs.toml");
    assert_eq!((code, shown.as_str()), (Some(2), ""));
    assert!(error.contains("did you mean `blocks.toml`?") && error.contains("fitted"), "{error}");
}
