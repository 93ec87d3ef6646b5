//! What no mesh is fitted to, and what to do.

use crate::error::Error;
use crate::scene::Scene;

/// What to do where a mesh cannot be fitted.
pub(super) const REMEDY: &str = "leave out --fitted";

/// Refuses meshes made elsewhere.
pub(super) fn refuse_given(scene: &Scene) -> Result<(), Error> {
    let given = scene.bodies.iter().position(|body| body.shape.has_given_mesh());
    given.map_or(Ok(()), |body| {
        let message = "--fitted cannot be used: the mesh of this body is given, and its lines stay where they are";
        Err(Error::at(scene.place_of_body(body), message, format!("{REMEDY}, or give the body another shape")))
    })
}

/// An error that another mesh than that of the scene brought about.
pub(super) fn on_fitted(error: Error) -> Error {
    let message = format!("{} (on a mesh that --fitted makes)", error.message);
    let remedy = format!("{}; or {REMEDY}", error.remedy);
    Error { message, remedy, ..error }
}
