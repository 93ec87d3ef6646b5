//! Reactions as they are told: by the name of the body and the place of the support.

use schemars::JsonSchema;
use serde::Serialize;

use crate::error::Error;
use crate::scene::Place;
use crate::solve::Run;
use crate::solve::{Discretisation, Reaction};

/// What a support exerts on the modelled part of its body.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ReactionReading {
    /// Name of the body.
    pub body: String,
    /// Where the support is: the name of a boundary, or the point of a node.
    #[schemars(with = "Where")]
    pub at: Place,
    /// Which component it holds: `x` or `y`.
    pub component: &'static str,
    /// Force on the body along that component, positive along x or y \[N\].
    pub force: f64,
}

/// A place as JSON has it.
#[derive(JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "it only describes how a place is written")]
enum Where {
    /// A boundary of the body.
    Boundary(String),
    /// The node at a point.
    Point([f64; 2]),
}

/// The reaction of every support, body by body in the order of the scene.
pub fn readings(discretisation: &Discretisation, run: &Run) -> Result<Vec<ReactionReading>, Error> {
    let reading = |reaction: Reaction| {
        let body = &discretisation.scene.bodies[reaction.body];
        let support = &body.supports[reaction.support];
        ReactionReading {
            body: body.name.clone(),
            at: support.at.clone(),
            component: support.component.name(),
            force: reaction.force,
        }
    };
    Ok(discretisation.reactions_under(run.share(), &run.solution)?.into_iter().map(reading).collect())
}
