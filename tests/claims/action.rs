//! What judges in the workflows of others: JUnit XML, the Action, the form of an issue.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;

use contact_vv::case::library::NAMES;
use contact_vv::checkout::root;
use quick_junit::{Report, TestCase, TestCaseStatus};
use serde_json::json;

use crate::outputs::{contact_vv, scene};
use crate::program::{Folder, ended, program};

/// Our own answer to a case.
static OURS: LazyLock<String> = LazyLock::new(|| {
    let folder = Folder::made();
    let (exported, _, error) = contact_vv(&["export", "truncated-hertz", &folder.at("to")]);
    assert!(exported, "{error}");
    folder.read("to/ours.csv")
});

/// The same, and with pressures 3 % too large, in files whose names have blanks.
fn answers() -> Folder {
    let folder = Folder::made();
    let wrong = OURS.lines().enumerate().map(|(line, text)| {
        let mut cells: Vec<String> = text.split(',').map(String::from).collect();
        if line > 0 {
            cells[1] = (1.03 * cells[1].parse::<f64>().expect("a pressure")).to_string();
        }
        cells.join(",") + "\n"
    });
    folder.with("right one.csv", &*OURS);
    folder.with("wrong one.csv", wrong.collect::<String>());
    folder
}

/// A script of the Action in a folder, with what it is told by the environment; standard output, then what is in a file
/// it writes.
fn script(name: &str, folder: &Path, told: &[(&str, String)], file: &str) -> (Option<i32>, String, String) {
    let path = format!("{}/bin:{}", folder.display(), std::env::var("PATH").expect("a path"));
    let mut command = Command::new("bash");
    command.arg(root().join(".github/actions/judge").join(name)).current_dir(folder).envs(told.iter().cloned());
    let command = command.env("PATH", path).env("GITHUB_OUTPUT", "output").env("GITHUB_STEP_SUMMARY", "summary");
    let (code, text, error) = ended(command);
    (code, text + &error, fs::read_to_string(folder.join(file)).unwrap_or_default())
}

#[test]
fn junit_has_a_test_case_for_every_verdict() {
    let folder = answers();
    let files = ["right one.csv", "wrong one.csv"].map(|name| folder.at(name));
    let xml = folder.at("verdicts.xml");
    let judge = |option: &str| contact_vv(&["judge", "truncated-hertz", &files[0], &files[1], "--json", option, &xml]);
    for met in [judge("--junit"), judge("--junit")].map(|(met, ..)| met) {
        assert!(!met, "an earlier report is replaced");
    }
    let report = Report::deserialize_from_str(&folder.read("verdicts.xml")).expect("JUnit XML");
    let (_, lines, _) = judge("--junit");
    for (suite, line) in report.test_suites.iter().zip(lines.lines()) {
        let line: serde_json::Value = serde_json::from_str(line).expect("JSON");
        assert_eq!(line["answer"], suite.name.as_str());
        let list = |key: &str| line[key].as_array().expect("a list").clone();
        let failed = |one: &serde_json::Value| one["verdict"] == "fail";
        assert_eq!(suite.tests, list("checks").len() + list("missing").len());
        assert_eq!((suite.failures, suite.errors), (list("checks").iter().filter(|one| failed(one)).count(), 0));
        for (case, check) in suite.test_cases.iter().zip(list("checks")) {
            assert_eq!(check["quantity"], case.name.as_str());
            if let TestCaseStatus::NonSuccess { message, .. } = &case.status {
                let message = message.as_ref().expect("a message").as_str();
                assert!(message.contains(check["requirement"].as_str().expect("a sentence")), "{message}");
            }
        }
    }
    assert_eq!([0, 1].map(|k| report.test_suites[k].failures > 0), [false, true]);
    folder.with("verdicts.xml", "<testsuites name=\"another\"/>");
    let (_, _, error) = judge("--junit");
    assert!(error.contains("not an earlier output"), "{error}");
}

