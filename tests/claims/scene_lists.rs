//! A list in a scene file has as many entries as it needs: one too many or too few is refused, never dropped.

use contact_vv::case::Case;

use crate::scene_file::{folder, text_of};

/// A block by its corners, in place of the rectangle of a file.
const BLOCK: &str = "shape = { blocks = [{ corners = [[0, 0], [20, 0], [20, 40], [0, 40]], elements = [16, 8], \
     growth = [1, 1.2], bottom = \"contact\", right = \"right\", top = \"far\", left = \"left\", arcs = { top = [10, 0] } }] }";

/// The file, a list in it, the same with another number of entries, and the key, value and remedy of the message.
const LISTS: &[(&str, &str, &str, [&str; 3])] = &[
    (
        "cylinder-on-block",
        "centre = [0, 50]",
        "centre = [0, 50, 7]",
        ["`centre`", "[0, 50, 7]", "give 2 entries, not 3"],
    ),
    (
        "cylinder-on-block",
        "value = [0, -57.5]",
        "value = [0, -57.5, 3]",
        ["`value`", "[0, -57.5, 3]", "give 2 entries"],
    ),
    ("cylinder-on-block", "value = [0, -57.5]", "value = [-57.5]", ["`value`", "[-57.5]", "give 2 entries, not 1"]),
    ("cylinder-on-block", "x = [0, 80]", "x = [0, 40, 80]", ["`x`", "[0, 40, 80]", "give 2 entries, not 3"]),
    ("whole-disc", "at = [0, 50]", "at = [0, 50, 0]", ["`at`", "[0, 50, 0]", "give 2 entries, not 3"]),
    (
        "plate-on-two-supports",
        "origin = [-30, 0]",
        "origin = [-30, 0, 0]",
        ["`origin`", "[-30, 0, 0]", "give 2 entries"],
    ),
    ("press-fit", "arc = { centre = [0, 0]", "arc = { centre = [0, 0, 0]", ["`centre`", "[0, 0, 0]", "give 2 entries"]),
    (
        "rigid-cosine",
        "gap = { cosine = { amplitude = 0.01, wavelength = 40 } }",
        "gap = { table = [[0, 0], [9, 0.1, 2], [20, 1]] }",
        ["`table`", "[9, 0.1, 2]", "give 2 entries, not 3"],
    ),
    (
        "rigid-cosine",
        "traction = { at = \"far\", value = [0, -62.618859641] }",
        "body-force = [0, -1e-5, 9.81]",
        ["`body-force`", "[0, -1e-5, 9.81]", "give 2 entries, not 3"],
    ),
    (
        "rigid-cosine",
        "traction = { at = \"far\", value = [0, -62.618859641] }",
        "force = { at = [0, 40, 0], value = [0, -1] }",
        ["`at`", "[0, 40, 0]", "give 2 entries, not 3"],
    ),
    (
        "rigid-cosine",
        "traction = { at = \"far\", value = [0, -62.618859641] }",
        "pressure = { at = \"far\", law = { cosine = { centre = [0, 1, 2], coefficients = [1] } } }",
        ["`centre`", "[0, 1, 2]", "give 2 entries, not 3"],
    ),
    (BLOCK, "elements = [16, 8]", "elements = [16, 8, 4]", ["`elements`", "[16, 8, 4]", "give 2 entries, not 3"]),
    (BLOCK, "growth = [1, 1.2]", "growth = [1, 1.2, 1]", ["`growth`", "[1, 1.2, 1]", "give 2 entries, not 3"]),
    (BLOCK, ", [0, 40]]", ", [0, 40], [1, 1]]", ["`corners`", "[0, 40], [1, 1]]", "give 4 entries, not 5"]),
    (BLOCK, "[20, 0]", "[20, 0, 1]", ["`corners`", "[20, 0, 1]", "give 2 entries, not 3"]),
    (BLOCK, "arcs = { top = [10, 0] }", "arcs = { top = [10, 0, 0] }", ["`arcs`", "[10, 0, 0]", "give 2 entries"]),
];

#[test]
fn list_of_another_length_names_file_line_key_value_and_remedy() {
    for (name, was, is, wanted) in LISTS {
        let rectangle = "shape = { rectangle = { x = [0, 20], y = [0, 40], contact = \"bottom\" } }";
        let (name, text) = match *name {
            BLOCK => ("block", text_of("rigid-cosine.toml").replace(rectangle, BLOCK)),
            name => (name, text_of(&format!("{name}.toml"))),
        };
        assert!(text.contains(was), "{name}: {was}");
        let spoiled = text.replacen(was, is, 1);
        let file = folder().join(format!("{name}.toml"));
        let error = Case::parse(&file, &spoiled).map(|_| ()).expect_err(is).to_string();
        let line = 1 + spoiled[..spoiled.find(is).expect("a place")].matches('\n').count();
        assert!(error.starts_with(&format!("{}:{line}: ", file.display())), "line {line}: {error}");
        wanted.iter().for_each(|part| assert!(error.contains(part), "{is}: `{part}` is not in: {error}"));
    }
}

/// A file, tables in it, and the same by position instead of by key.
const BY_POSITION: &[(&str, &str, &str)] = &[
    ("rigid-cosine", "cosine = { amplitude = 0.01, wavelength = 40 }", "cosine = [0.01, 40, 7]"),
    (
        "rigid-cosine",
        "rectangle = { x = [0, 20], y = [0, 40], contact = \"bottom\" }",
        "rectangle = [[0, 20], [0, 40], \"bottom\"]",
    ),
    (
        "rigid-cosine",
        "traction = { at = \"far\", value = [0, -62.618859641] }",
        "traction = [\"far\", [0, -62.618859641]]",
    ),
    ("rigid-cosine", "[mesh]\nelements = 16\nper = 8\n", "[mesh]\nelements = 16\nper = 8\ngrowth = [1.5, 1.4, 3]\n"),
    ("rigid-cosine", "supports = [{ at = \"left\", component = \"x\" }", "supports = [[\"left\", \"x\"]"),
    ("whole-disc", "disc = { centre = [0, 50], radius = 50, whole = true }", "disc = [[0, 50], 50]"),
    ("press-fit", "arc = { centre = [0, 0], radius = 40 }", "arc = [[0, 0], 40]"),
    ("press-fit", "[reference]\n", "[[reference]]\n"),
    ("press-fit", "[solve]\n", "[[solve]]\n"),
];

#[test]
fn table_by_position_is_refused() {
    for (name, was, is) in BY_POSITION {
        let text = text_of(&format!("{name}.toml"));
        assert!(text.contains(was), "{name}: {was}\n{text}");
        let spoiled = text.replacen(was, is, 1);
        let file = folder().join(format!("{name}.toml"));
        let error = Case::parse(&file, &spoiled).map(|_| ()).expect_err(is).to_string();
        let line = 1 + spoiled[..spoiled.find(is).expect("a place")].matches('\n').count();
        let near = (line..line + 4).any(|line| error.starts_with(&format!("{}:{line}: ", file.display())));
        assert!(near && error.contains("a table with its keys"), "{is}: {error}");
    }
}
