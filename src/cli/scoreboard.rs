//! `scoreboard`: asks other codes for the exported cases, and keeps what they write; the page of the study tells how each run ended.

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::scoreboard::board::{self, Board, Setting, hashes};
use crate::study::scoreboard::{CASES, SMALLEST, named};
use crate::study::seconds::Machine;

/// Asks every code for every case, and writes the record; nothing is written before all have answered.
pub fn run() -> Result<(), Error> {
    writable::in_checkout(board::FOLDER)?;
    board::refuse_absent(SMALLEST, &named(SMALLEST)?)?;
    let bar = progress(CASES.len() * Setting::ALL.len());
    let mut fresh = Board { scripts: hashes(), processor: Machine::here().processor, ..Board::default() };
    let mut files = Vec::new();
    for name in CASES {
        let (asked, written) = board::ask(name, &named(name)?, |setting| {
            bar.inc(1);
            bar.set_message(format!("{name}, {}, {}", setting.code.name(), setting.method));
        })?;
        fresh.cases.insert(name.into(), asked);
        files.extend(written);
    }
    bar.finish_and_clear();
    fresh.write(&files)?;
    say(format!("written: {}; `cargo run --release` draws it", board::FOLDER));
    Ok(())
}
