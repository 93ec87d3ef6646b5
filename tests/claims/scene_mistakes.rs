//! Every mistake in a scene file is told with its file, its line, what was found and what to do: those of tests/data/refused.toml.

use std::collections::BTreeMap;
use std::path::Path;

use contact_vv::case::Case;

use crate::scene_file::{folder, scene_alone, text_of};

/// A file, and what is spoiled in it.
pub struct Mistake {
    pub file: String,
    was: String,
    is: String,
    at: String,
    says: Vec<String>,
}

/// The mistakes of a kind.
pub fn mistakes(kind: &str) -> Vec<Mistake> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/refused.toml");
    let text = std::fs::read_to_string(path).expect("the table");
    let mut kinds: BTreeMap<String, BTreeMap<String, Vec<Vec<String>>>> = toml::from_str(&text).expect("TOML");
    let files = kinds.remove(kind).expect("a kind of mistake").into_iter();
    let rows = files.flat_map(|(file, rows)| rows.into_iter().map(move |row| (file.clone(), row)));
    rows.map(|(file, row)| {
        let [was, is, at, says @ ..] = row.as_slice() else { panic!("{file}: {row:?}") };
        let [was, is, at] = [was, is, at].map(String::clone);
        Mistake { file, was, is, at, says: says.to_vec() }
    })
    .collect()
}

/// A block by its corners, in place of the rectangle of a file.
const BLOCK: &str = "shape = { blocks = [{ corners = [[0, 0], [20, 0], [20, 40], [0, 40]], elements = [16, 8], \
     growth = [1, 1.2], bottom = \"contact\", right = \"right\", top = \"far\", left = \"left\", arcs = { top = [10, 0] } }] }";

impl Mistake {
    /// The text that is spoiled.
    pub fn sound(&self) -> String {
        let rectangle = "shape = { rectangle = { x = [0, 20], y = [0, 40], contact = \"bottom\" } }";
        match self.file.as_str() {
            "block" => text_of("rigid-cosine.toml").replace(rectangle, BLOCK),
            file => text_of(&format!("{file}.toml")),
        }
    }

    /// What is told of it in a text of its file with one more change, once, and the line that it must name.
    pub fn told(&self, text: &str, change: impl Fn(String) -> String) -> (String, usize) {
        let Self { file, was, is, at, .. } = self;
        let start = text.find(was.as_str()).unwrap_or_else(|| panic!("{file}: {was}"));
        let spoiled = change(text.replacen(was, is, 1));
        let anchor = match is.find(at.as_str()) {
            Some(within) => start + within,
            None => spoiled.find(at.as_str()).expect("a place"),
        };
        let path = folder().join(format!("{file}.toml"));
        let case = Case::parse(&path, &spoiled);
        let error = case.and_then(|case| case.solve().map(|_| ())).expect_err(is).to_string();
        (error, 1 + spoiled[..anchor].matches('\n').count())
    }

    /// What is wrong with a message: another line than its own or one of the next ones, or a part that it does not say.
    pub fn unlike(&self, error: &str, line: usize, more: usize) -> Option<String> {
        let named = |line| error.contains(&format!("{}.toml:{line}: ", self.file));
        let sound = (line..=line + more).any(named) && self.says.iter().all(|part| error.contains(part));
        (!sound).then(|| format!("{}: {}, line {line}, {:?}: {error}", self.file, self.is, self.says))
    }
}

#[test]
fn every_mistake_names_file_line_finding_and_remedy() {
    let mut wrong = Vec::new();
    for (kind, lines) in [("refused", 0), ("alone", 0), ("by-position", 3)] {
        for mistake in mistakes(kind) {
            let sound = if kind == "alone" { scene_alone(&mistake.sound()) } else { mistake.sound() };
            let (error, line) = mistake.told(&sound, |text| text);
            wrong.extend(mistake.unlike(&error, line, lines));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
