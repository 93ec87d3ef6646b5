//! The scoreboard is computed from files as other codes wrote them: what is planted in them, or in the record, is
//! found.

use std::fs::File;
use std::io::Read;
use std::sync::LazyLock;

use contact_vv::case::Verdict;
use contact_vv::oracle::cross_code::Code;
use contact_vv::referee::Truth;
use contact_vv::study::Study;
use contact_vv::study::scoreboard::board::{self, Board, Ended, ROUND_OFF, scored};
use contact_vv::study::scoreboard::{CASES, Numbers, Row, named, numbers};
use flate2::read::GzDecoder;

use crate::workbench::spoiled;

fn of(case: &str, board: &Board) -> Numbers {
    numbers(case, &named(case).expect("a case"), board).expect("judged")
}

/// All cases as they are frozen.
static ALL: LazyLock<[Numbers; CASES.len()]> = LazyLock::new(|| {
    let board = Board::load().expect("frozen");
    CASES.map(|case| of(case, &board))
});

/// The file that is kept of a run.
fn file(row: &Row) -> Option<&str> {
    if let Ended::Answered { file, .. } = &row.told.ended { file.as_deref() } else { None }
}

/// Which checks of a case do not pass.
fn not_passed(numbers: &Numbers) -> Vec<String> {
    let judged = numbers.judge().expect("judged").into_iter();
    judged.filter(|one| one.verdict != Verdict::Pass).map(|one| one.check.quantity.to_string()).collect()
}

#[test]
fn every_code_of_the_scoreboard_is_judged_from_the_file_that_it_wrote_on_at_least_five_cases() {
    for (code, ending) in [
        ("CalculiX", ".frd.gz"),
        ("CalculiX", ".dat"),
        ("GetFEM", ".vtu.gz"),
        ("NGSolve", ".vtu.gz"),
        ("NGSolve", ".json"),
        ("SfePy", ".vtu.gz"),
        ("Kratos", ".vtu.gz"),
        ("Akantu", ".vtu.gz"),
        ("FElupe", ".vtu.gz"),
        ("scikit-fem", ".csv"),
        ("dolfinx", ".json"),
    ] {
        let read = ALL.iter().filter(|numbers| {
            numbers.rows.iter().any(|row| {
                let is_of = file(row).is_some_and(|file| file.ends_with(ending));
                row.setting.code.name() == code && is_of && row.scored.is_ok()
            })
        });
        assert!(read.count() >= 5, "{code} {ending}");
    }
}

#[test]
fn what_is_planted_in_the_record_or_the_files_is_refused() {
    let board = Board::load().expect("frozen");
    let sound = of("bars", &board);
    assert_eq!(not_passed(&sound), Vec::<String>::new());
    let with = |spoil: &dyn Fn(&mut Board)| {
        let refused = numbers("bars", &named("bars").expect("a case"), &spoiled(&board, spoil));
        refused.expect_err("what it lacks").to_string()
    };
    let scripts = with(&|board| board.scripts.values_mut().for_each(|hash| hash.push('0')));
    assert!(scripts.contains("answers of another"), "{scripts}");
    let lost = with(&|board| drop(board.cases.get_mut("bars").expect("asked").runs.pop()));
    assert!(lost.contains("no answer of"), "{lost}");
    let unread = with(&|board| {
        let runs = &mut board.cases.get_mut("bars").expect("asked").runs;
        let rows = runs.iter_mut().find(|told| told.method == "gaps").expect("asked");
        if let Ended::Answered { file, .. } = &mut rows.ended {
            *file = Some("absent.dat".into());
        }
    });
    assert!(unread.contains("an answer of gaps that cannot be read"), "{unread}");
    let none = Numbers { rows: vec![], ..sound };
    assert_eq!(not_passed(&none).len(), codes().count());
}

/// Codes with a contact of their own.
fn codes() -> impl Iterator<Item = Code> {
    Code::ALL.into_iter().filter(|code| ![Code::ScikitFem, Code::Dolfinx].contains(code))
}

#[test]
fn every_search_ends_where_its_rule_says_and_keeps_the_files_of_the_first_choice_and_the_best() {
    for (case, numbers) in CASES.iter().zip(ALL.iter()) {
        for code in codes() {
            let of = format!("{case}, {}", code.name());
            let tried: Vec<&Row> = numbers.search(code).collect();
            let errors: Vec<f64> = tried.iter().map(|row| row.error()).collect();
            let floored: Vec<f64> =
                errors.iter().map(|error| if error.is_nan() { f64::INFINITY } else { error.max(ROUND_OFF) }).collect();
            // By hand: up by tens while the error falls by a tenth; where the first step does not, down.
            let ups = [1.0, 10.0, 100.0, 1000.0];
            let mut wanted = vec![ups[0]];
            let mut walk = |multiples: &[f64]| {
                let (mut before, begun) = (floored[0], wanted.len());
                for times in multiples {
                    wanted.push(*times);
                    let Some(error) = floored.get(wanted.len() - 1).filter(|error| **error < 0.9 * before) else {
                        break;
                    };
                    before = *error;
                }
                wanted.len() - begun == 1
            };
            if walk(&ups[1..]) && code != Code::Kratos {
                walk(&[0.1, 0.01]);
            }
            assert_eq!(tried.iter().map(|row| row.told.times).collect::<Vec<_>>(), wanted, "{of}: {errors:?}");
            let [first, best] = numbers.own(code).map(|row| row.expect("answered"));
            let least = floored.iter().copied().fold(f64::INFINITY, f64::min);
            assert!(best.error().max(ROUND_OFF) <= least * (1.0 + 1e-4), "{of}: {errors:?}");
            for row in tried {
                let is_kept =
                    [first, best].iter().any(|one| one.told.times == row.told.times) && row.error().is_finite();
                assert_eq!(file(row).is_some(), is_kept, "{of} × {}", row.told.times);
            }
        }
    }
}

