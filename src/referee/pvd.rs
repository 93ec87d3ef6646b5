//! Collections of ParaView (`.pvd`): a grid in a file of its own for each time, of which one is judged; and grids in
//! pieces (`.pvtu`) that have one.

use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::referee::asked::Asked;
use crate::referee::source::Source;
use crate::referee::state::State;
use crate::referee::vtu::{attribute, tag, uncommented, unescaped};

/// What to do with a collection that is not read.
const ONE: &str = "hand in the .vtu of the last time itself";

/// The file of a grid in pieces (`.pvtu`) that has one alone; none of several, or where that is no `.vtu`.
pub fn only_piece(file: &Path, text: &str) -> Option<PathBuf> {
    let plain = uncommented(text.as_bytes());
    let own = tag(&plain, b"<Piece", 0).filter(|own| tag(&plain, b"<Piece", own.end).is_none())?;
    let piece = file.with_file_name(unescaped(attribute(&text[own], "Source")?));
    piece.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("vtu")).then_some(piece)
}

/// The file that is judged and its state, that of the largest time or that of the time that is asked for; and the
/// states of all.
pub fn chosen(file: &Path, text: &str, asked: &Asked) -> Result<(PathBuf, State, Vec<State>), Error> {
    let source = Source { file, text };
    let (mut found, mut at) = (Vec::new(), 0);
    let plain = uncommented(text.as_bytes());
    while let Some(own) = tag(&plain, b"<DataSet", at) {
        at = own.end;
        let entry = &text[own];
        let Some(named) = attribute(entry, "file") else {
            return Err(source.at(entry, "this grid has no file", ONE));
        };
        // Where no time is written the grids are counted.
        let time = attribute(entry, "timestep").map_or(Some(found.len() as f64 + 1.0), |time| time.trim().parse().ok());
        let time =
            time.filter(|time| time.is_finite()).ok_or_else(|| source.at(entry, "its time is no number", ONE))?;
        found.push((file.parent().unwrap_or(Path::new("")).join(unescaped(named)), entry, State { step: None, time }));
    }
    // Programs that add to a collection do not write its times in order.
    found.sort_by(|(.., a), (.., b)| a.time.total_cmp(&b.time));
    let states: Vec<State> = found.iter().map(|(.., state)| *state).collect();
    if states.is_empty() {
        return Err(source.refused("it names no grid (<DataSet file=…>)", ONE));
    }
    let chosen = State::chosen(&source, &states, asked)?;
    let (own, entry, state) = found[chosen].clone();
    let parts = states.iter().filter(|other| other.time.total_cmp(&state.time).is_eq()).count();
    if parts > 1 {
        let message = format!("it has {parts} files of time {}, and one with all bodies is judged", state.time);
        return Err(source.refused(message, "save the grid of that time in one .vtu"));
    }
    let is = |file: &Path, ending: &str| file.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending));
    if is(&own, "pvd") || is(&own, "gz") && is(&own.with_extension(""), "pvd") {
        return Err(source.refused("it names another collection", ONE));
    }
    if !own.exists() {
        let message = format!("the file `{}` of this grid is missing", own.display());
        return Err(source.at(entry, message, "put it where the collection names it, seen from its folder"));
    }
    Ok((own, state, states))
}
