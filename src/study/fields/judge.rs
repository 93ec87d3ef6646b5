//! A run is within the bound of its error; recovered stresses carry the load.

use crate::case::{Check, Judged, Quantity, Reference, universal};
use crate::error::Error;
use crate::study::fields::run::{Field, Numbers, Resultant, Where};

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Path(run) => universal::bounded(run).into_iter().collect(),
        Numbers::Field(field) => field.resultants.iter().map(|resultant| carries(field, resultant)).collect(),
    })
}

/// The vertical resultant of the recovered stresses is the load.
fn carries(field: &Field, resultant: &Resultant) -> Judged {
    let (name, tolerance, because) = match resultant.on {
        Where::Contact => (
            "force of the recovered stresses on the contact [N]",
            1e-2,
            "trapezoids between nodes, nodal means of the cells; the edge of the contact lies inside an element",
        ),
        Where::Cut => ("force of the recovered stresses on the cut [N]", 5e-3, "nodal means of the cells, which are coarse there"),
    };
    let load = Reference::own("load", field.load);
    Check::near(Quantity::at(name, resultant.body.clone()), load, tolerance, because).judge(resultant.force)
}
