//! Benchmark sheets bite: values that another code does not meet, and values without a bound, turn red.

use contact_vv::case::Verdict;
use contact_vv::study::Study;
use contact_vv::study::references::{Numbers, Sheet, solve};

fn green(sheet: &Sheet) -> bool {
    Numbers::Sheet(sheet.clone()).judge().expect("judged").iter().all(|one| one.verdict == Verdict::Pass)
}

#[test]
fn a_value_that_another_code_does_not_meet_turns_red() {
    let sound = solve("pin-rod").expect("solved");
    assert!(green(&sound));
    let asked: Vec<usize> = (0..sound.values.len()).filter(|&k| !sound.values[k].others.is_empty()).collect();
    assert_eq!(asked.len(), 2, "peak and second-moment width");
    for k in asked {
        for times in [0.996, 1.004, f64::NAN] {
            let mut spoiled = sound.clone();
            spoiled.values[k].value *= times;
            assert!(!green(&spoiled), "{} times {times}", sound.values[k].quantity);
            let mut spoiled = sound.clone();
            spoiled.values[k].others[0].1[0] *= times;
            assert!(!green(&spoiled), "theirs of {} times {times}", sound.values[k].quantity);
        }
    }
    let mut unknown = sound.clone();
    unknown.values.iter_mut().for_each(|value| value.bound = f64::NAN);
    assert!(!green(&unknown));
}
