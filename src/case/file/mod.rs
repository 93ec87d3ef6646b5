//! A scene as a user writes it: a TOML file, every mistake of which is told with its place and what to do.
//!
//! * `form` — which keys a table has, and what their values are: stated as data beside the function that reads the
//!   table, and held against the file before anything is read.
//! * `value` — a value by its key, in the units of the scene; its place is looked up where something is wrong.
//! * `source` — the text, in whatever letters, `units` — names of units.
//! * `named` — bodies, boundaries, points and supports by their names.
//! * `document` — the whole file.
//! * `bodies` — `[[body]]`, with `blocks` and `mesh_file` (meshes of other programs) for its shape, `loads`.
//! * `contact` — `[contact]`: its bodies, their sides (`side`, `curves`) and the path; `gap` — its gap, also against
//!   the drawn one; `oracle` — its closed form, `hypotheses` — what that takes for granted.
//! * `revolution` — what bodies of revolution have otherwise.
//! * `mesh`, `reference`, `solve`, `wanted` — `[mesh]`, `[reference]`, `[solve]`, `[[check]]`.
//! * `places` — where things are in the file, for mistakes that show later.
//! * `unsupported` — physics that is not done here.
//! * `folder` — the files of a folder.
//!
//! Lengths, forces and stresses are in the units the file names, angles in degrees; the scene is in mm, N, MPa and
//! radians.

mod blocks;
mod bodies;
mod contact;
mod curves;
mod document;
mod folder;
mod form;
mod gap;
mod hypotheses;
mod loads;
mod mesh;
mod mesh_file;
mod named;
mod oracle;
mod places;
mod reference;
mod revolution;
mod side;
mod solve;
mod source;
mod units;
mod unsupported;
mod value;
mod wanted;

pub use document::schema;
pub use folder::files_in;
pub use places::Places;
pub use source::text_of;
