//! So many digits of peak and half-width for so many degrees of freedom, under the worst of all loads.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::solve::Fitted;
use crate::study::fitted::plan::{ASKED, Asked};
use crate::study::fitted::run::{Cells, Mesh, Numbers};

/// The checks; a mesh that was not solved has no number that could pass.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(ASKED.iter().flat_map(|asked| of(asked, numbers)).collect())
}

fn of(asked: &Asked, numbers: &Numbers) -> [Judged; 3] {
    let fitted = Fitted::of_digits(asked.digits);
    let mesh = numbers.fitted.iter().find(|mesh| mesh.cells == Cells::Fitted(fitted));
    let value = |of: fn(&Mesh) -> f64| mesh.map_or(f64::NAN, of);
    let at = format!("order {}, layers {}", fitted.order.number(), fitted.layers);
    let error = |name: &'static str, of: fn(&Mesh) -> f64| {
        let because = "what the order and the layers are chosen for; the worst of all loads";
        Check::error(Quantity::at(name, at.clone()), Reference::analytic("Hertz", 0.0), asked.error, because)
            .judge(value(of))
    };
    let dofs = Quantity::at("degrees of freedom of a mesh fitted to the contact", at.clone());
    let bound = Reference::own("asked of this accuracy", asked.dofs as f64);
    let dofs = Check::at_most(dofs, bound, "an accuracy counts only with what it costs");
    [
        error("relative error of the peak pressure on a mesh fitted to the contact", |mesh| mesh.peak),
        error("relative error of the half-width on a mesh fitted to the contact", |mesh| mesh.half_width),
        dofs.judge(value(|mesh| mesh.dofs as f64)),
    ]
}
