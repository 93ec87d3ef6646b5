//! Charts: whether what is drawn moved, only its words, or only how it looks.

use std::collections::{BTreeMap, BTreeSet};

use svg::node::element::tag::Type;
use svg::parser::{Event, Parser};

use super::told::{Change, Told};
use super::tree::Moved;
use crate::study::grouped::joined;

/// Attributes that say how something looks, and not what it is; rules of style sheets among them.
const LOOKS: [&str; 8] = [
    "stroke-width",
    "stroke-dasharray",
    "stroke-linejoin",
    "stroke-linecap",
    "font-family",
    "font-size",
    "font-weight",
    STYLE,
];
/// Attributes that hold a colour.
const COLOURS: [&str; 3] = ["fill", "stroke", "stop-color"];
/// A style of an attribute, and the element of a style sheet.
const STYLE: &str = "style";
/// What words between elements are kept under.
const WORDS: &str = "words";

/// Charts whose data moved, to be seen before and after; then those that differ in words and looks alone.
pub fn told(moved: &[Moved]) -> Vec<Told> {
    let (mut data, mut others) = (Vec::new(), Vec::new());
    for (path, [old, new]) in moved {
        let change = |of: &str, at: &str| Change { of: of.into(), at: at.into(), ..Change::default() };
        match old.zip(*new).map(|(old, new)| no_data(old, new)) {
            Some(Some(names)) => others.push(change(&format!("only {}", names.join(", ")), path)),
            Some(None) => data.push(((*path).into(), change(path, ""))),
            None => data.push(((*path).into(), change(if old.is_none() { "new" } else { "GONE" }, path))),
        }
    }
    let (charts, data): (Vec<String>, Vec<Change>) = data.into_iter().unzip();
    let data = Told::counted("Charts whose data moved", "chart", data).map(|told| Told { charts, ..told });
    let others = Told::counted("Charts that look otherwise, no data moved", "chart", others);
    data.into_iter().chain(others).collect()
}

/// The words and looks in which two drawings differ; none where what is drawn does.
///
/// Colours may be data, in maps: a drawing looks otherwise where each old colour became one new one everywhere, and no
/// two became the same.
pub fn no_data(before: &str, after: &str) -> Option<Vec<String>> {
    let parts = joined([parts(before), parts(after)]);
    let is_colour = |name: &str| COLOURS.contains(&name);
    let colours = parts.iter().filter(|((_, name), _)| is_colour(name)).map(|(_, both)| both);
    let colours: BTreeSet<&[Option<String>; 2]> = colours.collect();
    let each = |side: usize| colours.iter().map(|both| &both[side]).collect::<BTreeSet<_>>();
    let is_exchange = [each(0), each(1)].iter().all(|side| side.len() == colours.len() && !side.contains(&None));
    let is_look = |name: &str| name == WORDS || LOOKS.contains(&name) || is_colour(name) && is_exchange;
    let moved = parts.into_iter().filter(|(_, [old, new])| old != new).map(|((_, name), _)| name);
    let moved: BTreeSet<String> = moved.collect();
    moved.iter().all(|name| is_look(name)).then(|| moved.into_iter().collect())
}

/// Elements, attributes and words of a drawing by where they are and their name.
fn parts(text: &str) -> BTreeMap<(usize, String), String> {
    let mut parts = BTreeMap::new();
    let mut within = WORDS;
    for (place, event) in Parser::new(text).enumerate() {
        match event {
            Event::Tag(element, kind, attributes) => {
                within = if element == STYLE && kind == Type::Start { STYLE } else { WORDS };
                parts.insert((place, "element".into()), element.into());
                parts.extend(attributes.into_iter().map(|(name, value)| ((place, name), value.to_string())));
            }
            Event::Text(words) => {
                parts.insert((place, within.into()), words.trim().into());
            }
            Event::Error(error) => {
                parts.insert((place, "error".into()), error.to_string());
                return parts;
            }
            Event::Comment(_) | Event::Declaration(_) | Event::Instruction(_) => {}
        }
    }
    parts
}
