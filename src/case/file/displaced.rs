//! The side or the point whose displacement a check asks for.

use serde::Deserialize;
use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::named;
use crate::case::file::tables::{Name, PlaceTable};
use crate::case::file::units::Units;
use crate::error::Error;
use crate::scene::Scene;
use crate::solve::Displaced;

/// `of = { body = "…", at = "…", component = "…" }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DisplacedName {
    body: Name,
    at: Spanned<PlaceTable>,
    component: Name,
}

impl DisplacedName {
    /// What is meant in a scene; what does not exist is told with its line and what there is.
    pub(super) fn find(&self, source: Source, units: &Units, scene: &Scene) -> Result<Displaced, Error> {
        let body = find_body(source, &self.body, scene)?;
        let at = named::place(source, units, &scene.bodies[body].shape, &self.at)?;
        Ok(Displaced { body, at, component: named::component(source, &self.component)? })
    }
}

/// Index of the body of a name.
pub(super) fn find_body(source: Source, name: &Name, scene: &Scene) -> Result<usize, Error> {
    let names: Vec<_> = scene.bodies.iter().enumerate().map(|(index, body)| (body.name.as_str(), index)).collect();
    source.choice("body", name, &names)
}