#[test]
fn an_answer_that_lacks_a_contact_is_not_met_where_no_contact_alone_is_asked_for() {
    let folder = Folder::made();
    let (case, to) = (scene("plate-on-two-supports"), folder.at("to"));
    contact_vv(&["export", &case, &to]);
    let both = folder.read("to/ours.csv");
    let left: String = both.lines().filter(|line| !line.ends_with("right")).map(|line| format!("{line}\n")).collect();
    let [both, left] = [("both.csv", both), ("left.csv", left)].map(|(name, text)| folder.with(name, text));
    let xml = folder.at("verdicts.xml");
    let judge = |rest: &[&str]| ended(program(&["judge", &case, "--junit", &xml, "--force"]).args(rest));
    for (rest, wanted) in [(&[&*both][..], 0), (&[&left], 1), (&[&left, "--markdown"], 1), (&[&both, &left], 1)] {
        let (code, said, error) = judge(rest);
        assert_eq!(code, Some(wanted), "{rest:?}: {said}{error}");
        let title = "lacks a contact, and meets all that could be judged";
        assert_eq!(said.contains(title) && said.contains("NOT HANDED IN: contact `right`"), wanted == 1, "{said}");
        let report = Report::deserialize_from_str(&folder.read("verdicts.xml")).expect("JUnit XML");
        assert_eq!(report.test_suites.iter().map(|suite| suite.failures).sum::<usize>(), wanted as usize);
    }
    let (code, said, _) = judge(&[&left, "--contact", "left", "--json"]);
    assert_eq!(code, Some(0), "{said}");
    let (_, said, _) = judge(&[&left, "--json"]);
    assert!(said.contains("\"met\":false") && said.contains("contact `right`"), "{said}");
}

#[test]
fn what_a_series_leaves_unjudged_is_skipped_in_junit() {
    let folder = answers();
    let [right, wrong, xml] = ["right one.csv", "wrong one.csv", "verdicts.xml"].map(|name| folder.at(name));
    contact_vv(&["judge", "truncated-hertz", &right, &wrong, &right, "--series", "--junit", &xml]);
    let report = Report::deserialize_from_str(&folder.read("verdicts.xml")).expect("JUnit XML");
    let series = report.test_suites.iter().find(|suite| suite.name.as_str() == "series").expect("a series");
    let is_skipped = |case: &TestCase| matches!(case.status, TestCaseStatus::Skipped { .. });
    assert!(series.tests == 2 && series.test_cases.iter().all(is_skipped), "{series:?}");
}

#[test]
fn an_answer_that_cannot_be_read_is_an_error_beside_the_verdicts_of_the_others() {
    let folder = answers();
    let cut = folder.with("cut.csv", "position [mm],pressure [MPa]\n0,3\n1\n");
    let [right, wrong, xml] = ["right one.csv", "wrong one.csv", "verdicts.xml"].map(|name| folder.at(name));
    for options in [&["--json"][..], &["--json", "--series"]] {
        let arguments = ["judge", "truncated-hertz", &cut, &right, &wrong, "--junit", &xml, "--force"];
        let (code, said, error) = ended(program(&arguments).args(options));
        assert_eq!((code, said.lines().count()), (Some(2), 2), "{said}{error}");
        assert!(error.contains("cut.csv:3") && error.contains("the file is cut"), "{error}");
        let report = Report::deserialize_from_str(&folder.read("verdicts.xml")).expect("JUnit XML");
        let suite = |file: &str| report.test_suites.iter().find(|suite| suite.name.as_str() == file).expect("a suite");
        assert_eq!((suite(&cut).errors, suite(&cut).tests), (1, 1));
        assert!(suite(&right).errors == 0 && suite(&right).failures == 0 && suite(&wrong).failures > 0);
        let TestCaseStatus::NonSuccess { message, .. } = &suite(&cut).test_cases[0].status else { panic!("a success") };
        assert!(message.as_ref().is_some_and(|message| message.contains("the file is cut")));
    }
    // Of answers of which none is read there is a report too.
    let (_, _, error) = contact_vv(&["judge", "truncated-hertz", &cut, "--junit", &xml]);
    let report = folder.read("verdicts.xml");
    assert!(
        error.contains("the file is cut") && report.contains("<error") && !report.contains("right one"),
        "{report}"
    );
}

