//! Charts: whether what is drawn moved, only its words, or only how it looks.

use std::collections::BTreeMap;

use svg::parser::Event;

use super::told::Told;
use super::tree::Moved;
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// What is drawn.
    Data,
    /// Words, and nothing that is drawn.
    Words,
    /// Colours exchanged one for one, dashes, fonts.
    Looks,
}

/// Charts whose data moved, to be seen before and after; then those that only look otherwise. A chart for dark pages is told with its
/// twin for light ones.
pub fn told(moved: &[&Moved]) -> Vec<Told> {
    let paths: Vec<&str> = moved.iter().map(|one| one.0).collect();
    let twin =
        |path: &str| path.strip_suffix("-dark.svg").is_some_and(|name| paths.contains(&format!("{name}.svg").as_str()));
    let moved: Vec<&Moved> = moved.iter().copied().filter(|one| !twin(one.0)).collect();
    let (both, single): (Vec<&&Moved>, Vec<&&Moved>) = moved.iter().partition(|one| one.1.is_some() && one.2.is_some());
    let of = |wanted: Change| -> Vec<&str> {
        let is_one = |one: &&&&Moved| one.1.zip(one.2).is_some_and(|(old, new)| change(old, new) == wanted);
        both.iter().filter(is_one).map(|one| one.0).collect()
    };
    let [data, words, looks] = [Change::Data, Change::Words, Change::Looks].map(of);
    let mut told = Vec::new();
    if !data.is_empty() || !single.is_empty() {
        let mut rows: Vec<String> = data.iter().map(|path| path.to_string()).collect();
        rows.extend(single.iter().map(|one| format!("{}: {}", one.0, if one.2.is_some() { "new" } else { "GONE" })));
        let heading = format!("Charts whose data moved: {}, {} new or gone", data.len(), single.len());
        let charts = data.iter().copied().chain(single.iter().map(|one| one.0)).map(String::from).collect();
        told.push(Told { charts, ..Told::new(heading, rows) });
    }
    for (paths, what) in
        [(words, "only words moved, no data"), (looks, "only colours, dashes or fonts were exchanged, no data moved")]
    {
        if !paths.is_empty() {
            told.push(Told::new(format!("{}: {what}", counted(paths.len(), "chart")), vec![some(&paths)]));
        }
    }
    told
}

/// Compares two drawings part by part.
///
/// Colours may be data, in maps: a drawing looks otherwise where each old colour became one new one everywhere, and no two became
/// the same.
pub fn change(before: &str, after: &str) -> Change {
    let mut sides = [before, after].map(svg::parser::Parser::new);
    let mut colours: [BTreeMap<String, String>; 2] = Default::default();
    let mut change = Change::Looks;
    loop {
        let [old, new] = sides.each_mut().map(Iterator::next);
        match (old, new) {
            (None, None) => return change,
            (Some(Event::Text(old)), Some(Event::Text(new))) if old.trim() != new.trim() => change = Change::Words,
            (Some(Event::Text(_)), Some(Event::Text(_))) => (),
            (Some(Event::Tag(a, _, old)), Some(Event::Tag(b, _, new))) => {
                let same = a == b && old.keys().all(|key| new.contains_key(key) || LOOKS.contains(&key.as_str()));
                let exchanged = |[one, other]: [&svg::node::Attributes; 2],
                                 side: usize,
                                 known: &mut [BTreeMap<String, String>; 2]| {
                    one.iter().all(|(key, value)| match key.as_str() {
                        look if LOOKS.contains(&look) => true,
                        colour if COLOURS.contains(&colour) => {
                            let Some(now) = other.get(key) else { return false };
                            *known[side].entry(value.to_string()).or_insert_with(|| now.to_string()) == **now
                        }
                        _ => other.get(key) == Some(value),
                    })
                };
                if !same || !exchanged([&old, &new], 0, &mut colours) || !exchanged([&new, &old], 1, &mut colours) {
                    return Change::Data;
                }
            }
            (Some(Event::Comment(_)), Some(Event::Comment(_))) => (),
            _ => return Change::Data,
        }
    }
}
