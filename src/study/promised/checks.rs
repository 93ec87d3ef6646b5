//! Whether the error bars of the suite's own checks hold.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::markdown::{self, Column};

/// Share of the checks whose error may be beyond its bar.
const SHARE: f64 = 0.05;

/// How many of some checks, each with the title of its trial, have a bar beside a closed form; and those of them whose true error is
/// beyond the bar and what the closed form itself may be off, or whose bar is not known.
pub(super) fn barred<'a>(checks: impl IntoIterator<Item = (String, &'a Judged)>) -> (usize, Vec<(String, Judged)>) {
    let barred = checks.into_iter().filter(|(_, one)| one.is_within_bar().is_some());
    let mut barred: Vec<(String, Judged)> = barred.map(|(trial, one)| (trial, one.clone())).collect();
    let all = barred.len();
    barred.retain(|(_, one)| one.is_within_bar() == Some(false));
    (all, barred)
}

/// The check; it fails where there is nothing to judge.
pub(super) fn judge(all: usize, outside: &[(String, Judged)]) -> Vec<Judged> {
    let share = outside.len() as f64 / all as f64;
    let quantity = Quantity::at(
        "share of checks against closed forms whose true error is beyond its bar, or whose bar is not known",
        format!("of {all}"),
    );
    let because = "a bar holds for 95 of 100 numbers; those beyond are listed";
    vec![Check::at_most(quantity, Reference::analytic("closed forms", SHARE), because).judge(share)]
}

/// The table of checks beyond their bars.
const COLUMNS: [Column<(String, Judged)>; 7] = [
    ("trial", |(trial, _)| trial.clone()),
    ("quantity", |(_, one)| one.check.quantity.to_string()),
    ("closed form", |(_, one)| one.reference.name.clone()),
    ("error", |(_, one)| markdown::error(one.error)),
    ("bar", |(_, one)| one.bar_as_error().filter(|bar| !bar.is_nan()).map_or("unknown".into(), markdown::error)),
    ("model error stated", |(_, one)| match one.check.model {
        model if model > 0.0 => markdown::error(model),
        _ => "–".into(),
    }),
    ("because", |(_, one)| one.check.because.to_string()),
];

/// The section: the checks beyond their bars.
pub(super) fn section(all: usize, outside: &[(String, Judged)]) -> String {
    let table = if outside.is_empty() { String::new() } else { markdown::columns(&COLUMNS, outside) };
    let unknown = outside.iter().filter(|(_, one)| !one.has_known_bar()).count();
    format!(
        "## Error bars beside checks\n\n\
         Every check of a case that holds a number with an error bar against a closed form shows that bar in its table. Of {all} \
         {} have a true error beyond the sum of the bar and the model error that the case states of its closed form, and {unknown} a bar that is not known{}\n\n{table}\n",
        outside.len() - unknown,
        if outside.is_empty() { "." } else { ":" }
    )
}
