//! Limit of the load: none, on a body that only contact supports and on bodies that are fixed.

use serde::Serialize;

use crate::case::library::Bars;
use crate::case::{Check, Judged, Reference};
use crate::error::Error;
use crate::mesh::Order;
use crate::solution::Outcome;
use crate::study::limits::pulled_apart::cylinder;
use crate::study::limits::row::{Detail, Limit};
use crate::study::limits::seen::{Why, told};
use crate::study::limits::solved::{OfNine, count, meshed, nine};

/// What the nine formulations make of no load.
#[derive(Clone, Debug, Serialize)]
pub struct NoLoad {
    /// On the cylinder, which only contact supports.
    pub cylinder: Vec<OfNine>,
    /// On two bars, which are fixed.
    pub bars: Vec<OfNine>,
}

/// Both scenes.
pub(super) fn run() -> Result<NoLoad, Error> {
    let mut scene = Bars::default().scene();
    scene.bodies.iter_mut().flat_map(|body| &mut body.supports).for_each(|support| support.value = 0.0);
    Ok(NoLoad { cylinder: nine(&cylinder(0.0)?), bars: nine(&meshed(scene, 2, Order::Quadratic)?) })
}

impl NoLoad {
    /// Formulations that refuse the cylinder by name, and those that find no pressure between the bars.
    fn right(&self) -> [f64; 2] {
        let named = count(&self.cylinder, |run| run.seen.is_refused(Why::NothingPresses));
        [named, count(&self.bars, |run| run.seen.is(Outcome::Converged) && run.pressure <= 0.0)]
    }

    pub(super) fn judge(&self) -> Vec<Judged> {
        let [named, silent] = self.right();
        let all = || Reference::own("all nine", self.cylinder.len() as f64);
        vec![
            Check::at_least(
                "number of formulations that refuse a body without a load supported by contact alone",
                all(),
                "its position is undetermined",
            )
            .judge(named),
            Check::at_least(
                "number of formulations that converge to no pressure between fixed bodies without a load",
                all(),
                "the bars do not touch: p = 0 exactly, whatever the formulation",
            )
            .judge(silent),
        ]
    }

    pub(super) fn limit(&self) -> Limit {
        let ([named, silent], all) = (self.right(), self.cylinder.len());
        let [message, remedy] = told(self.cylinder.iter().find_map(|run| run.seen.refusal()));
        let bars = self.bars.first().map(|run| run.seen.to_string()).unwrap_or_default();
        Limit {
            pushed: "no load",
            range: "cylinder on a plane; two fixed bars".into(),
            onset: format!(
                "zero: {named} of {all} formulations refuse the cylinder, {silent} find no pressure between the bars"
            ),
            seen: format!("cylinder: {message}; bars: {bars}"),
            instead: remedy,
        }
    }

    pub(super) fn detail(&self) -> Option<Detail> {
        None
    }
}
