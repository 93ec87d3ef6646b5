//! `scoreboard`: asks other codes for the exported cases, and keeps what they write; the page of the study tells how each run ended.

use std::fs;

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::scoreboard::board::{self, Board, Code, Setting, hashes};
use crate::study::scoreboard::{CASES, named};
use crate::study::seconds::Machine;

/// Asks every installed code for every case, and writes the record.
pub fn run() -> Result<(), Error> {
    let folder = board::folder();
    writable::in_checkout(board::FOLDER)?;
    fs::create_dir_all(&folder).map_err(|error| Error::unwritable(&folder, error))?;
    let bar = progress(CASES.len() * Setting::ALL.len());
    let mut fresh = Board { scripts: hashes(), processor: Machine::here().processor, ..Board::default() };
    let mut absent = Vec::new();
    for name in CASES {
        let (asked, without) = board::ask(name, &named(name)?, |setting| {
            bar.inc(1);
            bar.set_message(format!("{name}, {}, {}", setting.code.name(), setting.method));
        })?;
        fresh.cases.insert(name.into(), asked);
        absent.extend(without);
    }
    bar.finish_and_clear();
    absent.dedup();
    if !absent.is_empty() {
        let codes = Code::ALL.map(Code::name).join(", ");
        let message = format!("not all of {codes} are installed: {}", absent.join("; "));
        return Err(Error::at(
            "scoreboard",
            message,
            "install them by `bash oracles/peers/setup.sh` and `bash oracles/setup.sh`; the record is kept as it was",
        ));
    }
    fresh.write()?;
    say(format!("written: {}; `cargo run --release` draws it", board::FOLDER));
    Ok(())
}
