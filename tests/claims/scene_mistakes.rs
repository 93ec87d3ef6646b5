//! Every mistake in a scene file or a mesh is told with its file, its line, what was found and what to do: those of
//! tests/data/refused.toml; a missing support is named by its body and direction, and physics that this code does not
//! do by what to use instead.

use std::collections::BTreeMap;

use contact_vv::case::Case;
use contact_vv::checkout::root;
use contact_vv::cli::new::Template;
use contact_vv::solve::Discretisation;

use crate::balance;
use crate::scene_file::{case, folder, scene_alone, text_of};

/// A file, and what is spoiled in it.
struct Mistake {
    file: String,
    was: String,
    is: String,
    at: String,
    says: Vec<String>,
}

/// The rows of a kind, each with the file that it changes.
pub fn rows(kind: &str) -> impl Iterator<Item = (String, Vec<String>)> {
    let path = root().join("tests/data/refused.toml");
    let text = std::fs::read_to_string(path).expect("the table");
    let mut kinds: BTreeMap<String, BTreeMap<String, Vec<Vec<String>>>> = toml::from_str(&text).expect("TOML");
    let files = kinds.remove(kind).expect("a kind of change").into_iter();
    files.flat_map(|(file, rows)| rows.into_iter().map(move |row| (file.clone(), row)))
}

/// The mistakes of a kind.
fn mistakes(kind: &str) -> Vec<Mistake> {
    let mistake = |(file, row): (String, Vec<String>)| {
        let [was, is, at, says @ ..] = row.as_slice() else { panic!("{file}: {row:?}") };
        let [was, is, at] = [was, is, at].map(String::clone);
        Mistake { file, was, is, at, says: says.to_vec() }
    };
    rows(kind).map(mistake).collect()
}

/// A block by its corners, in place of the rectangle of a file.
const BLOCK: &str = "shape = { blocks = [{ corners = [[0, 0], [20, 0], [20, 40], [0, 40]], elements = [16, 8], \
     growth = [1, 1.2], bottom = \"contact\", right = \"right\", top = \"far\", left = \"left\", arcs = { top = [10, \
     0] } }] }";

impl Mistake {
    /// The text that is spoiled.
    fn sound(&self) -> String {
        let rectangle = "shape = { rectangle = { x = [0, 20], y = [0, 40], contact = \"bottom\" } }";
        match self.file.as_str() {
            "block" => text_of("rigid-cosine.toml").replace(rectangle, BLOCK),
            "sphere" => Template::Sphere.text().into(),
            file if folder().join(format!("{file}.toml")).is_file() => text_of(&format!("{file}.toml")),
            file => balance::text(file),
        }
    }

    /// A text of its file with it and with one more change, once, and the line that must be named.
    fn spoil(&self, text: &str, change: impl Fn(String) -> String) -> (String, usize) {
        let Self { file, was, is, at, .. } = self;
        let start = text.find(was.as_str()).unwrap_or_else(|| panic!("{file}: {was}"));
        let spoiled = change(text.replacen(was, is, 1));
        let anchor = match is.find(at.as_str()) {
            Some(within) => start + within,
            None => spoiled.find(at.as_str()).expect("a place"),
        };
        let line = 1 + spoiled[..anchor].matches('\n').count();
        (spoiled, line)
    }

    /// What is told of it in a scene, and the line that it must name.
    fn told(&self, text: &str, change: impl Fn(String) -> String) -> (String, usize) {
        let (spoiled, line) = self.spoil(text, change);
        let case = Case::parse(&folder().join(format!("{}.toml", self.file)), &spoiled);
        (case.and_then(|case| case.solve().map(|_| ())).expect_err(&self.is).to_string(), line)
    }

    /// What is wrong with a message: another line than its own or one of the next ones, or a part that it does not say.
    fn unlike(&self, error: &str, line: usize, more: usize) -> Option<String> {
        let named = |line| error.contains(&format!("{}.toml:{line}: ", self.file));
        let sound = (line..=line + more).any(named) && self.says.iter().all(|part| error.contains(part));
        (!sound).then(|| format!("{}: {}, line {line}, {:?}: {error}", self.file, self.is, self.says))
    }
}

/// That every mistake in a mesh is told at its line in a file, or at a line of its scene that is among what is said.
pub fn assert_told(mesh: &str, text: &str, file: &str, refused: impl Fn(&str) -> String) {
    let mut wrong = Vec::new();
    for mistake in mistakes("mesh").into_iter().filter(|mistake| mistake.file == mesh) {
        let (spoiled, line) = mistake.spoil(text, |text| text);
        let told = refused(&spoiled);
        let place = format!("{file}:{line}: ");
        let placed = told.contains(&place) || mistake.says.iter().any(|part| part.starts_with("scene.toml:"));
        let said = mistake.says.iter().all(|part| told.contains(part));
        wrong.extend((!(placed && said)).then(|| format!("{}, {place}{:?}: {told}", mistake.is, mistake.says)));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
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

#[test]
fn missing_support_is_named_by_body_and_direction_whatever_the_algorithm() {
    for mistake in mistakes("unheld") {
        // Interference is not defined for varying stiffness.
        let algorithms = if mistake.file == "press-fit" { &["kinematic"][..] } else { &["kinematic", "varying"] };
        for algorithm in algorithms {
            let with = format!("[solve]\nalgorithm = \"{algorithm}\"\n");
            let (error, line) = mistake.told(&mistake.sound(), |text| text.replacen("[solve]\n", &with, 1));
            assert_eq!(mistake.unlike(&error, line, 0), None, "{algorithm}");
            for blamed in ["raise `stiffness`", "raise the initial stiffness", "NaN", "refine the mesh", "initial gap"]
            {
                assert!(!error.contains(blamed), "{algorithm}: {error}");
            }
        }
    }
}

#[test]
fn scenes_that_hold_are_not_said_to_miss_a_support() {
    for name in
        ["cylinder-on-block", "two-cylinders", "press-fit", "eccentric-load", "rigid-pin", "roller-between-plates"]
    {
        let case = case(name);
        let discretisation = Discretisation::of(case.scene, case.resolution).expect("meshed");
        let found = discretisation.unheld(1.0).expect("motions");
        assert!(found.is_none(), "{name}: {found:?}");
        // Pulled instead of pressed, a body that contact alone holds leaves it.
        let pulled = discretisation.unheld(-1.0).expect("motions");
        let alone = ["cylinder-on-block", "eccentric-load", "rigid-pin"].contains(&name);
        assert!(pulled.is_some() || !alone, "{name}");
    }
}
