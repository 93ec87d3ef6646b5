//! All that is printed as JSON: one type, and its published schema.
//!
//! * [`solved`] — the result of `solve`; [`contact`] — what one contact came to; [`oracle`] — what an oracle reads.
//! * [`checked`] — a check with its numbers and its verdict, of `solve`, `verify` and `verdicts` alike.
//! * [`refereed`] — the verdicts on the answer of another code.
//! * [`compared`] — formulations of one scene side by side.

pub mod checked;
pub mod compared;
pub mod contact;
pub mod oracle;
pub mod refereed;
pub mod solved;

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde::Serialize;

pub use checked::{Checked, Line};
pub use compared::{Compared, Compares};
pub use oracle::OracleReading;
pub use refereed::Refereed;
pub use solved::Solved;

/// A case of the library.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Listed {
    /// Its name, as `solve` takes it.
    pub name: &'static str,
    /// What it is.
    pub title: &'static str,
}

/// What contact-vv prints as JSON.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Answer<'a> {
    /// Of `solve --json`: one document.
    Solved(Box<Solved<'a>>),
    /// Of `compare --json`: one document.
    Compared(Box<Compared>),
    /// Of `verdicts` and `verify --json`: a line for each check.
    Line(Box<Line>),
    /// Of `judge --json`: a line for each answer.
    Refereed(Box<Refereed>),
    /// Of `list --json`: one document.
    Listed(Vec<Listed>),
}

impl Answer<'_> {
    /// As one document of several lines.
    pub fn document(&self) -> String {
        serde_json::to_string_pretty(self).expect("numbers, strings and lists can be written as JSON")
    }

    /// As one line.
    pub fn line(&self) -> String {
        serde_json::to_string(self).expect("numbers, strings and lists can be written as JSON")
    }
}

/// Whether a text is a result of `solve`.
pub fn is_result(text: &str) -> bool {
    has(text, &["case", "outcome", "seconds", "contacts"])
}

/// Whether a text is a result of `compare`.
pub fn is_comparison(text: &str) -> bool {
    has(text, &["case", "retained", "formulations"])
}

fn has(text: &str, keys: &[&str]) -> bool {
    let found = serde_json::from_str::<serde_json::Value>(text);
    found.is_ok_and(|found| keys.iter().all(|key| found.get(key).is_some()))
}

/// The schema of all that is printed as JSON (JSON Schema, draft 7).
pub fn schema() -> String {
    let settings = SchemaSettings::draft07().for_serialize().with_transform(RecursiveTransform(or_null));
    let schema = settings.into_generator().into_root_schema_for::<Answer>();
    serde_json::to_string_pretty(&schema).expect("a schema can be written as JSON")
}

/// Says that null may stand where a number may: JSON has neither NaN nor infinity, so that null is a number that is not
/// known, or has no limit.
fn or_null(schema: &mut Schema) {
    if schema.get("type").is_some_and(|kind| kind == "number") {
        schema.insert("type".into(), ["number", "null"].into());
    }
}
