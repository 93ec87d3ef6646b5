//! What the terminal shows: lines, errors and a bar of progress.

use std::io::Write;

use comfy_table::{ContentArrangement, Table, presets};
use indicatif::{ProgressBar, ProgressStyle};
use miette::GraphicalReportHandler;

use crate::cli::excerpt::Excerpt;
use crate::error::Error;

/// Prints an error; one in a file with the lines around it.
pub fn show(error: &Error) {
    let mut text = String::new();
    let draw = |excerpt: Excerpt| GraphicalReportHandler::new().render_report(&mut text, &excerpt).is_ok();
    if !Excerpt::of(error).is_some_and(draw) {
        text = format!("error: {}\n help: {}", error.finding(), error.remedy);
    }
    eprintln!("{text}");
}

/// Prints a line; a reader who has gone away (a closed pipe) is no error.
pub fn say(line: impl std::fmt::Display) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

/// Columns of the terminal; without one those that `COLUMNS` names, or 100, as the help has it.
pub fn width() -> u16 {
    let named = || std::env::var("COLUMNS").ok()?.parse().ok();
    terminal_size::terminal_size().map(|(width, _)| width.0).or_else(named).unwrap_or(100)
}

/// A table no wider than the terminal.
pub fn table<'a>(head: impl IntoIterator<Item = &'a str>) -> Table {
    table_on(width(), head)
}

/// A table no wider than so many columns.
pub fn table_on<'a>(columns: u16, head: impl IntoIterator<Item = &'a str>) -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic).set_width(columns);
    table.set_header(head);
    table
}

/// A bar over so many pieces of work, on a terminal.
pub fn progress(pieces: usize) -> ProgressBar {
    let bar = ProgressBar::new(pieces as u64);
    match ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
