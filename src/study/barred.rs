//! Whether the error bars of the suite's own checks hold.

use serde::Serialize;

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown;
use crate::study::about::About;
use crate::study::{Found, Planned};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Error bars beside checks",
    asked: "Whether the checks of this suite have errors within their own bars.",
    limits: "Only checks against closed forms have a true error to look at.",
};

/// No trial of its own.
pub fn plan() -> Vec<Planned<Numbers>> {
    Vec::new()
}

/// Checks with error bars.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// All of them.
    pub all: usize,
    /// Those whose true error is beyond the bar and what the closed form itself may be off.
    pub outside: Vec<Outside>,
}

/// A check whose true error is beyond its bar, or has a bar that is not known.
#[derive(Clone, Debug, Serialize)]
pub struct Outside {
    /// Title of the trial.
    pub trial: String,
    /// What was judged.
    pub quantity: String,
    /// The closed form.
    pub reference: String,
    /// The error, as the check has it.
    pub error: f64,
    /// The bar in the same terms; NaN where it is not known.
    pub bar: f64,
    /// What the closed form itself may be off, in the same terms.
    pub model: f64,
    /// Why the check has the tolerance that it has.
    pub because: String,
}

impl Numbers {
    /// Those of some checks, each with the title of its trial.
    pub fn of<'a>(checks: impl IntoIterator<Item = (String, &'a Judged)>) -> Self {
        let mut numbers = Self { all: 0, outside: Vec::new() };
        for (trial, judged) in checks {
            let (Some(bar), Some(is_within)) = (judged.bar_as_error(), judged.is_within_bar()) else { continue };
            numbers.all += 1;
            if !is_within {
                numbers.outside.push(Outside {
                    trial,
                    quantity: judged.check.quantity.to_string(),
                    reference: judged.reference.name.clone(),
                    error: judged.error,
                    bar,
                    model: judged.check.model,
                    because: judged.check.because.to_string(),
                });
            }
        }
        numbers
    }
}

/// Share of the checks whose error may be beyond its bar.
pub const SHARE: f64 = 0.05;

/// The check; it fails where there is nothing to judge.
pub fn judge(Numbers { all, outside }: &Numbers) -> Result<Vec<Judged>, Error> {
    let share = outside.len() as f64 / *all as f64;
    let quantity =
        Quantity::at("share of checks against closed forms whose true error is beyond its bar", format!("of {all}"));
    let because = "a bar holds for 95 of 100 numbers; those beyond are listed";
    Ok(vec![Check::at_most(quantity, Reference::analytic("closed forms", SHARE), because).judge(share)])
}

/// Columns.
const HEAD: [&str; 7] = ["trial", "quantity", "closed form", "error", "bar", "model error stated", "because"];

/// The section.
pub fn section(findings: &[Found<Numbers>]) -> Result<String, Error> {
    let outside: Vec<&Outside> = findings.iter().flat_map(|found| &found.numbers.outside).collect();
    let all: usize = findings.iter().map(|found| found.numbers.all).sum();
    let rows: Vec<Vec<String>> = outside.iter().map(|one| row(one)).collect();
    let table = if rows.is_empty() { String::new() } else { markdown::table(&HEAD.map(String::from), &rows) };
    Ok(format!(
        "Every check of a case that holds a number with an error bar against a closed form shows that bar in its table. {} of {all} \
         have a true error beyond the sum of the bar and the model error that the case states of its closed form, or a bar that is not known{}\n\n{table}\n",
        outside.len(),
        if rows.is_empty() { "." } else { ":" }
    ))
}

/// No chart.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}

fn row(one: &Outside) -> Vec<String> {
    let bar = if one.bar.is_nan() { "unknown".into() } else { markdown::error(one.bar) };
    let model = if one.model > 0.0 { markdown::error(one.model) } else { "–".into() };
    let Outside { trial, quantity, reference, error, because, .. } = one;
    vec![trial.clone(), quantity.clone(), reference.clone(), markdown::error(*error), bar, model, because.clone()]
}
