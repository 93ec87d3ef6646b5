//! `new SHAPE`: commented scene files to begin with, one for each shape of problem.

use crate::cli::terminal::named;

/// The mesh that one of them reads.
const MESH: &str = include_str!("rings.msh");

/// Files to begin with: text, name, and what it is.
pub const TEMPLATES: [(&str, &str, &str); 13] = [
    (include_str!("cylinder.toml"), "cylinder", "A cylinder on a rigid plane"),
    (include_str!("sphere.toml"), "sphere", "A sphere on a rigid plane: bodies of revolution"),
    (include_str!("two-cylinders.toml"), "two-cylinders", "Two cylinders of different radii and materials"),
    (
        include_str!("cylinder-on-block.toml"),
        "cylinder-on-block",
        "A cylinder on an elastic block, to an accuracy instead of a mesh",
    ),
    (include_str!("punch.toml"), "punch", "A rigid flat punch on a block"),
    (include_str!("profile.toml"), "profile", "A rigid profile given point by point, pressed into a block"),
    (include_str!("press-fit.toml"), "press-fit", "Two rings pressed into one another"),
    (include_str!("pin-in-hole.toml"), "pin-in-hole", "A pin in the eye of a lug, with clearance"),
    (include_str!("roller.toml"), "roller", "A roller between two plates: several contacts"),
    (include_str!("eccentric.toml"), "eccentric", "A block under an eccentric load: contact on both sides of x = 0"),
    (include_str!("blocks.toml"), "blocks", "A wedge-shaped body made of blocks"),
    (include_str!("gmsh.toml"), "gmsh", "Bodies from a Gmsh mesh"),
    (MESH, "mesh", "The Gmsh mesh itself that `gmsh` reads, as rings.msh"),
];

/// What editors that know TOML find the keys of a scene by; others take it for a comment.
const EDITORS: &str =
    "#:schema ./scene.schema.json\n# `contact-vv schema scene > scene.schema.json` writes the schema for editors.";

/// A file, or the list of all.
pub fn file(template: Option<&str>) -> String {
    match template {
        Some(MESH) => MESH.trim_end().into(),
        Some(template) => format!("{EDITORS}\n{}", template.trim_end()),
        None => {
            let remedy = "`contact-vv new NAME > mine.toml` writes one, `contact-vv solve mine.toml` solves it";
            format!("{}\n\n{remedy}", named(&TEMPLATES.map(|(_, name, what)| (name, what))))
        }
    }
}
