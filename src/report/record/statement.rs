//! A row per statement of the paper, in the order of the page.

use serde::{Deserialize, Serialize};

use crate::study::paper::statement::Statement;

/// A statement as the record has it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct StatementRow {
    /// What the paper says.
    pub statement: String,
    /// The judgement.
    pub judgement: String,
    /// What was measured.
    pub measured: String,
}

impl StatementRow {
    pub(super) fn of(statement: &Statement) -> Self {
        Self {
            statement: statement.text.into(),
            judgement: statement.judgement.to_string(),
            measured: statement.measured.clone(),
        }
    }
}
