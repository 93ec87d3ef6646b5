//! One thing that is told.

/// A heading that counts, rows from the most to the least important, charts to look at.
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
    pub fn new(heading: String, rows: Vec<String>) -> Self {
        Self { heading, rows, charts: Vec::new() }
    }
}
