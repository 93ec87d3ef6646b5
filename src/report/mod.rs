//! What the results look like on the page.
pub mod figure;
