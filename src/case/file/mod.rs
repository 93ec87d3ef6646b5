//! A scene as a user writes it: tables of a TOML file, every value with its place.
//!
//! * [`tables`] — the keys.
//! * `source` — the text, its values checked and its mistakes told with their place.
//! * [`values`] — values with their places.
//! * [`units`] — names of units, and numbers in them.
//! * [`bodies`] — outlines and supports, `loads` — loads, [`load_keys`] — their keys.
//! * `named` — boundaries, points and components by their names.
//! * `blocks` — bodies from blocks.
//! * `compared` — the gap given against the drawn one.
//! * `curves` — the sides of shapes.
//! * `displaced` — the side or point whose displacement a check asks for.
//! * `disc` — how much of a disc is modelled.
//! * `gmsh` — bodies from meshes.
//! * `hertz_load` — Hertz's stresses as a load.
//! * [`contact`] — contacts, their bodies, sides and paths.
//! * `side` — the side of a body that carries a contact.
//! * `gap` — the gap of a contact.
//! * [`gap_keys`] — its keys.
//! * `reference` — reference values.
//! * [`document`] — the whole file, `scene` — its scene.
//! * `folder` — the files of a folder.
//! * [`oracle`] — the closed form of a contact, `hypotheses` — what it takes for granted.
//! * `mesh` — `[mesh]`.
//! * `wanted` — the checks, `support` — the support of one.
//! * [`places`] — where things are in the file.
//! * [`unsupported`] — physics that is not done here.
//!
//! Lengths, forces and stresses are in the units the file names, angles in degrees; the scene is in mm, N, MPa and radians.

mod blocks;
pub mod bodies;
mod compared;
pub mod contact;
mod curves;
mod disc;
mod displaced;
pub mod document;
mod folder;
mod gap;
pub mod gap_keys;
mod gmsh;
mod hertz_load;
mod hypotheses;
pub mod load_keys;
mod loads;
mod mesh;
mod named;
pub mod oracle;
pub mod places;
mod reference;
mod scene;
mod side;
mod source;
mod support;
pub mod tables;
pub mod units;
pub mod unsupported;
pub mod values;
mod wanted;

pub use folder::{files_in, nearest_to};
pub use places::Places;
pub use source::Source;
