//! A number as JSON has it.

use schemars::JsonSchema;
use serde::Serialize;

/// A number; null where it is not known, or has no limit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, JsonSchema)]
#[serde(transparent)]
pub struct Number(Option<f64>);

impl Number {
    /// The number itself; NaN where it is null.
    pub fn value(self) -> f64 {
        self.0.unwrap_or(f64::NAN)
    }
}

impl From<f64> for Number {
    fn from(number: f64) -> Self {
        Some(number).into()
    }
}

impl From<Option<f64>> for Number {
    fn from(number: Option<f64>) -> Self {
        Self(number.filter(|number| number.is_finite()))
    }
}
