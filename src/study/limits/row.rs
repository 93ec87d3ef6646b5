//! A row of the table of limits, and the table behind it.

/// Columns of the table of limits.
pub const HEAD: [&str; 5] =
    ["what is pushed", "range tried", "measured onset", "what the user sees", "what to do instead"];

/// One row of the table of limits.
#[derive(Clone, Debug)]
pub struct Limit {
    /// What is pushed.
    pub pushed: &'static str,
    /// From where to where.
    pub range: String,
    /// Where it began to fail.
    pub onset: String,
    /// What the program said there.
    pub seen: String,
    /// What to do instead.
    pub instead: String,
}

/// The values tried, one by one.
#[derive(Clone, Debug)]
pub struct Detail {
    /// What the table shows.
    pub title: &'static str,
    /// Names of the columns.
    pub head: Vec<String>,
    /// Cells.
    pub rows: Vec<Vec<String>>,
}

impl Limit {
    /// Its cells, in the order of `HEAD`.
    pub fn cells(self) -> Vec<String> {
        vec![self.pushed.into(), self.range, self.onset, self.seen, self.instead]
    }
}

impl Detail {
    /// A table from its title, its columns and its cells.
    pub(super) fn of(title: &'static str, head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Option<Self> {
        Some(Self { title, head: head.iter().map(|name| name.to_string()).collect(), rows: rows.into_iter().collect() })
    }
}