#[test]
fn a_factor_in_how_the_pressures_of_a_code_are_read_turns_its_check_of_every_case_red_and_no_other() {
    for (case, numbers) in CASES.iter().zip(ALL.iter()) {
        for code in codes() {
            let mut planted = numbers.clone();
            for row in planted.rows.iter_mut().filter(|row| row.setting.code == code && row.setting.searched.is_some())
            {
                row.departures[0] = 1.1 * (1.0 + row.departures[0]) - 1.0;
            }
            let red = format!("error of {}'s own contact at its best, {case}", code.name());
            assert_eq!(not_passed(&planted), [red]);
        }
    }
}

#[test]
fn our_own_answer_changes_nothing_of_what_other_codes_may_be_off() {
    for (case, numbers) in CASES.iter().zip(ALL.iter()) {
        let allowed = |numbers: &Numbers| -> Vec<f64> {
            numbers.judge().expect("judged").iter().map(|one| one.check.tolerance).collect()
        };
        let absent = Numbers { ours: Err("none".into()), ..numbers.clone() };
        let mut off = numbers.clone();
        off.ours.as_mut().expect("read").scores[0].value *= 1.5;
        assert!(allowed(numbers).iter().all(|most| *most < 0.02), "{case}: {:?}", allowed(numbers));
        assert_eq!([allowed(&absent), allowed(&off)], [allowed(numbers), allowed(numbers)], "{case}");
    }
}

#[test]
fn pressures_spoiled_in_the_files_that_a_code_wrote_turn_its_check_red() {
    let (case, numbers) = (named("truncated-hertz").expect("a case"), &ALL[1]);
    let (discretisation, truth) =
        (case.meshed().expect("meshed").discretisation, Truth::of(case.clone()).expect("a truth"));
    let judged = |factor: f64| {
        let mut planted = numbers.clone();
        for row in planted
            .rows
            .iter_mut()
            .filter(|row| row.setting.code == Code::Getfem && row.setting.searched.is_some() && row.scored.is_ok())
        {
            let path = board::folder().join(file(row).expect("kept"));
            let mut text = String::new();
            GzDecoder::new(File::open(&path).expect("a file")).read_to_string(&mut text).expect("read");
            let field =
                text.find("Name=\"contact_pressure\"").and_then(|at| text[at..].find('>').map(|end| at + end + 1));
            let from = field.expect("a field");
            let to = from + text[from..].find('<').expect("its end");
            let scaled = text[from..to].split_whitespace().map(|p| p.parse::<f64>().expect("a number") * factor);
            let scaled: String = scaled.map(|p| format!("{p:e} ")).collect();
            let text = [&text[..from], &scaled, &text[to..]].concat();
            let scored = scored(&truth, &discretisation, &path.with_extension(""), text.as_bytes()).expect("judged");
            row.departures = [0, 1].map(|k| scored.departure(k));
        }
        not_passed(&planted)
    };
    assert_eq!(judged(1.0), Vec::<String>::new());
    assert_eq!(judged(1.05), ["error of GetFEM's own contact at its best, truncated-hertz"]);
}

#[test]
fn frozen_answers_are_of_the_present_meshes_and_judged_as_they_were_when_they_were_written() {
    for (case, numbers) in CASES.iter().zip(ALL.iter()) {
        assert_eq!(numbers.dofs[0], numbers.dofs[1], "{case}");
        for row in &numbers.rows {
            let (Ended::Answered { found, .. }, Ok(scored)) = (&row.told.ended, &row.scored) else { continue };
            for (now, then) in scored.scores.iter().zip(found) {
                assert!((now.value - then).abs() <= 1e-6 * then.abs(), "{case}, {:?}: {}", row.told, now.value);
            }
        }
    }
}

#[test]
fn a_code_that_solves_our_rows_is_not_judged_by_them_and_our_answer_is_read_as_theirs_are() {
    for (case, numbers) in CASES.iter().zip(ALL.iter()) {
        for code in Code::ALL {
            let own = numbers.own(code);
            assert!(own.iter().flatten().all(|row| row.setting.searched.is_some()), "{case}, {}", code.name());
            assert_eq!(own[1].is_some(), codes().any(|one| one == code), "{case}, {}", code.name());
        }
        let ours = numbers.ours.as_ref().expect("read");
        // Whoever solves our rows exactly finds our answer.
        let rows = numbers.best(|setting| setting.code == Code::Ngsolve && setting.searched.is_none());
        let theirs = rows.and_then(|row| row.scored.as_ref().ok()).expect("solved");
        for (ours, theirs) in ours.scores.iter().zip(&theirs.scores) {
            assert!(
                (ours.value - theirs.value).abs() <= 1e-3 * ours.value.abs(),
                "{case}: {} for {}",
                theirs.value,
                ours.value
            );
        }
    }
}
