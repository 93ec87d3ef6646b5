//! Every mistake in a scene file is told with its file, its line, what was found and what to do: those of tests/data/refused.toml; a
//! missing support is named by its body and direction, and physics that this code does not do by what to use instead.

use std::collections::BTreeMap;

use contact_vv::case::Case;
use contact_vv::checkout::root;
use contact_vv::solve::Discretisation;

use crate::balance;
use crate::scene_file::{folder, scene_alone, text_of};

/// A file, and what is spoiled in it.
struct Mistake {
    file: String,
    was: String,
    is: String,
    at: String,
    says: Vec<String>,
}

/// The mistakes of a kind.
fn mistakes(kind: &str) -> Vec<Mistake> {
    let path = root().join("tests/data/refused.toml");
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
    fn sound(&self) -> String {
        let rectangle = "shape = { rectangle = { x = [0, 20], y = [0, 40], contact = \"bottom\" } }";
        match self.file.as_str() {
            "block" => text_of("rigid-cosine.toml").replace(rectangle, BLOCK),
            file if folder().join(format!("{file}.toml")).is_file() => text_of(&format!("{file}.toml")),
            file => balance::text(file),
        }
    }

    /// What is told of it in a text of its file with one more change, once, and the line that it must name.
    fn told(&self, text: &str, change: impl Fn(String) -> String) -> (String, usize) {
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
    fn unlike(&self, error: &str, line: usize, more: usize) -> Option<String> {
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
        let case =
            Case::parse(&folder().join(format!("{name}.toml")), &text_of(&format!("{name}.toml"))).expect("sound");
        let discretisation = Discretisation::of(case.scene, case.resolution).expect("meshed");
        let found = discretisation.unheld(1.0).expect("motions");
        assert!(found.is_none(), "{name}: {found:?}");
        // Pulled instead of pressed, a body that contact alone holds leaves it.
        let pulled = discretisation.unheld(-1.0).expect("motions");
        let alone = ["cylinder-on-block", "eccentric-load", "rigid-pin"].contains(&name);
        assert!(pulled.is_some() || !alone, "{name}");
    }
}

/// A mesh of one cell on the unit square: its nodes, and its block of cells.
fn mesh(nodes: &str, cells: &str) -> String {
    let count = nodes.lines().count();
    let tags: String = (1..=count).map(|tag| format!("{tag}\n")).collect();
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 1 1 1\n1 0 0 0 1 0 0 1 1 0\n1 0 0 0 1 1 0 1 4 0\n\
         1 0 0 0 1 1 1 1 5 0\n$EndEntities\n$Nodes\n1 {count} 1 {count}\n2 1 0 {count}\n{tags}{nodes}$EndNodes\n\
         $Elements\n2 2 1 2\n1 1 1 1\n1 1 2\n{cells}$EndElements\n"
    )
}

/// What a scene says of a body from that mesh.
fn refusal(mesh: &str) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("mesh.msh"), mesh).expect("written");
    let rectangle = "{ rectangle = { x = [0, 20], y = [0, 40], contact = \"bottom\" } }";
    let text = text_of("rigid-cosine.toml");
    assert!(text.contains(rectangle));
    let given = "{ gmsh = { file = \"mesh.msh\", group = \"4\", contact = \"1\" } }";
    let error = Case::parse(&folder.path().join("scene.toml"), &text.replace(rectangle, given)).map(|_| ());
    error.expect_err("refused").to_string()
}

#[test]
fn triangles_and_solids_of_gmsh_name_the_option_that_helps() {
    let square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    let triangle = refusal(&mesh(square, "2 1 2 1\n2 1 2 3\n"));
    for part in ["cell 2 of `4` is a triangle", "Mesh.SubdivisionAlgorithm = 1", "Mesh.RecombineAll = 1"] {
        assert!(triangle.contains(part), "`{part}` is not in: {triangle}");
    }
    // A flat one: solids with a height are refused by their first node off the plane.
    let flat = refusal(&mesh(square, "3 1 4 1\n2 1 2 3 4\n"));
    assert!(flat.contains("type 4 are solids") && flat.contains("scenes are plane: mesh the surfaces only"), "{flat}");
    let high = refusal(&mesh(&format!("{square}0 0 1\n"), "3 1 4 1\n2 1 2 3 5\n"));
    assert!(high.contains("node 5 lies at z = 1") && high.contains("scenes are plane"), "{high}");
}
