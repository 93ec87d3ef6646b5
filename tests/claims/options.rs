//! Options of `solve` that may be combined are combined: every pair of their values in some run.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use contact_vv::checkout::root;

use crate::outputs::contact_vv;
use crate::program::{Folder, ended, program};
use crate::scene_file::folder;

/// What is chosen, and its values; an empty one is left out. What excludes one another is values of one choice.
const CHOICES: [&[&str]; 16] = [
    &["--element node", "--element layer", "--element line"],
    &[
        "",
        "--rule penalty",
        "--algorithm constant",
        "--algorithm constant --rule correction --acceleration none",
        "--algorithm varying",
        "--algorithm varying --bound 10 --acceleration none",
        "--algorithm varying --spring element --bound inf",
        "--algorithm varying --rule correction",
    ],
    &[
        "--resolution 4",
        "--resolution 4 --order 1",
        "--fitted",
        "--fitted --order 4",
        "--accuracy 5%",
        "--accuracy 5% --max-dofs 20000",
    ],
    &["", "--a-over-r 0.1"],
    &["", "--criterion conditions", "--criterion residuals", "--criterion displacement", "--criterion state"],
    &["", "--increments 3 --curve curve.csv", "--increments 2 --curve curve.json", "--increments 2"],
    &["", "--tolerance 1e-2"],
    &["", "--max-iterations 50"],
    &["", "--stiffness 1", "--stiffness 1e4"],
    &["", "--layer-thickness 0.5"],
    &["", "--no-error-bar"],
    &["--json found.json", "--json found.json --force"],
    &["", "--csv profile.csv", "--vtu fields.vtu"],
    &["", "--plot drawn.svg"],
    &["", "--html page.html"],
    &["", "--all"],
];

type Pair = [(usize, usize); 2];

/// Rows of one value a choice, until every pair of values of two choices stands in one: each row begins with a pair
/// that is left, and takes from each further choice what covers the most of them (Cohen et al. 1997).
fn rows() -> Vec<Vec<usize>> {
    let values = |choice: usize| (0..CHOICES[choice].len()).map(move |value| (choice, value));
    let below = |choice: usize| (0..choice).flat_map(values);
    let mut left: BTreeSet<Pair> = (0..CHOICES.len())
        .flat_map(|choice| values(choice).flat_map(move |one| below(choice).map(move |other| [other, one])))
        .collect();
    let mut rows = Vec::new();
    while let Some(&[first, second]) = left.first() {
        let mut row = vec![first, second];
        for choice in (0..CHOICES.len()).filter(|choice| ![first.0, second.0].contains(choice)) {
            let covers = |one: &(usize, usize)| {
                row.iter().filter(|&&other| left.contains(&[other.min(*one), other.max(*one)])).count()
            };
            // The first of equals.
            let best = values(choice).rev().max_by_key(covers).expect("a value");
            row.push(best);
        }
        row.sort_unstable();
        for (k, &one) in row.iter().enumerate() {
            left.retain(|pair| pair[1] != one || !row[..k].contains(&pair[0]));
        }
        rows.push(row.into_iter().map(|(_, value)| value).collect());
    }
    rows
}

/// Peak pressure of Hertz [MPa].
fn hertz(arguments: &[&str]) -> f64 {
    210e3 / (1.0 - 0.3 * 0.3) * if arguments.contains(&"--a-over-r") { 0.1 } else { 0.05 } / 2.0
}

/// A mistake in a run.
fn wrong(arguments: &[&str]) -> Option<String> {
    let folder = Folder::made();
    let (code, _, told) = ended(program(&["solve", "cylinder"]).args(arguments).current_dir(folder.path()));
    // A start that lets go of the body is an ending of the iteration.
    if code == Some(2) && told.contains("no contact spring is left after iteration") {
        return None;
    }
    if !matches!(code, Some(0 | 1 | 3)) {
        return Some(format!("ended with {code:?}: {told}"));
    }
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap_or_default();
    for name in arguments.iter().filter(|name| name.contains('.') && !name.starts_with(|c: char| c.is_ascii_digit())) {
        let text = read(name);
        let sound = match name.rsplit('.').next() {
            Some("json") => serde_json::from_str::<serde_json::Value>(&text).is_ok(),
            Some("svg") => text.starts_with("<svg") && !text.contains("NaN"),
            Some("html") => {
                text.starts_with("<!DOCTYPE html>") && text.trim_end().ends_with("</html>") && text.contains("<svg")
            }
            Some("vtu") => text.contains("<VTKFile") && text.contains("contact_pressure"),
            _ => text.lines().count() > 1,
        };
        if !sound {
            return Some(format!("{name} is {text:.200}"));
        }
    }
    let found: serde_json::Value = serde_json::from_str(&read("found.json")).expect("read before");
    let converged = found["outcome"] == "converged";
    if converged == (code == Some(3)) {
        return Some(format!("{} ended with {code:?}", found["outcome"]));
    }
    // What is called converged is near the truth: within what the coarsest of these meshes and the softest penalty
    // leave.
    let peak = found["contacts"][0]["peak_pressure"].as_f64().unwrap_or(f64::NAN);
    let off = (peak / hertz(arguments) - 1.0).abs();
    let soft = arguments.contains(&"penalty");
    let is_near = off <= 0.08;
    (converged && !soft && !is_near).then(|| format!("peak {peak} is off by {off}"))
}

#[test]
fn any_two_options_that_may_be_combined_solve_and_write_what_is_asked_for() {
    let rows = rows();
    let pairs = |row: &[usize]| row.iter().enumerate().map(|(choice, value)| (choice, *value)).collect::<Vec<_>>();
    assert!((40..90).contains(&rows.len()), "{} runs", rows.len());
    let mistakes: Vec<String> = rows
        .iter()
        .filter_map(|row| {
            let values = pairs(row).into_iter().map(|(choice, value)| CHOICES[choice][value]);
            let arguments: Vec<&str> = values.flat_map(str::split_whitespace).collect();
            wrong(&arguments).map(|mistake| format!("{}: {mistake}", arguments.join(" ")))
        })
        .collect();
    assert!(mistakes.is_empty(), "{} of {}:\n{}", mistakes.len(), rows.len(), mistakes.join("\n"));
}

#[test]
fn what_cannot_be_solved_or_written_is_refused_before_anything_is_solved_with_what_can() {
    let text = fs::read_to_string(root().join("tests/data/refused-options.toml")).expect("the options");
    let all: BTreeMap<String, Vec<Vec<String>>> = toml::from_str(&text).expect("TOML");
    for row in &all["refused"] {
        let [arguments, says @ ..] = &row[..] else { panic!("{row:?}") };
        let mut command = program(&[]);
        let command = command.args(arguments.split_whitespace()).current_dir(folder()).env("COLUMNS", "1000");
        let (code, text, told) = ended(command);
        assert_eq!((code, text.as_str()), (Some(2), ""), "{arguments}: {told}");
        assert!(says.iter().all(|part| told.contains(part)), "{arguments}: {told}");
    }
}

#[test]
fn accuracy_is_met_where_a_loose_iteration_leaves_points_pressed() {
    let (met, text, _) = contact_vv(&["solve", "cylinder", "--algorithm", "varying", "--accuracy", "5%"]);
    assert!(met, "{text}");
}
