//! The accuracy asked is met, and truly, by a mesh hardly larger than one made by hand.

use crate::case::solved::estimated;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::accuracy::run::Numbers;

/// Degrees of freedom allowed over those of the mesh made by hand: bars are some times the errors, and of order 3/2 or 2 in the elements.
const ALLOWED: f64 = 4.0;
/// The same for all meshes together.
const IN_ALL: f64 = 20.0;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let &Numbers { asked, met, estimate, by_hand, .. } = numbers;
    let closed_form = || Reference::analytic("the closed form", 0.0);
    let own = |name: &str, value: f64| Reference::own(name, value);
    let larger = |name: &'static str| Quantity::at(name, "larger one of peak and second-moment width");
    let promised = if met { estimate } else { f64::NAN };
    let most = |times: f64| {
        own(&format!("{times} times those of the mesh made by hand"), (times * by_hand.dofs as f64).floor())
    };
    let in_all = Quantity::at("degrees of freedom of all meshes solved", "");
    let shown = "the accuracy asked; the finer mesh shows what the closed form leaves out";
    let loads = "eight loads move the contact edge across one element";
    Ok(vec![
        estimated(promised, asked),
        Check::error(larger("true error"), closed_form(), asked, shown).judge(numbers.closed_form),
        Check::error(larger("true error"), own("a mesh far finer", 0.0), promised, "the estimate").judge(numbers.finer),
        Check::error(larger("error of the mesh made by hand"), closed_form(), asked, loads).judge(by_hand.worst),
        Check::at_most(Quantity::Dofs, most(ALLOWED), "the price of not knowing the error").judge(numbers.dofs as f64),
        Check::at_most(in_all, most(IN_ALL), "the price of not knowing the contact").judge(numbers.dofs_in_all as f64),
    ])
}
