//! Reactions as they are told: by the name of the body and the place of the support.

use serde::Serialize;

use crate::error::Error;
use crate::scene::{BoundaryName, Component, Place};
use crate::solve::Run;
use crate::solve::{Discretisation, Reaction};

/// What a support exerts on the modelled part of its body.
#[derive(Clone, Debug, Serialize)]
pub struct ReactionReading {
    /// Name of the body.
    pub body: String,
    /// Where the support is.
    pub at: At,
    /// Which component it holds: `x` or `y`.
    pub component: &'static str,
    /// Force on the body along that component, positive along x or y \[N\].
    pub force: f64,
}

/// Boundary by name, or a point \[mm\].
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum At {
    /// Boundary.
    Boundary(BoundaryName),
    /// Point.
    Point([f64; 2]),
}

impl std::fmt::Display for At {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Boundary(name) => f.write_str(name),
            Self::Point([x, y]) => write!(f, "({x}, {y})"),
        }
    }
}

/// A place as it is told.
pub fn at(place: &Place) -> At {
    match place {
        Place::Boundary(name) => At::Boundary(name.clone()),
        Place::Point(point) => At::Point(*point),
    }
}

/// Name of a component.
pub fn component(component: Component) -> &'static str {
    match component {
        Component::X => "x",
        Component::Y => "y",
    }
}

/// The reaction of every support, body by body in the order of the scene.
pub fn readings(discretisation: &Discretisation, run: &Run) -> Result<Vec<ReactionReading>, Error> {
    let reading = |reaction: Reaction| {
        let body = &discretisation.scene.bodies[reaction.body];
        let support = &body.supports[reaction.support];
        ReactionReading {
            body: body.name.clone(),
            at: at(&support.at),
            component: component(support.component),
            force: reaction.force,
        }
    };
    Ok(discretisation.reactions_under(run.share(), &run.solution)?.into_iter().map(reading).collect())
}
