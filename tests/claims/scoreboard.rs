//! The scoreboard is computed from files as other codes wrote them: what is planted in them, or in the record, is found.

use std::sync::LazyLock;

use contact_vv::case::Verdict;
use contact_vv::study::Study;
use contact_vv::study::scoreboard::board::{Board, Code, Contact, Ended};
use contact_vv::study::scoreboard::{CASES, Numbers, named, numbers};

use crate::workbench::spoiled;

fn of(case: &str, board: &Board) -> Numbers {
    numbers(case, &named(case).expect("a case"), board).expect("judged")
}

/// All cases as they are frozen.
static ALL: LazyLock<[Numbers; CASES.len()]> = LazyLock::new(|| {
    let board = Board::load().expect("frozen");
    CASES.map(|case| of(case, &board))
});

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
                let file = if let Ended::Answered { file, .. } = &row.told.ended { file.as_str() } else { "" };
                row.setting.code.name() == code && file.ends_with(ending) && row.scored.is_ok()
            })
        });
        assert!(read.count() >= 5, "{code} {ending}");
    }
}

#[test]
fn what_is_planted_in_the_record_or_the_files_turns_a_check_of_the_scoreboard_red() {
    let board = Board::load().expect("frozen");
    let sound = of("bars", &board);
    assert_eq!(not_passed(&sound), Vec::<String>::new());
    let with = |spoil: &dyn Fn(&mut Board)| not_passed(&of("bars", &spoiled(&board, spoil)));
    let scripts = with(&|board| board.scripts.values_mut().for_each(|hash| hash.push('0')));
    assert_eq!(scripts, ["scripts changed since their answers were frozen, bars"]);
    let lost = with(&|board| drop(board.cases.get_mut("bars").expect("asked").runs.pop()));
    assert_eq!(lost.len(), 2, "{lost:?}");
    let unread = with(&|board| {
        if let Ended::Answered { file, .. } = &mut board.cases.get_mut("bars").expect("asked").runs[0].ended {
            file.push_str(".absent");
        }
    });
    assert_eq!(unread, ["frozen answers that cannot be read, bars"]);
    let none = Numbers { rows: vec![], ..sound };
    assert_eq!(not_passed(&none).len(), 2);
}

#[test]
fn the_best_setting_is_the_one_with_the_least_that_is_not_met() {
    for (case, numbers) in CASES.iter().zip(ALL.iter()) {
        for code in Code::ALL {
            let Some(best) = numbers.best(|setting| setting.code == code) else { continue };
            let own = numbers.rows.iter().filter(|row| row.setting.code == code);
            assert_eq!(own.map(|row| row.not_met()).min(), Some(best.not_met()), "{case}, {}", code.name());
        }
    }
}

#[test]
fn frozen_answers_are_of_the_present_meshes_and_judged_as_they_were_when_they_were_written() {
    for (case, numbers) in CASES.iter().zip(ALL.iter()) {
        assert_eq!(numbers.dofs[0], numbers.dofs[1], "{case}");
        for row in &numbers.rows {
            let (Ended::Answered { file, found, .. }, Ok(scored)) = (&row.told.ended, &row.scored) else { continue };
            for (now, then) in scored.scores.iter().zip(found) {
                assert!((now.value - then).abs() <= 1e-6 * then.abs(), "{file}: {} for {then}", now.value);
            }
        }
    }
}

#[test]
fn a_code_that_solves_our_rows_is_not_judged_by_them_and_our_answer_is_read_as_theirs_are() {
    for (case, numbers) in CASES.iter().zip(ALL.iter()) {
        for code in Code::ALL {
            let own = numbers.own(code);
            assert!(own.iter().flatten().all(|row| row.setting.contact != Contact::OurRows), "{case}, {}", code.name());
            let has_none = [Code::ScikitFem, Code::Dolfinx].contains(&code);
            assert_eq!(own[1].is_none(), has_none, "{case}, {}", code.name());
        }
        let ours = numbers.ours.as_ref().expect("read");
        // Whoever solves our rows exactly finds our answer.
        let rows = numbers.best(|setting| setting.code == Code::Ngsolve && setting.contact == Contact::OurRows);
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
