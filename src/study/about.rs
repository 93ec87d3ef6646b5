//! What a study is called, what it asks, and what it cannot tell: no number, no judgement.

/// What the page of a study says of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct About {
    /// Title of its page.
    pub title: &'static str,
    /// What it asks, as a clause: whether, how, which.
    pub asked: &'static str,
    /// What it cannot tell.
    pub limits: &'static str,
}
