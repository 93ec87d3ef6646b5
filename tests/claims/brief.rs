//! What `solve` prints where nothing else is asked for.

use crate::outputs::{contact_vv, json, scene};
use crate::program::{ended, program};

/// What is printed on 80 columns.
fn printed(arguments: &[&str]) -> String {
    ended(program(arguments).env("COLUMNS", "80")).1
}

/// The numbers of a text, and what follows ± where something does.
fn numbers(text: &str) -> Vec<f64> {
    text.split(' ').filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn solve_prints_the_numbers_one_quotes_rounded_to_their_bars_on_80_columns() {
    for case in ["cylinder", "sphere", "press-fit", "flat-punch", "roller-between-plates", "eccentric-load", "pin-rod"]
    {
        let of_library = ["cylinder", "sphere", "pin-rod"].contains(&case);
        let case = if of_library { case.to_owned() } else { scene(case) };
        let (text, document) = (printed(&["solve", &case]), json(&["solve", &case]));
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
        // Words are whole: those of the title stand in a line each, or beside one another.
        let words: Vec<&str> = text.split_whitespace().collect();
        let (_, all, _) = contact_vv(&["solve", &case, "--all"]);
        let title = all.lines().next().and_then(|line| line.split_once(": ")).expect("a title").1;
        assert!(title.split_whitespace().all(|word| words.contains(&word)), "{title}: {text}");
        assert!(text.lines().count() < all.lines().count() && all.contains("equilibrium: "), "{text}");
        // No power of ten, no digit beyond a bar, no line twice within a contact.
        assert!(
            !words.iter().any(|word| word.contains("e-") && word.parse::<f64>().is_ok_and(|x| x.abs() < 1e-6)),
            "{text}"
        );
        let contacts = document["contacts"].as_array().expect("contacts");
        let rows = |name: &str| text.lines().filter(|line| line.trim_start().starts_with(name)).collect::<Vec<_>>();
        let peaks = rows("peak pressure");
        assert_eq!(peaks.len(), contacts.len(), "{text}");
        for (line, contact) in peaks.into_iter().zip(contacts) {
            let Some(peak) = contact["peak_pressure"].as_f64() else {
                assert!(line.contains("without limit"), "{line}");
                continue;
            };
            let [told, bar, ..] = numbers(line)[..] else { panic!("{line}") };
            assert!((told - peak).abs() <= 0.1 * bar && bar < 0.1 * peak, "{line}: {peak}");
        }
        for body in document["bodies"].as_array().expect("bodies") {
            let name = format!("`{}` ", body["name"].as_str().expect("a name"));
            let (_, line) = text.split_once(&name).expect("a line of the body");
            match body["von_mises"].as_f64() {
                None => assert!(line.starts_with("without limit"), "{line}"),
                Some(stress) => {
                    let [told, bar, ..] = numbers(line)[..] else { panic!("{line}") };
                    assert!((told - stress).abs() <= 0.1 * bar && bar < 0.2 * stress, "{line}: {stress}");
                }
            }
        }
    }
}
