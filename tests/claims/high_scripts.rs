//! Reference answers that scripts of `oracles/high` found too: what is frozen is of the present scripts, of our scenes, and of two ways that agree.

use std::collections::{BTreeMap, BTreeSet};

use contact_vv::checkout::root;
use contact_vv::oracle::cross_code::frozen::hash_of;
use contact_vv::oracle::cross_code::high::{ASK_AGAIN, High, Way};
use contact_vv::oracle::cross_code::independent::Independent;

/// Trials of the study `references`, and the scene of the independent scripts of which the numbers are.
const SCENES: [(&str, &str); 5] = [
    ("cylinder", "cylinder, a/R = 0.05"),
    ("cylinder, a/R = 0.1", "cylinder, a/R = 0.1"),
    ("cylinder-between-plates", "cylinder, a/R = 0.05"),
    ("pin-plate", "pin in plate"),
    ("pin-rod", "pin-rod"),
];

fn frozen() -> High {
    High::built_in().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn frozen_answers_of_high_order_are_those_of_the_scripts() {
    let scripts = hash_of(&root().join("oracles/high")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(frozen().scripts, scripts, "{ASK_AGAIN}");
}

#[test]
fn scenes_of_high_order_are_ours() {
    let (frozen, ours) = (frozen(), Independent::built_in().unwrap_or_else(|error| panic!("{error}")));
    assert_eq!(frozen.scenes.keys().map(String::as_str).collect::<Vec<_>>(), SCENES.map(|(name, _)| name));
    for (name, of) in SCENES {
        assert_eq!(frozen.scenes[name].scene.numbers, ours.scenes[of].scene.numbers, "{name}");
        assert!(name.starts_with(&frozen.scenes[name].scene.case), "{name}");
    }
}

#[test]
fn both_ways_of_high_order_tell_the_same_numbers_within_what_they_may_be_off() {
    for (name, asked) in frozen().scenes {
        let [boundary, elements] =
            Way::ALL.map(|way| asked.answers.get(&way).unwrap_or_else(|| panic!("{name}: {way:?}")));
        let told = |numbers: &BTreeMap<String, [f64; 2]>| numbers.keys().cloned().collect::<BTreeSet<_>>();
        assert_eq!(told(&boundary.numbers), told(&elements.numbers), "{name}");
        assert!(told(&boundary.numbers).len() >= 5, "{name}: {:?}", told(&boundary.numbers));
        for (key, [value, bound]) in &boundary.numbers {
            let [other, off] = elements.numbers[key];
            assert!((value - other).abs() <= bound + off, "{name}, {key}: {value} ± {bound:e}, {other} ± {off:e}");
            let scale = if key == "peak-place" { boundary.numbers["end"][0] } else { value.abs() };
            assert!(bound + off <= 1e-6 * scale, "six digits of {name}, {key}: ± {bound:e}, ± {off:e}");
        }
    }
}
