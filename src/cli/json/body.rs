//! What one body came to, as JSON.

use schemars::JsonSchema;
use serde::Serialize;

use crate::cli::solve::found::Found;
use crate::solve::VonMises;

use super::Number;

/// What one body came to.
#[derive(Serialize, JsonSchema)]
pub struct Body<'a> {
    /// Its name.
    name: &'a str,
    /// Largest von Mises stress, with the stress across the plane; null where it lies beside a place at which stresses have no limit. Its bar
    /// is among `error_bars`.
    von_mises: Number,
    /// Where that is: x and y.
    #[serde(skip_serializing_if = "Option::is_none")]
    von_mises_at: Option<[Number; 2]>,
    /// Places at which the stress has no limit.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    without_limit: Vec<WithoutLimit>,
}

/// A place at which the stress of a body has no limit.
#[derive(Serialize, JsonSchema)]
struct WithoutLimit {
    /// What makes it so.
    because: &'static str,
    /// Where: x and y.
    at: [Number; 2],
}

impl<'a> Body<'a> {
    /// One of a solve.
    pub fn of(found: &'a Found, VonMises { body, largest, without_limit }: &VonMises) -> Self {
        let place = |at: [f64; 2]| at.map(Number::from);
        let points = &found.discretisation.mesh.points;
        let without_limit =
            without_limit.iter().map(|one| WithoutLimit { because: one.because, at: place(points[one.node]) });
        Self {
            name: &found.problem.scene.bodies[*body].name,
            von_mises: largest.map(|largest| largest.stress).into(),
            von_mises_at: largest.map(|largest| place(largest.at)),
            without_limit: without_limit.collect(),
        }
    }
}
