//! Links to pages, and those of a text that is read elsewhere than it was written for.

/// The folder of the pages, from the root.
pub const PAGES: &str = "snapshots/pages";
/// The folder of the charts.
pub const CHARTS: &str = "snapshots/charts";

/// How a link to a generated file begins: in Markdown, and in HTML.
const BEGINNINGS: [&str; 3] = ["](", "=\"", "=\'"];

/// The text of a study, whose links start at the root, for the folder of pages.
pub fn from_pages(text: &str) -> String {
    BEGINNINGS
        .iter()
        .fold(text.to_string(), |text, begin| text.replace(&format!("{begin}snapshots/"), &format!("{begin}../")))
}

/// A link from the root to a page by its file.
pub fn to_page(text: &str, file: &str) -> String {
    format!("[{text}]({PAGES}/{file})")
}
