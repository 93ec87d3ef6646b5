//! The checks against closed forms that have an error bar, and those whose error is beyond it.

use serde::Serialize;

use crate::case::Judged;

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
