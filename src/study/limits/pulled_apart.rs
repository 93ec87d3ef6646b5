//! Limit of the load: it pulls the cylinder off the plane, and every spring opens.

use serde::Serialize;

use crate::case::library::Cylinder;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::scene::Load;
use crate::solution::Outcome;
use crate::solve::{Discretisation, Formulation};
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::{Why, told};
use crate::study::limits::solved::{OfNine, count, meshed, nine};

/// What the nine formulations make of the reversed load.
#[derive(Clone, Debug, Serialize)]
pub struct PulledApart {
    /// In the order of the nine.
    pub runs: Vec<OfNine>,
}

/// The cylinder, its load reversed.
pub(super) fn run() -> Result<PulledApart, Error> {
    Ok(PulledApart { runs: nine(&cylinder(-1.0)?) })
}

/// The cylinder under its load times a factor.
pub(super) fn cylinder(factor: f64) -> Result<Discretisation, Error> {
    let mut scene = Cylinder::default().scene();
    for load in scene.bodies.iter_mut().flat_map(|body| &mut body.loads) {
        if let Load::Traction { traction, .. } = load {
            *traction = traction.map(|t| t * factor);
        }
    }
    meshed(scene, 8, Order::Quadratic)
}

impl PulledApart {
    /// Runs that name the loss of the last spring, and runs that used up their iterations.
    fn ends(&self) -> [f64; 2] {
        let named = count(&self.runs, |run| run.seen.is_refused(Why::NoSpringLeft));
        [named, count(&self.runs, |run| run.seen.is(Outcome::Capped))]
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let ([named, capped], all) = (self.ends(), self.runs.len());
        vec![
            Check::none(
                Quantity::at(
                    "run that ends neither in the error of a lost spring nor at the cap of its iterations",
                    format!("of {all}"),
                ),
                "nothing balances the load",
            )
            .judge((all as f64 - named - capped).abs()),
            Check::at_least(
                "number of runs that end in the error of a lost spring",
                Reference::own("varying stiffness and kinematic load", 6.0),
                "constant stiffness never opens a spring: it runs until its iterations are used up",
            )
            .judge(named),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let [named, capped] = self.ends();
        let [message, remedy] = told(self.runs.iter().find_map(|run| run.seen.refusal()));
        Limit {
            pushed: "a body supported by contact alone, every spring open",
            range: "the load of the cylinder, reversed".into(),
            onset: "once the last spring is open".into(),
            seen: format!("{named} of {}: {message}; {capped}: {}", self.runs.len(), Outcome::Capped),
            instead: remedy,
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        let row = |run: &OfNine| vec![Formulation::new(run.element, run.algorithm).name(), run.seen.to_string()];
        Detail::of("Cylinder pulled off the plane", &["formulation", "what the user sees"], self.runs.iter().map(row))
    }
}
