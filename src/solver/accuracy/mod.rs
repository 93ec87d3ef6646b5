//! The error bar of an answer; and the cheapest mesh that meets an accuracy asked, found from coarse to fine.
//!
//! * [`reading`] — the numbers that are quoted of a run.
//! * [`mod@bar`] — how far each may be from the truth, and how it is told: of what, its name, and its unit.
//! * [`mod@family`] — the same run on the meshes that tell it.
//! * [`mod@evidence`] — what those say of each number.
//! * `elements` — what of a mesh that depends on.
//! * [`mod@coarser`] — the same scene on coarser meshes.
//! * [`counted`] — how far differences between meshes tell the error.
//! * [`answer`] — what is asked, and what is answered.
//! * [`fitted`] — where the contact found so far begins and ends, and meshes fitted to it.
//! * `length` — that found from a guess, on cheap meshes.
//! * [`mod@longest`] — how far candidates may go.
//! * `evenly` — several contacts, and bodies whose mesh is given.
//! * `rungs` — the meshes of a search, each solved from the active set of the one before.
//! * `by_order` — cells of higher and higher order that end with the contacts, each mesh judged by a finer one.
//! * `search` — finer and finer meshes of one of the two families, until the bars of one are within what is asked.
//! * [`mod@reference`] — numbers to five digits, by meshes fitted to the contact.
//! * `watch` — which meshes are solved, and what is told of each before it is.
//! * `slow` — the mesh chosen by kinematic load, and run by another algorithm.
//!
//! An accuracy is met by the bars that every solve has (`bar`). Elements along the contact and growth away from it are
//! refined together: refining the elements alone does not show what the growth leaves. On truncated Hertz a growth of 4
//! leaves 0.3 % however many elements there are.
//!
//! Cells of order 5 to 8 that end with the contacts are tried first, whatever is asked: of the random scenes of the
//! study *promised* they took fewer dofs than 8-node cells at 3 % already. 8-node cells remain for meshes that are
//! given, contacts that end where their candidates do, and line and layer elements.

pub mod answer;
pub mod bar;
mod by_order;
pub mod coarser;
pub mod counted;
mod elements;
mod evenly;
pub mod evidence;
pub mod family;
pub mod fitted;
mod length;
pub mod longest;
pub mod reading;
pub mod reference;
mod rungs;
mod search;
mod slow;
mod watch;

use crate::error::{Error, Place};
use crate::mesh::Resolution;
use crate::scene::{Place as At, Scene};
use crate::solve::{Discretisation, Formulation, Iteration};

pub use crate::measure::Quantity;
pub use answer::{Answer, Asked, Tried, TriedContact};
pub use bar::{Bar, Barred, Bars, Told, bars, bars_up_to, of_family};
pub use evidence::Evidence;
pub use family::Family;
pub use watch::{Next, Tell};

/// Smallest and largest relative error that may be asked for.
pub const RANGE: [f64; 2] = [1e-6, 0.2];

/// A relative error from a percentage, as users write it: `0.1 %`; what is expected where it is none, or not within
/// [`RANGE`].
pub fn percentage(text: &str) -> Result<f64, String> {
    let written = text.trim().strip_suffix('%').and_then(|number| number.trim().parse::<f64>().ok());
    let number = written.ok_or("it must be a percentage, with the sign %")?;
    let [least, most] = RANGE;
    let is_within = |error: &f64| *error >= least * (1.0 - 1e-9) && *error <= most * (1.0 + 1e-9);
    let error = Some(0.01 * number).filter(is_within);
    let [least, most] = RANGE.map(in_percent);
    error.ok_or_else(|| format!("it must lie between {least} % and {most} %"))
}

/// A relative error in percent, as users write it: without the digits that rounding adds.
pub fn in_percent(error: f64) -> f64 {
    (1e8 * error).round() / 1e6
}

/// What to give instead of something else.
pub fn remedy() -> String {
    let [least, most] = RANGE.map(in_percent);
    format!("give a percentage between {least} % and {most} %, such as \"0.1 %\"")
}

/// Why no accuracy chooses the mesh of a gap with kinks: their nodes would hide how the error falls with the elements.
pub const KINKED: &str = "`accuracy` cannot be used: the table of the gap has kinks, at which the mesh needs nodes";
/// What to do about it.
pub const UNKINKED: &str = "add `smooth = true` to the table, or give `elements` and `per` instead of the accuracy";

/// The cheapest mesh found that meets what is asked, or the best that was found, with the reason.
///
/// An error is returned where not even a first mesh can be solved.
pub fn solve(scene: &Scene, formulation: &Formulation, asked: &Asked) -> Result<Answer, Error> {
    solve_telling(scene, formulation, asked, &|_| ())
}

/// The same with someone who is told of each mesh before it is solved.
pub fn solve_telling(scene: &Scene, formulation: &Formulation, asked: &Asked, tell: Tell) -> Result<Answer, Error> {
    formulation.validate(scene)?;
    if scene.contacts.iter().any(|pair| !pair.profile.kinks().is_empty()) {
        return Err(Error::at(Place::Solve(scene.name.clone()), KINKED, UNKINKED));
    }
    let kinematic = formulation.algorithm == Iteration::Kinematic;
    let solve = if kinematic { search::solve } else { slow::solve };
    beside_points(solve(scene, formulation, asked, tell)?, asked)
}

/// The same unmet, its errors unknown, where contacts share their force with a support at a point.
fn beside_points(mut answer: Answer, asked: &Asked) -> Result<Answer, Error> {
    let scene = &answer.scene;
    if !scene.bodies.iter().flat_map(|body| &body.supports).any(|support| matches!(support.at, At::Point(_))) {
        return Ok(answer);
    }
    let held = answer.discretisation.take();
    let discretisation = held.map_or_else(|| Discretisation::of(scene.clone(), answer.resolution), Ok)?;
    let (readings, _) = reading::recovered(&discretisation, &answer.run, &[])?;
    let yields = |body: usize| readings.iter().any(|one| one.is_force_at_point(scene, body));
    if !(0..scene.bodies.len()).any(yields) {
        answer.discretisation = Some(discretisation);
        return Ok(answer);
    }
    let bars = answer.bars(asked, &discretisation, &answer.run)?;
    answer.discretisation = Some(discretisation);
    let at_point: Vec<&Barred> = bars.all.iter().filter(|one| one.is_at_point()).collect();
    for one in &mut answer.estimates {
        if at_point.iter().any(|other| other.is_of(one.contact, &one.quantity)) {
            one.yields();
            answer.unmet = one.unknown.map(str::to_owned);
        }
    }
    Ok(answer)
}

/// The scene on the first mesh of the search.
pub fn first(scene: &Scene) -> (Scene, Resolution) {
    search::first(scene)
}
