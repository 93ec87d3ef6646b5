//! Limits of validity: each trial pushes one thing until it fails, and measures the onset.
//!
//! A function a limit, from the scene to its row of the table; in a folder, since thirteen of them are no page of one
//! file.
//!
//! * `push` — one parameter pushed, what was found at every value of it, and how the page says it.
//! * `springs` — Gauss points on an edge, stiffness against digits, layer thickness, a rule that cycles.
//! * `loads` — loads of the wrong sign, of zero, too small for the mesh; candidates and bodies that end before the
//!   contact.
//! * `meshes` — cells that lock or are distorted; meshes that differ on the two sides.

mod loads;
mod meshes;
mod push;
mod springs;

use crate::case::Judged;
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::study::about::{About, Found, Planned, Study};

pub use push::Limit as Numbers;

impl Study for Numbers {
    const NAME: &'static str = "limits";
    const ABOUT: About = About {
        title: "Limits of validity",
        asked: "Where everything but the methods stops being right, and what the user then sees.",
        limits: "One scene a limit: another scene has its onset elsewhere. Bodies of revolution about y = 0 cannot be \
            exported: other codes turn them about x = 0.",
    };

    /// A trial for each limit.
    fn plan() -> Vec<Planned<Self>> {
        LIMITS.into_iter().map(|(name, run)| Planned::new("limits", name, run)).collect()
    }

    fn judge(&self) -> Result<Vec<Judged>, Error> {
        Ok(self.judged.clone())
    }

    /// The table of limits, and a folded table of the values tried for each.
    fn section(findings: &[Found<Self>]) -> Result<String, Error> {
        let limits = || findings.iter().map(|found| found.numbers);
        let behind: String =
            limits().filter(|limit| !limit.table.is_empty()).map(|limit| format!("\n{}", limit.table)).collect();
        Ok(format!(
            "Each row pushes one thing until it fails. What the user sees is what the program said in that \
            run.\n\n{}{behind}",
            markdown::columns(&COLUMNS, limits())
        ))
    }
}

/// Name of a trial, and what pushes.
type Trial = (&'static str, fn() -> Result<Numbers, Error>);

/// The limits, in the order of the page.
const LIMITS: [Trial; 13] = [
    ("three Gauss points", springs::gauss_points),
    ("spring stiffness", springs::stiffness),
    ("supported by contact alone", loads::pulled_apart),
    ("zero load", loads::no_load),
    ("load too small for the mesh", loads::small_load),
    ("candidates too short", loads::short_candidates),
    ("surface too short", loads::body_end),
    ("near incompressibility", meshes::incompressible),
    ("distorted cells", meshes::distorted),
    ("element sizes across the interface", meshes::unequal_sizes),
    ("non-matching meshes", meshes::non_matching),
    ("layer thickness", springs::layer_thickness),
    ("cycling", springs::cycling),
];

/// Columns of the table of limits.
const COLUMNS: [Column<Numbers>; 5] = [
    ("what is pushed", |limit| limit.pushed.into()),
    ("range tried", |limit| limit.range.clone()),
    ("measured onset", |limit| limit.onset.clone()),
    ("what the user sees", |limit| limit.seen.clone()),
    ("what to do instead", |limit| limit.instead.clone()),
];
