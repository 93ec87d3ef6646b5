//! Charts: whether what is drawn moved, only its words, or only how it looks.

use std::collections::BTreeMap;

use svg::node::Attributes;
use svg::parser::{Event, Parser};

use super::told::Told;
use super::tree::{self, Moved};
use super::words::{counted, some};

/// Attributes that say how something looks, and not what it is.
const LOOKS: [&str; 8] = [
    "stroke-width",
    "stroke-dasharray",
    "stroke-linejoin",
    "stroke-linecap",
    "font-family",
    "font-size",
    "font-weight",
    "style",
];
/// Attributes that hold a colour.
const COLOURS: [&str; 3] = ["fill", "stroke", "stop-color"];

/// What of a chart moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Change {
    /// What is drawn.
    Data,
    /// Words, and nothing that is drawn.
    Words,
    /// Colours exchanged one for one, dashes, fonts.
    Looks,
}

/// Charts whose data moved, to be seen before and after; then those that only look otherwise.
pub fn told(moved: &[Moved]) -> Vec<Told> {
    let mut both: BTreeMap<Change, Vec<&str>> = BTreeMap::new();
    let mut single: Vec<(&str, &str)> = Vec::new();
    for (path, texts) in moved {
        match texts {
            [Some(old), Some(new)] => both.entry(change(old, new)).or_default().push(path),
            _ => single.push((path, tree::came_or_went(texts))),
        }
    }
    let data = both.remove(&Change::Data).unwrap_or_default();
    let mut told = Vec::new();
    if !data.is_empty() || !single.is_empty() {
        let rows = data.iter().map(|path| path.to_string());
        let rows = rows.chain(single.iter().map(|(path, how)| format!("{path}: {how}"))).collect();
        let heading = format!("Charts whose data moved: {}, {} new or gone", data.len(), single.len());
        let charts = data.iter().chain(single.iter().map(|(path, _)| path)).map(|path| path.to_string()).collect();
        told.push(Told { charts, ..Told::new(heading, rows) });
    }
    told.extend(both.into_iter().map(|(change, paths)| {
        let what = match change {
            Change::Words => "only words moved, no data",
            Change::Data | Change::Looks => "only colours, dashes or fonts were exchanged, no data moved",
        };
        Told::new(format!("{}: {what}", counted(paths.len(), "chart")), vec![some(paths)])
    }));
    told
}

/// Compares two drawings part by part.
///
/// Colours may be data, in maps: a drawing looks otherwise where each old colour became one new one everywhere, and no two became
/// the same.
pub fn change(before: &str, after: &str) -> Change {
    let mut sides = [before, after].map(Parser::new);
    let [mut to, mut from] = [const { BTreeMap::new() }; 2];
    let mut change = Change::Looks;
    let mut of_style = false;
    loop {
        let both = sides.each_mut().map(Iterator::next);
        if let [Some(Event::Tag(name, ..)), _] = both {
            of_style = name == "style";
        }
        match both {
            [None, None] => return change,
            [Some(Event::Text(_)), Some(Event::Text(_))] if of_style => (),
            [Some(Event::Text(old)), Some(Event::Text(new))] if old.trim() != new.trim() => change = Change::Words,
            [Some(Event::Text(_)), Some(Event::Text(_))] | [Some(Event::Comment(_)), Some(Event::Comment(_))] => (),
            [Some(Event::Tag(a, _, old)), Some(Event::Tag(b, _, new))]
                if a == b && only_looks(&old, &new, &mut to) && only_looks(&new, &old, &mut from) => {}
            _ => return Change::Data,
        }
    }
}

/// Whether attributes differ from others in looks only, each colour always becoming the one that is known for it.
fn only_looks(own: &Attributes, others: &Attributes, known: &mut BTreeMap<String, String>) -> bool {
    own.iter().filter(|(name, _)| !LOOKS.contains(&name.as_str())).all(|(name, value)| match others.get(name) {
        Some(other) if COLOURS.contains(&name.as_str()) => {
            *known.entry(value.to_string()).or_insert_with(|| other.to_string()) == **other
        }
        other => other == Some(value),
    })
}
