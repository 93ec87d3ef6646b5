//! `new SHAPE`: commented scene files to begin with, one for each shape of problem.

use crate::cli::terminal::named;
use crate::named::named_enum;

named_enum! {
    /// A scene file to begin with.
    pub enum Template {
        /// A cylinder on a rigid plane.
        Cylinder = "cylinder",
        /// A sphere on a rigid plane: bodies of revolution.
        Sphere = "sphere",
        /// Two cylinders of different radii and materials.
        TwoCylinders = "two-cylinders",
        /// A cylinder on an elastic block, to an accuracy instead of a mesh.
        CylinderOnBlock = "cylinder-on-block",
        /// A rigid flat punch on a block.
        Punch = "punch",
        /// A rigid profile given point by point, pressed into a block.
        Profile = "profile",
        /// Two rings pressed into one another.
        PressFit = "press-fit",
        /// A pin in the eye of a lug, with clearance.
        PinInHole = "pin-in-hole",
        /// A roller between two plates: several contacts.
        Roller = "roller",
        /// A block under an eccentric load: contact on both sides of x = 0.
        Eccentric = "eccentric",
        /// A wedge-shaped body made of blocks.
        Blocks = "blocks",
        /// Bodies from a Gmsh mesh.
        Gmsh = "gmsh",
        /// The Gmsh mesh itself that `gmsh` reads, as rings.msh.
        Mesh = "mesh",
    }
}

impl Template {
    /// The text of the file.
    pub fn text(self) -> &'static str {
        match self {
            Self::Cylinder => include_str!("cylinder.toml"),
            Self::Sphere => include_str!("sphere.toml"),
            Self::TwoCylinders => include_str!("two-cylinders.toml"),
            Self::CylinderOnBlock => include_str!("cylinder-on-block.toml"),
            Self::Punch => include_str!("punch.toml"),
            Self::Profile => include_str!("profile.toml"),
            Self::PressFit => include_str!("press-fit.toml"),
            Self::PinInHole => include_str!("pin-in-hole.toml"),
            Self::Roller => include_str!("roller.toml"),
            Self::Eccentric => include_str!("eccentric.toml"),
            Self::Blocks => include_str!("blocks.toml"),
            Self::Gmsh => include_str!("gmsh.toml"),
            Self::Mesh => include_str!("rings.msh"),
        }
    }
}

/// What editors that know TOML find the keys of a scene by; others take it for a comment.
const EDITORS: &str =
    "#:schema ./scene.schema.json\n# `contact-vv schema scene > scene.schema.json` writes the schema for editors.";

/// A file, or the list of all.
pub fn file(template: Option<Template>) -> String {
    match template {
        Some(Template::Mesh) => Template::Mesh.text().trim_end().into(),
        Some(template) => format!("{EDITORS}\n{}", template.text().trim_end()),
        None => {
            let remedy = "`contact-vv new NAME > mine.toml` writes one, `contact-vv solve mine.toml` solves it";
            format!("{}\n\n{remedy}", named(&Template::ALL.map(|template| (template.name(), template.title()))))
        }
    }
}
