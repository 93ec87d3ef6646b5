//! The keys of a scene file.

use std::fmt;
use std::path::{Path, PathBuf};

use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use toml::Spanned;

use crate::case::file::gap_keys::GapTable;
use crate::case::file::load_keys::LoadTable;
use crate::case::file::oracle::OracleTable;

pub use crate::case::file::values::{Keyed, List, Name, Number, Pair};

/// `[[body]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodyTable {
    /// Name in messages and in the contact.
    pub name: Name,
    /// Young's modulus.
    pub young: Number,
    /// Poisson's ratio.
    pub poisson: Number,
    /// Outline.
    pub shape: Spanned<ShapeTable>,
    /// Candidate elements of this body over those of the mesh.
    pub density: Option<Number>,
    /// Prescribed displacements.
    #[serde(default)]
    pub supports: Vec<Keyed<SupportTable>>,
    /// Loads.
    #[serde(default)]
    pub loads: Vec<Spanned<LoadTable>>,
}

/// `shape = { rectangle = { … } }`.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ShapeTable {
    /// Axis-parallel rectangle.
    Rectangle(Keyed<RectangleTable>),
    /// A disc, or a sector of it.
    Disc(Keyed<DiscTable>),
    /// Sector of a ring from the downward vertical.
    Ring(Keyed<RingTable>),
    /// Blocks that share whole sides.
    Blocks(Vec<Spanned<Keyed<BlockTable>>>),
    /// A physical group of a Gmsh mesh.
    Gmsh(Keyed<GmshTable>),
}

impl ShapeTable {
    /// The mesh that it is read from, named in a scene file.
    pub fn mesh(&self, scene: &Path) -> Option<PathBuf> {
        match self {
            Self::Gmsh(table) => Some(table.path(scene)),
            _ => None,
        }
    }
}

/// `{ corners = [[x, y], …], elements = [n, m], bottom = "contact", … }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BlockTable {
    /// Corners, counter-clockwise.
    pub corners: List<Pair>,
    /// Elements from left to right and from bottom to top.
    pub elements: List<Spanned<usize>>,
    /// Size ratio of neighbouring elements, from left to right and from bottom to top.
    pub growth: Option<Pair>,
    /// Boundary of the first side.
    pub bottom: Option<Name>,
    /// Boundary of the second side.
    pub right: Option<Name>,
    /// Boundary of the third side.
    pub top: Option<Name>,
    /// Boundary of the fourth side.
    pub left: Option<Name>,
    /// Centres of the sides that are arcs.
    #[serde(default)]
    pub arcs: Keyed<ArcsTable>,
}

/// `arcs = { bottom = [x, y] }`: centres.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ArcsTable {
    /// Of the first side.
    pub bottom: Option<Pair>,
    /// Of the second side.
    pub right: Option<Pair>,
    /// Of the third side.
    pub top: Option<Pair>,
    /// Of the fourth side.
    pub left: Option<Pair>,
}

/// `gmsh = { file = "mesh.msh", group = "roller", contact = "arc" }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GmshTable {
    /// The file, from the folder of the scene file.
    pub file: Name,
    /// Physical surface that is the body.
    pub group: Name,
    /// Physical curve that carries the contact.
    pub contact: Name,
}

impl GmshTable {
    /// Where the mesh of a scene file is.
    pub fn path(&self, scene: &Path) -> PathBuf {
        scene.parent().unwrap_or(Path::new("")).join(self.file.get_ref())
    }
}

/// `rectangle = { x = [left, right], y = [lower, upper], contact = "bottom" }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RectangleTable {
    /// Left and right end.
    pub x: Pair,
    /// Lower and upper end.
    pub y: Pair,
    /// Side called `contact`: bottom or top.
    pub contact: Name,
}

/// `disc = { centre = [x, y], radius = R, half = false, whole = false }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DiscTable {
    /// Centre.
    pub centre: Pair,
    /// Radius.
    pub radius: Number,
    /// The right half instead of the lower right quarter.
    pub half: Option<Spanned<bool>>,
    /// All of it instead of the lower half, where the contact has both sides.
    pub whole: Option<Spanned<bool>>,
    /// Side that carries the contact: bottom, unless it is top.
    pub contact: Option<Name>,
}

