//! So many digits of peak and second-moment width for so many degrees of freedom, under the worst of all loads, and five of other scenes.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::solve::Fitted;
use crate::study::fitted::plan::{ASKED, Asked};
use crate::study::fitted::run::{Cells, Mesh, Numbers};
use crate::study::fitted::scenes::{self, Elsewhere};

/// The checks; a mesh that was not solved has no number that could pass.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let elsewhere = numbers.scenes.iter().flat_map(elsewhere);
    Ok(ASKED.iter().flat_map(|asked| of(asked, numbers)).chain(elsewhere).collect())
}

/// Five digits of another scene.
fn elsewhere(one: &Elsewhere) -> [Judged; 3] {
    let (most, dofs) = scenes::ASKED;
    let reference = || match one.exact {
        true => Reference::analytic("its closed form", 0.0),
        false => Reference::own("cells of order 8, three layers", 0.0),
    };
    let error = |name: &'static str, value: f64| {
        let because = "five digits of a contact that no mesh knew the ends of";
        Check::error(Quantity::at(name, one.scene.clone()), reference(), most, because).judge(value)
    };
    let cost = Quantity::at("degrees of freedom of a mesh fitted to the contact", one.scene.clone());
    let bound = Reference::own("asked of five digits", dofs as f64);
    [
        error("relative error of the peak pressure on a mesh fitted to the contact", one.peak),
        error("relative error of the second-moment width on a mesh fitted to the contact", one.half_width),
        Check::at_most(cost, bound, "an accuracy counts only with what it costs").judge(one.dofs as f64),
    ]
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
        error("relative error of the second-moment width on a mesh fitted to the contact", |mesh| mesh.half_width),
        dofs.judge(value(|mesh| mesh.dofs as f64)),
    ]
}
