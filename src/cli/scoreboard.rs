//! `scoreboard`: asks other codes for the exported cases, and keeps what they write.

use std::fs;

use crate::cli::terminal::{progress, say};
use crate::cli::writable;
use crate::error::Error;
use crate::study::scoreboard::board::{self, Board, Code, Scored, Setting, hashes};
use crate::study::scoreboard::{CASES, named, numbers};
use crate::study::seconds::Machine;

/// Asks every installed code for every case, writes the record, and tells how each run ended.
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
    for name in CASES {
        for row in numbers(name, &named(name)?, &fresh)?.rows {
            let Setting { code, method, .. } = row.setting;
            let told = match &row.scored {
                Err(why) => format!("failed: {why}"),
                Ok(Scored { scores: [peak, width], failed }) => {
                    let [peak, width] = [peak, width].map(|score| format!("{:+.3} %", 100.0 * score.error));
                    let failed =
                        if failed.is_empty() { "all met".into() } else { format!("not met: {}", failed.join("; ")) };
                    format!("p₀ {peak}, a {width}, {failed}")
                }
            };
            say(format!("{name}, {}, {method}: {told}", code.name()));
        }
    }
    say(format!("written: {}; `cargo run --release` draws it", board::FOLDER));
    Ok(())
}
