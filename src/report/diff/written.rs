//! A difference as text for a terminal, and as Markdown for a page.

use super::Difference;
use super::told::Told;

/// Lines that a difference has at most, where nothing else is asked for.
pub const LINES: usize = 40;

/// Rows of what is told first that come before any other.
const FIRST: usize = 8;
/// Longest row of a terminal \[characters\].
const WIDTH: usize = 220;

impl Difference {
    /// Text of at most so many lines; every heading is among them, and the most important rows.
    pub fn text(&self, lines: usize) -> String {
        let short = |row: &str| match row.char_indices().nth(WIDTH) {
            Some((end, _)) => format!("{}…", &row[..end]),
            None => row.to_string(),
        };
        let told = self.shown(lines).into_iter().map(|(told, rows)| {
            let rows: String = told.rows.iter().take(rows).map(|row| format!("  {}\n", short(row))).collect();
            format!("{}\n{rows}", told.heading)
        });
        std::iter::once(self.head() + "\n").chain(told).collect()
    }

    /// The same as Markdown; charts are found at `addresses` followed by their paths.
    pub fn markdown(&self, lines: usize, addresses: &[String; 2]) -> String {
        let told = self.shown(lines).into_iter().map(|(told, rows)| {
            let more = told.rows.len() - rows;
            let rows: String = told.rows.iter().take(rows).map(|row| format!("* {}\n", escaped(row))).collect();
            let more = if more > 0 { format!("* … and {more} more rows\n") } else { String::new() };
            format!("**{}**\n\n{rows}{more}\n{}", escaped(&told.heading), charts(told, addresses))
        });
        std::iter::once(format!("### {}\n\n", escaped(&self.head()))).chain(told).collect()
    }

    /// What is said first, with everything that could not be compared: one line.
    fn head(&self) -> String {
        let [before, after] = &self.names;
        let verdict = match (self.told.is_empty(), self.worse) {
            (true, _) => "nothing moved",
            (false, true) => "a verdict got WORSE",
            (false, false) => "no verdict got worse",
        };
        let note = self.note.as_ref().map(|note| format!(" {note}.")).unwrap_or_default();
        format!("{before} → {after}: {verdict}.{note}")
    }

    /// What is told with the number of its rows that there is room for: a row each in turn, from the most important on.
    fn shown(&self, lines: usize) -> Vec<(&Told, usize)> {
        let mut shown: Vec<(&Told, usize)> = self.told.iter().map(|told| (told, 0)).collect();
        let mut room = lines.saturating_sub(1 + shown.len());
        if let Some((told, rows)) = shown.first_mut() {
            *rows = told.rows.len().min(FIRST).min(room);
            room -= *rows;
        }
        loop {
            let before = room;
            for (told, rows) in &mut shown {
                if room > 0 && *rows < told.rows.len() {
                    *rows += 1;
                    room -= 1;
                }
            }
            if room == before || room == 0 {
                return shown;
            }
        }
    }
}

/// Charts side by side, folded.
fn charts(told: &Told, [before, after]: &[String; 2]) -> String {
    if told.charts.is_empty() {
        return String::new();
    }
    let image = |address: &str, path: &str| format!("![{path}]({address}{path})");
    let row = |path: &String| format!("| {} | {} |\n", image(before, path), image(after, path));
    let rows: String = told.charts.iter().map(row).collect();
    crate::markdown::folded("before and after", &format!("| before | after |\n|---|---|\n{rows}"), false)
}

/// Text that Markdown takes as it is.
fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('|', "\\|").replace('*', "\\*").replace('_', "\\_").replace('<', "&lt;")
}
