//! A run is within the bound of its error; recovered stresses carry the load.

use crate::case::{Check, Judged, Quantity, Reference, universal};
use crate::error::Error;
use crate::study::fields::run::{Along, Field, Numbers, Resultant, Where};

/// Difference of hoop stresses that is accepted.
const HOOP: f64 = 0.03;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Path(run) => universal::bounded(run).into_iter().collect(),
        Numbers::Along(along) => vec![agrees(along)],
        Numbers::Field(field) => field.resultants.iter().map(|resultant| carries(field, resultant)).collect(),
    })
}

/// What the paper says of its Figs 14 and 15: a reasonable agreement of the different solutions.
fn agrees(along: &Along) -> Judged {
    Check::error(
        "hoop stress along pin and rod, largest difference over the largest",
        Reference::own("node elements with kinematic load", 0.0),
        HOOP,
        "elements weight the last of the contact differently, and the stress at its edge bends sharply",
    )
    .judge(along.off)
}

/// The vertical resultant of the recovered stresses is the load.
fn carries(field: &Field, resultant: &Resultant) -> Judged {
    let (name, tolerance, because) = match resultant.on {
        Where::Contact => (
            "force of the recovered stresses on the contact [N]",
            1e-2,
            "trapezoids between nodes, nodal means of the cells; the edge of the contact lies inside an element",
        ),
        Where::Cut => {
            ("force of the recovered stresses on the cut [N]", 5e-3, "nodal means of the cells, which are coarse there")
        }
    };
    let load = Reference::own("load", field.load);
    Check::near(Quantity::at(name, resultant.body.clone()), load, tolerance, because).judge(resultant.force)
}
