//! A solve as one HTML file: well-formed, escaped, and complete.

use std::process::Command;

use crate::outputs::{contact_vv, json};
use crate::program::{Folder, ended};
use crate::scene_file::text_of;

/// Tags that are opened and not closed, or closed and not opened; what is no markup at all.
pub fn ill_formed(text: &str) -> Option<String> {
    let mut open: Vec<&str> = Vec::new();
    let mut pieces = text.split('<');
    pieces.next()?;
    for piece in pieces {
        let Some((tag, rest)) = piece.split_once('>') else { return Some(format!("no end: {piece:.60}")) };
        let entities = rest
            .split('&')
            .skip(1)
            .all(|one| ["amp;", "lt;", "gt;", "quot;", "apos;", "#"].iter().any(|e| one.starts_with(e)));
        let is_style = open.last() == Some(&"style");
        if !is_style && (rest.contains('>') || !entities) {
            return Some(format!("not escaped: {rest:.60}"));
        }
        let name = tag.split([' ', '\n']).next().unwrap_or_default();
        match name.strip_prefix('/') {
            _ if name.starts_with('!') || tag.ends_with('/') => {}
            Some(name) if open.pop() == Some(name) => {}
            Some(_) => return Some(format!("closed: {name}")),
            None => open.push(name),
        }
    }
    (!open.is_empty()).then(|| format!("open: {open:?}"))
}

/// A browser that shows no window, where one is installed.
fn browser() -> Option<&'static str> {
    let all = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
    all.into_iter().find(|name| Command::new(name).arg("--version").output().is_ok_and(|told| told.status.success()))
}

#[test]
fn a_solve_is_one_html_file_that_needs_nothing_else() {
    let folder = Folder::made();
    let title = "steel < 5 mm & \"{{input}}\"";
    let text = text_of("two-cylinders.toml");
    let line = text.lines().find(|line| line.starts_with("title")).expect("a title");
    let mine = folder.with("mine.toml", text.replace(line, &format!("title = '{title}'")));
    let html = folder.at("run.html");
    let (sound, _, error) = contact_vv(&["solve", &mine, "--html", &html]);
    assert!(sound, "{error}");
    let page = folder.read("run.html");
    assert_eq!(ill_formed(&page), None);
    assert!(page.contains("<p>steel &lt; 5 mm &amp; &quot;{{input}}&quot;</p>"), "escaped, and not filled in again");
    for outside in ["<script", " src=", "href=\"http", "url(http", "@import"] {
        assert!(!page.contains(outside), "{outside}");
    }
    let document = json(&["solve", &mine]);
    for list in ["error_bars", "checks"] {
        let key = if list == "checks" { "requirement" } else { "quantity" };
        for one in document[list].as_array().expect("a list") {
            let told = one[key].as_str().expect("a text").replace('<', "&lt;");
            assert!(page.contains(&told), "{told}");
        }
    }
    assert!(page.contains("<svg") && page.contains("prefers-color-scheme: dark") && page.contains("[[body]]"));
    // Written once more it replaces itself, and nothing else.
    assert!(contact_vv(&["solve", &mine, "--html", &html, "--no-error-bar"]).0);
    let (sound, _, error) = contact_vv(&["solve", &mine, "--html", &mine]);
    assert!(!sound && error.contains(".html"), "{error}");
    match browser() {
        None => println!("no Chromium is installed: the page was not opened in a browser"),
        Some(browser) => {
            let options = ["--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", &format!("file://{html}")];
            let (_, shown, _) = ended(Command::new(browser).args(options));
            assert!(["peak pressure", "</svg>", "</html>"].iter().all(|part| shown.contains(part)), "{shown:.500}");
        }
    }
}
