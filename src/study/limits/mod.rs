//! Limits of validity: each trial pushes one thing until it fails, and measures the onset.
//!
//! * `plan` — the list of limits: a line and a file each.
//! * `gauss_points` — three Gauss points on an edge.
//! * `springs` — stiffness against digits.
//! * `pulled_apart`, `no_load`, `small_load` — loads of the wrong sign, of zero, too small for the mesh.
//! * `short_candidates`, `body_end` — candidates and bodies that end before the contact.
//! * `incompressible`, `distorted` — cells.
//! * `unequal_sizes`, `non_matching` — meshes that differ on the two sides.
//! * `layer_thickness`, `cycling` — parameters and rules.
//! * `large_contact` — a/R, where it is the reference that fails.
//! * `seen` — what the user sees of a run.
//! * `solved` — scenes meshed and solved, and their errors.
//! * `written` — numbers in words.
//! * `row` — a row of the table of limits, and the table behind it.
//! * `section` — the table and what is behind it.

mod body_end;
mod cycling;
mod distorted;
mod gauss_points;
mod incompressible;
mod large_contact;
mod layer_thickness;
mod no_load;
mod non_matching;
mod plan;
mod pulled_apart;
mod row;
mod section;
mod seen;
mod short_candidates;
mod small_load;
mod solved;
mod springs;
mod unequal_sizes;
mod written;

use crate::study::about::About;

pub use plan::{Numbers, judge, plan};
pub use row::{Detail, Limit};
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Limits of validity",
    asked: "Where everything but the methods stops being right, and what the user then sees.",
    limits: "One scene a limit: another scene has its onset elsewhere.",
};
