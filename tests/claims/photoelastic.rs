//! The comparison with a photograph bites: spoiled readings, spoiled fields and far-off widths turn red.

use std::fs;

use contact_vv::case::Verdict;
use contact_vv::oracle::digitised::fringes::{End, Fringe, file, read};
use contact_vv::study::measured::photograph::{Photograph, compare, judge};

use crate::program::Folder;

/// Which of the checks do not pass.
fn red(photograph: &Photograph) -> Vec<usize> {
    let judged = judge(photograph);
    (0..judged.len()).filter(|&k| judged[k].verdict != Verdict::Pass).collect()
}

#[test]
fn the_photograph_agrees_and_every_spoiled_number_turns_red() {
    let sound = compare(&read(&file()).expect("fringes")).expect("compared");
    assert_eq!(red(&sound), Vec::<usize>::new());
    type Spoil = (usize, fn(&mut Photograph));
    let spoils: [Spoil; 7] = [
        (0, |n| n.ends[0].2 = 0.036),
        (1, |n| n.ends[1].2 = 0.036),
        (1, |n| n.ends[1].2 = f64::NAN),
        (2, |n| n.widths.iter_mut().for_each(|width| width[1] = 0.034)),
        (3, |n| n.widths.retain(|width| width[0] < 0.053)),
        (4, |n| n.mesh[0] = 0.011),
        (4, |n| n.mesh[0] = f64::NAN),
    ];
    for (check, spoil) in spoils {
        let mut spoiled = sound.clone();
        spoil(&mut spoiled);
        assert!(red(&spoiled).contains(&check), "check {check}: {:?}", red(&spoiled));
    }
}

#[test]
fn readings_that_are_moved_turn_red() {
    let fringes = read(&file()).expect("fringes");
    let moved = |spoil: fn(&mut Fringe)| {
        let mut all = fringes.clone();
        all.iter_mut().for_each(spoil);
        red(&compare(&all).expect("compared"))
    };
    // Each end has a check of its own, the bottom first.
    let places = moved(|fringe| match fringe.end {
        End::Top => fringe.half_spacing *= 1.08,
        End::Bottom => fringe.depth *= 1.3,
    });
    let orders = moved(|fringe| match fringe.end {
        End::Top => fringe.order *= 1.05,
        End::Bottom => fringe.order = 2.0,
    });
    assert!([places, orders].iter().all(|red| red.contains(&0) && red.contains(&1)));
}

#[test]
fn bad_rows_of_the_file_are_refused_with_their_line() {
    let text = fs::read_to_string(file()).expect("readable");
    let folder = Folder::made();
    let refused = |text: &str| read(folder.with("fringes.csv", text).as_ref()).expect_err("refused").to_string();
    let second = |replace: &[(usize, &str)]| {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let mut fields: Vec<&str> = lines[1].split(',').collect();
        replace.iter().for_each(|&(k, to)| fields[k] = to);
        lines[1] = fields.join(",");
        lines.join("\n")
    };
    for bad in [(1, "1.5"), (1, "nan"), (3, "0"), (4, "-0.1")] {
        assert!(refused(&second(&[bad])).contains("line 2"), "{bad:?}");
    }
    for bad in [(0, "left"), (2, "X"), (3, "one")] {
        assert!(refused(&second(&[bad])).contains("fringes.csv"), "{bad:?}");
    }
    assert!(refused(text.lines().next().expect("a header")).contains("no fringe"));
    assert!(read(&folder.path().join("none.csv")).is_err());
}
