//! Problems that have no solution on a discretised scene, refused with the names of their bodies.

use crate::algorithm::Acceleration;
use crate::algorithm::ContactProblem;
use crate::error::{Error, Kind, Part, Place};
use crate::scene::Scene;
use crate::solution::Work;
use crate::solve::{Change, Discretisation, Formulation};

/// Most contact points of which Newton's method keeps its matrix, a number for every two of them.
const DENSE: usize = 8000;

impl Formulation {
    /// Refuses an acceleration whose matrix would not fit.
    pub(super) fn refuse_dense(&self, scene: &Scene, points: usize) -> Result<(), Error> {
        if self.acceleration == Acceleration::None || points <= DENSE {
            return Ok(());
        }
        let bytes = 8.0 * (points as f64).powi(2);
        let message = format!("{} has a matrix of all {points} contact points, {bytes:.1e} bytes", self.name());
        Err(Error::at(scene.name.as_str(), message, "ask for kinematic load, or for no acceleration"))
    }
}

/// A condensed load below this fraction of the loads on the bodies is round-off of the condensation.
const UNLOADED: f64 = 1e-13;

impl Discretisation {
    /// Refuses a formulation that is not defined for this scene after a change.
    pub(super) fn refuse_undefined(&self, formulation: &Formulation, change: Change) -> Result<(), Error> {
        formulation.validate(&self.scene)?;
        change.validate(&self.scene.name)?;
        formulation.refuse_interference(&self.scene, self.tightest_gap() + change.clearance)
    }

    /// Smallest initial gap of a candidate node \[mm\].
    fn tightest_gap(&self) -> f64 {
        let nodes = self.interfaces.iter().flat_map(|interface| &interface.nodes);
        nodes.map(|node| node.gap).fold(f64::INFINITY, f64::min)
    }

    /// Refuses a problem in which nothing presses and springs alone would hold the bodies.
    pub(super) fn refuse_nothing(&self, problem: &ContactProblem) -> Result<(), Error> {
        let held = || problem.factorise(&vec![0.0; problem.points.len()], &mut Work::default()).is_some();
        if self.is_unloaded(problem.load) && !held() && !problem.interference_presses() {
            let error = self.unheld(1.0)?.unwrap_or_else(|| {
                let message = "only contact fixes the bodies, and nothing presses them together: the pressure is zero and the position undetermined";
                Error::at(self.contacts(), message, "apply a load or add a support")
            });
            return Err(Error { kind: Kind::NothingPresses, ..error });
        }
        Ok(())
    }

    /// Whether a condensed load is no more than round-off of the loads on the bodies.
    fn is_unloaded(&self, condensed: &[f64]) -> bool {
        let sum = |forces: &[f64]| forces.iter().map(|f| f.abs()).sum::<f64>();
        sum(condensed) <= UNLOADED * self.system.bodies.iter().map(|body| sum(&body.force)).sum::<f64>()
    }

    /// An error of the iteration, which sees matrices only, with what is not held, or with the names of the bodies.
    pub(super) fn named(&self, error: Error, load: f64) -> Error {
        match error.kind {
            Kind::NoSpringLeft { .. } | Kind::SpringsTooSoft => {}
            _ => return error,
        }
        match (self.unheld(load), error.kind) {
            (Err(other), _) => other,
            (Ok(Some(unheld)), Kind::NoSpringLeft { iterations }) => {
                let message = format!("no contact spring is left after iteration {iterations}: {}", unheld.message);
                Error { kind: error.kind, message, ..unheld }
            }
            (Ok(Some(unheld)), _) => unheld,
            (Ok(None), Kind::SpringsTooSoft) => Error { place: Place::Stiffness(self.names()), ..error },
            (Ok(None), _) => Error { place: self.contacts(), ..error },
        }
    }

    /// All contacts: the first of them, by the names of all bodies.
    fn contacts(&self) -> Place {
        Place::Contact { contact: 0, part: Part::First, name: self.names().into() }
    }

    /// Names of the bodies, as messages give them.
    fn names(&self) -> String {
        let bodies = self.scene.bodies.iter().map(|body| format!("`{}`", body.name));
        bodies.collect::<Vec<_>>().join(" and ")
    }
}
