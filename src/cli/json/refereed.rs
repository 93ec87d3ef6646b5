//! The verdicts on an answer as JSON.

use schemars::JsonSchema;
use serde::Serialize;

use crate::referee::{Truth, Verdicts};

use super::Checked;

/// The verdicts on an answer: a line of `judge --json`.
#[derive(Serialize, JsonSchema)]
pub struct Refereed {
    /// The file of the answer.
    answer: String,
    /// Name of the case.
    case: String,
    /// The code, where the answer says so.
    code: Option<String>,
    /// Whether nothing that could be judged failed.
    met: bool,
    /// Every check, contact by contact.
    checks: Vec<Checked>,
    /// Usual mistakes that explain what is not met.
    mistakes: Vec<String>,
    /// What could not be judged.
    missing: Vec<Missing>,
    /// What the closed forms of the case say that our own run contradicts, and what makes the answer another one than may be meant.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
}

/// Something that could not be judged.
#[derive(Serialize, JsonSchema)]
struct Missing {
    /// What.
    what: String,
    /// What to hand in for it.
    hand_in: String,
}

impl Refereed {
    /// What was found of an answer.
    pub fn of(truth: &Truth, found: &Verdicts) -> Self {
        let of = |[what, hand_in]: [String; 2]| Missing { what, hand_in };
        let missing = found.ruled.iter().flat_map(|ruled| ruled.missing.clone()).map(of);
        let absent = found.absent.iter().map(|name| of([format!("contact `{name}`"), "its points".into()]));
        Self {
            answer: found.answer.file.display().to_string(),
            case: truth.case.name.clone(),
            code: found.answer.code.clone(),
            met: found.met(),
            checks: found.ruled.iter().flat_map(|ruled| &ruled.judged).map(Checked::of).collect(),
            mistakes: found.mistakes.clone(),
            missing: missing.chain(absent).collect(),
            notes: found.notes.clone(),
        }
    }
}
