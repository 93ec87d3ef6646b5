//! One thing that is told: a heading that counts, rows from the most to the least important, charts to look at.

/// One thing that is told.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Told {
    /// What moved and how much of it: complete without the rows.
    pub heading: String,
    /// The rows, the most important first.
    pub rows: Vec<String>,
    /// Paths of charts to be seen before and after.
    pub charts: Vec<String>,
}

impl Told {
    /// A heading with rows.
    pub fn new(heading: impl Into<String>, rows: Vec<String>) -> Self {
        Self { heading: heading.into(), rows, charts: Vec::new() }
    }
}