#[test]
fn the_action_writes_summary_and_junit_and_ends_as_the_program_does() {
    for (files, options, code, parts) in [
        ("r*.csv", "", 0, ["meets all", "| peak pressure [MPa] |"]),
        ("\n right one.csv \nwrong*.csv\n", "", 1, ["does not meet", "NOT MET"]),
        ("wrong one.csv", "--tolerance=5 %", 0, ["meets all", "✓ met"]),
        ("**/wrong*.csv", "", 1, ["does not meet", "NOT MET"]),
        ("*.dat", "", 2, ["No file matches `*.dat`", "`files`"]),
        ("bare.csv", "", 2, ["bare.csv", "::set-env::"]),
        ("right one.csv", "--unit=furlong", 2, ["furlong", "```text"]),
    ] {
        let folder = answers();
        folder.with("bare.csv", "position,pressure\n::set-env::```,1\n");
        let program = env!("CARGO_BIN_EXE_contact-vv-tested");
        let units = "position=mm\npressure=MPa";
        let inputs = json!({ "case": "truncated-hertz", "files": files, "units": units, "columns": "",
            "options": options, "junit": "a b.xml", "program": program });
        let (ended, log, summary) = script("judge.sh", folder.path(), &[("INPUTS", inputs.to_string())], "summary");
        assert_eq!(ended, Some(code), "{files}: {log}");
        assert!(parts.iter().all(|part| summary.contains(part)), "{files}: {summary}");
        // What is quoted of an answer does not end its block.
        assert!([0, 2].contains(&summary.matches("```").count()), "{files}: {summary}");
        assert_eq!(log.lines().filter(|line| line.starts_with("::")).count(), usize::from(code > 0), "{log}");
        // What cannot be read is an error in the report.
        assert_eq!(folder.path().join("a b.xml").is_file(), code < 2 || files == "bare.csv", "{files}");
    }
}

#[test]
fn the_form_of_an_issue_is_read_and_nothing_else_of_it() {
    let form = fs::read_to_string(root().join(".github/ISSUE_TEMPLATE/judge-my-answer.yml")).expect("a form");
    assert!(form.contains(&format!("options: [{}]", NAMES.map(|(name, _)| name).join(", "))), "{form}");
    assert!(["Case", "Units", "Answer"].iter().all(|label| form.contains(&format!("label: {label}\n"))), "{form}");
    let link = "https://github.com/user-attachments/files/1/theirs.csv";
    let read = |case: &str, units: &str, answer: &str| {
        let folder = answers();
        fs::create_dir(folder.path().join("bin")).expect("a folder");
        let copy = "#!/bin/sh\nwhile [ \"$1\" != --output ]; do shift; done\ncp 'right one.csv' \"$2\"\n";
        let curl = folder.with("bin/curl", copy);
        fs::set_permissions(&curl, fs::Permissions::from_mode(0o755)).expect("set");
        let body =
            format!("### Case\r\n\r\n{case}\r\n\r\n### Units\r\n\r\n{units}\r\n\r\n### Answer\r\n\r\n{answer}\r\n");
        let (code, log, output) = script("issue.sh", folder.path(), &[("BODY", body)], "output");
        let fetched = fs::read_dir(folder.path().join("answers")).map_or(0, Iterator::count);
        assert!(!folder.path().join("run").exists() && log.is_empty(), "{log}");
        (code, output, fetched)
    };
    let (code, output, fetched) =
        read("cylinder", "position=mm\r\npressure=MPa", &format!("two: [a]({link}) [b]({link}.gz)"));
    assert_eq!((code, fetched), (Some(0), 2));
    assert_eq!(output, "case=cylinder\nunits<<END\nposition=mm\npressure=MPa\nEND\n");
    let (code, output, fetched) = read("cylinder", "$(touch run)\nEND\ncase=../x y\n`touch run`", link);
    assert_eq!((code, output.as_str(), fetched), (Some(1), "sheet=refused.md\n", 0));
    // Two files of one name are two; blanks beside a unit are none of it, and the field may be left empty.
    let (code, output, fetched) =
        read("cylinder", " position=mm \r\n\tpressure=MPa", &format!("[a]({link}) [a]({link})"));
    assert_eq!((code, fetched), (Some(0), 2));
    assert_eq!(output, "case=cylinder\nunits<<END\nposition=mm\npressure=MPa\nEND\n");
    assert_eq!(read("cylinder", "_No response_", link).0, Some(0));
    for (case, answer) in [
        ("../mine.toml", link),
        ("--help", link),
        ("cylinder", "none"),
        ("cylinder", "https://example.com/files/1/a.csv"),
        ("cylinder", "https://github.com/a/b/files/1/../../c"),
    ] {
        let (code, output, fetched) = read(case, "", answer);
        assert_eq!((code, output.as_str(), fetched), (Some(1), "sheet=refused.md\n", 0), "{case}: {answer}");
    }
}
