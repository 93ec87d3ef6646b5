//! What the terminal shows: lines, errors and a bar of progress.

use std::io::{ErrorKind, IsTerminal, Write};

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use comfy_table::{ColumnConstraint, ContentArrangement, Table, Width, presets};
use indicatif::{ProgressBar, ProgressStyle};

use crate::cli::exit::WRONG_INPUT;
use crate::error::{Error, Located, Place};

/// Prints an error; one in a text file with the line that it is in.
pub fn show(error: &Error) {
    match &error.place {
        Place::Line(located) => eprintln!("{}", excerpt(error, located, std::io::stderr().is_terminal())),
        _ => eprintln!("error: {}\n help: {}", error.finding(), error.remedy),
    }
}

/// An error in a text file, its line with the place marked, and the remedy below.
fn excerpt(error: &Error, Located { file, text, place }: &Located, styled: bool) -> String {
    let boundary = |at: usize| (0..=at).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    let marked = AnnotationKind::Primary.span(boundary(place.start)..boundary(place.end));
    let line = Snippet::source(text.as_str()).path(file.display().to_string()).annotation(marked);
    let remedy = Level::HELP.message(error.remedy.as_str());
    let report = [Level::ERROR.primary_title(error.message.as_str()).element(line).element(remedy)];
    let renderer = if styled { Renderer::styled() } else { Renderer::plain() };
    renderer.render(&report)
}

/// Prints a line; a reader who has gone away (a closed pipe) is no error, but what cannot be written, on a disk that is
/// full, ends the program.
#[expect(clippy::exit, reason = "no caller goes on well once what it printed is cut")]
pub fn say(line: impl std::fmt::Display) {
    match writeln!(std::io::stdout(), "{line}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let message = format!("cannot be written: {error}");
            show(&Error::at("standard output", message, "make room, or send it elsewhere; what is there is cut"));
            std::process::exit(WRONG_INPUT.into())
        }
        _ => {}
    }
}

/// Columns where neither a terminal nor `COLUMNS` names them, as the help has it.
pub const WIDTH: u16 = 100;

/// Columns of the terminal; without one those that `COLUMNS` names.
pub fn width() -> u16 {
    let named = || std::env::var("COLUMNS").ok()?.parse().ok();
    terminal_size::terminal_size().map(|(width, _)| width.0).or_else(named).unwrap_or(WIDTH)
}

/// A table no wider than the terminal.
pub fn table<'a>(head: impl IntoIterator<Item = &'a str>) -> Table {
    table_on(width(), head)
}

/// Prints a text in lines no wider than the terminal, its words whole.
pub fn say_in_lines(text: &str) {
    let mut table = table_on(width(), [""; 0]);
    table.add_row([text]);
    table.lines().for_each(|line| say(line.strip_prefix(' ').unwrap_or(&line).trim_end()));
}

/// The same table with columns as wide as their longest words.
pub fn whole(mut table: Table) -> Table {
    let mut longest = vec![0; table.column_count()];
    for row in table.header().into_iter().chain(table.row_iter()) {
        for (longest, cell) in longest.iter_mut().zip(row.cell_iter()) {
            let words = cell.content().split([' ', '\n']).map(|word| word.chars().count()).max();
            *longest = words.unwrap_or(0).max(*longest);
        }
    }
    for (column, longest) in table.column_iter_mut().zip(longest) {
        column.set_constraint(ColumnConstraint::LowerBoundary(Width::Fixed(longest as u16 + 2)));
    }
    table
}

/// Names and what each is, a line each.
pub fn named(all: &[(&str, &str)]) -> String {
    let widest = all.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    all.iter().map(|(name, what)| format!("{name:widest$}  {what}")).collect::<Vec<_>>().join("\n")
}

/// A table no wider than so many columns.
pub fn table_on<'a>(columns: u16, head: impl IntoIterator<Item = &'a str>) -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic).set_width(columns);
    let head: Vec<&str> = head.into_iter().collect();
    if !head.is_empty() {
        table.set_header(head);
    }
    table
}

/// A bar over so many pieces of work, on a terminal.
pub fn progress(pieces: usize) -> ProgressBar {
    styled(ProgressBar::new(pieces as u64), "{bar:30} {pos}/{len} {msg}")
}

/// A bar by a template.
pub fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    bar.with_style(ProgressStyle::with_template(template).expect("templates are those of this program"))
}