/// `ring = { centre = [x, y], inner = R₁, outer = R₂, sweep = 180, contact = "inner" }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RingTable {
    /// Centre of both circles.
    pub centre: Pair,
    /// Inner radius.
    pub inner: Number,
    /// Outer radius.
    pub outer: Number,
    /// Angle swept from the downward vertical, counter-clockwise \[°\].
    pub sweep: Number,
    /// Side that carries the contact: inner or outer.
    pub contact: Name,
}

/// `{ at = "left", component = "x", value = 0.0 }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SupportTable {
    /// Where.
    pub at: Spanned<PlaceTable>,
    /// x or y.
    pub component: Name,
    /// Prescribed displacement; zero where it is left out.
    pub value: Option<Number>,
}

/// A boundary's name, or a point.
#[derive(Debug, Deserialize, PartialEq)]
#[serde(untagged, expecting = "a place is the name of a boundary or a point [x, y]")]
pub enum PlaceTable {
    /// Boundary.
    Boundary(String),
    /// The node at a point.
    Point(Vec<f64>),
}

/// `[contact]`, or one of several `[[contact]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct ContactTable {
    /// Name in messages, results and checks: of the bodies where it is left out.
    pub name: Option<Name>,
    /// Body on which positions and areas are measured.
    pub first: Name,
    /// Boundary of it that touches: `contact` where it is left out.
    pub first_side: Option<Name>,
    /// The primary body; a rigid one where it is left out.
    pub second: Option<Name>,
    /// Boundary of that one.
    pub second_side: Option<Name>,
    /// Initial gap along the path.
    pub gap: Spanned<GapTable>,
    /// The gap is the one given even where the bodies are drawn with another; false where it is left out.
    pub gap_only: Option<Spanned<bool>>,
    /// The path is an arc: contact coordinates are angles from the downward vertical \[°\].
    pub arc: Option<Keyed<CircleTable>>,
    /// Where s = 0 lies on a straight path; [0, 0] where it is left out.
    pub origin: Option<Pair>,
    /// Candidates lie from 0 to here, on both sides where it has both: a length, or degrees on an arc.
    pub stretch: Number,
    /// The contact lies on both sides of s = 0; false where it is left out.
    pub both_sides: Option<Spanned<bool>>,
    /// The scene shows half of a symmetric problem; true where it is left out and the contact has one side.
    pub symmetric: Option<Spanned<bool>>,
    /// The closed form that checks without a value are held against.
    pub oracle: Option<Spanned<OracleTable>>,
}

/// The contacts of a file: one table, or several.
#[derive(Debug)]
pub struct ContactTables(pub Vec<ContactTable>);

impl<'de> Deserialize<'de> for ContactTables {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OneOrMore;
        impl<'de> Visitor<'de> for OneOrMore {
            type Value = ContactTables;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a table [contact], or several [[contact]]")
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
                let one = ContactTable::deserialize(MapAccessDeserializer::new(map))?;
                Ok(ContactTables(vec![one]))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Self::Value, A::Error> {
                let several: Vec<Keyed<ContactTable>> = Vec::deserialize(SeqAccessDeserializer::new(list))?;
                Ok(ContactTables(several.into_iter().map(|one| one.0).collect()))
            }
        }
        deserializer.deserialize_any(OneOrMore)
    }
}

impl ContactTable {
    /// Whether the contact lies on both sides of s = 0.
    pub fn has_both_sides(&self) -> bool {
        self.both_sides.as_ref().is_some_and(|given| *given.get_ref())
    }
}

/// `arc = { centre = [x, y], radius = R }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CircleTable {
    /// Centre.
    pub centre: Pair,
    /// Radius.
    pub radius: Number,
}

/// `[reference]`: what makes initial stiffnesses pure numbers, and what springs start from.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReferenceTable {
    /// ℓ.
    pub length: Option<Number>,
    /// p_ref.
    pub pressure: Option<Number>,
    /// g_ref.
    pub gap: Option<Number>,
}

/// `[mesh.growth]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GrowthTable {
    /// Size ratio of neighbours beyond the candidates.
    pub along: Option<Number>,
    /// Size ratio of neighbours into the depth.
    pub depth: Option<Number>,
    /// Coarsest element over the size of the body.
    pub coarsest: Option<Number>,
    /// Height of the first element over its width.
    pub first: Option<Number>,
    /// Last candidate element over the first.
    pub end: Option<Number>,
}
